// SPDX-License-Identifier: Apache-2.0
// The pages of all diagnostics as one Markdown document: docs/diagnostics.md.
#include <string.h>

#include "compiler/diag/diag.h"

static const struct { char digit; const char *title; } chapters[] = {
    {'1', "Characters and numbers"}, {'2', "Names and declarations"}, {'3', "Grammar"}, {'4', "Expressions and constants"},
    {'5', "States and transitions"}, {'6', "State vector"}, {'7', "Scripts"}, {'8', "Files and images"}};

void diag_put_title(const DiagInfo *row, Buf *out)
{
    const char *message = row->message;

    for (const char *hole; (hole = strstr(message, "{}")) != NULL; message = hole + 2) {
        buf_put(out, message, (size_t)(hole - message));
        buf_str(out, "...");
    }
    buf_str(out, message);
}

static void put_page(Buf *out, const DiagInfo *row)
{
    buf_printf(out, "### %s: ", row->id);
    diag_put_title(row, out);
    buf_str(out, "\n\n");
    if (row->flag)
        buf_printf(out, "A warning: `-Wno-%s` silences it, `-Werror=%s` makes it an error.\n\n", row->flag, row->flag);
    buf_str(out, row->page);
    buf_char(out, '\n');
}

void diags_write_markdown(Buf *out)
{
    buf_str(out, "# Diagnostics\n\n"
                 "Every error and warning of the compiler, by its code. `smc explain E0204` prints one of these pages. A code never\n"
                 "changes its meaning and is never used again for something else.\n\n"
                 "This page is made from `compiler/diag/codes.def` by `make docs`.\n\n");
    for (size_t c = 0; c < sizeof chapters / sizeof *chapters; c++) {
        buf_printf(out, "## %c %s\n\n", chapters[c].digit, chapters[c].title);
        for (size_t i = 0; i < DIAG_COUNT; i++)
            if (diag_info[i].id && diag_info[i].id[2] == chapters[c].digit)
                put_page(out, &diag_info[i]);
    }
    out->n--;                                             // one line end at the end of the file
    out->at[out->n] = '\0';
}
