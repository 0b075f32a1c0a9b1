// SPDX-License-Identifier: Apache-2.0
// Generates a program tree from a seed.  The program is valid by construction: the generator never builds what the language forbids, such as a
// transition in .exit, a write to a read-only variable, or a window whose size is not constant.
#include "tests/diff/gen.h"

#include <string.h>

// ---- random numbers: splitmix64 ----

static uint64_t scramble(uint64_t z)
{
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
    z = (z ^ z >> 27) * 0x94D049BB133111EBu;
    return z ^ z >> 31;
}

uint64_t rng_mix(uint64_t a, uint64_t b) { return scramble(scramble(a + 0x9E3779B97F4A7C15u) ^ (b + 0xD1B54A32D192ED03u)); }
uint64_t rng_u64(Rng *r) { return scramble(r->state += 0x9E3779B97F4A7C15u); }
uint32_t rng_below(Rng *r, uint32_t n) { return (uint32_t)((rng_u64(r) >> 32) * n >> 32); }
bool rng_percent(Rng *r, uint32_t percent) { return rng_below(r, 100) < percent; }

// ---- names ----

static const char *const odd_name[] = {
    "int", "while", "double", "errno", "NULL", "EOF", "m", "sv", "x", "X", "i", "self", "state", "step", "init",
    "start", "stored", "median", "average", "max", "min", "abs", "roll_avg", "sqrt", "orbit", "note", "android", "iffy", "_x", "__y",
    "_Z", "class", "new", "this", "union", "main", "bool_", "u8", "I9", "inf", "nan", "NAN", "INFINITY", "true_",
    "t", "g", "s", "flags", "sm_add", "sm_bits", "uint8_t", "size_t", "linux", "unix", "assert", "register",
    "entry", "exit", "slot", "count", "next", "window", "local", "all_states_", "delta_t", "lock", "a", "b", "c",
    "d", "e", "e1", "E1", "x0", "x1",
};

static bool name_is_used(const Gen *g, const char *name)
{
    for (size_t i = 0; i < g->used_name.n; i++)
        if (strcmp(g->used_name.at[i], name) == 0)
            return true;
    return false;
}

const char *gen_new_name(Gen *g)
{
    const char *name;
    do {
        if (rng_percent(&g->rng, 35))
            name = odd_name[rng_below(&g->rng, sizeof odd_name / sizeof *odd_name)];
        else
            name = format_in(g->arena, "%c%s%u", "vwpqzVWP_"[rng_below(&g->rng, 9)], rng_percent(&g->rng, 50) ? "" : "alue",
                             (unsigned)rng_below(&g->rng, 1000));
    } while (name_is_used(g, name));
    vec_push(g->arena, &g->used_name, name);
    return name;
}

// ---- expressions ----

GExpr *gen_expr_new(Gen *g, GExprKind kind, uint32_t n)
{
    GExpr *e = ARENA_NEW(g->arena, GExpr);
    e->kind = kind;
    e->n = n;
    return e;
}

static GExpr *number_text(Gen *g, const char *text)
{
    GExpr *e = gen_expr_new(g, G_NUMBER, 0);
    e->text = text;
    return e;
}

static GExpr *random_number(Gen *g) { return number_text(g, gen_number(g->arena, &g->rng, g->mood)); }

// The variables that an expression may read: all of them, or only the locals before `before`, for an expression that the compiler evaluates.
typedef struct Reach { const GVar *before; bool constant; bool rolls; } Reach;

static GExpr *random_var(Gen *g, const Reach *reach)
{
    const uint32_t n = (uint32_t)g->var.n, first = rng_below(&g->rng, n);
    for (uint32_t i = 0; i < n; i++) {
        GVar *v = g->var.at[(first + i) % n];
        if (reach->constant ? !v->is_local || v->id >= reach->before->id : !v->is_local && !v->listed)
            continue;
        GExpr *e = gen_expr_new(g, G_VAR, 0);
        e->var = v;
        e->by_alias = v->alias != NULL && rng_percent(&g->rng, 50);
        return e;
    }
    return random_number(g);
}

