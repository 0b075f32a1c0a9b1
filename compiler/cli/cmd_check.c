// SPDX-License-Identifier: Apache-2.0
// smc check: checks sources without running them.
#include "compiler/cli/runs.h"

// Checks that the files of the command line can be checked together, as their number by kind shows.
static int check_arguments(Cli *c)
{
    size_t of[FILE_KINDS] = {0};        // by FileKind: number of files of this kind
    const char *pins = NULL;
    FileKind kind;

    if (c->files == 0)
        return cli_usage_error(c, TEXT_check_what);
    if (!cli_check_sources(c, true))
        return EXIT_USAGE;
    for (size_t i = 0; i < c->files; i++) {
        kind = FILE_SM;
        file_kind(c->file[i], &kind);
        of[kind]++;
        pins = kind == FILE_IO || kind == FILE_NET ? c->file[i] : pins;
    }
    if (of[FILE_APP] && (of[FILE_APP] > 1 || of[FILE_APP] + of[FILE_SS] + of[FILE_RQ] < c->files))
        return cli_usage_error(c, TEXT_app_checked_alone);
    if (of[FILE_APP] && c->given[OPT_SV])
        return cli_usage_error(c, TEXT_app_names_vector, c->file[0]);
    if (pins && !c->given[OPT_SV])
        return cli_usage_error(c, TEXT_pins_checked_with, pins);
    if (of[FILE_RQ] && of[FILE_SM] != 1 && of[FILE_APP] == 0)
        return cli_usage_error(c, TEXT_requirements_checked_with);
    if (of[FILE_SS] && of[FILE_SM] == 0 && of[FILE_APP] == 0)
        return cli_usage_error(c, TEXT_script_checked_with);
    if (of[FILE_SS] && of[FILE_SM] > 1)
        return cli_usage_error(c, TEXT_one_machine_and_scripts);
    return EXIT_OK;
}

int cmd_check(Cli *c)
{
    CompileInput in;
    CompileOptions o;
    Compiled out;
    int code = check_arguments(c);

    if (code != EXIT_OK)
        return code;
    if (!cli_compile_options(c, &o))
        return EXIT_USAGE;
    if ((code = cli_read_inputs(c, &in)) != EXIT_OK)
        return code;
    o.names = in.app != NULL;             // smc build also puts names into the images of an application
    compile_sources(&c->session, &in, &o, &out);
    for (size_t i = 0; i < in.n; i++)
        if (out.of[i].requirements && !out.of[i].requirements->program->joint)
            runs_report_contradiction(c, out.of[i].requirements);
    return cli_print_diagnostics(c);
}
