// SPDX-License-Identifier: Apache-2.0
// The parts of the bench of steps: workloads, and rows, each a method to run one.  steps.c measures; each file
// workloads/NAME_rows.c defines a workload.
#ifndef BENCH_H
#define BENCH_H

#include <stddef.h>
#include <stdint.h>

// ---- rows ----

// One method to run a machine, as C functions.  A drive copies n inputs, one after another, to the front of the state
// vector and steps after each; the row `empty` is the cost of that alone.
typedef struct Row {
    const char *name;
    size_t size;                                                // bytes of the machine
    void (*init)(void *machine, void *sv);
    void (*drive)(void *machine, void *sv, const void *in, size_t n);
    int exact;                                                  // its outputs are those of the reference to the last bit
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

static inline double rng_unit(Rng *r) { return (double)(rng_next(r) >> 11) / 9007199254740992.0; }          // 0 … 1
static inline double rng_noise(Rng *r, double width) { return (rng_unit(r) * 2 - 1) * width; }
static inline uint32_t rng_below(Rng *r, uint32_t n) { return (uint32_t)(rng_next(r) >> 33) % n; }

// ---- workloads ----

typedef struct Workload {
    const char *name;
    const char *sm;                     // the machine; its state vector is workloads/NAME.sv
    size_t in_size, sv_size;            // bytes: of an input, of the state vector
    unsigned steps, warm;               // an episode: the number of steps from init on, of which the first `warm` are not measured
    unsigned episodes;                  // the number of different episodes
    unsigned count, check;              // steps after the warm ones when instructions are counted; steps that are checked
    unsigned other;                     // an episode with another sequence of states than the first, which is checked too; or 0
    void (*inputs)(Rng *r, void *in, unsigned n, unsigned episode);
    const Row *row;                     // empty, native, f64, C at -O0 to -O2
    void (*drive_vm)(void *machine, void *sv, const void *in, size_t n);     // machine: an SmVm
    void (*drive_fast)(void *machine, void *sv, const void *in, size_t n);   // machine: an SmvmDecoded
    void (*drive_ref)(void *machine, void *sv, const void *in, size_t n);    // machine: a Reference
} Workload;

enum { ROWS = 6 };                      // of Workload.row

extern const Workload workload_tank, workload_mission, workload_arith, workload_bigwindow;

void bench_nothing(void *machine, void *sv);                    // the step of the row `empty`
void bench_reference_step(void *reference, void *sv);

#endif
