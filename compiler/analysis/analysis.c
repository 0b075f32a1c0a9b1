// SPDX-License-Identifier: Apache-2.0
// Runs all analyses.  Contains the functions that they share.
#include "compiler/analysis/analysis.h"

#include <string.h>

// ---- comparisons ----

SmOperator relation_opposite(SmOperator op)
{
    switch ((int)op) {
    case SM_OP_LT: return SM_OP_GE;
    case SM_OP_LE: return SM_OP_GT;
    case SM_OP_GT: return SM_OP_LE;
    case SM_OP_GE: return SM_OP_LT;
    case SM_OP_EQ: return SM_OP_NE;
    default: return SM_OP_EQ;
    }
}

SmOperator relation_mirrored(SmOperator op)
{
    switch ((int)op) {
    case SM_OP_LT: return SM_OP_GT;
    case SM_OP_LE: return SM_OP_GE;
    case SM_OP_GT: return SM_OP_LT;
    case SM_OP_GE: return SM_OP_LE;
    default: return op;
    }
}

// ---- statements ----

// Recursion depth equals the nesting of conditionals, which AST_DEPTH_MAX bounds.
static void each_in(const Stmts *stmts, void (*f)(const Stmt *stmt, void *context), void *context)
{
    for (size_t i = 0; i < stmts->n; i++) {
        f(stmts->at[i], context);
        each_in(&stmts->at[i]->then, f, context);
        each_in(&stmts->at[i]->otherwise, f, context);
    }
}

void each_stmt(const Program *p, void (*f)(const Stmt *stmt, void *context), void *context)
{
    for (size_t i = 0; i < p->state.n; i++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            each_in(&p->state.at[i]->block[b], f, context);
}

// ---- facts of statements ----

void each_flow(Analysis *a, void (*f)(Analysis *a, const FlowPlace *at, void *context), void *context)
{
    for (size_t s = 0; s < a->p->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++) {
            FlowPlace at = {a->p->state.at[s], (BlockKind)b, a->m->state.at[s].block[b], {NULL, NULL, NULL}};
            if (!at.f || !facts_may_reach(a->facts, s, b))
                continue;
            at.flow = facts_of_function(a->facts, at.f, facts_begin(a->facts, s, b));
            f(a, &at, context);
        }
}

// The fact of the stored value before its conversion.  The conversion is one instruction, or none for a bool.
static Fact stored(const IrFn *f, const FactFlow *flow, const IrIns *store)
{
    const IrIns *value = &f->ins.at[store->a];

    return flow->of[value->op == IR_cvt ? value->a : store->a];
}

static bool is_large(Fact f) { return f.lo >= FACT_EXACT || f.hi <= -FACT_EXACT; }

static void note_ins(Analysis *a, const IrFn *f, const FactFlow *flow, const IrIns *i)
{
    if (i->op == IR_add || i->op == IR_sub)
        a->large_sums |= is_large(flow->of[i->a]) || is_large(flow->of[i->b]);
    if (i->op != IR_store)
        return;
    a->stmt[i->stmt].reached = true;
    a->stmt[i->stmt].value = stored(f, flow, i);
}

static void note_jump(Analysis *a, const FactFlow *flow, const IrJump *j, const FactExit *exit)
{
    StmtFact *s = &a->stmt[j->stmt];

    if (j->kind != IR_BR && j->kind != IR_GOTO)
        return;
    s->reached = true;
    s->env = exit->env;
    if (j->kind == IR_GOTO)
        return;
    s->then = exit->then;
    s->otherwise = exit->otherwise;
    s->value = fact_meet(flow->of[j->cond], fact_of_bool(s->otherwise, s->then));
}

// May be called several times for one function, each time with everything reached so far.  The last call is final.
static void note_flow(void *context, const IrFn *f, FactFlow flow)
{
    Analysis *a = context;

    for (size_t b = 0; b < f->blk.n; b++) {
        const IrBlk *blk = &f->blk.at[b];
        if (!flow.reached[b])
            continue;
        for (size_t k = 0; k < blk->ins.n; k++)
            note_ins(a, f, &flow, &f->ins.at[blk->ins.at[k]]);
        note_jump(a, &flow, &blk->jump, &flow.exit[b]);
    }
}

// ---- entry points ----

static void forget_flows(void *context)
{
    Analysis *a = context;

    memset(a->stmt, 0, (a->p->stmts + 1u) * sizeof *a->stmt);
    a->large_sums = false;
}

static void begin(Analysis *a, Arena *arena, Diags *diags, const IrMachine *m)
{
    const FactWatch notes = {note_flow, forget_flows, a};
    const Program *p = m->program;

    memset(a, 0, sizeof *a);
    a->groups = DIAG_GROUPS_ALL;
    a->arena = arena;
    a->diags = diags;
    a->p = p;
    a->m = m;
    a->stmt = ARENA_ARRAY(arena, StmtFact, p->stmts + 1u);
    a->asked = ARENA_ARRAY(arena, const IrFn *, p->stmts + 1u);
    a->facts = facts_from_first_state(arena, m, &notes);
    a->transition = transitions_of(arena, p);
}

void analysis_begin(Analysis *a, Arena *arena, Diags *diags, const Program *p)
{
    begin(a, arena, diags, ir_build(arena, p));
}

static void work_in(Analysis *a, Arena *arena)
{
    a->arena = arena;
    facts_set_arena(a->facts, arena);
    if (a->asked[0])
        memset(a->asked, 0, (a->p->stmts + 1u) * sizeof *a->asked);  // these functions were in the arena that was freed
}

typedef struct Row { void (*run)(Analysis *a); DiagGroup group; } Row;

void analyse_machine(Arena *arena, Arena *scratch, Diags *diags, const IrMachine *m, unsigned groups, uint64_t step)
{
    static const Row all[] = {
#define ANALYSIS(name, group, sentence) {analyse_##name, DIAG_GROUP_##group},
#include "compiler/analysis/analyses.def"
#undef ANALYSIS
    };
    Analysis a;

    begin(&a, arena, diags, m);
    a.groups = groups;
    a.step = step;
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        if (groups & 1u << all[i].group) {
            work_in(&a, scratch);
            all[i].run(&a);
            arena_free(scratch);
        }
}
