// SPDX-License-Identifier: Apache-2.0
// os.h on Windows.
#include "compiler/base/os.h"
#include "compiler/base/os_signal.h"
#include "compiler/base/os_windows.h"
#include "compiler/base/path.h"

#include <aclapi.h>
#include <fcntl.h>
#include <io.h>
#include <shellapi.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

BOOLEAN NTAPI SystemFunction036(PVOID bytes, ULONG n);      // RtlGenRandom, which headers declare under this name only

#ifndef ENABLE_VIRTUAL_TERMINAL_PROCESSING
#define ENABLE_VIRTUAL_TERMINAL_PROCESSING 0x0004
#endif

const char os_null_device[] = "NUL";

void *os_alloc(void *context, void *old, size_t size)
{
    (void)context;
    if (size == 0) {
        free(old);
        return NULL;
    }
    return realloc(old, size);
}

// ---- texts and reasons ----

wchar_t *windows_wide(const char *text)
{
    const int n = MultiByteToWideChar(CP_UTF8, 0, text, -1, NULL, 0);
    wchar_t *wide = malloc(((size_t)n + 1) * sizeof *wide);

    if (wide && MultiByteToWideChar(CP_UTF8, 0, text, -1, wide, n) == 0)
        wide[0] = L'\0';
    return wide;
}

char *windows_utf8(const wchar_t *text)
{
    const int n = WideCharToMultiByte(CP_UTF8, 0, text, -1, NULL, 0, NULL, NULL);
    char *utf8 = malloc((size_t)n + 1);

    if (utf8 && WideCharToMultiByte(CP_UTF8, 0, text, -1, utf8, n, NULL, NULL) == 0)
        utf8[0] = '\0';
    return utf8;
}

static const struct { DWORD error; const char *text; } reasons[] = {
    {ERROR_FILE_NOT_FOUND, "No such file or directory"},
    {ERROR_PATH_NOT_FOUND, "No such file or directory"},
    {ERROR_BAD_NETPATH, "No such file or directory"},
    {ERROR_BAD_NET_NAME, "No such file or directory"},
    {ERROR_INVALID_DRIVE, "No such file or directory"},
    {ERROR_INVALID_NAME, "its name contains a character that Windows does not allow"},
    {ERROR_DIRECTORY, "Not a directory"},
    {ERROR_TOO_MANY_OPEN_FILES, "Too many open files"},
    {ERROR_ACCESS_DENIED, "Permission denied"},
    {ERROR_NETWORK_ACCESS_DENIED, "Permission denied"},
    {ERROR_SHARING_VIOLATION, "another program uses it"},
    {ERROR_LOCK_VIOLATION, "another program uses it"},
    {ERROR_USER_MAPPED_FILE, "another program uses it"},
    {ERROR_WRITE_PROTECT, "Read-only file system"},
    {ERROR_NOT_ENOUGH_MEMORY, "out of memory"},
    {ERROR_OUTOFMEMORY, "out of memory"},
    {ERROR_FILE_EXISTS, "File exists"},
    {ERROR_ALREADY_EXISTS, "File exists"},
    {ERROR_DISK_FULL, "No space left on device"},
    {ERROR_HANDLE_DISK_FULL, "No space left on device"},
    {1295 /* ERROR_DISK_QUOTA_EXCEEDED */, "Disk quota exceeded"},
    {ERROR_FILE_TOO_LARGE, "File too large"},
    {ERROR_BROKEN_PIPE, "Broken pipe"},
    {ERROR_NO_DATA, "Broken pipe"},
    {ERROR_FILENAME_EXCED_RANGE, "File name too long"},
    {ERROR_BUFFER_OVERFLOW, "File name too long"},
    {ERROR_INVALID_HANDLE, "Bad file descriptor"},
    {ERROR_CRC, "Input/output error"},
    {ERROR_IO_DEVICE, "Input/output error"},
    {ERROR_GEN_FAILURE, "Input/output error"},
};

