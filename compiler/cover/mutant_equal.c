// SPDX-License-Identifier: Apache-2.0
// Proves that a mutant is equivalent.  As long as the changed statement has the same effect, the states of mutant and machine are equal.  So it is
// enough to prove that no run of the unchanged machine reaches a step in which the effect differs.  To do so, conditionals are added to the machine
// before the statement.  They lead to a probe (a store that facts can find unreachable) exactly if the effect differs:
//
//     if p > 100: -> Abort           `>` changed to `>=`:   if p >= 100 { if not (p > 100) { probe } }
//
// If facts (facts.h) exclude every path to the probe, the mutant is equivalent.
#include "compiler/cover/mutant.h"

#include <string.h>

#include "compiler/facts/facts.h"

enum { CONDITIONS_MOST = 64 };        // the most conditions around a probe; if more are needed, nothing is proved

// An expression that a mutant changes, and where in the machine it is.
typedef struct Probe {
    Arena *arena;
    const Program *p;
    const MutantEdit *edit;           // all edits of the mutant
    const Expr *around[CONDITIONS_MOST];      // the changed expression has an effect only if all of these are true
    size_t n;                         // number of conditions in `around`
    bool is_full;                     // conditions were left out, because there are too many
} Probe;

// ---- expressions ----

static Expr *make_expr(Arena *a, ExprKind kind, SmOperator op, uint32_t n)
{
    Expr *e = arena_alloc(a, sizeof *e + n * (sizeof(Expr *) + sizeof(SmOperator)));

    e->kind = kind;
    e->op = op;
    e->n = n & 0xffffff;
    return e;
}

static Expr *make_unary(Arena *a, SmOperator op, const Expr *x)
{
    Expr *e = make_expr(a, EX_UNARY, op, 1);

    e->arg[0] = (Expr *)x;
    return e;
}

static Expr *make_binary(Arena *a, SmOperator op, const Expr *x, const Expr *y)
{
    Expr *e = make_expr(a, EX_BINARY, op, 2);

    e->arg[0] = (Expr *)x;
    e->arg[1] = (Expr *)y;
    return e;
}

static Expr *make_number(Arena *a, double x)
{
    Expr *e = make_expr(a, EX_NUMBER, SM_OP_COUNT, 0);

    e->number = x;
    return e;
}

static Expr *make_variable(Arena *a, Var *v)
{
    Expr *e = make_expr(a, EX_VAR, SM_OP_COUNT, 0);

    e->var = v;
    return e;
}

// Applies to the copy of an expression the edits that the mutant makes to the original.
static void apply_edit(const Probe *k, const Expr *original, Expr *e)
{
    for (const MutantEdit *d = k->edit; d; d = d->next) {
        if (d->e != original)
            continue;
        switch (d->kind) {
        case EDIT_NUMBER: e->number = d->number; break;
        case EDIT_OPERATOR: e->op = d->op; break;
        case EDIT_LINK: expr_ops(e)[d->link] = d->op; break;
        case EDIT_DROP_NOT: e->op = SM_OP_PLUS; break;
        case EDIT_GUARD: case EDIT_TARGET: case EDIT_DELETE: case EDIT_INITIAL: break;
        }
    }
}

// Returns a copy of e with the edits of the mutant.
static Expr *copy_with_edits(const Probe *k, const Expr *e)
{
    Expr *copy = make_expr(k->arena, e->kind, e->op, e->n);

    *copy = *e;
    for (uint32_t i = 0; i < e->n; i++)
        copy->arg[i] = e->kind == EX_ROLL ? e->arg[i] : copy_with_edits(k, e->arg[i]);
    if (e->kind == EX_CHAIN)
        memcpy(expr_ops(copy), expr_ops(e), (e->n - 1) * sizeof(SmOperator));
    apply_edit(k, e, copy);
    return copy;
}

