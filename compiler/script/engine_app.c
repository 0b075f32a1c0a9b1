// SPDX-License-Identifier: Apache-2.0
// An engine for the machines of an application: in each tick it steps those that are due, one after the other, over one state vector
// (language.md 8.71 to 8.83).  Each machine has an engine of its own, which receives all elements before its step.  What the step stores is passed on
// to the next machine.
#include "compiler/script/engine.h"

#include <string.h>

#include "stdlib/convert.h"
#include "stdlib/types.h"

typedef struct MachineOfApp {
    const Member *member;
    Engine *engine;
    EngineStep answer;
    EngineWrite *write;       // first one write for each element that the machine lists, then what the script writes to the machine's locals
    uint32_t elements, writes;        // number of elements that the machine lists; number of writes
    uint64_t wait;            // number of ticks until the machine is due
    uint64_t periods;         // if rows of recorded data are ticks: how many of its periods had ended at the last tick
    bool ran;                 // the machine ran a step in this tick
} MachineOfApp;

typedef struct AppEngine {
    Engine engine;
    Arena *arena;
    const Program *p;
    uint64_t *cell;           // by Var.index of p: the value as a bit cell
    uint8_t *stored;          // by Var.index of p: 1 if a machine stored the variable in this tick
    MachineOfApp *machine;
    size_t machines;
    bool by_rows;             // each row of the recorded data is a tick
    uint64_t ticks;           // number of ticks that have run
} AppEngine;

// ---- one machine ----

// Copies variable v of a machine to the variables of the application, after the machine's step or init.
static void copy_variable(AppEngine *a, const MachineOfApp *m, size_t v)
{
    a->cell[m->member->var[v]->index] = m->answer.cell[v];
}

// Copies the elements that the machine has stored, its locals and its T to the variables of the application.
static void copy_results(AppEngine *a, const MachineOfApp *m)
{
    const Program *p = m->member->program;

    for (size_t v = 0; v < p->var.n; v++) {
        if (p->var.at[v]->kind == VAR_ELEMENT && !m->answer.stored[v])
            continue;
        copy_variable(a, m, v);
        a->stored[m->member->var[v]->index] |= p->var.at[v]->kind == VAR_ELEMENT;
    }
}

// Fills the writes of a machine with the elements that it lists.
static void pass_elements(const AppEngine *a, MachineOfApp *m)
{
    const Program *p = m->member->program;

    m->elements = 0;
    for (size_t v = 0; v < p->var.n; v++)
        if (p->var.at[v]->kind == VAR_ELEMENT)
            m->write[m->elements++] = (EngineWrite){(uint32_t)v, a->cell[m->member->var[v]->index]};
}

// Ends the run of the application because one machine's engine reported an error.
static EngineStatus fail_with(AppEngine *a, const MachineOfApp *m, const char *why)
{
    a->engine.error = format_in(a->arena, "machine '%s': %s", m->member->name->text, why ? why : "no reason given");
    return ENGINE_BROKEN;
}

// Steps a machine if it is due and enabled. Writes to its locals wait until it steps.
static EngineStatus step_machine(AppEngine *a, MachineOfApp *m)
{
    m->ran = false;
    if (m->wait > 0 || (m->member->mode && a->cell[m->member->mode->index] != MODE_ENABLED))
        return ENGINE_OK;
    pass_elements(a, m);
    m->answer.status = m->engine->step(m->engine, m->write, m->elements + m->writes, &m->answer);
    m->writes = 0;
    if (m->answer.status == ENGINE_BROKEN)
        return fail_with(a, m, m->engine->error);
    if (m->answer.status == ENGINE_REFUSED)
        return fail_with(a, m, "refused a step although G advanced");
    m->ran = true;
    copy_results(a, m);
    return ENGINE_OK;
}

// Adds a value that the script writes to a local of a machine to the writes of the machine's next step.
static void write_local(MachineOfApp *m, const Var *v, uint64_t cell)
{
    const Program *p = m->member->program;
    uint32_t local = 0, elements = 0;

    while (m->member->var[local] != v)
        local++;
    for (size_t i = 0; i < p->var.n; i++)
        elements += p->var.at[i]->kind == VAR_ELEMENT;
    for (uint32_t i = 0; i < m->writes; i++)
        if (m->write[elements + i].var == local) {
            m->write[elements + i].cell = cell;
            return;
        }
    m->write[elements + m->writes++] = (EngineWrite){local, cell};
}

// Decides whether a machine is due if rows of recorded data are ticks: in the first tick, and if one of its periods has ended since the last tick.
static void wait_for_period(const AppEngine *a, MachineOfApp *m)
{
    const uint64_t periods = joint_periods_until(a->p->joint, m->member->every, a->cell[a->p->g->index]);

    m->wait = a->ticks > 0 && periods == m->periods;
    m->periods = periods;
}

// ---- all machines ----

