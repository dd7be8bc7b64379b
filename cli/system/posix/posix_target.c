/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "system/system.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* "folder/" + name, or just name. Free it. */
static char *in_folder_of(const char *path, const char *name)
{
    const char *slash = strrchr(path, '/');
    const size_t folder = slash != NULL ? (size_t)(slash - path) + 1 : 0;
    char *joined = malloc(folder + strlen(name) + 1);
    if (joined == NULL)
        return NULL;
    memcpy(joined, path, folder);
    strcpy(joined + folder, name);
    return joined;
}

/* A link to a file that is not there is replaced itself. */
char *target_of_links(const char *path)
{
    char *target = realpath(path, NULL);
    return target == NULL && errno == ENOENT ? strdup(path) : target;
}

static bool look_at(const char *path, int standard_stream, struct stat *file)
{
    const bool standard = strcmp(path, "-") == 0;
    return (standard ? fstat(standard_stream, file) : stat(path, file)) == 0 &&
           S_ISREG(file->st_mode);
}

bool target_is_input(const char *to, const char *from)
{
    struct stat out, in;
    return look_at(to, STDOUT_FILENO, &out) && look_at(from, STDIN_FILENO, &in) &&
           out.st_dev == in.st_dev && out.st_ino == in.st_ino;
}

/* What open() would give a new file. */
static mode_t usual_mode(void)
{
    const mode_t mask = umask(0);
    umask(mask);
    return 0666 & ~mask;
}

/* Nobody gets more access than before. Where the group cannot be kept, its members are the others
 * now, and another group gets none. */
static mode_t mode_like(int descriptor, const struct stat *existing)
{
    const mode_t mode = existing->st_mode & 0777;
    const bool kept = fchown(descriptor, existing->st_uid, existing->st_gid) == 0 ||
                      fchown(descriptor, (uid_t)-1, existing->st_gid) == 0;
    return kept ? mode : (mode & 0700) | (mode & 07 & (mode >> 3));
}

static FILE *give_up(char *name, int descriptor)
{
    const int reason = errno;
    if (descriptor >= 0) {
        close(descriptor);
        unlink(name);
    }
    free(name);
    errno = reason;
    return NULL;
}

FILE *target_open_beside(const char *target, char **unfinished)
{
    struct stat existing;
    const bool exists = stat(target, &existing) == 0;
    if ((!exists && errno != ENOENT) || (exists && access(target, W_OK) != 0))
        return NULL; /* renaming would replace a file that is protected from writing */
    char *name = in_folder_of(target, ".rwedge-XXXXXX");
    const int descriptor = name != NULL ? mkstemp(name) : -1;
    if (descriptor < 0 || fcntl(descriptor, F_SETFD, FD_CLOEXEC) != 0 ||
        fchmod(descriptor, exists ? mode_like(descriptor, &existing) : usual_mode()) != 0)
        return give_up(name, descriptor);
    FILE *file = fdopen(descriptor, "wb");
    *unfinished = name;
    return file != NULL ? file : give_up(name, descriptor);
}

int target_replace(const char *target, const char *unfinished)
{
    if (rename(unfinished, target) == 0)
        return 0;
    const int reason = errno;
    remove(unfinished);
    return reason;
}

int target_sync(FILE *file)
{
    return fsync(fileno(file)) == 0 ? 0 : errno;
}
