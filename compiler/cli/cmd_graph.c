// SPDX-License-Identifier: Apache-2.0
// smc graph: the state diagram of a machine.
#include <string.h>

#include "compiler/cli/cli.h"
#include "compiler/emit/report/graph.h"

typedef void PutGraph(const Analysis *a, const GraphOptions *o, Buf *out);

static const CliFormat formats[] = {
    {"svg", {".svg", NULL, NULL}}, {"dot", {".dot", ".gv", NULL}}, {"mermaid", {".mmd", ".mermaid", NULL}}};
enum { FORMATS = sizeof formats / sizeof *formats };

static PutGraph *find_format(Cli *c)
{
    static PutGraph *const put[FORMATS] = {graph_svg, graph_dot, graph_mermaid};
    size_t i;

    return cli_format(c, formats, FORMATS, &i) ? put[i] : NULL;
}

// The diagram shows what the report says: warnings that are switched off are not marked.
static int draw(Cli *c, const Program *p, PutGraph *put)
{
    Diags found;
    GraphOptions o = {&found, NULL, NULL};
    OsOutput file = {c->given[OPT_OUTPUT] ? c->value[OPT_OUTPUT] : "-", NULL, 0};
    Analysis a;
    Buf out;
    int code;

    session_analyse(&c->session, p);
    warnings_apply(&c->warn, &c->session.diags);
    found = c->session.diags;
    if ((code = cli_report(c)) != EXIT_OK)
        return code;
    analysis_begin(&a, &c->session.arena, &c->session.diags, p);
    buf_init(&out, &c->session.arena);
    put(&a, &o, &out);
    file.bytes = buf_text(&out);
    file.n = out.n;
    return cli_write(c, &file, 1) ? EXIT_OK : EXIT_ENVIRONMENT;
}

static int check_use(Cli *c)
{
    if (c->files == 0)
        return cli_usage(c, "graph wants a machine, as in 'smc graph tank.sm'");
    if (c->files > 1)
        return cli_usage(c, "graph draws one machine at a time");
    if (!has_suffix(c->file[0], ".sm") && strcmp(c->file[0], "-") != 0)
        return cli_usage(c, "'%s' is no machine: its name ends in .sm", c->file[0]);
    return EXIT_OK;
}

int cmd_graph(Cli *c)
{
    MachineInput in = {NULL, NULL, NULL, 2};
    PutGraph *put = find_format(c);
    int code = put ? check_use(c) : EXIT_USAGE;
    Program *p;

    if (code != EXIT_OK)
        return code;
    if ((in.sm = cli_load(c, c->file[0])) == NULL || (c->given[OPT_SV] && (in.sv = cli_load(c, c->value[OPT_SV])) == NULL))
        return EXIT_ENVIRONMENT;
    p = session_program(&c->session, &in);
    return p ? draw(c, p, put) : cli_report(c);
}
