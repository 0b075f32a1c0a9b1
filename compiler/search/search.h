// SPDX-License-Identifier: Apache-2.0
// Finds inputs with which a machine reaches goals: coverage points (CoverPlace, cover.h), and goals of the caller, such as violating a requirement.
//
//     SearchResult *r = search_run(arena, c, &(SearchOptions){.seed = 1});
//     r->find[place]                            // place: index into c->place.  How the search for this coverage point ended
//     r->chosen[i]                              // scenarios that together reach everything that was reached
//
// Every scenario of a result has been replayed from its start on a flat machine, and reached the goals that are listed for it.  The result depends
// only on the machine, on which coverage points the Cover has as covered, and on the options: it is the same on every computer.  It depends on
// `memory` only if the search uses all of it.
//
// A parameter has its current value, Var.init.  The caller's Cover does not change.
#ifndef SMC_SEARCH_H
#define SMC_SEARCH_H

#include "compiler/cover/cover.h"
#include "compiler/script/scenario.h"

#define SEARCH_EFFORT UINT64_C(150000000)     // default of `effort`, in steps: about 10 s on a processor of 2020
#define SEARCH_MEMORY ((size_t)512 << 20)     // default of `memory`, in bytes
#define SEARCH_DELTA_T 10                     // default of `delta_t` for a machine that does not declare its step
// The kinds of coverage points that are goals by default.
#define SEARCH_KINDS (1u << COVER_TRANSITION | 1u << COVER_STATEMENT | 1u << COVER_GUARD | 1u << COVER_CONDITION | 1u << COVER_WINDOW | 1u << COVER_STATE)

#define SEARCH_UNKNOWN 1e300                  // in place of a distance: it is not known

// ---- goals of the caller ----

// Goals of the caller, whose function `step` judges them after each step, from the variables and from the *situation*.  This is the goals' memory,
// such as whether some earlier step had a condition.  The search saves and restores the situation together with the machine's state.
typedef struct SearchWatch {
    void *self;               // the caller's data, passed to both functions
    uint32_t goals;
    size_t size;              // bytes of a situation; it contains no pointers, so that memcpy copies it
    void (*start)(void *self, void *situation);   // initialises a situation: no step has run
    // Judges the step after which the variables have these cells, by Var.index (stdlib/convert.h).  Sets distance[i] for each goal: 0 if this
    // step reaches it, else how far it is from that, above 0; SEARCH_UNKNOWN: it knows nothing.
    void (*step)(void *self, void *situation, const uint64_t *cell, double *distance);
} SearchWatch;

// A value that is worth trying: a sensor had it in a script, or a requirement compares with it.
typedef struct SearchHint { uint32_t var; double value; } SearchHint;

// ---- options ----

// A machine among the others of an application (search_app.h): each step of its search is a tick of all machines.
typedef struct SearchPlace {
    const struct FlatApp *app;
    uint64_t every;           // the machine steps once in so many ticks
    const bool *foreign;      // by Var.index: another machine writes the element
    struct SearchOther *other;        // by machine; `others` of them
    uint32_t others;
    bool no_facts;            // the machine does not step at equal distances of G, so facts about its runs alone are not used
} SearchPlace;

typedef struct SearchProgress {
    uint32_t goals, reached, left;    // left: neither reached nor proved impossible
    uint64_t steps, effort;           // steps that have run; the most that can run
} SearchProgress;

// Whether short runs try infinities and values beyond ranges, and change several inputs in each step.  IN_RANGES: they do, but the values
// of inputs with a range stay within it.
typedef enum SearchSpecials { SEARCH_NO_SPECIALS, SEARCH_SPECIALS, SEARCH_SPECIALS_IN_RANGES } SearchSpecials;

// 0 in a field selects its default.
typedef struct SearchOptions {
    uint64_t seed;            // of the search's random numbers
    uint64_t effort;          // the most steps that the search can run, those of replays and simplifying included
    size_t memory;            // bytes of snapshots, and of what is known about them; without room, the least useful ones are evicted
    uint64_t delta_t;         // used if the machine declares no step
    const uint64_t *initial;  // by Var.index: the cells of parameters before the first step; NULL: their defaults
    const State *init_state;  // where every scenario starts; NULL: the first state
    const bool *writable;     // by Var.index: scenarios can set the variable; NULL: see search_default_inputs
    unsigned kinds;           // 1u << CoverKind of each kind whose places are goals; 0: SEARCH_KINDS
    const SearchPlace *place; // the machine runs in an application; NULL: alone
    bool no_places;           // only the goals of `watch` are searched for, no coverage points
    bool any_elements;        // proofs allow any value before the first step for elements that the machine stores; else they are 0, as in the runs
    bool loops;               // scenarios can have loops
    bool plain;               // for goals that few changes reach: no attempt repeats changes, and inputs with noise can become constant
    bool stays;               // an attempt that must wait in a state also changes the inputs that would end the wait
    bool drafts;              // scenarios are stored as they were found, with all their changes, and no effort is set aside for simplifying them
    SearchSpecials specials;
    const SearchWatch *watch; // NULL: no goals of the caller
    const SearchHint *hint;   // `hints` of them
    uint32_t hints;
    const Scenario *given;    // `givens` runs that the search makes first, to go on from the states along them.  Those with another start or delta_t
                              // are not used
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
    uint32_t scenario;        // REACHED: index into SearchResult.chosen of the first scenario that reaches the goal
    const char *reason;       // IMPOSSIBLE: why, as CoverPlace.impossible
    double nearest;           // NOT_FOUND: the smallest distance of all runs; SEARCH_UNKNOWN: no run made a decision that
                              // leads to the goal
    uint32_t blocked_by;      // NOT_FOUND: the coverage point of the condition or guard that did not have the value that the goal needs, in the
                              // run that came nearest to the goal, or to a state from which it can be reached; 0: a goal of the caller
    bool is_never;            // NOT_FOUND: that condition never had the needed value in any run; false: it had, but not together with what else
                              // the goal needs
    double missed_by;         // NOT_FOUND: the difference of the numbers that this condition compares, in that run; SEARCH_UNKNOWN: it
                              // compares no numbers
    bool is_state_reached;    // NOT_FOUND: some run was in a state in which the goal can be reached
} SearchFind;

typedef struct SearchScenario {
    Scenario scenario;
    const uint32_t *goal;     // indices into SearchResult.find, ascending: the goals that this scenario reaches and no earlier one of `chosen` does
    uint32_t goals;
    const State *end;         // the state in which the machine is after the scenario's last step
} SearchScenario;

typedef struct SearchResult {
    SearchFind *find;         // by coverage point; goal i of the watch is find[places + i]
    uint32_t places;          // CoverPlaces.n
    uint32_t finds;           // length of `find`: `places`, and the number of goals of the watch
    const SearchScenario *chosen;     // together they reach every goal with SEARCH_REACHED
    uint32_t chosens;
    uint64_t delta_t;         // time from step to step in all scenarios
    uint32_t refuted;         // number of goals that a scenario reaches although a proof says they are impossible: not 0 only if the prover is wrong
    uint64_t steps;           // steps that the search has run
    bool stopped;             // go_on returned false
    bool memory_reached;      // `memory` was too small for all snapshots: some were evicted
} SearchResult;

// Searches.  All memory is the arena's: snapshots are freed before it returns.
SearchResult *search_run(Arena *arena, const Cover *c, const SearchOptions *o);

#endif
