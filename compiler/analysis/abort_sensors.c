// SPDX-License-Identifier: Apache-2.0
// What the ability to abort depends on: trials in which a sensor has failed, and trials without any command.
//
// A state can abort if some trial from it reaches an @abort state, directly or through states that lead nowhere else.  It is
// reported as unable to abort only if both agree: no trial aborts, and every transition that could depends on the failed
// sensor.
#include "compiler/analysis/abort.h"
#include "compiler/analysis/trial_checks.h"

enum {
    TRIED = 4,                    // entries of a state that are tried
    ENTRIES = 8,                  // the same, for a state that begins again
    LIVES = 80,                   // trials before the search concludes that none aborts
    CHANGES = 4,                  // of the inputs in one trial
    WORK = 400000                 // instructions spent on one question
};

typedef struct Failed { uint32_t input; double reading; } Failed;

typedef struct Asking {
    Trials *t;
    const AbortBound *b;
    const Sensors *s;
    void *at;
    double *in;
    bool commands;                // the trial may give any command
    const Failed *failed;         // or NULL
    bool left_at_once, left;      // some trial left the state within two steps; or later, but before windows were full; both not to abort
    bool stayed;                  // some trial stayed in the state until windows were full
    bool aborted;                 // some trial aborted
    bool driven;                  // an output was on during a trial
    uint64_t until;               // value of Trials.run.work at which the question stops
} Asking;

typedef enum Fate { STAYS, ABORTS, LEAVES } Fate;

// ---- trials ----

static Fate fate(Asking *k, uint32_t state)
{
    Trials *t = k->t;
    const double *var = ir_run_vars(t->run, k->at);

    if (trial_state(k->at) != state)
        return k->b->bound[trial_state(k->at) - 1] ? ABORTS : LEAVES;
    for (uint32_t v = 0; v < t->run->m->var.n && !k->driven; v++)
        k->driven = t->actuator[v] && var[v] != 0;
    return STAYS;
}

static Fate step(Asking *k, uint32_t state)
{
    if (k->failed)
        k->in[k->failed->input] = k->failed->reading;
    trial_step(k->t, k->at, k->in, k->t->dt, &k->t->trace);
    return fate(k, state);
}

static Fate hold(Asking *k, uint32_t state)
{
    Trials *t = k->t;
    Fate f = STAYS;

    for (uint32_t n = t->window + 5; n > 0 && f == STAYS; n--) {
        f = step(k, state);
        *(n > t->window + 3 ? &k->left_at_once : &k->left) |= f == LEAVES;
    }
    k->stayed |= f == STAYS;
    for (int n = 0, idle = 0; n < TRIAL_PASSES && f == STAYS && idle < 2; n++) {
        idle = trial_pass(t, k->at, k->in, &t->trace) ? 0 : idle + 1;
        f = fate(k, state);
    }
    return f;
}

static void begin(Asking *k, const TrialEntry *e)
{
    trial_begin(k->t, e, k->at, k->in);
    if (k->failed) {
        k->in[k->failed->input] = k->failed->reading;
        trial_fill_windows(k->t, k->at, k->in);
    }
}

static bool aborts_from(Asking *k, const TrialEntry *e)
{
    Trials *t = k->t;
    const uint32_t state = trial_state(e->situation);

    for (int n = 0; n < LIVES && t->run->work < k->until; n++) {
        Fate f = STAYS;
        begin(k, e);
        for (int c = 0; c < CHANGES && f == STAYS; c++) {
            trial_draw(t, k->in, &t->state[state - 1], k->commands, true);
            if (c == 0 && n % 2)
                f = step(k, state);
            if (f == STAYS)
                f = hold(k, state);
        }
        if (f == ABORTS)
            return true;
    }
    return false;
}

// Whether some trial aborts, with or without commands, and with or without a failed sensor.
static bool can_abort(Asking *k, const AbortRow *r, bool commands, const Failed *failed)
{
    const TrialState *s = &k->t->state[r->state->number - 1];
    bool found = false;

    k->commands = commands;
    k->failed = failed;
    k->stayed = k->left = k->left_at_once = false;
    k->until = k->t->run->work + WORK;
    for (size_t n = 0; n < s->entry.n && n < TRIED && !found; n++)
        found = aborts_from(k, &s->entry.at[n]);
    k->failed = NULL;
    k->aborted = found;
    return found || !k->stayed;
}

// ---- inputs of the paths ----

static void note_looks(Asking *k, AbortWay *w)
{
    const Looks l = looks_of_condition(k->s, w->first->when);

    w->sensor = ARENA_ARRAY(k->t->a->arena, const Var *, l.n + 1);
    for (; w->sensors < l.n; w->sensors++)
        w->sensor[w->sensors] = l.sensor[w->sensors];
    w->by_time = l.time;
    w->by_input = l.input;
}

static bool is_by_command_alone(const AbortWay *w) { return w->by_input && w->sensors == 0 && !w->by_time; }

// Whether every transition to an abort that needs no person depends on this sensor.
static bool all_look_at(const AbortRow *r, const Var *v)
{
    bool any = false;

    for (size_t w = 0; w < r->way.n; w++) {
        const AbortWay *way = &r->way.at[w];
        bool looks = false;
        for (size_t i = 0; i < way->sensors; i++)
            looks |= way->sensor[i] == v;
        if (!looks && abort_is_sure(way) && !is_by_command_alone(way))
            return false;
        any |= looks && abort_is_sure(way);
    }
    return any;
}

