// SPDX-License-Identifier: Apache-2.0
#include "compiler/analysis/liveness.h"

#include <string.h>

#include "compiler/base/bitset.h"
#include "compiler/base/worklist.h"

typedef VEC(uint32_t) StateNumbers;

// A load or store of a function.  Loads and stores are listed once, because every function is visited several times and most of its
// instructions are neither.
typedef struct Access {
    uint32_t var;
    uint32_t at;                  // index in the list of the block's instructions
    IrBlkRef blk;
    bool store;
} Access;
typedef VEC(Access) Accesses;

struct Liveness {
    Analysis *a;
    size_t words;                 // number of 64-bit words of a set, which has a bit for each IR variable that the machine writes
    uint32_t *bit;                // by IR variable: number of its bit in the sets; IR_NONE: the machine never writes the variable
    uint64_t *read_after_step;    // the set of variables that other code or windows read after each step
    uint64_t **begin[BLOCK_COUNT];    // by state: the set of variables live where the block starts, or would start if it is missing
    StateNumbers *before, *after;     // by state: the states with a transition into the state; the targets of its own transitions
    Accesses *access[BLOCK_COUNT];    // by state: the loads and stores of the state's block, in the order of execution
    size_t blocks;                // the number of basic blocks that `live` has room for
    uint64_t *live;               // by basic block of the current function: the set of variables live at its start
    size_t state;                 // the current state
    BlockKind block;
    void (*report)(Analysis *a, const DeadStore *dead, void *context);    // called for each dead store; NULL while the sets still grow
    void *context;
};

static uint64_t *new_set(Liveness *l) { return ARENA_ARRAY(l->a->arena, uint64_t, l->words); }

// Adds a variable to a set of live variables, whose values are read later.
static void mark_live(Liveness *l, uint64_t *set, uint32_t var)
{
    if (l->bit[var] != IR_NONE)
        bitset_add(set, l->bit[var]);
}

static void merge_set(const Liveness *l, uint64_t *set, const uint64_t *more) { bitset_merge(set, more, l->words); }

// ---- functions ----

// Adds the variables that are live at the end of a step if the next step begins in this block of this state.
static void merge_live_in_next_step(const Liveness *l, uint64_t *set, size_t state, BlockKind block)
{
    merge_set(l, set, l->read_after_step);
    merge_set(l, set, l->begin[block][state]);
}

// Adds the variables that are live after the current function returns without a transition (.exit always returns).
static void merge_live_after_return(const Liveness *l, uint64_t *set)
{
    const StateNumbers *after = &l->after[l->state];

    switch (l->block) {
    case BLOCK_ENTRY: merge_set(l, set, l->begin[BLOCK_STEP][l->state]); break;
    case BLOCK_STEP:  merge_live_in_next_step(l, set, l->state, BLOCK_STEP); break;
    case BLOCK_EXIT:                                  // the target of the transition is unknown: assume all targets
        merge_set(l, set, l->read_after_step);
        for (size_t i = 0; i < after->n; i++)
            merge_set(l, set, l->begin[BLOCK_ENTRY][after->at[i]]);
        break;
    case BLOCK_COUNT: break;
    }
}

static void merge_live_after_jump(const Liveness *l, uint64_t *set, const IrJump *j)
{
    switch (j->kind) {
    case IR_RET: merge_live_after_return(l, set); break;
    case IR_GOTO:
        if (l->a->m->state.at[l->state].block[BLOCK_EXIT])
            merge_set(l, set, l->begin[BLOCK_EXIT][l->state]);
        else
            merge_live_in_next_step(l, set, j->state - 1, BLOCK_ENTRY);
        break;
    case IR_BR: merge_set(l, set, l->live + j->otherwise * l->words); /* fall through */
    case IR_JMP: merge_set(l, set, l->live + j->then * l->words); break;
    }
}

// Computes the variables that are live at the start of each block of the function.  If l->report is set, reports stores to variables that
// are not live.
static void compute_live_variables(Liveness *l, const IrFn *f)
{
    const Accesses *all = &l->access[l->block][l->state];
    size_t n = all->n;

    if (f->blk.n > l->blocks) {
        l->blocks = f->blk.n * 2;
        l->live = ARENA_ARRAY(l->a->arena, uint64_t, l->blocks * l->words);
    }
    for (size_t b = f->blk.n; b-- > 0;) {
        uint64_t *live = l->live + b * l->words;
        memset(live, 0, l->words * sizeof *live);
        merge_live_after_jump(l, live, &f->blk.at[b].jump);
        for (; n > 0 && all->at[n - 1].blk == b; n--) {
            const Access *access = &all->at[n - 1];
            if (!access->store) {
                mark_live(l, live, access->var);
                continue;
            }
            if (l->report && !bitset_has(live, l->bit[access->var])) {
                const IrIns *i = &f->ins.at[f->blk.at[b].ins.at[access->at]];
                const DeadStore dead = {l->state, l->block, f, (IrBlkRef)b, access->at, i};
                l->report(l->a, &dead, l->context);
            }
            bitset_remove(live, l->bit[access->var]);
        }
    }
}

