// SPDX-License-Identifier: Apache-2.0
// The conversation is that of emit_c_driver (emit_c.h): commands in one file, expected answers in another.
#include "tests/diff/cbatch.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compiler/emit/c/emit_c.h"
#include "tests/diff/subject.h"

// The part of the conversation that one form of a program has.
typedef struct Part {
    Subject *subject;
    Form form;
    const Gen *g;
    const IrMachine *ir;
    RunResult *result;
    size_t first, answer;             // offset and size of its answers
    uint32_t step[2 * GEN_STEPS_MAX]; // by answer: which step, or which one an init stands before
} Part;

typedef struct Batch {
    Part *part;
    uint32_t n;
    Buf commands, answers;
    Arena *arena;
    const char *folder;
} Batch;

// Numbers go in the host's byte order.
static void put_u32(Buf *b, uint32_t v) { buf_put(b, &v, sizeof v); }
static void put_u64(Buf *b, uint64_t v) { buf_put(b, &v, sizeof v); }

// Every other one is emitted with the flags of stored elements.
static bool tracks_stores(const Batch *b, const Part *p) { return (p - b->part) % 2 != 0; }

static void put_answer(Batch *b, Part *p, const EngineStep *s, uint32_t k)
{
    p->step[(b->answers.n - p->first) / p->answer] = k;
    put_u32(&b->answers, s->status == ENGINE_REFUSED);
    put_u32(&b->answers, s->next_state);
    put_u32(&b->answers, s->next_is_first);
    for (size_t i = 0; i < p->subject->program->var.n; i++)
        put_u64(&b->answers, s->cell[i]);
    for (size_t i = 0; i < p->subject->program->var.n; i++)
        buf_char(&b->answers, !tracks_stores(b, p) ? 2 : s->stored[i] != 0 && p->subject->program->var.at[i]->kind == VAR_ELEMENT);
}

static void put_step_command(Batch *b, uint32_t machine, const EngineWrite *write, uint32_t n)
{
    put_u32(&b->commands, machine);
    put_u32(&b->commands, 1);
    put_u32(&b->commands, n);
    for (uint32_t i = 0; i < n; i++) {
        put_u32(&b->commands, write[i].var);
        put_u64(&b->commands, write[i].cell);
    }
}

static void put_init_command(Batch *b, uint32_t machine, uint32_t state)
{
    put_u32(&b->commands, machine);
    put_u32(&b->commands, 0);
    put_u32(&b->commands, state);
}

// Runs the reference and writes down what was said.
static void record(Batch *b, uint32_t machine)
{
    Part *p = &b->part[machine];
    Engine *e = engine_ref_open(&p->subject->session.arena, p->subject->program);
    EngineWrite write[GEN_VARS_MAX];
    EngineStep s;
    uint32_t state;
    engine_step_init(&s, &p->subject->session.arena, p->subject->program);
    p->first = b->answers.n;
    p->answer = 12 + 9 * p->subject->program->var.n;
    for (uint32_t k = 0; k < p->g->steps; k++) {
        if (gen_restarts(p->g, k, &state)) {
            put_init_command(b, machine, gen_state_number(p->g, state));
            e->init(e, gen_state_number(p->g, state), &s);
            put_answer(b, p, &s, k);
        }
        if (p->g->skip[k])
            continue;
        const uint32_t n = subject_writes(p->subject, p->g, k, write);
        put_step_command(b, machine, write, n);
        e->step(e, write, n, &s);
        put_answer(b, p, &s, k);
    }
}

// ---- comparing ----

static uint64_t number_at(const char *bytes, size_t size)
{
    uint32_t u32;
    uint64_t u64;
    memcpy(&u64, bytes, size == 8 ? 8 : 0);
    memcpy(&u32, bytes, size == 4 ? 4 : 0);
    return size == 8 ? u64 : size == 4 ? u32 : (uint8_t)*bytes;
}

// The field of an answer in which byte `at` lies.
static const char *field_at(const Part *p, size_t at, size_t *from, size_t *size, Arena *arena)
{
    static const char *const head[] = { "status", "next state", "whether the next step is a first one" };
    const Program *program = p->subject->program;
    if (at < 12) {
        *from = at / 4 * 4;
        *size = 4;
        return head[at / 4];
    }
    if (at < 12 + 8 * program->var.n) {
        *from = 12 + (at - 12) / 8 * 8;
        *size = 8;
        return program->var.at[(at - 12) / 8]->name->text;
    }
    *from = at;
    *size = 1;
    return format_in(arena, "whether %s was stored", program->var.at[at - 12 - 8 * program->var.n]->name->text);
}

static void blame(Batch *b, size_t at, const char *got, size_t got_n, const char *cc)
{
    uint32_t i = b->n - 1;
    size_t from = 0, size = 1;
    while (i > 0 && b->part[i].first > at)
        i--;
    Part *p = &b->part[i];
    const size_t answer = p->first + (at - p->first) / p->answer * p->answer;
    const char *what = field_at(p, at - answer, &from, &size, b->arena);
    p->result->verdict = VERDICT_DIFFERENT;
    p->result->step = p->step[(answer - p->first) / p->answer];
    if (answer + from + size > got_n)
        p->result->message = format_in(b->arena, "%s: c (%s): stopped answering", form_name[p->form], cc);
    else
        p->result->message = format_in(b->arena, "%s: %s: ref has 0x%llx, c (%s) has 0x%llx", form_name[p->form], what,
                                       (unsigned long long)number_at(b->answers.at + answer + from, size), cc,
                                       (unsigned long long)number_at(got + answer + from, size));
}

