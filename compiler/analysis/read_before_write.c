// SPDX-License-Identifier: Apache-2.0
// Reports locals that are read before any store to them can have been executed, although a later state stores to them: probably the
// store was intended to come first.
//
// Three kinds of reads are intended.  An initial value other than 0 was chosen by the author, so its read is reported only if it
// decides a guard.  A plain copy (shown = phase) publishes the current value.  A counter reads the variable that it assigns.
#include <string.h>

#include "compiler/analysis/analysis.h"
#include "compiler/base/bitset.h"
#include "compiler/base/worklist.h"
#include "stdlib/convert.h"

enum { STATES_MAX = 1000 };     // limit of the search for the later store

typedef VEC(const State *) States;

typedef struct StoreOrder {
    Analysis *a;
    uint32_t *bit;                // by Var.index: number of the variable's bit in the sets; IR_NONE: it is not checked
    size_t words;                 // number of words of a set of locals
    uint64_t *stored[BLOCK_COUNT];    // by state: the set of locals that the state's block may store
    uint64_t *before, *after;     // by state: the set of locals that may have been stored when the state begins; the set that later states may store
    const States *next;           // by State.number: the targets of the state's transitions
    uint64_t *here;               // the set of locals that may have been stored when the current statement is executed
    bool *reported;               // by Var.index: a read of the local before any store has been reported
    uint32_t *seen, searches;     // by State.number: number of the last search that visited the state; number of searches so far
    const State *state;           // the current state
    BlockKind block;
} StoreOrder;

static uint64_t *set_of_state(const StoreOrder *o, uint64_t *sets, const State *s) { return sets + (s->number - 1) * o->words; }

// ---- what is stored where ----

// Assigns a bit of the sets to each local that is both read and written. Returns whether the machine has such a local.
static bool assign_bits_to_locals(StoreOrder *o)
{
    const Program *p = o->a->p;
    uint32_t n = 0;

    o->bit = ARENA_ARRAY(o->a->arena, uint32_t, p->var.n);
    for (size_t i = 0; i < p->var.n; i++) {
        const Var *v = p->var.at[i];
        o->bit[i] = v->kind == VAR_LOCAL && v->written && v->read ? n++ : IR_NONE;
    }
    o->words = bitset_words(n);
    return n > 0;
}

// Adds to the set the locals that these statements may store.
static void add_stores(StoreOrder *o, const Stmts *stmts, uint64_t *set)
{
    for (size_t i = 0; i < stmts->n; i++) {
        const Stmt *stmt = stmts->at[i];
        if (stmt->kind == ST_ASSIGN && o->bit[stmt->var->index] != IR_NONE && o->a->stmt[stmt->number].reached)
            bitset_add(set, o->bit[stmt->var->index]);
        add_stores(o, &stmt->then, set);
        add_stores(o, &stmt->otherwise, set);
    }
}

// Returns, for each state, the set of locals that its direct and indirect predecessors may store; with `backwards`, its successors.
static uint64_t *propagate_stores(StoreOrder *o, bool backwards)
{
    const Analysis *a = o->a;
    State *const *state = a->p->state.at;
    const size_t n = a->p->state.n;
    uint64_t *sets = ARENA_ARRAY(a->arena, uint64_t, o->words * n);
    States *next = arena_array(a->arena, n + 1, sizeof *next);    // next[State.number]: the states to which this state's set propagates
    Worklist queue = worklist_new(a->arena, n);

    for (size_t i = 0; i < a->transition.n; i++) {
        const Transition *t = &a->transition.at[i];
        if (a->stmt[t->stmt->number].reached)
            vec_push(a->arena, &next[(backwards ? t->to : t->from)->number], backwards ? t->from : t->to);
    }
    for (uint32_t s = 0; s < n; s++)                          // transitions mostly follow the order of the file
        worklist_add(&queue, backwards ? (uint32_t)n - 1 - s : s);
    while (queue.n > 0) {
        const State *from = state[worklist_next(&queue)];
        for (size_t i = 0; i < next[from->number].n; i++) {
            const State *to = next[from->number].at[i];
            bool grew = bitset_merge(set_of_state(o, sets, to), set_of_state(o, sets, from), o->words);
            for (int b = 0; b < BLOCK_COUNT; b++)
                grew |= bitset_merge(set_of_state(o, sets, to), set_of_state(o, o->stored[b], from), o->words);
            if (grew)
                worklist_add(&queue, to->number - 1);
        }
    }
    if (!backwards)
        o->next = next;
    return sets;
}

// ---- reports ----

// Returns the first assignment to the variable in these statements; NULL: none.
static const Stmt *find_store(const Stmts *stmts, const Var *v)
{
    const Stmt *found = NULL;

    for (size_t i = 0; i < stmts->n && !found; i++) {
        const Stmt *stmt = stmts->at[i];
        found = stmt->kind == ST_ASSIGN && stmt->var == v ? stmt : find_store(&stmt->then, v);
        if (!found)
            found = find_store(&stmt->otherwise, v);
    }
    return found;
}

