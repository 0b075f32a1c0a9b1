// SPDX-License-Identifier: Apache-2.0
// The tank.  The pressure varies around the vent threshold, so that a branch predictor cannot learn the pattern.  At the end of an episode the
// pressure is lost and the machine aborts.  An episode is too short for the machine to go idle.
#include "tests/bench/workloads/tank.h"

#include "tank_o0.h"
#include "tank_o1.h"
#include "tank_o2.h"
#include "tank_os.h"
#include "tests/bench/rows.h"

WORKLOAD_ROWS(tank, Tank)

static void inputs(Rng *r, void *at, unsigned n, unsigned episode)
{
    TankIn *in = at;
    double off = 0;                   // psi above the threshold

    (void)episode;
    for (unsigned i = 0; i < n; i++) {
        off = off * 0.98 + rng_noise(r, 3);
        in[i].time = i + 1;
        in[i].tankPressure = i + 2 < n ? 775 + (off < -49 ? -49 : off > 49 ? 49 : off) : 400;
    }
}

const Workload workload_tank = {
    WORKLOAD(tank, Tank), .sm = "examples/tank/tank.sm", .steps = 4000, .warm = 400, .count = 3600, .check = 4000,
};
