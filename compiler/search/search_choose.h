// SPDX-License-Identifier: Apache-2.0
// Choosing and simplifying scenarios, after the search.  Only files of this folder include it.
//
//     search_choose.c    which scenarios together reach what was reached
//     search_simplify.c  fewer changes
//     search_ways.c      shorter beginnings, no detours
//     search_follow.c    inputs that follow outputs or alternate, in place of several changes
//     search_gather.c    fewer times at which inputs change
//     search_round.c     shorter times, rounder values
//     search_rounds.c    loops in place of changes that are made again and again
//     search_replay.c    runs a scenario
//     search_marks.c     snapshots along a scenario, from which replays begin
#ifndef SMC_SEARCH_CHOOSE_H
#define SMC_SEARCH_CHOOSE_H

#include "compiler/search/search_run.h"

typedef VEC(uint32_t) GoalSet;        // goals, as indices into SearchRun.goal

typedef struct SearchEnter { uint32_t state; uint64_t step; } SearchEnter;    // a state that is entered after a step; step 0: the start

// When a change is made, relative to a transition instead of as a fixed step: `wait` steps after the transition that Chooser.enters[enter] was in
// the recorded run.  So the changes of later states move with it when an earlier state takes more or fewer steps.
typedef struct SearchAnchor { uint32_t enter; uint64_t wait; } SearchAnchor;

enum { MOST_MARKS = 64, FAILED_ATTEMPTS = 1 << 12 };

// A snapshot along the scenario that is simplified: after `step` steps.
typedef struct SearchMark {
    uint64_t step;
    uint32_t enters;          // how many transitions have been recorded until then
    char *block;              // as Chooser.block
    uint8_t *reached;         // by wanted goal: it is reached until then
} SearchMark;

// What is known about the scenario that is simplified, from its last replay.
typedef struct SearchMarks {
    SearchMark of[MOST_MARKS], fresh[MOST_MARKS];     // by step: those of the known scenario; those that the current replay adds
    uint32_t n, freshes, most;
    uint32_t shared;          // the first snapshots that the current replay shares with the known scenario
    uint64_t spacing;         // between snapshots that the current replay adds
    VEC(ScenarioChange) change;       // of the known scenario, without loops
    VEC(SearchEnter) enter;   // its transitions
    uint64_t *patience;       // by State.number - 1: an attempt that has waited in the state for so many steps fails
    uint64_t failed[FAILED_ATTEMPTS]; // hashes of attempts that have failed with the wanted goals, each at its value modulo the size
    bool is_known;
} SearchMarks;

typedef struct Chooser {
    SearchRun *k;             // the search whose runs are chosen from
    FlatMachine *f;           // the machine that the current replay runs
    Arena flats;              // memory of `wanted`
    Arena tries;              // memory of the current attempt to simplify
    Arena unrolled;           // memory of the current replay: the scenario without loops
    FlatMachine *wanted;      // a machine with the probes of only the goals for which a scenario is simplified
    char *block;              // the state of the machine in the current replay, then the situation of the caller's goals (SearchWatch)
    const ScenarioChange **current;   // by input: its last change in the current replay; NULL: none yet
    bool *covered;            // by goal: a chosen scenario reaches it
    bool *seen;               // by goal of the caller: reached in the current replay
    VEC(SearchScenario) chosen;
    uint32_t *input_of;       // by Var.index of an input: index into SearchRun.input
    VEC(SearchEnter) enters;  // the states that the last replay has entered
    Scenario *way;            // by State.number - 1: of all beginnings of chosen scenarios that enter the state, the one with the fewest changes;
                              // init_state NULL: none
    uint32_t end;             // number (State.number) of the state after the scenario that is simplified
    SearchMarks *marks;       // snapshots along the scenario that is simplified
    uint64_t limit;           // simplifying the current scenario ends when this many steps have run
} Chooser;

// Whether the last replay has reached a goal.
bool chooser_has_reached(const Chooser *c, uint32_t goal);
void chooser_set_reached(Chooser *c, uint32_t goal);   // records that the current replay has reached the goal
uint32_t chooser_end_state(const Chooser *c);         // State.number of the state in which the last replay has ended
bool chooser_has_effort(const Chooser *c);            // whether simplifying the current scenario can run more steps
// Runs a scenario from its start on machine `f`, which has probes of the wanted goals.  Returns the step after which the scenario has reached all of
// `want`; 0: it does not, or the effort has ended.  An empty `want` runs to the end.  With anchors it moves each change to `wait` steps after its
// transition.
uint64_t chooser_replay(Chooser *c, FlatMachine *f, Scenario *s, const GoalSet *want, const SearchAnchor *anchor);

