// SPDX-License-Identifier: Apache-2.0
// The red lines.  Sensors have single outliers, which the medians remove.  Now and then a sensor stays beyond its limit.
#include "tests/bench/workloads/redlines.h"

#include "redlines_o0.h"
#include "redlines_o1.h"
#include "redlines_o2.h"
#include "redlines_os.h"
#include "tests/bench/rows.h"

WORKLOAD_ROWS(redlines, Redlines)

static void inputs(Rng *r, void *at, unsigned n, unsigned episode)
{
    RedlinesIn *in = at;
    unsigned bad = 0, steps = 0;

    (void)episode;
    for (unsigned i = 0; i < n; i++) {
        memset(&in[i], 0, sizeof in[i]);
        in[i].time = (i + 1) * 10;
        if (rng_below(r, 300) == 0) {
            bad = rng_below(r, SENSORS);
            steps = 5;
        }
        for (unsigned k = 0; k < SENSORS; k++)
            in[i].sensor[k] = (float)(20 + rng_noise(r, 15) + (rng_below(r, 200) == 0 ? 90 : 0) + (steps > 0 && k == bad ? 100 : 0));
        steps -= steps > 0;
        in[i].reset = rng_below(r, 10) == 0;
    }
}

const Workload workload_redlines = {
    WORKLOAD(redlines, Redlines), .steps = 4000, .warm = 100, .count = 3900, .check = 4000,
};
