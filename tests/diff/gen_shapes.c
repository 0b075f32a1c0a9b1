// SPDX-License-Identifier: Apache-2.0
// Generates shapes that the optimiser searches for, and that random programs contain too rarely.  Examples are whole numbers near the limits of
// types, arithmetic on F32 alone, guards that an earlier guard decides, repeated expressions, windows of narrow elements, and T and G.
#include "tests/diff/gen.h"

#include <stdio.h>
#include <stdlib.h>

static SmOperator pick_operator(Gen *g, SmOperator first, uint32_t n) { return (SmOperator)(first + rng_below(&g->rng, n)); }

static GExpr *binary(Gen *g, SmOperator op, GExpr *a, GExpr *b)
{
    GExpr *e = gen_expr_new(g, G_BINARY, 2);
    e->op = op;
    e->arg[0] = a;
    e->arg[1] = b;
    return e;
}

static GExpr *call(Gen *g, SmBuiltin fn, GExpr *a, GExpr *b)
{
    GExpr *e = gen_expr_new(g, G_CALL, b != NULL ? 2 : 1);
    e->fn = fn;
    e->arg[0] = a;
    e->arg[1] = b;
    return e;
}

static GExpr *text(Gen *g, const char *number)
{
    GExpr *e = gen_expr_new(g, G_NUMBER, 0);
    e->text = number;
    return e;
}

// ---- of one kind of type ----

static bool is_whole(SmType t) { return sm_type_info[t].kind != SM_KIND_FLOAT; }
static bool is_f32(SmType t) { return t == SM_F32; }
static bool is_wide(SmType t) { return t == SM_I64 || t == SM_U64; }
static bool is_float(SmType t) { return !is_whole(t); }
static bool is_narrow(SmType t) { return t != SM_F64; }

typedef bool Likes(SmType t);

// Returns a variable of a preferred type, or a number.
static GExpr *leaf(Gen *g, Likes *likes, const char *const *number, uint32_t numbers)
{
    const uint32_t n = (uint32_t)g->var.n, first = rng_below(&g->rng, n);
    const bool want_number = rng_percent(&g->rng, 30);
    for (uint32_t i = 0; i < n && !want_number; i++) {
        GVar *v = g->var.at[(first + i) % n];
        if (!likes(v->type) || (!v->is_local && !v->listed))
            continue;
        GExpr *e = gen_expr_new(g, G_VAR, 0);
        e->var = v;
        return e;
    }
    return text(g, number[rng_below(&g->rng, numbers)]);
}

static const char *const whole_text[] = {
    "0", "1", "1", "2", "3", "10", "100", "255", "256", "-1", "-2", "-128", "32767", "65535", "65536", "16777215", "16777216", "16777217",
    "2147483646", "2147483647", "2147483648", "-2147483648", "-2147483649", "4294967295", "4294967296", "9007199254740991",
    "9007199254740992", "9007199254740993", "-9007199254740991", "-9007199254740993", "9223372036854775807", "18446744073709551615",
};

static GExpr *whole_leaf(Gen *g)
{
    if (rng_percent(&g->rng, 10))
        return gen_expr_new(g, G_TIME, 0);
    return leaf(g, is_whole, whole_text, rng_percent(&g->rng, 70) ? 10 : sizeof whole_text / sizeof *whole_text);
}

static GExpr *whole_expr(Gen *g, uint32_t depth)
{
    static const SmBuiltin pure[] = { SM_FN_abs, SM_FN_sign, SM_FN_floor, SM_FN_trunc, SM_FN_min, SM_FN_max };
    if (depth == 0 || rng_percent(&g->rng, 15))
        return whole_leaf(g);
    if (rng_percent(&g->rng, 75))
        return binary(g, pick_operator(g, SM_OP_ADD, 3), whole_expr(g, depth - 1), whole_expr(g, depth - 1));
    const uint32_t what = rng_below(&g->rng, 6);
    return call(g, pure[what], whole_expr(g, depth - 1), what >= 4 ? whole_expr(g, depth - 1) : NULL);
}

// Returns a comparison, or the larger or smaller, of 64-bit integers that may be beyond 2^53, or of their absolute values.
static GExpr *wide_expr(Gen *g)
{
    GExpr *side[2];

    for (int k = 0; k < 2; k++) {
        side[k] = leaf(g, is_wide, whole_text, sizeof whole_text / sizeof *whole_text);
        if (rng_percent(&g->rng, 30))
            side[k] = call(g, SM_FN_abs, side[k], NULL);
    }
    if (rng_percent(&g->rng, 60))
        return binary(g, pick_operator(g, SM_OP_EQ, 6), side[0], side[1]);
    return call(g, rng_percent(&g->rng, 50) ? SM_FN_min : SM_FN_max, side[0], side[1]);
}

static const char *const f32_text[] = {
    "0", "1", "0.5", "2", "-1.5", "0.25", "16777216", "16777217", "0.1", "3", "3.4028234663852886e38", "1e-45", "1e-38", "-0.0",
};

static GExpr *f32_leaf(Gen *g) { return leaf(g, is_f32, f32_text, sizeof f32_text / sizeof *f32_text); }

// Returns an expression of F32 operands.  One operation is computed in F32 if its result is stored in an F32; several operations are not.
static GExpr *f32_expr(Gen *g)
{
    GExpr *e = binary(g, pick_operator(g, SM_OP_ADD, 4), f32_leaf(g), f32_leaf(g));
    if (rng_percent(&g->rng, 20))
        return call(g, rng_percent(&g->rng, 50) ? SM_FN_abs : SM_FN_sqrt, f32_leaf(g), NULL);
    return rng_percent(&g->rng, 20) ? binary(g, pick_operator(g, SM_OP_ADD, 4), e, f32_leaf(g)) : e;
}

