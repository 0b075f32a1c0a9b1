// SPDX-License-Identifier: Apache-2.0
// Locals that are read before any store to them can have been executed, although a later state stores to them: the assignment
// was intended to come first.
//
// An initial value other than 0 was chosen by the author, so it is doubted only where it always decides a guard.  A plain copy
// (shown = phase) publishes the current value.  A statement that reads the variable it assigns, as a counter does, is intended.
#include <string.h>

#include "compiler/analysis/analysis.h"
#include "stdlib/convert.h"

typedef uint64_t Word;
enum { WORD_BITS = 64, STATES_TRIED = 1000 };      // STATES_TRIED: limit of the search for the later store

typedef VEC(const State *) States;

typedef struct Order {
    Analysis *a;
    uint32_t *bit;                // by Var.index; IR_NONE: not checked
    size_t words;
    Word *stored[BLOCK_COUNT];    // by state, `words` each: what the block may store
    Word *before, *after;         // by state: what may have been stored when it begins; what later states store
    const States *next;           // by State.number: the states that it leads to
    Word *here;                   // what may have been stored when the current statement is executed
    bool *told;                   // by Var.index
    uint32_t *seen, searches;     // by State.number: the last search that visited it
    const State *state;           // the current state
    BlockKind block;
} Order;

static Word *of_state(const Order *o, Word *sets, const State *s) { return sets + (s->number - 1) * o->words; }

static bool has(const Order *o, const Word *set, uint32_t bit)
{
    (void)o;
    return (set[bit / WORD_BITS] >> bit % WORD_BITS & 1) != 0;
}

static void put(Word *set, uint32_t bit) { set[bit / WORD_BITS] |= (Word)1 << bit % WORD_BITS; }

// Returns true if the set grew.
static bool add(const Order *o, Word *set, const Word *more)
{
    bool changed = false;

    for (size_t w = 0; w < o->words; w++) {
        changed |= (more[w] & ~set[w]) != 0;
        set[w] |= more[w];
    }
    return changed;
}

// ---- the locals to check ----

static bool is_looked_at(const Var *v)
{
    return v->kind == VAR_LOCAL && v->written && v->read;
}

// Returns whether there are any.
static bool number_locals(Order *o)
{
    const Program *p = o->a->p;
    uint32_t n = 0;

    o->bit = ARENA_ARRAY(o->a->arena, uint32_t, p->var.n);
    for (size_t v = 0; v < p->var.n; v++)
        o->bit[v] = is_looked_at(p->var.at[v]) ? n++ : IR_NONE;
    o->words = n / WORD_BITS + 1;
    return n > 0;
}

// ---- where values are stored ----

static void note_stores(Order *o, const Stmts *stmts, Word *set)
{
    for (size_t i = 0; i < stmts->n; i++) {
        const Stmt *stmt = stmts->at[i];
        if (stmt->kind == ST_ASSIGN && o->bit[stmt->var->index] != IR_NONE && o->a->stmt[stmt->number].reached)
            put(set, o->bit[stmt->var->index]);
        note_stores(o, &stmt->then, set);
        note_stores(o, &stmt->otherwise, set);
    }
}

static void note_all_stores(Order *o)
{
    const Program *p = o->a->p;

    for (int b = 0; b < BLOCK_COUNT; b++) {
        o->stored[b] = ARENA_ARRAY(o->a->arena, Word, o->words * p->state.n);
        for (size_t s = 0; s < p->state.n; s++)
            note_stores(o, &p->state.at[s]->block[b], of_state(o, o->stored[b], p->state.at[s]));
    }
}

// ---- along transitions ----

typedef struct Spread {
    Order *o;
    States *next;                 // by state: the states that receive its set
    const State **ring;           // states that wait for a visit
    bool *waits;
    size_t head, n;
} Spread;

static void wait_for(Spread *w, const State *s)
{
    if (w->waits[s->number])
        return;
    w->waits[s->number] = true;
    w->ring[(w->head + w->n++) % w->o->a->p->state.n] = s;
}

static const State *next_waiting(Spread *w)
{
    const State *s = w->ring[w->head];

    w->head = (w->head + 1) % w->o->a->p->state.n;
    w->n--;
    w->waits[s->number] = false;
    return s;
}

static void spread_one(Spread *w, Word *sets, const State *from)
{
    Order *o = w->o;
    const States *next = &w->next[from->number];

    for (size_t i = 0; i < next->n; i++) {
        bool changed = add(o, of_state(o, sets, next->at[i]), of_state(o, sets, from));
        for (int b = 0; b < BLOCK_COUNT; b++)
            changed |= add(o, of_state(o, sets, next->at[i]), of_state(o, o->stored[b], from));
        if (changed)
            wait_for(w, next->at[i]);
    }
}

// Computes by state: what its predecessors store; or, backwards, what its successors store, both transitively.
static Word *spread(Order *o, bool backwards)
{
    const Analysis *a = o->a;
    Word *sets = ARENA_ARRAY(a->arena, Word, o->words * a->p->state.n);
    Spread w = {.o = o};

    w.next = arena_array(a->arena, a->p->state.n + 1, sizeof *w.next);
    w.waits = ARENA_ARRAY(a->arena, bool, a->p->state.n + 1);
    for (size_t t = 0; t < a->transition.n; t++) {
        const Transition *way = &a->transition.at[t];
        if (a->stmt[way->stmt->number].reached)
            vec_push(a->arena, &w.next[(backwards ? way->to : way->from)->number], backwards ? way->from : way->to);
    }
    w.ring = ARENA_ARRAY(a->arena, const State *, a->p->state.n);
    for (size_t s = 0; s < a->p->state.n; s++)                // transitions mostly follow the order of the file
        wait_for(&w, a->p->state.at[backwards ? a->p->state.n - 1 - s : s]);
    while (w.n > 0)
        spread_one(&w, sets, next_waiting(&w));
    if (!backwards)
        o->next = w.next;
    return sets;
}

