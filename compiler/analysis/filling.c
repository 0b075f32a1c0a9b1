// SPDX-License-Identifier: Apache-2.0
// Guards that can hold while the window of a statistic they use cannot be full yet: in the machine's first step, and in states that
// are reached for sure after fewer steps than the window holds, because every state before leaves in its first step, or at a T that
// is a known number of steps.
//
// What is asked is whether the transition can be made when the state has just begun (G is supposed to be 0, locals are as in its
// first step): a limit of G, a count of steps, or a state before that waits, gives the window its time.  So does a limit of T, but not
// one below the window's size: time advances with every step, so by T = 20 there have been at most 20 more; and where it is known
// to advance by 10, two.
#include "compiler/analysis/analysis.h"
#include "compiler/analysis/whatif.h"

#include "stdlib/math.h"

typedef struct Arrival {          // of a state that is reached for sure
    const Env *env;
    uint32_t steps;               // how many have run when its first one ends; 0: not found
} Arrival;

typedef struct Filling {
    Analysis *a;
    Arrival *arrival;             // by state, from 0
    VEC(uint32_t) queue;
    const Expr **fed;             // by Var.index: the statistic that all assignments to it are made of
    double *fires;                // by Stmt.number: from which T on this transition can be made, and 1; 0: it cannot
    size_t *first;                // by state: where its transitions begin in the list of all
} Filling;

// ---- a first step ----

typedef struct End { const Env *env; bool found; } End;

typedef struct Step {
    Filling *k;
    bool note;                    // which transitions are made
    End stays;
    VEC(uint32_t) targets;        // states, from 0
    End leaves;
} Step;

static void join(const Step *s, End *end, const Env *env)
{
    end->env = end->found ? env_join(&s->k->a->facts->shape, end->env, env, NULL) : env;
    end->found = true;
}

static void note_end(void *context, const IrJump *end, const Env *env)
{
    Step *s = context;

    if (end->kind == IR_RET) {
        join(s, &s->stays, env);
        return;
    }
    join(s, &s->leaves, env);
    vec_push(s->k->a->arena, &s->targets, end->state - 1);
    if (s->note)
        s->k->fires[end->stmt] = 1 + env_get(&s->k->a->facts->shape, env, s->k->a->m->t).lo;
}

static void run_block(Step *s, uint32_t state, BlockKind block)
{
    const IrFn *f = s->k->a->m->state.at[state].block[block];
    const FactEnds ends = {note_end, s};
    const Env *env = s->stays.env;

    if (!f || !s->stays.found)
        return;
    s->stays.found = false;
    facts_flow(s->k->a->facts, f, env, &ends);
}

// .entry and .step of a state's first step; where ways are noted, .step also of those that follow soon.
static Step first_step(Filling *k, uint32_t state, const Env *env, bool note)
{
    Step s = {.k = k, .note = note};

    s.stays.env = suppose(k->a, env, k->a->p->t, fact_of_number(sm_from_i32(0)));
    s.stays.found = true;
    run_block(&s, state, BLOCK_ENTRY);
    if (note && s.stays.found)
        s.stays.env = suppose(k->a, s.stays.env, k->a->p->t, fact_of_range(sm_from_i32(0), sm_from_i32(SM_WINDOW_MAX)));
    run_block(&s, state, BLOCK_STEP);
    return s;
}

// What .exit leaves of the locals.
static const Env *after_exit(Filling *k, uint32_t state, const Env *env)
{
    Step s = {.k = k, .stays = {env, true}};

    run_block(&s, state, BLOCK_EXIT);
    return s.stays.found ? env_begin(&k->a->facts->shape, s.stays.env, NULL) : NULL;
}

// ---- guards ----

static bool takes_the_largest(const Expr *e)
{
    return e->kind == EX_ROLL && (e->stat == SM_STAT_MAX || e->stat == SM_STAT_RANGE);
}

