// SPDX-License-Identifier: Apache-2.0
// Signals that end the process (SIGINT, SIGTERM, SIGHUP) while it has something unfinished in the file system.  For the files os_*_posix.c.
// A signal that the process was started to ignore stays ignored.
#ifndef SMC_OS_SIGNAL_H
#define SMC_OS_SIGNAL_H

// From os_signals_begin to os_signals_end a signal removes the files that are noted here, then ends the process with 128 + its number.
// Pairs can nest.
void os_signals_begin(void);
void os_signals_end(void);

// Files to remove, by number below OS_UNFINISHED.  NULL: none.  The path must live until it is replaced.
enum { OS_UNFINISHED = 65 };
void os_unfinished(int number, char *path);
char *os_unfinished_path(int number);
void os_remove_unfinished(void);

// Between these two a signal does nothing but wait: the process ends in os_signals_resume.  For what a handler cannot remove, as a folder.
void os_signals_hold(void);
void os_signals_resume(void);
int os_signal_waiting(void);                          // the number of the signal that waits, or 0

#endif