static GExpr *random_leaf(Gen *g, const Reach *reach)
{
    if (rng_percent(&g->rng, 35))
        return random_number(g);
    if (!reach->constant && rng_percent(&g->rng, 8))
        return gen_expr_new(g, G_TIME, 0);
    return random_var(g, reach);
}

static GExpr *random_expr(Gen *g, const Reach *reach, uint32_t depth);

static GExpr *random_unary(Gen *g, const Reach *reach, uint32_t depth)
{
    static const SmOperator op[] = { SM_OP_NEG, SM_OP_NEG, SM_OP_NOT, SM_OP_PLUS };
    GExpr *e = gen_expr_new(g, G_UNARY, 1);
    e->op = op[rng_below(&g->rng, 4)];
    e->arg[0] = random_expr(g, reach, depth - 1);
    return e;
}

static GExpr *random_binary(Gen *g, const Reach *reach, uint32_t depth)
{
    GExpr *e = gen_expr_new(g, G_BINARY, 2);
    e->op = (SmOperator)(rng_percent(&g->rng, 60) ? SM_OP_ADD + rng_below(&g->rng, 4) : SM_OP_OR + rng_below(&g->rng, 8));
    e->arg[0] = random_expr(g, reach, depth - 1);
    e->arg[1] = rng_percent(&g->rng, 5) ? e->arg[0] : random_expr(g, reach, depth - 1);      // sometimes x - x, x / x
    return e;
}

static GExpr *random_chain(Gen *g, const Reach *reach, uint32_t depth)
{
    GExpr *e = gen_expr_new(g, G_CHAIN, 3 + rng_below(&g->rng, 2));
    for (uint32_t i = 0; i < e->n; i++)
        e->arg[i] = random_expr(g, reach, depth > 2 ? 2 : depth - 1);
    for (uint32_t i = 0; i + 1 < e->n; i++)
        e->ops[i] = (SmOperator)(SM_OP_LT + rng_below(&g->rng, 4));
    return e;
}

static SmBuiltin random_function_of_one(Gen *g)
{
    SmBuiltin of_one[SM_FN_COUNT];
    uint32_t n = 0;

    for (int fn = 0; fn < SM_FN_COUNT; fn++)
        if (sm_builtin_info[fn].arguments == 1)
            of_one[n++] = (SmBuiltin)fn;
    return of_one[rng_below(&g->rng, n)];
}

// Whether the value of e can change, so that it is no constant for median and average. Locals may be marked @read_only later.
bool gen_can_vary(const GExpr *e)
{
    bool varies = e->kind == G_TIME || e->kind == G_ROLL || (e->kind == G_DEFINED && gen_can_vary(e->def->value)) || (e->kind == G_VAR && !e->var->is_local);

    for (uint32_t i = 0; i < e->n && !varies; i++)
        varies = gen_can_vary(e->arg[i]);
    return varies;
}

// Returns min, max, median or average, mostly of few values.  Often all are variables, so that whole numbers and values that are never NaN are
// frequent.
static GExpr *random_list(Gen *g, const Reach *reach, uint32_t depth, SmBuiltin fn)
{
    const uint32_t most = rng_percent(&g->rng, 90) ? 5 : SM_LIST_MAX;
    GExpr *e = gen_expr_new(g, G_CALL, 2 + rng_below(&g->rng, most - 1));
    const bool of_variables = rng_percent(&g->rng, 50);

    e->fn = reach->constant && fn == SM_FN_median ? SM_FN_min : reach->constant && fn == SM_FN_average ? SM_FN_max : fn;
    for (uint32_t i = 0; i < e->n; i++) {
        e->arg[i] = of_variables ? random_var(g, reach) : random_expr(g, reach, e->n > 5 ? 1 : depth - 1);
        if ((e->fn == SM_FN_median || e->fn == SM_FN_average) && !gen_can_vary(e->arg[i]))
            e->arg[i] = gen_expr_new(g, G_TIME, 0);
    }
    return e;
}

