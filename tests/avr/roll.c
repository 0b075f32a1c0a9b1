// SPDX-License-Identifier: Apache-2.0
// Firmware: a rolling window as in the VM, whose kind is known only at run time.

#include "stdlib/roll.h"
#include "tests/avr/mailbox.h"

static RollBox box __attribute__((aligned(2)));       // so that the host can read it directly
static uint64_t window[81];                           // 40 slots of F64, and 40 in ascending order

// Calls as in the VM: from one position in the code, without knowledge of the arguments.
__attribute__((noinline, noclone)) static void sample(uint32_t n, uint32_t kind, SmF64 x) { sm_roll_sample(window, n, kind, x); }
__attribute__((noinline, noclone)) static SmF64 stat(uint32_t n, uint32_t kind, SmStat s) { return sm_roll_stat(window, n, kind, s); }

static void act(void)
{
    const SmF64 x = sm_from_bits(box.x);

    if (box.what == ROLL_SAMPLE)
        sample(box.n, box.kind, x);
    else
        box.x = sm_bits(stat(box.n, box.kind, (SmStat)box.what));
}

int main(void)
{
    box.window = (uint16_t)window;
    box.window_size = sizeof window;
    mailbox_serve(&box, act, 0);
}
