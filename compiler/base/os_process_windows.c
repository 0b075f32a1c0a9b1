// SPDX-License-Identifier: Apache-2.0
// os_process.h on Windows.  Every child belongs to a job: when the job ends, all processes that the child started end too.
#include "compiler/base/os_process.h"
#include "compiler/base/os.h"
#include "compiler/base/os_signal.h"
#include "compiler/base/os_windows.h"
#include "compiler/base/path.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { POLL_MS = 20, REMOVE_TRIES = 50 };

// The jobs of running partners, by number (OsPartner.pid), and a folder that could not be removed while a program in it ran.
enum { PARTNERS_MOST = 16 };
static struct { HANDLE process, job; } partners[PARTNERS_MOST];
static wchar_t *left_folder;

// ---- folders ----

// Returns folder\name, on the heap; NULL: out of memory.
static wchar_t *child_path(const wchar_t *folder, const wchar_t *name)
{
    wchar_t *path = malloc((wcslen(folder) + wcslen(name) + 2) * sizeof *path);

    if (path) {
        wcscpy(path, folder);
        wcscat(path, L"\\");
        wcscat(path, name);
    }
    return path;
}

// Returns the folder for temporary files as UTF-8, on the heap.
static char *temporary_base(void)
{
    static const char *const names[] = {"TMPDIR", "TMP", "TEMP"};
    wchar_t wide[MAX_PATH + 1];

    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        const char *base = os_getenv(names[i]);
        if (base)
            return strdup(base);
    }
    return GetTempPathW(MAX_PATH + 1, wide) ? windows_utf8(wide) : strdup("C:\\");
}

// Creates a folder that only this user can access.  Returns 0 or an error of Windows.
static DWORD make_private_folder(const char *path)
{
    SECURITY_ATTRIBUTES security;
    SECURITY_DESCRIPTOR descriptor;
    ACL *acl = NULL;
    wchar_t *wide = windows_path(path);
    DWORD error = wide ? 0 : ERROR_NOT_ENOUGH_MEMORY;

    if (!error && (!windows_private_security(&security, &descriptor, &acl) || !CreateDirectoryW(wide, &security)))
        error = GetLastError();
    LocalFree(acl);
    free(wide);
    return error;
}

bool os_temp_folder(char *path, size_t n, const char **why)
{
    char *base = temporary_base();
    uint32_t number;
    DWORD error = base ? ERROR_ALREADY_EXISTS : ERROR_NOT_ENOUGH_MEMORY;

    os_signals_delay();
    for (int i = 0; i < 100 && error == ERROR_ALREADY_EXISTS; i++) {
        int len;
        if (!os_get_random_bytes(&number, sizeof number, why))
            break;
        len = snprintf(path, n, "%s%ssmc-%08lx", base, path_ends_in_separator(base) ? "" : "\\", (unsigned long)number);
        error = len < 0 || (size_t)len >= n ? ERROR_FILENAME_EXCED_RANGE : make_private_folder(path);
    }
    free(base);
    if (error == 0)
        return true;
    *why = windows_reason(error);
    path[0] = '\0';
    os_signals_resume();
    return false;
}

// Removes a folder and the files in it.  Returns false if one is still in use.
static bool remove_wide_folder(const wchar_t *folder)
{
    wchar_t *pattern = child_path(folder, L"*");
    WIN32_FIND_DATAW found;
    const HANDLE search = pattern ? FindFirstFileW(pattern, &found) : INVALID_HANDLE_VALUE;

    free(pattern);
    if (search != INVALID_HANDLE_VALUE) {
        do {
            wchar_t *path = found.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY ? NULL : child_path(folder, found.cFileName);
            if (path)
                DeleteFileW(path);
            free(path);
        } while (FindNextFileW(search, &found));
        FindClose(search);
    }
    return RemoveDirectoryW(folder) || GetLastError() == ERROR_FILE_NOT_FOUND || GetLastError() == ERROR_PATH_NOT_FOUND;
}

