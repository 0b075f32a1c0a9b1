// SPDX-License-Identifier: Apache-2.0
// Notations that can also be written out by hand: definitions, rules for all states, states by name, times, windows in time (language.md 1.36,
// 3.30, 5.56 to 5.75, 7.23 to 7.25).  A pass over a generated program adds them.  It has its own random numbers, so that the rest of a seed's
// program does not change.  Half of the seeds have additions.
#include "tests/diff/gen.h"

#include <stdlib.h>
#include <string.h>

enum { DEFS_MAX = 14, SIZE_MAX_OF_DEF = 150, RULES_MAX = 3 };

bool gen_seed_has_additions(uint64_t seed) { return rng_mix(seed, 11) % 2 != 0; }

// ---- times ----

// A unit of time is times * 10^power seconds.
typedef struct SpanUnit { const char *name; uint32_t times; int power; } SpanUnit;
static const SpanUnit span_unit[] = { { "us", 1, -6 }, { "ms", 1, -3 }, { "s", 1, 0 }, { "min", 6, 1 }, { "h", 36, 2 } };
static const int unit_power[UNIT_COUNT] = { -6, -3, 0 };

static GExpr *new_span(Gen *g, const char *mantissa, int power, const SpanUnit *u, const char *number)
{
    GExpr *e = gen_expr_new(g, G_SPAN, 0);
    const char *gap = rng_percent(&g->rng, 10) ? "  " : rng_percent(&g->rng, 5) ? "\t" : " ";
    e->span = power == 0 ? format_in(g->arena, "%s%s%s", mantissa, gap, u->name) : format_in(g->arena, "%se%d%s%s", mantissa, power, gap, u->name);
    e->text = number;
    return e;
}

// Returns a random time of up to five digits, of which up to three follow the decimal point, in a random unit.
static GExpr *random_span(Gen *g)
{
    const SpanUnit *u = &span_unit[rng_below(&g->rng, sizeof span_unit / sizeof *span_unit)];
    const uint32_t digits = rng_below(&g->rng, rng_percent(&g->rng, 50) ? 100 : 100000), after = rng_below(&g->rng, 4);
    const int power = rng_percent(&g->rng, 10) ? (int)rng_below(&g->rng, 7) - 3 : 0;
    static const uint32_t scale[] = { 1, 10, 100, 1000 };
    const char *mantissa = after == 0 ? format_in(g->arena, "%u", (unsigned)digits)
        : format_in(g->arena, "%u.%0*u", (unsigned)(digits / scale[after]), (int)after, (unsigned)(digits % scale[after]));
    const char *number = format_in(g->arena, "%llue%d", (unsigned long long)digits * u->times, power - (int)after + u->power - unit_power[g->unit]);
    return new_span(g, mantissa, power, u, number);
}

// Returns a time of `units` units of G, written as a decimal number of a random unit.
static GExpr *whole_span(Gen *g, uint32_t units)
{
    const SpanUnit *u = &span_unit[rng_below(&g->rng, sizeof span_unit / sizeof *span_unit)];
    if (units % u->times != 0)
        u = &span_unit[g->unit];
    const char *mantissa = format_in(g->arena, "%u", (unsigned)(units / u->times));
    return new_span(g, mantissa, unit_power[g->unit] - u->power, u, format_in(g->arena, "%u", (unsigned)units));
}

// ---- definitions ----

static GExpr *use_of(Gen *g, GDef *d)
{
    GExpr *e = gen_expr_new(g, G_DEFINED, 0);
    e->def = d;
    return e;
}

static uint32_t expanded_size(const GExpr *e)
{
    uint32_t size = e->kind == G_DEFINED ? e->def->size : 1;
    for (uint32_t i = 0; i < e->n; i++)
        size += expanded_size(e->arg[i]);
    return size;
}

static bool is_constant(const GExpr *e)
{
    bool constant = e->kind == G_DEFINED ? e->def->constant : e->kind != G_VAR && e->kind != G_TIME && e->kind != G_STATE && e->kind != G_ROLL;
    for (uint32_t i = 0; i < e->n; i++)
        constant = constant && is_constant(e->arg[i]);
    return constant;
}

static GDef *new_def(Gen *g, GExpr *value)
{
    GDef *d = ARENA_NEW(g->arena, GDef);
    d->name = gen_new_name(g);
    d->value = value;
    d->size = expanded_size(value);
    d->constant = is_constant(value);
    vec_push(g->arena, &g->def, d);
    return d;
}

// Returns a random earlier definition that can be used here; NULL if no definition can.
static GDef *random_def(Gen *g, bool constant)
{
    GDef *d = g->def.n != 0 ? g->def.at[rng_below(&g->rng, (uint32_t)g->def.n)] : NULL;
    return d != NULL && !d->is_size && d->size <= SIZE_MAX_OF_DEF && (d->constant || !constant) ? d : NULL;
}

