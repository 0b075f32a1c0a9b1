// SPDX-License-Identifier: Apache-2.0
// Runs the emitted C of the parachutes on arrays.  fly.py compiles it with parachutes.c into a shared library.
#include "parachutes.h"

// For each of `rows` steps: stores the altitude, sets G to g[i], runs a step, and stores the outputs as bits (1: drogue, 2: main, 4: beacon) and
// the state that the next step runs.  Returns how many steps have run.
uint64_t fly_columns(uint64_t rows, const uint64_t *g, const float *altitude, uint8_t *outputs, uint32_t *states)
{
    ParachutesSv sv = {0};
    Parachutes m;
    uint64_t i;

    if (parachutes_init(&m, &sv, PARACHUTES_INITIAL_STATE) != PARACHUTES_OK)
        return 0;
    for (i = 0; i < rows; i++) {
        sv.altitude = altitude[i];
        sv.time = g[i];
        if (parachutes_step(&m, &sv) != PARACHUTES_OK)
            break;
        outputs[i] = (uint8_t)(sv.drogueCharge | sv.mainCharge << 1 | sv.beacon << 2);
        states[i] = m.state_;
    }
    return i;
}
