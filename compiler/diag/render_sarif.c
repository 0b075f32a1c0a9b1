// SPDX-License-Identifier: Apache-2.0
// Renders the diagnostics as one document of SARIF 2.1.0, the OASIS format that code-hosting sites and review tools read. Columns count
// characters, not bytes, and the end column is exclusive.
#include <string.h>

#include "compiler/base/json.h"
#include "compiler/base/utf8.h"
#include "compiler/diag/diag.h"

// ---- locations ----

// Writes a path as a relative reference: characters with a meaning in URIs become %XX, a backslash becomes a slash.
static void put_uri(Buf *out, const char *path)
{
    buf_char(out, '"');
    for (const char *s = path; *s; s++)
        if (*s == '\\')
            buf_char(out, '/');
        else if ((*s >= 'a' && *s <= 'z') || (*s >= 'A' && *s <= 'Z') || (*s >= '0' && *s <= '9') || strchr("-._~/", *s))
            buf_char(out, *s);
        else
            buf_printf(out, "%%%02X", (unsigned)(unsigned char)*s);
    buf_char(out, '"');
}

// Returns the column counted in characters, from 1; LineCol counts bytes.
static unsigned long column_in_characters(const Source *src, LineCol where)
{
    const char *s = src->text + src->line[where.line - 1];
    uint32_t left = where.col - 1, code;
    unsigned long column = 1;

    for (; left; column++) {
        size_t len = utf8_decode(s, left, &code);
        s += len ? len : 1;
        left -= len ? (uint32_t)len : 1;
    }
    return column;
}

static void put_region(Buf *out, Span span)
{
    LineCol from = source_position(span.src, span.at), to = source_position(span.src, span.at + span.len);

    buf_printf(out, "{\"startLine\":%lu,\"startColumn\":%lu,\"endLine\":%lu,\"endColumn\":%lu}", (unsigned long)from.line,
               column_in_characters(span.src, from), (unsigned long)to.line, column_in_characters(span.src, to));
}

static void put_artifact_location(Buf *out, Span span)
{
    buf_str(out, "\"artifactLocation\":{\"uri\":");
    put_uri(out, span.src->name);
    buf_char(out, '}');
}

static void put_physical_location(Buf *out, Span span)
{
    buf_str(out, "\"physicalLocation\":{");
    put_artifact_location(out, span);
    buf_str(out, ",\"region\":");
    put_region(out, span);
    buf_char(out, '}');
}

static void put_message(Buf *out, const char *text)
{
    buf_str(out, "{\"text\":");
    json_put_string(out, text);
    buf_char(out, '}');
}

// ---- rules: the codes that were used, each once, in the order of codes.def ----

// Returns the first paragraph of the page that is not an example, on one line; the diagnostic's message if there is no such paragraph.
static const char *first_paragraph(Arena *arena, const DiagInfo *row)
{
    const char *at = row->page, *end;
    Buf out;

    buf_init(&out, arena);
    while (*at == ' ' && (end = strstr(at, "\n\n")) != NULL)
        at = end + 2;
    if (*at == ' ' || *at == '\0') {
        diag_put_title(row, &out);
        return buf_text(&out);
    }
    for (; *at && !(at[0] == '\n' && (at[1] == '\n' || at[1] == '\0')); at++)
        buf_char(&out, *at == '\n' ? ' ' : *at);
    return buf_text(&out);
}

// Writes the SARIF rule of a code. The rule of a warning has the warning's name, as after -W and in @allow.
static void put_rule(Buf *out, const DiagInfo *row)
{
    const DiagFlag *flag = row->flag ? diag_find_flag(row->flag) : NULL;
    Buf title;

    buf_init(&title, out->arena);
    diag_put_title(row, &title);
    buf_printf(out, "{\"id\":\"%s\",\"name\":\"%s\",\"shortDescription\":", row->id, row->flag ? row->flag : row->name);
    put_message(out, buf_text(&title));
    buf_str(out, ",\"fullDescription\":");
    put_message(out, first_paragraph(out->arena, row));
    buf_str(out, ",\"help\":{\"text\":");
    json_put_string(out, row->page);
    buf_str(out, ",\"markdown\":");
    json_put_string(out, row->page);
    buf_printf(out, "},\"defaultConfiguration\":{\"enabled\":%s,\"level\":\"%s\"}",
               flag && flag->group != DIAG_GROUP_ALL ? "false" : "true", row->severity == DIAG_ERROR ? "error" : "warning");
    if (flag)
        buf_printf(out, ",\"properties\":{\"tags\":[\"%s\",\"%s\"]}", diag_group_name[flag->group], flag->name);
    buf_char(out, '}');
}

// Writes the rules, and sets index[code] of every code that was used.
static void put_rules(const Diags *d, Buf *out, size_t *index)
{
    bool used[DIAG_COUNT] = {false};
    size_t n = 0;

    for (size_t i = 0; i < d->list.n; i++)
        used[d->list.at[i]->code] = true;
    for (size_t i = 0; i < d->allowed.n; i++)
        used[d->allowed.at[i]->code] = true;
    for (int i = 0; i < DIAG_COUNT; i++)
        if (used[i]) {
            buf_str(out, n ? ",\n" : "\n");
            put_rule(out, &diag_info[i]);
            index[i] = n++;
        }
}

// ---- results ----

static void put_note(Buf *out, const DiagNote *n)
{
    buf_char(out, '{');
    if (n->span.src) {
        put_physical_location(out, n->span);
        buf_char(out, ',');
    }
    buf_str(out, "\"message\":");
    put_message(out, n->text);
    buf_char(out, '}');
}

