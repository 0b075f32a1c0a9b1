// SPDX-License-Identifier: Apache-2.0
// The types of the benchmark of steps: workloads, and rows, each of which is one method to run a workload.  steps.c measures.  Each file
// workloads/NAME_rows.c defines a workload.
#ifndef BENCH_H
#define BENCH_H

#include <stddef.h>
#include <stdint.h>

// ---- rows ----

// One method to run a machine, as C functions.  `drive` copies n inputs, one after another, to the start of the state vector, and steps after
// each.  The row `empty` measures the cost of this without a step.
typedef struct Row {
    const char *name;
    size_t size;                                                // size of `machine` in bytes
    void (*init)(void *machine, void *sv);
    void (*drive)(void *machine, void *sv, const void *in, size_t n);
    int exact;                                                  // its F32 and F64 outputs must equal those of the reference bit for bit
} Row;

// ---- random numbers, the same everywhere ----

typedef struct Rng { uint64_t x; } Rng;

static inline uint64_t rng_next(Rng *r)
{
    r->x ^= r->x << 13;
    r->x ^= r->x >> 7;
    r->x ^= r->x << 17;
    return r->x;
}

static inline double rng_unit(Rng *r) { return (double)(rng_next(r) >> 11) / 9007199254740992.0; }          // at least 0, less than 1
static inline double rng_noise(Rng *r, double width) { return (rng_unit(r) * 2 - 1) * width; }
static inline uint32_t rng_below(Rng *r, uint32_t n) { return (uint32_t)(rng_next(r) >> 33) % n; }

// ---- workloads ----

typedef struct Workload {
    const char *name;
    const char *sm;                     // path of the machine; NULL: workloads/NAME.sm.  The state vector is workloads/NAME.sv
    size_t in_size, sv_size;            // bytes of one input; bytes of the state vector
    unsigned steps, warm;               // steps of an episode, from init on; how many of them, at its start, are not measured
    unsigned count, check;              // steps after these when instructions are counted; steps that are checked
    unsigned other;                     // another episode to check, with other states than the first; 0: none
    void (*inputs)(Rng *r, void *in, unsigned n, unsigned episode);
    const Row *row;                     // the rows in C
    void (*drive_in_place)(void *machine, void *sv, const void *in, size_t n);   // machine: an SmVm
    void (*drive_decoded)(void *machine, void *sv, const void *in, size_t n);    // machine: an SmvmDecoded
    void (*drive_ref)(void *machine, void *sv, const void *in, size_t n);        // machine: a Reference
} Workload;

enum {
    ROWS = 7,                           // rows in Workload.row: empty, native, f64, C at -O0 to -O2, C at -O2 by cc -Os
    EPISODES = 8,                       // different episodes of each workload
    MOST_STEPS = 6500,                  // most steps of an episode
};

// Each workload is in this list, and in WORKLOADS of tests.mk.
#define EACH_WORKLOAD(X) X(tank) X(mission) X(arith) X(bigwindow) X(seq40) X(big200) X(intcount) X(f32filter) X(vote) X(decide) X(ledger) X(redlines) \
    X(kalman) X(guide) X(persist)
#define DECLARE_WORKLOAD(w) extern const Workload workload_##w;
EACH_WORKLOAD(DECLARE_WORKLOAD)

void bench_nothing(void *machine, void *sv);                    // the step of the row `empty`
void bench_reference_step(void *reference, void *sv);

#endif
