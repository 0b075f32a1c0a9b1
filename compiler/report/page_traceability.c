// SPDX-License-Identifier: Apache-2.0
// Traceability in both directions: from each requirement to its marks in the machine, from each part of the machine and each assert to its
// requirements.
#include "compiler/report/page.h"
#include "compiler/report/page_text.h"
#include "compiler/report/traceability.h"

// From requirements to the machine: each mark with the part of the program that it covers.
static void add_marks(const Traceability *t, Doc *d)
{
    static const DocColumn columns[] = {{"id", "Requirement"}, {"part", "Implemented in"}, {"line", "Line"}};
    DocTable *table = NULL;

    for (size_t i = 0; i < t->requirement.n; i++)
        for (size_t k = 0; k < t->requirement.at[i].mark.n; k++) {
            const TracedMark *m = &t->requirement.at[i].mark.at[k];
            if (!table)
                table = DOC_ADD_TABLE(d, "marks", columns);
            doc_add_code_cell(table, t->requirement.at[i].id->text);
            doc_add_code_cell(table, m->name);
            doc_add_line_cell(table, report_line_of(m->span));
        }
}

static bool has_marks(const Traceability *t)
{
    bool found = false;

    for (size_t i = 0; i < t->requirement.n; i++)
        found = found || t->requirement.at[i].mark.n;
    return found;
}

// From the machine to requirements: each state, transition and output with the requirements that apply to it.
static void add_parts(const Traceability *t, Doc *d)
{
    static const DocColumn columns[] = {{"state", "State"}, {"kind", "Kind"}, {"part", "Part"}, {"text", "Condition or statement"},
                                        {"line", "Line"}, {"requirements", "Requirements"}, {"by", "Marked at"}};
    static const char *const kind[TRACED_KINDS] = {"state", "all states", "transition", "output"};
    DocTable *table;

    if (!has_marks(t)) {
        doc_add_paragraph(d, TEXT_NO_MARKS);
        return;
    }
    doc_add_heading(d, NULL, "From the machine to requirements");
    table = DOC_ADD_TABLE(d, "parts", columns);
    for (size_t i = 0; i < t->part.n; i++) {
        const TracedPart *p = &t->part.at[i];
        if (p->state && p->kind != TRACED_ALL_STATES)
            doc_add_state_cell(table, p->state->name->text);
        else
            doc_add_plain_cell(table, p->where);
        doc_add_plain_cell(table, kind[p->kind]);
        doc_add_code_cell(table, p->name);
        doc_add_code_cell(table, p->text);
        doc_add_line_cell(table, report_line_of(p->span));
        doc_add_plain_cell(table, p->requirement.n ? traceability_ids(t, &p->requirement) : "none");
        doc_add_plain_cell(table, traced_by_name[p->by]);
    }
}

static bool has_asserts_with_requirements(const Traceability *t)
{
    bool found = false;

    for (size_t i = 0; i < t->assert.n; i++)
        found = found || t->assert.at[i].requirement;
    return found;
}

static void add_asserts(const Traceability *t, Doc *d)
{
    static const DocColumn columns[] = {{"place", "Place"}, {"text", "Text"}, {"evaluated", "Times"}, {"result", "Result"},
                                        {"requirement", "Requirement"}};
    DocTable *table;

    if (!has_asserts_with_requirements(t)) {
        if (t->assert.n)
            doc_add_paragraph(d, TEXT_NO_ASSERTS_WITH_REQUIREMENTS);
        return;
    }
    doc_add_heading(d, NULL, "From asserts to requirements");
    table = DOC_ADD_TABLE(d, "asserts", columns);
    for (size_t i = 0; i < t->assert.n; i++) {
        const TracedAssert *a = &t->assert.at[i];
        doc_add_plain_cell(table, traceability_place(t->arena, a->span));
        doc_add_plain_cell(table, a->text);
        doc_add_number_cell(table, a->evaluated);
        doc_add_plain_cell(table, a->result);
        doc_add_plain_cell(table, a->requirement ? t->requirement.at[a->requirement - 1].id->text : "none");
    }
}

void report_add_traceability(Report *r, Doc *d)
{
    Traceability *t;
    Buf summary;

    if (!r->requirements && r->analysis.p->mark.n == 0)
        return;
    t = traceability_new(r->arena, r->analysis.p, r->requirements);
    for (size_t i = 0; i < r->runs; i++)
        if (r->run[i].script)
            traceability_add_run(t, r->run[i].name, r->run[i].script, &r->run[i].result);
    traceability_finish(t);
    buf_init(&summary, r->arena);
    traceability_write_summary(t, &summary);
    doc_add_section(d, "traceability", "Traceability");
    doc_add_paragraph(d, TEXT_TRACEABILITY);
    doc_add_plain(d, buf_text(&summary));
    add_marks(t, d);
    add_parts(t, d);
    add_asserts(t, d);
}
