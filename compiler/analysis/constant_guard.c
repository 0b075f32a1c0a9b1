// SPDX-License-Identifier: Apache-2.0
// Finds guards that are always or never true, and the reason: constants alone (a switch, intended by the user), a type, two parts of the
// guard that contradict each other, an earlier guard that covers all other cases, or the facts about the variables.
#include "compiler/analysis/decided_comparison.h"
#include <string.h>

#include "compiler/analysis/assume.h"
#include "compiler/analysis/earlier_guards.h"
#include "compiler/analysis/guards_imply.h"
#include "stdlib/convert.h"
#include "stdlib/math.h"

// Adds an entry to ReachWalk.dead.  Returns 1 + its index.
uint32_t add_dead_code(ReachWalk *k, DeadCause cause, const Stmt *stmt, const Stmt *earlier, Diag *finding)
{
    const DeadCode d = {cause, stmt, earlier, finding, false};

    vec_push(k->a->arena, &k->dead, d);
    return (uint32_t)k->dead.n;
}

// ---- explained by other findings ----

// Whether e contains only numbers and locals that never change.  Another analysis reports such locals that are not marked @read_only.
static bool is_constant_expr(const Expr *e)
{
    if (e->kind == EX_ROLL || (e->kind == EX_VAR && (e->var->kind != VAR_LOCAL || e->var->written)))
        return false;
    for (uint32_t i = 0; i < e->n; i++)
        if (!is_constant_expr(e->arg[i]))
            return false;
    return true;
}

// Returns ALWAYS or NEVER if constants alone decide the guard, else SOMETIMES.
static Truth truth_by_constants(const Expr *e)
{
    if (e->kind == EX_BINARY && (e->op == SM_OP_AND || e->op == SM_OP_OR)) {
        const Truth a = truth_by_constants(e->arg[0]), b = truth_by_constants(e->arg[1]);
        const Truth decisive = e->op == SM_OP_AND ? NEVER : ALWAYS;
        return a == decisive || b == decisive ? decisive : a == b ? a : SOMETIMES;
    }
    if (!is_constant_expr(e))
        return SOMETIMES;
    return sm_to_bool(expr_constant_value(e)) ? ALWAYS : NEVER;
}

// Whether e reads a local that always has its initial value at this position but other values elsewhere.  read_before_write.c reports that.
static bool reads_initial_value(const ReachWalk *k, const Expr *e, const Env *env)
{
    const Var *v = e->var;
    double x;

    if (e->kind == EX_VAR && k->stored[v->index] == STORED_OTHER && !k->written[v->index])
        return fact_is_number(env_get(&k->a->facts->shape, env, k->a->m->var_of[v->index]), &x) &&
               sm_eq(x, sm_cell_to_f64(v->type, v->init));
    for (uint32_t i = 0; e->kind != EX_ROLL && i < e->n; i++)
        if (reads_initial_value(k, e->arg[i], env))
            return true;
    return false;
}

// ---- the facts at the guard ----

// Returns the first expression that the guard compares, or the bool that it reads; NULL if the guard contains neither.
static const Expr *find_compared_expr(const Expr *e)
{
    const bool comparison = comparison_count(e) > 0;
    const Expr *found = NULL;

    if (e->kind == EX_VAR && !expr_is_constant(e))
        return e;
    for (uint32_t i = 0; e->kind != EX_ROLL && i < e->n && !found; i++)
        found = comparison && !expr_is_constant(e->arg[i]) ? e->arg[i] : comparison ? NULL : find_compared_expr(e->arg[i]);
    return found;
}

// Returns the text of a bound x, such as "at least 400" (or_equal and x).  `beside` is the next number outside the bound.  If the text of
// `beside` is shorter, returns a strict bound: "above 400" (strict and beside) instead of "at least 400.00000000000006".
static const char *bound_text(Arena *arena, double x, double beside, const char *strict, const char *or_equal)
{
    const char *text = const_text(arena, x), *other = const_text(arena, beside);

    return strlen(other) < strlen(text) ? format_in(arena, "%s %s", strict, other) : format_in(arena, "%s %s", or_equal, text);
}

