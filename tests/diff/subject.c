// SPDX-License-Identifier: Apache-2.0
// Compiles a program tree, by printing it and compiling the source.
#include "tests/diff/subject.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static jmp_buf out_of_memory;

static void *heap(void *context, void *old, size_t size)
{
    (void)context;
    if (size == 0) {
        free(old);
        return NULL;
    }
    void *p = realloc(old, size);
    if (p == NULL) {
        fputs("difftest: out of memory\n", stderr);
        exit(3);
    }
    return p;
}

void diff_arena_init(Arena *a) { arena_init(a, heap, NULL, &out_of_memory); }

// ---- compiling ----

static const Source *source_of(Session *s, const char *name, Buf *text)
{
    return source_new(&s->arena, name, buf_text(text), text->n);
}

static Map *written_outside(Session *s, const Gen *g)
{
    Map *m = ARENA_NEW(&s->arena, Map);
    m->arena = &s->arena;
    for (size_t i = 0; i < g->var.n; i++)
        if (g->var.at[i]->is_local && g->var.at[i]->outside)
            map_put(m, str_c(&s->strings, g->var.at[i]->name), (void *)(uintptr_t)1);
    return m;
}

static void locate_vars(Subject *s, const Gen *g)
{
    for (size_t i = 0; i < g->var.n; i++) {
        const Var *v = map_find(&s->program->by_name, str_c(&s->session.strings, g->var.at[i]->name));
        s->index[g->var.at[i]->id] = v != NULL ? v->index : 0;
    }
}

static const char *complaints(const Session *s, Arena *arena)
{
    Buf text;
    const DiagStyle style = { false, 3 };
    buf_init(&text, arena);
    diags_render_text(&s->diags, &style, &text);
    return buf_text(&text);
}

static const char *compile(Subject *s, const Gen *g, const MachineInput *in, Arena *arena)
{
    s->program = session_program(&s->session, in);
    if (s->program == NULL)
        return complaints(&s->session, arena);
    locate_vars(s, g);
    return NULL;
}

const char *subject_compile(Subject *s, Gen *g, Arena *arena)
{
    Buf sm, sv;
    MachineInput in = { 0 };
    session_init(&s->session, heap, NULL, &out_of_memory);
    buf_init(&sm, &s->session.arena);
    buf_init(&sv, &s->session.arena);
    gen_print_sm(g, &sm);
    in.sm = source_of(&s->session, format_in(&s->session.arena, "%s.sm", g->machine_name), &sm);
    if (g->with_sv) {
        gen_print_sv(g, &sv);
        in.sv = source_of(&s->session, "bus.sv", &sv);
    }
    in.written_outside = written_outside(&s->session, g);
    return compile(s, g, &in, arena);
}

const char *subject_compile_inits(Subject *s, Gen *g, Arena *arena)
{
    Buf sm;
    MachineInput in = { 0 };
    session_init(&s->session, heap, NULL, &out_of_memory);
    buf_init(&sm, &s->session.arena);
    gen_print_inits(g, &sm);
    in.sm = source_of(&s->session, "inits.sm", &sm);
    return compile(s, g, &in, arena);
}

const char *subject_compile_text(Subject *s, const char *text, Arena *arena)
{
    MachineInput in = { 0 };
    session_init(&s->session, heap, NULL, &out_of_memory);
    in.sm = source_new(&s->session.arena, "text.sm", text, strlen(text));
    s->program = session_program(&s->session, &in);
    return s->program == NULL ? complaints(&s->session, arena) : NULL;
}

uint32_t subject_writes(const Subject *s, const Gen *g, uint32_t k, EngineWrite *out)
{
    GInput in[GEN_VARS_MAX];
    const uint32_t n = gen_inputs(g, k, in);
    for (uint32_t i = 0; i < n; i++)
        out[i] = (EngineWrite){ s->index[in[i].var->id], in[i].cell };
    return n;
}

void subject_free(Subject *s) { session_free(&s->session); }
