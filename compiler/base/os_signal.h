// SPDX-License-Identifier: Apache-2.0
// Signals that end the process while it has unfinished files or folders.  Used by the files os_*_posix.c.  All such POSIX signals that can
// be caught are handled, among them SIGPIPE: the report may go into a pipe that is closed while a trace is unfinished.  Signals that a fault
// of the program itself raises (SIGSEGV, SIGABRT ...) are not caught, because its memory cannot be trusted then.  A signal that was
// ignored when the process started stays ignored.
#ifndef SMC_OS_SIGNAL_H
#define SMC_OS_SIGNAL_H

// From os_signals_begin to os_signals_end, a signal removes the files registered with os_set_unfinished, then ends the process as the
// system would have done.  Pairs of these calls can nest.
void os_signals_begin(void);
void os_signals_end(void);
int os_signal_at(int i);                              // the number of the i-th handled signal, from 0; 0 after the last one

// The files that a signal removes.  Each has a number below OS_UNFINISHED; path NULL: no file has this number.  A path must stay valid until
// it is replaced.
enum { OS_UNFINISHED = 65 };
void os_set_unfinished(int number, char *path);
char *os_unfinished_path(int number);
void os_remove_unfinished(void);

// Between these two calls a signal is delayed: the process ends in os_signals_resume.  Used while something exists that a signal handler
// cannot remove, such as a folder.
void os_signals_delay(void);
void os_signals_resume(void);
int os_signal_waiting(void);                          // the number of the delayed signal, or 0

#endif
