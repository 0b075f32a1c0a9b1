// SPDX-License-Identifier: Apache-2.0
#include "compiler/cover/run_facts.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "compiler/cover/judge.h"

// How often facts are computed again: a bound after one transition can lead to a bound after another one in the next round.
enum { MOST_ROUNDS = 4 };

struct RunFacts {
    Arena *arena;
    Arena *known;             // memory of `facts`, and of what is computed from them
    IrMachine m;              // a copy of the machine in which all variables except inputs are locals
    FactMachine *facts;
    uint32_t start;           // State.number of the state in which the runs begin
    uint64_t delta_t;
    bool counts;              // some transition stores a lower bound, so facts depend on delta_t
};

// ---- the machine ----

// Turns all variables except inputs and times into locals, so that facts about them remain valid from step to step.  any_elements: the elements may
// have any value at the start, as facts about a parameter allow every value of its range.
static void turn_variables_into_locals(IrMachine *m, Arena *arena, const bool *is_input, bool any_elements)
{
    Parameter *any = ARENA_NEW(arena, Parameter);

    any->lo = -INFINITY;
    any->hi = INFINITY;
    m->var.at = arena_copy(arena, m->var.at, m->var.n * sizeof *m->var.at);
    for (uint32_t v = 0; v < m->var.n; v++) {
        IrVar *var = &m->var.at[v];
        if (is_input[v] || v == m->g || v == m->s || var->space == IR_TIME)
            continue;
        if (var->space == IR_ELEMENT) {
            var->init = 0;
            var->parameter = any_elements ? any : NULL;
        }
        var->space = IR_LOCAL;
        var->outside = false;
    }
}

// Replaces what a function reads of S by the number of its state: no code outside the machine writes S (language.md 6.4, 6.12).
static void replace_state_number(IrFn *f, uint32_t s, uint64_t number)
{
    for (uint32_t i = 0; i < f->ins.n; i++)
        if (f->ins.at[i].op == IR_load && f->ins.at[i].var == s) {
            f->ins.at[i].op = IR_const;
            f->ins.at[i].bits = number;
        }
}

static void make_functions(IrMachine *m, Arena *arena)
{
    m->state.at = arena_copy(arena, m->state.at, m->state.n * sizeof *m->state.at);
    for (uint32_t i = 0; i < m->state.n * BLOCK_COUNT; i++) {
        const uint32_t s = i / BLOCK_COUNT, part = i % BLOCK_COUNT;
        const IrFn *f = m->state.at[s].block[part];
        IrFn *form;
        if (!f)
            continue;
        form = arena_copy(arena, f, sizeof *f);
        form->ins.at = arena_copy(arena, f->ins.at, f->ins.n * sizeof *f->ins.at);
        form->ins.cap = f->ins.n;
        form->blk.at = arena_copy(arena, f->blk.at, f->blk.n * sizeof *f->blk.at);
        form->blk.cap = f->blk.n;
        for (uint32_t b = 0; b < f->blk.n; b++) {
            form->blk.at[b].ins.at = arena_copy(arena, f->blk.at[b].ins.at, f->blk.at[b].ins.n * sizeof *f->blk.at[b].ins.at);
            form->blk.at[b].ins.cap = f->blk.at[b].ins.n;
        }
        replace_state_number(form, m->s, s + 1);
        m->state.at[s].block[part] = form;
    }
}

// ---- what a state counts ----

static double low_of(Drift d, double before)
{
    const double counted = before + d.by[0];

    return !d.is_relative || (d.is_number && d.number[0] < counted) ? d.number[0] : counted;
}

static double high_of(Drift d, double before)
{
    const double counted = before + d.by[1];

    return !d.is_relative || (d.is_number && d.number[1] > counted) ? d.number[1] : counted;
}

