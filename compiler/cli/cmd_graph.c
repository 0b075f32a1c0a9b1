// SPDX-License-Identifier: Apache-2.0
// smc graph: draws the state diagram of a machine, with its findings and the parts that its scripts have reached.
#include <string.h>

#include "compiler/cli/runs.h"

typedef void PutGraph(const Analysis *a, const GraphOptions *o, Buf *out);

static const CliFormat formats[] = {
    {"svg", {".svg", NULL, NULL}, "a browser"}, {"dot", {".dot", ".gv", NULL}, NULL}, {"mermaid", {".mmd", ".mermaid", NULL}, NULL}};
enum { FORMATS = sizeof formats / sizeof *formats };

static PutGraph *find_format(Cli *c)
{
    static PutGraph *const put[FORMATS] = {graph_svg, graph_dot, graph_mermaid};
    size_t i;

    return cli_format(c, formats, FORMATS, &i) ? put[i] : NULL;
}

// With scripts, the diagram shows the results of their runs.
static int count_runs(Cli *c, const Analysis *a, const Program *scripted, Source *const *ss, Report *r)
{
    r->arena = &c->session.arena;
    r->analysis = *a;
    return runs_make(c, r, scripted, ss);
}

// The diagram shows how far a failed script got.
static int tell_failures(Cli *c, const Report *r)
{
    int code = EXIT_OK, said;

    for (size_t i = 0; i < r->runs; i++) {
        c->session.diags = r->run[i].diags;
        said = cli_report(c);
        code = said > code ? said : code;
    }
    return code;
}

// The diagram shows the same findings as the report: disabled warnings are not marked. `scripted`: p, compiled for scripts.
static int draw(Cli *c, const Program *p, const Program *scripted, PutGraph *put, Source *const *ss)
{
    Diags found;
    GraphOptions o = {&found, NULL, NULL};
    OsOutput file = {c->given[OPT_OUTPUT] ? c->value[OPT_OUTPUT] : "-", NULL, 0};
    GraphCounts counts;
    Report r;
    Analysis a;
    Buf out;
    int code;

    memset(&r, 0, sizeof r);
    session_analyse(&c->session, p);
    diags_select(&c->session.diags, &c->warn);
    found = c->session.diags;
    if ((code = cli_report(c)) != EXIT_OK)
        return code;
    analysis_begin(&a, &c->session.arena, &c->session.diags, p);
    if ((code = count_runs(c, &a, scripted, ss, &r)) != EXIT_OK) {
        cli_report(c);
        return code;
    }
    counts = report_counts(&r);
    if (r.runs > 0)
        o.counts = &counts;
    buf_init(&out, &c->session.arena);
    put(&a, &o, &out);
    file.bytes = buf_text(&out);
    file.n = out.n;
    if ((code = cli_write(c, &file, 1)) != EXIT_OK)
        return code;
    return tell_failures(c, &r);
}

int cmd_graph(Cli *c)
{
    Map written = {&c->session.arena, NULL, NULL, 0, 0};
    MachineInput in = {NULL, NULL, NULL, 2};
    PutGraph *put = find_format(c);
    const char *machine;
    int code = put ? runs_machine(c, &machine) : EXIT_USAGE;
    Program *p, *scripted = NULL;
    Source **ss;

    if (code != EXIT_OK)
        return code;
    if (!step_known(c))
        return EXIT_USAGE;
    if ((in.sm = cli_load(c, machine)) == NULL || (c->given[OPT_SV] && (in.sv = cli_load(c, c->value[OPT_SV])) == NULL)
        || !runs_load(c, &ss, &written))
        return EXIT_ENVIRONMENT;
    if ((p = session_program(&c->session, &in)) != NULL) {
        in.written_outside = &written;
        scripted = session_program_for_scripts(&c->session, &in, p);
    }
    return scripted ? draw(c, p, scripted, put, ss) : cli_report(c);
}
