// SPDX-License-Identifier: Apache-2.0
// Studies a machine before a search: which inputs it has, where its decisions are, what stores its variables.
#include <string.h>

#include "compiler/ir/eval.h"
#include "compiler/search/search_run.h"
#include "stdlib/convert.h"

// ---- inputs ----

void search_default_inputs(const Program *p, bool *writable)
{
    for (uint32_t i = 0; i < p->var.n; i++) {
        const Var *v = p->var.at[i];
        writable[i] = v->kind == VAR_ELEMENT ? v != p->g && v != p->s && !v->written && v->read : v->kind == VAR_LOCAL && v->outside;
    }
}

static void find_inputs(SearchRun *k)
{
    bool *writable = arena_alloc(&k->work, k->p->var.n);

    if (k->o->writable)
        memcpy(writable, k->o->writable, k->p->var.n);
    else
        search_default_inputs(k->p, writable);
    k->input = arena_array(&k->work, k->p->var.n, sizeof *k->input);
    for (uint32_t v = 0; v < k->p->var.n; v++) {
        const Var *var = k->p->var.at[v];
        const uint32_t at = k->m->var_of[v];
        if (!writable[v] || at == IR_NONE || var == k->p->g || var == k->p->s || var == k->p->t)
            continue;
        k->var[at].input = k->inputs;
        k->input[k->inputs++] = (SearchInput){.var = v, .at = at, .type = var->type, .forced = var->written, .range = var->range};
    }
    for (uint32_t v = 0; v < k->p->var.n; v++)
        if (k->p->var.at[v]->written && k->m->var_of[v] != IR_NONE)
            vec_push(&k->work, &k->output, v);
    k->words = (k->inputs + 63) / 64 + 1;
}

// ---- functions and stores ----

// Returns by what a search can change the value of an instruction: a set of HANDLE_ bits, from its operands.
static uint8_t handle_of(const SearchRun *k, const SearchFn *s, const IrIns *i)
{
    uint8_t h = 0;

    if (i->op == IR_load)
        return k->var[i->var].input != SEARCH_NONE ? HANDLE_INPUT : i->var == k->m->g || i->var == k->m->t
               ? HANDLE_TIME : i->var == k->m->s ? 0 : HANDLE_VAR;
    if (i->op == IR_stat)
        return HANDLE_WINDOW | HANDLE_INPUT;
    if (i->op == IR_const || i->op == IR_store || i->op == IR_sample)
        return 0;
    if (i->a != IR_NONE)
        h |= s->handle[i->a];
    if (i->b != IR_NONE)
        h |= s->handle[i->b];
    return h;
}

// Finds of one function its stores, its constants, and by what the search can change the value of each instruction.
static void analyse_function(SearchRun *k, uint32_t n)
{
    SearchFn *s = &k->fn[n];

    s->handle = arena_alloc(&k->work, s->fn->ins.n + 1);
    for (uint32_t b = 0; b < s->fn->blk.n; b++)
        for (uint32_t at = 0; at < s->fn->blk.at[b].ins.n; at++) {
            const IrRef ref = s->fn->blk.at[b].ins.at[at];
            const IrIns *i = &s->fn->ins.at[ref];
            s->handle[ref] = handle_of(k, s, i);
            if (i->op == IR_store) {
                const SearchStore one = {n, s->state, i->stmt, ref, i->a};
                vec_push(&k->work, &k->var[i->var].store, one);
            } else if (i->op == IR_const) {
                vec_push(&k->work, &k->constant, ir_number(i->type, i->bits));
            }
        }
}

static void analyse_functions(SearchRun *k)
{
    k->fn = arena_array(&k->work, k->plain->fns + 1, sizeof *k->fn);
    for (uint32_t n = 0; n < k->plain->fns; n++) {
        k->fn[n].fn = k->plain->fn[n].fn;
        for (uint32_t s = 0; s < k->m->state.n; s++)
            for (int b = 0; b < BLOCK_COUNT; b++)
                if (k->m->state.at[s].block[b] == k->fn[n].fn) {
                    k->fn[n].state = s + 1;
                    k->fn[n].is_step = b == BLOCK_STEP;
                }
        analyse_function(k, n);
    }
    for (size_t w = 0; w < k->m->window.n; w++)
        k->longest = k->m->window.at[w].size > k->longest ? k->m->window.at[w].size : k->longest;
}

// ---- paths ----

