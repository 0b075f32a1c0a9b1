// SPDX-License-Identifier: Apache-2.0
// What a changed condition means.  Conditions are split into parts that must all be true; equal parts cancel out.  If only one side has others,
// it is the stronger one.  If both have comparisons of one variable with constants, they are intervals, which can be compared: no variable is
// ever NaN when it is read (language.md 2).
#include <math.h>
#include <string.h>

#include "compiler/analysis/analysis.h"
#include "compiler/diff/diff_part.h"

// A part of a condition: an expression that must be true, or must be false.
typedef struct GuardPart { const Expr *e; bool holds; const char *canon; bool cancelled; } GuardPart;
typedef VEC(GuardPart) GuardParts;

// Adds the operands of a conjunction to `out`, each as one part. holds: the expression must be true, else false (De Morgan).
static void add_part(Arena *arena, const Canon *c, const Expr *e, bool holds, GuardParts *out)
{
    GuardPart part = {e, holds, NULL, false};
    Buf text;

    if (holds && e->kind == EX_BINARY && e->op == SM_OP_AND) {
        add_part(arena, c, e->arg[0], true, out);
        add_part(arena, c, e->arg[1], true, out);
        return;
    }
    buf_init(&text, arena);
    buf_str(&text, holds ? "" : "!");
    canon_expr(c, e, &text);
    part.canon = buf_text(&text);
    vec_push(arena, out, part);
}

// Splits a condition and all the conditions around it into parts that must all be true or false.
static GuardParts split_guard(Arena *arena, const Canon *c, const Condition *when)
{
    GuardParts out = {NULL, 0, 0};

    for (; when; when = when->outer)
        add_part(arena, c, when->stmt->value, when->holds, &out);
    return out;
}

// Marks the parts that both guards have as cancelled, in pairs.
static void cancel_common_parts(GuardParts *a, GuardParts *b)
{
    for (size_t i = 0; i < a->n; i++)
        for (size_t k = 0; k < b->n && !a->at[i].cancelled; k++)
            if (!b->at[k].cancelled && strcmp(a->at[i].canon, b->at[k].canon) == 0)
                a->at[i].cancelled = b->at[k].cancelled = true;
}

static size_t count_remaining_parts(const GuardParts *g)
{
    size_t n = 0;

    for (size_t i = 0; i < g->n; i++)
        n += !g->at[i].cancelled;
    return n;
}

// ---- intervals ----

typedef struct GuardInterval {
    const Var *var;
    double lo, hi;
    bool lo_open, hi_open;        // the end itself is outside
} GuardInterval;

// Returns the value of a constant expression in *x; false if it is not constant, or NaN.
static bool constant_of(const Expr *e, double *x)
{
    if (!expr_is_constant(e))
        return false;
    *x = expr_constant_value(e);
    return *x == *x;
}

// Raises the lower bound of the interval to x, if that narrows it. open: x itself is excluded.
static void raise_lower_bound(GuardInterval *v, double x, bool open)
{
    if (x > v->lo || (x == v->lo && open)) {
        v->lo = x;
        v->lo_open = open;
    }
}

// Lowers the upper bound of the interval to x, if that narrows it. open: x itself is excluded.
static void lower_upper_bound(GuardInterval *v, double x, bool open)
{
    if (x < v->hi || (x == v->hi && open)) {
        v->hi = x;
        v->hi_open = open;
    }
}

// Narrows the interval v of a variable by a comparison that is true (or false, without `holds`).  Returns false if it does not compare this variable
// with a constant.
static bool add_comparison(GuardInterval *v, Comparison c, bool holds)
{
    SmOperator op = c.op;
    const Expr *var = c.a;
    double x;

    if (c.b->kind == EX_VAR && constant_of(c.a, &x)) {
        op = comparison_swapped(op);
        var = c.b;
    } else if (!constant_of(c.b, &x))
        return false;
    if (var->kind != EX_VAR || expr_is_constant(var) || (v->var && v->var != var->var))
        return false;
    v->var = var->var;
    op = holds ? op : comparison_negated(op);
    switch ((int)op) {
    case SM_OP_LT: lower_upper_bound(v, x, true); return true;
    case SM_OP_LE: lower_upper_bound(v, x, false); return true;
    case SM_OP_GT: raise_lower_bound(v, x, true); return true;
    case SM_OP_GE: raise_lower_bound(v, x, false); return true;
    case SM_OP_EQ: raise_lower_bound(v, x, false); lower_upper_bound(v, x, false); return true;
    default: return false;
    }
}

