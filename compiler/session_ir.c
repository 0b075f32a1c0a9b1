// SPDX-License-Identifier: Apache-2.0
#include <assert.h>

#include "compiler/passes/pass.h"
#include "compiler/pipeline.h"

IrMachine *session_ir(Session *s, const Program *p, int opt_level)
{
    IrMachine *m = ir_build(&s->arena, p);
    PassOptions o = {opt_level, NULL, true, NULL, NULL};
    const char *wrong = passes_run(&s->arena, m, &o);

    assert(!wrong);
    return wrong ? NULL : m;
}
