// SPDX-License-Identifier: Apache-2.0
// os.h on Windows: memory, strings, the reasons of errors, paths, and the process itself.  os_files_windows.c, os_folders_windows.c and
// os_private_windows.c are the rest of os.h.
#include "compiler/base/os.h"
#include "compiler/base/os_windows.h"

#include <fcntl.h>
#include <io.h>
#include <shellapi.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

bool windows_set_no_memory(const char **why)
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

wchar_t *windows_join(const wchar_t *a, const wchar_t *b)
{
    wchar_t *both = malloc((wcslen(a) + wcslen(b) + 1) * sizeof *both);

    if (both) {
        wcscpy(both, a);
        wcscat(both, b);
    }
    return both;
}

// Returns the absolute path with the prefix \\?\, which permits more than 260 characters; on the heap.
wchar_t *windows_path(const char *path)
{
    wchar_t *wide = windows_wide(strcmp(path, "/dev/null") == 0 ? os_null_device : path), *full, *whole;

    if (!wide || wide[0] == L'\0' || wcsncmp(wide, L"\\\\?\\", 4) == 0)
        return wide;
    full = absolute_path(wide);
    free(wide);
    if (!full || wcsncmp(full, L"\\\\.\\", 4) == 0)
        return full;
    whole = wcsncmp(full, L"\\\\", 2) == 0 ? windows_join(L"\\\\?\\UNC\\", full + 2) : windows_join(L"\\\\?\\", full);
    free(full);
    return whole;
}

// Returns the path without the prefix \\?\, as UTF-8, on the heap.
char *windows_plain_path(const wchar_t *path)
{
    const bool is_unc = wcsncmp(path, L"\\\\?\\UNC\\", 8) == 0;
    char *plain = windows_utf8(wcsncmp(path, L"\\\\?\\", 4) != 0 ? path : path + (is_unc ? 6 : 4));

    if (plain && is_unc)
        plain[0] = '\\';
    return plain;
}

// Returns the number of the standard stream that a path names, else -1. The names are those of Unix, so that a script works on both systems.
int os_find_descriptor(const char *path)
{
    static const char *const names[][2] = {{"/dev/stdin", "/dev/fd/0"}, {"/dev/stdout", "/dev/fd/1"}, {"/dev/stderr", "/dev/fd/2"}};

    for (int fd = 0; fd < 3; fd++)
        if (strcmp(path, names[fd][0]) == 0 || strcmp(path, names[fd][1]) == 0)
            return fd;
    return -1;
}

bool os_is_name(const char *name)
{
    while ((unsigned char)*name >= 0x20 && *name != 0x7F)
        name++;
    return *name == '\0';
}

bool windows_check_name(const char *path, const char **why)
{
    *why = "its name contains a control character";
    return os_is_name(path);
}

DWORD windows_attributes(const char *path)
{
    wchar_t *wide = windows_path(path);
    const DWORD attributes = wide ? GetFileAttributesW(wide) : INVALID_FILE_ATTRIBUTES;

    free(wide);
    return attributes;
}

bool os_is_folder(const char *path)
{
    const DWORD a = windows_attributes(path);
    return a != INVALID_FILE_ATTRIBUTES && (a & FILE_ATTRIBUTE_DIRECTORY);
}

HANDLE windows_open_existing(const char *path, DWORD access)
{
    const DWORD share = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;
    wchar_t *wide = windows_path(path);
    const HANDLE file = wide ? CreateFileW(wide, access, share, NULL, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, NULL) : INVALID_HANDLE_VALUE;
    const DWORD error = wide ? GetLastError() : ERROR_NOT_ENOUGH_MEMORY;

    free(wide);
    SetLastError(error);
    return file;
}

// ---- the process ----

HANDLE windows_standard_stream(int fd)
{
    return GetStdHandle(fd == 0 ? STD_INPUT_HANDLE : fd == 1 ? STD_OUTPUT_HANDLE : STD_ERROR_HANDLE);
}

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
    return GetConsoleMode(windows_standard_stream(fd), &mode);
}

// Whether a stream is a console that understands escape sequences for colours: Windows 10 and later.
bool os_shows_colors(int fd)
{
    const char *term = os_getenv("TERM");
    DWORD mode;

    return !(term && strcmp(term, "dumb") == 0) && GetConsoleMode(windows_standard_stream(fd), &mode) &&
           SetConsoleMode(windows_standard_stream(fd), mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
}

// Returns the value of an environment variable, NULL if it is absent or empty.  Values are never freed: few variables are read, each rarely.
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
