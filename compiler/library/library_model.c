// SPDX-License-Identifier: Apache-2.0
// The structure of the machines that smc_compile compiled: states, transitions, variables, and which state uses which variable.
#include <stdlib.h>
#include <string.h>

#include "compiler/library/library.h"

// ---- variables ----

static int32_t kind_of_variable(const Var *v)
{
    return v->kind == VAR_ELEMENT ? SMC_VARIABLE_ELEMENT : v->is_constant ? SMC_VARIABLE_CONSTANT : SMC_VARIABLE_LOCAL;
}

// For qsort: the variables by name, as smc_machine_variable_name numbers them, and then the constants by name.
static int compare_variables(const void *a, const void *b)
{
    const Var *x = *(const Var *const *)a, *y = *(const Var *const *)b;

    return x->is_constant != y->is_constant ? (x->is_constant ? 1 : -1) : strcmp(x->name->text, y->name->text);
}

static void list_variables(Arena *arena, LibraryModel *m)
{
    m->variable = ARENA_ARRAY(arena, const Var *, m->p->var.n);
    for (size_t i = 0; i < m->p->var.n; i++)
        if (m->p->var.at[i]->kind != VAR_TIME)
            m->variable[m->variables++] = m->p->var.at[i];
    qsort(m->variable, m->variables, sizeof *m->variable, compare_variables);
}

// ---- transitions ----

static void list_transitions(Session *c, LibraryModel *m)
{
    const Transitions all = transitions_of(&c->work, m->p);

    m->transition = ARENA_ARRAY(&c->arena, LibraryTransition, all.n);
    m->is_left = ARENA_ARRAY(&c->arena, bool, m->p->state.n);
    m->transitions = all.n;
    for (size_t i = 0; i < all.n; i++) {
        const Transition *t = &all.at[i];
        const char *guard = condition_text(&c->work, t->when);
        m->transition[i] = (LibraryTransition){t->from->number, t->to->number, (int32_t)t->block, t->stmt->span,
                                               arena_copy(&c->arena, guard, strlen(guard) + 1)};
        m->is_left[t->from->number - 1] = m->is_left[t->from->number - 1] || t->to != t->from;
    }
}

// ---- uses ----

typedef struct UseList {
    Arena *arena;
    LibraryModel *m;
    uint32_t *number;             // by Var.index: the variable's number; UINT32_MAX: T
    const State *state;           // the state whose uses are being collected
    uint32_t *access;             // by number: how that state accesses the variable
    uint32_t *touched, count;     // the numbers that it accesses
} UseList;

static void record_access(UseList *u, const Var *v, uint32_t access)
{
    const uint32_t number = u->number[v->index];

    if (number == UINT32_MAX)
        return;
    if (!u->access[number])
        u->touched[u->count++] = number;
    u->access[number] |= access;
}

static void record_read(Expr *e, void *context)
{
    if (e->kind == EX_VAR)
        record_access(context, e->var, SMC_ACCESS_READ);
}

static int compare_numbers(const void *a, const void *b)
{
    const uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;

    return x < y ? -1 : x > y;
}

// Appends the uses of the current state, sorted by variable.
static void end_state(UseList *u)
{
    qsort(u->touched, u->count, sizeof *u->touched, compare_numbers);
    for (uint32_t i = 0; i < u->count; i++) {
        const LibraryUse use = {u->state->number, u->touched[i], u->access[u->touched[i]]};
        vec_push(u->arena, &u->m->use, use);
        u->access[u->touched[i]] = 0;
    }
    u->count = 0;
}

static void record_statement(const StmtLocation *at, void *context)
{
    UseList *u = context;

    if (u->state != at->state)
        end_state(u);
    u->state = at->state;
    if (at->stmt->value)
        expr_walk(at->stmt->value, record_read, u);
    if (at->stmt->kind == ST_ASSIGN)
        record_access(u, at->stmt->var, SMC_ACCESS_WRITE);
}

static void list_uses(Session *c, LibraryModel *m)
{
    UseList u = {&c->arena, m, ARENA_ARRAY(&c->work, uint32_t, m->p->var.n), NULL, ARENA_ARRAY(&c->work, uint32_t, m->variables),
                 ARENA_ARRAY(&c->work, uint32_t, m->variables), 0};

    for (size_t i = 0; i < m->p->var.n; i++)
        u.number[i] = UINT32_MAX;
    for (uint32_t v = 0; v < m->variables; v++)
        u.number[m->variable[v]->index] = v;
    each_stmt_location(&c->work, m->p, record_statement, &u);
    end_state(&u);
}

// ---- all machines ----

// Returns the program of a source that is a machine, also of an application: of several machines of one file, that of the first. NULL: it is
// none, or has errors.
static const Program *program_of(const LibraryResults *of, uint32_t source)
{
    if (of->input[source])
        return of->made.of[of->input[source] - 1].program;
    for (size_t i = 0; of->in.app && of->made.app && i < of->in.app->files.instances; i++) {
        const AppInstance *m = &of->in.app->files.instance[i];
        if (of->text[source] && of->in.app->files.at[m->file].src == of->text[source])
            return m->program;
    }
    return NULL;
}

void library_build_models(SmcSession *s)
{
    LibraryResults *of = &s->of;

    of->model = ARENA_ARRAY(&s->compiler.arena, LibraryModel, of->sources);
    for (uint32_t i = 0; i < of->sources; i++) {
        LibraryModel *m = &of->model[i];
        if ((m->p = program_of(of, i)) == NULL)
            continue;
        list_variables(&s->compiler.arena, m);
        list_transitions(&s->compiler, m);
        list_uses(&s->compiler, m);
        arena_free(&s->compiler.work);
    }
}

