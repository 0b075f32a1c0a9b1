// SPDX-License-Identifier: Apache-2.0
// Runs a machine from its IR, step by step, as language.md chapter 6 defines a step.  Used by analyses that search by running the machine.
// A situation is the complete state of a running machine (variables, rolling windows, state) in one block of memory.  A search copies
// situations so that it can return to them.
//
//     IrRun *r = ir_run_new(arena, m);
//     void *s = arena_alloc(arena, r->size);
//     ir_run_start(r, s, 1);
//     ir_run_vars(r, s)[m->g] = 10;                     // set inputs, by IR variable, as the F64 that a load produces
//     ir_run_step(r, s, NULL);
//
// Every variable is stored as F64.  For I64 and U64 beyond 2^53, that is the rounded number that a load produces.
#ifndef SMC_IR_RUN_H
#define SMC_IR_RUN_H

#include "compiler/ir/ir.h"

typedef struct IrRunFn IrRunFn;

typedef struct IrRun {
    const IrMachine *m;
    size_t size;                      // size of a situation in bytes
    size_t vars, writers, windows;    // byte offsets of the parts of a situation
    size_t *window_at;                // by window: byte offset of its data in a situation
    uint32_t *window_kind;            // by window: its sample type and set of statistics, from sm_roll_kind
    uint64_t work;                    // instructions and jumps executed so far; callers limit it
    IrRunFn *sample;
    IrRunFn *(*block)[BLOCK_COUNT];   // by state: its .entry, .step and .exit; NULL: missing
    double *initial;                  // by IR variable: the value of a local at the start.  Callers can change the values of parameters
    double *temp;                     // temporaries of the running function
    uint32_t refused;                 // Stmt.number of a conditional whose guard counts as false, whatever its value; 0: none
} IrRun;

// The first bytes of a situation.  Variables and windows follow, which the functions below access.
typedef struct IrSituation {
    double last_g, start;             // G of the last step that ran; G when the current state began
    uint32_t state;                   // number of the state that the next step runs
    bool first;                       // the next step is the first one in `state`
    bool ran;                         // some step has run
} IrSituation;

// The events of one step, in order.  Each statement of a machine is executed at most once in a step.
typedef struct IrTrace {
    uint32_t *at;                     // Stmt.number << 1 of a store, transition or evaluated guard; bit 0 is set if the guard was true
    uint32_t n;                       // number of entries; `at` has room for one per statement of the machine
    uint32_t transition;              // Stmt.number of the transition that was executed; 0: none
} IrTrace;

// Prepares a machine for running.  The result is allocated in the arena.
IrRun *ir_run_new(Arena *arena, const IrMachine *m);
// Initialises a situation: elements 0, locals at `initial`, windows empty, no step has run.
void ir_run_start(const IrRun *r, void *situation, uint32_t state);
// Returns the values of all variables, indexed by IR variable.
double *ir_run_vars(const IrRun *r, void *situation);
// Returns for each IR variable the Stmt.number of the last assignment to it; 0: none was executed.
const uint32_t *ir_run_writers(const IrRun *r, const void *situation);
// Runs one step.  Returns false and leaves the situation unchanged if G forbids the step (language.md 6.3).  `trace` may be NULL.
bool ir_run_step(IrRun *r, void *situation, IrTrace *trace);
// Samples every window n times, at times that are dt apart and end with the last step.  `inputs` may be NULL; it is called before each sample to
// set the inputs.
void ir_run_fill_windows(IrRun *r, void *situation, uint32_t n, double dt, void (*inputs)(void *context, double *vars, uint32_t sample),
                         void *context);

// Removes the samples of all windows.
void ir_run_clear_windows(const IrRun *r, void *situation);
// Copies one window from one situation to another.
void ir_run_copy_window(const IrRun *r, void *to, const void *from, uint32_t window);

#endif
