// SPDX-License-Identifier: Apache-2.0
// Reports assignments without a visible effect: of a variable to itself, or of a value that is overwritten on every path before it is read.
#include "compiler/analysis/liveness.h"

// Limits of the search for the overwriting assignment: the most states in one search, and the most basic blocks in all searches together.
enum { STATES_MAX = 100, BLOCKS_MAX = 10000000 };

typedef struct DeadStores {
    Analysis *a;
    size_t *first;                // by state: index of the state's first transition in Analysis.transition; the last entry is the list's length
    uint32_t *seen, searches;     // by state: number of the last search that visited the state; number of searches so far
    uint32_t *walked, walks;      // by block of a function: number of the last walk that reached the block; number of walks so far
    size_t work;                  // blocks that may still be walked
} DeadStores;

// ---- assignments of a variable to itself ----

static bool is_self_assignment(const Stmt *stmt)
{
    return stmt->kind == ST_ASSIGN && stmt->operators == 0 && stmt->value->kind == EX_VAR && stmt->value->var == stmt->var;
}

static void check_self_assignment(const Stmt *stmt, void *context)
{
    const Analysis *a = context;

    if (is_self_assignment(stmt))
        diag_report(a->diags, DIAG_self_assignment, stmt->span, stmt->var->name->text);
}

// Returns the last statement of a list whose number is at most `number`; the first statement if all numbers are higher.
static const Stmt *find_last_stmt_up_to(const Stmts *list, uint32_t number)
{
    size_t low = 0, high = list->n;

    while (high - low > 1) {
        const size_t middle = low + (high - low) / 2;
        if (list->at[middle]->number <= number)
            low = middle;
        else
            high = middle;
    }
    return list->at[low];
}

// Returns the statement with that number, in `block` or nested in it.  Statements are numbered in file order.
static const Stmt *find_stmt(const Stmts *block, uint32_t number)
{
    const Stmt *stmt = find_last_stmt_up_to(block, number);

    while (stmt->number != number) {
        const Stmts *no = &stmt->otherwise;
        stmt = find_last_stmt_up_to(no->n && no->at[0]->number <= number ? no : &stmt->then, number);
    }
    return stmt;
}

// ---- the overwriting store ----

// Returns the first store to var at or after ins.at[at] of block blk; NULL if the block has no such store.
static const IrIns *find_store_in_block(const IrFn *f, size_t blk, size_t at, uint32_t var)
{
    for (size_t k = at; k < f->blk.at[blk].ins.n; k++) {
        const IrIns *i = &f->ins.at[f->blk.at[blk].ins.at[k]];
        if (i->op == IR_store && i->var == var)
            return i;
    }
    return NULL;
}

// Returns the first store to var in f that can be reached from ins.at[at] of block blk; NULL if no store can be reached.
static const IrIns *find_store_after(DeadStores *k, const IrFn *f, IrBlkRef blk, size_t at, uint32_t var)
{
    const IrIns *found = NULL;

    k->walked[blk] = ++k->walks;
    for (size_t b = blk; b < f->blk.n && !found && k->work > 0; b++, k->work--) {
        const IrJump *j = &f->blk.at[b].jump;
        if (k->walked[b] != k->walks)
            continue;
        found = find_store_in_block(f, b, b == blk ? at : 0, var);
        if (j->kind == IR_BR || j->kind == IR_JMP)
            k->walked[j->then] = k->walks;
        if (j->kind == IR_BR)
            k->walked[j->otherwise] = k->walks;
    }
    return found;
}

// Returns the first store to var in the state's functions from `block` (such as BLOCK_STEP) on; NULL if these functions have no such store.
static const IrIns *find_store_in_state(DeadStores *k, size_t state, int block, uint32_t var)
{
    const IrIns *found = NULL;

    for (; block < BLOCK_COUNT && !found; block++)
        if (k->a->m->state.at[state].block[block])
            found = find_store_after(k, k->a->m->state.at[state].block[block], 0, 0, var);
    return found;
}

// The states that a search visits, each once, in order.
typedef struct StateQueue { size_t state[STATES_MAX], n; } StateQueue;

// Adds a state to the queue of the search, unless the search has visited it or the queue is full.
static void enqueue_state(DeadStores *k, StateQueue *q, size_t state)
{
    if (q->n < STATES_MAX && k->seen[state] != k->searches)
        q->state[q->n++] = state;
    k->seen[state] = k->searches;
}

// Adds the states that can follow state `from`.
static void enqueue_next_states(DeadStores *k, StateQueue *q, size_t from)
{
    for (size_t t = k->first[from]; t < k->first[from + 1]; t++)
        enqueue_state(k, q, k->a->transition.at[t].to->number - 1);
}

// Adds to the queue the target states of transitions that can be reached from block blk of f.  Returns whether the end of f can also be
// reached.
static bool enqueue_targets_and_check_return(DeadStores *k, const IrFn *f, IrBlkRef blk, StateQueue *q)
{
    bool returns = false;

    k->walked[blk] = ++k->walks;
    for (size_t b = blk; b < f->blk.n && k->work > 0; b++, k->work--) {
        const IrJump *j = &f->blk.at[b].jump;
        if (k->walked[b] != k->walks)
            continue;
        if (j->kind == IR_BR || j->kind == IR_JMP)
            k->walked[j->then] = k->walks;
        if (j->kind == IR_BR)
            k->walked[j->otherwise] = k->walks;
        if (j->kind == IR_GOTO)
            enqueue_state(k, q, j->state - 1);
        returns |= j->kind == IR_RET;
    }
    return returns;
}

