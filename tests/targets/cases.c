// SPDX-License-Identifier: Apache-2.0
// Runs the cases of conformance/ on a target.  It records what their scripts write to a machine, and the results of the reference
// (tests/diff/talk.h), and repeats this conversation with the target.
//     cases --vm=COMMAND | --cc=COMMAND | --cc-soft=COMMAND [--every=N] --out=FOLDER CASE.smt…       every N-th of them
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "compiler/case.h"
#include "tests/diff/batch.h"
#include "tests/diff/subject.h"
#include "tests/heap.h"

enum { TEXT_MAX = 1 << 20, STEPS_MAX = 500, BATCH = 40 };

typedef struct Case {
    const char *path;
    TestFile *f;
    Session s;
    RunResult result;
    bool runs;
} Case;

static unsigned long passed, failed, no_room, left_out;
static jmp_buf out_of_memory;

// ---- a case as a part of the conversation ----

static bool is_for(const Case *c, const char *engine)
{
    const char *on = testfile_header(c->f, "on");

    return c->f->error == NULL && c->f->outcome != TEST_ERROR && (on == NULL || testfile_has_word(on, engine));
}

static void record(Case *c, Talk *t, uint32_t number)
{
    const ScriptOptions options = { .max_steps = c->f->steps != 0 && c->f->steps < STEPS_MAX ? c->f->steps : STEPS_MAX };
    const CompileOptions compile = { .skip_analyses = true };
    const Form form = (Form)(number % 3);
    const Program *p = NULL;
    const Script *script = NULL;
    CaseSources sources;
    Compiled made;

    if (!is_for(c, t->images ? "vm" : "c"))
        return;
    case_list_sources(&c->s, c->f, &sources);
    compile_sources(&c->s, &sources.in, &compile, &made);
    for (size_t i = 0; i < sources.in.n; i++) {
        p = made.of[i].scripted != NULL ? made.of[i].scripted : p;
        script = script != NULL ? script : made.of[i].script;
    }
    if (script == NULL || p->joint)               // several machines, which one conversation does not carry
        return;
    c->runs = true;
    TalkPart *part = batch_part(t, &c->s, p, p, form, session_ir(&c->s, p, (int)form), &c->result);
    if (part == NULL)
        return;
    Engine *engine = &part->recorder;
    script_run(&c->s.arena, &c->s.diags, script, &engine, 1, &options);
}

static void open_case(Case *c, const char *path, Talk *t, uint32_t number)
{
    FILE *f = fopen(path, "rb");

    memset(c, 0, sizeof *c);
    c->path = path;
    session_init(&c->s, heap_alloc, NULL, &out_of_memory);
    char *text = arena_alloc(&c->s.arena, TEXT_MAX);
    const size_t n = f != NULL ? fread(text, 1, TEXT_MAX, f) : 0;
    if (f != NULL)
        fclose(f);
    c->f = testfile_parse(&c->s.arena, path, text, n);
    record(c, t, number);
}

static void close_case(Case *c)
{
    const bool large = c->result.verdict == VERDICT_TOO_LARGE;

    passed += c->runs && c->result.verdict == VERDICT_SAME && !c->result.met.no_room;
    failed += c->runs && c->result.verdict != VERDICT_SAME && !large;
    no_room += c->result.met.no_room || large;
    left_out += !c->runs;
    if (c->result.verdict != VERDICT_SAME && !large)
        printf("%s: %s\n", c->path, c->result.message);
    session_free(&c->s);
}

// ---- many ----

// Runs n cases, of which the first has the number `number`.  If they are together too large for the target, runs each half.
static void run(char **path, uint32_t number, uint32_t n, uint32_t every, const Via *via, const char *folder)
{
    static Case c[BATCH];
    Arena arena;
    Talk t;

    diff_arena_init(&arena);
    talk_init(&t, &arena, via->images, BATCH);
    for (uint32_t i = 0; i < n; i++)
        open_case(&c[i], path[(number + i) * every], &t, number + i);
    mkdir(folder, 0777);
    if (t.n > 0)
        batch_talk(&t, via, 1, folder);
    const bool split = t.n > 1 && t.part[0].result->verdict == VERDICT_TOO_LARGE;
    for (uint32_t i = 0; i < n; i++)
        if (split)
            session_free(&c[i].s);
        else
            close_case(&c[i]);
    batch_clean(folder);
    arena_free(&arena);
    if (split) {
        run(path, number, n / 2, every, via, folder);
        run(path, number + n / 2, n - n / 2, every, via, folder);
    }
}

int main(int argc, char **argv)
{
    Via via = { NULL, false, false };
    const char *folder = NULL;
    uint32_t every = 1;
    int i;

    for (i = 1; i < argc && argv[i][0] == '-'; i++)
        if (strncmp(argv[i], "--out=", 6) == 0)
            folder = argv[i] + 6;
        else if (strncmp(argv[i], "--every=", 8) == 0)
            every = (uint32_t)strtoul(argv[i] + 8, NULL, 10);
        else if (!batch_via(argv[i], &via))
            return 2;
    if (via.command == NULL || folder == NULL || every == 0)
        return 2;
    const uint32_t n = ((uint32_t)(argc - i) + every - 1) / every;
    for (uint32_t k = 0; k < n; k += BATCH)
        run(argv + i, k, n - k < BATCH ? n - k : BATCH, every, &via, folder);
    if (no_room > 0)
        printf("%lu had no room there\n", no_room);
    printf("%lu passed, %lu failed\n", passed, failed);
    return failed != 0 || passed == 0;
}