const char *windows_reason(DWORD error)
{
    static char unknown[40];

    for (size_t i = 0; i < sizeof reasons / sizeof *reasons; i++)
        if (reasons[i].error == error)
            return reasons[i].text;
    snprintf(unknown, sizeof unknown, "error %lu of Windows", (unsigned long)error);
    return unknown;
}

bool windows_set_reason(const char **why)
{
    *why = windows_reason(GetLastError());
    return false;
}

static bool set_no_memory(const char **why)
{
    *why = "out of memory";
    return false;
}

// ---- paths ----

// Returns the absolute path, with backslashes and without the prefix \\?\, on the heap.
static wchar_t *absolute_path(const wchar_t *path)
{
    const DWORD n = GetFullPathNameW(path, 0, NULL, NULL);
    wchar_t *full = n ? malloc((n + 1) * sizeof *full) : NULL;

    if (full && GetFullPathNameW(path, n + 1, full, NULL) == 0)
        full[0] = L'\0';
    return full;
}

static wchar_t *join_wide(const wchar_t *a, const wchar_t *b)
{
    wchar_t *both = malloc((wcslen(a) + wcslen(b) + 1) * sizeof *both);

    if (both) {
        wcscpy(both, a);
        wcscat(both, b);
    }
    return both;
}

wchar_t *windows_path(const char *path)
{
    wchar_t *wide = windows_wide(strcmp(path, "/dev/null") == 0 ? os_null_device : path), *full, *whole;

    if (!wide || wide[0] == L'\0' || wcsncmp(wide, L"\\\\?\\", 4) == 0)
        return wide;
    full = absolute_path(wide);
    free(wide);
    if (!full || wcsncmp(full, L"\\\\.\\", 4) == 0)
        return full;
    whole = wcsncmp(full, L"\\\\", 2) == 0 ? join_wide(L"\\\\?\\UNC\\", full + 2) : join_wide(L"\\\\?\\", full);
    free(full);
    return whole;
}

// Returns a path without the prefix \\?\ as UTF-8, on the heap.
static char *plain_path(const wchar_t *path)
{
    const bool is_unc = wcsncmp(path, L"\\\\?\\UNC\\", 8) == 0;
    char *plain = windows_utf8(wcsncmp(path, L"\\\\?\\", 4) != 0 ? path : path + (is_unc ? 6 : 4));

    if (plain && is_unc)
        plain[0] = '\\';
    return plain;
}

bool os_is_name(const char *name)
{
    while ((unsigned char)*name >= 0x20 && *name != 0x7F)
        name++;
    return *name == '\0';
}

static bool check_name(const char *path, const char **why)
{
    *why = "its name contains a control character";
    return os_is_name(path);
}

static DWORD attributes_of(const char *path)
{
    wchar_t *wide = windows_path(path);
    const DWORD attributes = wide ? GetFileAttributesW(wide) : INVALID_FILE_ATTRIBUTES;

    free(wide);
    return attributes;
}

bool os_is_folder(const char *path)
{
    const DWORD a = attributes_of(path);
    return a != INVALID_FILE_ATTRIBUTES && (a & FILE_ATTRIBUTE_DIRECTORY);
}

// Opens a file that is there. Other programs can use it meanwhile. The result of CreateFileW.
static HANDLE open_existing(const char *path, DWORD access)
{
    const DWORD share = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;
    wchar_t *wide = windows_path(path);
    const HANDLE file = wide ? CreateFileW(wide, access, share, NULL, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, NULL) : INVALID_HANDLE_VALUE;
    const DWORD error = wide ? GetLastError() : ERROR_NOT_ENOUGH_MEMORY;

    free(wide);
    SetLastError(error);
    return file;
}

// ---- reading ----

// Returns the number of bytes read, 0 at the end, -1 after an error.
static long read_some(HANDLE file, void *bytes, size_t n)
{
    DWORD got = 0;

    if (ReadFile(file, bytes, n > 1 << 20 ? 1 << 20 : (DWORD)n, &got, NULL))
        return (long)got;
    return GetLastError() == ERROR_BROKEN_PIPE || GetLastError() == ERROR_HANDLE_EOF ? 0 : -1;
}

