// SPDX-License-Identifier: Apache-2.0
// smc test --coverage: measures while the scripts run, adds counts of earlier runs, and writes and judges the result.
#include <string.h>

#include "compiler/cli/test.h"
#include "compiler/cover/cover.h"

// The coverage of a machine, or of the machines of an application.
struct TestCoverage {
    Cover **machine;
    size_t machines;
    const Program *p;
};

typedef struct Demand { bool is_set; double percent; } Demand;       // the percentage that --min-coverage demands of one kind of coverage

// The kinds of --min-coverage: those of coverage by their numbers, and requirements, which test_traceability.c judges.
enum { DEMAND_REQUIREMENTS = COVER_KIND_COUNT, DEMANDS };

bool test_coverage_is_wanted(const Cli *c)
{
    return c->given[OPT_COVERAGE] || c->given[OPT_MIN_COVERAGE] || c->given[OPT_COVERAGE_DATA] || c->given[OPT_COVERAGE_JSON] || c->given[OPT_COVERAGE_LCOV];
}

bool test_is_coverage_data(const char *path) { return has_suffix(path, ".cov"); }

// ---- --min-coverage ----

static const char *demand_name(int kind) { return kind == DEMAND_REQUIREMENTS ? "requirements" : cover_kind_name[kind]; }

// Reads `kind:percent,kind:percent` into demand, by kind.  Returns false if it has another form.
static bool read_demands(const char *text, Demand *demand)
{
    for (;; text++) {
        const size_t n = strcspn(text, ":");
        int kind = 0;
        while (kind < DEMANDS && (strlen(demand_name(kind)) != n || strncmp(demand_name(kind), text, n) != 0))
            kind++;
        if (kind == DEMANDS || text[n] != ':' || (text = cli_read_percent(text + n + 1, &demand[kind].percent)) == NULL)
            return false;
        demand[kind].is_set = true;
        if (*text != ',')
            return *text == '\0';
    }
}

static const char *list_kinds(Cli *c)
{
    Buf out;

    buf_init(&out, &c->session.arena);
    for (int k = 0; k < DEMANDS; k++)
        buf_printf(&out, "%s%s", k == 0 ? "" : k + 1 < DEMANDS ? ", " : " and ", demand_name(k));
    return buf_text(&out);
}

// Whether --min-coverage demands a percentage of tested requirements.
bool test_coverage_demands_requirements(const Cli *c, double *percent)
{
    Demand demand[DEMANDS] = {{false, 0}};

    if (!c->given[OPT_MIN_COVERAGE] || !read_demands(c->value[OPT_MIN_COVERAGE], demand))
        return false;
    *percent = demand[DEMAND_REQUIREMENTS].percent;
    return demand[DEMAND_REQUIREMENTS].is_set;
}

int test_coverage_check_options(Cli *c)
{
    Demand demand[DEMANDS] = {{false, 0}};

    if (c->given[OPT_MIN_COVERAGE] && !read_demands(c->value[OPT_MIN_COVERAGE], demand))
        return cli_usage_error(c, TEXT_min_coverage_form, list_kinds(c));
    if (c->given[OPT_COVERAGE_DATA] && !test_is_coverage_data(c->value[OPT_COVERAGE_DATA]) && strcmp(c->value[OPT_COVERAGE_DATA], "-") != 0 &&
        !os_is_special(c->value[OPT_COVERAGE_DATA]))
        return cli_usage_error(c, TEXT_coverage_data_name, c->value[OPT_COVERAGE_DATA]);
    return EXIT_OK;
}

// Whether coverage of a kind is below the demanded percentage.  A machine with nothing of this kind meets any demand.
static bool is_too_low(CoverTotal t, Demand d)
{
    return d.is_set && 100.0 * t.covered < d.percent * t.possible;
}

// Reports a kind whose coverage is too low, with a note for each place in the source that is not covered.
static void report_too_low(TestRun *t, const TestCoverage *v, const Cover *c, int kind, double percent)
{
    Diags *d = &t->c->session.diags;
    const CoverTotal total = cover_total(c, (CoverKind)kind);
    const CoverGaps gaps = cover_list_gaps(c, 1u << kind);
    const char *of = v->p->joint ? format_in(t->arena, " in '%s'", c->p->name->text) : "";
    const char *has = format_in(t->arena, "%lu of %lu%s", (unsigned long)total.covered, (unsigned long)total.possible, of);
    Diag *low = NULL;

    for (uint32_t i = 0; i < gaps.n && !gaps.at[i].is_impossible; i++) {
        if (low == NULL)
            low = diag_report(d, DIAG_coverage_too_low, gaps.at[i].span, cover_kind_name[kind], has, format_in(t->arena, "%.6g", percent));
        diag_note(d, low, gaps.at[i].span, DIAG_note_not_covered, gaps.at[i].text);
    }
}