// Snapshots along the scenario that is simplified, in search_marks.c.
void chooser_begin_marks(Chooser *c);
void chooser_forget_marks(Chooser *c);                // before another scenario, or other wanted goals
// Prepares a replay: restores the last snapshot before the first difference to the known scenario.  Returns how many steps it has run, and sets
// *next to the index of the change that is next; 0: the replay has to begin at the start.
uint64_t chooser_resume(Chooser *c, const Scenario *s, const GoalSet *want, size_t *next);
void chooser_mark(Chooser *c, uint64_t step, const GoalSet *want);    // offers a snapshot after step `step` of the current replay
void chooser_keep_marks(Chooser *c, const Scenario *s);       // the last replay was one of `s`, which is the known scenario from now on

// Simplifies a scenario that reaches all of `want`.  Returns false if no effort is left for it: then the scenario is unchanged.
bool chooser_simplify(Chooser *c, Scenario *s, const GoalSet *want);
// A variant of the current scenario, which is replayed to see whether it still reaches the goals.  Its memory is reused by the next attempt.
typedef struct Attempt {
    Scenario s;
    ScenarioChange *change;   // s.change
    ScenarioLoop *loop;       // s.loop
    SearchAnchor *anchor;     // by change: relative to the transitions in `enters`, as recorded for the current scenario
} Attempt;

// Returns a copy of the current scenario, with room for more changes and one more loop.
Attempt chooser_begin_attempt(Chooser *c, const Scenario *s, size_t more);
void chooser_store_attempt(Chooser *c, Scenario *s, const Attempt *t);
// Replaces *s by the attempt if that still reaches everything.
bool chooser_accept(Chooser *c, Scenario *s, Attempt *t, const GoalSet *want, const SearchAnchor *anchor);

// The scenario that is simplified, and the transitions of its last replay.
typedef struct Reducer {
    Chooser *c;
    Scenario *s;
    const GoalSet *want;
    SearchEnter *enter;       // the transitions of a replay of *s
    uint32_t enters;
    size_t known;             // the scenario's first changes, which are those of a known way
} Reducer;

// Adds to an attempt when its changes are due after the entries of `enter`, which a replay of the same changes has recorded.
void chooser_add_anchors(Chooser *c, Attempt *t, const SearchEnter *enter, uint32_t enters);
// Replays *s, and stores its transitions.  Returns false if it does not reach the goals, or the effort has ended.
bool chooser_begin_reducer(Reducer *r);
void chooser_store_enters(Reducer *r);        // stores the transitions of the last replay, which was one of *s
// Edits an attempt so that it has fewer changes; i, n: numbers with a meaning of the edit's own.  Returns false if the edit does not apply to this
// scenario.
typedef bool SearchEdit(Attempt *t, size_t i, size_t n);
// Tries an edit with anchored changes, and with changes at their times if that is another run.  A loop has its own times, so with one no change
// is anchored.
bool chooser_try_edit(Reducer *r, SearchEdit *edit, size_t i, size_t n);

// Replaces the beginning of a scenario, up to where it enters a state, by the simplest known way to that state.
bool chooser_simplify_beginning(Reducer *r);
// Leaves out what the scenario does between two entries of the same state, if that still reaches the goals.
bool chooser_leave_out_detours(Reducer *r);
// Replaces changes of an input by one: it follows an output, or alternates.
bool chooser_follow_outputs(Reducer *r);

// Replaces equal rounds of changes by loops; every step has the same inputs as before.  Returns whether there is a new loop.
bool chooser_join_equal(Chooser *c, Scenario *s);
// Replaces changes that a scenario makes again and again by loops: tries shorter ones.  Returns whether there is a new one.
bool chooser_add_loops(Chooser *c, Scenario *s, const GoalSet *want);
// Begins loops sooner, in place of changes before them.  Returns whether that saves any.
// Or lets them make more rounds, in place of changes after them.
bool chooser_extend_loops(Chooser *c, Scenario *s, const GoalSet *want);
// Changes the periods of loops to round times, such as 100 ms, where the scenario still reaches all of `want`.
void chooser_round_periods(Chooser *c, Scenario *s, const GoalSet *want);

// Shorten the times between changes; replace what changes in each step by values that hold; round values.
void chooser_shorten_waits(Chooser *c, Scenario *s, const GoalSet *want);
void chooser_prefer_holds(Chooser *c, Scenario *s, const GoalSet *want);
void chooser_round_values(Chooser *c, Scenario *s, const GoalSet *want);

// Makes changes at the times of earlier ones where the scenario still reaches all of `want`, so that inputs change at fewer times.
void chooser_gather(Chooser *c, Scenario *s, const GoalSet *want);

// Stores in `way` the beginnings of `s`, as its last replay has shown, that enter a state with fewer changes than known so far.
void chooser_keep_ways(Chooser *c, const Scenario *s);
// Returns the scenario that leads from the start to a node.
Scenario chooser_scenario_of(SearchRun *k, Arena *arena, uint32_t node);

#endif
