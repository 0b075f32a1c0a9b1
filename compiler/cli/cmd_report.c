// SPDX-License-Identifier: Apache-2.0
// smc report: one page about a machine for a design review. Findings are those of `smc check` with the same files. Costs are
// those of the image that `smc build` makes. The scripts run on the VM, on an image with names.
#include "compiler/base/os_signal.h"
#include "compiler/cli/deps.h"
#include "compiler/cli/report_parts.h"
#include "compiler/cli/runs.h"

typedef void WriteReport(const Doc *d, Buf *out);

static const CliFormat formats[] = {
    {"html", {".html", ".htm", NULL}, "a browser"}, {"text", {".txt", NULL, NULL}, NULL}, {"json", {".json", NULL, NULL}, NULL}};
enum {
    FORMATS = sizeof formats / sizeof *formats,
    MOST_SECONDS = 10000000       // of --time: about 116 days
};

// Prints which scripts have failed, before the parts that take time.  Returns whether one has.
static bool print_failed(Cli *c, const Report *r)
{
    bool failed = false;

    for (size_t i = 0; i < r->runs; i++)
        if (!r->run[i].script || r->run[i].result.outcome != SCRIPT_PASSED) {
            cli_print_error(c, TEXT_run_failed, r->run[i].name);
            failed = true;
        }
    return failed;
}

static void print_unfinished(Cli *c, const Report *r)
{
    for (size_t i = 0; i < r->unfinished.n; i++)
        cli_print_note(c, TEXT_report_unfinished, r->unfinished.at[i]);
}

// Whether a search has found a run that violates a requirement.
static bool is_violated(const Report *r)
{
    bool any = false;

    for (uint32_t i = 0; r->proofs && i < r->proofs->n && !any; i++)
        any = r->proofs->of[i].verdict == PROVE_VIOLATED;
    return any;
}

// Checks the arguments that are not about the scripts.  Sets the index of the format.  Returns EXIT_OK, or EXIT_USAGE after a message.
static int check_options(Cli *c, CompileOptions *o, OsOutput *file, size_t *format)
{
    if (!cli_choose_format(c, formats, FORMATS, format) || !cli_compile_options(c, o))
        return EXIT_USAGE;
    if (c->given[OPT_IO] && !c->given[OPT_SV])
        return cli_usage_error(c, TEXT_io_needs_vector);
    if (deps_wanted(c) && !deps_check_name(c, file))
        return EXIT_USAGE;
    if (c->given[OPT_NET] && !c->given[OPT_SV])
        return cli_usage_error(c, TEXT_net_needs_vector);
    return EXIT_OK;
}

// Returns the application among the files of the command; NULL: none.
static const char *find_app(const Cli *c)
{
    for (size_t i = 0; i < c->files; i++)
        if (has_suffix(c->file[i], ".app"))
            return c->file[i];
    return NULL;
}

// Refuses options that an application replaces.
static int check_app_options(Cli *c, const char *app)
{
    if (c->given[OPT_IO] || c->given[OPT_NET])
        return cli_usage_error(c, TEXT_app_names_files, app, c->given[OPT_IO] ? "--io" : "--net");
    return EXIT_OK;
}

// Compiles an application, and begins the report about it and its machines.
static int compile_app_for_report(Cli *c, const CompileInput *in, CompileOptions *o, Compiled *made, Report *r)
{
    o->scripts_later = true;
    o->warnings = NULL;                   // a report contains every finding
    if (!compile_sources(&c->session, in, o, made) || !made->of[0].scripted) {
        cli_print_diagnostics(c);
        return EXIT_PROBLEM;
    }
    review_begin_app(&c->session, made->app, made->of[0].scripted, o->opt_level, r);
    return EXIT_OK;
}

// Compiles the machine and the scripts, and begins the report with the costs of the image.  Returns EXIT_OK, or EXIT_PROBLEM after messages.
static int compile_for_report(Cli *c, const CompileInput *in, CompileOptions *o, Compiled *made, Report *r)
{
    const Network *net = NULL;

    o->emit = EMIT_BYTECODE;
    o->measure = true;
    o->scripts_later = true;
    o->warnings = NULL;                   // a report contains every finding
    if (!compile_sources(&c->session, in, o, made) || (in->messages && !(net = session_net(&c->session, in->messages, in->vector)))) {
        cli_print_diagnostics(c);
        return EXIT_PROBLEM;
    }
    review_begin(&c->session, runs_find_machine(in, made)->program, r);
    r->net = net;
    review_add_costs(&c->session, runs_find_machine(in, made), made->artefact.at[0].bytes, o->step != 0, r);
    return EXIT_OK;
}

int cmd_report(Cli *c)
{
    static WriteReport *const writer[FORMATS] = {doc_write_html, doc_write_text, doc_write_json};
    OsOutput file[2] = {{c->given[OPT_OUTPUT] ? c->value[OPT_OUTPUT] : "-", NULL, 0}};
    size_t format, files = 1;
    CompileInput in;
    CompileOptions o;
    Compiled made;
    Report r;
    Buf out;
    uint64_t seconds = 0;
    bool failed;
    int code;

    if ((code = runs_check_arguments(c)) != EXIT_OK)
        return code;
    report_parts_choose(c);
    if (find_app(c) && (code = check_app_options(c, find_app(c))) != EXIT_OK)
        return code;
    if ((code = check_options(c, &o, &file[0], &format)) != EXIT_OK)
        return code;
    if (!cli_read_limit(c, OPT_TIME, "--time", MOST_SECONDS, &seconds))
        return EXIT_USAGE;
    if ((code = cli_read_inputs(c, &in)) != EXIT_OK)
        return code;
    if ((code = (in.app ? compile_app_for_report : compile_for_report)(c, &in, &o, &made, &r)) != EXIT_OK)
        return code;
    if ((code = (in.app ? runs_execute_app : runs_execute)(c, &r, &in, &made)) != EXIT_OK) {
        cli_print_diagnostics(c);
        return code;
    }
    failed = print_failed(c, &r);
    os_signals_begin();
    os_signals_delay();                   // a signal ends the parts, and the process when the page is written
    code = report_parts_run(c, &r, runs_find_machine(&in, &made)->scripted, &o, (double)seconds);
    if (code == EXIT_OK) {
        print_unfinished(c, &r);
        buf_init(&out, &c->session.arena);
        writer[format]((in.app ? report_build_app : report_build)(&r), &out);
        file[0].bytes = buf_text(&out);
        file[0].n = out.n;
        if (deps_wanted(c))
            deps_add_rule(c, file, &files, deps_list_inputs(c));
        code = cli_write_outputs(c, file, files);
    }
    os_signals_resume();
    os_signals_end();
    if (code != EXIT_OK)
        return code;
    return failed || is_violated(&r) ? EXIT_PROBLEM : EXIT_OK;
}