// What nobody sees in this form is as the reference has it.
static void take_unknown(const Batch *b, const Part *p, size_t end, char *got, size_t got_n)
{
    const size_t vars = p->subject->program->var.n;
    for (size_t answer = p->first; answer < end && answer + p->answer <= got_n; answer += p->answer)
        for (size_t v = 0; v < vars; v++)
            if (run_is_unknown(p->subject->program->var.at[v], p->form))
                memcpy(got + answer + 12 + 8 * v, b->answers.at + answer + 12 + 8 * v, 8);
}

// Every program of which an answer differs gets the first one said; comparing goes on behind its part.
static void compare(Batch *b, char *got, size_t got_n, const char *cc)
{
    for (uint32_t i = 0; i < b->n; i++) {
        const size_t end = i + 1 < b->n ? b->part[i + 1].first : b->answers.n;
        take_unknown(b, &b->part[i], end, got, got_n);
        for (size_t at = b->part[i].first; at < end; at++)
            if (at >= got_n || got[at] != b->answers.at[at]) {
                if (b->part[i].result->verdict == VERDICT_SAME)
                    blame(b, at, got, got_n, cc);
                break;
            }
    }
}

// ---- files and processes ----

static char *path_in(const Batch *b, const char *name, char *out, size_t size)
{
    snprintf(out, size, "%s/%s", b->folder, name);
    return out;
}

static void write_file(const Batch *b, const char *name, const Buf *text)
{
    char path[500];
    FILE *f = fopen(path_in(b, name, path, sizeof path), "wb");
    if (f == NULL || fwrite(buf_text(text), 1, text->n, f) != text->n || fclose(f) != 0) {
        perror(path);
        exit(3);
    }
}

static char *read_file(const Batch *b, const char *name, size_t most, size_t *n)
{
    char path[500], *text = arena_alloc(b->arena, most + 1);
    FILE *f = fopen(path_in(b, name, path, sizeof path), "rb");
    *n = 0;
    if (f != NULL) {
        *n = fread(text, 1, most, f);
        fclose(f);
    }
    return text;
}

static void fail_all(Batch *b, const char *why, const char *cc)
{
    for (uint32_t i = 0; i < b->n; i++) {
        b->part[i].result->verdict = VERDICT_REJECTED;
        b->part[i].result->message = format_in(b->arena, "%s: %s", cc, why);
    }
}

static void run_with(Batch *b, const char *cc)
{
    size_t n;
    char command[2000];
    snprintf(command, sizeof command, "cd '%s' && %s -o batch batch.c >batch.log 2>&1", b->folder, cc);
    if (system(command) != 0) {
        fail_all(b, "does not compile the emitted C; see batch.log", cc);
        return;
    }
    snprintf(command, sizeof command, "cd '%s' && ./batch <commands >answers 2>>batch.log", b->folder);
    const bool crashed = system(command) != 0;
    char *got = read_file(b, "answers", b->answers.n, &n);
    compare(b, got, n, cc);
    if (crashed && n == b->answers.n)
        fail_all(b, "the emitted C ended badly", cc);
}

// ---- a batch ----

static void add_form(Batch *b, Gen *g, Subject *subject, Form form, RunResult *r)
{
    Part *p = &b->part[b->n];
    p->subject = subject;
    p->form = form;
    p->g = g;
    p->result = r;
    p->ir = run_machine(subject, subject->program, form);
    record(b, b->n++);
}

static void add(Batch *b, Gen *g, Subject *subject, unsigned forms, RunResult *r)
{
    r->message = subject_compile(subject, g, b->arena);
    r->verdict = r->message == NULL ? VERDICT_SAME : VERDICT_REJECTED;
    for (Form f = FORM_O0; f < FORM_COUNT && r->message == NULL; f++)
        if (forms >> f & 1)
            add_form(b, g, subject, f, r);
}

static void emit(Batch *b)
{
    const IrMachine *m[C_BATCH_MAX * FORM_COUNT];
    bool track[C_BATCH_MAX * FORM_COUNT];
    Buf code;
    for (uint32_t i = 0; i < b->n; i++) {
        m[i] = b->part[i].ir;
        track[i] = tracks_stores(b, &b->part[i]);
    }
    buf_init(&code, b->arena);
    emit_c_driver(b->arena, m, track, b->n, &code);
    write_file(b, "batch.c", &code);
    write_file(b, "commands", &b->commands);
}

void run_c_batch(Gen *const *g, const unsigned *forms, uint32_t n, const char *const *cc, uint32_t ccs, const char *folder,
                 Arena *arena, RunResult *r)
{
    Batch b = { .arena = arena, .folder = folder };
    Subject *subject = ARENA_ARRAY(arena, Subject, n);
    b.part = ARENA_ARRAY(arena, Part, n * FORM_COUNT);
    buf_init(&b.commands, arena);
    buf_init(&b.answers, arena);
    for (uint32_t i = 0; i < n; i++)
        add(&b, g[i], &subject[i], forms[i], &r[i]);
    if (b.n > 0)
        emit(&b);
    for (uint32_t i = 0; i < ccs && b.n > 0; i++)
        run_with(&b, cc[i]);
    for (uint32_t i = 0; i < n; i++)
        subject_free(&subject[i]);
}
