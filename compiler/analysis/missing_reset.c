// SPDX-License-Identifier: Apache-2.0
// Reports latches and extremes that keep the value of an earlier run, although others that the same states set are reset:
//
//   - one that the machine never resets, while it comes back to its first state and resets the others on that path;
//   - one that is missing in a block of resets which repeats another block but for this one, on a path back on which nothing else resets it.
//
// A value that no guard reads is for the record.  One that is reset under a condition, as by an operator, is not judged.
#include "compiler/analysis/carried.h"
#include "compiler/analysis/trial_checks.h"

enum { NAMED_MAX = 4 };           // companions that a message names

typedef struct ResetCheck {
    CarriedTable t;
    bool *home;                   // by State.number - 1: the machine goes from its first state to this one, and back
    bool *mark;                   // scratch, by State.number - 1
} ResetCheck;

static bool is_state_carried(const Carried *c) { return c->kind == CARRIED_LATCH || c->kind == CARRIED_EXTREME; }

// ---- the states of a run ----

static void mark_paths(const Analysis *a, const State *from, bool backwards, bool *mark)
{
    bool grown = true;

    mark[from->number - 1] = true;
    while (grown) {
        grown = false;
        for (size_t i = 0; i < a->transition.n; i++) {
            const Transition *way = &a->transition.at[i];
            const uint32_t to = (backwards ? way->from : way->to)->number - 1, at = (backwards ? way->to : way->from)->number - 1;
            if (!mark[at] || mark[to] || !a->stmt[way->stmt->number].reached)
                continue;
            mark[to] = grown = true;
        }
    }
}

// Marks the states of cycles through the first state.
static void find_home(ResetCheck *k)
{
    const Analysis *a = k->t.a;

    mark_paths(a, a->p->state.at[0], false, k->home);
    mark_paths(a, a->p->state.at[0], true, k->mark);
    for (size_t s = 0; s < a->p->state.n; s++)
        k->home[s] &= k->mark[s];
}

// ---- what is never reset ----

static bool share_a_state(const Carried *a, const Carried *b)
{
    bool shared = false;

    for (size_t i = 0; i < a->store.n && !shared; i++)
        shared = !a->store.at[i].resets && carried_is_set_in(b, a->store.at[i].state);
    return shared;
}

// Returns a reset of the variable in a run that can be repeated; NULL: the variable has no reset there.
static const CarriedStore *find_home_reset(const ResetCheck *k, const Carried *c)
{
    for (size_t i = 0; i < c->store.n; i++) {
        const CarriedStore *r = &c->store.at[i];
        if (r->resets && r->certain && k->home[r->state->number - 1] && k->t.a->stmt[r->stmt->number].reached)
            return r;
    }
    return NULL;
}

static const CarriedStore *find_home_set(const ResetCheck *k, const Carried *c)
{
    for (size_t i = 0; i < c->store.n; i++)
        if (!c->store.at[i].resets && k->home[c->store.at[i].state->number - 1])
            return &c->store.at[i];
    return NULL;
}

static bool is_read_at_home(const ResetCheck *k, const Carried *c)
{
    bool read = false;

    for (size_t i = 0; i < c->guard_state.n && !read; i++)
        read = k->home[c->guard_state.at[i]->number - 1];
    return read;
}

static void check_never_reset(ResetCheck *k, size_t v)
{
    const Analysis *a = k->t.a;
    const Carried *c = &k->t.of[v];
    const uint32_t least = c->kind == CARRIED_LATCH ? 2 : 1;
    const CarriedStore *set = find_home_set(k, c), *reset = NULL;
    const Var *with[NAMED_MAX];
    uint32_t n = 0;
    Diag *d;

    if (c->resets > 0 || !set || !is_read_at_home(k, c))
        return;
    for (size_t w = 0; w < a->p->var.n && n < NAMED_MAX; w++) {
        const CarriedStore *r = w != v && is_state_carried(&k->t.of[w]) && share_a_state(c, &k->t.of[w]) ? find_home_reset(k, &k->t.of[w]) : NULL;
        if (!r)
            continue;
        with[n++] = a->p->var.at[w];
        reset = r;
    }
    if (n < least)
        return;
    d = diag_report(a->diags, DIAG_never_reset, set->stmt->span, a->p->var.at[v]->name->text, trial_check_join_names(a->arena, with, n));
    diag_note_declaration(a->diags, d, DIAG_OUTPUTS, a->p->var.at[v]->span);
    diag_note(a->diags, d, reset->stmt->span, DIAG_note_reset_here, with[n - 1]->name->text);
    diag_note(a->diags, d, c->guard.at[0]->value->span, DIAG_note_decides_here, a->p->var.at[v]->name->text);
}

// ---- what one block of resets leaves out ----

// The latches and extremes that one list of statements resets.
typedef struct ResetBlock {
    const CarriedStore *at;       // its first reset
    VEC(uint32_t) var;            // by Var.index, ascending
} ResetBlock;

typedef VEC(ResetBlock) ResetBlocks;

