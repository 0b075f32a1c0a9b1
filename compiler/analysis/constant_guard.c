// SPDX-License-Identifier: Apache-2.0
// Guards that are always or never true, and the reason: a switch of constants, a type, a part that contradicts another, an
// earlier guard that covers all other cases, or the facts about the variables.
#include "compiler/analysis/decided_comparison.h"
#include <string.h>

#include "compiler/analysis/assume.h"
#include "compiler/analysis/earlier_guards.h"
#include "compiler/analysis/guards_imply.h"
#include "stdlib/convert.h"
#include "stdlib/math.h"

typedef enum Answer { SOMETIMES, NEVER, ALWAYS } Answer;

uint32_t dead_of(Structure *k, Cause cause, const Stmt *stmt, const Stmt *earlier, Diag *told)
{
    const Dead d = {cause, stmt, earlier, told, false};

    vec_push(k->a->arena, &k->dead, d);
    return (uint32_t)k->dead.n;
}

// ---- explained by other findings ----

// Contains only numbers and locals that never change.  If such a local is not marked @read_only, it has its own finding.
static bool is_fixed(const Expr *e)
{
    if (e->kind == EX_ROLL || (e->kind == EX_VAR && (e->var->kind != VAR_LOCAL || e->var->written)))
        return false;
    for (uint32_t i = 0; i < e->n; i++)
        if (!is_fixed(e->arg[i]))
            return false;
    return true;
}

static Answer either(Answer a, Answer b, Answer decides) { return a == decides || b == decides ? decides : a == b ? a : SOMETIMES; }

// The value of a guard if constants alone decide it.
static Answer switched(const Expr *e)
{
    if (e->kind == EX_BINARY && (e->op == SM_OP_AND || e->op == SM_OP_OR))
        return either(switched(e->arg[0]), switched(e->arg[1]), e->op == SM_OP_AND ? NEVER : ALWAYS);
    if (!is_fixed(e))
        return SOMETIMES;
    return sm_to_bool(expr_constant_value(e)) ? ALWAYS : NEVER;
}

// A local that has its initial value here and gets other values elsewhere.  Reading it too early is reported at that local.
static bool reads_initial(const Structure *k, const Expr *e, const Env *env)
{
    const Var *v = e->var;
    double x;

    if (e->kind == EX_VAR && k->stored[v->index] == STORED_OTHER && !k->written[v->index])
        return fact_is_number(env_get(&k->a->facts->shape, env, k->a->m->var_of[v->index]), &x) &&
               sm_eq(x, sm_cell_to_f64(v->type, v->init));
    for (uint32_t i = 0; e->kind != EX_ROLL && i < e->n; i++)
        if (reads_initial(k, e->arg[i], env))
            return true;
    return false;
}

// ---- the facts at the guard ----

static const Expr *compared(const Expr *e)
{
    const bool comparison = e->kind == EX_CHAIN || (e->kind == EX_BINARY && is_comparison(e->op));
    const Expr *found = NULL;

    if (e->kind == EX_VAR && !expr_is_constant(e))
        return e;
    for (uint32_t i = 0; e->kind != EX_ROLL && i < e->n && !found; i++)
        found = comparison && !expr_is_constant(e->arg[i]) ? e->arg[i] : comparison ? NULL : compared(e->arg[i]);
    return found;
}

// Writes "above 400" if the facts contain 400.00000000000006 and more.
static const char *bound_text(Arena *arena, double x, double beside, const char *strict, const char *or_equal)
{
    const char *text = const_text(arena, x), *other = const_text(arena, beside);

    return strlen(other) < strlen(text) ? format_in(arena, "%s %s", strict, other) : format_in(arena, "%s %s", or_equal, text);
}

static const char *range_text(Arena *arena, const char *what, Fact f)
{
    const bool open = f.lo - f.lo != 0, endless = f.hi - f.hi != 0;
    const char *lo = bound_text(arena, f.lo, fact_below(f, f.lo), "above", "at least");
    const char *hi = bound_text(arena, f.hi, fact_above(f, f.hi), "below", "at most");

    if (f.lo == f.hi)
        return format_in(arena, "here '%s' is always %s", what, const_text(arena, f.lo));
    return format_in(arena, "here '%s' is always %s%s%s", what, open ? "" : lo, open || endless ? "" : " and ", endless ? "" : hi);
}

// "here 'mode' is always at most 2", or NULL if the facts only show that it is a number.
static const char *known_text(const Structure *k, const Stmt *s)
{
    const Expr *e = compared(s->value);
    const char *name;
    Fact f;

    if (!e)
        return NULL;
    name = source_text(k->a->arena, e->span);
    f = suppose_value(k->a, k->a->stmt[s->number].env, e);
    if (f.lo > f.hi || f.nan || (f.lo - f.lo != 0 && f.hi - f.hi != 0))
        return NULL;
    if (e->kind == EX_VAR && e->var->type == SM_BOOL)
        return f.lo < f.hi ? NULL : format_in(k->a->arena, "here '%s' is always %s", name, f.hi > 0 ? "true" : "false");
    return range_text(k->a->arena, name, f);
}

// Whether the guard is always true (or always false) for all values of its variables.
static bool decides_itself(const Structure *k, const Expr *guard, bool holds)
{
    const Env *env = NULL;

    return (holds ? guard_always(k->a, guard) : guard_never(k->a, guard)) || !suppose_guard(k->a, &env, guard, !holds);
}

// ---- reports ----