static GExpr *random_call(Gen *g, const Reach *reach, uint32_t depth)
{
    const SmBuiltin fn = (SmBuiltin)rng_below(&g->rng, SM_FN_roll_avg);           // the pure ones come first
    GExpr *e;

    if (sm_builtin_info[fn].most == SM_LIST_MAX)
        return random_list(g, reach, depth, fn);
    e = gen_expr_new(g, G_CALL, sm_builtin_info[fn].arguments);
    e->fn = fn;
    for (uint32_t i = 0; i < e->n; i++)
        e->arg[i] = random_expr(g, reach, depth - 1);
    return e;
}

static const char *unsigned_text(Gen *g, uint32_t v) { return format_in(g->arena, "%u", (unsigned)v); }

static GExpr *size_of_local(Gen *g)
{
    for (size_t i = 0; i < g->var.n; i++)
        if (g->var.at[i]->roll_size != 0 && rng_percent(&g->rng, 60)) {
            GExpr *e = gen_expr_new(g, G_VAR, 0);
            e->var = g->var.at[i];
            return e;
        }
    return NULL;
}

// Returns a constant from 1 to a few dozen, sometimes a few hundred.
static GExpr *random_size(Gen *g)
{
    const uint32_t most = rng_percent(&g->rng, 3) ? 600 : rng_percent(&g->rng, 20) ? 90 : 9;
    GExpr *literal = number_text(g, unsigned_text(g, 1 + rng_below(&g->rng, most))), *e;
    GExpr *local = rng_percent(&g->rng, 30) ? size_of_local(g) : NULL;
    if (local == NULL)
        return literal;
    if (rng_percent(&g->rng, 50))
        return local;
    e = gen_expr_new(g, G_BINARY, 2);
    e->op = SM_OP_ADD;
    e->arg[0] = local;
    e->arg[1] = literal;
    return e;
}

// Returns the sample of the last window, unchanged or with another operator or function.
static GExpr *similar_sample(Gen *g)
{
    GExpr *e = gen_expr_new(g, G_NUMBER, 0);
    *e = *g->last_roll->arg[0];
    if (e->kind == G_BINARY && rng_percent(&g->rng, 70))
        e->op = e->op >= SM_OP_ADD ? (SmOperator)(SM_OP_ADD + rng_below(&g->rng, 4)) : (SmOperator)rng_below(&g->rng, 8);
    if (e->kind == G_CALL && e->n == 1)
        e->fn = random_function_of_one(g);
    return e;
}

static GExpr *similar_roll(Gen *g)
{
    GExpr *e = gen_expr_new(g, G_ROLL, 2);
    e->fn = (SmBuiltin)(SM_FN_roll_avg + rng_below(&g->rng, 5));
    e->arg[0] = similar_sample(g);
    e->arg[1] = g->last_roll->arg[1];
    return e;
}

static GExpr *random_roll(Gen *g, const Reach *reach, uint32_t depth)
{
    if (g->last_roll != NULL && rng_percent(&g->rng, 35))
        return similar_roll(g);
    GExpr *e = gen_expr_new(g, G_ROLL, 2);
    e->fn = (SmBuiltin)(SM_FN_roll_avg + rng_below(&g->rng, 5));
    e->arg[0] = random_expr(g, reach, depth > 3 ? 2 : depth - 1);
    e->arg[1] = random_size(g);
    g->last_roll = e;
    return e;
}

// Returns the difference or quotient of two equal values, which are infinite unless the operand is small: then it is NaN.
static GExpr *lost_difference(Gen *g, const Reach *reach)
{
    GExpr *e = gen_expr_new(g, G_BINARY, 2), *far = gen_expr_new(g, G_BINARY, 2);
    far->op = SM_OP_MUL;
    far->arg[0] = random_leaf(g, reach);
    far->arg[1] = number_text(g, "1.5e308");
    e->op = rng_percent(&g->rng, 50) ? SM_OP_SUB : SM_OP_DIV;
    e->arg[0] = e->arg[1] = far;
    return e;
}

