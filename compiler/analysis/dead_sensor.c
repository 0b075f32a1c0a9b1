// SPDX-License-Identifier: Apache-2.0
#include "compiler/analysis/dead_sensor.h"

#include <string.h>

#include "stdlib/math.h"

enum { DEPTH = 100 };             // how long a chain of locals and windows made of each other may be

DeadSensor dead_sensor_new(const Sensors *s)
{
    const Analysis *a = s->a;
    DeadSensor d = {.s = s, .what = *a};
    FactMachine *fm = ARENA_NEW(a->arena, FactMachine);

    *fm = *a->facts;
    fm->epoch = ARENA_ARRAY(a->arena, uint32_t, a->m->var.n);
    fm->stored = ARENA_ARRAY(a->arena, uint32_t, a->m->var.n);
    fm->window = ARENA_ARRAY(a->arena, Fact, a->m->window.n + 1);
    if (a->m->window.n > 0)
        memcpy(fm->window, a->facts->window, a->m->window.n * sizeof *fm->window);
    d.what.facts = fm;
    d.local = ARENA_ARRAY(a->arena, uint32_t, a->p->var.n);
    d.kept = ARENA_ARRAY(a->arena, uint32_t, a->p->var.n);
    d.stored = ARENA_ARRAY(a->arena, uint32_t, a->p->var.n);
    d.always = ARENA_ARRAY(a->arena, bool, a->p->var.n);
    d.rest = ARENA_ARRAY(a->arena, Fact, a->p->var.n);
    d.window = ARENA_ARRAY(a->arena, uint32_t, a->m->window.n + 1);
    return d;
}

// ---- what is stored in a local ----

static bool is_reached(const DeadSensor *d, const StmtPlace *at) { return d->s->a->stmt[at->stmt->number].reached; }

typedef struct Stored {
    Fact fact;
    bool any;                     // something is stored
    bool always;                  // every store stands alone in its block, none under a guard
} Stored;

static void add_fact(Stored *out, Fact f)
{
    out->fact = out->any ? fact_join(out->fact, f) : f;
    out->any = true;
}

// All that is stored in a local, if before it holds what env says.
static Stored all_stored(DeadSensor *d, const Var *local, const Env *env)
{
    const Stores *list = &d->s->stores[local->index];
    Stored out = {fact_of_type(local->type), false, true};

    for (size_t i = 0; i < list->n; i++) {
        const StmtPlace *at = &list->at[i];
        const Env *here = env;
        if (!is_reached(d, at))
            continue;
        out.always &= at->when == NULL;
        d->work++;
        if (suppose_condition(&d->what, &here, at->when))
            add_fact(&out, fact_convert(suppose_stored(&d->what, here, at->stmt), local->type));
    }
    return out;
}

static Fact initial_of(const Var *local) { return fact_convert(fact_of_cell(local->type, local->init), local->type); }

// ---- filters ----
// A local that is made of itself and of the sensor comes to rest if it forgets: stored from some way off, it comes nearer.  Where,
// is found as that of a straight line through two points.

static bool stored_number(DeadSensor *d, const Var *local, double from, double *to)
{
    const Stored s = all_stored(d, local, suppose(&d->what, d->env, local, fact_of_number(from)));

    return s.any && s.always && fact_is_number(s.fact, to);
}

static bool comes_nearer(DeadSensor *d, const Var *local, double rest, double distance)
{
    const double from = fact_convert(fact_of_number(rest + distance), local->type).lo;
    double to;

    return stored_number(d, local, from, &to) && (from == rest || sm_abs(to - rest) < sm_abs(from - rest));
}

static bool comes_to_rest(DeadSensor *d, const Var *local, Fact *at)
{
    static const double distance[] = {-1e6, -1000, -1, 1, 1000, 1e6};
    double from_0, from_1, rest, near;

    if (!stored_number(d, local, 0, &from_0) || !stored_number(d, local, 1, &from_1) || !(sm_abs(from_1 - from_0) < 1))
        return false;
    rest = from_0 / (1 - (from_1 - from_0));
    near = 1e-6 * (1 + sm_abs(rest));
    for (size_t i = 0; i < sizeof distance / sizeof *distance; i++)
        if (!comes_nearer(d, local, rest, distance[i]))
            return false;
    *at = fact_of_range(rest - near, rest + near);
    return true;
}

// ---- settling ----

static bool is_one_number(Fact f)
{
    double x;

    return fact_is_number(f, &x);
}

// A flag that only this sensor's other readings would have set: it is as it was at the start.
static bool stays_initial(DeadSensor *d, const Var *local)
{
    const Fact initial = initial_of(local);
    const Stored s = all_stored(d, local, suppose(&d->what, d->env, local, initial));

    return !s.any || fact_equal(fact_join(s.fact, initial), initial);
}

// Where a state keeps storing it.
static Fact at_rest(DeadSensor *d, const Var *local, const Stored *s)
{
    Fact rest;

    if (!s->always || is_one_number(s->fact) || d->s->looks[local->index].n > 1 || !comes_to_rest(d, local, &rest))
        return s->fact;
    return fact_convert(rest, local->type);
}

// Elsewhere it may still hold its initial value.
static Fact anywhere(DeadSensor *d, const Var *local, const Stored *s)
{
    const Fact initial = initial_of(local);

    if (!s->any || (local->type == SM_BOOL && stays_initial(d, local)))
        return initial;
    return fact_join(d->rest[local->index], initial);
}

