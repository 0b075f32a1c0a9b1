// SPDX-License-Identifier: Apache-2.0
// Facts of a machine: the possible values of its locals when each function begins.  Transitions are followed until no fact changes.
// Bounds that keep growing are widened, so this ends after a few visits of each state.  If anything was widened, one last round over
// all functions is the narrowing step.
#include <stddef.h>

#include "compiler/facts/facts.h"

// Limits on the number of changes of a function's facts.  After PATIENCE changes, bounds are widened to numbers of the program; after
// IMPATIENCE, to a few round numbers.  After ENOUGH, only constants remain known.  NUMBERS limits how many numbers are collected.
enum { PATIENCE = 3, IMPATIENCE = 12, ENOUGH = 20, NUMBERS = 64 };

// The states to visit, in a ring buffer.
typedef struct Queue {
    uint32_t *at;
    bool *waits;                      // by state
    size_t first, n, size;
} Queue;

typedef struct Visit {
    FactMachine *fm;
    FactBegin (*to)[BLOCK_COUNT];     // receives the facts: fm->begin, or in the last round a new table that replaces it
    bool *(*made)[BLOCK_COUNT];       // by state with an .exit and by function, a table by block: its transition is possible
    Queue queue;
    uint32_t state;                   // the current one
    int block;
    bool anywhere;                    // the machine may be started in any state
    const FactWatch *watch;           // or NULL
    bool widened;                     // some bound was widened, so the last round may improve facts
    FactLimits numbers;               // constants of the program and their neighbours, because guards stop counters there
} Visit;

static void enqueue(Queue *q, uint32_t state)
{
    if (q->waits[state])
        return;
    q->waits[state] = true;
    q->at[(q->first + q->n++) % q->size] = state;
}

static uint32_t dequeue(Queue *q)
{
    const uint32_t state = q->at[q->first];

    q->first = (q->first + 1) % q->size;
    q->n--;
    q->waits[state] = false;
    return state;
}

// ---- paths into functions ----

static const Env *with_more(Visit *v, const FactBegin *b, const Env *env)
{
    static const double round[] = {-FACT_EXACT, -2147483648.0, -32768, -128, 0, 1, 255, 65535, 2147483647.0, FACT_EXACT};
    static const FactLimits few = {round, sizeof round / sizeof *round};
    const bool last = v->to != v->fm->begin;

    if (!b->found)
        return env;
    if (b->changes > ENOUGH && !last)
        return v->fm->constants;
    v->widened |= b->changes > PATIENCE;
    return env_join(&v->fm->shape, b->env, env, last || b->changes <= PATIENCE ? NULL : b->changes <= IMPATIENCE ? &v->numbers : &few);
}

static void arrive(Visit *v, uint32_t state, int block, const Env *env)
{
    FactBegin *b = &v->to[state][block];
    const Env *now = with_more(v, b, env);

    if (b->found && now == b->env)
        return;
    b->env = now;
    b->found = b->dirty = true;
    b->changes++;
    if (v->to == v->fm->begin)
        enqueue(&v->queue, state);
}

// At the end of .exit: enters the target of each transition that has been found possible.
static void arrive_at_targets(Visit *v, int block, const Env *env)
{
    const IrFn *f = v->fm->shape.m->state.at[v->state].block[block];
    const bool *made = v->made[v->state][block];

    for (size_t b = 0; made && b < f->blk.n; b++)
        if (made[b])
            arrive(v, f->blk.at[b].jump.state - 1, BLOCK_ENTRY, env);
}

// Records that a transition is possible.  A new one requires a visit of .exit, even if it adds no fact at the beginning of .exit.
static void make_transition(Visit *v, const IrJump *j, const Env *env)
{
    const IrFn *f = v->fm->shape.m->state.at[v->state].block[v->block];
    const IrBlk *blk = (const IrBlk *)((const char *)j - offsetof(IrBlk, jump));
    bool **made = &v->made[v->state][v->block];
    const size_t b = (size_t)(blk - f->blk.at);

    arrive(v, v->state, BLOCK_EXIT, env);
    if (!v->fm->shape.m->state.at[v->state].block[BLOCK_EXIT]) {
        arrive(v, j->state - 1, BLOCK_ENTRY, env);
        return;
    }
    if (!*made)
        *made = ARENA_ARRAY(v->fm->shape.arena, bool, f->blk.n);
    v->to[v->state][BLOCK_EXIT].dirty |= !(*made)[b];
    (*made)[b] = true;
}

