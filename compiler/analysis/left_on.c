// SPDX-License-Identifier: Apache-2.0
// Outputs that a state switches on and that stay on behind it, where nothing that follows sees to them.
//
// An output is followed by facts from off, before .entry, through the state's blocks, .exit and the next state's .entry.  If it
// may still be on then, and that .entry says nothing of it, it has been handed on.  That is right if a state that follows
// sees to it (assigns it), on every way; it is wrong where the machine can come to rest, or go on for ever, without one:
// in an end state; and, if another way out of the state does see to it, in its first state or one marked @safe or @abort.
#include "compiler/analysis/outputs.h"
#include "compiler/analysis/whatif.h"

enum { ROUNDS = 3 };              // of .step, until what it leaves on is known

typedef struct LeftOn {
    Analysis *a;
    const bool *output;           // by Program.var
    VEC(const Var *) var;         // the outputs
    bool **sees;                  // by output (its place in var) and state: it assigns it
    bool **clears;                // by output and state: it may switch it off
    bool **stays;                 // by output and state: nothing from there on sees to it before the machine rests for good
    bool **rests;                 // the same, or before it rests: in its first state, in one marked @safe or @abort
    size_t *at;                   // by Stmt.number: the transition it is
    const Env **env;              // by transition: behind it, before .exit; then behind .exit
    const Env **gone;             // by transition: behind it, before .exit
    bool *made;                   // by transition
    size_t first, first_from;     // transitions of the state looked at
    const Env *begin;             // of its .step
    bool *told;                   // by output: that nobody ever switches it off
} LeftOn;

// ---- who sees to what ----

static void note_assigned(const Stmts *stmts, const LeftOn *l, size_t state, const size_t *place)
{
    for (size_t i = 0; i < stmts->n; i++) {
        const Stmt *s = stmts->at[i];
        if (s->kind == ST_ASSIGN && l->output[s->var->index] && l->a->stmt[s->number].reached) {
            l->sees[place[s->var->index]][state] = true;
            l->clears[place[s->var->index]][state] |= !is_on(l->a->stmt[s->number].value);
        }
        note_assigned(&s->then, l, state, place);
        note_assigned(&s->otherwise, l, state, place);
    }
}

static bool **by_output_and_state(const LeftOn *l)
{
    bool **out = ARENA_ARRAY(l->a->arena, bool *, l->var.n + 1);

    for (size_t o = 0; o < l->var.n; o++)
        out[o] = ARENA_ARRAY(l->a->arena, bool, l->a->p->state.n);
    return out;
}

