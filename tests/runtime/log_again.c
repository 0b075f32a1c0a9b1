// SPDX-License-Identifier: Apache-2.0
// A log whose description is longer than the interval of its repetition.  All other records are still written, and closing terminates.
#define SM_LOG_AGAIN 16u
#include "runtime-c/log_drain.c"

#include "log_parts.h"
#include "runtime-c/psl/sim/sim.h"

int main(void)
{
    SmTick tick = {0, 0};
    uint64_t before;

    sim_reset();
    reset_log("flight.log");
    CHECK(sm_log_init(&flight) == SM_OK);
    for (; tick.number < 20; tick.number++, tick.time += TICK) {
        fill_vector(tick.number, 0);
        CHECK(sm_log_step(&flight, &tick) == SM_OK && !sm_log_drain(&flight, PAL_SECOND) && flight.tail == flight.head);
    }
    before = flight.written;
    CHECK(before > 20 * flight.description_size);         // it was repeated
    CHECK(sm_log_close(&flight) == SM_OK && flight.written - before <= flight.description_size);
    return test_end("log again");
}
