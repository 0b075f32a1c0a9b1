// SPDX-License-Identifier: Apache-2.0
#include "compiler/cover/flat_app.h"

#include <string.h>

// The state of a run continues after that of the view's machine with this, and then with the states of the other machines, in their order.
typedef struct AppState { uint64_t ticks; } AppState;

static AppState *app_state(const FlatMachine *f, void *run) { return (AppState *)(void *)((char *)run + f->own); }

// ---- running ----

void flat_app_start(const FlatMachine *f, void *run)
{
    const FlatApp *a = f->app;
    uint64_t *cell = flat_cells(f, run);
    char *at = (char *)(app_state(f, run) + 1);

    for (uint32_t i = 0; i < a->start.n; i++)
        cell[a->start.at[i].var] = a->start.at[i].cell;
    for (uint32_t i = 0; i < a->members; i++) {
        const FlatMember *m = &a->member[i];
        cell[m->s] = m->state;
        if (m->f) {
            flat_start(m->f, at, m->state);
            at += m->f->size;
        }
    }
}

// Steps another machine than that of the view: it reads the elements of the view, and stores there what it has stored.
static bool step_other(const FlatMember *m, void *run, uint64_t *cell)
{
    uint64_t *own = flat_cells(m->f, run);
    const size_t n = m->f->m->var.n;

    for (size_t v = 0; v < n; v++)
        if (m->cell[v] != IR_NONE)
            own[v] = cell[m->cell[v]];
    flat_step(m->f, run);
    for (size_t v = 0; v < n; v++)
        if (m->cell[v] != IR_NONE && m->f->stored[v])
            cell[m->cell[v]] = own[v];
    return m->f->taken != 0;
}

void flat_app_step(FlatMachine *f, void *run)
{
    const FlatApp *a = f->app;
    AppState *s = app_state(f, run);
    uint64_t *cell = flat_cells(f, run);
    char *at = (char *)(s + 1);

    memset(f->stored, 0, f->m->var.n);
    f->taken = 0;
    f->moved = f->ran = false;
    for (uint32_t i = 0; i < a->members; i++) {
        const FlatMember *m = &a->member[i];
        void *const own = m->f ? at : run;
        at += m->f ? m->f->size : 0;
        if (s->ticks % m->every != 0 || (m->mode != IR_NONE && cell[m->mode] != MODE_ENABLED))
            continue;
        if (m->f) {
            f->moved |= step_other(m, own, cell);
        } else {
            f->ran = flat_step_alone(f, run);
            f->moved |= f->taken != 0;
        }
    }
    s->ticks++;
}

void *flat_app_state(const FlatMachine *f, void *run, uint32_t machine)
{
    char *at = (char *)(app_state(f, run) + 1);

    for (uint32_t i = 0; i < machine; i++)
        at += f->app->member[i].f ? f->app->member[i].f->size : 0;
    return at;
}

uint64_t flat_app_hash(const FlatMachine *f, const void *run, uint64_t hash)
{
    const char *at = (const char *)run + f->own + sizeof(AppState);

    for (uint32_t i = 0; i < f->app->members; i++)
        if (f->app->member[i].f) {
            hash = (hash ^ ((const FlatState *)(const void *)at)->state) * UINT64_C(0x9e3779b97f4a7c15);
            hash ^= hash >> 29;
            at += f->app->member[i].f->size;
        }
    return hash;
}

FlatMachine *flat_app_join(FlatMachine *f, const FlatApp *app)
{
    f->app = app;
    f->own = f->size;
    f->size += app->size;
    return f;
}

// ---- the view ----

// The construction of a view.
typedef struct ViewMaker {
    Arena *arena;
    const Program *joint;
    const Member *own;
    const IrMachine *const *ir;       // by machine
    Program *p;
    IrMachine *m;
    uint32_t *var_of;         // IrMachine.var_of of the view
    uint32_t *to_joint, *from_joint;
} ViewMaker;

// Whether a machine other than the view's writes the element.  A machine's S is written, too.
static bool others_write(const ViewMaker *k, const Var *v)
{
    for (size_t i = 0; i < k->joint->joint->member.n; i++) {
        const Member *m = &k->joint->joint->member.at[i];
        for (size_t n = 0; m != k->own && n < m->program->var.n; n++)
            if (m->var[n] == v && (m->program->var.at[n]->written || m->s == v))
                return true;
    }
    return false;
}

// Adds the variable of the joined Program to the view, or the view's copy of the machine's own variable.
static void add_variable(ViewMaker *k, Var *v, uint32_t joint)
{
    k->to_joint[k->p->var.n] = joint;
    k->from_joint[joint] = (uint32_t)k->p->var.n;
    vec_push(k->arena, &k->p->var, v);
}