static void add_to_block(const ResetCheck *k, ResetBlocks *all, const CarriedStore *r, uint32_t v)
{
    Arena *arena = k->t.a->arena;
    ResetBlock *b = NULL;

    for (size_t i = 0; i < all->n && !b; i++)
        b = all->at[i].at->list == r->list ? &all->at[i] : NULL;
    if (!b) {
        const ResetBlock fresh = {.at = r};
        vec_push(arena, all, fresh);
        b = &all->at[all->n - 1];
    }
    if (b->var.n == 0 || b->var.at[b->var.n - 1] != v)
        vec_push(arena, &b->var, v);
    if (r->stmt->number < b->at->stmt->number)
        b->at = r;
}

static ResetBlocks find_reset_blocks(const ResetCheck *k)
{
    ResetBlocks all = {NULL, 0, 0};

    for (size_t v = 0; v < k->t.a->p->var.n; v++)
        for (size_t i = 0; is_state_carried(&k->t.of[v]) && i < k->t.of[v].store.n; i++) {
            const CarriedStore *r = &k->t.of[v].store.at[i];
            if (r->resets && r->certain && k->t.a->stmt[r->stmt->number].reached)
                add_to_block(k, &all, r, (uint32_t)v);
        }
    return all;
}

// Returns the variable that `most` resets and `least` does not, if that is the only difference; else IR_NONE.
static uint32_t find_difference(const ResetBlock *most, const ResetBlock *least)
{
    uint32_t missing = IR_NONE;
    size_t i = 0;

    if (most->var.n != least->var.n + 1)
        return IR_NONE;
    for (size_t n = 0; n < most->var.n; n++) {
        if (i < least->var.n && most->var.at[n] == least->var.at[i])
            i++;
        else if (missing != IR_NONE)
            return IR_NONE;
        else
            missing = most->var.at[n];
    }
    return missing;
}

// Whether a guard reads the variable together with one that the block resets.
static bool decides_with(const ResetCheck *k, uint32_t v, const ResetBlock *b)
{
    const Carried *c = &k->t.of[v];
    bool together = false;

    for (size_t i = 0; i < b->var.n && !together; i++)
        for (size_t g = 0; g < c->guard.n && !together; g++)
            together = expr_reads(c->guard.at[g]->value, k->t.a->p->var.at[b->var.at[i]]);
    return together;
}

// Whether the list assigns the variable, itself or in a conditional.
static bool assigns(const Carried *c, const Stmts *list)
{
    bool any = false;

    for (size_t i = 0; i < c->store.n && !any; i++)
        any = c->store.at[i].list == list;
    return any;
}

static void clear_marks(ResetCheck *k)
{
    for (size_t s = 0; s < k->t.a->p->state.n; s++)
        k->mark[s] = false;
}

// Whether the machine goes from the state of the block to one that sets the variable, and back, and resets it nowhere on that path.
static bool is_kept_around(ResetCheck *k, uint32_t v, const ResetBlock *b)
{
    const Carried *c = &k->t.of[v];
    bool kept = false;

    for (size_t i = 0; i < c->store.n && !kept; i++) {
        const State *set = c->store.at[i].state;
        if (c->store.at[i].resets)
            continue;
        clear_marks(k);
        carried_mark_reached(&k->t, v, b->at->state, k->mark);
        kept = k->mark[set->number - 1];
        clear_marks(k);
        carried_mark_reached(&k->t, v, set, k->mark);
        kept &= k->mark[b->at->state->number - 1];
    }
    return kept;
}

static void report_left_out(const ResetCheck *k, uint32_t v, const ResetBlock *most, const ResetBlock *b)
{
    const Analysis *a = k->t.a;
    const Var *with[NAMED_MAX];
    uint32_t n = 0;
    Diag *d;

    while (n < NAMED_MAX && n < b->var.n) {
        with[n] = a->p->var.at[b->var.at[n]];
        n++;
    }
    d = diag_report(a->diags, DIAG_reset_left_out, b->at->stmt->span, a->p->var.at[v]->name->text, trial_check_join_names(a->arena, with, n));
    diag_note_declaration(a->diags, d, DIAG_OUTPUTS, a->p->var.at[v]->span);
    for (size_t i = 0; i < k->t.of[v].store.n; i++)
        if (k->t.of[v].store.at[i].list == most->at->list)
            diag_note(a->diags, d, k->t.of[v].store.at[i].stmt->span, DIAG_note_reset_here, a->p->var.at[v]->name->text);
}

static void check_blocks(ResetCheck *k)
{
    const ResetBlocks all = find_reset_blocks(k);

    for (size_t i = 0; i < all.n; i++)
        for (size_t n = 0; n < all.n && all.at[i].var.n >= 2; n++) {
            const ResetBlock *most = &all.at[n], *b = &all.at[i];
            const uint32_t v = find_difference(most, b);
            if (v == IR_NONE || k->t.of[v].unclear || assigns(&k->t.of[v], b->at->list) || !decides_with(k, v, b) || !is_kept_around(k, v, b))
                continue;
            report_left_out(k, v, most, b);
            break;
        }
}

void analyse_missing_reset(Analysis *a)
{
    ResetCheck k = {carried_of(a), ARENA_ARRAY(a->arena, bool, a->p->state.n), ARENA_ARRAY(a->arena, bool, a->p->state.n)};

    find_home(&k);
    for (size_t v = 0; v < a->p->var.n; v++)
        if (is_state_carried(&k.t.of[v]))
            check_never_reset(&k, v);
    check_blocks(&k);
}
