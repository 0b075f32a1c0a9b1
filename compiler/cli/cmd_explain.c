// SPDX-License-Identifier: Apache-2.0
// smc explain CODE: the page of a diagnostic.
#include "compiler/cli/cli.h"

static void page(const DiagInfo *d, Buf *out)
{
    buf_printf(out, "%s: ", d->id);
    diag_put_title(d, out);
    if (d->flag)
        buf_printf(out, "  [-W%s]", d->flag);
    buf_printf(out, "\n\n%s", d->page);
}

static int unknown_code(Cli *c, const char *name)
{
    const char *names[2 * DIAG_COUNT], *near;
    size_t n = 0;

    for (size_t i = 0; i < DIAG_COUNT; i++) {
        if (diag_info[i].id)
            names[n++] = diag_info[i].id;
        if (diag_info[i].flag)
            names[n++] = diag_info[i].flag;
    }
    near = nearest_name(name, names, n);
    return near ? cli_usage(c, "no diagnostic is called '%s'; did you mean '%s'?", name, near)
                : cli_usage(c, "no diagnostic is called '%s'", name);
}

int cmd_explain(Cli *c)
{
    Buf out;

    buf_init(&out, &c->session.arena);
    if (c->given[OPT_ALL_PAGES]) {
        for (size_t i = 0; i < DIAG_COUNT; i++)
            if (diag_info[i].id) {
                page(&diag_info[i], &out);
                buf_char(&out, '\n');
            }
        return cli_print(c, 1, &out) ? EXIT_OK : EXIT_ENVIRONMENT;
    }
    if (c->files == 0)
        return cli_usage(c, "explain wants the code of a diagnostic, as in 'smc explain E0204'");
    for (size_t i = 0; i < c->files; i++) {
        const DiagInfo *d = diag_find(c->file[i]);
        if (!d)
            return unknown_code(c, c->file[i]);
        if (i > 0)
            buf_char(&out, '\n');
        page(d, &out);
    }
    return cli_print(c, 1, &out) ? EXIT_OK : EXIT_ENVIRONMENT;
}
