// SPDX-License-Identifier: Apache-2.0
// The sixteen channels, handwritten.
#ifndef BENCH_LEDGER_H
#define BENCH_LEDGER_H

#include <stdbool.h>
#include <stdint.h>

#include "ledger_o2.h"
#include "tests/bench/workloads/frame.h"

enum { CHANNELS = 16 };

typedef struct LedgerIn {
    uint64_t time;
    int32_t in[CHANNELS];
    uint8_t clear;
} LedgerIn;

typedef struct LedgerNative {
    uint32_t state;
    bool first;
    uint64_t start;
    int64_t position[CHANNELS], peak[CHANNELS];
    uint64_t distance[CHANNELS], next[CHANNELS];
    int32_t last[CHANNELS];
} LedgerNative;

void ledger_native_init(LedgerNative *m, LedgerSv *sv);
void ledger_native_step(LedgerNative *m, LedgerSv *sv);

typedef struct LedgerF64 {
    Frame frame;
    int64_t p[CHANNELS], k[CHANNELS];
    uint64_t d[CHANNELS], n[CHANNELS];
    int32_t l[CHANNELS];
} LedgerF64;

void ledger_f64_init(LedgerF64 *m, LedgerSv *sv);
void ledger_f64_step(LedgerF64 *m, LedgerSv *sv);

#endif
