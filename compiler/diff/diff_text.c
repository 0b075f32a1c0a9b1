// SPDX-License-Identifier: Apache-2.0
// A comparison as text for a terminal, and as Markdown for a pull request.
#include <inttypes.h>
#include <string.h>

#include "compiler/base/path.h"
#include "compiler/diff/diff_part.h"

// Returns how many changes have this weight.
static size_t count_weight(const ProgramDiff *d, DiffWeight w)
{
    size_t n = 0;

    for (size_t i = 0; i < d->change.n; i++)
        n += d->change.at[i].weight == w;
    return n;
}

static size_t count_differing_runs(const ProgramDiff *d)
{
    size_t n = 0;

    for (size_t i = 0; i < d->run.n; i++)
        n += !d->run.at[i].problem && !d->run.at[i].same;
    return n;
}

static const char *count_text(Arena *arena, size_t n, const char *what)
{
    return format_in(arena, "%lu %s%s", (unsigned long)n, what, n == 1 ? "" : "s");
}

// Returns the verdict as a sentence without its full stop.
static const char *verdict_text(const ProgramDiff *d)
{
    const size_t changes = count_weight(d, DIFF_BEHAVIOUR), runs = count_differing_runs(d);

    if (!changes && !runs)
        return "no change of behaviour";
    return format_in(d->arena, "behaviour changed: %s%s%s", count_text(d->arena, changes, "change"), runs ? ", seen in " : "",
                     runs ? count_text(d->arena, runs, "script") : "");
}

static const char *side_name(const DiffSide *s) { return path_portable_name(s->p->src->name); }

static const char *sign_of(DiffHow how) { return how == DIFF_ADDED ? "+" : how == DIFF_REMOVED ? "-" : how == DIFF_CHANGED ? "~" : "="; }

// ---- text ----

static const char *const weight_title[] = {"behaviour:\n", "what surrounds the machine sees:\n", "no change of behaviour:\n"};

static void write_change(const DiffChange *c, Buf *out)
{
    buf_printf(out, "  %s %s%s%s", sign_of(c->how), c->where, *c->where ? ": " : "", c->how == DIFF_RENAMED && c->part == DIFF_STATE ? "state " : "");
    if (c->how == DIFF_RENAMED)
        buf_printf(out, "%s renamed\n", c->what);
    else
        buf_printf(out, "%s %s\n", c->what, diff_how_name[c->how]);
    if (c->old)
        buf_printf(out, "      - %s\n", c->old);
    if (c->new)
        buf_printf(out, "      + %s\n", c->new);
    if (c->meaning)
        buf_printf(out, "      %s\n", c->meaning);
}

static void write_changes(const ProgramDiff *d, DiffWeight w, Buf *out)
{
    if (count_weight(d, w))
        buf_str(out, weight_title[w]);
    for (size_t i = 0; i < d->change.n; i++)
        if (d->change.at[i].weight == w)
            write_change(&d->change.at[i], out);
}

static void write_run(const DiffRun *r, Buf *out)
{
    buf_printf(out, "  %s: ", r->script);
    if (r->problem)
        buf_printf(out, "not compared: %s\n", r->problem);
    else if (r->same)
        buf_printf(out, "equal in %" PRIu64 " steps, %s\n", r->steps, r->old_result);
    else if (r->step == 0)
        buf_printf(out, "%s, now %s\n", r->old_result, r->new_result);
    else {
        buf_printf(out, "differs after step %" PRIu64 " (G = %" PRIu64 ", state %s%s%s)", r->step, r->g, r->old_state,
                   strcmp(r->old_state, r->new_state) ? ", now " : "",
                   strcmp(r->old_state, r->new_state) ? r->new_state : "");
        for (uint32_t i = 0; i < r->values; i++)
            buf_printf(out, "%s%s = %s, now %s", i ? "; " : ": ", r->value[i].name, r->value[i].old, r->value[i].new);
        buf_printf(out, "\n      %s, now %s\n", r->old_result, r->new_result);
    }
}

static void write_costs(const ProgramDiff *d, Buf *out)
{
    bool is_first = true;

    for (size_t i = 0; i < d->cost.n; i++) {
        const DiffCost *c = &d->cost.at[i];
        if (c->old == c->new)
            continue;
        buf_printf(out, "%s  %s: %" PRIu64 ", now %" PRIu64 "\n", is_first ? "costs:\n" : "", c->name, c->old, c->new);
        is_first = false;
    }
}

static void write_findings(const ProgramDiff *d, Buf *out)
{
    for (size_t i = 0; i < d->finding.n; i++) {
        const DiffFinding *f = &d->finding.at[i];
        buf_printf(out, "%s  %s %s%s%s [%s]\n", i ? "" : "findings:\n", f->appeared ? "+" : "-", f->where, *f->where ? ": " : "", f->diag->text,
                   diag_info[f->diag->code].flag ? diag_info[f->diag->code].flag : diag_info[f->diag->code].id);
    }
}

