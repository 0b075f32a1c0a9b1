// SPDX-License-Identifier: Apache-2.0
#include "compiler/search/must_not.h"

#include "compiler/script/ref.h"

// ---- how far a condition is from a value ----

// Returns how far `a op b` is from the wanted result: 0 if it has it, else the gap between the numbers.
static double compare_distance(SmOperator op, double a, double b, bool wanted)
{
    const double gap = a > b ? a - b : b - a;
    bool is;

    switch (op) {
    case SM_OP_LT: is = a < b; break;
    case SM_OP_LE: is = a <= b; break;
    case SM_OP_GT: is = a > b; break;
    case SM_OP_GE: is = a >= b; break;
    case SM_OP_EQ: is = a == b; break;
    default: is = a != b; break;
    }
    return is == wanted ? 0 : gap < 1e100 ? gap + 1e-6 : 1e100;
}

double must_not_distance(const Expr *e, bool wanted, const uint64_t *cell)
{
    double sum = 0, least = SEARCH_UNKNOWN;
    bool all = wanted;
    const uint32_t parts = e->kind == EX_CHAIN ? e->n - 1 : e->n;

    if (e->kind == EX_UNARY && e->op == SM_OP_NOT)
        return must_not_distance(e->arg[0], !wanted, cell);
    if (e->kind == EX_BINARY && e->op >= SM_OP_EQ && e->op <= SM_OP_GE)
        return compare_distance(e->op, ref_eval(e->arg[0], cell, NULL), ref_eval(e->arg[1], cell, NULL), wanted);
    if (e->kind != EX_CHAIN && !(e->kind == EX_BINARY && (e->op == SM_OP_AND || e->op == SM_OP_OR)))
        return ref_true(ref_eval(e, cell, NULL)) == wanted ? 0 : 1;
    if (e->kind == EX_BINARY && e->op == SM_OP_OR)
        all = !wanted;
    for (uint32_t i = 0; i < parts; i++) {
        const double d = e->kind == EX_CHAIN
            ? compare_distance(expr_ops(e)[i], ref_eval(e->arg[i], cell, NULL), ref_eval(e->arg[i + 1], cell, NULL), wanted)
                                             : must_not_distance(e->arg[i], wanted, cell);
        sum += d;
        least = d < least ? d : least;
    }
    return all ? sum : least;
}

// ---- pairs ----

// What the conditions of a transition read: a window; a variable other than G, S and T (`reads`).
typedef struct Reading { const Program *p; bool has_window, reads; } Reading;

static void check_usable_expr(Expr *e, void *context)
{
    Reading *r = context;

    r->has_window = r->has_window || e->kind == EX_ROLL;
    r->reads = r->reads || (e->kind == EX_VAR && e->var != r->p->g && e->var != r->p->s && e->var != r->p->t && !e->var->is_constant);
}

static bool is_usable(const Program *p, const Transition *t)
{
    Reading r = {p, false, false};

    for (const Condition *c = t->when; c; c = c->outer)
        expr_walk(c->stmt->value, check_usable_expr, &r);
    return r.reads && !r.has_window;
}

// Whether the machine has a transition from state `from` to state `to`.
static bool leads_to(const Transitions *all, const State *from, const State *to)
{
    for (uint32_t i = 0; i < all->n; i++)
        if (all->at[i].from == from && all->at[i].to == to)
            return true;
    return false;
}

static void add_pairs_of(Arena *arena, MustNots *m, const Transitions *all, const State *to)
{
    const Transition *other = NULL;

    for (uint32_t i = 0; i < all->n && !other; i++)
        if (all->at[i].to == to && all->at[i].from != to && is_usable(m->p, &all->at[i]))
            other = &all->at[i];
    for (uint32_t i = 0; i < m->p->state.n && other; i++) {
        const MustNot pair = {m->p->state.at[i], to, other};
        if (pair.in != to && !leads_to(all, pair.in, to))
            vec_push(arena, &m->at, pair);
    }
}

// ---- the watch ----

// Initialises the situation (SearchWatch): by goal, whether the last step was in state A and its condition was true.
static void start_situation(void *self, void *situation)
{
    const MustNots *m = self;
    bool *was = situation;

    for (uint32_t i = 0; i < m->at.n; i++)
        was[i] = false;
}

// Returns how far the conditions of a transition are from all being true; 0: they are true.
static double distance_of(const Transition *t, const uint64_t *cell)
{
    double sum = 0;

    for (const Condition *c = t->when; c; c = c->outer)
        sum += must_not_distance(c->stmt->value, c->holds, cell);
    return sum;
}

// Called after each step: sets the distance of each forbidden pair of states from being provoked.
static void judge_step(void *self, void *situation, const uint64_t *cell, double *distance)
{
    const MustNots *m = self;
    bool *was = situation;

    for (uint32_t i = 0; i < m->at.n; i++) {
        const MustNot *pair = &m->at.at[i];
        const bool is_here = cell[m->p->s->index] == pair->in->number;
        const double d = is_here ? distance_of(pair->other, cell) : SEARCH_UNKNOWN;
        distance[i] = !is_here ? SEARCH_UNKNOWN : was[i] ? 0 : d + 1e-3;
        was[i] = d == 0;
    }
}

MustNots *must_not_list(Arena *arena, const Program *p)
{
    MustNots *m = ARENA_NEW(arena, MustNots);
    Transitions *all = ARENA_NEW(arena, Transitions);

    *all = transitions_of(arena, p);
    m->p = p;
    for (uint32_t i = 0; i < p->state.n; i++)
        add_pairs_of(arena, m, all, p->state.at[i]);
    m->watch = (SearchWatch){.self = m, .goals = m->at.n, .size = m->at.n * sizeof(bool), .start = start_situation, .step = judge_step};
    return m;
}