static bool takes_the_smallest(const Expr *e) { return e->kind == EX_ROLL && e->stat == SM_STAT_MIN; }

// More samples can only make the largest larger: what it exceeds already it will exceed then.
static bool is_foregone(const Expr *e, bool holds)
{
    const bool less = e->op == SM_OP_LT || e->op == SM_OP_LE, more = e->op == SM_OP_GT || e->op == SM_OP_GE;
    const Expr *small, *large;

    if (e->kind != EX_BINARY || !(less || more))
        return false;
    small = less == holds ? e->arg[0] : e->arg[1];
    large = less == holds ? e->arg[1] : e->arg[0];
    return (takes_the_largest(large) && expr_is_constant(small)) || (takes_the_smallest(small) && expr_is_constant(large));
}

// A statistic that decides e and needs more samples than there are; NULL if there is none.  *from: where e takes it from.
static const Expr *unfilled(const Filling *k, const Expr *e, bool holds, uint32_t steps, const Expr **from)
{
    const bool logic = e->kind == EX_BINARY && (e->op == SM_OP_AND || e->op == SM_OP_OR);
    const bool negates = e->kind == EX_UNARY && e->op == SM_OP_NOT;
    const Expr *roll = e->kind == EX_ROLL ? e : e->kind == EX_VAR ? k->fed[e->var->index] : NULL, *found = NULL;

    if (!logic && !negates && is_foregone(e, holds))
        return NULL;
    if (roll && k->a->p->window.at[roll->window].size > steps) {
        *from = e;
        return roll;
    }
    for (uint32_t i = 0; i < e->n && !found; i++)
        found = unfilled(k, e->arg[i], negates ? !holds : holds, steps, from);
    return found;
}

static void report(const Filling *k, const Condition *when, const Expr *roll, const Expr *from, uint32_t steps)
{
    Arena *arena = k->a->arena;
    Diag *d = diag_report(k->a->diags, DIAG_window_not_full, when->stmt->value->span, source_text(arena, from->span),
                          format_in(arena, "%lu", (unsigned long)steps),
                          format_in(arena, "%lu", (unsigned long)k->a->p->window.at[roll->window].size));

    if (from != roll)
        diag_note(k->a->diags, d, roll->span, DIAG_note_statistic_here, from->var->name->text);
}

// The steps behind the first one when T has come to t: where nobody knows how far T advances in each, there may be as many.
static uint32_t steps_until(const Filling *k, double t)
{
    const double d = k->a->step > 0 ? (double)k->a->step : 1;

    return (uint32_t)sm_ceil(t / d);
}

static void look_at_transitions(const Filling *k, uint32_t state, uint32_t before)
{
    for (size_t t = k->first[state]; t < k->first[state + 1]; t++) {
        const Transition *way = &k->a->transition.at[t];
        const double fires = k->fires[way->stmt->number];
        const uint32_t steps = before + steps_until(k, fires > 0 ? fires - 1 : 0);
        if (fires <= 0)
            continue;
        for (const Condition *when = way->when; when; when = when->outer) {
            const Expr *from = NULL, *roll = unfilled(k, when->stmt->value, when->holds, steps, &from);
            if (roll)
                report(k, when, roll, from, steps);
        }
    }
}

// ---- states that are reached for sure ----

static void arrive(Filling *k, uint32_t state, const Env *env, uint32_t steps)
{
    Arrival *at = &k->arrival[state];

    if (at->steps != 0)
        return;
    *at = (Arrival){env, steps};
    vec_push(k->a->arena, &k->queue, state);
}

// Where the step leads for sure, `steps` having run before.
static void follow(Filling *k, uint32_t state, const Step *s, uint32_t steps)
{
    const Env *env;

    if (s->stays.found || !s->leaves.found || steps >= SM_WINDOW_MAX)
        return;
    env = after_exit(k, state, s->leaves.env);
    for (size_t i = 0; i < s->targets.n; i++)
        arrive(k, s->targets.at[i], env, steps + 1);
}

