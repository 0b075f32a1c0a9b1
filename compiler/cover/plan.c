// SPDX-License-Identifier: Apache-2.0
// Lists the places of a machine (what coverage counts, cover.h), and finds the temporaries of the IR whose values decide whether a place is
// covered.
#include "compiler/cover/cover.h"

#include <stdlib.h>
#include <string.h>

#include "stdlib/convert.h"

const char *const cover_kind_name[COVER_KIND_COUNT] = {
#define KIND(constant, name, sentence) name,
#include "compiler/cover/cover_kinds.def"
#undef KIND
};

// A decision of the program: a condition with its and, or and not.  The copies of a decision of [all_states] share their places.
typedef struct Decision {
    const Expr *root;                 // the whole decision
    VEC(FlatNode) node;
    VEC(const Expr *) condition;
    VEC(uint32_t) link;               // by condition: IrNote.link
    VEC(FlatFull) full;               // `window` is the index in Program.window until the IR has been built
    VEC(Span) read;                   // by entry of `full`: position of the call of the window function
    uint32_t hit;                     // index of the first place of the decision
    uint32_t note;                    // index in Cover.notes of the note about `root`; UINT32_MAX: no code computes it, because an equal window
                                      // has been sampled
} Decision;

// The identity of a place, as the key of a hash table: its kind, the position of its text, and a number that distinguishes copies.
typedef struct Key { uint32_t what, at, len, of; } Key;

enum { KEY_DECISION = COVER_KIND_COUNT };

typedef struct Plan {
    Arena *arena;
    Cover *c;
    struct { Key key; uint32_t place; } *slot;        // hash table with open addressing; place 0: an empty slot
    uint32_t cap;                     // number of slots, a power of two
    uint32_t used;                    // number of slots that are not empty
    VEC(Decision) decision;
    VEC(const Expr *) pending;        // decisions inside conditions, which are added after the decision that contains them
    uint32_t *stmt, *transition;      // by Stmt.number: the place of the statement; of the transition
    const FlatFull **full;            // by Stmt.number: as FlatProbes.full
    VEC(FlatFull) read;               // the windows that the current statement reads outside decisions
    bool in_window;                   // the current expression is what a window samples: no statement reads a window inside it
    uint32_t *entry, *exit;           // by State.number - 1: the place of entering the state; of leaving it
    const State *state;               // the current state; NULL before the first
    uint32_t inside;                  // the place of the branch, block or statement that contains the current code
    uint32_t *first_decision;         // by index in Program.window: index of the first decision in the sampled expression
    uint32_t *last_decision;          // by index in Program.window: index after the last decision
} Plan;

// ---- places ----

static Span own_span(const Plan *k, Span s) { return (Span){k->c->p->src, s.at, s.len}; }

static uint32_t hash_key(Key k)
{
    uint64_t h = k.at * UINT64_C(0x9e3779b97f4a7c15) + k.len;

    h = (h ^ h >> 29) * UINT64_C(0xbf58476d1ce4e5b9) + k.what * 64u + k.of;
    h = (h ^ h >> 32) * UINT64_C(0x94d049bb133111eb);
    return (uint32_t)(h >> 32);
}

static bool key_equal(Key a, Key b) { return a.what == b.what && a.at == b.at && a.len == b.len && a.of == b.of; }

static uint32_t find_slot(const Plan *k, Key key)
{
    uint32_t i = hash_key(key) & (k->cap - 1);

    while (k->slot[i].place && !key_equal(k->slot[i].key, key))
        i = (i + 1) & (k->cap - 1);
    return i;
}

static void grow_table(Plan *k)
{
    const uint32_t was = k->cap;
    void *old = k->slot;
    const Plan before = *k;

    k->cap = was ? 2 * was : 256;
    k->slot = arena_array(k->arena, k->cap, sizeof *k->slot);
    for (uint32_t i = 0; old && i < was; i++)
        if (before.slot[i].place)
            k->slot[find_slot(k, before.slot[i].key)] = before.slot[i];
}

