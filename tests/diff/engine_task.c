// SPDX-License-Identifier: Apache-2.0
#include "tests/diff/engine_task.h"

#include <string.h>

#include "bytecode-vm/image.h"
#include "bytecode-vm/target/machine.h"
#include "compiler/base/buf.h"
#include "runtime-c/machine.h"
#include "runtime-c/psl/sim/sim.h"
#include "stdlib/convert.h"

enum { NOISE = 0xe7 };

typedef struct Task {
    Engine engine;
    const Program *p;
    SmLayout layout;
    SmStateVec vector;
    SmEvents events;
    SmEvent ring[4];
    uint32_t cursor;
    SmMachine machine;
    SmvmTarget target;
    uint8_t *sv, *before, *noise;
    uint32_t *local;          // by variable: 1 + its index among the locals; 0: it is not a local, or the index is unknown
} Task;

// ---- others ----

static Task *running;

static SmResult step_in_noise(void *self, void *copy)
{
    SmResult r;

    memcpy(running->sv, running->noise, running->layout.whole.size);
    r = smvm_machine_type.step(self, copy);
    memcpy(running->sv, running->noise, running->layout.whole.size);
    return r;
}

// ---- the answer ----

static uint8_t *place(const Task *t, uint32_t k)      // NULL: T, a constant, or unknown
{
    const Var *v = t->p->var.at[k];

    if (v->kind == VAR_ELEMENT)
        return t->sv + v->element->offset;
    return t->local[k] != 0 ? (uint8_t *)smvm_locals(t->target.vm) + t->local[k] - 1 : NULL;
}

static void note_stored(const Task *t, EngineStep *out)
{
    SmvmMachine m;

    smvm_machine(t->target.image, 0, &m);
    for (uint32_t i = 0; i < m.outputs; i++)
        for (uint32_t k = 0; smvm_stored(t->target.vm, i) && k < t->p->var.n; k++)
            if (t->p->var.at[k]->kind == VAR_ELEMENT && t->p->var.at[k]->element->offset == smvm_output(&m, i).offset)
                out->stored[k] = 1;
    if (smvm_stored_state(t->target.vm))
        out->stored[t->p->s->index] = 1;
}

static EngineStatus answer(Task *t, EngineStatus status, EngineStep *out)
{
    out->status = status;
    out->next_state = sm_machine_state(&t->machine);
    out->next_is_first = t->target.vm->first;
    for (uint32_t k = 0; k < t->p->var.n; k++) {
        const Var *v = t->p->var.at[k];
        out->cell[k] = place(t, k) ? sm_cell_load(v->type, place(t, k)) : v == t->p->t ? sm_machine_time(&t->machine) : v->init;
    }
    return status;
}

static EngineStatus broken(Engine *e, EngineStep *out, const char *error)
{
    e->error = error;
    return out->status = ENGINE_BROKEN;
}

// ---- what must be so ----

// Whether the machine stored only what `out` says.  All other bytes must have the noise, and get their earlier values back.
static bool only_stored(Task *t, const EngineStep *out)
{
    bool ok = true;

    for (uint32_t k = 0; k < t->p->var.n; k++)
        if (t->p->var.at[k]->kind == VAR_ELEMENT && out->stored[k]) {
            uint32_t at = t->p->var.at[k]->element->offset, n = sm_type_info[t->p->var.at[k]->type].bytes;
            memcpy(t->before + at, t->sv + at, n);
            memcpy(t->sv + at, t->noise + at, n);
        }
    ok = memcmp(t->sv, t->noise, t->layout.whole.size) == 0;
    memcpy(t->sv, t->before, t->layout.whole.size);
    return ok;
}

// A transition emits one event.  The first of several refused steps emits one with the reason, `machine.refused`.  Other steps emit none.
static bool events_are_right(Task *t, SmResult r, uint32_t from, bool standing)
{
    SmEvent e = {.b = 0};
    bool one = sm_events_read(&t->events, &t->cursor, &e, 1, NULL) == 1;

    if (t->events.next != t->cursor)
        return false;
    if (r == SM_REFUSED)
        return standing ? !one : one && e.kind == SM_EVENT_REFUSED && e.a == t->machine.refused;
    if (!t->target.vm->first)
        return !one;
    return one && e.kind == SM_EVENT_STATE && e.a == from && e.b == sm_machine_state(&t->machine);
}

// ---- engine ----

