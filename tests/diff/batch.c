// SPDX-License-Identifier: Apache-2.0
#include "tests/diff/batch.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "compiler/emit/c/emit_c.h"
#include "compiler/passes/pass.h"
#include "tests/diff/subject.h"

enum { PATH = 500 };

bool batch_via(const char *arg, Via *out)
{
    static const struct { const char *option; bool images, soft; } known[] = {
        { "--vm=", true, false }, { "--cc=", false, false }, { "--cc-soft=", false, true },
    };
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (strncmp(arg, known[i].option, strlen(known[i].option)) == 0)
            return *out = (Via){ arg + strlen(known[i].option), known[i].images, known[i].soft }, true;
    return false;
}

// ---- files and processes ----

static void write_file(const char *folder, const char *name, const Buf *text)
{
    char path[PATH];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *f = fopen(path, "wb");
    if (f == NULL || fwrite(buf_text(text), 1, text->n, f) != text->n || fclose(f) != 0) {
        perror(path);
        exit(3);
    }
}

static char *read_file(Arena *arena, const char *folder, const char *name, size_t most, size_t *n)
{
    char path[PATH], *text = arena_alloc(arena, most + 1);
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *f = fopen(path, "rb");
    *n = 0;
    if (f != NULL) {
        *n = fread(text, 1, most, f);
        fclose(f);
    }
    return text;
}

static void fail_all(Talk *t, Verdict verdict, const char *why, const char *who)
{
    for (uint32_t i = 0; i < t->n; i++) {
        t->part[i].result->verdict = verdict;
        t->part[i].result->message = format_in(t->arena, "(%s): %s", who, why);
    }
}

static bool compile(Talk *t, const char *folder, const char *cc)
{
    char command[2000];
    snprintf(command, sizeof command, "%s -o '%s/batch' '%s/batch.c' >'%s/batch.log' 2>&1", cc, folder, folder, folder);
    const int status = system(command);
    if (status == 0)
        return true;
    fail_all(t, WIFEXITED(status) && WEXITSTATUS(status) == BATCH_TOO_LARGE ? VERDICT_TOO_LARGE : VERDICT_REJECTED, "does not compile the emitted C; see batch.log", cc);
    return false;
}

static void talk_via(Talk *t, const Via *via, const char *folder)
{
    char command[2000];
    size_t n;
    if (!via->images && !compile(t, folder, via->command))
        return;
    snprintf(command, sizeof command, "%s%s%s%s <'%s/commands' >'%s/answers' 2>>'%s/batch.log'", via->images ? via->command : "'",
             via->images ? "" : *folder == '/' ? "" : "./", via->images ? "" : folder, via->images ? "" : "/batch'", folder, folder, folder);
    const bool crashed = system(command) != 0;
    char *got = read_file(t->arena, folder, "answers", t->answers.n, &n);
    talk_compare(t, got, n, via->command);
    if (crashed && n == t->answers.n)
        fail_all(t, VERDICT_REJECTED, "ended badly", via->command);
}

static void emit(Talk *t, bool soft, const char *folder)
{
    const IrMachine *m[BATCH_MAX * FORM_COUNT];
    bool track[BATCH_MAX * FORM_COUNT];
    const PassOptions o = {.verify = true, .soft = soft};
    Buf code;
    for (uint32_t i = 0; i < t->n; i++) {
        const char *wrong;
        m[i] = passes_for_c(t->arena, t->part[i].ir, &o, &wrong);
        if (!m[i]) {
            fprintf(stderr, "a pass for C broke the machine: %s\n", wrong);
            abort();
        }
        track[i] = t->part[i].tracks;
    }
    buf_init(&code, t->arena);
    emit_c_driver(t->arena, m, track, t->n, soft, &code);
    write_file(folder, "batch.c", &code);
}

void batch_talk(Talk *t, const Via *via, uint32_t vias, const char *folder)
{
    if (!t->images)
        emit(t, vias > 0 && via[0].soft, folder);
    write_file(folder, "commands", &t->commands);
    for (uint32_t i = 0; i < vias; i++)
        talk_via(t, &via[i], folder);
}

void batch_clean(const char *folder)
{
    static const char *const made[] = { "batch.c", "batch", "batch.elf", "batch.log", "commands", "answers" };
    char path[PATH];
    for (size_t i = 0; i < sizeof made / sizeof *made; i++) {
        snprintf(path, sizeof path, "%s/%s", folder, made[i]);
        remove(path);
    }
    rmdir(folder);
}

// ---- parts ----

TalkPart *batch_part(Talk *t, Session *s, const Program *p, const Program *known, Form form, IrMachine *ir, RunResult *result)
{
    const ImageOptions options = { .debug = true };       // the engine finds locals by name
    const char *error = "the compiler makes no image";
    Engine *vm = NULL;
    Buf image;
    buf_init(&image, &s->arena);
    if (t->images && session_image(s, &ir, 1, &options, &image))
        vm = engine_vm_open(&s->arena, known, (const uint8_t *)image.at, image.n, 0, &error);
    if (t->images && vm == NULL) {
        result->verdict = VERDICT_REJECTED;
        result->message = format_in(t->arena, "%s", error);
        return NULL;
    }
    TalkPart *part = talk_add(t, s, p, form, ir, result);
    if (t->images)
        talk_load(part, vm, &image);
    return part;
}

static void record(TalkPart *p, const Subject *s, const Gen *g)
{
    EngineWrite write[GEN_VARS_MAX];
    Engine *e = &p->recorder;
    EngineStep answer;
    uint32_t state;
    engine_step_init(&answer, p->talk->arena, p->program);
    for (p->now = 0; p->now < g->steps; p->now++) {
        if (gen_restarts(g, p->now, &state))
            e->init(e, gen_state_number(g, state), &answer);
        if (!g->skip[p->now])
            e->step(e, write, subject_writes(s, g, p->now, write), &answer);
    }
}

static void add(Talk *t, Gen *g, Subject *s, unsigned forms, RunResult *r)
{
    r->message = subject_compile(s, g, t->arena);
    r->verdict = r->message == NULL ? VERDICT_SAME : VERDICT_REJECTED;
    for (Form f = FORM_O0; f < FORM_COUNT && r->message == NULL; f++) {
        TalkPart *p = NULL;
        if (forms >> f & 1)
            p = batch_part(t, &s->session, s->program, run_known_program(s, f), f, run_machine(s, s->program, f), r);
        if (p != NULL)
            record(p, s, g);
    }
}

void run_batch(Gen *const *g, const unsigned *forms, uint32_t n, const Via *via, uint32_t vias, const char *folder, Arena *arena,
               RunResult *r)
{
    Subject *subject = ARENA_ARRAY(arena, Subject, n);
    Talk t;
    talk_init(&t, arena, vias > 0 && via[0].images, n * FORM_COUNT);
    for (uint32_t i = 0; i < n; i++)
        add(&t, g[i], &subject[i], forms[i], &r[i]);
    if (t.n > 0)
        batch_talk(&t, via, vias, folder);
    for (uint32_t i = 0; i < n; i++)
        subject_free(&subject[i]);
}