static uint32_t push_place(Plan *k, CoverPlace p)
{
    p.span = own_span(k, p.span);
    p.where = own_span(k, p.where);
    vec_push(k->arena, &k->c->place, p);
    return (uint32_t)k->c->place.n - 1;
}

// Returns the place with this key; adds `p` if no place has it.  Sets *is_new.
static uint32_t add_place(Plan *k, Key key, CoverPlace p, bool *is_new)
{
    uint32_t i;

    if (2 * k->used >= k->cap)
        grow_table(k);
    i = find_slot(k, key);
    *is_new = k->slot[i].place == 0;
    if (*is_new) {
        k->used++;
        k->slot[i].key = key;
        k->slot[i].place = push_place(k, p);
    }
    return k->slot[i].place;
}

// ---- decisions ----

static bool same_span(Span a, Span b) { return a.at == b.at && a.len == b.len; }

// Whether the checker has made this operator from a call such as held(c, t): both operands then have the span of the call.
static bool is_made_of_call(const Expr *e) { return e->kind == EX_BINARY && same_span(e->arg[0]->span, e->arg[1]->span); }

static bool joins_conditions(const Expr *e)
{
    return (e->kind == EX_UNARY && e->op == SM_OP_NOT) || e->kind == EX_CHAIN
        || (e->kind == EX_BINARY && (e->op == SM_OP_AND || e->op == SM_OP_OR) && !is_made_of_call(e));
}

static bool is_comparison(const Expr *e) { return e->kind == EX_BINARY && e->op >= SM_OP_EQ && e->op <= SM_OP_GE; }
static bool is_truth(const Expr *e)
{
    return joins_conditions(e) || is_comparison(e) || (e->kind == EX_BINARY && (e->op == SM_OP_AND || e->op == SM_OP_OR));
}

// Whether a statistic can have another value while its window is not full yet, so that tests should fill the window.
static bool has_fill(const Plan *k, const Expr *roll)
{
    static const uint32_t never = SM_STATS_OF_TIMES | 1u << SM_STAT_OLDEST | 1u << SM_STAT_NEWEST;

    return k->c->p->window.at[roll->window].size > 1 && !(1u << roll->stat & never);
}

// Returns the place of the window of a call that is read in the current code; adds it if it is new.
static uint32_t add_window_place(Plan *k, Span call, Span where)
{
    const Key key = {COVER_WINDOW, call.at, call.len, where.at};
    const CoverPlace p = {.kind = COVER_WINDOW, .span = call, .where = where, .part_of = k->inside};
    bool is_new;

    return add_place(k, key, p, &is_new);
}

static uint32_t add_node(Plan *k, Decision *d, FlatNode n)
{
    vec_push(k->arena, &d->node, n);
    return (uint32_t)d->node.n - 1;
}

// Finds the windows that condition number `condition` reads, and the decisions inside its operands.
static void scan_operand(Plan *k, Decision *d, const Expr *e, uint32_t condition)
{
    if (is_truth(e)) {
        vec_push(k->arena, &k->pending, e);
    } else if (e->kind == EX_ROLL) {
        const FlatFull full = {condition, e->window, 0};
        if (has_fill(k, e)) {
            vec_push(k->arena, &d->full, full);
            vec_push(k->arena, &d->read, e->span);
        }
    } else {
        for (uint32_t i = 0; i < e->n; i++)
            scan_operand(k, d, e->arg[i], condition);
    }
}

static uint32_t add_condition(Plan *k, Decision *d, const Expr *e, uint32_t link)
{
    const uint32_t number = (uint32_t)d->condition.n;
    const FlatNode node = {NODE_CONDITION, number, 0};

    vec_push(k->arena, &d->condition, e);
    vec_push(k->arena, &d->link, link);
    return add_node(k, d, node);
}

