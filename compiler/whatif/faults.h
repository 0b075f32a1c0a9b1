// SPDX-License-Identifier: Apache-2.0
// The faults of sensors: runs every script once for each fault of each input, beginning at each trigger, and compares the run with the one
// without a fault (docs/faults.md).
//
//     Faults *f = faults_new(arena, p, script, scripts, &options);
//     while (faults_run_next(f)) ;
//     ... f->result ...
//     faults_end(f);
#ifndef SMC_FAULTS_H
#define SMC_FAULTS_H

#include "compiler/script/baseline.h"
#include "compiler/whatif/fault_engine.h"

// The effect of a fault on a run, the least dangerous first.
typedef enum FaultOutcome {
#define OUTCOME(constant, name, words) FAULT_HAS_##constant,
#include "compiler/whatif/fault_outcomes.def"
#undef OUTCOME
    FAULT_OUTCOME_COUNT
} FaultOutcome;

extern const char *const fault_outcome_name[FAULT_OUTCOME_COUNT], *const fault_outcome_words[FAULT_OUTCOME_COUNT];

// Where faults begin: before a step of a script.
typedef struct FaultTrigger {
    uint32_t script;                  // index of the script
    uint64_t step, g;                 // number and G of the first step with the fault
    const State *from, *state;        // the state that the transition into `state` has left, NULL: no transition; the state that the step runs
    bool is_timed;                    // the caller has chosen this time (FaultOptions.at)
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
    FaultMoment violated_at;          // the step at which it was violated
    const ScriptAssert *failed;       // the first assert that failed; NULL: none
    FaultMoment failed_at;            // the step after which it failed
    const Var *differs;               // the first output that differs, or S for another state; NULL: none
    FaultMoment differs_at;
    uint64_t cell, healthy_cell;      // value of `differs` after that step, with the fault and without
    const State *end, *healthy_end;   // the states that a further step would run at the end, with the fault and without; in an application, of the
                                      // first machine that ends in @abort because of the fault, or else elsewhere
    uint64_t steps;                   // number of steps of the run
    uint64_t end_g;                   // G of the last step
    bool worse_than_alone;            // for two faults: the outcome is more dangerous than that of each fault alone at the same trigger
} FaultResult;

typedef struct FaultOptions {
    unsigned kinds;                   // set of the kinds to run: 1u << FaultKind for each
    const Var *const *input;          // the inputs that can fail, `inputs` of them; 0: all that the machine reads and that a script writes or that
                                      // are @read_only
    uint32_t inputs;
    bool pairs;                       // also runs every pair of faults
    bool runs_all;                    // also runs faults whose outcome follows from other runs: for tests
    uint64_t max_runs;
    FaultSizes sizes;                 // sizes.seed is only used if has_seed
    bool has_seed;                    // sizes.seed is used; otherwise each script's own seed
    const uint64_t *at;               // times at which faults begin, instead of at states and transitions; `times` of them
    uint32_t times;
    uint64_t max_steps;               // the most steps of a run without a fault
    const Requirements *requirements; // judged in each run; or NULL
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
    VEC(FaultResult) result;          // the results of all single faults, and of the pairs with worse_than_alone
    uint64_t faults, runs;            // number of faults that were judged; how many of these were run: the others concern inputs that nothing reads
    uint64_t pairs, pairs_worse;      // number of pairs that were judged; of these, with worse_than_alone
    uint64_t repeated;                // number of pairs that were found to do the same as one of their faults, without a run
    bool is_cut;                      // not all faults were judged, because max_runs was reached
    Baseline baseline;                // the runs without a fault
    FaultRunner *runner;
} Faults;

// Runs every script without a fault, and lists inputs and triggers.  Scripts that fail have none.
Faults *faults_new(Arena *arena, const Program *p, const Script *const *script, uint32_t scripts, const FaultOptions *o);
// Runs the next fault.  Returns false if no fault is left.
bool faults_run_next(Faults *f);
// Returns the most dangerous outcome of one fault of one input at any trigger, without pairs.
FaultOutcome faults_find_worst(const Faults *f, uint32_t input, FaultKind kind);
// Whether a kind applies to an input.
bool fault_applies(const FaultInput *in, FaultKind kind);
// Whether a machine of p writes the variable.
bool fault_is_written(const Program *p, const Var *v);
// Whether an element is an input by default, when these scripts run.
bool fault_is_input(const Var *v, const Script *const *script, uint32_t scripts);
// Frees working memory.
void faults_end(Faults *f);

// A value that a script or a faulty sensor wrote in a step, if the variable did not have that value already.
typedef struct FaultWrite { uint64_t step, g; const Var *var; uint64_t cell; } FaultWrite;
typedef VEC(FaultWrite) FaultWrites;
// Repeats the run of a result, and lists what was written to inputs and locals of the machine, without G.
void faults_record(Faults *f, const FaultResult *r, FaultWrites *out);

#endif
