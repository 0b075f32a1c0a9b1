// SPDX-License-Identifier: Apache-2.0
// Renders diagnostics for programs: one JSON object per line. The keys and their order are stable: severity, code, message, file, line,
// column, endLine, endColumn, label, notes[], edits[], flag, group. endColumn is exclusive. Absent values are null: the file and
// positions of a diagnostic without a position, a label, the number of a note that is not a step, the flag (the name after -W) and group
// of an error. A message without a diagnostic, such as a problem with the command line, also has a null code; its severity can be note.
#include "compiler/base/json.h"
#include "compiler/diag/diag.h"

static void put_key(Buf *out, const char *key, const char *value)
{
    buf_printf(out, "\"%s\":", key);
    json_put_string(out, value);
    buf_char(out, ',');
}

static void put_span(Buf *out, Span span)
{
    LineCol from, to;

    if (!span.src) {
        buf_str(out, "\"file\":null,\"line\":null,\"column\":null,\"endLine\":null,\"endColumn\":null");
        return;
    }
    from = source_position(span.src, span.at);
    to = source_position(span.src, span.at + span.len);
    put_key(out, "file", span.src->name);
    buf_printf(out, "\"line\":%lu,\"column\":%lu,\"endLine\":%lu,\"endColumn\":%lu", (unsigned long)from.line,
               (unsigned long)from.col, (unsigned long)to.line, (unsigned long)to.col);
}

// Appends a message without a code, such as that a file cannot be read.
void diag_plain_json(const char *severity, const char *message, Buf *out)
{
    const Span nowhere = {NULL, 0, 0};

    buf_char(out, '{');
    put_key(out, "severity", severity);
    put_key(out, "code", NULL);
    put_key(out, "message", message);
    put_span(out, nowhere);
    buf_str(out, ",\"label\":null,\"notes\":[],\"edits\":[],\"flag\":null,\"group\":null}\n");
}

static void put_diag_object(Buf *out, const Diag *x)
{
    const char *name = diag_info[x->code].flag;
    const DiagFlag *flag = name ? diag_find_flag(name) : NULL;

    buf_char(out, '{');
    put_key(out, "severity", x->severity == DIAG_ERROR ? "error" : "warning");
    put_key(out, "code", diag_info[x->code].id);
    put_key(out, "message", x->text);
    put_span(out, x->span);
    buf_char(out, ',');
    put_key(out, "label", x->label);
    buf_str(out, "\"notes\":[");
    for (size_t i = 0; i < x->notes.n; i++) {
        const DiagNote *note = &x->notes.at[i];
        buf_str(out, i ? ",{" : "{");
        put_key(out, "message", note->text);
        put_span(out, note->span);
        buf_str(out, ",\"step\":");
        if (note->step)
            buf_printf(out, "%u}", note->step);
        else
            buf_str(out, "null}");
    }
    buf_str(out, "],\"edits\":[");
    for (size_t i = 0; i < x->edits.n; i++) {
        buf_str(out, i ? ",{" : "{");
        put_key(out, "text", x->edits.at[i].text);
        put_span(out, x->edits.at[i].span);
        buf_char(out, '}');
    }
    buf_str(out, "],");
    put_key(out, "flag", name);
    buf_str(out, "\"group\":");
    json_put_string(out, flag ? diag_group_name[flag->group] : NULL);
    buf_str(out, "}\n");
}

void diags_render_json(const Diags *d, Buf *out)
{
    for (size_t i = 0; i < d->list.n; i++)
        put_diag_object(out, d->list.at[i]);
}
