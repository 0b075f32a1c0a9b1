// SPDX-License-Identifier: Apache-2.0
// Reports latches and extremes that decide a state again with what they have seen when the machine was last in it.
//
// Judges a variable that no state sets before the machine first comes to the state that reads it: there its value is a former visit's, unless
// something resets it on the way.  Two machines run side by side from the same entry of the state and with the same inputs.  In one of them the
// variable has the value of a former visit, in the other its initial value.  Reported if only the first one makes a transition that reads the
// variable, and an output goes on in it.
//
// What leads to an @abort state is abort_latch.c's, and what missing_reset.c has reported is not reported again.
#include <string.h>

#include "compiler/analysis/abort.h"
#include "compiler/analysis/carried.h"
#include "compiler/analysis/trial_checks.h"
#include "stdlib/math.h"

enum {
    ENTRIES_TRIED = 4,            // situations at the entry of the state
    DRAWS = 16,                   // inputs tried in each of them
    EVENTS_MAX = 40,              // ends of timers that a run waits for
    AFTER = 3,                    // steps after the transition until the outputs of the two machines are compared
    OUTPUTS_NAMED = 4
};
static const uint64_t effort_in_all = 30000000;       // in instructions

typedef struct StaleTrial {
    Trials *t;
    CarriedTable carried;
    AbortBound bound;
    bool *mark;                   // scratch, by State.number - 1
    const Var *v;                 // the variable
    uint32_t var;                 // its index in IrMachine.var
    double value;                 // its value after a former visit
    void *stale, *fresh;          // the situations of the two machines: with this value, and with the initial one
    double *in, *before, *before_fresh;
    uint64_t until;               // value of run->work at which the check ends
} StaleTrial;

// ---- variables ----

static bool reads(const Condition *when, const Var *v)
{
    while (when && !expr_reads(when->stmt->value, v))
        when = when->outer;
    return when != NULL;
}

// Marks the states that the machine can come to before it is in `s` for the first time.
static void mark_before(StaleTrial *k, const State *s)
{
    const Analysis *a = k->t->a;
    bool grown = s->number != 1;

    memset(k->mark, 0, a->p->state.n * sizeof *k->mark);
    k->mark[0] = grown;
    while (grown) {
        grown = false;
        for (size_t i = 0; i < a->transition.n; i++) {
            const Transition *way = &a->transition.at[i];
            if (!k->mark[way->from->number - 1] || k->mark[way->to->number - 1] || way->to == s || !a->stmt[way->stmt->number].reached)
                continue;
            k->mark[way->to->number - 1] = grown = true;
        }
    }
}

// Returns an assignment that sets the variable and from which the machine comes to the state again without a reset.  NULL: no
// assignment does so, or a state sets the variable before the first visit.
static const CarriedStore *find_former_set(StaleTrial *k, size_t v, const State *s)
{
    const Carried *c = &k->carried.of[v];
    const CarriedStore *found = NULL;

    mark_before(k, s);
    for (size_t i = 0; i < c->store.n; i++)
        if (!c->store.at[i].resets && k->mark[c->store.at[i].state->number - 1])
            return NULL;
    for (size_t i = 0; i < c->store.n && !found; i++) {
        const CarriedStore *set = &c->store.at[i];
        if (set->resets || !k->t->a->stmt[set->stmt->number].reached)
            continue;
        memset(k->mark, 0, k->t->a->p->state.n * sizeof *k->mark);
        carried_mark_reached(&k->carried, v, set->state, k->mark);
        found = k->mark[s->number - 1] ? set : NULL;
    }
    return found;
}

// Returns the value of a variable after a former visit: true for a latch, and for an extreme the value of all trials that is farthest
// from the initial value.  The initial value: no trial has had another one.
static double find_value(const StaleTrial *k, CarriedKind kind)
{
    const Trials *t = k->t;
    const double initial = t->run->initial[k->var];
    double value = initial;

    if (kind == CARRIED_LATCH)
        return 1;
    for (size_t s = 0; s < t->a->p->state.n; s++)
        for (size_t e = 0; e < t->state[s].entry.n; e++) {
            const double x = trial_vars(t, t->state[s].entry.at[e].situation)[k->var];
            if (!t->state[s].entry.at[e].unhealthy && sm_abs(x - initial) > sm_abs(value - initial))
                value = x;
        }
    return value;
}

static bool is_reported(const StaleTrial *k, const Carried *c)
{
    const Diags *all = k->t->a->diags;
    bool is = false;

    for (size_t i = 0; i < all->list.n && !is; i++)
        for (size_t n = 0; n < c->store.n && !is; n++)
            is = all->list.at[i]->code == DIAG_never_reset && all->list.at[i]->span.at == c->store.at[n].stmt->span.at;
    return is;
}

// ---- runs ----

// Runs both machines until the first one makes a transition.  Returns it; NULL: it makes none, or the second one makes one first.
static const Transition *run_both(StaleTrial *k)
{
    Trials *t = k->t;
    const size_t vars = t->run->m->var.n * sizeof *k->before;

    for (int events = 0, steps = 0; events < EVENTS_MAX && t->run->work < k->until; steps++) {
        uint32_t n, fresh;
        memcpy(k->before, trial_vars(t, k->stale), vars);
        memcpy(k->before_fresh, trial_vars(t, k->fresh), vars);
        trial_step(t, k->fresh, k->in, t->dt, &t->trace);
        if (t->trace.transition)
            return NULL;
        trial_step(t, k->stale, k->in, t->dt, &t->trace);
        if (t->trace.transition)
            return t->transition[t->trace.transition];
        if ((uint32_t)steps <= t->window)
            continue;
        n = trial_steps_to_event(t, k->before, k->stale);
        fresh = trial_steps_to_event(t, k->before_fresh, k->fresh);
        events++;
        n = fresh < n ? fresh : n;
        if (n == TRIAL_MANY)
            return NULL;
        trial_skip_steps(t, k->before, k->stale, n);
        trial_skip_steps(t, k->before_fresh, k->fresh, n);
    }
    return NULL;
}

