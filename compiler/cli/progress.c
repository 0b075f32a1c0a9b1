// SPDX-License-Identifier: Apache-2.0
#include "compiler/cli/progress.h"

#include "compiler/base/os.h"

bool progress_is_due(const ProgressLine *k) { return os_is_terminal(2) && os_seconds() - k->last >= 0.2; }

// Writes `text` over what the line of progress shows; "" erases it.
static void rewrite_line(ProgressLine *k, const char *text)
{
    Buf out;

    buf_init(&out, &k->c->session.arena);
    buf_printf(&out, "\r%-*.*s%s", (int)PROGRESS_WIDTH, (int)PROGRESS_WIDTH, text, *text ? "" : "\r");
    cli_print(k->c, 2, &out);
}

void progress_show(ProgressLine *k, const char *text)
{
    k->last = os_seconds();
    k->is_shown = true;
    rewrite_line(k, text);
}

void progress_end(ProgressLine *k)
{
    if (k->is_shown)
        rewrite_line(k, "");
    k->is_shown = false;
}