static EngineStatus task_step(Engine *e, const EngineWrite *write, uint32_t n, EngineStep *out)
{
    Task *t = e->self;
    const SmTick tick = {0, 0};
    const uint32_t from = t->machine.last_state;
    const bool standing = t->machine.was_refused;
    SmResult r;

    for (uint32_t i = 0; i < n; i++)
        if (place(t, write[i].var))
            sm_cell_store(t->p->var.at[write[i].var]->type, place(t, write[i].var), write[i].cell);
    memcpy(t->before, t->sv, t->layout.whole.size);
    running = t;
    r = sm_machine_step(&t->machine, &tick);
    memset(out->stored, 0, t->p->var.n);
    if (r == SM_OK)
        note_stored(t, out);
    if (!only_stored(t, out))
        return broken(e, out, "it wrote more than it stored");
    if (!events_are_right(t, r, from, standing))
        return broken(e, out, "its events are not what happened");
    if (r != SM_OK && r != SM_REFUSED)
        return broken(e, out, sm_result_text(r));
    return answer(t, r == SM_OK ? ENGINE_OK : ENGINE_REFUSED, out);
}

static EngineStatus task_init(Engine *e, uint32_t state, EngineStep *out)
{
    Task *t = e->self;
    SmResult r;

    memset(t->sv, 0, t->layout.whole.size);
    t->machine.initial = state;
    r = sm_machine_init(&t->machine);
    if (r != SM_OK)
        return broken(e, out, sm_result_text(r));
    t->cursor = t->events.next;
    memset(out->stored, 0, t->p->var.n);
    return answer(t, ENGINE_OK, out);
}

static void task_close(Engine *e) { pal_lock_close(((Task *)e->self)->vector.lock); }

// ---- opening ----

static void find_local(Task *t, SmvmName name, const SmvmLocation *at)
{
    for (uint32_t k = 0; k < t->p->var.n; k++) {
        const Var *v = t->p->var.at[k];
        if (v->kind == VAR_LOCAL && at->type == v->type && v->name->len == name.size
            && memcmp(v->name->text, t->target.image + name.at, name.size) == 0)
            t->local[k] = 1 + at->offset;
    }
}

static void set_up(Task *t, Arena *arena, const uint8_t *image, size_t size, bool decoded)
{
    static SmMachineType type;
    SmvmMachine m;

    smvm_machine(image, 0, &m);
    type = smvm_machine_type;
    type.step = step_in_noise;
    t->layout.hash = t->p->sv->hash;
    t->layout.whole.size = t->p->sv->size;
    t->vector = (SmStateVec){.layout = &t->layout, .at = t->sv, .guarded = true};
    t->events = (SmEvents){.at = t->ring, .room = 4};
    t->target = (SmvmTarget){.image = image, .size = (uint32_t)size, .memory_size = smvm_ram_size(&m),
        .memory = arena_alloc(arena, smvm_ram_size(&m)), .decoder = decoded ? &smvm_decoder : NULL, .decoded_size = smvm_decoded_size(&m),
        .decoded = decoded ? arena_alloc(arena, smvm_decoded_size(&m)) : NULL};
    t->machine = (SmMachine){.name = "task", .type = &type, .self = &t->target, .sv = &t->vector, .events = &t->events,
        .copy = arena_alloc(arena, t->layout.whole.size)};
}

Engine *engine_task_open(Arena *arena, const Program *p, const uint8_t *image, size_t size, bool decoded, const char **error)
{
    Task *t = ARENA_NEW(arena, Task);
    SmvmMachine m;
    SmvmVariable is;
    SmvmLocation at;

    t->p = p;
    t->sv = arena_alloc(arena, p->sv->size);
    t->before = arena_alloc(arena, p->sv->size);
    t->noise = arena_alloc(arena, p->sv->size);
    memset(t->noise, NOISE, p->sv->size);
    t->local = ARENA_ARRAY(arena, uint32_t, p->var.n);
    set_up(t, arena, image, size, decoded);
    smvm_machine(image, 0, &m);
    for (uint32_t i = 0; i < smvm_variables(&m); i++) {
        SmvmName name = smvm_variable(&m, i, &is, &at);
        if (is == SMVM_IS_LOCAL)
            find_local(t, name, &at);
    }
    *error = sm_statevec_init(&t->vector) != SM_OK || sm_events_init(&t->events) != SM_OK ? "no lock is left" : NULL;
    t->engine = (Engine){.name = decoded ? "task, decoded" : "task", .program = p, .self = t, .init = task_init, .step = task_step, .close = task_close};
    return *error ? NULL : &t->engine;
}
