// SPDX-License-Identifier: Apache-2.0
// Internal to the comparison of two machines: what its files share.
#ifndef SMC_DIFF_PART_H
#define SMC_DIFF_PART_H

#include "compiler/analysis/transitions.h"
#include "compiler/diff/diff.h"

// How statements of one machine are written so that equal texts mean equal behaviour: names are those of the new machine, constants are their
// values, windows are what they sample.  Types of variables are not in it: compare_variables reports those that differ.
typedef struct Canon {
    const Program *p;
    const char **var;             // by Var.index: the canonical name of the variable
    const char **state;           // by State.number: the canonical name of the state
    bool keeps_numbers;           // every state that both machines have has the same number in both
    const char *side;             // "old" or "new": added to a text that depends on the number of a state, so that the two sides never seem equal
} Canon;

void canon_expr(const Canon *c, const Expr *e, Buf *out);
void canon_stmt(const Canon *c, const Stmt *s, Buf *out);
void canon_stmts(const Canon *c, const Stmts *list, Buf *out);
void canon_state(const Canon *c, const State *s, Buf *out);       // the statements of all its blocks
const char *canon_condition(Arena *arena, const Canon *c, const Condition *when);

// ---- diff_match.c ----

// Matches states and variables, and adds what is renamed, added or removed.  Fills in `canon`: of the old machine, and of the new one.
void diff_match(ProgramDiff *d, Canon canon[2]);

// ---- diff_code.c ----

// Whether the optimised code of two states is the same under the match of states and variables.  True proves the same behaviour.
bool diff_same_code(const ProgramDiff *d, const State *old, const State *new);

// ---- diff_guard.c ----

// Returns what a changed condition means if that is provable: "weaker: also true when 800 < p <= 825"; NULL: nothing is known.
const char *diff_compare_guards(const ProgramDiff *d, const Canon canon[2], const Condition *old, const Condition *new);

// ---- diff_define.c ----

// Adds the definitions that were added, removed or changed.
void diff_compare_defines(ProgramDiff *d);
// Returns why a statement of the old machine that is written as before means something else: the changed definitions that it uses.
const char *diff_describe_defines(ProgramDiff *d, const Stmt *stmt, const Condition *when);

// ---- diff.c ----

void diff_add(ProgramDiff *d, DiffChange change);

#endif
