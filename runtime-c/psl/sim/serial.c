// SPDX-License-Identifier: Apache-2.0
// Simulated serial lines, "serial0" and "serial1", with any of the usual speeds.  Sent bytes arrive immediately while the buffer
// has space.
#include <string.h>

#include "runtime-c/pal/clock.h"
#include "runtime-c/pal/serial.h"
#include "runtime-c/psl/sim/world.h"

#define LINES 2
#define ROOM  4096

typedef struct SerialQueue {
    size_t n;
    uint8_t bytes[ROOM];
} SerialQueue;

static struct {
    bool open, unplugged;
    SerialQueue in, out;
} lines[LINES];

static bool used[PAL_SERIALS];
static uint8_t line_of[PAL_SERIALS];

void sim_serial_reset(void)
{
    memset(lines, 0, sizeof lines);
    memset(used, 0, sizeof used);
}

// ---- queues ----

// Adds up to n bytes to the end of the queue, as many as fit.  Returns their number.
static size_t enqueue(SerialQueue *q, const void *bytes, size_t n)
{
    if (n > ROOM - q->n)
        n = ROOM - q->n;
    memcpy(q->bytes + q->n, bytes, n);
    q->n += n;
    return n;
}

// Removes up to `room` bytes from the front of the queue.  Returns their number.
static size_t dequeue(SerialQueue *q, void *bytes, size_t room)
{
    size_t n = q->n < room ? q->n : room;

    memcpy(bytes, q->bytes, n);
    q->n -= n;
    memmove(q->bytes, q->bytes + n, q->n);
    return n;
}

// ---- the far end ----

// Returns the index of the line, or LINES if no line has that name.
static uint8_t find_line(const char *name)
{
    return strcmp(name, "serial0") == 0 ? 0 : strcmp(name, "serial1") == 0 ? 1 : LINES;
}

// Sends bytes to the program, from the remote end of the line.
void sim_serial_send(const char *name, const void *bytes, size_t n)
{
    enqueue(&lines[find_line(name)].in, bytes, n);
}

// Receives what the program has sent, at the remote end of the line.  Returns the number of bytes.
size_t sim_serial_receive(const char *name, void *bytes, size_t room)
{
    return dequeue(&lines[find_line(name)].out, bytes, room);
}

// Unplugs the line from the computer, or plugs it in again.
void sim_serial_plug(const char *name, bool in)
{
    lines[find_line(name)].unplugged = !in;
}

// ---- the PAL ----

static bool is_supported_rate(uint32_t bits_per_second)
{
    static const uint32_t usual[] = {9600, 19200, 38400, 57600, 115200, 230400, 460800, 921600};

    for (size_t i = 0; i < sizeof usual / sizeof *usual; i++)
        if (usual[i] == bits_per_second)
            return true;
    return false;
}

SmResult pal_serial_open(PalSerial *line, const char *name, uint32_t bits_per_second)
{
    uint8_t id, number;
    SmResult r;

    if (!line || !name || strlen(name) >= PAL_NAME || !is_supported_rate(bits_per_second))
        return SM_E_ARGUMENT;
    number = find_line(name);
    if (number == LINES || lines[number].unplugged)
        return SM_E_MISSING;
    r = lines[number].open ? SM_E_BUSY : sim_begin_call(SIM_serial_open);
    if (r != SM_OK)
        return r;
    id = psl_table_allocate(used, PAL_SERIALS);
    if (id == 0)
        return SM_E_FULL;
    lines[number].open = true;
    lines[number].in.n = 0;
    line_of[id - 1] = number;
    line->id = id;
    return SM_OK;
}

static SmResult check_arguments(PalSerial line, const void *bytes, const size_t *n, uint64_t timeout)
{
    if (!bytes || !n || timeout > PAL_TIMEOUT_MAX)
        return SM_E_ARGUMENT;
    if (!psl_table_is_used(used, PAL_SERIALS, line.id))
        return SM_E_HANDLE;
    return lines[line_of[line.id - 1]].unplugged ? SM_E_CLOSED : SM_OK;
}

SmResult pal_serial_send(PalSerial line, const void *bytes, size_t n, size_t *sent, uint64_t timeout)
{
    const uint64_t deadline = pal_clock_now() + timeout;
    const uint8_t *from = bytes;
    SmResult r;

    if (sent)
        *sent = 0;
    r = check_arguments(line, bytes, sent, timeout);
    if (r == SM_OK)
        r = sim_begin_call(SIM_serial_send);
    while (r == SM_OK) {
        *sent += enqueue(&lines[line_of[line.id - 1]].out, from + *sent, n - *sent);
        if (*sent == n)
            break;
        r = sim_wait(deadline) ? check_arguments(line, bytes, sent, timeout) : SM_E_TIMEOUT;
    }
    return r;
}

SmResult pal_serial_receive(PalSerial line, void *bytes, size_t room, size_t *n, uint64_t timeout)
{
    const uint64_t deadline = pal_clock_now() + timeout;
    SmResult r = room == 0 ? SM_E_ARGUMENT : check_arguments(line, bytes, n, timeout);

    if (r == SM_OK)
        r = sim_begin_call(SIM_serial_receive);
    while (r == SM_OK) {
        const size_t got = dequeue(&lines[line_of[line.id - 1]].in, bytes, room);

        if (got > 0) {
            *n = got;
            break;
        }
        r = sim_wait(deadline) ? check_arguments(line, bytes, n, timeout) : SM_E_TIMEOUT;
    }
    return r;
}

SmResult pal_serial_close(PalSerial line)
{
    if (!psl_table_is_used(used, PAL_SERIALS, line.id))
        return SM_E_HANDLE;
    lines[line_of[line.id - 1]].open = false;
    used[line.id - 1] = false;
    return SM_OK;
}
