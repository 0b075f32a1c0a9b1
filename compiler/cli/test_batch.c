// SPDX-License-Identifier: Apache-2.0
// Runs many cases. Cases are compiled and run in batches, so that the C emitted for a whole batch is one program. The C compiler, which
// takes longer than everything else, then runs only once per batch.
#include "compiler/cli/test.h"
#include "compiler/device/engine_c.h"

enum { BATCH = 50 };

typedef struct Batch {
    Arena arena;
    TestCase *at[BATCH];
    Engine *engine[BATCH][ENGINE_KINDS];      // by case, then by EngineKind: its engine in the program `c` of this kind; NULL: it has none
    size_t n;
    EngineCBatch *c[ENGINE_KINDS];            // by EngineKind: one program with the emitted C of all cases; NULL: none was built
} Batch;

// Builds the C of all cases of the batch as one program. If that fails, each case builds its own C, so that the faulty case reports the
// error.
static void open_emitted_c(Batch *b, EngineKind kind)
{
    const Program *p[BATCH];
    const IrMachine *ir[BATCH];
    size_t owner[BATCH], n = 0;
    const char *error;

    for (size_t i = 0; i < b->n; i++)
        if (test_case_find_c(b->at[i], kind, &p[n], &ir[n]))
            owner[n++] = i;
    if (n > 1)
        b->c[kind] = engine_c_batch_open(&b->arena, p, ir, n, kind == ENGINE_C_SOFT, &error);
    for (size_t i = 0; b->c[kind] && i < n; i++)
        b->engine[owner[i]][kind] = engine_c_batch_engine(b->c[kind], i);
}

// Reports why a case did not pass. With --tap, which has the reason too, it is not printed.
static void report_failed_case(TestRun *t, const TestResult *r)
{
    Buf b;

    buf_init(&b, t->arena);
    buf_printf(&b, "%s: failed", r->path);
    for (const char *at = r->message; *at; at++) {
        if (at == r->message || at[-1] == '\n')
            buf_str(&b, "\n    ");
        if (*at != '\n')
            buf_char(&b, *at);
    }
    cli_record_message(t->c, "error", format_in(t->arena, "%s", buf_text(&b)));
    buf_char(&b, '\n');
    if (!t->c->given[OPT_TAP])
        cli_print(t->c, 2, &b);
}

// Runs n cases, at most BATCH, and adds their results.
static void run_batch(TestRun *t, const char *const *path, size_t n)
{
    Batch b = {.n = n};

    arena_init(&b.arena, os_alloc, NULL, t->arena->oom);
    for (size_t i = 0; i < n; i++)
        b.at[i] = test_case_open(t, path[i]);
    open_emitted_c(&b, ENGINE_C);
    open_emitted_c(&b, ENGINE_C_SOFT);
    for (size_t i = 0; i < n; i++) {
        TestResult r = test_case_close(b.at[i], b.engine[i]);
        vec_push(t->arena, &t->result, r);
        if (r.status == TEST_FAILED || r.status == TEST_BROKEN)
            report_failed_case(t, &r);
    }
    for (int kind = 0; kind < ENGINE_KINDS; kind++)
        if (b.c[kind])
            engine_c_batch_close(b.c[kind]);
    arena_free(&b.arena);
}

// Runs n .smt files, and adds a result for each.
void test_run_cases(TestRun *t, const char *const *path, size_t n)
{
    for (size_t i = 0; i < n; i += BATCH)
        run_batch(t, path + i, n - i < BATCH ? n - i : BATCH);
}
