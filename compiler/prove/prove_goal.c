// SPDX-License-Identifier: Apache-2.0
#include "compiler/prove/prove_goal.h"

#include <string.h>

#include "compiler/ir/comparison.h"
#include "stdlib/convert.h"

// What a goal remembers from step to step: the first MEMORY_SIZE bytes of a situation (SearchWatch).  The monitor's memory follows.
typedef struct GoalMemory {
    bool seen;                // condition b of the requirement was true in a step
    bool outside;             // an input was outside its @range, although GoalSearch.assume_ranges is set
    uint64_t set;             // one bit for each of the first 64 inputs with a range: it has been other than 0
    bool open;                // AFTER: no step since the last one with b has had c; LEADS_TO: a has occurred, and b not yet
} GoalMemory;

typedef struct GoalWatch {
    const GoalSearch *g;
    const Requirement *what;
    Monitor *monitor;
    bool strict;              // inputs that were never set must be in their ranges, too
    bool premise_seen;
    bool *tried;              // by state from 0: a step has run in it
} GoalWatch;

enum { MEMORY_SIZE = (sizeof(GoalMemory) + 7) / 8 * 8 };

// ---- distances ----

// How far a condition is from being true, and from being false: exactly one of them is 0.
typedef struct Distance { double to_true, to_false; } Distance;

static double absolute(double x) { return x < 0 ? -x : x; }
static double smaller_of(double a, double b) { return a < b ? a : b; }

static Distance distance_of_value(bool value) { return (Distance){value ? 0 : 1, value ? 1 : 0}; }

// Returns how far `a op b` is from being true and from being false.
static Distance distance_of_comparison(SmOperator op, double a, double b)
{
    const double apart = absolute(a - b) < 1e300 ? absolute(a - b) : 1e300;

    switch (op) {
    case SM_OP_EQ: return a == b ? distance_of_value(true) : (Distance){apart, 0};
    case SM_OP_NE: return a != b ? (Distance){0, apart} : distance_of_value(false);
    case SM_OP_LT: return a < b ? (Distance){0, apart + 1} : (Distance){apart + 1, 0};
    case SM_OP_LE: return a <= b ? (Distance){0, apart + 1} : (Distance){apart + 1, 0};
    case SM_OP_GT: return a > b ? (Distance){0, apart + 1} : (Distance){apart + 1, 0};
    case SM_OP_GE: return a >= b ? (Distance){0, apart + 1} : (Distance){apart + 1, 0};
    default: return distance_of_value(false);
    }
}

static bool is_comparison(SmOperator op)
{
    return op == SM_OP_EQ || op == SM_OP_NE || op == SM_OP_LT || op == SM_OP_LE || op == SM_OP_GT || op == SM_OP_GE;
}

static Distance distance_of_and(Distance a, Distance b) { return (Distance){a.to_true + b.to_true, smaller_of(a.to_false, b.to_false)}; }
static Distance distance_of_or(Distance a, Distance b) { return (Distance){smaller_of(a.to_true, b.to_true), a.to_false + b.to_false}; }

// Evaluates each part of a condition once: windows can be long.
static Distance distance_of(const Expr *e, const uint64_t *cell, const RefWindows *w)
{
    Distance all = {0, 0};

    if (e->kind == EX_UNARY && e->op == SM_OP_NOT) {
        const Distance d = distance_of(e->arg[0], cell, w);
        return (Distance){d.to_false, d.to_true};
    }
    if (e->kind == EX_BINARY && (e->op == SM_OP_AND || e->op == SM_OP_OR)) {
        const Distance a = distance_of(e->arg[0], cell, w), b = distance_of(e->arg[1], cell, w);
        return e->op == SM_OP_AND ? distance_of_and(a, b) : distance_of_or(a, b);
    }
    if (e->kind == EX_BINARY && is_comparison(e->op))
        return distance_of_comparison(e->op, ref_eval(e->arg[0], cell, w), ref_eval(e->arg[1], cell, w));
    if (e->kind != EX_CHAIN)
        return distance_of_value(ref_true(ref_eval(e, cell, w)));
    for (uint32_t k = 0; k + 1 < e->n; k++) {
        const Distance d = distance_of_comparison(expr_ops(e)[k], ref_eval(e->arg[k], cell, w), ref_eval(e->arg[k + 1], cell, w));
        all = k == 0 ? d : distance_of_and(all, d);
    }
    return all;
}

