// SPDX-License-Identifier: Apache-2.0
// os.h on POSIX systems.
#define _XOPEN_SOURCE 700
#define _DEFAULT_SOURCE                  // for the declaration of madvise

#include "compiler/base/os_files.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

enum { HUGE_PAGE = 2 << 20 };

// Allocates, resizes or (size 0) frees heap memory, as an SmcAllocFn.
void *os_alloc(void *context, void *old, size_t size)
{
    (void)context;
    if (size == 0) {
        free(old);
        return NULL;
    }
#ifdef MADV_HUGEPAGE                     // Linux: large blocks get pages of 2 MB, because every page costs a page fault
    if (!old && size >= HUGE_PAGE && posix_memalign(&old, HUGE_PAGE, size) == 0)
        return madvise(old, size, MADV_HUGEPAGE), old;
#endif
    return realloc(old, size);
}

const char os_null_device[] = "/dev/null";

void os_start(int *argc, char ***argv) { (void)argc, (void)argv; }

// Sets *why to the text of errno. Always returns false, the result of the failed function.
static bool set_reason(const char **why)
{
    *why = strerror(errno);
    return false;
}

// ---- names ----

bool os_is_name(const char *name)
{
    while ((unsigned char)*name >= 0x20 && *name != 0x7F)
        name++;
    return *name == '\0';
}

// Returns false and sets *why if the name contains a control character.
static bool check_name(const char *path, const char **why)
{
    *why = "its name contains a control character";
    return os_is_name(path);
}

// ---- reading ----

long os_read_some(intptr_t file, void *into, size_t n, const char **why)
{
    ssize_t got;

    while ((got = read((int)file, into, n)) < 0 && errno == EINTR)
        continue;
    if (got < 0)
        set_reason(why);
    return (long)got;
}

// Reads a whole file or, for "-", standard input, of at most `most` bytes.  The caller frees *text with os_alloc; after false, *why is the
// reason.
bool os_read_file(const char *path, size_t most, char **text, size_t *len, const char **why)
{
    bool ok;
    int fd;

    if (strcmp(path, "-") == 0)
        return os_read_all(0, most, text, len, why);
    if (!check_name(path, why))
        return false;
    if (os_is_folder(path)) {
        *why = "it is a folder";
        return false;
    }
    if ((fd = open(path, O_RDONLY)) < 0)
        return set_reason(why);
    ok = os_read_all(fd, most, text, len, why);
    close(fd);
    return ok;
}

// Reads up to n bytes from the start of a regular file.  *len is their number, 0 if there is no such file.
bool os_read_head(const char *path, char *into, size_t n, size_t *len)
{
    const char *why;
    struct stat st;
    long got;
    int fd;

    *len = 0;
    if (stat(path, &st) != 0 || !S_ISREG(st.st_mode))
        return true;
    if ((fd = open(path, O_RDONLY)) < 0)
        return false;
    got = os_read_some(fd, into, n, &why);
    close(fd);
    *len = got > 0 ? (size_t)got : 0;
    return got >= 0;
}

bool os_reader_open(OsReader *r, const char *path, const char **why)
{
    struct stat st;
    int fd;

    if (!check_name(path, why))
        return false;
    if ((fd = open(path, O_RDONLY | O_NONBLOCK)) < 0)                     // does not wait for the writer of a pipe
        return set_reason(why);
    if (fstat(fd, &st) != 0 || !S_ISREG(st.st_mode)) {
        *why = S_ISDIR(st.st_mode) ? "it is a folder" : "it is not a regular file";
        close(fd);
        return false;
    }
    *r = (OsReader){fd, (uint64_t)st.st_size, 0};
    return true;
}

void os_reader_close(OsReader *r) { close((int)r->file); }

// ---- writing ----

// Writes all n bytes. Returns false and sets *why if that fails.
static bool write_all(int fd, const void *bytes, size_t n, const char **why)
{
    const char *p = bytes;

    while (n > 0) {
        ssize_t put = write(fd, p, n);
        if (put < 0 && errno == EINTR)
            continue;
        if (put < 0)
            return set_reason(why);
        p += put;
        n -= (size_t)put;
    }
    return true;
}

bool os_print(int fd, const void *bytes, size_t n, const char **why)
{
    return write_all(fd, bytes, n, why);
}

// Returns the mode of the replaced file, or else the default mode of a new file.
static mode_t file_mode_for_output(const char *target)
{
    struct stat st;
    mode_t mask = umask(0);

    umask(mask);
    return stat(target, &st) == 0 ? st.st_mode & 07777 : (mode_t)(0666 & ~mask);
}

