// SPDX-License-Identifier: Apache-2.0
// The findings of the analyses: all groups of warnings, even if disabled elsewhere, and those that an @allow covers, with its reason.
#include "compiler/report/describe.h"
#include "compiler/report/page.h"
#include "compiler/base/path.h"
#include "compiler/report/page_text.h"

FindingCount report_count_findings(const Report *r)
{
    return (FindingCount){r->analysis.diags->list.n, r->analysis.diags->allowed.n};
}

// The group of warnings that the finding belongs to; empty for an error.
static const char *group_name(const Diag *diag)
{
    static const char *const name[] = {"on by default", "-Wextra", "-Wflight"};
    const DiagFlag *flag = diag_info[diag->code].flag ? diag_find_flag(diag_info[diag->code].flag) : NULL;

    return flag ? name[flag->group] : "";
}

// ---- one finding in detail ----

static const char *position_text(const Report *r, Span span)
{
    LineCol at;

    if (!span.src)
        return "";
    at = source_position(span.src, span.at);
    return format_in(r->arena, "%s:%lu:%lu", source_short_name(span.src), (unsigned long)at.line, (unsigned long)at.col);
}

static void add_finding(const Report *r, Doc *d, const Diag *diag, size_t number)
{
    DocPart *heading = doc_add_heading(d, format_in(r->arena, "finding-%lu", (unsigned long)number), diag->text);
    DocList *l = NULL;

    heading->plain = true;
    heading->badge = diag->allowed ? "allowed" : diag_code_and_name(diag, r->arena);
    heading->tone = diag->allowed ? "good" : diag->severity == DIAG_ERROR ? "bad" : "note";
    if (diag->allowed)
        doc_add_quote(d, format_in(r->arena, "Allowed: %s", diag->allowed));
    doc_add_excerpt(d, diag->span, diag->label);
    if (diag->notes.n)
        l = doc_add_list(d, format_in(r->arena, "notes.%lu", (unsigned long)number), NULL);
    for (size_t i = 0; i < diag->notes.n; i++)
        doc_add_list_line(l, 0, diag->notes.at[i].span.src == r->analysis.p->src ? report_line_of(diag->notes.at[i].span) : 0,
                          diag->notes.at[i].text);
    if (diag->edits.n)
        doc_add_paragraph(d, TEXT_FINDING_FIXABLE);
}

// ---- the tables ----

static const DocColumn finding_columns[] = {
    {"number", "No."}, {"name", "Name"}, {"group", "Group"}, {"position", "Position"}, {"message", "Finding"}, {"code", "Code"}};
static const DocColumn allowed_columns[] = {
    {"number", "No."}, {"name", "Name"}, {"position", "Position"}, {"message", "Finding"}, {"reason", "Reason"}};

static void add_row(const Report *r, DocTable *t, const Diag *diag, size_t number)
{
    doc_add_number_cell(t, number);
    doc_add_code_cell(t, diag_info[diag->code].flag);
    if (!diag->allowed)
        doc_add_plain_cell(t, group_name(diag));
    doc_add_plain_cell(t, position_text(r, diag->span));
    doc_add_plain_cell(t, diag->text);
    doc_add_plain_cell(t, diag->allowed ? diag->allowed : diag_info[diag->code].id);
}

// Writes findings in detail, numbered from `first`.
static void add_details(const Report *r, Doc *d, Diag *const *diag, size_t n, size_t first)
{
    for (size_t i = 0; i < n; i++)
        add_finding(r, d, diag[i], first + i);
}

// Returns the paragraph about the time by which a step advances G, which some findings assume.
static const char *step_text(const Report *r)
{
    const unsigned long step = (unsigned long)r->analysis.step;

    if (r->members || r->of)
        return TEXT_STEP_OF_APP;
    if (r->analysis.step == 0)
        return r->runs > 1 ? TEXT_STEP_DIFFERS : TEXT_STEP_UNKNOWN;
    if (!r->step_given && r->analysis.p->step)
        return format_in(r->arena, TEXT_STEP_DECLARED, describe_time(r->arena, r->analysis.p, r->analysis.step));
    return format_in(r->arena, r->step_given ? TEXT_STEP_GIVEN : TEXT_STEP_OF_SCRIPTS, step);
}

void report_add_findings(Report *r, Doc *d)
{
    const Diags *diags = r->analysis.diags;
    const size_t open = diags->list.n, allowed = diags->allowed.n;
    DocTable *t;

    doc_add_section(d, "findings", "Findings");
    doc_add_paragraph(d, format_in(r->arena, "%s %s", open ? TEXT_FINDINGS_OPEN : allowed ? TEXT_FINDINGS_ALLOWED : TEXT_FINDINGS_NONE,
                                   step_text(r)));
    if (open) {
        t = DOC_ADD_TABLE(d, "findings", finding_columns);
        for (size_t i = 0; i < open; i++)
            add_row(r, t, diags->list.at[i], i + 1);
    }
    if (allowed) {
        doc_add_heading(d, "allowed", "Allowed findings");
        t = DOC_ADD_TABLE(d, "allowed", allowed_columns);
        for (size_t i = 0; i < allowed; i++)
            add_row(r, t, diags->allowed.at[i], open + i + 1);
    }
    add_details(r, d, diags->list.at, open, 1);
    add_details(r, d, diags->allowed.at, allowed, open + 1);
}
