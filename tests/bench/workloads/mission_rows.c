// SPDX-License-Identifier: Apache-2.0
// The mission: flights of 130 s, each with its own thrust and noise.  In every eighth flight the motor does not ignite.
#include "tests/bench/workloads/mission.h"

#include "mission_o0.h"
#include "mission_o1.h"
#include "mission_o2.h"
#include "mission_os.h"
#include "tests/bench/rows.h"

WORKLOAD_ROWS(mission, Mission)

enum { STEP = 20, ARM_AT = 2000, LAUNCH_AT = 6000, LIT_AT = 6300, BURN = 3000 };       // ms

typedef struct Flight { double height, speed, thrust, pad; int ignites, drogue, chute; } Flight;    // m, m/s, m/s2, m

// One step of the rocket; returns the acceleration at the sensor, m/s2.
static double fly(Flight *f, unsigned t)
{
    const int burns = f->ignites && t > LIT_AT && t < LIT_AT + BURN;
    const double felt = burns ? f->thrust : f->height > 0 ? -0.0004 * f->speed * (f->speed < 0 ? -f->speed : f->speed) - 0.1 : 9.8;

    if (f->speed < 0 && f->height > 0)
        f->drogue = 1;
    if (f->drogue && f->height < 300)
        f->chute = 1;
    f->speed += (felt - 9.8) * STEP / 1000.0;
    if (f->drogue && f->speed < (f->chute ? -7 : -27))
        f->speed = f->chute ? -7 : -27;
    f->height += f->speed * STEP / 1000.0;
    if (f->height <= 0) {
        f->height = 0;
        f->speed = 0;
    }
    return felt;
}

static void inputs(Rng *r, void *at, unsigned n, unsigned episode)
{
    Flight f = {0, 0, 60 + rng_noise(r, 10), 400 + rng_noise(r, 300), episode % 8 != 5, 0, 0};
    MissionIn *in = at;

    for (unsigned i = 0; i < n; i++) {
        const unsigned t = (i + 1) * STEP;
        const double felt = fly(&f, t);
        in[i].time = t;
        in[i].altitude = f.pad + f.height + rng_noise(r, 0.4);
        in[i].acceleration = (float)(felt + rng_noise(r, 0.8));
        in[i].battery = (uint16_t)(t < 200 ? 10900 : 12600 - t / 100 + rng_below(r, 20));
        in[i].armSwitch = t >= ARM_AT && (f.ignites || t < 60000);
        in[i].launchButton = t >= LAUNCH_AT && t < LAUNCH_AT + 200;
    }
}

const Workload workload_mission = {
    WORKLOAD(mission, Mission), .steps = 6500, .warm = 40, .count = 6460, .check = 6500, .other = 5,
};
