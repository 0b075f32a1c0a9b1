// SPDX-License-Identifier: Apache-2.0
#include "compiler/cover/mutant_cases.h"

#include <string.h>

#include "compiler/facts/facts.h"
#include "stdlib/convert.h"

enum { CONDITIONS_MOST = 64 };        // in a case; with more of them nothing is known

// An expression that a mutant changes, and where in the machine it is.
typedef struct EditPlace {
    MutantCases *cases;
    Arena *arena;
    const Program *p;
    const MutantEdit *edit;           // all edits of the mutant
    const Expr *around[CONDITIONS_MOST];      // under these conditions the changed expression decides
    size_t n;
    bool is_full;                     // conditions were left out, because there are too many
} EditPlace;

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
static void apply_edit(const EditPlace *k, const Expr *original, Expr *e)
{
    for (const MutantEdit *d = k->edit; d; d = d->next) {
        if (d->e != original)
            continue;
        switch (d->kind) {
        case EDIT_NUMBER:
            e->kind = EX_NUMBER;                      // it can be a constant of [local], too
            e->number = d->number;
            break;
        case EDIT_OPERATOR: e->op = d->op; break;
        case EDIT_LINK: expr_ops(e)[d->link] = d->op; break;
        case EDIT_DROP_UNARY: e->op = SM_OP_PLUS; break;
        case EDIT_GUARD: case EDIT_TARGET: case EDIT_DELETE: case EDIT_INITIAL: break;
        }
    }
}

// Returns a copy of e with the edits of the mutant.
static Expr *copy_with_edits(const EditPlace *k, const Expr *e)
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
static void add_condition(EditPlace *k, const Expr *e)
{
    if (k->n < CONDITIONS_MOST)
        k->around[k->n++] = e;
    else
        k->is_full = true;
}

// Splits a chain of comparisons such as a < b < c: returns the one that contains the change, and adds the others as conditions.  Returns e itself
// if two of them contain it.
static const Expr *split_chain(EditPlace *k, const Expr *e, const MutantEdit *d, const Expr **new)
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
static const Expr *find_condition(EditPlace *k, const Expr *e, const MutantEdit *d, const Expr **new)
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

// ---- cases ----

// Adds a case: the conditions of the place and the n of `extra` are true when the statement is reached.  certain: so many of all these must be
// true whenever the mutant differs.
static void add_case(EditPlace *k, Stmt *s, const Expr *const *extra, size_t n, size_t uncertain)
{
    MutantCase c = {.stmt = s, .n = (uint32_t)(k->n + n), .certain = (uint32_t)(k->n + n - uncertain)};
    const Expr **when = arena_array(k->arena, k->n + n + 1, sizeof *when);

    k->cases->unknown |= k->is_full;
    memcpy(when, k->around, k->n * sizeof *when);
    for (size_t i = 0; i < n; i++)
        when[k->n + i] = extra[i];
    c.when = when;
    vec_push(k->arena, &k->cases->at, c);
}

// The old and the new condition differ: one of them is true.
static void add_truth_cases(EditPlace *k, Stmt *s, const Expr *old, const Expr *new)
{
    const Expr *only_old[] = {old, make_unary(k->arena, SM_OP_NOT, new)}, *only_new[] = {new, make_unary(k->arena, SM_OP_NOT, old)};

    add_case(k, s, only_old, 2, 0);
    add_case(k, s, only_new, 2, 0);
}

static bool is_float(SmType t) { return t == SM_F32 || t == SM_F64; }

// The statement stores another value.  -0 and 0 are equal, but not the same in a float.
static void add_value_case(EditPlace *k, Stmt *s, const Expr *old, const Expr *new)
{
    const Expr *differ = make_binary(k->arena, SM_OP_NE, old, new);

    add_case(k, s, &differ, 1, is_float(s->var->type));
}

