// SPDX-License-Identifier: Apache-2.0
// The launch sequencer.  In most episodes tanks fill while their valve opens, and a feed line cools.  In some the operator revokes the go, the
// stop button is pressed, or the chamber pressure is lost.
#include "tests/bench/workloads/seq40.h"

#include "seq40_o0.h"
#include "seq40_o1.h"
#include "seq40_o2.h"
#include "seq40_os.h"
#include "tests/bench/rows.h"

WORKLOAD_ROWS(seq40, Seq40)

// The inputs do not depend on the machine: pressures rise and fall over seconds, whatever the valves do.
static void inputs(Rng *r, void *at, unsigned n, unsigned episode)
{
    float lox = 10, fuel = 12;
    Seq40In *in = at;
    int go = 1, stop = 0;
    double cold = 20;

    for (unsigned i = 0; i < n; i++) {
        if (rng_below(r, go ? 400 : 60) == 0)
            go = !go;
        if (rng_below(r, stop ? 20 : 3000) == 0)
            stop = !stop;
        lox += (float)((33 - lox) * 0.002 + rng_noise(r, 0.3));
        fuel += (float)((31 - fuel) * 0.002 + rng_noise(r, 0.3));
        cold += (-130 - cold) * 0.004 + rng_noise(r, 2);
        in[i].time = (i + 1) * 10;
        in[i].lox = lox + (float)rng_noise(r, 0.2);
        in[i].fuel = fuel + (float)rng_noise(r, 0.2);
        in[i].chamber = (float)(episode % 4 == 3 && rng_below(r, 40) == 0 ? 2 : 25 + rng_noise(r, 4));
        in[i].chill = (int16_t)cold;
        in[i].bus = (uint16_t)(24000 + rng_below(r, 400));
        in[i].go = (uint8_t)go;
        in[i].stop = (uint8_t)stop;
    }
}

const Workload workload_seq40 = {
    WORKLOAD(seq40, Seq40), .steps = 6000, .warm = 100, .count = 5900, .check = 6000, .other = 3,
};
