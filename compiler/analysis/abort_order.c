// SPDX-License-Identifier: Apache-2.0
// Reports transitions that prevent an abort because they are written above it: the first transition whose guard is true is made.
//
// A trial shows it: in one step both guards are true, and the machine goes on.  The trial then continues with the same inputs, beside a copy that
// has aborted.  Reported if the machine has not aborted AFTER steps later, and has an output on that the copy has not.  So a step that the next
// state corrects is not reported, and neither is a transition to a state that switches everything off itself.
//
// An abort that waits for time or a count alone is not judged: that success is written above a time limit is usual.
#include <string.h>

#include "compiler/analysis/abort.h"
#include "compiler/analysis/guards_imply.h"
#include "compiler/analysis/trial_checks.h"

enum {
    ENTRIES_TRIED = 6,            // situations from which a pair of transitions is tried
    RESTS = 300,                  // changes of inputs that are tried at an entry, to make the state last
    TRIES = 24,                   // choices of inputs for the first transition, from each of these situations
    HAZARDS = 12,                 // choices of inputs for the abort, for each of them
    SHIFT_MAX = 2,                // the abort's inputs begin up to so many steps earlier or later than computed
    STEPS_MAX = 1200,             // the most steps of one run to a transition
    AFTER = 3,                    // steps after the transition until the two machines are compared
    NAMED_MAX = 4                 // inputs and outputs that a note names
};
static const uint64_t effort_in_all = 60000000, effort_of_pair = 4000000;         // in instructions

typedef struct OrderTrial {
    Trials *t;
    const InputDepsTable *deps;
    AbortBound bound;
    const Transition *first, *abort;      // the pair, in the order as written
    uint32_t refused;             // Stmt.number of the innermost conditional around `first`
    bool *is_cause, *is_hazard;   // by input: the guards of `first` depend on it; those of `abort` do
    void *begin, *start;          // the entry of the state; where a run begins, after some time
    void *at, *other;             // the situations of the machine, and of its copy that has aborted
    double *rest, *cause, *hazard, *now;  // inputs: before anything happens, that lead to `first`, that lead to `abort`, of the current step
    uint32_t steps;               // the most steps of a run
} OrderTrial;

// ---- pairs ----

static bool depends_on(const OrderTrial *k, const Condition *when, const Var *v)
{
    const InputDeps d = input_deps_of_condition(k->deps, when);
    bool reads = d.more || input_deps_include(&d, v);

    for (; when && !reads; when = when->outer)
        reads = expr_reads(when->stmt->value, v);
    return reads;
}

static bool is_inside(const Condition *when, const Stmt *conditional)
{
    while (when && when->stmt != conditional)
        when = when->outer;
    return when != NULL;
}

// Whether the guard of a transition contains all of another's, as `weight < 380 and tries < 3` contains `weight < 380`: then the one with less
// is for the other cases.
static bool implies(const OrderTrial *k, const Transition *first, const Transition *abort)
{
    bool all = true;

    for (const Condition *y = abort->when; y && all; y = y->outer) {
        bool any = false;
        for (const Condition *x = first->when; x && !any && y->holds; x = x->outer)
            any = x->holds && guard_implies(k->t->a, x->stmt->value, y->stmt->value);
        all = any;
    }
    return all;
}

// Whether the state can abort by a transition of its own.  Where it cannot, the author has decided that nothing stops it, as a parachute's charge.
static bool can_abort(const OrderTrial *k, const State *s)
{
    const Transitions *all = &k->t->a->transition;
    bool can = false;

    for (size_t i = 0; i < all->n && !can; i++)
        can = all->at[i].from == s && k->bound.bound[all->at[i].to->number - 1] && k->t->a->stmt[all->at[i].stmt->number].reached;
    return can;
}

// Whether `abort` is an abort on an input, written below `first`, which goes on.
static bool is_pair(const OrderTrial *k, const Transition *first, const Transition *abort)
{
    const StmtFact *fact = k->t->a->stmt;
    const Condition *own = first->when;
    const InputDeps d = input_deps_of_condition(k->deps, abort->when);

    return first->from == abort->from && first->block == BLOCK_STEP && abort->block == BLOCK_STEP && first->stmt->number < abort->stmt->number &&
           fact[first->stmt->number].reached && fact[abort->stmt->number].reached && !k->bound.bound[first->to->number - 1] &&
           abort->to->is_abort && first->to != first->from && !first->to->is_safe && can_abort(k, first->to) &&
           own && own->holds && own->stmt->otherwise.n == 0 &&
           !is_inside(abort->when, own->stmt) && (d.n > 0 || d.input) && !implies(k, first, abort);
}

