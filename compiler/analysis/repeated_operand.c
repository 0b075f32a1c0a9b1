// SPDX-License-Identifier: Apache-2.0
// Reports operands that are written twice, as in a vote of three that counts one sensor twice:
//
//   - two equal operands of one chain of and, of or, or of a sum of conditions; and two equal conditions that count in one counter;
//   - an operand that cannot change the result of a network of and and or, or of min, max and median: `median(a, b, a)` is a.
//
// A network of min, max and medians selects one of its operands.  It ignores an operand for all numbers exactly if it does for all operands
// that are 0 or 1 (the 0-1 principle of sorting networks), so a table of truth decides.
#include "compiler/analysis/analysis.h"

enum { LEAVES_MAX = 8 };          // different operands of a network; a network of more is not checked

typedef struct OperandNet {
    const Analysis *a;
    bool numeric;                 // min, max and median; else: and, or
    const Expr *leaf[LEAVES_MAX]; // the different operands
    uint32_t uses[LEAVES_MAX];    // how often each is an operand
    uint32_t n;
    bool more;                    // it has more than LEAVES_MAX operands
} OperandNet;

// ---- operands without an effect ----

static bool is_gate(const OperandNet *w, const Expr *e)
{
    if (!w->numeric)
        return e->kind == EX_BINARY && (e->op == SM_OP_AND || e->op == SM_OP_OR);
    return e->kind == EX_CALL && (e->fn == SM_FN_min || e->fn == SM_FN_max || (e->fn == SM_FN_median && e->n % 2 == 1));
}

// Returns the index of the leaf; that of the next one if it is new.
static uint32_t leaf_index(const OperandNet *w, const Expr *e)
{
    uint32_t i = 0;

    while (i < w->n && !expr_equal(w->leaf[i], e, w->a->m->window_of))
        i++;
    return i;
}

static void add_leaf(OperandNet *w, const Expr *e)
{
    const uint32_t at = leaf_index(w, e);

    if (at == LEAVES_MAX) {
        w->more = true;
        return;
    }
    if (at == w->n)
        w->leaf[w->n++] = e;
    w->uses[at]++;
}

static void find_leaves(OperandNet *w, const Expr *e)
{
    if (is_gate(w, e)) {
        for (uint32_t i = 0; i < e->n; i++)
            find_leaves(w, e->arg[i]);
        return;
    }
    add_leaf(w, e);
}

// Returns the result for operands that are 0 or 1: bit i is leaf i.
static bool network_result(const OperandNet *w, const Expr *e, unsigned operands)
{
    uint32_t ones = 0;

    if (!is_gate(w, e))
        return operands >> leaf_index(w, e) & 1;
    for (uint32_t i = 0; i < e->n; i++)
        ones += network_result(w, e->arg[i], operands);
    if (e->kind == EX_BINARY ? e->op == SM_OP_AND : e->fn == SM_FN_min)
        return ones == e->n;
    return e->kind == EX_CALL && e->fn == SM_FN_median ? ones > e->n / 2 : ones > 0;
}

static bool leaf_matters(const OperandNet *w, const Expr *e, uint32_t leaf)
{
    bool matters = false;

    for (unsigned x = 0; x < 1u << w->n && !matters; x++)
        matters = network_result(w, e, x) != network_result(w, e, x ^ 1u << leaf);
    return matters;
}

// Reports the first operand of a network that has no effect, with the operand that is written most often.
static void check_network(const Analysis *a, const Expr *e, bool numeric)
{
    OperandNet w = {.a = a, .numeric = numeric};
    uint32_t often = 0;

    if (!is_gate(&w, e))
        return;
    find_leaves(&w, e);
    for (uint32_t i = 0; i < w.n; i++)
        often = w.uses[i] > w.uses[often] ? i : often;
    for (uint32_t i = 0; i < w.n && !w.more && w.uses[often] > 1; i++)
        if (!leaf_matters(&w, e, i)) {
            Diag *d = diag_report(a->diags, DIAG_ignored_operand, w.leaf[i]->span, source_text(a->arena, w.leaf[i]->span));
            diag_label(a->diags, d, DIAG_label_operand_uses, source_text(a->arena, w.leaf[often]->span),
                       format_in(a->arena, "%u", (unsigned)w.uses[often]));
            return;
        }
}

// ---- operands that are written twice ----

// Whether the operands of e are written where e is: those of a definition are not, and the two may overlap as intended.
static bool is_written_here(const Expr *e)
{
    bool here = true;

    for (uint32_t i = 0; i < e->n && here; i++) {
        const Span in = e->arg[i]->span;
        here = in.src == e->span.src && in.at >= e->span.at && in.at + in.len <= e->span.at + e->span.len;
    }
    return here;
}

// Whether e counts as 0 or 1 in a sum: a condition.
static bool is_condition(const Expr *e)
{
    if (comparison_count(e) > 0 || (e->kind == EX_VAR && e->var->type == SM_BOOL && !e->var->is_constant))
        return true;
    return (e->kind == EX_BINARY && (e->op == SM_OP_AND || e->op == SM_OP_OR)) || (e->kind == EX_UNARY && e->op == SM_OP_NOT);
}

