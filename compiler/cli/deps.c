// SPDX-License-Identifier: Apache-2.0
// -MD, -MF, -MT, -MP: the dependencies of an output, as a make rule.
#include "compiler/cli/deps.h"

#include <string.h>

bool deps_wanted(const Cli *c) { return c->given[OPT_DEPS] || c->given[OPT_DEPS_FILE]; }

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

// Returns the output's path with its suffix replaced.
static const char *deps_path(Cli *c, const char *output)
{
    const char *slash = strrchr(output, '/'), *name = slash ? slash + 1 : output, *dot = strrchr(name, '.');
    size_t stem = dot && dot != name ? (size_t)(dot - output) : strlen(output);

    if (c->given[OPT_DEPS_FILE])
        return c->value[OPT_DEPS_FILE];
    return format_in(&c->session.arena, "%.*s.d", (int)stem, output);
}

static void write_targets(Cli *c, const OsOutput *products, size_t n, Buf *out)
{
    if (c->given[OPT_DEPS_NAME])
        buf_str(out, c->value[OPT_DEPS_NAME]);             // verbatim, as compilers do: it can be several names
    else
        for (size_t i = 0; i < n; i++) {
            buf_str(out, i ? " " : "");
            write_make_name(out, products[i].path);
        }
    buf_char(out, ':');
}

void deps_add_rule(Cli *c, OsOutput *o, size_t *n, DepInputs in)
{
    Buf *out = ARENA_NEW(&c->session.arena, Buf);

    buf_init(out, &c->session.arena);
    write_targets(c, o, *n, out);
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
    o[*n] = (OsOutput){deps_path(c, o[0].path), buf_text(out), out->n};
    ++*n;
}
