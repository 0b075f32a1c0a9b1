// SPDX-License-Identifier: Apache-2.0
// The short form of smc why, for the report of a run that failed: the statements that stored the variables of the failed condition, and why a machine
// is not in a state that this condition demands.
#include "compiler/script/script_run.h"
#include "compiler/script/why_paths.h"
#include "compiler/script/why_words.h"

typedef struct WhyShort {
    const ScriptRun *failed;
    Diag *d;
    const Watch *w;           // the watch of machine number `machine`
    WhyWords words;
    size_t machine;
    size_t notes;
} WhyShort;

static const Program *program_of(const Program *p, size_t machine) { return p->joint ? p->joint->member.at[machine].program : p; }

// Returns the machine's own variable for variable v of the run's program; NULL: the machine does not have it.
static const Var *variable_of(const Program *p, size_t machine, const Var *v)
{
    const Program *m = program_of(p, machine);

    for (size_t i = 0; i < m->var.n; i++)
        if ((p->joint ? p->joint->member.at[machine].var[i] : m->var.at[i]) == v)
            return m->var.at[i];
    return NULL;
}

// ---- what is watched ----

enum { WATCHED_MOST = 3 };            // the most variables of a condition that are explained

// The variables of a condition that a machine stores; has_state: the condition also reads S.
typedef struct Watched { const Var *at[WATCHED_MOST]; size_t n; bool has_state; } Watched;

// Adds the variables of a condition that a machine assigns.
static void find_watched(const Program *p, size_t machine, const Expr *e, Watched *out)
{
    const Var *v = e->kind == EX_VAR && !e->var->of_script ? variable_of(p, machine, e->var) : NULL;
    bool is_new = v && v->written && out->n < WATCHED_MOST;

    out->has_state |= e->kind == EX_VAR && e->var->state_of == program_of(p, machine);
    for (size_t i = 0; i < out->n; i++)
        is_new = is_new && out->at[i] != v;
    if (is_new)
        out->at[out->n++] = v;
    for (uint32_t i = 0; i < e->n; i++)
        find_watched(p, machine, e->arg[i], out);
}

Watch **why_short_watch(const ScriptRun *failed, Engine *ref, const uint64_t *steps)
{
    Watch **watch = ARENA_ARRAY(failed->arena, Watch *, failed->machines);
    bool any = false;

    for (size_t i = 0; failed->failed && i < failed->machines; i++) {
        Watched what = {{NULL}, 0, false};
        find_watched(failed->p, i, failed->failed, &what);
        if (what.n == 0 && !what.has_state)
            continue;
        watch[i] = watch_new(failed->arena, program_of(failed->p, i), steps, 0);
        watch_restrict(watch[i], what.at, what.n, failed->result.steps);
        watch_attach(watch[i], engine_app_machine(ref, i));
        any = true;
    }
    return any ? watch : NULL;
}

// ---- the notes ----

// Adds a note to the message about the failed assert, unless it has WHY_SHORT_MOST notes already.  Several machines of an application can have
// the same source, so the note names the machine.
static void add_note(WhyShort *n, Span at, const char *text)
{
    const Joint *j = n->failed->p->joint;

    if (j)
        text = format_in(n->failed->arena, "%s: %s", j->member.at[n->machine].name->text, text);
    if (n->notes++ < WHY_SHORT_MOST)
        diag_note(n->failed->diags, n->d, at, DIAG_note_why, text);
}

// Adds a note about the statement that stored a variable last, with its operands and the guards around it.
static void add_store(WhyShort *n, const Var *v)
{
    const WatchStmt *s = n->w->stored_by[v->index];
    Buf text;

    if (!s) {
        add_note(n, (Span){0}, format_in(n->failed->arena, "no step has stored %s", v->name->text));
        return;
    }
    buf_init(&text, n->failed->arena);
    buf_printf(&text, "%s: %s", why_step(n->failed->arena, s->step, s->g), why_store(&n->words, s));
    if (s->parent)
        buf_printf(&text, ", because %s", why_guards(&n->words, s, s->value));
    add_note(n, s->stmt->span, buf_text(&text));
}