// A variable has so large a value that F64 rounds it when it is read.
static void add_rounding_cases(EditPlace *k, Stmt *s)
{
    Expr *v = make_variable(k->arena, s->var);
    const Expr *above = make_binary(k->arena, SM_OP_GE, v, make_number(k->arena, FACT_EXACT));
    const Expr *below = make_binary(k->arena, SM_OP_LE, v, make_number(k->arena, -FACT_EXACT));

    if (v->var->type != SM_U64 && v->var->type != SM_I64)
        return;
    add_case(k, s, &above, 1, 0);
    add_case(k, s, &below, 1, 0);
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

// ---- values that no variable has ----

typedef enum Grid { GRID_F32, GRID_WHOLE } Grid;

static bool is_number_on(Grid g, double x)
{
    return g == GRID_F32 ? (double)(float)x == x : x > -FACT_EXACT && x < FACT_EXACT && x == (double)(int64_t)x;
}

// Whether every value of an expression is one that an F32 can have, or a whole number.
static bool is_on_grid(const Program *p, const Expr *e, Grid g)
{
    static const uint32_t samples = 1u << SM_STAT_MIN | 1u << SM_STAT_MAX | 1u << SM_STAT_OLDEST | 1u << SM_STAT_NEWEST;
    bool all = true;

    switch (e->kind) {
    case EX_NUMBER: return is_number_on(g, e->number);
    case EX_VAR: return g == GRID_F32 ? e->var->type == SM_F32 : e->var->type != SM_F32 && e->var->type != SM_F64;
    case EX_CALL:
        for (uint32_t i = 0; i < e->n; i++)
            all = all && is_on_grid(p, e->arg[i], g);
        return all && (e->fn == SM_FN_max || e->fn == SM_FN_min || e->fn == SM_FN_abs);
    case EX_ROLL:
        return 1u << e->stat & samples && is_on_grid(p, p->window.at[e->window].sample, g);
    default: return false;
    }
}

// Whether the operators differ only for equal operands.
static bool differs_when_equal(SmOperator a, SmOperator b)
{
    return (a == SM_OP_LT && b == SM_OP_LE) || (a == SM_OP_LE && b == SM_OP_LT) || (a == SM_OP_GT && b == SM_OP_GE) ||
           (a == SM_OP_GE && b == SM_OP_GT);
}

// Whether both are comparisons with a number that the other operand never has, such as that of an F32 with 0.4, and differ only for equal operands.
static bool is_same_off_grid(const Program *p, const Expr *old, const Expr *new)
{
    if (old->kind != EX_BINARY || new->kind != EX_BINARY || !differs_when_equal(old->op, new->op))
        return false;
    for (int side = 0; side < 2; side++)
        for (int g = GRID_F32; g <= GRID_WHOLE; g++)
            if (expr_is_constant(old->arg[side]) && old->arg[side]->kind != EX_ROLL && !is_number_on((Grid)g, expr_constant_value(old->arg[side]))
                && is_on_grid(p, old->arg[!side], (Grid)g))
                return true;
    return false;
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

// ---- edits ----

// Adds when the edited expression does not have the value of the original one.
static void add_expression_cases(EditPlace *k, const MutantEdit *d, bool is_only, uint64_t step)
{
    const Expr *new = NULL, *old = d->stmt->value;
    const bool is_condition = d->stmt->kind == ST_IF || is_truth(old);

    if (is_only && is_condition)
        old = find_condition(k, old, d, &new);
    else
        new = copy_with_edits(k, old);
    if (is_same_at_every_step(k->p, old, new, step) || is_same_off_grid(k->p, old, new))
        return;
    if (is_condition)
        add_truth_cases(k, d->stmt, old, new);
    else
        add_value_case(k, d->stmt, old, new);
}

// Adds when one edit makes a difference.  is_only: no other edit of the mutant is in its statement.
static void add_edit_cases(MutantCases *c, Arena *arena, const Program *p, const MutantEdit *all, const MutantEdit *d, bool is_only, uint64_t step)
{
    EditPlace k = {.cases = c, .arena = arena, .p = p, .edit = all};

    switch (d->kind) {
    case EDIT_NUMBER: case EDIT_OPERATOR: case EDIT_LINK: case EDIT_DROP_UNARY:
        c->unknown |= !d->stmt;
        if (d->stmt)
            add_expression_cases(&k, d, is_only, step);
        break;
    case EDIT_GUARD: add_truth_cases(&k, d->stmt, d->stmt->value, make_number(arena, d->number)); break;
    case EDIT_TARGET: add_case(&k, d->stmt, NULL, 0, 0); break;
    case EDIT_DELETE:
        if (d->stmt->kind == ST_ASSIGN) {
            add_value_case(&k, d->stmt, make_variable(arena, d->stmt->var), d->stmt->value);
            add_rounding_cases(&k, d->stmt);
        } else {
            add_case(&k, d->stmt, NULL, 0, 0);
        }
        break;
    case EDIT_INITIAL: break;
    }
}

// ---- initial values ----

// A local whose initial value is changed to one above, and that is assigned a maximum of itself, and what does not depend on it.  Then the mutant's
// value is always that of the machine, or its maximum with the new initial value.  The same with a minimum and one below.
typedef struct Extreme {
    const Var *v;
    SmBuiltin fn;             // SM_FN_max or SM_FN_min
    double initial;           // the new one
} Extreme;

static bool reads(const Expr *e, const Var *v)
{
    bool found = e->kind == EX_VAR && e->var == v;

    for (uint32_t i = 0; i < e->n && !found; i++)
        found = reads(e->arg[i], v);
    return found;
}

// Whether e is the maximum (or for SM_FN_min the minimum) of the local, once, and of what does not depend on it.
static bool is_extreme_of_itself(const Extreme *k, const Expr *e)
{
    uint32_t own = 0;

    if (e->kind != EX_CALL || e->fn != k->fn)
        return false;
    for (uint32_t i = 0; i < e->n; i++)
        if (e->arg[i]->kind == EX_VAR && e->arg[i]->var == k->v)
            own++;
        else if (reads(e->arg[i], k->v))
            return false;
    return own == 1;
}

// Whether all assignments to the local in the list have one of the two forms.
static bool only_extremes(const Extreme *k, const Stmts *list)
{
    for (size_t i = 0; i < list->n; i++) {
        const Stmt *s = list->at[i];
        if (s->kind == ST_ASSIGN && s->var == k->v && reads(s->value, k->v) && !is_extreme_of_itself(k, s->value))
            return false;
        if (!only_extremes(k, &s->then) || !only_extremes(k, &s->otherwise))
            return false;
    }
    return true;
}

static bool only_extremes_of_program(const Extreme *k, const Program *p)
{
    for (size_t i = 0; i < p->state.n; i++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            if (!only_extremes(k, &p->state.at[i]->block[b]))
                return false;
    return true;
}

// Returns the value that an expression has in the mutant.
static Expr *copy_with_extreme(Arena *a, const Extreme *x, const Expr *e)
{
    Expr *copy = make_expr(a, e->kind, e->op, e->n);

    if (e->kind == EX_VAR && e->var == x->v) {
        copy = make_expr(a, EX_CALL, SM_OP_COUNT, 2);
        copy->fn = x->fn;
        copy->arg[0] = (Expr *)e;
        copy->arg[1] = make_number(a, x->initial);
        return copy;
    }
    *copy = *e;
    for (uint32_t i = 0; i < e->n; i++)
        copy->arg[i] = e->kind == EX_ROLL ? e->arg[i] : copy_with_extreme(a, x, e->arg[i]);
    if (e->kind == EX_CHAIN)
        memcpy(expr_ops(copy), expr_ops(e), (e->n - 1) * sizeof(SmOperator));
    return copy;
}

// Adds when a statement that reads the local has another effect in the mutant.
static void add_reading_cases(EditPlace *k, const Extreme *x, const Stmts *list)
{
    Expr *const bound = make_number(k->arena, x->initial);

    for (size_t i = 0; i < list->n; i++) {
        Stmt *s = list->at[i];
        if (s->value && reads(s->value, x->v) && !(s->kind == ST_ASSIGN && s->var == x->v)) {
            const Expr *new = copy_with_extreme(k->arena, x, s->value);
            k->n = 0;
            add_condition(k, make_binary(k->arena, x->fn == SM_FN_max ? SM_OP_LT : SM_OP_GT, make_variable(k->arena, (Var *)x->v), bound));
            if (s->kind == ST_IF || is_truth(s->value))
                add_truth_cases(k, s, s->value, new);
            else
                add_value_case(k, s, s->value, new);
        }
        add_reading_cases(k, x, &s->then);
        add_reading_cases(k, x, &s->otherwise);
    }
}

// Adds when the changed initial value of a variable makes a difference.
static void add_initial_cases(MutantCases *c, Arena *arena, const Program *p, const MutantEdit *d)
{
    const Var *v = d->var;
    const double was = sm_cell_to_f64(v->type, v->init), now = sm_cell_to_f64(v->type, sm_cell_from_f64(v->type, d->number));
    const Extreme x = {v, now > was ? SM_FN_max : SM_FN_min, now};
    EditPlace k = {.cases = c, .arena = arena, .p = p};

    if (mutant_initial_is_unread(p, v))
        return;
    if (now == 0 || now == was || !mutant_initial_is_own(p, v) || !only_extremes_of_program(&x, p)) {
        c->unknown = true;
        return;
    }
    for (size_t i = 0; i < p->state.n; i++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            add_reading_cases(&k, &x, &p->state.at[i]->block[b]);
}

// ---- constants ----

// The uses of constants whose value a mutant changes: each becomes an edit.
typedef struct Uses {
    Arena *arena;
    const double *value;      // by Var.index: in the mutant
    const bool *changed;      // by Var.index
    Stmt *stmt;
    MutantEdit *list;
} Uses;

static void add_use(Expr *e, void *context)
{
    Uses *k = context;
    MutantEdit edit = {.kind = EDIT_NUMBER, .e = e, .stmt = k->stmt, .next = k->list};

    if (e->kind != EX_VAR || !k->changed[e->var->index])
        return;
    edit.number = k->value[e->var->index];
    k->list = arena_copy(k->arena, &edit, sizeof edit);
}

static void add_uses(Uses *k, const Stmts *list)
{
    for (size_t i = 0; i < list->n; i++) {
        k->stmt = list->at[i];
        if (list->at[i]->value)
            expr_walk(list->at[i]->value, add_use, k);
        add_uses(k, &list->at[i]->then);
        add_uses(k, &list->at[i]->otherwise);
    }
}

// Returns the edits of all uses of a constant, and of constants that are computed from it.  Returns `d` itself if the mutant changes another
// variable than constants, or what a window samples.
static const MutantEdit *list_uses(Arena *arena, const Program *p, const MutantEdit *d)
{
    double *value = arena_array(arena, p->var.n, sizeof *value), was = mutant_initial_number(d->var)->number;
    uint64_t *init = arena_array(arena, p->var.n, sizeof *init);
    bool *changed = arena_alloc(arena, p->var.n), only_constants = true;
    Uses k = {.arena = arena, .value = value, .changed = changed};

    mutant_initial_number(d->var)->number = d->number;
    for (size_t i = 0; i < p->var.n; i++) {
        Var *v = p->var.at[i];
        init[i] = v->init;
        if (v->kind == VAR_LOCAL && v->init_value)
            v->init = sm_cell_from_f64(v->type, expr_constant_value(v->init_value));
        value[i] = sm_cell_to_f64(v->type, v->init);
        changed[i] = v->init != init[i];
        only_constants = only_constants && (!changed[i] || (v->is_constant && !v->sizes));
    }
    mutant_initial_number(d->var)->number = was;
    for (size_t i = 0; i < p->var.n; i++)
        p->var.at[i]->init = init[i];
    for (size_t i = 0; i < p->window.n; i++)
        expr_walk(p->window.at[i].sample, add_use, &k);
    if (!only_constants || k.list)
        return d;
    for (size_t i = 0; i < p->state.n; i++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            add_uses(&k, &p->state.at[i]->block[b]);
    return k.list;
}

// ---- all edits ----

MutantCases mutant_cases_list(Arena *arena, const Program *p, const MutantEdit *edit, uint64_t step)
{
    MutantCases c = {.unknown = false};

    if (edit->kind == EDIT_INITIAL)
        edit = list_uses(arena, p, edit);
    for (const MutantEdit *d = edit; d; d = d->next) {
        bool is_only = true;
        for (const MutantEdit *other = edit; other; other = other->next)
            is_only = is_only && (other == d || other->stmt != d->stmt);
        if (d->kind == EDIT_INITIAL)
            add_initial_cases(&c, arena, p, d);
        else
            add_edit_cases(&c, arena, p, edit, d, is_only, step);
    }
    return c;
}