static void settle_at(DeadSensor *d, const Var *local)
{
    const Stored s = all_stored(d, local, suppose(&d->what, d->env, local, fact_of_type(local->type)));
    Fact *rest = &d->rest[local->index], all;

    *rest = s.any ? at_rest(d, local, &s) : initial_of(local);
    all = anywhere(d, local, &s);
    if (!s.always)
        *rest = all;
    d->always[local->index] = s.always;
    d->env = suppose(&d->what, d->env, local, all);
}

// What an expression reads is looked into before the expression is.
static void settle(Expr *e, void *context);

static void settle_window(DeadSensor *d, const Window *w, uint32_t ir)
{
    const Looks looks = looks_of_value(d->s, w->sample);
    Fact *fact = &d->what.facts->window[ir];

    if (d->window[ir] == d->question || !looks_at(&looks, d->sensor))
        return;
    d->window[ir] = d->question;
    d->work++;
    *fact = fact_meet(*fact, fact_convert(suppose_value(&d->what, d->env, w->sample), SM_F64));
    vec_push(d->what.arena, &d->changed, ir);
}

static void settle_local(DeadSensor *d, const Var *local)
{
    const Stores *list = &d->s->stores[local->index];

    if (d->local[local->index] == d->question || d->depth == DEPTH || local->outside)
        return;
    d->local[local->index] = d->question;
    d->depth++;
    for (size_t i = 0; i < list->n; i++) {
        expr_walk(list->at[i].stmt->value, settle, d);
        for (const Condition *when = list->at[i].when; when; when = when->outer)
            expr_walk(when->stmt->value, settle, d);
    }
    d->depth--;
    settle_at(d, local);
}

static void settle(Expr *e, void *context)
{
    DeadSensor *d = context;

    if (e->kind == EX_ROLL)
        settle_window(d, &d->s->a->p->window.at[e->window], d->what.m->window_of[e->window]);
    else if (e->kind == EX_VAR && e->var->kind == VAR_LOCAL && looks_at(&d->s->looks[e->var->index], d->sensor))
        settle_local(d, e->var);
}

// ---- questions ----

void dead_sensor_reads(DeadSensor *d, const Var *sensor, Fact f)
{
    for (size_t i = 0; i < d->changed.n; i++)
        d->what.facts->window[d->changed.at[i]] = d->s->a->facts->window[d->changed.at[i]];
    d->changed.n = 0;
    d->question++;
    d->sensor = sensor;
    d->reads = f;
    d->env = suppose(&d->what, d->what.facts->constants, sensor, f);
}

static void look_into(DeadSensor *d, const State *state)
{
    const Numbers *locals = &d->s->local[state->number - 1u], *windows = &d->s->window[state->number - 1u];
    const Program *p = d->s->a->p;

    for (size_t i = 0; i < windows->n; i++) {
        const Window *w = &p->window.at[windows->at[i]];
        expr_walk(w->sample, settle, d);
        settle_window(d, w, d->what.m->window_of[windows->at[i]]);
    }
    for (size_t i = 0; i < locals->n; i++)
        if (looks_at(&d->s->looks[locals->at[i]], d->sensor))
            settle_local(d, p->var.at[locals->at[i]]);
}

static void note_stores(DeadSensor *d, const State *state)
{
    const Numbers *kept = &d->s->kept[state->number - 1u], *stored = &d->s->stored[state->number - 1u];

    d->looks++;
    for (size_t i = 0; i < kept->n; i++)
        d->kept[kept->at[i]] = d->looks;
    for (size_t i = 0; i < stored->n; i++)
        d->stored[stored->at[i]] = d->looks;
}

static const Env *settled_here(const DeadSensor *d, const Env *env, const Var *local)
{
    const uint32_t v = local->index;

    if (d->kept[v] == d->looks)
        return suppose(&d->what, env, local, d->rest[v]);
    if (!d->always[v] && d->stored[v] != d->looks)
        return suppose(&d->what, env, local, fact_of_type(local->type));
    return env;
}

const Env *dead_sensor_settled(DeadSensor *d, const State *state)
{
    const Numbers *list = &d->s->local[state->number - 1u];
    const Env *env;

    look_into(d, state);
    note_stores(d, state);
    env = d->env;
    for (size_t i = 0; i < list->n; i++)
        if (d->local[list->at[i]] == d->question)
            env = settled_here(d, env, d->s->a->p->var.at[list->at[i]]);
    return env;
}

const Env *dead_sensor_begin(DeadSensor *d, const State *state, BlockKind block)
{
    const Numbers *list = &d->s->local[state->number - 1u];
    const EnvShape *shape = &d->what.facts->shape;
    const Env *settled = dead_sensor_settled(d, state);
    const Env *env = suppose(&d->what, facts_begin(d->what.facts, state->number - 1u, (int)block), d->sensor, d->reads);

    for (size_t i = 0; i < list->n; i++) {
        const uint32_t v = d->what.m->var_of[list->at[i]];
        if (d->local[list->at[i]] == d->question)
            env = env_set(shape, env, v, fact_meet(env_get(shape, env, v), env_get(shape, settled, v)));
    }
    return env;
}
