// SPDX-License-Identifier: Apache-2.0
// Swaps the machine of bench.app, and prints what happens.
#include <stdio.h>

#include "bench_app.h"
#include "image.h"

static void begin(const char *machine, SmSwapMode mode)
{
    const SmSwapChange change = {machine, image, sizeof image, (uint8_t)mode, NULL, false};

    printf("begin: %d\n", (int)sm_swap_begin(&bench_swaps, &change, 1));
}

// Prints the status when it has changed.
static void print_status(const SmTick *tick)
{
    static SmSwapStatus last;
    SmSwapStatus s;

    sm_swap_status(&bench_swaps, &s);
    if (s.phase != last.phase || s.number != last.number)
        printf("%2u: swap %u phase %d reason '%s' end %d, n = %u, state %u\n", (unsigned)tick->number, (unsigned)s.number, (int)s.phase,
               sm_swap_reason_text(s.reason), (int)s.end, (unsigned)bench_n(), (unsigned)bench_countState());
    last = s;
}

SmResult conduct_step(const SmTick *tick)
{
    print_status(tick);
    switch (tick->number) {
    case 2: begin("other", SM_SWAP_CONTINUE); break;
    case 4: bench_set_armed(true); begin("count", SM_SWAP_CONTINUE); break;
    case 8: bench_set_armed(false); begin("count", SM_SWAP_CONTINUE); break;
    case 14: printf("confirm: %d\n", (int)sm_swap_confirm(&bench_swaps)); break;
    case 16: begin("count", SM_SWAP_RESTART); break;
    case 70: sm_app_stop(&bench_app); break;
    default: break;
    }
    return SM_OK;
}
