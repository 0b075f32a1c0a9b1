// SPDX-License-Identifier: Apache-2.0
// smc test: runs state scripts on a machine, .smt cases, and the cases of folders.
#include <string.h>

#include "compiler/base/path.h"
#include "compiler/cli/test.h"
#include "compiler/device/engine_c.h"

enum { FOLDER_DEPTH_MAX = 40 };       // nesting of folders: a link can form a cycle

// Returns the name of a case's suite in the results: the folder of its file.
const char *test_suite_name(Arena *arena, const char *path)
{
    const char *name = path_file_name(path);

    return name > path ? format_in(arena, "%.*s", (int)(name - path - path_is_separator(name[-1])), path) : ".";
}

static void add_error(TestRun *t, const char *path, const char *message, int code)
{
    const TestResult r = {.path = path, .suite = test_suite_name(t->arena, path), .status = TEST_BROKEN, .message = message, .code = code};

    vec_push(t->arena, &t->result, r);
}

// ---- cases and folders ----

static void refuse_folder(TestRun *t, const char *path, const char *why)
{
    cli_print_error(t->c, TEXT_cannot_read, cli_printable_name(t->arena, path), why);
    add_error(t, path, why, EXIT_ENVIRONMENT);
}

// Adds a case, or every case in a folder and its subfolders, to t->path.
static void collect_cases(TestRun *t, const char *path, int depth)
{
    const char *why = "folders are nested too deeply";
    char **names;
    size_t n;

    if (!os_is_folder(path)) {
        vec_push(t->arena, &t->path, path);
        return;
    }
    if (depth == FOLDER_DEPTH_MAX || !os_list_folder(path, &names, &n, &why)) {
        refuse_folder(t, path, why);
        return;
    }
    for (size_t i = 0; i < n; i++) {
        const char *inner = format_in(t->arena, "%s%s%s", path, path_ends_in_separator(path) ? "" : "/", names[i]);
        if (names[i][0] != '.' && (has_suffix(inner, ".smt") || os_is_folder(inner)))
            collect_cases(t, inner, depth + 1);
    }
    os_alloc(NULL, names, 0);
}

// Collects a case or folder that the call names; a folder without any case is an error.
static void collect_argument(TestRun *t, const char *path)
{
    size_t before = t->path.n + t->result.n;

    collect_cases(t, path, 0);
    if (t->path.n + t->result.n > before)
        return;
    cli_print_error(t->c, TEXT_no_case_in, path);
    add_error(t, path, "no .smt case is in it", EXIT_PROBLEM);
}

// ---- results ----

bool test_stdout_is_for_program(const Cli *c) { return c->given[OPT_TAP] || cli_is_standard_output(c, OPT_JUNIT); }

// Returns where the results go: standard output (1), or standard error (2) if another output goes to standard output.
int test_result_fd(const Cli *c)
{
    return cli_is_standard_output(c, OPT_TRACE) || cli_is_standard_output(c, OPT_COVERAGE_DATA) || cli_is_standard_output(c, OPT_COVERAGE_JSON) ||
           cli_is_standard_output(c, OPT_COVERAGE_LCOV) || cli_is_standard_output(c, OPT_TRACEABILITY) || cli_is_standard_output(c, OPT_MESSAGE_FILE) ? 2 : 1;
}

static bool all_engines(const Cli *c) { return c->given[OPT_ENGINE] && strcmp(c->value[OPT_ENGINE], "all") == 0; }

// Returns those of the engines `which` (a set of 1u << EngineKind) that cannot run here.  Only the engines of emitted C can be absent, because only
// they depend on a tool outside smc.
unsigned test_absent_engines(TestRun *t, unsigned which)
{
    which &= 1u << ENGINE_C | 1u << ENGINE_C_SOFT;
    if (which == 0 || (t->engines && !all_engines(t->c)) || (all_engines(t->c) && os_getenv("CC")))
        return 0;
    if (!t->c_was_tried)
        t->c_runs = engine_c_present(t->arena, &t->why_absent);
    t->c_was_tried = true;
    which = t->c_runs ? 0 : which;
    t->absent |= which;
    return which;
}

static void report_absent_engines(TestRun *t)
{
    for (unsigned i = 0; i < ENGINE_KINDS; i++)
        if (t->absent & 1u << i)
            cli_print_note(t->c, TEXT_engine_left_out, engine_name[i], t->why_absent);
}

