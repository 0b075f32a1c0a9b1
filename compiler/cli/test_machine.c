// SPDX-License-Identifier: Apache-2.0
// Compiles a machine and its scripts, runs the scripts and reports the results.
#include <string.h>

#include "compiler/cli/setting.h"
#include "compiler/cli/test.h"

typedef struct MachineTest {
    TestRun *t;
    const char *path;         // path of the machine's source
    double begin;             // start time of the current script
    const Program *p;         // the machine, compiled for scripts
    EngineSet engines;
    const Requirements *requirements;         // NULL: none
    RequirementTable *table;
    ScriptSettings setting;          // the values of --set
    const Source **ss;        // by argument: the scripts, each read once; NULL: not a script, or unreadable
    const char **problem;     // by argument: why a script cannot be read
    bool *is_part;            // by argument: another script includes it, so it does not run by itself
    Buf report;               // report of the last script: what it printed, and then the final values
    size_t printed;           // length of what the script printed, in bytes of `report`
    TestTrace *trace;         // the trace that --trace requests; or NULL
    TestCoverage *coverage;   // the coverage that options ask for; or NULL
    Traceability *matrix;     // results of --traceability; or NULL
    bool has_early_end;       // some script did not run, or has not reached a @stop
    VEC(Span) explained;      // conditions of requirements whose violation is printed in full
} MachineTest;

// Returns a script's name in results: standard input has the name that diagnostics use.
static const char *result_name(const char *path) { return strcmp(path, "-") == 0 ? "<stdin>" : path; }

static void add_result(MachineTest *m, const char *path, TestStatus status, const char *message, int code)
{
    const TestResult r = {.path = path, .suite = m->path, .status = status, .message = message, .code = code,
                          .seconds = os_seconds() - m->begin, .printed = "", .seed = "", .requirements = ""};

    vec_push(m->t->arena, &m->t->result, r);
}

// Adds an error for every script when none of them can run.
static void add_errors(MachineTest *m, const char *message, int code)
{
    Cli *c = m->t->c;
    const size_t before = m->t->result.n;

    for (size_t i = 0; i < c->files; i++)
        if (test_is_script(c, c->file[i]) && !m->is_part[i]) {
            add_result(m, result_name(c->file[i]), TEST_BROKEN, message, code);
            m->t->result.at[m->t->result.n - 1].did_not_run = true;
            m->begin = os_seconds();          // the time before the first script is part of the first script's duration only
        }
    if (m->t->result.n == before)             // the call names only files of counts
        add_result(m, result_name(m->path), TEST_BROKEN, message, code);
}

// ---- one script ----

// Shortens the report of a requirement that an earlier script has violated, whose report has the steps before. The first note is the script.
static void shorten_violation(MachineTest *m, Diag *d, const ScriptResult *r)
{
    const Span script = d->notes.at[0].span;
    bool is_explained = false;

    for (size_t i = 0; i < m->explained.n; i++)
        is_explained = is_explained || (m->explained.at[i].src == d->span.src && m->explained.at[i].at == d->span.at);
    if (!is_explained) {
        vec_push(m->t->arena, &m->explained, d->span);
        return;
    }
    d->notes.n = 0;
    diag_note(&m->t->c->session.diags, d, script, DIAG_note_violated_in);
    if (r->is_random)
        diag_note(&m->t->c->session.diags, d, (Span){0}, DIAG_note_seed, format_in(m->t->arena, "%llu", (unsigned long long)r->seed));
}

static void shorten_violations(MachineTest *m, const ScriptResult *r)
{
    const Diags *d = &m->t->c->session.diags;

    for (size_t i = 0; i < d->list.n; i++)
        if (d->list.at[i]->code == DIAG_requirement_violated)
            shorten_violation(m, d->list.at[i], r);
}

// Returns the session's diagnostics as the message of a result.
static const char *render_diagnostics(const TestRun *t)
{
    DiagStyle plain = {false, 20};
    Buf b;

    buf_init(&b, t->arena);
    diags_apply_allows(&t->c->session.diags);
    diags_select(&t->c->session.diags, &t->c->warn);
    diags_sort(&t->c->session.diags);
    diags_fold(&t->c->session.diags);
    diags_render_text(&t->c->session.diags, &plain, &b);
    return buf_text(&b);
}

