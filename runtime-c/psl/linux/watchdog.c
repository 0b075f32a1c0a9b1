// SPDX-License-Identifier: Apache-2.0
// The watchdog: /dev/watchdog, hardware that restarts the computer.  Periods are whole seconds. pal_watchdog_stop asks the driver
// whether it can be stopped at all.  A driver with nowayout continues to run after a stop, which Linux does not report.  Ending the
// program does not stop the watchdog: the computer restarts, which is the purpose of a watchdog.
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <linux/watchdog.h>
#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "runtime-c/pal/watchdog.h"
#include "runtime-c/psl/linux/linux.h"

// The file in which the kernel reports the cause of the start.  Opening the device itself would start the watchdog.
#ifndef PSL_LINUX_BOOTSTATUS
#define PSL_LINUX_BOOTSTATUS "/sys/class/watchdog/watchdog0/bootstatus"
#endif

static int device = -1;

// Stops the watchdog: a 'V' before the close tells the driver that the stop is intended.
static void stop_device(void)
{
    while (write(device, "V", 1) < 0 && errno == EINTR) {}
    close(device);
    device = -1;
}

// Sets the period in nanoseconds, rounded up to whole seconds; *actual is what the device accepted.
static SmResult set_period(uint64_t period, uint64_t *actual)
{
    int seconds = (int)((period + PAL_SECOND - 1) / PAL_SECOND), wanted = seconds;

    if (ioctl(device, WDIOC_SETTIMEOUT, &seconds) != 0)
        return errno == EINVAL ? SM_E_ARGUMENT : psl_result_of_errno(errno);
    if (seconds < wanted)
        return SM_E_ARGUMENT;
    *actual = (uint64_t)seconds * PAL_SECOND;
    return SM_OK;
}

SmResult pal_watchdog_start(uint64_t period, uint64_t *actual)
{
    SmResult r;

    if (!actual || period == 0 || period > PAL_TIMEOUT_MAX)
        return SM_E_ARGUMENT;
    if (device >= 0)
        return SM_E_BUSY;
    device = open(PSL_LINUX_WATCHDOG, O_WRONLY | O_CLOEXEC);
    if (device < 0)
        return psl_result_of_errno(errno);
    r = set_period(period, actual);
    if (r != SM_OK)
        stop_device();
    return r;
}

SmResult pal_watchdog_feed(void)
{
    if (device < 0)
        return SM_E_HANDLE;
    return ioctl(device, WDIOC_KEEPALIVE, 0) == 0 ? SM_OK : psl_result_of_errno(errno);
}

SmResult pal_watchdog_stop(void)
{
    struct watchdog_info info;

    if (device < 0)
        return SM_E_HANDLE;
    memset(&info, 0, sizeof info);
    if (ioctl(device, WDIOC_GETSUPPORT, &info) != 0 || !(info.options & WDIOF_MAGICCLOSE))
        return SM_E_DENIED;
    stop_device();
    return SM_OK;
}

SmResult pal_watchdog_caused_start(bool *caused)
{
    char text[32] = "";
    unsigned long status;
    FILE *f;

    if (!caused)
        return SM_E_ARGUMENT;
    f = fopen(PSL_LINUX_BOOTSTATUS, "re");
    if (!f)
        return SM_E_UNSUPPORTED;
    if (!fgets(text, sizeof text, f) || sscanf(text, "%lu", &status) != 1) {
        fclose(f);
        return SM_E_DEVICE;
    }
    fclose(f);
    *caused = (status & WDIOF_CARDRESET) != 0;
    return SM_OK;
}
