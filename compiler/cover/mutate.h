// SPDX-License-Identifier: Apache-2.0
// Mutation: changes one number, operator, target or statement of a machine at a time, and finds the changes that no script notices
// (docs/testing.md).  A change is made in the checked program and undone after its runs, so nothing is parsed again.
//
//     Mutation *u = mutation_new(arena, p, 0, script, scripts, requirements, max_steps);
//     while (mutation_run_next(u)) ;
//
// Every change is also an edit of the source: `old` at `span` becomes `text`.
#ifndef SMC_MUTATE_H
#define SMC_MUTATE_H

#include "compiler/cover/flat.h"
#include "compiler/script/baseline.h"
#include "compiler/script/scenario.h"
#include "compiler/script/script.h"

typedef enum MutantVerdict {
    MUTANT_WAITING,           // the mutant has not been run yet
    MUTANT_NOTICED,           // a script fails, or its run violates a requirement
    MUTANT_UNNOTICED,         // every script passes as before
    MUTANT_EQUIVALENT,        // it is proved that the mutant behaves like the machine
    MUTANT_GENERATED,         // every script passes as before, but a search found a scenario in which the mutant differs from the machine
    MUTANT_VERDICT_COUNT
} MutantVerdict;

// What the changed code can affect, the least dangerous first: nothing of the others, a transition, an output, a hazard (mutant_hazards.c) or a
// transition to a state that switches one on, a transition to an @abort state.
typedef enum MutantDanger { DANGER_OTHER, DANGER_TRANSITION, DANGER_OUTPUT, DANGER_HAZARD, DANGER_ABORT } MutantDanger;

extern const char *const mutant_danger_name[];        // by MutantDanger: "other", "transition", "output", "hazard", "abort"
extern const char *const mutant_verdict_name[];       // by MutantVerdict: "waiting", "noticed", "unnoticed", "equivalent", "generated"

typedef struct MutantEdit MutantEdit;

typedef struct Mutant {
    Span span;                // the text that is changed
    const char *text;         // the text that replaces it
    MutantDanger danger;
    const State *state;       // the state that contains the change; NULL: several states, or none
    const MutantEdit *edit;   // a list: one edit for each copy in the program
    MutantVerdict verdict;
    uint32_t script;          // NOTICED: index of the script that fails
    const Requirement *violated;      // NOTICED: the requirement that its run violates; NULL: the script itself fails
    const Scenario *scenario; // GENERATED: the scenario in whose last step the mutant differs from the machine.  Variables that the machine
                              // stores are only set before the first step
    const Var *differs;       // GENERATED: the variable that differs; NULL: S
    bool if_only_inputs_change;       // EQUIVALENT: only as long as no code outside the machine writes what the machine stores
} Mutant;

typedef struct Mutation Mutation;

#define MUTATE_STEPS_MOST UINT64_C(1000000)   // default of max_steps
#define MUTATE_SEARCH_STEPS UINT64_C(2000000)  // default of the steps of a search for one mutant: about 0.8 s

// Lists the changes, and runs every script without a change.  rq: requirements that are judged after each step; or NULL.  While a mutant runs,
// expressions and statements of p are changed; the change is undone afterwards.  p: a machine, or an application, of which machine number `member` is
// changed.
Mutation *mutation_new(Arena *arena, const Program *p, size_t member, const Script *const *script, uint32_t scripts, const Requirements *rq, uint64_t max_steps);
// Returns the runs without a change: which scripts and requirements are left out.
const Baseline *mutation_baseline(const Mutation *u);
// Runs the next mutant.  Returns false if no mutant is left.
bool mutation_run_next(Mutation *u);
// Searches a scenario for the next mutant that no script notices, for at most `steps` steps (mutant_search.h).  Returns false
// if no such mutant is left.
bool mutation_search_next(Mutation *u, uint64_t steps);
// Returns the machine of a mutant, allocated in `arena`.
FlatMachine *mutation_build(Mutation *u, Arena *arena, const Mutant *m);
// Returns the mutants, in the order of the source.
const Mutant *mutation_list(const Mutation *u, uint32_t *n);
// Returns the mutants with this verdict, the most dangerous ones first, then in the order of the source; allocated in `arena`.
const Mutant **mutation_order(const Mutation *u, Arena *arena, MutantVerdict verdict, uint32_t *n);

typedef struct MutationScore {
    unsigned long all, of[MUTANT_VERDICT_COUNT];      // number of all mutants; by MutantVerdict, number of mutants with this verdict
    unsigned long noticeable; // mutants that a script can notice, as far as is known
    double percent;           // percentage of the noticeable mutants that are noticed; 100 if no mutant is noticeable
} MutationScore;

MutationScore mutation_score(const Mutation *u);
// Frees working memory.
void mutation_end(Mutation *u);

// ---- mutant_words.c ----

// Appends a change: "`>` changed to `>=` in Fill, an output".
void mutant_write_change(Arena *arena, const Mutant *m, Buf *out);
// Appends the scenario of a mutant: "from Fill, at G = 0: pressure = 776; at G = 40, valveOpen differs". `most`: how many inputs are shown, because
// a scenario from an edited script can have thousands.
void mutant_write_scenario(const Program *p, const Mutant *m, size_t most, Buf *out);
enum { MUTANT_INPUTS_SHOWN = 8 };         // for `most`, in lists that a person reads

#endif