// Compares the coverage with each limit of --min-coverage, and adds the comparison to the results of the tests.
static void check_min_coverage(TestRun *t, const TestCoverage *v, const char *machine)
{
    Demand demand[DEMANDS] = {{false, 0}};
    TestResult r = {.path = format_in(t->arena, "coverage of %s", machine), .suite = machine, .status = TEST_PASSED, .message = "", .is_limit = true};

    if (!t->c->given[OPT_MIN_COVERAGE])
        return;
    read_demands(t->c->value[OPT_MIN_COVERAGE], demand);
    for (size_t i = 0; i < v->machines; i++)
        for (int k = 0; k < COVER_KIND_COUNT; k++)
            if (is_too_low(cover_total(v->machine[i], (CoverKind)k), demand[k]))
                report_too_low(t, v, v->machine[i], k, demand[k].percent);
    r.code = test_report_diagnostics(t, &r.message);
    if (r.code != EXIT_OK)
        r.status = TEST_FAILED;
    vec_push(t->arena, &t->result, r);
}

// ---- counts of earlier runs ----

// Adds the counts in a .cov file of an earlier call. Returns EXIT_OK, or the exit code after a message.
static int add_coverage_file(TestRun *t, const TestCoverage *v, const char *path)
{
    const Source *text = cli_read_source(t->c, path);
    const char *wrong;

    if (!text)
        return EXIT_ENVIRONMENT;
    if ((wrong = cover_add_data(v->machine, v->machines, text->text, text->len)) == NULL)
        return EXIT_OK;
    cli_print_error(t->c, TEXT_coverage_refused, cli_printable_name(t->arena, path), wrong);
    return EXIT_PROBLEM;
}

// Opens an engine that counts coverage while it runs. For an application, it consists of one engine for each machine.
static Engine *open_engine(Arena *arena, TestCoverage *v)
{
    v->machines = engine_machines(v->p);
    v->machine = ARENA_ARRAY(arena, Cover *, v->machines);
    for (size_t i = 0; i < v->machines; i++)
        v->machine[i] = cover_new(arena, engine_program(v->p, i));
    return cover_open_engines(arena, v->p, v->machine);
}

// Adds an engine that measures coverage to the set, and reads the counts of earlier runs. *coverage is NULL if no option asks for it.
int test_coverage_open(TestRun *t, const Program *p, EngineSet *engines, TestCoverage **coverage)
{
    TestCoverage *v = ARENA_NEW(t->arena, TestCoverage);
    int code = EXIT_OK;

    *coverage = NULL;
    if (!test_coverage_is_wanted(t->c))
        return EXIT_OK;
    v->p = p;
    engines->at[engines->n++] = open_engine(t->arena, v);
    for (size_t i = 0; i < t->c->files && code == EXIT_OK; i++)
        if (test_is_coverage_data(t->c->file[i]))
            code = add_coverage_file(t, v, t->c->file[i]);
    *coverage = v;
    return code;
}

// ---- the end ----

static void write_data(const TestCoverage *v, Buf *out)
{
    for (size_t i = 0; i < v->machines; i++)
        cover_write_data(v->machine[i], out);
}

// Writes the JSON object of a machine.  For an application, writes an object that contains the objects of its machines.
static void write_json(const TestCoverage *v, Buf *out)
{
    if (v->p->joint)
        buf_printf(out, "{\"smc-coverage\":1,\"application\":\"%s\",\"machines\":[\n", v->p->name->text);
    for (size_t i = 0; i < v->machines; i++) {
        buf_str(out, i ? "," : "");
        cover_write_json(v->machine[i], out);
    }
    if (v->p->joint)
        buf_str(out, "]}\n");
}

static void write_lcov(const TestCoverage *v, Buf *out)
{
    for (size_t i = 0; i < v->machines; i++)
        cover_write_lcov(v->machine[i], out);
}

// Writes the files that options name.
static int write_files(TestRun *t, const TestCoverage *v)
{
    static const struct { OptionId id; void (*write)(const TestCoverage *v, Buf *out); } form[] = {
        {OPT_COVERAGE_DATA, write_data}, {OPT_COVERAGE_JSON, write_json}, {OPT_COVERAGE_LCOV, write_lcov}};
    OsOutput file[sizeof form / sizeof *form];
    size_t n = 0;

    for (size_t i = 0; i < sizeof form / sizeof *form; i++)
        if (t->c->given[form[i].id]) {
            Buf out;
            buf_init(&out, t->arena);
            form[i].write(v, &out);
            file[n++] = (OsOutput){t->c->value[form[i].id], buf_text(&out), out.n};
        }
    return cli_write_outputs(t->c, file, n);
}

// After the scripts: writes the coverage, and compares it with --min-coverage.
int test_coverage_finish(TestRun *t, TestCoverage *v, const char *machine)
{
    Buf out;
    int code;

    if (!v)
        return EXIT_OK;
    for (size_t i = 0; i < v->machines; i++)
        cover_settle(v->machine[i]);
    if ((code = write_files(t, v)) != EXIT_OK)
        return code;
    buf_init(&out, t->arena);
    for (size_t i = 0; i < v->machines && t->c->given[OPT_COVERAGE]; i++)
        cover_write_text(v->machine[i], &out);
    if (!test_stdout_is_for_program(t->c) && !cli_print(t->c, test_result_fd(t->c), &out))
        return EXIT_ENVIRONMENT;
    check_min_coverage(t, v, machine);
    return EXIT_OK;
}
