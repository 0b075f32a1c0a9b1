// SPDX-License-Identifier: Apache-2.0
#include "compiler/analysis/carried.h"
#include "stdlib/convert.h"
#include "stdlib/math.h"

// ---- kinds ----

// What the assignments to a variable are, counted.
typedef struct StoreCounts { uint32_t constants, on, extremes, counts, stamps, fresh, others; } StoreCounts;

typedef struct CarriedFinder {
    CarriedTable *t;
    StoreCounts *count;           // by Var.index
    const State *state;
    BlockKind block;
} CarriedFinder;

static bool is_extreme_of_itself(const Stmt *s)
{
    const Expr *e = s->value;
    uint32_t itself = 0;

    for (uint32_t i = 0; i < e->n; i++)
        itself += e->arg[i]->kind == EX_VAR && e->arg[i]->var == s->var;
    return e->kind == EX_CALL && (e->fn == SM_FN_max || e->fn == SM_FN_min) && itself == 1;
}

// Whether the assignment is v = v + constant.
static bool is_count(const Stmt *s)
{
    const Expr *e = s->value;
    const bool sum = e->kind == EX_BINARY && e->op == SM_OP_ADD;

    for (uint32_t i = 0; sum && i < 2; i++)
        if (e->arg[i]->kind == EX_VAR && e->arg[i]->var == s->var && expr_is_constant(e->arg[1 - i]))
            return sm_lt(sm_from_i32(0), expr_constant_value(e->arg[1 - i]));
    return false;
}

static void count_store(const Stmt *s, void *context)
{
    CarriedFinder *f = context;
    StoreCounts *n;

    if (s->kind != ST_ASSIGN)
        return;
    n = &f->count[s->var->index];
    if (expr_is_constant(s->value)) {
        n->constants++;
        n->on += sm_to_bool(expr_constant_value(s->value));
    } else if (is_extreme_of_itself(s))
        n->extremes++;
    else if (is_count(s))
        n->counts++;
    else if (s->value->kind == EX_VAR && s->value->var == f->t->a->p->g)
        n->stamps++;
    else if (expr_reads(s->value, s->var))
        n->others++;
    else
        n->fresh++;
}

static CarriedKind kind_of(const Var *v, const StoreCounts *n)
{
    const uint32_t all = n->constants + n->extremes + n->counts + n->stamps + n->fresh + n->others;
    const bool off = v->kind != VAR_LOCAL || !sm_to_bool(sm_cell_to_f64(v->type, v->init));

    if (v->type == SM_BOOL)
        return n->on > 0 && n->constants == all && off ? CARRIED_LATCH : CARRIED_NONE;
    if (n->extremes > 0)
        return n->counts + n->others == 0 ? CARRIED_EXTREME : CARRIED_NONE;
    if (n->counts > 0)
        return n->counts + n->constants == all ? CARRIED_COUNT : CARRIED_NONE;
    return n->stamps > 0 && n->stamps + n->constants == all ? CARRIED_STAMP : CARRIED_NONE;
}

// ---- assignments and guards ----

static bool is_reset(CarriedKind kind, const Stmt *s)
{
    switch (kind) {
    case CARRIED_LATCH: return !sm_to_bool(expr_constant_value(s->value));
    case CARRIED_EXTREME: return !is_extreme_of_itself(s);
    case CARRIED_COUNT: return !is_count(s);
    case CARRIED_STAMP: return true;
    case CARRIED_NONE: break;
    }
    return false;
}

static void add_store(CarriedFinder *f, const Stmt *s, const Stmts *list, bool guarded)
{
    Carried *c = &f->t->of[s->var->index];
    CarriedStore at = {s, list, f->state, f->block, is_reset(c->kind, s), false};

    at.certain = always_leaves(list) || (f->block != BLOCK_STEP && !guarded);
    // A latch that no condition sets is a phase or an output.
    if (c->kind == CARRIED_LATCH && !at.resets && !guarded)
        c->kind = CARRIED_NONE;
    c->resets += at.resets;
    c->unclear |= at.resets && !at.certain;
    vec_push(f->t->a->arena, &c->store, at);
}