// ---- runs ----

// Passes time with the inputs at rest, until up to `events` timers have ended but for a random number of steps.  Returns false if the machine
// leaves its state.
static bool pass_time(OrderTrial *k, uint32_t events)
{
    Trials *t = k->t;
    const uint32_t state = trial_state(k->start);

    for (; events > 0; events--) {
        uint32_t n, left = trial_random_below(t, t->window + 3);
        memcpy(t->before, ir_run_vars(t->run, k->start), t->run->m->var.n * sizeof *t->before);
        trial_step(t, k->start, k->rest, t->dt, &t->trace);
        if (trial_state(k->start) != state)
            return false;
        n = trial_steps_to_event(t, t->before, k->start);
        if (n == TRIAL_MANY || n <= left)
            continue;
        trial_skip_steps(t, t->before, k->start, n - left);
        if (t->run_time == 0)
            trial_fill_skipped(t, k->start, n - left < t->window ? n - left : t->window);
    }
    return true;
}

// Sets the inputs of a step that is followed by `cause` - 1 further steps with the inputs of the cause, and by `hazard` - 1 with those of the hazard;
// 0: that is over or has not begun.
static void choose_inputs(const OrderTrial *k, bool cause, bool hazard)
{
    for (uint32_t i = 0; i < k->t->inputs; i++)
        k->now[i] = k->is_hazard[i] ? (hazard ? k->hazard[i] : k->rest[i]) : cause ? k->cause[i] : k->rest[i];
}

// Runs from k->start with the inputs k->now.  Returns the step, counted from 1, in which the transition is made; 0: another one is made, or none.
static uint32_t find_step(OrderTrial *k, const Transition *wanted)
{
    Trials *t = k->t;

    trial_copy_situation(t, k->at, k->start);
    for (uint32_t n = 1; n <= k->steps; n++) {
        trial_step(t, k->at, k->now, t->dt, &t->trace);
        if (t->trace.transition)
            return t->trace.transition == wanted->stmt->number ? n : 0;
    }
    return 0;
}

// Gives an input of k->rest another value, and all sensors of its group: one that the guards of a transition depend on.
static void change_one_input(OrderTrial *k, const Transition *x)
{
    Trials *t = k->t;
    const uint32_t from = trial_random_below(t, t->inputs);

    for (uint32_t n = 0; n < t->inputs; n++) {
        const uint32_t i = (from + n) % t->inputs;
        if (!depends_on(k, x->when, t->input[i].v))
            continue;
        if (t->input[i].command)
            k->rest[i] = trial_pick_reading(t, &t->input[i], true);
        else
            trial_set_group(t, k->rest, i, trial_pick_reading(t, &t->input[i], false));
        return;
    }
}

// Chooses inputs with which the machine does not abort from the entry for as long as a run lasts, and stores the situation in k->begin.  Begins with
// the inputs that led to it, and changes what a run aborts on.  The windows then have samples of the changed inputs.
static bool find_rest(OrderTrial *k, const TrialEntry *e)
{
    Trials *t = k->t;

    trial_begin_at_entry(t, e, k->begin, k->rest);
    for (int n = 0; n < RESTS && trial_may_continue(t); n++) {
        const Transition *x;
        memcpy(k->now, k->rest, t->inputs * sizeof *k->now);
        trial_copy_situation(t, k->start, k->begin);
        find_step(k, k->first);
        x = t->trace.transition ? t->transition[t->trace.transition] : NULL;
        if (!x || !x->to->is_abort)
            return true;
        change_one_input(k, x);
        trial_copy_situation(t, k->begin, e->situation);
        trial_fill_windows(t, k->begin, k->rest);
    }
    return false;
}

// Runs one step in k->at with the inputs k->now, and in a copy without the first transition.  Whether the first makes it, and the copy aborts.
static bool step_both(OrderTrial *k)
{
    Trials *t = k->t;
    bool first;

    trial_copy_situation(t, k->other, k->at);
    trial_step(t, k->at, k->now, t->dt, &t->trace);
    first = t->trace.transition == k->first->stmt->number;
    t->run->refused = k->refused;
    if (first)
        trial_step(t, k->other, k->now, t->dt, &t->trace);
    t->run->refused = 0;
    return first && t->trace.transition == k->abort->stmt->number;
}

