// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/engines.h"

#include <stdio.h>
#include <stdlib.h>

#include "stdlib/convert.h"
#include "tests/heap.h"

static void give_up(const char *what, const char *why)
{
    fprintf(stderr, "bench: %s: %s\n", what, why);
    exit(2);
}

// ---- compiling ----

static const Source *read_source(Session *s, const char *path)
{
    FILE *f = fopen(path, "rb");
    Buf text;
    int c;

    if (!f)
        give_up(path, "cannot be read; run the bench where the Makefile is");
    buf_init(&text, &s->arena);
    while ((c = getc(f)) != EOF)
        buf_char(&text, (char)c);
    fclose(f);
    return source_new(&s->arena, path, buf_text(&text), text.n);
}

static void make_image(CompiledWorkload *c, int level)
{
    ImageOptions options = {false, NULL};
    IrMachine *m = session_ir(&c->session, c->program, level);

    buf_init(&c->image[level], &c->session.arena);
    if (!session_image(&c->session, &m, 1, &options, &c->image[level]))
        give_up("image", "cannot be made");
}

void compile_workload(CompiledWorkload *c, const Workload *w)
{
    static jmp_buf oom;
    MachineInput in = {0};

    if (setjmp(oom) != 0)
        give_up(w->name, "out of memory");
    session_init(&c->session, heap_alloc, NULL, &oom);
    in.sm = read_source(&c->session, w->sm ? w->sm : format_in(&c->session.arena, "tests/bench/workloads/%s.sm", w->name));
    in.sv = read_source(&c->session, format_in(&c->session.arena, "tests/bench/workloads/%s.sv", w->name));
    c->program = session_program(&c->session, &in);
    if (!c->program)
        give_up(w->name, "does not compile");
    if (c->program->sv->size != w->sv_size)
        give_up(w->name, "the state vector has another size than in C");
    for (int level = 0; level < LEVELS; level++)
        make_image(c, level);
}

// ---- the VM ----

void vm_row_open(VmRow *v, CompiledWorkload *c, const Buf *image)
{
    SmvmVerdict why;

    if (smvm_verify((const uint8_t *)image->at, (uint32_t)image->n, &why) != 0)
        give_up("image", smvm_rule_text(why.rule));
    smvm_machine((const uint8_t *)image->at, 0, &v->m);
    v->size = smvm_ram_size(&v->m);
    v->vm = arena_alloc(&c->session.arena, v->size);
}

void vm_row_decode(VmRow *v, CompiledWorkload *c, void *sv)
{
    v->decoded_size = smvm_decoded_size(&v->m);
    vm_row_init(v, sv);
    if (smvm_decode(&v->decoded, arena_alloc(&c->session.arena, v->decoded_size), v->decoded_size, &v->m, v->vm, sv) != SM_OK)
        give_up("VM", "does not decode");
}

void vm_row_init(void *vm_row, void *sv)
{
    VmRow *v = vm_row;
    const SmvmVector vector = {sv, v->m.sv_size, v->m.layout};

    if (smvm_init(v->vm, v->size, &v->m, &vector, 1) != SM_OK)
        give_up("VM", "does not start");
}

// ---- the reference ----

void reference_open(Reference *r, CompiledWorkload *c, size_t in_size)
{
    const Program *p = c->program;

    r->engine = engine_ref_open(&c->session.arena, p);
    engine_step_init(&r->answer, &c->session.arena, p);
    r->write = ARENA_ARRAY(&c->session.arena, EngineWrite, p->var.n);
    r->inputs = 0;
    for (uint32_t i = 0; i < p->var.n; i++)
        if (p->var.at[i]->kind == VAR_ELEMENT && p->var.at[i]->element->offset < in_size)
            r->write[r->inputs++].var = i;
}

static void give_back(const Reference *r, uint8_t *sv)
{
    const Program *p = r->engine->program;

    for (size_t i = 0; i < p->var.n; i++)
        if (p->var.at[i]->kind == VAR_ELEMENT)
            sm_cell_store(p->var.at[i]->type, sv + p->var.at[i]->element->offset, r->answer.cell[i]);
}

void reference_init(void *reference, void *sv)
{
    Reference *r = reference;

    r->engine->init(r->engine, 1, &r->answer);
    give_back(r, sv);
}

void bench_reference_step(void *reference, void *sv)
{
    Reference *r = reference;

    for (uint32_t i = 0; i < r->inputs; i++) {
        const Var *v = r->engine->program->var.at[r->write[i].var];
        r->write[i].cell = sm_cell_load(v->type, (const uint8_t *)sv + v->element->offset);
    }
    r->engine->step(r->engine, r->write, r->inputs, &r->answer);
    give_back(r, sv);
}