// Returns a false guard in words; of an `and` only its first false operand.
static const char *missing_part(const WhyShort *n, const WatchStmt *guard)
{
    uint32_t i = 0;

    while (guard->node[i].kind == WATCH_AND) {
        uint32_t operand = i + 1;
        while (watch_truth(guard, guard->value, operand))
            operand = guard->node[operand].end;
        i = operand;
    }
    return why_condition(&n->words, guard, i, false);
}

// Adds a note about why the step did not take a transition.
static void add_transition(WhyShort *n, const WatchStmt *t)
{
    const WatchStmt *obstacle = why_obstacle(n->w, t);
    const char *const name = format_in(n->failed->arena, "%s -> %s", t->state->name->text, t->stmt->target->name->text);

    if (!obstacle)
        add_note(n, t->stmt->span, format_in(n->failed->arena, "state %s begins in the step after this transition", t->stmt->target->name->text));
    else if (why_is_blocked(obstacle) && !obstacle->in_else)
        add_note(n, t->stmt->span, format_in(n->failed->arena, "%s was not taken: %s", name, missing_part(n, obstacle->parent)));
    else if (why_is_blocked(obstacle))
        add_note(n, t->stmt->span, format_in(n->failed->arena, "%s was not taken: %s", name, why_condition(&n->words, obstacle->parent, 0, false)));
}

static void add_transitions(WhyShort *n, const State *to)
{
    for (uint32_t i = 1; i <= n->w->p->stmts; i++) {
        const WatchStmt *t = &n->w->stmt[i];
        if (t->stmt && t->stmt->kind == ST_TRANSITION && t->state == n->w->state && t->stmt->target == to &&
            (t->block != BLOCK_ENTRY || n->w->is_first))
            add_transition(n, t);
    }
}

// Adds a note about why the machine is not in a state.
static void add_state(WhyShort *n, const State *to)
{
    const State *from = n->w->state;
    WhyPath path;

    if (why_find_transition(n->w, from, to)) {
        add_transitions(n, to);
        return;
    }
    path = why_shortest_path(n->failed->arena, n->w, from, to);
    if (path.n == 0) {
        add_note(n, (Span){0}, format_in(n->failed->arena, "no sequence of transitions leads from %s to %s", from->name->text, to->name->text));
        return;
    }
    add_note(n, (Span){0}, format_in(n->failed->arena, "the shortest path to %s is %s", to->name->text, why_path_text(n->failed->arena, &path)));
    add_transitions(n, path.at[1]);
}

// Returns the state that a comparison with S demands; NULL: e is no such comparison.
static const State *demanded_state(const WhyShort *n, const Expr *e)
{
    const Program *p = n->w->p;
    uint64_t number;

    if (e->kind != EX_BINARY || e->op != SM_OP_EQ || e->arg[0]->kind != EX_VAR || e->arg[0]->var->state_of != p || e->arg[1]->kind != EX_NUMBER)
        return NULL;
    number = ref_convert(SM_U64, e->arg[1]->number);
    return number >= 1 && number <= p->state.n ? p->state.at[number - 1] : NULL;
}

// Adds a reason for each state that the condition demands, as `S == A` does outside a `not`, and that the machine is not in.
static void add_states(WhyShort *n, const Expr *e)
{
    const State *to = demanded_state(n, e);

    if (to && to != n->w->state)
        add_state(n, to);
    for (uint32_t i = 0; i < e->n && !(e->kind == EX_UNARY && e->op == SM_OP_NOT); i++)
        add_states(n, e->arg[i]);
}

void why_short_add(const ScriptRun *failed, Diag *d, Watch *const *watch)
{
    WhyShort n = {.failed = failed, .d = d};

    for (n.machine = 0; n.machine < failed->machines; n.machine++) {
        Watched what = {{NULL}, 0, false};
        if (!watch[n.machine] || watch[n.machine]->step == 0)
            continue;
        n.w = watch[n.machine];
        n.words = (WhyWords){failed->arena, n.w, NULL};
        find_watched(failed->p, n.machine, failed->failed, &what);
        for (size_t i = 0; i < what.n; i++)
            add_store(&n, what.at[i]);
        if (n.w->step == failed->result.steps)
            add_states(&n, failed->failed);
    }
}