void diff_write_text(const ProgramDiff *d, Buf *out)
{
    buf_printf(out, "comparison of %s with %s: %s\n", side_name(&d->old), side_name(&d->new), verdict_text(d));
    for (int w = 0; w <= DIFF_NOTE; w++)
        write_changes(d, (DiffWeight)w, out);
    for (size_t i = 0; i < d->run.n; i++) {
        buf_str(out, i ? "" : "scripts:\n");
        write_run(&d->run.at[i], out);
    }
    write_costs(d, out);
    write_findings(d, out);
    buf_printf(out, "%sswap without stopping: %s\n", d->same_image ? "image: the same logic\n" : "", d->swap);
}

// ---- Markdown ----

// Writes a text into a cell of a table, as code.  A bar would end the cell, and a backtick the code.
static void write_code(Buf *out, const char *text)
{
    if (!text)
        return;
    buf_char(out, '`');
    for (; *text; text++)
        buf_str(out, *text == '|' ? "\\|" : *text == '`' ? "'" : (const char[2]){*text, '\0'});
    buf_char(out, '`');
}

// Writes a text outside code, where a bar, an angle bracket or a mark of Markdown would not be shown.
static void write_plain(Buf *out, const char *text)
{
    for (; text && *text; text++) {
        if (strchr("\\|<>*_`[]#", *text))
            buf_char(out, '\\');
        buf_char(out, *text);
    }
}

static void write_rows(const ProgramDiff *d, DiffWeight w, Buf *out)
{
    buf_str(out, "| | where | what | before | now | meaning |\n|---|---|---|---|---|---|\n");
    for (size_t i = 0; i < d->change.n; i++) {
        const DiffChange *c = &d->change.at[i];
        if (c->weight != w)
            continue;
        buf_printf(out, "| %s | ", diff_how_name[c->how]);
        write_plain(out, c->where);
        buf_str(out, " | ");
        write_plain(out, c->what);
        buf_str(out, " | ");
        write_code(out, c->old);
        buf_str(out, " | ");
        write_code(out, c->new);
        buf_str(out, " | ");
        write_plain(out, c->meaning);
        buf_str(out, " |\n");
    }
}

static void write_details(const ProgramDiff *d, DiffWeight w, const char *title, Buf *out)
{
    if (!count_weight(d, w))
        return;
    buf_printf(out, "\n<details><summary>%s (%lu)</summary>\n\n", title, (unsigned long)count_weight(d, w));
    write_rows(d, w, out);
    buf_str(out, "\n</details>\n");
}

void diff_write_markdown(const ProgramDiff *d, Buf *out)
{
    buf_str(out, "### ");
    write_plain(out, side_name(&d->new));
    buf_printf(out, ": %s\n", verdict_text(d));
    if (count_weight(d, DIFF_BEHAVIOUR)) {
        buf_char(out, '\n');
        write_rows(d, DIFF_BEHAVIOUR, out);
    }
    for (size_t i = 0; i < d->run.n; i++) {
        Buf line;
        buf_init(&line, d->arena);
        write_run(&d->run.at[i], &line);
        buf_str(out, i ? "- " : "\n- ");
        for (const char *at = buf_text(&line) + 2; *at; at++)
            if (*at == '\n' && at[1])
                buf_str(out, "; ");
            else if (*at == '\n')
                buf_char(out, '\n');
            else if (*at != ' ' || at[1] != ' ')
                write_plain(out, (const char[2]){*at, '\0'});
    }
    write_details(d, DIFF_INTERFACE, "What surrounds the machine sees", out);
    write_details(d, DIFF_NOTE, "No change of behaviour", out);
    if (d->cost.n || d->finding.n) {
        buf_str(out, "\n<details><summary>Costs and findings</summary>\n\n");
        if (d->cost.n)
            buf_str(out, "| cost | before | now |\n|---|---:|---:|\n");
        for (size_t i = 0; i < d->cost.n; i++)
            buf_printf(out, "| %s | %" PRIu64 " | %" PRIu64 " |\n", d->cost.at[i].name, d->cost.at[i].old, d->cost.at[i].new);
        for (size_t i = 0; i < d->finding.n; i++) {
            buf_printf(out, "%s- %s ", i ? "" : "\n", d->finding.at[i].appeared ? "appeared:" : "disappeared:");
            write_plain(out, d->finding.at[i].diag->text);
            buf_char(out, '\n');
        }
        buf_str(out, "\n</details>\n");
    }
    buf_printf(out, "\nSwap without stopping: %s.\n", d->swap);
}
