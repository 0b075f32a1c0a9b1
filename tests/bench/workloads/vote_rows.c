// SPDX-License-Identifier: Apache-2.0
// The vote.  Sensors have noise.  At times one of the pressures drifts away, or does not change for a while.
#include "tests/bench/workloads/vote.h"

#include "tests/bench/rows.h"
#include "vote_o0.h"
#include "vote_o1.h"
#include "vote_o2.h"
#include "vote_os.h"

WORKLOAD_ROWS(vote, Vote)

enum { RESTING = 50 };                     // steps

static void inputs(Rng *r, void *at, unsigned n, unsigned episode)
{
    double pressure = 40, altitude = 500, away = 0;
    unsigned bad = 0, stuck = 0;
    VoteIn *in = at;

    (void)episode;
    for (unsigned i = 0; i < n; i++) {
        const double noise = i < RESTING ? 0 : 1;
        float p[3];

        pressure += (40 - pressure) * 0.01 + rng_noise(r, 0.3);
        altitude += rng_noise(r, 2);
        if (rng_below(r, 400) == 0) {
            bad = rng_below(r, 3);
            away = rng_below(r, 2) != 0 ? rng_noise(r, 8) : 0;
        }
        if (rng_below(r, 600) == 0)
            stuck = 40;
        for (unsigned k = 0; k < 3; k++)
            p[k] = (float)(pressure + noise * (rng_noise(r, 0.5) + (k == bad ? away : 0)));
        memset(&in[i], 0, sizeof in[i]);
        in[i].time = (i + 1) * 10;
        in[i].p1 = stuck > 0 && i > 0 ? in[i - 1].p1 : p[0];
        in[i].p2 = p[1];
        in[i].p3 = p[2];
        in[i].a1 = (float)(altitude + rng_noise(r, 2));
        in[i].a2 = (float)(altitude + rng_noise(r, rng_below(r, 100) == 0 ? 15 : 2));
        in[i].t1 = (int16_t)(200 + noise * rng_noise(r, 20));
        in[i].t2 = (int16_t)(200 + noise * rng_noise(r, 40));
        in[i].reset = rng_below(r, 30) == 0;
        stuck -= stuck > 0;
    }
}

const Workload workload_vote = {
    WORKLOAD(vote, Vote), .steps = 4000, .warm = 100, .count = 3900, .check = 4000,
};
