// SPDX-License-Identifier: Apache-2.0
// The counters.  Readings drift, and sums reach the limits of the small types.
#include "tests/bench/workloads/intcount.h"

#include "intcount_o0.h"
#include "intcount_o1.h"
#include "intcount_o2.h"
#include "intcount_os.h"
#include "tests/bench/rows.h"

WORKLOAD_ROWS(intcount, Intcount)

static void inputs(Rng *r, void *at, unsigned n, unsigned episode)
{
    double adc0 = 2000, adc1 = 2000, encoder = 0;
    IntcountIn *in = at;
    int mode = 0;

    (void)episode;
    for (unsigned i = 0; i < n; i++) {
        if (rng_below(r, 50) == 0)
            mode = (int)rng_below(r, 4);
        adc0 += (2000 - adc0) * 0.01 + rng_noise(r, 300);
        adc1 += (2000 - adc1) * 0.01 + rng_noise(r, 300);
        encoder += rng_noise(r, 200);
        in[i].time = i + 1;
        in[i].encoder = (int32_t)(rng_below(r, 500) == 0 ? encoder * 1e5 : encoder);
        in[i].adc0 = (uint16_t)(adc0 < 0 ? 0 : adc0 > 4095 ? 4095 : adc0);
        in[i].adc1 = (uint16_t)(adc1 < 0 ? 0 : adc1 > 4095 ? 4095 : adc1);
        in[i].gyro = (int16_t)rng_noise(r, 4000);
        in[i].trim = (int8_t)rng_noise(r, 60);
        in[i].mode = (uint8_t)mode;
        in[i].pulse = rng_below(r, 5) < 3;
        in[i].fault = rng_below(r, 40) == 0;
    }
}

const Workload workload_intcount = {
    WORKLOAD(intcount, Intcount), .steps = 4000, .warm = 100, .count = 3900, .check = 4000,
};