static bool read_all(HANDLE file, size_t most, char **text, size_t *len, const char **why)
{
    size_t cap = 16384, n = 0;
    char *buffer = malloc(cap);

    while (buffer) {
        const long got = read_some(file, buffer + n, cap - n - 1);
        if (got < 0 || n > most) {
            *why = got < 0 ? windows_reason(GetLastError()) : "the file is too large";
            free(buffer);
            return false;
        }
        if (got == 0) {
            buffer[n] = '\0';
            *text = buffer;
            *len = n;
            return true;
        }
        n += (size_t)got;
        if (cap - n < 2) {
            char *larger = realloc(buffer, cap *= 2);
            if (!larger)
                free(buffer);
            buffer = larger;
        }
    }
    return set_no_memory(why);
}

static HANDLE standard_stream(int fd)
{
    return GetStdHandle(fd == 0 ? STD_INPUT_HANDLE : fd == 1 ? STD_OUTPUT_HANDLE : STD_ERROR_HANDLE);
}

bool os_read_file(const char *path, size_t most, char **text, size_t *len, const char **why)
{
    HANDLE file;
    bool ok;

    if (strcmp(path, "-") == 0 || os_find_descriptor(path) == 0)
        return read_all(standard_stream(0), most, text, len, why);
    if (!check_name(path, why))
        return false;
    if (os_is_folder(path)) {
        *why = "it is a folder";
        return false;
    }
    if ((file = open_existing(path, GENERIC_READ)) == INVALID_HANDLE_VALUE)
        return windows_set_reason(why);
    ok = read_all(file, most, text, len, why);
    CloseHandle(file);
    return ok;
}

// Returns false if no regular file has this name.
static bool get_information(const char *path, BY_HANDLE_FILE_INFORMATION *information)
{
    const HANDLE file = open_existing(path, FILE_READ_ATTRIBUTES);
    const bool ok = file != INVALID_HANDLE_VALUE && GetFileType(file) == FILE_TYPE_DISK && GetFileInformationByHandle(file, information) &&
                    !(information->dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY);

    if (file != INVALID_HANDLE_VALUE)
        CloseHandle(file);
    return ok;
}

bool os_read_head(const char *path, char *into, size_t n, size_t *len)
{
    BY_HANDLE_FILE_INFORMATION information;
    HANDLE file;
    long got;

    *len = 0;
    if (!get_information(path, &information))
        return true;
    if ((file = open_existing(path, GENERIC_READ)) == INVALID_HANDLE_VALUE)
        return false;
    got = read_some(file, into, n);
    CloseHandle(file);
    *len = got > 0 ? (size_t)got : 0;
    return got >= 0;
}

bool os_reader_open(OsReader *r, const char *path, const char **why)
{
    BY_HANDLE_FILE_INFORMATION information;
    HANDLE file;

    if (!check_name(path, why))
        return false;
    if (os_is_folder(path)) {
        *why = "it is a folder";
        return false;
    }
    if ((file = open_existing(path, GENERIC_READ)) == INVALID_HANDLE_VALUE)
        return windows_set_reason(why);
    if (GetFileType(file) != FILE_TYPE_DISK || !GetFileInformationByHandle(file, &information)) {
        *why = "it is not a regular file";
        CloseHandle(file);
        return false;
    }
    *r = (OsReader){(intptr_t)file, (uint64_t)information.nFileSizeHigh << 32 | information.nFileSizeLow, 0};
    return true;
}

bool os_reader_get(OsReader *r, void *into, size_t n, size_t *got, const char **why)
{
    const long bytes = read_some((HANDLE)r->file, into, n);

    *got = bytes > 0 ? (size_t)bytes : 0;
    r->done += *got;
    if (bytes < 0)
        return windows_set_reason(why);
    if (bytes == 0 && r->done < r->size)
        *why = "the file became shorter while it was read";
    return bytes > 0 || r->done >= r->size;
}

void os_reader_close(OsReader *r) { CloseHandle((HANDLE)r->file); }

