// SPDX-License-Identifier: Apache-2.0
// The pressure stand.  Pressures wander with noise, stick for a while, jump, and leak; steps of 9 to 11 ms with a gap now and then.
#include "tests/bench/workloads/persist.h"

#include "persist_o0.h"
#include "persist_o1.h"
#include "persist_o2.h"
#include "persist_os.h"
#include "tests/bench/rows.h"

WORKLOAD_ROWS(persist, Persist)

static void pressures(Rng *r, double *p, unsigned *stuck, float *out)
{
    for (unsigned k = 0; k < PRESSURES; k++) {
        p[k] += (26 - p[k]) * 0.01 + rng_noise(r, 1) + (rng_below(r, 400) == 0 ? 16 : 0);
        if (rng_below(r, 200) == 0)
            stuck[k] = 12;
        if (stuck[k] == 0)
            out[k] = (float)(p[k] + rng_noise(r, 0.5));
        stuck[k] -= stuck[k] > 0;
    }
}

static bool toggled(Rng *r, bool x, unsigned on, unsigned off) { return rng_below(r, x ? off : on) == 0 ? !x : x; }

static void inputs(Rng *r, void *at, unsigned n, unsigned episode)
{
    double p[PRESSURES] = {26, 26, 26, 26}, heat = 20;
    unsigned stuck[PRESSURES] = {0};
    float shown[PRESSURES] = {0};
    bool armed = true, key = false, link = true, current = false;
    uint64_t time = 0;
    PersistIn *in = at;

    (void)episode;
    for (unsigned i = 0; i < n; i++) {
        time += 9 + rng_below(r, 3) + (rng_below(r, 200) == 0 ? 30 : 0);
        pressures(r, p, stuck, shown);
        heat = heat * 0.999 + rng_noise(r, 0.3);
        armed = toggled(r, armed, 10, 60);
        key = toggled(r, key, 6, 4);
        link = toggled(r, link, 12, 80);
        current = toggled(r, current, 12, 6);
        memset(&in[i], 0, sizeof in[i]);
        in[i].time = time;
        memcpy(in[i].p, shown, sizeof shown);
        in[i].heat = (float)heat;
        in[i].current = (int16_t)((current ? 150 : 50) + rng_noise(r, 40));
        in[i].armed = armed;
        in[i].key = key;
        in[i].link = link;
    }
}

const Workload workload_persist = {
    WORKLOAD(persist, Persist), .steps = 4000, .warm = 100, .count = 3900, .check = 4000,
};
