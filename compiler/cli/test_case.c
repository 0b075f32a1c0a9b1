// SPDX-License-Identifier: Apache-2.0
// Runs one .smt case: compiles its sources and runs its scripts in lock step on the engines that it names. Then compares the results with
// those that the case expects: diagnostics on their lines, outcome, report, trace.
#include <inttypes.h>
#include <string.h>

#include "compiler/cli/test.h"

struct TestCase {
    TestRun *t;
    const char *path;
    TestFile *f;
    jmp_buf oom;
    Session s;
    EngineSet engines;
    char *text;               // of the file; on the heap
    DiagSelection warn;            // as its header `warn` selects
    Source **src;             // of each part that is a source
    size_t *input;            // by part: the index of its source in the input of compile_sources()
    Buf why;                  // the problems, one or more lines each
    int code;                 // the exit code for them; 0: EXIT_PROBLEM
    unsigned which;           // engines it runs on
    const Program *p;         // compiled for its scripts
    IrMachine *ir;            // of p, if emitted C is among them
    const Script **script;    // by part; NULL: no script, or it has errors
    bool is_ready;            // compiled without errors, and there are scripts to run
    bool is_done;             // nothing more to do: `result` is final
    TestResult result;
};

static void add_problem(TestCase *c, const char *what) { buf_printf(&c->why, "%s\n", what); }

static void set_result(TestCase *c, TestStatus status, const char *message, int code)
{
    c->result.status = status;
    c->result.message = format_in(c->t->arena, "%s", message);
    c->result.code = code;
    c->is_done = true;
}

static void set_out_of_memory(TestCase *c) { set_result(c, TEST_BROKEN, "out of memory", EXIT_ENVIRONMENT); }

// ---- is the file a valid case? ----

static size_t count_parts(const TestFile *f, const char *suffix)
{
    size_t n = 0;

    for (size_t i = 0; i < f->part.n; i++)
        n += testfile_has_suffix(&f->part.at[i], suffix);
    return n;
}

static const char *find_unknown_key(TestCase *c)
{
    static const char keys[] = "spec on expect steps args analyses warn advance";

    for (size_t i = 0; i < c->f->header.n; i++)
        if (!testfile_has_word(keys, c->f->header.at[i].key))
            return format_in(&c->s.arena, "line %lu: unknown header line '%s'; it is one of: %s",
                             (unsigned long)c->f->header.at[i].line, c->f->header.at[i].key, keys);
    return NULL;
}

// Reads the header `warn extra no-dead-code`: names as after -W. Returns what is wrong with them, or NULL.
static const char *read_warnings(TestCase *c)
{
    const char *words = testfile_header(c->f, "warn");

    c->warn.word = ARENA_ARRAY(&c->s.arena, const char *, words ? strlen(words) + 1 : 1);
    while (words && *words) {
        size_t n = strcspn(words, " \t");
        if (n)
            c->warn.word[c->warn.n++] = format_in(&c->s.arena, "%.*s", (int)n, words);
        words += n + (words[n] != '\0');
    }
    return diag_selection_error(&c->s.arena, &c->warn);
}

// Returns what is wrong with the file itself, or NULL.
static const char *find_malformed(TestCase *c)
{
    const TestFile *f = c->f;
    const char *wrong;

    if (f->error)
        return f->error;
    if (count_parts(f, ".app"))
        return count_parts(f, ".app") > 1 || count_parts(f, ".ss") ? "a case has at most one .app, and no script beside it"
             : (wrong = find_unknown_key(c)) != NULL ? wrong : read_warnings(c);
    if (count_parts(f, ".sm") > 1 || count_parts(f, ".sv") > 1 || count_parts(f, ".io") > 1)
        return "a case has at most one .sm, one .sv and one .io";
    if (count_parts(f, ".io") && !count_parts(f, ".sv"))
        return "pins need a state vector, as -- app.sv --";
    if (count_parts(f, ".sm") + count_parts(f, ".sv") == 0)
        return "a case needs a machine, as -- app.sm --";
    if (count_parts(f, ".ss") && !count_parts(f, ".sm"))
        return "a script needs a machine, as -- app.sm --";
    if (f->outcome == TEST_FAIL && !count_parts(f, ".ss"))
        return "'expect fail' needs a script";
    return (wrong = find_unknown_key(c)) != NULL ? wrong : read_warnings(c);
}