DriftInState run_facts_drift(RunFacts *r, uint32_t state, uint32_t var)
{
    const IrFn *entry = r->m.state.at[state - 1].block[BLOCK_ENTRY], *step = r->m.state.at[state - 1].block[BLOCK_STEP];
    DriftInState out = {.has_low = false};
    Drift first = {.is_relative = true}, each;
    DriftPaths paths;
    Fact before;

    if (!step || r->m.var.at[var].space != IR_LOCAL || r->m.var.at[var].outside || drift_cap(r->m.var.at[var].type) == 0 || !facts_may_reach(r->facts, state - 1, BLOCK_ENTRY))
        return out;
    before = env_get(&r->facts->shape, facts_at_begin(r->facts, state - 1, BLOCK_ENTRY), var);
    if (entry) {
        paths = drift_of_function(r->known, entry, var);
        first = drift_at_returns(entry, &paths);
    }
    paths = drift_of_function(r->known, step, var);
    each = drift_at_returns(step, &paths);
    if (first.any || each.any || (!first.is_relative && !first.is_number))
        return out;
    out.bound[0] = low_of(first, before.lo);
    out.bound[1] = high_of(first, before.hi);
    out.each[0] = each.is_relative ? each.by[0] : 0;
    out.each[1] = each.is_relative ? each.by[1] : 0;
    out.has_low = !each.is_number;
    out.has_high = !each.is_number || each.number[1] <= out.bound[1];
    return out;
}

// ---- bounds after transitions ----

static IrRef append_ins(Arena *arena, IrFn *f, IrBlk *blk, IrIns i)
{
    vec_push(arena, &f->ins, i);
    vec_push(arena, &blk->ins, f->ins.n - 1);
    return f->ins.n - 1;
}

// Appends a store of the maximum of a variable and a number.
static void append_maximum(RunFacts *r, IrFn *f, IrBlk *blk, uint32_t var, double least)
{
    const SmType type = r->m.var.at[var].type;
    const IrIns load = {.op = IR_load, .type = type, .a = IR_NONE, .b = IR_NONE, .var = var}, number = {.op = IR_const, .type = SM_F64, .a = IR_NONE, .b = IR_NONE};
    IrIns wide = {.op = IR_cvt, .type = SM_F64, .b = IR_NONE}, bound = number, most = {.op = IR_max, .type = SM_F64}, store = {.op = IR_store, .type = type, .b = IR_NONE, .var = var};
    IrIns narrow = {.op = IR_cvt, .type = type, .b = IR_NONE};

    wide.a = append_ins(r->arena, f, blk, load);
    bound.bits = sm_bits(sm_from_u64((uint64_t)least));
    most.a = append_ins(r->arena, f, blk, wide);
    most.b = append_ins(r->arena, f, blk, bound);
    narrow.a = append_ins(r->arena, f, blk, most);
    store.a = append_ins(r->arena, f, blk, narrow);
    append_ins(r->arena, f, blk, store);
}

// Returns the lower bound of a variable where a transition leaves the state.  time: the least T there; end: the drift in that step.
static double bound_at_end(const RunFacts *r, const DriftInState *d, Drift end, double time, SmType type)
{
    const double steps = time / (double)r->delta_t, cap = drift_cap(type);
    const double least = d->bound[0] + d->each[0] * steps + end.by[0];

    return least < cap ? least : cap;
}

// Adds a lower bound of a variable before each transition of a state.  Returns whether a bound is tighter than the facts.
static bool bound_transitions(RunFacts *r, uint32_t state, uint32_t var)
{
    IrFn *f = r->m.state.at[state - 1].block[BLOCK_STEP];
    const DriftInState d = run_facts_drift(r, state, var);
    const FactEnds ends = {.exits = true};
    DriftPaths paths;
    FactFlow flow;
    bool more = false;

    if (!d.has_low || d.each[0] == 0)
        return false;
    paths = drift_of_function(r->known, f, var);
    flow = facts_flow(r->facts, f, facts_at_begin(r->facts, state - 1, BLOCK_STEP), &ends);
    for (uint32_t b = 0; b < f->blk.n; b++) {
        IrBlk *blk = &f->blk.at[b];
        double least, time;
        if (blk->jump.kind != IR_GOTO || !flow.reached[b] || !paths.reached[b] || paths.at_end[b].any || paths.at_end[b].is_number)
            continue;
        time = env_get(&r->facts->shape, flow.exit[b].env, r->m.t).lo;
        least = bound_at_end(r, &d, paths.at_end[b], time, r->m.var.at[var].type);
        if (!(least > env_get(&r->facts->shape, flow.exit[b].env, var).lo + 1))
            continue;
        append_maximum(r, f, blk, var, least);
        more = true;
    }
    return more;
}

static bool is_first_store(const IrFn *f, uint32_t i)
{
    for (uint32_t before = 0; before < i; before++)
        if (f->ins.at[before].op == IR_store && f->ins.at[before].var == f->ins.at[i].var)
            return false;
    return true;
}