static void add_own_variables(ViewMaker *k)
{
    const Program *p = k->own->program;

    for (size_t i = 0; i < p->var.n; i++) {
        Var *v = p->var.at[i];
        const Var *of = k->own->var[i];
        if (v->kind == VAR_ELEMENT && v != p->g && v != p->s && !v->written && others_write(k, of)) {
            v = arena_copy(k->arena, v, sizeof *v);
            v->written = true;
        }
        add_variable(k, v, of->index);
        k->var_of[i] = k->m->var_of[i];
    }
}

// Adds the elements that the machine does not list, to the Program and to the IR.
static void add_elements(ViewMaker *k)
{
    for (uint32_t i = 0; i < k->joint->var.n; i++) {
        const Var *of = k->joint->var.at[i];
        IrVar ir = {.space = IR_ELEMENT, .name = of->name, .type = of->type, .span = of->span};
        Var *v;
        if (of->kind != VAR_ELEMENT || k->from_joint[i] != UINT32_MAX)
            continue;
        ir.element = of->element->name;
        ir.offset = of->element->offset;
        v = arena_copy(k->arena, of, sizeof *of);
        v->index = (uint32_t)k->p->var.n;
        v->written = !v->state_of && others_write(k, of);
        k->var_of[v->index] = (uint32_t)k->m->var.n;
        add_variable(k, v, i);
        vec_push(k->arena, &k->m->var, ir);
    }
}

// Returns the view's IR variable of an element of the joined Program.
static uint32_t ir_var_of(const ViewMaker *k, const Var *joint) { return k->var_of[k->from_joint[joint->index]]; }

// Lists for each IR variable of a machine the view's variable with the same element.
static const uint32_t *map_elements(const ViewMaker *k, const Member *m, const IrMachine *ir)
{
    uint32_t *cell = ARENA_ARRAY(k->arena, uint32_t, ir->var.n + 1);

    memset(cell, 0xff, (ir->var.n + 1) * sizeof *cell);
    for (size_t v = 0; v < m->program->var.n; v++)
        if (m->program->var.at[v]->kind == VAR_ELEMENT)
            cell[ir->var_of[v]] = ir_var_of(k, m->var[v]);
    return cell;
}

static FlatApp *make_app(const ViewMaker *k)
{
    const Joint *j = k->joint->joint;
    FlatApp *a = ARENA_NEW(k->arena, FlatApp);

    a->members = (uint32_t)j->member.n;
    a->member = ARENA_ARRAY(k->arena, FlatMember, a->members);
    a->size = sizeof(AppState);
    for (uint32_t i = 0; i < a->members; i++) {
        const Member *from = &j->member.at[i];
        FlatMember *m = &a->member[i];
        *m = (FlatMember){.every = from->every, .mode = from->mode ? ir_var_of(k, from->mode) : IR_NONE, .s = ir_var_of(k, from->s),
                          .state = from->initial->number};
        if (from == k->own)
            continue;
        m->f = flat_new(k->arena, k->ir[i], NULL);
        m->cell = map_elements(k, from, m->f->m);
        a->size += m->f->size;
    }
    for (size_t i = 0; i < j->start.n; i++)
        vec_push(k->arena, &a->start, ((FlatStart){ir_var_of(k, j->start.at[i].var), j->start.at[i].cell}));
    return a;
}

const FlatView *flat_view_new(Arena *arena, const Program *joint, size_t machine, const IrMachine *const *ir)
{
    const IrMachine *m = ir[machine];
    const Member *own = &joint->joint->member.at[machine];
    const size_t most = own->program->var.n + joint->var.n;
    ViewMaker k = {.arena = arena, .joint = joint, .own = own, .ir = ir};
    FlatView *v = ARENA_NEW(arena, FlatView);

    k.p = arena_copy(arena, own->program, sizeof *own->program);
    k.p->var.at = NULL;
    k.p->var.n = k.p->var.cap = 0;
    k.p->step = joint->step;
    k.m = arena_copy(arena, m, sizeof *m);
    k.m->var.at = arena_copy(arena, m->var.at, m->var.n * sizeof *m->var.at);
    k.m->var.cap = (uint32_t)m->var.n;
    k.var_of = ARENA_ARRAY(arena, uint32_t, most);
    k.to_joint = ARENA_ARRAY(arena, uint32_t, most);
    k.from_joint = ARENA_ARRAY(arena, uint32_t, joint->var.n + 1);
    memset(k.from_joint, 0xff, (joint->var.n + 1) * sizeof *k.from_joint);
    add_own_variables(&k);
    add_elements(&k);
    k.m->var_of = k.var_of;
    *v = (FlatView){k.p, k.m, k.to_joint, k.from_joint, make_app(&k)};
    return v;
}
