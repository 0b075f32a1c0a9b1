// SPDX-License-Identifier: Apache-2.0
#include "compiler/sema/join.h"

#include <string.h>

// The construction of the Program of an application.
typedef struct Join {
    const CheckContext *c;
    const App *app;
    Program *p;
    Joint *joint;
    Var **element;            // by Element.index: the variable of the joined Program
} Join;

static Str dotted_name(Join *k, Str machine, Str name) { return str_c(k->c->strings, format_in(k->c->arena, "%s.%s", machine->text, name->text)); }

// Adds a copy of the variable, with a new name, to the joined program.
static Var *add_variable(Join *k, const Var *from, Str name)
{
    Var *v = arena_copy(k->c->arena, from, sizeof *from);

    v->name = v->report_name = name;
    v->alias = NULL;
    v->index = (uint32_t)k->p->var.n;
    vec_push(k->c->arena, &k->p->var, v);
    return v;
}

// Adds one variable for each element of the application's state vector. The machines share them.
static void add_elements(Join *k)
{
    const StateVec *sv = k->app->sv;

    k->element = ARENA_ARRAY(k->c->arena, Var *, sv->element.n);
    for (size_t i = 0; i < sv->element.n; i++) {
        Element *e = sv->element.at[i];
        Var from = {.kind = VAR_ELEMENT, .type = e->type, .element = e, .range = e->range, .command = e->command, .unit = e->unit, .span = e->span};
        from.read_only = e == k->app->time;
        k->element[e->index] = add_variable(k, &from, e->name);
        map_put(&k->p->by_name, e->name, k->element[e->index]);
    }
    k->p->g = k->element[k->app->time->index];
    if (!map_find(&k->p->by_name, str_c(k->c->strings, "G")))
        map_put(&k->p->by_name, str_c(k->c->strings, "G"), k->p->g);
}

// ---- machines ----

// Adds the states of a machine, with new numbers and names of the form machine.state.
static void add_states(Join *k, Member *m)
{
    m->first = (uint32_t)k->p->state.n;
    for (size_t i = 0; i < m->program->state.n; i++) {
        State *s = arena_copy(k->c->arena, m->program->state.at[i], sizeof *s);
        s->name = dotted_name(k, m->name, s->name);
        s->number = (uint32_t)k->p->state.n + 1;
        vec_push(k->c->arena, &k->p->state, s);
        map_put(&k->p->state_by_name, s->name, s);
    }
}

// Returns the joined program's variable for v of a machine: the shared one of an element, else a new one.
static Var *add_variable_of(Join *k, const Member *m, const Var *v)
{
    return v->element ? k->element[v->element->index] : add_variable(k, v, dotted_name(k, m->name, v->name));
}

// Maps each variable of the machine to one of the joined program, in m->var.
static void add_variables_of(Join *k, Member *m)
{
    const Program *p = m->program;

    m->var = ARENA_ARRAY(k->c->arena, const Var *, p->var.n);
    for (size_t i = 0; i < p->var.n; i++) {
        Var *v = add_variable_of(k, m, p->var.at[i]);
        m->var[i] = v;
        map_put(&k->p->by_name, dotted_name(k, m->name, p->var.at[i]->name), v);
        if (p->var.at[i]->alias)
            map_put(&k->p->by_name, dotted_name(k, m->name, p->var.at[i]->alias), v);
        if (p->var.at[i] == p->s) {
            v->state_of = p;
            v->read_only = true;
            m->s = v;
        }
        if (p->var.at[i] == p->t)
            m->t = v;
    }
}

// Copies the machine's requirement marks, with the joined program's states in them.
static void add_marks(Join *k, const Member *m)
{
    for (size_t i = 0; i < m->program->mark.n; i++) {
        RequirementMark mark = m->program->mark.at[i];
        mark.state = mark.state ? k->p->state.at[m->first + mark.state->number - 1] : NULL;
        vec_push(k->c->arena, &k->p->mark, mark);
    }
}

static void add_member(Join *k, const AppTask *task, const AppRate *rate, const Program *program)
{
    Member m = {.name = task->machine->name, .program = program, .every = rate->period / k->joint->tick};

    m.initial = task->machine->initial ? program->state.at[task->machine->initial->number - 1] : program->state.at[0];
    m.mode = task->mode ? k->element[task->mode->index] : NULL;
    add_states(k, &m);
    add_variables_of(k, &m);
    add_marks(k, &m);
    vec_push(k->c->arena, &k->joint->member, m);
}

