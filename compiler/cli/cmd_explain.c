// SPDX-License-Identifier: Apache-2.0
// smc explain CODE or NAME: the page of a diagnostic, or those of a warning.
#include <string.h>

#include "compiler/cli/cli.h"

static void write_page(const DiagInfo *d, Buf *out)
{
    buf_printf(out, "%s: ", d->id);
    diag_put_title(d, out);
    if (d->flag)
        buf_printf(out, "  [-W%s]", d->flag);
    buf_printf(out, "\n\n%s", d->page);
}

static int report_unknown_code(Cli *c, const char *name)
{
    const char **names = ARENA_ARRAY(&c->session.arena, const char *, DIAG_COUNT + diag_flag_count), *near;
    size_t n = 0;

    for (size_t i = 0; i < DIAG_COUNT; i++)
        if (diag_info[i].id)
            names[n++] = diag_info[i].id;
    for (size_t i = 0; i < diag_flag_count; i++)
        names[n++] = diag_flag[i].name;
    near = str_nearest(name, names, n);
    return near ? cli_usage_error(c, TEXT_no_diagnostic_near, name, near)
                : cli_usage_error(c, TEXT_no_diagnostic, name);
}

static void explain_flag(const DiagFlag *flag, Buf *out)
{
    diag_put_flag(out, flag);
    for (size_t i = 0; i < DIAG_COUNT; i++)
        if (diag_info[i].flag && strcmp(diag_info[i].flag, flag->name) == 0) {
            buf_char(out, '\n');
            write_page(&diag_info[i], out);
        }
}

// Explains each argument. If some names are unknown, the known ones are still explained.
static int explain_names(Cli *c, Buf *out)
{
    int code = EXIT_OK;

    for (size_t i = 0; i < c->files; i++) {
        // Diagnostics end with code and name in brackets, as [W0901 abort-blind]: they are accepted around both.
        const char *word = c->file[i] + (c->file[i][0] == '[');
        const size_t n = strlen(word);
        const char *name = format_in(&c->session.arena, "%.*s", (int)(n && word[n - 1] == ']' ? n - 1 : n), word);
        const DiagFlag *flag = diag_find_flag(name);
        const DiagInfo *d = diag_find(name);
        if (out->n > 0 && (flag || d))
            buf_char(out, '\n');
        if (flag)
            explain_flag(flag, out);
        else if (d)
            write_page(d, out);
        else
            code = report_unknown_code(c, c->file[i]);
    }
    return code;
}

int cmd_explain(Cli *c)
{
    int code = EXIT_OK;
    Buf out;

    buf_init(&out, &c->session.arena);
    if (!c->given[OPT_ALL] && c->files == 0)
        return cli_usage_error(c, TEXT_explain_what);
    if (!c->given[OPT_ALL])
        code = explain_names(c, &out);
    for (size_t i = 0; i < DIAG_COUNT && c->given[OPT_ALL]; i++)
        if (diag_info[i].id) {
            write_page(&diag_info[i], &out);
            buf_char(&out, '\n');
        }
    return cli_print(c, 1, &out) ? code : EXIT_ENVIRONMENT;
}