static size_t count_steps(const Diag *d)
{
    size_t n = 0;

    for (size_t i = 0; i < d->notes.n; i++)
        n += d->notes.at[i].step > 0;
    return n;
}

// Writes the notes that are not numbered steps.
static void put_related_locations(Buf *out, const Diag *d)
{
    bool any = false;

    if (d->notes.n == count_steps(d))
        return;
    buf_str(out, ",\"relatedLocations\":[");
    for (size_t i = 0; i < d->notes.n; i++)
        if (!d->notes.at[i].step) {
            buf_str(out, any ? "," : "");
            put_note(out, &d->notes.at[i]);
            any = true;
        }
    buf_char(out, ']');
}

// Writes the numbered steps among the notes as one SARIF code flow: the path that leads to the finding.
static void put_code_flow(Buf *out, const Diag *d)
{
    bool any = false;

    if (count_steps(d) == 0)
        return;
    buf_str(out, ",\"codeFlows\":[{\"threadFlows\":[{\"locations\":[");
    for (size_t i = 0; i < d->notes.n; i++)
        if (d->notes.at[i].step) {
            buf_str(out, any ? ",{\"location\":" : "{\"location\":");
            put_note(out, &d->notes.at[i]);
            buf_char(out, '}');
            any = true;
        }
    buf_str(out, "]}]}]");
}

// SARIF allows several alternative fixes; the edits of a diagnostic are one fix.
static void put_fix(Buf *out, const Diag *d)
{
    if (d->edits.n == 0)
        return;
    buf_str(out, ",\"fixes\":[{\"artifactChanges\":[{");
    put_artifact_location(out, d->edits.at[0].span);
    buf_str(out, ",\"replacements\":[");
    for (size_t i = 0; i < d->edits.n; i++) {
        buf_str(out, i ? ",{\"deletedRegion\":" : "{\"deletedRegion\":");
        put_region(out, d->edits.at[i].span);
        buf_str(out, ",\"insertedContent\":");
        put_message(out, d->edits.at[i].text);
        buf_char(out, '}');
    }
    buf_str(out, "]}]}]");
}

// Writes one result. `suppressions`: some result of the run is suppressed, so SARIF requires every result to state whether it is.
static void put_result(Buf *out, const Diag *d, const DiagFingerprint *print, size_t rule, bool suppressions)
{
    Buf text;

    buf_init(&text, out->arena);
    buf_str(&text, d->text);
    if (d->label)
        buf_printf(&text, " (%s)", d->label);
    buf_printf(out, "{\"ruleId\":\"%s\",\"ruleIndex\":%lu,\"level\":\"%s\",\"message\":", diag_info[d->code].id,
               (unsigned long)rule, d->severity == DIAG_ERROR ? "error" : "warning");
    put_message(out, buf_text(&text));
    buf_str(out, ",\"locations\":[");
    if (d->span.src) {
        buf_char(out, '{');
        put_physical_location(out, d->span);
        buf_char(out, '}');
    }
    buf_char(out, ']');
    put_related_locations(out, d);
    put_code_flow(out, d);
    buf_printf(out, ",\"partialFingerprints\":{\"primaryLocationLineHash\":\"%08lx%08lx:%lu\"}",     // the key that code-hosting sites read
               (unsigned long)(print->hash >> 32), (unsigned long)(print->hash & 0xffffffffu), print->twin);
    if (suppressions && d->allowed) {
        buf_str(out, ",\"suppressions\":[{\"kind\":\"inSource\",\"justification\":");
        json_put_string(out, d->allowed);
        buf_str(out, "}]");
    } else if (suppressions)
        buf_str(out, ",\"suppressions\":[]");
    put_fix(out, d);
    buf_char(out, '}');
}

// Writes the messages that are not diagnostics, and ends the document.
static void put_notifications(const PlainMessages *plain, Buf *out)
{
    bool succeeded = true;

    for (size_t i = 0; i < plain->n; i++)
        succeeded &= strcmp(plain->at[i].severity, "error") != 0;
    if (plain->n)
        buf_printf(out, ",\n\"invocations\":[{\"executionSuccessful\":%s,\"toolExecutionNotifications\":[\n", succeeded ? "true" : "false");
    for (size_t i = 0; i < plain->n; i++) {
        buf_printf(out, "%s{\"level\":\"%s\",\"message\":", i ? ",\n" : "", plain->at[i].severity);
        put_message(out, plain->at[i].text);
        buf_char(out, '}');
    }
    buf_str(out, plain->n ? "]}]}]}\n" : "}]}\n");
}

void diags_render_sarif(const Diags *d, const PlainMessages *plain, const char *version, Buf *out)
{
    size_t index[DIAG_COUNT] = {0};
    const DiagFingerprint *print = diags_fingerprints(d, out->arena);

    buf_str(out, "{\"$schema\":\"https://json.schemastore.org/sarif-2.1.0.json\",\"version\":\"2.1.0\",\"runs\":[{\n"
                 "\"tool\":{\"driver\":{\"name\":\"smc\",\"version\":");
    json_put_string(out, version);
    buf_str(out, ",\"rules\":[");
    put_rules(d, out, index);
    buf_str(out, "]}},\n\"columnKind\":\"unicodeCodePoints\",\n\"results\":[");
    for (size_t i = 0; i < d->list.n + d->allowed.n; i++) {
        const Diag *x = i < d->list.n ? d->list.at[i] : d->allowed.at[i - d->list.n];
        buf_str(out, i ? ",\n" : "\n");
        put_result(out, x, &print[i], index[x->code], d->allowed.n > 0);
    }
    buf_char(out, ']');
    put_notifications(plain, out);
}