// Updates the set of variables that are live at the start of the state's block.  Returns whether it has changed.
static bool update_live_at_begin(Liveness *l, BlockKind block)
{
    const IrFn *f = l->a->m->state.at[l->state].block[block];
    uint64_t *begin = l->begin[block][l->state];
    const size_t size = l->words * sizeof *begin;
    bool changed;

    l->block = block;
    if (f) {
        compute_live_variables(l, f);
    } else {
        memcpy(l->live, begin, size);
        merge_live_after_return(l, l->live);
    }
    changed = memcmp(begin, l->live, size) != 0;
    memcpy(begin, l->live, size);
    return changed;
}

// ---- the iteration ----

// Computes `begin` of all states.  Variables that are live at the start of .step are also live where .step returns, because .step runs
// again.  Passing that set backward through .step adds no further variables, so one visit of .step is enough.
static void compute_live_at_begins(Liveness *l)
{
    Worklist queue = worklist_new(l->a->arena, l->a->m->state.n);

    for (size_t s = l->a->m->state.n; s-- > 0;)
        worklist_add(&queue, (uint32_t)s);
    while (queue.n > 0) {
        l->state = worklist_next(&queue);
        update_live_at_begin(l, BLOCK_EXIT);
        update_live_at_begin(l, BLOCK_STEP);
        if (update_live_at_begin(l, BLOCK_ENTRY))
            for (size_t i = 0; i < l->before[l->state].n; i++)
                worklist_add(&queue, l->before[l->state].at[i]);
    }
}

// ---- preparation ----

// Assigns a bit of the sets to each variable that the machine writes.
static void assign_bits_to_variables(Liveness *l)
{
    const IrMachine *m = l->a->m;
    uint32_t n = 0;

    l->bit = ARENA_ARRAY(l->a->arena, uint32_t, m->var.n);
    for (size_t v = 0; v < m->var.n; v++)
        l->bit[v] = m->var.at[v].writable ? n++ : IR_NONE;
    l->words = bitset_words(n);
}

static void find_read_after_step(Liveness *l)
{
    const IrMachine *m = l->a->m;

    l->read_after_step = new_set(l);
    for (uint32_t v = 0; v < m->var.n; v++)
        if (m->var.at[v].space != IR_LOCAL)
            mark_live(l, l->read_after_step, v);
    for (size_t i = 0; m->sample && i < m->sample->ins.n; i++)
        if (m->sample->ins.at[i].op == IR_load)
            mark_live(l, l->read_after_step, m->sample->ins.at[i].var);
}

static void list_accesses(Liveness *l, const IrFn *f, Accesses *out)
{
    for (size_t b = 0; b < f->blk.n; b++)
        for (size_t k = 0; k < f->blk.at[b].ins.n; k++) {
            const IrIns *i = &f->ins.at[f->blk.at[b].ins.at[k]];
            const Access access = {i->var, (uint32_t)k, (IrBlkRef)b, i->op == IR_store};
            if (i->op == IR_store || (i->op == IR_load && l->bit[i->var] != IR_NONE))
                vec_push(l->a->arena, out, access);
        }
}

static void list_adjacent_states(Liveness *l)
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
    assign_bits_to_variables(l);
    l->blocks = 1;
    l->live = new_set(l);
    find_read_after_step(l);
    list_adjacent_states(l);
    for (int b = 0; b < BLOCK_COUNT; b++) {
        l->begin[b] = ARENA_ARRAY(a->arena, uint64_t *, states);
        l->access[b] = arena_array(a->arena, states, sizeof *l->access[b]);
        for (size_t s = 0; s < states; s++) {
            l->begin[b][s] = new_set(l);
            if (a->m->state.at[s].block[b])
                list_accesses(l, a->m->state.at[s].block[b], &l->access[b][s]);
        }
    }
    compute_live_at_begins(l);
    return l;
}

// Calls f for each store whose value is never read.
void each_dead_store(Liveness *l, void (*f)(Analysis *a, const DeadStore *dead, void *context), void *context)
{
    l->report = f;
    l->context = context;
    for (l->state = 0; l->state < l->a->m->state.n; l->state++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            if (l->a->m->state.at[l->state].block[b] && facts_may_reach(l->a->facts, l->state, b))
                update_live_at_begin(l, (BlockKind)b);
    l->report = NULL;
}