// Adds the machines that the executor runs to the joined program.  Returns their number.
static size_t add_members_of(Join *k, const AppExecutor *x, const Program *const *program)
{
    size_t before = k->joint->member.n;

    for (size_t r = 0; r < x->rate.n; r++)
        for (size_t t = 0; t < x->rate.at[r]->task.n; t++) {
            const AppTask *task = x->rate.at[r]->task.at[t];
            if (task->machine)
                add_member(k, task, x->rate.at[r], program[task->machine->number]);
        }
    return k->joint->member.n - before;
}

static void add_members(Join *k, const Program *const *program)
{
    const AppExecutor *first = NULL;

    for (size_t i = 0; i < k->app->executor.n; i++) {
        const AppExecutor *x = k->app->executor.at[i];
        if (add_members_of(k, x, program) == 0)
            continue;
        if (first)
            diag_report(k->c->diags, DIAG_executors_in_order, x->span, x->name->text, first->name->text);
        first = x;
    }
}

// ---- time ----

static uint64_t gcd(uint64_t a, uint64_t b)
{
    while (b) {
        const uint64_t rest = a % b;
        a = b;
        b = rest;
    }
    return a;
}

static void set_time(Join *k)
{
    for (size_t i = 0; i < k->app->executor.n; i++)
        for (size_t r = 0; r < k->app->executor.at[i]->rate.n; r++)
            k->joint->tick = gcd(k->joint->tick, k->app->executor.at[i]->rate.at[r]->period);
    k->joint->unit = k->app->unit;
    k->p->time_unit = time_unit_of_period(k->app->unit);
    if (k->joint->tick % k->joint->unit == 0)
        k->p->step = k->joint->tick / k->joint->unit;
    k->p->step_span = k->app->time_span;
}

uint32_t joint_machine_of(const Joint *j, uint32_t number)
{
    uint32_t i = 0;

    while (i + 1 < j->member.n && j->member.at[i + 1].first < number)
        i++;
    return i;
}

JointUses program_uses_of(const Program *p, const Var *v)
{
    JointUses u = {p->joint ? false : v->read, p->joint ? false : v->written, v->read_only};

    for (size_t m = 0; p->joint && m < p->joint->member.n; m++) {
        const Member *member = &p->joint->member.at[m];
        for (size_t i = 0; i < member->program->var.n; i++)
            if (member->var[i] == v) {
                u.read |= member->program->var.at[i]->read;
                u.written |= member->program->var.at[i]->written;
                u.read_only |= member->program->var.at[i]->read_only;
            }
    }
    return u;
}

// Computes floor(g * unit / period).  A period is at most an hour and a unit at most a second, so after division by their gcd, x below is less
// than 2^42 and the unit less than 2^30.
uint64_t joint_periods_until(const Joint *j, uint64_t every, uint64_t g)
{
    enum { HALF = 15 };
    const uint64_t common = gcd(every * j->tick, j->unit), period = every * j->tick / common, unit = j->unit / common;
    const uint64_t x = g % period, high = x * (unit >> HALF), low = x * (unit & ((1u << HALF) - 1));

    return g / period * unit + ((high / period) << HALF) + (((high % period) << HALF) + low) / period;
}

const Program *join_machines(const CheckContext *c, const App *app, const Program *const *program)
{
    Join k = {c, app, ARENA_NEW(c->arena, Program), ARENA_NEW(c->arena, Joint), NULL};

    if (app->machine.n == 0) {
        diag_report(c->diags, DIAG_app_without_machines, (Span){app->src, 0, 0});
        return NULL;
    }
    k.p->stem = k.p->name = app->name;
    k.p->src = app->src;
    k.p->sv = (StateVec *)(size_t)app->sv;
    k.p->by_name.arena = k.p->state_by_name.arena = c->arena;
    k.joint->app = app;
    set_time(&k);
    add_elements(&k);
    add_members(&k, program);
    for (size_t i = 0; i < app->start.n; i++)
        vec_push(c->arena, &k.joint->start, ((MemberStart){k.element[app->start.at[i].element->index], app->start.at[i].cell}));
    k.p->joint = k.joint;
    return k.p;
}
