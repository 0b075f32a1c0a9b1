// SPDX-License-Identifier: Apache-2.0
// The simulated console: stores the text for the test.
#include <string.h>

#include "runtime-c/pal/console.h"
#include "runtime-c/psl/sim/world.h"

static char text_written[4096];
static size_t length;

void sim_console_reset(void)
{
    memset(text_written, 0, sizeof text_written);
    length = 0;
}

// Returns the text written since sim_reset, at most 4095 bytes.
const char *sim_console(void)
{
    return text_written;
}

SmResult pal_console_write(const char *text, size_t n)
{
    size_t room = sizeof text_written - 1 - length;
    SmResult r;

    if (!text)
        return SM_E_ARGUMENT;
    r = sim_begin_call(SIM_console_write);
    if (r != SM_OK)
        return r;
    memcpy(text_written + length, text, n < room ? n : room);
    length += n < room ? n : room;
    return n <= room ? SM_OK : SM_E_BUSY;
}
