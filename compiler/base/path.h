// SPDX-License-Identifier: Apache-2.0
// Paths as text: separators of folders.  '/' separates folders on every system, '\' also does on Windows.
#ifndef SMC_PATH_H
#define SMC_PATH_H

#include <stdbool.h>

#include "compiler/base/arena.h"

static inline bool path_is_separator(char c)
{
#ifdef _WIN32
    return c == '/' || c == '\\';
#else
    return c == '/';
#endif
}

// Returns the name of the file in a path: what follows its last separator, or the path itself.  On Windows a drive, as in C:tank.sm, is
// not part of the name.
const char *path_file_name(const char *path);
// Like path_file_name, but with / and \ as separators on every system.  For names in images and generated code, which must not depend on the
// system.
const char *path_portable_name(const char *path);
bool path_is_absolute(const char *path);
// Returns the path of the file that `from` names as `name`: relative to the folder of `from`, unless it is absolute.
const char *path_beside(Arena *arena, const char *from, const char *name);
// Returns the path without `.` and `FOLDER/..`, for comparing names of files that need not exist.
const char *path_simplify(Arena *arena, const char *path);
bool path_ends_in_separator(const char *path);

#endif