bool os_same_file(const char *a, const char *b)
{
    BY_HANDLE_FILE_INFORMATION x, y;

    if (strcmp(a, "-") == 0 || strcmp(b, "-") == 0 || !get_information(a, &x) || !get_information(b, &y))
        return false;
    return x.dwVolumeSerialNumber == y.dwVolumeSerialNumber && x.nFileIndexHigh == y.nFileIndexHigh && x.nFileIndexLow == y.nFileIndexLow;
}

bool os_has_other_names(const char *path)
{
    BY_HANDLE_FILE_INFORMATION information;

    return get_information(path, &information) && information.nNumberOfLinks > 1;
}

// ---- writing ----

static bool write_all(HANDLE file, const void *bytes, size_t n, const char **why)
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

// Other messages go to stderr by stdio, which the C runtime buffers where stderr is a file or a pipe: they come first.
bool os_print(int fd, const void *bytes, size_t n, const char **why)
{
    fflush(stderr);
    return write_all(standard_stream(fd), bytes, n, why);
}

enum { MOST_OUTPUTS = OS_UNFINISHED - 1, STREAM = MOST_OUTPUTS };     // numbers in os_signal.h, as in os_posix.c

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
    if (is_device || (file = open_existing(path, FILE_READ_ATTRIBUTES)) == INVALID_HANDLE_VALUE)
        return is_device;
    is_device = !os_is_folder(path) && GetFileType(file) != FILE_TYPE_DISK;
    CloseHandle(file);
    return is_device;
}

// Opens a path that is written without a temporary file. *is_own: it is a stream of this process, which stays open.
static HANDLE open_directly(const char *path, bool *is_own, const char **why)
{
    const int fd = strcmp(path, "-") == 0 ? 1 : os_find_descriptor(path);
    const HANDLE file = fd >= 0 ? standard_stream(fd) : open_existing(path, GENERIC_WRITE);

    *is_own = fd >= 0;
    if (file == INVALID_HANDLE_VALUE)
        windows_set_reason(why);
    return file;
}

// Returns the file that `path` names after following symbolic links, so that a link remains a link; on the heap.
static char *resolve_target(const char *path, const char **why)
{
    const DWORD a = attributes_of(path);
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

// Creates a file that does not exist yet. Others can read and remove it while it is open, so that a signal can remove it.
static HANDLE create_new(const char *path, SECURITY_ATTRIBUTES *security, const char **why)
{
    wchar_t *wide = windows_path(path);
    const HANDLE file = wide ? CreateFileW(wide, GENERIC_WRITE, FILE_SHARE_READ | FILE_SHARE_DELETE, security, CREATE_NEW, FILE_ATTRIBUTE_NORMAL, NULL)
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
        set_no_memory(why);
        return INVALID_HANDLE_VALUE;
    }
    os_signals_delay();
    if ((file = create_new(temp, NULL, why)) == INVALID_HANDLE_VALUE)
        free(temp);
    else
        os_set_unfinished(number, temp);
    os_signals_resume();
    return file;
}

// Closes a temporary file.  FlushFileBuffers stores its bytes on the medium before the rename, so that after a power cut either the old
// file or the complete new one exists.
static bool close_temporary(HANDLE file, bool ok, const char **why)
{
    if (ok && !FlushFileBuffers(file))
        ok = windows_set_reason(why);
    if (!CloseHandle(file) && ok)
        ok = windows_set_reason(why);
    return ok;
}

static void forget_temporary(int number)
{
    char *temp = os_unfinished_path(number);

    os_set_unfinished(number, NULL);
    free(temp);
}

static void remove_file(const char *path)
{
    wchar_t *wide = windows_path(path);

    if (wide)
        DeleteFileW(wide);
    free(wide);
}

// Puts a complete temporary file in the place of its target.  ReplaceFileW keeps the permissions and attributes of a replaced file; a file
// system that cannot do that only renames.  A virus scanner can hold a new file for a moment, so the rename is tried for 1 s.
static bool replace_file(const char *temp, const char *target, const char **why)
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

