// SPDX-License-Identifier: Apache-2.0
// The engine that measures coverage: a flat machine with probes.  It runs in lock step with the engines of a test, so every value that it
// computes is compared with theirs, bit for bit.
#include "compiler/cover/cover.h"

#include <string.h>

typedef struct CoverEngine {
    Engine engine;
    FlatMachine *flat;
    void *run;                // the state of the run
    const Program *p;
    Cover *cover;             // counts the values of parameters; or NULL
    uint64_t *parameter;      // buffer for cover_count_parameters: by Var.index, the cell when the run began
} CoverEngine;

// Copies the state of the machine to *out; returns `status`.
static EngineStatus fill_result(const CoverEngine *c, EngineStatus status, EngineStep *out)
{
    const FlatState *s = c->run;
    const uint64_t *cell = flat_cells(c->flat, c->run);

    out->status = status;
    out->next_state = s->state;
    out->next_is_first = s->first;
    for (size_t i = 0; i < c->p->var.n; i++) {
        const Var *v = c->p->var.at[i];
        const uint32_t at = c->flat->m->var_of[v->index];
        out->cell[i] = at == IR_NONE ? v->init : cell[at];
        out->stored[i] = at != IR_NONE && v->kind == VAR_ELEMENT && c->flat->stored[at];
    }
    return status;
}

// Counts the values that parameters have in the first step of a run.
static void count_parameters(const CoverEngine *c)
{
    for (size_t i = 0; i < c->p->var.n; i++)
        if (c->p->var.at[i]->parameter)
            c->parameter[i] = flat_cells(c->flat, c->run)[c->flat->m->var_of[i]];
    cover_count_parameters(c->cover, c->parameter);
}

// Runs a step of the flat machine, whose probes count what the step covers.
static EngineStatus cover_step(Engine *e, const EngineWrite *write, uint32_t n, EngineStep *out)
{
    CoverEngine *c = e->self;
    const bool is_first = !((const FlatState *)c->run)->ran;      // no step has run; a refused step does not count

    for (uint32_t i = 0; i < n; i++) {
        const uint32_t at = c->flat->m->var_of[write[i].var];
        if (at != IR_NONE)
            flat_cells(c->flat, c->run)[at] = write[i].cell;
    }
    if (!flat_step(c->flat, c->run))
        return fill_result(c, ENGINE_REFUSED, out);
    if (c->cover && is_first)
        count_parameters(c);
    return fill_result(c, ENGINE_OK, out);
}

static EngineStatus cover_init(Engine *e, uint32_t state, EngineStep *out)
{
    CoverEngine *c = e->self;

    memset(c->flat->stored, 0, c->flat->m->var.n);
    flat_start(c->flat, c->run, state);
    return fill_result(c, ENGINE_OK, out);
}

static void cover_close(Engine *e) { (void)e; }       // all its memory belongs to the arena

Engine *engine_flat_open(Arena *arena, const Program *p, FlatMachine *f)
{
    CoverEngine *c = ARENA_NEW(arena, CoverEngine);

    c->p = p;
    c->flat = f;
    c->run = arena_alloc(arena, f->size);
    c->engine.name = "coverage";
    c->engine.program = p;
    c->engine.self = c;
    c->engine.init = cover_init;
    c->engine.step = cover_step;
    c->engine.close = cover_close;
    return &c->engine;
}

FlatMachine **flat_new_machines(Arena *arena, const Program *p)
{
    const size_t machines = engine_machines(p);
    FlatMachine **flat = ARENA_ARRAY(arena, FlatMachine *, machines);

    for (size_t i = 0; i < machines; i++)
        flat[i] = flat_new(arena, ir_build(arena, engine_program(p, i)), NULL);
    return flat;
}

Engine *engine_flat_open_machines(Arena *arena, const Program *p, FlatMachine *const *flat, Engine *one, size_t member)
{
    const size_t machines = engine_machines(p);
    Engine **machine = ARENA_ARRAY(arena, Engine *, machines);

    for (size_t i = 0; i < machines; i++)
        machine[i] = one && i == member ? one : engine_flat_open(arena, engine_program(p, i), flat[i]);
    return p->joint ? engine_app_open(arena, p, machine) : machine[0];
}

Engine *cover_open_engine(Cover *c)
{
    Engine *e = engine_flat_open(c->arena, c->p, c->flat);
    CoverEngine *self = e->self;

    if (program_has_parameters(c->p)) {
        self->cover = c;
        self->parameter = ARENA_ARRAY(c->arena, uint64_t, c->p->var.n);
    }
    return e;
}

Engine *cover_open_engines(Arena *arena, const Program *p, Cover *const *machine)
{
    const size_t machines = engine_machines(p);
    Engine **e = ARENA_ARRAY(arena, Engine *, machines);

    for (size_t i = 0; i < machines; i++)
        e[i] = cover_open_engine(machine[i]);
    return p->joint ? engine_app_open(arena, p, e) : e[0];
}

void engine_flat_set(Engine *e, FlatMachine *f, void *run)
{
    CoverEngine *c = e->self;

    c->flat = f;
    c->run = run;
    c->cover = NULL;
}

void *engine_flat_run(const Engine *e) { return ((const CoverEngine *)e->self)->run; }