// Whether a path is a device, a pipe or an open descriptor, to which output is written directly: a renamed file cannot replace it.
bool os_is_special(const char *path)
{
    struct stat st;
    return os_find_descriptor(path) >= 0 || (stat(path, &st) == 0 && !S_ISREG(st.st_mode) && !S_ISDIR(st.st_mode));
}

// Opens a path that is written without a temporary file. If it names an open file of this process (*is_own), returns that descriptor:
// output continues at its current position.
static int open_directly(const char *path, bool *is_own, const char **why)
{
    int fd = strcmp(path, "-") == 0 ? 1 : os_find_descriptor(path);

    *is_own = fd >= 0;
    if (fd < 0 && (fd = open(path, O_WRONLY)) < 0)
        set_reason(why);
    return fd;
}

// Returns the file that `path` names after following symbolic links, so that a link remains a link; allocated on the heap.
static char *resolve_target(const char *path, const char **why)
{
    struct stat st;
    const bool is_link = lstat(path, &st) == 0 && S_ISLNK(st.st_mode);
    char *target = is_link ? os_real_path(path) : strdup(path);

    if (!target)
        *why = is_link ? "its symbolic link leads to no folder" : "out of memory";
    return target;
}

// Creates a temporary file next to `target`, and returns its descriptor; -1, and the reason in *why, if it cannot be created. From then on, a
// signal that ends the process removes the temporary file.
static int open_temporary(const char *target, int number, const char **why)
{
    char *temp;
    int fd;

    if (os_is_folder(target)) {
        *why = "it is a folder";
        return -1;
    }
    if ((temp = malloc(strlen(target) + sizeof ".XXXXXX")) == NULL) {
        *why = "out of memory";
        return -1;
    }
    strcpy(temp, target);
    strcat(temp, ".XXXXXX");
    if ((fd = mkstemp(temp)) < 0) {
        set_reason(why);
        free(temp);
        return -1;
    }
    os_set_unfinished(number, temp);
    return fd;
}

// Gives the temporary file the owner and mode of the file that it will replace, and closes it. fsync stores its bytes on the medium before
// the rename, so that after a power cut either the old file or the complete new one exists.
static bool flush_and_close_temporary(int fd, const char *target, bool ok, const char **why)
{
    struct stat old, own;

    if (ok && stat(target, &old) == 0 && fstat(fd, &own) == 0 && (old.st_uid != own.st_uid || old.st_gid != own.st_gid) &&
        fchown(fd, old.st_uid, old.st_gid) != 0)
        errno = 0;                                    // only root can change a file's owner
    if (ok && (fchmod(fd, file_mode_for_output(target)) != 0 || fsync(fd) != 0))
        ok = set_reason(why);
    if (close(fd) != 0 && ok)
        ok = set_reason(why);
    return ok;
}

// Writes one output without a temporary file. Returns false and sets *why if that fails.
static bool write_directly(const OsOutput *out, const char **why)
{
    bool ok, is_own;
    int fd = open_directly(out->path, &is_own, why);

    if (fd < 0)
        return false;
    ok = write_all(fd, out->bytes, out->n, why);
    if (!is_own && close(fd) != 0 && ok)
        ok = set_reason(why);
    return ok;
}

// Writes one output to a temporary file beside its target; *target is then the path to rename it to. Special files are written directly.
bool os_write_temporary(const OsOutput *out, int number, char **target, const char **why)
{
    int fd;

    if (!check_name(out->path, why))
        return false;
    if (strcmp(out->path, "-") == 0 || os_is_special(out->path))
        return write_directly(out, why);
    if ((*target = resolve_target(out->path, why)) == NULL || (fd = open_temporary(*target, number, why)) < 0)
        return false;
    return flush_and_close_temporary(fd, *target, write_all(fd, out->bytes, out->n, why), why);
}

bool os_replace_file(const char *temp, const char *target, const char **why) { return rename(temp, target) == 0 || set_reason(why); }
void os_remove_file(const char *path) { unlink(path); }

// ---- a file written incrementally ----

// Opens an output that is written bit by bit: a temporary file, or a special file directly.
bool os_stream_open(OsStream *s, const char *path, const char **why)
{
    if (!check_name(path, why))
        return false;
    s->target = NULL;
    s->is_direct = strcmp(path, "-") == 0 || os_is_special(path);
    if (s->is_direct)
        return (s->fd = open_directly(path, &s->is_own, why)) >= 0;
    if ((s->target = resolve_target(path, why)) == NULL)
        return false;
    os_signals_begin();
    atexit(os_remove_unfinished);
    s->fd = open_temporary(s->target, OS_STREAM_NUMBER, why);
    if (s->fd >= 0)
        return true;
    free(s->target);
    os_signals_end();
    return false;
}

