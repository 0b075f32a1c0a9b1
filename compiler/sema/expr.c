// SPDX-License-Identifier: Apache-2.0
// Operations on typed expressions: visit, compare, evaluate.  AST_DEPTH_MAX bounds the recursion depth.
#include "compiler/sema/list.h"
#include "compiler/sema/program.h"

#include <stdio.h>
#include <string.h>

#include "compiler/base/buf.h"
#include "stdlib/convert.h"
#include "stdlib/elementary.h"
#include "stdlib/math.h"

// ---- visit, compare ----

// Calls f(x, context) for e and all its subexpressions, operands before the expression that owns them.
void expr_walk(Expr *e, void (*f)(Expr *e, void *context), void *context)
{
    for (uint32_t i = 0; i < e->n; i++)
        expr_walk(e->arg[i], f, context);
    f(e, context);
}

bool expr_is_same_operation(const Expr *a, const Expr *b)
{
    if (a->kind != b->kind || a->n != b->n)
        return false;
    switch (a->kind) {
    case EX_NUMBER: return sm_bits(a->number) == sm_bits(b->number);
    case EX_VAR: return a->var == b->var;
    case EX_UNARY:
    case EX_BINARY: return a->op == b->op;
    case EX_CHAIN: return memcmp(expr_ops(a), expr_ops(b), (a->n - 1) * sizeof(SmOperator)) == 0;
    case EX_CALL: return a->fn == b->fn;
    case EX_EVERY: case EX_AT: return sm_eq(a->number, b->number);
    case EX_RANDOM: return a->window == b->window;
    case EX_ROLL: return a->stat == b->stat;
    }
    return false;
}

// Whether two expressions apply the same operators to the same numbers, variables and statistics.
bool expr_equal(const Expr *a, const Expr *b, const uint32_t *window_of)
{
    if (!expr_is_same_operation(a, b))
        return false;
    if (a->kind == EX_ROLL)
        return window_of ? window_of[a->window] == window_of[b->window] : a->window == b->window;
    for (uint32_t i = 0; i < a->n; i++)
        if (!expr_equal(a->arg[i], b->arg[i], window_of))
            return false;
    return true;
}

// ---- evaluate ----

// Constant evaluation calls the functions of stdlib that also run on targets, so that the results have the same bits.  ir/eval.c evaluates
// IR operations with the same functions, but shares no code with this file: the IR has no chains and no clamp, and sema cannot use the IR.

static bool eval_relation(SmOperator op, SmF64 a, SmF64 b)
{
    return op == SM_OP_LT ? sm_lt(a, b) : op == SM_OP_LE ? sm_le(a, b) : op == SM_OP_GT ? sm_lt(b, a) : sm_le(b, a);
}

static SmF64 eval_binary(SmOperator op, SmF64 a, SmF64 b)
{
    switch (op) {
    case SM_OP_OR:  return sm_from_bool(sm_to_bool(a) || sm_to_bool(b));
    case SM_OP_AND: return sm_from_bool(sm_to_bool(a) && sm_to_bool(b));
    case SM_OP_EQ:  return sm_from_bool(sm_eq(a, b));
    case SM_OP_NE:  return sm_from_bool(!sm_eq(a, b));
    case SM_OP_LT: case SM_OP_LE: case SM_OP_GT: case SM_OP_GE: return sm_from_bool(eval_relation(op, a, b));
    case SM_OP_ADD: return sm_add(a, b);
    case SM_OP_SUB: return sm_sub(a, b);
    case SM_OP_MUL: return sm_mul(a, b);
    case SM_OP_DIV: return sm_div(a, b);
    case SM_OP_NOT: case SM_OP_NEG: case SM_OP_PLUS: case SM_OP_COUNT: break;
    }
    return sm_from_i32(0);                                  // not reached: these operators are not binary
}

// Evaluates a chain of comparisons such as a < b <= c.
static SmF64 eval_chain(const Expr *e, const SmF64 *value)
{
    bool is_true = true;
    SmF64 left = expr_eval(e->arg[0], value);

    for (uint32_t i = 1; i < e->n; i++) {
        SmF64 right = expr_eval(e->arg[i], value);
        is_true = is_true && eval_relation(expr_ops(e)[i - 1], left, right);
        left = right;
    }
    return sm_from_bool(is_true);
}

#define CALL_1(f, v) f(v[0])
#define CALL_2(f, v) f(v[0], v[1])
#define CALL_3(f, v) f(v[0], v[1], v[2])