// Whether two operands are equal, as `a and b` and `b and a` are.
static bool are_same_operands(const Analysis *a, const Expr *x, const Expr *y)
{
    const bool swaps = x->kind == EX_BINARY && y->kind == EX_BINARY && x->op == y->op && (x->op == SM_OP_AND || x->op == SM_OP_OR);

    if (expr_equal(x, y, a->m->window_of))
        return true;
    return swaps && expr_equal(x->arg[0], y->arg[1], a->m->window_of) && expr_equal(x->arg[1], y->arg[0], a->m->window_of);
}

enum { CHAIN_MAX = 16 };          // operands of a chain that are compared with each other

typedef struct OperandChain { const Expr *at[CHAIN_MAX]; uint32_t n; } OperandChain;

// Lists the operands of a chain of one operator, in the order in which they are written.
static void list_operands(OperandChain *c, const Expr *e, SmOperator op, bool root)
{
    if (e->kind == EX_BINARY && e->op == op && (root || is_written_here(e))) {
        list_operands(c, e->arg[0], op, false);
        list_operands(c, e->arg[1], op, false);
    } else if (c->n < CHAIN_MAX)
        c->at[c->n++] = e;
}

static void report_repeated(const Analysis *a, Span span, Span first)
{
    Diag *d = diag_report(a->diags, DIAG_repeated_operand, span, source_text(a->arena, span));

    if (first.at != span.at)
        diag_note(a->diags, d, first, DIAG_note_first_here);
}

static void check_chain(const Analysis *a, const Expr *e)
{
    OperandChain c = {.n = 0};

    list_operands(&c, e, e->op, true);
    for (uint32_t i = 1; i < c.n; i++)
        for (uint32_t k = 0; k < i; k++)
            if (is_condition(c.at[i]) && are_same_operands(a, c.at[i], c.at[k])) {
                report_repeated(a, c.at[i]->span, c.at[k]->span);
                return;
            }
}

// Checks an expression and its operands.  `chain`: the operator of the chain that e belongs to and that has been checked; else SM_OP_NOT.
static void check_expr(const Analysis *a, const Expr *e, SmOperator chain)
{
    const bool logic = e->kind == EX_BINARY && (e->op == SM_OP_AND || e->op == SM_OP_OR);
    const size_t before = a->diags->list.n;
    const bool sum = e->kind == EX_BINARY && e->op == SM_OP_ADD, inner = (logic || sum) && e->op == chain;

    for (uint32_t i = 0; i < e->n; i++)
        check_expr(a, e->arg[i], logic || sum ? e->op : SM_OP_NOT);
    if ((logic || sum) && (!inner || !is_written_here(e)))
        check_chain(a, e);
    if (a->diags->list.n == before)
        check_network(a, e, e->kind == EX_CALL);
}

// ---- conditions that count ----

// Returns the assignment if the conditional does nothing but count: `hot: votes = votes + 1`; else NULL.
static const Stmt *counting_assignment(const Stmt *s)
{
    const Stmt *one = s->kind == ST_IF && s->then.n == 1 && s->otherwise.n == 0 ? s->then.at[0] : NULL;

    return one && one->kind == ST_ASSIGN && one->value->kind == EX_BINARY && one->value->op == SM_OP_ADD && one->value->arg[0]->kind == EX_VAR &&
           one->value->arg[0]->var == one->var && expr_is_constant(one->value->arg[1]) ? one : NULL;
}

// Compares the condition with those directly before it that count in the same counter.
static void check_vote(const Analysis *a, const Stmts *list, size_t at)
{
    const Stmt *s = list->at[at], *vote = counting_assignment(s);

    for (size_t k = at; vote && k-- > 0;) {
        const Stmt *other = counting_assignment(list->at[k]);
        if (!other || other->var != vote->var || !expr_equal(other->value, vote->value, a->m->window_of) || expr_reads(s->value, vote->var))
            return;
        if (expr_equal(list->at[k]->value, s->value, a->m->window_of)) {
            report_repeated(a, s->value->span, list->at[k]->value->span);
            return;
        }
    }
}

// Recursion depth equals the nesting of conditionals, which AST_DEPTH_MAX bounds.
static void check_statements(const Analysis *a, const Stmts *list)
{
    for (size_t i = 0; i < list->n; i++) {
        const Stmt *s = list->at[i];
        if (s->value && s->value->kind != EX_VAR && s->value->kind != EX_NUMBER)
            check_expr(a, s->value, SM_OP_NOT);
        if (s->kind != ST_IF)
            continue;
        check_vote(a, list, i);
        check_statements(a, &s->then);
        check_statements(a, &s->otherwise);
    }
}

void analyse_repeated_operand(Analysis *a)
{
    for (size_t i = 0; i < a->p->state.n; i++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            check_statements(a, &a->p->state.at[i]->block[b]);
}
