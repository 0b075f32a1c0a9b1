// SPDX-License-Identifier: Apache-2.0
// Analyses: what looks wrong in a machine that is no error.  They read a Program, report warnings and change nothing.
#ifndef SMC_ANALYSIS_H
#define SMC_ANALYSIS_H

#include "compiler/diag/diag.h"
#include "compiler/sema/program.h"

// All of them.  `arena` holds their work.
void analyse_program(Arena *arena, Diags *diags, const Program *p);

void analyse_reach(Arena *arena, Diags *diags, const Program *p);      // states and code to which no way leads
void analyse_unused(Arena *arena, Diags *diags, const Program *p);     // elements and locals that nobody needs

void analyse_values(Arena *arena, Diags *diags, const Program *p);     // constants that do not fit, comparisons decided by types

// Calls f for every statement of a machine, those inside conditionals after the conditional itself.
void each_stmt(const Program *p, void (*f)(const Stmt *stmt, void *context), void *context);

#endif