// Returns an expression whose results include NaN, infinities and limits of types: x / x, sqrt(x - y), x / 0, x * 1e308.
static GExpr *random_spice(Gen *g, const Reach *reach)
{
    if (rng_percent(&g->rng, 15))
        return lost_difference(g, reach);
    static const SmOperator op[] = { SM_OP_DIV, SM_OP_SUB, SM_OP_DIV, SM_OP_MUL };
    static const char *const edge[] = { "0", "0", "1e308", "1e-308", "1e300" };
    const uint32_t what = rng_below(&g->rng, 4);
    GExpr *e = gen_expr_new(g, G_BINARY, 2), *root;
    e->op = op[what];
    e->arg[0] = random_leaf(g, reach);
    e->arg[1] = what == 0 ? e->arg[0] : what == 1 ? random_leaf(g, reach) : number_text(g, edge[rng_below(&g->rng, 5)]);
    if (what != 1)
        return e;
    root = gen_expr_new(g, G_CALL, 1);
    root->fn = SM_FN_sqrt;
    root->arg[0] = e;
    return root;
}

static GExpr *random_expr(Gen *g, const Reach *reach, uint32_t depth)
{
    const uint32_t what = rng_below(&g->rng, 100);
    if (depth > 0 && !reach->constant && rng_percent(&g->rng, 8))
        return gen_shape(g);
    if (depth == 0 || what < 17)
        return random_leaf(g, reach);
    if (what < 25)
        return random_spice(g, reach);
    if (what < 37)
        return random_unary(g, reach, depth);
    if (what < 78)
        return random_binary(g, reach, depth);
    if (what < 83)
        return random_chain(g, reach, depth);
    if (what < 94 || !reach->rolls)
        return random_call(g, reach, depth);
    return random_roll(g, reach, depth);
}

static const Reach everywhere = { NULL, false, true };

static uint32_t random_depth(Gen *g) { return rng_percent(&g->rng, 3) ? 7 : rng_below(&g->rng, 5); }

// Returns a random guard.  Most are comparisons, so that both branches are taken.
static GExpr *random_guard(Gen *g)
{
    if (rng_percent(&g->rng, 30))
        return gen_plain_guard(g);
    if (rng_percent(&g->rng, 30))
        return random_expr(g, &everywhere, random_depth(g));
    if (rng_percent(&g->rng, 15))
        return random_chain(g, &everywhere, 2);
    GExpr *e = gen_expr_new(g, G_BINARY, 2);
    e->op = (SmOperator)(SM_OP_EQ + rng_below(&g->rng, 6));
    e->arg[0] = random_expr(g, &everywhere, rng_below(&g->rng, 3));
    e->arg[1] = random_expr(g, &everywhere, rng_below(&g->rng, 2));
    return e;
}

// Returns a guard that becomes true after some time.
static GExpr *leaving_guard(Gen *g)
{
    if (rng_percent(&g->rng, 60))
        return random_guard(g);
    GExpr *e = gen_expr_new(g, G_BINARY, 2);
    e->op = rng_percent(&g->rng, 50) ? SM_OP_GE : SM_OP_GT;
    e->arg[0] = gen_expr_new(g, G_TIME, 0);
    e->arg[1] = number_text(g, unsigned_text(g, rng_below(&g->rng, 60)));
    return e;
}

// ---- statements ----

static GVar *random_target(Gen *g)
{
    const uint32_t n = (uint32_t)g->var.n, first = rng_below(&g->rng, n);
    for (uint32_t i = 0; i < n; i++) {
        GVar *v = g->var.at[(first + i) % n];
        if (!v->read_only && (v->is_local || v->listed))
            return v;
    }
    return NULL;
}

static GStmt *new_stmt(Gen *g, GStmtKind kind)
{
    GStmt *s = ARENA_NEW(g->arena, GStmt);
    s->kind = kind;
    return s;
}