// Describes the facts about the expression that a guard compares: "here 'mode' is always at least 1 and at most 2".  NULL if the facts give
// no bound.
static const char *facts_text(const ReachWalk *k, const Stmt *s)
{
    const Expr *e = find_compared_expr(s->value);
    Arena *arena = k->a->arena;
    bool open, endless;
    const char *name, *lo, *hi;
    Fact f;

    if (!e)
        return NULL;
    name = source_text(arena, e->span);
    f = fact_of_expr(k->a, env_of_stmt(k->a, s), e);
    open = f.lo - f.lo != 0;                          // `open`: the range has no finite lower bound; `endless`: no finite upper bound
    endless = f.hi - f.hi != 0;
    if (f.lo > f.hi || f.nan || (open && endless))
        return NULL;
    if (e->kind == EX_VAR && e->var->type == SM_BOOL)
        return f.lo < f.hi ? NULL : format_in(arena, "here '%s' is always %s", name, f.hi > 0 ? "true" : "false");
    if (f.lo == f.hi)
        return format_in(arena, "here '%s' is always %s", name, const_text(arena, f.lo));
    lo = open ? "" : bound_text(arena, f.lo, fact_next_below(f, f.lo), "above", "at least");
    hi = endless ? "" : bound_text(arena, f.hi, fact_next_above(f, f.hi), "below", "at most");
    return format_in(arena, "here '%s' is always %s%s%s", name, lo, open || endless ? "" : " and ", hi);
}

// Whether the guard is always true (`holds`) or always false, whatever its variables contain.
static bool is_decided_alone(const ReachWalk *k, const Expr *guard, bool holds)
{
    const Env *env = NULL;

    return (holds ? guard_is_always_true(k->a, guard) : guard_is_never_true(k->a, guard)) || !assume_guard(k->a, &env, guard, !holds);
}

// ---- reports ----

// Whether a guard combines comparisons; `not` is ignored.
static bool is_compound(const Expr *e)
{
    if (e->kind == EX_UNARY && e->op == SM_OP_NOT)
        return is_compound(e->arg[0]);
    return e->kind == EX_CHAIN || (e->kind == EX_BINARY && (e->op == SM_OP_AND || e->op == SM_OP_OR));
}

// Chooses the diagnostic of a guard that is never true: its parts contradict each other, or the facts at the guard decide it.
static DiagCode code_of_never_true(const ReachWalk *k, const Stmt *s)
{
    return is_compound(s->value) && is_decided_alone(k, s->value, false) ? DIAG_guard_contradiction : DIAG_guard_never;
}

// Reports a guard that is never true.
void report_never_true(ReachWalk *k, const DeadCode *d)
{
    const Expr *g = d->stmt->value;
    const DiagCode code = code_of_never_true(k, d->stmt);
    const char *facts = code == DIAG_guard_never ? facts_text(k, d->stmt) : NULL;
    Diag *finding = diag_report(k->a->diags, code, g->span);

    if (facts)
        diag_label(k->a->diags, finding, DIAG_label_text, facts);
    if (d->earlier)
        diag_note(k->a->diags, finding, d->earlier->span, DIAG_note_guard_before);
}

// Adds a note about a guard that is never true to the finding `to`.
void note_never_true(ReachWalk *k, Diag *to, const DeadCode *d)
{
    const char *reason = code_of_never_true(k, d->stmt) == DIAG_guard_never ? facts_text(k, d->stmt) : "its parts exclude each other";

    if (reason)
        diag_note(k->a->diags, to, d->stmt->value->span, DIAG_note_never_because, reason);
    else
        diag_note(k->a->diags, to, d->stmt->value->span, DIAG_note_never_true);
}

static void report_always_true(ReachWalk *k, const Stmt *s, const Stmt *around)
{
    const bool itself = is_compound(s->value) && is_decided_alone(k, s->value, true);
    const char *facts = itself ? NULL : facts_text(k, s);
    Diag *finding = diag_report(k->a->diags, itself ? DIAG_guard_tautology : DIAG_guard_always, s->value->span);

    if (facts)
        diag_label(k->a->diags, finding, DIAG_label_text, facts);
    if (around)
        diag_note(k->a->diags, finding, around->span, DIAG_note_guard_around);
}