// Finds the store in the nearest state after the current one, or in the .exit of the current one.  Returns NULL if neither has such a store.
static const Stmt *find_later_store(StoreOrder *o, const Var *v, const State **later)
{
    const Analysis *a = o->a;
    const Stmt *found = find_store(&o->state->block[BLOCK_EXIT], v);
    States queue = {NULL, 0, 0};

    *later = o->state;
    o->searches++;
    vec_push(a->arena, &queue, o->state);
    for (size_t i = 0; i < queue.n && i < STATES_MAX && !found; i++) {
        for (size_t t = 0; t < o->next[queue.at[i]->number].n; t++) {
            const State *to = o->next[queue.at[i]->number].at[t];
            if (o->seen[to->number] != o->searches)
                vec_push(a->arena, &queue, to);
            o->seen[to->number] = o->searches;
        }
        if (i + 1 < queue.n)
            *later = queue.at[i + 1];
        for (int b = 0; i + 1 < queue.n && b < BLOCK_COUNT && !found; b++)
            found = find_store(&queue.at[i + 1]->block[b], v);
    }
    return found;
}

// Reports that e reads a local before its first store.  Does not report it if no later store is found.
static void report_early_read(StoreOrder *o, const Expr *e)
{
    const Var *v = e->var;
    const State *later;
    const Stmt *store = find_later_store(o, v, &later);
    const char *initial;
    Diag *d;

    o->reported[v->index] = true;
    if (!store)
        return;
    initial = v->type == SM_BOOL ? v->init ? "true" : "false" : const_text(o->a->arena, sm_cell_to_f64(v->type, v->init));
    d = diag_report(o->a->diags, DIAG_read_before_write, e->span, v->name->text, initial, later->name->text);
    diag_note(o->a->diags, d, store->span, DIAG_note_written_here);
}

// ---- reads ----

// Reports reads in e of locals that cannot have been stored yet but are stored later: in a later state, or in the .exit of this state.
// Ignores reads by windows, which take their samples in every state, so that the order of states does not matter.
static void check_reads(StoreOrder *o, const Stmt *stmt, const Expr *e)
{
    const StmtFact *f = &o->a->stmt[stmt->number];
    uint32_t bit;

    if (e->kind == EX_ROLL)
        return;
    for (uint32_t i = 0; i < e->n; i++)
        check_reads(o, stmt, e->arg[i]);
    if (e->kind != EX_VAR || o->bit[e->var->index] == IR_NONE || o->reported[e->var->index] || stmt->var == e->var)
        return;
    if (e->var->init != 0 && !(stmt->kind == ST_IF && (!f->then || !f->otherwise)))           // the author chose the initial value
        return;
    bit = o->bit[e->var->index];
    if (bitset_has(o->here, bit))
        return;
    if (bitset_has(set_of_state(o, o->after, o->state), bit)
        || (o->block != BLOCK_EXIT && bitset_has(set_of_state(o, o->stored[BLOCK_EXIT], o->state), bit)))
        report_early_read(o, e);
}

// Checks statements in their order, and adds the locals that they store to o->here.
static void check_stmts(StoreOrder *o, const Stmts *stmts)
{
    for (size_t i = 0; i < stmts->n; i++) {
        const Stmt *stmt = stmts->at[i];
        if (!o->a->stmt[stmt->number].reached)
            continue;
        if (stmt->kind == ST_IF || (stmt->kind == ST_ASSIGN && stmt->value->kind != EX_VAR))
            check_reads(o, stmt, stmt->value);
        check_stmts(o, &stmt->then);
        check_stmts(o, &stmt->otherwise);
        if (stmt->kind == ST_ASSIGN && o->bit[stmt->var->index] != IR_NONE)
            bitset_add(o->here, o->bit[stmt->var->index]);
    }
}

void analyse_read_before_write(Analysis *a)
{
    const Program *p = a->p;
    StoreOrder o = {.a = a};

    if (!assign_bits_to_locals(&o))
        return;
    for (int b = 0; b < BLOCK_COUNT; b++) {
        o.stored[b] = ARENA_ARRAY(a->arena, uint64_t, o.words * p->state.n);
        for (size_t s = 0; s < p->state.n; s++)
            add_stores(&o, &p->state.at[s]->block[b], set_of_state(&o, o.stored[b], p->state.at[s]));
    }
    o.before = propagate_stores(&o, false);
    o.after = propagate_stores(&o, true);
    o.here = ARENA_ARRAY(a->arena, uint64_t, o.words);
    o.reported = ARENA_ARRAY(a->arena, bool, p->var.n);
    o.seen = ARENA_ARRAY(a->arena, uint32_t, p->state.n + 1);
    for (size_t s = 0; s < p->state.n; s++) {
        o.state = p->state.at[s];
        memcpy(o.here, set_of_state(&o, o.before, o.state), o.words * sizeof *o.here);
        for (int b = 0; b < BLOCK_COUNT; b++) {
            o.block = (BlockKind)b;
            if (b == BLOCK_STEP)                              // a step reads what the step before stored
                bitset_merge(o.here, set_of_state(&o, o.stored[b], o.state), o.words);
            check_stmts(&o, &o.state->block[b]);
        }
    }
}
