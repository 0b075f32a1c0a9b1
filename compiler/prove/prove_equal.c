// SPDX-License-Identifier: Apache-2.0
// Conditions compared with each other, whatever values the variables have.
#include "compiler/prove/prove_equal.h"

#include "compiler/base/bitset.h"
#include "compiler/prove/prove.h"
#include "compiler/prove/prove_explore.h"

// ---- contradictions ----

static Expr *new_expr(Arena *arena, ExprKind kind, SmOperator op, Expr *a, Expr *b)
{
    Expr *e = arena_alloc(arena, sizeof *e + 2 * sizeof *e->arg);

    e->kind = kind;
    e->op = op;
    e->span = a->span;
    e->arg[e->n++] = a;
    if (b)
        e->arg[e->n++] = b;
    return e;
}

// Returns what a requirement that is judged step by step requires of a step with its premise.
static Expr *condition_to_meet(Arena *arena, const Requirement *r)
{
    return r->kind == REQUIREMENT_NEVER ? new_expr(arena, EX_UNARY, SM_OP_NOT, r->a, NULL) : r->b;
}

static const Expr *premise_of(const Requirement *r) { return r->kind == REQUIREMENT_ALWAYS ? r->a : NULL; }

// Whether the condition can be true in a step with the premise, which can be NULL.
static bool can_be_true(Arena *arena, const IrMachine *m, const Requirements *all, const Expr *premise, Expr *condition)
{
    Expr *both = premise ? new_expr(arena, EX_BINARY, SM_OP_AND, (Expr *)premise, condition) : condition;
    const Requirement never = {.kind = REQUIREMENT_NEVER, .a = both};

    return prove_can_violate(arena, prove_model_new(arena, m, all, &never, 1, PROVE_EXACT, NULL));
}

static bool is_judged_alone(const Requirement *r) { return r->kind == REQUIREMENT_NEVER || r->kind == REQUIREMENT_ALWAYS; }

// Whether two requirements can each be met where their premise is true, but never both.
static bool contradict_each_other(Arena *arena, const IrMachine *m, const Requirements *all, const Requirement *a, const Requirement *b)
{
    const Expr *of_a = premise_of(a), *of_b = premise_of(b);

    if (!is_judged_alone(a) || !is_judged_alone(b) || (of_a != of_b && (!of_a || !of_b || !expr_equal(of_a, of_b, NULL))))
        return false;
    return !can_be_true(arena, m, all, of_a,
                        new_expr(arena, EX_BINARY, SM_OP_AND, condition_to_meet(arena, a), condition_to_meet(arena, b)))
        && can_be_true(arena, m, all, of_a, condition_to_meet(arena, a)) && can_be_true(arena, m, all, of_a, condition_to_meet(arena, b));
}

// The variables that a requirement reads, as a set of their indices.  `clock`: they include S, T or G, whose values depend on each other.
typedef struct VariablesRead { const Program *p; uint64_t *set; bool clock; } VariablesRead;

// Called by expr_walk for each part of a condition.
static void note_read(Expr *e, void *context)
{
    VariablesRead *v = context;

    if (e->kind != EX_VAR)
        return;
    bitset_add(v->set, e->var->index);
    v->clock = v->clock || e->var->kind == VAR_TIME || e->var == v->p->g || e->var == v->p->s;
}

static VariablesRead *find_variables_read(Arena *arena, const Requirements *r)
{
    VariablesRead *read = ARENA_ARRAY(arena, VariablesRead, r->at.n);

    for (uint32_t i = 0; i < r->at.n; i++) {
        Expr *const part[] = {(Expr *)r->at.at[i].a, (Expr *)r->at.at[i].b, (Expr *)r->at.at[i].c};
        read[i] = (VariablesRead){r->program, ARENA_ARRAY(arena, uint64_t, bitset_words(r->program->var.n)), false};
        for (size_t k = 0; k < sizeof part / sizeof *part; k++)
            if (part[k])
                expr_walk(part[k], note_read, &read[i]);
    }
    return read;
}

// Whether two requirements share a variable: conditions on different variables can be met together if each can be met.
static bool share_a_variable(const VariablesRead *a, const VariablesRead *b)
{
    bool shared = a->clock && b->clock;

    for (size_t i = 0; i < bitset_words(a->p->var.n) && !shared; i++)
        shared = (a->set[i] & b->set[i]) != 0;
    return shared;
}

