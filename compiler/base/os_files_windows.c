// SPDX-License-Identifier: Apache-2.0
// Reading and writing files, for os.h on Windows.  An output is written to a temporary file next to its target and then renamed, so that the
// target always is the old file or the complete new one.  A signal that ends the process removes the temporary files (os_signal.h).
#include "compiler/base/os_files.h"
#include "compiler/base/os_windows.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// ---- reading ----

long os_read_some(intptr_t file, void *into, size_t n, const char **why)
{
    DWORD got = 0;

    if (ReadFile((HANDLE)file, into, n > 1 << 20 ? 1 << 20 : (DWORD)n, &got, NULL))
        return (long)got;
    if (GetLastError() == ERROR_BROKEN_PIPE || GetLastError() == ERROR_HANDLE_EOF)
        return 0;
    windows_set_reason(why);
    return -1;
}

// Opens a file for reading; other programs can use it meanwhile.  Returns INVALID_HANDLE_VALUE, and the reason in *why, if that is impossible.
static HANDLE open_to_read(const char *path, const char **why)
{
    HANDLE file = INVALID_HANDLE_VALUE;

    if (!windows_check_name(path, why))
        return file;
    if (os_is_folder(path))
        *why = "it is a folder";
    else if ((file = windows_open_existing(path, GENERIC_READ)) == INVALID_HANDLE_VALUE)
        windows_set_reason(why);
    return file;
}

bool os_read_file(const char *path, size_t most, char **text, size_t *len, const char **why)
{
    HANDLE file;
    bool ok;

    if (strcmp(path, "-") == 0 || os_find_descriptor(path) == 0)
        return os_read_all((intptr_t)windows_standard_stream(0), most, text, len, why);
    if ((file = open_to_read(path, why)) == INVALID_HANDLE_VALUE)
        return false;
    ok = os_read_all((intptr_t)file, most, text, len, why);
    CloseHandle(file);
    return ok;
}

// Reads the size, identity and number of links of a file. Returns false if no regular file has this name.
static bool read_file_information(const char *path, BY_HANDLE_FILE_INFORMATION *information)
{
    const HANDLE file = windows_open_existing(path, FILE_READ_ATTRIBUTES);
    const bool ok = file != INVALID_HANDLE_VALUE && GetFileType(file) == FILE_TYPE_DISK && GetFileInformationByHandle(file, information) &&
                    !(information->dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY);

    if (file != INVALID_HANDLE_VALUE)
        CloseHandle(file);
    return ok;
}

bool os_read_head(const char *path, char *into, size_t n, size_t *len)
{
    BY_HANDLE_FILE_INFORMATION information;
    const char *why;
    HANDLE file;
    long got;

    *len = 0;
    if (!read_file_information(path, &information))
        return true;
    if ((file = windows_open_existing(path, GENERIC_READ)) == INVALID_HANDLE_VALUE)
        return false;
    got = os_read_some((intptr_t)file, into, n, &why);
    CloseHandle(file);
    *len = got > 0 ? (size_t)got : 0;
    return got >= 0;
}

bool os_reader_open(OsReader *r, const char *path, const char **why)
{
    BY_HANDLE_FILE_INFORMATION information;
    HANDLE file;

    if ((file = open_to_read(path, why)) == INVALID_HANDLE_VALUE)
        return false;
    if (GetFileType(file) != FILE_TYPE_DISK || !GetFileInformationByHandle(file, &information)) {
        *why = "it is not a regular file";
        CloseHandle(file);
        return false;
    }
    *r = (OsReader){(intptr_t)file, (uint64_t)information.nFileSizeHigh << 32 | information.nFileSizeLow, 0};
    return true;
}

void os_reader_close(OsReader *r) { CloseHandle((HANDLE)r->file); }

bool os_same_file(const char *a, const char *b)
{
    BY_HANDLE_FILE_INFORMATION x, y;

    if (strcmp(a, "-") == 0 || strcmp(b, "-") == 0 || !read_file_information(a, &x) || !read_file_information(b, &y))
        return false;
    return x.dwVolumeSerialNumber == y.dwVolumeSerialNumber && x.nFileIndexHigh == y.nFileIndexHigh && x.nFileIndexLow == y.nFileIndexLow;
}

bool os_has_other_names(const char *path)
{
    BY_HANDLE_FILE_INFORMATION information;

    return read_file_information(path, &information) && information.nNumberOfLinks > 1;
}

// ---- writing ----

