// SPDX-License-Identifier: Apache-2.0
// Serial lines: terminal devices (/dev/ttyS0, /dev/ttyUSB0) in raw mode.
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <string.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include "runtime-c/pal/serial.h"
#include "runtime-c/psl/linux/linux.h"

static bool used[PAL_SERIALS];
static int lines[PAL_SERIALS];

static const struct {
    uint32_t bits_per_second;
    speed_t speed;
} speeds[] = {
    {1200, B1200}, {2400, B2400}, {4800, B4800}, {9600, B9600}, {19200, B19200}, {38400, B38400}, {57600, B57600},
    {115200, B115200}, {230400, B230400}, {460800, B460800}, {500000, B500000}, {576000, B576000}, {921600, B921600},
    {1000000, B1000000}, {1500000, B1500000}, {2000000, B2000000}, {3000000, B3000000}, {4000000, B4000000},
};

// Returns B0, which means hang up, for an unsupported speed.
static speed_t find_speed(uint32_t bits_per_second)
{
    for (size_t i = 0; i < sizeof speeds / sizeof *speeds; i++)
        if (speeds[i].bits_per_second == bits_per_second)
            return speeds[i].speed;
    return B0;
}

// tcsetattr succeeds if it could make any of the changes, so the resulting speed is checked afterwards.
static SmResult configure_line(int fd, speed_t speed)
{
    struct termios t;

    if (tcgetattr(fd, &t) != 0)
        return psl_result_of_errno(errno);
    cfmakeraw(&t);
    t.c_cflag &= ~(tcflag_t)(CSTOPB | CRTSCTS);
    t.c_cflag |= CLOCAL | CREAD;                           // ignore modem control lines
    t.c_iflag &= ~(tcflag_t)(IXOFF | IXANY);
    if (cfsetspeed(&t, speed) != 0 || tcsetattr(fd, TCSANOW, &t) != 0 || tcgetattr(fd, &t) != 0)
        return psl_result_of_errno(errno);
    tcflush(fd, TCIOFLUSH);
    return cfgetospeed(&t) == speed ? SM_OK : SM_E_ARGUMENT;
}

static SmResult open_line(const char *name, speed_t speed, int *fd)
{
    SmResult r;

    *fd = open(name, O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (*fd < 0)
        return psl_result_of_errno(errno);
    r = !isatty(*fd) ? SM_E_UNSUPPORTED : flock(*fd, LOCK_EX | LOCK_NB) != 0 ? SM_E_BUSY : configure_line(*fd, speed);
    if (r == SM_OK)
        ioctl(*fd, TIOCEXCL);                             // excludes programs that do not use flock
    else
        close(*fd);
    return r;
}

SmResult pal_serial_open(PalSerial *line, const char *name, uint32_t bits_per_second)
{
    speed_t speed = find_speed(bits_per_second);
    SmResult r = SM_E_FULL;
    uint8_t id;

    if (!line || !name || strlen(name) >= PAL_NAME || speed == B0)
        return SM_E_ARGUMENT;
    psl_lock_tables();
    id = psl_table_allocate(used, PAL_SERIALS);
    if (id != 0) {
        r = open_line(name, speed, &lines[id - 1]);
        used[id - 1] = r == SM_OK;
    }
    psl_unlock_tables();
    if (r == SM_OK)
        line->id = id;
    return r;
}

// Returns the result of a read or write that returned `got` and did not transfer anything.  If the line hung up, it returned 0 or failed
// with EIO.
static SmResult result_of_transfer(ssize_t got)
{
    return got == 0 || errno == EIO ? SM_E_CLOSED : psl_result_of_errno(errno);
}

static SmResult check_arguments(PalSerial line, const void *bytes, const size_t *n, uint64_t timeout)
{
    if (!bytes || !n || timeout > PAL_TIMEOUT_MAX)
        return SM_E_ARGUMENT;
    return psl_table_is_used(used, PAL_SERIALS, line.id) ? SM_OK : SM_E_HANDLE;
}

SmResult pal_serial_send(PalSerial line, const void *bytes, size_t n, size_t *sent, uint64_t timeout)
{
    uint64_t deadline = pal_clock_now() + timeout;
    const uint8_t *next = bytes;
    SmResult r;

    if (sent)
        *sent = 0;
    r = check_arguments(line, bytes, sent, timeout);
    while (r == SM_OK && *sent < n) {
        ssize_t taken = write(lines[line.id - 1], next + *sent, n - *sent);

        if (taken > 0)
            *sent += (size_t)taken;
        else if (taken < 0 && errno == EAGAIN)
            r = psl_wait_for_events(lines[line.id - 1], POLLOUT, deadline);
        else if (taken == 0 || errno != EINTR)
            r = result_of_transfer(taken);
    }
    return r;
}

SmResult pal_serial_receive(PalSerial line, void *bytes, size_t room, size_t *n, uint64_t timeout)
{
    uint64_t deadline = pal_clock_now() + timeout;
    SmResult r = check_arguments(line, bytes, n, timeout);

    if (r == SM_OK && room == 0)
        r = SM_E_ARGUMENT;
    while (r == SM_OK && (r = psl_wait_for_events(lines[line.id - 1], POLLIN, deadline)) == SM_OK) {
        ssize_t got = read(lines[line.id - 1], bytes, room);

        if (got > 0) {
            *n = (size_t)got;
            break;
        }
        if (got == 0 || (errno != EINTR && errno != EAGAIN))
            r = result_of_transfer(got);
    }
    return r;
}

SmResult pal_serial_close(PalSerial line)
{
    SmResult r = SM_E_HANDLE;

    psl_lock_tables();
    if (psl_table_is_used(used, PAL_SERIALS, line.id)) {
        tcflush(lines[line.id - 1], TCOFLUSH);            // otherwise close waits until all bytes are transmitted
        close(lines[line.id - 1]);
        used[line.id - 1] = false;
        r = SM_OK;
    }
    psl_unlock_tables();
    return r;
}