// How many steps behind the first one the state can be left at the earliest; 0: in the first, or it is not known.
static uint32_t shortest_wait(const Filling *k, uint32_t state)
{
    double least = 0;

    for (size_t t = k->first[state]; t < k->first[state + 1]; t++) {
        const double fires = k->fires[k->a->transition.at[t].stmt->number];
        if (fires > 0 && (least <= 0 || fires < least))
            least = fires;
    }
    return k->a->step > 0 && least > 1 ? steps_until(k, least - 1) : 0;
}

// The step of .step behind so many others, whatever they did.
static Step later_step(Filling *k, uint32_t state, uint32_t steps)
{
    const Fact t = fact_of_number(sm_from_u64(steps * k->a->step));
    Step s = {.k = k, .stays = {facts_begin(k->a->facts, state, BLOCK_STEP), true}};

    s.stays.env = suppose(k->a, s.stays.env, k->a->p->t, t);
    run_block(&s, state, BLOCK_STEP);
    return s;
}

static void look_at_state(Filling *k, uint32_t state)
{
    const Arrival at = k->arrival[state];
    const Env *early = suppose(k->a, at.env, k->a->p->g, fact_of_number(sm_from_i32(0)));
    uint32_t wait;
    Step s;

    first_step(k, state, early, true);
    look_at_transitions(k, state, at.steps);
    wait = shortest_wait(k, state);
    s = wait > 0 ? later_step(k, state, wait) : first_step(k, state, at.env, false);
    follow(k, state, &s, at.steps + wait);
}

// ---- variables that statistics feed ----

static const Expr *statistic_in(const Expr *e)
{
    const Expr *found = e->kind == EX_ROLL ? e : NULL;

    for (uint32_t i = 0; i < e->n && !found; i++)
        found = statistic_in(e->arg[i]);
    return found;
}

typedef struct Feeds { const Expr **fed; bool *otherwise; } Feeds;

static void note_feed(const Stmt *stmt, void *context)
{
    Feeds *f = context;
    const Expr *roll;

    if (stmt->kind != ST_ASSIGN)
        return;
    roll = statistic_in(stmt->value);
    if (!f->fed[stmt->var->index])                         // of several the first: early states matter here
        f->fed[stmt->var->index] = roll;
    f->otherwise[stmt->var->index] |= !roll;
}

static const Expr **find_feeds(const Analysis *a)
{
    Feeds f = {ARENA_ARRAY(a->arena, const Expr *, a->p->var.n), ARENA_ARRAY(a->arena, bool, a->p->var.n)};

    each_stmt(a->p, note_feed, &f);
    for (size_t v = 0; v < a->p->var.n; v++)
        if (f.otherwise[v])
            f.fed[v] = NULL;
    return f.fed;
}

// ---- the whole ----

static const Env *at_the_start(const Analysis *a)
{
    const Env *env = NULL;

    for (uint32_t v = 0; v < a->m->var.n; v++) {
        const IrVar *var = &a->m->var.at[v];
        if (env_is_private(var))
            env = env_set(&a->facts->shape, env, v, fact_convert(fact_of_cell(var->type, var->init), var->type));
    }
    return env;
}

void analyse_filling(Analysis *a)
{
    Filling k = {.a = a};

    if (a->p->window.n == 0)
        return;
    k.arrival = arena_array(a->arena, a->p->state.n, sizeof *k.arrival);
    k.fed = find_feeds(a);
    k.fires = ARENA_ARRAY(a->arena, double, a->p->stmts + 1u);
    k.first = transitions_by_state(a->arena, a->p, &a->transition);
    arrive(&k, 0, at_the_start(a), 1);
    for (size_t i = 0; i < k.queue.n; i++)
        look_at_state(&k, k.queue.at[i]);
}
