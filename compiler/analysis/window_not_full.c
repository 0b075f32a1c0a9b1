// SPDX-License-Identifier: Apache-2.0
// Reports rolling windows whose statistics decide a guard before the window is full.
//
// Two machines run side by side from a situation in which windows have few samples.  In one of them a window is filled first, with
// earlier readings.  If that machine does nothing while the other makes a transition or switches an output on, the reason is the missing
// samples.  The finding is at the first guard whose value differs between the two; its branch may only set a variable that has an effect
// later.
//
// Only situations that are reached without a command and in a known number of steps are checked.  A person is assumed to wait until
// windows are full, and so is a timer if the length of a step is unknown.
#include <string.h>

#include "compiler/analysis/trial_checks.h"

enum {
    ENTRIES_TRIED = 8,            // how many situations at the entry of a state are tried
    DRAWS_MAX = 500,              // inputs tried from each situation, for each window
    STATS_OF_SAMPLES = (1 << SM_STAT_OLDEST) - 1,     // bit set of SmStat: statistics of all samples, such as the average
    STEPS_FOLLOWED = 60           // steps, not counting skipped ones, that are run after windows are full
};
static const uint64_t work_max = 30000000;          // the most IR instructions that this check executes
static const double noise[] = {0.001, 0.02, 0.3, 5, 100};          // noises that are tried, in units of TrialInput.scale
enum { NOISES = sizeof noise / sizeof *noise };

typedef struct WindowTrial {
    Trials *t;
    void *full, *few, *filled;    // situations: with a full window; with few samples; a temporary one
    uint32_t window;              // index in IrMachine.window of the window that is full in `full`
    double *in, *now;             // inputs without noise; inputs of this step
    IrTrace few_did, full_did;    // what the last step of each machine has executed
    double noise;                 // largest noise on sensors, in units of TrialInput.scale
    double *earlier;              // the inputs whose samples fill the window in `full`
    double *before, *before_full; // variables before a step
    bool same;                    // this trial assumes that sensors have had their current readings since the machine's start
    bool later;                   // both windows are full, or both machines are in another state: a difference from here on has an earlier cause
    const Stmt *guard;            // the first guard whose value differed between the two machines
    uint32_t samples;             // number of samples in the window when that guard differed
    uint64_t until;               // value of Trials.run.work at which the search stops
    uint32_t *deciding;           // by Stmt.number of a guard: the window whose samples decided the guard
    uint32_t *found;              // by Stmt.number of a guard: the fewest samples with which that window decided the guard; 0: it has not
} WindowTrial;

// ---- inputs ----

// Sets the inputs of the next sample, with noise.
static void set_inputs(WindowTrial *w)
{
    const Trials *t = w->t;

    memcpy(w->now, w->in, t->inputs * sizeof *w->now);
    trial_add_noise(w->t, w->now, w->noise);
}

static void fill_inputs(void *context, double *vars, uint32_t sample)
{
    WindowTrial *w = context;

    (void)sample;
    set_inputs(w);
    trial_store_inputs(w->t, vars, w->now);
}

// ---- one trial ----

// Whether an output is on in the machine with few samples and off in the other.
static bool switches_on(const WindowTrial *w)
{
    const double *few = ir_run_vars(w->t->run, w->few), *full = ir_run_vars(w->t->run, w->full);

    for (uint32_t v = 0; v < w->t->run->m->var.n; v++)
        if (w->t->actuator[v] && few[v] != 0 && full[v] == 0)
            return true;
    return false;
}

// Finds the first guard with different results in the two machines, and stores it in w->guard.
static void find_differing_guard(WindowTrial *w, uint32_t samples)
{
    const uint32_t n = samples > w->t->window ? 0 : w->few_did.n < w->full_did.n ? w->few_did.n : w->full_did.n;

    for (uint32_t k = 0; k < n && !w->guard; k++)
        if (w->few_did.at[k] != w->full_did.at[k]) {
            if (w->few_did.at[k] >> 1 == w->full_did.at[k] >> 1) {
                w->guard = w->t->stmt[w->few_did.at[k] >> 1];
                w->samples = samples;
            }
            return;
        }
}

