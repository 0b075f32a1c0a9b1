// SPDX-License-Identifier: Apache-2.0
// The simulated console: stores the text for the test.
#include <string.h>

#include "runtime-c/pal/console.h"
#include "runtime-c/psl/sim/world.h"

static char kept[4096];
static size_t length;

void sim_console_reset(void)
{
    memset(kept, 0, sizeof kept);
    length = 0;
}

const char *sim_console(void)
{
    return kept;
}

SmResult pal_console_write(const char *text, size_t n)
{
    size_t room = sizeof kept - 1 - length;
    SmResult r;

    if (!text)
        return SM_E_ARGUMENT;
    r = sim_enter(SIM_console_write);
    if (r != SM_OK)
        return r;
    memcpy(kept + length, text, n < room ? n : room);
    length += n < room ? n : room;
    return n <= room ? SM_OK : SM_E_BUSY;
}