// Runs from k->start so that the inputs of the cause last `cause` steps and those of the hazard `hazard`, both to the end.  Whether both guards are
// true in the last step, and no transition was made before.
static bool run_to_both(OrderTrial *k, uint32_t cause, uint32_t hazard)
{
    Trials *t = k->t;
    const uint32_t steps = cause > hazard ? cause : hazard;

    trial_copy_situation(t, k->at, k->start);
    for (uint32_t n = steps; n > 0; n--) {
        choose_inputs(k, n <= cause, n <= hazard);
        if (n == 1)
            return step_both(k);
        trial_step(t, k->at, k->now, t->dt, &t->trace);
        if (t->trace.transition)
            return false;
    }
    return false;
}

// Runs with the same inputs in all steps, to the first transition.  Whether both guards are true when it is made.
static bool run_with_cause_alone(OrderTrial *k)
{
    Trials *t = k->t;
    uint32_t n;

    memcpy(k->now, k->cause, t->inputs * sizeof *k->now);
    n = find_step(k, k->first);
    if (n == 0)
        return false;
    trial_copy_situation(t, k->at, k->start);
    while (--n > 0)
        trial_step(t, k->at, k->now, t->dt, &t->trace);
    return step_both(k);
}

// Draws values for the inputs that a guard depends on; the others stay as they were at rest.  s: NULL: so do all.
static void draw_inputs(const OrderTrial *k, double *in, const bool *depends, const TrialState *s, bool commands, bool unhealthy)
{
    Trials *t = k->t;

    memcpy(in, k->rest, t->inputs * sizeof *in);
    if (s)
        trial_draw_inputs(t, in, s, commands, unhealthy);
    for (uint32_t i = 0; i < t->inputs; i++)
        in[i] = depends[i] ? in[i] : k->rest[i];
}

// Whether inputs are found with which both guards are true in one step, from k->start.
static bool find_both(OrderTrial *k, const TrialState *s, uint32_t n)
{
    Trials *t = k->t;
    uint32_t cause, hazard;

    draw_inputs(k, k->cause, k->is_cause, n > 0 ? s : NULL, n % 2, false);
    choose_inputs(k, true, false);
    cause = find_step(k, k->first);
    if (cause == 0)
        return run_with_cause_alone(k);
    for (int h = 0; h < HAZARDS && trial_may_continue(t); h++) {
        draw_inputs(k, k->hazard, k->is_hazard, s, h % 2, h % 4 == 3);
        choose_inputs(k, false, true);
        t->run->refused = k->refused;
        hazard = find_step(k, k->abort);
        t->run->refused = 0;
        for (int shift = 0; shift <= 2 * SHIFT_MAX && hazard > 0; shift++) {
            const uint32_t by = (uint32_t)(shift + 1) / 2, lasts = shift % 2 ? hazard + by : hazard - (by < hazard ? by : 0);
            if (run_to_both(k, cause, lasts))
                return true;
        }
    }
    return false;
}

// ---- the effect ----

// Goes on for some steps.  Returns how many outputs are on that are off after an abort, and lists them; 0 if the machine has aborted, too.
static uint32_t find_outputs_on(OrderTrial *k, const Var **output)
{
    Trials *t = k->t;
    const double *on = trial_vars(t, k->at), *off = trial_vars(t, k->other);
    uint32_t n = 0;

    for (int step = 0; step < AFTER; step++) {
        trial_step(t, k->at, k->now, t->dt, &t->trace);
        trial_step(t, k->other, k->now, t->dt, &t->trace);
        if (k->bound.bound[trial_state(k->at) - 1])
            return 0;
    }
    for (uint32_t v = 0; v < t->run->m->var.n && n < NAMED_MAX; v++)
        if (t->actuator[v] && on[v] != 0 && off[v] == 0)
            output[n++] = t->var[v];
    return n;
}

// Returns the inputs of the step that the two guards depend on, as "'fire' reads 1 and 'tank' reads 12".
static const char *inputs_text(const OrderTrial *k)
{
    const Trials *t = k->t;
    const char *text = "";
    uint32_t n = 0;

    for (uint32_t i = 0; i < t->inputs && n < NAMED_MAX; i++) {
        const Var *v = t->input[i].v;
        if (k->now[i] == k->rest[i] || !(k->is_hazard[i] || k->is_cause[i]))
            continue;
        text = format_in(t->a->arena, "%s%s'%s' reads %s", text, n > 0 ? ", " : "", v->name->text,
                         const_text(t->a->arena, trial_check_round(k->now[i])));
        n++;
    }
    return n > 0 ? text : "the inputs stay as they were";
}

