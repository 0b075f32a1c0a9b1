// SPDX-License-Identifier: Apache-2.0
// The glider.  Rates and wind are noise that was filtered; the pad is near, and another one is chosen now and then.
#include "tests/bench/workloads/guide.h"

#include "guide_o0.h"
#include "guide_o1.h"
#include "guide_o2.h"
#include "guide_os.h"
#include "tests/bench/rows.h"

WORKLOAD_ROWS(guide, Guide)

static void inputs(Rng *r, void *at, unsigned n, unsigned episode)
{
    double p = 0, q = 0, yaw = 0, north = 0, east = 0, lat = 0, lon = 0;
    GuideIn *in = at;

    (void)episode;
    for (unsigned i = 0; i < n; i++) {
        p = p * 0.98 + rng_noise(r, 0.2);
        q = q * 0.98 + rng_noise(r, 0.1);
        yaw = yaw * 0.98 + rng_noise(r, 0.1);
        north = north * 0.999 + rng_noise(r, 0.3);
        east = east * 0.999 + rng_noise(r, 0.3);
        if (rng_below(r, 700) == 0) {
            lat = rng_noise(r, 1.2e-4);
            lon = rng_noise(r, 1.2e-4);
        }
        memset(&in[i], 0, sizeof in[i]);
        in[i].time = (i + 1) * 20;
        in[i].gyroP = (float)p;
        in[i].gyroQ = (float)q;
        in[i].gyroR = (float)(yaw + 0.15);
        in[i].airspeed = (float)(25 + rng_noise(r, 1));
        in[i].windNorth = (float)north;
        in[i].windEast = (float)east;
        in[i].padLat = (float)lat;
        in[i].padLon = (float)lon;
    }
}

const Workload workload_guide = {
    WORKLOAD(guide, Guide), .steps = 4000, .warm = 100, .count = 3900, .check = 4000,
};