static bool has_partners(void)
{
    for (int i = 0; i < PARTNERS_MOST; i++)
        if (partners[i].process)
            return true;
    return false;
}

// Removes the folder that os_remove_folder could not remove yet. Windows refuses to remove the file of a running program, and of one that has just
// ended, so this function tries several times.
static void remove_left_folder(void)
{
    for (int i = 0; left_folder && !remove_wide_folder(left_folder) && i < REMOVE_TRIES; i++)
        Sleep(POLL_MS);
    free(left_folder);
    left_folder = NULL;
}

void os_remove_folder(const char *path)
{
    remove_left_folder();
    left_folder = windows_path(path);
    if (!has_partners() || !left_folder || remove_wide_folder(left_folder))
        remove_left_folder();
    os_signals_resume();
}

// Ends all programs that this process has started, and removes their folder. Called when a signal ends this process.
void windows_end_processes(void)
{
    for (int i = 0; i < PARTNERS_MOST; i++)
        if (partners[i].process) {
            TerminateJobObject(partners[i].job, 1);
            WaitForSingleObject(partners[i].process, 1000);
        }
    remove_left_folder();
}

// ---- command lines ----

typedef struct Line { wchar_t *text; size_t n, cap; } Line;

// Appends a character `times` times. Returns false if memory is exhausted.
static bool put_wide(Line *l, wchar_t c, size_t times)
{
    if (l->n + times + 1 > l->cap) {
        wchar_t *larger = realloc(l->text, (l->cap = (l->n + times + 1) * 2) * sizeof *larger);
        if (!larger)
            return false;
        l->text = larger;
    }
    for (; times > 0; times--)
        l->text[l->n++] = c;
    l->text[l->n] = L'\0';
    return true;
}

// Appends an argument in quotes, as CommandLineToArgvW and the C runtime read it: backslashes before a quote are doubled.
static bool put_argument(Line *l, const wchar_t *argument)
{
    size_t slashes = 0;
    bool ok = (l->n == 0 || put_wide(l, L' ', 1)) && put_wide(l, L'"', 1);

    for (; ok && *argument; argument++)
        if (*argument == L'\\') {
            slashes++;
        } else {
            ok = put_wide(l, L'\\', *argument == L'"' ? 2 * slashes + 1 : slashes) && put_wide(l, *argument, 1);
            slashes = 0;
        }
    return ok && put_wide(l, L'\\', 2 * slashes) && put_wide(l, L'"', 1);
}

// Returns the command line of a list of arguments, on the heap; NULL: out of memory.
static wchar_t *command_line(const char *const *argv)
{
    Line l = {0};
    bool ok = true;

    for (; ok && *argv; argv++) {
        wchar_t *wide = windows_wide(*argv);
        ok = wide && put_argument(&l, wide);
        free(wide);
    }
    if (ok)
        return l.text;
    free(l.text);
    return NULL;
}

// Returns the path of a program. A name without a folder is searched in PATH. Neither the current folder nor batch files are searched, and .exe
// is added where it is missing.  On the heap; NULL, with the last error set, if no such program exists.
static wchar_t *find_program(const char *name)
{
    const bool has_folder = path_file_name(name) > name;
    wchar_t *wide = windows_wide(name), *found = NULL;
    const char *variable = has_folder ? "." : os_getenv("PATH");
    wchar_t *path = windows_wide(variable ? variable : "");
    const DWORD n = wide && path && path[0] ? SearchPathW(path, wide, L".exe", 0, NULL, NULL) : 0;

    if (n && (found = malloc((n + 1) * sizeof *found)) != NULL)
        SearchPathW(path, wide, L".exe", n + 1, found, NULL);
    free(wide);
    free(path);
    if (!found)
        SetLastError(ERROR_FILE_NOT_FOUND);
    return found;
}

// ---- processes ----

