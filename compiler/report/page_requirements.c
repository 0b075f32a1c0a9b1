// SPDX-License-Identifier: Apache-2.0
// The requirements: where each is implemented, what tests it, how often it was judged, and the result in all scripts.
#include "compiler/base/path.h"
#include "compiler/report/page.h"
#include "compiler/report/page_text.h"

#include <string.h>

static const DocColumn columns[] = {{"id", "Requirement"},     {"text", "Text"},     {"place", "Place"},  {"implemented", "Implemented in"},
                                    {"asserts", "Tested by"}, {"scripts", "Judged in"}, {"judged", "Times"}, {"result", "Result"}};

static const char *place_text(const Report *r, Span s)
{
    return format_in(r->arena, "%s:%lu", path_portable_name(s.src->name), (unsigned long)report_line_of(s));
}

// Adds an entry to a list, unless it is the last one already.
static void add_entry(Buf *list, const char *entry)
{
    const size_t n = strlen(entry);

    if (list->n < n || memcmp(list->at + list->n - n, entry, n) != 0)
        buf_printf(list, "%s%s", list->n ? ", " : "", entry);
}

static const char *marks_text(const Report *r, Str id)
{
    const Program *p = r->requirements->program;
    Buf out;

    buf_init(&out, r->arena);
    for (size_t i = 0; i < p->mark.n; i++)
        if (p->mark.at[i].requirement == id)
            add_entry(&out, place_text(r, p->mark.at[i].span));
    return out.n ? buf_text(&out) : "nowhere";
}

// Adds the asserts of a run that test the requirement and were evaluated.
static void add_asserts(const Report *r, const ReportRun *run, Str id, Buf *out)
{
    for (size_t i = 0; i < run->script->section.n; i++)
        for (size_t k = 0; k < run->script->section.at[i].item.n; k++) {
            const ScriptItem *item = run->script->section.at[i].item.at[k];
            for (size_t n = 0; n < item->asserts.n; n++) {
                const ScriptAssert *a = &item->asserts.at[n];
                const uint32_t number = item->first_assert + (uint32_t)n;
                if (a->remark && a->remark->requirement == id && (a->kind == SCRIPT_FAIL || run->result.evaluated[number]))
                    add_entry(out, format_in(r->arena, "%s%s", place_text(r, a->remark->span), run->result.failed_asserts[number] ? " (failed)" : ""));
            }
        }
}

static const char *asserts_text(const Report *r, Str id)
{
    Buf out;

    buf_init(&out, r->arena);
    for (size_t i = 0; i < r->runs; i++)
        if (r->run[i].script && r->run[i].result.evaluated)
            add_asserts(r, &r->run[i], id, &out);
    return buf_text(&out);
}

static const char *scripts_text(const Report *r, size_t requirement)
{
    Buf out;

    buf_init(&out, r->arena);
    for (size_t i = 0; i < r->runs; i++)
        if (r->run[i].result.requirement && r->run[i].result.requirement[requirement].judged)
            buf_printf(&out, "%s%s", out.n ? ", " : "", r->run[i].name);
    return out.n ? buf_text(&out) : "no script";
}

void report_add_requirements(Report *r, Doc *d)
{
    const Requirements *all = r->requirements;
    RequirementTotal *total;
    DocTable *t;

    if (!all)
        return;
    total = ARENA_ARRAY(r->arena, RequirementTotal, all->at.n);
    for (size_t i = 0; i < r->runs; i++)
        if (r->run[i].script)
            requirement_add_run(total, all, &r->run[i].result);
    doc_add_section(d, "requirements", "Requirements");
    doc_add_paragraph(d, TEXT_REQUIREMENTS);
    t = DOC_ADD_TABLE(d, "requirements", columns);
    for (size_t i = 0; i < all->at.n; i++) {
        const Requirement *q = &all->at.at[i];
        doc_add_code_cell(t, q->id->text);
        doc_add_plain_cell(t, q->text->text);
        doc_add_plain_cell(t, place_text(r, q->span));
        doc_add_plain_cell(t, marks_text(r, q->id));
        doc_add_plain_cell(t, asserts_text(r, q->id));
        doc_add_plain_cell(t, scripts_text(r, i));
        doc_add_number_cell(t, total[i].judged);
        doc_add_plain_cell(t, requirement_verdict(&total[i]));
    }
}
