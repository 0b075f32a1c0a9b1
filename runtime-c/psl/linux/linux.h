// SPDX-License-Identifier: Apache-2.0
// What the files of this platform share: one lock for the tables, the system's errors as results, waiting for a descriptor.
#ifndef PSL_LINUX_H
#define PSL_LINUX_H

#include <time.h>

#include "runtime-c/pal/clock.h"
#include "runtime-c/psl/table.h"

// Where the system shows its devices; tests put a folder of their own there.
#ifndef PSL_LINUX_GPIO
#define PSL_LINUX_GPIO "/dev/gpiochip"
#endif
#ifndef PSL_LINUX_IIO
#define PSL_LINUX_IIO "/sys/bus/iio/devices"
#endif
#ifndef PSL_LINUX_WATCHDOG
#define PSL_LINUX_WATCHDOG "/dev/watchdog"
#endif

// Taken while a table is searched and an entry filled in or freed.
void psl_guard(void);
void psl_unguard(void);

// An entry of a table by itself (table.h): what fills it in may take its time, as nobody else has it.
uint8_t psl_take(bool *used, uint8_t size);
void psl_release(bool *used, uint8_t id);

// An errno as a result; SM_E_DEVICE for those that the PAL has no number for.
SmResult psl_result(int error);

struct timespec psl_timespec(uint64_t ns);

// Waits until `events` (of poll) are there or the clock shows `deadline`: SM_OK, SM_E_TIMEOUT.  A descriptor that hung up is ready.
SmResult psl_wait(int fd, short events, uint64_t deadline);

// Waits until the folder that `path` is in knows its files: 0, or an errno.
int psl_sync_folder(const char *path);

#endif