// Called at each end of the current function.  From here on, other code may have written the elements.
static void end_of_function(void *context, const IrJump *end, const Env *env)
{
    Visit *v = context;

    env = env_begin(&v->fm->shape, env, v->fm->outside);
    if (v->block == BLOCK_EXIT && v->fm->shape.m->state.at[v->state].block[BLOCK_EXIT]) {
        arrive_at_targets(v, BLOCK_ENTRY, env);
        arrive_at_targets(v, BLOCK_STEP, env);
    } else if (end->kind == IR_GOTO) {
        make_transition(v, end, env);
    } else if (v->block != BLOCK_EXIT) {
        arrive(v, v->state, BLOCK_STEP, env);
    }
}

// ---- visits ----

static void look_at_function(Visit *v, int block)
{
    static const IrJump nothing = {.kind = IR_RET, .cond = IR_NONE};
    const FactEnds ends = {end_of_function, v};
    const IrFn *f = v->fm->shape.m->state.at[v->state].block[block];
    FactBegin *b = &v->fm->begin[v->state][block];

    v->block = block;
    b->dirty = false;
    if (!f) {
        end_of_function(v, &nothing, b->env);
        return;
    }
    FactFlow flow = facts_flow(v->fm, f, facts_begin(v->fm, v->state, block), &ends);
    if (v->watch)
        v->watch->at(v->watch->context, f, flow);
}

static void visit_states(Visit *v)
{
    while (v->queue.n > 0) {
        v->state = dequeue(&v->queue);
        for (int block = 0; block < BLOCK_COUNT; block++)
            if (v->fm->begin[v->state][block].dirty)
                look_at_function(v, block);
    }
}

static void begin_all(Visit *v, const Env *env)
{
    for (uint32_t s = 0; s < (v->anywhere ? v->fm->shape.m->state.n : 1); s++)
        arrive(v, s, BLOCK_ENTRY, env);
}

// Derives all facts once more from facts that are true.  The results are also true, and may be tighter.
static void last_round(Visit *v, const Env *env)
{
    v->to = arena_array(v->fm->shape.arena, v->fm->shape.m->state.n, sizeof *v->to);
    begin_all(v, env);
    for (v->state = 0; v->state < v->fm->shape.m->state.n; v->state++)
        for (int block = 0; block < BLOCK_COUNT; block++)
            if (v->fm->begin[v->state][block].found)
                look_at_function(v, block);
    v->fm->begin = v->to;
}

static const Env *initial(const FactMachine *fm, bool writable_too)
{
    const EnvShape *s = &fm->shape;
    const Env *env = fm->outside;

    for (uint32_t v = 0; v < s->m->var.n; v++) {
        const IrVar *var = &s->m->var.at[v];
        if (env_is_private(var) && (writable_too || !var->writable))
            env = env_set(s, env, v, fact_convert(fact_of_cell(var->type, var->init), var->type));
    }
    return env;
}

// ---- the program's numbers ----

typedef struct Numbers {
    double at[NUMBERS + 2];
    size_t n;
} Numbers;

static void add_number(Numbers *numbers, double x)
{
    for (size_t i = 0; i < numbers->n; i++)
        if (numbers->at[i] == x)
            return;
    if (numbers->n < NUMBERS && x > -FACT_EXACT && x < FACT_EXACT)
        numbers->at[numbers->n++] = x;
}

static void add_numbers_of(Numbers *numbers, const IrFn *f)
{
    for (size_t i = 0; f && i < f->ins.n && numbers->n < NUMBERS; i++) {
        const Fact c = f->ins.at[i].op == IR_const ? fact_of_cell(f->ins.at[i].type, f->ins.at[i].bits) : fact_of_type(SM_F64);
        for (int beside = -1; c.lo == c.hi && beside <= 1; beside++)
            add_number(numbers, c.lo + beside);
    }
}

