// SPDX-License-Identifier: Apache-2.0
#include "compiler/script/schedule.h"

#include <float.h>
#include <stdlib.h>

// ---- intervals ----

// A closed interval of values, as F64: the values of G or T are compared as F64, too, and are finite.  Empty if from > to.
typedef struct Interval { double from, to; } Interval;

static const Interval always = {-DBL_MAX, DBL_MAX}, never = {DBL_MAX, -DBL_MAX};

static Interval intersection(Interval a, Interval b)
{
    return (Interval){a.from > b.from ? a.from : b.from, a.to < b.to ? a.to : b.to};
}

static Interval hull(Interval a, Interval b)
{
    return (Interval){a.from < b.from ? a.from : b.from, a.to > b.to ? a.to : b.to};
}

// Returns an interval of the variable `time` outside which the guard `a op b` is false.
static Interval interval_of_comparison(SmOperator op, const Expr *a, const Expr *b, const Var *time, const uint64_t *cell)
{
    const bool on_left = a->kind == EX_VAR && a->var == time, on_right = b->kind == EX_VAR && b->var == time;
    const Expr *limit = on_left ? b : a;
    double x;

    if (on_left == on_right || !expr_is_constant(limit))
        return always;
    x = ref_eval(limit, cell, NULL);
    if (x != x)
        return op == SM_OP_NE ? always : never;
    switch ((int)op) {
    case SM_OP_EQ: return (Interval){x, x};
    case SM_OP_LT: case SM_OP_LE: return on_left ? (Interval){always.from, x} : (Interval){x, always.to};
    case SM_OP_GT: case SM_OP_GE: return on_left ? (Interval){x, always.to} : (Interval){always.from, x};
    default: return always;
    }
}

// Returns an interval of the variable `time` outside which e is false.
static Interval interval_of(const Expr *e, const Var *time, const uint64_t *cell)
{
    Interval all = always;

    if (e->kind == EX_BINARY && e->op == SM_OP_AND)
        return intersection(interval_of(e->arg[0], time, cell), interval_of(e->arg[1], time, cell));
    if (e->kind == EX_BINARY && e->op == SM_OP_OR)
        return hull(interval_of(e->arg[0], time, cell), interval_of(e->arg[1], time, cell));
    if (e->kind == EX_AT)
        return e->var == time ? (Interval){e->number, e->number} : always;
    if (e->kind == EX_BINARY)
        return interval_of_comparison(e->op, e->arg[0], e->arg[1], time, cell);
    for (uint32_t i = 1; e->kind == EX_CHAIN && i < e->n; i++)
        all = intersection(all, interval_of_comparison(expr_ops(e)[i - 1], e->arg[i - 1], e->arg[i], time, cell));
    return all;
}

// Returns an interval of the variable `time` outside which the item does not run, because its guard or an enclosing one is false.
static Interval interval_of_item(const ScriptItem *item, const Var *time, const uint64_t *cell)
{
    Interval all = interval_of(item->guard, time, cell);

    for (; item->parent; item = item->parent)
        if (!item->otherwise)
            all = intersection(all, interval_of(item->parent->guard, time, cell));
    return all;
}

// ---- the search for intervals that contain a time ----

typedef struct Entry {
    const ScriptItem *item;
    Interval when;
    double latest;            // the largest when.to of this entry and of the entries in its subtree
} Entry;

// Entries sorted by when.from: an interval tree, a binary search tree whose root is the middle of the array.
typedef VEC(Entry) Entries;

static int compare_entries(const void *left, const void *right)
{
    const Entry *a = left, *b = right;

    if (a->when.from != b->when.from)
        return a->when.from < b->when.from ? -1 : 1;
    return a->item->number < b->item->number ? -1 : 1;
}

// Sets Entry.latest in the subtree at[from … end - 1], and returns its largest when.to.
static double set_latest(Entry *at, size_t from, size_t end)
{
    const size_t middle = from + (end - from) / 2;
    double latest, other;

    if (from == end)
        return never.to;
    latest = set_latest(at, from, middle);
    other = set_latest(at, middle + 1, end);
    latest = latest > other ? latest : other;
    return at[middle].latest = latest > at[middle].when.to ? latest : at[middle].when.to;
}

// Adds to `due` the items of the subtree at[from … end - 1] whose interval contains `now`.
static void add_items_containing(Arena *arena, const Entry *at, size_t from, size_t end, double now, DueItems *due)
{
    while (from < end) {
        const size_t middle = from + (end - from) / 2;
        if (at[middle].latest < now)
            return;
        add_items_containing(arena, at, from, middle, now, due);
        if (at[middle].when.from > now)
            return;
        if (at[middle].when.to >= now)
            vec_push(arena, due, at[middle].item);
        from = middle + 1;
    }
}