// Whether all remaining parts compare the same variable with constants.  *v is then the interval of its values.
static bool find_interval(const GuardParts *g, GuardInterval *v)
{
    *v = (GuardInterval){NULL, -INFINITY, INFINITY, false, false};
    for (size_t i = 0; i < g->n; i++) {
        const GuardPart *part = &g->at[i];
        const uint32_t n = comparison_count(part->e);
        if (part->cancelled)
            continue;
        if (n == 0 || (n > 1 && !part->holds))
            return false;
        for (uint32_t k = 0; k < n; k++)
            if (!add_comparison(v, comparison_at(part->e, k), part->holds))
                return false;
    }
    return v->var && (v->lo < v->hi || (v->lo == v->hi && !v->lo_open && !v->hi_open));
}

// Whether the lower end of b is below that of a; the same of upper ends.
static bool begins_before(const GuardInterval *b, const GuardInterval *a) { return b->lo < a->lo || (b->lo == a->lo && a->lo_open && !b->lo_open); }
// Whether interval b contains numbers above all those of a.
static bool has_higher_upper_bound(const GuardInterval *b, const GuardInterval *a)
{
    return b->hi > a->hi || (b->hi == a->hi && a->hi_open && !b->hi_open);
}

// Writes an interval as a condition on the variable `name`: "p > 3" or "3 < p <= 5". open: the bound itself is excluded.
static void write_interval(Buf *out, const char *name, double lo, bool lo_open, double hi, bool hi_open)
{
    if (lo == hi) {
        buf_printf(out, "%s == ", name);
        format_number_shortest(out, lo);
        return;
    }
    if (lo != -INFINITY && hi != INFINITY) {
        format_number_shortest(out, lo);
        buf_printf(out, " %s %s %s ", lo_open ? "<" : "<=", name, hi_open ? "<" : "<=");
        format_number_shortest(out, hi);
    } else if (lo != -INFINITY) {
        buf_printf(out, "%s %s ", name, lo_open ? ">" : ">=");
        format_number_shortest(out, lo);
    } else {
        buf_printf(out, "%s %s ", name, hi_open ? "<" : "<=");
        format_number_shortest(out, hi);
    }
}

// Writes the values in the interval `large` that are not in `small`, an interval inside it.
static void write_difference(Buf *out, const char *name, const GuardInterval *large, const GuardInterval *small)
{
    const bool below = begins_before(large, small);

    if (below)
        write_interval(out, name, large->lo, large->lo_open, small->lo, !small->lo_open);
    if (has_higher_upper_bound(large, small)) {
        buf_str(out, below ? " or " : "");
        write_interval(out, name, small->hi, !small->hi_open, large->hi, large->hi_open);
    }
}

// Returns in words for which values of the only variable the new guard is true and the old one not, or the reverse; NULL if the guards are not
// intervals.
static const char *compare_intervals(const ProgramDiff *d, const GuardParts *old, const GuardParts *new)
{
    GuardInterval a, b;
    Buf out;

    if (!find_interval(old, &a) || !find_interval(new, &b) || d->var_of[a.var->index] != b.var)
        return NULL;
    buf_init(&out, d->arena);
    if (!begins_before(&a, &b) && !has_higher_upper_bound(&a, &b)) {
        buf_str(&out, "weaker: also true when ");
        write_difference(&out, b.var->name->text, &b, &a);
    } else if (!begins_before(&b, &a) && !has_higher_upper_bound(&b, &a)) {
        buf_str(&out, "stronger: no longer true when ");
        write_difference(&out, b.var->name->text, &a, &b);
    } else
        return NULL;
    return buf_text(&out);
}

// ---- the comparison ----

// Returns the parts that are not cancelled, joined by "and".
static const char *list_parts(Arena *arena, const GuardParts *g)
{
    Buf out;

    buf_init(&out, arena);
    for (size_t i = 0; i < g->n; i++)
        if (!g->at[i].cancelled)
            buf_printf(&out, "%s%s%s%s", out.n ? " and " : "", g->at[i].holds ? "" : "not (", source_text(arena, g->at[i].e->span),
                       g->at[i].holds ? "" : ")");
    return buf_text(&out);
}

// Returns what a changed guard means, if that is provable: "weaker: also true when 800 < p <= 825"; NULL: unknown.
const char *diff_compare_guards(const ProgramDiff *d, const Canon canon[2], const Condition *old, const Condition *new)
{
    GuardParts a = split_guard(d->arena, &canon[0], old), b = split_guard(d->arena, &canon[1], new);
    size_t left_a, left_b;

    cancel_common_parts(&a, &b);
    left_a = count_remaining_parts(&a);
    left_b = count_remaining_parts(&b);
    if (left_a == 0 && left_b == 0)
        return NULL;
    if (left_b == 0)
        return format_in(d->arena, "weaker: no longer requires %s", list_parts(d->arena, &a));
    if (left_a == 0)
        return format_in(d->arena, "stronger: also requires %s", list_parts(d->arena, &b));
    return compare_intervals(d, &a, &b);
}
