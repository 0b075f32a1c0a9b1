// SPDX-License-Identifier: Apache-2.0
// Facts of a machine: the possible values of its locals when each function begins.  Transitions are followed until no fact changes.
// Bounds that grow repeatedly are widened, so this iteration ends after a few visits of each state.  If anything was widened, one last
// round over all functions is the narrowing step of abstract interpretation.
#include <stddef.h>
#include <string.h>

#include "compiler/base/worklist.h"
#include "compiler/facts/facts.h"

// How often the facts at the beginning of a function may change before joins become less precise.
enum {
    CHANGES_BEFORE_WIDENING = 3,           // after so many changes, bounds are widened to constants of the program
    CHANGES_BEFORE_FEW_LIMITS = 12,   // after so many changes, bounds are widened to a few round numbers
    CHANGES_MAX = 20,                 // after so many changes, only the facts about locals that never change remain
    LIMITS_MAX = 64                   // how many constants of the program are collected
};

typedef struct FactIteration {
    FactMachine *fm;
    FactBegin (*to)[BLOCK_COUNT];     // the table into which facts are merged: fm->begin, or in the last round a new table that then replaces it
    bool *(*possible)[BLOCK_COUNT];   // [state with an .exit][function][IR block]: whether the block's transition is possible
    Worklist queue;                   // the states to visit next, if any_start
    SweepList sweep;                  // the states to visit next, if not any_start
    uint32_t state;                   // the state that is visited
    int block;                        // which function of the state is visited: BLOCK_ENTRY, BLOCK_STEP or BLOCK_EXIT
    bool any_start;                   // the machine may be started in any state
    uint32_t start;                   // else: the index of the state in which it starts
    bool widened;                     // some bound was widened, so the last round may improve facts
    FactLimits limits;                // constants of the program and the numbers next to them, because guards stop counters there
} FactIteration;

// ---- the order of visits ----
// From the first state, most facts flow in the order in which states are written.  Sweeps in that order visit a state after most of its
// predecessors, and need half as many visits as the order in which facts change.  If the machine may start in any state, all states are
// visited first anyway.

// Adds a state to those whose functions must be visited again.
static void queue_state(FactIteration *v, uint32_t state)
{
    if (v->any_start)
        worklist_add(&v->queue, state);
    else
        sweep_list_add(&v->sweep, state);
}

// Sets v->state to the next state to visit.  Returns false if no state is queued.
static bool take_queued_state(FactIteration *v)
{
    if (v->queue.n == 0 && v->sweep.n == 0)
        return false;
    v->state = v->any_start ? worklist_next(&v->queue) : sweep_list_next(&v->sweep, v->state);
    return true;
}

// ---- paths into functions ----

// Merges the facts `env` of one more path into those at the beginning b of a function, and returns the result.  After several changes,
// widens the result.
static const Env *join_at_begin(FactIteration *v, const FactBegin *b, const Env *env)
{
    static const double round[] = {-FACT_EXACT, -2147483648.0, -32768, -128, 0, 1, 255, 65535, 2147483647.0, FACT_EXACT};
    static const FactLimits few = {round, sizeof round / sizeof *round};
    const bool last = v->to != v->fm->begin;

    if (!b->found)
        return env;
    if (b->changes > CHANGES_MAX && !last)
        return v->fm->constants;
    v->widened |= b->changes > CHANGES_BEFORE_WIDENING;
    return env_join(&v->fm->shape, b->env, env, last || b->changes <= CHANGES_BEFORE_WIDENING
                    ? NULL : b->changes <= CHANGES_BEFORE_FEW_LIMITS ? &v->limits : &few);
}

// Merges the facts `env` of a path into a function into the facts at the function's beginning.  If these change, queues its state for
// another visit.
static void enter_function(FactIteration *v, uint32_t state, int block, const Env *env)
{
    FactBegin *b = &v->to[state][block];
    const Env *now;

    if (b->found && b->joined == env)
        return;
    now = join_at_begin(v, b, env);
    b->joined = env;
    if (b->found && now == b->env)
        return;
    b->env = now;
    b->found = b->dirty = true;
    b->changes++;
    if (v->to == v->fm->begin)
        queue_state(v, state);
}