// Maps a distance to one below 1, so that a condition that comes first counts more.
static double below_one(double d) { return d / (d + 1); }

// ---- ranges ----

static bool is_ranged_input(const Program *p, const Var *v) { return v->kind == VAR_ELEMENT && v != p->g && v != p->s && !v->written && v->range; }

// Whether all inputs are in their ranges.  An input that a scenario has not set yet is 0: hold_in_ranges sets it later.
static bool is_in_ranges(const GoalWatch *w, GoalMemory *m, const uint64_t *cell)
{
    const Program *p = w->g->all->program;
    uint64_t bit = 1;

    for (uint32_t i = 0; i < p->var.n; i++) {
        const Var *v = p->var.at[i];
        double x;
        if (!is_ranged_input(p, v))
            continue;
        x = ref_read(v->type, cell[i]);
        if (x != 0)
            m->set |= bit;
        if ((x < v->range->lo || x > v->range->hi) && (x != 0 || (m->set & bit) || w->strict))
            return false;
        bit *= 2;
    }
    return true;
}

// Adds a change in the first step for each input that has none there and whose range does not contain 0.
static void set_inputs_in_ranges(Arena *arena, const Program *p, Scenario *s)
{
    ScenarioChange *change = ARENA_ARRAY(arena, ScenarioChange, s->changes + p->var.n);
    size_t n = 0;

    for (uint32_t i = 0; i < p->var.n; i++) {
        const Var *v = p->var.at[i];
        bool is_set = !is_ranged_input(p, v) || (v->range->lo <= 0 && v->range->hi >= 0);
        for (size_t k = 0; !is_set && k < s->changes && s->change[k].step == 1; k++)
            is_set = s->change[k].var == i;
        if (!is_set)
            change[n++] = (ScenarioChange){.step = 1, .var = i, .kind = SCENARIO_HOLD, .a = v->range->lo > 0 ? v->range->lo : v->range->hi};
    }
    for (size_t k = 0; k < s->changes; k++)
        change[n++] = s->change[k];
    s->change = change;
    s->changes = n;
}

// ---- the goal ----

// The distances of the conditions of a requirement in a step.  A condition that the requirement lacks counts as false.
typedef struct Conditions { Distance a, b, c; } Conditions;

// Returns how far the three conditions of the requirement are from being true and false in this step.
static Conditions evaluate(const GoalWatch *w, const uint64_t *cell)
{
    const Requirement *r = w->what;
    const RefWindows *windows = &w->monitor->windows;
    const Distance none = distance_of_value(false);

    return (Conditions){r->a ? distance_of(r->a, cell, windows) : none, r->b ? distance_of(r->b, cell, windows) : none,
                        r->c ? distance_of(r->c, cell, windows) : none};
}

static bool is_true(Distance d) { return d.to_true == 0; }

// Returns the share of the time of an undecided `leads to` that has not passed yet.
static double share_of_time_left(const GoalWatch *w, const void *situation, const uint64_t *cell)
{
    const double within = (double)w->what->within + (double)w->g->delta_t;
    uint64_t since;

    if (!monitor_is_open(w->monitor, situation, w->g->requirement, &since))
        return 1;
    return 1 - (double)(cell[w->g->all->program->g->index] - since) / within;
}