static bool write_directly(const OsOutput *out, const char **why)
{
    bool ok, is_own;
    const HANDLE file = open_directly(out->path, &is_own, why);

    if (file == INVALID_HANDLE_VALUE)
        return false;
    ok = write_all(file, out->bytes, out->n, why);
    if (!is_own)
        CloseHandle(file);
    return ok;
}

// Writes one output to a temporary file, which the caller renames to *target. *target stays NULL if the output was written directly.
static bool write_temporary(const OsOutput *out, int number, char **target, const char **why)
{
    HANDLE file;

    if (!check_name(out->path, why))
        return false;
    if (strcmp(out->path, "-") == 0 || os_is_special(out->path))
        return write_directly(out, why);
    if ((*target = resolve_target(out->path, why)) == NULL || (file = open_temporary(*target, number, why)) == INVALID_HANDLE_VALUE)
        return false;
    return close_temporary(file, write_all(file, out->bytes, out->n, why), why);
}

bool os_write_files(const OsOutput *out, size_t n, const char **failed_path, const char **why)
{
    char *target[MOST_OUTPUTS] = {NULL};
    bool ok = n <= MOST_OUTPUTS;

    *failed_path = n ? out[0].path : "";
    *why = "too many files";
    os_signals_begin();
    for (size_t i = 0; ok && i < n; i++) {
        *failed_path = out[i].path;
        ok = write_temporary(&out[i], (int)i, &target[i], why);
    }
    os_signals_delay();                               // a signal cannot interrupt the renames
    for (size_t i = 0; ok && i < n; i++)
        if (target[i]) {
            *failed_path = out[i].path;
            ok = replace_file(os_unfinished_path((int)i), target[i], why);
        }
    for (size_t i = 0; i < n && i < MOST_OUTPUTS; i++) {
        if (!ok && os_unfinished_path((int)i))
            remove_file(os_unfinished_path((int)i));
        forget_temporary((int)i);
        free(target[i]);
    }
    os_signals_resume();
    os_signals_end();
    return ok;
}

bool os_stream_open(OsStream *s, const char *path, const char **why)
{
    HANDLE file;

    if (!check_name(path, why))
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
    if ((file = open_temporary(s->target, STREAM, why)) == INVALID_HANDLE_VALUE) {
        free(s->target);
        os_signals_end();
        return false;
    }
    s->fd = windows_number(file);
    return true;
}

bool os_stream_put(OsStream *s, const void *bytes, size_t n, const char **why)
{
    return write_all(windows_handle(s->fd), bytes, n, why);
}

bool os_stream_close(OsStream *s, bool keep, const char **why)
{
    bool ok;

    if (s->is_direct)
        return s->is_own || CloseHandle(windows_handle(s->fd)) || windows_set_reason(why);
    ok = close_temporary(windows_handle(s->fd), true, why);
    os_signals_delay();
    if (ok && keep)
        ok = replace_file(os_unfinished_path(STREAM), s->target, why);
    if (!ok || !keep)
        remove_file(os_unfinished_path(STREAM));
    forget_temporary(STREAM);
    os_signals_resume();
    free(s->target);
    os_signals_end();
    return ok;
}

// ---- folders ----

// The Unix names of the standard streams are accepted, so that a script for both systems needs no second form.
int os_find_descriptor(const char *path)
{
    static const char *const names[][2] = {{"/dev/stdin", "/dev/fd/0"}, {"/dev/stdout", "/dev/fd/1"}, {"/dev/stderr", "/dev/fd/2"}};

    for (int fd = 0; fd < 3; fd++)
        if (strcmp(path, names[fd][0]) == 0 || strcmp(path, names[fd][1]) == 0)
            return fd;
    return -1;
}

