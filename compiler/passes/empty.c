// SPDX-License-Identifier: Apache-2.0
// empty: a state's function that does nothing is no function.  Needs nothing and breaks nothing: what is left stays as it is.
#include "compiler/passes/pass.h"

static bool does_nothing(const IrFn *f)
{
    return f->blk.n == 1 && f->blk.at[0].ins.n == 0 && f->blk.at[0].jump.kind == IR_RET;
}

void pass_empty(Arena *arena, IrMachine *m, FactMachine *values)
{
    (void)values;
    (void)arena;
    for (size_t s = 0; s < m->state.n; s++)
        for (int k = 0; k < BLOCK_COUNT; k++)
            if (m->state.at[s].block[k] && does_nothing(m->state.at[s].block[k]))
                m->state.at[s].block[k] = NULL;
}
