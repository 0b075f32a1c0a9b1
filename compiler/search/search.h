// SPDX-License-Identifier: Apache-2.0
// Finds inputs with which a machine reaches goals: places of its coverage (cover.h), and goals of the caller, such as violating a requirement.
//
//     SearchResult *r = search_run(arena, c, &(SearchOptions){.seed = 1});
//     r->find[place]                            // by CoverPlace: how its search ended
//     r->chosen[i]                              // scenarios that together reach everything that was reached
//
// Every scenario of a result has been replayed from its start on a flat machine, and reached what is stored for it.  The result depends only on
// the machine, the counts of the Cover and the options: it is the same on every computer.  It depends on `memory` only if that is reached.
//
// A parameter has its current value, Var.init.  The caller's Cover does not change.
#ifndef SMC_SEARCH_H
#define SMC_SEARCH_H

#include "compiler/cover/cover.h"
#include "compiler/script/scenario.h"

#define SEARCH_EFFORT UINT64_C(150000000)     // default of `effort`: about 10 s on a processor of 2020
#define SEARCH_MEMORY ((size_t)512 << 20)     // default of `memory`
#define SEARCH_DELTA_T 10                     // default of `delta_t` of a machine without a step
// The kinds of places that are goals by default.
#define SEARCH_KINDS (1u << COVER_TRANSITION | 1u << COVER_STATEMENT | 1u << COVER_GUARD | 1u << COVER_CONDITION | 1u << COVER_WINDOW | 1u << COVER_STATE)

#define SEARCH_UNKNOWN 1e300                  // a distance of which nothing is known

// ---- goals of the caller ----

// Goals that are judged after each step, from the variables and a situation of their own, which the search copies with the machine's state.
typedef struct SearchWatch {
    void *self;               // passed to the functions
    uint32_t goals;
    size_t size;              // bytes of a situation; it contains no pointers, so that memcpy copies it
    void (*start)(void *self, void *situation);   // initialises a situation: no step has run
    // Judges the step after which the variables have these cells, by Var.index (stdlib/convert.h).  Sets distance[i] for each goal: 0 if this
    // step reaches it, else how far it is from that, above 0; SEARCH_UNKNOWN: it knows nothing.
    void (*step)(void *self, void *situation, const uint64_t *cell, double *distance);
    const Expr *const *condition;     // conditions whose variables and constants matter for the goals
    uint32_t conditions;
} SearchWatch;

// A value that is worth trying: a sensor had it in a script, or a requirement compares with it.
typedef struct SearchHint { uint32_t var; double value; } SearchHint;

// ---- options ----

typedef struct SearchProgress {
    uint32_t goals, reached, left;    // left: neither reached nor proved impossible
    uint64_t steps, effort;           // steps that have run, and how many can run
} SearchProgress;

// Whether short runs try infinities and values beyond ranges, and change several inputs in each step.
typedef enum SearchSpecials { SEARCH_NO_SPECIALS, SEARCH_SPECIALS, SEARCH_SPECIALS_IN_RANGES } SearchSpecials;

// Every field can be 0.
typedef struct SearchOptions {
    uint64_t seed;            // of its random numbers
    uint64_t effort;          // how many steps it can run, those of replays and simplifying included; it never runs more
    size_t memory;            // bytes of snapshots, and of what is known about them; without room, the least useful ones are evicted
    uint64_t delta_t;         // used if the machine declares no step
    const State *init_state;  // where every scenario starts; NULL: the first state
    const bool *writable;     // by Var.index: a scenario may set it; NULL: see search_default_inputs
    unsigned kinds;           // 1u << CoverKind of each kind whose places are goals; 0: SEARCH_KINDS
    bool no_places;           // only goals of the watch are goals
    bool any_elements;        // proofs allow any value before the first step for elements that the machine stores; else they are 0, as in the runs
    bool loops;               // scenarios can have loops
    bool plain;               // for one goal with few changes: no attempt repeats changes, and inputs with noise may become constant
    SearchSpecials specials;
    const SearchWatch *watch; // NULL: no goals of the caller
    const SearchHint *hint;
    uint32_t hints;
    const Scenario *given;    // starting points: the states along them are known from the start.  Those with another start or delta_t are not used
    uint32_t givens;
    // Called about every 100,000 steps.  Returns false to stop: the result then has what was found until then.
    bool (*go_on)(void *context, const SearchProgress *p);
    void *context;
} SearchOptions;

// Sets writable[Var.index] for the inputs that a scenario sets by default: elements other than G and S that the machine reads, but never
// stores, and locals that scripts write.
void search_default_inputs(const Program *p, bool *writable);

// ---- results ----

typedef enum SearchOutcome {
    SEARCH_NO_GOAL,           // covered before the search, or of a kind that was not wanted
    SEARCH_REACHED,
    SEARCH_IMPOSSIBLE,
    SEARCH_NOT_FOUND
} SearchOutcome;

typedef struct SearchFind {
    SearchOutcome outcome;
    uint32_t scenario;        // REACHED: index into SearchResult.chosen of the first one that reaches it
    const char *reason;       // IMPOSSIBLE: why, as CoverPlace.impossible
    double nearest;           // NOT_FOUND: the smallest distance that was seen, SEARCH_UNKNOWN: no run came to what
                              // decides it
    uint32_t blocked_by;      // NOT_FOUND: the place of the condition or guard that did not have the value that the goal needs, in the run
                              // that came nearest to it, or to a state from which it can be reached; 0: a goal of the caller
    bool is_never;            // NOT_FOUND: it never had that value; else it had it, but not together with what else the goal needs
    double missed_by;         // NOT_FOUND: the difference of the numbers that it compares, in that run; SEARCH_UNKNOWN: none
    bool is_state_reached;    // NOT_FOUND: some run was in its state
} SearchFind;

typedef struct SearchScenario {
    Scenario scenario;
    const uint32_t *goal;     // the goals that it is chosen for, in ascending order: those that no earlier one reaches
    uint32_t goals;
    const State *end;         // the state that the step after its last one would run
} SearchScenario;

typedef struct SearchResult {
    SearchFind *find;         // by place; goal i of the watch is find[places + i]
    uint32_t places;          // CoverPlaces.n
    uint32_t finds;           // places, and the goals of the watch
    const SearchScenario *chosen;     // together they reach every goal with SEARCH_REACHED
    uint32_t chosens;
    uint64_t delta_t;         // that of the scenarios
    uint32_t refuted;         // goals that were proved impossible and that a scenario reaches, each by a wrong proof: 0
    uint64_t steps;           // how many have run
    bool stopped;             // go_on returned false
    bool memory_reached;      // `memory` was too small for all snapshots: some were evicted
} SearchResult;

// Searches.  All memory is the arena's: snapshots are freed before it returns.
SearchResult *search_run(Arena *arena, const Cover *c, const SearchOptions *o);

#endif
