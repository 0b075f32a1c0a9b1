// SPDX-License-Identifier: Apache-2.0
// Runs a state script against a machine on an engine (language.md 8) and tells what happened.
#ifndef SMC_SCRIPT_H
#define SMC_SCRIPT_H

#include "compiler/base/buf.h"
#include "compiler/diag/diag.h"
#include "compiler/script/engine.h"
#include "compiler/sema/program.h"

typedef enum ScriptOutcome {
    SCRIPT_PASSED,
    SCRIPT_FAILED,            // an assert did not hold
    SCRIPT_ENDLESS,           // max_steps without @stop
    SCRIPT_TIME_OVER,         // G cannot advance any further
    SCRIPT_BROKEN,            // an engine failed
    SCRIPT_DIFFERENT          // two engines disagree
} ScriptOutcome;

typedef struct ScriptStep {
    uint64_t number;          // from 1
    uint64_t g;               // G in this step
    const State *state;       // that the step ran
    const uint64_t *cell;     // every variable after it
} ScriptStep;

typedef struct ScriptOptions {
    uint64_t max_steps;
    void (*after_step)(void *context, const ScriptStep *step);      // NULL, or called after each step, before its asserts
    void *context;
    bool is_compared;         // its report or trace is compared with another, or only shown: it needs no assert
} ScriptOptions;

typedef struct ScriptResult {
    ScriptOutcome outcome;
    uint64_t steps;
    uint64_t asserts_passed;
    uint64_t *cell;           // the final values, by variable
    const char *difference;   // SCRIPT_DIFFERENT, SCRIPT_BROKEN: what and where
} ScriptResult;

// Runs the engines in lock step on one script; the first one's values decide guards and asserts.  A failed assert, an
// assert never judged and the other bad ends are reported to `diags`.
ScriptResult script_run(Arena *arena, Diags *diags, const Script *s, Engine **engine, size_t engines, const ScriptOptions *o);

// The report of thesis Figure 3.4.
void script_report(const ScriptResult *r, const Program *p, Buf *out);
// A cell as the report prints it, and as a trace does.
void format_cell(Buf *out, SmType type, uint64_t cell);
void format_cell_trace(Buf *out, SmType type, uint64_t cell);
// With the fewest digits that give the same number when they are read as a double.
void format_cell_exact(Buf *out, SmType type, uint64_t cell);
void format_number_exact(Buf *out, double x);

// The variables in the order of reports and traces; in arena.
const Var **report_order(Arena *arena, const Program *p);

// ---- script_trace.c ----

// CSV: a header, then a row for each step with the script, the step, G, the name of the state, and the columns.  bool is 1 or 0, which
// every reader takes for a number.  A column that would be called like one of the first is called MACHINE.NAME.
void script_trace_header(Buf *out, const Program *p, const Var *const *column, size_t n);
void script_trace_row(Buf *out, const char *script, const ScriptStep *step, const Var *const *column, size_t n);
// A line `STEP NAME VALUE` for each of `order`; floats as C99 %a, in which every bit can be read.
void script_trace_exact(Buf *out, const ScriptStep *step, const Var *const *order, size_t n);

#endif