// Writes the results in every requested form.  Returns EXIT_OK, or the exit code after a message.
static int write_results(TestRun *t, bool summary)
{
    OsOutput junit = {t->c->value[OPT_JUNIT], NULL, 0};
    const bool tap = t->c->given[OPT_TAP];
    Buf xml, out;

    buf_init(&out, t->arena);
    if (tap)
        test_write_tap(t, &out);
    else if (summary && !test_stdout_is_for_program(t->c))
        test_write_summary(t, &out);
    if (!tap && !test_stdout_is_for_program(t->c)) {
        test_requirements_write(t, &out);
        buf_str(&out, t->traceability ? t->traceability : "");
    }
    if (!cli_print(t->c, tap ? 1 : test_result_fd(t->c), &out))
        return EXIT_ENVIRONMENT;
    if (!t->c->given[OPT_JUNIT])
        return EXIT_OK;
    buf_init(&xml, t->arena);
    test_write_junit(t, &xml);
    junit.bytes = buf_text(&xml);
    junit.n = xml.n;
    return cli_write_outputs(t->c, &junit, 1);
}

// Returns the most serious result: a bug of smc, then a fault of the environment, then a problem in the user's input.
static int exit_code(const TestRun *t)
{
    int code = t->code;

    for (size_t i = 0; i < t->result.n; i++)
        if (code < t->result.at[i].code)
            code = t->result.at[i].code;
    return code;
}

// ---- the command ----

// Whether an argument is a script. "-" is one if the command line also names a machine.
bool test_is_script(const Cli *c, const char *path)
{
    bool has_machine = false;

    if (strcmp(path, "-") != 0)
        return has_suffix(path, ".ss");
    for (size_t i = 0; i < c->files; i++)
        has_machine |= has_suffix(c->file[i], ".sm") || has_suffix(c->file[i], ".app");
    return has_machine;
}

bool test_is_requirements(const char *path) { return has_suffix(path, ".rq"); }

typedef struct Files { size_t machines, scripts, cases, requirements, data, standard_inputs; const char *machine; } Files;

static Files classify_files(const Cli *c)
{
    Files f = {0};

    for (size_t i = 0; i < c->files; i++) {
        const bool standard = strcmp(c->file[i], "-") == 0, script = test_is_script(c, c->file[i]), data = test_is_coverage_data(c->file[i]);
        const bool machine = !script && !data && (standard || has_suffix(c->file[i], ".sm") || has_suffix(c->file[i], ".app"));
        f.standard_inputs += standard;
        f.machines += machine;
        f.scripts += script;
        f.requirements += test_is_requirements(c->file[i]);
        f.data += data;
        f.cases += !machine && !script && !data && !test_is_requirements(c->file[i]);
        f.machine = machine ? c->file[i] : f.machine;
    }
    return f;
}

static const char accepted[] = "a machine (.sm) or an application (.app), state scripts (.ss), requirements (.rq), test cases (.smt) and folders of test cases";

static int check_kinds(Cli *c)
{
    for (size_t i = 0; i < c->files; i++) {
        const char *path = c->file[i];
        if (has_suffix(path, ".sv"))
            return cli_usage_error(c, TEXT_vector_with_sv, path);
        if (has_suffix(path, ".app") && c->given[OPT_SV])
            return cli_usage_error(c, TEXT_app_names_vector, path);
        if (!has_suffix(path, ".sm") && !has_suffix(path, ".app") && !has_suffix(path, ".ss") && !has_suffix(path, ".smt") &&
            !test_is_requirements(path) && !test_is_coverage_data(path) && strcmp(path, "-") != 0 && !os_is_folder(path))
            return cli_usage_error(c, TEXT_test_kind, path, accepted);
    }
    return EXIT_OK;
}

static int check_arguments(Cli *c, const Files *f)
{
    static const struct { OptionId id; const char *spelling; } other[] = {
        {OPT_JUNIT, "--junit"}, {OPT_TRACE, "--trace"}, {OPT_MESSAGE_FILE, "--message-file"}, {OPT_COVERAGE_DATA, "--coverage-data"},
        {OPT_COVERAGE_JSON, "--coverage-json"}, {OPT_COVERAGE_LCOV, "--coverage-lcov"}, {OPT_TRACEABILITY, "--traceability"}};

    if (c->files == 0)
        return cli_usage_error(c, TEXT_test_what);
    if (check_kinds(c) != EXIT_OK)
        return EXIT_USAGE;
    if (f->standard_inputs > 1)
        return cli_usage_error(c, TEXT_test_one_input);
    if (f->machines > 1)
        return cli_usage_error(c, TEXT_test_one_machine);
    if (f->data && (!f->machines || !test_coverage_is_wanted(c)))
        return cli_usage_error(c, TEXT_coverage_for_data);
    if (test_coverage_is_wanted(c) && !f->machines)
        return cli_usage_error(c, TEXT_coverage_of_case);
    if (f->machines && !f->scripts && f->cases)
        return cli_usage_error(c, TEXT_test_folder_of_scripts, f->machine);
    if (f->machines && !f->scripts && !f->data)
        return cli_usage_error(c, TEXT_test_no_script, f->machine, f->machine);
    if (f->scripts && !f->machines)
        return cli_usage_error(c, TEXT_test_no_machine);
    if (c->given[OPT_SET] && !f->machines)
        return cli_usage_error(c, TEXT_set_of_case);
    if (f->requirements && !f->machines)
        return cli_usage_error(c, TEXT_test_requirements_alone);
    for (size_t i = 0; i < sizeof other / sizeof *other && c->given[OPT_TAP]; i++)
        if (cli_is_standard_output(c, other[i].id))
            return cli_usage_error(c, TEXT_both_to_stdout, "--tap", other[i].spelling);
    return EXIT_OK;
}

