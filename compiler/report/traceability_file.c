// SPDX-License-Identifier: Apache-2.0
// Traceability as files: CSV for spreadsheets, JSON for programs, and the summary line of a test.  Names of columns and keys are stable.
#include <inttypes.h>
#include <string.h>

#include "compiler/base/json.h"
#include "compiler/base/path.h"
#include "compiler/report/describe.h"
#include "compiler/report/traceability.h"

// ---- summary ----

// Appends "n what"; nothing for 0. `separator` is what precedes the next count.
static void write_count(Buf *out, uint32_t n, const char *what, const char **separator)
{
    if (n == 0)
        return;
    buf_printf(out, "%s%lu %s", *separator, (unsigned long)n, what);
    *separator = ", ";
}

static void write_part_count(const Traceability *t, TracedKind kind, const char *one, const char *many, Buf *out, const char **separator)
{
    if (t->counts.unmarked[kind] == 0)
        return;
    buf_printf(out, "%s%s", *separator, describe_count(t->arena, t->counts.unmarked[kind], one, many));
    *separator = ", ";
}

void traceability_write_summary(const Traceability *t, Buf *out)
{
    const char *separator = ": ";
    const size_t start = out->n;

    buf_str(out, describe_count(t->arena, t->requirement.n, "requirement", "requirements"));
    write_count(out, t->counts.tested, "tested", &separator);
    write_count(out, t->counts.violated, "violated", &separator);
    write_count(out, t->counts.undecided, "undecided", &separator);
    write_count(out, t->counts.untested, "untested", &separator);
    separator = out->n > start ? "; " : "";
    write_part_count(t, TRACED_TRANSITION, "transition", "transitions", out, &separator);
    write_part_count(t, TRACED_OUTPUT, "output", "outputs", out, &separator);
    write_part_count(t, TRACED_STATE, "state", "states", out, &separator);
    if (strcmp(separator, ", ") == 0)
        buf_str(out, " without a requirement");
    buf_char(out, '\n');
}

// ---- CSV ----

// Appends a field.  A spreadsheet takes a text that begins with one of =+-@ for a formula, so an apostrophe precedes it.
static void write_field(Buf *out, const char *text)
{
    const bool is_quoted = strpbrk(text, ",;\"\r\n") != NULL;

    if (is_quoted)
        buf_char(out, '"');
    if (*text && strchr("=+-@\t\r", *text))
        buf_char(out, '\'');
    for (; *text; text++) {
        if (*text == '"')
            buf_char(out, '"');
        buf_char(out, *text == '\r' || *text == '\n' ? ' ' : *text);
    }
    if (is_quoted)
        buf_char(out, '"');
}

// The columns, in their order.
typedef struct CsvRow {
    const char *kind, *name, *text, *place, *requirements, *by, *implemented, *asserts, *scripts, *times, *result, *proof;
} CsvRow;

static void write_row(Buf *out, const CsvRow *r)
{
    const char *const field[] = {r->kind, r->name, r->text, r->place, r->requirements, r->by, r->implemented, r->asserts, r->scripts, r->times,
                                 r->result, r->proof};

    for (size_t i = 0; i < sizeof field / sizeof *field; i++) {
        if (i)
            buf_char(out, ',');
        write_field(out, field[i] ? field[i] : "");
    }
    buf_str(out, "\r\n");
}

static const char *list_marks(const Traceability *t, const TracedRequirement *q)
{
    Buf out;

    buf_init(&out, t->arena);
    for (size_t i = 0; i < q->mark.n; i++)
        buf_printf(&out, "%s%s (%s)", i ? "; " : "", q->mark.at[i].name, traceability_place(t->arena, q->mark.at[i].span));
    return buf_text(&out);
}

static const char *list_asserts(const Traceability *t, const TracedRequirement *q)
{
    Buf out;

    buf_init(&out, t->arena);
    for (size_t i = 0; i < q->assert.n; i++) {
        const TracedAssert *a = &t->assert.at[q->assert.at[i]];
        buf_printf(&out, "%s%s (%s)", i ? "; " : "", traceability_place(t->arena, a->span), a->result);
    }
    return buf_text(&out);
}