// Returns how far the step is from the goal, if it does not reach it.  `left`: the share of the time of a `leads to` that is left.
static double distance_to_goal(const GoalWatch *w, const GoalMemory *before, const GoalMemory *after, const Conditions *x, double left)
{
    const Requirement *r = w->what;
    const double a = r->a ? below_one(x->a.to_true) : 0;

    switch (r->kind) {
    case REQUIREMENT_NEVER: return a;
    case REQUIREMENT_ALWAYS: return w->g->kind == GOAL_PREMISE ? a : a + below_one(x->b.to_false);
    case REQUIREMENT_BEFORE: return before->seen && w->g->kind == GOAL_VIOLATION ? SEARCH_UNKNOWN : a;
    case REQUIREMENT_AFTER:
        if (!after->seen)
            return 2 + below_one(x->b.to_true);
        return (after->open ? 0 : 1) + a;
    case REQUIREMENT_LEADS_TO:
        if (w->g->kind == GOAL_PREMISE || !after->open)
            return 1 + a;
        return (below_one(x->b.to_false + 1) + left) / 2;
    }
    return 1;
}

// Remembers what the requirement needs of this step later: whether its second condition was true, and whether a deadline is running.
static void note_step(const GoalWatch *w, GoalMemory *m, const Conditions *x)
{
    const bool b = is_true(x->b);

    m->seen = m->seen || b;
    if (w->what->kind == REQUIREMENT_AFTER)
        m->open = b || (m->open && !is_true(x->c));
    else if (w->what->kind == REQUIREMENT_LEADS_TO)
        m->open = (m->open || is_true(x->a)) && !b;
}

// Whether the step could have violated the requirement.
static bool is_premise(const GoalWatch *w, const GoalMemory *before, const Conditions *x)
{
    const Requirement *r = w->what;
    const bool a = !r->a || r->kind == REQUIREMENT_NEVER || is_true(x->a);

    return a && (r->kind != REQUIREMENT_AFTER || before->seen);
}

static void start_goal(void *self, void *situation)
{
    const GoalWatch *w = self;
    const GoalMemory none = {.seen = false};

    *(GoalMemory *)situation = none;
    monitor_start(w->monitor, (char *)situation + MEMORY_SIZE);
}

// Called after each step of the search: sets *distance to how far the run is from the goal.
static void step_goal(void *self, void *situation, const uint64_t *cell, double *distance)
{
    GoalWatch *w = self;
    GoalMemory *m = situation;
    const GoalMemory before = *m;
    Conditions x;
    bool premise, reached;
    double left;              // the share of the waiting time that is left

    monitor_step(w->monitor, (char *)situation + MEMORY_SIZE, cell);
    w->tried[cell[w->g->all->program->s->index] - 1] = true;
    x = evaluate(w, cell);
    note_step(w, m, &x);
    premise = is_premise(w, &before, &x);
    w->premise_seen = w->premise_seen || (premise && !m->outside);
    m->outside = m->outside || (w->g->assume_ranges && !is_in_ranges(w, m, cell));
    reached = m->outside ? false : w->g->kind == GOAL_PREMISE ? premise : w->monitor->result[w->g->requirement] == MONITOR_VIOLATED;
    left = w->what->kind == REQUIREMENT_LEADS_TO ? share_of_time_left(w, (char *)situation + MEMORY_SIZE, cell) : 1;
    *distance = m->outside ? SEARCH_UNKNOWN : distance_to_goal(w, &before, m, &x, left);
    if (reached)
        *distance = 0;
    else if (!(*distance > 0))
        *distance = 1;
}

static GoalWatch *new_watch(Arena *arena, const GoalSearch *g)
{
    GoalWatch *w = ARENA_NEW(arena, GoalWatch);

    w->g = g;
    w->what = &g->all->at.at[g->requirement];
    w->monitor = monitor_new(arena, g->all, g->delta_t);
    monitor_judge_only(w->monitor, g->requirement);
    w->tried = ARENA_ARRAY(arena, bool, g->all->program->state.n);
    return w;
}

// ---- confirming ----

typedef struct GoalReplay { GoalWatch *w; void *situation; uint64_t reached; } GoalReplay;

