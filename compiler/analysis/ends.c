// SPDX-License-Identifier: Apache-2.0
// States that are never left, and states that switch something on and are not left by time alone.
#include "compiler/analysis/outputs.h"
#include "compiler/analysis/whatif.h"

// By state: whether some transition to another state can be made.
static bool *find_left(const Analysis *a)
{
    bool *left = ARENA_ARRAY(a->arena, bool, a->p->state.n);

    for (size_t i = 0; i < a->transition.n; i++) {
        const Transition *t = &a->transition.at[i];
        if (t->to != t->from && a->stmt[t->stmt->number].reached)
            left[t->from->number - 1] = true;
    }
    return left;
}

// ---- no way out ----

static void report_no_way_out(Analysis *a, const State *s)
{
    Diag *d = diag_report(a->diags, DIAG_no_way_out, s->span, s->name->text);

    diag_label(a->diags, d, DIAG_label_mark_safe, s->name->text);
}

void analyse_ends(Analysis *a)
{
    const bool *left;

    if (a->p->state.n == 1)
        return;                               // a machine that does one thing for ever
    left = find_left(a);
    for (size_t s = 0; s < a->p->state.n; s++)
        if (!left[s] && !a->p->state.at[s]->is_safe && facts_reach(a->facts, s, BLOCK_ENTRY))
            report_no_way_out(a, a->p->state.at[s]);
}

// ---- time alone ----

// A time so late that no limit lies beyond it, and what sensors and settings may say meanwhile.
static const double late = 1e15, last = 1.8e19, sane = 1e12, early = 1e9;

static Fact between(double lo, double hi)
{
    Fact f = fact_of_type(SM_F64);

    f.lo = lo;
    f.hi = hi;
    return f;
}

// How the locals are written: as a moment, of G and numbers alone; or anything else.
typedef struct Locals {
    const Analysis *a;
    bool *written, *other;                    // by Program.var
    const Var **var;                          // by IR variable
} Locals;

typedef struct Reads { const Var *g; bool g_read, other; } Reads;

static void look_at_read(Expr *e, void *context)
{
    Reads *r = context;

    if (e->kind == EX_ROLL)
        r->other = true;
    if (e->kind != EX_VAR || e->var->is_constant)
        return;
    if (e->var == r->g)
        r->g_read = true;
    else
        r->other = true;
}

static void look_at_local(const Stmt *s, void *context)
{
    Locals *l = context;
    Reads r = {l->a->p->g, false, false};

    if (s->kind != ST_ASSIGN || s->var->kind != VAR_LOCAL)
        return;
    expr_walk(s->value, look_at_read, &r);
    l->written[s->var->index] = true;
    l->other[s->var->index] |= r.other;
}

// x = x + 1 and the like, at the end of which x is at its end: 1 upwards, -1 downwards, else 0.
static int counts(const Stmt *s)
{
    const Expr *e = s->value;
    double by;

    if (s->kind != ST_ASSIGN || e->kind != EX_BINARY || (e->op != SM_OP_ADD && e->op != SM_OP_SUB))
        return 0;
    if (e->arg[0]->kind != EX_VAR || e->arg[0]->var != s->var || !expr_is_constant(e->arg[1]))
        return 0;
    by = fact_of_number(const_eval(e->arg[1])).lo;
    return (by > 0) - (by < 0) == 0 ? 0 : ((by > 0) == (e->op == SM_OP_ADD) ? 1 : -1);
}

static Fact counted(const Var *v, int direction)
{
    const Fact t = fact_of_type(v->type);

    if (direction > 0)
        return t.hi < late ? between(t.hi, t.hi) : between(late, late);
    return t.lo > -late ? between(t.lo, t.lo) : between(-late, -late);
}

