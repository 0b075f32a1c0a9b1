// SPDX-License-Identifier: Apache-2.0
#include "compiler/analysis/trial_near.h"

#include "compiler/analysis/input_deps.h"
#include "compiler/analysis/trial_checks.h"
#include "compiler/ir/comparison.h"
#include "stdlib/math.h"

enum { NOTES_MAX = 4 };               // the most states that are explained
enum { WAS_FALSE = 1, WAS_TRUE = 2 };

// A part of a guard that `and`, `or`, `not` and `held` combine: a comparison, or another condition.
typedef struct NearPart {
    const Expr *e;
    Span span;
    Comparison pair;                  // the comparison; `a` is NULL if the part is no comparison, or if one of its sides reads a window
    bool wanted;                      // the value that the part must have so that the guard can be true; false after `not`
    bool sampled;                     // the part belongs to a condition that a window samples, as in `held`
    bool met;                         // the part had the wanted value after some step
    bool known;                       // some step has told whether the part had the wanted value when the guard was evaluated
    double distance, at, to;          // the smallest distance between the two sides, and their values then; negative: none was computed
} NearPart;

typedef struct NearGuard { unsigned seen; VEC(NearPart) part; } NearGuard;

struct TrialNear {
    const Trials *t;
    NearGuard *guard;                 // by Stmt.number
    double *value;                    // by Var.index: the variables after the current step
};

// ---- the parts of a guard ----

static bool has_window(const Expr *e)
{
    bool has = e->kind == EX_ROLL;

    for (uint32_t i = 0; i < e->n && !has; i++)
        has = has_window(e->arg[i]);
    return has;
}

// Whether a transition of the same step cannot change what e reads: neither T nor what the machine writes.
static bool reads_only_inputs(const TrialNear *near, const Expr *e)
{
    const Program *p = near->t->a->p;
    bool only = e->kind != EX_ROLL && (e->kind != EX_VAR || (!e->var->written && e->var != p->t && e->var != p->s));

    for (uint32_t i = 0; i < e->n && only; i++)
        only = reads_only_inputs(near, e->arg[i]);
    return only;
}

static bool is_relation(SmOperator op) { return (COMPARISONS >> op & 1) != 0; }

static bool is_condition(const Expr *e)
{
    return (e->kind == EX_UNARY && e->op == SM_OP_NOT) || e->kind == EX_CHAIN ||
           (e->kind == EX_BINARY && (is_relation(e->op) || e->op == SM_OP_AND || e->op == SM_OP_OR));
}

static void add_parts(Arena *arena, NearGuard *g, const Expr *e, bool wanted, bool sampled);

// Adds a part.  If it compares the length of a run with a number, as `held` does, adds the parts of the condition that is sampled instead.
static void add_part(Arena *arena, NearGuard *g, const Expr *e, bool wanted, bool sampled)
{
    NearPart part = {.e = e, .span = e->span, .wanted = wanted, .sampled = sampled, .distance = -1};
    const bool compares = !has_window(e) && ((e->kind == EX_BINARY && is_relation(e->op)) || (e->kind == EX_CHAIN && wanted));

    if (e->kind == EX_BINARY && e->arg[0]->kind == EX_ROLL && is_condition(e->arg[0]->arg[0])) {
        add_parts(arena, g, e->arg[0]->arg[0], wanted, true);
        return;
    }
    for (uint32_t i = 0; compares && i + 1 < e->n; i++) {
        part.pair = comparison_at(e, i);
        if (e->kind == EX_CHAIN)
            part.span = span_join(part.pair.a->span, part.pair.b->span);
        vec_push(arena, &g->part, part);
    }
    if (!compares)
        vec_push(arena, &g->part, part);
}

static void add_parts(Arena *arena, NearGuard *g, const Expr *e, bool wanted, bool sampled)
{
    if (e->kind == EX_UNARY && e->op == SM_OP_NOT) {
        add_parts(arena, g, e->arg[0], !wanted, sampled);
    } else if (e->kind == EX_BINARY && (e->op == SM_OP_AND || e->op == SM_OP_OR)) {
        add_parts(arena, g, e->arg[0], wanted, sampled);
        add_parts(arena, g, e->arg[1], wanted, sampled);
    } else {
        add_part(arena, g, e, wanted, sampled);
    }
}

TrialNear *trial_near_new(const Trials *t)
{
    TrialNear *near = ARENA_NEW(t->a->arena, TrialNear);

    near->t = t;
    near->guard = ARENA_ARRAY(t->a->arena, NearGuard, t->a->p->stmts + 1u);
    near->value = ARENA_ARRAY(t->a->arena, double, t->a->p->var.n + 1u);
    for (size_t i = 0; i < t->a->transition.n; i++)
        for (const Condition *c = t->a->transition.at[i].when; c; c = c->outer)
            if (near->guard[c->stmt->number].part.n == 0)
                add_parts(t->a->arena, &near->guard[c->stmt->number], c->stmt->value, c->holds, false);
    return near;
}

// ---- recording ----

// Records whether the part is as the guard needs it after this step, and how close the sides of its comparison are.  The guard may have been
// evaluated with other values than those after the step: if the step has made a transition, records only parts that depend on inputs alone.
static void record_part(const TrialNear *near, NearPart *part, bool left)
{
    double a, b, distance;

    if (left && !part->pair.a ? !reads_only_inputs(near, part->e)
             : left && !(reads_only_inputs(near, part->pair.a) && reads_only_inputs(near, part->pair.b)))
        return;
    part->known = true;
    if (!part->pair.a) {
        part->met |= !has_window(part->e) && (expr_eval(part->e, near->value) != 0) == part->wanted;
        return;
    }
    a = expr_eval(part->pair.a, near->value);
    b = expr_eval(part->pair.b, near->value);
    distance = sm_abs(a - b);
    part->met |= ir_compare(ir_op_of_operator(part->pair.op), a, b) == part->wanted;
    if (distance >= 0 && (part->distance < 0 || distance < part->distance)) {
        part->distance = distance;
        part->at = a;
        part->to = b;
    }
}

