// SPDX-License-Identifier: Apache-2.0
// The inputs that can be faulty, the faults of each, and which states, asserts and requirements read them.
#include "compiler/whatif/fault_part.h"

// Whether the script writes v to the machine.
static bool script_writes(const Script *s, const Var *v)
{
    for (size_t i = 0; s->data && i < s->data->column.n; i++)
        if (s->data->column.at[i].var == v)
            return true;
    for (size_t i = 0; i < s->section.n; i++)
        for (size_t j = 0; j < s->section.at[i].item.n; j++) {
            const ScriptItem *item = s->section.at[i].item.at[j];
            for (size_t k = 0; k < item->inputs.n; k++)
                if (item->inputs.at[k].var == v)
                    return true;
        }
    return false;
}

bool fault_is_written(const Program *p, const Var *v) { return program_uses_of(p, v).written; }

bool fault_is_input(const Var *v, const Script *const *script, uint32_t scripts)
{
    const Program *p = scripts ? script[0]->program : NULL;
    JointUses u;

    if (!p || v->kind != VAR_ELEMENT || v == p->g || v->state_of)
        return false;
    u = program_uses_of(p, v);
    if (!u.read || (p->joint && u.written))
        return false;
    for (uint32_t i = 0; i < scripts; i++)
        if (script_writes(script[i], v))
            return true;
    return u.read_only;
}

static void add_input(FaultRunner *x, const Var *v)
{
    FaultInput in = {.var = v};

    if (v->range) {
        in.lo = v->range->lo;
        in.hi = v->range->hi;
        in.has_range = in.lo < in.hi;
    }
    vec_push(x->arena, &x->f->input, in);
}

// Lists the inputs to which faults apply: those given with --input, or else all that the scripts or other code write and the machine reads.
static void list_inputs(FaultRunner *x)
{
    const Faults *f = x->f;

    for (uint32_t i = 0; i < f->options.inputs; i++)
        add_input(x, f->options.input[i]);
    for (size_t i = 0; f->options.inputs == 0 && i < f->p->var.n; i++)
        if (fault_is_input(f->p->var.at[i], f->script, f->scripts))
            add_input(x, f->p->var.at[i]);
}

static bool is_faulty_input(const Faults *f, const Var *v)
{
    for (uint32_t i = 0; i < f->input.n; i++)
        if (f->input.at[i].var == v)
            return true;
    return false;
}

// Lists the elements that the machine writes: a change of one of them shows the effect of a fault.
static void list_outputs(FaultRunner *x)
{
    const Program *p = x->f->p;

    x->output = ARENA_ARRAY(x->arena, const Var *, p->var.n + x->machines);
    for (size_t i = 0; i < p->var.n; i++) {
        const Var *v = p->var.at[i];
        if (v->kind == VAR_ELEMENT && fault_is_written(p, v) && !v->state_of && v != p->g && !is_faulty_input(x->f, v))
            x->output[x->outputs++] = v;
    }
    for (size_t i = 0; i < x->machines; i++)
        x->output[x->outputs++] = p->joint ? p->joint->member.at[i].s : p->s;
}

bool fault_applies(const FaultInput *in, FaultKind kind)
{
    const bool is_bool = in->var->type == SM_BOOL, is_float = in->var->type == SM_F32 || in->var->type == SM_F64;

    switch (kind) {
    case FAULT_STUCK: case FAULT_DEAD: case FAULT_LATE: case FAULT_DROPPED: return true;
    case FAULT_NAN: return is_float;
    case FAULT_HIGH: return is_bool || in->has_range;
    case FAULT_LOW: case FAULT_BELOW: case FAULT_ABOVE: case FAULT_NOISY: return !is_bool && in->has_range;
    case FAULT_FLIPPED: return is_bool;
    case FAULT_KIND_COUNT: break;
    }
    return false;
}

