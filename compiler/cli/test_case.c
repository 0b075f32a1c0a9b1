// SPDX-License-Identifier: Apache-2.0
// One .smt case: its sources are compiled, its scripts run on the engines it names in lock step, and what comes out is
// held against what the case announces: diagnostics on their lines, outcome, report, trace.
#include <inttypes.h>
#include <string.h>

#include "compiler/analysis/analysis.h"
#include "compiler/cli/test.h"

typedef struct Case {
    TestRun *t;
    const char *path;
    TestFile *f;
    jmp_buf oom;
    Session s;
    EngineSet engines;
    char *text;               // of the file, from the heap
    Source **src;             // of each part that is a source
    Buf why;                  // what is wrong, a line or more each
} Case;

static void complain(Case *c, const char *what) { buf_printf(&c->why, "%s\n", what); }

static TestResult result_of(const Case *c, TestStatus status, const char *message, int code)
{
    return (TestResult){c->path, status, format_in(c->t->arena, "%s", message), code};
}

// ---- is it a case for us? ----

static size_t count_parts(const TestFile *f, const char *suffix)
{
    size_t n = 0;

    for (size_t i = 0; i < f->part.n; i++)
        n += testfile_has_suffix(&f->part.at[i], suffix);
    return n;
}

static const char *unknown_key(Case *c)
{
    static const char keys[] = "spec on expect steps args analyses";

    for (size_t i = 0; i < c->f->header.n; i++)
        if (!testfile_has_word(keys, c->f->header.at[i].key))
            return format_in(&c->s.arena, "line %lu: unknown header line '%s'; it is one of: %s",
                             (unsigned long)c->f->header.at[i].line, c->f->header.at[i].key, keys);
    return NULL;
}

// What is wrong with the file itself, or NULL.
static const char *malformed(Case *c)
{
    const TestFile *f = c->f;

    if (f->error)
        return f->error;
    if (count_parts(f, ".sm") > 1 || count_parts(f, ".sv") > 1)
        return "a case has at most one .sm and one .sv";
    if (count_parts(f, ".sm") + count_parts(f, ".sv") == 0)
        return "a case needs a machine, as -- app.sm --";
    if (count_parts(f, ".ss") && !count_parts(f, ".sm"))
        return "a script needs a machine, as -- app.sm --";
    if (f->outcome == TEST_FAIL && !count_parts(f, ".ss"))
        return "'expect fail' needs a script";
    return unknown_key(c);
}

static bool is_golden(const TestFile *f)
{
    return testfile_part(f, "stdout") || testfile_part(f, "stderr") || testfile_part(f, "exit") || testfile_part(f, "ir");
}

// ---- compiling ----

static const Source *find_source(const Case *c, const char *suffix)
{
    for (size_t i = 0; i < c->f->part.n; i++)
        if (testfile_has_suffix(&c->f->part.at[i], suffix))
            return c->src[i];
    return NULL;
}

static void make_sources(Case *c)
{
    c->src = ARENA_ARRAY(&c->s.arena, Source *, c->f->part.n);
    for (size_t i = 0; i < c->f->part.n; i++) {
        const TestPart *p = &c->f->part.at[i];
        if (testfile_is_source(p))
            c->src[i] = source_new(&c->s.arena, p->name, p->text, p->n);
    }
}

// The locals that scripts write.  Mistakes in a script are reported when it is compiled.
static void collect_written(Case *c, Map *written)
{
    c->s.diags.muted = true;
    for (size_t i = 0; i < c->f->part.n; i++)
        if (testfile_has_suffix(&c->f->part.at[i], ".ss")) {
            AstFile *ss = session_parse(&c->s, c->src[i], FILE_SS);
            if (ss)
                script_written_names(ss, written);
        }
    c->s.diags.muted = false;
}

static Program *compile_machine(Case *c)
{
    Map written = {&c->s.arena, NULL, NULL, 0, 0};
    MachineInput in = {find_source(c, ".sm"), find_source(c, ".sv"), &written, option_level(c->t->c)};

    if (!in.sm) {
        session_state_vector(&c->s, in.sv);
        return NULL;
    }
    collect_written(c, &written);
    return session_program(&c->s, &in);
}

// The scripts, by part; NULL where there is none or it has errors.
static Script **compile_scripts(Case *c, const Program *p)
{
    Script **script = ARENA_ARRAY(&c->s.arena, Script *, c->f->part.n);

    for (size_t i = 0; p && i < c->f->part.n; i++)
        if (testfile_has_suffix(&c->f->part.at[i], ".ss"))
            script[i] = session_script(&c->s, c->src[i], p);
    return script;
}

// ---- diagnostics, both ways ----