static bool is_golden(const TestFile *f)
{
    return testfile_part(f, "stdout") || testfile_part(f, "stderr") || testfile_part(f, "exit") || testfile_part(f, "ir");
}

// ---- compiling ----

static const Source *find_source(const TestCase *c, const char *suffix)
{
    for (size_t i = 0; i < c->f->part.n; i++)
        if (testfile_has_suffix(&c->f->part.at[i], suffix))
            return c->src[i];
    return NULL;
}

static bool wants_analyses(const TestCase *c)
{
    const char *analyses = testfile_header(c->f, "analyses");

    return c->warn.n > 0 || (analyses && strcmp(analyses, "on") == 0);
}

// Parts of the case supply the files that an application names.
static void open_app(TestCase *c, CompileInput *in)
{
    in->app = ARENA_NEW(&c->s.arena, CompileApp);
    compile_open_app(&c->s, in->at[0].text, in->app);
    for (size_t i = 0; i < in->app->files.n; i++) {
        AppFile *f = &in->app->files.at[i];
        f->problem = "the case has no such part";
        for (size_t k = 0; k < c->f->part.n && !f->wrong_kind; k++)
            if (strcmp(c->f->part.at[k].name, f->name.text->text) == 0)
                f->src = c->src[k];
    }
}

// Of an application, the only source is the .app itself.  A .sv beside a machine or pins is their vector.
static CompileInput list_inputs(TestCase *c)
{
    const bool has_app = count_parts(c->f, ".app") > 0, has_users = count_parts(c->f, ".sm") + count_parts(c->f, ".io") > 0;
    CompileInput in = {ARENA_ARRAY(&c->s.arena, CompileSource, c->f->part.n), 0, NULL, NULL, NULL};

    c->src = ARENA_ARRAY(&c->s.arena, Source *, c->f->part.n);
    c->input = ARENA_ARRAY(&c->s.arena, size_t, c->f->part.n);
    for (size_t i = 0; i < c->f->part.n; i++) {
        const TestPart *p = &c->f->part.at[i];
        FileKind kind;
        if (testfile_is_source(p))
            c->src[i] = source_new(&c->s.arena, p->name, p->text, p->n);
        if (!c->src[i] || !file_kind(p->name, &kind) || (has_app && kind != FILE_APP) || (has_users && kind == FILE_SV))
            continue;
        c->input[i] = in.n;
        in.at[in.n++] = (CompileSource){.text = c->src[i], .kind = kind};
    }
    if (has_app)
        open_app(c, &in);
    else
        in.vector = has_users ? find_source(c, ".sv") : NULL;
    return in;
}

static void compile_case(TestCase *c)
{
    const CompileInput in = list_inputs(c);
    CompileOptions o;
    Compiled made;

    memset(&o, 0, sizeof o);
    o.opt_level = options_opt_level(c->t->c);
    o.warnings = &c->warn;
    o.skip_analyses = !in.app && !wants_analyses(c);
    o.step = c->f->advance;
    compile_sources(&c->s, &in, &o, &made);
    c->script = ARENA_ARRAY(&c->s.arena, const Script *, c->f->part.n);
    for (size_t i = 0; i < c->f->part.n; i++)
        if (testfile_has_suffix(&c->f->part.at[i], ".sm"))
            c->p = made.of[c->input[i]].scripted;
        else if (testfile_has_suffix(&c->f->part.at[i], ".ss"))
            c->script[i] = made.of[c->input[i]].script;
    c->is_ready = c->f->outcome != TEST_ERROR && c->s.diags.errors == 0 && count_parts(c->f, ".ss") > 0;
    if (c->is_ready && c->which & (1u << ENGINE_C | 1u << ENGINE_C_SOFT))
        c->ir = session_ir(&c->s, c->p, options_opt_level(c->t->c));
}

// ---- diagnostics: missing and unexpected ----

static bool mentions_text(const Diag *d, const char *text)
{
    if (strstr(d->text, text) || (d->label && strstr(d->label, text)))
        return true;
    for (size_t i = 0; i < d->notes.n; i++)
        if (strstr(d->notes.at[i].text, text))
            return true;
    return false;
}

