// SPDX-License-Identifier: Apache-2.0
#include "compiler/case.h"

#include <string.h>

#include "compiler/base/path.h"
#include "compiler/data/data_file.h"

// ---- the parts as sources ----

static size_t count_parts(const TestFile *f, const char *suffix)
{
    size_t n = 0;

    for (size_t i = 0; i < f->part.n; i++)
        n += testfile_has_suffix(&f->part.at[i], suffix);
    return n;
}

bool case_has_part_of_kind(const TestFile *f, const char *suffix) { return count_parts(f, suffix) > 0; }

static void supply_app_files(Session *s, const TestFile *f, CaseSources *out)
{
    out->in.app = ARENA_NEW(&s->arena, CompileApp);
    compile_open_app(s, out->in.at[0].text, out->in.app);
    for (size_t i = 0; i < out->in.app->files.n; i++) {
        AppFile *file = &out->in.app->files.at[i];
        file->problem = "the case has no such part";
        for (size_t k = 0; k < f->part.n && !file->wrong_kind; k++)
            if (strcmp(f->part.at[k].name, file->name.text->text) == 0)
                file->src = out->src[k];
    }
}

// Finds the part of a case that a script includes.
static const Source *find_included(void *context, const Source *from, const char *name, const char **problem)
{
    const CaseSources *c = context;
    const char *path = path_simplify(c->arena, path_beside(c->arena, from->name, name));

    *problem = "the case has no such part";
    for (size_t i = 0; i < c->parts; i++)
        if (c->src[i] && strcmp(path_simplify(c->arena, c->src[i]->name), path) == 0)
            return c->src[i];
    return NULL;
}

// Finds the part of a case that is a file with recorded data.
static const DataFile *find_data(void *context, const Source *from, const char *name, const char **problem)
{
    const CaseSources *c = context;
    const char *path = path_simplify(c->arena, path_beside(c->arena, from->name, name));

    *problem = "the case has no such part";
    for (size_t i = 0; i < c->parts; i++)
        if (strcmp(path_simplify(c->arena, c->file->part.at[i].name), path) == 0) {
            DataMemory *m = ARENA_NEW(c->arena, DataMemory);
            data_memory_init(m, c->file->part.at[i].name, c->file->part.at[i].text, c->file->part.at[i].n);
            return &m->file;
        }
    return NULL;
}

void case_list_sources(Session *s, const TestFile *f, CaseSources *out)
{
    const bool has_app = case_has_part_of_kind(f, ".app");
    const bool vector_is_shared = case_has_part_of_kind(f, ".sm") || case_has_part_of_kind(f, ".io") ||
                                  case_has_part_of_kind(f, ".net");
    size_t others = 0;

    memset(out, 0, sizeof *out);
    s->finder = (SourceFinder){find_included, find_data, out};
    out->arena = &s->arena;
    out->file = f;
    out->parts = f->part.n;
    out->src = ARENA_ARRAY(&s->arena, Source *, f->part.n);
    out->input = ARENA_ARRAY(&s->arena, size_t, f->part.n);
    out->in.at = ARENA_ARRAY(&s->arena, CompileSource, f->part.n);
    for (size_t i = 0; i < f->part.n; i++) {
        const TestPart *p = &f->part.at[i];
        FileKind kind;
        if (!testfile_is_source(p) || !file_kind(p->name, &kind))
            continue;
        out->src[i] = source_new(&s->arena, p->name, p->text, p->n);
        if (has_app ? kind != FILE_APP && kind != FILE_SS && kind != FILE_RQ : vector_is_shared && kind == FILE_SV) {
            if (!has_app && !out->in.vector)
                out->in.vector = out->src[i];
            continue;
        }
        out->input[i] = has_app && kind != FILE_APP ? ++others : out->in.n;           // the application has index 0, so other parts get 1, 2 …
        out->in.at[out->input[i]] = (CompileSource){.text = out->src[i], .kind = kind};
        out->in.n += !has_app || kind == FILE_APP;
    }
    out->in.n += others;
    if (has_app)
        supply_app_files(s, f, out);
}

// ---- the case ----

// Whether the tests of the command (tests/golden) or of the IR (tests/ir) run the case, and smc test does not.
bool case_is_for_other_runner(const TestFile *f)
{
    return testfile_part(f, "stdout") || testfile_part(f, "stderr") || testfile_part(f, "exit") || testfile_part(f, "ir");
}

