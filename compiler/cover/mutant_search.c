// SPDX-License-Identifier: Apache-2.0
#include "compiler/cover/mutant_search.h"

#include <string.h>

#include "compiler/cover/mutant_values.h"
#include "stdlib/convert.h"

enum {
    NODES_MOST = 512,         // the most stored situations
    SEEN_SLOTS = 4096,        // size of the hash table of situations; a power of two
    CONTINUE_ONE_IN = 2,      // one extension in so many is the last one before another situation is chosen
    AROUND_MOST = 100000,     // the most steps of an extension that waits for a time in the changed condition
    MINIMISE_STEPS = 200000   // the most steps of all replays that test shorter forms of a scenario
};

// The values of an input since its last change.  step 0: there was none.
typedef ScenarioChange Course;

// A stored situation: the states of machine and mutant after some steps.  The nodes from the root to it are the scenario that reaches it.
typedef struct Node {
    const struct Node *parent;
    const ScenarioChange *change;     // the changes between the parent and this node
    uint32_t changes;
    const State *start;       // the state in which the scenario begins
    uint64_t steps;           // number of steps from the start of the scenario
    void *original, *mutant;  // the states of the unchanged machine, and of the mutant
    Course *course;           // by index in MutantValues.input: its current values; step 0: not set by the scenario
    bool differs;             // the states of machine and mutant differ, although no output does yet
} Node;

struct MutantSearch {
    Arena *arena;
    const Program *p;
    FlatMachine *original;
    uint64_t delta_t;
    const State *const *start;
    uint32_t starts;
    const Scenario *given;
    uint32_t givens;
    MutantValues v;
    uint64_t random;
};

// ---- random numbers: splitmix64 ----