// Whether `part` is the expression e or inside it.
static bool contains(const Expr *e, const Expr *part)
{
    if (e == part)
        return true;
    for (uint32_t i = 0; i < e->n; i++)
        if (contains(e->arg[i], part))
            return true;
    return false;
}

// ---- where the change decides ----

// Adds a condition that is known to hold where the edited expression is computed.
static void add_condition(Probe *k, const Expr *e)
{
    if (k->n < CONDITIONS_MOST)
        k->around[k->n++] = e;
    else
        k->is_full = true;
}

// Splits a chain of comparisons such as a < b < c: returns the one that contains the change, and adds the others as conditions.  Returns e itself
// if two of them contain it.
static const Expr *split_chain(Probe *k, const Expr *e, const MutantEdit *d, const Expr **new)
{
    const Expr *copy = copy_with_edits(k, e);
    uint32_t link = d->link, arg = 0;

    if (d->kind != EDIT_LINK || d->e != e) {
        while (!contains(e->arg[arg], d->e))
            arg++;
        if (arg > 0 && arg + 1 < e->n)
            return e;
        link = arg > 0 ? arg - 1 : 0;
    }
    for (uint32_t i = 0; i + 1 < e->n; i++)
        if (i != link)
            add_condition(k, make_binary(k->arena, expr_ops(e)[i], e->arg[i], e->arg[i + 1]));
    *new = make_binary(k->arena, expr_ops(copy)[link], copy->arg[link], copy->arg[link + 1]);
    return make_binary(k->arena, expr_ops(e)[link], e->arg[link], e->arg[link + 1]);
}

// Finds the smallest condition that contains the change, going down through `and`, `or` and `not`.  It decides only if the other operands of
// each `and` are true, and those of each `or` are false.  Returns it, and sets *new to what the mutant has there.
static const Expr *find_condition(Probe *k, const Expr *e, const MutantEdit *d, const Expr **new)
{
    for (;;) {
        const bool is_join = e->kind == EX_BINARY && (e->op == SM_OP_AND || e->op == SM_OP_OR);
        if (e != d->e && e->kind == EX_UNARY && e->op == SM_OP_NOT) {
            e = e->arg[0];
        } else if (e != d->e && is_join) {
            const uint32_t side = contains(e->arg[1], d->e);
            const Expr *other = e->arg[!side];
            if (side && contains(other, d->e))
                break;
            add_condition(k, e->op == SM_OP_AND ? other : make_unary(k->arena, SM_OP_NOT, other));
            e = e->arg[side];
        } else {
            break;
        }
    }
    *new = copy_with_edits(k, e);
    return e->kind == EX_CHAIN ? split_chain(k, e, d, new) : e;
}

// Whether an expression is true or false by its kind: a comparison or a logic operator.
static bool is_truth(const Expr *e)
{
    return e->kind == EX_CHAIN || (e->kind == EX_UNARY && e->op == SM_OP_NOT) ||
           (e->kind == EX_BINARY && (e->op == SM_OP_AND || e->op == SM_OP_OR || (e->op >= SM_OP_EQ && e->op <= SM_OP_GE)));
}

// ---- the probe in the machine ----

static Stmt *make_if(Arena *a, const Expr *guard)
{
    Stmt *s = ARENA_NEW(a, Stmt);

    s->kind = ST_IF;
    s->value = (Expr *)guard;
    return s;
}

// Returns a variable that a probe program can assign to; NULL if the program has no such variable.
static Var *find_assigned(const Program *p)
{
    for (size_t i = 0; i < p->var.n; i++)
        if (p->var.at[i]->written && !p->var.at[i]->read_only)
            return p->var.at[i];
    return NULL;
}

// Whether facts allow a path to a statement.
static bool may_execute(FactMachine *facts, const IrFn *f, const Env *begin, uint32_t stmt)
{
    const FactFlow flow = facts_of_function(facts, f, begin);

    for (uint32_t b = 0; b < f->blk.n; b++)
        for (uint32_t i = 0; flow.reached[b] && i < f->blk.at[b].ins.n; i++)
            if (f->ins.at[f->blk.at[b].ins.at[i]].stmt == stmt)
                return true;
    return false;
}

