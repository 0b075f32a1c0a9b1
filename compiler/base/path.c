// SPDX-License-Identifier: Apache-2.0
#include "compiler/base/path.h"

#include <string.h>

#include "compiler/base/buf.h"

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

// Returns the name of a file without folders, with / and \ as separators on every system.
const char *path_portable_name(const char *path)
{
    const char *name = path;

    for (; *path; path++)
        if (*path == '/' || *path == '\\')
            name = path + 1;
    return name;
}

bool path_is_absolute(const char *path) { return path_is_separator(path[0]) || drive_length(path) > 0; }

// Returns the path of the file that the file `from` calls `name`: relative to the folder of `from`, unless absolute.
const char *path_beside(Arena *arena, const char *from, const char *name)
{
    const int folder = (int)(path_file_name(from) - from);           // the length of the folder's path, with its separator

    return path_is_absolute(name) || folder == 0 ? name : format_in(arena, "%.*s%s", folder, from, name);
}

// Returns the length of `path` without the folder that it ends with; `n` if it ends with none that a `..` can cancel.
static size_t length_of_parent(const char *path, size_t n)
{
    size_t at = n > 0 ? n - 1 : 0;                                    // path[n - 1] is the separator

    while (at > 0 && !path_is_separator(path[at - 1]))
        at--;
    return n < 2 || (n - at == 3 && path[at] == '.' && path[at + 1] == '.') ? n : at;
}

// Returns the path without `.` and `FOLDER/..`.
const char *path_simplify(Arena *arena, const char *path)
{
    char *out = arena_alloc(arena, strlen(path) + 1);
    size_t n = 0;

    while (*path) {
        size_t len = 0;
        while (path[len] && !path_is_separator(path[len]))
            len++;
        if (len == 2 && path[0] == '.' && path[1] == '.' && length_of_parent(out, n) != n) {
            n = length_of_parent(out, n);
        } else if (!(len == 1 && path[0] == '.')) {
            memcpy(out + n, path, len);
            n += len;
            if (path[len])
                out[n++] = '/';
        }
        path += len + (path[len] != '\0');
    }
    out[n] = '\0';
    return out;
}

bool path_ends_in_separator(const char *path)
{
    const size_t n = strlen(path);
    return n > 0 && path_is_separator(path[n - 1]);
}