static bool matches_expected(const TestCase *c, const TestExpected *e, const Diag *d)
{
    return d->span.src && d->span.src == c->src[e->part] && source_position(d->span.src, d->span.at).line == e->line &&
           strcmp(diag_info[d->code].id, e->id) == 0 && mentions_text(d, e->text);
}

static void add_unexpected(TestCase *c, const Diag *d)
{
    Buf *b = &c->why;

    buf_str(b, "not announced: ");
    if (d->span.src) {
        LineCol at = source_position(d->span.src, d->span.at);
        buf_printf(b, "%s:%lu:%lu: ", d->span.src->name, (unsigned long)at.line, (unsigned long)at.col);
    }
    buf_printf(b, "%s: %s", d->severity == DIAG_ERROR ? "error" : "warning", d->text);
    if (d->label)
        buf_printf(b, " (%s)", d->label);
    buf_printf(b, " [%s]\n", diag_code_and_name(d, b->arena));
}

static void check_diagnostics(TestCase *c)
{
    uint8_t *met = arena_alloc(&c->s.arena, c->f->expected.n);

    diags_apply_allows(&c->s.diags);
    diags_select(&c->s.diags, &c->warn);
    for (size_t i = 0; i < c->s.diags.list.n; i++) {
        const Diag *d = c->s.diags.list.at[i];
        size_t j = 0;
        while (j < c->f->expected.n && (met[j] || !matches_expected(c, &c->f->expected.at[j], d)))
            j++;
        if (j < c->f->expected.n)
            met[j] = 1;
        else
            add_unexpected(c, d);
    }
    for (size_t j = 0; j < c->f->expected.n; j++) {
        const TestExpected *e = &c->f->expected.at[j];
        if (!met[j])
            buf_printf(&c->why, "announced, but not reported: %s:%lu: %s %s\n", c->f->part.at[e->part].name,
                       (unsigned long)e->line, e->id, e->text);
    }
}

// ---- running ----

static const char *outcome_text(ScriptOutcome o)
{
    switch (o) {
    case SCRIPT_PASSED: return "passed";
    case SCRIPT_FAILED: return "failed";
    case SCRIPT_ENDLESS: return "did not reach @stop";
    case SCRIPT_TIME_OVER: return "ran out of time";
    case SCRIPT_BROKEN: return "could not be run";
    case SCRIPT_DIFFERENT: return "gave different values on different engines";
    }
    return "";
}

static void check_outcome(TestCase *c, const char *script, ScriptOutcome o)
{
    bool failed = o == SCRIPT_FAILED || o == SCRIPT_ENDLESS || o == SCRIPT_TIME_OVER;

    if (c->f->outcome == TEST_PASS ? o != SCRIPT_PASSED : !failed)
        buf_printf(&c->why, "%s should %s, but %s\n", script, c->f->outcome == TEST_PASS ? "pass" : "fail", outcome_text(o));
}

typedef struct CaseTrace { const Var **order; size_t n; Buf text; } CaseTrace;

static void add_to_trace(void *context, const ScriptStep *step)
{
    CaseTrace *t = context;

    script_trace_exact(&t->text, step, t->order, t->n);
}

static void run_script(TestCase *c, const Script *script, const char *name, bool is_first)
{
    const TestPart *report_part = testfile_part(c->f, "report"), *trace_part = testfile_part(c->f, "trace");
    CaseTrace trace = {report_order(&c->s.arena, c->p), c->p->var.n, {0}};
    ScriptOptions o = {c->f->steps ? c->f->steps : c->t->max_steps, NULL, &trace, report_part || trace_part};
    ScriptResult r;
    Buf report;

    buf_init(&report, &c->s.arena);
    buf_init(&trace.text, &c->s.arena);
    if (trace_part && is_first)
        o.after_step = add_to_trace;
    r = script_run(&c->s.arena, &c->s.diags, script, c->engines.at, c->engines.n, &o);
    check_outcome(c, name, r.outcome);
    if (r.outcome == SCRIPT_BROKEN)
        c->code = EXIT_INTERNAL;
    script_report(&r, c->p, &report);
    if (report_part && is_first)
        test_check_report(report_part, &report, &c->why);
    if (o.after_step)
        test_check_trace(trace_part, &trace.text, &c->why);
}

