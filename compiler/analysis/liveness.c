// SPDX-License-Identifier: Apache-2.0
#include "compiler/analysis/liveness.h"

#include <string.h>

typedef uint64_t Word;
enum { WORD_BITS = 64 };

typedef VEC(uint32_t) Numbers;

// A load or store of a function.  Every function is visited several times, and only a fifth of its IR are accesses.
typedef struct Access {
    uint32_t var;
    uint32_t at;                  // index in its block's list
    IrBlkRef blk;
    bool store;
} Access;
typedef VEC(Access) Accesses;

struct Liveness {
    Analysis *a;
    size_t words;                 // words of a set: one bit for each variable of the IR that is written
    uint32_t *bit;                // by IrVar; IR_NONE: it is never written
    Word *shown;                  // read at the end of each step
    Word **begin[BLOCK_COUNT];    // by state: what is live at the start of the block; for a missing block, where it would start
    Numbers *before, *after;      // by state: the states that lead to it, and those that it leads to
    Accesses *access[BLOCK_COUNT];    // by state, in order
    size_t blocks;                // the number of blocks that `end` has room for
    Word *end;                    // by block of the current function: what is live at its start
    uint32_t *queue;              // states to visit
    bool *waits;
    size_t head, waiting;
    size_t state;                 // the current state
    BlockKind block;
    void (*dead)(Analysis *a, const DeadStore *dead, void *context);
    void *context;
};

// ---- sets ----

static Word *new_set(Liveness *l) { return ARENA_ARRAY(l->a->arena, Word, l->words); }

static void put(Liveness *l, Word *set, uint32_t var)
{
    if (l->bit[var] != IR_NONE)
        set[l->bit[var] / WORD_BITS] |= (Word)1 << l->bit[var] % WORD_BITS;
}

static bool has(const Liveness *l, const Word *set, uint32_t var)
{
    return l->bit[var] == IR_NONE || (set[l->bit[var] / WORD_BITS] >> l->bit[var] % WORD_BITS & 1) != 0;
}

static void take(const Liveness *l, Word *set, uint32_t var)
{
    set[l->bit[var] / WORD_BITS] &= ~((Word)1 << l->bit[var] % WORD_BITS);
}

static void add(const Liveness *l, Word *set, const Word *more)
{
    for (size_t w = 0; w < l->words; w++)
        set[w] |= more[w];
}

// Returns true if the set changed.
static bool assign(const Liveness *l, Word *set, const Word *now)
{
    const bool changed = memcmp(set, now, l->words * sizeof *set) != 0;

    memcpy(set, now, l->words * sizeof *set);
    return changed;
}

// ---- functions ----

static void add_next_step(const Liveness *l, Word *set, size_t state, BlockKind block)
{
    add(l, set, l->shown);
    add(l, set, l->begin[block][state]);
}

// .exit does not know the target of the transition.
static void add_after_exit(const Liveness *l, Word *set)
{
    const Numbers *after = &l->after[l->state];

    add(l, set, l->shown);
    for (size_t i = 0; i < after->n; i++)
        add(l, set, l->begin[BLOCK_ENTRY][after->at[i]]);
}

static void add_after_return(const Liveness *l, Word *set)
{
    switch (l->block) {
    case BLOCK_ENTRY: add(l, set, l->begin[BLOCK_STEP][l->state]); break;
    case BLOCK_STEP:  add_next_step(l, set, l->state, BLOCK_STEP); break;
    case BLOCK_EXIT:  add_after_exit(l, set); break;
    case BLOCK_COUNT: break;
    }
}

static void add_after_goto(const Liveness *l, Word *set, uint32_t target)
{
    if (l->a->m->state.at[l->state].block[BLOCK_EXIT])
        add(l, set, l->begin[BLOCK_EXIT][l->state]);
    else
        add_next_step(l, set, target - 1, BLOCK_ENTRY);
}

static void add_after(const Liveness *l, Word *set, const IrJump *j)
{
    switch (j->kind) {
    case IR_RET:  add_after_return(l, set); break;
    case IR_GOTO: add_after_goto(l, set, j->state); break;
    case IR_BR:   add(l, set, l->end + j->otherwise * l->words); /* fall through */
    case IR_JMP:  add(l, set, l->end + j->then * l->words); break;
    }
}

static void look_at_store(Liveness *l, const IrFn *f, const Access *store, Word *live)
{
    if (l->dead && !has(l, live, store->var)) {
        const IrIns *i = &f->ins.at[f->blk.at[store->blk].ins.at[store->at]];
        const DeadStore dead = {l->state, l->block, f, store->blk, store->at, i};
        l->dead(l->a, &dead, l->context);
    }
    take(l, live, store->var);
}

// Returns what is live at the start of the function.
static const Word *look_at_function(Liveness *l, const IrFn *f)
{
    const Accesses *all = &l->access[l->block][l->state];
    size_t n = all->n;

    if (f->blk.n > l->blocks) {
        l->blocks = f->blk.n * 2;
        l->end = ARENA_ARRAY(l->a->arena, Word, l->blocks * l->words);
    }
    for (size_t b = f->blk.n; b-- > 0;) {
        const IrBlk *blk = &f->blk.at[b];
        Word *live = l->end + b * l->words;
        memset(live, 0, l->words * sizeof *live);
        add_after(l, live, &blk->jump);
        for (; n > 0 && all->at[n - 1].blk == b; n--)
            if (all->at[n - 1].store)
                look_at_store(l, f, &all->at[n - 1], live);
            else
                put(l, live, all->at[n - 1].var);
    }
    return l->end;
}

