// SPDX-License-Identifier: Apache-2.0
// A VM without windows: its verifier, which calls sm_roll_is_kind, refuses all of them.
#define SM_ROLL_NONE 1
#include "stdlib/roll.h"
#include "tests/test.h"

int main(void)
{
    uint64_t w[2] = { 1, 2 };

    for (uint32_t kind = 0; kind < 1024; kind++)
        CHECK(!sm_roll_is_kind(kind));
    sm_roll_sample(w, 8, SM_ROLL_U8 | SM_ROLL_MAX, sm_from_i32(7));
    CHECK(w[0] == 1 && w[1] == 2 && sm_bits(sm_roll_stat(w, 8, SM_ROLL_U8 | SM_ROLL_MAX, SM_STAT_MAX)) == 0);
    return test_end("stdlib_roll_none");
}
