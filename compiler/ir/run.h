// SPDX-License-Identifier: Apache-2.0
// Runs a machine from its IR, step by step, as language.md chapter 6 defines a step.  For analyses that try out what a machine
// does: a situation of the machine is one piece of memory that can be copied, so that a search can return to it.
//
//     IrRun *r = ir_run_of(arena, m);
//     void *s = arena_alloc(arena, r->size);
//     ir_run_start(r, s, 1);
//     ir_run_vars(r, s)[m->g] = 10;                     // inputs, by IR variable, as the numbers that the language reads
//     ir_run_step(r, s, NULL);
//
// Numbers are kept as F64 in every variable: of I64 and U64 beyond 2^53 that is what reading them gives.
#ifndef SMC_IR_RUN_H
#define SMC_IR_RUN_H

#include "compiler/ir/ir.h"

typedef struct IrRunFn IrRunFn;

typedef struct IrRun {
    const IrMachine *m;
    size_t size;                      // bytes of a situation
    size_t vars, writers, windows;    // byte offsets of its parts
    size_t *window_at;                // by window: offset of its words
    uint32_t *window_kind;            // by window: as sm_roll_kind
    uint64_t work;                    // instructions executed and window slots sampled so far: what callers bound
    IrRunFn *sample;
    IrRunFn *(*block)[BLOCK_COUNT];   // by state
    double *temp;                     // for the function that runs
} IrRun;

// The head of a situation; the rest is reached by the functions below.
typedef struct IrSituation {
    double last_g, start;             // of the last step that ran; when the state began
    uint32_t state;                   // number of the state that the next step runs
    bool first;                       // the next step is its first
    bool ran;                         // a step has run
} IrSituation;

// What one step did, in order.  Each statement of a machine is executed at most once in a step.
typedef struct IrTrace {
    uint32_t *at;                     // a store or transition: its Stmt.number << 1; a decided guard: the same, plus 1 where it was true
    uint32_t n;                       // entries; room for one per statement of the machine
    uint32_t transition;              // Stmt.number of the one made; 0: none
} IrTrace;

// The machine prepared for running; it lives in the arena.
IrRun *ir_run_of(Arena *arena, const IrMachine *m);
// Elements 0, locals at their initial values, windows empty, no step has run.
void ir_run_start(const IrRun *r, void *situation, uint32_t state);
// By IR variable: its value.
double *ir_run_vars(const IrRun *r, void *situation);
// By IR variable: the statement (Stmt.number) that stored it last; 0: none.
const uint32_t *ir_run_writers(const IrRun *r, const void *situation);
// What a variable of this type holds after x has been stored in it.
double ir_run_number(SmType type, double x);
// One step.  False, with nothing changed, if G forbids it (language.md 6.3).  `trace` may be NULL.
bool ir_run_step(IrRun *r, void *situation, IrTrace *trace);
// Gives every window n samples of what its expression samples now, with inputs as `inputs` sets them before each sample.
void ir_run_fill(IrRun *r, void *situation, uint32_t n, void (*inputs)(void *context, double *vars, uint32_t sample), void *context);

void ir_run_clear_windows(const IrRun *r, void *situation);
// Makes one window of a situation the same as in another.
void ir_run_copy_window(const IrRun *r, void *to, const void *from, uint32_t window);

#endif