static void define(Gen *g, GExpr **place)
{
    if (g->def.n < DEFS_MAX && expanded_size(*place) <= SIZE_MAX_OF_DEF)
        *place = use_of(g, new_def(g, *place));
}

// ---- sizes of windows ----

// Returns the use of a definition as the size of a window: of the definition that already has this value, or of a new one.
static GExpr *defined_size(Gen *g, GExpr *value)
{
    GDef *d = NULL;
    for (size_t i = 0; i < g->def.n && d == NULL; i++)
        if (g->def.at[i]->is_size && g->def.at[i]->value->kind == value->kind && strcmp(g->def.at[i]->value->text, value->text) == 0)
            d = g->def.at[i];
    if (d == NULL && g->def.n >= DEFS_MAX)
        return value;
    if (d == NULL)
        d = new_def(g, value);
    d->is_size = true;
    return use_of(g, d);
}

static GExpr *size_in_time(Gen *g, uint32_t samples)
{
    GExpr *e = whole_span(g, (samples - 1) * g->step);
    e->samples = samples;
    return rng_percent(&g->rng, 30) ? defined_size(g, e) : e;
}

static void rewrite_size(Gen *g, GExpr **place)
{
    GExpr *size = *place, *steps;
    const uint32_t samples = size->kind == G_NUMBER ? (uint32_t)strtoul(size->text, NULL, 10) : 0;
    if (g->step != 0 && samples != 0 && rng_percent(&g->rng, 45)) {
        *place = size_in_time(g, samples);
        return;
    }
    if (samples != 0 && rng_percent(&g->rng, 15))
        size = *place = defined_size(g, size);
    if (size->kind == G_BINARY || rng_percent(&g->rng, 60))
        return;
    steps = gen_expr_new(g, G_STEPS, 1);
    steps->arg[0] = size;
    *place = steps;
}

// ---- expressions ----

static GExpr *state_guard(Gen *g)
{
    GExpr *e = gen_expr_new(g, G_BINARY, 2), *s = gen_expr_new(g, G_VAR, 0), *name = gen_expr_new(g, G_STATE, 0);
    const bool turned = rng_percent(&g->rng, 20);
    s->var = g->var.at[1];
    s->by_alias = rng_percent(&g->rng, 50);
    name->state = g->state.at[rng_below(&g->rng, (uint32_t)g->state.n)];
    e->op = rng_percent(&g->rng, 60) ? SM_OP_EQ : SM_OP_NE;
    e->arg[turned] = s;
    e->arg[!turned] = name;
    return e;
}

static GExpr *rewritten_leaf(Gen *g, GExpr *e, bool constant)
{
    GDef *d = rng_percent(&g->rng, 8) ? random_def(g, constant) : NULL;
    if (d != NULL)
        return use_of(g, d);
    return e->kind == G_NUMBER && rng_percent(&g->rng, 12) ? random_span(g) : e;
}

// Replaces operands in a tree.  The tree must be a copy that shares no node with another tree.
static void rewrite(Gen *g, GExpr **place, bool constant)
{
    GExpr *e = *place;
    const bool is_guard = e->kind == G_BINARY && e->op <= SM_OP_GE;
    if (is_guard && !constant && rng_percent(&g->rng, 8)) {
        *place = state_guard(g);
    } else if (e->n == 0) {
        *place = rewritten_leaf(g, e, constant);
    } else if (e->kind == G_ROLL) {
        rewrite(g, &e->arg[0], constant);
        rewrite_size(g, &e->arg[1]);
    } else {
        for (uint32_t i = 0; i < e->n; i++) {
            rewrite(g, &e->arg[i], constant);
            if (e->kind == G_CALL && (e->fn == SM_FN_median || e->fn == SM_FN_average) && !gen_can_vary(e->arg[i]))
                e->arg[i] = gen_expr_new(g, G_TIME, 0);
        }
    }
    if (rng_percent(&g->rng, e->n == 0 ? 2 : 10))
        define(g, place);
}

static GExpr *copy_of(Gen *g, const GExpr *e)
{
    GExpr *copy = gen_expr_new(g, e->kind, e->n);
    *copy = *e;
    for (uint32_t i = 0; i < e->n; i++)
        copy->arg[i] = copy_of(g, e->arg[i]);
    return copy;
}

static void rewrite_copy(Gen *g, GExpr **place, bool constant)
{
    *place = copy_of(g, *place);
    rewrite(g, place, constant);
}

static void rewrite_stmts(Gen *g, GStmts *list)
{
    for (size_t i = 0; i < list->n; i++) {
        GStmt *s = list->at[i];
        if (s->value != NULL)
            rewrite_copy(g, &s->value, false);
        rewrite_stmts(g, &s->then);
        rewrite_stmts(g, &s->otherwise);
    }
}

// ---- rules for all states ----

static bool is_excepted(const GRule *r, const GState *s)
{
    bool found = false;
    for (size_t i = 0; i < r->except.n && !found; i++)
        found = r->except.at[i] == s;
    return found;
}