// Called at the end of .exit with the facts `env` at that point: calls enter_function for the target of each transition of `block` (.entry
// or .step) that has been found possible.
static void enter_possible_targets(FactIteration *v, int block, const Env *env)
{
    const IrFn *f = v->fm->m->state.at[v->state].block[block];
    const bool *possible = v->possible[v->state][block];

    for (size_t b = 0; possible && b < f->blk.n; b++)
        if (possible[b])
            enter_function(v, f->blk.at[b].jump.state - 1, BLOCK_ENTRY, env);
}

// Records that a transition of the current function is possible, and enters .exit, or the target state if there is no .exit.  After the
// first record of a transition, .exit must be visited even if its facts do not change, because only that visit enters the target state.
static void mark_transition_possible(FactIteration *v, const IrJump *j, const Env *env)
{
    const IrFn *f = v->fm->m->state.at[v->state].block[v->block];
    const IrBlk *blk = (const IrBlk *)((const char *)j - offsetof(IrBlk, jump));
    bool **possible = &v->possible[v->state][v->block];
    const size_t b = (size_t)(blk - f->blk.at);

    enter_function(v, v->state, BLOCK_EXIT, env);
    if (!v->fm->m->state.at[v->state].block[BLOCK_EXIT]) {
        enter_function(v, j->state - 1, BLOCK_ENTRY, env);
        return;
    }
    if (!*possible)
        *possible = ARENA_ARRAY(v->fm->shape.arena, bool, f->blk.n);
    v->to[v->state][BLOCK_EXIT].dirty |= !(*possible)[b];
    (*possible)[b] = true;
}

// Called at each end of the current function: enters the functions that can run next.  `env` has no facts about elements except those that
// are assumed, because other code may write elements between steps.
static void visit_end(void *context, const IrJump *end, const Env *env)
{
    FactIteration *v = context;

    if (v->block == BLOCK_EXIT && v->fm->m->state.at[v->state].block[BLOCK_EXIT]) {
        enter_possible_targets(v, BLOCK_ENTRY, env);
        enter_possible_targets(v, BLOCK_STEP, env);
    } else if (end->kind == IR_GOTO) {
        mark_transition_possible(v, end, env);
    } else if (v->block != BLOCK_EXIT) {
        enter_function(v, v->state, BLOCK_STEP, env);
    }
}

// ---- visits ----

// Computes the facts in one function of the current state.  Merges the facts at each of its ends into those at the beginning of every
// function that can run next (visit_end).
static void compute_function_facts(FactIteration *v, int block)
{
    static const IrJump nothing = {.kind = IR_RET, .cond = IR_NONE};
    const Fact *time = block == BLOCK_ENTRY ? &v->fm->zero : block == BLOCK_STEP && v->fm->time ? &v->fm->time[v->state] : NULL;
    const FactEnds ends = {visit_end, v, .time = time, .fn = &v->fm->fn[v->state][block]};
    const IrFn *f = v->fm->m->state.at[v->state].block[block];
    FactBegin *b = &v->fm->begin[v->state][block];

    v->block = block;
    b->dirty = false;
    if (!f) {
        visit_end(v, &nothing, b->env);
        return;
    }
    facts_flow(v->fm, f, b->env, &ends);
}

static void enter_start_states(FactIteration *v, const Env *env)
{
    if (!v->any_start)
        enter_function(v, v->start, BLOCK_ENTRY, env);
    for (uint32_t s = 0; v->any_start && s < v->fm->m->state.n; s++)
        enter_function(v, s, BLOCK_ENTRY, env);
}

