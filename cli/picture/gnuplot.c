/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "gnuplot.h"

#include "text/message.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

enum { SCRIPT, PICTURE, COMPLAINTS, PIPES }; /* numbered as gnuplot's standard streams */
enum { NEAR = 0, FAR = 1 };                  /* our end of a pipe, and gnuplot's */

typedef struct {
    pid_t process;
    int pipe[PIPES][2]; /* -1 where closed */
    bytes complaints;
} child;

static void close_end(child *gnuplot, int number, int end)
{
    if (gnuplot->pipe[number][end] >= 0)
        close(gnuplot->pipe[number][end]);
    gnuplot->pipe[number][end] = -1;
}

static bool open_pipes(child *gnuplot)
{
    for (int i = 0; i < PIPES; i++)
        gnuplot->pipe[i][NEAR] = gnuplot->pipe[i][FAR] = -1;
    for (int i = 0; i < PIPES; i++) {
        int ends[2];
        if (pipe(ends) != 0)
            return false;
        gnuplot->pipe[i][NEAR] = ends[i == SCRIPT ? 1 : 0];
        gnuplot->pipe[i][FAR] = ends[i == SCRIPT ? 0 : 1];
        for (int end = NEAR; end <= FAR; end++) /* else gnuplot would hold its own script open */
            fcntl(ends[end], F_SETFD, FD_CLOEXEC);
        fcntl(gnuplot->pipe[i][NEAR], F_SETFL, O_NONBLOCK);
    }
    return true;
}

/* What would change the picture: the locale, and the date in a PDF. */
static char *const our_environment[] = {"LC_ALL=C", "GNUTERM=dumb", "SOURCE_DATE_EPOCH=0",
                                        "TZ=UTC0"};
enum { OUR_ENVIRONMENT = sizeof our_environment / sizeof our_environment[0] };

static bool is_ours(const char *variable)
{
    for (int i = 0; i < OUR_ENVIRONMENT; i++)
        if (strncmp(variable, our_environment[i], strcspn(our_environment[i], "=") + 1) == 0)
            return true;
    return false;
}

/* The user's environment but for that. Free it. */
static char **environment(void)
{
    size_t count = 0, kept = 0;
    while (environ[count] != NULL)
        count++;
    char **variables = malloc((OUR_ENVIRONMENT + count + 1) * sizeof *variables);
    if (variables == NULL)
        return NULL;
    for (; kept < OUR_ENVIRONMENT; kept++)
        variables[kept] = our_environment[kept];
    for (size_t i = 0; i < count; i++)
        if (!is_ours(environ[i]))
            variables[kept++] = environ[i];
    variables[kept] = NULL;
    return variables;
}

/* Signals that the tool ignores would stay ignored in gnuplot. */
static int spawn(child *gnuplot, posix_spawn_file_actions_t *actions, posix_spawnattr_t *attributes)
{
    /* not the user's own start file */
    char *const words[] = {"gnuplot", "--default-settings", "-", NULL};
    sigset_t usual;
    sigemptyset(&usual);
    sigaddset(&usual, SIGPIPE);
    sigaddset(&usual, SIGXFSZ);
    posix_spawnattr_setsigdefault(attributes, &usual);
    posix_spawnattr_setflags(attributes, POSIX_SPAWN_SETSIGDEF);
    int error = 0;
    for (int i = 0; i < PIPES && error == 0; i++)
        error = posix_spawn_file_actions_adddup2(actions, gnuplot->pipe[i][FAR], i);
    char **variables = environment();
    if (error == 0)
        error = variables != NULL ? posix_spawnp(&gnuplot->process, words[0], actions, attributes,
                                                 words, variables)
                                  : ENOMEM;
    free(variables);
    return error;
}

static int start(child *gnuplot)
{
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    if (posix_spawn_file_actions_init(&actions) != 0)
        return ENOMEM;
    int error = posix_spawnattr_init(&attributes);
    if (error == 0) {
        error = spawn(gnuplot, &actions, &attributes);
        posix_spawnattr_destroy(&attributes);
    }
    posix_spawn_file_actions_destroy(&actions);
    return error;
}

static bool may_try_again(ssize_t count)
{
    return count < 0 && (errno == EINTR || errno == EAGAIN);
}

/* What gnuplot no longer reads (EPIPE) is not needed: its status says why. */
static void feed(child *gnuplot, const bytes *script, size_t *fed)
{
    const ssize_t count =
        write(gnuplot->pipe[SCRIPT][NEAR], script->data + *fed, script->length - *fed);
    if (count > 0)
        *fed += (size_t)count;
    if (*fed == script->length || (count < 0 && !may_try_again(count)))
        close_end(gnuplot, SCRIPT, NEAR);
}

static void take(child *gnuplot, int number, bytes *into)
{
    char part[4096];
    const ssize_t count = read(gnuplot->pipe[number][NEAR], part, sizeof part);
    if (count > 0)
        bytes_add(into, part, (size_t)count);
    else if (!may_try_again(count))
        close_end(gnuplot, number, NEAR);
}