// Adds the comparisons of a chain: `a < b <= c` is `a < b and b <= c`.
static uint32_t add_chain(Plan *k, Decision *d, const Expr *e)
{
    uint32_t all = 0;

    for (uint32_t i = 1; i < e->n; i++) {
        const uint32_t one = add_condition(k, d, e, i);
        scan_operand(k, d, e->arg[i], (uint32_t)d->condition.n - 1);
        if (i == 1)
            scan_operand(k, d, e->arg[0], (uint32_t)d->condition.n - 1);
        all = i == 1 ? one : add_node(k, d, (FlatNode){NODE_AND, all, one});
    }
    return all;
}

// Adds the tree of e.  Returns its root.
static uint32_t add_tree(Plan *k, Decision *d, const Expr *e)
{
    uint32_t a, b;

    if (e->kind == EX_CHAIN)
        return add_chain(k, d, e);
    if (joins_conditions(e)) {
        a = add_tree(k, d, e->arg[0]);
        if (e->kind == EX_UNARY)
            return add_node(k, d, (FlatNode){NODE_NOT, a, 0});
        b = add_tree(k, d, e->arg[1]);
        return add_node(k, d, (FlatNode){e->op == SM_OP_AND ? NODE_AND : NODE_OR, a, b});
    }
    a = add_condition(k, d, e, 0);
    if (is_made_of_call(e))
        return a;
    if (!is_comparison(e))
        scan_operand(k, d, e, d->node.at[a].a);
    for (uint32_t i = 0; is_comparison(e) && i < e->n; i++)
        scan_operand(k, d, e->arg[i], d->node.at[a].a);
    return a;
}

// Sets odd[n] to whether an odd number of `not` is above node n in the tree.
static void find_negated(const Decision *d, bool *odd)
{
    for (uint32_t n = (uint32_t)d->node.n; n-- > 0; ) {
        const FlatNode *node = &d->node.at[n];
        if (node->kind == NODE_CONDITION)
            continue;
        odd[node->a] = odd[n] ^ (node->kind == NODE_NOT);
        if (node->kind != NODE_NOT)
            odd[node->b] = odd[n];
    }
}

static Span condition_span(const Decision *d, uint32_t c)
{
    const Expr *e = d->condition.at[c];
    const uint32_t link = d->link.at[c];
    const Span a = link ? e->arg[link - 1]->span : e->span, b = link ? e->arg[link]->span : e->span;

    return b.at >= a.at ? (Span){a.src, a.at, b.at + b.len - a.at} : e->span;
}

static bool is_within(Span inner, Span outer) { return inner.at >= outer.at && inner.at + inner.len <= outer.at + outer.len; }

// Adds the places of the conditions of a decision, after the places of its result: for each condition two, deciding when true and when false.
static void add_condition_places(Plan *k, const Decision *d)
{
    bool *odd = arena_alloc(k->arena, d->node.n);
    uint32_t *node_of = ARENA_ARRAY(k->arena, uint32_t, d->condition.n);

    find_negated(d, odd);
    for (uint32_t n = 0; n < d->node.n; n++)
        if (d->node.at[n].kind == NODE_CONDITION)
            node_of[d->node.at[n].a] = n;
    for (uint32_t c = 0; c < d->condition.n; c++) {
        const Span span = condition_span(d, c);
        const Span where = is_within(span, d->root->span) ? span : d->root->span;
        for (int value = 1; value >= 0; value--) {
            const uint32_t result = d->hit + ((bool)value == odd[node_of[c]]);
            push_place(k, (CoverPlace){.kind = COVER_CONDITION, .value = value, .span = span, .where = where, .part_of = result, .result = result});
        }
    }
}