static const char *list_runs(const Traceability *t, const TracedRequirement *q)
{
    Buf out;

    buf_init(&out, t->arena);
    for (size_t i = 0; i < q->run.n; i++)
        buf_printf(&out, "%s%s (%" PRIu64 ")", i ? "; " : "", t->script.at[q->run.at[i].script].name, q->run.at[i].judged);
    return buf_text(&out);
}

static const char *outcome_text(ScriptOutcome o) { return o == SCRIPT_PASSED ? "passed" : "failed"; }

void traceability_write_csv(const Traceability *t, Buf *out)
{
    buf_str(out, "kind,name,text,place,requirements,by,implemented,asserts,scripts,times,result,proof\r\n");
    for (size_t i = 0; i < t->requirement.n; i++) {
        const TracedRequirement *q = &t->requirement.at[i];
        write_row(out, &(CsvRow){.kind = "requirement", .name = q->id->text, .text = q->what ? q->what->text->text : "",
                                 .place = q->what ? traceability_place(t->arena, q->what->span) : "", .implemented = list_marks(t, q),
                                 .asserts = list_asserts(t, q), .scripts = list_runs(t, q),
                                 .times = format_in(t->arena, "%" PRIu64, q->total.judged), .result = q->result, .proof = q->proof});
    }
    for (size_t i = 0; i < t->part.n; i++) {
        const TracedPart *p = &t->part.at[i];
        write_row(out, &(CsvRow){.kind = traced_kind_name[p->kind], .name = p->name, .text = p->text, .place = traceability_place(t->arena, p->span),
                                 .requirements = traceability_ids(t, &p->requirement), .by = traced_by_name[p->by]});
    }
    for (size_t i = 0; i < t->script.n; i++)
        write_row(out, &(CsvRow){.kind = "script", .name = t->script.at[i].name, .requirements = traceability_ids(t, &t->script.at[i].requirement),
                                 .result = outcome_text(t->script.at[i].outcome)});
    for (size_t i = 0; i < t->assert.n; i++) {
        const TracedAssert *a = &t->assert.at[i];
        write_row(out, &(CsvRow){.kind = "assert", .name = traceability_place(t->arena, a->span), .text = a->text,
                                 .place = traceability_place(t->arena, a->span),
                                 .requirements = a->requirement ? t->requirement.at[a->requirement - 1].id->text : "",
                                 .scripts = t->script.at[a->script].name, .times = format_in(t->arena, "%" PRIu64, a->evaluated), .result = a->result});
    }
}

// ---- JSON ----

static void write_place(Buf *out, Span s)
{
    buf_str(out, "\"file\":");
    json_put_string(out, source_short_name(s.src));
    buf_printf(out, ",\"line\":%lu", (unsigned long)source_position(s.src, s.at).line);
}

// Appends a member to a JSON object that has at least one member.
static void write_member(Buf *out, const char *key, const char *text)
{
    buf_printf(out, ",\"%s\":", key);
    json_put_string(out, text);
}

static void write_ids(const Traceability *t, const TraceIndices *list, Buf *out)
{
    buf_str(out, ",\"requirements\":[");
    for (size_t i = 0; i < list->n; i++) {
        buf_str(out, i ? "," : "");
        json_put_string(out, t->requirement.at[list->at[i]].id->text);
    }
    buf_char(out, ']');
}