static void add_guard(CarriedFinder *f, const Stmt *s, const Expr *e)
{
    Carried *c = e->kind == EX_VAR ? &f->t->of[e->var->index] : NULL;

    for (uint32_t i = 0; i < e->n; i++)
        add_guard(f, s, e->arg[i]);
    if (!c || c->kind == CARRIED_NONE || (c->guard.n > 0 && c->guard.at[c->guard.n - 1] == s))
        return;
    vec_push(f->t->a->arena, &c->guard, s);
    vec_push(f->t->a->arena, &c->guard_state, f->state);
}

// Recursion depth equals the nesting of conditionals, which AST_DEPTH_MAX bounds.
static void add_statements(CarriedFinder *f, const Stmts *list, bool guarded)
{
    for (size_t i = 0; i < list->n; i++) {
        const Stmt *s = list->at[i];
        if (s->kind == ST_ASSIGN && f->t->of[s->var->index].kind != CARRIED_NONE)
            add_store(f, s, list, guarded);
        if (s->kind != ST_IF)
            continue;
        add_guard(f, s, s->value);
        add_statements(f, &s->then, true);
        add_statements(f, &s->otherwise, true);
    }
}

CarriedTable carried_of(Analysis *a)
{
    const Program *p = a->p;
    CarriedTable t = {a, ARENA_ARRAY(a->arena, Carried, p->var.n), transitions_by_state(a->arena, p, &a->transition)};
    CarriedFinder f = {&t, ARENA_ARRAY(a->arena, StoreCounts, p->var.n), NULL, BLOCK_ENTRY};

    each_stmt(p, count_store, &f);
    for (size_t v = 0; v < p->var.n; v++)
        t.of[v].kind = kind_of(p->var.at[v], &f.count[v]);
    for (size_t s = 0; s < p->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++) {
            f.state = p->state.at[s];
            f.block = (BlockKind)b;
            add_statements(&f, &f.state->block[b], false);
        }
    return t;
}

bool carried_is_set_in(const Carried *c, const State *s)
{
    bool is_set = false;

    for (size_t i = 0; i < c->store.n && !is_set; i++)
        is_set = c->store.at[i].state == s && !c->store.at[i].resets;
    return is_set;
}

// ---- paths ----

static bool contains(const Stmts *list, const Stmt *s)
{
    bool found = false;

    for (size_t i = 0; i < list->n && !found; i++)
        found = list->at[i] == s || contains(&list->at[i]->then, s) || contains(&list->at[i]->otherwise, s);
    return found;
}

// Whether the variable is reset when the transition is made: beside it, in .exit of its state, or in .entry of the next one.
static bool is_reset_on(const Carried *c, const Transition *way)
{
    bool reset = false;

    for (size_t i = 0; i < c->store.n && !reset; i++) {
        const CarriedStore *r = &c->store.at[i];
        const bool beside = r->state == way->from && r->block != BLOCK_EXIT && always_leaves(r->list) && contains(r->list, way->stmt);
        reset = r->resets && (beside || (r->certain && ((r->block == BLOCK_EXIT && r->state == way->from) ||
                                                        (r->block == BLOCK_ENTRY && r->state == way->to))));
    }
    return reset;
}

void carried_mark_reached(const CarriedTable *t, size_t v, const State *from, bool *mark)
{
    const Analysis *a = t->a;
    VEC(const State *) waiting = {NULL, 0, 0};

    vec_push(a->arena, &waiting, from);
    while (waiting.n > 0) {
        const uint32_t s = waiting.at[--waiting.n]->number - 1;
        for (size_t i = t->first[s]; i < t->first[s + 1]; i++) {
            const Transition *way = &a->transition.at[i];
            if (mark[way->to->number - 1] || !a->stmt[way->stmt->number].reached || is_reset_on(&t->of[v], way))
                continue;
            mark[way->to->number - 1] = true;
            vec_push(a->arena, &waiting, way->to);
        }
    }
}