static void add_decision(Plan *k, const Expr *root, bool is_guard)
{
    const Key key = {KEY_DECISION, root->span.at, root->span.len, k->in_window};
    CoverPlace p = {.kind = COVER_GUARD, .value = true, .span = root->span, .where = root->span, .part_of = k->inside, .assigned = !is_guard,
                    .sampled = k->in_window};
    const uint32_t first_pending = (uint32_t)k->pending.n;
    Decision d = {.root = root, .note = UINT32_MAX};
    bool is_new;

    add_tree(k, &d, root);
    d.hit = add_place(k, key, p, &is_new);
    p.value = false;
    if (is_new) {
        push_place(k, p);
        add_condition_places(k, &d);
    }
    vec_push(k->arena, &k->decision, d);
    for (uint32_t i = 0; i < d.full.n; i++)
        d.full.at[i].hit = add_window_place(k, d.read.at[i], is_within(d.read.at[i], root->span) ? d.read.at[i] : root->span);
    for (uint32_t i = first_pending; i < k->pending.n; i++)
        add_decision(k, k->pending.at[i], false);
    k->pending.n = first_pending;
}

// Finds the decisions in a value that is no decision itself, and the windows that it reads.
static void scan_value(Plan *k, const Expr *e)
{
    if (is_truth(e)) {
        add_decision(k, e, false);
    } else if (e->kind == EX_ROLL) {
        if (has_fill(k, e) && !k->in_window) {
            const FlatFull full = {0, e->window, add_window_place(k, e->span, e->span)};
            vec_push(k->arena, &k->read, full);
        }
    } else {
        for (uint32_t i = 0; i < e->n; i++)
            scan_value(k, e->arg[i]);
    }
}

// ---- statements ----

static void plan_statements(Plan *k, const Stmts *list);

static void plan_branch(Plan *k, const Stmts *list, uint32_t inside)
{
    const uint32_t outer = k->inside;

    k->inside = inside;
    plan_statements(k, list);
    k->inside = outer;
}

static void plan_transition(Plan *k, const Stmt *s, uint32_t stmt, bool is_new)
{
    const bool of_all = s->span.src->copy_of != NULL;
    const Key key = {COVER_TRANSITION, s->span.at, s->span.len, k->state->number};
    const CoverPlace p = {.kind = COVER_TRANSITION, .span = s->span, .where = s->span, .from = k->state, .to = s->target, .of_all_states = of_all,
                          .part_of = k->inside};
    bool ignored;

    k->transition[s->number] = add_place(k, key, p, &ignored);
    if (is_new && !of_all)
        k->c->place.at[stmt].part_of = k->transition[s->number];
}

// Stores the list k->read as the windows that statement s reads, and empties it.
static void finish_read_windows(Plan *k, const Stmt *s)
{
    const FlatFull end = {0, 0, 0};

    if (k->read.n == 0)
        return;
    vec_push(k->arena, &k->read, end);
    k->full[s->number] = arena_copy(k->arena, k->read.at, k->read.n * sizeof end);
    k->read.n = 0;
}

static void plan_statement(Plan *k, const Stmt *s)
{
    const Key key = {COVER_STATEMENT, s->span.at, s->span.len, (uint32_t)s->kind};
    const CoverPlace p = {.kind = COVER_STATEMENT, .span = s->span, .where = s->span, .part_of = k->inside};
    const uint32_t outer = k->inside;
    uint32_t guard;
    bool is_new;

    k->stmt[s->number] = add_place(k, key, p, &is_new);
    k->inside = k->stmt[s->number];
    switch (s->kind) {
    case ST_ASSIGN: scan_value(k, s->value); break;
    case ST_TRANSITION:
        k->inside = outer;
        plan_transition(k, s, k->stmt[s->number], is_new);
        break;
    case ST_IF:
        guard = (uint32_t)k->decision.n;
        add_decision(k, s->value, true);
        guard = k->decision.at[guard].hit;
        plan_branch(k, &s->then, guard);
        plan_branch(k, &s->otherwise, guard + 1);
        break;
    }
    finish_read_windows(k, s);
    k->inside = outer;
}

static void plan_statements(Plan *k, const Stmts *list)
{
    for (size_t i = 0; i < list->n; i++) {
        const uint32_t outer = k->inside;
        if (list->at[i]->span.src->copy_of && outer == k->entry[k->state->number - 1])
            k->inside = 0;                            // a copy from [all_states]: the statement can also be executed in another state
        plan_statement(k, list->at[i]);
        k->inside = outer;
    }
}