// Returns a sum, difference or product of two operands.  Assigned repeatedly, it counts, or reaches the limits of its type.
static GExpr *growing_expr(Gen *g)
{
    GExpr *e = gen_expr_new(g, G_BINARY, 2);
    e->op = (SmOperator)(SM_OP_ADD + rng_below(&g->rng, 3));
    e->arg[0] = random_leaf(g, &everywhere);
    e->arg[1] = random_leaf(g, &everywhere);
    return e;
}

// Returns a value clamped to limits that a type may have; it can still be NaN.
static GExpr *limited_expr(Gen *g)
{
    GExpr *e = gen_expr_new(g, G_CALL, 3);
    e->fn = SM_FN_clamp;
    e->arg[0] = rng_percent(&g->rng, 40) ? random_spice(g, &everywhere) : random_expr(g, &everywhere, 2);
    e->arg[1] = random_number(g);
    e->arg[2] = random_number(g);
    return e;
}

static GExpr *random_value(Gen *g)
{
    const uint32_t what = rng_below(&g->rng, 100);
    GExpr *e;
    if (what < 15)
        return gen_shape(g);
    e = what < 35 ? growing_expr(g) : what < 45 ? limited_expr(g) : random_expr(g, &everywhere, random_depth(g));
    if (e->kind != G_NUMBER && e->kind != G_VAR)
        gen_remember(g, e);
    return e;
}

static GStmt *random_assign(Gen *g, GVar *v)
{
    GStmt *s = new_stmt(g, G_ASSIGN);
    s->var = v;
    s->by_alias = v->alias != NULL && rng_percent(&g->rng, 50);
    s->value = random_value(g);
    return s;
}

static GStmt *random_goto(Gen *g)
{
    GStmt *s = new_stmt(g, G_GOTO);
    s->target = g->state.at[rng_below(&g->rng, (uint32_t)g->state.n)];
    return s;
}

static GStmt *random_if(Gen *g, uint32_t depth, bool may_leave)
{
    GStmt *s = new_stmt(g, G_IF);
    s->value = random_guard(g);
    gen_random_stmts(g, &s->then, rng_percent(&g->rng, 60) ? 1 : rng_below(&g->rng, 4), depth - 1, may_leave);
    s->has_else = rng_percent(&g->rng, 40);
    if (s->has_else)
        gen_random_stmts(g, &s->otherwise, rng_percent(&g->rng, 60) ? 1 : rng_below(&g->rng, 3), depth - 1, may_leave);
    return s;
}

static GStmt *leaving_if(Gen *g)
{
    GStmt *s = new_stmt(g, G_IF);
    s->value = leaving_guard(g);
    vec_push(g->arena, &s->then, random_goto(g));
    return s;
}

static GStmt *random_stmt(Gen *g, uint32_t depth, bool may_leave)
{
    const uint32_t what = rng_below(&g->rng, 100);
    GVar *v = random_target(g);
    if (may_leave && what < 15)
        return leaving_if(g);
    if (may_leave && what < 17)
        return random_goto(g);
    if (depth > 0 && (what < 45 || v == NULL))
        return random_if(g, depth, may_leave);
    return v != NULL ? random_assign(g, v) : NULL;
}

// Returns an assignment that reads the variable assigned by `before`: it computes a value for the same or another variable, or copies it.
static GStmt *next_assign(Gen *g, const GStmt *before)
{
    const uint32_t what = rng_below(&g->rng, 100);
    GStmt *s = random_assign(g, what < 50 ? before->var : random_target(g));
    GExpr *e = gen_expr_new(g, G_VAR, 0), *value = gen_expr_new(g, G_BINARY, 2);
    e->var = before->var;
    if (what >= 80) {
        s->value = e;
    } else if (what >= 25 && s->value->kind == G_BINARY) {
        *value = *s->value;               // other trees may share the node
        value->arg[rng_below(&g->rng, 2)] = e;
        s->value = value;
    }
    return s;
}

