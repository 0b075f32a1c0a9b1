// SPDX-License-Identifier: Apache-2.0
// A report as one JSON object: by section {"title", "text": […], "tables": {KEY: [{…}]}, "lists": {KEY: [{…}]}}.  Figures and sources are
// omitted.
#include "compiler/base/json.h"
#include "compiler/report/doc.h"

static void write_key(Buf *out, const char *key)
{
    json_put_string(out, key);
    buf_str(out, ": ");
}

static void write_cell(Buf *out, const DocCell *c)
{
    if (c->kind == CELL_NUMBER || c->kind == CELL_TARGET || c->kind == CELL_BAR || c->kind == CELL_LINE)
        buf_printf(out, "%llu", (unsigned long long)c->number);
    else
        json_put_string(out, c->kind == CELL_TEXT ? doc_replace_links(out->arena, c->text) : c->text);
}

static void write_row(Buf *out, const DocTable *t, size_t first)
{
    buf_char(out, '{');
    for (size_t i = 0; i < t->columns; i++) {
        buf_str(out, i ? ", " : "");
        write_key(out, t->column[i].key);
        write_cell(out, &t->cell.at[first + i]);
    }
    buf_char(out, '}');
}

// Writes pairs of name and value as one object whose keys are the names.
static void write_facts(Buf *out, const DocTable *t)
{
    buf_str(out, "{");
    for (size_t i = 0; i + 1 < t->cell.n; i += t->columns) {
        buf_str(out, i ? ",\n      " : "\n      ");
        write_key(out, t->cell.at[i].text);
        write_cell(out, &t->cell.at[i + 1]);
    }
    buf_str(out, "\n    }");
}

static void write_table(Buf *out, const DocTable *t)
{
    if (t->facts) {
        write_facts(out, t);
        return;
    }
    buf_char(out, '[');
    for (size_t i = 0; i + t->columns <= t->cell.n; i += t->columns) {
        buf_str(out, i ? ",\n      " : "\n      ");
        write_row(out, t, i);
    }
    buf_str(out, t->cell.n ? "\n    ]" : "]");
}

static void write_list(Buf *out, const DocList *l)
{
    buf_char(out, '[');
    for (size_t i = 0; i < l->line.n; i++) {
        buf_printf(out, "%s{\"depth\": %u, \"line\": %lu, \"text\": ", i ? ",\n      " : "\n      ", l->line.at[i].depth,
                   (unsigned long)l->line.at[i].line);
        json_put_string(out, doc_replace_links(out->arena, l->line.at[i].text));
        if (l->line.at[i].comment) {
            buf_str(out, ", \"comment\": ");
            json_put_string(out, l->line.at[i].comment);
        }
        buf_char(out, '}');
    }
    buf_str(out, l->line.n ? "\n    ]" : "]");
}

// Writes the parts of one kind as an object by key, if there are any.
static void write_parts(Buf *out, const DocSection *s, DocKind kind, const char *name)
{
    bool any = false;

    for (size_t i = 0; i < s->part.n; i++) {
        const DocPart *p = &s->part.at[i];
        if (p->kind != kind)
            continue;
        if (any)
            buf_str(out, ",\n    ");
        else
            buf_printf(out, ",\n   \"%s\": {\n    ", name);
        any = true;
        write_key(out, kind == DOC_TABLE ? p->table->key : p->list->key);
        if (kind == DOC_TABLE)
            write_table(out, p->table);
        else
            write_list(out, p->list);
    }
    buf_str(out, any ? "}" : "");
}

// The paragraphs and quotes of a section, as member "text" with a list of strings; nothing for a section without these.
static void write_texts(Buf *out, const DocSection *s)
{
    bool any = false;

    for (size_t i = 0; i < s->part.n; i++) {
        const DocPart *p = &s->part.at[i];
        if (p->kind != DOC_PARAGRAPH && p->kind != DOC_QUOTE)
            continue;
        buf_str(out, any ? ",\n    " : ",\n   \"text\": [\n    ");
        any = true;
        json_put_string(out, p->plain || p->kind == DOC_QUOTE ? p->text : doc_replace_links(out->arena, p->text));
    }
    buf_str(out, any ? "]" : "");
}

// Whether the section has anything but source text and pictures, which the JSON file leaves out.
static bool has_data(const DocSection *s)
{
    for (size_t i = 0; i < s->part.n; i++)
        if (s->part.at[i].kind != DOC_SOURCE && s->part.at[i].kind != DOC_FIGURE)
            return true;
    return false;
}

void doc_write_json(const Doc *d, Buf *out)
{
    buf_printf(out, "{\"smc-report\": 1, \"%s\": ", d->of_application ? "application" : "machine");
    json_put_string(out, d->title);
    for (size_t i = 0; i < d->section.n; i++) {
        const DocSection *s = d->section.at[i];
        if (!has_data(s))
            continue;
        buf_str(out, ",\n ");
        write_key(out, s->id);
        buf_str(out, "{\"title\": ");
        json_put_string(out, s->title);
        write_texts(out, s);
        write_parts(out, s, DOC_TABLE, "tables");
        write_parts(out, s, DOC_LIST, "lists");
        buf_char(out, '}');
    }
    buf_str(out, "\n}\n");
}
