// SPDX-License-Identifier: Apache-2.0
// smc emit-dictionary: writes the messages of a .net for programs on other computers.
#include <string.h>

#include "compiler/cli/cli.h"
#include "compiler/report/dictionary.h"

static const CliFormat formats[] = {{"json", {".json", NULL, NULL}, NULL}, {"c", {".h", NULL, NULL}, NULL}, {"python", {".py", NULL, NULL}, NULL},
                                    {"xtce", {".xml", ".xtce", NULL}, NULL}};
enum { FORMATS = sizeof formats / sizeof *formats };

int cmd_emit_dictionary(Cli *c)
{
    static DictionaryWriter *const writer[FORMATS] = {dictionary_write_json, dictionary_write_c, dictionary_write_python,
                                                      dictionary_write_xtce};
    OsOutput file = {NULL, NULL, 0};
    FileKind kind = FILE_SM;
    CompileInput in;
    CompileOptions o;
    Compiled made;
    size_t format;
    Buf out;
    int code;

    if (c->files != 1 || !file_kind(c->file[0], &kind) || kind != FILE_NET || !c->given[OPT_SV])
        return cli_usage_error(c, TEXT_dictionary_what);
    if (!cli_choose_format(c, formats, FORMATS, &format))
        return EXIT_USAGE;
    if (!cli_compile_options(c, &o))
        return EXIT_USAGE;
    if ((code = cli_read_inputs(c, &in)) != EXIT_OK)
        return code;
    compile_sources(&c->session, &in, &o, &made);
    if ((code = cli_print_diagnostics(c)) != EXIT_OK)
        return code;
    buf_init(&out, &c->session.arena);
    writer[format](made.of[0].net, &out);
    file = (OsOutput){c->given[OPT_OUTPUT] ? c->value[OPT_OUTPUT] : "-", buf_text(&out), out.n};
    return cli_write_outputs(c, &file, 1);
}
