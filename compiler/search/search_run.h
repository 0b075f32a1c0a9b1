// SPDX-License-Identifier: Apache-2.0
// The parts of a running search.  Only files of this folder include it.
//
//     search_machine.c   what no run changes: inputs, decisions, stores, and the path to each statement
//     search_goals.c     goals, and how far a step was from each
//     search_prove.c     goals that are impossible
//     search_nodes.c     states that have been reached, and runs from them
//     search_wish.h      which inputs lead to a goal: backwards from its conditions, or at random, in three files
//     search_stay.c      waits in a state that other transitions would end
//     search_guard.c     waits during which other machines would store something else
//     search_repeat.c    pulses of inputs, and ways around through several states, again and again
//     search_special.c   short runs with infinities, ends of ranges, and changes in each step
//     search_choose.h    few scenarios with few changes that reach what was reached, in three files
//     search_missing.c   what blocked the goals that were not found
//     search.c           the loop
//
// Words of all these files:
//
//     node       a state of the machine that a run has reached, with the inputs as they are then
//     snapshot   a node whose whole state is stored, so that runs can begin there
//     turn       a change of an input at the start of a segment
//     segment    the steps that run from a node with some turns: one attempt of the search
//     pool       the snapshots that came nearest to a goal
//     entry      a snapshot taken when a state of the machine was entered
//
//     flat       a machine compiled to a flat list of instructions (FlatMachine); with probes it counts what runs reach, or measures distances
//
// Letters: k the search, f a flat machine, n a node, g a goal.  A state's number is State.number, from 1.
#ifndef SMC_SEARCH_RUN_H
#define SMC_SEARCH_RUN_H

#include "compiler/search/search.h"

enum { SEARCH_POOL = 4, SEARCH_ENTRIES = 32 };        // the most snapshots in the pool of a goal, and the most entries of a state
#define SEARCH_NONE UINT32_MAX

// ---- the machine ----

typedef struct SearchInput {
    uint32_t var, at;         // var: index into Program.var; at: index into IrMachine.var
    SmType type;
    bool forced;              // the machine writes the input, too, so that runs set it again before every step
    const Range *range;       // @range of the input; NULL: none
    VEC(double) constant;     // numbers with which the machine compares the input, and hints of the caller for it
    uint32_t *slot;           // hash table: 1 + index into `constant`; 0: empty.  Scripts with noise set an input to many thousand numbers
    uint32_t slots;           // a power of 2, or 0
} SearchInput;

// A decision on the path to a statement, and the outcome that leads there.
typedef struct SearchElem {
    uint32_t decision;        // index into SearchRun.decision
    bool value;
    bool is_certain;          // no run executes the statement without this outcome; false: some runs can
} SearchElem;

// The decisions that lead to a statement, the innermost first: a step makes the last one of the list first.
typedef struct SearchPath { const SearchElem *elem; uint32_t n; } SearchPath;

typedef struct SearchDecision {
    const FlatDecision *d;
    uint32_t fn;              // index into FlatMachine.fn
    uint32_t state;           // number of the state that contains the decision; 0: a sampled expression contains it
    SearchPath path;          // the path to the statement that contains the decision
    uint32_t *operand;        // indices into FlatMachine.frame: the numbers from which the distances of the outcomes are computed
    double *last;             // the values of `operand` when the distances were last computed
    uint32_t operands;
    bool is_known;            // `last` has been set
    VEC(struct SearchEdge) edge;      // the goals whose paths contain the decision
    uint64_t *inputs;         // set of inputs on which the decision depends, one bit for each index into SearchRun.input
} SearchDecision;

// A store to a variable: instruction `ref` of function `fn`, in statement `stmt` (Stmt.number) of state `state`, stores temporary `value`.
typedef struct SearchStore { uint32_t fn, state, stmt; IrRef ref, value; } SearchStore;

typedef struct SearchVar {
    uint32_t input;           // index into SearchRun.input; SEARCH_NONE: it is no input
    VEC(SearchStore) store;   // all stores to the variable
    uint64_t *inputs;         // set of inputs on which the variable's value depends
} SearchVar;

typedef struct SearchFn {
    const IrFn *fn;
    uint32_t state;           // number of the state to which the function belongs; 0: it samples the windows
    bool is_step;             // the function is the code of .step, which runs in each step of the state
    uint8_t *handle;          // by IrRef: how the search can influence the value, a set of HANDLE_… bits
} SearchFn;

enum { HANDLE_INPUT = 1, HANDLE_VAR = 2, HANDLE_TIME = 4, HANDLE_WINDOW = 8 };       // through an input, a stored variable, T or G, a window

// A transition: statement `stmt` (Stmt.number), and the numbers of the states that it leaves and enters.
typedef struct SearchExit { uint32_t stmt, from, to; SearchPath path; } SearchExit;