// Returns what is wrong with the kinds of the parts, or NULL.
static const char *find_wrong_parts(const TestFile *f)
{
    const size_t machines = count_parts(f, ".sm"), scripts = count_parts(f, ".ss"), vectors = count_parts(f, ".sv"), pins = count_parts(f, ".io");
    const size_t nets = count_parts(f, ".net");

    if (case_has_part_of_kind(f, ".app"))
        return count_parts(f, ".app") > 1 ? "a case has at most one .app" : NULL;
    if (machines > 1 || vectors > 1 || pins > 1 || nets > 1)
        return "a case has at most one .sm, one .sv, one .io and one .net";
    if (nets && !vectors)
        return "messages need a state vector, as -- app.sv --";
    if (case_has_part_of_kind(f, ".rq") && !machines)
        return "requirements need a machine, as -- app.sm --";
    if (pins && !vectors)
        return "pins need a state vector, as -- app.sv --";
    if (machines + vectors == 0)
        return "a case needs a machine, as -- app.sm --";
    if (scripts && !machines)
        return "a script needs a machine, as -- app.sm --";
    if (f->outcome == TEST_FAIL && !scripts)
        return "'expect fail' needs a script";
    return NULL;
}

// Returns a sentence about the first header line with an unknown key, or NULL.
static const char *find_unknown_key(Arena *arena, const TestFile *f)
{
    static const char keys[] = "spec on expect steps args analyses warn advance";

    for (size_t i = 0; i < f->header.n; i++)
        if (!testfile_has_word(keys, f->header.at[i].key))
            return format_in(arena, "line %lu: unknown header line '%s'; it is one of: %s", (unsigned long)f->header.at[i].line,
                             f->header.at[i].key, keys);
    return NULL;
}

// Initialises c for f, whose text has been parsed, and reads its header `warn`.
const char *case_init(SmtCase *c, Session *s, const TestFile *f)
{
    const char *words = testfile_header(f, "warn"), *wrong;

    memset(c, 0, sizeof *c);
    c->s = s;
    c->f = f;
    buf_init(&c->why, &s->arena);
    if (f->error)
        return f->error;
    if ((wrong = find_wrong_parts(f)) != NULL || (wrong = find_unknown_key(&s->arena, f)) != NULL)
        return wrong;
    c->warn.word = ARENA_ARRAY(&s->arena, const char *, words ? strlen(words) + 1 : 1);
    while (words && *words) {                 // names as after -W: "extra no-dead-code"
        size_t n = strcspn(words, " \t");
        if (n)
            c->warn.word[c->warn.n++] = format_in(&s->arena, "%.*s", (int)n, words);
        words += n + (words[n] != '\0');
    }
    return diag_selection_error(&s->arena, &c->warn);
}

void case_compile(SmtCase *c, int opt_level)
{
    const TestFile *f = c->f;
    const char *analyses = testfile_header(f, "analyses");
    CompileOptions o;
    Compiled made;

    case_list_sources(c->s, f, &c->sources);
    memset(&o, 0, sizeof o);
    o.opt_level = opt_level;
    o.warnings = &c->warn;
    o.skip_analyses = !c->sources.in.app && c->warn.n == 0 && !(analyses && strcmp(analyses, "on") == 0);
    o.step = f->advance;
    compile_sources(c->s, &c->sources.in, &o, &made);
    c->script = ARENA_ARRAY(&c->s->arena, const Script *, f->part.n);
    for (size_t i = 0; i < f->part.n; i++)
        if (testfile_has_suffix(&f->part.at[i], c->sources.in.app ? ".app" : ".sm"))
            c->p = made.of[c->sources.input[i]].scripted, c->requirements = made.of[c->sources.input[i]].requirements;
        else if (testfile_has_suffix(&f->part.at[i], ".ss"))
            c->script[i] = made.of[c->sources.input[i]].script;
    c->has_runs = f->outcome != TEST_ERROR && c->s->diags.errors == 0 && case_has_part_of_kind(f, ".ss");
    if (f->outcome == TEST_ERROR && c->s->diags.errors == 0)
        buf_str(&c->why, "should not compile, but does\n");
}

// ---- running ----

static const char *outcome_text(ScriptOutcome o)
{
    switch (o) {
    case SCRIPT_PASSED: return "passed";
    case SCRIPT_FAILED: return "failed";
    case SCRIPT_NO_DATA: return "could not use its recorded data";
    case SCRIPT_ENDLESS: return "did not reach @stop";
    case SCRIPT_TIME_OVERFLOW: return "ran out of time";
    case SCRIPT_BROKEN: return "could not be run";
    case SCRIPT_CANCELLED: return "was cancelled";
    case SCRIPT_DIFFERENT: return "gave different values on different engines";
    }
    return "";
}

typedef struct CaseTrace { const Var **order; size_t n; Buf text; } CaseTrace;

static void add_to_trace(void *context, const ScriptStep *step)
{
    CaseTrace *t = context;

    script_trace_exact(&t->text, step, t->order, t->n);
}