typedef enum OverwriteTime { IN_SAME_STEP, IN_NEXT_STEP, IN_LATER_STATE } OverwriteTime;
typedef struct Overwrite { const IrIns *store; OverwriteTime when; size_t state; } Overwrite;      // state: index of the state that contains `store`

// Finds the store that overwrites a dead one: for an element, in the same step; for a local, also later.  `store` is NULL if the
// variable is never stored again.
static Overwrite find_overwrite(DeadStores *k, const DeadStore *dead)
{
    const uint32_t var = dead->store->var;
    Overwrite o = {NULL, IN_SAME_STEP, dead->state};
    StateQueue q = {.n = 0};
    bool stays;

    k->searches++;
    stays = enqueue_targets_and_check_return(k, dead->f, dead->blk, &q) && dead->block != BLOCK_EXIT;
    o.store = find_store_after(k, dead->f, dead->blk, dead->at + 1, var);
    if (!o.store && dead->block == BLOCK_ENTRY)
        o.store = find_store_in_state(k, dead->state, BLOCK_STEP, var);
    if (!o.store && dead->block == BLOCK_STEP && q.n > 0)     // .exit belongs to the same step if that step leaves the state
        o.store = find_store_in_state(k, dead->state, BLOCK_EXIT, var);
    if (o.store || k->a->m->var.at[var].space != IR_LOCAL)
        return o;
    o.when = IN_NEXT_STEP;
    if (stays)
        o.store = find_store_in_state(k, dead->state, BLOCK_STEP, var);
    if (o.store)
        return o;
    o.when = IN_LATER_STATE;
    if (stays || dead->block == BLOCK_EXIT)
        enqueue_next_states(k, &q, dead->state);
    for (size_t i = 0; i < q.n && !o.store; i++) {
        o.state = q.state[i];
        o.store = find_store_in_state(k, o.state, BLOCK_ENTRY, var);
        enqueue_next_states(k, &q, o.state);
    }
    return o;
}

// Whether every path from ins.at[at] of block blk on stores var, in f or after f returns.  `after`: whether every path stores var after f returns.
static bool is_always_stored(DeadStores *k, const IrFn *f, IrBlkRef blk, size_t at, uint32_t var, bool after)
{
    const uint32_t yes = ++k->walks;

    for (size_t b = f->blk.n; b-- > blk && k->work > 0; k->work--) {
        const IrJump *j = &f->blk.at[b].jump;
        const bool both = j->kind == IR_JMP || (j->kind == IR_BR && k->walked[j->otherwise] == yes);
        const bool later = j->kind == IR_RET ? after : both && k->walked[j->then] == yes;
        k->walked[b] = later || find_store_in_block(f, b, b == blk ? at : 0, var) ? yes : 0;
    }
    return k->walked[blk] == yes;
}

// Whether a dead store initialises an output: it sets the output to a constant in .entry, and not every path through the rest of .entry and
// .step stores to the output again.
static bool is_initialisation(DeadStores *k, const DeadStore *dead, const Stmt *stmt)
{
    const IrFn *step = k->a->m->state.at[dead->state].block[BLOCK_STEP];
    const uint32_t var = dead->store->var;
    bool after;

    if (dead->block != BLOCK_ENTRY || stmt->var->kind != VAR_ELEMENT || !expr_is_constant(stmt->value))
        return false;
    after = step && is_always_stored(k, step, 0, 0, var, false);
    return !is_always_stored(k, dead->f, dead->blk, dead->at + 1, var, after);
}

static void report_dead_store(Analysis *a, const DeadStore *dead, void *context)
{
    DeadStores *k = context;
    const Stmt *stmt = find_stmt(&a->p->state.at[dead->state]->block[dead->block], dead->store->stmt);
    const Var *v = stmt->var;
    Overwrite other;
    Diag *d;

    if (!a->stmt[stmt->number].reached || is_self_assignment(stmt) || (v->kind == VAR_LOCAL && !v->read))
        return;
    if (is_initialisation(k, dead, stmt) || (other = find_overwrite(k, dead)).store == NULL)
        return;
    d = diag_report(a->diags, DIAG_dead_store, stmt->span, v->name->text);
    if (other.store->stmt == dead->store->stmt)
        diag_note(a->diags, d, (Span){NULL, 0, 0}, DIAG_note_overwritten_by_itself);
    else if (other.when == IN_NEXT_STEP)
        diag_note(a->diags, d, other.store->span, DIAG_note_overwritten_next_step);
    else if (other.when == IN_LATER_STATE)
        diag_note(a->diags, d, other.store->span, DIAG_note_overwritten_later, a->p->state.at[other.state]->name->text);
    else
        diag_note(a->diags, d, other.store->span, DIAG_note_overwritten_here);
}

void analyse_dead_store(Analysis *a)
{
    DeadStores k = {.a = a, .work = BLOCKS_MAX};
    size_t most = 1;              // the number of blocks of the largest function

    for (size_t s = 0; s < a->m->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            if (a->m->state.at[s].block[b] && a->m->state.at[s].block[b]->blk.n > most)
                most = a->m->state.at[s].block[b]->blk.n;
    k.first = transitions_by_state(a->arena, a->p, &a->transition);
    k.seen = ARENA_ARRAY(a->arena, uint32_t, a->m->state.n);
    k.walked = ARENA_ARRAY(a->arena, uint32_t, most);
    each_stmt(a->p, check_self_assignment, a);
    each_dead_store(liveness_of(a), report_dead_store, &k);
}
