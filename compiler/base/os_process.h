// SPDX-License-Identifier: Apache-2.0
// Child processes: run to completion, or connected as a partner that exchanges data with this process.  Like os.h, for the command only.
// On failure a function returns false and sets *why to a reason.
#ifndef SMC_OS_PROCESS_H
#define SMC_OS_PROCESS_H

#include <stdbool.h>
#include <stddef.h>

// Creates a folder that only this user can access, and stores its path in `path` (n bytes).  Only one may exist at a time.  While it
// exists, a signal that ends the process is delayed: os_run_program ends its program and fails, and the process ends in os_remove_folder.
bool os_temp_folder(char *path, size_t n, const char **why);
// Removes the folder that os_temp_folder made, and the files in it.
void os_remove_folder(const char *path);

// Runs the program argv[0] (searched in PATH) with the NULL-terminated list argv, and waits for its end.  Its output goes to the file
// `output`, its temporary files to the folder `temp` (TMPDIR); NULL: to that of this process.  *exit_code is 128 + the signal's number if a
// signal ended the program.  The program runs in its own process group.  A signal that ends this process ends that whole group first.
bool os_run_program(const char *const *argv, const char *output, const char *temp, int *exit_code, const char **why);

// A partner: a child process whose standard input and output are connected to this process.  After a partner has died, the next write or
// read fails; no signal is raised.
typedef struct OsPartner {
    int fd;                   // the process's standard input and output; on Windows, only its input: the caller writes to it
    int from;                 // on Windows: the process's output, which the caller reads
    long pid;
} OsPartner;

bool os_partner_start(OsPartner *p, const char *const *argv, const char **why);
bool os_partner_write(OsPartner *p, const void *bytes, size_t n, const char **why);      // writes all n bytes to its standard input
bool os_partner_read(OsPartner *p, void *bytes, size_t n, const char **why);             // waits for exactly n bytes of its standard output
void os_partner_end(OsPartner *p);                        // closes the partner's input and waits for the partner's end

#endif
