// SPDX-License-Identifier: Apache-2.0
// Waits of a machine in an application, during which other machines would store something else than it needs.
//
// The solution runs on a copy of the snapshot.  In the first tick in which another machine changes an element that the goal's conditions read, the
// code of that machine is solved for inputs with which it does not.  This is repeated, as in search_stay.c for transitions.
#include "compiler/cover/flat_app.h"
#include "compiler/search/search_wish.h"

enum {
    MOST_REPAIRS = 16,        // of one attempt
    MOST_TRIES = 8            // solutions of one repair, until one changes an input
};

// ---- what is guarded ----

// Adds the elements that another machine writes, and on which the value of an instruction depends, to a set of IR variables.
static void add_foreign(const SearchRun *k, const IrFn *f, IrRef ref, bool *set)
{
    const IrIns *i = &f->ins.at[ref];

    if (i->op == IR_load) {
        for (uint32_t m = 0; m < k->o->place->others; m++)
            set[i->var] = set[i->var] || (k->o->place->other[m].of && k->o->place->other[m].var[i->var] != SEARCH_NONE);
        return;
    }
    if (i->op == IR_const || i->op == IR_stat)
        return;
    if (i->a != IR_NONE)
        add_foreign(k, f, i->a, set);
    if (i->b != IR_NONE)
        add_foreign(k, f, i->b, set);
}

// Finds the elements that the conditions of a goal read and other machines write.
static void find_guarded(const SearchRun *k, const SearchGoal *g, bool *set)
{
    for (uint32_t s = 0; s < g->site.n; s++)
        for (uint32_t e = 0; e < g->site.at[s].path.n; e++) {
            const FlatDecision *d = k->decision[g->site.at[s].path.elem[e].decision].d;
            add_foreign(k, d->fn, d->value, set);
        }
    if (k->foreign != SEARCH_NONE)
        set[k->foreign] = false;                           // the goal needs another value of it
}

// ---- repairs ----

// Runs the changes from a node until a guarded element has another value than there.  Returns the element; SEARCH_NONE: all keep theirs.
static uint32_t find_changed(SearchRun *k, uint32_t node, uint64_t steps, const bool *guarded)
{
    const uint64_t at = k->node.at[node].at;
    const uint64_t *was = flat_cells(k->plain, k->node.at[node].copy), *now = flat_cells(k->plain, k->scratch);

    search_load(k, node, k->scratch);
    search_apply(k, k->scratch, at, k->turn.at, k->turn.n);
    for (uint64_t n = 1; n <= steps && k->r->steps < k->stop_at; n++) {
        for (uint32_t m = 0; m < k->o->place->others; m++)
            if (k->o->place->other[m].of)
                k->o->place->other[m].of->site_state = ((const FlatState *)flat_app_state(k->plain, k->scratch, m))->state;
        search_set_inputs(k, k->scratch, at + n);
        flat_step(k->plain, k->scratch);
        k->r->steps++;
        for (uint32_t v = 0; v < k->m->var.n; v++)
            if (guarded[v] && now[v] != was[v])
                return v;
    }
    return SEARCH_NONE;
}

// Returns the statement that has decided what the last step of a machine stored in a variable: the store, or one before it that stored what it reads;
// 0: it is not known.
static uint32_t find_cause(const SearchRun *o, uint32_t var)
{
    for (uint32_t i = 0; i < o->var[var].store.n; i++) {
        const SearchStore *s = &o->var[var].store.at[i];
        if (s->state != o->site_state || !o->fn[s->fn].is_step || !search_was_taken(o, o->path[s->stmt]))
            continue;
        return o->path[s->stmt].n ? s->stmt : search_find_store(o, s->fn, s->value);
    }
    return 0;
}

// Adds what another machine needs of an input to the wish of the search, and changes the input.
static void take_wish(SearchRun *k, uint32_t input, const SearchWish *from)
{
    SearchWish *w = &k->wish[input];

    if (from->lo > w->lo) {
        w->lo = from->lo;
        w->above = from->above;
    }
    if (from->hi < w->hi) {
        w->hi = from->hi;
        w->below = from->below;
    }
    w->differs = from->differs;
    w->other = from->other;
    w->vary = from->vary;
    w->slope = from->slope;
    w->copies = SEARCH_NONE;
    search_replace_turn(k, input);
}

// Changes the inputs so that the last step of the other machine does not execute the statement.  Returns whether an input has changed.
static bool repair(SearchRun *k, const SearchOther *other, uint32_t stmt)
{
    SearchRun *o = other->of;
    bool any = false;

    for (uint32_t i = 0; i < o->inputs; i++)
        o->wish[i] = (SearchWish){.lo = -SEARCH_BIG, .hi = SEARCH_BIG, .copies = SEARCH_NONE};
    o->is_lasting = true;
    search_avoid_statement(o, stmt);
    o->is_lasting = false;
    for (uint32_t i = 0; i < o->inputs; i++) {
        const uint32_t input = other->input[i] == SEARCH_NONE ? SEARCH_NONE : k->var[k->m->var_of[other->input[i]]].input;
        if (input == SEARCH_NONE || !o->wish[i].needed)
            continue;
        take_wish(k, input, &o->wish[i]);
        any = true;
    }
    return any;
}

// Repairs the change of a guarded element in the last tick of k->scratch.
static bool repair_change(SearchRun *k, uint32_t var)
{
    for (uint32_t m = 0; m < k->o->place->others; m++) {
        const SearchOther *other = &k->o->place->other[m];
        uint32_t stmt;
        if (!other->of || other->var[var] == SEARCH_NONE)
            continue;
        other->of->scratch = flat_app_state(k->plain, k->scratch, m);
        other->of->random = search_random(k);
        other->of->effort = k->effort;
        other->of->delta_t = k->delta_t;
        stmt = find_cause(other->of, other->var[var]);
        for (int n = 0; n < MOST_TRIES && stmt; n++)
            if (repair(k, other, stmt))
                return true;
    }
    return false;
}

void search_run_guarding(SearchRun *k, uint32_t node, uint32_t goal)
{
    bool *guarded = arena_alloc(&k->legs, k->m->var.n + 1);
    const uint64_t wait = k->wait;

    find_guarded(k, &k->goal[goal], guarded);
    for (int n = 0; n < MOST_REPAIRS; n++) {
        const uint32_t changed = find_changed(k, node, wait, guarded);
        if (changed == SEARCH_NONE || !repair_change(k, changed))
            break;
    }
    arena_reset(&k->legs);
    search_run_segment(k, node, k->turn.at, k->turn.n, wait + 1, goal);
}
