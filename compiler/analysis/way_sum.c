// SPDX-License-Identifier: Apache-2.0
// Values on a way, as sums of atoms.
#include "compiler/analysis/way_formula.h"

#include "stdlib/math.h"

// ---- atoms ----

static WaySum sum_of_atom(Way *w, WayAtom atom)
{
    WaySum s = {.n = 1, .term = {{(uint32_t)w->atom.n, 1}}};

    vec_push(w->a->arena, &w->atom, atom);
    return s;
}

WaySum way_unknown(Way *w, bool whole)
{
    return sum_of_atom(w, (WayAtom){.whole = whole, .fact = fact_of_type(SM_F64)});
}

static WaySum sum_of_number(double x) { return (WaySum){.constant = x}; }

const WayValue *way_assigned(const Way *w, const Var *v)
{
    for (size_t i = 0; i < w->assigned.n; i++)
        if (w->assigned.at[i].var == v)
            return &w->assigned.at[i];
    return NULL;
}

static WaySum sum_of_var(Way *w, const Var *v)
{
    const WayValue *now = way_assigned(w, v);

    if (v->is_constant)
        return sum_of_number(fact_of_cell(v->type, v->init).lo);
    if (now)
        return now->sum;
    for (size_t i = 0; i < w->atom.n; i++)
        if (w->atom.at[i].var == v)
            return (WaySum){.n = 1, .term = {{(uint32_t)i, 1}}};
    return sum_of_atom(w, (WayAtom){.var = v, .whole = sm_type_info[v->type].kind != SM_KIND_FLOAT, .fact = fact_of_type(v->type)});
}

typedef struct Search { const Way *w; bool found; } Search;

static void look_for_assigned(Expr *e, void *context)
{
    Search *s = context;

    s->found |= e->kind == EX_VAR && way_assigned(s->w, e->var);
}

// An expression as a whole: the same wherever it stands, as long as nothing in it has been assigned.
static WaySum sum_of_whole(Way *w, const Expr *e)
{
    Search s = {w, false};

    expr_walk((Expr *)e, look_for_assigned, &s);
    if (s.found)
        return way_unknown(w, false);
    for (size_t i = 0; i < w->atom.n; i++)
        if (w->atom.at[i].expr && expr_equal(w->atom.at[i].expr, e, w->a->m->window_of))
            return (WaySum){.n = 1, .term = {{(uint32_t)i, 1}}};
    return sum_of_atom(w, (WayAtom){.expr = e, .fact = fact_of_type(SM_F64)});
}

// ---- arithmetic ----

static WaySum times(WaySum s, double x)
{
    for (unsigned i = 0; i < s.n; i++)
        s.term[i].times *= x;
    s.constant *= x;
    if (x == 0)
        s.n = 0;
    return s;
}

// Adds a term at its place, which is that of its atom's number; false if there are too many.
static bool add_term(WaySum *s, WayTerm t)
{
    unsigned i = 0, k;

    while (i < s->n && s->term[i].atom < t.atom)
        i++;
    if (i < s->n && s->term[i].atom == t.atom) {
        s->term[i].times += t.times;
        if (s->term[i].times != 0)
            return true;
        for (s->n--; i < s->n; i++)
            s->term[i] = s->term[i + 1];
        return true;
    }
    if (s->n == WAY_TERMS)
        return false;
    for (k = s->n++; k > i; k--)
        s->term[k] = s->term[k - 1];
    s->term[i] = t;
    return true;
}

static bool add(WaySum *a, const WaySum *b)
{
    a->constant += b->constant;
    for (unsigned i = 0; i < b->n; i++)
        if (!add_term(a, b->term[i]))
            return false;
    return true;
}

bool way_subtract(WaySum *a, const WaySum *b)
{
    const WaySum minus = times(*b, -1);

    return add(a, &minus);
}

static WaySum sum_of_two(Way *w, const Expr *e)
{
    WaySum a = way_sum(w, e->arg[0]), b = way_sum(w, e->arg[1]);

    switch ((int)e->op) {
    case SM_OP_SUB: b = times(b, -1); break;
    case SM_OP_MUL:
        return b.n == 0 ? times(a, b.constant) : a.n == 0 ? times(b, a.constant) : sum_of_whole(w, e);
    case SM_OP_DIV:
        return b.n == 0 && b.constant != 0 ? times(a, 1 / b.constant) : sum_of_whole(w, e);
    }
    return add(&a, &b) ? a : sum_of_whole(w, e);
}

// While its input does not change, a window ends up holding that alone.
static WaySum sum_of_stat(Way *w, const Expr *e)
{
    return e->stat == SM_STAT_RANGE ? sum_of_number(0) : way_sum(w, e->arg[0]);
}

WaySum way_sum(Way *w, const Expr *e)
{
    WaySum s;

    switch (e->kind) {
    case EX_NUMBER: return sum_of_number(fact_of_cell(SM_F64, sm_bits(e->number)).lo);
    case EX_VAR: return sum_of_var(w, e->var);
    case EX_UNARY: return e->op == SM_OP_NEG ? times(way_sum(w, e->arg[0]), -1) : sum_of_whole(w, e);
    case EX_BINARY:
        if (sm_op_info[e->op].op_class != SM_CLASS_ARITH)
            break;
        s = sum_of_two(w, e);
        return s.constant - s.constant == 0 ? s : sum_of_whole(w, e);
    case EX_ROLL: return sum_of_stat(w, e);
    case EX_CHAIN: case EX_CALL: break;
    }
    return sum_of_whole(w, e);
}

bool way_sum_is_whole(const Way *w, const WaySum *s)
{
    for (unsigned i = 0; i < s->n; i++)
        if (!w->atom.at[s->term[i].atom].whole || s->term[i].times != sm_trunc(s->term[i].times))
            return false;
    return s->constant == sm_trunc(s->constant);
}