// Called if the guard of s is never true because of the earlier guard b, which has one outcome on every path to s.  Reports the guard of s,
// or only records it in ReachWalk.dead if a state that becomes unreachable may be reported instead.  Returns 1 + its index in dead.
static uint32_t report_earlier_guard(ReachWalk *k, const Stmt *s, const EarlierGuard *b)
{
    const bool same = is_same_guard(k, s->value, b);
    Diag *d;

    if (!same && !((b->leaves || always_leaves(&b->stmt->then)) && has_transition(&s->then)))
        return add_dead_code(k, CAUSE_NEVER, s, b->stmt, NULL);
    d = diag_report(k->a->diags, same ? DIAG_duplicate_guard : DIAG_shadowed_transition, s->value->span);
    diag_note(k->a->diags, d, b->stmt->span, same ? DIAG_note_same_guard : DIAG_note_left_before);
    return add_dead_code(k, CAUSE_REPORTED, s, NULL, d);
}

// ---- verdicts ----

// Reports a guard that is never true, unless the constants of the program decide it on purpose.
static GuardVerdict judge_never_true(ReachWalk *k, const Stmt *s, const EarlierGuards *b)
{
    const bool itself = is_decided_alone(k, s->value, false);
    const EarlierGuard *earlier = itself ? NULL : find_explaining_guard(k, s->value, b);
    GuardVerdict v = {false, true, 0};

    if (truth_by_constants(s->value) != SOMETIMES)
        v.dead = add_dead_code(k, CAUSE_SWITCH, s, NULL, NULL);
    else if (has_comparison_decided_by_types(k->a, s->value))
        v.dead = add_dead_code(k, CAUSE_REPORTED, s, NULL, NULL);
    else if (earlier)
        v.dead = report_earlier_guard(k, s, earlier);
    else
        v.dead = add_dead_code(k, reads_initial_value(k, s->value, env_of_stmt(k->a, s)) ? CAUSE_REPORTED : CAUSE_NEVER, s, NULL, NULL);
    return v;
}

// Reports a guard that is always true, unless the constants of the program decide it on purpose.
static GuardVerdict judge_always_true(ReachWalk *k, const Stmt *s, const EarlierGuards *b, const Stmt *around)
{
    GuardVerdict v = {true, false, 0};

    if (truth_by_constants(s->value) != SOMETIMES) {
        v.dead = add_dead_code(k, CAUSE_SWITCH, s, NULL, NULL);
        return v;
    }
    if (!has_comparison_decided_by_types(k->a, s->value) && !reads_initial_value(k, s->value, env_of_stmt(k->a, s))) {
        if (covers_remaining_cases(k, s->value, b))
            return v;
        report_always_true(k, s, around);
    }
    v.dead = add_dead_code(k, CAUSE_REPORTED, s, NULL, NULL);
    return v;
}

// Returns an enclosing guard that is true at s and implies the guard of s, as in `a > b { a > b: … }`; NULL if no enclosing guard implies it.
static const Stmt *find_implying_guard(const ReachWalk *k, const Stmt *s, const Branch *branch)
{
    for (unsigned n = 0; branch && n < EARLIER_MAX; branch = branch->outer, n++)
        if (branch->holds && guard_implies(k->a, branch->stmt->value, s->value) && is_unchanged(k, branch->stmt, s->value))
            return branch->stmt;
    return NULL;
}

GuardVerdict judge_guard(ReachWalk *k, const Stmt *s, const Branch *branch)
{
    const StmtFact *f = &k->a->stmt[s->number];
    const EarlierGuards b = earlier_guards_of(k, branch);
    const Stmt *around = find_implying_guard(k, s, branch);
    const GuardVerdict both = {true, true, 0};

    if (!f->reached)
        return both;
    if (!f->then || guard_is_never_true(k->a, s->value) || find_excluding_guard(k, s->value, &b))
        return judge_never_true(k, s, &b);
    if (!f->otherwise || guard_is_always_true(k->a, s->value) || around)
        return judge_always_true(k, s, &b, around);
    return both;
}
