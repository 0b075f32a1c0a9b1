// SPDX-License-Identifier: Apache-2.0
// Proves that a mutant is equivalent: facts (facts.h) exclude every path to the cases in which it differs.
#include "compiler/cover/mutant_cases.h"
#include "compiler/facts/facts.h"

// Whether a statement is one of the probes.
static bool is_probe(const MutantCases *cases, uint32_t stmt)
{
    for (uint32_t i = 0; i < cases->at.n; i++)
        if (cases->at.at[i].probe == stmt)
            return true;
    return false;
}

// Whether the function contains a probe on a path that facts allow.
static bool may_execute(FactMachine *facts, const IrFn *f, const Env *begin, const MutantCases *cases)
{
    const FactFlow flow = facts_of_function(facts, f, begin);

    for (uint32_t b = 0; b < f->blk.n; b++)
        for (uint32_t i = 0; flow.reached[b] && i < f->blk.at[b].ins.n; i++)
            if (is_probe(cases, f->ins.at[f->blk.at[b].ins.at[i]].stmt))
                return true;
    return false;
}

// Whether the facts allow a probe to be executed in any state.
static bool may_reach_probe(Arena *work, const Program *p, const MutantCases *cases)
{
    const IrMachine *m = ir_build(work, p);
    FactMachine *facts = facts_of_machine(work, m);

    for (size_t s = 0; s < m->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            if (m->state.at[s].block[b] && may_execute(facts, m->state.at[s].block[b], facts_at_begin(facts, s, b), cases))
                return true;
    return false;
}

bool mutant_is_equivalent(Arena *work, const Program *p, const MutantEdit *edit, uint64_t step)
{
    MutantCases cases = mutant_cases_list(work, p, edit, step);
    MutantProbes *probes;
    bool reached;

    if (cases.unknown || cases.at.n == 0)
        return !cases.unknown;
    if ((probes = mutant_probes_insert(work, p, &cases, true)) == NULL)
        return false;
    reached = may_reach_probe(work, &probes->program, &cases);
    mutant_probes_remove(probes);
    return !reached;
}