// Finds the decision of each conditional: that whose result its branch tests.
static void find_guards(SearchRun *k)
{
    k->guard = ARENA_ARRAY(&k->work, uint32_t, k->p->stmts + 1);
    memset(k->guard, 0xff, (k->p->stmts + 1) * sizeof *k->guard);
    for (uint32_t d = 0; d < k->decisions; d++) {
        const IrFn *f = k->decision[d].d->fn;
        for (uint32_t b = 0; b < f->blk.n; b++) {
            const IrJump *j = &f->blk.at[b].jump;
            IrRef cond = j->cond;
            if (j->kind != IR_BR || j->stmt == 0)
                continue;
            while (cond != k->decision[d].d->value && f->ins.at[cond].op == IR_cvt)
                cond = f->ins.at[cond].a;
            if (cond == k->decision[d].d->value)
                k->guard[j->stmt] = d;
        }
    }
}

typedef VEC(SearchElem) Elems;        // outcomes of decisions, the outermost decision first

// Whether a statement of the list, or one inside it, is a transition.
static bool has_transition(const Stmts *list)
{
    for (size_t i = 0; i < list->n; i++)
        if (list->at[i]->kind == ST_TRANSITION || has_transition(&list->at[i]->then) || has_transition(&list->at[i]->otherwise))
            return true;
    return false;
}

// Returns a copy of the decisions on the way to a statement, the innermost first.
static SearchPath store_path(SearchRun *k, const Elems *e)
{
    SearchElem *out = arena_array(&k->work, e->n + 1, sizeof *out);

    for (uint32_t i = 0; i < e->n; i++)
        out[i] = e->at[e->n - 1 - i];
    return (SearchPath){out, e->n};
}

// Whether every way through the list of statements ends in a transition.
static bool leaves_always(const Stmts *list)
{
    for (size_t i = 0; i < list->n; i++)
        if (list->at[i]->kind == ST_TRANSITION || (leaves_always(&list->at[i]->then) && leaves_always(&list->at[i]->otherwise)))
            return true;
    return false;
}

static void add_elem(SearchRun *k, Elems *e, uint32_t stmt, bool value, bool is_certain)
{
    const SearchElem one = {k->guard[stmt], value, is_certain};

    if (one.decision != SEARCH_NONE)
        vec_push(&k->work, e, one);
}

// Stores for each statement of the list, and for those inside it, which outcomes of decisions lead to it.
static void find_paths(SearchRun *k, const Stmts *list, const State *state, Elems *e)
{
    const uint32_t outer = e->n;

    for (size_t i = 0; i < list->n; i++) {
        const Stmt *s = list->at[i];
        const uint32_t before = e->n;
        k->path[s->number] = store_path(k, e);
        if (s->kind == ST_TRANSITION) {
            const SearchExit x = {s->number, state->number, s->target->number, k->path[s->number]};
            vec_push(&k->work, &k->exit, x);
        }
        if (s->kind != ST_IF)
            continue;
        add_elem(k, e, s->number, true, true);
        find_paths(k, &s->then, state, e);
        e->n = before;
        add_elem(k, e, s->number, false, true);
        find_paths(k, &s->otherwise, state, e);
        e->n = before;
        if (has_transition(&s->then) && !has_transition(&s->otherwise))
            add_elem(k, e, s->number, false, leaves_always(&s->then));
        else if (has_transition(&s->otherwise) && !has_transition(&s->then))
            add_elem(k, e, s->number, true, leaves_always(&s->otherwise));
    }
    e->n = outer;
}

// ---- what decisions depend on ----

static void add_inputs(const SearchRun *k, const IrFn *f, IrRef ref, uint64_t *to);

// Adds the inputs that a window samples to the set `to`.
static void add_window_inputs(const SearchRun *k, uint32_t window, uint64_t *to)
{
    const IrFn *f = k->m->sample;

    for (uint32_t i = 0; f && i < f->ins.n; i++)
        if (f->ins.at[i].op == IR_sample && f->ins.at[i].var == window)
            add_inputs(k, f, f->ins.at[i].a, to);
}

