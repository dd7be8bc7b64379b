/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A signal that ends the program: the unfinished file is removed, a message says so, and the
 * program ends by the signal itself, so that the shell sees it. A closed pipe and a size limit are
 * errors of write() instead. */
#ifndef CLI_SIGNALS_H
#define CLI_SIGNALS_H

/* Once, at the start. A signal that is ignored already (nohup) stays so. */
void signals_install(void);

/* From now on a signal removes this file, NULL for none, and its message ends with the text.
 * Both are kept, not copied. */
void signals_on_end(const char *unfinished_file, const char *message);

/* Threads begun in between leave signals to the one that begins them. Not so a crash: it belongs to
 * the thread that it is in, which begins by giving a stack for where its own has run out. */
enum { SIGNALS_STACK = 1 << 14 };
void signals_in_thread(char stack[SIGNALS_STACK]);
void signals_before_threads(void);
void signals_after_threads(void);

/* Hold signals back while a file and what is known of it change together. */
void signals_hold(void);
void signals_release(void);

#endif
