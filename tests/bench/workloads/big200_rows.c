// SPDX-License-Identifier: Apache-2.0
// 200 states.  Each input is independent of the ones before, so that a branch predictor cannot know the next state.
#include "tests/bench/workloads/big200.h"

#include "big200_o0.h"
#include "big200_o1.h"
#include "big200_o2.h"
#include "big200_os.h"
#include "tests/bench/rows.h"

WORKLOAD_ROWS(big200, Big200)

static void inputs(Rng *r, void *at, unsigned n, unsigned episode)
{
    Big200In *in = at;

    (void)episode;
    for (unsigned i = 0; i < n; i++) {
        in[i].time = i + 1;
        in[i].rate = rng_noise(r, 1);
        in[i].level = (uint16_t)rng_below(r, 100);
        in[i].ready = (uint8_t)rng_below(r, 2);
    }
}

const Workload workload_big200 = {
    WORKLOAD(big200, Big200), .steps = 4000, .warm = 400, .count = 3600, .check = 4000,
};
