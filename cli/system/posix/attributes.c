/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "attributes.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#ifdef __linux__
#include <sys/xattr.h>

static const char access_list[] = "system.posix_acl_access";

/* Those of users, and access lists; labels of security are the system's to give. */
static int is_kept(const char *name)
{
    return strncmp(name, "user.", 5) == 0 || strcmp(name, access_list) == 0 ||
           strcmp(name, "system.nfs4_acl") == 0;
}

static int copy_attribute(int descriptor, const char *old, const char *name)
{
    const ssize_t size = getxattr(old, name, NULL, 0);
    char *value = size >= 0 ? malloc((size_t)size + 1) : NULL;
    int reason = value == NULL ? errno : 0;
    if (reason == 0 && (getxattr(old, name, value, (size_t)size) != size ||
                        fsetxattr(descriptor, name, value, (size_t)size, 0) != 0))
        reason = errno;
    free(value);
    return reason;
}

/* A file made in a folder with a default access list has one; the old one need not. */
static int copy_attributes(int descriptor, const char *old)
{
    fremovexattr(descriptor, access_list);
    const ssize_t size = listxattr(old, NULL, 0);
    if (size <= 0)
        return size == 0 || errno == ENOTSUP ? 0 : errno;
    char *names = malloc((size_t)size);
    const ssize_t length = names != NULL ? listxattr(old, names, (size_t)size) : -1;
    int reason = length < 0 ? errno : 0;
    for (const char *name = names; reason == 0 && name < names + length; name += strlen(name) + 1)
        if (is_kept(name))
            reason = copy_attribute(descriptor, old, name);
    free(names);
    return reason;
}
#else
static int copy_attributes(int descriptor, const char *old)
{
    (void)descriptor;
    (void)old;
    return 0;
}
#endif

/* The bits of a group that the file leaves: its members are the others now, and get no more than
 * they had. */
static mode_t without_group(mode_t mode)
{
    return (mode & 0700) | (mode & 07 & (mode >> 3));
}

int attributes_keep(int descriptor, const char *old, const struct stat *existing)
{
    mode_t mode = existing->st_mode & 0777;
    int reason = 0;
    if (fchown(descriptor, existing->st_uid, existing->st_gid) == 0 ||
        fchown(descriptor, (uid_t)-1, existing->st_gid) == 0)
        reason = copy_attributes(descriptor, old);
    else
        mode = without_group(mode);
    if (reason == 0 &&
        fchmod(descriptor, mode) != 0) /* the bits of a group may be those of a list */
        reason = errno;
    return reason;
}

const char *attributes_lost(int descriptor, const struct stat *existing)
{
    struct stat now;
    if (fstat(descriptor, &now) != 0)
        return "";
    if (now.st_gid != existing->st_gid)
        return "its group could not be kept, and may not read it any more";
    if (now.st_uid != existing->st_uid)
        return "its owner could not be kept, it is yours now";
    if (existing->st_nlink > 1)
        return "it had other names (hard links), which keep the old content";
    return "";
}
