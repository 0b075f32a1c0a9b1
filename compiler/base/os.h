// SPDX-License-Identifier: Apache-2.0
// What the command needs from the operating system.  libsmc does not use it; only compiler/device and compiler/cli do.
// Every function that can fail returns false and puts a reason (static text, as "No space left on device") in *why.
// A file whose name contains a control character is neither read nor made: a newline in it would end a comment in emitted C, or a make rule.
#ifndef SMC_OS_H
#define SMC_OS_H

#include <stdbool.h>
#include <stddef.h>

// Memory for SmcAllocFn: the host's heap.
void *os_alloc(void *context, void *old, size_t size);

bool os_is_name(const char *name);                 // whether it has no control character

// Whole file or, for "-", standard input.  *text is from the heap (os_alloc), closed by a NUL that *len does not count.
// Refuses folders and anything longer than `most` bytes.
bool os_read(const char *path, size_t most, char **text, size_t *len, const char **why);

// Files that appear whole or not at all: each is written beside its place, and all are renamed once all are complete.
// A path "-" is standard output.  A signal that ends the process removes what is unfinished.
// What is replaced keeps its mode and, as far as the system allows, its owner.  A symbolic link stays one: the file that it leads to is
// replaced.  Of a file with several names (hard links) only this name gets the new contents.  To change all of them the file would have to
// be overwritten in place, and a power cut would leave half of it; nor may a backup that was made of hard links change.
typedef struct OsOutput { const char *path; const void *bytes; size_t n; } OsOutput;
bool os_write(const OsOutput *out, size_t n, const char **failed_path, const char **why);

// One file that grows while it is open, and appears when it is closed to be kept; standard output and devices as it grows.
// There is one at a time.
typedef struct OsStream { char *target; int fd; bool is_direct; } OsStream;
bool os_stream_open(OsStream *s, const char *path, const char **why);
bool os_stream_put(OsStream *s, const void *bytes, size_t n, const char **why);
bool os_stream_close(OsStream *s, bool keep, const char **why);

// Writes all of it to standard output or standard error (fd 1 or 2).
bool os_print(int fd, const void *bytes, size_t n, const char **why);

// The first bytes of a regular file, at most n; *len: how many, 0 where there is no such file.  False: it cannot be read.
bool os_read_head(const char *path, char *into, size_t n, size_t *len);

bool os_is_folder(const char *path);
bool os_is_special(const char *path);              // a device or pipe, as /dev/null
bool os_make_folder(const char *path, const char **why);     // the folder alone, not those it lies in; true if it is there already
// The path with symbolic links followed, from the heap; of a file that does not exist yet too.  NULL: its folder does not exist.
char *os_real_path(const char *path);
bool os_same_file(const char *a, const char *b);   // two names of one regular file that exists; "-" is none
// Names in a folder without . and .., sorted; *names and its strings are one block from the heap.
bool os_list(const char *path, char ***names, size_t *n, const char **why);

// Keys.  os_write_private makes a file that only its owner can read, and fails where there is one already.
bool os_random(void *bytes, size_t n, const char **why);
bool os_write_private(const char *path, const void *bytes, size_t n, const char **why);
bool os_is_private(const char *path);              // nobody but its owner may read it, or there is no such file

double os_seconds(void);                           // of a clock that only goes forward
bool os_is_terminal(int fd);
const char *os_getenv(const char *name);           // NULL when unset or empty

#endif
