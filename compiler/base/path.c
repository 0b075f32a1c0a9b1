// SPDX-License-Identifier: Apache-2.0
#include "compiler/base/path.h"

#include <string.h>

// Returns the length of the drive that a path begins with, as C: on Windows; 0 without one.
static size_t drive_length(const char *path)
{
#ifdef _WIN32
    const char letter = (char)(path[0] | 0x20);
    return letter >= 'a' && letter <= 'z' && path[1] == ':' ? 2 : 0;
#else
    (void)path;
    return 0;
#endif
}

const char *path_file_name(const char *path)
{
    const char *name = path + drive_length(path);

    for (const char *at = name; *at; at++)
        if (path_is_separator(*at))
            name = at + 1;
    return name;
}

const char *path_portable_name(const char *path)
{
    const char *name = path;

    for (; *path; path++)
        if (*path == '/' || *path == '\\')
            name = path + 1;
    return name;
}

bool path_is_absolute(const char *path) { return path_is_separator(path[0]) || drive_length(path) > 0; }

bool path_ends_in_separator(const char *path)
{
    const size_t n = strlen(path);
    return n > 0 && path_is_separator(path[n - 1]);
}
