// SPDX-License-Identifier: Apache-2.0
// The average of a window of the most slots that SM_ROLL_WAITING allows: the pending numbers fit into their array.
#define SM_ROLL_SMALL 1
#define SM_ROLL_WAITING 9
#include "stdlib/roll.h"
#include "tests/test.h"

enum { SLOTS = 1 << (SM_ROLL_WAITING - 1) };

static uint64_t memory[SLOTS + 2];
static SmRollSmall window;

// The memory has exactly the needed size, and bytes that must not change follow it.
static void check_average(uint32_t samples)
{
    SmF64 x[SM_ROLL_WAITING + 1];

    x[SM_ROLL_WAITING] = sm_from_bits(0xDEADu);
    window.count = samples;
    sm_roll_small_stat(&window, SM_STAT_AVG, x);
    CHECK(sm_bits(x[SM_ROLL_WAITING]) == 0xDEADu);
    CHECK(sm_bits(x[0]) == sm_bits(sm_from_u32(1)));
}

int main(void)
{
    const uint32_t kind = sm_roll_kind(SM_F32, SM_ROLL_AVG);

    CHECK(sm_roll_words(SLOTS, kind) <= SLOTS + 2);
    for (uint32_t i = 0; i < SLOTS; i++)
        sm_roll_sample(memory, SLOTS, kind, sm_from_u32(1));
    sm_roll_small_init(&window, memory, SLOTS, (uint16_t)kind);
    for (uint32_t samples = 1; samples <= SLOTS; samples++)
        check_average(samples);
    return test_end("stdlib_roll_waiting");
}