// Prints the session's diagnostics and stores them for the result's message.
int test_report_diagnostics(TestRun *t, const char **text)
{
    *text = render_diagnostics(t);
    return cli_print_diagnostics(t->c);
}

static int exit_code_of(ScriptOutcome o)
{
    switch (o) {
    case SCRIPT_PASSED: return EXIT_OK;
    case SCRIPT_FAILED: case SCRIPT_ENDLESS: case SCRIPT_TIME_OVERFLOW: case SCRIPT_NO_DATA: return EXIT_PROBLEM;
    case SCRIPT_BROKEN: case SCRIPT_DIFFERENT: case SCRIPT_CANCELLED: return EXIT_INTERNAL;      // smc test cancels no run
    }
    return EXIT_INTERNAL;
}

// Returns the requirements that the script has tested, each once: "R7 R8"; "" if it tested none of them. First those of its asserts, then those of
// `what`, which can be NULL.
static const char *list_requirements(Arena *arena, const Script *s, const ScriptResult *r, const Requirements *what)
{
    Map seen = {arena, NULL, NULL, 0, 0};
    Buf out;

    buf_init(&out, arena);
    for (size_t i = 0; i < s->section.n; i++)
        for (size_t k = 0; k < s->section.at[i].item.n; k++) {
            const ScriptItem *item = s->section.at[i].item.at[k];
            for (size_t n = 0; n < item->asserts.n; n++) {
                const ScriptAssert *a = &item->asserts.at[n];
                const Str name = a->remark ? a->remark->requirement : NULL;
                if (!name || map_find(&seen, name) || (a->kind != SCRIPT_FAIL && !r->evaluated[item->first_assert + n]))
                    continue;
                map_put(&seen, name, (void *)name);
                buf_printf(&out, "%s%s", out.n ? " " : "", name->text);
            }
        }
    for (size_t i = 0; what && i < what->at.n; i++)
        if (r->requirement[i].judged && !map_find(&seen, what->at.at[i].id))
            buf_printf(&out, "%s%s", out.n ? " " : "", what->at.at[i].id->text);
    return buf_text(&out);
}

static void run_script(MachineTest *m, const char *path, const Script *s)
{
    TestRun *t = m->t;
    ScriptOptions o = {.max_steps = t->max_steps, .seed = t->c->given[OPT_SEED] ? &t->seed : NULL,
                       .after_step = m->trace ? test_trace_step : NULL, .context = m->trace,
                       .setting = m->setting.at, .settings = m->setting.n, .requirements = m->requirements};
    ScriptResult r;
    int code, reported;
    const char *message;

    if (m->trace)
        test_trace_script(m->trace, path);
    r = script_run(t->arena, &t->c->session.diags, s, m->engines.at, m->engines.n, &o);
    code = exit_code_of(r.outcome);
    m->has_early_end |= !script_has_stopped(&r);
    test_requirements_add(m->table, s, &r);
    if (m->matrix)
        traceability_add_run(m->matrix, path, s, &r);
    buf_str(&m->report, r.printed);
    m->printed = m->report.n;
    script_report(&r, m->p, &m->report);
    message = render_diagnostics(t);
    if (cli_prints_text(t->c))
        shorten_violations(m, &r);
    reported = cli_print_diagnostics(t->c);
    if (code == EXIT_OK)
        code = reported;
    add_result(m, path, code == EXIT_OK ? TEST_PASSED : code == EXIT_PROBLEM ? TEST_FAILED : TEST_BROKEN, message, code);
    m->t->result.at[m->t->result.n - 1].printed = r.printed;
    m->t->result.at[m->t->result.n - 1].seed = r.is_random ? format_in(t->arena, "%llu", (unsigned long long)r.seed) : "";
    m->t->result.at[m->t->result.n - 1].requirements = list_requirements(t->arena, s, &r, m->requirements);
}