// The narrowing step: derives all facts once more from facts that are true.  The results are also true, and may be tighter.
static void narrow_facts(FactIteration *v, const Env *initial)
{
    v->to = arena_array(v->fm->shape.arena, v->fm->m->state.n, sizeof *v->to);
    enter_start_states(v, initial);
    for (v->state = 0; v->state < v->fm->m->state.n; v->state++)
        for (int block = 0; block < BLOCK_COUNT; block++)
            if (v->fm->begin[v->state][block].found)
                compute_function_facts(v, block);
    v->fm->begin = v->to;
}

// Returns the fact about the initial value of a local, or about all values to which a parameter can be set.
static Fact fact_of_initial(const IrVar *v)
{
    const Parameter *p = v->parameter;
    const Fact any = {p ? p->lo : 0, p ? p->hi : 0, .whole = !ir_is_float(v->type),
                      .minus_zero = ir_is_float(v->type) && p && p->lo <= 0 && p->hi >= 0};
    const Fact written = p ? any : fact_of_cell(v->type, v->init);
    Fact r = fact_convert(written, v->type);

    r.round_trips |= written.round_trips;
    return r;
}

// Returns facts that say that private locals, which only the machine writes, have their initial values.  If `writable_too` is false, says nothing
// about locals that the machine stores to.
static const Env *initial_values(const FactMachine *fm, bool writable_too)
{
    const EnvShape *s = &fm->shape;
    const Env *env = fm->assumed;

    for (uint32_t v = 0; v < fm->m->var.n; v++) {
        const IrVar *var = &fm->m->var.at[v];
        if (env_is_private(var) && (writable_too || !var->writable))
            env = env_set(s, env, v, fact_of_initial(var));
    }
    return env;
}

// ---- limits for widening ----

// Inserts x into the ascending list, unless the list has it or is full.
static void add_limit(double *limit, size_t *n, double x)
{
    size_t at = 0;

    while (at < *n && limit[at] < x)
        at++;
    if (*n == LIMITS_MAX || (at < *n && limit[at] == x) || !(x > -FACT_EXACT && x < FACT_EXACT))
        return;
    memmove(limit + at + 1, limit + at, (*n - at) * sizeof *limit);
    limit[at] = x;
    (*n)++;
}

// Inserts a constant, and the numbers one below and one above it.  A NaN has none.
static void add_limits_at_constant(double *limit, size_t *n, Fact c)
{
    for (int beside = -1; c.lo == c.hi && beside <= 1; beside++)
        add_limit(limit, n, c.lo + beside);
}

// Returns the constants of the program, and the numbers one below and one above each.
static FactLimits limits_of_program(Arena *arena, const IrMachine *m)
{
    double *limit = ARENA_ARRAY(arena, double, LIMITS_MAX);
    size_t n = 0;

    for (size_t s = 0; s < m->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++) {
            const IrFn *f = m->state.at[s].block[b];
            for (size_t i = 0; f && i < f->ins.n && n < LIMITS_MAX; i++) {
                const IrIns *ins = &f->ins.at[i];
                if (ins->op == IR_const)
                    add_limits_at_constant(limit, &n, fact_of_cell(ins->type, ins->bits));
            }
        }
    add_limit(limit, &n, 0);
    return (FactLimits){limit, n};
}

// ---- the iteration ----

// Visits functions until no fact changes, then narrows the facts if bounds were widened.
static void iterate_to_fixed_point(FactMachine *fm, bool any_start, uint32_t start)
{
    const IrMachine *m = fm->m;
    const Env *initial = initial_values(fm, true);
    FactIteration v = {.fm = fm, .to = fm->begin, .any_start = any_start, .start = start};

    v.limits = limits_of_program(fm->shape.arena, m);
    v.possible = arena_array(fm->shape.arena, m->state.n, sizeof *v.possible);
    fm->fn = arena_array(fm->shape.arena, m->state.n, sizeof *fm->fn);
    if (any_start)
        v.queue = worklist_new(fm->shape.arena, m->state.n);
    else
        v.sweep = sweep_list_new(fm->shape.arena, m->state.n);
    enter_start_states(&v, initial);
    while (take_queued_state(&v))
        for (int block = 0; block < BLOCK_COUNT; block++)
            if (fm->begin[v.state][block].dirty)
                compute_function_facts(&v, block);
    if (v.widened)
        narrow_facts(&v, initial);
}

