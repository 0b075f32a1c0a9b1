// SPDX-License-Identifier: Apache-2.0
// The VM as an engine: what flies, in this process.  Elements lie in a state vector of its own at the program's offsets;
// locals are found by their names in the image's debug section.
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
    SmVm *vm;
    uint32_t size;            // bytes at vm
    uint64_t *sv;             // the state vector
    SmvmVector vector;        // the same, as the VM wants it
    uint8_t **at;             // by variable: where its value lies; NULL: T and constants
    uint32_t *output;         // by variable: 1 + its number among the outputs; 0: it is none
} VmEngine;

// ---- stepping ----

static EngineStatus answer(const VmEngine *v, EngineStatus status, EngineStep *out)
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

static EngineStatus vm_step(Engine *e, const EngineWrite *write, uint32_t n, EngineStep *out)
{
    VmEngine *v = e->self;
    SmResult result;

    for (uint32_t i = 0; i < n; i++)
        if (v->at[write[i].var])
            sm_cell_store(v->p->var.at[write[i].var]->type, v->at[write[i].var], write[i].cell);
    result = smvm_step(v->vm, v->sv);
    answer(v, result == SM_OK ? ENGINE_OK : ENGINE_REFUSED, out);
    if (result == SM_OK && smvm_stored_state(v->vm))
        out->stored[v->p->s->index] = 1;
    return out->status;
}

static EngineStatus vm_init(Engine *e, uint32_t state, EngineStep *out)
{
    VmEngine *v = e->self;
    SmResult result;

    memset(v->sv, 0, v->m.sv_size);
    result = smvm_init(v->vm, v->size, &v->m, &v->vector, state);
    if (result != SM_OK) {
        e->error = sm_result_text(result);
        return out->status = ENGINE_BROKEN;
    }
    answer(v, ENGINE_OK, out);
    memset(out->stored, 0, v->p->var.n);
    return ENGINE_OK;
}

static void vm_close(Engine *e) { (void)e; }          // everything lives in the arena

// ---- opening ----

static void find_elements(VmEngine *v, Arena *arena)
{
    uint32_t *var_at = ARENA_ARRAY(arena, uint32_t, v->m.sv_size);       // by offset: 1 + the variable that begins there

    for (uint32_t k = 0; k < v->p->var.n; k++) {
        const Var *var = v->p->var.at[k];
        if (var->kind == VAR_ELEMENT) {
            v->at[k] = (uint8_t *)v->sv + var->element->offset;
            var_at[var->element->offset] = k + 1;
        }
    }
    for (uint32_t i = 0; i < v->m.outputs; i++) {
        uint32_t k = var_at[smvm_operand(&v->m, i).offset];
        if (k != 0)
            v->output[k - 1] = i + 1;
    }
}

static bool is_variable(const VmEngine *v, uint32_t k, SmvmName name, const SmvmOperand *o)
{
    const Var *var = v->p->var.at[k];

    return var->kind == VAR_LOCAL && o->kind == (uint8_t)(SMVM_K_LOCAL + (int)var->type) && var->name->len == name.size
        && o->offset + sm_type_info[var->type].bytes <= v->m.locals               // names are not verified
        && memcmp(var->name->text, v->m.image + name.at, name.size) == 0;
}

// The image has them in the program's order, some left out: so each search begins behind the last find.
static void find_locals(VmEngine *v)
{
    uint8_t *locals = smvm_locals(v->vm);
    uint32_t from = 0, n = (uint32_t)v->p->var.n;

    for (uint32_t i = 0; i < smvm_variables(&v->m); i++) {
        SmvmOperand o;
        SmvmName name = smvm_variable(&v->m, i, &o);
        for (uint32_t k = 0; o.kind >= SMVM_K_LOCAL && o.kind < SMVM_K_TEMP && k < n; k++)
            if (is_variable(v, (from + k) % n, name, &o)) {
                from = (from + k) % n;
                v->at[from] = locals + o.offset;
                break;
            }
    }
}

// NULL, or why the image cannot stand for the program.
static const char *check(const VmEngine *v, Arena *arena)
{
    for (uint32_t k = 0; k < v->p->var.n; k++) {
        const Var *var = v->p->var.at[k];
        if (var->kind == VAR_LOCAL && !var->is_constant && !v->at[k])
            return format_in(arena, "the image has no local named '%s'; was it built with --strip?", var->name->text);
    }
    return NULL;
}

static const char *bind(VmEngine *v, Arena *arena, const uint8_t *image, size_t size, uint32_t machine)
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
    v->sv = arena_alloc(arena, v->p->sv->size);
    v->vector.at = v->sv;
    v->vector.size = v->p->sv->size;
    v->vector.layout = v->p->sv->hash;
    result = smvm_init(v->vm, v->size, &v->m, &v->vector, 1);
    return result == SM_OK ? NULL : sm_result_text(result);
}

Engine *engine_vm_open(Arena *arena, const Program *p, const uint8_t *image, size_t size, uint32_t machine, const char **error)
{
    VmEngine *v = ARENA_NEW(arena, VmEngine);

    v->p = p;
    v->at = ARENA_ARRAY(arena, uint8_t *, p->var.n);
    v->output = ARENA_ARRAY(arena, uint32_t, p->var.n);
    *error = bind(v, arena, image, size, machine);
    if (*error)
        return NULL;
    find_elements(v, arena);
    find_locals(v);
    *error = check(v, arena);
    if (*error)
        return NULL;
    v->engine.name = "vm";
    v->engine.program = p;
    v->engine.self = v;
    v->engine.init = vm_init;
    v->engine.step = vm_step;
    v->engine.close = vm_close;
    return &v->engine;
}