// Runs the script at this index of the arguments and adds its result.
static void test_script(MachineTest *m, size_t argument)
{
    const char *const path = result_name(m->t->c->file[argument]);
    const Source *const src = m->ss[argument];
    const char *message;
    Script *s;

    m->report.n = m->printed = 0;
    m->begin = os_seconds();
    if (!src) {
        test_trace_left_out(m->trace, path);
        m->has_early_end = true;
        add_result(m, path, TEST_BROKEN, m->problem[argument], EXIT_ENVIRONMENT);
        return;
    }
    if ((s = session_script(&m->t->c->session, src, m->p)) != NULL) {
        if (m->requirements)
            session_check_requirements_of_script(&m->t->c->session, m->requirements, s);
        vec_push(m->t->arena, &m->t->script, s);
        run_script(m, path, s);
        return;
    }
    m->has_early_end = true;
    test_report_diagnostics(m->t, &message);
    test_trace_left_out(m->trace, path);
    add_result(m, path, TEST_BROKEN, message, EXIT_PROBLEM);
}

// Reads the machine, the state vector and the scripts.  If a script cannot be read, m->problem has the reason and the others still run.
static int read_inputs(MachineTest *m, const char *path, CompileInput *in)
{
    Cli *c = m->t->c;
    const bool is_app = has_suffix(path, ".app");
    int code;

    memset(in, 0, sizeof *in);
    in->at = ARENA_ARRAY(m->t->arena, CompileSource, c->files + 1);
    m->problem = ARENA_ARRAY(m->t->arena, const char *, c->files);
    m->ss = ARENA_ARRAY(m->t->arena, const Source *, c->files);
    in->at[in->n++] = (CompileSource){.text = cli_read_source(c, path), .kind = is_app ? FILE_APP : FILE_SM};
    if (!in->at[0].text || (c->given[OPT_SV] && (in->vector = cli_read_source(c, c->value[OPT_SV])) == NULL))
        return EXIT_ENVIRONMENT;
    if ((code = cli_read_bindings(c, !is_app, &in->instance)) != EXIT_OK)
        return code;
    if (is_app)
        cli_load_app(c, in);
    for (size_t i = 0; i < c->files; i++)
        if (test_is_requirements(c->file[i])) {
            in->at[in->n] = (CompileSource){.text = cli_read_source(c, c->file[i]), .kind = FILE_RQ};
            if (!in->at[in->n++].text)
                return EXIT_ENVIRONMENT;
        } else if (test_is_script(c, c->file[i])) {
            if ((m->ss[i] = cli_read_source(c, c->file[i])) != NULL)
                in->at[in->n++] = (CompileSource){.text = m->ss[i], .kind = FILE_SS};
            else
                m->problem[i] = c->last_error;
        }
    return EXIT_OK;
}

static int compile_machine(MachineTest *m, const char *path)
{
    CompileInput in;
    CompileOptions o;
    Compiled made;
    int code;

    if (!cli_compile_options(m->t->c, &o))
        return EXIT_USAGE;
    if ((code = read_inputs(m, path, &in)) != EXIT_OK)
        return code;
    o.scripts_later = true;
    compile_sources(&m->t->c->session, &in, &o, &made);
    for (size_t i = 0; i < m->t->c->files; i++)
        for (size_t k = 0; k < in.n; k++)
            m->is_part[i] |= made.of[k].is_included && in.at[k].text == m->ss[i];
    m->p = made.of[0].scripted;
    m->requirements = made.of[0].requirements;
    return m->p ? EXIT_OK : EXIT_PROBLEM;
}

// Opens the engines. If this fails, no script runs and the result of each is an error.
static bool open_engines(MachineTest *m)
{
    TestRun *t = m->t;
    unsigned which = t->engines ? t->engines : 1u << ENGINE_VM;
    const char *message;
    int code;

    which &= ~test_absent_engines(t, which);
    if (engines_open(&m->engines, &t->c->session, m->p, which, options_opt_level(t->c)))
        return true;
    cli_print_error(t->c, TEXT_sentence, m->engines.error);
    code = test_report_diagnostics(t, &message) == EXIT_PROBLEM ? EXIT_PROBLEM : EXIT_ENVIRONMENT;        // EXIT_PROBLEM: the image is too large
    add_errors(m, format_in(t->arena, "%s\n%s", m->engines.error, message), code);
    return false;
}

