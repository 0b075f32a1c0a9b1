// SPDX-License-Identifier: Apache-2.0
// Parameters (language.md 5.77 to 5.84).  A third of the programs with additions declare some and read them in place of some operands, and their
// inputs set them before the first step.  The parameters have their own random numbers.
#include "tests/diff/gen.h"

#include "stdlib/convert.h"

enum { PARAMETERS_MAX = 3 };

// Returns the distance between the possible values of a parameter.  All of them are exact in its type.
static double grid(SmType type) { return type == SM_F32 || type == SM_F64 ? 0.125 : 1; }

static double random_between(Gen *g, SmType type, double lo, double hi)
{
    const uint32_t steps = (uint32_t)((hi - lo) / grid(type));
    const uint32_t which = rng_below(&g->rng, 10);
    return which < 2 ? lo : which < 4 ? hi : lo + grid(type) * rng_below(&g->rng, steps + 1);
}

void gen_random_range(Gen *g, GVar *v)
{
    const bool is_signed = sm_type_info[v->type].kind == SM_KIND_SIGNED || sm_type_info[v->type].kind == SM_KIND_FLOAT;
    const double below = grid(v->type) * rng_below(&g->rng, 40), above = grid(v->type) * rng_below(&g->rng, 40);
    v->lo = v->type == SM_BOOL || (!is_signed && v->standard < below) ? 0 : v->standard - below;
    v->hi = v->type == SM_BOOL ? 1 : v->standard + above;
}

static void declare(Gen *g)
{
    GVar *v = gen_new_local(g, (SmType)rng_below(&g->rng, SM_TYPE_COUNT));
    const bool is_unsigned = sm_type_info[v->type].kind == SM_KIND_UNSIGNED || v->type == SM_BOOL;
    v->parameter = v->read_only = true;
    v->standard = v->type == SM_BOOL ? rng_below(&g->rng, 2) : grid(v->type) * ((double)rng_below(&g->rng, 80) - (is_unsigned ? 0 : 40));
    gen_random_range(g, v);
    v->is_set = rng_percent(&g->rng, 60);
    v->set = random_between(g, v->type, v->lo, v->hi);
    v->init = gen_expr_new(g, G_NUMBER, 0);
    v->init->text = format_in(g->arena, "%.17g", v->standard);
}

static GExpr *read_of(Gen *g, uint32_t first)
{
    GExpr *e = gen_expr_new(g, G_VAR, 0);
    e->var = g->var.at[first + rng_below(&g->rng, (uint32_t)g->var.n - first)];
    return e;
}

// Replaces some operands by reads of parameters.  The size of a window is not changed.
static GExpr *replace_operands(Gen *g, GExpr *e, uint32_t first)
{
    if ((e->kind == G_NUMBER || e->kind == G_VAR) && rng_percent(&g->rng, 12))
        return read_of(g, first);
    for (uint32_t i = 0; i < (e->kind == G_ROLL ? 1 : e->n); i++)
        e->arg[i] = replace_operands(g, e->arg[i], first);
    return e;
}

static void rewrite_stmts(Gen *g, GStmts *list, uint32_t first)
{
    for (size_t i = 0; i < list->n; i++) {
        if (list->at[i]->value != NULL)
            list->at[i]->value = replace_operands(g, list->at[i]->value, first);
        rewrite_stmts(g, &list->at[i]->then, first);
        rewrite_stmts(g, &list->at[i]->otherwise, first);
    }
}

void gen_add_parameters(Gen *g)
{
    const uint32_t first = (uint32_t)g->var.n;
    g->rng.state = rng_mix(g->seed, 30);
    if (!rng_percent(&g->rng, 33))
        return;
    for (uint32_t n = 1 + rng_below(&g->rng, PARAMETERS_MAX); n > 0; n--)
        declare(g);
    for (size_t i = 0; i < g->state.n; i++)
        for (int b = 0; b < 3; b++)
            rewrite_stmts(g, &g->state.at[i]->block[b], first);
    g->last_guard = g->last_roll = NULL;              // the expressions may have been changed
}

uint64_t gen_parameter_cell(const GVar *v) { return sm_cell_from_f64(v->type, v->set); }

bool gen_sets_parameter(const Gen *g)
{
    for (size_t i = 0; i < g->var.n; i++)
        if (g->var.at[i]->parameter && g->var.at[i]->is_set && g->var.at[i]->set != g->var.at[i]->standard)
            return true;
    return false;
}