bool windows_write_all(HANDLE file, const void *bytes, size_t n, const char **why)
{
    const char *p = bytes;
    DWORD put = 0;

    for (; n > 0; p += put, n -= put) {
        if (!WriteFile(file, p, n > 1 << 20 ? 1 << 20 : (DWORD)n, &put, NULL))
            return windows_set_reason(why);
        if (put == 0) {                               // a full disk that is reported as success
            *why = "No space left on device";
            return false;
        }
    }
    return true;
}

// Prints after flushing stderr: the C runtime buffers it if it is a file or a pipe, and earlier messages have to come first.
bool os_print(int fd, const void *bytes, size_t n, const char **why)
{
    fflush(stderr);
    return windows_write_all(windows_standard_stream(fd), bytes, n, why);
}

bool os_is_special(const char *path)
{
    wchar_t *wide;
    bool is_device;
    HANDLE file;

    if (os_find_descriptor(path) >= 0)
        return true;
    wide = windows_path(path);
    is_device = wide && wcsncmp(wide, L"\\\\.\\", 4) == 0;
    free(wide);
    if (is_device || (file = windows_open_existing(path, FILE_READ_ATTRIBUTES)) == INVALID_HANDLE_VALUE)
        return is_device;
    is_device = !os_is_folder(path) && GetFileType(file) != FILE_TYPE_DISK;
    CloseHandle(file);
    return is_device;
}

// Opens a path that is written without a temporary file. *is_own: it is a stream of this process, which stays open.
static HANDLE open_directly(const char *path, bool *is_own, const char **why)
{
    const int fd = strcmp(path, "-") == 0 ? 1 : os_find_descriptor(path);
    const HANDLE file = fd >= 0 ? windows_standard_stream(fd) : windows_open_existing(path, GENERIC_WRITE);

    *is_own = fd >= 0;
    if (file == INVALID_HANDLE_VALUE)
        windows_set_reason(why);
    return file;
}

// Returns the file that `path` names after following symbolic links, so that a link remains a link; on the heap.
static char *resolve_target(const char *path, const char **why)
{
    const DWORD a = windows_attributes(path);
    const bool is_link = a != INVALID_FILE_ATTRIBUTES && (a & FILE_ATTRIBUTE_REPARSE_POINT);
    char *target = is_link ? os_real_path(path) : strdup(path);

    if (!target)
        *why = is_link ? "its symbolic link leads to no folder" : "out of memory";
    return target;
}

// Returns the name of a temporary file next to `target`, on the heap.
static char *temporary_name(const char *target)
{
    static const char digits[] = "abcdefghijklmnopqrstuvwxyz012345";
    const size_t n = strlen(target);
    unsigned char random[6] = {0};
    char *temp = malloc(n + 8);

    if (!temp)
        return NULL;
    SystemFunction036(random, sizeof random);
    memcpy(temp, target, n);
    temp[n] = '.';
    for (size_t i = 0; i < sizeof random; i++)
        temp[n + 1 + i] = digits[random[i] % 32];
    temp[n + 7] = '\0';
    return temp;
}

HANDLE windows_create_new(const char *path, SECURITY_ATTRIBUTES *security, const char **why)
{
    wchar_t *wide = windows_path(path);
    const HANDLE file = wide ? CreateFileW(wide, GENERIC_WRITE, FILE_SHARE_READ | FILE_SHARE_DELETE, security, CREATE_NEW, FILE_ATTRIBUTE_NORMAL,
                                           NULL)
                             : INVALID_HANDLE_VALUE;

    if (file == INVALID_HANDLE_VALUE)
        *why = windows_reason(wide ? GetLastError() : ERROR_NOT_ENOUGH_MEMORY);
    free(wide);
    return file;
}

// Creates a temporary file next to `target`.  A signal that ends the process removes it from then on.
static HANDLE open_temporary(const char *target, int number, const char **why)
{
    char *temp;
    HANDLE file;

    if (os_is_folder(target)) {
        *why = "it is a folder";
        return INVALID_HANDLE_VALUE;
    }
    if ((temp = temporary_name(target)) == NULL) {
        windows_set_no_memory(why);
        return INVALID_HANDLE_VALUE;
    }
    os_signals_delay();
    if ((file = windows_create_new(temp, NULL, why)) == INVALID_HANDLE_VALUE)
        free(temp);
    else
        os_set_unfinished(number, temp);
    os_signals_resume();
    return file;
}

