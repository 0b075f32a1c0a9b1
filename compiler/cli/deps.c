// SPDX-License-Identifier: Apache-2.0
// -MD, -MF, -MT, -MP: the dependencies of an output, as a make rule.
#include "compiler/base/path.h"
#include "compiler/cli/deps.h"

#include <string.h>

bool deps_wanted(const Cli *c) { return c->given[OPT_DEPS] || c->given[OPT_DEPS_FILE]; }

// Checks that the make rule of -MD can be written to a file: -MF names it, or the output has a name.
bool deps_check_name(Cli *c, const OsOutput *output)
{
    if (c->given[OPT_DEPS_FILE] || strcmp(output->path, "-") != 0)
        return true;
    cli_usage_error(c, TEXT_deps_unnamed);
    return false;
}

static void write_make_name(Buf *out, const char *name)
{
    for (; *name; name++) {
        if (*name == ' ' || *name == '#')
            buf_char(out, '\\');
        if (*name == '$')
            buf_char(out, '$');
        buf_char(out, *name);
    }
}

// Lists the files that the command has read: arguments, what they name and include, their data, and those of options.
DepInputs deps_list_inputs(Cli *c)
{
    static const OptionId option[] = {OPT_SV, OPT_IO, OPT_NET};
    enum { OPTIONS = sizeof option / sizeof *option };
    DepInputs all = {ARENA_ARRAY(&c->session.arena, const char *, c->files + c->named.n + c->included.n + c->data.n + OPTIONS), 0};

    for (size_t i = 0; i < c->files; i++)
        all.at[all.n++] = c->file[i];
    for (size_t i = 0; i < c->named.n; i++)
        all.at[all.n++] = c->named.at[i]->name;
    for (size_t i = 0; i < c->included.n; i++)
        all.at[all.n++] = c->included.at[i]->name;
    for (size_t i = 0; i < c->data.n; i++)
        all.at[all.n++] = c->data.at[i];
    for (int i = 0; i < OPTIONS; i++)
        if (c->given[option[i]])
            all.at[all.n++] = c->value[option[i]];
    return all;
}

// Appends the file with the make rule of -MD to the *n outputs, of which there is at least one; the array has room for it.
void deps_add_rule(Cli *c, OsOutput *o, size_t *n, DepInputs in)
{
    Buf *out = ARENA_NEW(&c->session.arena, Buf);
    const char *path = o[0].path, *name = path_file_name(path), *dot = strrchr(name, '.');
    const size_t stem = dot && dot != name ? (size_t)(dot - path) : strlen(path);

    buf_init(out, &c->session.arena);
    if (c->given[OPT_DEPS_NAME])
        buf_str(out, c->value[OPT_DEPS_NAME]);             // as compilers do, without escaping: it can be several names
    else
        for (size_t i = 0; i < *n; i++) {
            buf_str(out, i ? " " : "");
            write_make_name(out, o[i].path);
        }
    buf_char(out, ':');
    for (size_t i = 0; i < in.n; i++)
        if (strcmp(in.at[i], "-") != 0) {
            buf_char(out, ' ');
            write_make_name(out, in.at[i]);
        }
    buf_char(out, '\n');
    for (size_t i = 0; c->given[OPT_DEPS_PHONY] && i < in.n; i++)
        if (strcmp(in.at[i], "-") != 0) {
            buf_char(out, '\n');
            write_make_name(out, in.at[i]);
            buf_str(out, ":\n");
        }
    path = c->given[OPT_DEPS_FILE] ? c->value[OPT_DEPS_FILE] : format_in(&c->session.arena, "%.*s.d", (int)stem, path);
    o[*n] = (OsOutput){path, buf_text(out), out->n};
    ++*n;
}

bool deps_check_result(Cli *c)
{
    return !deps_wanted(c) || deps_check_name(c, &(OsOutput){c->given[OPT_OUTPUT] ? c->value[OPT_OUTPUT] : "-", NULL, 0});
}

int deps_write_result(Cli *c, const Buf *result)
{
    OsOutput file[2] = {{c->given[OPT_OUTPUT] ? c->value[OPT_OUTPUT] : "-", buf_text(result), result->n}};
    size_t files = 1;

    if (deps_wanted(c))
        deps_add_rule(c, file, &files, deps_list_inputs(c));
    return cli_write_outputs(c, file, files);
}