static void report_order(const OrderTrial *k, const char *inputs, double time, const Var *const *output, uint32_t outputs)
{
    const Analysis *a = k->t->a;
    const Transition *x = k->first;
    Diag *d = diag_report(a->diags, DIAG_abort_order, x->stmt->span, x->from->name->text, x->to->name->text,
                          condition_brief(a->arena, k->abort->when, 2));

    diag_note(a->diags, d, k->abort->stmt->span, DIAG_note_abort_below, k->abort->to->name->text);
    diag_note(a->diags, d, (Span){0}, DIAG_note_both_true, const_text(a->arena, time), inputs, trial_check_join_names(a->arena, output, outputs));
    diag_note(a->diags, d, (Span){0}, DIAG_note_abort_first);
}

static bool try_entry(OrderTrial *k, const TrialEntry *e, uint64_t until)
{
    Trials *t = k->t;
    const TrialState *s = &t->state[trial_state(e->situation) - 1];

    if (!find_rest(k, e))
        return false;
    for (uint32_t n = 0; n < TRIES && t->run->work < until; n++) {
        const Var *output[NAMED_MAX];
        uint32_t outputs;
        double time;
        trial_copy_situation(t, k->start, k->begin);
        if (!pass_time(k, n % 4) || !find_both(k, s, n))
            continue;
        time = trial_vars(t, k->at)[t->run->m->t];
        {
            const char *inputs = inputs_text(k);
            outputs = find_outputs_on(k, output);
            if (outputs == 0)
                continue;
            report_order(k, inputs, time, output, outputs);
        }
        return true;
    }
    return false;
}

static bool try_pair(OrderTrial *k, const Transition *first, const Transition *abort, uint64_t effort)
{
    Trials *t = k->t;
    const TrialState *s = &t->state[first->from->number - 1];
    const uint64_t until = t->run->work + effort;
    bool found = false;

    k->first = first;
    k->abort = abort;
    k->refused = first->when->stmt->number;
    for (uint32_t i = 0; i < t->inputs; i++) {
        k->is_cause[i] = depends_on(k, first->when, t->input[i].v);
        k->is_hazard[i] = depends_on(k, abort->when, t->input[i].v);
    }
    for (size_t e = 0; e < s->entry.n && e < ENTRIES_TRIED && !found && trial_may_continue(t); e++)
        found = s->reached && try_entry(k, &s->entry.at[e], until);
    t->pattern = NULL;
    return found;
}

// Finds transitions that are made although an abort that is written below them has its reason in the same step.
void check_abort_order(Trials *t)
{
    const Transitions *all = &t->a->transition;
    OrderTrial k = {.t = t, .deps = input_deps_of(t->a), .bound = abort_find_bound(t->a)};
    uint64_t pairs = 0, effort;

    k.is_cause = ARENA_ARRAY(t->a->arena, bool, t->inputs + 1u);
    k.is_hazard = ARENA_ARRAY(t->a->arena, bool, t->inputs + 1u);
    k.begin = arena_alloc(t->a->arena, t->run->size);
    k.start = arena_alloc(t->a->arena, t->run->size);
    k.at = arena_alloc(t->a->arena, t->run->size);
    k.other = arena_alloc(t->a->arena, t->run->size);
    k.rest = trial_new_inputs(t);
    k.cause = trial_new_inputs(t);
    k.hazard = trial_new_inputs(t);
    k.now = trial_new_inputs(t);
    k.steps = t->window + 8 < STEPS_MAX ? t->window + 8 : STEPS_MAX;
    for (size_t i = 0; i < all->n; i++)
        for (size_t n = 0; n < all->n; n++)
            pairs += is_pair(&k, &all->at[i], &all->at[n]);
    effort = pairs == 0 ? 0 : (effort_in_all / pairs < effort_of_pair ? effort_in_all / pairs : effort_of_pair) / t->share;
    for (size_t i = 0; i < all->n; i++) {
        bool found = false;
        for (size_t n = 0; n < all->n && !found; n++)
            found = is_pair(&k, &all->at[i], &all->at[n]) && try_pair(&k, &all->at[i], &all->at[n], effort);
    }
}
