// SPDX-License-Identifier: Apache-2.0
// Recorded data in a run of a script (language.md 8.54 to 8.70): writes columns of a file to variables before each step, and compares variables
// with columns after it.
//
// The file is read once from start to end, one row ahead of the current step.  A @compare with a delay reads the file at earlier times, so each
// delay has its own cursor, which reads the file once more.  Memory does not grow with the number of rows.
#ifndef SMC_REPLAY_H
#define SMC_REPLAY_H

#include "compiler/script/script.h"

typedef struct Replay Replay;

// Reads the header of the data of a script.  Returns false after reporting what is wrong with the file.
bool replay_check(Arena *arena, Diags *diags, const Script *s);
// Opens the data of a script at its first row.  Returns NULL after reporting what is wrong with the file.
Replay *replay_open(Arena *arena, Diags *diags, const Script *s);
void replay_close(Replay *r);
// Reads on to the time g, which never decreases, and calls `write` for each column that has a value.  Returns false after an error, which is
// reported.
bool replay_advance(Replay *r, uint64_t g, void (*write)(void *context, const Var *v, double value), void *context);
// Compares variables with columns after the step at g.  cell: the values of the variables, by index.  Returns false after an error, which is
// reported.
bool replay_compare(Replay *r, uint64_t g, const uint64_t *cell);
// Returns the recorded values of the last replay_compare, by @compare; NaN: the variable was not compared.
const double *replay_recorded(const Replay *r);
// Replaces *g by the time of the first row after *g.  Returns false if no row follows.
bool replay_find_next_time(const Replay *r, uint64_t *g);
// Whether some @compare was not met in some step.
bool replay_differs(const Replay *r);
// Sets the results of the @compares, and the counts of rows.
void replay_set_result(const Replay *r, ScriptResult *result);
// Reports rows that were skipped, and if `judged`, the @compares that were not met or never evaluated.  `result`: that of the run.
void replay_report(const Replay *r, bool judged, const ScriptResult *result);

#endif
