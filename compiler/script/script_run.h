// SPDX-License-Identifier: Apache-2.0
// Internal to the script engine: the state of a run, shared by script_run.c, asserts.c and history.c.
#ifndef SMC_RUN_H
#define SMC_RUN_H

#include "compiler/script/ref.h"
#include "compiler/script/script.h"

// An assert or a @stop of a conditional whose guard was true in this step.
typedef struct Noted {
    const ScriptItem *item;
    size_t assert;            // index into item->asserts; asserts.n means the item's @stop
    size_t number;            // number of the assert in the script
} Noted;

typedef struct Run {
    Arena *arena;
    Diags *diags;
    const Script *s;
    const Program *p;
    Engine **engine;
    EngineStep *answer;       // of each engine
    size_t engines;
    const ScriptOptions *o;
    uint64_t *cell;           // the values that the script sees, by variable
    RefWindows windows;       // the script's own
    uint64_t g, start;        // G of this step; of the first step of its state
    const State *state;       // the state that this step runs
    EngineWrite *write;       // inputs of the machine for this step
    uint32_t writes;
    Noted *noted;             // in this step, in order
    size_t notes;
    uint8_t *evaluated;          // by number of assert: it was evaluated at least once
    uint8_t *was_true;        // by number of conditional: its guard was true at least once
    uint64_t *ran;            // by section: the last step in which it ran; 0: none
    const Expr *failed;       // the assert that failed, or NULL
    const ScriptItem *failed_item;
    ScriptResult result;
    bool over;                // result.outcome is the reason
} Run;

void run_end(Run *r, ScriptOutcome outcome);
const ScriptItem *script_first_stop(const Script *s);      // NULL only in a script with errors
// Runs the script from its first step until it ends.  Reports errors of engines and differences between them.
void run_to_the_end(Run *r);

// ---- asserts.c ----

// Evaluates the asserts noted in this step, in order.  Ends the run if an assert fails or at @stop.
void assert_check_step(Run *r);
void assert_report_failure(Run *r);        // for the assert that failed
// Warns about asserts that no step evaluated, and about a script without asserts.
void assert_report_unevaluated(const Run *r);
// Appends the value of e as messages show it.
void run_put_value(Run *r, const Expr *e, Buf *out);
bool span_same_text(Span a, Span b);

// ---- history.c ----

// Adds the last steps and transitions to d, which reports a run that ended badly.  If no assert failed, also adds where the script
// should have stopped.
void history_add(Run *failed, Diag *d);

#endif
