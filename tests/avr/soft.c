// SPDX-License-Identifier: Apache-2.0
// Firmware: executes one operation of soft binary64 at a time, with operands and result in RAM.  The emulating computer writes the operands to
// the mailbox, and counts the cycles between two writes of GPIOR0 (sim.h).
#include <avr/io.h>

#include "stdlib/convert.h"
#include "stdlib/math.h"
#include "tests/avr/mailbox.h"
#include "tests/soft/cells.h"

static Mailbox box;

static void operate(void)
{
    switch (box.op) {
#define OP(name, operands, soft, hardware)                                                      \
    case SOFT_##name: {                                                                         \
        BARRIER;                                                                                \
        GPIOR0 = AVR_BEGIN;                                                                     \
        BARRIER;                                                                                \
        const uint64_t a = box.a, b = box.b;                                                    \
        const SmF64 x = sm_from_bits(a), y = sm_from_bits(b);                                   \
        (void)x, (void)y, (void)b;                                                              \
        box.result = (soft);                                                                    \
        BARRIER;                                                                                \
        GPIOR0 = AVR_END;                                                                       \
        break;                                                                                  \
    }
#include "tests/soft/ops.def"
#undef OP
    default: break;
    }
}

int main(void)
{
    GPIOR1 = (uint8_t)(uint16_t)&box;
    GPIOR2 = (uint8_t)((uint16_t)&box >> 8);
    for (;;) {
        GPIOR0 = AVR_READY;
        BARRIER;
        operate();
        BARRIER;
    }
}