static uint64_t next_random(MutantSearch *k)
{
    uint64_t x = k->random += UINT64_C(0x9e3779b97f4a7c15);

    x = (x ^ x >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
    x = (x ^ x >> 27) * UINT64_C(0x94d049bb133111eb);
    return x ^ x >> 31;
}

static uint32_t random_below(MutantSearch *k, uint32_t n) { return (uint32_t)(next_random(k) % n); }

MutantSearch *mutant_search_new(Arena *arena, const Program *p, FlatMachine *original, uint64_t delta_t, const State *const *start, uint32_t starts,
                                const Scenario *given, uint32_t givens)
{
    MutantSearch *k = ARENA_NEW(arena, MutantSearch);

    k->arena = arena;
    k->p = p;
    k->original = original;
    k->delta_t = delta_t ? delta_t : 10;
    k->start = start;
    k->starts = starts;
    k->given = given;
    k->givens = givens;
    mutant_values_list(arena, p, k->delta_t, &k->v);
    return k;
}

// ---- a run ----

// The search for one mutant, in which the unchanged machine and the mutant run in lockstep.
typedef struct Lockstep {
    MutantSearch *k;
    Arena *work;
    FlatMachine *mutant;
    const double *around;
    uint32_t arounds;
    bool same_layout;
    uint64_t left;            // number of steps that the search may still run
    uint64_t replayed;        // number of steps of all replays that tested shorter scenarios
    VEC(Node *) node;         // all stored situations
    VEC(Node *) apart;        // the nodes of `node` with `differs`
    const State *state;       // the state that contains the change; or NULL
    VEC(Node *) inside;       // the nodes of `node` that are in this state
    uint64_t seen[SEEN_SLOTS];        // hash table of the situations reached so far: their hashes; 0: empty
    const Var *what;          // the variable that differs; NULL: S
} Lockstep;

// Returns the value of an input in a step, of which no COPY is asked before the machine has the state that it had then.
static double value_at(const Lockstep *l, const Node *n, const Course *c, uint64_t step)
{
    const MutantSearch *k = l->k;
    const uint32_t source = k->original->m->var_of[c->source];

    switch (c->kind) {
    case SCENARIO_HOLD: break;
    case SCENARIO_ALTERNATE: return (step - c->step) % 2 ? c->b : c->a;
    case SCENARIO_RAMP: return c->a + c->b * (double)(step - c->step);
    case SCENARIO_COPY: return source == IR_NONE ? c->a : sm_cell_to_f64(k->p->var.at[c->source]->type, flat_cells(k->original, n->original)[source]);
    }
    return c->a;
}

static void write_cell(const FlatMachine *f, void *state, uint32_t var, uint64_t cell)
{
    if (f->m->var_of[var] != IR_NONE)
        flat_cells(f, state)[f->m->var_of[var]] = cell;
}

// Sets the inputs and the time of both machines for a step.
static void write_inputs(const Lockstep *l, Node *n, uint64_t step)
{
    const MutantSearch *k = l->k;

    write_cell(k->original, n->original, k->p->g->index, (step - 1) * k->delta_t);
    write_cell(l->mutant, n->mutant, k->p->g->index, (step - 1) * k->delta_t);
    for (uint32_t i = 0; i < k->v.input.n; i++) {
        uint64_t cell;
        if (n->course[i].step == 0 || (k->v.input.at[i].is_stored && step > 1))
            continue;
        cell = sm_cell_from_f64(k->v.input.at[i].type, value_at(l, n, &n->course[i], step));
        write_cell(k->original, n->original, k->v.input.at[i].var, cell);
        write_cell(l->mutant, n->mutant, k->v.input.at[i].var, cell);
    }
}

// Whether a script can see a difference: S or an output differs.
static bool is_visible(Lockstep *l, Node *n)
{
    const MutantSearch *k = l->k;

    if (flat_cells(k->original, n->original)[k->original->m->s] != flat_cells(l->mutant, n->mutant)[l->mutant->m->s]) {
        l->what = NULL;
        return true;
    }
    for (uint32_t i = 0; i < k->v.output.n; i++) {
        const uint32_t v = k->v.output.at[i];
        if (flat_cells(k->original, n->original)[k->original->m->var_of[v]] != flat_cells(l->mutant, n->mutant)[l->mutant->m->var_of[v]]) {
            l->what = k->p->var.at[v];
            return true;
        }
    }
    return false;
}

// Runs one step of the original and of the mutant with the same inputs; returns whether a difference is visible to a script.
static bool run_step(Lockstep *l, Node *n)
{
    n->steps++;
    l->left -= l->left > 0;
    write_inputs(l, n, n->steps);
    flat_step(l->k->original, n->original);
    flat_step(l->mutant, n->mutant);
    return is_visible(l, n);
}

// ---- situations ----

static bool has_diverged(const Lockstep *l, const Node *n) { return l->same_layout && memcmp(n->original, n->mutant, l->k->original->size) != 0; }

// Returns a hash that is equal for situations that the search treats as the same: it depends on the state, on whether the two machines differ, on
// the rough time in the state, and on the values of variables of small types.
static uint64_t hash_of(const Lockstep *l, const Node *n)
{
    const MutantSearch *k = l->k;
    const FlatState *s = n->original;
    const uint64_t *cell = flat_cells(k->original, n->original);
    uint64_t t = (n->steps ? (n->steps - 1) * k->delta_t - s->start : 0) / k->delta_t, h = s->state * 2 + n->differs;
    unsigned bits = 0;

    for (; t > 0; t /= 4)
        bits++;
    h = h * 64 + bits;
    for (size_t v = 0; v < k->p->var.n; v++) {
        const Var *x = k->p->var.at[v];
        const uint32_t at = k->original->m->var_of[v];
        double number;
        if (!x->written || at == IR_NONE)
            continue;
        number = sm_cell_to_f64(x->type, cell[at]);
        h = (h ^ (number >= 0 && number <= 8 ? (uint64_t)number : 9)) * UINT64_C(0x100000001b3);
    }
    return h | 1;
}

// Adds the hash of the situation of n to the table of seen ones.  Returns false if it is in the table already.
static bool record_if_new(Lockstep *l, const Node *n)
{
    const uint64_t h = hash_of(l, n);
    uint32_t at = (uint32_t)(h * UINT64_C(0x9e3779b97f4a7c15) >> 40) & (SEEN_SLOTS - 1);

    for (uint32_t i = 0; i < 16; i++, at = (at + 1) & (SEEN_SLOTS - 1)) {
        if (l->seen[at] == h)
            return false;
        if (l->seen[at] == 0) {
            l->seen[at] = h;
            return true;
        }
    }
    return false;
}

static Node *copy_node(Lockstep *l, const Node *n)
{
    Node *copy = arena_copy(l->work, n, sizeof *n);

    copy->original = arena_copy(l->work, n->original, l->k->original->size);
    copy->mutant = arena_copy(l->work, n->mutant, l->mutant->size);
    copy->course = arena_copy(l->work, n->course, (l->k->v.input.n + 1) * sizeof *n->course);
    return copy;
}

static Node *new_start(const Lockstep *l, const State *start)
{
    Node *n = ARENA_NEW(l->work, Node);

    n->original = arena_alloc(l->work, l->k->original->size);
    n->mutant = arena_alloc(l->work, l->mutant->size);
    n->course = ARENA_ARRAY(l->work, Course, l->k->v.input.n + 1);
    n->start = start;
    flat_start(l->k->original, n->original, start->number);
    flat_start(l->mutant, n->mutant, start->number);
    return n;
}

// ---- extensions ----

// Returns a value for an input.  now: its current one.
static double choose_value(const Lockstep *l, const MutantInput *in, double now)
{
    MutantSearch *k = l->k;

    if (in->type != SM_BOOL && l->arounds && random_below(k, 8) == 0) {
        const double by = l->around[random_below(k, l->arounds)];
        return random_below(k, 2) ? now + by : now - by;
    }

    if (in->type != SM_BOOL && l->arounds && random_below(k, 4) == 0) {
        const double a = l->around[random_below(k, l->arounds)], b = l->around[random_below(k, l->arounds)];
        return random_below(k, 2) ? a : (a + b) / 2;
    }
    if (in->value.n && (in->type == SM_BOOL || random_below(k, 8)))
        return in->value.at[random_below(k, in->value.n)];
    return k->v.number.n ? k->v.number.at[random_below(k, k->v.number.n)] : random_below(k, 2);
}

static uint64_t choose_duration(const Lockstep *l)
{
    MutantSearch *k = l->k;
    static const uint32_t plain[] = {1, 1, 2, 3, 5, 10, 30, 100, 300};
    const uint32_t which = random_below(k, 8);

    if (which == 0 && l->arounds) {
        const double steps = l->around[random_below(k, l->arounds)] / (double)k->delta_t + random_below(k, 3) - 1;
        if (steps >= 1 && steps <= (double)AROUND_MOST)
            return (uint64_t)steps;
    }
    if (which < 4 && k->v.hold.n)
        return k->v.hold.at[random_below(k, k->v.hold.n)];
    return plain[random_below(k, sizeof plain / sizeof *plain)];
}

// Changes some inputs from the next step on.  Adds the changes to *list.
static void change_inputs(Lockstep *l, Node *n, uint64_t duration, ScenarioChange *list, uint32_t *changes)
{
    MutantSearch *k = l->k;
    const bool is_first = n->steps == 0;

    for (uint32_t i = 0; i < k->v.input.n; i++) {
        Course *c = &n->course[i];
        ScenarioChange change = {n->steps + 1, k->v.input.at[i].var, SCENARIO_HOLD, 0, 0, 0};
        double now;
        if (k->v.input.at[i].is_stored ? !is_first || random_below(k, 4)
            : !is_first && random_below(k, k->v.readings < 3 ? 2 : k->v.readings / 2 + 1))
            continue;
        now = c->step ? value_at(l, n, c, n->steps + 1) : 0;
        change.a = choose_value(l, &k->v.input.at[i], now);
        if (!is_first && k->v.input.at[i].type != SM_BOOL && random_below(k, 5) == 0) {
            change.kind = SCENARIO_RAMP;
            change.b = (change.a - now) / (double)(duration ? duration : 1);
            change.a = now;
        }
        *c = change;
        list[(*changes)++] = change;
    }
}

static Node *choose_node(const Lockstep *l)
{
    MutantSearch *k = l->k;
    const uint32_t newest = l->node.n > 16 && random_below(k, 3) == 0 ? random_below(k, 16) : random_below(k, l->node.n);

    if (l->apart.n && random_below(k, 2))
        return l->apart.at[random_below(k, l->apart.n)];
    if (l->inside.n && random_below(k, 2))
        return l->inside.at[random_below(k, l->inside.n)];
    return l->node.at[l->node.n - 1 - newest];
}

// Stores a situation, if it is new.
static const Node *store_situation(Lockstep *l, const Node *n)
{
    Node *copy;

    if (l->node.n + l->apart.n >= NODES_MOST || !record_if_new(l, n))
        return NULL;
    copy = copy_node(l, n);
    if (copy->differs)
        vec_push(l->work, &l->apart, copy);
    else
        vec_push(l->work, &l->node, copy);
    if (!copy->differs && l->state && ((FlatState *)copy->original)->state == l->state->number)
        vec_push(l->work, &l->inside, copy);
    return copy;
}

// Continues a situation with other inputs for some time.  Returns whether a difference is visible; *n is then the last situation.
static bool extend_situation(Lockstep *l, Node *n, ScenarioChange *list)
{
    const uint64_t duration = choose_duration(l);
    uint32_t changes = 0;
    uint32_t state = ((FlatState *)n->original)->state;

    change_inputs(l, n, duration, list, &changes);
    n->change = list;
    n->changes = changes;
    for (uint64_t i = 0; i < duration && l->left; i++) {
        const FlatState *s = n->original;
        const Node *stored = NULL;
        if (run_step(l, n))
            return true;
        if (s->state != state || i + 1 == duration) {
            n->differs = has_diverged(l, n);
            stored = store_situation(l, n);
        }
        state = s->state;
        if (stored && stored->changes)                // only the first node of this extension has the changes; later ones follow it without changes
            ((Node *)stored)->change = arena_copy(l->work, list, changes * sizeof *list);
        if (stored) {
            n->parent = stored;
            n->changes = 0;
        }
    }
    return false;
}

// ---- the scenario ----

static Scenario *scenario_of(const Lockstep *l, Arena *arena, const Node *last)
{
    Scenario *s = ARENA_NEW(arena, Scenario);
    ScenarioChange *change;
    size_t n = 0;

    for (const Node *i = last; i; i = i->parent)
        n += i->changes;
    change = arena_array(arena, n + 2, sizeof *change);
    s->init_state = last->start;
    s->delta_t = l->k->delta_t;
    s->steps = last->steps;
    s->change = change;
    s->changes = n;
    for (const Node *i = last; i; i = i->parent) {
        n -= i->changes;
        if (i->changes)
            memcpy(change + n, i->change, i->changes * sizeof *change);
    }
    return s;
}

static Course *course_of(const Lockstep *l, const Node *n, uint32_t var)
{
    for (uint32_t i = 0; i < l->k->v.input.n; i++)
        if (l->k->v.input.at[i].var == var)
            return &n->course[i];
    return NULL;
}

// Begins the changes of a scenario that belong to the next step.  *next: the first change that has not begun.
static void begin_changes(const Lockstep *l, const Node *n, const Scenario *s, size_t *next)
{
    for (; *next < s->changes && s->change[*next].step == n->steps + 1; (*next)++) {
        const ScenarioChange *c = &s->change[*next];
        Course *course = course_of(l, n, c->var);
        if (course)                                   // NULL: the machine does not read the variable
            *course = *c;
    }
}

// Runs a scenario from its start.  Returns whether a difference is visible, and sets s->steps to the first step in which it is.
static bool replay_scenario(Lockstep *l, Scenario *s)
{
    Node *n = new_start(l, s->init_state);
    size_t next = 0;

    while (n->steps < s->steps) {
        begin_changes(l, n, s, &next);
        l->replayed++;
        if (run_step(l, n)) {
            s->steps = n->steps;
            s->changes = next;
            return true;
        }
    }
    return false;
}

// Runs a scenario of `given`, and stores its new situations.  Returns whether a difference is visible; *n is then the last situation.
static bool run_given(Lockstep *l, Node *n, const Scenario *s)
{
    size_t next = 0, stored_at = 0;

    while (n->steps < s->steps && l->left > 0) {
        const Node *stored;
        begin_changes(l, n, s, &next);
        n->change = s->change + stored_at;
        n->changes = (uint32_t)(next - stored_at);
        if (run_step(l, n))
            return true;
        n->differs = has_diverged(l, n);
        if ((stored = store_situation(l, n)) != NULL) {
            n->parent = stored;
            stored_at = next;
        }
    }
    return false;
}

// Leaves out the changes without which the difference is still visible: first many at once, then each.
static void remove_needless_changes(Lockstep *l, Arena *arena, Scenario *s)
{
    for (size_t n = s->changes / 2 ? s->changes / 2 : 1; n > 0; n /= 2)
        for (size_t end = s->changes; end >= n && l->replayed < MINIMISE_STEPS; end -= n) {
            Scenario shorter = *s;
            ScenarioChange *change = arena_array(arena, s->changes + 2, sizeof *change);
            if (end > s->changes)
                continue;
            memcpy(change, s->change, (end - n) * sizeof *change);
            memcpy(change + end - n, s->change + end, (s->changes - end) * sizeof *change);
            shorter.change = change;
            shorter.changes -= n;
            if (replay_scenario(l, &shorter))
                *s = shorter;
        }
}

// Replaces *s by a scenario with these changes, if the difference is still visible.
static void try_changes(Lockstep *l, Scenario *s, const ScenarioChange *change, uint64_t steps)
{
    Scenario other = *s;

    if (l->replayed >= 2 * MINIMISE_STEPS)
        return;
    other.change = change;
    other.steps = steps;
    if (replay_scenario(l, &other))
        *s = other;
}

// Makes a scenario easier to read: each ramp becomes its last value, and the first change is in the first step.
static void simplify_scenario(Lockstep *l, Arena *arena, Scenario *s)
{
    ScenarioChange *change;

    for (size_t i = 0; i < s->changes; i++) {
        if (s->change[i].kind != SCENARIO_RAMP)
            continue;
        change = arena_copy(arena, s->change, (s->changes + 1) * sizeof *change);
        change[i].a += change[i].b * (double)(s->steps - change[i].step);
        change[i].b = 0;
        change[i].kind = SCENARIO_HOLD;
        try_changes(l, s, change, s->steps + 1);
    }
    for (size_t first = 0; first < s->changes; first++) {
        const uint64_t before = first ? s->change[first - 1].step : 1, by = s->change[first].step - before;
        if (by == 0)
            continue;
        change = arena_copy(arena, s->change, (s->changes + 1) * sizeof *change);
        for (size_t i = first; i < s->changes; i++)
            change[i].step -= by;
        if (first == 0 || change[first].var != change[first - 1].var)
            try_changes(l, s, change, s->steps - by + 1);
    }
}

// Returns the scenario of a run whose last step shows a difference, without the changes that it does not need.
static const Scenario *finish_scenario(Lockstep *l, Arena *out, const Node *last, const Var **what)
{
    Scenario *s = scenario_of(l, l->work, last), *result = ARENA_NEW(out, Scenario);

    l->left = UINT64_MAX;
    remove_needless_changes(l, l->work, s);
    simplify_scenario(l, l->work, s);
    replay_scenario(l, s);
    *result = *s;
    result->change = arena_copy(out, s->change, (s->changes + 1) * sizeof *s->change);
    *what = l->what;
    return result;
}

// Copies the stored situation `from` to *at, so that it can be continued.
static void begin_at(const Lockstep *l, Node *at, const Node *from)
{
    void *original = at->original, *mutant = at->mutant;
    Course *course = at->course;

    *at = (Node){.parent = from, .start = from->start, .steps = from->steps, .original = original, .mutant = mutant, .course = course};
    memcpy(original, from->original, l->k->original->size);
    memcpy(mutant, from->mutant, l->mutant->size);
    memcpy(course, from->course, (l->k->v.input.n + 1) * sizeof *course);
}

// Makes the changes of the last extension a part of the path, although its situation was not stored.
static void continue_path(const Lockstep *l, Node *n, const ScenarioChange *list)
{
    Node *before = arena_copy(l->work, n, sizeof *n);

    if (n->changes == 0)
        return;
    before->change = arena_copy(l->work, list, n->changes * sizeof *list);
    n->parent = before;
    n->changes = 0;
}

static void add_start(Lockstep *l, Node *n)
{
    vec_push(l->work, &l->node, n);
    if (n->start == l->state)
        vec_push(l->work, &l->inside, n);
}

const Scenario *mutant_search_run(MutantSearch *k, Arena *out, Arena *work, const MutantTarget *t, uint64_t steps, const Var **what)
{
    Lockstep *l = ARENA_NEW(work, Lockstep);
    ScenarioChange *list = arena_array(work, k->v.input.n + 1, sizeof *list);
    Node *at = NULL;

    *l = (Lockstep){.k = k, .work = work, .mutant = t->mutant, .state = t->state, .around = t->around, .arounds = t->arounds, .left = steps};
    l->same_layout = flat_have_same_layout(k->p, k->original, t->mutant);
    k->random = 1;
    for (uint32_t i = 0; i < k->starts; i++)
        add_start(l, new_start(l, k->start[i]));
    if (t->from && run_given(l, at = new_start(l, t->from->init_state), t->from))
        return finish_scenario(l, out, at, what);
    for (uint32_t i = 0; i < k->givens; i++)
        if (run_given(l, at = new_start(l, k->given[i].init_state), &k->given[i]))
            return finish_scenario(l, out, at, what);
    at = new_start(l, k->start[0]);
    while (l->left) {
        begin_at(l, at, choose_node(l));
        do {
            if (extend_situation(l, at, list))
                return finish_scenario(l, out, at, what);
            continue_path(l, at, list);
        } while (random_below(k, CONTINUE_ONE_IN));
    }
    return NULL;
}