// ---- goals ----

// A state and a path on which a goal can be reached.  With a condition (else SEARCH_NONE), this condition of the innermost decision must determine
// the outcome of the decision, with `value`.
typedef struct SearchSite { uint32_t state; SearchPath path; uint32_t condition; bool value; } SearchSite;

// A goal whose path contains a decision.  level: index of the decision in the path, so the number of decisions that still follow it.
typedef struct SearchEdge { uint32_t goal, level, condition; bool value; } SearchEdge;

// A node of a pool, and the distance from the goal that its next step had.
typedef struct SearchNear { uint32_t node; double distance; } SearchNear;

typedef struct SearchGoal {
    uint32_t place;           // index into SearchResult.find
    VEC(SearchSite) site;     // the states and paths in which the goal can be reached
    bool done;                // reached, or proved impossible
    SearchNear pool[SEARCH_POOL];
    uint32_t pooled;
    double best;              // the smallest distance of all runs
    SearchElem best_elem;     // the decision that did not have the needed outcome in the step with that distance
    uint32_t best_condition;  // the condition that must determine the outcome of `best_elem`; SEARCH_NONE: only the outcome matters
    uint64_t cost;            // steps that attempts for this goal have run, and 100 for each attempt
    uint32_t found;           // the node after the step that reached the goal
    double run_best;          // the smallest distance in the current segment
    uint64_t run_step;        // the step with `run_best`, counted from the start
    bool touched;             // the goal is in the list SearchRun.touched
    uint32_t fill;            // coverage point of kind WINDOW: size of the window in steps; the goal cannot be reached before the window is full
} SearchGoal;

// ---- nodes ----

// How an input is set from a step on: held at a value, alternating, a ramp, or a copy of a variable (ScenarioChange).
typedef struct SearchSetting {
    bool set;                 // false: the run has not set the input yet
    ScenarioKind kind;
    double a, b;              // HOLD: a is the value; ALTERNATE: a and b; RAMP: a is the first value, b is added in each step
    uint32_t source;          // COPY: index into Program.var
    uint64_t since;           // the step in which the change was made
} SearchSetting;

typedef struct SearchTurn { uint32_t input; SearchSetting setting; } SearchTurn;

// A node: it is reached from its parent by the changes `turn` and the steps up to `at`.
typedef struct SearchNode {
    uint32_t parent;
    uint32_t users;           // number of pools and entries that contain the node, and of running attempts; 0: it has no snapshot
    uint32_t followers;       // number of its children, and of goals that were reached there; a node without followers and users is freed
    uint64_t at;              // number of steps from the start
    SearchTurn *turn;         // `turns` changes that are made at the parent
    uint32_t turns;
    uint32_t depth;           // number of changes from the start; changes of equal rounds count once
    char *copy;               // the snapshot: SearchRun.block bytes; NULL: none
    uint32_t state;           // number of the state that the next step after the node runs
    uint64_t key;             // a hash of the snapshot
} SearchNode;

