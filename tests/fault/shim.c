// SPDX-License-Identifier: Apache-2.0
// Makes one system call fail: preloaded before the command (LD_PRELOAD), controlled by environment variables.
//
//     SMC_FAULT=write:3         the third write returns an error (in this process, not in its children)
//     SMC_FAULT=half-write:2    the second write writes half of its data, the next one fails
//     SMC_FAULT_MARK=FILE       FILE is created when the fault happens, so that the caller knows when to stop counting
//
// Linux with glibc.  Calls inside libc are not intercepted; the test concerns only calls of our own code.
#define _GNU_SOURCE
#include <dirent.h>
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <spawn.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

void *__libc_malloc(size_t n);
void *__libc_calloc(size_t count, size_t n);
void *__libc_realloc(void *old, size_t n);

static char kind[32];                 // the calls that are counted
static long left;                     // number of these calls that still succeed
static int looking_up;                // dlsym may allocate memory, which is not counted

static void mark(void)
{
    const char *path = getenv("SMC_FAULT_MARK");
    long fd = path ? syscall(SYS_openat, AT_FDCWD, path, O_WRONLY | O_CREAT, 0600) : -1;

    if (fd >= 0)
        syscall(SYS_close, fd);
}

__attribute__((constructor)) static void begin(void)
{
    const char *fault = getenv("SMC_FAULT"), *colon = fault ? strchr(fault, ':') : NULL;

    unsetenv("LD_PRELOAD");
    if (!colon || (size_t)(colon - fault) >= sizeof kind)
        return;
    memcpy(kind, fault, (size_t)(colon - fault));
    left = strtol(colon + 1, NULL, 10);
}

// Whether the current call must fail.  Sets errno.
static int fails(const char *name, int error)
{
    if (looking_up || strcmp(kind, name) != 0 || left == 0 || --left > 0)
        return 0;
    mark();
    errno = error;
    return 1;
}

static void *next(const char *name)
{
    void *found;

    looking_up++;
    found = dlsym(RTLD_NEXT, name);
    looking_up--;
    return found;
}

// The next definition of a function, as that function's type, without casting an object pointer to a function pointer.
#define NEXT(pointer, name) do { void *found_ = next(name); memcpy(&(pointer), &found_, sizeof found_); } while (0)

// ---- memory ----

void *malloc(size_t n) { return fails("memory", ENOMEM) ? NULL : __libc_malloc(n); }
void *calloc(size_t count, size_t n) { return fails("memory", ENOMEM) ? NULL : __libc_calloc(count, n); }
void *realloc(void *old, size_t n) { return fails("memory", ENOMEM) ? NULL : __libc_realloc(old, n); }

// ---- files ----

int open(const char *path, int flags, ...)
{
    va_list args;
    mode_t mode;

    va_start(args, flags);
    mode = flags & O_CREAT ? (mode_t)va_arg(args, int) : 0;
    va_end(args);
    return fails("open", EMFILE) ? -1 : (int)syscall(SYS_openat, AT_FDCWD, path, flags, mode);
}

ssize_t read(int fd, void *to, size_t n) { return fails("read", EIO) ? -1 : (ssize_t)syscall(SYS_read, fd, to, n); }

ssize_t write(int fd, const void *from, size_t n)
{
    static int full;

    if (fails("write", ENOSPC))
        return -1;
    if (full) {
        errno = ENOSPC;
        return -1;
    }
    if (fails("half-write", 0)) {
        full = 1;
        n /= 2;
    }
    return (ssize_t)syscall(SYS_write, fd, from, n);
}

// A close that fails has still closed the file.
int close(int fd)
{
    int failed = fails("close", EIO);
    int result = (int)syscall(SYS_close, fd);

    if (failed)
        errno = EIO;
    return failed ? -1 : result;
}

int fsync(int fd) { return fails("fsync", EIO) ? -1 : (int)syscall(SYS_fsync, fd); }
int fchmod(int fd, mode_t mode) { return fails("fchmod", EPERM) ? -1 : (int)syscall(SYS_fchmod, fd, mode); }
int rename(const char *from, const char *to) { return fails("rename", EACCES) ? -1 : (int)syscall(SYS_renameat, AT_FDCWD, from, AT_FDCWD, to); }

int mkstemp(char *name)
{
    int (*real)(char *);

    NEXT(real, "mkstemp");
    return fails("mkstemp", EACCES) ? -1 : real(name);
}

char *mkdtemp(char *name)
{
    char *(*real)(char *);

    NEXT(real, "mkdtemp");
    return fails("mkdtemp", EACCES) ? NULL : real(name);
}

DIR *opendir(const char *path)
{
    DIR *(*real)(const char *);

    NEXT(real, "opendir");
    return fails("opendir", EACCES) ? NULL : real(path);
}

// ---- processes ----

int posix_spawnp(pid_t *pid, const char *file, const posix_spawn_file_actions_t *actions, const posix_spawnattr_t *attributes,
                 char *const argv[], char *const environment[])
{
    int (*real)(pid_t *, const char *, const posix_spawn_file_actions_t *, const posix_spawnattr_t *, char *const[], char *const[]);

    NEXT(real, "posix_spawnp");
    return fails("spawn", EAGAIN) ? EAGAIN : real(pid, file, actions, attributes, argv, environment);
}

int socketpair(int domain, int type, int protocol, int pair[2])
{
    int (*real)(int, int, int, int[2]);

    NEXT(real, "socketpair");
    return fails("socketpair", EMFILE) ? -1 : real(domain, type, protocol, pair);
}

ssize_t recv(int fd, void *to, size_t n, int flags)
{
    ssize_t (*real)(int, void *, size_t, int);

    NEXT(real, "recv");
    return fails("recv", EIO) ? -1 : real(fd, to, n, flags);
}

ssize_t send(int fd, const void *from, size_t n, int flags)
{
    ssize_t (*real)(int, const void *, size_t, int);

    NEXT(real, "send");
    return fails("send", EPIPE) ? -1 : real(fd, from, n, flags);
}
