// SPDX-License-Identifier: Apache-2.0
// Non-volatile memory: a regular file.  Each write replaces the file:
// 1. Write a new file NAME.new beside the old one, and wait until it is on the medium.
// 2. Rename it to the old name.
// 3. Wait until the folder is on the medium.
// After a power cut the file is entirely the old or entirely the new one, on every file system with atomic rename (all journaling
// ones).  A write costs a copy of the memory, so this suits some kilobytes of settings and counters, but not a log.
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "runtime-c/pal/nvm.h"
#include "runtime-c/psl/linux/linux.h"

#define BLANK 0xff

typedef struct NvmEntry {
    int fd;                   // keeps the flock on the file while it is open
    uint32_t size;
    char path[PAL_NAME];
} NvmEntry;

// Bytes to store: n bytes at address `at`; blank ones if `bytes` is NULL.
typedef struct NvmChange {
    uint32_t at, n;
    const uint8_t *bytes;
} NvmChange;

static bool used[PAL_NVMS];
static NvmEntry entries[PAL_NVMS];

// ---- descriptors ----

// Reads n bytes at offset `at`.  Returns 0 or an errno.
static int read_all(int fd, uint8_t *to, size_t n, uint32_t at)
{
    while (n > 0) {
        ssize_t got = pread(fd, to, n, (off_t)at);

        if (got == 0 || (got < 0 && errno != EINTR))
            return got == 0 ? EIO : errno;
        if (got > 0) {
            to += got;
            n -= (size_t)got;
            at += (uint32_t)got;
        }
    }
    return 0;
}

// Writes n bytes.  Returns 0 or an errno.
static int write_all(int fd, const uint8_t *from, size_t n)
{
    while (n > 0) {
        ssize_t taken = psl_write(fd, from, n);

        if (taken < 0 && errno != EINTR)
            return errno;
        if (taken > 0) {
            from += taken;
            n -= (size_t)taken;
        }
    }
    return 0;
}

// Returns the file's size, or -1 if it is not a regular file or exceeds the address range.
static int64_t file_size(int fd)
{
    struct stat s;

    return fstat(fd, &s) == 0 && S_ISREG(s.st_mode) && s.st_size <= INT32_MAX ? (int64_t)s.st_size : -1;
}

// ---- replacing the file ----

// Stores the part of the change that falls into `block`: n bytes at address `at`.
static void apply_change(uint8_t *block, uint32_t at, uint32_t n, const NvmChange *c)
{
    for (uint32_t i = 0; i < n; i++)
        if (at + i - c->at < c->n)                         // also implies at + i >= c->at: otherwise the difference would be huge
            block[i] = c->bytes ? c->bytes[at + i - c->at] : BLANK;
}

// Copies the first `size` bytes of `old` with the change applied.  Bytes after the end of `old` are blank.  Returns 0 or an errno.
static int copy_changed(int to, int old, uint32_t old_size, uint32_t size, const NvmChange *c)
{
    uint8_t block[512];
    int error = 0;

    for (uint32_t at = 0; at < size && !error; at += (uint32_t)sizeof block) {
        uint32_t n = size - at < sizeof block ? size - at : (uint32_t)sizeof block;

        memset(block, BLANK, sizeof block);
        if (at < old_size)
            error = read_all(old, block, n < old_size - at ? n : old_size - at, at);
        apply_change(block, at, n, c);
        if (!error)
            error = write_all(to, block, n);
    }
    return error;
}

// Opens NAME.new, empty and locked.  Returns its descriptor; -1, and the errno in *error, on failure.
static int open_new(const char *name, int *error)
{
    int fd = open(name, O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0644);

    *error = fd < 0 ? errno : 0;
    if (fd >= 0 && (flock(fd, LOCK_EX | LOCK_NB) != 0 || ftruncate(fd, 0) != 0)) {
        *error = errno == EWOULDBLOCK ? EBUSY : errno;
        close(fd);
        fd = -1;
    }
    return fd;
}

// Replaces the file by a copy with the change.  If no file exists yet, e->fd is -1.  Returns 0 or an errno.
static int replace_file(NvmEntry *e, uint32_t old_size, const NvmChange *c)
{
    char name[PAL_NAME + 4];
    int error, fd;

    snprintf(name, sizeof name, "%s.new", e->path);
    fd = open_new(name, &error);
    if (fd < 0)
        return error;
    error = copy_changed(fd, e->fd, old_size, e->size, c);
    if (!error && (fsync(fd) != 0 || rename(name, e->path) != 0))
        error = errno;
    if (error) {
        unlink(name);
        close(fd);
        return error;
    }
    if (e->fd >= 0)
        close(e->fd);
    e->fd = fd;
    return psl_sync_folder(e->path);
}

// ---- opening ----

// Whether the locked file still has its name: another program may have replaced it meanwhile.
static bool is_current(int fd, const char *path)
{
    struct stat a, b;

    return fstat(fd, &a) == 0 && stat(path, &b) == 0 && a.st_ino == b.st_ino && a.st_dev == b.st_dev;
}

