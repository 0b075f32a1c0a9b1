// SPDX-License-Identifier: Apache-2.0
// smc report: one page about a machine for a design review. Findings are those of `smc check` with the same files. Costs are
// those of the image that `smc build` makes. The scripts run on the VM, on an image with names.
#include "compiler/cli/deps.h"
#include "compiler/cli/runs.h"
#include "compiler/prove/prove_given.h"

typedef void WriteReport(const Doc *d, Buf *out);

static const CliFormat formats[] = {
    {"html", {".html", ".htm", NULL}, "a browser"}, {"text", {".txt", NULL, NULL}, NULL}, {"json", {".json", NULL, NULL}, NULL}};
enum { FORMATS = sizeof formats / sizeof *formats };

// Tries changes of the machine on the scripts of r, if that is wanted.  Nothing is tried if a script fails, which is reported.
static void run_mutants(Cli *c, Report *r, const Program *p)
{
    const Script **script = ARENA_ARRAY(&c->session.arena, const Script *, r->runs + 1);
    Mutation *u;

    if (!c->given[OPT_MUTATE])
        return;
    if (r->runs == 0)
        r->not_mutated = "there is no script that could notice it";
    for (size_t i = 0; i < r->runs && !r->not_mutated; i++) {
        script[i] = r->run[i].script;
        if (!script[i] || r->run[i].result.outcome != SCRIPT_PASSED)
            r->not_mutated = format_in(&c->session.arena, "%s fails without one", r->run[i].name);
    }
    if (r->not_mutated) {
        cli_print_note(c, TEXT_report_not_mutated, r->not_mutated);
        return;
    }
    u = mutation_new(&c->session.arena, p, script, (uint32_t)r->runs, r->requirements, MUTATE_STEPS_MOST);
    while (mutation_run_next(u))
        ;
    while (mutation_search_next(u, MUTATE_SEARCH_STEPS))
        ;
    mutation_end(u);
    r->mutation = u;
}

// Decides the requirements, if that is wanted.  Returns false if two of them contradict each other, which is reported.
static bool run_proofs(Cli *c, Report *r, const CompileOptions *o)
{
    ProveGiven *given = ARENA_ARRAY(&c->session.arena, ProveGiven, r->runs + 1);
    const Requirement *first, *second;
    uint32_t givens = 0;
    Diags reported;                       // by the runs of the scripts, before

    if (!c->given[OPT_PROVE] || !r->requirements)
        return true;
    if (prove_find_contradiction(&c->session.arena, r->requirements, &first, &second)) {
        diag_note(&c->session.diags, diag_report(&c->session.diags, DIAG_requirements_contradict, second->span, second->id->text, first->id->text),
                  first->span, DIAG_note_first_here);
        return false;
    }
    diags_init(&reported, &c->session.arena);
    for (size_t i = 0; i < r->runs; i++)
        if (r->run[i].script)
            prove_record_script(&c->session.arena, &reported, r->requirements->program, r->requirements->program, r->run[i].script, &given[givens++]);
    r->proofs = prove_run(&c->session.arena, r->requirements, &(ProveOptions){.delta_t = o->step, .given = given, .givens = givens});
    return true;
}

int cmd_report(Cli *c)
{
    static WriteReport *const writer[FORMATS] = {doc_write_html, doc_write_text, doc_write_json};
    OsOutput file[2] = {{c->given[OPT_OUTPUT] ? c->value[OPT_OUTPUT] : "-", NULL, 0}};
    size_t format, files = 1;
    CompileInput in;
    CompileOptions o;
    Compiled made;
    const Network *net;
    Report r;
    Buf out;
    int code;

    if ((code = runs_check_arguments(c)) != EXIT_OK)
        return code;
    if (!cli_choose_format(c, formats, FORMATS, &format) || !cli_compile_options(c, &o))
        return EXIT_USAGE;
    if (c->given[OPT_IO] && !c->given[OPT_SV])
        return cli_usage_error(c, TEXT_io_needs_vector);
    if (deps_wanted(c) && !deps_check_name(c, &file[0]))
        return EXIT_USAGE;
    if (c->given[OPT_NET] && !c->given[OPT_SV])
        return cli_usage_error(c, TEXT_net_needs_vector);
    if ((code = cli_read_inputs(c, &in)) != EXIT_OK)
        return code;
    o.emit = EMIT_BYTECODE;
    o.measure = true;
    o.scripts_later = true;
    o.warnings = NULL;                    // a report contains every finding
    if (!compile_sources(&c->session, &in, &o, &made)) {
        cli_print_diagnostics(c);
        return EXIT_PROBLEM;
    }
    net = in.messages ? session_net(&c->session, in.messages, in.vector) : NULL;
    if (in.messages && !net) {
        cli_print_diagnostics(c);
        return EXIT_PROBLEM;
    }
    review_begin(&c->session, runs_find_machine(&in, &made)->program, &r);
    r.net = net;
    review_add_costs(&c->session, runs_find_machine(&in, &made), made.artefact.at[0].bytes, o.step != 0, &r);
    if ((code = runs_execute(c, &r, &in, &made)) != EXIT_OK) {
        cli_print_diagnostics(c);
        return code;
    }
    run_mutants(c, &r, runs_find_machine(&in, &made)->scripted);
    if (!run_proofs(c, &r, &o)) {
        cli_print_diagnostics(c);
        return EXIT_PROBLEM;
    }
    buf_init(&out, &c->session.arena);
    writer[format](report_build(&r), &out);
    file[0].bytes = buf_text(&out);
    file[0].n = out.n;
    if (deps_wanted(c))
        deps_add_rule(c, file, &files, deps_list_inputs(c));
    if ((code = cli_write_outputs(c, file, files)) != EXIT_OK)
        return code;
    for (size_t i = 0; i < r.runs; i++)
        if (!r.run[i].script || r.run[i].result.outcome != SCRIPT_PASSED) {
            cli_print_error(c, TEXT_run_failed, r.run[i].name);
            code = EXIT_PROBLEM;
        }
    return code;
}