static bool mentions(const Diag *d, const char *text)
{
    if (strstr(d->text, text) || (d->label && strstr(d->label, text)))
        return true;
    for (size_t i = 0; i < d->notes.n; i++)
        if (strstr(d->notes.at[i].text, text))
            return true;
    return false;
}

static bool matches(const Case *c, const TestExpected *e, const Diag *d)
{
    return d->span.src && d->span.src == c->src[e->part] && source_position(d->span.src, d->span.at).line == e->line &&
           strcmp(diag_info[d->code].id, e->id) == 0 && mentions(d, e->text);
}

static void complain_of_diagnostic(Case *c, const Diag *d)
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
    buf_printf(b, " [%s]\n", diag_info[d->code].id);
}

static void check_diagnostics(Case *c)
{
    uint8_t *met = arena_alloc(&c->s.arena, c->f->expected.n);

    for (size_t i = 0; i < c->s.diags.list.n; i++) {
        const Diag *d = c->s.diags.list.at[i];
        size_t j = 0;
        while (j < c->f->expected.n && (met[j] || !matches(c, &c->f->expected.at[j], d)))
            j++;
        if (j < c->f->expected.n)
            met[j] = 1;
        else
            complain_of_diagnostic(c, d);
    }
    for (size_t j = 0; j < c->f->expected.n; j++) {
        const TestExpected *e = &c->f->expected.at[j];
        if (!met[j])
            buf_printf(&c->why, "announced, but not reported: %s:%lu: %s %s\n", c->f->part.at[e->part].name,
                       (unsigned long)e->line, e->id, e->text);
    }
}

// ---- report and trace ----

typedef struct Lines { const char *at, *end; } Lines;
typedef struct TextLine { const char *at; size_t n; } TextLine;

static bool next_line(Lines *l, TextLine *line)
{
    const char *lf;

    if (l->at == l->end)
        return false;
    lf = memchr(l->at, '\n', (size_t)(l->end - l->at));
    line->at = l->at;
    line->n = (size_t)((lf ? lf : l->end) - l->at);
    l->at = lf ? lf + 1 : l->end;
    return true;
}

static Lines lines_of_part(const TestPart *p)         // blank lines at its end separate it from the next part
{
    size_t n = p->n;

    while (n && (p->text[n - 1] == '\n' || p->text[n - 1] == '\r'))
        n--;
    return (Lines){p->text, p->text + n};
}

static bool equal(TextLine a, TextLine b) { return a.n == b.n && memcmp(a.at, b.at, a.n) == 0; }

static void check_report(Case *c, const TestPart *part, const Buf *report)
{
    Lines expected = lines_of_part(part), came = {buf_text(report), buf_text(report) + report->n};
    TextLine e, r;
    bool more_e = true, more_r = true, differs = false;

    while (more_e || more_r) {
        more_e = next_line(&expected, &e);
        more_r = next_line(&came, &r);
        if (more_e == more_r && (!more_e || equal(e, r)))
            continue;
        if (!differs)
            complain(c, "the report differs (- expected, + came):");
        differs = true;
        if (more_e)
            buf_printf(&c->why, "  - %.*s\n", (int)e.n, e.at);
        if (more_r)
            buf_printf(&c->why, "  + %.*s\n", (int)r.n, r.at);
    }
}

static size_t up_to_value(TextLine l)                 // of "STEP NAME VALUE"
{
    size_t n = l.n;

    while (n && l.at[n - 1] != ' ')
        n--;
    return n;
}

static void complain_of_trace(Case *c, TextLine wanted, const Buf *trace)
{
    Lines all = {buf_text(trace), buf_text(trace) + trace->n};
    size_t n = up_to_value(wanted);
    TextLine l;

    buf_printf(&c->why, "the trace has no line '%.*s' here", (int)wanted.n, wanted.at);
    while (next_line(&all, &l))
        if (n && up_to_value(l) == n && memcmp(l.at, wanted.at, n) == 0)
            buf_printf(&c->why, "; it has '%.*s'", (int)l.n, l.at);
    buf_char(&c->why, '\n');
}