/* Writes and reads at the same time: either alone could block for ever once a pipe is full. */
static void converse(child *gnuplot, const bytes *script, bytes *picture)
{
    size_t fed = 0;
    while (gnuplot->pipe[PICTURE][NEAR] >= 0 || gnuplot->pipe[COMPLAINTS][NEAR] >= 0) {
        struct pollfd ends[PIPES];
        for (int i = 0; i < PIPES; i++)
            ends[i] = (struct pollfd){.fd = gnuplot->pipe[i][NEAR],
                                      .events = i == SCRIPT ? POLLOUT : POLLIN};
        if (poll(ends, PIPES, -1) < 0)
            continue; /* a signal came in between */
        if (ends[SCRIPT].revents != 0)
            feed(gnuplot, script, &fed);
        if (ends[PICTURE].revents != 0)
            take(gnuplot, PICTURE, picture);
        if (ends[COMPLAINTS].revents != 0)
            take(gnuplot, COMPLAINTS, &gnuplot->complaints);
    }
}

static int exit_status(pid_t process)
{
    int status;
    while (waitpid(process, &status, 0) < 0)
        if (errno != EINTR)
            return -1;
    return status;
}

/* The last line that says something; gnuplot shows the failing line of the script above it. */
static const char *last_complaint(bytes *complaints)
{
    bytes_add(complaints, "", 1);
    if (complaints->failed)
        return "";
    char *end = complaints->data + strlen(complaints->data);
    while (end > complaints->data && strchr(" \t\r\n", end[-1]) != NULL)
        *--end = '\0';
    char *line = strrchr(complaints->data, '\n');
    line = line != NULL ? line + 1 : complaints->data;
    return line + strspn(line, " \t\r");
}

static bool refuse(child *gnuplot, const char *what, int number)
{
    const char *said = last_complaint(&gnuplot->complaints);
    failure("gnuplot %s %d%s%.400s; needed: gnuplot 5 with its terminals svg, pngcairo, pdfcairo "
            "(package gnuplot-nox)",
            what, number, said[0] != '\0' ? ": " : "", said);
    return false;
}

static bool is_whole(const bytes *picture, const picture_format *format)
{
    enum { TAIL = 32 }; /* blanks may follow the end */
    if (picture->length < format->begins_length + format->ends_length ||
        memcmp(picture->data, format->begins, format->begins_length) != 0)
        return false;
    const size_t last = picture->length - format->ends_length;
    for (size_t at = last; at + TAIL > last && at > 0; at--)
        if (memcmp(picture->data + at, format->ends, format->ends_length) == 0)
            return true;
    return false;
}

/* The date of a PDF, for the same bytes tomorrow; as many characters as before, since the file
 * counts its bytes. */
static void remove_date(bytes *picture)
{
    static const char key[] = "/CreationDate (D:", usual[] = "20000101000000";
    const size_t length = sizeof key - 1, digits = sizeof usual - 1;
    for (size_t i = 0; i + length + digits <= picture->length; i++)
        if (memcmp(picture->data + i, key, length) == 0 &&
            strspn(picture->data + i + length, "0123456789") == digits)
            memcpy(picture->data + i + length, usual, digits);
}

/* In an SVG, viewers drop a space where the font changes, unless told to keep it. */
static void keep_spaces(bytes *picture)
{
    static const char start[] = "<svg", told[] = " xml:space=\"preserve\"";
    const size_t length = sizeof start - 1;
    bytes whole = {0};
    size_t at = 0;
    while (at + length < picture->length && memcmp(picture->data + at, start, length) != 0)
        at++;
    if (at + length >= picture->length)
        return;
    bytes_add(&whole, picture->data, at + length);
    bytes_text(&whole, told);
    bytes_add(&whole, picture->data + at + length, picture->length - at - length);
    bytes_free(picture);
    *picture = whole;
}

static bool judge(child *gnuplot, int status, const picture_format *format, bytes *picture)
{
    if (picture->failed || gnuplot->complaints.failed) {
        failure("out of memory");
        return false;
    }
    if (!WIFEXITED(status))
        return refuse(gnuplot, "was ended by signal", WIFSIGNALED(status) ? WTERMSIG(status) : 0);
    if (WEXITSTATUS(status) != 0)
        return refuse(gnuplot, "ended with status", WEXITSTATUS(status));
    if (!is_whole(picture, format))
        return refuse(gnuplot,
                      "gave no whole picture, but bytes:", (int)(picture->length % 1000000000));
    remove_date(picture);
    if (format->needs_spaces)
        keep_spaces(picture);
    if (picture->failed)
        failure("out of memory");
    return !picture->failed;
}

static bool run(child *gnuplot, const picture_format *format, const bytes *script, bytes *picture)
{
    const int error = open_pipes(gnuplot) ? start(gnuplot) : errno;
    for (int i = 0; i < PIPES; i++)
        close_end(gnuplot, i, FAR);
    bool drawn = false;
    if (error == ENOENT)
        failure("gnuplot: not found on PATH; it draws the figures: install it (package "
                "gnuplot-nox), or use --data");
    else if (error != 0)
        failure("gnuplot: %s", strerror(error));
    else {
        converse(gnuplot, script, picture);
        drawn = judge(gnuplot, exit_status(gnuplot->process), format, picture);
    }
    for (int i = 0; i < PIPES; i++)
        close_end(gnuplot, i, NEAR);
    bytes_free(&gnuplot->complaints);
    return drawn;
}

bool gnuplot_draw(const drawing *what, const picture_format *format, bytes *picture)
{
    bytes script = {0};
    child gnuplot = {0};
    gnuplot_script(what, format, &script);
    bool drawn = false;
    if (script.failed)
        failure("out of memory");
    else
        drawn = run(&gnuplot, format, &script, picture);
    bytes_free(&script);
    return drawn;
}