static void except(Gen *g, GRule *r, GState *s)
{
    if (!is_excepted(r, s))
        vec_push(g->arena, &r->except, s);
}

static void except_targets(Gen *g, GRule *r, const GStmts *list)
{
    for (size_t i = 0; i < list->n; i++) {
        if (list->at[i]->kind == G_GOTO)
            except(g, r, list->at[i]->target);
        except_targets(g, r, &list->at[i]->then);
        except_targets(g, r, &list->at[i]->otherwise);
    }
}

// Adds a section [all_states], unless its @except would have to name every state.
static void add_rule(Gen *g)
{
    GRule *r = ARENA_NEW(g->arena, GRule);
    const uint32_t states = (uint32_t)g->state.n;
    gen_random_stmts(g, &r->block, 1 + rng_below(&g->rng, 3), 2, states > 1 && rng_percent(&g->rng, 70));
    except_targets(g, r, &r->block);
    for (uint32_t i = 0; i < states && rng_percent(&g->rng, 40); i++)
        except(g, r, g->state.at[rng_below(&g->rng, states)]);
    r->before = rng_below(&g->rng, states);
    if (r->except.n < states)
        vec_push(g->arena, &g->rule, r);
}

static int by_place(const void *a, const void *b)
{
    const GRule *x = *(GRule *const *)a, *y = *(GRule *const *)b;
    return (x->before > y->before) - (x->before < y->before);
}

// Adds the sections in the order of the file, in which they also run.
static void add_rules(Gen *g)
{
    const uint32_t n = rng_percent(&g->rng, 60) ? 1 + rng_below(&g->rng, RULES_MAX) : 0;
    for (uint32_t i = 0; i < n; i++)
        add_rule(g);
    if (g->rule.n > 1)
        qsort(g->rule.at, g->rule.n, sizeof *g->rule.at, by_place);
}

// ---- all of it ----

static void rewrite_inits(Gen *g)
{
    for (size_t i = 0; i < g->var.n; i++)
        if (g->var.at[i]->init != NULL && g->var.at[i]->roll_size == 0 && !g->var.at[i]->parameter)
            rewrite_copy(g, &g->var.at[i]->init, true);
}

void gen_add(Gen *g)
{
    gen_add_parameters(g);
    g->rng.state = rng_mix(g->seed, 12);
    g->additions = true;
    g->units = g->layout % 2 == 0;
    g->unit = (GUnit)rng_below(&g->rng, UNIT_COUNT);
    g->writes_unit = rng_percent(&g->rng, 50);
    g->step = rng_percent(&g->rng, 70) ? 1 + rng_below(&g->rng, rng_percent(&g->rng, 60) ? 25 : 60) : 0;
    add_rules(g);
    rewrite_inits(g);
    for (size_t i = 0; i < g->rule.n; i++)
        rewrite_stmts(g, &g->rule.at[i]->block);
    for (size_t i = 0; i < g->state.n; i++)
        for (int b = 0; b < 3; b++)
            rewrite_stmts(g, &g->state.at[i]->block[b]);
}

// ---- what a program uses ----

uint32_t gen_samples_in_time(const GExpr *size)
{
    while (size->kind == G_DEFINED)
        size = size->def->value;
    return size->kind == G_SPAN ? size->samples : 0;
}

static void used_by(const GExpr *e, bool *used, bool *window_in_time)
{
    used[e->kind] = true;
    *window_in_time |= e->kind == G_ROLL && gen_samples_in_time(e->arg[1]) != 0;
    for (uint32_t i = 0; i < e->n; i++)
        used_by(e->arg[i], used, window_in_time);
}

static void used_by_stmts(const GStmts *list, bool *used, bool *window_in_time)
{
    for (size_t i = 0; i < list->n; i++) {
        if (list->at[i]->value != NULL)
            used_by(list->at[i]->value, used, window_in_time);
        used_by_stmts(&list->at[i]->then, used, window_in_time);
        used_by_stmts(&list->at[i]->otherwise, used, window_in_time);
    }
}

void gen_additions_used(const Gen *g, bool *used, bool *window_in_time)
{
    for (size_t i = 0; i < g->def.n; i++)
        used_by(g->def.at[i]->value, used, window_in_time);
    for (size_t i = 0; i < g->rule.n; i++)
        used_by_stmts(&g->rule.at[i]->block, used, window_in_time);
    for (size_t i = 0; i < g->state.n; i++)
        for (int b = 0; b < 3; b++)
            used_by_stmts(&g->state.at[i]->block[b], used, window_in_time);
}

bool gen_additions_sample(const Gen *g)
{
    bool used[G_STEPS + 1] = { false }, in_time = false;
    for (size_t i = 0; i < g->def.n; i++)
        used_by(g->def.at[i]->value, used, &in_time);
    for (size_t i = 0; i < g->rule.n; i++)
        used_by_stmts(&g->rule.at[i]->block, used, &in_time);
    return used[G_ROLL];
}
