// SPDX-License-Identifier: Apache-2.0
// os_signal.h on Windows.  Ctrl-C, Ctrl-Break, closing the console, logging off and shutting down arrive in a separate thread.
#include "compiler/base/os_signal.h"
#include "compiler/base/os_windows.h"

#include <stdlib.h>

enum { EXIT_BY_CONTROL_C = (int)0xC000013A };         // STATUS_CONTROL_C_EXIT, with which the system ends a process

static SRWLOCK lock = SRWLOCK_INIT;                   // protects all variables of this file
static char *unfinished[OS_UNFINISHED];
static int waiting, held, begun;

void os_set_unfinished(int number, char *path)
{
    AcquireSRWLockExclusive(&lock);
    unfinished[number] = path;
    ReleaseSRWLockExclusive(&lock);
}

char *os_unfinished_path(int number) { return unfinished[number]; }
int os_signal_at(int i) { return i == 0 ? 1 : 0; }

int os_signal_waiting(void)
{
    int number;

    AcquireSRWLockShared(&lock);
    number = waiting;
    ReleaseSRWLockShared(&lock);
    return number;
}

void os_remove_unfinished(void)
{
    for (int i = 0; i < OS_UNFINISHED; i++) {
        wchar_t *wide = unfinished[i] ? windows_path(unfinished[i]) : NULL;
        if (wide)
            DeleteFileW(wide);
        free(wide);
    }
}

// Runs in its own thread.  The lock stays taken, so that the main thread can begin no further file until the process has ended.  If
// signals are delayed, the main thread ends the process in os_signals_resume.  When the console closes, the system ends the process as soon
// as this function returns, so it waits.
static BOOL WINAPI on_control(DWORD event)
{
    AcquireSRWLockExclusive(&lock);
    if (!held) {
        os_remove_unfinished();
        windows_end_processes();
        TerminateProcess(GetCurrentProcess(), (UINT)EXIT_BY_CONTROL_C);
    }
    waiting = 1;
    ReleaseSRWLockExclusive(&lock);
    if (event != CTRL_C_EVENT && event != CTRL_BREAK_EVENT)
        Sleep(INFINITE);
    return TRUE;
}

void os_signals_begin(void)
{
    if (begun++ == 0)
        SetConsoleCtrlHandler(on_control, TRUE);
}

void os_signals_end(void)
{
    if (--begun == 0)
        SetConsoleCtrlHandler(on_control, FALSE);
}

void os_signals_delay(void)
{
    os_signals_begin();
    AcquireSRWLockExclusive(&lock);
    held++;
    ReleaseSRWLockExclusive(&lock);
}

void os_signals_resume(void)
{
    bool ends;

    AcquireSRWLockExclusive(&lock);
    held--;
    ends = !held && waiting;
    if (ends) {
        os_remove_unfinished();
        windows_end_processes();
        TerminateProcess(GetCurrentProcess(), (UINT)EXIT_BY_CONTROL_C);
    }
    ReleaseSRWLockExclusive(&lock);
    os_signals_end();
}