// Adds the inputs on which the value of an instruction depends to the set `to`, one bit for each.
static void add_inputs(const SearchRun *k, const IrFn *f, IrRef ref, uint64_t *to)
{
    const IrIns *i = &f->ins.at[ref];

    if (i->op == IR_load) {
        const SearchVar *v = &k->var[i->var];
        if (v->input != SEARCH_NONE)
            to[v->input / 64] |= UINT64_C(1) << v->input % 64;
        for (uint32_t w = 0; w < k->words; w++)
            to[w] |= v->inputs[w];
    } else if (i->op == IR_stat) {
        add_window_inputs(k, i->var, to);
    } else if (i->op != IR_const) {
        if (i->a != IR_NONE)
            add_inputs(k, f, i->a, to);
        if (i->b != IR_NONE)
            add_inputs(k, f, i->b, to);
    }
}

static uint64_t count_bits(uint64_t set)
{
    uint64_t n = 0;

    for (; set; set &= set - 1)
        n++;
    return n;
}

// Finds for each variable the inputs on which it depends, through all stores, until nothing changes.
static void find_dependences(SearchRun *k)
{
    for (bool again = true; again; ) {
        again = false;
        for (size_t v = 0; v < k->m->var.n; v++)
            for (uint32_t i = 0; i < k->var[v].store.n; i++) {
                const SearchStore *s = &k->var[v].store.at[i];
                uint64_t before = 0, after = 0;
                for (uint32_t w = 0; w < k->words; w++)
                    before += count_bits(k->var[v].inputs[w]);
                add_inputs(k, k->fn[s->fn].fn, s->value, k->var[v].inputs);
                for (uint32_t e = 0; e < k->path[s->stmt].n; e++) {
                    const FlatDecision *d = k->decision[k->path[s->stmt].elem[e].decision].d;
                    add_inputs(k, d->fn, d->value, k->var[v].inputs);
                }
                for (uint32_t w = 0; w < k->words; w++)
                    after += count_bits(k->var[v].inputs[w]);
                again = again || after != before;
            }
    }
    for (uint32_t d = 0; d < k->decisions; d++) {
        SearchDecision *x = &k->decision[d];
        x->inputs = ARENA_ARRAY(&k->work, uint64_t, k->words);
        add_inputs(k, x->d->fn, x->d->value, x->inputs);
        for (uint32_t e = 0; e < x->path.n; e++) {
            const FlatDecision *o = k->decision[x->path.elem[e].decision].d;
            add_inputs(k, o->fn, o->value, x->inputs);
        }
    }
}

// ---- constants ----

// Returns the entry of the hash table for x: that of an equal number, or else an empty one.
static uint32_t *find_constant(const SearchInput *in, double x)
{
    const uint64_t bits = sm_bits(x == 0 ? 0.0 : x) * UINT64_C(0x9e3779b97f4a7c15);
    uint32_t at = (uint32_t)(bits >> 32) & (in->slots - 1);

    while (in->slot[at] && !(in->constant.at[in->slot[at] - 1] == x))
        at = (at + 1) & (in->slots - 1);
    return &in->slot[at];
}

static void grow_constants(SearchRun *k, SearchInput *in)
{
    in->slots = in->slots ? in->slots * 2 : 16;
    in->slot = ARENA_ARRAY(&k->work, uint32_t, in->slots);
    for (uint32_t i = 0; i < in->constant.n; i++)
        *find_constant(in, in->constant.at[i]) = i + 1;
}

static void add_constant(SearchRun *k, SearchInput *in, double x)
{
    uint32_t *slot;

    if (in->constant.n * 2 >= in->slots)
        grow_constants(k, in);
    slot = find_constant(in, x);
    if (*slot)
        return;
    vec_push(&k->work, &in->constant, x);
    *slot = in->constant.n;
}

// Adds each constant of an expression to those that are tried for these inputs.
static void collect_constants(SearchRun *k, const IrFn *f, IrRef ref, const uint64_t *inputs)
{
    const IrIns *i = &f->ins.at[ref];

    if (i->op == IR_const) {
        for (uint32_t in = 0; in < k->inputs; in++)
            if (inputs[in / 64] >> in % 64 & 1)
                add_constant(k, &k->input[in], ir_number(i->type, i->bits));
        return;
    }
    if (i->op == IR_load || i->op == IR_stat)
        return;
    if (i->a != IR_NONE)
        collect_constants(k, f, i->a, inputs);
    if (i->b != IR_NONE)
        collect_constants(k, f, i->b, inputs);
}