typedef enum FillOutcome { SAME, FULL_ACTS, FEW_DECIDE } FillOutcome;

// Compares the two machines after a step.  A transition or output by the machine with the full window is not a finding.
static FillOutcome compare_after_step(WindowTrial *w, uint32_t samples)
{
    const bool before = w->guard && w->later;         // a guard has differed before, without a visible effect

    find_differing_guard(w, samples);
    if (w->few_did.transition != w->full_did.transition)
        return w->guard && (w->full_did.transition == 0 || before) ? FEW_DECIDE : FULL_ACTS;
    w->later |= w->few_did.transition != 0;
    if (switches_on(w))
        return w->guard ? FEW_DECIDE : FULL_ACTS;
    return SAME;
}

// Continues both machines, with commands and passing time, until their outputs or transitions differ, because a wrong decision may have a
// visible effect only later, in another state.  Returns whether the machine with few samples acts.
static bool run_until_difference_shows(WindowTrial *w)
{
    Trials *t = w->t;
    const size_t size = t->run->m->var.n * sizeof *w->before;
    FillOutcome o = SAME;

    for (int n = 0; n < STEPS_FOLLOWED && o == SAME && !trial_is_same_situation(t, w->few, w->full); n++) {
        uint32_t leap, in_full;
        if (n % 10 == 9)
            trial_draw_inputs(t, w->in, NULL, true, false);
        memcpy(w->before, ir_run_vars(t->run, w->few), size);
        memcpy(w->before_full, ir_run_vars(t->run, w->full), size);
        trial_step(t, w->full, w->in, t->dt, &w->full_did);
        trial_step(t, w->few, w->in, t->dt, &w->few_did);
        o = compare_after_step(w, w->samples);
        if (w->few_did.transition)
            continue;
        leap = trial_steps_to_event(t, w->before, w->few);
        in_full = trial_steps_to_event(t, w->before_full, w->full);
        leap = in_full < leap ? in_full : leap;
        if (o == SAME && leap != TRIAL_MANY) {
            trial_skip_steps(t, w->before, w->few, leap);
            trial_skip_steps(t, w->before_full, w->full, leap);
        }
    }
    return o == FEW_DECIDE;
}

// Fills the window with `earlier` samples of the earlier readings, then with one sample of the last step's readings for each
// step so far.
static void fill_window(WindowTrial *w, const TrialEntry *e, void *situation, uint32_t earlier)
{
    Trials *t = w->t;
    double *in = w->in, usual = w->noise;

    trial_copy_situation(t, w->filled, e->situation);
    ir_run_clear_windows(t->run, w->filled);
    w->in = w->earlier;
    ir_run_fill_windows(t->run, w->filled, earlier, t->dt, fill_inputs, w);
    w->in = w->same ? in : e->in;
    w->noise = 0;                     // no noise: the samples must be equal in both machines
    ir_run_fill_windows(t->run, w->filled, e->steps, t->dt, fill_inputs, w);
    ir_run_copy_window(t->run, situation, w->filled, w->window);
    w->in = in;
    w->noise = usual;
}

// Runs two machines from e with the same inputs; in one of them the window is full of earlier readings.  Returns whether the other one,
// with few samples, makes a transition or switches an output on that the first does not.  glitch: an input that has the value `reading`
// in the first step only; or IR_NONE.
static bool run_with_few_samples(WindowTrial *w, const TrialEntry *e, uint32_t glitch, double reading)
{
    Trials *t = w->t;
    w->guard = NULL;
    w->later = false;
    trial_copy_situation(t, w->few, e->situation);
    trial_copy_situation(t, w->full, e->situation);
    fill_window(w, e, w->few, 0);
    fill_window(w, e, w->full, t->window);
    for (uint32_t n = 0; n < 2 * t->window; n++) {
        FillOutcome o;
        set_inputs(w);
        if (n == 0 && glitch != IR_NONE)
            trial_set_group(t, w->now, glitch, reading);
        trial_step(t, w->full, w->now, t->dt, &w->full_did);
        trial_step(t, w->few, w->now, t->dt, &w->few_did);
        o = compare_after_step(w, e->steps + n + 1);
        if (o != SAME)
            return o == FEW_DECIDE;
        if (w->few_did.transition && !w->guard && t->a->step == 0 && t->by_time[w->few_did.transition])
            return false;
        w->later |= e->steps + n >= t->window;
        if (e->steps + n >= t->window)
            return w->guard && run_until_difference_shows(w);
    }
    return false;
}

