// SPDX-License-Identifier: Apache-2.0
// Expressions of the reference (language.md 3): one recursion over the tree.  The parser limits its depth.
#include "compiler/script/ref.h"

static double apply_unary(SmOperator op, double a)
{
    if (op == SM_OP_NOT)
        return !ref_true(a);
    return op == SM_OP_NEG ? -a : a;                  // C's minus flips the sign, even of zero
}

static double apply_binary(SmOperator op, double a, double b)
{
    switch (op) {
    case SM_OP_OR: return ref_true(a) || ref_true(b);
    case SM_OP_AND: return ref_true(a) && ref_true(b);
    case SM_OP_EQ: return a == b;
    case SM_OP_NE: return a != b;                     // 1 if a or b is NaN; the other five comparisons are then 0
    case SM_OP_LT: return a < b;
    case SM_OP_LE: return a <= b;
    case SM_OP_GT: return a > b;
    case SM_OP_GE: return a >= b;
    case SM_OP_ADD: return a + b;
    case SM_OP_SUB: return a - b;
    case SM_OP_MUL: return a * b;
    case SM_OP_DIV: return a / b;
    case SM_OP_NOT: case SM_OP_NEG: case SM_OP_PLUS: case SM_OP_COUNT: break;       // not reached: these are not binary operators
    }
    return 0;
}

static double eval_chain(const Expr *e, const uint64_t *cell, const RefWindows *w)
{
    double left = ref_eval(e->arg[0], cell, w);
    bool all = true;

    for (uint32_t i = 1; i < e->n; i++) {
        double right = ref_eval(e->arg[i], cell, w);
        all = all && ref_true(apply_binary(expr_ops(e)[i - 1], left, right));
        left = right;
    }
    return all;
}

static double eval_call(const Expr *e, const uint64_t *cell, const RefWindows *w)
{
    double arg[SM_LIST_MAX] = {0};                    // no function in builtins.def has more parameters than SM_LIST_MAX

    for (uint32_t i = 0; i < e->n && i < SM_LIST_MAX; i++)
        arg[i] = ref_eval(e->arg[i], cell, w);
    return sm_builtin_info[e->fn].most == SM_LIST_MAX ? ref_list(e->fn, arg, e->n) : ref_pure(e->fn, arg);
}

// Evaluates e with cell[i] as the cell of variable i.  w: the rolling windows of the machine or script that e belongs to.
double ref_eval(const Expr *e, const uint64_t *cell, const RefWindows *w)
{
    switch (e->kind) {
    case EX_NUMBER: return e->number;
    case EX_VAR: return ref_read(e->var->type, cell[e->var->index]);
    case EX_UNARY: return apply_unary(e->op, ref_eval(e->arg[0], cell, w));
    case EX_BINARY: return apply_binary(e->op, ref_eval(e->arg[0], cell, w), ref_eval(e->arg[1], cell, w));
    case EX_CHAIN: return eval_chain(e, cell, w);
    case EX_CALL: return eval_call(e, cell, w);
    case EX_EVERY: return cell[e->var->index] % (uint64_t)e->number == 0;
    case EX_AT: return ref_read(e->var->type, cell[e->var->index]) == e->number;
    case EX_RANDOM: return ref_random_value(w->random, e->window);
    case EX_ROLL: return ref_statistic(w, e->window, e->stat);
    }
    return 0;
}