// Goes on with both.  Returns how many outputs are on in the first machine only, and lists them; 0 if the second one leaves its state, too.
static uint32_t find_outputs_on(StaleTrial *k, const Var **output)
{
    Trials *t = k->t;
    const double *on = trial_vars(t, k->stale), *off = trial_vars(t, k->fresh);
    uint32_t n = 0;

    for (uint32_t step = 0; step < AFTER + t->window; step++) {
        if (step < AFTER)
            trial_step(t, k->stale, k->in, t->dt, &t->trace);
        trial_step(t, k->fresh, k->in, t->dt, &t->trace);
        if (t->trace.transition)
            return 0;
    }
    for (uint32_t v = 0; v < t->run->m->var.n && n < OUTPUTS_NAMED; v++)
        if (t->actuator[v] && on[v] != 0 && off[v] == 0)
            output[n++] = t->var[v];
    return n;
}

static void report_stale(const StaleTrial *k, const CarriedStore *set, const Transition *taken, double time, const Var *const *output, uint32_t n)
{
    const Analysis *a = k->t->a;
    const char *v = k->v->name->text;
    const char *value = const_text(a->arena, trial_check_round(k->value));
    Diag *d = diag_report(a->diags, DIAG_stale_latch, taken->stmt->span, taken->from->name->text, v, value, taken->to->name->text);

    diag_note_declaration(a->diags, d, DIAG_OUTPUTS, k->v->span);
    diag_note(a->diags, d, set->stmt->span, DIAG_note_set_and_kept, v, taken->from->name->text);
    diag_note(a->diags, d, (Span){0}, DIAG_note_stale_example, const_text(a->arena, time), trial_check_join_names(a->arena, output, n), v,
              taken->from->name->text);
}

// Tries inputs from one entry of the state.  Returns whether a finding was reported.
static bool try_entry(StaleTrial *k, const TrialEntry *e, const CarriedStore *set)
{
    Trials *t = k->t;
    const TrialState *s = &t->state[trial_state(e->situation) - 1];
    const Var *output[OUTPUTS_NAMED];

    if (trial_vars(t, e->situation)[k->var] != t->run->initial[k->var])
        return false;
    for (int n = 0; n < DRAWS && trial_may_continue(t) && t->run->work < k->until; n++) {
        const Transition *taken;
        uint32_t outputs;
        double time;
        trial_begin_at_entry(t, e, k->fresh, k->in);
        if (n > 0)
            trial_draw_inputs(t, k->in, s, false, false);
        trial_copy_situation(t, k->stale, k->fresh);
        ir_run_vars(t->run, k->stale)[k->var] = k->value;
        taken = run_both(k);
        if (!taken || !reads(taken->when, k->v) || k->bound.bound[taken->to->number - 1])
            continue;
        time = trial_vars(t, k->stale)[t->run->m->t];
        outputs = find_outputs_on(k, output);
        if (outputs > 0)
            report_stale(k, set, taken, time, output, outputs);
        if (outputs > 0)
            return true;
    }
    return false;
}

static void check_variable(StaleTrial *k, size_t v)
{
    Trials *t = k->t;
    const Carried *c = &k->carried.of[v];
    bool found = false;

    k->v = t->a->p->var.at[v];
    k->var = t->a->m->var_of[v];
    if (k->var == IR_NONE || c->unclear || is_reported(k, c))
        return;
    k->value = find_value(k, c->kind);
    for (size_t g = 0; g < c->guard.n && !found && k->value != t->run->initial[k->var]; g++) {
        const State *s = c->guard_state.at[g];
        const TrialState *entries = &t->state[s->number - 1];
        const CarriedStore *set = entries->reached && !s->is_abort ? find_former_set(k, v, s) : NULL;
        for (size_t e = 0; set && e < entries->entry.n && e < ENTRIES_TRIED && !found; e++)
            found = try_entry(k, &entries->entry.at[e], set);
        t->pattern = NULL;
    }
}

// Finds latches and extremes that end a state at once when the machine comes to it again.
void check_stale_latch(Trials *t)
{
    Arena *arena = t->a->arena;
    StaleTrial k = {.t = t, .carried = carried_of(t->a), .bound = abort_find_bound(t->a), .mark = ARENA_ARRAY(arena, bool, t->a->p->state.n)};

    k.stale = arena_alloc(arena, t->run->size);
    k.fresh = arena_alloc(arena, t->run->size);
    k.in = trial_new_inputs(t);
    k.before = ARENA_ARRAY(arena, double, t->run->m->var.n);
    k.before_fresh = ARENA_ARRAY(arena, double, t->run->m->var.n);
    k.until = t->run->work + effort_in_all / t->share;
    for (size_t v = 0; v < t->a->p->var.n; v++)
        if (k.carried.of[v].kind == CARRIED_LATCH || k.carried.of[v].kind == CARRIED_EXTREME)
            check_variable(&k, v);
}
