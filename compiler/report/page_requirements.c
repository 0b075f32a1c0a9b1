// SPDX-License-Identifier: Apache-2.0
// The requirements: the rule, result and proof of each, how many faults violate it, where it is implemented and what tests it, in how many steps it
// was judged, and which states no script came to.
#include "compiler/base/path.h"
#include "compiler/prove/prove_text.h"
#include "compiler/report/page.h"
#include "compiler/report/page_text.h"

#include <string.h>

static const DocColumn verdict_columns[] = {{"id", "Requirement"}, {"text", "Text"},   {"rule", "Rule"}, {"result", "Verdict"},
                                            {"proof", "Proof"},    {"faults", "Faults that violate it first"}};
static const DocColumn place_columns[] = {{"id", "Requirement"}, {"text", "Text"},        {"place", "Place"},  {"implemented", "Implemented in"},
                                          {"asserts", "Tested by"}, {"scripts", "Judged in"}, {"judged", "Times"},
                                          {"unvisited", "No script came to"}, {"result", "Result"}};

static const char *place_text(const Report *r, Span s)
{
    return format_in(r->arena, "%s:%lu", source_short_name(s.src), (unsigned long)report_line_of(s));
}

// Adds an entry to a list, unless it is the last one already.
static void add_entry(Buf *list, const char *entry)
{
    const size_t n = strlen(entry);

    if (list->n < n || memcmp(list->at + list->n - n, entry, n) != 0)
        buf_printf(list, "%s%s", list->n ? ", " : "", entry);
}

// Where the program implements the requirement: files and lines of the marks that name it.
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
                    add_entry(out, format_in(r->arena, "%s%s", place_text(r, a->remark->span),
                                             run->result.failed_asserts[number] ? " (failed)" : ""));
            }
        }
}

// The asserts of all scripts that name the requirement.
static const char *asserts_text(const Report *r, Str id)
{
    Buf out;

    buf_init(&out, r->arena);
    for (size_t i = 0; i < r->runs; i++)
        if (r->run[i].script && r->run[i].result.evaluated)
            add_asserts(r, &r->run[i], id, &out);
    return buf_text(&out);
}

// The scripts that judged the requirement, by name; only their number when there are more than NAMED_MOST.
static const char *scripts_text(const Report *r, size_t requirement)
{
    enum { NAMED_MOST = 3 };
    size_t judged = 0;
    Buf out;

    buf_init(&out, r->arena);
    for (size_t i = 0; i < r->runs; i++)
        if (r->run[i].result.requirement && r->run[i].result.requirement[requirement].judged) {
            buf_printf(&out, "%s%s", out.n ? ", " : "", r->run[i].name);
            judged++;
        }
    if (judged > NAMED_MOST)
        return format_in(r->arena, "%lu of %lu scripts", (unsigned long)judged, (unsigned long)r->runs);
    return out.n ? buf_text(&out) : "no script";
}

// Returns the rule of a requirement as written, on one line and without comments: what follows its text, up to the next requirement.
static const char *rule_text(const Report *r, size_t requirement)
{
    const Requirement *q = &r->requirements->at.at[requirement];
    const Source *src = q->span.src;
    const char *at = src->text + q->span.at + q->span.len, *end = src->text + src->len;
    Buf out;

    buf_init(&out, r->arena);
    if (requirement + 1 < r->requirements->at.n && q[1].span.src == src)
        end = src->text + q[1].span.at;
    for (int quotes = 0; at < end && quotes < 2; at++)
        quotes += *at == '"';
    for (bool blank = false; at < end; at++) {
        if (*at == '#')
            while (at + 1 < end && at[1] != '\n')
                at++;
        else if (*at == ' ' || *at == '\t' || *at == '\n' || *at == '\r')
            blank = out.n > 0;
        else {
            buf_str(&out, blank ? " " : "");
            buf_char(&out, *at);
            blank = false;
        }
    }
    return buf_text(&out);
}

// Adds how many faults of inputs violate a requirement, with a link to the first of them.
static void add_faults_cell(const Report *r, DocTable *t, size_t requirement)
{
    const ReportFaults *f = r->faults;
    const ReportFaultsOf *of = f && requirement < f->of.n ? &f->of.at[requirement] : NULL;
    const char *text = of && of->faults ? format_in(r->arena, "%lu", of->faults) : of ? "none" : "";

    if (of && of->line)
        doc_add_linked_badge_cell(t, text, "bad", format_in(r->arena, "fault-%lu", (unsigned long)of->line));
    else
        doc_add_plain_cell(t, text);
}

// For each requirement: the rule, the worse of its result in scripts and its proof, and its proof.
static void add_verdicts(const Report *r, Doc *d, const RequirementTotal *total)
{
    const Requirements *all = r->requirements;
    DocTable *t = DOC_ADD_TABLE(d, "verdicts", verdict_columns);

    for (size_t i = 0; i < all->at.n; i++) {
        const Requirement *q = &all->at.at[i];
        doc_add_code_cell(t, q->id->text);
        doc_add_plain_cell(t, q->text->text);
        doc_add_code_cell(t, rule_text(r, i));
        if (r->proofs && r->proofs->of[i].verdict == PROVE_VIOLATED)
            doc_add_badge_cell(t, "violated", "bad");
        else
            doc_add_badge_cell(t, requirement_verdict(&total[i]),
                               total[i].violated ? "bad" : total[i].undecided || !total[i].judged ? "note" : "good");
        doc_add_badge_cell(t, r->proofs ? prove_verdict_words(r->proofs->of[i].verdict) : "",
                           r->proofs ? report_proof_tone(r->proofs->of[i].verdict) : NULL);
        add_faults_cell(r, t, i);
    }
}

// For each requirement: where it is written, implemented, asserted and judged.
static void add_places(const Report *r, Doc *d, const RequirementTotal *total)
{
    const Requirements *all = r->requirements;
    bool *visited = ARENA_ARRAY(r->arena, bool, all->program->state.n);
    DocTable *t;

    for (size_t i = 0; i < r->runs; i++)
        if (r->run[i].script)
            requirement_add_visits(visited, all->program, &r->run[i].result);
    doc_add_heading(d, NULL, "Where each requirement is implemented and judged");
    t = DOC_ADD_TABLE(d, "requirements", place_columns);
    for (size_t i = 0; i < all->at.n; i++) {
        const Requirement *q = &all->at.at[i];
        doc_add_code_cell(t, q->id->text);
        doc_add_plain_cell(t, q->text->text);
        doc_add_plain_cell(t, place_text(r, q->span));
        doc_add_plain_cell(t, marks_text(r, q->id));
        doc_add_plain_cell(t, asserts_text(r, q->id));
        doc_add_plain_cell(t, scripts_text(r, i));
        doc_add_number_cell(t, total[i].judged);
        doc_add_plain_cell(t, requirement_unvisited(r->arena, q, all->program, visited));
        doc_add_plain_cell(t, requirement_verdict(&total[i]));
    }
}

void report_add_requirements(Report *r, Doc *d)
{
    RequirementTotal *total;

    if (!r->requirements)
        return;
    total = ARENA_ARRAY(r->arena, RequirementTotal, r->requirements->at.n);
    for (size_t i = 0; i < r->runs; i++)
        if (r->run[i].script)
            requirement_add_run(total, r->requirements, &r->run[i].result);
    doc_add_section(d, "requirements", "Requirements");
    doc_add_paragraph(d, TEXT_REQUIREMENTS);
    add_verdicts(r, d, total);
    add_places(r, d, total);
}