// ---- findings ----

// The search for the statistic of the deciding window that a guard reads.
typedef struct RollSearch {
    const WindowTrial *w;
    const Expr *roll;             // the roll call that was found; NULL: not yet found
    const Var *through;           // if the guard reads the statistic only through a variable: that variable; else NULL
    const Var *stored;            // the variable whose stores are being searched
    int depth;
} RollSearch;

static void find_roll(Expr *e, void *context);

// Continues the search in the value that `s` stores, if it is a store to f->stored.
static void find_roll_in_store(const Stmt *s, void *context)
{
    RollSearch *f = context;

    if (s->kind == ST_ASSIGN && s->var == f->stored)
        expr_walk(s->value, find_roll, f);
}

// If e is a statistic of the window, stores e in f->roll.  If e is a variable, searches the values that are stored to the variable.
static void find_roll(Expr *e, void *context)
{
    RollSearch *f = context;

    if (e->kind == EX_ROLL && !f->roll && f->w->t->a->m->window_of[e->window] == f->w->window)
        f->roll = e;
    if (e->kind == EX_VAR && e->var->written && !f->roll && f->depth < 4) {
        const Var *outer = f->stored;
        f->stored = e->var;
        f->depth++;
        each_stmt(f->w->t->a->p, find_roll_in_store, f);
        f->depth--;
        f->stored = outer;
        if (f->roll && !f->through)
            f->through = e->var;
    }
}

static void report_guard(const WindowTrial *w)
{
    const Analysis *a = w->t->a;
    RollSearch f = {.w = w};
    const char *text, *reason;
    uint32_t size;
    Diag *d;

    expr_walk(w->guard->value, find_roll, &f);
    if (!f.roll)
        return;
    text = source_text(a->arena, f.roll->span);
    size = a->p->window.at[f.roll->window].size;
    if (w->samples >= size)       // the window is full now, so the cause is a value that the machine stored earlier
        reason = format_in(a->arena, "it reads what was stored before the window of '%s' was full", text);
    else
        reason = format_in(a->arena, "the window of '%s' has %lu of %lu samples", text, (unsigned long)w->samples, (unsigned long)size);
    d = diag_report(a->diags, DIAG_window_not_full, w->guard->value->span, reason);
    if (f.through)
        diag_note(a->diags, d, f.roll->span, DIAG_note_statistic_here, f.through->name->text);
}

// Chooses w->earlier, the readings before the start.  kind 0: the current readings; 1: other readings; 2: far too high; 3: far too low.
static void choose_earlier_readings(WindowTrial *w, uint32_t kind)
{
    Trials *t = w->t;

    memcpy(w->earlier, w->in, t->inputs * sizeof *w->in);
    if (kind == 1)
        trial_draw_inputs(t, w->earlier, NULL, false, false);
    for (uint32_t i = 0; i < t->inputs && kind > 1; i++)
        if (!t->input[i].command)
            w->earlier[i] = (kind == 2 ? 1e5 : -1e5) * t->input[i].scale;
}

