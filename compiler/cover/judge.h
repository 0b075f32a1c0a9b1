// SPDX-License-Identifier: Apache-2.0
// Places of a machine (things that coverage counts, cover.h) that no run can cover, according to facts (facts/facts.h).
#ifndef SMC_JUDGE_H
#define SMC_JUDGE_H

#include "compiler/cover/cover.h"
#include "compiler/facts/facts.h"

// Sets reason[place] to why no run covers the place; NULL: facts do not exclude it, or it has been covered.  The machine of `facts` is the machine
// of c, or a form of it whose functions have the same instructions and blocks, with more instructions after these.  `any_start`: runs can begin in
// any state.
void cover_judge_by_facts(const Cover *c, Arena *arena, FactMachine *facts, bool any_start, const char **reason);

#endif
