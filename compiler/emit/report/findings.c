// SPDX-License-Identifier: Apache-2.0
// What the analyses found: all groups of warnings, whatever is switched on elsewhere, and those that an @allow covers with its reason.
#include <string.h>

#include "compiler/emit/report/report.h"

static bool covers(const Allow *a, const Diag *diag)
{
    const char *flag = diag_info[diag->code].flag;

    return flag && strcmp(flag, a->flag) == 0 && diag->span.src == a->covers.src && diag->span.at >= a->covers.at
        && diag->span.at <= a->covers.at + a->covers.len;
}

// The @allow that covers a finding, or NULL.
static const Allow *allow_of(const Report *r, const Diag *diag)
{
    const Program *p = r->analysis.p;

    for (size_t i = 0; i < p->allow.n; i++)
        if (covers(&p->allow.at[i], diag))
            return &p->allow.at[i];
    return NULL;
}

FindingCount report_count_findings(const Report *r)
{
    const Diags *diags = r->analysis.diags;
    FindingCount n = {0, 0};

    for (size_t i = 0; i < diags->list.n; i++)
        if (allow_of(r, diags->list.at[i]))
            n.allowed++;
        else
            n.open++;
    return n;
}

static const char *group_of(const Diag *diag)
{
    static const char *const name[] = {"on by default", "-Wextra", "-Wflight"};
    const DiagFlag *flag = diag_info[diag->code].flag ? diag_find_flag(diag_info[diag->code].flag) : NULL;

    return flag ? name[flag->group] : "";
}

static const char *name_of(const Diag *diag) { return diag_info[diag->code].flag ? diag_info[diag->code].flag : ""; }

// ---- one finding at length ----

static const char *place_of(const Report *r, Span span)
{
    LineCol at;

    if (!span.src)
        return "";
    at = source_position(span.src, span.at);
    return format_in(r->arena, "%s:%lu:%lu", report_file_name(span.src->name), (unsigned long)at.line, (unsigned long)at.col);
}

static void put_notes(const Report *r, Doc *d, const Diag *diag, size_t number)
{
    DocList *l;

    if (diag->notes.n == 0)
        return;
    l = doc_list(d, format_in(r->arena, "notes.%lu", (unsigned long)number), NULL);
    for (size_t i = 0; i < diag->notes.n; i++)
        list_line(l, 0, diag->notes.at[i].span.src == r->analysis.p->src ? report_line(diag->notes.at[i].span) : 0, diag->notes.at[i].text);
}

static void put_finding(const Report *r, Doc *d, const Diag *diag, size_t number)
{
    const Allow *allow = allow_of(r, diag);
    DocPart *heading = doc_heading(d, format_in(r->arena, "finding-%lu", (unsigned long)number), diag->text);

    heading->badge = allow ? "allowed" : format_in(r->arena, "%s %s", diag_info[diag->code].id, name_of(diag));
    heading->tone = allow ? "good" : diag->severity == DIAG_ERROR ? "bad" : "note";
    if (allow)
        doc_quote(d, format_in(r->arena, "Allowed: %s", allow->reason->text));
    doc_excerpt(d, diag->span, diag->label);
    put_notes(r, d, diag, number);
}

// ---- the tables ----

static const DocColumn finding_columns[] = {
    {"number", "No."}, {"name", "Name"}, {"group", "Group"}, {"place", "Place"}, {"message", "What was found"}, {"code", "Code"}};
static const DocColumn allowed_columns[] = {
    {"number", "No."}, {"name", "Name"}, {"place", "Place"}, {"message", "What was found"}, {"reason", "Why it is allowed"}};

static void put_row(const Report *r, DocTable *t, const Diag *diag, const Allow *allow, size_t number)
{
    cell_number(t, number);
    cell_code(t, name_of(diag));
    if (!allow)
        cell_plain(t, group_of(diag));
    cell_plain(t, place_of(r, diag->span));
    cell_text(t, diag->text);
    cell_plain(t, allow ? allow->reason->text : diag_info[diag->code].id);
}

static void put_table(const Report *r, Doc *d, bool allowed)
{
    const Diags *diags = r->analysis.diags;
    DocTable *t = allowed ? DOC_TABLE_OF(d, "allowed", allowed_columns) : DOC_TABLE_OF(d, "findings", finding_columns);

    for (size_t i = 0; i < diags->list.n; i++) {
        const Allow *allow = allow_of(r, diags->list.at[i]);
        if ((allow != NULL) == allowed)
            put_row(r, t, diags->list.at[i], allow, i + 1);
    }
}

void report_findings(Report *r, Doc *d)
{
    const Diags *diags = r->analysis.diags;
    const FindingCount n = report_count_findings(r);

    doc_section(d, "findings", "Findings");
    doc_paragraph(d, n.open ? "What the analyses found, of all groups. `smc explain` with a name or code prints what it means and what to do."
                            : "The analyses of all groups found nothing that is not allowed with a reason.");
    if (n.open)
        put_table(r, d, false);
    if (n.allowed) {
        doc_heading(d, "allowed", "Allowed with a reason");
        put_table(r, d, true);
    }
    for (size_t i = 0; i < diags->list.n; i++)
        put_finding(r, d, diags->list.at[i], i + 1);
}