// ---- reading: a machine without a program has no items ----

static const LibraryModel *model_of(const SmcSession *s, uint32_t machine)
{
    static const LibraryModel none;

    return library_is_open(s) && s->of.is_compiled && machine < s->of.sources && s->of.model[machine].p ? &s->of.model[machine] : &none;
}

static uint32_t line_of(Span span) { return span.src ? source_position(span.src, span.at).line : 0; }

static const State *state_of(const SmcSession *s, uint32_t machine, uint32_t state)
{
    const Program *p = model_of(s, machine)->p;

    return p && state >= 1 && state <= p->state.n ? p->state.at[state - 1] : NULL;
}

uint32_t smc_model_state_count(const SmcSession *s, uint32_t machine)
{
    const Program *p = model_of(s, machine)->p;

    return p ? (uint32_t)p->state.n : 0;
}

const char *smc_model_state_name(const SmcSession *s, uint32_t machine, uint32_t state)
{
    const State *at = state_of(s, machine, state);

    return at ? at->name->text : "";
}

uint32_t smc_model_state_marks(const SmcSession *s, uint32_t machine, uint32_t state)
{
    const State *at = state_of(s, machine, state);

    if (!at)
        return 0;
    return (at->is_safe ? SMC_MARK_SAFE : 0u) | (at->is_abort ? SMC_MARK_ABORT : 0u) | (at->is_safe || at->allows_swap ? SMC_MARK_SWAP : 0u) |
           (model_of(s, machine)->is_left[state - 1] ? 0u : SMC_MARK_FINAL);
}

uint32_t smc_model_state_line(const SmcSession *s, uint32_t machine, uint32_t state)
{
    const State *at = state_of(s, machine, state);

    return at ? line_of(at->span) : 0;
}

static const LibraryTransition *transition_of(const SmcSession *s, uint32_t machine, uint32_t transition)
{
    const LibraryModel *m = model_of(s, machine);

    return transition < m->transitions ? &m->transition[transition] : NULL;
}

uint32_t smc_model_transition_count(const SmcSession *s, uint32_t machine) { return model_of(s, machine)->transitions; }

uint32_t smc_model_transition_from(const SmcSession *s, uint32_t machine, uint32_t transition)
{
    const LibraryTransition *t = transition_of(s, machine, transition);

    return t ? t->from : 0;
}

uint32_t smc_model_transition_to(const SmcSession *s, uint32_t machine, uint32_t transition)
{
    const LibraryTransition *t = transition_of(s, machine, transition);

    return t ? t->to : 0;
}

int32_t smc_model_transition_block(const SmcSession *s, uint32_t machine, uint32_t transition)
{
    const LibraryTransition *t = transition_of(s, machine, transition);

    return t ? t->block : -1;
}

uint32_t smc_model_transition_line(const SmcSession *s, uint32_t machine, uint32_t transition)
{
    const LibraryTransition *t = transition_of(s, machine, transition);

    return t ? line_of(t->span) : 0;
}

const char *smc_model_transition_guard(const SmcSession *s, uint32_t machine, uint32_t transition)
{
    const LibraryTransition *t = transition_of(s, machine, transition);

    return t ? t->guard : "";
}

static const Var *variable_of(const SmcSession *s, uint32_t machine, uint32_t variable)
{
    const LibraryModel *m = model_of(s, machine);

    return variable < m->variables ? m->variable[variable] : NULL;
}

uint32_t smc_model_variable_count(const SmcSession *s, uint32_t machine) { return model_of(s, machine)->variables; }

const char *smc_model_variable_name(const SmcSession *s, uint32_t machine, uint32_t variable)
{
    const Var *v = variable_of(s, machine, variable);

    return v ? v->name->text : "";
}

int32_t smc_model_variable_type(const SmcSession *s, uint32_t machine, uint32_t variable)
{
    const Var *v = variable_of(s, machine, variable);

    return v ? (int32_t)v->type : -1;
}

int32_t smc_model_variable_kind(const SmcSession *s, uint32_t machine, uint32_t variable)
{
    const Var *v = variable_of(s, machine, variable);

    return v ? kind_of_variable(v) : -1;
}

uint32_t smc_model_variable_line(const SmcSession *s, uint32_t machine, uint32_t variable)
{
    const Var *v = variable_of(s, machine, variable);

    return v ? line_of(v->span) : 0;
}

static const LibraryUse *use_of(const SmcSession *s, uint32_t machine, uint32_t use)
{
    const LibraryModel *m = model_of(s, machine);

    return use < m->use.n ? &m->use.at[use] : NULL;
}

uint32_t smc_model_use_count(const SmcSession *s, uint32_t machine) { return (uint32_t)model_of(s, machine)->use.n; }

uint32_t smc_model_use_state(const SmcSession *s, uint32_t machine, uint32_t use)
{
    const LibraryUse *u = use_of(s, machine, use);

    return u ? u->state : 0;
}

int64_t smc_model_use_variable(const SmcSession *s, uint32_t machine, uint32_t use)
{
    const LibraryUse *u = use_of(s, machine, use);

    return u ? (int64_t)u->variable : -1;
}

uint32_t smc_model_use_access(const SmcSession *s, uint32_t machine, uint32_t use)
{
    const LibraryUse *u = use_of(s, machine, use);

    return u ? u->access : 0;
}