// ---- items whose guard is true at one G only ----

// Items with a guard such as `at 5 s`, sorted by the time in the guard.  A script can have a million of them, and a pointer needs a quarter of the
// memory of an Entry.
typedef struct Moments {
    DueItems item;
    uint32_t next;            // index of the first item whose time was not over at the last search
} Moments;

static double moment_of(const ScriptItem *item) { return item->guard->number; }

static int compare_moments(const void *left, const void *right)
{
    const ScriptItem *const *a = left, *const *b = right;

    if (moment_of(*a) != moment_of(*b))
        return moment_of(*a) < moment_of(*b) ? -1 : 1;
    return (*a)->number < (*b)->number ? -1 : 1;
}

// Adds to `due` the items whose guard is true at G = now.  Searches from where the last call ended, because G advances from call to call.
static void add_moments(Arena *arena, Moments *list, double now, DueItems *due)
{
    if (list->next > 0 && moment_of(list->item.at[list->next - 1]) >= now)
        list->next = 0;
    while (list->next < list->item.n && moment_of(list->item.at[list->next]) < now)
        list->next++;
    for (size_t i = list->next; i < list->item.n && moment_of(list->item.at[i]) == now; i++)
        vec_push(arena, due, list->item.at[i]);
}

// ---- items with a period ----

// An item whose guard is `every d`.  They are in a heap, ordered by `next`.
typedef struct Periodic {
    const ScriptItem *item;
    uint64_t next, period;    // in units of G: when the guard is true next; the duration d
} Periodic;

typedef VEC(Periodic) Periodics;

// Restores the order of the heap after the time of the entry at `i` has increased.
static void sift_down(Periodics *heap, size_t i)
{
    const Periodic moved = heap->at[i];

    for (size_t child; (child = 2 * i + 1) < heap->n; i = child) {
        if (child + 1 < heap->n && heap->at[child + 1].next < heap->at[child].next)
            child++;
        if (heap->at[child].next >= moved.next)
            break;
        heap->at[i] = heap->at[child];
    }
    heap->at[i] = moved;
}

// Adds to `due` the items for which `now` is a multiple of the period.  `now` increases from call to call; not every step makes a call.
static void add_periodic(Arena *arena, Periodics *heap, uint64_t now, DueItems *due)
{
    while (heap->n > 0 && heap->at[0].next <= now) {
        Periodic *p = &heap->at[0];
        const uint64_t last = now - now % p->period;

        if (last == now)
            vec_push(arena, due, p->item);
        p->next = last > UINT64_MAX - p->period ? UINT64_MAX : last + p->period;
        sift_down(heap, 0);
    }
}

// ---- the schedule ----

enum { BY_G, BY_T, TIMES };   // the two variables of time by whose intervals entries are sorted

// The items of the sections of one state, or of [all_states].
typedef struct Group {
    Entries by[TIMES];        // the entries whose `when` is an interval of G; of T
    Moments moments;
    Periodics periodic;
} Group;

struct Schedule {
    Arena *arena;
    const Var *time[TIMES];   // G and T
    bool grows;               // G is larger in each step than in the step before, never equal
    Group all_states;
    Group **of_state;         // by State.number - 1; NULL: the script has no section for it
    size_t states;
};

// Adds an item to the entries by G or to those by T, whichever gives it the shorter interval.
static void add_item(Schedule *h, Group *g, const ScriptItem *item, const uint64_t *cell)
{
    const Interval of_g = interval_of_item(item, h->time[BY_G], cell), of_t = interval_of_item(item, h->time[BY_T], cell);
    const bool by_t = of_t.to - of_t.from < of_g.to - of_g.from;
    const Interval when = by_t ? of_t : of_g;
    const Entry e = {item, when, 0};
    const Periodic p = {item, 0, item->guard->kind == EX_EVERY ? (uint64_t)item->guard->number : 0};

    // An item with `every` can be inside other guards.  If these are never false for good after some G, the heap is the faster search.
    if (p.period && h->grows && !by_t && of_g.to == always.to) {
        vec_push(h->arena, &g->periodic, p);
        return;
    }
    if (item->guard->kind == EX_AT && when.from == when.to)   // the interval is not one time if an enclosing guard is false at that time
        vec_push(h->arena, &g->moments.item, item);
    else
        vec_push(h->arena, &g->by[by_t ? BY_T : BY_G], e);
}

