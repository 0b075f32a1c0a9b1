// SPDX-License-Identifier: Apache-2.0
// An expression as it is in one state: what is left of it when S is known.
#ifndef SMC_STATE_REST_H
#define SMC_STATE_REST_H

#include "compiler/sema/program.h"

// Returns what the value of e depends on in the state, as written, on one line: of `(S == Fill or S == Vent) and not igniter`, in Fill,
// "not igniter". Only operands of `and`, `or` and `not` that S decides are left out.
const char *state_rest(Arena *arena, const Program *p, const State *state, const Expr *e);

#endif
