// SPDX-License-Identifier: Apache-2.0
// Folders, for os.h on Windows: the real path of a file, whatever names lead to it, creating a folder, and listing its files in the order of
// their names.
#include "compiler/base/os.h"
#include "compiler/base/os_windows.h"
#include "compiler/base/path.h"

#include <stdlib.h>
#include <string.h>

// Returns the path of a file or folder that is there, with links followed; on the heap, NULL if it is not there.
static char *existing_path(const char *path)
{
    const HANDLE file = windows_open_existing(path, FILE_READ_ATTRIBUTES);
    const DWORD n = file != INVALID_HANDLE_VALUE ? GetFinalPathNameByHandleW(file, NULL, 0, FILE_NAME_NORMALIZED) : 0;
    wchar_t *wide = n ? malloc((n + 1) * sizeof *wide) : NULL;
    char *real = wide && GetFinalPathNameByHandleW(file, wide, n + 1, FILE_NAME_NORMALIZED) ? windows_plain_path(wide) : NULL;

    free(wide);
    if (file != INVALID_HANDLE_VALUE)
        CloseHandle(file);
    return real;
}

char *os_real_path(const char *path)
{
    const char *name = path_file_name(path);
    char *real = existing_path(path), *folder, *base;

    if (real)
        return real;
    if ((folder = strdup(path)) == NULL)
        return NULL;
    folder[name - path] = '\0';
    base = existing_path(folder[0] ? folder : ".");
    free(folder);
    if (base && (real = malloc(strlen(base) + strlen(name) + 2)) != NULL) {
        strcpy(real, base);
        strcat(real, path_ends_in_separator(base) ? "" : "\\");
        strcat(real, name);
    }
    free(base);
    return real;
}

bool os_make_folder(const char *path, const char **why)
{
    wchar_t *wide;
    bool ok;

    if (!windows_check_name(path, why))
        return false;
    if (os_is_folder(path))
        return true;
    wide = windows_path(path);
    ok = wide && CreateDirectoryW(wide, NULL);
    if (!ok)
        *why = windows_reason(wide ? GetLastError() : ERROR_NOT_ENOUGH_MEMORY);
    free(wide);
    return ok || os_is_folder(path);                      // another process may have created the folder
}

static int compare_names(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

typedef struct NameList { char *text; size_t bytes, cap, count; } NameList;

static bool add_name(NameList *l, const wchar_t *wide)
{
    char *name = windows_utf8(wide), *larger;
    const size_t n = name ? strlen(name) + 1 : 0;

    if (name && l->bytes + n > l->cap) {
        l->cap = (l->bytes + n) * 2;
        if ((larger = realloc(l->text, l->cap)) == NULL) {
            free(name);
            return false;
        }
        l->text = larger;
    }
    if (!name)
        return false;
    memcpy(l->text + l->bytes, name, n);
    l->bytes += n;
    l->count++;
    free(name);
    return true;
}

// Collects the names in a folder. Returns 0 or an error of Windows.
static DWORD collect_names(const char *path, NameList *l)
{
    wchar_t *folder = windows_path(path), *pattern = folder ? windows_join(folder, L"\\*") : NULL;
    WIN32_FIND_DATAW found;
    const HANDLE search = pattern ? FindFirstFileW(pattern, &found) : INVALID_HANDLE_VALUE;
    DWORD error = !pattern ? ERROR_NOT_ENOUGH_MEMORY : search == INVALID_HANDLE_VALUE ? GetLastError() : 0;

    free(folder);
    free(pattern);
    if (error)
        return error;
    do {
        if (wcscmp(found.cFileName, L".") != 0 && wcscmp(found.cFileName, L"..") != 0 && !add_name(l, found.cFileName))
            error = ERROR_NOT_ENOUGH_MEMORY;
    } while (!error && FindNextFileW(search, &found));
    if (!error && GetLastError() != ERROR_NO_MORE_FILES)
        error = GetLastError();
    FindClose(search);
    return error;
}

bool os_list_folder(const char *path, char ***names, size_t *n, const char **why)
{
    NameList l = {0};
    char **list = NULL, *text;
    DWORD error;

    if (!windows_check_name(path, why))
        return false;
    error = collect_names(path, &l);
    if (!error && (list = malloc(l.count * sizeof *list + l.bytes + 1)) == NULL)
        error = ERROR_NOT_ENOUGH_MEMORY;
    if (!error) {
        text = (char *)(list + l.count);
        if (l.bytes)
            memcpy(text, l.text, l.bytes);
        for (size_t i = 0; i < l.count; i++, text += strlen(text) + 1)
            list[i] = text;
        qsort(list, l.count, sizeof *list, compare_names);
        *names = list;
        *n = l.count;
    }
    free(l.text);
    if (error)
        *why = windows_reason(error);
    return error == 0;
}