// Called after each step of a replay: stores the first step that reaches the goal.
static void judge_replayed(void *context, uint64_t step, const EngineStep *result)
{
    GoalReplay *r = context;
    double distance;

    step_goal(r->w, r->situation, result->cell, &distance);
    if (distance == 0 && r->reached == 0)
        r->reached = step;
}

uint64_t goal_confirm(Arena *arena, const GoalSearch *g, const Scenario *s)
{
    GoalReplay r = {.w = new_watch(arena, g)};
    Engine *e = engine_ref_open(arena, g->all->program);
    EngineStatus status;

    r.w->strict = true;
    r.situation = arena_alloc(arena, MEMORY_SIZE + r.w->monitor->size);
    start_goal(r.w, r.situation);
    status = scenario_run(arena, g->all->program, s, e, judge_replayed, &r);
    e->close(e);
    return status == ENGINE_OK ? r.reached : 0;
}

// ---- searching ----

const bool *goal_inputs(Arena *arena, const Program *p)
{
    bool *writable = ARENA_ARRAY(arena, bool, p->var.n);

    for (uint32_t i = 0; i < p->var.n; i++) {
        const Var *v = p->var.at[i];
        writable[i] = v->kind == VAR_ELEMENT && v != p->g && v != p->s && !v->written;
    }
    return writable;
}

// ---- fewer changes ----

enum { SIMPLIFY_CHANGES = 12, SIMPLIFY_STEPS = 20000 };       // larger scenarios are left as they are

// Whether a scenario still reaches the goal.  If so, it ends there.
static bool reaches_goal(Arena *arena, const GoalSearch *g, Scenario *s)
{
    const uint64_t step = goal_confirm(arena, g, s);

    if (step)
        s->steps = step;
    return step != 0;
}

// Replaces *s by one without change `drop`, and with the value of change `from` in change `to`, if that reaches the goal.
static bool try_without(Arena *arena, const GoalSearch *g, Scenario *s, size_t drop, size_t to, size_t from)
{
    ScenarioChange *change = ARENA_ARRAY(arena, ScenarioChange, s->changes);
    Scenario less = *s;
    bool reached;

    less.change = change;
    less.changes = 0;
    for (size_t i = 0; i < s->changes; i++) {
        ScenarioChange c = s->change[i];
        if (i == to && from != to && g->all->program->var.at[c.var]->parameter)
            return false;                             // the other value can be outside of its range
        if (i == to && from != to)
            c.kind = SCENARIO_HOLD, c.a = s->change[from].a;
        if (i != drop)
            change[less.changes++] = c;
    }
    if (g->assume_ranges)
        set_inputs_in_ranges(arena, g->all->program, &less);
    reached = less.changes < s->changes && reaches_goal(arena, g, &less);
    if (reached)
        *s = less;
    return reached;
}

// Removes changes that the goal does not need.  Also tries to give one change the value of another, if a third change is not needed then.
static void simplify_scenario(Arena *arena, const GoalSearch *g, Scenario *s)
{
    bool shorter = s->changes <= SIMPLIFY_CHANGES && s->steps <= SIMPLIFY_STEPS;

    while (shorter) {
        shorter = false;
        for (size_t i = 0; !shorter && i < s->changes; i++)
            shorter = try_without(arena, g, s, i, i, i);
        for (size_t i = 0; !shorter && i < s->changes; i++)
            for (size_t to = 0; !shorter && to < s->changes; to++)
                for (size_t from = 0; !shorter && from < s->changes; from++)
                    shorter = to != i && from != to && try_without(arena, g, s, i, to, from);
    }
}

typedef struct GoalStop { const GoalSearch *g; } GoalStop;

// Whether the caller wants the search to go on.
static bool may_go_on(void *context, const SearchProgress *progress)
{
    const GoalStop *s = context;

    (void)progress;
    return !s->g->go_on || s->g->go_on(s->g->context);
}