static SmF64 eval_call(const Expr *e, const SmF64 *value)
{
    SmF64 v[SM_LIST_MAX];

    for (uint32_t i = 0; i < SM_LIST_MAX; i++)
        v[i] = i < e->n ? expr_eval(e->arg[i], value) : sm_from_i32(0);
    switch (e->fn) {
#define SM_PURE(name, arguments, usage, units, sentence) case SM_FN_##name: return CALL_##arguments(sm_##name, v);
#define SM_COMPOSED(name, arguments, usage, units, steps, sentence) SM_PURE(name, arguments, usage, units, sentence)
#define SM_LIST(name, units, sentence) case SM_FN_##name: return list_value(e->fn, e->n, v);
#define SM_ROLL(name, stat, sentence) case SM_FN_##name:
#define SM_SAMPLED(name, arguments, usage, sentence) case SM_FN_##name:
#include "stdlib/builtins.def"
    case SM_FN_COUNT: break;
    }
    return sm_from_i32(0);                                  // not reached: a roll call is an EX_ROLL, not an EX_CALL
}

// Returns the value of an expression for the given values of variables (by Var.index); NULL: for their initial values.
SmF64 expr_eval(const Expr *e, const SmF64 *value)
{
    SmF64 x;
    switch (e->kind) {
    case EX_NUMBER: return e->number;
    case EX_VAR:    return value && !e->var->is_constant ? value[e->var->index] : sm_cell_to_f64(e->var->type, e->var->init);
    case EX_UNARY:  x = expr_eval(e->arg[0], value); return e->op == SM_OP_NOT ? sm_from_bool(!sm_to_bool(x)) : sm_neg(x);
    case EX_BINARY: return eval_binary(e->op, expr_eval(e->arg[0], value), expr_eval(e->arg[1], value));
    case EX_CHAIN:  return eval_chain(e, value);
    case EX_CALL:   return eval_call(e, value);
    case EX_EVERY: case EX_AT: case EX_RANDOM: break;             // only scripts have these, and the script engine evaluates them
    case EX_ROLL:   return value && e->stat != SM_STAT_RANGE && e->stat < SM_STAT_CHANGE ? expr_eval(e->arg[0], value) : sm_from_i32(0);    // all samples are equal
    }
    return sm_from_i32(0);
}

// Returns the value of a constant expression.  If e reads a local that is not constant, uses its initial value.
SmF64 expr_constant_value(const Expr *e) { return expr_eval(e, NULL); }

// Whether the value of e never changes: it contains only numbers, constant locals, operators and pure functions.
bool expr_is_constant(const Expr *e)
{
    if (e->kind == EX_ROLL || e->kind >= EX_EVERY || (e->kind == EX_VAR && !e->var->is_constant))
        return false;
    for (uint32_t i = 0; i < e->n; i++)
        if (!expr_is_constant(e->arg[i]))
            return false;
    return true;
}

bool expr_is_negative_number(const Expr *e)
{
    const Span s = e->span;

    return e->kind == EX_UNARY && e->op == SM_OP_NEG && e->arg[0]->kind == EX_NUMBER && s.len > 1 && s.src->text[s.at] == '-' &&
           strchr("0123456789.", s.src->text[s.at + 1]);
}

// ---- text ----

static const char *const operator_spelling[SM_OP_COUNT] = {
#define SM_OPERATOR(name, spelling, arity, precedence, class) [SM_OP_##name] = spelling,
#include "stdlib/operators.def"
#undef SM_OPERATOR
};

static const char *const builtin_name[SM_FN_COUNT] = {
#define SM_PURE(name, arguments, usage, units, sentence) [SM_FN_##name] = #name,
#define SM_COMPOSED(name, arguments, usage, units, steps, sentence) SM_PURE(name, arguments, usage, units, sentence)
#define SM_LIST(name, units, sentence) SM_PURE(name, 2, "", units, sentence)
#define SM_ROLL(name, stat, sentence) SM_PURE(name, 2, "", SAME, sentence)
#define SM_SAMPLED(name, arguments, usage, sentence) SM_PURE(name, arguments, usage, SAME, sentence)
#include "stdlib/builtins.def"
};

static const char *const statistic_name[SM_STAT_COUNT] = {
    [SM_STAT_OLDEST] = "oldest",
    [SM_STAT_NEWEST] = "newest",
    [SM_STAT_CHANGE] = "change",
    [SM_STAT_ELAPSED] = "elapsed",
    [SM_STAT_RUN_STEPS] = "run_steps",
    [SM_STAT_RUN_TIME] = "run_time",
#define SM_ROLL(name, stat, sentence) [SM_STAT_##stat] = #name,
#include "stdlib/builtins.def"
};

// Appends the name of an expression to `out`: text with which the expression could be written.  Stops soon after `most`
// characters, so that nested calls do not take quadratic time.
typedef struct Namer {
    Arena *arena;
    const Windows *window;
    size_t most;
    Buf *out;
} Namer;

static void append_expr_name(const Namer *n, const Expr *e);

