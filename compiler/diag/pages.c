// SPDX-License-Identifier: Apache-2.0
// The pages of all diagnostics as one Markdown document: docs/diagnostics.md.
#include <string.h>

#include "compiler/diag/diag.h"

// chapters[n - 1] is the title for the codes whose first two digits are n.
static const char *const chapters[] = {
    "Characters and numbers", "Names and declarations", "Grammar", "Expressions and constants", "States and transitions", "State vector",
    "Scripts", "Files and images", "Flight", "Applications", "Pins", "Network", "Requirements", "Coverage and mutation"};

static size_t chapter_of(const DiagInfo *row) { return (size_t)(row->id[1] - '0') * 10 + (size_t)(row->id[2] - '0'); }

// Whether any code belongs to this chapter.
static bool has_pages(size_t chapter)
{
    for (size_t i = 0; i < DIAG_COUNT; i++)
        if (diag_info[i].id && chapter_of(&diag_info[i]) == chapter)
            return true;
    return false;
}

// Appends the message, with "..." for each argument.
void diag_put_title(const DiagInfo *row, Buf *out)
{
    const char *message = row->message;

    for (const char *hole; (hole = strstr(message, "{}")) != NULL; message = hole + 2) {
        buf_put(out, message, (size_t)(hole - message));
        buf_str(out, "...");
    }
    buf_str(out, message);
}

static const struct { const char *title, *words; } groups[] = {
    [DIAG_GROUP_ALL]    = {"On by default", "Each finding is almost certainly a mistake. `-Wno-all` switches all of these warnings off."},
    [DIAG_GROUP_EXTRA]  = {"-Wextra", "Untidy code."},
    [DIAG_GROUP_FLIGHT] = {"-Wflight", "Questions of a flight review. They use the marks `@abort`, `@safe`, `@command` and `@range`."}};

// Writes the table of a group of warnings.
static void put_group(Buf *out, DiagGroup group)
{
    buf_printf(out, "### %s\n\n%s\n\n| name | what it finds | codes |\n|---|---|---|\n", groups[group].title, groups[group].words);
    for (size_t i = 0; i < diag_flag_count; i++) {
        const DiagFlag *flag = &diag_flag[i];
        const char *separator = "";

        if (flag->group != group)
            continue;
        buf_printf(out, "| `%s` | %s | ", flag->name, flag->sentence);
        for (size_t code = 0; code < DIAG_COUNT; code++)
            if (diag_info[code].flag && strcmp(diag_info[code].flag, flag->name) == 0) {
                buf_printf(out, "%s%s", separator, diag_info[code].id);
                separator = " ";
            }
        buf_str(out, " |\n");
    }
    buf_char(out, '\n');
}

// Appends a warning's name, what it finds, and how to switch it: the text before the pages of its codes.
void diag_put_flag(Buf *out, const DiagFlag *flag)
{
    const char *name = flag->name;

    buf_printf(out, "%s: %s\n\n", name, flag->sentence);
    if (flag->group == DIAG_GROUP_ALL)
        buf_printf(out, "This warning is on: -Wno-%s switches it off", name);
    else
        buf_printf(out, "This warning is one of -W%s: -W%s switches it on alone", diag_group_name[flag->group], name);
    buf_printf(out, ", and -Werror=%s makes it an error.\nTo accept it in one place: @allow(%s, \"the reason\")\n", name, name);
}

// Writes the page of a code; for a warning also how to switch it on or off.
static void put_page(Buf *out, const DiagInfo *row)
{
    const DiagFlag *flag = row->flag ? diag_find_flag(row->flag) : NULL;

    buf_printf(out, "### %s: ", row->id);
    diag_put_title(row, out);
    buf_str(out, "\n\n");
    if (flag && flag->group == DIAG_GROUP_ALL)
        buf_printf(out, "A warning: `-Wno-%s` silences it, `-Werror=%s` makes it an error.\n\n", flag->name, flag->name);
    else if (flag)
        buf_printf(out, "A warning of `-W%s`, or alone of `-W%s`; `-Werror=%s` makes it an error.\n\n", diag_group_name[flag->group],
                   flag->name, flag->name);
    buf_str(out, row->page);
    buf_char(out, '\n');
}

void diags_write_markdown(Buf *out)
{
    buf_str(out, "# Diagnostics\n\n"
                 "Every error and warning of the compiler, by code. `smc explain E0204` prints one of these pages. The meaning of a code\n"
                 "never changes, and a code is never reused.\n\n"
                 "This page is generated from `compiler/diag/codes.def` and `flags.def` by `make docs`.\n\n"
                 "## Warnings\n\n"
                 "Each warning has a name, which follows its code: `[W0921 missing-timeout]`. `-Wname` switches it on, `-Wno-name` off.\n"
                 "`-Werror=name` makes it an error. The names `all`, `extra`, `flight` and `everything` select groups of warnings.\n"
                 "`@allow(name, \"reason\")` accepts a warning in one place ([language.md](language.md), 5.49).\n"
                 "`smc explain` with a name prints the pages of its codes.\n\n");
    for (int g = DIAG_GROUP_ALL; g <= DIAG_GROUP_FLIGHT; g++)
        put_group(out, (DiagGroup)g);
    for (size_t c = 0; c < sizeof chapters / sizeof *chapters; c++) {
        if (has_pages(c + 1))
            buf_printf(out, "## %u %s\n\n", (unsigned)c + 1, chapters[c]);
        for (size_t i = 0; i < DIAG_COUNT; i++)
            if (diag_info[i].id && chapter_of(&diag_info[i]) == c + 1)
                put_page(out, &diag_info[i]);
    }
    out->n--;                                             // removes the second of two line ends at the end of the file
    out->at[out->n] = '\0';
}
