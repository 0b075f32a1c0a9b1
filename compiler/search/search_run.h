// SPDX-License-Identifier: Apache-2.0
// The parts of a running search.  Only files of this folder include it.
//
//     search_machine.c   what is constant: inputs, decisions, stores, and the path to each place
//     search_goals.c     goals, and how far a step was from each
//     search_prove.c     goals that are impossible
//     search_nodes.c     states that have been reached, and runs from them
//     search_wish.h      which inputs lead to a goal: backwards from its conditions, or at random, in three files
//     search_repeat.c    pulses of inputs, and ways around through several states, again and again
//     search_special.c   short runs with infinities, ends of ranges, and changes in each step
//     search_choose.h    few scenarios with few changes that reach what was reached, in three files
//     search_missing.c   what blocked the goals that were not found
//     search.c           the loop
//
// Letters: k the search, f a flat machine, n a node, g a goal.
#ifndef SMC_SEARCH_RUN_H
#define SMC_SEARCH_RUN_H

#include "compiler/search/search.h"

enum { SEARCH_POOL = 4, SEARCH_ENTRIES = 32 };        // snapshots for each goal, and for each state
#define SEARCH_NONE UINT32_MAX

// ---- the machine ----

typedef struct SearchInput {
    uint32_t var, at;         // in Program.var, in IrMachine.var
    SmType type;
    bool forced;              // the machine writes it too, so it is set before every step
    const Range *range;       // or NULL
    VEC(double) constant;     // numbers that it is compared with
} SearchInput;

// A decision that has to have an outcome.
typedef struct SearchElem {
    uint32_t decision;
    bool value;
    bool is_certain;          // without this value the statement is not executed; otherwise some runs need it, and others do not
} SearchElem;

// What has to happen before a statement is executed, the innermost first; the last element is decided first in a step.
typedef struct SearchPath { const SearchElem *elem; uint32_t n; } SearchPath;

typedef struct SearchDecision {
    const FlatDecision *d;
    uint32_t fn;              // index into FlatMachine.fn
    uint32_t state;           // number of its state; 0: what a window samples
    SearchPath path;          // of its statement
    uint32_t *operand;        // places in the frame of everything that its distance depends on
    double *last;             // their values when the distance was last computed
    uint32_t operands;
    bool is_known;            // `last` has been set
    VEC(struct SearchEdge) edge;
    uint64_t *inputs;         // the set of inputs that it depends on
} SearchDecision;

// A store to a variable.
typedef struct SearchStore { uint32_t fn, state, stmt; IrRef ref, value; } SearchStore;

typedef struct SearchVar {
    uint32_t input;           // index of the input; SEARCH_NONE
    VEC(SearchStore) store;
    uint64_t *inputs;         // the set of inputs that its value depends on
} SearchVar;

typedef struct SearchFn {
    const IrFn *fn;
    uint32_t state;           // 0: the sampling
    bool is_step;             // of .step: it runs in each step of its state
    uint8_t *handle;          // by IrRef: what the value depends on
} SearchFn;

enum { HANDLE_INPUT = 1, HANDLE_VAR = 2, HANDLE_TIME = 4, HANDLE_WINDOW = 8 };

// A transition of the machine.
typedef struct SearchExit { uint32_t stmt, from, to; SearchPath path; } SearchExit;

// ---- goals ----

// Where a goal can be reached.  With a condition, that condition of the path's first decision has to decide with `value`.
typedef struct SearchSite { uint32_t state; SearchPath path; uint32_t condition; bool value; } SearchSite;

typedef struct SearchEdge { uint32_t goal, level, condition; bool value; } SearchEdge;

typedef struct SearchNear { uint32_t node; double distance; } SearchNear;

typedef struct SearchGoal {
    uint32_t place;           // index into SearchResult.find
    VEC(SearchSite) site;
    bool done;
    SearchNear pool[SEARCH_POOL];
    uint32_t pooled;
    double best;              // in all runs
    SearchElem best_elem;     // the element that decided it
    uint32_t best_condition;  // which of its conditions has to decide with this value; SEARCH_NONE: the decision has to have it
    uint64_t cost;            // steps spent on it
    uint32_t found;           // the node after the step that reached it
    double run_best;          // in the current segment
    uint64_t run_step;
    bool touched;
    uint32_t fill;            // WINDOW: its samples; steps that have to run before
} SearchGoal;