// ---- states and windows ----

static bool contains_transition(const Stmts *list)
{
    for (size_t i = 0; i < list->n; i++)
        if (list->at[i]->kind == ST_TRANSITION || contains_transition(&list->at[i]->then) || contains_transition(&list->at[i]->otherwise))
            return true;
    return false;
}

static void plan_state(Plan *k, const State *s)
{
    CoverPlace p = {.kind = COVER_STATE, .value = true, .span = s->span, .where = s->span, .from = s};
    const uint32_t i = s->number - 1;

    k->entry[i] = push_place(k, p);
    p.value = false;
    p.part_of = k->entry[i];
    if (contains_transition(&s->block[BLOCK_ENTRY]) || contains_transition(&s->block[BLOCK_STEP]))
        k->exit[i] = push_place(k, p);
    k->state = s;
    for (int b = 0; b < BLOCK_COUNT; b++) {
        k->inside = b == BLOCK_EXIT && k->exit[i] ? k->exit[i] : k->entry[i];
        plan_statements(k, &s->block[b]);
    }
    k->inside = 0;
}

// Returns what a window samples as it is written: the checker makes `not not c` of the argument of held, rising and falling.
static const Expr *written_sample(const Window *w)
{
    const Expr *e = w->sample;

    while (e->kind == EX_UNARY && e->op == SM_OP_NOT && same_span(e->span, w->span))
        e = e->arg[0];
    return e;
}

// Adds the decisions in what windows sample: the argument of held is a decision at every step.
static void plan_windows(Plan *k)
{
    const Windows *all = &k->c->p->window;

    k->in_window = true;
    k->first_decision = ARENA_ARRAY(k->arena, uint32_t, all->n);
    k->last_decision = ARENA_ARRAY(k->arena, uint32_t, all->n);
    for (size_t i = 0; i < all->n; i++) {
        const Expr *e = written_sample(&all->at[i]);
        k->first_decision[i] = (uint32_t)k->decision.n;
        if (e != all->at[i].sample)
            add_decision(k, e, false);
        else
            scan_value(k, e);
        k->last_decision[i] = (uint32_t)k->decision.n;
    }
    k->in_window = false;
}

// ---- the IR ----

// A hash table of notes, by expression and link.  slot: 1 + index of a note; 0: empty.
typedef struct NoteTable { const IrNotes *notes; uint32_t *slot; uint32_t cap; } NoteTable;

static uint32_t hash_note(const Expr *e, uint32_t link)
{
    uint64_t h = ((uint64_t)(uintptr_t)e >> 3) * UINT64_C(0x9e3779b97f4a7c15) + link;

    return (uint32_t)((h ^ h >> 31) * UINT64_C(0xbf58476d1ce4e5b9) >> 32);
}

static uint32_t *note_slot(const NoteTable *t, const Expr *e, uint32_t link)
{
    uint32_t i = hash_note(e, link) & (t->cap - 1);

    while (t->slot[i] && (t->notes->at[t->slot[i] - 1].e != e || t->notes->at[t->slot[i] - 1].link != link))
        i = (i + 1) & (t->cap - 1);
    return &t->slot[i];
}

static NoteTable index_notes(Arena *arena, const IrNotes *notes)
{
    NoteTable t = {notes, NULL, 16};

    while (t.cap < 2 * notes->n)
        t.cap *= 2;
    t.slot = ARENA_ARRAY(arena, uint32_t, t.cap);
    for (uint32_t i = 0; i < notes->n; i++)
        *note_slot(&t, notes->at[i].e, notes->at[i].link) = i + 1;
    return t;
}

static int compare_decisions(const void *a, const void *b)
{
    const Decision *x = *(const Decision *const *)a, *y = *(const Decision *const *)b;

    return x->note < y->note ? -1 : x->note > y->note;
}