typedef struct SearchRun {
    Arena *arena, work;       // `arena`: memory of the result; `work`: memory of what only the search needs
    Arena flats;              // memory of the current machine with probes (`flat`, below)
    Arena legs;               // memory of the parts of the current detour (search_go_around)
    const Cover *c;
    const Program *p;
    const IrMachine *m;
    const SearchOptions *o;
    SearchResult *r;
    uint64_t effort, random, delta_t;     // random: state of the random number generator
    uint64_t every;           // the machine steps once in so many steps of a run: 1, or of an application's tick
    uint64_t reserve;         // steps of the effort that are set aside for replaying the runs that reached goals
    uint64_t stop_at;         // the search ends when this many steps have run
    const State *start;       // the state in which every run begins
    FlatMachine *plain;       // the machine without probes
    FlatMachine *flat;        // the machine with the probes of open goals; calls measure_goals for decisions on their paths
    FlatMachine *quiet;       // the machine with the probes of open goals only
    FlatMachine *running;     // the machine of the current segment: `flat` or `quiet`
    uint64_t progress;        // value of r->steps when a snapshot was last added to the pool of a goal
    FlatMachine *judge;       // the machine with all probes, which search_choose runs
    uint32_t *kept;           // by decision of `flat`: index into `decision`
    uint32_t done_since;      // number of goals that were reached since `flat` was built
    // the machine
    SearchInput *input;
    uint32_t inputs, words;   // words: length of a set of inputs, in uint64_t
    SearchVar *var;           // by index into IrMachine.var
    SearchFn *fn;             // by index in FlatMachine.fn
    SearchDecision *decision; // by index in FlatProbes.decision
    uint32_t decisions;
    SearchPath *path;         // by Stmt.number: the path to the statement
    uint32_t *guard;          // by Stmt.number of an IF: index of its decision; SEARCH_NONE for other statements
    VEC(SearchExit) exit;
    VEC(double) constant;     // all numbers in the machine's code
    VEC(uint32_t) output;     // variables that the machine writes, as indices into Program.var
    uint32_t longest;         // size of the longest window, in samples
    // goals
    SearchGoal *goal;
    uint32_t goals, open;     // number of goals, and of those that are not done
    uint32_t *goal_of;        // by index into SearchResult.find: index into `goal`; SEARCH_NONE: no goal
    uint32_t *counter;        // by coverage point: number of the counter that counts it; points that always occur together share a counter
    bool *is_open;            // by counter: an open goal needs it, so the machine with probes counts it
    VEC(uint32_t) touched;    // goals for which a distance was measured in the current segment
    double *cost[2];          // by node of the decision that is being measured: distance from being false (cost[0]), from being true (cost[1])
    // nodes
    VEC(SearchNode) node;
    uint32_t root;            // the node of the start, before the first step; it always has a snapshot
    SearchNear *entry;        // the entries of each state: SEARCH_ENTRIES from index (State.number - 1) * SEARCH_ENTRIES on
    uint32_t *entries;        // by State.number - 1: number of entries of the state
    bool *visited;            // by State.number - 1: some run was in the state
    size_t block, settings;   // bytes of a snapshot; offset in bytes of the inputs' settings within a snapshot
    size_t nominal;           // bytes that the memory limit assumes for a snapshot: the same on every computer, so that results do not depend on it
    size_t used, memory;      // bytes that are in use, with `nominal` for each snapshot; the limit of `used` (SearchOptions.memory)
    VEC(char *) free;         // unused memory of snapshots
    SearchTurn **free_turn;   // by number of turns: a list of unused arrays of that length
    uint32_t free_node;       // the first unused node; SearchNode.parent is the next one; SEARCH_NONE ends the list
    VEC(uint32_t) active;     // inputs that are set before each step of the current run
    char *now, *scratch;      // the state of the current run; `scratch`: a copy of a snapshot, on which one trial step is run
    uint64_t at;              // steps that the current run has run
    uint64_t *cell;           // by Var.index: the variables after the current step, for the caller's goals
    double *distance;         // by goal of the caller: what SearchWatch.step has set
    uint64_t next_report;     // value of r->steps at which the caller is next asked whether to go on
    // solving
    struct SearchWish *wish;  // by index into `input`: what the solution wants the input to be
    uint64_t wait;            // how many steps the solved changes must last; 0: no condition asks for a time
    uint32_t foreign;         // a variable that only another state can store as needed; SEARCH_NONE: there is none
    double foreign_value;     // the value that `foreign` needs to have
    uint64_t rounds;          // how many times a counter of the machine must be incremented or decremented; 0: the solution needs no counter
    bool is_lasting;          // the wishes are for all steps of a wait, not for one step
    bool is_way;              // the current run is a simplified one: its entries are always stored
    bool is_round;            // the current changes repeat earlier ones: they do not count in SearchNode.depth
    uint32_t site_state;      // the state of the snapshot for which changes are solved
    VEC(SearchTurn) turn;     // the changes that were solved for
    struct Chooser *chooser;  // what search_choose works with
} SearchRun;

uint64_t search_random(SearchRun *k);
// Returns a random number below n, which is above 0.
static inline uint32_t search_pick(SearchRun *k, uint32_t n) { return (uint32_t)(search_random(k) % n); }
static inline bool search_chance(SearchRun *k, uint32_t percent) { return search_pick(k, 100) < percent; }

// Builds a flat machine, which runs in its application if the search has one.
FlatMachine *search_flat(const SearchRun *k, Arena *arena, const FlatProbes *probes);

void search_analyse_machine(SearchRun *k);

void search_make_goals(SearchRun *k);
void search_prove(SearchRun *k);              // finds goals that are impossible
void search_build_flat(SearchRun *k);         // builds `flat` for the goals that are open
FlatMachine *search_new_flat(SearchRun *k, Arena *arena);     // a machine with the probes of SearchRun.is_open
double search_near(double difference);        // maps a difference of two numbers to a distance from 0 to below 1