void gen_random_stmts(Gen *g, GStmts *list, uint32_t n, uint32_t depth, bool may_leave)
{
    for (uint32_t i = 0; i < n; i++) {
        GStmt *s = random_stmt(g, depth, may_leave);
        if (s != NULL)
            vec_push(g->arena, list, s);
        while (s != NULL && s->kind == G_ASSIGN && rng_percent(&g->rng, 25)) {
            s = next_assign(g, s);
            vec_push(g->arena, list, s);
        }
    }
}

void gen_random_state(Gen *g, GState *s)
{
    const uint32_t depth = rng_percent(&g->rng, 5) ? 6 : 2;
    s->present[0] = rng_percent(&g->rng, 50);
    s->present[1] = rng_percent(&g->rng, 92);
    s->present[2] = rng_percent(&g->rng, 40);
    if (s->present[0])
        gen_random_stmts(g, &s->block[0], rng_below(&g->rng, 4), depth, rng_percent(&g->rng, 30));
    if (s->present[1])
        gen_random_stmts(g, &s->block[1], 1 + rng_below(&g->rng, 7), depth, true);
    if (s->present[1] && rng_percent(&g->rng, 75))
        vec_push(g->arena, &s->block[1], leaving_if(g));
    if (s->present[2])
        gen_random_stmts(g, &s->block[2], rng_below(&g->rng, 4), depth, false);
}

// ---- declarations ----

static GVar *new_var(Gen *g, SmType type, const char *name)
{
    GVar *v = ARENA_NEW(g->arena, GVar);
    v->id = (uint32_t)g->var.n;
    v->type = type;
    v->name = name;
    v->listed = true;
    v->region = rng_below(&g->rng, g->regions);
    vec_push(g->arena, &g->var, v);
    return v;
}

GVar *gen_new_local(Gen *g, SmType type)
{
    GVar *v = new_var(g, type, gen_new_name(g));
    v->is_local = true;
    vec_push(g->arena, &g->order, v);
    return v;
}

// Declares G or S: under this name, or as the alias of another name.
static void declare_role(Gen *g, const char *role, SmType type)
{
    const bool aliased = rng_percent(&g->rng, 40);
    GVar *v = new_var(g, type, aliased ? gen_new_name(g) : role);
    v->alias = aliased ? role : NULL;
    v->read_only = true;
    v->outside = rng_percent(&g->rng, 30) || type == SM_U64;      // the test may also write S, which has no effect
}

static SmType random_type(Gen *g)
{
    return rng_percent(&g->rng, 20) ? SM_F64 : (SmType)rng_below(&g->rng, SM_TYPE_COUNT);
}

static void declare_element(Gen *g)
{
    GVar *v = new_var(g, random_type(g), gen_new_name(g));
    v->listed = !g->with_sv || rng_percent(&g->rng, 75);
    v->alias = v->listed && rng_percent(&g->rng, 15) ? gen_new_name(g) : NULL;
    v->read_only = rng_percent(&g->rng, 20);
    v->outside = v->read_only || rng_percent(&g->rng, 60);
}

static void declare_local(Gen *g)
{
    GVar *v = new_var(g, random_type(g), gen_new_name(g));
    const Reach reach = { v, true, false };
    v->is_local = true;
    v->read_only = rng_percent(&g->rng, 25);
    v->outside = rng_percent(&g->rng, 15);
    if (rng_percent(&g->rng, 20)) {
        v->roll_size = 1 + rng_below(&g->rng, 12);
        v->type = v->type == SM_BOOL ? SM_U8 : v->type;
        v->init = number_text(g, unsigned_text(g, v->roll_size));
    } else {
        v->init = random_expr(g, &reach, rng_below(&g->rng, 4));
    }
}

