// SPDX-License-Identifier: Apache-2.0
// Runs one .smt case: reads its file, opens the engines that it names, and makes a result of what the case found wrong.
#include <string.h>

#include "compiler/cli/test.h"
#include "compiler/case.h"

struct TestCase {
    TestRun *t;
    jmp_buf oom;
    Session s;
    char *text;               // content of the file; on the heap
    SmtCase smt;
    EngineSet engines;
    unsigned which;           // the engines that the case runs on: a set of 1u << EngineKind
    IrMachine *ir;            // IR of the case's machine, if emitted C is among the engines; else NULL
    bool is_done;             // `result` is final, and the case must not run
    TestResult result;
};

static void set_result(TestCase *c, TestStatus status, const char *message, int code)
{
    c->result.status = status;
    c->result.message = format_in(c->t->arena, "%s", message);
    c->result.code = code;
    c->is_done = true;
}

// Records why the compiler left a stage by longjmp.
static void set_interrupted_result(TestCase *c)
{
    const char *bug = c->s.bug ? format_in(c->t->arena, "%s", c->s.bug) : NULL;

    set_result(c, TEST_BROKEN, bug ? bug : "out of memory", bug ? EXIT_INTERNAL : EXIT_ENVIRONMENT);
}

// Returns the engines that the case wants and the call requests, without those that are not available.
static unsigned choose_engines(TestRun *t, const TestFile *f)
{
    const char *on = testfile_header(f, "on");
    const unsigned requested = t->engines ? t->engines : engines_named("all");
    const unsigned wanted = on ? engines_in_list(on) & requested : requested, absent = test_absent_engines(t, wanted);

    if (wanted & ~absent)
        for (unsigned i = 0; i < ENGINE_KINDS; i++)
            t->left_out += absent >> i & 1u;
    return wanted & ~absent;
}

// Compiles the case, or sets its result if it cannot run.
static void parse_and_compile(TestCase *c, const char *path, size_t n)
{
    const TestFile *f = testfile_parse(&c->s.arena, path, c->text, n);
    const int opt_level = options_opt_level(c->t->c);
    const char *wrong;

    if (!f->error && case_is_for_other_runner(f)) {
        set_result(c, TEST_SKIPPED, "not a case of smc test", EXIT_OK);
        return;
    }
    if ((wrong = case_init(&c->smt, &c->s, f)) != NULL) {
        set_result(c, TEST_BROKEN, wrong, EXIT_PROBLEM);
        return;
    }
    if (case_has_part_of_kind(f, ".ss") && (c->which = choose_engines(c->t, f)) == 0) {
        set_result(c, TEST_SKIPPED, "no engine it can run on", EXIT_OK);
        return;
    }
    case_compile(&c->smt, opt_level);
    if (c->smt.has_runs && !c->smt.p->joint && c->which & (1u << ENGINE_C | 1u << ENGINE_C_SOFT))
        c->ir = session_ir(&c->s, c->smt.p, opt_level);
}

// Reads and compiles a case; test_case_close runs it.
TestCase *test_case_open(TestRun *t, const char *path)
{
    TestCase *c = ARENA_NEW(t->arena, TestCase);
    const double begin = os_seconds();
    const char *why;
    size_t n;

    c->t = t;
    c->result.path = path;
    c->result.suite = test_suite_name(t->arena, path);
    if (!os_read_file(path, SOURCE_MAX, &c->text, &n, &why)) {
        set_result(c, TEST_BROKEN, format_in(t->arena, "cannot read '%s': %s", cli_printable_name(t->arena, path), why), EXIT_ENVIRONMENT);
    } else if (setjmp(c->oom) == 0) {
        session_init(&c->s, os_alloc, NULL, &c->oom);
        parse_and_compile(c, path, n);
    } else {
        set_interrupted_result(c);
    }
    c->result.seconds = os_seconds() - begin;
    return c;
}

// Returns whether the case has to run on emitted C of this kind; if so, stores its program and its IR.
bool test_case_find_c(const TestCase *c, EngineKind kind, const Program **p, const IrMachine **ir)
{
    *p = c->smt.p;
    *ir = c->ir;
    return !c->is_done && c->ir && c->which >> kind & 1u;
}

// Runs the scripts on the engines of emitted C that the batch has opened, and on others that it opens itself. Returns the exit code that a
// failure to run requires, or EXIT_OK.
static int run_scripts(TestCase *c, Engine *const *emitted)
{
    unsigned to_open = c->which;

    for (int kind = 0; kind < ENGINE_KINDS; kind++)
        to_open &= emitted[kind] ? ~(1u << kind) : ~0u;
    if (!engines_open(&c->engines, &c->s, c->smt.p, to_open, options_opt_level(c->t->c))) {
        buf_printf(&c->smt.why, "%s\n", c->engines.error);
        return c->s.diags.errors == 0 ? EXIT_ENVIRONMENT : EXIT_OK;       // an image that is too large is a failure of the case
    }
    for (int kind = 0; kind < ENGINE_KINDS; kind++)
        if (emitted[kind])
            c->engines.at[c->engines.n++] = emitted[kind];
    return case_run_scripts(&c->smt, c->engines.at, c->engines.n, c->t->max_steps) ? EXIT_OK : EXIT_INTERNAL;
}

// Runs the case and frees it. `emitted`, which the caller closes: the engines of emitted C, by kind; where one is NULL, the case opens its
// own engine.
TestResult test_case_close(TestCase *c, Engine *const *emitted)
{
    const double begin = os_seconds();

    if (!c->is_done && setjmp(c->oom) == 0) {
        const int code = c->smt.has_runs ? run_scripts(c, emitted) : EXIT_OK;
        case_check_diagnostics(&c->smt);
        if (c->smt.why.n)
            set_result(c, code ? TEST_BROKEN : TEST_FAILED, buf_text(&c->smt.why), code ? code : EXIT_PROBLEM);
        else
            set_result(c, TEST_PASSED, "", EXIT_OK);
    } else if (!c->is_done) {
        set_interrupted_result(c);
    }
    engines_close(&c->engines);
    session_free(&c->s);
    os_alloc(NULL, c->text, 0);
    c->result.seconds += os_seconds() - begin;
    return c->result;
}
