/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A user who ends the program, by Ctrl-C, kill or a closed terminal: the unfinished file is
 * removed, a message says so, and the program ends by the signal itself, so that the shell sees it.
 * A closed pipe and a size limit are errors of write() instead. */
#ifndef CLI_SIGNALS_H
#define CLI_SIGNALS_H

/* Once, at the start. A signal that is ignored already (nohup) stays so. */
void signals_install(void);

/* From now on a signal removes this file, NULL for none, and its message ends with the text.
 * Both are kept, not copied. */
void signals_on_end(const char *unfinished_file, const char *message);

/* Hold signals back while a file and what is known of it change together. Threads begun in between
 * leave signals to the one that begins them. */
void signals_hold(void);
void signals_release(void);

#endif
