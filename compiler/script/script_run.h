// SPDX-License-Identifier: Apache-2.0
// The state of a run of a script, shared by script_run.c, asserts.c and history.c.
#ifndef SMC_RUN_H
#define SMC_RUN_H

#include "compiler/script/ref.h"
#include "compiler/script/replay.h"
#include "compiler/script/schedule.h"
#include "compiler/script/script.h"
#include "compiler/script/watch.h"

// An assert or a @stop whose guard was true in this step, noted before the step runs and evaluated after it.
typedef struct NotedAssert {
    const ScriptItem *item;
    size_t assert;            // index into item->asserts; asserts.n means the item's @stop
} NotedAssert;

// An @expect whose guard has been true, and whose condition has not been true since then.
typedef struct PendingExpect {
    const ScriptItem *item;
    size_t assert;            // index into item->asserts
    uint64_t since;           // G of the step in which the guard was true
} PendingExpect;

// A machine of a run.
typedef struct ScriptMachine {
    const Var *s, *t;
    const Var *mode;          // the element of its @mode; or NULL
    uint32_t first;           // the machine's states have the numbers from first + 1 on
    uint64_t every;           // the machine runs once in this many ticks
    uint64_t wait;            // number of ticks until the machine is due
    bool is_due;              // the machine steps in this tick: it is due, and its mode enables it
    const State *state;       // the state that the machine's next step runs
    uint64_t start;           // G of the first step of that state
    uint64_t start_step;      // number of the first step of that state
} ScriptMachine;

typedef struct ScriptRun {
    Arena *arena;
    Diags *diags;
    const Script *s;
    const Program *p;
    Engine **engine;
    EngineStep *answer;       // by engine: the result of its last step
    size_t engines;           // number of engines
    const ScriptOptions *o;
    uint64_t *cell;           // the values that the script reads: of the machine's variables by Var.index, then of the script's own
    RefRandom random;         // the random numbers of the script
    RefWindows windows;       // the windows of calls in the script, not in the machine
    Replay *replay;           // the recorded data; NULL: the script has none, or it cannot be read
    uint64_t g;               // G of this step
    uint64_t rest;            // for an application: nanoseconds by which the time of this tick exceeds g, less than one unit of G
    ScriptMachine *machine;   // by machine: the only one, or those of the application
    size_t machines;
    const State **active;     // the states of the machines that are due in this step, `actives` of them
    size_t actives;
    const State **states;     // by machine: buffer for ScriptStep.states
    Schedule *schedule;
    DueItems due;             // the items of this step whose guards can be true
    VEC(EngineWrite) write;   // the inputs that this step writes before the machine runs
    VEC(NotedAssert) noted;   // the asserts that this step has noted, in source order
    VEC(PendingExpect) pending;       // sorted by `since`; at most one for each @expect
    uint8_t *is_pending;      // by number of the assert: 1 if it is in `pending`
    Buf printed;              // the lines of @print, at most PRINTED_MOST
    uint64_t prints;          // number of lines that @print would have shown without a limit
    uint8_t *failed_asserts;  // by number of the assert: 1 if it was not met at least once
    uint64_t *evaluated;      // by number of the assert: how often it was evaluated
    uint64_t *true_in;        // by number of the item: number of the last step in which its guard was true; 0: none
    uint64_t *ran;            // by State.number - 1: number of the last step that ran the state; 0: none
    uint64_t *ran_at;         // by State.number - 1: G in the last step that ran the state
    const Expr *failed;       // why the run failed: the condition of an assert or a violated requirement, or the guard of an @fail; or NULL
    const ScriptItem *failed_item;    // the item with the assert that failed; NULL: a requirement was violated
    uint64_t failed_since;    // for a failed @expect: G of the step in which its guard was true
    Monitor *monitor;         // judges the requirements; NULL: the run has none
    void *situation;          // what the monitor remembers of the steps so far (monitor.h)
    RequirementRun *requirement;      // by requirement: the results so far
    const Requirement *violated;      // the first requirement that a step has violated; NULL: none
    Diag **violation;         // by requirement: the report of its first violation; NULL: none
    bool reports_violation;   // `failed` is the condition of a violated requirement, and reads the monitor's windows
    const void *pieces;       // the list of memory pieces that run_point.c saves; NULL: no point was saved yet
    ScriptResult result;
    bool ended;               // the run has ended, with result.outcome as the reason
} ScriptRun;

