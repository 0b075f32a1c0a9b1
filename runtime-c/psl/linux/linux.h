// SPDX-License-Identifier: Apache-2.0
// Internal to this platform: a mutex for the tables, conversion of errno to results, waiting for a file descriptor.
#ifndef PSL_LINUX_H
#define PSL_LINUX_H

#include <sys/types.h>
#include <time.h>

#include "runtime-c/pal/clock.h"
#include "runtime-c/psl/table.h"

// Paths of the system's devices; tests replace them with separate folders.
#ifndef PSL_LINUX_GPIO
#define PSL_LINUX_GPIO "/dev/gpiochip"
#endif
#ifndef PSL_LINUX_IIO
#define PSL_LINUX_IIO "/sys/bus/iio/devices"
#endif
#ifndef PSL_LINUX_WATCHDOG
#define PSL_LINUX_WATCHDOG "/dev/watchdog"
#endif

// Lock and unlock the mutex.  It must be locked while a table is searched and an entry is filled in or freed.
void psl_lock_tables(void);
void psl_unlock_tables(void);

// Takes an entry of a table (table.h) with the mutex locked only during this call.  The caller may then fill in the entry slowly,
// because no other thread has its handle yet.
uint8_t psl_allocate(bool *used, uint8_t size);
void psl_free(bool *used, uint8_t id);

// Converts an errno to a result; SM_E_DEVICE for an error without a PAL code.
SmResult psl_result_of_errno(int error);

struct timespec psl_timespec(uint64_t ns);

// Waits until one of `events` (of poll) occurs or the clock reaches `deadline`.  Returns SM_OK, SM_E_TIMEOUT or an error.  A
// descriptor that was hung up counts as ready.
SmResult psl_wait_for_events(int fd, short events, uint64_t deadline);

// Like write, but never raises a signal: without a reader it only fails with EPIPE, and beyond the size limit of files (ulimit -f) only
// with EFBIG.  The program's own handling of SIGPIPE and SIGXFSZ is unchanged.  Use it for all files that may be a pipe, a socket or a
// regular file.
ssize_t psl_write(int fd, const void *bytes, size_t n);

// Opens the folder that contains `path`, for reading.  Returns a descriptor; -1 and an errno on failure.
int psl_open_folder(const char *path);

// Waits until the entries of the folder that contains `path` are on the medium (fsync).  Returns 0 or an errno.
int psl_sync_folder(const char *path);

#endif