// Returns a job whose processes end when its handle is closed.
static HANDLE create_job(void)
{
    JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits;
    const HANDLE job = CreateJobObjectW(NULL, NULL);

    memset(&limits, 0, sizeof limits);
    limits.BasicLimitInformation.LimitFlags = JOB_OBJECT_LIMIT_KILL_ON_JOB_CLOSE;
    if (job)
        SetInformationJobObject(job, JobObjectExtendedLimitInformation, &limits, sizeof limits);
    return job;
}

// Starts a program in a job, with these standard streams.  Returns 0 or an error of Windows.
static DWORD start_in_job(const char *const *argv, HANDLE in, HANDLE out, HANDLE error_out, HANDLE *process, HANDLE *job)
{
    wchar_t *program = find_program(argv[0]), *line = command_line(argv);
    PROCESS_INFORMATION started;
    STARTUPINFOW how;
    DWORD error = 0;

    memset(&how, 0, sizeof how);
    how.cb = sizeof how;
    how.dwFlags = STARTF_USESTDHANDLES;
    how.hStdInput = in;
    how.hStdOutput = out;
    how.hStdError = error_out;
    *job = create_job();
    if (!program || !line || !*job)
        error = program ? ERROR_NOT_ENOUGH_MEMORY : ERROR_FILE_NOT_FOUND;
    else if (!CreateProcessW(program, line, NULL, NULL, TRUE, CREATE_SUSPENDED, NULL, NULL, &how, &started))
        error = GetLastError();
    free(program);
    free(line);
    if (error) {
        CloseHandle(*job);
        return error;
    }
    AssignProcessToJobObject(*job, started.hProcess);
    ResumeThread(started.hThread);
    CloseHandle(started.hThread);
    *process = started.hProcess;
    return 0;
}

// Opens a file that a child inherits.
static HANDLE open_inherited(const char *path, DWORD access, DWORD how)
{
    SECURITY_ATTRIBUTES inherited = {sizeof inherited, NULL, TRUE};
    wchar_t *wide = windows_path(path);
    const HANDLE file = wide ? CreateFileW(wide, access, FILE_SHARE_READ | FILE_SHARE_WRITE, &inherited, how, FILE_ATTRIBUTE_NORMAL, NULL)
                             : INVALID_HANDLE_VALUE;

    free(wide);
    return file;
}

// The variables that name the folder for temporary files, as different programs read them.
static const wchar_t *const temp_names[] = {L"TMPDIR", L"TMP", L"TEMP"};
enum { TEMP_NAMES = sizeof temp_names / sizeof *temp_names };

// Sets the environment variables that name the folder for temporary files, and stores their previous values in before[].
static void replace_temp_variables(const char *temp, wchar_t *before[TEMP_NAMES])
{
    wchar_t *wide = windows_wide(temp);

    for (int i = 0; i < TEMP_NAMES; i++) {
        const DWORD n = GetEnvironmentVariableW(temp_names[i], NULL, 0);
        before[i] = n ? malloc((n + 1) * sizeof *before[i]) : NULL;
        if (before[i])
            GetEnvironmentVariableW(temp_names[i], before[i], n + 1);
        if (wide)
            SetEnvironmentVariableW(temp_names[i], wide);
    }
    free(wide);
}

// Sets the variables back to the values that replace_temp_variables stored, and frees these.
static void restore_temp_variables(wchar_t *before[TEMP_NAMES])
{
    for (int i = 0; i < TEMP_NAMES; i++) {
        SetEnvironmentVariableW(temp_names[i], before[i]);
        free(before[i]);
    }
}

// Starts a program whose output goes to `output`.  Returns 0 or an error of Windows.
static DWORD start_with_output(const char *const *argv, const char *output, HANDLE *process, HANDLE *job)
{
    const HANDLE in = open_inherited(os_null_device, GENERIC_READ, OPEN_EXISTING);
    const HANDLE out = open_inherited(output, GENERIC_WRITE, strcmp(output, os_null_device) == 0 ? OPEN_EXISTING : CREATE_ALWAYS);
    const DWORD error = in == INVALID_HANDLE_VALUE || out == INVALID_HANDLE_VALUE ? GetLastError() : start_in_job(argv, in, out, out, process, job);

    CloseHandle(in);
    CloseHandle(out);
    return error;
}