// Reserves memory for the items of a section: for those with `at` in `moments`, for all others in the entries by G.
static void reserve_items(Schedule *h, Group *g, const ScriptSection *section)
{
    uint32_t moments = 0;

    if (g->by[BY_G].cap || g->moments.item.cap)               // an earlier section of the same state has already reserved the memory
        return;
    for (size_t i = 0; i < section->item.n; i++)
        moments += section->item.at[i]->guard->kind == EX_AT;
    g->moments.item.cap = moments;
    g->moments.item.at = ARENA_ARRAY(h->arena, const ScriptItem *, moments);
    g->by[BY_G].cap = section->item.n - moments;
    g->by[BY_G].at = ARENA_ARRAY(h->arena, Entry, g->by[BY_G].cap);
}

// Sorts a list, unless it is in order already, as in a script that is written in order of time: some qsorts need as much memory again.
static void sort_list(void *list, size_t n, size_t size, int (*compare)(const void *, const void *))
{
    for (size_t i = 1; i < n; i++)
        if (compare((const char *)list + (i - 1) * size, (const char *)list + i * size) > 0) {
            qsort(list, n, size, compare);
            return;
        }
}

// Sorts the items of a state by when they are due.
static void sort_group(Group *g)
{
    sort_list(g->moments.item.at, g->moments.item.n, sizeof *g->moments.item.at, compare_moments);
    for (int i = 0; i < TIMES; i++) {
        sort_list(g->by[i].at, g->by[i].n, sizeof(Entry), compare_entries);
        set_latest(g->by[i].at, 0, g->by[i].n);
    }
}

// Returns the group of a section's state.  Each file of the script can have a section for it.
static Group *find_or_add_group(Schedule *h, const ScriptSection *section)
{
    Group **g = &h->of_state[section->state->number - 1];

    if (!*g)
        *g = ARENA_NEW(h->arena, Group);
    return *g;
}

// Prepares the schedule of a script.  `cell`: the initial values by variable; only those of constant locals are used.
Schedule *schedule_new(Arena *arena, const Script *s, const uint64_t *cell)
{
    Schedule *h = ARENA_NEW(arena, Schedule);

    h->arena = arena;
    h->time[BY_G] = s->program->g;
    h->time[BY_T] = s->program->t ? s->program->t : s->program->g;            // an application has no common T, so its entries are sorted by G only
    h->grows = s->delta_t > 0 || s->by_rows;                                  // else a tick can be shorter than a unit of G
    h->of_state = ARENA_ARRAY(arena, Group *, s->program->state.n);
    h->states = s->program->state.n;
    for (size_t i = 0; i < s->section.n; i++) {
        const ScriptSection *section = &s->section.at[i];
        Group *g = section->state ? find_or_add_group(h, section) : &h->all_states;
        reserve_items(h, g, section);
        for (size_t k = 0; k < section->item.n; k++)
            add_item(h, g, section->item.at[k], cell);
    }
    for (size_t i = 0; i < s->program->state.n; i++)
        if (h->of_state[i])
            sort_group(h->of_state[i]);
    sort_group(&h->all_states);
    return h;
}

static int compare_items(const void *left, const void *right)
{
    const ScriptItem *const *a = left, *const *b = right;

    return (*a)->number < (*b)->number ? -1 : (*a)->number > (*b)->number;
}

static bool is_sorted(const DueItems *due)
{
    for (size_t i = 1; i < due->n; i++)
        if (due->at[i - 1]->number > due->at[i]->number)
            return false;
    return true;
}

// Adds the items of a state that are due at this step.
static void add_due_items(const Schedule *h, Group *g, const uint64_t *cell, DueItems *due)
{
    for (int k = 0; g && k < TIMES; k++) {
        const double now = ref_read(h->time[k]->type, cell[h->time[k]->index]);
        if (k == BY_G)
            add_moments(h->arena, &g->moments, now, due);
        add_items_containing(h->arena, g->by[k].at, 0, g->by[k].n, now, due);
    }
    if (g)
        add_periodic(h->arena, &g->periodic, cell[h->time[BY_G]->index], due);
}

// Replaces `due` by the items of [all_states] and of the sections of n states whose guards can be true, in source order.
void schedule_find_due(Schedule *h, const State *const *state, size_t n, const uint64_t *cell, DueItems *due)
{
    due->n = 0;
    add_due_items(h, &h->all_states, cell, due);
    for (size_t i = 0; i < n; i++)
        add_due_items(h, h->of_state[state[i]->number - 1], cell, due);
    if (!is_sorted(due))
        qsort(due->at, due->n, sizeof *due->at, compare_items);
}

// Resets the next times of the group's periodic items to 0.
static void rewind_group(Group *g)
{
    for (size_t i = 0; g && i < g->periodic.n; i++)
        g->periodic.at[i].next = 0;
}

void schedule_rewind(Schedule *h)
{
    rewind_group(&h->all_states);
    for (size_t i = 0; i < h->states; i++)
        rewind_group(h->of_state[i]);
}
