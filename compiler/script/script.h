// SPDX-License-Identifier: Apache-2.0
// Runs a state script against a machine on one or more engines (language.md 8) and returns the result.
#ifndef SMC_SCRIPT_H
#define SMC_SCRIPT_H

#include "compiler/base/buf.h"
#include "compiler/diag/diag.h"
#include "compiler/script/engine.h"
#include "compiler/script/monitor.h"
#include "compiler/sema/program.h"

typedef enum ScriptOutcome {
    SCRIPT_PASSED,
    SCRIPT_FAILED,            // an assert was false, or a requirement was violated
    SCRIPT_ENDLESS,           // no @stop was reached within max_steps
    SCRIPT_TIME_OVERFLOW,         // G cannot advance any further
    SCRIPT_NO_DATA,           // the recorded data cannot be read, or ended before a @stop
    SCRIPT_CANCELLED,         // ScriptOptions.is_cancelled returned true
    SCRIPT_BROKEN,            // an engine failed
    SCRIPT_DIFFERENT          // two engines disagree
} ScriptOutcome;

typedef struct ScriptStep {
    uint64_t number;          // number of the step, from 1
    uint64_t g;               // G in this step
    const State *state;       // the state that the step ran; in an application, the state of its first machine
    const uint64_t *cell;     // the value of every variable after the step, by index
    const uint8_t *results;   // by requirement: the MonitorResult of the step; NULL: the run has no requirements
    const double *recorded;   // by @compare: the recorded value; NaN: there is none.  NULL: the script has no data
    const State *const *states;       // for an application, by machine: the state that the step ran, or its next step will run; else NULL
    const Program *program;
} ScriptStep;

// Adds a note to d, which a run of the script has reported, if its position is in a file that the script includes.
void script_note_include(Diags *diags, const Script *s, Diag *d);

// ---- what @compare has found ----

enum { COMPARE_SPANS_MAX = 8 };

typedef struct ComparePoint {
    uint64_t g, row, line;    // G of the step; the number of the row in the file, and the line in which the row begins
    double element, recorded, difference;         // the element's value, the recorded one, and the magnitude of their difference
} ComparePoint;

typedef struct CompareSpan { uint64_t from, to; } CompareSpan;       // G of the first and the last of successive steps

typedef struct CompareResult {
    uint64_t steps, failed;   // number of steps in which the @compare was evaluated; of those, number in which it was not met
    bool differs;             // the @compare was not met in the last step in which it was evaluated
    ComparePoint first, worst;        // if failed > 0: the first step in which it was not met; that with the largest difference
    uint64_t spans;           // number of intervals of G in which it was not met
    CompareSpan span[COMPARE_SPANS_MAX];          // the first of these intervals, at most COMPARE_SPANS_MAX
} CompareResult;

// Appends the intervals in which a @compare was not met: "G = 40 to 80, G = 200".
void compare_write_spans(const CompareResult *c, Buf *out);

typedef struct ScriptOptions {
    uint64_t max_steps;
    const uint64_t *seed;     // seed of the random numbers, at most SCRIPT_SEED_MAX; NULL: the script's own seed
    void (*after_step)(void *context, const ScriptStep *step);      // called after each step, before its asserts are evaluated; or NULL
    void *context;            // passed to after_step and is_cancelled
    bool (*is_cancelled)(void *context);      // called after each step that does not end the run; or NULL
    const ScriptSetting *setting;     // parameters that have another value in this run; `settings` of them
    size_t settings;
    const Requirements *requirements;         // judged after each step; NULL: none
    const uint8_t *ignored;   // by requirement: 1: this run does not judge it (baseline.h); NULL: it judges all
    bool is_silent;           // no diagnostics are reported: the caller reads only the result
    bool continues;           // a failed assert does not end the run, and neither it nor a violated requirement makes the run SCRIPT_FAILED
    bool ends_at_violation;   // a violated requirement ends the run, and the asserts of its step are not evaluated
    bool is_compared;         // the caller compares or displays the report or trace, so a script without asserts is not reported
} ScriptOptions;

// What a run has decided about a requirement.
typedef struct RequirementRun {
    uint64_t judged;          // number of steps that could have violated the requirement
    uint64_t violations;      // number of steps that violated it
    uint64_t first_step, first_g, last_step, last_g;  // if violations > 0: numbers and G of the first of these steps and of the last one
    bool undecided;           // no step violated it, and it was undecided when the run ended
    uint64_t since;           // if undecided: G from which its time counts
} RequirementRun;

