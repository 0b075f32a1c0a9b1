// SPDX-License-Identifier: Apache-2.0
// Platform without serial lines.
#include "runtime-c/pal/serial.h"

SmResult pal_serial_open(PalSerial *line, const char *name, uint32_t bits_per_second)
{
    (void)line, (void)name, (void)bits_per_second;
    return SM_E_UNSUPPORTED;
}

SmResult pal_serial_send(PalSerial line, const void *bytes, size_t n, size_t *sent, uint64_t timeout)
{
    (void)line, (void)bytes, (void)n, (void)timeout;
    if (sent)
        *sent = 0;
    return SM_E_UNSUPPORTED;
}

SmResult pal_serial_receive(PalSerial line, void *bytes, size_t room, size_t *n, uint64_t timeout)
{
    (void)line, (void)bytes, (void)room, (void)n, (void)timeout;
    return SM_E_UNSUPPORTED;
}

SmResult pal_serial_close(PalSerial line)
{
    (void)line;
    return SM_E_UNSUPPORTED;
}