// Runs the scripts in lock step on the engines and compares outcomes, report and trace.
bool case_run_scripts(SmtCase *c, Engine **engine, size_t engines, uint64_t max_steps)
{
    const TestFile *f = c->f;
    const TestPart *report_part = testfile_part(f, "report"), *trace_part = testfile_part(f, "trace");
    const bool must_pass = f->outcome == TEST_PASS;
    Arena *arena = &c->s->arena;
    CaseTrace trace = {report_order(arena, c->p), c->p->var.n, {0}};
    RequirementTotal *total = c->requirements ? ARENA_ARRAY(arena, RequirementTotal, c->requirements->at.n) : NULL;
    bool is_first = true, works = true, passed = true;

    for (size_t i = 0; i < f->part.n; i++) {
        ScriptOptions o = {.max_steps = f->steps ? f->steps : max_steps, .after_step = trace_part && is_first ? add_to_trace : NULL,
                           .context = &trace,
                           .requirements = c->requirements, .is_compared = report_part || trace_part};
        ScriptResult r;
        Buf report;

        if (!c->script[i])
            continue;
        buf_init(&report, arena);
        buf_init(&trace.text, arena);
        r = script_run(arena, &c->s->diags, c->script[i], engine, engines, &o);
        if (must_pass ? r.outcome != SCRIPT_PASSED
                      : r.outcome != SCRIPT_FAILED && r.outcome != SCRIPT_ENDLESS && r.outcome != SCRIPT_TIME_OVERFLOW &&
                        r.outcome != SCRIPT_NO_DATA)
            buf_printf(&c->why, "%s should %s, but %s\n", f->part.at[i].name, must_pass ? "pass" : "fail", outcome_text(r.outcome));
        works &= r.outcome != SCRIPT_BROKEN;
        passed &= r.outcome == SCRIPT_PASSED;
        if (total)
            requirement_add_run(total, c->requirements, &r);
        script_report(&r, c->p, &report);
        if (report_part && is_first)
            case_compare_report(report_part, &report, &c->why);
        if (trace_part && is_first)
            case_compare_trace(trace_part, &trace.text, &c->why);
        is_first = false;
    }
    if (total && passed)
        requirement_report_unjudged(&c->s->diags, c->requirements, total);
    return works;
}

// ---- diagnostics: missing and unexpected ----

// Whether the message, the label or a note of a diagnostic contains the text.
static bool mentions_text(const Diag *d, const char *text)
{
    if (strstr(d->text, text) || (d->label && strstr(d->label, text)))
        return true;
    for (size_t i = 0; i < d->notes.n; i++)
        if (strstr(d->notes.at[i].text, text))
            return true;
    return false;
}

static void add_unexpected(Buf *why, const Diag *d)
{
    buf_str(why, "not announced: ");
    if (d->span.src) {
        LineCol at = source_position(d->span.src, d->span.at);
        buf_printf(why, "%s:%lu:%lu: ", d->span.src->name, (unsigned long)at.line, (unsigned long)at.col);
    }
    buf_printf(why, "%s: %s", d->severity == DIAG_ERROR ? "error" : "warning", d->text);
    if (d->label)
        buf_printf(why, " (%s)", d->label);
    buf_printf(why, " [%s]\n", diag_code_and_name(d, why->arena));
}

// Compares the diagnostics with those that the case announces.
void case_check_diagnostics(SmtCase *c)
{
    const TestFile *f = c->f;
    Diags *diags = &c->s->diags;
    uint8_t *met = arena_alloc(&c->s->arena, f->expected.n);      // by index in f->expected: a diagnostic has been found for it

    diags_apply_allows(diags);
    diags_select(diags, &c->warn);
    for (size_t i = 0; i < diags->list.n; i++) {
        const Diag *d = diags->list.at[i];
        size_t j = 0;
        for (; j < f->expected.n; j++) {
            const TestExpected *e = &f->expected.at[j];
            if (!met[j] && d->span.src && d->span.src == c->sources.src[e->part] &&
                source_position(d->span.src, d->span.at).line == e->line && strcmp(diag_info[d->code].id, e->id) == 0 &&
                mentions_text(d, e->text))
                break;
        }
        if (j < f->expected.n)
            met[j] = 1;
        else
            add_unexpected(&c->why, d);
    }
    for (size_t j = 0; j < f->expected.n; j++) {
        const TestExpected *e = &f->expected.at[j];
        if (!met[j])
            buf_printf(&c->why, "announced, but not reported: %s:%lu: %s %s\n", f->part.at[e->part].name, (unsigned long)e->line, e->id,
                       e->text);
    }
}