// ---- nodes ----

// How an input is set.
typedef struct SearchSetting {
    bool set;
    ScenarioKind kind;
    double a, b;
    uint32_t source;          // COPY: index into Program.var
    uint64_t since;           // the step of the change
} SearchSetting;

typedef struct SearchTurn { uint32_t input; SearchSetting setting; } SearchTurn;

// A state that has been reached: by `turn` at the parent and steps up to `at`.
typedef struct SearchNode {
    uint32_t parent;
    uint32_t users;           // pools that contain it; without any, it has no copy
    uint32_t followers;       // nodes whose parent it is, and goals that it has reached; without any, and without users, it is freed
    uint64_t at;              // steps from the start
    SearchTurn *turn;         // its own
    uint32_t turns;
    uint32_t depth;           // changes from the start; those of equal rounds count once
    char *copy;               // or NULL
    uint32_t state;
    uint64_t key;             // of what it has stored
} SearchNode;

typedef struct SearchRun {
    Arena *arena, work;       // of the result; of the search
    Arena flats;              // of the current `flat`
    Arena legs;               // of the current rounds
    const Cover *c;
    const Program *p;
    const IrMachine *m;
    const SearchOptions *o;
    SearchResult *r;
    uint64_t effort, random, delta_t;
    uint64_t reserve;         // steps of the replays of what was found: they are part of the effort
    uint64_t stop_at;         // the search ends after so many steps
    const State *start;
    FlatMachine *plain;       // without probes
    FlatMachine *flat;        // with the probes of open goals, and watched decisions
    FlatMachine *quiet;       // with the probes of open goals only
    FlatMachine *running;     // the one of the current segment
    uint64_t progress;        // steps that had run when a snapshot of a goal was last stored
    FlatMachine *judge;       // with all probes
    uint32_t *kept;           // by decision of `flat`: index into `decision`
    uint32_t done_since;      // goals reached since `flat` was built
    // the machine
    SearchInput *input;
    uint32_t inputs, words;   // words: of a set of inputs
    SearchVar *var;           // by IR variable
    SearchFn *fn;             // as FlatMachine.fn
    SearchDecision *decision; // as FlatProbes.decision
    uint32_t decisions;
    SearchPath *path;         // by Stmt.number
    uint32_t *guard;          // by Stmt.number of an IF: its decision; SEARCH_NONE
    VEC(SearchExit) exit;
    VEC(double) constant;     // all numbers of the machine
    VEC(uint32_t) output;     // variables that the machine writes, as indices into Program.var
    uint32_t longest;         // samples of the longest window
    // goals
    SearchGoal *goal;
    uint32_t goals, open;
    uint32_t *goal_of;        // by place: its goal; SEARCH_NONE
    uint32_t *counter;        // by place (CoverPlace): the counter of `running` that counts how often it was executed
    bool *is_open;            // by counter
    VEC(uint32_t) touched;    // goals that came nearer in the current segment
    double *cost[2];          // by node of a decision: how far it is from being false, true
    // nodes
    VEC(SearchNode) node;
    uint32_t root;            // the start; it always has a copy
    SearchNear *entry;        // by State.number - 1, SEARCH_ENTRIES each
    uint32_t *entries;
    bool *visited;            // by State.number - 1
    size_t block, settings;   // bytes of a snapshot; offset of its settings
    size_t nominal;           // bytes that are counted for a snapshot: the same on every computer
    size_t used, memory;
    VEC(char *) free;         // copies
    SearchTurn **free_turn;   // by number of turns: a list of arrays
    uint32_t free_node;       // a list, by SearchNode.parent; SEARCH_NONE
    VEC(uint32_t) active;     // inputs that are set before each step of the current run
    char *now, *scratch;      // the current run; another one
    uint64_t at;              // steps that the current run has run
    uint64_t *cell;           // by Var.index, for the caller's goals
    double *distance;
    uint64_t next_report;
    // solving
    struct SearchWish *wish;  // by input
    uint64_t wait;            // steps that a solution has to last
    uint32_t foreign;         // a variable that another state has to store; SEARCH_NONE
    double foreign_value;     // what the solution needs of it
    uint64_t rounds;          // how often a variable has to be counted up or down, one after another; 0: no count was solved for
    bool is_round;            // their changes repeat earlier ones, and are not counted
    uint32_t site_state;      // the state of the snapshot
    VEC(SearchTurn) turn;
} SearchRun;

