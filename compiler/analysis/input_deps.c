// SPDX-License-Identifier: Apache-2.0
// Computes what values depend on.  A local depends on the values stored in it and on the guards around those stores.  A guard
// depends on the variables it reads and on the enclosing guards.  These are the nodes of a graph.  Dependencies propagate along
// its edges to a fixed point.  A node stores at most LOOKS_MAX sensors, so each node is visited only a few times.
#include "compiler/analysis/input_deps.h"

typedef struct Spread {
    Sensors *s;
    Numbers *readers;             // by node: the nodes that depend on it
    Numbers waiting;
    bool *waits;
    uint32_t to;                  // the node whose expression is being walked
} Spread;

static uint32_t node_of_guard(const Sensors *s, const Stmt *stmt) { return (uint32_t)s->a->p->var.n + stmt->number; }

// ---- roles of elements ----

static bool is_only_read(const Sensors *s, const Var *v)
{
    return v->kind == VAR_ELEMENT && !v->written && v != s->a->p->g && v != s->a->p->s;
}

bool is_sensor(const Sensors *s, const Var *v) { return is_only_read(s, v) && v->type != SM_BOOL && !s->command[v->index]; }

static bool is_whole(const Var *v) { return sm_type_info[v->type].kind != SM_KIND_FLOAT && v->type != SM_BOOL; }

typedef struct Uses { uint32_t *reads, *coded; } Uses;       // by Var.index

static void count_coded(Uses *u, const Expr *e, const Expr *other)
{
    if (e->kind == EX_VAR && expr_is_constant(other))
        u->coded[e->var->index]++;
}

static void count_use(Expr *e, void *context)
{
    Uses *u = context;

    if (e->kind == EX_VAR)
        u->reads[e->var->index]++;
    if (e->kind != EX_BINARY || (e->op != SM_OP_EQ && e->op != SM_OP_NE))
        return;
    count_coded(u, e->arg[0], e->arg[1]);
    count_coded(u, e->arg[1], e->arg[0]);
}

static void count_uses(const Stmt *stmt, void *context)
{
    if (stmt->value)
        expr_walk(stmt->value, count_use, context);
}

static void find_commands(Sensors *s)
{
    const Program *p = s->a->p;
    Uses u = {ARENA_ARRAY(s->a->arena, uint32_t, p->var.n), ARENA_ARRAY(s->a->arena, uint32_t, p->var.n)};

    each_stmt(p, count_uses, &u);
    for (size_t v = 0; v < p->var.n; v++)
        s->command[v] = p->var.at[v]->command || (is_whole(p->var.at[v]) && u.reads[v] > 0 && u.reads[v] == u.coded[v]);
}

// ---- sets ----

bool looks_at(const Looks *l, const Var *sensor)
{
    for (uint32_t i = 0; i < l->n; i++)
        if (l->sensor[i] == sensor)
            return true;
    return false;
}

static void add_sensor(Looks *l, const Var *v)
{
    uint32_t i = l->n;

    if (looks_at(l, v))
        return;
    if (l->n == LOOKS_MAX) {
        l->more = true;
        return;
    }
    for (; i > 0 && l->sensor[i - 1]->index > v->index; i--)
        l->sensor[i] = l->sensor[i - 1];
    l->sensor[i] = v;
    l->n++;
}

static bool add_looks(Looks *to, const Looks *from)
{
    const Looks was = *to;

    for (uint32_t i = 0; i < from->n; i++)
        add_sensor(to, from->sensor[i]);
    to->more |= from->more;
    to->time |= from->time;
    to->input |= from->input;
    to->other |= from->other;
    return to->n != was.n || to->more != was.more || to->time != was.time || to->input != was.input || to->other != was.other;
}

static Looks looks_of_var(const Sensors *s, const Var *v)
{
    Looks l = {.n = 0};

    if (v->kind == VAR_TIME || v == s->a->p->g)
        l.time = true;
    else if (is_sensor(s, v))
        add_sensor(&l, v);
    else if (is_only_read(s, v))
        l.input = true;
    else if (v->kind == VAR_ELEMENT)
        l.other = true;
    return l;
}

// ---- the graph ----

static void wait_for(Spread *g, uint32_t node)
{
    if (g->waits[node])
        return;
    g->waits[node] = true;
    vec_push(g->s->a->arena, &g->waiting, node);
}

