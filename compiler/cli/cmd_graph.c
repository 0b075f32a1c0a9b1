// SPDX-License-Identifier: Apache-2.0
// smc graph: draws the state diagram of a machine, with its findings and the parts that its scripts have reached.
#include "compiler/cli/deps.h"
#include "compiler/cli/runs.h"

typedef void WriteGraph(const Analysis *a, const DiagramOptions *o, Buf *out);

static const CliFormat formats[] = {
    {"svg", {".svg", NULL, NULL}, "a browser"}, {"dot", {".dot", ".gv", NULL}, NULL}, {"mermaid", {".mmd", ".mermaid", NULL}, NULL}};
enum { FORMATS = sizeof formats / sizeof *formats };

// Prints the diagnostics of each run; the diagram shows how far a failed script got.
static int report_runs(Cli *c, const Report *r)
{
    int code = EXIT_OK;

    for (size_t i = 0; i < r->runs; i++) {
        int reported;
        c->session.diags = r->run[i].diags;
        reported = cli_print_diagnostics(c);
        code = reported > code ? reported : code;
    }
    return code;
}

// Runs smc graph.  The diagram shows the findings that smc report shows, except disabled warnings.
int cmd_graph(Cli *c)
{
    const CompiledSource *m;
    static WriteGraph *const writer[FORMATS] = {diagram_write_svg, diagram_write_dot, diagram_write_mermaid};
    size_t format;
    DiagramOptions g = {.findings = NULL};
    DiagramCounts counts;
    CompileInput in;
    CompileOptions o;
    Compiled made;
    Diags found;
    Report r;
    Buf out;
    int code;

    if (!cli_choose_format(c, formats, FORMATS, &format) || !deps_check_result(c))
        return EXIT_USAGE;
    if ((code = runs_check_arguments(c)) != EXIT_OK)
        return code;
    if (!cli_compile_options(c, &o))
        return EXIT_USAGE;
    if ((code = cli_read_inputs(c, &in)) != EXIT_OK)
        return code;
    o.opt_level = 2;
    o.scripts_later = true;
    compile_sources(&c->session, &in, &o, &made);
    found = c->session.diags;
    g.findings = &found;
    if ((code = cli_print_diagnostics(c)) != EXIT_OK)
        return code;
    m = runs_find_machine(&in, &made);
    review_begin(&c->session, m->program, &r);
    if ((code = runs_execute(c, &r, &in, &made)) != EXIT_OK) {
        cli_print_diagnostics(c);
        return code;
    }
    counts = report_sum_counts(&r);
    if (r.runs > 0)
        g.counts = &counts;
    buf_init(&out, r.arena);
    writer[format](&r.analysis, &g, &out);
    if ((code = deps_write_result(c, &out)) != EXIT_OK)
        return code;
    return report_runs(c, &r);
}
