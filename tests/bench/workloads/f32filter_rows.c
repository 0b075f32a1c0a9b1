// SPDX-License-Identifier: Apache-2.0
// The filters.  Accelerations and rates have noise, a height drifts, and a command changes in steps.
#include "tests/bench/workloads/f32filter.h"

#include "f32filter_o0.h"
#include "f32filter_o1.h"
#include "f32filter_o2.h"
#include "f32filter_os.h"
#include "tests/bench/rows.h"

WORKLOAD_ROWS(f32filter, F32filter)

static void inputs(Rng *r, void *at, unsigned n, unsigned episode)
{
    double x = 0, y = 0, z = 0, height = 0, climb = 0, command = 0;
    F32filterIn *in = at;

    (void)episode;
    for (unsigned i = 0; i < n; i++) {
        x = x * 0.99 + rng_noise(r, 1);
        y = y * 0.99 + rng_noise(r, 1);
        z = z * 0.99 + rng_noise(r, 1);
        climb = climb * 0.99 + rng_noise(r, 0.5);
        height = height * 0.999 + climb * 0.1;
        if (rng_below(r, 100) == 0)
            command = rng_noise(r, 6);
        memset(&in[i], 0, sizeof in[i]);
        in[i].time = i + 1;
        in[i].accX = (float)(x + rng_noise(r, 2));
        in[i].accY = (float)(y + rng_noise(r, 2));
        in[i].accZ = (float)(z + rng_noise(r, 2));
        in[i].gyroX = (float)rng_noise(r, 3);
        in[i].gyroY = (float)rng_noise(r, 3);
        in[i].baro = (float)(height + rng_noise(r, 1));
        in[i].command = (float)command;
    }
}

const Workload workload_f32filter = {
    WORKLOAD(f32filter, F32filter), .steps = 4000, .warm = 100, .count = 3900, .check = 4000,
};
