// SPDX-License-Identifier: Apache-2.0
// smc check: checks sources without running them.
#include "compiler/cli/cli.h"

static int check_use(Cli *c)
{
    size_t of[FILE_APP + 1] = {0};        // files of each kind
    const char *pins = NULL;
    FileKind kind;

    if (c->files == 0)
        return cli_usage(c, "check wants a file, as in 'smc check tank.sm'");
    if (!cli_are_sources(c, true))
        return EXIT_USAGE;
    for (size_t i = 0; i < c->files; i++) {
        kind = FILE_SM;
        file_kind(c->file[i], &kind);
        of[kind]++;
        pins = kind == FILE_IO ? c->file[i] : pins;
    }
    if (of[FILE_APP] && c->files > 1)
        return cli_usage(c, "an application is checked alone: it names its files itself");
    if (of[FILE_APP] && c->given[OPT_SV])
        return cli_usage(c, "'%s' names its state vector itself: --sv has no place here", c->file[0]);
    if (pins && !c->given[OPT_SV])
        return cli_usage(c, "pins are checked with their state vector, as in 'smc check %s --sv app.sv'", pins);
    if (of[FILE_SS] && of[FILE_SM] == 0)
        return cli_usage(c, "a script is checked together with its machine, as in 'smc check tank.sm tank.ss'");
    if (of[FILE_SS] && of[FILE_SM] > 1)
        return cli_usage(c, "scripts are checked with one machine at a time, as in 'smc check tank.sm tank.ss'");
    return EXIT_OK;
}

int cmd_check(Cli *c)
{
    CompileInput in;
    CompileOptions o;
    Compiled out;
    int code = check_use(c);

    if (code != EXIT_OK)
        return code;
    if (!cli_compile_options(c, &o))
        return EXIT_USAGE;
    if ((code = cli_read_inputs(c, &in)) != EXIT_OK)
        return code;
    compile_sources(&c->session, &in, &o, &out);
    return cli_report(c);
}
