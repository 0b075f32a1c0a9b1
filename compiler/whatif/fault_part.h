// SPDX-License-Identifier: Apache-2.0
// What the files of a campaign of faults share (faults.h): fault_inputs.c lists inputs and what reads them, fault_watch.c observes a run,
// faults.c runs, fault_replay.c finds pairs that need no run.
#ifndef SMC_FAULT_PART_H
#define SMC_FAULT_PART_H

#include "compiler/cover/cover.h"
#include "compiler/script/script_run.h"
#include "compiler/whatif/faults.h"

// A change of an output in the run without a fault.
typedef struct Change {
    uint64_t step, cell;
    uint32_t output;
} Change;

// The run of a script without a fault.
typedef struct Healthy {
    VEC(Change) change;
    uint64_t *last;           // by State.number - 1: the last step that ran the state; 0: none
    uint64_t steps;
    const State *end;
} Healthy;

// A visit of a state, from its first step to its last one.
typedef struct Visit { uint64_t first, last; } Visit;

// The variables of the machine that a script, the requirements and the comparison of outputs read (Var.index).
typedef struct FaultSeen {
    VEC(uint32_t) cell;       // variables of the machine, by their values after the step
    VEC(uint32_t) outside;    // inputs that the machine itself assigns, by their true value
} FaultSeen;

// The run of one fault from its trigger on, as fault_replay.c records it.
typedef struct FaultSlot { uint32_t slot; uint64_t value; } FaultSlot;
typedef struct FaultStepEnd { uint32_t write, change; } FaultStepEnd;
typedef struct FaultRecord {
    VEC(EngineWrite) write;   // of the script
    VEC(FaultSlot) change;    // the values that scripts and requirements see, where they change; all of them in the first step
    VEC(FaultStepEnd) end;    // by step: the end of its writes and changes
    bool is_cut;              // the record ends early, because VALUES_MOST was reached
} FaultRecord;

typedef struct FaultTape FaultTape;

// What is observed in a run.  It is in the arena of the run, so that a copy of the run contains it.
typedef struct FaultWatch {
    FaultRunner *x;
    ScriptRun *r;
    FaultEngine *e;
    FaultTape *tape;
    Healthy *healthy;
    bool is_healthy;          // the run has no fault, and is recorded instead of compared
    uint64_t *cell;           // by output: the value without a fault
    uint32_t next;            // index into healthy->change
    Monitor *monitor;         // judges the true values
    bool judges_truth;        // a requirement reads a faulty input, so the true values can have another result than the readings
    void *situation;
    const State *last;        // the state that the step before ran
    uint8_t *visited;         // by State.number - 1: the run was in the state since the fault began
    FaultMoment aborted;      // the first step that ran in an @abort state; step 0: none
    FaultResult result;       // the result so far
} FaultWatch;

struct FaultRunner {
    Faults *f;
    Arena *arena;             // of the results
    Arena run, copy;          // of the current run; of its copy
    Arena tapes;              // of the records of the current trigger
    uint64_t taped;           // number of writes and changes in these records
    FaultRecord *record;      // by single fault; only with pairs
    FaultSeen *seen;          // by script
    ArenaCopy saved;
    FlatMachine *flat;
    ScriptOptions o;
    const Var **output;
    uint32_t outputs;         // the elements that the machine writes, and then S
    Healthy *healthy;         // by script
    Visit *visit;             // by State.number - 1: the longest one of the current script
    VEC(Fault) single;        // the faults that apply
    uint8_t *is_required;      // by input: a requirement reads it
    uint8_t *is_judged;        // by input: a requirement, an assert or an @compare reads it
    uint8_t *reads;           // by State.number - 1 and input: the state reads it
    uint8_t *alone;           // by single fault: its outcome at the current trigger
    uint8_t *visited;         // by single fault and State.number - 1: its run was in the state from the current trigger on
    uint8_t *is_repeated;     // by single fault: an earlier fault of the same input reads the same constant at this trigger
    uint32_t at, i, k;        // the next run: its trigger; its fault, or its two faults i and k
    bool in_pairs;            // the single faults of the trigger have been run
    bool is_prepared;         // the current run is before trigger `at`
    FaultWatch *w;                 // of the current run
    FaultWrites *writes;      // what faults_record collects; NULL: nothing
};

// ---- fault_inputs.c ----

// Lists the inputs, outputs, and what each state, assert and requirement reads.
void fault_find_inputs(FaultRunner *x);
// Lists the faults that apply.  The ranges of inputs must be known.
void fault_list_single(FaultRunner *x);
// Whether a state of a run reads an input, or an assert or a requirement does.  visited: by State.number - 1, of the run.  If nothing
// reads it, the run is the same with every fault of the input.
bool fault_is_read(const FaultRunner *x, uint32_t input, const uint8_t *visited);

// ---- fault_replay.c ----

// Lists, for each script, what a run reads of the machine (FaultRunner.seen).  Inputs and outputs must be known.
void fault_find_seen(FaultRunner *x);
// Opens the engine that records the steps of x->w, around the faulty sensors.  It is in x->run.
Engine *fault_tape_open(FaultRunner *x, Engine *inner, uint32_t script);
// Drops all records.
void fault_tape_reset(FaultRunner *x);
// Records the current run from its next step on, as that of a single fault.
void fault_tape_begin(FaultRunner *x, uint32_t single);
// Whether a run with both faults has the outcome that `single`, one of the two, has alone.  False: not known.  The current run must be before the
// trigger; the call uses it up.
bool fault_pair_repeats(FaultRunner *x, uint32_t single, const Fault *both);

// ---- fault_watch.c ----

// Is called after each step of a run, with its FaultWatch.
void fault_watch_step(void *context, const ScriptStep *step);
// Observes the run of x->w from its start on.
void fault_begin_watching(FaultRunner *x, uint32_t script);
// Begins to judge the true values.  Until a fault begins, they are what the machine reads.
void fault_begin_judging_truth(FaultWatch *w, const Fault *fault, uint32_t n);

#endif
