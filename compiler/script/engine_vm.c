// SPDX-License-Identifier: Apache-2.0
// The engine that runs the VM in this process, with the same code as in flight.  Elements are in its own state vector, at the program's
// offsets.  Locals are found by name in the image's debug section.
//
// The machine runs twice: on decoded instructions, which returns the results, and in place, directly on the bytes of the image.  Any
// difference between the two is an error.
#include <string.h>

#include "bytecode-vm/image.h"
#include "bytecode-vm/smvm.h"
#include "compiler/base/buf.h"
#include "compiler/script/engine.h"
#include "stdlib/convert.h"

typedef struct VmEngine {
    Engine engine;
    const Program *p;
    SmvmMachine m;
    SmVm *vm, *in_place;      // `vm` runs decoded instructions, `in_place` the image itself
    SmvmDecoded *decoded;
    uint32_t size;            // size in bytes of *vm and of *in_place
    uint64_t *sv, *sv_in_place; // the state vectors of `vm` and of `in_place`
    uint8_t **at;             // by Var.index: address of the value; NULL: T and constants
    uint32_t *output;         // by Var.index: 1 + the variable's number among the outputs; 0: not an output
} VmEngine;

// ---- stepping ----

// Copies the state of the decoded run to *out; returns `status`.
static EngineStatus fill_result(const VmEngine *v, EngineStatus status, EngineStep *out)
{
    const Program *p = v->p;

    out->status = status;
    out->next_state = smvm_state(v->vm);
    out->next_is_first = v->vm->first;
    for (uint32_t i = 0; i < p->var.n; i++) {
        if (v->at[i])
            out->cell[i] = sm_cell_load(p->var.at[i]->type, v->at[i]);
        else
            out->cell[i] = p->var.at[i] == p->t ? smvm_time(v->vm) : p->var.at[i]->init;
        out->stored[i] = status == ENGINE_OK && v->output[i] != 0 && smvm_stored(v->vm, v->output[i] - 1);
    }
    return status;
}

static EngineStatus set_broken(Engine *e, EngineStep *out, const char *error)
{
    e->error = error;
    return out->status = ENGINE_BROKEN;
}

// Whether the decoded run and the run in place have the same state.  The compared locals include intermediate values.
static bool has_same_state(const VmEngine *v)
{
    for (uint32_t i = 0; i < v->m.outputs; i++)
        if (smvm_stored(v->vm, i) != smvm_stored(v->in_place, i))
            return false;
    return memcmp(v->sv, v->sv_in_place, v->m.sv_size) == 0 && memcmp(smvm_locals(v->vm), smvm_locals(v->in_place), v->m.locals) == 0
        && smvm_state(v->vm) == smvm_state(v->in_place) && v->vm->first == v->in_place->first && smvm_time(v->vm) == smvm_time(v->in_place)
        && smvm_stored_state(v->vm) == smvm_stored_state(v->in_place);
}

// Writes an input to both runs.
static void write_cell(const VmEngine *v, const EngineWrite *w)
{
    uint8_t *at = v->at[w->var], *sv = (uint8_t *)v->sv, *locals = smvm_locals(v->vm);
    SmType type = v->p->var.at[w->var]->type;

    if (at == NULL)
        return;
    sm_cell_store(type, at, w->cell);
    if (v->p->var.at[w->var]->kind == VAR_ELEMENT)
        sm_cell_store(type, (uint8_t *)v->sv_in_place + (at - sv), w->cell);
    else
        sm_cell_store(type, (uint8_t *)smvm_locals(v->in_place) + (at - locals), w->cell);
}

// Runs a step on the VM, decoded and in place, and compares both.
static EngineStatus vm_step(Engine *e, const EngineWrite *write, uint32_t n, EngineStep *out)
{
    VmEngine *v = e->self;
    SmResult result, in_place;

    for (uint32_t i = 0; i < n; i++)
        write_cell(v, &write[i]);
    result = smvm_step_decoded(v->decoded, v->sv);
    in_place = smvm_step(v->in_place, v->sv_in_place);
    if (result != in_place || !has_same_state(v))
        return set_broken(e, out, "the decoded form of the image does not do what the image does");
    fill_result(v, result == SM_OK ? ENGINE_OK : ENGINE_REFUSED, out);
    if (result == SM_OK && smvm_stored_state(v->vm))
        out->stored[v->p->s->index] = 1;
    return out->status;
}

static SmResult init_vm(const VmEngine *v, SmVm *vm, uint64_t *sv, uint32_t state)
{
    const SmvmVector vector = {sv, v->p->sv->size, v->p->sv->hash};

    return smvm_init(vm, v->size, &v->m, &vector, state);
}

static EngineStatus vm_init(Engine *e, uint32_t state, EngineStep *out)
{
    VmEngine *v = e->self;
    SmResult result;

    memset(v->sv, 0, v->m.sv_size);
    memset(v->sv_in_place, 0, v->m.sv_size);
    result = init_vm(v, v->vm, v->sv, state);
    if (result == SM_OK)
        result = init_vm(v, v->in_place, v->sv_in_place, state);
    if (result != SM_OK)
        return set_broken(e, out, sm_result_text(result));
    fill_result(v, ENGINE_OK, out);
    memset(out->stored, 0, v->p->var.n);
    return ENGINE_OK;
}

static void vm_close(Engine *e) { (void)e; }          // all its memory belongs to the arena

// ---- opening ----