static void find_who_sees(LeftOn *l)
{
    const Program *p = l->a->p;
    size_t *place = ARENA_ARRAY(l->a->arena, size_t, p->var.n);

    for (size_t v = 0; v < p->var.n; v++)
        if (l->output[v]) {
            place[v] = l->var.n;
            vec_push(l->a->arena, &l->var, p->var.at[v]);
        }
    l->sees = by_output_and_state(l);
    l->clears = by_output_and_state(l);
    l->stays = by_output_and_state(l);
    l->rests = by_output_and_state(l);
    for (size_t s = 0; s < p->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            note_assigned(&p->state.at[s]->block[b], l, s, place);
}

// ---- where it stays on ----

typedef struct Edges {                // of transitions that can be made, by the state that they lead to
    size_t *first, *from;             // first[s] … first[s + 1]
} Edges;

static bool is_made(const LeftOn *l, const Transition *t) { return t->to != t->from && l->a->stmt[t->stmt->number].reached; }

static Edges find_edges(const LeftOn *l)
{
    const Transitions *list = &l->a->transition;
    Edges e = {ARENA_ARRAY(l->a->arena, size_t, l->a->p->state.n + 2), ARENA_ARRAY(l->a->arena, size_t, list->n + 1)};

    for (size_t i = 0; i < list->n; i++)
        if (is_made(l, &list->at[i]))
            e.first[list->at[i].to->number + 1]++;
    for (size_t s = 2; s < l->a->p->state.n + 2; s++)
        e.first[s] += e.first[s - 1];
    for (size_t i = 0; i < list->n; i++)
        if (is_made(l, &list->at[i]))
            e.from[e.first[list->at[i].to->number]++] = list->at[i].from->number - 1;
    return e;                         // first[n] … first[n + 1] has moved to first[n - 1] … first[n]
}

typedef struct Spread { const Edges *edges; const bool *through; bool *reached; size_t *waiting, n; } Spread;

static void start_spread(Spread *s, size_t state)
{
    if (s->reached[state])
        return;
    s->reached[state] = true;
    s->waiting[s->n++] = state;
}

// Against the transitions, as far as states that do not see to the output go.
static void spread(Spread *s)
{
    while (s->n > 0) {
        const size_t to = s->waiting[--s->n];
        for (size_t i = s->edges->first[to]; i < s->edges->first[to + 1]; i++)
            if (!s->through[s->edges->from[i]])
                start_spread(s, s->edges->from[i]);
    }
}

static void find_rests(LeftOn *l, const Edges *e, const bool *left, size_t output)
{
    const Program *p = l->a->p;
    const bool *sees = l->sees[output];
    bool *seen_to = ARENA_ARRAY(l->a->arena, bool, p->state.n);
    size_t *waiting = ARENA_ARRAY(l->a->arena, size_t, p->state.n);
    Spread to_sight = {e, sees, seen_to, waiting, 0}, to_end = {e, sees, l->stays[output], waiting, 0};
    Spread to_rest = {e, sees, l->rests[output], waiting, 0};

    for (size_t s = 0; s < p->state.n; s++)
        if (l->clears[output][s])
            start_spread(&to_sight, s);
    spread(&to_sight);
    for (size_t s = 0; s < p->state.n; s++)
        if (!sees[s] && (!left[s] || !seen_to[s]))
            start_spread(&to_end, s);
    spread(&to_end);
    for (size_t s = 0; s < p->state.n; s++)
        if (!sees[s] && (s == 0 || p->state.at[s]->is_safe || p->state.at[s]->is_abort))
            start_spread(&to_rest, s);
    spread(&to_rest);
}

// ---- following it through a state ----

typedef struct Ends { LeftOn *l; bool stays; const Env *env; } Ends;

static const Env *join(const LeftOn *l, bool both, const Env *a, const Env *b)
{
    return both ? env_join(&l->a->facts->shape, a, b, NULL) : b;
}

static void note_end(void *context, const IrJump *end, const Env *env)
{
    Ends *e = context;
    LeftOn *l = e->l;

    if (end->kind == IR_GOTO && end->stmt) {
        const size_t t = l->at[end->stmt];
        l->env[t] = join(l, l->made[t], l->env[t], env);
        l->made[t] = true;
    } else {
        e->env = join(l, e->stays, e->env, env);
        e->stays = true;
    }
}

static Ends run(LeftOn *l, const IrFn *f, const Env *env)
{
    Ends e = {l, !f, env};
    const FactEnds ends = {note_end, &e};

    if (f)
        facts_flow(l->a->facts, f, env, &ends);
    return e;
}

static Fact output_fact(const LeftOn *l, const Env *env, const Var *v)
{
    return env_get(&l->a->facts->shape, env, l->a->m->var_of[v->index]);
}

// env, with the outputs as they may be at `from` as well.
static const Env *carry(const LeftOn *l, size_t state, const Env *env, const Env *from, bool also)
{
    for (size_t o = 0; o < l->var.n; o++)
        if (l->sees[o][state]) {
            const Fact now = output_fact(l, env, l->var.at[o]), more = output_fact(l, from, l->var.at[o]);
            env = suppose(l->a, env, l->var.at[o], also ? fact_join(now, more) : more);
        }
    return env;
}

static const Env *all_off(const LeftOn *l, size_t state, const Env *env)
{
    for (size_t o = 0; o < l->var.n; o++)
        if (l->sees[o][state])
            env = suppose(l->a, env, l->var.at[o], fact_of_cell(SM_F64, 0));
    return env;
}

static void run_state(LeftOn *l, size_t state)
{
    const IrState *s = &l->a->m->state.at[state];
    const Ends entry = run(l, s->block[BLOCK_ENTRY], all_off(l, state, facts_begin(l->a->facts, state, BLOCK_ENTRY)));
    const Env *env;

    if (!entry.stays || !facts_reach(l->a->facts, state, BLOCK_STEP))
        return;
    env = carry(l, state, facts_begin(l->a->facts, state, BLOCK_STEP), entry.env, false);
    for (int round = 0; round < ROUNDS; round++) {
        const Ends step = run(l, s->block[BLOCK_STEP], env);
        l->begin = env;
        if (!step.stays)
            return;
        env = carry(l, state, env, step.env, true);
    }
}

// ---- findings ----

static bool assigns(const Stmts *stmts, const Var *v)
{
    for (size_t i = 0; i < stmts->n; i++) {
        const Stmt *s = stmts->at[i];
        if ((s->kind == ST_ASSIGN && s->var == v) || assigns(&s->then, v) || assigns(&s->otherwise, v))
            return true;
    }
    return false;
}

static const Stmt *switched(const LeftOn *l, const State *s, const Var *v, bool on)
{
    const Stmt *found = NULL;

    for (int b = 0; b < BLOCK_COUNT && !found; b++)
        found = outputs_switch(l->a, &s->block[b], v, on);
    return found;
}

static bool never_off(const LeftOn *l, const Var *v)
{
    for (size_t s = 0; s < l->a->p->state.n; s++)
        if (switched(l, l->a->p->state.at[s], v, false))
            return false;
    return true;
}

static void report(LeftOn *l, const Transition *t, size_t output)
{
    const Var *v = l->var.at[output];
    const Stmt *on = switched(l, t->from, v, true);
    Diags *diags = l->a->diags;
    Diag *d;

    if (l->told[output])
        return;
    if (never_off(l, v)) {
        diag_report(diags, DIAG_output_never_off, on->span, v->name->text);
        l->told[output] = true;
        return;
    }
    d = diag_report(diags, DIAG_output_left_on, t->stmt->span, v->name->text, t->from->name->text, t->to->name->text);
    diag_note(diags, d, on->span, DIAG_note_switched_on, v->name->text);
}

typedef struct Only { const LeftOn *l; uint32_t stmt; bool made; const Env *env; } Only;

static void note_only(void *context, const IrJump *end, const Env *env)
{
    Only *o = context;

    if (end->kind != IR_GOTO || end->stmt != o->stmt)
        return;
    o->env = join(o->l, o->made, o->env, env);
    o->made = true;
}

// T does not change within a step: what an earlier line has done by the time that this way out asks for.
static bool is_off_by_then(LeftOn *l, const Transition *t, const Var *v)
{
    const IrState *s = &l->a->m->state.at[t->from->number - 1];
    const Fact time = output_fact(l, l->env[t->number], l->a->p->t);
    Only only = {l, t->stmt->number, false, NULL};
    const FactEnds ends = {note_only, &only};

    if (t->block != BLOCK_STEP)
        return false;
    facts_flow(l->a->facts, s->block[BLOCK_STEP], suppose(l->a, l->begin, l->a->p->t, time), &ends);
    return !only.made || !may_be_on(output_fact(l, run(l, s->block[BLOCK_EXIT], only.env).env, v));
}

static bool is_off_behind(const LeftOn *l, const Transition *t, const Var *v)
{
    return assigns(&t->to->block[BLOCK_ENTRY], v) || !may_be_on(output_fact(l, l->env[t->number], v));
}

// Whether this way out takes v, which may be on, and switches it off.
static bool switches_off(const LeftOn *l, const Transition *t, const Var *v)
{
    if (!may_be_on(output_fact(l, l->gone[t->number], v)))
        return switched(l, t->from, v, false);
    return outputs_switch(l->a, &t->to->block[BLOCK_ENTRY], v, false) || !may_be_on(output_fact(l, l->env[t->number], v));
}

// Whether another way out of its state sees to what this one leaves on.  That an @abort state switches everything off says nothing
// about other ways.
static bool others_see(LeftOn *l, const Transition *t, const Var *v)
{
    for (size_t i = l->first; i < l->first_from; i++) {
        const Transition *u = &l->a->transition.at[i];
        if (l->made[i] && u->to != t->to && u->to != u->from && !u->to->is_abort && switches_off(l, u, v))
            return true;
    }
    return false;
}

// l->env is behind .exit here.
static void look_at_transition(LeftOn *l, const Transition *t)
{
    const size_t from = t->from->number - 1, to = t->to->number - 1;

    for (size_t o = 0; o < l->var.n; o++) {
        const Var *v = l->var.at[o];
        if (l->sees[o][from] && !is_off_behind(l, t, v) &&
            (l->stays[o][to] || (l->rests[o][to] && others_see(l, t, v))) && !is_off_by_then(l, t, v))
            report(l, t, o);
    }
}

static void look_at_state(LeftOn *l, size_t state)
{
    const Transitions *list = &l->a->transition;
    const IrFn *exit = l->a->m->state.at[state].block[BLOCK_EXIT];

    run_state(l, state);
    l->first = l->first_from;
    for (; l->first_from < list->n && list->at[l->first_from].from->number - 1 == state; l->first_from++)
        if (l->made[l->first_from]) {
            l->gone[l->first_from] = l->env[l->first_from];
            l->env[l->first_from] = run(l, exit, l->env[l->first_from]).env;
        }
    for (size_t t = l->first; t < l->first_from; t++)
        if (l->made[t] && list->at[t].to != list->at[t].from)
            look_at_transition(l, &list->at[t]);
}

void analyse_left_on(Analysis *a)
{
    LeftOn l = {.a = a, .output = outputs_find(a)};
    Edges edges;
    bool *left;

    l.at = ARENA_ARRAY(a->arena, size_t, a->p->stmts + 1u);
    l.env = ARENA_ARRAY(a->arena, const Env *, a->transition.n + 1);
    l.gone = ARENA_ARRAY(a->arena, const Env *, a->transition.n + 1);
    l.made = ARENA_ARRAY(a->arena, bool, a->transition.n + 1);
    left = ARENA_ARRAY(a->arena, bool, a->p->state.n);
    for (size_t t = 0; t < a->transition.n; t++) {
        l.at[a->transition.at[t].stmt->number] = t;
        left[a->transition.at[t].from->number - 1] |= is_made(&l, &a->transition.at[t]);
    }
    find_who_sees(&l);
    l.told = ARENA_ARRAY(a->arena, bool, l.var.n + 1);
    edges = find_edges(&l);
    for (size_t o = 0; o < l.var.n; o++)
        find_rests(&l, &edges, left, o);
    for (size_t s = 0; s < a->p->state.n; s++)
        if (facts_reach(a->facts, s, BLOCK_ENTRY))
            look_at_state(&l, s);
        else
            while (l.first_from < a->transition.n && a->transition.at[l.first_from].from->number - 1 == s)
                l.first_from++;
}
