// SPDX-License-Identifier: Apache-2.0
// The faults of sensors: runs every script once for each fault of each input, beginning at each trigger, and compares the run with the one
// without a fault (docs/faults.md).
//
//     Faults *f = faults_new(arena, p, script, scripts, &options);
//     if (faults_find_failing(f) == scripts)
//         while (faults_run_next(f)) ;
//     ... f->result ...
//     faults_end(f);
#ifndef SMC_FAULTS_H
#define SMC_FAULTS_H

#include "compiler/script/script.h"
#include "compiler/whatif/fault_engine.h"

// What a fault has done, the least dangerous first.
typedef enum FaultOutcome {
#define OUTCOME(constant, name, words) FAULT_HAS_##constant,
#include "compiler/whatif/fault_outcomes.def"
#undef OUTCOME
    FAULT_OUTCOME_COUNT
} FaultOutcome;

extern const char *const fault_outcome_name[FAULT_OUTCOME_COUNT], *const fault_outcome_words[FAULT_OUTCOME_COUNT];

// Where faults begin: before a step of a script.
typedef struct FaultTrigger {
    uint32_t script;
    uint64_t step, g;
    const State *from, *state;        // from: the state that a transition to `state` has left, NULL: no transition; state: the one that the step runs
    bool is_timed;                    // a time that the caller has chosen
} FaultTrigger;

// A step at which something happened.
typedef struct FaultMoment { uint64_t step, g; } FaultMoment;

typedef struct FaultResult {
    uint32_t trigger;                 // index in Faults.trigger
    Fault fault[FAULTS_MOST];
    uint32_t faults;
    FaultOutcome outcome;             // the most dangerous of the outcomes below
    uint32_t violated;                // 1 + index of the requirement that was violated first; 0: none
    bool violated_in_truth;           // the requirement is met for the readings, but violated for the true values
    FaultMoment violated_at;
    const ScriptAssert *failed;       // the first assert that failed; NULL: none
    FaultMoment failed_at;
    const Var *differs;               // the first output that differs, or S for another state; NULL: none
    FaultMoment differs_at;
    uint64_t cell, healthy_cell;      // of `differs`, after that step
    const State *end, *healthy_end;   // the states that a step after the last one would run
    uint64_t steps;
    uint64_t end_g;                   // G of the last step
    bool worse_than_alone;            // of two faults: more dangerous than each of the two alone, at the same trigger
} FaultResult;

typedef struct FaultOptions {
    unsigned kinds;                   // 1u << FaultKind
    const Var *const *input;          // the inputs that can fail, `inputs` of them; 0: all that the machine reads and that a script writes or that
                                      // are @read_only
    uint32_t inputs;
    bool pairs;
    bool runs_all;                    // also runs faults whose outcome follows from other runs: for tests
    uint64_t max_runs;
    FaultSizes sizes;                 // the seed counts only if has_seed
    bool has_seed;                    // otherwise the seed is that of each script
    const uint64_t *at;               // times at which faults begin, instead of at states and transitions; `times` of them
    uint32_t times;
    uint64_t max_steps;               // of a run without a fault
    const Requirements *requirements; // or NULL
    const ScriptSetting *setting;     // parameters with other values, as in ScriptOptions
    size_t settings;
} FaultOptions;

typedef struct FaultRunner FaultRunner;

typedef struct Faults {
    const Program *p;
    const Script *const *script;
    uint32_t scripts;
    FaultOptions options;
    VEC(FaultInput) input;
    VEC(FaultTrigger) trigger;
    VEC(FaultResult) result;          // of single faults: all; of pairs: those that are worse than alone
    uint64_t faults, runs;            // number of faults that were judged; how many of these were run: the others concern inputs that nothing reads
    uint64_t pairs, pairs_worse;      // of two faults: how many were judged; how many are worse than alone
    uint64_t repeated;                // number of pairs that were found to do the same as one of their faults, without a run
    bool is_cut;                      // max_runs was reached
    uint32_t failing;                 // a script that fails without a fault; `scripts`: none
    FaultRunner *runner;
} Faults;

// Runs every script without a fault, and lists inputs and triggers.
Faults *faults_new(Arena *arena, const Program *p, const Script *const *script, uint32_t scripts, const FaultOptions *o);
// Returns a script that fails without a fault; `scripts` if all pass.
uint32_t faults_find_failing(const Faults *f);
// Runs the next fault.  Returns false if no fault is left.
bool faults_run_next(Faults *f);
// Returns the most dangerous outcome of a fault of one input; of single faults only.
FaultOutcome faults_find_worst(const Faults *f, uint32_t input, FaultKind kind);
// Whether a kind applies to an input.
bool fault_applies(const FaultInput *in, FaultKind kind);
// Whether an element is an input by default, when these scripts run.
bool fault_is_input(const Var *v, const Script *const *script, uint32_t scripts);
// Frees working memory.
void faults_end(Faults *f);

// What a run of a script has written to the machine in a step that the machine did not have already.
typedef struct FaultWrite { uint64_t step, g; const Var *var; uint64_t cell; } FaultWrite;
typedef VEC(FaultWrite) FaultWrites;
// Runs a result once more, and lists what the machine was given: inputs and locals, without G.
void faults_record(Faults *f, const FaultResult *r, FaultWrites *out);

#endif