// Closes a temporary file.  FlushFileBuffers stores its bytes on the medium before the rename, so that after a power cut either the old
// file or the complete new one exists.
static bool flush_and_close_temporary(HANDLE file, bool ok, const char **why)
{
    if (ok && !FlushFileBuffers(file))
        ok = windows_set_reason(why);
    if (!CloseHandle(file) && ok)
        ok = windows_set_reason(why);
    return ok;
}

void os_remove_file(const char *path)
{
    wchar_t *wide = windows_path(path);

    if (wide)
        DeleteFileW(wide);
    free(wide);
}

// Puts a complete temporary file in the place of its target.  ReplaceFileW keeps the permissions and attributes of a replaced file; a file
// system that cannot do that only renames.  A virus scanner can hold a new file for a moment, so the rename is tried for 1 s.
bool os_replace_file(const char *temp, const char *target, const char **why)
{
    wchar_t *from = windows_path(temp), *to = windows_path(target);
    bool ok = false;
    DWORD error = ERROR_NOT_ENOUGH_MEMORY;

    for (int i = 0; from && to && !ok && i < 20; i++) {
        if (i > 0)
            Sleep(50);
        ok = (GetFileAttributesW(to) != INVALID_FILE_ATTRIBUTES && ReplaceFileW(to, from, NULL, REPLACEFILE_IGNORE_MERGE_ERRORS, NULL, NULL)) ||
             MoveFileExW(from, to, MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH);
        error = GetLastError();
        if (error != ERROR_SHARING_VIOLATION && error != ERROR_ACCESS_DENIED)
            break;
    }
    free(from);
    free(to);
    if (!ok)
        *why = windows_reason(error);
    return ok;
}

// Writes one output without a temporary file. Returns false and sets *why if that fails.
static bool write_directly(const OsOutput *out, const char **why)
{
    bool ok, is_own;
    const HANDLE file = open_directly(out->path, &is_own, why);

    if (file == INVALID_HANDLE_VALUE)
        return false;
    ok = windows_write_all(file, out->bytes, out->n, why);
    if (!is_own)
        CloseHandle(file);
    return ok;
}

// Writes one output to a temporary file beside its target; *target is then the path to rename it to. Special files are written directly.
bool os_write_temporary(const OsOutput *out, int number, char **target, const char **why)
{
    HANDLE file;

    if (!windows_check_name(out->path, why))
        return false;
    if (strcmp(out->path, "-") == 0 || os_is_special(out->path))
        return write_directly(out, why);
    if ((*target = resolve_target(out->path, why)) == NULL || (file = open_temporary(*target, number, why)) == INVALID_HANDLE_VALUE)
        return false;
    return flush_and_close_temporary(file, windows_write_all(file, out->bytes, out->n, why), why);
}

bool os_stream_open(OsStream *s, const char *path, const char **why)
{
    HANDLE file;

    if (!windows_check_name(path, why))
        return false;
    s->target = NULL;
    s->is_direct = strcmp(path, "-") == 0 || os_is_special(path);
    if (s->is_direct) {
        s->fd = windows_number(file = open_directly(path, &s->is_own, why));
        return file != INVALID_HANDLE_VALUE;
    }
    if ((s->target = resolve_target(path, why)) == NULL)
        return false;
    os_signals_begin();
    atexit(os_remove_unfinished);
    if ((file = open_temporary(s->target, OS_STREAM_NUMBER, why)) == INVALID_HANDLE_VALUE) {
        free(s->target);
        os_signals_end();
        return false;
    }
    s->fd = windows_number(file);
    return true;
}

bool os_stream_put(OsStream *s, const void *bytes, size_t n, const char **why)
{
    return windows_write_all(windows_handle(s->fd), bytes, n, why);
}

// Closes the output. With `keep`, a temporary file replaces its target; without, it is removed.
bool os_stream_close(OsStream *s, bool keep, const char **why)
{
    bool ok;

    if (s->is_direct)
        return s->is_own || CloseHandle(windows_handle(s->fd)) || windows_set_reason(why);
    ok = flush_and_close_temporary(windows_handle(s->fd), true, why);
    os_signals_delay();
    if (ok && keep)
        ok = os_replace_file(os_unfinished_path(OS_STREAM_NUMBER), s->target, why);
    if (!ok || !keep)
        os_remove_file(os_unfinished_path(OS_STREAM_NUMBER));
    os_forget_temporary(OS_STREAM_NUMBER);
    os_signals_resume();
    free(s->target);
    os_signals_end();
    return ok;
}