// ---- reports ----

typedef struct Writer { const Var *var; const Stmt *found; } Writer;

static void find_writer(const Stmt *stmt, void *context)
{
    Writer *w = context;

    if (!w->found && stmt->kind == ST_ASSIGN && stmt->var == w->var)
        w->found = stmt;
}

static void writer_in(Writer *w, const Stmts *stmts)
{
    for (size_t i = 0; i < stmts->n && !w->found; i++) {
        find_writer(stmts->at[i], w);
        writer_in(w, &stmts->at[i]->then);
        writer_in(w, &stmts->at[i]->otherwise);
    }
}

// The nearest state after the current one that stores the variable, or the current one if its .exit does.
static const State *find_later(Order *o, Writer *w)
{
    const Analysis *a = o->a;
    States queue = {NULL, 0, 0};

    o->searches++;
    writer_in(w, &o->state->block[BLOCK_EXIT]);
    vec_push(a->arena, &queue, o->state);
    for (size_t i = 0; i < queue.n && i < STATES_TRIED && !w->found; i++) {
        for (size_t t = 0; t < o->next[queue.at[i]->number].n; t++) {
            const State *to = o->next[queue.at[i]->number].at[t];
            if (o->seen[to->number] != o->searches)
                vec_push(a->arena, &queue, to);
            o->seen[to->number] = o->searches;
        }
        for (int b = 0; i + 1 < queue.n && b < BLOCK_COUNT; b++)
            writer_in(w, &queue.at[i + 1]->block[b]);
        if (w->found)
            return queue.at[i + 1];
    }
    return o->state;
}

static const char *initial_text(const Order *o, const Var *v)
{
    if (v->type == SM_BOOL)
        return v->init ? "true" : "false";
    return const_text(o->a->arena, sm_cell_to_f64(v->type, v->init));
}

static void report(Order *o, const Expr *e)
{
    const Var *v = e->var;
    Writer w = {v, NULL};
    const State *later = find_later(o, &w);
    Diag *d;

    o->told[v->index] = true;
    if (!w.found)
        return;
    d = diag_report(o->a->diags, DIAG_read_before_write, e->span, v->name->text, initial_text(o, v),
                    later->name->text);
    diag_note(o->a->diags, d, w.found->span, DIAG_note_written_here);
}

// ---- reads ----

static bool comes_later(const Order *o, uint32_t bit)
{
    return has(o, of_state(o, o->after, o->state), bit) ||
           (o->block != BLOCK_EXIT && has(o, of_state(o, o->stored[BLOCK_EXIT], o->state), bit));
}

static bool is_decided(const Order *o, const Stmt *stmt)
{
    const StmtFact *f = &o->a->stmt[stmt->number];

    return stmt->kind == ST_IF && (!f->then || !f->otherwise);
}

// Windows take their samples in every state, so the order of states does not affect what they read.
static void look_at_expr(Order *o, const Stmt *stmt, const Expr *e)
{
    if (e->kind == EX_ROLL)
        return;
    for (uint32_t i = 0; i < e->n; i++)
        look_at_expr(o, stmt, e->arg[i]);
    if (e->kind != EX_VAR || o->bit[e->var->index] == IR_NONE || o->told[e->var->index] || stmt->var == e->var)
        return;
    if (e->var->init != 0 && !is_decided(o, stmt))
        return;
    if (!has(o, o->here, o->bit[e->var->index]) && comes_later(o, o->bit[e->var->index]))
        report(o, e);
}

static void look_at_stmts(Order *o, const Stmts *stmts)
{
    for (size_t i = 0; i < stmts->n; i++) {
        const Stmt *stmt = stmts->at[i];
        if (!o->a->stmt[stmt->number].reached)
            continue;
        if (stmt->kind == ST_IF || (stmt->kind == ST_ASSIGN && stmt->value->kind != EX_VAR))
            look_at_expr(o, stmt, stmt->value);
        look_at_stmts(o, &stmt->then);
        look_at_stmts(o, &stmt->otherwise);
        if (stmt->kind == ST_ASSIGN && o->bit[stmt->var->index] != IR_NONE)
            put(o->here, o->bit[stmt->var->index]);
    }
}

static void look_at_state(Order *o)
{
    memcpy(o->here, of_state(o, o->before, o->state), o->words * sizeof *o->here);
    for (int b = 0; b < BLOCK_COUNT; b++) {
        o->block = (BlockKind)b;
        if (b == BLOCK_STEP)                                  // the next step reads what a step stores
            add(o, o->here, of_state(o, o->stored[b], o->state));
        look_at_stmts(o, &o->state->block[b]);
    }
}

void analyse_order(Analysis *a)
{
    Order o = {.a = a};

    if (!number_locals(&o))
        return;
    note_all_stores(&o);
    o.before = spread(&o, false);
    o.after = spread(&o, true);
    o.here = ARENA_ARRAY(a->arena, Word, o.words);
    o.told = ARENA_ARRAY(a->arena, bool, a->p->var.n);
    o.seen = ARENA_ARRAY(a->arena, uint32_t, a->p->state.n + 1);
    for (size_t s = 0; s < a->p->state.n; s++) {
        o.state = a->p->state.at[s];
        look_at_state(&o);
    }
}
