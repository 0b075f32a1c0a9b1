// SPDX-License-Identifier: Apache-2.0
// Runs all analyses.
#include "compiler/analysis/analysis.h"

void analyse_program(Arena *arena, Diags *diags, const Program *p)
{
    analyse_reach(arena, diags, p);
    analyse_unused(arena, diags, p);
}