static bool look_at_block(Liveness *l, BlockKind block)
{
    const IrFn *f = l->a->m->state.at[l->state].block[block];
    Word *begin = l->begin[block][l->state];

    l->block = block;
    if (f)
        return assign(l, begin, look_at_function(l, f));
    memcpy(l->end, begin, l->words * sizeof *begin);
    add_after_return(l, l->end);
    return assign(l, begin, l->end);
}

// ---- states ----

static void enqueue(Liveness *l, uint32_t state)
{
    const size_t n = l->a->m->state.n;

    if (l->waits[state])
        return;
    l->waits[state] = true;
    l->queue[(l->head + l->waiting++) % n] = state;
}

static uint32_t dequeue(Liveness *l)
{
    const uint32_t state = l->queue[l->head];

    l->head = (l->head + 1) % l->a->m->state.n;
    l->waiting--;
    l->waits[state] = false;
    return state;
}

// What is live at the start of .step is also live where it returns.  That adds nothing to what is live at its start.
static void look_at_state(Liveness *l)
{
    look_at_block(l, BLOCK_EXIT);
    look_at_block(l, BLOCK_STEP);
    if (look_at_block(l, BLOCK_ENTRY))
        for (size_t i = 0; i < l->before[l->state].n; i++)
            enqueue(l, l->before[l->state].at[i]);
}

static void look_at_all(Liveness *l)
{
    for (size_t s = l->a->m->state.n; s-- > 0;)
        enqueue(l, (uint32_t)s);
    while (l->waiting > 0) {
        l->state = dequeue(l);
        look_at_state(l);
    }
}

// ---- entry points ----

static void number_variables(Liveness *l)
{
    const IrMachine *m = l->a->m;
    uint32_t n = 0;

    l->bit = ARENA_ARRAY(l->a->arena, uint32_t, m->var.n);
    for (size_t v = 0; v < m->var.n; v++)
        l->bit[v] = m->var.at[v].writable ? n++ : IR_NONE;
    l->words = n / WORD_BITS + 1;
}

static void note_shown(Liveness *l)
{
    const IrMachine *m = l->a->m;

    l->shown = new_set(l);
    for (uint32_t v = 0; v < m->var.n; v++)
        if (m->var.at[v].space != IR_LOCAL)
            put(l, l->shown, v);
    for (size_t i = 0; m->sample && i < m->sample->ins.n; i++)
        if (m->sample->ins.at[i].op == IR_load)
            put(l, l->shown, m->sample->ins.at[i].var);
}

static void note_accesses_of(Liveness *l, const IrFn *f, Accesses *out)
{
    for (size_t b = 0; b < f->blk.n; b++)
        for (size_t k = 0; k < f->blk.at[b].ins.n; k++) {
            const IrIns *i = &f->ins.at[f->blk.at[b].ins.at[k]];
            const Access access = {i->var, (uint32_t)k, (IrBlkRef)b, i->op == IR_store};
            if (i->op == IR_store || (i->op == IR_load && l->bit[i->var] != IR_NONE))
                vec_push(l->a->arena, out, access);
        }
}

static void note_accesses(Liveness *l)
{
    const IrMachine *m = l->a->m;

    for (int b = 0; b < BLOCK_COUNT; b++)
        l->access[b] = arena_array(l->a->arena, m->state.n, sizeof *l->access[b]);
    for (size_t s = 0; s < m->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            if (m->state.at[s].block[b])
                note_accesses_of(l, m->state.at[s].block[b], &l->access[b][s]);
}

static void note_ways(Liveness *l)
{
    const Transitions *t = &l->a->transition;

    l->before = arena_array(l->a->arena, l->a->m->state.n, sizeof *l->before);
    l->after = arena_array(l->a->arena, l->a->m->state.n, sizeof *l->after);
    for (size_t i = 0; i < t->n; i++) {
        vec_push(l->a->arena, &l->before[t->at[i].to->number - 1], t->at[i].from->number - 1);
        vec_push(l->a->arena, &l->after[t->at[i].from->number - 1], t->at[i].to->number - 1);
    }
}

Liveness *liveness_of(Analysis *a)
{
    Liveness *l = ARENA_NEW(a->arena, Liveness);
    const size_t states = a->m->state.n;

    l->a = a;
    number_variables(l);
    l->blocks = 1;
    l->end = new_set(l);
    note_shown(l);
    note_ways(l);
    note_accesses(l);
    for (int b = 0; b < BLOCK_COUNT; b++) {
        l->begin[b] = ARENA_ARRAY(a->arena, Word *, states);
        for (size_t s = 0; s < states; s++)
            l->begin[b][s] = new_set(l);
    }
    l->queue = ARENA_ARRAY(a->arena, uint32_t, states);
    l->waits = ARENA_ARRAY(a->arena, bool, states);
    look_at_all(l);
    return l;
}

void each_dead_store(Liveness *l, void (*f)(Analysis *a, const DeadStore *dead, void *context), void *context)
{
    l->dead = f;
    l->context = context;
    for (l->state = 0; l->state < l->a->m->state.n; l->state++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            if (l->a->m->state.at[l->state].block[b] && facts_may_reach(l->a->facts, l->state, b))
                look_at_block(l, (BlockKind)b);
    l->dead = NULL;
}
