// SPDX-License-Identifier: Apache-2.0
// os_signal.h on POSIX systems. The handler calls only async-signal-safe functions: unlink, and those that end the process.
#define _XOPEN_SOURCE 700

#include "compiler/base/os_signal.h"

#include <signal.h>
#include <stddef.h>
#include <string.h>
#include <unistd.h>

static char *volatile unfinished[OS_UNFINISHED];      // written by normal code, read by the signal handler
static volatile sig_atomic_t waiting, held;
static int begun;                                     // how many calls of os_signals_begin are not ended yet

static const int numbers[] = {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGQUIT, SIGXCPU, SIGALRM, SIGVTALRM, SIGPROF, SIGUSR1, SIGUSR2};
enum { NUMBERS = sizeof numbers / sizeof *numbers };
static struct sigaction before[NUMBERS];              // the handlers that os_signals_begin replaced

// Registers the file that a signal removes, as number `number`; NULL: none.
void os_set_unfinished(int number, char *path) { unfinished[number] = path; }
char *os_unfinished_path(int number) { return unfinished[number]; }

// Returns the number of the delayed signal, or 0.
int os_signal_waiting(void) { return waiting; }

void os_remove_unfinished(void)
{
    for (int i = 0; i < OS_UNFINISHED; i++)
        if (unfinished[i])
            unlink(unfinished[i]);
}

// Returns the number of the i-th handled signal, from 0; 0 after the last one.
int os_signal_at(int i) { return i < NUMBERS ? numbers[i] : 0; }

// Ends the process by the default action of the signal, so that the parent process sees which signal it was.
static void end_process(int number)
{
    sigset_t set;

    os_remove_unfinished();
    signal(number, SIG_DFL);
    sigemptyset(&set);
    sigaddset(&set, number);
    sigprocmask(SIG_UNBLOCK, &set, NULL);
    raise(number);
    _exit(128 + number);
}

// The handler of signals: ends the process, or while os_signals_delay is in effect, only records the signal.
static void on_signal(int number)
{
    if (!held)
        end_process(number);
    waiting = number;
}

// Installs the handlers. Without SA_RESTART, a blocking call returns after a signal, and its caller can query os_signal_waiting.
void os_signals_begin(void)
{
    struct sigaction action;

    if (begun++ > 0)
        return;
    memset(&action, 0, sizeof action);
    sigemptyset(&action.sa_mask);
    for (int i = 0; i < NUMBERS; i++)
        sigaddset(&action.sa_mask, numbers[i]);
    action.sa_handler = on_signal;
    for (int i = 0; i < NUMBERS; i++)
        if (sigaction(numbers[i], NULL, &before[i]) == 0 && before[i].sa_handler == SIG_DFL)
            sigaction(numbers[i], &action, NULL);
    signal(SIGXFSZ, SIG_IGN);                         // at the size limit of a file, write then returns an error
}

void os_signals_end(void)
{
    if (--begun > 0)
        return;
    for (int i = 0; i < NUMBERS; i++)
        if (before[i].sa_handler == SIG_DFL)
            sigaction(numbers[i], &before[i], NULL);
}

// Delays the effect of signals until the matching os_signals_resume.
void os_signals_delay(void)
{
    os_signals_begin();
    held++;
}

// Ends the delay of os_signals_delay. A signal that arrived meanwhile ends the process.
void os_signals_resume(void)
{
    held--;
    if (!held && waiting)
        end_process(waiting);
    os_signals_end();
}