static const Env *suppose_sane(const Analysis *a, const Env *env, const Locals *l, const IrFn *f)
{
    for (size_t i = 0; i < f->ins.n; i++) {
        const uint32_t number = f->ins.at[i].var;
        const Var *v = f->ins.at[i].op == IR_load ? l->var[number] : NULL;
        if (!v || v == a->p->g || v == a->p->t)
            continue;
        if (v->kind == VAR_LOCAL && l->written[v->index] && !l->other[v->index])
            env = suppose(a, env, v, between(0, early));
        else
            env = suppose(a, env, v, fact_meet(env_get(&a->facts->shape, env, number), between(-sane, sane)));
    }
    return env;
}

// The state has lasted for ever.
static const Env *suppose_late(const Analysis *a, const State *s, const Locals *l, const IrFn *f)
{
    const Env *env = suppose_sane(a, facts_begin(a->facts, s->number - 1, BLOCK_STEP), l, f);

    env = suppose(a, env, a->p->t, between(late, last));
    env = suppose(a, env, a->p->g, between(late, last));
    for (size_t i = 0; i < s->block[BLOCK_STEP].n; i++) {
        const Stmt *stmt = s->block[BLOCK_STEP].at[i];
        if (counts(stmt) != 0)
            env = suppose(a, env, stmt->var, counted(stmt->var, counts(stmt)));
    }
    return env;
}

typedef struct Stay { const Analysis *a; bool stays; const Env *env; } Stay;

static void note_stay(void *context, const IrJump *end, const Env *env)
{
    Stay *s = context;

    if (end->kind != IR_RET)
        return;
    s->env = s->stays ? env_join(&s->a->facts->shape, s->env, env, NULL) : env;
    s->stays = true;
}

// What is left of the state when it has lasted long enough, whatever the sensors say.
static Stay stay(const Analysis *a, const State *s, const Locals *l)
{
    const IrFn *f = a->m->state.at[s->number - 1].block[BLOCK_STEP];
    Stay out = {a, false, NULL};
    const FactEnds ends = {note_stay, &out};

    if (!facts_reach(a->facts, s->number - 1, BLOCK_STEP))
        return out;                           // .entry leaves
    if (f)
        facts_flow(a->facts, f, suppose_late(a, s, l, f), &ends);
    else
        out.stays = true;
    return out;
}

// What these statements switch on and is on for as long as the state lasts, or NULL.
static const Stmt *left_running(const Stay *stay, const Stmts *stmts, const bool *output)
{
    const Analysis *a = stay->a;
    const Stmt *found = NULL;

    for (size_t i = 0; i < stmts->n && !found; i++) {
        const Stmt *s = stmts->at[i];
        if (s->kind == ST_ASSIGN && output[s->var->index] && a->stmt[s->number].reached && may_be_on(a->stmt[s->number].value) &&
            may_be_on(env_get(&a->facts->shape, stay->env, a->m->var_of[s->var->index])))
            return s;
        found = left_running(stay, &s->then, output);
        if (!found)
            found = left_running(stay, &s->otherwise, output);
    }
    return found;
}

static void report_no_timeout(Analysis *a, const State *s, const Stmt *on)
{
    Diag *d = diag_report(a->diags, DIAG_no_timeout, s->span, s->name->text, on->var->name->text);

    diag_note(a->diags, d, on->span, DIAG_note_switched_on, on->var->name->text);
}

void analyse_timeouts(Analysis *a)
{
    Locals l = {a, ARENA_ARRAY(a->arena, bool, a->p->var.n), ARENA_ARRAY(a->arena, bool, a->p->var.n), whatif_vars(a)};
    const bool *left = find_left(a), *output = outputs_find(a);

    each_stmt(a->p, look_at_local, &l);
    for (size_t i = 0; i < a->p->state.n; i++) {
        const State *s = a->p->state.at[i];
        const Stmt *on;
        Stay late_stay;
        if (!left[i] || s->is_safe || s->is_abort || !facts_reach(a->facts, i, BLOCK_ENTRY))
            continue;
        late_stay = stay(a, s, &l);
        if (!late_stay.stays)
            continue;
        on = left_running(&late_stay, &s->block[BLOCK_ENTRY], output);
        if (!on)
            on = left_running(&late_stay, &s->block[BLOCK_STEP], output);
        if (on)
            report_no_timeout(a, s, on);
    }
}