typedef struct ScriptResult {
    ScriptOutcome outcome;
    uint64_t steps;
    bool is_random;           // the script has random numbers, with `seed`
    uint64_t seed;
    uint64_t asserts_passed;
    uint64_t *cell;           // the final values, by variable
    const char *printed;      // the lines that @print has shown; "": none
    const uint64_t *evaluated;        // by number of the assert (its index in the order of the script): how often it was evaluated
    const uint8_t *undecided; // by number of the assert: 1 for an @expect that was neither met nor failed when the run ended
    const ScriptAssert *failed;       // the first assert that was not met; NULL: none, then SCRIPT_FAILED means a violated requirement or a @compare
    uint64_t failures;        // how many times an assert was not met; at most 1 unless ScriptOptions.continues
    const uint8_t *failed_asserts;    // by number of the assert: 1 if it was not met at least once
    uint64_t failed_step, failed_g;   // number and G of the step after which `failed` was not met
    bool is_violated;         // a requirement was violated; a run that reaches its @stop is then SCRIPT_FAILED
    const RequirementRun *requirement;        // by requirement; NULL: the run had no requirements
    const uint64_t *ran;      // by State.number - 1: number of the last step that ran the state; 0: none
    const CompareResult *compare;     // by @compare of [data]; NULL: the script has no data, or it could not be read
    const char *data_file;    // the file with recorded data; NULL: none, or it could not be read
    uint64_t data_first_bad_line;     // number of the line with the first row that was skipped
    uint64_t data_rows, data_bad_rows, data_between;  // number of data rows that were read; of skipped rows; of rows
                                                      // between two steps, which no step used
    bool data_ended;          // with `delta_t file`: the last row has been reached without a @stop
    const char *difference;   // SCRIPT_DIFFERENT, SCRIPT_BROKEN: description and location
} ScriptResult;

// Whether the run reached a @stop, even if a requirement was violated or recorded values differ.
bool script_has_stopped(const ScriptResult *r);

// What all runs of a call have decided about a requirement.
typedef struct RequirementTotal {
    uint64_t judged;          // number of steps of all runs that could have violated it
    uint32_t scripts;         // number of runs that contain such a step
    uint32_t violated, undecided;     // number of runs that violated it; that left it undecided
} RequirementTotal;

// Adds the results of a run to `total`, the results of earlier runs; both are by requirement.
void requirement_add_run(RequirementTotal *total, const Requirements *what, const ScriptResult *r);
// Sets visited[State.number - 1] for each state that the run entered.
void requirement_add_visits(bool *visited, const Program *p, const ScriptResult *r);
// Returns the states that the conditions of a requirement name and that were not visited: "Hold, Burn"; "": it names no such state.
const char *requirement_unvisited(Arena *arena, const Requirement *what, const Program *p, const bool *visited);
// Returns the result as a word: "violated", "undecided", "never judged" or "met".
const char *requirement_verdict(const RequirementTotal *t);
// Warns of requirements that no run has judged.
void requirement_report_unjudged(Diags *diags, const Requirements *what, const RequirementTotal *total);

// Runs the engines in lock step on one script.  The values of the first engine decide guards and asserts.  A failed assert, an
// assert that was never evaluated and other failures are reported to `diags`.
ScriptResult script_run(Arena *arena, Diags *diags, const Script *s, Engine **engine, size_t engines, const ScriptOptions *o);

// Appends the report of a run: the number of steps and of passed asserts, the rows of recorded data, then the final value of each variable.
void script_report(const ScriptResult *r, const Program *p, Buf *out);
// Appends a sentence about the rows of the recorded data, without a full stop.  r->data_file is not NULL.
void script_write_rows(const ScriptResult *r, Buf *out);
// Append a cell (the bits of a value in its type): rounded, as in the report; and with floats in hexadecimal, as in an exact trace.
void format_cell_rounded(Buf *out, SmType type, uint64_t cell);
void format_cell_exact(Buf *out, SmType type, uint64_t cell);
// Append a value with the fewest digits that read back as the same double.
void format_cell_shortest(Buf *out, SmType type, uint64_t cell);
void format_number_shortest(Buf *out, double x);
// Appends a value with the fewest digits that are the same value once they are stored in the type: 0.1 for an F32.
void format_cell_stored(Buf *out, SmType type, uint64_t cell);

// Returns the variables in the order of reports and traces; allocated in `arena`.
const Var **report_order(Arena *arena, const Program *p);

// ---- script_reads.c ----

// Mark the variables that a script, or a set of requirements, reads.  reads: by Var.index, of the machine and the locals of the script.
void script_mark_reads(const Script *s, bool *reads);
void requirements_mark_reads(const Requirements *rq, bool *reads);

// ---- script_trace.c ----

// CSV: a header, then one row for each step: the script, the step, G, the name of the state, and the columns.  A bool is written as 1
// or 0, which every reader accepts as a number.  A column with the name of one of these first columns is called MACHINE.NAME.  Of an
// application, a column for each machine, with its name, takes the place of the state.
// With the requirements `rq` of the run, a last column `violated` has the ids of the requirements that the step has violated.  NULL: none.
void script_trace_header(Buf *out, const Program *p, const Var *const *column, size_t n, const Requirements *rq);
void script_trace_row(Buf *out, const char *script, const ScriptStep *step, const Var *const *column, size_t n, const Requirements *rq);
// Appends a line `STEP NAME VALUE` for each variable of `order`.  Floats are printed as C99 %a, which is exact.
void script_trace_exact(Buf *out, const ScriptStep *step, const Var *const *order, size_t n);

#endif
