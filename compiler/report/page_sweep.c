// SPDX-License-Identifier: Apache-2.0
// The section on parameters: how far each is from a value at which something fails, and what fails where.
#include "compiler/report/describe.h"
#include "compiler/report/page.h"
#include "compiler/report/page_text.h"

static const DocColumn margin_columns[] = {{"parameter", "Parameter"}, {"verdict", "Verdict"}, {"now", "Now"}, {"below", "Below"},
                                           {"above", "Above"}};
static const DocColumn span_columns[] = {{"from", "From"}, {"to", "To"}, {"fails", "What fails"}};
static const DocColumn boundary_columns[] = {{"check", "Check"}, {"meaning", "Meaning"}, {"passes", "Passes at"}, {"fails", "Fails at"}};

static const char *const verdict[] = {"fails now", "not noticed", "not changed", "has a limit", "only an assert"};       // by rank_of
static const char *const tone[] = {"bad", "note", "note", "good", "note"};

// Returns the rank of a parameter in the table, from the one that needs attention first.
static size_t rank_of(const ReportSweepOf *s)
{
    return !s->has_scripts ? 2 : s->fails_now ? 0 : !s->has_margin ? 1 : s->is_requirement ? 3 : 4;
}

static void add_margin(DocTable *t, const ReportSweepOf *s)
{
    doc_add_code_cell(t, s->parameter);
    doc_add_badge_cell(t, verdict[rank_of(s)], tone[rank_of(s)]);
    doc_add_plain_cell(t, s->now);
    doc_add_plain_cell(t, s->below);
    doc_add_plain_cell(t, s->above);
}

// For each parameter: how far its value can change before a check fails.  Those first that fail, then those whose values nothing notices.
static void add_margins(const Report *r, Doc *d)
{
    DocTable *t = DOC_ADD_TABLE(d, "margins", margin_columns);

    t->narrow = true;
    for (size_t rank = 0; rank <= 2; rank++)          // the last rank and all after it in the order of the source
        for (uint32_t i = 0; i < r->sweep->of.n; i++)
            if (rank == 2 ? rank_of(&r->sweep->of.at[i]) >= rank : rank_of(&r->sweep->of.at[i]) == rank)
                add_margin(t, &r->sweep->of.at[i]);
}

// The values that were tried for one parameter: checks that fail in each span, and the boundaries between spans.
static void add_parameter(const Report *r, Doc *d, const ReportSweepOf *s)
{
    DocTable *t;

    doc_add_heading(d, NULL, format_in(r->arena, "`%s` from %s to %s", s->parameter, s->from, s->to));
    if (*s->left_out)
        doc_add_plain(d, format_in(r->arena, s->has_scripts ? TEXT_SWEEP_LEFT_OUT : TEXT_SWEEP_ALL_LEFT_OUT, s->left_out));
    if (!s->has_scripts)
        return;
    t = doc_add_table(d, format_in(r->arena, "values.%s", s->parameter), span_columns, sizeof span_columns / sizeof *span_columns);
    t->narrow = true;
    for (uint32_t i = 0; i < s->span.n; i++) {
        doc_add_plain_cell(t, s->span.at[i].from);
        doc_add_plain_cell(t, s->span.at[i].to);
        doc_add_plain_cell(t, *s->span.at[i].fails ? s->span.at[i].fails : "nothing");
    }
    if (s->boundary.n) {
        t = doc_add_table(d, format_in(r->arena, "boundaries.%s", s->parameter), boundary_columns,
                          sizeof boundary_columns / sizeof *boundary_columns);
        t->narrow = true;
    }
    for (uint32_t i = 0; i < s->boundary.n; i++) {
        doc_add_plain_cell(t, s->boundary.at[i].check);
        doc_add_plain_cell(t, s->boundary.at[i].meaning);
        doc_add_plain_cell(t, s->boundary.at[i].passes);
        doc_add_plain_cell(t, s->boundary.at[i].fails);
    }
    if (s->boundary.n)
        doc_add_figure(d, s->svg, "Green: the check passes. Red: it fails. The dashed line is the current value.");
}

// Names the parameters that the sweep did not come to the end of.
static void add_not_swept(const Report *r, Doc *d)
{
    Buf names;

    buf_init(&names, r->arena);
    for (uint32_t i = 0; i < r->sweep->not_swept.n; i++)
        buf_printf(&names, "%s%s", describe_separator(i, r->sweep->not_swept.n), r->sweep->not_swept.at[i]);
    doc_add_plain(d, format_in(r->arena, TEXT_SWEEP_STOPPED, buf_text(&names)));
}

void report_add_sweep(Report *r, Doc *d)
{
    const ReportSweep *s = r->sweep;

    if (!s)
        return;
    doc_add_section(d, "sweep", "Parameters at other values");
    if (s->not_run) {
        doc_add_plain(d, format_in(r->arena, "No parameter was changed, because %s.", s->not_run));
        return;
    }
    if (s->not_swept.n)
        add_not_swept(r, d);
    if (s->of.n == 0) {
        if (s->not_swept.n == 0)
            doc_add_paragraph(d, TEXT_SWEEP_NONE);
        return;
    }
    doc_add_paragraph(d, TEXT_SWEEP);
    report_add_left_out(r, d);
    add_margins(r, d);
    for (uint32_t i = 0; i < s->of.n; i++)
        add_parameter(r, d, &s->of.at[i]);
}