static void check_trace(Case *c, const TestPart *part, const Buf *trace)
{
    Lines expected = lines_of_part(part), came = {buf_text(trace), buf_text(trace) + trace->n};
    TextLine e, l;

    while (next_line(&expected, &e)) {
        Lines before = came;
        bool found = e.n == 0;
        while (!found && next_line(&came, &l))
            found = equal(e, l);
        if (!found) {
            complain_of_trace(c, e, trace);
            came = before;
        }
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

static void check_outcome(Case *c, const char *script, ScriptOutcome o)
{
    bool failed = o == SCRIPT_FAILED || o == SCRIPT_ENDLESS || o == SCRIPT_TIME_OVER;

    if (c->f->outcome == TEST_PASS ? o != SCRIPT_PASSED : !failed)
        buf_printf(&c->why, "%s should %s, but %s\n", script, c->f->outcome == TEST_PASS ? "pass" : "fail", outcome_text(o));
}

static void run_script(Case *c, const Program *p, const Script *script, const char *name, bool is_first)
{
    const TestPart *report_part = testfile_part(c->f, "report"), *trace_part = testfile_part(c->f, "trace");
    ScriptOptions o = {c->f->steps ? c->f->steps : c->t->max_steps, NULL, NULL, NULL};
    ScriptResult r;
    Buf report, trace;

    buf_init(&report, &c->s.arena);
    buf_init(&trace, &c->s.arena);
    if (trace_part && is_first)
        o.trace = &trace;
    r = script_run(&c->s.arena, &c->s.diags, script, c->engines.at, c->engines.n, &o);
    check_outcome(c, name, r.outcome);
    script_report(&r, p, &report);
    if (report_part && is_first)
        check_report(c, report_part, &report);
    if (o.trace)
        check_trace(c, trace_part, &trace);
}

static void run_scripts(Case *c, const Program *p, Script **script, unsigned which)
{
    bool is_first = true;

    if (!engines_open(&c->engines, &c->s, p, which, option_level(c->t->c))) {
        complain(c, c->engines.error);
        return;
    }
    for (size_t i = 0; i < c->f->part.n; i++)
        if (script[i]) {
            run_script(c, p, script[i], c->f->part.at[i].name, is_first);
            is_first = false;
        }
}

// ---- the case ----

// Of those the case wants and the call asks for, the ones that are here.
static unsigned choose_engines(Case *c)
{
    const char *on = testfile_header(c->f, "on");
    unsigned wanted = on ? engines_in_list(on) : engines_named("all"), present = engines_present(), absent;

    if (c->t->engines)
        wanted &= c->t->engines;
    absent = wanted & ~present;
    c->t->absent |= absent;
    if (wanted & present)
        for (unsigned i = 0; i < ENGINE_KINDS; i++)
            c->t->left_out += absent >> i & 1u;
    return wanted & present;
}

static void check_case(Case *c, unsigned which)
{
    const char *analyses = testfile_header(c->f, "analyses");
    Script **script;
    Program *p;

    make_sources(c);
    p = compile_machine(c);
    if (p && analyses && strcmp(analyses, "on") == 0)
        analyse_program(&c->s.arena, &c->s.diags, p);
    script = compile_scripts(c, p);
    if (c->f->outcome == TEST_ERROR && c->s.diags.errors == 0)
        complain(c, "should not compile, but does");
    else if (c->f->outcome != TEST_ERROR && c->s.diags.errors == 0 && count_parts(c->f, ".ss"))
        run_scripts(c, p, script, which);
    check_diagnostics(c);
}

static TestResult run_case(Case *c)
{
    const char *wrong;
    unsigned which;

    if (!c->f->error && is_golden(c->f))
        return result_of(c, TEST_SKIPPED, "not a case of smc test", EXIT_OK);
    if ((wrong = malformed(c)) != NULL)
        return result_of(c, TEST_FAILED, wrong, EXIT_PROBLEM);
    which = count_parts(c->f, ".ss") ? choose_engines(c) : 0;
    if (!which && count_parts(c->f, ".ss"))
        return result_of(c, TEST_SKIPPED, "no engine it can run on", EXIT_OK);
    check_case(c, which);
    return c->why.n ? result_of(c, TEST_FAILED, buf_text(&c->why), EXIT_PROBLEM) : result_of(c, TEST_PASSED, "", EXIT_OK);
}

static TestResult open_case(Case *c, const char *path)
{
    const char *why;
    char *text;
    size_t n;

    c->path = path;
    if (!os_read(path, SOURCE_MAX, &text, &n, &why))
        return result_of(c, TEST_FAILED, format_in(c->t->arena, "cannot read '%s': %s", path, why), EXIT_ENVIRONMENT);
    c->text = text;
    if (setjmp(c->oom))
        return result_of(c, TEST_FAILED, "out of memory", EXIT_ENVIRONMENT);
    session_init(&c->s, os_alloc, NULL, &c->oom);
    buf_init(&c->why, &c->s.arena);
    c->f = testfile_parse(&c->s.arena, path, text, n);
    return run_case(c);
}

TestResult test_case(TestRun *t, const char *path)
{
    Case *c = ARENA_NEW(t->arena, Case);
    TestResult r;

    c->t = t;
    r = open_case(c, path);
    engines_close(&c->engines);
    session_free(&c->s);
    os_alloc(NULL, c->text, 0);
    return r;
}
