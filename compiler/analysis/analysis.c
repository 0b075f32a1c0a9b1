// SPDX-License-Identifier: Apache-2.0
// Runs all analyses.  Contains the functions that the analyses share.
#include "compiler/analysis/analysis.h"

#include <string.h>

// ---- comparisons ----

uint32_t comparison_count(const Expr *e)
{
    if (e->kind == EX_CHAIN)
        return e->n - 1;
    return e->kind == EX_BINARY && (COMPARISONS >> e->op & 1) != 0 ? 1 : 0;
}

Comparison comparison_at(const Expr *e, uint32_t i)
{
    return (Comparison){e->arg[i], e->arg[i + 1], e->kind == EX_CHAIN ? expr_ops(e)[i] : e->op};
}

// Returns the operator that is true exactly if `op` is false, when no operand is NaN.
SmOperator comparison_negated(SmOperator op)
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

// Returns the operator for exchanged operands: > for <.
SmOperator comparison_swapped(SmOperator op)
{
    switch ((int)op) {
    case SM_OP_LT: return SM_OP_GT;
    case SM_OP_LE: return SM_OP_GE;
    case SM_OP_GT: return SM_OP_LT;
    case SM_OP_GE: return SM_OP_LE;
    default: return op;
    }
}

// Returns the possible results of `a op b`, as the fact of a bool.
Fact fact_of_comparison(SmOperator op, Fact a, Fact b)
{
    const IrIns i = {.op = ir_op_of_operator(op), .type = SM_BOOL};

    return fact_of_result(&i, &a, &b, SM_F64);
}

// ---- statements ----

// Calls f for each statement of a list and those inside it.  AST_DEPTH_MAX bounds the nesting of conditionals and so the recursion depth.
static void each_stmt_in(const Stmts *stmts, void (*f)(const Stmt *stmt, void *context), void *context)
{
    for (size_t i = 0; i < stmts->n; i++) {
        f(stmts->at[i], context);
        each_stmt_in(&stmts->at[i]->then, f, context);
        each_stmt_in(&stmts->at[i]->otherwise, f, context);
    }
}