// Tries an entry of a state with glitches of the inputs: does a guard decide before its window is full?
static void try_entry(WindowTrial *w, const TrialState *s, const TrialEntry *e)
{
    Trials *t = w->t;
    const uint32_t windows = t->run->m->window.n;

    for (uint32_t n = 0; n < DRAWS_MAX * windows && t->run->work < w->until; n++) {
        const uint32_t glitch = t->inputs == 0 || trial_random_below(t, 3) == 0 ? IR_NONE : trial_random_below(t, t->inputs);
        uint32_t *least;
        double reading;
        w->window = n % windows;
        if (!(t->run->m->window.at[w->window].stats & STATS_OF_SAMPLES))       // prev, held and similar have no size to fill
            continue;
        memcpy(w->in, e->in, t->inputs * sizeof *w->in);
        trial_draw_inputs(t, w->in, s, true, false);
        w->same = trial_random_below(t, 2);
        choose_earlier_readings(w, trial_random_below(t, 4));
        w->noise = trial_random_below(t, 2) ? 0 : noise[trial_random_below(t, NOISES)];
        if (glitch != IR_NONE && t->input[glitch].command)
            continue;
        reading = glitch == IR_NONE ? 0 : t->input[glitch].reading[trial_random_below(t, t->input[glitch].readings)];
        if (!run_with_few_samples(w, e, glitch, reading))
            continue;
        least = &w->found[w->guard->number];          // one finding per guard: the trial with the fewest samples
        if (*least == 0 || w->samples < *least) {
            *least = w->samples;
            w->deciding[w->guard->number] = w->window;
        }
    }
}

// Returns the first entries of a state, at most ENTRIES_TRIED, from which windows are filled.  Stores their number in *n.
static const TrialEntry *const *choose_entries(const Trials *t, const TrialState *s, uint32_t *n)
{
    const TrialEntry **out = ARENA_ARRAY(t->a->arena, const TrialEntry *, ENTRIES_TRIED);

    *n = 0;
    for (size_t k = 0; k < s->entry.n && *n < ENTRIES_TRIED; k++) {
        const TrialEntry *e = &s->entry.at[k];
        if (e->steps != TRIAL_MANY && e->steps + 1 < t->window && !e->commanded && !e->unhealthy)
            out[(*n)++] = e;
    }
    return out;
}

// Tries the entries of all states.  Each has an equal share of the effort that remains.
static void try_entries(WindowTrial *w)
{
    const Trials *t = w->t;
    const uint64_t until = t->run->work + work_max / t->share;
    uint32_t left = 0, n;

    for (size_t s = 0; s < t->a->p->state.n; s++) {
        choose_entries(t, &t->state[s], &n);
        left += n;
    }
    for (size_t s = 0; s < t->a->p->state.n; s++) {
        const TrialEntry *const *entry = choose_entries(t, &t->state[s], &n);
        for (uint32_t k = 0; k < n; k++, left--) {
            w->until = t->run->work + (until > t->run->work ? (until - t->run->work) / left : 0);
            try_entry(w, &t->state[s], entry[k]);
        }
    }
}

// Finds guards that a window decides before the window is full.
void check_window_not_full(Trials *t)
{
    WindowTrial w = {.t = t, .in = trial_new_inputs(t), .now = trial_new_inputs(t)};

    if (t->window < 2)
        return;
    w.deciding = ARENA_ARRAY(t->a->arena, uint32_t, t->a->p->stmts + 1u);
    w.found = ARENA_ARRAY(t->a->arena, uint32_t, t->a->p->stmts + 1u);
    w.earlier = trial_new_inputs(t);
    w.before = ARENA_ARRAY(t->a->arena, double, t->run->m->var.n);
    w.before_full = ARENA_ARRAY(t->a->arena, double, t->run->m->var.n);
    w.full = arena_alloc(t->a->arena, t->run->size);
    w.filled = arena_alloc(t->a->arena, t->run->size);
    w.few = arena_alloc(t->a->arena, t->run->size);
    w.few_did.at = ARENA_ARRAY(t->a->arena, uint32_t, t->a->p->stmts + 2u);
    w.full_did.at = ARENA_ARRAY(t->a->arena, uint32_t, t->a->p->stmts + 2u);
    try_entries(&w);
    for (uint32_t n = 1; n <= t->a->p->stmts; n++)
        if (w.found[n] > 0) {
            w.guard = t->stmt[n];
            w.samples = w.found[n];
            w.window = w.deciding[n];
            report_guard(&w);
        }
}
