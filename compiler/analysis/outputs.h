// SPDX-License-Identifier: Apache-2.0
// Outputs that are switched on and off: elements that a machine writes and that drive something.
#ifndef SMC_OUTPUTS_H
#define SMC_OUTPUTS_H

#include "compiler/analysis/analysis.h"

// By Program.var: whether it is such an output.  A bool is.  A number is if it is only ever given constants, 0 among them, and
// is no code that tells what the machine is doing: three or more whole numbers close together.
bool *outputs_find(const Analysis *a);

bool may_be_on(Fact f);                       // a number other than 0
bool is_on(Fact f);                           // surely one

// The first statement of the list, conditionals included, that may switch v on (or, with `on` false, may switch it off).
const Stmt *outputs_switch(const Analysis *a, const Stmts *stmts, const Var *v, bool on);

#endif