static FactMachine *compute_machine_facts(Arena *arena, const IrMachine *m, bool any_start, uint32_t start, const Env *assumed, const Fact *time)
{
    FactMachine *fm = ARENA_NEW(arena, FactMachine);
    const size_t slots = m->var.n > FACT_SLOTS ? m->var.n : FACT_SLOTS;

    fm->m = m;
    fm->shape = env_shape(arena, m);
    arena_init_within(&fm->local, arena);
    fm->assumed = assumed;
    fm->time = time;
    fm->begin = arena_array(arena, m->state.n, sizeof *fm->begin);
    fm->window = ARENA_ARRAY(arena, Fact, m->window.n);
    fm->epoch = ARENA_ARRAY(arena, uint32_t, m->var.n);
    fm->stored = ARENA_ARRAY(arena, uint32_t, m->var.n);
    fm->slot_of = ARENA_ARRAY(arena, FactSlotOf, m->var.n);
    fm->refined = ARENA_ARRAY(arena, FactRefined, slots);
    fm->refined_slot = ARENA_ARRAY(arena, uint32_t, slots);
    fm->zero = fact_of_cell(SM_U64, 0);
    fm->constants = initial_values(fm, false);
    for (uint32_t v = 0; v < m->var.n; v++)
        fm->has_variable_locals |= env_is_private(&m->var.at[v]) && m->var.at[v].writable;
    if (m->sample)
        facts_flow(fm, m->sample, fm->constants, NULL);
    if (fm->has_variable_locals || !any_start)
        iterate_to_fixed_point(fm, any_start, start);
    return fm;
}

FactMachine *facts_of_machine(Arena *arena, const IrMachine *m) { return compute_machine_facts(arena, m, true, 0, NULL, NULL); }

// Computes the facts of a machine that is only ever started in its first state, as analyses assume.
FactMachine *facts_from_first_state(Arena *arena, const IrMachine *m) { return facts_from_state(arena, m, 0); }

FactMachine *facts_from_state(Arena *arena, const IrMachine *m, uint32_t state) { return facts_with_times(arena, m, state, NULL); }

// Like facts_from_state, with facts about T when .step of each state begins.
FactMachine *facts_with_times(Arena *arena, const IrMachine *m, uint32_t state, const Fact *time)
{
    return compute_machine_facts(arena, m, false, state, NULL, time);
}

// Like facts_from_first_state, but assumes that the elements satisfy `assumed` whenever a step begins.
FactMachine *facts_assuming(Arena *arena, const IrMachine *m, const Env *assumed)
{
    return compute_machine_facts(arena, m, false, 0, assumed, NULL);
}

// ---- results ----

const Env *facts_at_begin(const FactMachine *fm, size_t state, int block)
{
    const FactBegin *b = &fm->begin[state][block];
    const Env *env = b->found ? b->env : fm->constants;
    const IrMachine *m = fm->m;

    if (block == BLOCK_STEP && fm->time)
        return env_set(&fm->shape, env, m->t, fm->time[state]);
    return block == BLOCK_ENTRY ? env_set(&fm->shape, env, m->t, fm->zero) : env;
}

void facts_forget_visits(FactMachine *fm) { fm->fn = NULL; }

// Makes later calls of facts_of_function allocate from `arena`.
void facts_set_arena(FactMachine *fm, Arena *arena)
{
    fm->shape.arena = arena;
    fm->shape.unique = NULL;
    arena_init_within(&fm->local, arena);
    fm->temps = fm->blocks = 0;       // allocate new tables in the new arena
}

// Whether the facts allow a path to this function.
bool facts_may_reach(const FactMachine *fm, size_t state, int block) { return fm->begin[state][block].found; }
const Env *facts_at_begin_of_sample(const FactMachine *fm) { return fm->constants; }

// Returns the fact that is true of all samples of the window.
Fact facts_of_window(const FactMachine *fm, uint32_t window) { return fm->window[window]; }