// Whether the call names one script, and no case.
static bool is_lone_script(const Cli *c)
{
    size_t others = 0;

    for (size_t i = 0; i < c->files; i++)
        others += !test_is_requirements(c->file[i]);
    return others == 2;
}

// Begins to measure coverage if an option asks for it.  If this fails, no script runs and the result of each is an error.
static bool open_coverage(MachineTest *m)
{
    const int code = test_coverage_open(m->t, m->p, &m->engines, &m->coverage);

    if (code != EXIT_OK)
        add_errors(m, m->t->c->last_error, code);
    return code == EXIT_OK;
}

// Prints the lines that the last script printed, and its final values if they are wanted.
static int print_report(MachineTest *m, const char *path)
{
    Cli *c = m->t->c;
    const TestResult *last = &m->t->result.at[m->t->result.n - 1];
    const bool has_values = c->given[OPT_VERBOSE] || (is_lone_script(c) && last->status == TEST_PASSED);
    const size_t shown = has_values ? m->report.n : m->printed;
    Buf out;

    buf_init(&out, m->t->arena);
    if (!is_lone_script(c))
        buf_printf(&out, "%s:\n", path);
    buf_put(&out, buf_text(&m->report), shown);
    if (test_stdout_is_for_program(c) || shown == 0)
        return EXIT_OK;
    return cli_print(c, test_result_fd(c), &out) ? EXIT_OK : EXIT_ENVIRONMENT;
}

// Ends the table of requirements, and prints the diagnostics about them.
static int end_requirements(MachineTest *m, int code)
{
    const char *unused;

    test_requirements_end(m->table, code == EXIT_OK && !m->has_early_end);
    return test_report_diagnostics(m->t, &unused);
}

static int test_scripts(MachineTest *m)
{
    Cli *c = m->t->c;
    int code = test_trace_open(m->t, m->p, m->requirements, &m->trace), closed;

    m->table = test_requirements_begin(m->t, m->requirements);
    m->matrix = test_traceability_begin(m->t, m->p, m->requirements);
    if (code == EXIT_ENVIRONMENT)
        add_errors(m, c->last_error, code);
    for (size_t i = 0; i < c->files && code == EXIT_OK; i++)
        if (test_is_script(c, c->file[i]) && !m->is_part[i]) {
            test_script(m, i);
            code = print_report(m, result_name(c->file[i]));
        }
    closed = test_trace_close(m->trace);
    code = code == EXIT_OK ? closed : code;
    if (m->requirements && (closed = end_requirements(m, code)) != EXIT_OK && code == EXIT_OK)
        code = m->t->code = closed;
    if (code == EXIT_OK)
        code = test_coverage_finish(m->t, m->coverage, m->path);
    return code == EXIT_OK ? test_traceability_finish(m->t, m->matrix, m->path) : code;
}

int test_run_machine(TestRun *t, const char *path)
{
    MachineTest m = {.t = t, .path = path, .begin = os_seconds()};
    const char *message;
    int code, compiled, reported;

    buf_init(&m.report, t->arena);
    m.is_part = ARENA_ARRAY(t->arena, bool, t->c->files);
    compiled = compile_machine(&m, path);
    reported = test_report_diagnostics(t, &message);
    code = compiled == EXIT_OK ? reported : compiled;
    if (code != EXIT_OK)
        add_errors(&m, compiled == EXIT_ENVIRONMENT ? t->c->last_error : message, code);
    else if ((code = settings_read(t->c, m.p, &m.setting)) != EXIT_OK)
        add_errors(&m, t->c->last_error, code);
    else if (open_engines(&m) && open_coverage(&m))
        code = test_scripts(&m);
    engines_close(&m.engines);
    return code == EXIT_PROBLEM ? EXIT_OK : code;
}