// Opens and locks the file and stores its size in *size.  If there is no file: SM_OK, with e->fd -1 and *size 0.
static SmResult open_existing(NvmEntry *e, int64_t *size)
{
    *size = 0;
    e->fd = open(e->path, O_RDWR | O_NOFOLLOW | O_CLOEXEC);
    if (e->fd < 0)
        return errno == ENOENT ? SM_OK : errno == EISDIR ? SM_E_UNSUPPORTED : psl_result_of_errno(errno);
    *size = file_size(e->fd);
    if (*size < 0)
        return SM_E_UNSUPPORTED;
    return flock(e->fd, LOCK_EX | LOCK_NB) == 0 && is_current(e->fd, e->path) ? SM_OK : SM_E_BUSY;
}

// Opens the file of a new entry, and creates or extends it to `size` bytes.
static SmResult open_entry(NvmEntry *e, const char *path, uint32_t size)
{
    const NvmChange nothing = {0, 0, NULL};
    int64_t old;
    SmResult r;

    strcpy(e->path, path);
    r = open_existing(e, &old);
    e->size = old > (int64_t)size ? (uint32_t)old : size;
    if (r == SM_OK && old < (int64_t)size)
        r = psl_result_of_errno(replace_file(e, (uint32_t)old, &nothing));
    if (r != SM_OK && e->fd >= 0)
        close(e->fd);
    return r;
}

SmResult pal_nvm_open(PalNvm *memory, const char *name, uint32_t size)
{
    SmResult r = SM_E_FULL;
    uint8_t id;

    if (!memory || !name || size == 0 || name[0] == '\0' || strlen(name) >= PAL_NAME)
        return SM_E_ARGUMENT;
    if (size > INT32_MAX)
        return SM_E_SPACE;
    id = psl_allocate(used, PAL_NVMS);
    if (id != 0)
        r = open_entry(&entries[id - 1], name, size);      // slow; the table is not locked meanwhile
    if (r == SM_OK)
        memory->id = id;
    else if (id != 0)
        psl_free(used, id);
    return r;
}

// Reads the first n bytes of a file.  O_NONBLOCK: opening a pipe does not wait for its other end.
SmResult pal_nvm_load(const char *name, void *bytes, uint32_t n)
{
    int64_t size;
    SmResult r;
    int fd;

    if (!name || !bytes || n == 0 || name[0] == '\0' || strlen(name) >= PAL_NAME)
        return SM_E_ARGUMENT;
    fd = open(name, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (fd < 0)
        return errno == ENXIO ? SM_E_UNSUPPORTED : psl_result_of_errno(errno);
    size = file_size(fd);
    r = size < 0 ? SM_E_UNSUPPORTED : size < (int64_t)n ? SM_E_SPACE : psl_result_of_errno(read_all(fd, bytes, n, 0));
    close(fd);
    return r;
}

// ---- using ----

SmResult pal_nvm_info(PalNvm memory, PalNvmInfo *info)
{
    const PalNvmInfo file = {0, 1, 0, 0, 0, BLANK};

    if (!info)
        return SM_E_ARGUMENT;
    if (!psl_table_is_used(used, PAL_NVMS, memory.id))
        return SM_E_HANDLE;
    *info = file;
    info->size = info->atomic = entries[memory.id - 1].size;
    return SM_OK;
}

// Checks that the handle is open and the range is valid.
static SmResult check_range(PalNvm memory, uint32_t at, uint32_t n)
{
    if (!psl_table_is_used(used, PAL_NVMS, memory.id))
        return SM_E_HANDLE;
    return at <= entries[memory.id - 1].size && n <= entries[memory.id - 1].size - at ? SM_OK : SM_E_ARGUMENT;
}

SmResult pal_nvm_read(PalNvm memory, uint32_t at, void *bytes, uint32_t n)
{
    SmResult r = check_range(memory, at, n);

    if (r == SM_OK && !bytes)
        r = SM_E_ARGUMENT;
    return r == SM_OK ? psl_result_of_errno(read_all(entries[memory.id - 1].fd, bytes, n, at)) : r;
}

// Writes n bytes; erases them if `bytes` is NULL.
static SmResult change_bytes(PalNvm memory, uint32_t at, const void *bytes, uint32_t n)
{
    const NvmChange c = {at, n, bytes};
    SmResult r = check_range(memory, at, n);

    if (r != SM_OK || n == 0)
        return r;
    return psl_result_of_errno(replace_file(&entries[memory.id - 1], entries[memory.id - 1].size, &c));
}

SmResult pal_nvm_write(PalNvm memory, uint32_t at, const void *bytes, uint32_t n)
{
    return bytes ? change_bytes(memory, at, bytes, n) : SM_E_ARGUMENT;
}

SmResult pal_nvm_erase(PalNvm memory, uint32_t at, uint32_t n)
{
    return change_bytes(memory, at, NULL, n);
}

SmResult pal_nvm_close(PalNvm memory)
{
    SmResult r = SM_E_HANDLE;

    psl_lock_tables();
    if (psl_table_is_used(used, PAL_NVMS, memory.id)) {
        close(entries[memory.id - 1].fd);
        used[memory.id - 1] = false;
        r = SM_OK;
    }
    psl_unlock_tables();
    return r;
}