// Returns the path of a file or folder that is there, with links followed; on the heap, NULL if it is not there.
static char *existing_path(const char *path)
{
    const HANDLE file = open_existing(path, FILE_READ_ATTRIBUTES);
    const DWORD n = file != INVALID_HANDLE_VALUE ? GetFinalPathNameByHandleW(file, NULL, 0, FILE_NAME_NORMALIZED) : 0;
    wchar_t *wide = n ? malloc((n + 1) * sizeof *wide) : NULL;
    char *real = wide && GetFinalPathNameByHandleW(file, wide, n + 1, FILE_NAME_NORMALIZED) ? plain_path(wide) : NULL;

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

    if (!check_name(path, why))
        return false;
    if (os_is_folder(path))
        return true;
    wide = windows_path(path);
    ok = wide && CreateDirectoryW(wide, NULL);
    if (!ok)
        *why = windows_reason(wide ? GetLastError() : ERROR_NOT_ENOUGH_MEMORY);
    free(wide);
    return ok || os_is_folder(path);                      // another process has created it
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
    wchar_t *folder = windows_path(path), *pattern = folder ? join_wide(folder, L"\\*") : NULL;
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

    if (!check_name(path, why))
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

// ---- keys ----

bool os_get_random_bytes(void *bytes, size_t n, const char **why)
{
    *why = "there are too few random numbers";
    return SystemFunction036(bytes, (ULONG)n);
}

// Returns information about this user, on the heap; NULL if that fails.
static TOKEN_USER *current_user(void)
{
    TOKEN_USER *user = NULL;
    HANDLE token;
    DWORD n = 0;

    if (!OpenProcessToken(GetCurrentProcess(), TOKEN_QUERY, &token))
        return NULL;
    GetTokenInformation(token, TokenUser, NULL, 0, &n);
    if (n && (user = malloc(n)) != NULL && !GetTokenInformation(token, TokenUser, user, n, &n)) {
        free(user);
        user = NULL;
    }
    CloseHandle(token);
    return user;
}

bool windows_private_security(SECURITY_ATTRIBUTES *attributes, SECURITY_DESCRIPTOR *descriptor, ACL **acl)
{
    TOKEN_USER *user = current_user();
    const DWORD n = user ? (DWORD)(sizeof(ACL) + sizeof(ACCESS_ALLOWED_ACE)) + GetLengthSid(user->User.Sid) : 0;
    const bool ok = user && (*acl = LocalAlloc(LPTR, n)) != NULL && InitializeAcl(*acl, n, ACL_REVISION) &&
                    AddAccessAllowedAceEx(*acl, ACL_REVISION, OBJECT_INHERIT_ACE | CONTAINER_INHERIT_ACE, GENERIC_ALL, user->User.Sid) &&
                    InitializeSecurityDescriptor(descriptor, SECURITY_DESCRIPTOR_REVISION) && SetSecurityDescriptorDacl(descriptor, TRUE, *acl, FALSE) &&
                    SetSecurityDescriptorControl(descriptor, SE_DACL_PROTECTED, SE_DACL_PROTECTED);

    free(user);
    attributes->nLength = sizeof *attributes;
    attributes->lpSecurityDescriptor = descriptor;
    attributes->bInheritHandle = FALSE;
    return ok;
}

bool os_write_private(const char *path, const void *bytes, size_t n, const char **why)
{
    SECURITY_ATTRIBUTES security;
    SECURITY_DESCRIPTOR descriptor;
    ACL *acl = NULL;
    HANDLE file;
    bool ok;

    if (!check_name(path, why))
        return false;
    if (!windows_private_security(&security, &descriptor, &acl)) {
        LocalFree(acl);
        *why = "its permissions cannot be set";
        return false;
    }
    file = create_new(path, &security, why);
    LocalFree(acl);
    if (file == INVALID_HANDLE_VALUE)
        return false;
    ok = write_all(file, bytes, n, why);
    if (!CloseHandle(file) && ok)
        ok = windows_set_reason(why);
    if (!ok)
        remove_file(path);
    return ok;
}

// Whether a user other than the owner is meant. The system and the administrators can read every file.
static bool is_other_user(PSID sid, PSID owner)
{
    return !EqualSid(sid, owner) && !IsWellKnownSid(sid, WinLocalSystemSid) && !IsWellKnownSid(sid, WinBuiltinAdministratorsSid) &&
           !IsWellKnownSid(sid, WinCreatorOwnerSid) && !IsWellKnownSid(sid, WinCreatorOwnerRightsSid);
}

static bool others_can_read(ACL *acl, PSID owner)
{
    const DWORD reads = FILE_READ_DATA | GENERIC_READ | GENERIC_ALL;

    for (DWORD i = 0; acl && i < acl->AceCount; i++) {
        ACCESS_ALLOWED_ACE *ace;
        if (GetAce(acl, i, (void **)&ace) && ace->Header.AceType == ACCESS_ALLOWED_ACE_TYPE && (ace->Mask & reads) &&
            is_other_user((PSID)&ace->SidStart, owner))
            return true;
    }
    return acl == NULL;
}

bool os_is_private(const char *path)
{
    wchar_t *wide = windows_path(path);
    PSECURITY_DESCRIPTOR descriptor = NULL;
    PSID owner = NULL;
    ACL *acl = NULL;
    const DWORD error = wide ? GetNamedSecurityInfoW(wide, SE_FILE_OBJECT, OWNER_SECURITY_INFORMATION | DACL_SECURITY_INFORMATION, &owner, NULL, &acl, NULL,
                                                     &descriptor)
                             : ERROR_NOT_ENOUGH_MEMORY;
    const bool is_private = error != 0 || !others_can_read(acl, owner);

    LocalFree(descriptor);
    free(wide);
    return is_private;
}

// ---- the process ----

static UINT console_before;

static void restore_console(void) { SetConsoleOutputCP(console_before); }

// Returns the arguments as UTF-8; NULL: out of memory.  They live as long as the process.
static char **utf8_arguments(int *argc)
{
    wchar_t **wide = CommandLineToArgvW(GetCommandLineW(), argc);
    char **argv = wide ? malloc(((size_t)*argc + 1) * sizeof *argv) : NULL;

    for (int i = 0; argv && i < *argc; i++)
        if ((argv[i] = windows_utf8(wide[i])) == NULL)
            return NULL;
    if (argv)
        argv[*argc] = NULL;
    LocalFree(wide);
    return argv;
}

void os_start(int *argc, char ***argv)
{
    char **utf8 = utf8_arguments(argc);

    if (!utf8) {
        fputs("smc: out of memory\n", stderr);
        exit(3);
    }
    *argv = utf8;
    for (int fd = 0; fd < 3; fd++)
        _setmode(fd, _O_BINARY);
    if (os_is_terminal(1) || os_is_terminal(2)) {
        console_before = GetConsoleOutputCP();
        SetConsoleOutputCP(CP_UTF8);
        atexit(restore_console);
    }
}

double os_seconds(void)
{
    LARGE_INTEGER now, frequency;

    QueryPerformanceFrequency(&frequency);
    QueryPerformanceCounter(&now);
    return (double)now.QuadPart / (double)frequency.QuadPart;
}

bool os_is_terminal(int fd)
{
    DWORD mode;
    return GetConsoleMode(standard_stream(fd), &mode);
}

// Consoles before Windows 10 do not understand escape sequences.
bool os_shows_colors(int fd)
{
    const char *term = os_getenv("TERM");
    DWORD mode;

    return !(term && strcmp(term, "dumb") == 0) && GetConsoleMode(standard_stream(fd), &mode) &&
           SetConsoleMode(standard_stream(fd), mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
}

// Values are stored as long as the process lives: few variables are read, each only a few times.
const char *os_getenv(const char *name)
{
    wchar_t *wide = windows_wide(name), *value = NULL;
    const DWORD n = wide ? GetEnvironmentVariableW(wide, NULL, 0) : 0;
    char *utf8 = NULL;

    if (n > 1 && (value = malloc((n + 1) * sizeof *value)) != NULL && GetEnvironmentVariableW(wide, value, n + 1) < n)
        utf8 = windows_utf8(value);
    free(value);
    free(wide);
    return utf8;
}