static FactLimits numbers_of(Arena *arena, const IrMachine *m)
{
    Numbers *numbers = ARENA_NEW(arena, Numbers);

    for (size_t s = 0; s < m->state.n && numbers->n < NUMBERS; s++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            add_numbers_of(numbers, m->state.at[s].block[b]);
    add_number(numbers, 0);
    return (FactLimits){numbers->at, numbers->n};
}

static void tell_anew(FactMachine *fm, const FactWatch *watch)
{
    watch->forget(watch->context);
    for (size_t s = 0; s < fm->shape.m->state.n; s++)
        for (int block = 0; block < BLOCK_COUNT; block++) {
            const IrFn *f = fm->shape.m->state.at[s].block[block];
            if (f && fm->begin[s][block].found)
                watch->at(watch->context, f, facts_of_function(fm, f, facts_begin(fm, s, block)));
        }
}

static void visit_all(FactMachine *fm, bool anywhere, const FactWatch *watch)
{
    const IrMachine *m = fm->shape.m;
    const Env *env = initial(fm, true);
    Visit v = {.fm = fm, .to = fm->begin, .anywhere = anywhere, .watch = watch, .numbers = numbers_of(fm->shape.arena, m)};

    v.made = arena_array(fm->shape.arena, m->state.n, sizeof *v.made);
    v.queue.size = m->state.n;
    v.queue.at = ARENA_ARRAY(fm->shape.arena, uint32_t, m->state.n);
    v.queue.waits = ARENA_ARRAY(fm->shape.arena, bool, m->state.n);
    begin_all(&v, env);
    visit_states(&v);
    if (!v.widened)
        return;
    v.watch = NULL;
    last_round(&v, env);
    if (watch)
        tell_anew(fm, watch);
}

static FactMachine *find_facts(Arena *arena, const IrMachine *m, bool anywhere, const Env *outside, const FactWatch *watch)
{
    FactMachine *fm = ARENA_NEW(arena, FactMachine);

    fm->shape = env_shape(arena, m);
    fm->outside = outside;
    fm->begin = arena_array(arena, m->state.n, sizeof *fm->begin);
    fm->window = ARENA_ARRAY(arena, Fact, m->window.n);
    fm->epoch = ARENA_ARRAY(arena, uint32_t, m->var.n);
    fm->stored = ARENA_ARRAY(arena, uint32_t, m->var.n);
    fm->constants = initial(fm, false);
    if (m->sample)
        facts_flow(fm, m->sample, fm->constants, NULL);
    visit_all(fm, anywhere, watch);
    return fm;
}

FactMachine *facts_of_machine(Arena *arena, const IrMachine *m) { return find_facts(arena, m, true, NULL, NULL); }

FactMachine *facts_from_first_state(Arena *arena, const IrMachine *m, const FactWatch *watch)
{
    return find_facts(arena, m, false, NULL, watch);
}

FactMachine *facts_supposing(Arena *arena, const IrMachine *m, const Env *outside)
{
    return find_facts(arena, m, false, outside, NULL);
}

// ---- results ----

const Env *facts_begin(const FactMachine *fm, size_t state, int block)
{
    const FactBegin *b = &fm->begin[state][block];
    const Env *env = b->found ? b->env : fm->constants;
    const IrMachine *m = fm->shape.m;

    return block == BLOCK_ENTRY ? env_set(&fm->shape, env, m->t, fact_of_cell(SM_U64, 0)) : env;
}

void facts_work_in(FactMachine *fm, Arena *arena)
{
    fm->shape.arena = arena;
    fm->temps = fm->blocks = 0;       // the old tables belong to the previous arena
}

bool facts_reach(const FactMachine *fm, size_t state, int block) { return fm->begin[state][block].found; }
const Env *facts_begin_sample(const FactMachine *fm) { return fm->constants; }
Fact facts_of_window(const FactMachine *fm, uint32_t window) { return fm->window[window]; }
