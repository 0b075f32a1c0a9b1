// SPDX-License-Identifier: Apache-2.0
// The findings of the analyses: all groups of warnings, even if disabled elsewhere, and those that an @allow covers, with its reason.
#include "compiler/report/describe.h"
#include "compiler/report/page.h"
#include "compiler/base/path.h"
#include "compiler/report/page_text.h"

#include <string.h>

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
    return format_in(r->arena, "%s:%lu:%lu", path_portable_name(span.src->name), (unsigned long)at.line, (unsigned long)at.col);
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

    if (r->members)
        return TEXT_STEP_OF_APP;
    if (r->analysis.step == 0)
        return r->runs > 1 ? TEXT_STEP_DIFFERS : TEXT_STEP_UNKNOWN;
    if (!r->step_given && r->analysis.p->step)
        return format_in(r->arena, TEXT_STEP_DECLARED, describe_time(r->arena, r->analysis.p, r->analysis.step));
    return format_in(r->arena, r->step_given ? TEXT_STEP_GIVEN : TEXT_STEP_OF_SCRIPTS, step);
}

// Findings of one part of the page: of a machine, or of an application's machines that come from one file.
typedef VEC(Diag *) Findings;
typedef struct FindingGroup { Findings open, allowed; } FindingGroup;

// Adds the tables of a group and each finding in detail, numbered from `first`.  name: added to the keys of the tables; "": none.
static void add_group(const Report *r, Doc *d, const FindingGroup *g, size_t first, const char *name)
{
    DocTable *t;

    if (g->open.n) {
        t = doc_add_table(d, format_in(r->arena, "findings%s", name), finding_columns, sizeof finding_columns / sizeof *finding_columns);
        for (size_t i = 0; i < g->open.n; i++)
            add_row(r, t, g->open.at[i], first + i);
    }
    if (g->allowed.n) {
        doc_add_heading(d, format_in(r->arena, "allowed%s", name), "Allowed findings");
        t = doc_add_table(d, format_in(r->arena, "allowed%s", name), allowed_columns, sizeof allowed_columns / sizeof *allowed_columns);
        for (size_t i = 0; i < g->allowed.n; i++)
            add_row(r, t, g->allowed.at[i], first + g->open.n + i);
    }
    add_details(r, d, g->open.at, g->open.n, first);
    add_details(r, d, g->allowed.at, g->allowed.n, first + g->open.n);
}

// ---- an application ----

static bool is_from(const Report *machine, const Source *src) { return strcmp(machine->analysis.p->src->name, src->name) == 0; }

// Returns the first machine in whose file the finding is; r->members: it is in none.
static size_t machine_of(const Report *r, const Diag *diag)
{
    size_t m = 0;

    while (m < r->members && !(diag->span.src && is_from(&r->member[m], diag->span.src)))
        m++;
    return m;
}

// Returns the heading of the findings in a machine's file: "Machine flight", or of several from one file "Machines drogue and main".
static const char *group_title(const Report *r, size_t first)
{
    const Source *src = r->member[first].analysis.p->src;
    size_t n = 0, at = 0;
    Buf out;

    for (size_t m = first; m < r->members; m++)
        n += is_from(&r->member[m], src);
    buf_init(&out, r->arena);
    buf_str(&out, n > 1 ? "Machines " : "Machine ");
    for (size_t m = first; m < r->members; m++)
        if (is_from(&r->member[m], src))
            buf_printf(&out, "%s%s", describe_separator(at++, n), r->member[m].of->name->text);
    return buf_text(&out);
}

// Adds the findings of an application: first those in its own files, then a part for each machine.
static void add_groups(const Report *r, Doc *d)
{
    const Diags *diags = r->analysis.diags;
    FindingGroup *group = ARENA_ARRAY(r->arena, FindingGroup, r->members + 1);
    size_t first = 1;

    for (size_t i = 0; i < diags->list.n; i++)
        vec_push(r->arena, &group[machine_of(r, diags->list.at[i])].open, diags->list.at[i]);
    for (size_t i = 0; i < diags->allowed.n; i++)
        vec_push(r->arena, &group[machine_of(r, diags->allowed.at[i])].allowed, diags->allowed.at[i]);
    for (size_t n = 0; n <= r->members; n++) {
        const size_t m = n == 0 ? r->members : n - 1;
        const char *name = n == 0 ? "-application" : format_in(r->arena, "-%s", r->member[m].of->name->text);
        if (group[m].open.n + group[m].allowed.n == 0)
            continue;
        doc_add_heading(d, format_in(r->arena, "findings-of%s", name), n == 0 ? TEXT_THE_APPLICATION : group_title(r, m));
        add_group(r, d, &group[m], first, name);
        first += group[m].open.n + group[m].allowed.n;
    }
}

// ---- the section ----

void report_add_findings(Report *r, Doc *d)
{
    const Diags *diags = r->analysis.diags;
    const size_t open = diags->list.n, allowed = diags->allowed.n;
    FindingGroup all = {{NULL, 0, 0}, {NULL, 0, 0}};

    doc_add_section(d, "findings", "Findings");
    doc_add_paragraph(d, format_in(r->arena, "%s %s", open ? TEXT_FINDINGS_OPEN : allowed ? TEXT_FINDINGS_ALLOWED : TEXT_FINDINGS_NONE,
                                   step_text(r)));
    if (r->members) {
        add_groups(r, d);
        return;
    }
    for (size_t i = 0; i < open; i++)
        vec_push(r->arena, &all.open, diags->list.at[i]);
    for (size_t i = 0; i < allowed; i++)
        vec_push(r->arena, &all.allowed, diags->allowed.at[i]);
    add_group(r, d, &all, 1, "");
}