// Sets *out to the probe of a decision; all its conditions have temporaries in the IR.
static void make_probe(Plan *k, const NoteTable *t, const Decision *d, FlatDecision *out)
{
    IrRef *ref = ARENA_ARRAY(k->arena, IrRef, d->condition.n);

    for (uint32_t c = 0; c < d->condition.n; c++)
        ref[c] = t->notes->at[*note_slot(t, d->condition.at[c], d->link.at[c]) - 1].ref;
    for (uint32_t w = 0; w < d->full.n; w++)
        d->full.at[w].window = k->c->m->window_of[d->full.at[w].window];
    *out = (FlatDecision){t->notes->at[d->note].fn, t->notes->at[d->note].ref, d->node.at, d->node.n, ref, d->condition.n, d->full.at, d->full.n,
                          d->hit};
}

// Finds the code of each decision, and makes the probes in the order of the code.
static void make_probes(Plan *k)
{
    Cover *c = k->c;
    const NoteTable t = index_notes(k->arena, &c->notes);
    const Decision **order = arena_array(k->arena, k->decision.n + 1, sizeof *order);
    FlatDecision *out = arena_array(k->arena, k->decision.n + 1, sizeof *out);
    uint32_t n = 0;

    for (uint32_t i = 0; i < k->decision.n; i++) {
        Decision *d = &k->decision.at[i];
        const uint32_t slot = *note_slot(&t, d->root, 0);
        d->note = slot ? slot - 1 : UINT32_MAX;
        if (slot)
            order[n++] = d;
    }
    qsort(order, n, sizeof *order, compare_decisions);
    for (uint32_t i = 0; i < n; i++)
        make_probe(k, &t, order[i], &out[i]);
    c->probes.decision = out;
    c->probes.decisions = n;
}

static void add_shared_counts(Plan *k, uint32_t from, uint32_t to, uint32_t n)
{
    const CoverShared s = {from, to, n};

    vec_push(k->arena, &k->c->shared, s);
}

// If several windows share their samples, code computes only the decisions of the first one.  Adds the copies of counts to the others
// (Cover.shared).
static void find_shared(Plan *k)
{
    const Cover *c = k->c;

    for (uint32_t i = 0; i < c->p->window.n; i++) {
        const uint32_t first = (uint32_t)(c->m->window.at[c->m->window_of[i]].first - c->p->window.at);
        for (uint32_t n = k->first_decision[i]; first != i && n < k->last_decision[i]; n++) {
            const Decision *to = &k->decision.at[n], *from = &k->decision.at[k->first_decision[first] + n - k->first_decision[i]];
            add_shared_counts(k, from->hit, to->hit, 2 + 2 * to->condition.n);
            for (uint32_t w = 0; w < to->full.n; w++)
                add_shared_counts(k, from->full.at[w].hit, to->full.at[w].hit, 1);
        }
    }
}

static void list_single_conditions(Plan *k)
{
    for (uint32_t i = 0; i < k->decision.n; i++)
        if (k->decision.at[i].node.n == 1 && k->decision.at[i].full.n == 0)
            vec_push(k->arena, &k->c->single, k->decision.at[i].hit);
}

// ---- the cover ----

// FNV-1a of the machine's text and of the layout of its state vector.
static uint64_t identity_of(const Program *p)
{
    uint64_t h = UINT64_C(0xcbf29ce484222325);

    for (uint32_t i = 0; i < p->src->len; i++)
        h = (h ^ (unsigned char)p->src->text[i]) * UINT64_C(0x100000001b3);
    for (int i = 0; i < 4; i++)
        h = (h ^ (p->sv->hash >> 8 * i & 0xff)) * UINT64_C(0x100000001b3);
    return h;
}

static void add_parameter_value(Plan *k, const Var *v, uint64_t cell)
{
    const CoverPlace p = {.kind = COVER_PARAMETER, .span = v->span, .where = v->span, .parameter = v, .cell = cell};

    for (uint32_t i = 1; i < k->c->place.n; i++)
        if (k->c->place.at[i].parameter == v && k->c->place.at[i].cell == cell)
            return;                                   // the value has a place already, because the default is an end of the range
    push_place(k, p);
}