static void write_requirement(const Traceability *t, const TracedRequirement *q, Buf *out)
{
    buf_str(out, "{\"id\":");
    json_put_string(out, q->id->text);
    write_member(out, "text", q->what ? q->what->text->text : NULL);
    if (q->what) {
        buf_char(out, ',');
        write_place(out, q->what->span);
    }
    buf_str(out, ",\"implemented\":[");
    for (size_t i = 0; i < q->mark.n; i++) {
        buf_str(out, i ? ",{" : "{");
        write_place(out, q->mark.at[i].span);
        write_member(out, "name", q->mark.at[i].name);
        buf_char(out, '}');
    }
    buf_str(out, "],\"asserts\":[");
    for (size_t i = 0; i < q->assert.n; i++)
        buf_printf(out, "%s%lu", i ? "," : "", (unsigned long)q->assert.at[i]);
    buf_str(out, "],\"judged\":[");
    for (size_t i = 0; i < q->run.n; i++) {
        buf_str(out, i ? ",{\"script\":" : "{\"script\":");
        json_put_string(out, t->script.at[q->run.at[i].script].name);
        buf_printf(out, ",\"steps\":%" PRIu64 "}", q->run.at[i].judged);
    }
    buf_printf(out, "],\"steps\":%" PRIu64, q->total.judged);
    write_member(out, "unvisited", q->unvisited);
    write_member(out, "result", q->result);
    write_member(out, "proof", q->proof);
    buf_char(out, '}');
}

static void write_part(const Traceability *t, const TracedPart *p, Buf *out)
{
    buf_printf(out, "{\"kind\":\"%s\"", traced_kind_name[p->kind]);
    write_member(out, "where", p->where);
    write_member(out, "name", p->name);
    write_member(out, "text", p->text);
    buf_char(out, ',');
    write_place(out, p->span);
    write_ids(t, &p->requirement, out);
    write_member(out, "by", traced_by_name[p->by]);
    buf_char(out, '}');
}

static void write_assert(const Traceability *t, const TracedAssert *a, Buf *out)
{
    static const char *const kind[] = {"assert", "fail", "expect", "print"};

    buf_printf(out, "{\"kind\":\"%s\",", kind[a->kind]);
    write_place(out, a->span);
    write_member(out, "script", t->script.at[a->script].name);
    write_member(out, "text", a->text);
    write_member(out, "requirement", a->requirement ? t->requirement.at[a->requirement - 1].id->text : NULL);
    buf_printf(out, ",\"evaluated\":%" PRIu64, a->evaluated);
    write_member(out, "result", a->result);
    buf_char(out, '}');
}

void traceability_write_json(const Traceability *t, Buf *out)
{
    const TraceCounts *n = &t->counts;

    buf_str(out, "{\"smc-traceability\":1,\"machine\":");
    json_put_string(out, t->program->name->text);
    buf_printf(out, ",\"tested\":%lu,\"violated\":%lu,\"undecided\":%lu,\"untested\":%lu,\"without\":{", (unsigned long)n->tested,
               (unsigned long)n->violated, (unsigned long)n->undecided, (unsigned long)n->untested);
    for (int k = 0; k < TRACED_KINDS; k++)
        buf_printf(out, "%s\"%s\":%lu", k ? "," : "", traced_kind_name[k], (unsigned long)n->unmarked[k]);
    buf_str(out, "},\n\"requirements\":[");
    for (size_t i = 0; i < t->requirement.n; i++) {
        buf_str(out, i ? ",\n" : "\n");
        write_requirement(t, &t->requirement.at[i], out);
    }
    buf_str(out, "],\n\"parts\":[");
    for (size_t i = 0; i < t->part.n; i++) {
        buf_str(out, i ? ",\n" : "\n");
        write_part(t, &t->part.at[i], out);
    }
    buf_str(out, "],\n\"scripts\":[");
    for (size_t i = 0; i < t->script.n; i++) {
        buf_str(out, i ? ",\n{\"name\":" : "\n{\"name\":");
        json_put_string(out, t->script.at[i].name);
        write_member(out, "result", outcome_text(t->script.at[i].outcome));
        write_ids(t, &t->script.at[i].requirement, out);
        buf_char(out, '}');
    }
    buf_str(out, "],\n\"asserts\":[");
    for (size_t i = 0; i < t->assert.n; i++) {
        buf_str(out, i ? ",\n" : "\n");
        write_assert(t, &t->assert.at[i], out);
    }
    buf_str(out, "]}\n");
}