// Returns G of the next step in which the asserts of a machine are evaluated: `machine` as in ScriptItem. UINT64_MAX: no such step follows,
// because G would overflow or reach 2^64-1, or because the recorded data ends.
uint64_t run_next_g(const ScriptRun *r, uint32_t machine);
// Returns the state of the machine in this step as text for messages; for an application, the states of all machines.
const char *run_state_text(const ScriptRun *r);
// Returns the position of the script, for messages about its run as a whole.
Span run_start_of_script(const ScriptRun *r);
// Ends the run.
void run_finish(ScriptRun *r, ScriptOutcome outcome);
// Whether the run ended at a @stop or after the most steps, so that what it did not evaluate or decide is worth a warning.
bool run_is_complete(const ScriptRun *r);
// Returns the first item with a @stop; NULL only in a script with errors.
const ScriptItem *script_first_stop(const Script *s);
// Returns the number of the last step in which a section ran; 0: none.  For [all_states], which runs in each step, returns 1.
uint64_t run_last_of_section(const ScriptRun *r, const ScriptSection *section);
// Runs the script from its first step until it ends.  Reports errors of engines and differences between them.
void run_to_the_end(ScriptRun *r);
// The three parts of run_to_the_end, for code that interrupts a run or copies it.  All memory of a run without recorded data is in r->arena and in
// the arenas of its engines, so copying these arenas copies the run.
// Initialises the engines and prepares the first step.
void run_begin(ScriptRun *r);
// Runs further steps, until the run has ended or `steps` steps have run since the beginning.
void run_continue(ScriptRun *r, uint64_t steps);
// Sets r->result after the last step.
void run_end(ScriptRun *r);

// ---- run_point.c: runs that are continued more than once ----

// The state of a run of one machine between two steps, without the state of the engine.
typedef struct RunPoint RunPoint;

// Whether the points of a script can be saved: it has no recorded data, and its machine is no application.
bool run_has_points(const Script *s);
RunPoint *run_save_point(ScriptRun *r, Arena *arena);
// Makes r continue from the point, which was saved from r.  The caller restores the engine.
void run_restore_point(ScriptRun *r, const RunPoint *p);

// ---- asserts.c ----

// Evaluates the asserts noted in this step, in order.  Ends the run if an assert fails or at @stop.
void assert_check_step(ScriptRun *r);
// Returns the lines of @print.
const char *assert_finish_printing(ScriptRun *r);
// Reports the assert that failed, with the values of its operands and the history of the run.
void assert_report_failure(ScriptRun *r);
// Warns about asserts that no step evaluated, and about a script without asserts.
void assert_report_unevaluated(const ScriptRun *r);
// Appends the value of e in the format of diagnostics. w: the windows that e belongs to.
void run_append_value(ScriptRun *r, const Expr *e, const RefWindows *w, Buf *out);
// Adds a label with the values of the operands of e, which decided a failure.
void run_label_operands(ScriptRun *r, Diag *d, const Expr *e, const RefWindows *w);
// Whether a message that shows the n expressions of `shown` with their values can show e too: its source is on one line of at most `most`
// bytes, and differs from theirs.
bool run_can_show(const Expr *const *shown, size_t n, const Expr *e, size_t most);

// ---- run_requirements.c ----

void requirement_begin_run(ScriptRun *r);
// Judges the requirements after a step. Returns whether the step violates one that no earlier step has violated.
bool requirement_check_step(ScriptRun *r);
// Reports the requirements that this step is the first to violate, with its values, unless the run is silent.  The run goes on.
void requirement_report_new_violations(ScriptRun *r);
// Sets the results of a run that has ended.
void requirement_end_run(ScriptRun *r);
// Adds to the report of each violated requirement how many later steps violated it.
void requirement_report_repetitions(ScriptRun *r);
void requirement_report_undecided(const ScriptRun *r);

// ---- history.c ----

// Adds the last steps and transitions to d, which reports a run that ended badly.  If no assert failed, also adds where the script
// should have stopped.
void history_add(ScriptRun *failed, Diag *d);

// ---- why_short.c ----

// A run that failed is repeated on the engine `ref`.  Watches the machines of `ref`, as far as why_short_add needs it.  steps: the number of steps
// that the repeated run has made.  Returns the watches by machine; NULL: the condition that failed reads nothing that a machine stores.
Watch **why_short_watch(const ScriptRun *failed, Engine *ref, const uint64_t *steps);
// Adds at most WHY_SHORT_MOST notes to d that explain why the variables in the condition that failed have their values.
enum { WHY_SHORT_MOST = 4 };
void why_short_add(const ScriptRun *failed, Diag *d, Watch *const *watch);

#endif