static void plan_parameters(Plan *k, const Program *p)
{
    for (size_t i = 0; i < p->var.n; i++) {
        const Var *v = p->var.at[i];
        if (!v->parameter)
            continue;
        add_parameter_value(k, v, v->parameter->standard);
        add_parameter_value(k, v, sm_cell_from_f64(v->type, v->parameter->lo));
        add_parameter_value(k, v, sm_cell_from_f64(v->type, v->parameter->hi));
    }
}

static void plan_places(Plan *k, const Program *p)
{
    const CoverPlace none = {.kind = COVER_KIND_COUNT};

    vec_push(k->arena, &k->c->place, none);
    k->stmt = ARENA_ARRAY(k->arena, uint32_t, p->stmts + 1);
    k->transition = ARENA_ARRAY(k->arena, uint32_t, p->stmts + 1);
    k->full = arena_array(k->arena, p->stmts + 1, sizeof *k->full);
    k->entry = ARENA_ARRAY(k->arena, uint32_t, p->state.n);
    k->exit = ARENA_ARRAY(k->arena, uint32_t, p->state.n);
    plan_windows(k);
    for (size_t s = 0; s < p->state.n; s++)
        plan_state(k, p->state.at[s]);
    plan_parameters(k, p);
}

// In the lists of k->full, replaces the index of each window in Program.window by its index in IrMachine.window.
static void map_windows(Plan *k)
{
    for (uint32_t s = 0; s <= k->c->p->stmts; s++)
        for (FlatFull *f = (FlatFull *)k->full[s]; f && f->hit; f++)
            f->window = k->c->m->window_of[f->window];
}

Cover *cover_new(Arena *arena, const Program *p)
{
    Cover *c = ARENA_NEW(arena, Cover);
    Plan k = {.arena = arena, .c = c};

    c->arena = arena;
    c->p = p;
    c->identity = identity_of(p);
    plan_places(&k, p);
    c->m = ir_build_noting(arena, p, &c->notes);
    make_probes(&k);
    find_shared(&k);
    list_single_conditions(&k);
    map_windows(&k);
    c->entry = k.entry;
    c->probes.stmt = k.stmt;
    c->probes.transition = k.transition;
    c->probes.entry = k.entry;
    c->probes.exit = k.exit;
    c->probes.full = k.full;
    c->probes.counters = (uint32_t)c->place.n;
    c->flat = flat_new(arena, c->m, &c->probes);
    c->hits = c->flat->hits;
    return c;
}

void cover_count_parameters(Cover *c, const uint64_t *cell)
{
    for (uint32_t i = 1; i < c->place.n; i++)
        if (c->place.at[i].kind == COVER_PARAMETER)
            c->hits[i] += c->place.at[i].cell == cell[c->place.at[i].parameter->index];
}

void cover_settle(Cover *c)
{
    for (uint32_t i = 0; i < c->single.n; i++)
        memcpy(&c->hits[c->single.at[i] + 2], &c->hits[c->single.at[i]], 2 * sizeof *c->hits);
    for (uint32_t i = 0; i < c->shared.n; i++)
        for (uint32_t n = 0; n < c->shared.at[i].n; n++)
            if (c->hits[c->shared.at[i].to + n] == 0)
                c->hits[c->shared.at[i].to + n] = c->hits[c->shared.at[i].from + n];
    cover_find_impossible(c);
}

CoverTotal cover_total(const Cover *c, CoverKind kind)
{
    CoverTotal t = {0, 0, 0};

    for (uint32_t i = 1; i < c->place.n; i++)
        if (c->place.at[i].kind == kind) {
            t.covered += c->hits[i] > 0;
            t.impossible += c->hits[i] == 0 && c->place.at[i].impossible;
            t.possible += c->hits[i] > 0 || !c->place.at[i].impossible;
        }
    return t;
}
