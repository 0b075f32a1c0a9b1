// SPDX-License-Identifier: Apache-2.0
#include "compiler/report/state_rest.h"

#include <string.h>

#include "compiler/analysis/analysis.h"
#include "stdlib/convert.h"
#include "stdlib/math.h"

typedef struct InState {
    Arena *arena;
    const Var *s;
    SmF64 *value;             // by Var.index, for expr_eval: only the value of S is set
} InState;

static bool is_logic(const Expr *e) { return e->kind == EX_BINARY && (e->op == SM_OP_AND || e->op == SM_OP_OR); }

// Whether the expression depends on S and constants alone.
static bool depends_on_state_only(const InState *k, const Expr *e)
{
    if (e->kind == EX_ROLL || e->kind >= EX_EVERY || (e->kind == EX_VAR && e->var != k->s && !e->var->is_constant))
        return false;
    for (uint32_t i = 0; i < e->n; i++)
        if (!depends_on_state_only(k, e->arg[i]))
            return false;
    return true;
}

// Whether S alone decides if the expression is true; *is_true then receives it.
static bool is_decided(const InState *k, const Expr *e, bool *is_true)
{
    bool one;

    if (depends_on_state_only(k, e)) {
        *is_true = sm_to_bool(expr_eval(e, k->value));
        return true;
    }
    if (e->kind == EX_UNARY && e->op == SM_OP_NOT && is_decided(k, e->arg[0], &one)) {
        *is_true = !one;
        return true;
    }
    for (uint32_t i = 0; is_logic(e) && i < 2; i++)
        if (is_decided(k, e->arg[i], &one) && one == (e->op == SM_OP_OR)) {
            *is_true = one;
            return true;
        }
    return false;
}

// Returns e, or the operand of `and` and `or` that remains because the other one is decided and so has no effect.
static const Expr *skip_decided(const InState *k, const Expr *e)
{
    bool unused;

    while (is_logic(e)) {
        const bool first = is_decided(k, e->arg[0], &unused), second = is_decided(k, e->arg[1], &unused);
        if (first == second)
            break;
        e = e->arg[first ? 1 : 0];
    }
    return e;
}

static void write_rest(const InState *k, const Expr *e, Buf *out);

// Appends an operand of `and`, `or` or `not`, in parentheses if it is one of these and not the same as `outer`.
static void write_operand(const InState *k, const Expr *e, const Expr *outer, Buf *out)
{
    Buf text;
    bool enclosed;

    e = skip_decided(k, e);
    buf_init(&text, k->arena);
    write_rest(k, e, &text);
    enclosed = outer->kind == EX_UNARY ? e->kind == EX_BINARY || e->kind == EX_CHAIN : is_logic(e) && e->op == SM_OP_OR && outer->op == SM_OP_AND;
    enclosed = enclosed && strchr(buf_text(&text), ' ') != NULL;      // the name of a definition needs none
    buf_printf(out, enclosed ? "(%s)" : "%s", buf_text(&text));
}

static void write_rest(const InState *k, const Expr *e, Buf *out)
{
    e = skip_decided(k, e);
    if (!expr_reads(e, k->s) || !(is_logic(e) || (e->kind == EX_UNARY && e->op == SM_OP_NOT))) {
        buf_str(out, source_text(k->arena, e->span));
        return;
    }
    if (e->kind == EX_UNARY) {
        buf_str(out, "not ");
        write_operand(k, e->arg[0], e, out);
        return;
    }
    write_operand(k, e->arg[0], e, out);
    buf_str(out, e->op == SM_OP_AND ? " and " : " or ");
    write_operand(k, e->arg[1], e, out);
}

const char *state_rest(Arena *arena, const Program *p, const State *state, const Expr *e)
{
    InState k = {arena, p->s, ARENA_ARRAY(arena, SmF64, p->var.n + 1u)};
    Buf out;

    k.value[p->s->index] = sm_cell_to_f64(SM_U32, state->number);
    buf_init(&out, arena);
    write_rest(&k, e, &out);
    return buf_text(&out);
}