bool os_run_program(const char *const *argv, const char *output, const char *temp, int *exit_code, const char **why)
{
    wchar_t *before[TEMP_NAMES];
    HANDLE process, job;
    DWORD error, code = 0;
    bool interrupted = false;

    os_signals_delay();
    if (temp)
        replace_temp_variables(temp, before);
    error = start_with_output(argv, output, &process, &job);
    if (temp)
        restore_temp_variables(before);
    if (error) {
        *why = windows_reason(error);
        os_signals_resume();
        return false;
    }
    while (!interrupted && WaitForSingleObject(process, POLL_MS) == WAIT_TIMEOUT)
        interrupted = os_signal_waiting() != 0;
    if (interrupted)
        *why = "interrupted";
    TerminateJobObject(job, 1);                           // also ends processes that the program started and that still run
    GetExitCodeProcess(process, &code);
    *exit_code = (int)code;
    CloseHandle(process);
    CloseHandle(job);
    os_signals_resume();
    return !interrupted;
}

// ---- partners ----

// Creates a pipe of which a child inherits one end.
static bool make_pipe(HANDLE *read_end, HANDLE *write_end, bool child_reads)
{
    SECURITY_ATTRIBUTES inherited = {sizeof inherited, NULL, TRUE};

    return CreatePipe(read_end, write_end, &inherited, 0) && SetHandleInformation(child_reads ? *write_end : *read_end, HANDLE_FLAG_INHERIT, 0);
}

// Starts a program whose standard input and output the caller writes and reads.
bool os_partner_start(OsPartner *p, const char *const *argv, const char **why)
{
    HANDLE child_in, to, from, child_out;
    int number = 0;
    DWORD error;

    while (number < PARTNERS_MOST && partners[number].process)
        number++;
    *why = "too many programs are running";
    if (number == PARTNERS_MOST)
        return false;
    if (!make_pipe(&child_in, &to, true) || !make_pipe(&from, &child_out, false))
        return windows_set_reason(why);
    error = start_in_job(argv, child_in, child_out, GetStdHandle(STD_ERROR_HANDLE), &partners[number].process, &partners[number].job);
    CloseHandle(child_in);
    CloseHandle(child_out);
    if (error) {
        CloseHandle(to);
        CloseHandle(from);
        partners[number].process = NULL;
        *why = windows_reason(error);
        return false;
    }
    if (number == 0)
        atexit(windows_end_processes);
    p->fd = windows_number(to);
    p->from = windows_number(from);
    p->pid = number;
    return true;
}

bool os_partner_write(OsPartner *p, const void *bytes, size_t n, const char **why)
{
    const char *at = bytes;
    DWORD put;

    for (; n > 0; at += put, n -= put)
        if (!WriteFile(windows_handle(p->fd), at, (DWORD)n, &put, NULL))
            return windows_set_reason(why);
    return true;
}

bool os_partner_read(OsPartner *p, void *bytes, size_t n, const char **why)
{
    char *at = bytes;
    DWORD got;

    for (; n > 0; at += got, n -= got)
        if (!ReadFile(windows_handle(p->from), at, (DWORD)n, &got, NULL) || got == 0) {
            *why = "it ended by itself";
            return false;
        }
    return true;
}

void os_partner_end(OsPartner *p)
{
    HANDLE process = partners[p->pid].process;

    CloseHandle(windows_handle(p->fd));
    CloseHandle(windows_handle(p->from));
    WaitForSingleObject(process, INFINITE);
    partners[p->pid].process = NULL;
    CloseHandle(process);
    CloseHandle(partners[p->pid].job);
    if (!has_partners())
        remove_left_folder();
}
