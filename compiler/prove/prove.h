// SPDX-License-Identifier: Apache-2.0
// Decides for each requirement of a machine (requirements.md 13) whether a run can violate it.
//
//     ProveResult *r = prove_run(arena, requirements, &(ProveOptions){.delta_t = 10});
//     r->of[i].verdict                          // the verdict on requirement i of `requirements`
//
// The verdict is one of these:
//
//     proved      no run violates it.  The result has what is true after each step, and the assumptions that the proof rests on.
//     vacuous     no run can violate it, because its premise never occurs in a run.  The premise of `always a implies b`, `a leads to b` and
//                 `never a before b` is a step in which a is true; that of `never a after b without c` is such a step after one with b.
//     violated    the result has a scenario that violates it, confirmed by the reference interpreter.
//     undecided   neither a proof nor a violation was found.
//     interrupted ProveOptions.go_on has stopped the attempts before all were made.
//
// How a proof works.  A step of the machine, and the judgement of the requirement after it, become one function of variables (prove_model.h).
// The exploration (prove_explore.h) computes facts about these variables, mostly intervals.  Separate facts are computed for each state, for
// each state of the requirement's monitor, and for each value of variables that have only a few values.
// The exploration begins with all values with which the machine can start.  It ends when each step leads to values that the facts already
// cover.  This is an induction over steps, and the facts are the invariant of that induction.  The facts (facts/facts.h) are computed with the
// language's own arithmetic, with infinities, NaN and saturation.
//
// Facts about single variables are too weak where a requirement compares two variables.  If the short attempts fail, one more computes facts
// about the differences of the compared variables, too (prove_relate.h), before the long attempts.
//
// Only what can influence the requirement is part of the proof.  The first attempts also leave out windows that the requirement does not read;
// their statistics then can have any value.  The first attempt leaves out all of these windows, the next only those of more than two samples.
// Later attempts know what is true of all samples of a window (prove_threshold.c).
//
// What a proof covers:
//
//   - Elements that the machine does not assign have any value in each step, and parameters have any value in their ranges.
//   - G grows by exactly delta_t from step to step.  With another delta_t, the verdict can differ.
//   - The machine starts in init_state, with locals at their initial values.
//   - Only the machine writes its locals and S.
//
// Where such a proof fails, assumptions are added (ProveAssumption).  The result names the assumptions that the proof needs.  Searches for
// violations only find runs in which all assumptions are true.
//
// Everything depends only on the arguments, not on the time that the computer needs: limits are numbers of steps and of visits.
#ifndef SMC_PROVE_H
#define SMC_PROVE_H

#include "compiler/facts/fact.h"
#include "compiler/script/scenario.h"
#include "compiler/sema/requirements.h"

typedef enum ProveVerdict { PROVE_PROVED, PROVE_VACUOUS, PROVE_VIOLATED, PROVE_UNDECIDED, PROVE_INTERRUPTED,
                            PROVE_ALONE,      // violated by a machine of an application that runs alone (prove_app.h)
                            PROVE_VERDICTS } ProveVerdict;

typedef enum ProveAssumption {
    PROVE_OWN_OUTPUTS,        // only the machine writes the elements that it assigns
    PROVE_ZERO_START,         // in the first step G is 0, and the elements that the machine assigns are 0, as in a script (language.md 8.12)
    PROVE_PARAMETERS,         // the parameters have the values with which the machine was compiled
    PROVE_RANGES,             // elements with @range have values in it; only if the caller asks for it
    PROVE_ASSUMPTIONS
} ProveAssumption;

typedef struct ProveBound { const Var *var; Fact fact; } ProveBound;         // `fact` is true of the variable after each step

// What is true after each step in a state.
typedef struct ProveInvariant {
    const State *state;
    bool reached;             // a step can run in the state
    VEC(ProveBound) bound;    // locals, T and elements that the machine assigns, if more is known of them than their types say
} ProveInvariant;

typedef enum ProveObstacle {
    PROVE_FACTS_TOO_WEAK,     // the facts allow a violation that no run was found to have
    PROVE_TOO_LARGE           // the exploration reached its limits
} ProveObstacle;

// The run of a script: a starting point of searches for violations (prove_given.h).
typedef struct ProveGiven {
    const char *name;         // name of the script
    Scenario run;             // the run up to `ended_by`, with only what a search can set: elements that the machine does not assign
    uint64_t ran;             // steps that the whole script runs
    const Var *ended_by;      // the variable that the script sets next and no search can set: G, S, or one that the machine assigns;
                              // NULL: `run` is the whole script
} ProveGiven;

// A violation that differs from a given run in few inputs (prove_near.h).
typedef struct ProveNear {
    const ProveGiven *given;
    const Var *var[2];        // the `vars` inputs that have other values than in the given run
    double value[2];          // by index in `var`: the other value
    uint32_t vars;
    uint64_t from, to;        // the first and the last step in which they have these values
    uint64_t step;            // the step that violates the requirement
} ProveNear;