static bool has_parts(const Expr *e)
{
    if (e->kind == EX_UNARY && e->op == SM_OP_NOT)
        return has_parts(e->arg[0]);
    return e->kind == EX_CHAIN || (e->kind == EX_BINARY && (e->op == SM_OP_AND || e->op == SM_OP_OR));
}

static DiagCode never_code(const Structure *k, const Stmt *s)
{
    return has_parts(s->value) && decides_itself(k, s->value, false) ? DIAG_guard_contradiction : DIAG_guard_never;
}

void report_never(Structure *k, const Dead *d)
{
    const Expr *g = d->stmt->value;
    const DiagCode code = never_code(k, d->stmt);
    const char *known = code == DIAG_guard_never ? known_text(k, d->stmt) : NULL;
    Diag *told = diag_report(k->a->diags, code, g->span);

    if (known)
        diag_label(k->a->diags, told, DIAG_label_text, known);
    if (d->earlier)
        diag_note(k->a->diags, told, d->earlier->span, DIAG_note_guard_before);
}

void note_never(Structure *k, Diag *to, const Dead *d)
{
    const char *known = never_code(k, d->stmt) == DIAG_guard_never ? known_text(k, d->stmt) : "its parts exclude each other";

    if (known)
        diag_note(k->a->diags, to, d->stmt->value->span, DIAG_note_never_because, known);
    else
        diag_note(k->a->diags, to, d->stmt->value->span, DIAG_note_never_holds);
}

static void report_always(Structure *k, const Stmt *s, const Stmt *around)
{
    const bool itself = has_parts(s->value) && decides_itself(k, s->value, true);
    const char *known = itself ? NULL : known_text(k, s);
    Diag *told = diag_report(k->a->diags, itself ? DIAG_guard_tautology : DIAG_guard_always, s->value->span);

    if (known)
        diag_label(k->a->diags, told, DIAG_label_text, known);
    if (around)
        diag_note(k->a->diags, told, around->span, DIAG_note_guard_around);
}

static bool makes_transition(const Stmts *list)
{
    for (size_t i = 0; i < list->n; i++)
        if (list->at[i]->kind == ST_TRANSITION || makes_transition(&list->at[i]->then) || makes_transition(&list->at[i]->otherwise))
            return true;
    return false;
}

// s can be true only where b has its excluded outcome.
static uint32_t forestalled(Structure *k, const Stmt *s, const Before *b)
{
    const bool same = is_same(k, s->value, b);
    Diag *d;

    if (!same && !((b->left || always_leaves(&b->stmt->then)) && makes_transition(&s->then)))
        return dead_of(k, CAUSE_NEVER, s, b->stmt, NULL);
    d = diag_report(k->a->diags, same ? DIAG_duplicate_guard : DIAG_shadowed_transition, s->value->span);
    diag_note(k->a->diags, d, b->stmt->span, same ? DIAG_note_same_guard : DIAG_note_left_before);
    return dead_of(k, CAUSE_TOLD, s, NULL, d);
}

// ---- judging ----

static Verdict judge_never(Structure *k, const Stmt *s, const Befores *b)
{
    const bool itself = decides_itself(k, s->value, false);
    const Before *before = itself ? NULL : the_one_before(k, s->value, b);
    Verdict v = {false, true, 0};

    if (switched(s->value) != SOMETIMES)
        v.dead = dead_of(k, CAUSE_SWITCH, s, NULL, NULL);
    else if (types_decide_in(k->a, s->value))
        v.dead = dead_of(k, CAUSE_TOLD, s, NULL, NULL);
    else if (before)
        v.dead = forestalled(k, s, before);
    else
        v.dead = dead_of(k, reads_initial(k, s->value, k->a->stmt[s->number].env) ? CAUSE_TOLD : CAUSE_NEVER, s, NULL, NULL);
    return v;
}

static Verdict judge_always(Structure *k, const Stmt *s, const Befores *b, const Stmt *around)
{
    Verdict v = {true, false, 0};

    if (switched(s->value) != SOMETIMES) {
        v.dead = dead_of(k, CAUSE_SWITCH, s, NULL, NULL);
        return v;
    }
    if (!types_decide_in(k->a, s->value) && !reads_initial(k, s->value, k->a->stmt[s->number].env)) {
        if (is_the_rest(k, s->value, b))
            return v;
        report_always(k, s, around);
    }
    v.dead = dead_of(k, CAUSE_TOLD, s, NULL, NULL);
    return v;
}

// An enclosing guard that is true here and implies this one, as in `a > b { a > b: … }`; or NULL.
static const Stmt *implied_by(const Structure *k, const Stmt *s, const Way *way)
{
    for (unsigned n = 0; way && n < LOOK_BACK; way = way->outer, n++)
        if (way->holds && guard_implies(k->a, way->stmt->value, s->value) && is_unchanged(k, way->stmt, s->value))
            return way->stmt;
    return NULL;
}

Verdict judge(Structure *k, const Stmt *s, const Way *way)
{
    const StmtFact *f = &k->a->stmt[s->number];
    const Befores b = befores_of(k, way);
    const Stmt *around = implied_by(k, s, way);
    const Verdict both = {true, true, 0};

    if (!f->reached)
        return both;
    if (!f->then || guard_never(k->a, s->value) || written_before(k, s->value, &b))
        return judge_never(k, s, &b);
    if (!f->otherwise || guard_always(k->a, s->value) || around)
        return judge_always(k, s, &b, around);
    return both;
}