// Writes a variable of the application, and if it is a local, passes the value to its machine.
static void write_variable(AppEngine *a, EngineWrite w)
{
    const Var *v = a->p->var.at[w.var];

    a->cell[w.var] = w.cell;
    for (size_t i = 0; i < a->machines && v->kind == VAR_LOCAL; i++)
        for (size_t k = 0; k < a->machine[i].member->program->var.n; k++)
            if (a->machine[i].member->var[k] == v)
                write_local(&a->machine[i], v, w.cell);
}

static EngineStatus fill_result(const AppEngine *a, EngineStatus status, EngineStep *out)
{
    out->status = status;
    memcpy(out->cell, a->cell, a->p->var.n * sizeof *a->cell);
    memcpy(out->stored, a->stored, a->p->var.n);
    for (size_t i = 0; i < a->machines; i++) {
        const MachineOfApp *m = &a->machine[i];
        out->machine[i] = (EngineNext){m->member->first + m->answer.next_state, m->answer.next_is_first, m->ran};
    }
    return status;
}

// Runs one step of the application: every machine that is due, in order, on one shared state vector.
static EngineStatus app_step(Engine *e, const EngineWrite *write, uint32_t n, EngineStep *out)
{
    AppEngine *a = e->self;
    EngineStatus status = ENGINE_OK;

    memset(a->stored, 0, a->p->var.n);
    for (uint32_t i = 0; i < n; i++)
        write_variable(a, write[i]);
    for (size_t i = 0; i < a->machines && a->by_rows; i++)
        wait_for_period(a, &a->machine[i]);
    for (size_t i = 0; i < a->machines && status == ENGINE_OK; i++)
        status = step_machine(a, &a->machine[i]);
    a->ticks++;
    for (size_t i = 0; i < a->machines && !a->by_rows; i++) {
        MachineOfApp *m = &a->machine[i];
        m->wait = m->wait > 0 ? m->wait - 1 : m->member->every - 1;
    }
    return fill_result(a, status, out);
}

// Starts a machine: S is stored, and locals have their initial values.
static EngineStatus init_machine(AppEngine *a, MachineOfApp *m)
{
    const Program *p = m->member->program;

    m->wait = 0;
    m->writes = 0;
    if (m->engine->init(m->engine, m->member->initial->number, &m->answer) == ENGINE_BROKEN)
        return fail_with(a, m, m->engine->error);
    m->ran = false;
    for (size_t v = 0; v < p->var.n; v++)
        if (p->var.at[v]->kind != VAR_ELEMENT || p->var.at[v] == p->s)
            copy_variable(a, m, v);
    return ENGINE_OK;
}

// Starts all machines.  `state` is ignored, because the .app declares their initial states.
static EngineStatus app_init(Engine *e, uint32_t state, EngineStep *out)
{
    AppEngine *a = e->self;
    const Joint *j = a->p->joint;
    EngineStatus status = ENGINE_OK;

    (void)state;
    memset(a->cell, 0, a->p->var.n * sizeof *a->cell);
    memset(a->stored, 0, a->p->var.n);
    a->ticks = 0;
    for (size_t i = 0; i < j->start.n; i++)
        a->cell[j->start.at[i].var->index] = j->start.at[i].cell;
    for (size_t i = 0; i < a->machines && status == ENGINE_OK; i++)
        status = init_machine(a, &a->machine[i]);
    return fill_result(a, status, out);
}

static void app_close(Engine *e)
{
    AppEngine *a = e->self;

    for (size_t i = 0; i < a->machines; i++)
        a->machine[i].engine->close(a->machine[i].engine);
}

// Returns the engine that runs the machines: e, or the one inside it.
static Engine *innermost(Engine *e)
{
    while (e->inside)
        e = e->inside;
    return e;
}

void engine_app_set_rows(Engine *e, bool by_rows) { ((AppEngine *)innermost(e)->self)->by_rows = by_rows; }

Engine *engine_app_machine(Engine *e, size_t i)
{
    return e->program->joint ? ((AppEngine *)innermost(e)->self)->machine[i].engine : e;
}

Engine *engine_app_open(Arena *arena, const Program *p, Engine *const *machine)
{
    AppEngine *a = ARENA_NEW(arena, AppEngine);

    a->arena = arena;
    a->p = p;
    a->cell = ARENA_ARRAY(arena, uint64_t, p->var.n);
    a->stored = arena_alloc(arena, p->var.n);
    a->machines = engine_machines(p);
    a->machine = ARENA_ARRAY(arena, MachineOfApp, a->machines);
    for (size_t i = 0; i < a->machines; i++) {
        MachineOfApp *m = &a->machine[i];
        m->member = &p->joint->member.at[i];
        m->engine = machine[i];
        m->write = ARENA_ARRAY(arena, EngineWrite, m->member->program->var.n);
        engine_step_init(&m->answer, arena, m->member->program);
    }
    a->engine.name = machine[0]->name;
    a->engine.program = p;
    a->engine.self = a;
    a->engine.init = app_init;
    a->engine.step = app_step;
    a->engine.close = app_close;
    return &a->engine;
}
