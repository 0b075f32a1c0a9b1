// SPDX-License-Identifier: Apache-2.0
// The sixteen channels.  Readings drift; times are in nanoseconds.
#include "tests/bench/workloads/ledger.h"

#include "ledger_o0.h"
#include "ledger_o1.h"
#include "ledger_o2.h"
#include "ledger_os.h"
#include "tests/bench/rows.h"

WORKLOAD_ROWS(ledger, Ledger)

static void inputs(Rng *r, void *at, unsigned n, unsigned episode)
{
    LedgerIn *in = at;
    double mean[CHANNELS] = {0};

    (void)episode;
    for (unsigned i = 0; i < n; i++) {
        memset(&in[i], 0, sizeof in[i]);
        in[i].time = (i + 1) * UINT64_C(10000);
        for (unsigned k = 0; k < CHANNELS; k++) {
            mean[k] += rng_noise(r, 1000);
            in[i].in[k] = (int32_t)(mean[k] + rng_noise(r, 30000));
        }
        in[i].clear = rng_below(r, 700) == 0;
    }
}

const Workload workload_ledger = {
    WORKLOAD(ledger, Ledger), .steps = 4000, .warm = 100, .count = 3900, .check = 4000,
};