// Whether the facts allow the statement to be executed in any state.
static bool may_execute_anywhere(Arena *work, const Program *p, uint32_t stmt)
{
    const IrMachine *m = ir_build(work, p);
    FactMachine *facts = facts_of_machine(work, m);

    for (size_t s = 0; s < m->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            if (m->state.at[s].block[b] && may_execute(facts, m->state.at[s].block[b], facts_at_begin(facts, s, b), stmt))
                return true;
    return false;
}

// Whether some run may execute the statement while all conditions of the probe and the n of `extra` are true.
static bool may_differ(Probe *k, Stmt *s, const Expr *const *extra, size_t n)
{
    const Stmt was = *s;
    Stmt *rest = arena_copy(k->arena, s, sizeof *s), *probe = ARENA_NEW(k->arena, Stmt), *outer = probe;
    bool result;

    probe->kind = ST_ASSIGN;
    probe->number = s->number;
    probe->var = find_assigned(k->p);
    probe->value = make_number(k->arena, 0);
    if (!probe->var || k->is_full)
        return true;
    for (size_t i = n + k->n; i-- > 0; ) {
        Stmt *inside = outer;
        outer = make_if(k->arena, i < k->n ? k->around[i] : extra[i - k->n]);
        vec_push(k->arena, &outer->then, inside);
    }
    rest->number = 0;
    *s = *make_if(k->arena, make_number(k->arena, 1));
    s->span = was.span;
    vec_push(k->arena, &s->then, outer);
    vec_push(k->arena, &s->then, rest);
    result = may_execute_anywhere(k->arena, k->p, was.number);
    *s = was;
    return result;
}

// ---- time between two steps ----

static bool is_time_comparison(const Program *p, const Expr *e)
{
    return e->kind == EX_BINARY && e->op >= SM_OP_EQ && e->op <= SM_OP_GE && e->arg[0]->kind == EX_VAR && e->arg[0]->var == p->t
        && expr_is_constant(e->arg[1]);
}

static bool compare_numbers(SmOperator op, double a, double b)
{
    switch ((int)op) {
    case SM_OP_EQ: return a == b;
    case SM_OP_NE: return a != b;
    case SM_OP_LT: return a < b;
    case SM_OP_LE: return a <= b;
    case SM_OP_GT: return a > b;
    default: return a >= b;
    }
}

// Whether two comparisons of T with constants have the same result for every multiple of the step.  Each changes its result only at its
// constant, so the multiples around both constants are enough.
static bool is_same_at_every_step(const Program *p, const Expr *old, const Expr *new, uint64_t step)
{
    const Expr *both[] = {old, new};

    if (step == 0 || !is_time_comparison(p, old) || !is_time_comparison(p, new))
        return false;
    for (int i = 0; i < 2; i++) {
        const double x = expr_constant_value(both[i]->arg[1]), near = (double)(int64_t)(x / (double)step);
        if (!(x >= 0 && x < FACT_EXACT / 2))
            return false;
        for (int by = -1; by <= 2; by++) {
            const double t = (near + by) * (double)step;
            if (t >= 0 && compare_numbers(old->op, t, expr_constant_value(old->arg[1]))
                != compare_numbers(new->op, t, expr_constant_value(new->arg[1])))
                return false;
        }
    }
    return true;
}

uint64_t mutant_step(const Program *p, const Script *const *script, uint32_t scripts)
{
    if (p->step || scripts == 0 || script[0]->by_rows)
        return p->step;
    for (uint32_t i = 1; i < scripts; i++)
        if (script[i]->by_rows || script[i]->delta_t != script[0]->delta_t)
            return 0;
    return script[0]->delta_t;
}

// ---- a mutant ----

// Whether it is proved that the old and the new condition are always both true or both false.
static bool has_same_truth(Probe *k, Stmt *s, const Expr *old, const Expr *new)
{
    const Expr *only_old[] = {old, make_unary(k->arena, SM_OP_NOT, new)}, *only_new[] = {new, make_unary(k->arena, SM_OP_NOT, old)};

    return !may_differ(k, s, only_old, 2) && !may_differ(k, s, only_new, 2);
}

static bool is_float(SmType t) { return t == SM_F32 || t == SM_F64; }

// Whether it is proved that the statement stores the same value with `new` as with `old`.  In a float, -0 and 0 compare as equal but are different
// values.
static bool has_same_value(Probe *k, Stmt *s, const Expr *old, const Expr *new)
{
    const Expr *differ = make_binary(k->arena, SM_OP_NE, old, new);

    if (is_float(s->var->type))
        return !may_differ(k, s, NULL, 0);
    return !may_differ(k, s, &differ, 1);
}

// Whether a variable may have so large a value that F64 rounds it when it is read.
static bool may_be_rounded(Probe *k, const MutantEdit *d)
{
    Expr *v = make_variable(k->arena, d->stmt->var);
    const Expr *above = make_binary(k->arena, SM_OP_GE, v, make_number(k->arena, FACT_EXACT));
    const Expr *below = make_binary(k->arena, SM_OP_LE, v, make_number(k->arena, -FACT_EXACT));

    if (v->var->type != SM_U64 && v->var->type != SM_I64)
        return false;
    return may_differ(k, d->stmt, &above, 1) || may_differ(k, d->stmt, &below, 1);
}

// Whether the edited expression always has the value of the original one.
static bool has_same_expression(Probe *k, const MutantEdit *d, bool is_only, uint64_t step)
{
    const Expr *new = NULL, *old = d->stmt->value;

    if (!is_only)
        new = copy_with_edits(k, old);
    else if (d->stmt->kind == ST_IF || is_truth(old))
        old = find_condition(k, old, d, &new);
    else
        new = copy_with_edits(k, old);
    if (is_same_at_every_step(k->p, old, new, step))
        return true;
    return d->stmt->kind == ST_IF || is_truth(d->stmt->value) ? has_same_truth(k, d->stmt, old, new) : has_same_value(k, d->stmt, old, new);
}

// Whether it is proved that edit d alone makes no difference.  is_only: no other edit of the mutant is in the same statement.
static bool is_without_effect(Arena *work, const Program *p, const MutantEdit *all, const MutantEdit *d, bool is_only, uint64_t step)
{
    Probe k = {.arena = work, .p = p, .edit = all};

    switch (d->kind) {
    case EDIT_NUMBER: case EDIT_OPERATOR: case EDIT_LINK: case EDIT_DROP_NOT: return d->stmt && has_same_expression(&k, d, is_only, step);
    case EDIT_GUARD: return has_same_truth(&k, d->stmt, d->stmt->value, make_number(work, d->number));
    case EDIT_TARGET: return !may_differ(&k, d->stmt, NULL, 0);
    case EDIT_DELETE:
        if (d->stmt->kind == ST_ASSIGN)
            return has_same_value(&k, d->stmt, make_variable(work, d->stmt->var), d->stmt->value) && !may_be_rounded(&k, d);
        return !may_differ(&k, d->stmt, NULL, 0);
    case EDIT_INITIAL: break;
    }
    return false;
}

bool mutant_is_equivalent(Arena *work, const Program *p, const MutantEdit *edit, uint64_t step)
{
    for (const MutantEdit *d = edit; d; d = d->next) {
        bool is_only = true;
        for (const MutantEdit *other = edit; other; other = other->next)
            is_only = is_only && (other == d || other->stmt != d->stmt);
        if (d->kind == EDIT_INITIAL ? !mutant_initial_is_unread(p, d->var) : !is_without_effect(work, p, edit, d, is_only, step))
            return false;
    }
    return true;
}