// Finds for each input the constants with which a comparison relates it.
static void find_constants(SearchRun *k)
{
    uint64_t *set = ARENA_ARRAY(&k->work, uint64_t, k->words);

    for (uint32_t n = 0; n < k->plain->fns; n++) {
        const IrFn *f = k->fn[n].fn;
        for (uint32_t i = 0; i < f->ins.n; i++)
            if (ir_op_info[f->ins.at[i].op].types == IR_T_COMPARE) {
                memset(set, 0, k->words * sizeof *set);
                add_inputs(k, f, i, set);
                collect_constants(k, f, i, set);
            }
    }
    for (uint32_t i = 0; i < k->o->hints; i++) {
        const uint32_t at = k->m->var_of[k->o->hint[i].var];
        if (at != IR_NONE && k->var[at].input != SEARCH_NONE)
            add_constant(k, &k->input[k->var[at].input], k->o->hint[i].value);
    }
    for (uint32_t i = 0; i < k->o->givens; i++)
        for (size_t c = 0; c < k->o->given[i].changes; c++) {
            const uint32_t at = k->m->var_of[k->o->given[i].change[c].var];
            if (at != IR_NONE && k->var[at].input != SEARCH_NONE)
                add_constant(k, &k->input[k->var[at].input], k->o->given[i].change[c].a);
        }
    for (uint32_t i = 0; i < k->inputs; i++) {
        add_constant(k, &k->input[i], 0);
        add_constant(k, &k->input[i], 1);
        if (k->input[i].range) {
            add_constant(k, &k->input[i], k->input[i].range->lo);
            add_constant(k, &k->input[i], k->input[i].range->hi);
        }
    }
}

// ---- decisions ----

typedef VEC(uint32_t) Slots;

// Adds the places of the numbers that the truth of `ref` is computed from.
static void add_operands(SearchRun *k, const IrFn *f, const uint32_t *slot, IrRef ref, Slots *out)
{
    const IrIns *i = &f->ins.at[ref];

    if (i->op == IR_not || i->op == IR_and || i->op == IR_or) {
        add_operands(k, f, slot, i->a, out);
        if (i->b != IR_NONE)
            add_operands(k, f, slot, i->b, out);
    } else if (ir_op_info[i->op].types == IR_T_COMPARE) {
        vec_push(&k->work, out, slot[i->a]);
        vec_push(&k->work, out, slot[i->b]);
    } else {
        vec_push(&k->work, out, slot[ref]);
    }
}

// Finds where a decision is, and the slots of the values on which its distance depends.
static void analyse_decision(SearchRun *k, uint32_t n)
{
    SearchDecision *d = &k->decision[n];
    Slots slots = {NULL, 0, 0};

    d->d = &k->c->probes.decision[n];
    while (k->fn[d->fn].fn != d->d->fn)
        d->fn++;
    d->state = k->fn[d->fn].state;
    for (uint32_t c = 0; c < d->d->conditions; c++)
        add_operands(k, d->d->fn, k->plain->fn[d->fn].slot, d->d->condition[c], &slots);
    d->operand = slots.at;
    d->operands = slots.n;
    d->last = ARENA_ARRAY(&k->work, double, slots.n + 1);
}

void search_analyse_machine(SearchRun *k)
{
    Elems path = {NULL, 0, 0};

    k->var = arena_array(&k->work, k->m->var.n, sizeof *k->var);
    for (size_t v = 0; v < k->m->var.n; v++)
        k->var[v].input = SEARCH_NONE;
    find_inputs(k);
    for (size_t v = 0; v < k->m->var.n; v++)
        k->var[v].inputs = ARENA_ARRAY(&k->work, uint64_t, k->words);
    for (uint32_t v = 0; v < k->p->var.n && k->o->place; v++)      // what another machine writes can depend on any input
        for (uint32_t i = 0; i < k->inputs && k->o->place->foreign[v]; i++)
            k->var[k->m->var_of[v]].inputs[i / 64] |= UINT64_C(1) << i % 64;
    analyse_functions(k);
    k->decisions = k->c->probes.decisions;
    k->decision = arena_array(&k->work, k->decisions + 1, sizeof *k->decision);
    for (uint32_t d = 0; d < k->decisions; d++)
        analyse_decision(k, d);
    find_guards(k);
    k->path = arena_array(&k->work, k->p->stmts + 1, sizeof *k->path);
    for (size_t s = 0; s < k->p->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            find_paths(k, &k->p->state.at[s]->block[b], k->p->state.at[s], &path);
    for (uint32_t d = 0; d < k->decisions; d++)
        if (k->decision[d].state)
            k->decision[d].path = k->path[k->decision[d].d->fn->ins.at[k->decision[d].d->value].stmt];
    find_dependences(k);
    find_constants(k);
}
