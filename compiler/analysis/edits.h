// SPDX-License-Identifier: Apache-2.0
// Edits that several analyses propose.  Each adds nothing where the text around it leaves doubt.
#ifndef SMC_EDITS_H
#define SMC_EDITS_H

#include "compiler/diag/diag.h"
#include "compiler/sema/program.h"

// Takes an assignment away: only one that has its line to itself and is not all that stands in its braces.
// `list`: the statements that it stands among; is_block: they are a label's, not a conditional's.
void edit_remove(Diags *diags, Diag *d, const Stmt *stmt, const Stmts *list, bool is_block);
// Writes @read_only behind the declaration of a local.
void edit_mark_read_only(Diags *diags, Diag *d, const Var *local);

#endif
