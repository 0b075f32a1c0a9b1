// SPDX-License-Identifier: Apache-2.0
// The state of a run of a script, shared by script_run.c, asserts.c and history.c.
#ifndef SMC_RUN_H
#define SMC_RUN_H

#include "compiler/script/ref.h"
#include "compiler/script/schedule.h"
#include "compiler/script/script.h"

// An assert or a @stop whose guard was true in this step, noted before the step runs and evaluated after it.
typedef struct NotedAssert {
    const ScriptItem *item;
    size_t assert;            // index into item->asserts; asserts.n means the item's @stop
} NotedAssert;

// An @expect whose condition has not been true since its guard was.
typedef struct PendingExpect {
    const ScriptItem *item;
    size_t assert;            // index into item->asserts
    uint64_t since;           // G of the step in which its guard was true
} PendingExpect;

// A machine of a run.
typedef struct ScriptMachine {
    const Var *s, *t;
    const Var *mode;          // the element of its @mode; or NULL
    uint32_t first;           // its states are numbered from first + 1 on
    uint64_t every;           // it is due once in this many ticks
    uint64_t wait;            // ticks until it is due
    bool is_due;              // this step is one of its own: it is due, and enabled when the step begins
    const State *state;       // the state that its next step runs
    uint64_t start;           // G of the first step of its state
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
    uint64_t *cell;           // the values that the script sees, by variable: those of the machine, then those of the script
    RefWindows windows;       // the rolling windows of the script itself, not those of the machine
    uint64_t g;               // G of this step
    uint64_t rest;            // of an application: nanoseconds since G was reached
    ScriptMachine *machine;   // the machine, or those of the application
    size_t machines;
    const State **active;     // the states of the machines at whose ticks this step is, `actives` of them
    size_t actives;
    const State **states;     // by machine: its state, for ScriptStep
    Schedule *schedule;
    DueItems due;             // the items of this step whose guards can be true
    VEC(EngineWrite) write;   // the inputs that this step writes before the machine runs
    VEC(NotedAssert) noted;   // the asserts that this step has noted, in source order
    VEC(PendingExpect) pending;       // in the order in which they began; at most one for each @expect
    uint8_t *is_pending;      // by number of the assert
    Buf printed;              // the lines of @print, at most PRINTED_MOST
    uint64_t prints;          // how many lines there would be without a limit
    uint8_t *evaluated;       // by number of the assert: it was evaluated at least once
    uint8_t *was_true;        // by number of the conditional: its guard was true at least once
    uint64_t *ran;            // by State.number - 1: the last step that ran the state, 0: none
    const Expr *failed;       // the condition that failed, or the guard of an @fail; or NULL
    const ScriptItem *failed_item;
    uint64_t failed_since;    // of an @expect: G of the step in which it began
    ScriptResult result;
    bool ended;               // then result.outcome is the reason
} ScriptRun;

// Returns G of the step of machine i after the one at this step, for an assert of its sections: `machine` as in ScriptItem. UINT64_MAX: G would
// overflow, or reach 2^64-1.
uint64_t run_next_g(const ScriptRun *r, uint32_t machine);
// Returns the state in which the machine is in this step; of an application, those of all machines.
const char *run_state_text(const ScriptRun *r);
// Ends the run.
void run_finish(ScriptRun *r, ScriptOutcome outcome);
// Returns the first item with a @stop; NULL only in a script with errors.
const ScriptItem *script_first_stop(const Script *s);
// Returns the last step in which a section ran, 0: none; of [all_states], which runs in each step: 1.
uint64_t run_last_of_section(const ScriptRun *r, const ScriptSection *section);
// Runs the script from its first step until it ends.  Reports errors of engines and differences between them.
void run_to_the_end(ScriptRun *r);

// ---- asserts.c ----

// Evaluates the asserts noted in this step, in order.  Ends the run if an assert fails or at @stop.
void assert_check_step(ScriptRun *r);
// Returns the lines of @print.
const char *assert_finish_printing(ScriptRun *r);
// Reports the assert that failed, with the values of its operands and the history of the run.
void assert_report_failure(ScriptRun *r);
// Warns about asserts that no step evaluated, and about a script without asserts.
void assert_report_unevaluated(const ScriptRun *r);
// Appends the value of e in the format of diagnostics.
void run_append_value(ScriptRun *r, const Expr *e, Buf *out);
// Whether a message that shows the n expressions of `shown` with their values can show e too: its source is on one line of at most `most`
// bytes, and differs from theirs.
bool run_can_show(const Expr *const *shown, size_t n, const Expr *e, size_t most);

// ---- history.c ----

// Adds the last steps and transitions to d, which reports a run that ended badly.  If no assert failed, also adds where the script
// should have stopped.
void history_add(ScriptRun *failed, Diag *d);

#endif