static GExpr *narrow_window(Gen *g)
{
    GExpr *e = gen_expr_new(g, G_ROLL, 2), *sample = leaf(g, is_narrow, whole_text, 10);
    e->fn = (SmBuiltin)(SM_FN_roll_avg + rng_below(&g->rng, 5));
    e->arg[0] = rng_percent(&g->rng, 25) ? binary(g, pick_operator(g, SM_OP_ADD, 3), sample, whole_leaf(g)) : sample;
    e->arg[1] = text(g, format_in(g->arena, "%u", 1 + (unsigned)rng_below(&g->rng, 12)));
    return e;
}

// Returns T or G minus a value.
static GExpr *time_expr(Gen *g)
{
    GExpr *now = gen_expr_new(g, rng_percent(&g->rng, 50) ? G_TIME : G_VAR, 0);
    now->var = now->kind == G_VAR ? g->var.at[0] : NULL;
    return rng_percent(&g->rng, 50) ? now : binary(g, pick_operator(g, SM_OP_ADD, 2), now, whole_leaf(g));
}

// ---- what was there before ----

void gen_remember(Gen *g, GExpr *e)
{
    g->recent[g->recents++ % GEN_RECENT] = e;
}

static GExpr *recent(Gen *g)
{
    const uint32_t n = g->recents < GEN_RECENT ? (uint32_t)g->recents : GEN_RECENT;
    return n != 0 ? g->recent[rng_below(&g->rng, n)] : whole_expr(g, 2);
}

// Combines a recent expression with an equal one, one with swapped operands, or one with another operator of its kind.
static GExpr *twins(Gen *g)
{
    GExpr *e = recent(g), *twin = gen_expr_new(g, e->kind, e->n);
    *twin = *e;
    if (e->kind == G_BINARY && rng_percent(&g->rng, 60)) {
        twin->arg[0] = e->arg[1];
        twin->arg[1] = e->arg[0];
    }
    if (e->kind == G_BINARY && rng_percent(&g->rng, 30))
        twin->op = e->op >= SM_OP_ADD ? pick_operator(g, SM_OP_ADD, 4) : pick_operator(g, SM_OP_EQ, 6);
    return binary(g, pick_operator(g, SM_OP_ADD, 4), e, twin);
}

GExpr *gen_shape(Gen *g)
{
    const uint32_t what = rng_below(&g->rng, 100);
    if (what < 15)
        return twins(g);
    if (what < 30)
        return recent(g);
    if (what < 36)
        return wide_expr(g);
    if (what < 60)
        return whole_expr(g, 1 + rng_below(&g->rng, 3));
    if (what < 80)
        return f32_expr(g);
    return what < 92 ? time_expr(g) : narrow_window(g);
}

// ---- guards that decide each other ----

static const char *number_near(Gen *g, const char *number)
{
    static const double step[] = { 0, 0, 1, -1, 0.5, 1000 };
    char out[40];
    const double x = strtod(number, NULL) + step[rng_below(&g->rng, 6)];
    snprintf(out, sizeof out, "%.17g", rng_percent(&g->rng, 5) ? -x : x);
    return out[0] == 'i' || out[1] == 'i' ? "1" : format_in(g->arena, "%s", out);
}

// Returns one to three relations, joined by AND and OR, mostly of one sensor.  A sensor can be NaN, and is then read as 0.
static GExpr *reading_guard(Gen *g)
{
    static const char *const limit[] = { "-1000", "-5", "-0.5", "-0.0", "0", "0.5", "5", "1000" };
    GExpr *x = leaf(g, is_float, limit, 8), *e = NULL, *more;
    for (uint32_t n = rng_below(&g->rng, 3) + 1; n > 0; n--) {
        more = binary(g, pick_operator(g, SM_OP_EQ, 6), x, text(g, limit[rng_below(&g->rng, 8)]));
        if (rng_percent(&g->rng, 15)) {
            GExpr *not = gen_expr_new(g, G_UNARY, 1);
            not->op = SM_OP_NOT;
            not->arg[0] = more;
            more = not;
        }
        e = e == NULL ? more : binary(g, rng_percent(&g->rng, 50) ? SM_OP_AND : SM_OP_OR, e, more);
        if (rng_percent(&g->rng, 20))
            x = leaf(g, is_float, limit, 8);
    }
    return e;
}

// Returns a relation between a variable and a number.  Often the variable is that of the last one, and the number is near that of the last one.
GExpr *gen_plain_guard(Gen *g)
{
    GExpr *e = g->last_guard, *value, *limit;
    if (rng_percent(&g->rng, 15))
        return reading_guard(g);
    if (e != NULL && rng_percent(&g->rng, 70)) {
        value = e->arg[0];
        limit = text(g, number_near(g, e->arg[1]->text));
    } else {
        value = rng_percent(&g->rng, 15) ? time_expr(g) : leaf(g, rng_percent(&g->rng, 60) ? is_narrow : is_f32, whole_text, 10);
        limit = text(g, whole_text[rng_below(&g->rng, rng_percent(&g->rng, 70) ? 10 : sizeof whole_text / sizeof *whole_text)]);
    }
    e = binary(g, pick_operator(g, SM_OP_EQ, 6), value, limit);
    return g->last_guard = e;
}