// A number below n, which is above 0.
uint64_t search_random(SearchRun *k);
static inline uint32_t search_pick(SearchRun *k, uint32_t n) { return (uint32_t)(search_random(k) % n); }
static inline bool search_chance(SearchRun *k, uint32_t percent) { return search_pick(k, 100) < percent; }

void search_study_machine(SearchRun *k);

void search_make_goals(SearchRun *k);
void search_prove(SearchRun *k);              // finds goals that are impossible
void search_build_flat(SearchRun *k);         // builds `flat` for the goals that are open
FlatMachine *search_new_flat(SearchRun *k, Arena *arena);     // a machine with the probes of SearchRun.is_open
double search_near(double difference);        // a distance from 0 to below 1

void search_begin_nodes(SearchRun *k);
// Runs `steps` steps from a node with changes of inputs, and stores what is worth it.  Stops early if it reaches `goal`.  Without a goal
// (SEARCH_NONE) returns the node after the last step, which the caller drops.
uint32_t search_run_segment(SearchRun *k, uint32_t from, const SearchTurn *turn, uint32_t turns, uint64_t steps, uint32_t goal);
// The same without a goal, and with all steps whatever happens: a part of a given run.
uint32_t search_run_exactly(SearchRun *k, uint32_t from, const SearchTurn *turn, uint32_t turns, uint64_t steps);
// Opens the goals again that were reached after more than so many changes: only a run with fewer changes counts.  Returns whether there are any.
bool search_reopen(SearchRun *k, uint32_t changes);
void search_close_again(SearchRun *k);        // ends that
void search_drop(SearchRun *k, uint32_t node);
bool search_goes_on(SearchRun *k);            // whether effort is left and the caller wants to go on
void search_load(SearchRun *k, uint32_t node, char *to);
void search_apply(SearchRun *k, char *block, uint64_t at, const SearchTurn *turn, uint32_t turns);
void search_set_inputs(SearchRun *k, char *block, uint64_t step);
static inline SearchSetting *search_settings(const SearchRun *k, char *block) { return (SearchSetting *)(void *)(block + k->settings); }

// Find changes for a node, in k->turn.  Return for how many steps to run.
uint64_t search_solve_goal(SearchRun *k, uint32_t node, uint32_t goal);
uint64_t search_solve_exit(SearchRun *k, uint32_t node, const SearchExit *x);

// Returns the entry of a state (0: any) at which a variable is nearest to a value; SEARCH_NONE: it has not been entered.
uint32_t search_find_nearest_entry(SearchRun *k, uint32_t var, double wanted, uint32_t state);
// Makes the changes of k->turn and takes them back, again and again, from a node that they were found for.
void search_run_pulses(SearchRun *k, uint32_t node, uint32_t goal);
// Goes from an entry through a state that stores k->foreign, and back to the first state, again and again.
void search_go_around(SearchRun *k, uint32_t goal);

// Makes a short run with special values from a node (SearchOptions.specials).
void search_run_specials(SearchRun *k, uint32_t node);

// Adds a change of a given scenario to k->turn, if it sets an input.
void search_add_change(SearchRun *k, const ScenarioChange *c);

void search_begin_solving(SearchRun *k);

void search_choose(SearchRun *k);
void search_describe_missing(SearchRun *k);

// The value of an instruction in the last step of k->plain, and the truth of node n of a decision there.
static inline double search_value_of(const SearchRun *k, uint32_t fn, IrRef ref) { return k->plain->frame[k->plain->fn[fn].slot[ref]]; }
bool search_node_value(const SearchRun *k, const SearchDecision *x, uint32_t n);

#endif
