// SPDX-License-Identifier: Apache-2.0
// Runs a state script against a machine on one or more engines (language.md 8) and returns the result.
#ifndef SMC_SCRIPT_H
#define SMC_SCRIPT_H

#include "compiler/base/buf.h"
#include "compiler/diag/diag.h"
#include "compiler/script/engine.h"
#include "compiler/sema/program.h"

typedef enum ScriptOutcome {
    SCRIPT_PASSED,
    SCRIPT_FAILED,            // an assert was false
    SCRIPT_ENDLESS,           // no @stop was reached within max_steps
    SCRIPT_TIME_OVERFLOW,         // G cannot advance any further
    SCRIPT_CANCELLED,         // ScriptOptions.is_cancelled returned true
    SCRIPT_BROKEN,            // an engine failed
    SCRIPT_DIFFERENT          // two engines disagree
} ScriptOutcome;

typedef struct ScriptStep {
    uint64_t number;          // number of the step, from 1
    uint64_t g;               // G in this step
    const State *state;       // the state that the step ran; of an application, that of its first machine
    const uint64_t *cell;     // the value of every variable after the step, by index
    const State *const *states;       // of an application: by machine, the state that the step ran, or its next step runs; else NULL
    const Program *program;
} ScriptStep;

typedef struct ScriptOptions {
    uint64_t max_steps;
    void (*after_step)(void *context, const ScriptStep *step);      // called after each step, before its asserts are evaluated; or NULL
    void *context;            // passed to both functions
    bool (*is_cancelled)(void *context);      // called after each step that does not end the run; or NULL
    bool is_compared;         // the report or trace is compared or only displayed, so the script needs no assert
} ScriptOptions;

typedef struct ScriptResult {
    ScriptOutcome outcome;
    uint64_t steps;
    uint64_t asserts_passed;
    uint64_t *cell;           // the final values, by variable
    const char *printed;      // what @print has shown: lines; "" if nothing
    const uint8_t *evaluated; // by number of the assert, in the order of the script: it was evaluated at least once
    const uint8_t *undecided; // by number of the assert: it is an @expect that was neither met nor failed when the run ended
    const ScriptAssert *failed;       // SCRIPT_FAILED: the assert that was not met
    const char *difference;   // SCRIPT_DIFFERENT, SCRIPT_BROKEN: description and location
} ScriptResult;

// Runs the engines in lock step on one script.  The values of the first engine decide guards and asserts.  A failed assert, an
// assert that was never evaluated and other failures are reported to `diags`.
ScriptResult script_run(Arena *arena, Diags *diags, const Script *s, Engine **engine, size_t engines, const ScriptOptions *o);

// Appends the report of a run: the number of steps and of passed asserts, then the final value of each variable.
void script_report(const ScriptResult *r, const Program *p, Buf *out);
// Append a cell (the bits of a value in its type): rounded, as in the report; and with floats in hexadecimal, as in an exact trace.
void format_cell_rounded(Buf *out, SmType type, uint64_t cell);
void format_cell_exact(Buf *out, SmType type, uint64_t cell);
// Append a value with the fewest digits that read back as the same double.
void format_cell_shortest(Buf *out, SmType type, uint64_t cell);
void format_number_shortest(Buf *out, double x);

// Returns the variables in the order of reports and traces; allocated in `arena`.
const Var **report_order(Arena *arena, const Program *p);

// ---- script_trace.c ----

// CSV: a header, then one row for each step: the script, the step, G, the name of the state, and the columns.  A bool is written as 1
// or 0, which every reader accepts as a number.  A column with the name of one of these first columns is called MACHINE.NAME.  Of an
// application, a column for each machine, with its name, takes the place of the state.
void script_trace_header(Buf *out, const Program *p, const Var *const *column, size_t n);
void script_trace_row(Buf *out, const char *script, const ScriptStep *step, const Var *const *column, size_t n);
// Appends a line `STEP NAME VALUE` for each variable of `order`.  Floats are printed as C99 %a, which is exact.
void script_trace_exact(Buf *out, const ScriptStep *step, const Var *const *order, size_t n);

#endif