void trial_near_record(TrialNear *near, const void *situation, const IrTrace *trace)
{
    const Trials *t = near->t;
    const double *var = trial_vars(t, situation);
    bool copied = false;

    for (uint32_t n = 0; n < trace->n; n++) {
        NearGuard *g = &near->guard[trace->at[n] >> 1];
        if (g->part.n == 0)
            continue;
        g->seen |= trace->at[n] & 1 ? WAS_TRUE : WAS_FALSE;
        if (g->seen == (WAS_TRUE | WAS_FALSE))
            continue;
        for (size_t v = 0; v < t->a->p->var.n && !copied; v++)
            near->value[v] = t->a->m->var_of[v] != IR_NONE ? var[t->a->m->var_of[v]] : 0;
        copied = true;
        for (size_t k = 0; k < g->part.n; k++)
            record_part(near, &g->part.at[k], trace->transition != 0);
    }
}

// ---- the notes ----

// Returns the outermost condition that was evaluated and never as the transition needs it; NULL: none.
static const Condition *find_unmet(const TrialNear *near, const Condition *when)
{
    const Condition *unmet = when ? find_unmet(near, when->outer) : NULL;
    const unsigned seen = when ? near->guard[when->stmt->number].seen : 0;

    return unmet || !when ? unmet : seen && !(seen & (when->holds ? WAS_TRUE : WAS_FALSE)) ? when : NULL;
}

// Describes a side of a comparison, rounded unless that makes it equal to the other side.
static const char *side_text(Arena *arena, const Expr *e, double x, double other)
{
    const double rounded = trial_check_round(x);

    return format_in(arena, "%s = %s", source_text(arena, e->span), const_text(arena, rounded == other ? x : rounded));
}

// Returns how close the sides of a comparison came, as the end of a sentence; "" if that was not computed.
static const char *closest_text(Arena *arena, const NearPart *part)
{
    const char *a, *b;

    if (part->distance < 0)
        return "";
    a = side_text(arena, part->pair.a, part->at, part->to);
    b = side_text(arena, part->pair.b, part->to, part->at);
    if (part->pair.a->kind != EX_NUMBER && part->pair.b->kind != EX_NUMBER)
        return format_in(arena, "; the closest was %s with %s", a, b);
    return format_in(arena, "; the closest was %s", part->pair.a->kind == EX_NUMBER ? b : a);
}

// Adds a note for each sensor of the comparison that has no @range, unless d has the note already.  noted: by Var.index.
static void note_ranges(const TrialNear *near, Diag *d, const NearPart *part, bool *noted)
{
    const InputDepsTable *deps = input_deps_of(near->t->a);
    const InputDeps by = input_deps_of_expr(deps, part->e);

    for (uint32_t i = 0; i < by.n; i++) {
        const Var *v = by.sensor[i];
        if (!v->range && !noted[v->index])
            diag_note(near->t->a->diags, d, v->span, DIAG_note_gap_range, v->name->text);
        noted[v->index] = true;
    }
}

// Adds a note about the first part of the guard that was never as the transition needs it; without such a part, that the parts never were so
// together, or not for long enough.  noted: as in note_ranges.
static void note_guard(const TrialNear *near, Diag *d, const State *to, const Condition *unmet, bool *noted)
{
    Arena *arena = near->t->a->arena;
    const NearGuard *g = &near->guard[unmet->stmt->number];
    const char *name = to->name->text;
    bool sampled = false, all_known = true;

    for (size_t k = 0; k < g->part.n; k++) {
        const NearPart *part = &g->part.at[k];
        sampled |= part->sampled;
        all_known &= part->known;
        if (part->met || !part->known || (!part->pair.a && has_window(part->e) && g->part.n > 1))
            continue;
        diag_note(near->t->a->diags, d, part->span, DIAG_note_gap_guard, name, source_text(arena, part->span),
                  part->wanted ? "true" : "false", closest_text(arena, part));
        note_ranges(near, d, part, noted);
        return;
    }
    if (!all_known) {
        diag_note(near->t->a->diags, d, unmet->stmt->value->span, DIAG_note_gap_guard, name, source_text(arena, unmet->stmt->value->span),
                  unmet->holds ? "true" : "false", "");
        return;
    }
    diag_note(near->t->a->diags, d, unmet->stmt->value->span, sampled ? DIAG_note_gap_duration : DIAG_note_gap_together, name,
              source_text(arena, unmet->stmt->value->span), unmet->holds ? "true" : "false");
}

void trial_near_note(const TrialNear *near, Diag *d)
{
    const Trials *t = near->t;
    bool *noted = ARENA_ARRAY(t->a->arena, bool, t->a->p->state.n + 1u), *of_sensor = ARENA_ARRAY(t->a->arena, bool, t->a->p->var.n);
    int notes = 0;

    for (size_t i = 0; i < t->a->transition.n && notes < NOTES_MAX; i++) {
        const Transition *x = &t->a->transition.at[i];
        const Condition *unmet;
        if (t->state[x->to->number - 1].reached || !t->state[x->from->number - 1].reached || noted[x->to->number])
            continue;
        unmet = find_unmet(near, x->when);
        if (!unmet)
            continue;
        note_guard(near, d, x->to, unmet, of_sensor);
        noted[x->to->number] = true;
        notes++;
    }
}