// Finds where elements are stored, and their numbers among the outputs.
static void bind_elements(VmEngine *v, Arena *arena)
{
    uint32_t *var_at = ARENA_ARRAY(arena, uint32_t, v->m.sv_size);       // by byte offset in the state vector: 1 + Var.index of the element there

    for (uint32_t k = 0; k < v->p->var.n; k++) {
        const Var *var = v->p->var.at[k];
        if (var->kind == VAR_ELEMENT) {
            v->at[k] = (uint8_t *)v->sv + var->element->offset;
            var_at[var->element->offset] = k + 1;
        }
    }
    for (uint32_t i = 0; i < v->m.outputs; i++) {
        uint32_t k = var_at[smvm_output(&v->m, i).offset];
        if (k != 0)
            v->output[k - 1] = i + 1;
    }
}

// Whether variable k is the local that the image calls `name`.
static bool is_local_named(const VmEngine *v, uint32_t k, SmvmName name, const SmvmLocation *at)
{
    const Var *var = v->p->var.at[k];

    return var->kind == VAR_LOCAL && at->type == var->type && var->name->len == name.size
        && at->offset + sm_type_info[var->type].bytes <= v->m.locals              // the verifier does not check the debug section
        && memcmp(var->name->text, v->m.image + name.at, name.size) == 0;
}

// Finds where locals are stored, by name.  The image has the locals of a type in the program's order, possibly with gaps, so each search
// starts at the previous match.
static void bind_locals(VmEngine *v)
{
    uint8_t *locals = smvm_locals(v->vm);
    uint32_t from = 0, n = (uint32_t)v->p->var.n;

    for (uint32_t i = 0; i < smvm_variables(&v->m); i++) {
        SmvmVariable is;
        SmvmLocation at;
        SmvmName name = smvm_variable(&v->m, i, &is, &at);
        for (uint32_t k = 0; is == SMVM_IS_LOCAL && k < n; k++)
            if (is_local_named(v, (from + k) % n, name, &at)) {
                from = (from + k) % n;
                v->at[from] = locals + at.offset;
                break;
            }
    }
}

// Returns NULL if every local was found in the image, otherwise a sentence about one that was not.
static const char *find_unbound_local(const VmEngine *v, Arena *arena)
{
    for (uint32_t k = 0; k < v->p->var.n; k++) {
        const Var *var = v->p->var.at[k];
        if (var->kind == VAR_LOCAL && !var->is_constant && !v->at[k])
            return format_in(arena, "the image has no local named '%s'; was it built with --strip?", var->name->text);
    }
    return NULL;
}

// Verifies an image, allocates both VMs and decodes the machine.  Returns NULL, or the reason of a failure.
static const char *load_image(VmEngine *v, Arena *arena, const uint8_t *image, size_t size, uint32_t machine)
{
    SmvmVerdict why;
    SmResult result;

    if (size > SMVM_IMAGE_MAX || smvm_verify(image, (uint32_t)size, &why) != 0)
        return format_in(arena, "the image breaks rule %u: %s", size > SMVM_IMAGE_MAX ? SMVM_R_LENGTH : why.rule,
                         smvm_rule_text(size > SMVM_IMAGE_MAX ? SMVM_R_LENGTH : why.rule));
    if (!smvm_machine(image, machine, &v->m))
        return format_in(arena, "the image has no machine number %lu", (unsigned long)machine);
    if (v->m.states != v->p->state.n)
        return "the image was made from another machine";
    v->size = smvm_ram_size(&v->m);
    v->vm = arena_alloc(arena, v->size);
    v->in_place = arena_alloc(arena, v->size);
    v->sv = arena_alloc(arena, v->p->sv->size);
    v->sv_in_place = arena_alloc(arena, v->p->sv->size);
    result = init_vm(v, v->vm, v->sv, 1);
    if (result == SM_OK)
        result = smvm_decode(&v->decoded, arena_alloc(arena, smvm_decoded_size(&v->m)), smvm_decoded_size(&v->m), &v->m, v->vm, v->sv);
    return result == SM_OK ? NULL : sm_result_text(result);
}

// Opens the VM, with an image in which p is machine number `machine`.
Engine *engine_vm_open(Arena *arena, const Program *p, const uint8_t *image, size_t size, uint32_t machine, const char **error)
{
    VmEngine *v = ARENA_NEW(arena, VmEngine);

    v->p = p;
    v->at = ARENA_ARRAY(arena, uint8_t *, p->var.n);
    v->output = ARENA_ARRAY(arena, uint32_t, p->var.n);
    *error = load_image(v, arena, image, size, machine);
    if (*error)
        return NULL;
    bind_elements(v, arena);
    bind_locals(v);
    *error = find_unbound_local(v, arena);
    if (*error)
        return NULL;
    v->engine.name = SM_F64_SOFT ? "vm-soft" : "vm";
    v->engine.program = p;
    v->engine.self = v;
    v->engine.init = vm_init;
    v->engine.step = vm_step;
    v->engine.close = vm_close;
    return &v->engine;
}

EngineLocation engine_vm_location(const Engine *e, uint32_t var)
{
    const VmEngine *v = e->self;
    const Var *of = v->p->var.at[var];
    EngineLocation place = {LOCATION_CONSTANT, 0, v->output[var]};

    if (of == v->p->t)
        place.in = LOCATION_TIME;
    if (v->at[var]) {
        place.in = of->kind == VAR_ELEMENT ? LOCATION_ELEMENT : LOCATION_LOCAL;
        place.offset = (uint32_t)(v->at[var] - (place.in == LOCATION_ELEMENT ? (uint8_t *)v->sv : (uint8_t *)smvm_locals(v->vm)));
    }
    return place;
}
