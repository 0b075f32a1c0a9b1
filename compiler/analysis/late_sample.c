// SPDX-License-Identifier: Apache-2.0
// Reports windows, prev, rising, falling, held and rate that sample a variable before the step assigns it.  All take their samples when a
// step begins (language.md 7.4, 7.27).  If the machine assigns the variable and then uses the call, the result lacks the value of this step.
//
// Not reported, because the old value is intended or is the only one available:
// 1. assignments after the use, as in `rate = x - last` ... `last = x`: at the use, the variable also has its old value;
// 2. assignments in .entry alone: they store an initial value, and the window samples the values that .step stores later;
// 3. an element combined with an input, as in `abs(order - position)`: the input is the reaction to the element's value of the last step;
// 4. a variable that the same expression also reads without a window, as in `min(p, roll_min(p, 1))`: that read has this step's value.
#include "compiler/analysis/guards_known.h"
#include "compiler/analysis/transitions.h"

typedef struct StatUse {
    Analysis *a;
    const Stmts *block;
    const KnownGuard *known;      // the guards known at the expression, and the assignments before it (guards_known.h)
    const Expr *value;            // the whole expression of the statement
    const Expr *roll;             // the roll call in `value` whose sample is being searched
} StatUse;

// Returns the last assignment to v in the list, which was or may have been executed before the expression; or NULL.
static const Stmt *find_assignment(const KnownGuard *known, const Var *v)
{
    for (; known; known = known->outer)
        if (known->assigned && known->assigned->var == v)
            return known->assigned;
    return NULL;
}

static bool reads_written_variable(const Expr *e)
{
    bool found = e->kind == EX_VAR && e->var->written;

    for (uint32_t i = 0; i < e->n && !found; i++)
        found = reads_written_variable(e->arg[i]);
    return found;
}

// Whether the window could sample the assigned expression instead of the variable: the assignment is executed in every step of the
// state, the expression reads nothing that the machine writes, and the variable stores its value exactly, without rounding, truncation
// or saturation.
static bool can_sample_assigned_value(const StatUse *u, const Stmt *assigned)
{
    const Fact value = u->a->stmt[assigned->number].value;
    const SmType type = assigned->var->type;
    const bool is_float = sm_type_info[type].kind == SM_KIND_FLOAT;
    bool is_always_executed = false;

    for (size_t i = 0; i < u->block->n; i++)
        is_always_executed |= u->block->at[i] == assigned;
    return is_always_executed && !reads_written_variable(assigned->value) && fact_fits(value, type)
        && (is_float ? type == SM_F64 || value.f32 : value.whole && !value.minus_zero);
}

typedef struct OtherStore { const Stmt *assigned; bool found; } OtherStore;

// Searches for another expression that the machine stores in the same variable; initial values of .entry do not count.
static void find_other_store(const StmtLocation *at, void *context)
{
    OtherStore *o = context;

    o->found |= at->stmt->kind == ST_ASSIGN && at->stmt->var == o->assigned->var && at->block != BLOCK_ENTRY &&
                at->stmt->span.at != o->assigned->span.at;
}

// Whether the variable can be a definition of what is assigned: it is a local, and no other statement stores something else in it.
static bool can_be_definition(const StatUse *u, const Stmt *assigned)
{
    OtherStore o = {assigned, assigned->var->kind != VAR_LOCAL};

    each_stmt_location(u->a->diags->arena, u->a->p, find_other_store, &o);
    return !o.found;
}

static bool reads_input(const Expr *e)
{
    bool found = e->kind == EX_VAR && e->var->kind == VAR_ELEMENT && !e->var->written;

    for (uint32_t i = 0; i < e->n && !found; i++)
        found = reads_input(e->arg[i]);
    return found;
}

static bool is_read_without_window(const Expr *e, const Var *v)
{
    bool read = e->kind == EX_VAR && e->var == v;

    for (uint32_t i = 0; e->kind != EX_ROLL && i < e->n; i++)
        read |= is_read_without_window(e->arg[i], v);
    return read;
}

static void report_late_sample(const StatUse *u, const Var *v, const Stmt *assigned)
{
    Diags *diags = u->a->diags;
    Diag *d = diag_report(diags, DIAG_late_sample, u->roll->span, source_text(diags->arena, u->roll->span), v->name->text);
    const char *value = source_text(diags->arena, assigned->value->span);

    diag_note(diags, d, assigned->span, DIAG_note_assigned_after_sample, v->name->text);
    if (!can_sample_assigned_value(u, assigned))
        return;
    if (can_be_definition(u, assigned))
        diag_note(diags, d, (Span){0}, DIAG_note_sample_definition, v->name->text, v->name->text, value);
    else
        diag_note(diags, d, (Span){0}, DIAG_note_sample_itself, v->name->text, value);
}

// Reports variables in e, a part of the sample of u->roll, that the step assigns before the use.  Roll calls inside the sample are visited
// separately.
static void check_sample(const StatUse *u, const Expr *e)
{
    const Stmt *assigned = e->kind == EX_VAR ? find_assignment(u->known, e->var) : NULL;

    if (assigned && !(e->var->kind == VAR_ELEMENT && reads_input(u->roll->arg[0])) && !is_read_without_window(u->value, e->var))
        report_late_sample(u, e->var, assigned);
    for (uint32_t i = 0; e->kind != EX_ROLL && i < e->n; i++)
        check_sample(u, e->arg[i]);
}

// Checks a window whether it samples, before the step, a variable that the step assigns first.
static void check_roll(Expr *e, void *context)
{
    StatUse *u = context;

    u->roll = e;
    if (e->kind == EX_ROLL)
        check_sample(u, e->arg[0]);
}

static void check_stmt(void *context, const Stmt *stmt, const KnownGuard *known)
{
    StatUse *u = context;

    u->known = known;
    u->value = stmt->value;
    if (stmt->kind != ST_TRANSITION)
        expr_walk(stmt->value, check_roll, u);
}

void analyse_late_sample(Analysis *a)
{
    StatUse u = {.a = a};

    for (size_t s = 0; a->p->window.n && s < a->p->state.n; s++) {
        u.block = &a->p->state.at[s]->block[BLOCK_STEP];
        guards_known_each_stmt(a, u.block, check_stmt, &u);
    }
}
