// SPDX-License-Identifier: Apache-2.0
// Reports an @abort state from which the machine starts again because a command that was given before the abort is still given.
//
// A key that is withdrawn to stop the machine, as in `not key: -> Abort`, is still given after an abort for any other reason.  A button that nothing
// stops when it is released is not judged.
//
// A trial begins in the @abort state with the commands that the run had, and changes no input.  Reported if the machine leaves the state by a
// transition that reads no command, and later switches on an output that was off in the @abort state.  The same run without commands must switch
// nothing on, and be in another state then: so a lamp that shows the key is not reported.  A start that needs a new command, as `rising(start)` or
// another button, is not reported either, and neither is a machine that goes on by itself, which abort_restarts.c judges.
#include <string.h>

#include "compiler/analysis/input_deps.h"
#include "compiler/analysis/trial_checks.h"

enum {
    ENTRIES_TRIED = 6,            // situations at the entry of the @abort state
    DRAWS = 12,                   // readings of the sensors, in each of them
    ADVANCES = 60                 // the most changes and ends of timers, before the machine leaves the state and after that
};
static const uint64_t effort_in_all = 30000000;       // in instructions

typedef struct HeldTrial {
    Trials *t;
    const InputDepsTable *deps;
    bool *command;                // by input: a person operates it
    bool *key;                    // by input: and the machine stops when it is withdrawn
    void *at, *left;              // the current situation; that in which the machine leaves the @abort state
    double *in, *none;            // the inputs; the same without commands
    bool *shared;                 // by State.number - 1: the machine also comes to this state without commands
    double *off;                  // by IR variable: its value in the @abort state, before the machine leaves it
} HeldTrial;

// Whether e, or with `negated` its negation, requires that v is false now.  rising(v) is `not not v` now and not before: it does not.
static bool requires_off(const Expr *e, const Var *v, bool negated)
{
    const bool is_not = e->kind == EX_UNARY && e->op == SM_OP_NOT, is_past = e->kind == EX_ROLL && e->stat == SM_STAT_OLDEST;
    bool requires = e->kind == EX_VAR && e->var == v && negated;

    for (uint32_t i = 0; i < e->n && !requires && !is_past; i++)
        requires = requires_off(e->arg[i], v, negated != is_not);
    return requires;
}

// Whether the machine makes a transition because the command is withdrawn, from a state that is no @abort state.
static bool stops_when_withdrawn(const Trials *t, const Var *v)
{
    bool stops = false;

    for (size_t i = 0; i < t->a->transition.n && !stops; i++) {
        const Transition *x = &t->a->transition.at[i];
        const Expr *guard = x->when && x->when->holds && !x->from->is_abort ? x->when->stmt->value : NULL;
        stops = guard && requires_off(guard, v, false) && t->a->stmt[x->stmt->number].reached;
    }
    return stops;
}

static bool has_command(const HeldTrial *k)
{
    bool any = false;

    for (uint32_t i = 0; i < k->t->inputs && !any; i++)
        any = k->key[i] && k->in[i] != 0;
    return any;
}

// Runs until the machine leaves the state.  Returns the transition; NULL: it stays, or a person decides that it leaves.
static const Transition *leave_state(HeldTrial *k)
{
    Trials *t = k->t;
    InputDeps d;

    for (int n = 0; n < ADVANCES && trial_may_continue(t); n++) {
        bool goes_on;
        memcpy(k->off, trial_vars(t, k->at), t->run->m->var.n * sizeof *k->off);
        goes_on = trial_advance_to_event(t, k->at, k->in, &t->trace);
        if (t->trace.transition)
            break;
        if (!goes_on)
            return NULL;
    }
    if (!t->trace.transition)
        return NULL;
    d = input_deps_of_condition(k->deps, t->transition[t->trace.transition]->when);
    return d.command || d.other || d.input ? NULL : t->transition[t->trace.transition];
}

// Runs on from k->left with these inputs, for at most *steps steps.  Returns an output that is on and was off in the @abort state, and sets *steps to
// the steps until then; NULL: no output goes on, or the machine has aborted again.  Outputs that go on in shared states do not count.
static const Var *find_started_output(HeldTrial *k, const double *in, int *steps)
{
    Trials *t = k->t;
    const int most = *steps;

    trial_copy_situation(t, k->at, k->left);
    for (*steps = 1; *steps <= most && trial_may_continue(t); ++*steps) {
        const bool goes_on = trial_advance_to_event(t, k->at, in, &t->trace);
        if (t->a->p->state.at[trial_state(k->at) - 1]->is_abort)
            return NULL;
        for (uint32_t v = 0; v < t->run->m->var.n; v++) {
            const double value = trial_vars(t, k->at)[v];
            if (!t->actuator[v] || value == 0 || k->off[v] != 0)
                continue;
            if (!k->shared[trial_state(k->at) - 1])
                return t->var[v];
            k->off[v] = value;
        }
        if (!goes_on)
            return NULL;
    }
    return NULL;
}

