// SPDX-License-Identifier: Apache-2.0
// os_signal.h on POSIX systems.  The handler only calls what is safe in one: unlink and _exit.
#define _XOPEN_SOURCE 700

#include "compiler/base/os_signal.h"

#include <signal.h>
#include <stddef.h>
#include <string.h>
#include <unistd.h>

static char *volatile unfinished[OS_UNFINISHED];      // written by the main flow, read by the handler
static volatile sig_atomic_t waiting, held;
static int begun;                                     // how often os_signals_begin is open

void os_unfinished(int number, char *path) { unfinished[number] = path; }
char *os_unfinished_path(int number) { return unfinished[number]; }
int os_signal_waiting(void) { return waiting; }

void os_remove_unfinished(void)
{
    for (int i = 0; i < OS_UNFINISHED; i++)
        if (unfinished[i])
            unlink(unfinished[i]);
}

static void end_process(int number)
{
    os_remove_unfinished();
    _exit(128 + number);
}

static void on_signal(int number)
{
    if (!held)
        end_process(number);
    waiting = number;
}

// Without SA_RESTART: a call that blocks returns, and its caller can ask os_signal_waiting.
static void catch_signals(void (*handler)(int))
{
    static const int numbers[] = {SIGINT, SIGTERM, SIGHUP};
    struct sigaction action, now;

    memset(&action, 0, sizeof action);
    sigemptyset(&action.sa_mask);
    action.sa_handler = handler;
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
        if (sigaction(numbers[i], NULL, &now) == 0 && now.sa_handler != SIG_IGN)
            sigaction(numbers[i], &action, NULL);
}

void os_signals_begin(void)
{
    if (begun++ > 0)
        return;
    catch_signals(on_signal);
    signal(SIGXFSZ, SIG_IGN);                         // a file larger than allowed: write reports it instead
}

void os_signals_end(void)
{
    if (--begun == 0)
        catch_signals(SIG_DFL);
}

void os_signals_hold(void)
{
    os_signals_begin();
    held++;
}

void os_signals_resume(void)
{
    held--;
    if (!held && waiting)
        end_process(waiting);
    os_signals_end();
}
