// SPDX-License-Identifier: Apache-2.0
// The operating system interface of the command.  libsmc does not use it; only compiler/device and compiler/cli do.
// On failure a function returns false and sets *why to a reason (static text, such as "No space left on device").
// A file whose name contains a control character is neither read nor created: a newline in it would end a comment in emitted C, or a
// make rule.
#ifndef SMC_OS_H
#define SMC_OS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

// An SmcAllocFn that allocates on the heap.  `context` is not used.
void *os_alloc(void *context, void *old, size_t size);

// Called first in main.  On Windows it replaces the arguments by their UTF-8, sets the console to UTF-8, and the standard streams to bytes
// as they are.
void os_start(int *argc, char ***argv);

extern const char os_null_device[];                // reads as an empty file, and drops what is written

bool os_is_name(const char *name);                 // whether the name contains no control character

// Reads a whole file or, for "-", standard input.  *text is allocated on the heap (os_alloc) and ends with a NUL that *len does not
// count.  Refuses folders and anything longer than `most` bytes.
bool os_read_file(const char *path, size_t most, char **text, size_t *len, const char **why);

// Writes files so that each appears complete or not at all.  Writes each output to a temporary file next to its target, and renames the
// temporary files when all of them are complete.  The path "-" is standard output.  Devices, pipes and open files of this process
// (os_find_descriptor) receive the bytes directly.  A signal that ends the process removes the temporary files.
// A replaced file keeps its mode and, as far as the system allows, its owner.  A symbolic link stays a link, and its target is replaced.
// If a file has several names (hard links), only this name gets the new contents.  To change all of them, the file would have to be
// overwritten in place: a power cut would leave half of it, and a backup made of hard links would change.
typedef struct OsOutput { const char *path; const void *bytes; size_t n; } OsOutput;
bool os_write_files(const OsOutput *out, size_t n, const char **failed_path, const char **why);

// A file written piece by piece.  The file appears when the stream is closed with `keep`; without `keep` it never appears.  Standard
// output and devices receive each piece at once.  Only one stream may be open at a time.
typedef struct OsStream { char *target; int fd; bool is_direct, is_own; } OsStream;
bool os_stream_open(OsStream *s, const char *path, const char **why);
bool os_stream_put(OsStream *s, const void *bytes, size_t n, const char **why);
bool os_stream_close(OsStream *s, bool keep, const char **why);

// Writes all n bytes to standard output or standard error (fd 1 or 2).
bool os_print(int fd, const void *bytes, size_t n, const char **why);

// Reads up to n bytes from the start of a regular file.  *len is their number, 0 if there is no such file.  False if it cannot be read.
bool os_read_head(const char *path, char *into, size_t n, size_t *len);

// A regular file read piece by piece, of any size.  Refuses folders, devices and pipes.  os_reader_get stores up to n bytes and their number,
// 0 at the end.  It fails if the file has become shorter than it was when it was opened.
typedef struct OsReader { intptr_t file; uint64_t size, done; } OsReader;
bool os_reader_open(OsReader *r, const char *path, const char **why);
bool os_reader_get(OsReader *r, void *into, size_t n, size_t *got, const char **why);
void os_reader_close(OsReader *r);

bool os_is_folder(const char *path);
// The file descriptor of this process that a path names, as /dev/stdout, /dev/fd/1, /proc/self/fd/1 or a link to one; else -1.
int os_find_descriptor(const char *path);
bool os_is_special(const char *path);              // whether it is a device or pipe, as /dev/null, or an open file of this process
bool os_make_folder(const char *path, const char **why);     // creates the folder, not its parents; true if it already exists
// The path with symbolic links resolved, allocated on the heap.  The file need not exist.  NULL if its folder does not exist.
char *os_real_path(const char *path);
bool os_has_other_names(const char *path);         // whether it is a regular file with several hard links
bool os_same_file(const char *a, const char *b);   // whether both name the same existing regular file; "-" is not a file
// Lists the names in a folder, sorted, without . and ..; *names and its strings are one heap allocation.
bool os_list_folder(const char *path, char ***names, size_t *n, const char **why);

// For secret keys.  os_get_random_bytes stores n random bytes.  os_write_private creates a file that only its owner can read, and fails if it exists.
bool os_get_random_bytes(void *bytes, size_t n, const char **why);
bool os_write_private(const char *path, const void *bytes, size_t n, const char **why);
bool os_is_private(const char *path);              // whether only its owner can read the file, or the file does not exist

double os_seconds(void);                           // returns the time of a monotonic clock, in seconds
bool os_is_terminal(int fd);
bool os_shows_colors(int fd);                      // whether fd is a terminal that understands ANSI escape sequences
const char *os_getenv(const char *name);           // returns the value of a variable; NULL if unset or empty

#endif