// Appends an operand.  One that contains an operator is put in parentheses, whatever the precedence, so that different trees have different texts.
static void append_operand_name(const Namer *n, const Expr *e)
{
    const bool enclosed = (e->kind == EX_UNARY || e->kind == EX_BINARY || e->kind == EX_CHAIN) && !expr_is_constant(e);

    buf_str(n->out, enclosed ? "(" : "");
    append_expr_name(n, e);
    buf_str(n->out, enclosed ? ")" : "");
}

// Appends a constant.  An infinity and NaN are written as divisions, because `inf` and `NaN` can be names of variables.
static void append_constant_name(const Namer *n, SmF64 x)
{
    if (sm_is_nan(x))
        buf_str(n->out, "0/0");
    else if (sm_is_nan(sm_sub(x, x)))
        buf_str(n->out, sm_lt(x, sm_from_i32(0)) ? "-1/0" : "1/0");
    else
        buf_str(n->out, const_text(n->arena, x));
}

static void append_variable_name(const Namer *n, const Var *v)
{
    if (v->kind == VAR_LOCAL)
        buf_printf(n->out, "%s %s", sm_type_info[v->type].spelling, v->name->text);
    else
        buf_str(n->out, v->name->text);
}

static void append_window_name(const Namer *n, const char *function, const Window *w)
{
    buf_printf(n->out, "%s(", function);
    append_expr_name(n, w->sample);
    buf_printf(n->out, ", %lu)", (unsigned long)w->size);
}

// Returns the state that operand i of `S == Run` names; NULL for any other operand.
static const State *named_state(const Expr *e, uint32_t i)
{
    const Expr *number = e->arg[i], *s = e->kind == EX_BINARY ? e->arg[!i] : NULL;

    return s && number->kind == EX_NUMBER && number->window == 1 && s->kind == EX_VAR && s->var->state_of
               ? s->var->state_of->state.at[sm_to_u32(number->number) - 1]
               : NULL;
}

static void append_operation_name(const Namer *n, const Expr *e)
{
    for (uint32_t i = 0; i < e->n; i++) {
        if (e->kind == EX_UNARY)
            buf_printf(n->out, "%s%s", operator_spelling[e->op], e->op == SM_OP_NOT ? " " : "");
        else if (i > 0)
            buf_printf(n->out, " %s ", operator_spelling[e->kind == EX_CHAIN ? expr_ops(e)[i - 1] : e->op]);
        if (named_state(e, i))
            buf_printf(n->out, "[%s]", named_state(e, i)->name->text);
        else
            append_operand_name(n, e->arg[i]);
    }
}

static void append_call_name(const Namer *n, const Expr *e)
{
    buf_printf(n->out, "%s(", builtin_name[e->fn]);
    for (uint32_t i = 0; i < e->n; i++) {
        buf_str(n->out, i > 0 ? ", " : "");
        append_expr_name(n, e->arg[i]);
    }
    buf_str(n->out, ")");
}

static void append_expr_name(const Namer *n, const Expr *e)
{
    if (n->out->n > n->most)
        return;
    if (expr_is_constant(e)) {
        append_constant_name(n, expr_constant_value(e));
        return;
    }
    switch (e->kind) {
    case EX_NUMBER: break;                                  // not reached: a number is a constant expression
    case EX_VAR: append_variable_name(n, e->var); break;
    case EX_UNARY:
    case EX_BINARY:
    case EX_CHAIN: append_operation_name(n, e); break;
    case EX_CALL: append_call_name(n, e); break;
    case EX_EVERY: case EX_AT: case EX_RANDOM: break;             // no window of a machine samples them
    case EX_ROLL: append_window_name(n, statistic_name[e->stat], &n->window->at[e->window]); break;
    }
}

// Appends the canonical name of what a window samples, as in `roll(tankPressure + 1, 10)` (swapping.md 12.11).
void expr_name_window(Arena *arena, const Windows *all, const Window *w, size_t most, Buf *out)
{
    const Namer n = {arena, all, most, out};

    append_window_name(&n, 1u << w->stat & SM_STATS_OF_RUNS ? "run" : 1u << w->stat & SM_STATS_OF_TIMES ? "times" : "roll", w);
}

// Formats a value for messages, with the fewest digits from which the same number can be read back, but at least 6.
const char *const_text(Arena *arena, SmF64 x)
{
    enum { FEW = 6, ENOUGH = 17 };             // numbers of decimal digits; 17 digits distinguish any two F64
    const char *text = "";

    if (sm_is_nan(x))
        return "NaN";
    for (int digits = FEW; digits <= ENOUGH; digits++) {
        double back = 0;
        text = format_in(arena, "%.*g", digits, x);
        if (sscanf(text, "%lf", &back) == 1 && sm_eq(back, x))
            break;
    }
    return text;
}
