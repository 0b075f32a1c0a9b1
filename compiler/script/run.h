// SPDX-License-Identifier: Apache-2.0
// Inside of the script engine: a run as run.c and judge.c share it.
#ifndef SMC_RUN_H
#define SMC_RUN_H

#include "compiler/script/ref.h"
#include "compiler/script/script.h"

// An assert or a @stop of a conditional whose guard was true in this step.
typedef struct Noted {
    const ScriptItem *item;
    size_t assert;            // index into item->asserts; asserts.n means the item's @stop
    size_t number;            // of the assert among all of the script's
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
    uint64_t *cell;           // what the script sees, by variable
    RefWindows windows;       // the script's own
    uint64_t g, start;        // G of this step; of the first step of its state
    const State *state;       // that this step runs
    EngineWrite *write;       // for the machine, of this step
    uint32_t writes;
    Noted *noted;             // in this step, in order
    size_t notes;
    uint8_t *judged;          // by number of assert: it was judged at least once
    uint8_t *was_true;        // by number of conditional: its guard was true at least once
    uint64_t *ran;            // by section: the last step that it was run in; 0: none
    const Expr *failed;       // the assert that failed, or NULL
    const ScriptItem *failed_item;
    ScriptResult result;
    bool over;                // result.outcome says how
} Run;

void run_end(Run *r, ScriptOutcome outcome);
const ScriptItem *script_first_stop(const Script *s);      // NULL only of a script with mistakes
// Runs the script, from its first step; reports what engines do wrong, and the end of time.
void run_to_the_end(Run *r);

// ---- judge.c ----

// Judges what the step noted, in order; ends the run where an assert fails or @stop stands.
void judge_step(Run *r);
void judge_report_failure(Run *r);        // of the assert that failed
// Warns of asserts that no step judged, and of a script without any.
void judge_unjudged(const Run *r);
// The value of e as messages show it.
void run_put_value(Run *r, const Expr *e, Buf *out);
bool span_same_text(Span a, Span b);

// ---- history.c ----

// Adds to d, which reports how a run ended badly, the last steps and transitions; and where the script was to stop, if no assert failed.
void history_add(Run *failed, Diag *d);

#endif
