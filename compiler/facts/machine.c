// SPDX-License-Identifier: Apache-2.0
// Facts of a machine: what its locals can hold when each function begins, found by following transitions until nothing is added.
// Bounds that keep growing are widened, so this ends after a few visits of each state.
#include "compiler/facts/facts.h"

enum { PATIENCE = 3, ENOUGH = 20 };   // changes after which bounds are widened; after which no more is claimed than is constant

// States that wait for a visit, in a ring.
typedef struct Queue {
    uint32_t *at;
    bool *waits;                      // by state
    size_t first, n, size;
} Queue;

typedef struct Visit {
    FactMachine *fm;
    Queue queue;
    uint32_t state;                   // the one that is looked at
    int block;
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

// ---- ways into functions ----

static const Env *with_more(const FactMachine *fm, const FactBegin *b, const Env *env)
{
    if (!b->found)
        return env;
    return b->changes > ENOUGH ? fm->constants : env_join(&fm->shape, b->env, env, b->changes > PATIENCE);
}

static void arrive(Visit *v, uint32_t state, int block, const Env *env)
{
    FactBegin *b = &v->fm->begin[state][block];
    const Env *now = with_more(v->fm, b, env);

    if (b->found && now == b->env)
        return;
    b->env = now;
    b->found = b->dirty = true;
    b->changes++;
    enqueue(&v->queue, state);
}

static void arrive_at_targets(Visit *v, const IrFn *f, const Env *env)
{
    for (size_t b = 0; f && b < f->blk.n; b++)
        if (f->blk.at[b].jump.kind == IR_GOTO)
            arrive(v, f->blk.at[b].jump.state - 1, BLOCK_ENTRY, env);
}

// The function that is looked at ends; elements are others' from now on.
static void end_of_function(void *context, const IrJump *end, const Env *env)
{
    Visit *v = context;
    const IrState *s = &v->fm->shape.m->state.at[v->state];

    env = env_private(&v->fm->shape, env);
    if (v->block == BLOCK_EXIT) {
        arrive_at_targets(v, s->block[BLOCK_ENTRY], env);
        arrive_at_targets(v, s->block[BLOCK_STEP], env);
    } else {
        arrive(v, v->state, end->kind == IR_GOTO ? BLOCK_EXIT : BLOCK_STEP, env);
    }
}

// ---- visits ----

static void look_at_function(Visit *v, int block)
{
    static const IrJump nothing = {IR_RET, IR_NONE, IR_NONE, IR_NONE, 0, {0}};
    const FactEnds ends = {end_of_function, v};
    const IrFn *f = v->fm->shape.m->state.at[v->state].block[block];
    FactBegin *b = &v->fm->begin[v->state][block];

    if (!b->dirty)
        return;
    b->dirty = false;
    v->block = block;
    if (f)
        facts_flow(v->fm, f, facts_begin(v->fm, v->state, block), &ends);
    else
        end_of_function(v, &nothing, b->env);
}

static void visit_states(Visit *v)
{
    while (v->queue.n > 0) {
        v->state = dequeue(&v->queue);
        for (int block = 0; block < BLOCK_COUNT; block++)
            look_at_function(v, block);
    }
}

static const Env *initial(const EnvShape *s, bool writable_too)
{
    const Env *env = NULL;

    for (uint32_t v = 0; v < s->m->var.n; v++) {
        const IrVar *var = &s->m->var.at[v];
        if (env_is_private(var) && (writable_too || !var->writable))
            env = env_set(s, env, v, fact_convert(fact_of_cell(var->type, var->init), var->type));
    }
    return env;
}

static void visit_all(FactMachine *fm)
{
    const IrMachine *m = fm->shape.m;
    const Env *env = initial(&fm->shape, true);
    Visit v = {fm, {NULL, NULL, 0, 0, m->state.n}, 0, 0};

    v.queue.at = ARENA_ARRAY(fm->shape.arena, uint32_t, m->state.n);
    v.queue.waits = ARENA_ARRAY(fm->shape.arena, bool, m->state.n);
    for (uint32_t s = 0; s < m->state.n; s++)         // a machine may be started in any
        arrive(&v, s, BLOCK_ENTRY, env);
    visit_states(&v);
}

FactMachine *facts_of_machine(Arena *arena, const IrMachine *m)
{
    FactMachine *fm = ARENA_NEW(arena, FactMachine);

    fm->shape = env_shape(arena, m);
    fm->begin = arena_array(arena, m->state.n, sizeof *fm->begin);
    fm->window = ARENA_ARRAY(arena, Fact, m->window.n);
    fm->epoch = ARENA_ARRAY(arena, uint32_t, m->var.n);
    fm->stored = ARENA_ARRAY(arena, uint32_t, m->var.n);
    fm->constants = initial(&fm->shape, false);
    if (m->sample)
        facts_flow(fm, m->sample, fm->constants, NULL);
    visit_all(fm);
    return fm;
}

// ---- answers ----

const Env *facts_begin(const FactMachine *fm, size_t state, int block)
{
    const FactBegin *b = &fm->begin[state][block];
    const Env *env = b->found ? b->env : fm->constants;
    const IrMachine *m = fm->shape.m;

    return block == BLOCK_ENTRY ? env_set(&fm->shape, env, m->t, fact_of_cell(SM_U64, 0)) : env;
}

const Env *facts_begin_sample(const FactMachine *fm) { return fm->constants; }
Fact facts_of_window(const FactMachine *fm, uint32_t window) { return fm->window[window]; }