void fault_list_single(FaultRunner *x)
{
    const Faults *f = x->f;
    const size_t states = f->p->state.n;

    for (uint32_t i = 0; i < f->input.n; i++)
        for (int k = 0; k < FAULT_KIND_COUNT; k++) {
            const Fault fault = {i, (FaultKind)k};
            if (f->options.kinds >> k & 1 && fault_applies(&f->input.at[i], fault.kind))
                vec_push(x->arena, &x->single, fault);
        }
    x->alone = arena_alloc(x->arena, x->single.n + 1);
    x->is_repeated = arena_alloc(x->arena, x->single.n + 1);
    x->visited = arena_alloc(x->arena, x->single.n * states + 1);
}

// The destination of marks on the inputs that an expression reads; `at` is by index in Faults.input.  The code of an application's machine reads
// variables of its own, which have the elements of the inputs.
typedef struct Marks { const Faults *f; uint8_t *at; } Marks;

static void mark_inputs(Expr *e, void *context)
{
    Marks *m = context;

    for (uint32_t i = 0; e->kind == EX_VAR && i < m->f->input.n; i++)
        m->at[i] |= m->f->input.at[i].var == e->var || (e->var->element && m->f->input.at[i].var->element == e->var->element);
}

// Marks the inputs that a list of statements reads, in branches too.
static void mark_statements(const Stmts *list, Marks *m)
{
    for (uint32_t i = 0; i < list->n; i++) {
        if (list->at[i]->value)
            expr_walk(list->at[i]->value, mark_inputs, m);
        mark_statements(&list->at[i]->then, m);
        mark_statements(&list->at[i]->otherwise, m);
    }
}

// Finds which inputs each state reads, windows included, whatever the guards.
static void find_reads_of_states(FaultRunner *x)
{
    const Program *p = x->f->p;

    x->reads = arena_alloc(x->arena, p->state.n * x->f->input.n + 1);
    for (uint32_t s = 0; s < p->state.n; s++) {
        Marks m = {x->f, x->reads + (size_t)s * x->f->input.n};
        for (int b = 0; b < BLOCK_COUNT; b++)
            mark_statements(&p->state.at[s]->block[b], &m);
    }
}

// Marks the inputs that asserts read.
static void mark_inputs_of_asserts(FaultRunner *x, Marks *m)
{
    for (uint32_t i = 0; i < x->f->scripts; i++) {
        const Script *s = x->f->script[i];
        for (uint32_t k = 0; k < s->section.n; k++)
            for (uint32_t j = 0; j < s->section.at[k].item.n; j++)
                for (uint32_t a = 0; a < s->section.at[k].item.at[j]->asserts.n; a++)
                    if (s->section.at[k].item.at[j]->asserts.at[a].condition)
                        expr_walk(s->section.at[k].item.at[j]->asserts.at[a].condition, mark_inputs, m);
        for (uint32_t k = 0; s->data && k < s->data->compare.n; k++)
            for (uint32_t n = 0; n < x->f->input.n; n++)
                m->at[n] |= x->f->input.at[n].var == s->data->compare.at[k].column.var;
    }
}

// Marks the inputs that requirements read (is_required), and those that requirements, asserts or @compare read (is_judged).
static void find_judged_inputs(FaultRunner *x)
{
    const Requirements *rq = x->f->options.requirements;

    Marks required = {x->f, arena_alloc(x->arena, x->f->input.n + 1)}, judged = {x->f, arena_alloc(x->arena, x->f->input.n + 1)};

    x->is_required = required.at;
    x->is_judged = judged.at;
    mark_inputs_of_asserts(x, &judged);
    for (uint32_t i = 0; rq && i < rq->at.n; i++) {
        Expr *const condition[] = {rq->at.at[i].a, rq->at.at[i].b, rq->at.at[i].c};
        for (int k = 0; k < 3; k++)
            if (condition[k]) {
                expr_walk(condition[k], mark_inputs, &required);
                expr_walk(condition[k], mark_inputs, &judged);
            }
    }
}

void fault_find_inputs(FaultRunner *x)
{
    list_inputs(x);
    list_outputs(x);
    find_judged_inputs(x);
    find_reads_of_states(x);
}

bool fault_is_read(const FaultRunner *x, uint32_t input, const uint8_t *visited)
{
    bool is_read = x->is_judged[input];

    for (uint32_t s = 0; s < x->f->p->state.n && !is_read; s++)
        is_read = visited[s] && x->reads[(size_t)s * x->f->input.n + input];
    return is_read;
}