static GVar **shuffled(Gen *g, bool for_sv, size_t *n)
{
    GVar **list = ARENA_ARRAY(g->arena, GVar *, g->var.n);
    *n = 0;
    for (size_t i = 0; i < g->var.n; i++)
        if (!g->var.at[i]->is_local && (for_sv || g->var.at[i]->listed))
            list[(*n)++] = g->var.at[i];
    for (size_t i = *n; i > 1; i--) {
        const size_t j = rng_below(&g->rng, (uint32_t)i);
        GVar *t = list[j];
        list[j] = list[i - 1];
        list[i - 1] = t;
    }
    return list;
}

static void put_in_order(Gen *g)
{
    size_t n;
    GVar **list = shuffled(g, false, &n);
    for (size_t i = 0; i < n; i++)
        vec_push(g->arena, &g->order, list[i]);
    for (size_t i = 0; i < g->var.n; i++)
        if (g->var.at[i]->is_local)
            vec_push(g->arena, &g->order, g->var.at[i]);
    list = shuffled(g, true, &n);
    for (size_t i = 0; i < n; i++)
        vec_push(g->arena, &g->sv_order, list[i]);
}

static void declare_all(Gen *g)
{
    const uint32_t elements = 1 + rng_below(&g->rng, 9), locals = rng_below(&g->rng, 6);
    g->with_sv = rng_percent(&g->rng, 50);
    g->regions = g->with_sv ? 1 + rng_below(&g->rng, GEN_REGIONS_MAX) : 1;
    for (uint32_t i = 0; i < g->regions; i++)
        g->region_name[i] = format_in(g->arena, rng_percent(&g->rng, 20) ? "bus/r%u" : "Region%u", (unsigned)i);
    declare_role(g, "G", SM_U64);
    declare_role(g, "S", SM_U32);
    for (uint32_t i = 0; i < elements; i++)
        declare_element(g);
    for (uint32_t i = 0; i < locals; i++)
        declare_local(g);
    put_in_order(g);
}

// State names have their own namespace: a state may have the name of an element.
static const char *state_name(Gen *g, uint32_t i)
{
    if (rng_percent(&g->rng, 10) && g->var.at[i % g->var.n]->name[0] != 'R')
        return format_in(g->arena, "%s_%u", g->var.at[i % g->var.n]->name, (unsigned)i);
    return format_in(g->arena, rng_percent(&g->rng, 50) ? "St%u" : "hold_%u", (unsigned)i);
}

uint32_t gen_state_number(const Gen *g, uint32_t index)
{
    uint32_t number = 1;
    if (g->state.at[index]->removed)
        return 1;
    for (uint32_t i = 0; i < index; i++)
        number += !g->state.at[i]->removed;
    return number;
}

Gen *gen_program(Arena *arena, uint64_t seed, uint32_t steps)
{
    static const char *const reserved[] = { "G", "S", "T", "if", "else", "and", "or", "not", "true", "false", "bool" };
    static const char *const stem[] = { "app", "tank", "my-tank.v2", "int", "a" };
    Gen *g = ARENA_NEW(arena, Gen);
    g->arena = arena;
    g->seed = seed;
    g->rng.state = rng_mix(seed, 1);
    g->layout = rng_mix(seed, 2);
    g->mood = rng_percent(&g->rng, 15) ? 0 : 1;
    g->steps = steps;
    g->machine_name = stem[rng_below(&g->rng, sizeof stem / sizeof *stem)];
    for (size_t i = 0; i < sizeof reserved / sizeof *reserved; i++)
        vec_push(arena, &g->used_name, reserved[i]);
    declare_all(g);
    const uint32_t states = 1 + rng_below(&g->rng, rng_percent(&g->rng, 5) ? 20 : 6);
    for (uint32_t i = 0; i < states; i++)
        vec_push(arena, &g->state, ARENA_NEW(arena, GState));
    for (uint32_t i = 0; i < states; i++) {
        g->state.at[i]->name = state_name(g, i);
        gen_random_state(g, g->state.at[i]);
    }
    g->first_state = rng_percent(&g->rng, 75) ? 0 : rng_below(&g->rng, states);
    g->states = states;
    gen_plan_time(g);
    if (gen_seed_has_additions(seed))
        gen_add(g);
    return g;
}