// Returns whether some transition has got a tighter bound.
static bool bound_all_transitions(RunFacts *r)
{
    bool more = false;

    for (uint32_t s = 0; s < r->m.state.n; s++) {
        const IrFn *f = r->m.state.at[s].block[BLOCK_STEP];
        const uint32_t own = f && facts_may_reach(r->facts, s, BLOCK_STEP) ? f->ins.n : 0;
        for (uint32_t i = 0; i < own; i++)
            if (f->ins.at[i].op == IR_store && is_first_store(f, i))
                more |= bound_transitions(r, s + 1, f->ins.at[i].var);
    }
    return more;
}

// ---- how long a state lasts ----

// The facts about T where a step ends without a transition.
typedef struct StayEnd { const RunFacts *r; double most; bool any; } StayEnd;

static void visit_stay(void *context, const IrJump *end, const Env *env)
{
    StayEnd *x = context;
    const Fact time = env_get(&x->r->facts->shape, env, x->r->m.t);

    if (end->kind != IR_RET)
        return;
    x->any = true;
    x->most = time.hi > x->most ? time.hi : x->most;
}

Fact run_facts_time(RunFacts *r, uint32_t state)
{
    const IrFn *f = r->m.state.at[state - 1].block[BLOCK_STEP];
    const double delta_t = (double)r->delta_t;
    StayEnd x = {.r = r};
    const FactEnds ends = {.visit = visit_stay, .context = &x, .all = true};
    Fact time = fact_of_type(SM_U64);

    if (!f || !facts_may_reach(r->facts, state - 1, BLOCK_STEP))
        return time;
    facts_flow(r->facts, f, facts_at_begin(r->facts, state - 1, BLOCK_STEP), &ends);
    if (!x.any)
        return fact_of_cell(SM_U64, 0);
    if (!(x.most + delta_t < FACT_EXACT))
        return time;
    time.hi = floor(x.most / delta_t) * delta_t + delta_t;
    time.round_trips = true;
    return time;
}

// Computes the facts, with `time` about T when .step of each state begins; NULL: without.  Those computed before are freed.
static void compute_facts(RunFacts *r, const Fact *time)
{
    arena_free(r->known);
    r->facts = facts_with_times(r->known, &r->m, r->start - 1, time);
}

// Computes the facts again with what they imply about T.  Returns false if that is nothing.
static bool add_times(RunFacts *r)
{
    Fact *time = ARENA_ARRAY(r->arena, Fact, r->m.state.n);
    bool any = false;

    for (uint32_t s = 0; s < r->m.state.n; s++) {
        time[s] = run_facts_time(r, s + 1);
        any |= time[s].hi < FACT_EXACT;
    }
    if (any)
        compute_facts(r, time);
    return any;
}

RunFacts *run_facts_new(Arena *arena, Arena *known, const IrMachine *m, const bool *is_input, uint64_t delta_t, RunStart start)
{
    RunFacts *r = ARENA_NEW(arena, RunFacts);

    r->arena = arena;
    r->known = known;
    r->m = *m;
    r->delta_t = delta_t;
    r->start = start.state;
    turn_variables_into_locals(&r->m, arena, is_input, start.any_elements);
    make_functions(&r->m, arena);
    for (int round = 0; round < MOST_ROUNDS; round++) {
        compute_facts(r, NULL);
        if (round + 1 == MOST_ROUNDS || !bound_all_transitions(r))
            break;
        r->counts = true;
    }
    return r;
}

// ---- places ----

// Sets reason[place], as run_facts_exclude does, for the places without a reason that the current facts exclude.  condition: appended to the reason.
static void add_reasons(RunFacts *r, const Cover *c, Arena *texts, const char *condition, const char **reason)
{
    const char **found = arena_array(r->known, c->place.n, sizeof *found);

    cover_judge_by_facts(c, r->known, r->facts, false, found);
    for (uint32_t i = 1; i < c->place.n; i++)
        if (found[i] && !reason[i])
            reason[i] = format_in(texts, "%s, %s", found[i], condition);
}

void run_facts_exclude(RunFacts *r, const Cover *c, Arena *texts, const char **reason)
{
    const char *const timed = format_in(r->arena, "if only inputs change, and delta_t is %" PRIu64, r->delta_t);

    add_reasons(r, c, texts, r->counts ? timed : "if only inputs change", reason);
    if (add_times(r))
        add_reasons(r, c, texts, timed, reason);
}