bool prove_find_contradiction(Arena *arena, const Requirements *r, const Requirement **first, const Requirement **second)
{
    const IrMachine *m = ir_build(arena, r->program);
    const VariablesRead *read = find_variables_read(arena, r);
    Arena pair;                       // each pair has models of its own, which nothing needs afterwards
    bool found = false;

    arena_init_within(&pair, arena);
    for (uint32_t i = 0; i < r->at.n && !found; i++)
        for (uint32_t k = i + 1; k < r->at.n && !found; k++) {
            *first = &r->at.at[i];
            *second = &r->at.at[k];
            found = share_a_variable(&read[i], &read[k]) && contradict_each_other(&pair, m, r, *first, *second);
            arena_reset(&pair);
        }
    return found;
}

// ---- windows with equal conditions ----

static bool is_run(uint32_t stats) { return (stats & SM_STATS_OF_RUNS) != 0; }

// What a condition reads.
typedef struct ConditionReads {
    const Expr *other;        // NULL, or a condition that may read the same variable
    bool is_unchanged;        // no step changes what it reads, and it reads no window
    bool is_shared;           // `other` reads one of its variables, too
} ConditionReads;

static bool reads(const Expr *e, const Var *v)
{
    bool found = e->kind == EX_VAR && e->var == v;

    for (uint32_t n = 0; n < e->n && !found; n++)
        found = reads(e->arg[n], v);
    return found;
}

static void find_reads(Expr *e, void *context)
{
    ConditionReads *r = context;

    r->is_unchanged = r->is_unchanged && (e->kind != EX_VAR || !e->var->written) && e->kind != EX_ROLL;
    r->is_shared = r->is_shared || (e->kind == EX_VAR && r->other && reads(r->other, e->var));
}

// Whether two conditions can have the same value in every step, to be decided by are_equal: both are values of the step alone.
static bool may_be_equal(Expr *a, Expr *b)
{
    ConditionReads of_a = {.other = b, .is_unchanged = true}, of_b = {.is_unchanged = true};

    expr_walk(a, find_reads, &of_a);
    expr_walk(b, find_reads, &of_b);
    return of_a.is_unchanged && of_b.is_unchanged && of_a.is_shared;
}

// Whether no values of the variables violate `always a implies b`.
static bool implies(Arena *arena, const IrMachine *m, const Requirements *all, Expr *a, Expr *b)
{
    const Requirement always = {.kind = REQUIREMENT_ALWAYS, .a = a, .b = b};

    return !prove_can_violate(arena, prove_model_new(arena, m, all, &always, 1, PROVE_EXACT, NULL));
}

// Whether two conditions are true in the same steps.  The facts that follow from one condition decide the other one: after `a > 60 or b > 60` those
// about a and b decide max(a, b) > 60, but not the other way round.
static bool are_equal(Arena *arena, const IrMachine *m, const Requirements *all, Expr *a, Expr *b)
{
    Expr *not_a = new_expr(arena, EX_UNARY, SM_OP_NOT, a, NULL), *not_b = new_expr(arena, EX_UNARY, SM_OP_NOT, b, NULL);

    return (implies(arena, m, all, a, b) || implies(arena, m, all, not_b, not_a))
        && (implies(arena, m, all, b, a) || implies(arena, m, all, not_a, not_b));
}

// Returns the window of the machine that stores the same run as w.
static uint32_t find_equal_window(Arena *arena, const IrMachine *m, const Requirements *all, const Window *w)
{
    for (uint32_t n = 0; is_run(1u << w->stat) && n < m->window.n; n++) {
        const Window *of = m->window.at[n].first;
        if (of && is_run(m->window.at[n].stats) && of->size == w->size && of->gap == w->gap && may_be_equal(w->sample, of->sample)
            && are_equal(arena, m, all, w->sample, of->sample))
            return n;
    }
    return IR_NONE;
}

const uint32_t *prove_find_equal_windows(Arena *arena, const IrMachine *m, const Requirements *all)
{
    uint32_t *equal = ARENA_ARRAY(arena, uint32_t, all->window.n + 1u);

    for (uint32_t n = 0; n < all->window.n; n++)
        equal[n] = find_equal_window(arena, m, all, &all->window.at[n]);
    return equal;
}