static const Scenario *copy_scenario(Arena *arena, const Scenario *s)
{
    Scenario *out = arena_copy(arena, s, sizeof *s);

    out->change = arena_copy(arena, s->change, s->changes * sizeof *s->change);
    return out;
}

// Returns a scenario that first sets the parameters that have other values in g->initial than the machine was compiled with.
static const Scenario *set_parameters(Arena *arena, const GoalSearch *g, const Scenario *s)
{
    const Program *p = g->all->program;
    ScenarioChange *change = arena_array(arena, p->var.n + s->changes, sizeof *change);
    Scenario *out = arena_copy(arena, s, sizeof *s);
    size_t n = 0;

    for (uint32_t v = 0; v < p->var.n && g->initial; v++)
        if (p->var.at[v]->parameter && g->initial[v] != p->var.at[v]->init)
            change[n++] = (ScenarioChange){.step = 1, .var = v, .kind = SCENARIO_HOLD, .a = sm_cell_to_f64(p->var.at[v]->type, g->initial[v])};
    memcpy(change + n, s->change, s->changes * sizeof *change);
    out->change = change;
    out->changes = n + s->changes;
    return out;
}

Scenario *goal_end_scenario(Arena *arena, const GoalSearch *g, const Scenario *found)
{
    Scenario *s = ARENA_NEW(arena, Scenario);

    *s = *found;
    if (g->assume_ranges)
        set_inputs_in_ranges(arena, g->all->program, s);
    s->steps = goal_confirm(arena, g, s);
    while (s->changes && s->change[s->changes - 1].step > s->steps)
        s->changes--;
    return s->steps == 0 ? NULL : s;
}

// The reference interpreter computes a statistic from all samples of the window, so long windows make a step expensive.
uint64_t goal_cost_of_step(const Monitor *m)
{
    enum { SAMPLES = 64 };                // reading this many samples takes as long as the rest of a step
    uint64_t samples = 0;

    for (size_t n = 0; n < m->windows.n; n++)
        samples += m->windows.at[n].is_unused ? 0 : ref_window_samples(m->windows.at[n].what);
    return 1 + samples / SAMPLES;
}

GoalFound goal_search(Arena *arena, Arena *work, const Cover *c, const GoalSearch *g)
{
    GoalWatch *w;
    SearchWatch watch = {.goals = 1, .start = start_goal, .step = step_goal};
    GoalStop stop = {g};
    SearchOptions o = {.seed = g->seed, .effort = g->effort, .delta_t = g->delta_t, .init_state = g->init_state,
                       .initial = g->initial, .no_places = true, .plain = true,
                       .watch = &watch, .given = g->given, .givens = g->givens, .memory = g->memory,
                       .specials = g->usual_values ? SEARCH_NO_SPECIALS : g->assume_ranges ? SEARCH_SPECIALS_IN_RANGES : SEARCH_SPECIALS,
                       .go_on = may_go_on, .context = &stop};
    const SearchResult *found;
    GoalFound out = {.scenario = NULL};

    arena_reset(work);
    watch.self = w = new_watch(work, g);
    watch.size = MEMORY_SIZE + w->monitor->size;
    o.writable = goal_inputs(work, g->all->program);
    o.effort = (g->effort - 1) / goal_cost_of_step(w->monitor) + 1;
    found = search_run(work, c, &o);
    out.steps = found->steps;
    if (found->find[found->places].outcome == SEARCH_REACHED) {
        Scenario *s = goal_end_scenario(work, g, set_parameters(work, g, &found->chosen[found->find[found->places].scenario].scenario));
        if (s)
            simplify_scenario(work, g, s);
        out.unconfirmed = !s && !g->assume_ranges;        // with ranges, the values that inputs must have can prevent the violation
        out.scenario = s ? copy_scenario(arena, s) : NULL;
    }
    out.premise_seen = w->premise_seen;
    out.tried = arena_copy(arena, w->tried, g->all->program->state.n);
    return out;
}
