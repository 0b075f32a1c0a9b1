// SPDX-License-Identifier: Apache-2.0
// What the files of a campaign of faults share (faults.h): fault_inputs.c lists inputs and what reads them, fault_watch.c observes a run,
// faults.c runs, fault_replay.c finds pairs that need no run.
#ifndef SMC_FAULT_PART_H
#define SMC_FAULT_PART_H

#include "compiler/cover/cover.h"
#include "compiler/script/script_run.h"
#include "compiler/whatif/faults.h"

// A step in which an output changed in the run without a fault.
typedef struct Change {
    uint64_t step, cell;      // number of the step; the new value
    uint32_t output;          // index in FaultRunner.output
} Change;

// The run of a script without a fault.
typedef struct Healthy {
    VEC(Change) change;       // sorted by step; the first step has one for each output
    uint64_t *last;           // by State.number - 1: number of the last step that ran the state; 0: none
    uint64_t steps;           // number of steps
    const State **end;        // by machine: the state that a further step would run
} Healthy;

// A visit of a state: the numbers of its first and last step.
typedef struct Visit { uint64_t first, last; } Visit;

// The variables of the machine, by Var.index, that a script, the requirements or the comparison of outputs read after a step.
typedef struct FaultSeen {
    VEC(uint32_t) cell;       // variables that are read with the machine's own values
    VEC(uint32_t) outside;    // inputs that the machine assigns as well: they are read with their true values
} FaultSeen;

// The run of one fault from its trigger on, as fault_replay.c records it.  A slot is the number of a value that is read after each step.
typedef struct FaultSlot { uint32_t slot; uint64_t value; } FaultSlot;
typedef struct FaultStepEnd { uint32_t write, change; } FaultStepEnd;       // the lengths of FaultRecord.write and .change after a step
typedef struct FaultRecord {
    VEC(EngineWrite) write;   // what the script wrote
    VEC(FaultSlot) change;    // the values that changed in each step; in the first step all values
    VEC(FaultStepEnd) end;    // by step, from 0: where its writes and changes end
    bool is_cut;              // the record ends early, because VALUES_MOST was reached
} FaultRecord;

typedef struct FaultTape FaultTape;

// What is observed in a run.  It is allocated in FaultRunner.run, so that a copy of that arena contains it.
typedef struct FaultWatch {
    FaultRunner *x;
    ScriptRun *r;
    FaultEngine *e;
    FaultTape *tape;          // records the run (fault_replay.c)
    Healthy *healthy;         // the run of the same script without a fault
    bool is_healthy;          // the run has no fault, and is recorded instead of compared
    uint64_t *cell;           // by output: the value at this step in the run without a fault
    uint32_t next;            // index in healthy->change of the first change after this step
    Monitor *monitor;         // judges the true values
    bool judges_truth;        // a requirement reads a faulty input, so the true values can have another result than the readings
    void *situation;          // what `monitor` remembers of the steps so far (monitor.h)
    const State **last;       // by machine: the state that the previous step ran
    uint8_t *visited;         // by State.number - 1: 1 if the run was in the state since the fault began
    FaultMoment *aborted;     // by machine: the first step that ran in an @abort state; step 0: none
    FaultResult result;       // the result so far
} FaultWatch;

struct FaultRunner {
    Faults *f;
    Arena *arena;             // memory of the results
    Arena run, copy;          // memory of the current run; of its copy at the trigger
    Arena tapes;              // memory of the records of the current trigger
    uint64_t taped;           // number of writes and changes in these records
    FaultRecord *record;      // by index in `single`: its record; only if pairs of faults are run
    FaultSeen *seen;          // by script: what a script and the requirements read
    ArenaCopy saved;          // the copy of `run` at the trigger
    FlatMachine **flat;       // the machines that all runs share
    size_t machines;          // 1, or the number of machines of the application
    ScriptOptions o;          // the options of the current run
    const Var **output;       // the elements that the machine writes, and last S, of each machine
    uint32_t outputs;
    Healthy *healthy;         // by script: its run without a fault
    Visit *visit;             // by State.number - 1: the longest visit in the run of the current script without a fault
    VEC(Fault) single;        // all single faults that apply to their inputs
    uint8_t *is_required;      // by input: 1 if a requirement reads it
    uint8_t *is_judged;        // by input: 1 if a requirement, an assert or an @compare reads it
    uint8_t *reads;           // by State.number - 1 and input: 1 if the state's code reads the input
    uint8_t *alone;           // by index in `single`: the FaultOutcome at the current trigger
    uint8_t *visited;         // by index in `single` and State.number - 1: 1 if its run was in the state after the current trigger
    uint8_t *is_repeated;     // by index in `single`: 1 if an earlier fault of the same input reads the same constant at this trigger
    uint32_t at, i, k;        // the next run: index of its trigger; index in `single` of its fault, or for a pair of both faults
    bool in_pairs;            // the single faults of the trigger have been run
    bool is_prepared;         // the current run has stopped just before trigger `at`
    FaultWatch *w;                 // observes the current run
    FaultWrites *writes;      // the list that faults_record fills; NULL: no writes are listed
};

// ---- fault_inputs.c ----

// Lists the inputs, outputs, and what each state, assert and requirement reads.
void fault_find_inputs(FaultRunner *x);
// Lists the faults that apply.  The ranges of inputs must be known.
void fault_list_single(FaultRunner *x);
// Whether an assert, a requirement or one of the states with visited[State.number - 1] reads an input.  If not, a run that was only in these
// states is the same with every fault of the input.
bool fault_is_read(const FaultRunner *x, uint32_t input, const uint8_t *visited);

// ---- fault_replay.c ----

// Lists, for each script, what a run reads of the machine (FaultRunner.seen).  Inputs and outputs must be known.
void fault_find_seen(FaultRunner *x);
// Opens the engine that records the steps of the current run.  It wraps `inner`, the engine with the faulty sensors, and is allocated in x->run.
Engine *fault_tape_open(FaultRunner *x, Engine *inner, uint32_t script);
// Drops all records.
void fault_tape_reset(FaultRunner *x);
// Records the current run from its next step on, as the run of the fault with index `single`.
void fault_tape_begin(FaultRunner *x, uint32_t single);
// Whether a run with both faults has the outcome that `single`, one of the two, has alone.  False: not known.  The current run must be before the
// trigger; the call uses it up.
bool fault_pair_repeats(FaultRunner *x, uint32_t single, const Fault *both);

// ---- fault_watch.c ----

// The after_step callback of runs; context: the FaultWatch of the run.
void fault_watch_step(void *context, const ScriptStep *step);
// Observes the run of x->w from its start on.
void fault_begin_watching(FaultRunner *x, uint32_t script);
// Begins to judge the true values.  Until a fault begins, they are what the machine reads.
void fault_begin_judging_truth(FaultWatch *w, const Fault *fault, uint32_t n);

#endif
