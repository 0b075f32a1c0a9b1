// SPDX-License-Identifier: Apache-2.0
// The decisions.  Every input has a new random value in every step.
#include "tests/bench/workloads/decide.h"

#include "decide_o0.h"
#include "decide_o1.h"
#include "decide_o2.h"
#include "decide_os.h"
#include "tests/bench/rows.h"

WORKLOAD_ROWS(decide, Decide)

static void inputs(Rng *r, void *at, unsigned n, unsigned episode)
{
    DecideIn *in = at;

    (void)episode;
    for (unsigned i = 0; i < n; i++) {
        memset(&in[i], 0, sizeof in[i]);
        in[i].time = i + 1;
        in[i].chamber = rng_unit(r) * 100;
        in[i].lox = (float)(rng_unit(r) * 60);
        in[i].fuel = (float)(rng_unit(r) * 60);
        in[i].flow = (float)(rng_unit(r) * 10);
        in[i].thrust = (int32_t)rng_below(r, 10000);
        in[i].bus = (uint16_t)(20000 + rng_below(r, 8000));
        in[i].speed = (uint16_t)(8000 + rng_below(r, 12000));
        in[i].vibe = (int16_t)rng_noise(r, 400);
        in[i].temp = (int16_t)rng_noise(r, 400);
        in[i].mode = (uint8_t)rng_below(r, 5);
        in[i].command = (uint8_t)rng_below(r, 256);
        in[i].armed = (uint8_t)rng_below(r, 2);
        in[i].hot = (uint8_t)rng_below(r, 2);
        in[i].cold = (uint8_t)rng_below(r, 2);
        in[i].wet = (uint8_t)rng_below(r, 2);
    }
}

const Workload workload_decide = {
    WORKLOAD(decide, Decide), .steps = 4000, .warm = 100, .count = 3900, .check = 4000,
};
