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
    ScriptResult result;
    bool over;                // result.outcome says how
} Run;

void run_end(Run *r, ScriptOutcome outcome);
// Judges what the step noted, in order; ends the run where an assert fails or @stop stands.
void judge_step(Run *r);
// Warns of asserts that no step judged.
void judge_unjudged(const Run *r);

#endif