// Something with too many values for a proof: a variable of the machine, the samples of a window, or, if both are NULL, the time since a `leads to`
// is open.
typedef struct ProveWide { const Var *var; const Window *window; } ProveWide;

enum { PROVE_WIDES = 4 };     // the length of ProveOf.wide, `ranged` and `unranged`

typedef struct ProveOf {
    const Requirement *what;  // the requirement that is judged
    ProveVerdict verdict;
    unsigned assumed;         // PROVED, VACUOUS: 1u << ProveAssumption of each that the proof needs
    const ProveInvariant *invariant;  // PROVED, VACUOUS: by state from 0
    const Scenario *scenario; // VIOLATED: a run that violates it in its last step
    const ProveGiven *given;  // VIOLATED: a given run that violates it, too; or NULL
    uint64_t given_step;      // the step in which `given` violates it
    const ProveNear *near;    // VIOLATED: a given run violates it with other values of few inputs; or NULL
    bool premise_seen;        // some run that was tried could have violated the requirement; always true if VIOLATED
    ProveObstacle obstacle;   // UNDECIDED: why the last proof failed
    ProveWide wide[PROVE_WIDES];      // UNDECIDED: `wides` variables or windows, not all of whose values the last exploration could distinguish
    uint32_t wides;
    const Var *ranged[PROVE_WIDES];   // UNDECIDED: `rangeds` elements with @range on which it depends, if values beyond the range were possible
    uint32_t rangeds;
    const Var *unranged[PROVE_WIDES]; // UNDECIDED: `unrangeds` inputs that are numbers without @range, and on which it depends
    uint32_t unrangeds;
    bool *tried;              // by state from 0: some run was in the state
    bool *excluded;           // by state from 0: an exploration has shown that no run reaches the state without violating the requirement before
    uint32_t irrelevant;      // number of variables that cannot influence the requirement
    bool is_loose;            // PROVED, VACUOUS: the model let windows have any value (ProveLoosening)
    bool is_compared;         // PROVED, VACUOUS: the model knew which samples are above constants of the requirement
    bool is_related;          // PROVED, VACUOUS: the model knew bounds of the differences of variables
    uint32_t nodes;           // number of abstract states of the last exploration (prove_explore.h)
    uint64_t steps;           // steps of all runs that searched for a violation
    uint64_t visits;          // paths from block to block that all explorations visited
} ProveOf;

typedef struct ProveResult {
    ProveOf *of;              // by requirement
    uint32_t n;
    const ProveGiven *given;  // the `givens` runs of ProveOptions.given
    uint32_t givens;
    uint64_t delta_t;
    const State *init_state;
    uint64_t steps;           // steps of all runs that searched for violations
    uint64_t effort;          // steps that the searches for a requirement can run: as in the options, or the default
    bool can_prove_longer;    // with more effort, long proofs examine more paths, too
    const char *bug;          // a sentence: a found violation that the reference interpreter does not confirm; or NULL
} ProveResult;

typedef struct ProveOptions {
    uint64_t delta_t;         // used if the machine declares no step; 0: that of the first given run, or 10
    const State *init_state;  // NULL: the first state
    bool assume_ranges;       // proofs can use PROVE_RANGES, and searches keep inputs within their ranges
    bool any_parameters;      // no proof uses PROVE_PARAMETERS, and searches also set parameters to the ends of their ranges
    const ProveGiven *given;  // `givens` runs of scripts; those that begin in another state than init_state, or have another step, are not used
    uint32_t givens;
    uint64_t effort;          // how many steps the search for violations can run, fewer if its windows are long (prove_goal.h).  A small
                              // one also limits the proofs that need long.  0: a default
    size_t memory;            // bytes of an exploration, and of the snapshots of a search; 0: SEARCH_MEMORY.  It affects results only if used up
    uint64_t visits;          // how many paths from block to block an exploration can visit; 0: a default
    void (*progress)(void *context, uint32_t done, uint32_t now);     // `done` are decided, and attempts at number `now` begin; or NULL
    void (*decided)(void *context, const ProveResult *r, uint32_t i);         // called once for each requirement: r->of[i] is complete; or NULL
    bool (*go_on)(void *context);     // called now and then; returns false to stop: what is not decided then is interrupted.  NULL: never stops
    void *context;
} ProveOptions;

// Finds two requirements that contradict each other: no values of the variables meet both.  Compares only requirements that are judged in the same
// steps: in every step, or in those with the same premise (a of `a implies b`).  Returns false if no two contradict each other.
bool prove_find_contradiction(Arena *arena, const Requirements *r, const Requirement **first, const Requirement **second);

ProveResult *prove_run(Arena *arena, const Requirements *r, const ProveOptions *o);

#endif