static const char *commands_text(const HeldTrial *k)
{
    const Var *held[3];
    uint32_t n = 0;

    for (uint32_t i = 0; i < k->t->inputs && n < 3; i++)
        if (k->key[i] && k->in[i] != 0)
            held[n++] = k->t->input[i].v;
    return trial_check_join_names(k->t->a->arena, held, n);
}

// Returns an output that goes on with the commands only, and its state: one to which the machine does not come without them.  NULL: no output does.
static const Var *find_restart(HeldTrial *k, const State **in)
{
    Trials *t = k->t;
    const Var *output;
    int steps = ADVANCES;

    memset(k->shared, 0, t->a->p->state.n * sizeof *k->shared);
    for (uint32_t i = 0; i < t->inputs; i++)
        k->none[i] = k->key[i] ? 0 : k->in[i];
    while ((output = find_started_output(k, k->in, &steps)) != NULL) {
        *in = t->a->p->state.at[trial_state(k->at) - 1];
        if (find_started_output(k, k->none, &steps))
            return NULL;
        if (trial_state(k->at) != (*in)->number)
            return output;
        k->shared[(*in)->number - 1] = true;
        steps = ADVANCES;
    }
    return NULL;
}

// Tries one choice of inputs.  Returns whether a finding was reported.
static bool try_inputs(HeldTrial *k, const TrialEntry *e)
{
    Trials *t = k->t;
    const Transition *x;
    const Var *output;
    const State *in;
    Diag *d;

    trial_copy_situation(t, k->at, e->situation);
    x = leave_state(k);
    if (!x)
        return false;
    trial_copy_situation(t, k->left, k->at);
    output = find_restart(k, &in);
    if (!output)
        return false;
    d = diag_report(t->a->diags, DIAG_held_command, x->stmt->span, x->from->name->text, output->name->text, in->name->text, commands_text(k));
    diag_note_declaration(t->a->diags, d, DIAG_OUTPUTS, output->span);
    return true;
}

static bool try_entry(HeldTrial *k, const TrialEntry *e, uint64_t until)
{
    Trials *t = k->t;
    bool found = false;

    for (int n = 0; n < DRAWS && !found && t->run->work < until && trial_may_continue(t); n++) {
        memcpy(k->in, e->in, t->inputs * sizeof *k->in);
        if (n > 0)
            trial_draw_inputs(t, k->in, NULL, false, false);
        found = has_command(k) && try_inputs(k, e);
    }
    return found;
}

// Finds @abort states after which a command that is still given starts the machine again.
void check_held_command(Trials *t)
{
    Arena *arena = t->a->arena;
    HeldTrial k = {.t = t, .deps = input_deps_of(t->a), .command = ARENA_ARRAY(arena, bool, t->inputs + 1u),
                   .key = ARENA_ARRAY(arena, bool, t->inputs + 1u)};
    const uint64_t until = t->run->work + effort_in_all / t->share;

    k.at = arena_alloc(arena, t->run->size);
    k.left = arena_alloc(arena, t->run->size);
    k.in = trial_new_inputs(t);
    k.none = trial_new_inputs(t);
    k.off = ARENA_ARRAY(arena, double, t->run->m->var.n);
    k.shared = ARENA_ARRAY(arena, bool, t->a->p->state.n);
    for (uint32_t i = 0; i < t->inputs; i++) {
        k.command[i] = t->input[i].command && (t->input[i].v->command || !k.deps->marks_commands);
        k.key[i] = k.command[i] && stops_when_withdrawn(t, t->input[i].v);
    }
    for (size_t s = 0; s < t->a->p->state.n; s++) {
        bool found = !t->a->p->state.at[s]->is_abort || !t->state[s].reached;
        for (size_t e = 0; e < t->state[s].entry.n && e < ENTRIES_TRIED && !found; e++)
            found = try_entry(&k, &t->state[s].entry.at[e], until);
    }
}