static void add_reader(Spread *g, uint32_t node, uint32_t reader) { vec_push(g->s->a->arena, &g->readers[node], reader); }

static void note_read(Expr *e, void *context)
{
    Spread *g = context;

    if (e->kind == EX_VAR && !e->var->is_constant)
        add_reader(g, e->var->index, g->to);
}

static void note_place(const StmtPlace *at, void *context)
{
    Spread *g = context;

    if (at->stmt->kind == ST_TRANSITION)
        return;
    g->to = at->stmt->kind == ST_IF ? node_of_guard(g->s, at->stmt) : at->stmt->var->index;
    if (at->stmt->kind == ST_ASSIGN)
        vec_push(g->s->a->arena, &g->s->stores[g->to], *at);
    expr_walk(at->stmt->value, note_read, g);
    if (at->when)
        add_reader(g, node_of_guard(g->s, at->when->stmt), g->to);
}

static void spread_from(Spread *g, uint32_t node)
{
    g->waits[node] = false;
    for (size_t k = 0; k < g->readers[node].n; k++)
        if (add_looks(&g->s->looks[g->readers[node].at[k]], &g->s->looks[node]))
            wait_for(g, g->readers[node].at[k]);
}

static void spread(Sensors *s)
{
    const Program *p = s->a->p;
    const size_t nodes = p->var.n + p->stmts + 1;
    Spread g = {s, ARENA_ARRAY(s->a->arena, Numbers, nodes), {NULL, 0, 0}, ARENA_ARRAY(s->a->arena, bool, nodes), 0};

    each_place(s->a->arena, p, note_place, &g);
    for (size_t v = 0; v < p->var.n; v++) {
        s->looks[v] = looks_of_var(s, p->var.at[v]);
        wait_for(&g, (uint32_t)v);
    }
    while (g.waiting.n > 0)
        spread_from(&g, g.waiting.at[--g.waiting.n]);
}

// ---- queries ----

Looks looks_of_condition(const Sensors *s, const Condition *when)
{
    const Looks none = {.n = 0};

    return when ? s->looks[node_of_guard(s, when->stmt)] : none;
}

typedef struct Sum { const Sensors *s; Looks looks; } Sum;

static void sum_up(Expr *e, void *context)
{
    Sum *sum = context;

    if (e->kind == EX_VAR && !e->var->is_constant)
        add_looks(&sum->looks, &sum->s->looks[e->var->index]);
}

Looks looks_of_value(const Sensors *s, const Expr *e)
{
    Sum sum = {s, {.n = 0}};

    expr_walk((Expr *)e, sum_up, &sum);
    return sum.looks;
}

const Condition *condition_on(const Sensors *s, const Condition *when, const Var *sensor)
{
    for (; when; when = when->outer) {
        const Looks l = looks_of_value(s, when->stmt->value);
        if (looks_at(&l, sensor))
            return when;
    }
    return NULL;
}

typedef struct Through {
    const Sensors *s;
    const Var *sensor;
    const Stmt *store;
    bool itself;                  // the expression reads the sensor
} Through;

static void look_through(Expr *e, void *context)
{
    Through *t = context;

    if (e->kind != EX_VAR)
        return;
    t->itself |= e->var == t->sensor;
    if (!t->store && e->var->kind == VAR_LOCAL && t->s->stores[e->var->index].n > 0 &&
        looks_at(&t->s->looks[e->var->index], t->sensor))
        t->store = t->s->stores[e->var->index].at[0].stmt;
}

const Stmt *looks_through(const Sensors *s, const Expr *e, const Var *sensor)
{
    Through t = {s, sensor, NULL, false};

    expr_walk((Expr *)e, look_through, &t);
    return t.itself ? NULL : t.store;
}

const Sensors *sensors_of(Analysis *a)
{
    Arena *arena = a->arena;
    const size_t n = a->p->var.n;
    Sensors *s = ARENA_NEW(arena, Sensors);

    s->a = a;
    s->command = ARENA_ARRAY(arena, bool, n);
    s->looks = ARENA_ARRAY(arena, Looks, n + a->p->stmts + 1);
    s->stores = ARENA_ARRAY(arena, Stores, n);
    find_commands(s);
    spread(s);
    return s;
}
