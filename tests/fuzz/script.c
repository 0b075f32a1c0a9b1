// SPDX-License-Identifier: Apache-2.0
// Fuzz target: an .smt case, whose machine is compiled and whose scripts run on every engine in lock step.  Nothing may crash or hang, and the
// engines must agree.  Any conformance case is a seed.
#include "compiler/case.h"
#include "tests/fuzz/fuzz.h"

enum { STEPS_MOST = 1000, MEMORY_MOST = 256 << 20 };

static size_t memory_taken;

// A host with little memory.  A case that needs more ends without a result, which is not a fault.
static void *small_heap(void *context, void *old, size_t size)
{
    if (size > MEMORY_MOST - memory_taken)
        return NULL;
    memory_taken += size;
    return heap_alloc(context, old, size);
}

static size_t open_engines(Session *s, const Program *p, Engine **engine)
{
    IrMachine *m[2] = {session_ir(s, p, 0), session_ir(s, p, 2)};
    size_t n = 0;

    engine[n++] = engine_ref_open(&s->arena, p);
    for (int i = 0; i < 2; i++) {
        ImageOptions o = {true, NULL};                      // the engine finds locals by name
        const char *error = NULL;
        Buf image;
        buf_init(&image, &s->arena);
        if (!session_image(s, &m[i], 1, &o, &image))
            continue;                                 // larger than an image can be
        engine[n] = engine_vm_open(&s->arena, p, (const uint8_t *)image.at, image.n, 0, &error);
        if (!engine[n])
            fprintf(stderr, "%s\n", error);
        FUZZ_CHECK(engine[n++] != NULL);              // the verifier must accept every image that the compiler emits
    }
    return n;
}

unsigned long fuzz_reached;           // cases that compile and run
const unsigned fuzz_floor = 15;

static void run_script(Session *s, const TestFile *f)
{
    const CompileOptions compile = {.skip_analyses = true};
    const ScriptOptions o = {.max_steps = STEPS_MOST};
    const Program *p = NULL;
    const Script *script = NULL;
    Engine *engine[3];
    CaseSources sources;
    Compiled made;
    ScriptResult r;

    case_list_sources(s, f, &sources);
    compile_sources(s, &sources.in, &compile, &made);
    for (size_t i = 0; i < sources.in.n; i++) {
        p = made.of[i].scripted ? made.of[i].scripted : p;
        script = script ? script : made.of[i].script;
    }
    if (!script || script->program->joint)            // tests/joint runs scripts of applications
        return;
    fuzz_reached++;
    r = script_run(&s->arena, &s->diags, script, engine, open_engines(s, p, engine), &o);
    if (r.difference)
        fprintf(stderr, "%s\n", r.difference);
    FUZZ_CHECK(r.outcome != SCRIPT_DIFFERENT && r.outcome != SCRIPT_BROKEN);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static Session s;
    jmp_buf oom;
    DiagStyle style = {true, 0};
    Buf text;

    memory_taken = 0;
    if (setjmp(oom) == 0) {
        session_init(&s, small_heap, NULL, &oom);
        run_script(&s, testfile_parse(&s.arena, "fuzz.smt", (const char *)data, size));
        buf_init(&text, &s.arena);
        diags_sort(&s.diags);
        diags_render_text(&s.diags, &style, &text);
    }
    session_free(&s);
    return 0;
}