bool os_stream_put(OsStream *s, const void *bytes, size_t n, const char **why)
{
    return write_all(s->fd, bytes, n, why);
}

// Closes the output. With `keep`, a temporary file replaces its target; without, it is removed.
bool os_stream_close(OsStream *s, bool keep, const char **why)
{
    bool ok = true;

    if (s->is_direct)
        return s->is_own || close(s->fd) == 0 || set_reason(why);
    ok = flush_and_close_temporary(s->fd, s->target, true, why);
    if (ok && keep)
        ok = os_replace_file(os_unfinished_path(OS_STREAM_NUMBER), s->target, why);
    if (!ok || !keep)
        unlink(os_unfinished_path(OS_STREAM_NUMBER));
    os_forget_temporary(OS_STREAM_NUMBER);
    free(s->target);
    os_signals_end();
    return ok;
}

// ---- folders and environment ----

// Whether both name the same existing regular file; "-" is not a file.
bool os_same_file(const char *a, const char *b)
{
    struct stat x, y;

    if (strcmp(a, "-") == 0 || strcmp(b, "-") == 0 || stat(a, &x) != 0 || stat(b, &y) != 0)
        return false;
    return S_ISREG(x.st_mode) && x.st_dev == y.st_dev && x.st_ino == y.st_ino;
}

// Whether the path is a regular file with several hard links.
bool os_has_other_names(const char *path)
{
    struct stat st;

    return stat(path, &st) == 0 && S_ISREG(st.st_mode) && st.st_nlink > 1;
}

// Returns the folder that contains `path`, with links followed; allocated on the heap. NULL, with errno set, if there is no such folder.
static char *real_folder(const char *path)
{
    const char *slash = strrchr(path, '/');
    char *folder = slash ? strndup(path, (size_t)(slash - path) + 1) : strdup("."), *real = folder ? realpath(folder, NULL) : NULL;

    free(folder);
    return real;
}

enum { LINKS_MOST = 40, LINK_LENGTH = 4096 };         // the most links followed in a row, and the longest target of a link: common limits

// Returns the target of a symbolic link in the folder `folder`, allocated on the heap. NULL: `path` is not a link, or memory is
// exhausted.
static char *follow_link(const char *path, const char *folder)
{
    char target[LINK_LENGTH], *next;
    const ssize_t n = readlink(path, target, sizeof target - 1);
    const bool is_absolute = n > 0 && target[0] == '/';

    if (n < 0 || (next = malloc(strlen(folder) + (size_t)n + 2)) == NULL)
        return NULL;
    target[n] = '\0';
    strcpy(next, is_absolute ? "" : folder);
    strcat(next, is_absolute ? "" : "/");
    strcat(next, target);
    return next;
}

// Returns the number of the file descriptor that the file `name` in `folder` represents, else -1. On Linux /dev/fd links to /proc/PID/fd;
// on other systems /dev/fd is a folder.
static int parse_descriptor(const char *folder, const char *name)
{
    char process_folder[40];
    const int n = snprintf(process_folder, sizeof process_folder, "/proc/%ld/", (long)getpid());
    const size_t length = strlen(folder);
    const bool is_proc = strncmp(folder, process_folder, (size_t)n) == 0 && strcmp(folder + length - 3, "/fd") == 0;

    if (strcmp(folder, "/dev") == 0)
        return strcmp(name, "stdin") == 0 ? 0 : strcmp(name, "stdout") == 0 ? 1 : strcmp(name, "stderr") == 0 ? 2 : -1;
    if ((!is_proc && strcmp(folder, "/dev/fd") != 0) || *name == '\0' || strlen(name) > 6 || strspn(name, "0123456789") != strlen(name))
        return -1;
    return atoi(name);
}

// Returns the file descriptor of this process that a path names, as /dev/stdout, /dev/fd/1 or a link to one; else -1.
int os_find_descriptor(const char *path)
{
    char *at = strdup(path);
    int fd = -1;

    for (int i = 0; at && fd < 0 && i < LINKS_MOST; i++) {
        const char *slash = strrchr(at, '/');
        char *folder = real_folder(at), *next = NULL;
        if (folder && (fd = parse_descriptor(folder, slash ? slash + 1 : at)) < 0)
            next = follow_link(at, folder);
        free(folder);
        free(at);
        at = next;
    }
    free(at);
    return fd;
}

