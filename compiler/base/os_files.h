// SPDX-License-Identifier: Apache-2.0
// Reading and writing files, for os.h: what is the same on all systems (os_files.c), and what os_posix.c or os_files_windows.c implements.
#ifndef SMC_OS_FILES_H
#define SMC_OS_FILES_H

#include "compiler/base/os.h"
#include "compiler/base/os_signal.h"

// Temporary files have numbers in os_signal.h: os_write_files uses 0 to OS_OUTPUTS_MOST - 1, the open stream uses OS_STREAM_NUMBER.
enum { OS_OUTPUTS_MOST = OS_UNFINISHED - 1, OS_STREAM_NUMBER = OS_OUTPUTS_MOST };

// ---- os_files.c ----

// Reads to the end of the file into a heap buffer.  Returns false and sets *why if reading fails or the file has more than `most` bytes.
bool os_read_all(intptr_t file, size_t most, char **text, size_t *len, const char **why);
// Unregisters a temporary file, so that a signal no longer removes it, and frees its path.
void os_forget_temporary(int number);

// ---- the system ----

// Reads up to n bytes of an open file: a descriptor, or a HANDLE of Windows.  Returns their number, 0 at the end of the file; -1, with the
// reason in *why, after an error.
long os_read_some(intptr_t file, void *into, size_t n, const char **why);
// Writes one output to a temporary file, which os_replace_file renames to *target.  *target stays NULL if the output was written directly.
bool os_write_temporary(const OsOutput *out, int number, char **target, const char **why);
bool os_replace_file(const char *temp, const char *target, const char **why);
void os_remove_file(const char *path);

#endif
