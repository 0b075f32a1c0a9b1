// SPDX-License-Identifier: Apache-2.0
// Append-only files: regular files opened with O_APPEND.  While a file is open, its flock keeps other programs out.
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "runtime-c/pal/log.h"
#include "runtime-c/psl/linux/linux.h"

static bool used[PAL_LOGS];
static int descriptors[PAL_LOGS];

// Opens or creates the file for appending.  O_NONBLOCK: if the name is that of a pipe without a reader, opening fails instead of waiting.
static SmResult open_file(const char *name, int *fd)
{
    *fd = open(name, O_RDWR | O_APPEND | O_CREAT | O_NONBLOCK | O_NOCTTY | O_CLOEXEC, 0644);
    if (*fd >= 0)
        return SM_OK;
    return errno == EISDIR || errno == ENXIO || errno == ENODEV ? SM_E_UNSUPPORTED : psl_result_of_errno(errno);
}

// Checks that the file is regular, locks it, and makes sure that its directory entry is on the medium.
static SmResult check_and_lock_file(int fd, const char *name)
{
    struct stat s;

    if (fstat(fd, &s) != 0)
        return psl_result_of_errno(errno);
    if (!S_ISREG(s.st_mode))
        return SM_E_UNSUPPORTED;
    if (flock(fd, LOCK_EX | LOCK_NB) != 0)
        return errno == EWOULDBLOCK ? SM_E_BUSY : psl_result_of_errno(errno);
    return s.st_size == 0 ? psl_result_of_errno(psl_sync_folder(name)) : SM_OK;
}

// Opens and locks the file of log handle `id`.
static SmResult open_and_lock_file(uint8_t id, const char *name)
{
    int fd;
    SmResult r = open_file(name, &fd);

    if (r != SM_OK)
        return r;
    r = check_and_lock_file(fd, name);
    if (r != SM_OK)
        close(fd);
    descriptors[id - 1] = fd;
    return r;
}

SmResult pal_log_open(PalLogFile *file, const char *name)
{
    SmResult r;
    uint8_t id;

    if (!file || !name || name[0] == '\0' || strlen(name) >= PAL_NAME)
        return SM_E_ARGUMENT;
    id = psl_allocate(used, PAL_LOGS);
    if (id == 0)
        return SM_E_FULL;
    r = open_and_lock_file(id, name);
    if (r == SM_OK)
        file->id = id;
    else
        psl_free(used, id);
    return r;
}

SmResult pal_log_append(PalLogFile file, const void *bytes, size_t n)
{
    const uint8_t *from = (const uint8_t *)bytes;

    if (!psl_table_is_used(used, PAL_LOGS, file.id))
        return SM_E_HANDLE;
    if (!bytes)
        return SM_E_ARGUMENT;
    while (n > 0) {
        ssize_t taken = psl_write(descriptors[file.id - 1], from, n);

        if (taken < 0 && errno != EINTR)
            return psl_result_of_errno(errno);
        if (taken > 0) {
            from += taken;
            n -= (size_t)taken;
        }
    }
    return SM_OK;
}

SmResult pal_log_sync(PalLogFile file)
{
    if (!psl_table_is_used(used, PAL_LOGS, file.id))
        return SM_E_HANDLE;
    while (fdatasync(descriptors[file.id - 1]) != 0)          // also writes the new length, which is needed to read the bytes
        if (errno != EINTR)
            return psl_result_of_errno(errno);
    return SM_OK;
}

SmResult pal_log_read(PalLogFile file, void *bytes, size_t n)
{
    uint8_t *to = (uint8_t *)bytes;
    off_t at = 0;

    if (!psl_table_is_used(used, PAL_LOGS, file.id))
        return SM_E_HANDLE;
    if (!bytes)
        return SM_E_ARGUMENT;
    while (n > 0) {
        ssize_t got = pread(descriptors[file.id - 1], to + at, n, at);

        if (got == 0)
            return SM_E_ARGUMENT;
        if (got < 0 && errno != EINTR)
            return psl_result_of_errno(errno);
        if (got > 0) {
            at += got;
            n -= (size_t)got;
        }
    }
    return SM_OK;
}

SmResult pal_log_size(PalLogFile file, uint64_t *size)
{
    struct stat s;

    if (!size)
        return SM_E_ARGUMENT;
    if (!psl_table_is_used(used, PAL_LOGS, file.id))
        return SM_E_HANDLE;
    if (fstat(descriptors[file.id - 1], &s) != 0)
        return psl_result_of_errno(errno);
    *size = (uint64_t)s.st_size;
    return SM_OK;
}

SmResult pal_log_close(PalLogFile file)
{
    SmResult r = SM_E_HANDLE;

    psl_lock_tables();
    if (psl_table_is_used(used, PAL_LOGS, file.id)) {
        close(descriptors[file.id - 1]);
        used[file.id - 1] = false;
        r = SM_OK;
    }
    psl_unlock_tables();
    return r;
}
