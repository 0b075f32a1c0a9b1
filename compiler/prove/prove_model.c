// SPDX-License-Identifier: Apache-2.0
#include "compiler/prove/prove_model.h"

#include "compiler/base/bitset.h"
#include "compiler/prove/prove_make.h"

// ---- variables ----

// Returns the fact of a local at the start: its initial value, or all values to which the parameter can be set.
static Fact fact_of_initial_value(const IrVar *v)
{
    const Parameter *p = v->parameter;
    Fact f = fact_of_type(v->type);

    if (!p)
        return fact_of_cell(v->type, v->init);
    if (p->lo > f.lo)
        f.lo = p->lo;
    if (p->hi < f.hi)
        f.hi = p->hi;
    return f;
}

// Adds the machine's variables to the model, by what sets them: time, the machine itself, or its inputs.
static void add_machine_vars(ProveMaker *k)
{
    for (uint32_t v = 0; v < k->m->var.n; v++) {
        const IrVar *from = &k->m->var.at[v];
        const bool is_time = v == k->m->g || v == k->m->s || v == k->m->t;
        const bool is_local = from->space == IR_LOCAL && !from->outside;
        const ProveVarKind kind = is_time ? PROVE_TIME : is_local ? PROVE_KEPT : from->writable && !from->outside ? PROVE_OUTPUT : PROVE_INPUT;
        const uint32_t made = prove_add_var(k, from->type, kind, is_local ? fact_of_initial_value(from) : fact_of_type(from->type));
        k->model->ir->var.at[made].space = from->space;
        k->model->ir->var.at[made].name = from->name;
        k->model->var[made].stored = from->writable;
    }
}
// Copies a function of the machine, and continues after it: in block `ret` where it ends, in block `go` after its transitions.
// Returns its first block.
static IrBlkRef copy_function(ProveMaker *k, const IrFn *from, IrBlkRef ret, IrBlkRef go)
{
    IrRef *copy;
    IrBlkRef first;

    if (!from)
        return ret;
    copy = prove_new_copies(k, from);
    first = k->f->blk.n;
    for (uint32_t b = 0; b < from->blk.n; b++)
        prove_new_block(k);
    for (uint32_t b = 0; b < from->blk.n; b++) {
        const IrJump *j = &from->blk.at[b].jump;
        k->b = first + b;
        prove_copy_block(k, from, &from->blk.at[b], copy);
        if (j->kind == IR_GOTO)
            prove_emit_set(k, k->model->next, j->state);
        if (j->kind == IR_BR)
            prove_branch_from(k, k->b, copy[j->cond], first + j->then, first + j->otherwise);
        else
            prove_jump_from(k, k->b, j->kind == IR_JMP ? first + j->then : j->kind == IR_GOTO ? go : ret);
    }
    return first;
}

// ---- a step ----

// Appends the blocks that can be reached from b, each before its predecessors.
static void order_blocks(const IrFn *f, IrBlkRef b, bool *visited, ProveStep *s)
{
    const IrJump *j = &f->blk.at[b].jump;

    if (visited[b])
        return;
    visited[b] = true;
    if (j->kind == IR_JMP || j->kind == IR_BR)
        order_blocks(f, j->then, visited, s);
    if (j->kind == IR_BR)
        order_blocks(f, j->otherwise, visited, s);
    s->order[s->blocks++] = b;
}

// Adds the variables that a block loads to the set `live`.
static void add_loads(const IrFn *f, const IrBlk *b, uint64_t *live)
{
    for (uint32_t n = 0; n < b->ins.n; n++)
        if (f->ins.at[b->ins.at[n]].op == IR_load)
            bitset_add(live, f->ins.at[b->ins.at[n]].var);
}

// Splits the blocks of the step into branches, and finds the variables that are live in each.
static ProveStep *finish_step(ProveMaker *k)
{
    ProveStep *s = ARENA_NEW(k->arena, ProveStep);
    const size_t words = bitset_words(k->model->ir->var.n);

    s->fn = k->f;
    s->block = ARENA_ARRAY(k->arena, ProveBlock, k->f->blk.n);
    s->order = ARENA_ARRAY(k->arena, IrBlkRef, k->f->blk.n);
    order_blocks(k->f, 0, ARENA_ARRAY(k->arena, bool, k->f->blk.n), s);
    for (uint32_t n = 0; n < s->blocks; n++) {
        const IrBlk *b = &k->f->blk.at[s->order[n]];
        ProveBlock *to = &s->block[s->order[n]];
        to->end = k->end.at[s->order[n]];
        to->live = ARENA_ARRAY(k->arena, uint64_t, words);
        prove_split_block(k, to, k->f, b);
        add_loads(k->f, b, to->live);
        if (b->jump.kind == IR_JMP || b->jump.kind == IR_BR)
            bitset_merge(to->live, s->block[b->jump.then].live, words);
        if (b->jump.kind == IR_BR)
            bitset_merge(to->live, s->block[b->jump.otherwise].live, words);
    }
    for (uint32_t n = 0; n < s->blocks / 2; n++) {
        const IrBlkRef swap = s->order[n];
        s->order[n] = s->order[s->blocks - 1 - n];
        s->order[s->blocks - 1 - n] = swap;
    }
    return s;
}

