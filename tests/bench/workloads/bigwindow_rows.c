// SPDX-License-Identifier: Apache-2.0
// The large window: a pressure that drifts over hundreds of steps, with noise.  The window is full before the measurement starts.
#include "tests/bench/workloads/bigwindow.h"

#include "bigwindow_o0.h"
#include "bigwindow_o1.h"
#include "bigwindow_o2.h"
#include "bigwindow_os.h"
#include "tests/bench/rows.h"

WORKLOAD_ROWS(bigwindow, Bigwindow)

static void inputs(Rng *r, void *at, unsigned n, unsigned episode)
{
    BigwindowIn *in = at;
    double mean = 700;

    (void)episode;
    for (unsigned i = 0; i < n; i++) {
        mean += (700 - mean) * 0.002 + rng_noise(r, 1);
        in[i].time = i + 1;
        in[i].pressure = mean + rng_noise(r, 20);
    }
}

const Workload workload_bigwindow = {
    WORKLOAD(bigwindow, Bigwindow), .steps = 4000, .warm = 1100, .count = 300, .check = 1500,
};
