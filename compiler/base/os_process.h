// SPDX-License-Identifier: Apache-2.0
// Other programs: run to their end, or kept as a partner to talk to.  As os.h, for the command alone.
#ifndef SMC_OS_PROCESS_H
#define SMC_OS_PROCESS_H

#include <stdbool.h>
#include <stddef.h>

// A new folder that only this user can look into; its path goes to `path` (of `n` bytes).  There is one at a time.  While it exists, a
// signal that ends the process waits: os_run ends the program that it runs and fails, and the process ends in os_remove_folder.
bool os_temp_folder(char *path, size_t n, const char **why);
// Removes the folder that os_temp_folder made, and the files in it.
void os_remove_folder(const char *path);

// Runs argv[0] (looked for in PATH) with argv, a list that NULL closes, to its end.  What it prints goes to the file
// `output`.  *exit_code is 128 + the signal when one ended it.  It runs in a process group of its own, and a signal that ends this process
// ends the whole group first.
bool os_run(const char *const *argv, const char *output, int *exit_code, const char **why);

// A partner whose standard input and output are ours.  A partner that has died is an error of the next write or read,
// nothing worse.
typedef struct OsPartner {
    int fd;
    long pid;
} OsPartner;

bool os_partner_start(OsPartner *p, const char *const *argv, const char **why);
bool os_partner_write(OsPartner *p, const void *bytes, size_t n, const char **why);      // all of it
bool os_partner_read(OsPartner *p, void *bytes, size_t n, const char **why);             // exactly n bytes
void os_partner_end(OsPartner *p);                        // closes its input and waits until it has ended

#endif