static int check_trace(Cli *c, const Files *f)
{
    const bool is_exact = c->given[OPT_TRACE_FORMAT] && strcmp(c->value[OPT_TRACE_FORMAT], "exact") == 0;

    if (c->given[OPT_TRACE_FORMAT] && !is_exact && strcmp(c->value[OPT_TRACE_FORMAT], "csv") != 0)
        return cli_usage_error(c, TEXT_trace_formats, c->value[OPT_TRACE_FORMAT]);
    if (!c->given[OPT_TRACE] && (c->given[OPT_TRACE_FORMAT] || c->given[OPT_TRACE_ELEMENTS]))
        return cli_usage_error(c, TEXT_trace_required, c->given[OPT_TRACE_FORMAT] ? "--trace-format" : "--trace-elements");
    if (c->given[OPT_TRACE] && !f->scripts)
        return cli_usage_error(c, TEXT_trace_of_case);
    if (is_exact && f->scripts > 1)
        return cli_usage_error(c, TEXT_exact_one_script);
    if (is_exact && c->given[OPT_TRACE_ELEMENTS])
        return cli_usage_error(c, TEXT_exact_has_all);
    return EXIT_OK;
}

static int read_options(TestRun *t)
{
    Cli *c = t->c;
    CompileOptions unused;

    t->max_steps = 1000000;
    if (!cli_read_limit(c, OPT_MAX_STEPS, "--max-steps", UINT64_MAX, &t->max_steps))
        return EXIT_USAGE;
    if (c->given[OPT_SEED] && (!cli_read_whole(c->value[OPT_SEED], &t->seed) || t->seed > SCRIPT_SEED_MAX))
        return cli_usage_error(c, TEXT_seed_value, c->value[OPT_SEED]);
    if (c->given[OPT_ENGINE] && (t->engines = engines_named(c->value[OPT_ENGINE])) == 0)
        return cli_usage_error(c, TEXT_engine_values, c->value[OPT_ENGINE]);
    return cli_compile_options(c, &unused) ? EXIT_OK : EXIT_USAGE;
}

// Replaces other names of standard input, such as /dev/stdin, with "-".
static void normalize_standard_input_names(Cli *c)
{
    for (size_t i = 0; i < c->files; i++)
        if (os_find_descriptor(c->file[i]) == 0)
            c->file[i] = "-";
}

int cmd_test(Cli *c)
{
    TestRun t = {.c = c, .arena = &c->session.arena};
    Files f;
    int code, ran = EXIT_OK, written;

    normalize_standard_input_names(c);
    f = classify_files(c);
    if ((code = check_arguments(c, &f)) != EXIT_OK || (code = check_trace(c, &f)) != EXIT_OK || (code = test_coverage_check_options(c)) != EXIT_OK ||
        (code = test_traceability_check_options(c, f.machine, f.requirements)) != EXIT_OK || (code = read_options(&t)) != EXIT_OK)
        return code;
    if (c->given[OPT_TRACE] && f.cases)
        cli_print_note(c, TEXT_cases_not_traced, f.machine);
    if (f.machine && (ran = test_run_machine(&t, f.machine)) == EXIT_USAGE)
        return ran;
    for (size_t i = 0; i < c->files; i++)
        if (!test_is_script(c, c->file[i]) && !test_is_requirements(c->file[i]) && !test_is_coverage_data(c->file[i]) && c->file[i] != f.machine)
            collect_argument(&t, c->file[i]);
    test_run_cases(&t, t.path.at, t.path.n);
    report_absent_engines(&t);
    written = write_results(&t, f.cases > 0 || f.scripts > 1);
    code = exit_code(&t);
    code = code > ran ? code : ran;
    return code != EXIT_OK ? code : written;
}
