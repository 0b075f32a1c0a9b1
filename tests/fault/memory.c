// SPDX-License-Identifier: Apache-2.0
// Refuses each allocation of the library in turn.  Compiling, checking, all outputs and running a script must then return by longjmp to the call
// of the session, free every block, and not access a block that was refused.
//
//     memory FILE.smt…      each case has a machine; without scripts it is only compiled
//
// It is built with arenas whose chunks contain one allocation each, so that "the N-th request fails" reaches every call of arena_alloc in turn.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compiler/case.h"
#include "tests/heap.h"
#include "tests/test.h"

// ---- a host that refuses the N-th request ----

typedef struct Host {
    size_t requests, refuse;          // number of requests; the request that is refused, counted from 1, 0: none
    size_t live;                      // blocks that are allocated and not yet freed
} Host;

static void *take(void *context, void *old, size_t size)
{
    Host *h = context;
    void *p;

    if (size == 0) {
        h->live -= old != NULL;
        free(old);
        return NULL;
    }
    if (++h->requests == h->refuse || (p = realloc(old, size)) == NULL)
        return NULL;
    h->live += old == NULL;
    return p;
}

// ---- everything the library does with a machine ----

static void make_outputs(Session *s, IrMachine *m, Buf *out)
{
    EmitCOptions c;
    Buf header;
    const char *error;

    memset(&c, 0, sizeof c);
    c.header = "m.h";
    c.source = "m.sm";
    buf_init(&header, &s->arena);
    session_emit_c(s, m, &c, &header, out);
    buf_put(out, buf_text(&header), header.n);
    header.n = 0;
    ir_print(m, &header);
    ir_read(&s->arena, &s->strings, buf_text(&header), header.n, &error);
    buf_put(out, buf_text(&header), header.n);
}

typedef struct Traced { const Program *p; const Var **order; Buf *out; } Traced;

static void trace(void *context, const ScriptStep *step)
{
    Traced *t = context;

    script_trace_row(t->out, "a script", step, t->order, t->p->var.n, NULL);
    script_trace_exact(t->out, step, t->order, t->p->var.n);
}

static void run_script(Session *s, const Program *p, const Script *script, const Buf *image, Buf *out)
{
    Traced traced = {p, report_order(&s->arena, p), out};
    const char *error = NULL;
    Engine *engine[2] = {engine_ref_open(&s->arena, p), NULL};
    ScriptOptions o;
    ScriptResult r;

    engine[1] = engine_vm_open(&s->arena, p, (const uint8_t *)image->at, image->n, 0, &error);
    memset(&o, 0, sizeof o);
    o.max_steps = 30;
    o.after_step = trace;
    o.context = &traced;
    script_trace_header(out, p, traced.order, p->var.n, NULL);
    r = script_run(&s->arena, &s->diags, script, engine, engine[1] ? 2 : 1, &o);
    script_report(&r, p, out);
}

static void do_everything(Session *s, const TestFile *f, Buf *out)
{
    const CompileOptions o = {.opt_level = 2};
    const ImageOptions image = {true, NULL};
    CaseSources sources;
    Compiled made;
    const Program *p = NULL;
    IrMachine *m;
    Buf bytes;

    case_list_sources(s, f, &sources);
    compile_sources(s, &sources.in, &o, &made);
    for (size_t i = 0; i < sources.in.n; i++)
        p = made.of[i].scripted ? made.of[i].scripted : p;
    if (!p)
        return;
    m = session_ir(s, p, 0);
    make_outputs(s, m, out);
    m = session_ir(s, p, 2);
    make_outputs(s, m, out);
    buf_init(&bytes, &s->arena);
    if (!session_image(s, &m, 1, &image, &bytes))
        return;
    buf_put(out, buf_text(&bytes), bytes.n);
    for (size_t i = 0; i < sources.in.n; i++)
        if (made.of[i].script)
            run_script(s, p, made.of[i].script, &bytes, out);
}

static void report(Session *s, Buf *out)
{
    DiagStyle style = {true, 20};

    diags_sort(&s->diags);
    diags_render_text(&s->diags, &style, out);
    diags_render_json(&s->diags, out);
}

static uint64_t digest(const Buf *b)
{
    uint64_t h = 1469598103934665603u;

    for (size_t i = 0; i < b->n; i++)
        h = (h ^ (unsigned char)b->at[i]) * 1099511628211u;
    return h;
}

// Runs a case.  Returns whether it ended normally; then *result depends on its output.
static bool attempt(Host *h, const TestFile *f, uint64_t *result)
{
    volatile bool done = false;
    jmp_buf oom;
    Session s;
    Buf out;

    session_init(&s, take, h, &oom);
    if (setjmp(oom) == 0) {
        buf_init(&out, &s.arena);
        do_everything(&s, f, &out);
        report(&s, &out);
        *result = digest(&out);
        done = true;
    }
    session_free(&s);
    return done;
}

// ---- every request in turn ----

enum { MOST_TRIES = 2000 };           // of a case with more requests, this many are refused, evenly distributed

static bool refuse_each(const TestFile *f)
{
    Host plenty = {0, 0, 0};
    uint64_t expected = 0, result;

    if (!attempt(&plenty, f, &expected) || plenty.live != 0)
        return fprintf(stderr, "%s: it does not even work with plenty of memory\n", f->name), false;
    for (size_t n = 1; n <= plenty.requests + 1; n += 1 + plenty.requests / MOST_TRIES) {
        Host h = {0, n, 0};
        bool done = attempt(&h, f, &result);
        if (h.live != 0)
            return fprintf(stderr, "%s: request %lu: %lu pieces are not given back\n", f->name, (unsigned long)n, (unsigned long)h.live), false;
        if (done != (n > plenty.requests) || (done && result != expected))
            return fprintf(stderr, "%s: request %lu: refused, and it went on\n", f->name, (unsigned long)n), false;
    }
    return true;
}

static char *read_all(const char *path, size_t *n)
{
    FILE *f = fopen(path, "rb");
    char *text = NULL;

    if (!f || fseek(f, 0, SEEK_END) != 0 || !(text = malloc((size_t)ftell(f) + 1))) {
        fprintf(stderr, "cannot read %s\n", path);
        exit(3);
    }
    *n = (size_t)ftell(f);
    rewind(f);
    *n = fread(text, 1, *n, f);
    fclose(f);
    return text;
}

static int machines;                   // number of machines tried

static bool check_file(const char *file)
{
    size_t n;
    char *text = read_all(file, &n);
    volatile bool ok = false;
    jmp_buf oom;
    Arena a;
    TestFile *t;

    arena_init(&a, heap_alloc, NULL, &oom);
    if (setjmp(oom) == 0) {
        t = testfile_parse(&a, file, text, n);
        ok = !t->error && (!case_has_part_of_kind(t, ".sm") || refuse_each(t));
        machines += case_has_part_of_kind(t, ".sm");
    }
    arena_free(&a);
    free(text);
    return ok;
}

int main(int argc, char **argv)
{
    for (int i = 1; i < argc; i++)
        test_count(check_file(argv[i]), argv[i]);
    test_count(machines * 2 > argc - 1, "half of the files have a machine");
    return test_end("memory");
}