// Calls f for every statement of a machine.
void each_stmt(const Program *p, void (*f)(const Stmt *stmt, void *context), void *context)
{
    for (size_t i = 0; i < p->state.n; i++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            each_stmt_in(&p->state.at[i]->block[b], f, context);
}

// ---- facts of statements ----

void each_reachable_fn(Analysis *a, void (*f)(Analysis *a, const ReachableFn *r, void *context), void *context)
{
    for (size_t s = 0; s < a->p->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++) {
            ReachableFn r = {a->p->state.at[s], (BlockKind)b, a->m->state.at[s].block[b], {NULL, NULL, NULL}};
            if (!r.fn || !facts_may_reach(a->facts, s, b))
                continue;
            r.flow = facts_of_block(a->facts, s, b);
            f(a, &r, context);
        }
}

// Whether every number that the fact allows has a magnitude of 2^53 or more.
static bool is_large(Fact f) { return f.lo >= FACT_EXACT || f.hi <= -FACT_EXACT; }

// Stores the facts about each statement of a function in a->stmt.
static void record_flow(Analysis *a, const ReachableFn *r, void *context)
{
    const IrFn *f = r->fn;
    const FactFlow flow = r->flow;

    (void)context;
    for (size_t b = 0; b < f->blk.n; b++) {
        const IrBlk *blk = &f->blk.at[b];
        const IrJump *j = &blk->jump;
        StmtFact *s = &a->stmt[j->stmt];
        if (!flow.reached[b])
            continue;
        for (size_t k = 0; k < blk->ins.n; k++) {
            const IrIns *i = &f->ins.at[blk->ins.at[k]];
            if (i->op == IR_add || i->op == IR_sub)
                a->large_sums |= is_large(flow.of[i->a]) || is_large(flow.of[i->b]);
            if (i->op == IR_store) {
                const IrIns *value = &f->ins.at[i->a];
                a->stmt[i->stmt].reached = true;
                a->stmt[i->stmt].value = flow.of[value->op == IR_cvt ? value->a : i->a];     // the value before its conversion
            }
        }
        if (j->kind != IR_BR && j->kind != IR_GOTO)
            continue;
        s->reached = true;
        s->state = r->state->number - 1;
        s->block = r->block;
        if (j->kind == IR_BR) {
            s->then = flow.exit[b].then;
            s->otherwise = flow.exit[b].otherwise;
            s->value = fact_meet(flow.of[j->cond], fact_of_bool(s->otherwise, s->then));
        }
    }
}

StmtFact *analysis_facts_in_states(const Analysis *a)
{
    Analysis in_states = *a;

    in_states.stmt = ARENA_ARRAY(a->arena, StmtFact, a->p->stmts + 1u);
    for (size_t s = 0; s < a->p->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++) {
            ReachableFn r = {a->p->state.at[s], (BlockKind)b, a->m->state.at[s].block[b], {NULL, NULL, NULL}};
            const Env *begin;
            if (!r.fn || !facts_may_reach(a->facts, s, b))
                continue;
            begin = env_set(&a->facts->shape, facts_at_begin(a->facts, s, b), a->m->s, fact_of_cell(SM_U32, s + 1));
            r.flow = facts_of_function(a->facts, r.fn, begin);
            record_flow(&in_states, &r, NULL);
        }
    return in_states.stmt;
}

// Sets StmtFact.env of all guards and transitions of a function.
static void find_envs(const Analysis *a, uint32_t state, BlockKind block)
{
    static const FactEnds ends = {.exits = true};
    const IrFn *f = a->m->state.at[state].block[block];
    FactFlow flow;

    facts_set_arena(a->facts, a->kept);
    flow = facts_flow(a->facts, f, facts_at_begin(a->facts, state, (int)block), &ends);
    for (size_t b = 0; b < f->blk.n; b++) {
        const IrJump *j = &f->blk.at[b].jump;
        if (flow.reached[b] && (j->kind == IR_BR || j->kind == IR_GOTO)) {
            a->stmt[j->stmt].env = flow.exit[b].env;
            a->stmt[j->stmt].has_env = true;
        }
    }
    facts_set_arena(a->facts, a->arena);
}

bool expr_reads(const Expr *e, const Var *v)
{
    bool reads = e->kind == EX_VAR && e->var == v;

    for (uint32_t i = 0; i < e->n && !reads; i++)
        reads = expr_reads(e->arg[i], v);
    return reads;
}

const Env *env_of_stmt(const Analysis *a, const Stmt *stmt)
{
    const StmtFact *s = &a->stmt[stmt->number];

    if (s->reached && !s->has_env)
        find_envs(a, s->state, s->block);
    return s->env;
}

// ---- entry points ----

// Fills in *a for a machine whose IR has been built: computes its facts and lists its transitions.  Reports nothing.
static void begin_on_ir(Analysis *a, Arena *arena, Diags *diags, const IrMachine *m)
{
    const Program *p = m->program;

    memset(a, 0, sizeof *a);
    a->groups = DIAG_GROUPS_ALL;
    a->arena = a->kept = arena;
    a->diags = diags;
    a->p = p;
    a->m = m;
    a->stmt = ARENA_ARRAY(arena, StmtFact, p->stmts + 1u);
    a->facts = facts_from_first_state(arena, m);
    each_reachable_fn(a, record_flow, NULL);
    a->transition = transitions_of(arena, p);
}

// Fills in *a for a machine: builds its IR, computes its facts and lists its transitions.
void analysis_begin(Analysis *a, Arena *arena, Diags *diags, const Program *p)
{
    begin_on_ir(a, arena, diags, ir_build(arena, p));
}

void analyse_machine(Arena *arena, Arena *scratch, Diags *diags, const IrMachine *m, unsigned groups, uint64_t step, bool pauses,
                     AnalysisSearch *search)
{
    static const struct { void (*run)(Analysis *a); DiagGroup group; } all[] = {
#define ANALYSIS(name, group, sentence) {analyse_##name, DIAG_GROUP_##group},
#include "compiler/analysis/analyses.def"
#undef ANALYSIS
    };
    const size_t first = diags->list.n;
    Analysis a;

    begin_on_ir(&a, arena, diags, m);
    a.groups = groups;
    a.step = step;
    a.pauses = pauses;
    a.search = search;
    a.arena = scratch;
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        if (groups & 1u << all[i].group) {
            facts_set_arena(a.facts, scratch);
            all[i].run(&a);
            arena_free(scratch);
        }
    complete_all_states_findings(&a, first);
    arena_free(scratch);
}