static void run_scripts(TestCase *c, Engine *const *emitted)
{
    bool is_first = true;
    unsigned own = c->which;

    for (int kind = 0; kind < ENGINE_KINDS; kind++)
        own &= emitted[kind] ? ~(1u << kind) : ~0u;
    if (!engines_open(&c->engines, &c->s, c->p, own, options_opt_level(c->t->c))) {
        add_problem(c, c->engines.error);
        if (c->s.diags.errors == 0)           // otherwise an image can be too large
            c->code = EXIT_ENVIRONMENT;
        return;
    }
    for (int kind = 0; kind < ENGINE_KINDS; kind++)
        if (emitted[kind])
            c->engines.at[c->engines.n++] = emitted[kind];
    for (size_t i = 0; i < c->f->part.n; i++)
        if (c->script[i]) {
            run_script(c, c->script[i], c->f->part.at[i].name, is_first);
            is_first = false;
        }
}

// ---- the case ----

// Returns the engines that the case wants and the call requests, without those that are not available.
static unsigned choose_engines(TestCase *c)
{
    const char *on = testfile_header(c->f, "on");
    const unsigned asked = c->t->engines ? c->t->engines : engines_named("all");
    const unsigned wanted = on ? engines_in_list(on) & asked : asked, absent = test_absent_engines(c->t, wanted);

    if (wanted & ~absent)
        for (unsigned i = 0; i < ENGINE_KINDS; i++)
            c->t->left_out += absent >> i & 1u;
    return wanted & ~absent;
}

static void compile_if_runnable(TestCase *c)
{
    const char *wrong;

    if (!c->f->error && is_golden(c->f)) {
        set_result(c, TEST_SKIPPED, "not a case of smc test", EXIT_OK);
    } else if ((wrong = find_malformed(c)) != NULL) {
        set_result(c, TEST_BROKEN, wrong, EXIT_PROBLEM);
    } else {
        c->which = count_parts(c->f, ".ss") ? choose_engines(c) : 0;
        if (c->which || !count_parts(c->f, ".ss"))
            compile_case(c);
        else
            set_result(c, TEST_SKIPPED, "no engine it can run on", EXIT_OK);
    }
}

TestCase *case_open(TestRun *t, const char *path)
{
    TestCase *c = ARENA_NEW(t->arena, TestCase);
    const double begin = os_seconds();
    const char *why;
    size_t n;

    c->t = t;
    c->path = path;
    c->result.path = path;
    c->result.suite = test_folder(t->arena, path);
    if (!os_read(path, SOURCE_MAX, &c->text, &n, &why)) {
        set_result(c, TEST_BROKEN, format_in(t->arena, "cannot read '%s': %s", cli_printable_name(t->arena, path), why), EXIT_ENVIRONMENT);
    } else if (setjmp(c->oom) == 0) {
        session_init(&c->s, os_alloc, NULL, &c->oom);
        buf_init(&c->why, &c->s.arena);
        c->f = testfile_parse(&c->s.arena, path, c->text, n);
        compile_if_runnable(c);
    } else {
        set_out_of_memory(c);
    }
    c->result.seconds = os_seconds() - begin;
    return c;
}

bool case_find_c(const TestCase *c, EngineKind kind, const Program **p, const IrMachine **ir)
{
    *p = c->p;
    *ir = c->ir;
    return !c->is_done && c->ir && c->which >> kind & 1u;
}

static void check_results(TestCase *c, Engine *const *emitted)
{
    if (c->f->outcome == TEST_ERROR && c->s.diags.errors == 0)
        add_problem(c, "should not compile, but does");
    if (c->is_ready)
        run_scripts(c, emitted);
    check_diagnostics(c);
    if (c->why.n)
        set_result(c, c->code ? TEST_BROKEN : TEST_FAILED, buf_text(&c->why), c->code ? c->code : EXIT_PROBLEM);
    else
        set_result(c, TEST_PASSED, "", EXIT_OK);
}

TestResult case_close(TestCase *c, Engine *const *emitted)
{
    const double begin = os_seconds();

    if (!c->is_done && setjmp(c->oom) == 0)
        check_results(c, emitted);
    else if (!c->is_done)
        set_out_of_memory(c);
    engines_close(&c->engines);
    session_free(&c->s);
    os_alloc(NULL, c->text, 0);
    c->result.seconds += os_seconds() - begin;
    return c->result;
}