static bool all_by_command(const AbortRow *r)
{
    for (size_t w = 0; w < r->way.n; w++)
        if (abort_is_sure(&r->way.at[w]) && !r->way.at[w].by_input)
            return false;
    return true;
}

static bool any_sure(const AbortRow *r)
{
    for (size_t w = 0; w < r->way.n; w++)
        if (abort_is_sure(&r->way.at[w]))
            return true;
    return false;
}

// ---- a sensor that has failed ----

static bool cannot_at(Asking *k, const AbortRow *r, uint32_t input, double reading)
{
    const Failed f = {input, reading};

    return !can_abort(k, r, false, &f) || (!k->stayed && !k->aborted && k->left && !k->left_at_once);
}

// A reading that no healthy sensor delivers must not lead to any other state either.
static bool is_blind_at(Asking *k, const AbortRow *r, uint32_t input, double reading)
{
    return cannot_at(k, r, input, reading) || (!k->stayed && !k->aborted && k->left_at_once);
}

// Tries 0 and the readings outside the range, as far as the type can represent them.
static void ask_blind(Asking *k, AbortRow *r, uint32_t input)
{
    const TrialInput *i = &k->t->input[input];
    const Fact type = fact_of_type(i->v->type);
    const bool ranged = i->v->range != NULL;
    const bool zero = is_blind_at(k, r, input, 0);
    const bool below = ranged && fact_below(type, i->lo) >= type.lo && is_blind_at(k, r, input, fact_below(type, i->lo)) &&
                       is_blind_at(k, r, input, i->lo - i->scale);
    const bool above = ranged && fact_above(type, i->hi) <= type.hi && is_blind_at(k, r, input, fact_above(type, i->hi)) &&
                       is_blind_at(k, r, input, i->hi + i->scale);
    Arena *arena = k->t->a->arena;
    const bool say_zero = zero && !(below && i->lo > 0) && !(above && i->hi < 0);

    if (!zero && !below && !above)
        return;
    r->blind = i->v;
    r->blind_at = format_in(arena, "%s%s%s%s%s", say_zero ? "0" : "", say_zero && (below || above) ? " or " : "",
                            below ? format_in(arena, "less than %s", const_text(arena, i->lo)) : "", below && above ? " or " : "",
                            above ? format_in(arena, "more than %s", const_text(arena, i->hi)) : "");
}

static void ask_single(Asking *k, AbortRow *r, uint32_t input)
{
    const TrialInput *i = &k->t->input[input];

    for (uint32_t n = 0; n < i->readings; n++) {
        const double x = i->reading[(n + i->readings / 2) % i->readings];
        if (x == 0 || !trial_is_healthy(i, x) || !cannot_at(k, r, input, x))
            continue;
        r->single = i->v;
        r->stuck = x;
        return;
    }
}

// ---- state that remains from an earlier abort ----

// One entry can abort and the other cannot: finds a variable that a path reads and that differs between them.
static void note_latch(Asking *k, AbortRow *r, const TrialEntry *stuck, const TrialEntry *other)
{
    for (size_t w = 0; w < r->way.n && !r->latch; w++) {
        r->latch = trial_differing(k->t, r->way.at[w].first->when, stuck->situation, other->situation);
        r->latched = &r->way.at[w];
    }
    if (r->latch)
        r->latched_at = trial_vars(k->t, stuck->situation)[k->t->a->m->var_of[r->latch->index]];
}

static void ask_latch(Asking *k, AbortRow *r)
{
    const TrialState *s = &k->t->state[r->state->number - 1];
    const TrialEntry *can = NULL, *cannot = NULL;

    k->commands = true;
    for (size_t n = 0; n < s->entry.n && n < ENTRIES && !(can && cannot); n++) {
        k->stayed = false;
        k->until = k->t->run->work + WORK;
        if (aborts_from(k, &s->entry.at[n]))
            can = &s->entry.at[n];
        else if (k->stayed && k->t->run->work < k->until)
            cannot = &s->entry.at[n];
    }
    if (can && cannot)
        note_latch(k, r, cannot, can);
}

static void ask_row(Asking *k, AbortRow *r)
{
    Trials *t = k->t;

    if (t->state[r->state->number - 1].entry.n == 0)
        return;
    k->driven = false;
    r->by_itself = can_abort(k, r, false, NULL);
    r->by_command = any_sure(r) && !r->by_itself && all_by_command(r) && can_abort(k, r, true, NULL);
    r->drives = k->driven;
    if (!any_sure(r) || !r->by_itself)
        return;
    ask_latch(k, r);
    for (uint32_t i = 0; i < t->inputs && !(r->blind && r->single); i++)
        if (!t->input[i].command && all_look_at(r, t->input[i].v)) {
            if (!r->blind)
                ask_blind(k, r, i);
            if (!r->single)
                ask_single(k, r, i);
        }
}

void abort_ask(Trials *t, AbortMatrix *x, const AbortBound *b)
{
    Asking k = {.t = t, .b = b, .s = sensors_of(t->a), .at = arena_alloc(t->a->arena, t->run->size), .in = trial_new_inputs(t)};

    x->sensors = k.s;
    for (size_t s = 0; s < x->n; s++) {
        AbortRow *r = &x->row[s];
        for (size_t w = 0; w < r->way.n; w++)
            note_looks(&k, &r->way.at[w]);
        if (r->state->is_abort)
            continue;
        ask_row(&k, r);
    }
}