// Returns the path with symbolic links resolved, allocated on the heap.  The file need not exist.  NULL if its folder does not exist.
char *os_real_path(const char *path)
{
    char *at = strdup(path), *real = NULL;

    for (int i = 0; at && !real && i < LINKS_MOST; i++) {
        const char *slash = strrchr(at, '/'), *name = slash ? slash + 1 : at;
        char *folder, *next;
        struct stat st;
        if ((real = realpath(at, NULL)) != NULL || (folder = real_folder(at)) == NULL)
            break;
        if (lstat(at, &st) == 0 && S_ISLNK(st.st_mode)) {         // `at` is a link to a missing file
            next = follow_link(at, folder);
            free(at);
            at = next;
        } else if ((real = malloc(strlen(folder) + strlen(name) + 2)) != NULL) {
            strcpy(real, folder);
            strcat(real, "/");
            strcat(real, name);
        }
        free(folder);
    }
    free(at);
    return real;
}

bool os_is_folder(const char *path)
{
    struct stat st;
    return stat(path, &st) == 0 && S_ISDIR(st.st_mode);
}

// Creates the folder, but not its parents.  True if it already exists.
bool os_make_folder(const char *path, const char **why)
{
    int error;

    if (!check_name(path, why))
        return false;
    if (os_is_folder(path) || mkdir(path, 0777) == 0)
        return true;
    error = errno;
    if (os_is_folder(path))                               // another process has created the folder
        return true;
    *why = strerror(error);
    return false;
}

static int compare_names(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

// Lists the names in a folder, sorted, without . and ..; *names and its strings are one heap allocation.
bool os_list_folder(const char *path, char ***names, size_t *n, const char **why)
{
    struct dirent *entry;
    char **list = NULL, *text;
    size_t bytes = 0, count = 0, at = 0;
    DIR *folder;

    if (!check_name(path, why))
        return false;
    if ((folder = opendir(path)) == NULL)
        return set_reason(why);
    while ((entry = readdir(folder)) != NULL) {
        bytes += strlen(entry->d_name) + 1;
        count++;
    }
    rewinddir(folder);
    if ((list = malloc(count * sizeof *list + bytes + 1)) == NULL) {
        closedir(folder);
        *why = "out of memory";
        return false;
    }
    text = (char *)(list + count);
    *n = 0;
    while ((entry = readdir(folder)) != NULL && *n < count) {
        size_t len = strlen(entry->d_name) + 1;
        if (strcmp(entry->d_name, ".") == 0 || strcmp(entry->d_name, "..") == 0 || at + len > bytes)
            continue;
        memcpy(text + at, entry->d_name, len);
        list[(*n)++] = text + at;
        at += len;
    }
    closedir(folder);
    qsort(list, *n, sizeof *list, compare_names);
    *names = list;
    return true;
}

// ---- keys ----

bool os_get_random_bytes(void *bytes, size_t n, const char **why)
{
    const int fd = open("/dev/urandom", O_RDONLY);
    const ssize_t got = fd >= 0 ? read(fd, bytes, n) : -1;

    if (fd < 0 || got < 0)
        set_reason(why);
    else if ((size_t)got != n)
        *why = "there are too few random numbers";
    if (fd >= 0)
        close(fd);
    return got == (ssize_t)n;
}

bool os_write_private(const char *path, const void *bytes, size_t n, const char **why)
{
    bool ok;
    int fd;

    if (!check_name(path, why))
        return false;
    if ((fd = open(path, O_WRONLY | O_CREAT | O_EXCL, S_IRUSR | S_IWUSR)) < 0)
        return set_reason(why);
    ok = write_all(fd, bytes, n, why);
    if (close(fd) != 0 && ok)
        ok = set_reason(why);
    if (!ok)
        unlink(path);
    return ok;
}

// Whether only its owner can read the file, or the file does not exist.
bool os_is_private(const char *path)
{
    struct stat s;

    return stat(path, &s) != 0 || (s.st_mode & (S_IRGRP | S_IROTH)) == 0;
}

double os_seconds(void)
{
    struct timespec now = {0, 0};

    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + (double)now.tv_nsec / 1e9;
}

bool os_is_terminal(int fd) { return isatty(fd) == 1; }

bool os_shows_colors(int fd)
{
    const char *term = os_getenv("TERM");
    return os_is_terminal(fd) && !(term && strcmp(term, "dumb") == 0);
}

const char *os_getenv(const char *name)
{
    const char *value = getenv(name);
    return value && *value ? value : NULL;
}