// Emits the samples of the machine and its functions, and makes the block after them the current one.
static void run_machine(ProveMaker *k, const IrState *s, bool first)
{
    IrBlkRef judge, leave, step, sampled;

    prove_sample_windows(k, 0, k->of_machine);
    sampled = k->b;
    judge = prove_new_block(k);
    leave = copy_function(k, s->block[BLOCK_EXIT], judge, judge);
    step = copy_function(k, s->block[BLOCK_STEP], judge, leave);
    prove_jump_from(k, sampled, first ? copy_function(k, s->block[BLOCK_ENTRY], step, leave) : step);
    k->b = judge;
}

// Makes the function of one step in this state, with the code that then judges the requirement.
static ProveStep *make_step(ProveMaker *k, size_t state, bool first)
{
    k->f = ARENA_NEW(k->arena, IrFn);
    k->end.n = 0;
    k->b = prove_new_block(k);
    for (uint32_t n = k->of_both; n < k->windows; n++)
        k->window[n].is_sampled = false;
    if (state < k->m->state.n)
        run_machine(k, &k->m->state.at[state], first);
    prove_sample_windows(k, k->of_machine, k->of_both);
    prove_judge_requirement(k);
    return finish_step(k);
}

const ProveStep *prove_model_step(ProveModel *p, size_t state, bool first)
{
    ProveStep **s = &p->step[state][first];

    if (!*s)
        *s = make_step(p->maker, state, first);
    return *s;
}

// ---- the model ----

// Builds the IR of the requirement's conditions.
static void build_conditions(ProveMaker *k)
{
    const Requirement *r = k->model->what;
    const IrMachine named = {.program = k->m->program, .var_of = k->m->var_of, .window_of = k->window_of};
    const Expr *const of[3] = {r->a, r->b, r->c};

    for (int c = 0; c < 3; c++)
        k->condition[c] = of[c] ? ir_build_guard(k->arena, &named, of[c]) : NULL;
}

// Slices the machine, and marks the variables.
static void slice_machine(ProveMaker *k)
{
    ProveModel *p = k->model;
    const bool *relevant = prove_slice(k);

    p->machine = k->m;
    for (uint32_t v = 0; v < k->m->var.n; v++) {
        p->var[v].relevant = relevant[v];
        if (relevant[v] || p->var[v].kind == PROVE_TIME)
            continue;
        p->var[v].kind = PROVE_IRRELEVANT;
        p->var[v].stored = false;
    }
}

// Adds the variables that only the model has, such as the state of the requirement.
static void add_own_vars(ProveMaker *k)
{
    ProveModel *p = k->model;

    p->next = prove_add_var(k, SM_F64, PROVE_CHOICE, prove_fact_of_number(0));
    p->premise = prove_add_var(k, SM_F64, PROVE_CHOICE, prove_fact_of_number(0));
    k->sampled = prove_add_var(k, SM_F64, PROVE_KEPT, prove_fact_of_number(0));
    k->seen = prove_add_var(k, SM_F64, PROVE_KEPT, prove_fact_of_number(0));
    k->open = prove_add_var(k, SM_F64, PROVE_KEPT, prove_fact_of_number(0));
    k->age = prove_add_var(k, SM_F64, PROVE_KEPT, prove_fact_of_number(0));
    k->offset = prove_add_var(k, SM_F64, PROVE_KEPT, prove_fact_of_number(0));
    p->var[k->sampled].few = p->var[k->seen].few = p->var[k->open].few = true;
}

ProveModel *prove_model_new(Arena *arena, const IrMachine *m, const Requirements *all, const Requirement *what, uint64_t delta_t, ProveLoosening loose,
                            const uint32_t *equal)
{
    ProveModel *p = ARENA_NEW(arena, ProveModel);
    ProveMaker *k = ARENA_NEW(arena, ProveMaker);

    *p = (ProveModel){.arena = arena, .machine = m, .what = what, .delta_t = delta_t, .ir = ARENA_NEW(arena, IrMachine), .maker = k};
    p->step = arena_array(arena, m->state.n + 1, sizeof *p->step);
    k->model = p;
    k->arena = arena;
    k->m = m;
    k->equal = equal;
    p->ir->g = m->g;
    p->ir->s = m->s;
    p->ir->t = m->t;
    add_machine_vars(k);
    prove_merge_windows(k, all);
    build_conditions(k);
    prove_find_samples(k, loose);
    if (loose == PROVE_COMPARED)
        prove_compare_samples(k);
    slice_machine(k);
    prove_add_windows(k);
    add_own_vars(k);
    if (loose == PROVE_RELATED)
        prove_add_pairs(k);
    return p;
}