void search_begin_nodes(SearchRun *k);
// Runs a segment of `steps` steps from a node.  Stores snapshots where it comes nearer to a goal than before, or enters a state.  Stops early if
// it reaches `goal`.  Without a goal (SEARCH_NONE) returns the node after the last step, which the caller drops.
uint32_t search_run_segment(SearchRun *k, uint32_t from, const SearchTurn *turn, uint32_t turns, uint64_t steps, uint32_t goal);
// Runs a segment without a goal: a part of a given run, of which all steps run.
uint32_t search_run_exactly(SearchRun *k, uint32_t from, const SearchTurn *turn, uint32_t turns, uint64_t steps);
// Opens the goals again that were reached after more than so many changes: only a run with fewer changes counts.  Returns whether there are any.
bool search_reopen(SearchRun *k, uint32_t changes);
void search_close_again(SearchRun *k);        // closes the goals that search_reopen has opened
void search_drop(SearchRun *k, uint32_t node);        // ends a use of the node: without other users it loses its snapshot
bool search_goes_on(SearchRun *k);            // whether effort is left and the caller wants to go on
void search_load(SearchRun *k, uint32_t node, char *to);      // copies the node's snapshot
// Returns the statement of the last step that has stored a variable which temporary `ref` reads; 0: none has.
uint32_t search_find_store(const SearchRun *k, uint32_t fn, IrRef ref);
// Whether the last step of k->plain has made all decisions of a path, in a state that it has run.
bool search_was_taken(const SearchRun *k, SearchPath path);
// Adds wishes so that a step like the last one does not execute a statement which that step has executed.
void search_avoid_statement(SearchRun *k, uint32_t stmt);
// Makes changes in the state `block` of a run that has run `at` steps.
void search_apply(SearchRun *k, char *block, uint64_t at, const SearchTurn *turn, uint32_t turns);
void search_start(const SearchRun *k, FlatMachine *f, char *block, uint32_t state);    // makes `block` the start of a run in a state
void search_set_inputs(SearchRun *k, char *block, uint64_t step);     // sets all inputs and the time before step `step`
static inline SearchSetting *search_settings(const SearchRun *k, char *block) { return (SearchSetting *)(void *)(block + k->settings); }

// Solve for changes of inputs at a node, and store them in k->turn.  Return the length of the segment, in steps.
uint64_t search_solve_goal(SearchRun *k, uint32_t node, uint32_t goal);
uint64_t search_solve_exit(SearchRun *k, uint32_t node, const SearchExit *x);

// Runs the solution, which must last k->wait steps, towards a goal.  Changes other inputs, too, so that the machine stays in the state of the node
// meanwhile, unless it goes to a state that no run has visited.
void search_run_staying(SearchRun *k, uint32_t node, uint32_t goal);

// Returns the entry of a state (0: of any state) whose snapshot has the variable nearest to the wanted value; SEARCH_NONE: there is no entry.
uint32_t search_find_nearest_entry(SearchRun *k, uint32_t var, double wanted, uint32_t state);
// Makes the changes of k->turn and undoes them, again and again, from the node for which they were solved.
void search_run_pulses(SearchRun *k, uint32_t node, uint32_t goal);
// Goes from an entry through a state that stores k->foreign, and back to the first state, again and again.
void search_go_around(SearchRun *k, uint32_t goal);

// Another machine of the application: what a search knows of its code.
typedef struct SearchOther {
    struct SearchRun *of;     // the machine, studied but not searched; NULL: the machine that is searched
    uint32_t *input;          // by index into of->input: index into SearchRun.p's variables of the element; SEARCH_NONE: no input of the application
    uint32_t *var;            // by IR variable of SearchRun.m: that of `of` with the same element; SEARCH_NONE: none, or `of` does not store it
} SearchOther;

// Runs the solution, which must last k->wait steps, towards a goal.  Changes other inputs, too, so that other machines meanwhile leave alone what the
// machine reads.
void search_run_guarding(SearchRun *k, uint32_t node, uint32_t goal);

// Makes a short run with special values from a node (SearchOptions.specials).
void search_run_specials(SearchRun *k, uint32_t node);

// Adds a change of a given scenario to k->turn, if it sets an input.
void search_add_change(SearchRun *k, const ScenarioChange *c);

void search_begin_solving(SearchRun *k);

void search_begin_choosing(SearchRun *k);
// Simplifies a run to each state, and runs what results: attempts can then begin at states after few changes.  Stops after `end` steps.
void search_shorten_ways(SearchRun *k, uint64_t end);
// Runs a scenario, and stores the snapshots along it.
void search_run_given(SearchRun *k, const Scenario *s);
void search_choose(SearchRun *k);             // chooses and simplifies the scenarios of the result
void search_describe_missing(SearchRun *k);   // sets nearest, blocked_by and so on of the goals that were not found

// The value of an instruction in the last step of k->plain, and the truth of node n of a decision there.
static inline double search_value_of(const SearchRun *k, uint32_t fn, IrRef ref) { return k->plain->frame[k->plain->fn[fn].slot[ref]]; }
bool search_node_value(const SearchRun *k, const SearchDecision *x, uint32_t n);

#endif
