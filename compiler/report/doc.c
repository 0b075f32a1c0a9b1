// SPDX-License-Identifier: Apache-2.0
// Builds a report.
#include "compiler/report/doc.h"

#include <string.h>

void doc_begin_chapter(Doc *d, const char *title) { d->chapter = title; }

const char *doc_scoped_id(Arena *arena, const char *scope, const char *id) { return scope ? format_in(arena, "%s-%s", scope, id) : id; }

void doc_add_section(Doc *d, const char *id, const char *title)
{
    DocSection *s = ARENA_NEW(d->arena, DocSection);

    s->id = doc_scoped_id(d->arena, d->scope, id);
    s->title = d->scope ? format_in(d->arena, "%s: %s", d->scope, title) : title;
    s->scope = d->scope;
    s->chapter = d->chapter;
    d->chapter = NULL;
    vec_push(d->arena, &d->section, s);
}

static DocPart *add_part(Doc *d, DocKind kind)
{
    DocSection *s = d->section.at[d->section.n - 1];
    DocPart part = {.kind = kind};

    vec_push(d->arena, &s->part, part);
    return &s->part.at[s->part.n - 1];
}

// Adds a heading.  The result is valid until the next part is added.
DocPart *doc_add_heading(Doc *d, const char *id, const char *text)
{
    DocPart *p = add_part(d, DOC_HEADING);

    p->id = id;
    p->text = text;
    return p;
}

void doc_add_paragraph(Doc *d, const char *text) { add_part(d, DOC_PARAGRAPH)->text = text; }

void doc_add_legend(Doc *d, const char *text)
{
    for (size_t i = 0; i < d->legend.n; i++)
        if (strcmp(d->legend.at[i], text) == 0)
            return;
    vec_push(d->arena, &d->legend, text);
    doc_add_paragraph(d, text);
}

// Adds a paragraph without markup.
void doc_add_plain(Doc *d, const char *text)
{
    DocPart *p = add_part(d, DOC_PARAGRAPH);

    p->text = text;
    p->plain = true;
}

// Adds a quotation; nothing for NULL and "".
void doc_add_quote(Doc *d, const char *plain)
{
    if (plain && *plain)
        add_part(d, DOC_QUOTE)->text = plain;
}

// Adds lines that are shown as they are; nothing for "".
void doc_add_lines(Doc *d, const char *plain)
{
    if (*plain)
        add_part(d, DOC_LINES)->text = plain;
}

void doc_add_excerpt(Doc *d, Span span, const char *label)
{
    DocPart *p;

    if (!span.src)
        return;
    p = add_part(d, DOC_EXCERPT);
    p->span = span;
    p->text = label;
}

// Adds a figure.  The result is valid until the next part is added.
DocPart *doc_add_figure(Doc *d, const char *svg, const char *caption)
{
    DocPart *p = add_part(d, DOC_FIGURE);

    p->text = svg;
    p->caption = caption;
    return p;
}

void doc_add_source(Doc *d, const Source *src) { add_part(d, DOC_SOURCE)->source = src; }

DocTable *doc_add_table(Doc *d, const char *key, const DocColumn *column, size_t columns)
{
    DocTable *t = ARENA_NEW(d->arena, DocTable);

    t->arena = d->arena;
    t->key = key;
    t->column = column;
    t->columns = columns;
    add_part(d, DOC_TABLE)->table = t;
    return t;
}

DocList *doc_add_list(Doc *d, const char *key, const char *label)
{
    DocList *l = ARENA_NEW(d->arena, DocList);

    l->arena = d->arena;
    l->key = key;
    l->label = label;
    add_part(d, DOC_LIST)->list = l;
    return l;
}

// Returns, by column, whether some row has content in the column.
bool *doc_columns_used(const DocTable *t)
{
    bool *used = ARENA_ARRAY(t->arena, bool, t->columns);

    for (size_t i = 0; i < t->cell.n; i++) {
        const DocCell *c = &t->cell.at[i];
        if (*c->text || c->number || c->kind == CELL_NUMBER || c->kind == CELL_BAR)
            used[i % t->columns] = true;
    }
    return used;
}

// Returns the text with `Name` for ^Name^, for formats without links.
const char *doc_replace_links(Arena *arena, const char *text)
{
    Buf b;

    buf_init(&b, arena);
    for (; *text; text++)
        buf_char(&b, *text == '^' ? '`' : *text);
    return buf_text(&b);
}

// ---- cells ----

// Appends a cell; the table is a flat list of cells, row by row. `most`: the number that a full bar stands for (CELL_BAR only).
static void add_cell(DocTable *t, DocCellKind kind, const char *text, uint64_t number, uint64_t most)
{
    DocCell c = {kind, text ? text : "", number, most, NULL, NULL};

    vec_push(t->arena, &t->cell, c);
}

void doc_add_text_cell(DocTable *t, const char *text) { add_cell(t, CELL_TEXT, text, 0, 0); }
void doc_add_plain_cell(DocTable *t, const char *text) { add_cell(t, CELL_PLAIN, text, 0, 0); }
void doc_add_code_cell(DocTable *t, const char *text) { add_cell(t, CELL_CODE, text, 0, 0); }
void doc_add_number_cell(DocTable *t, uint64_t n) { add_cell(t, CELL_NUMBER, NULL, n, 0); }
void doc_add_bar_cell(DocTable *t, uint64_t n, uint64_t most) { add_cell(t, CELL_BAR, NULL, n, most); }
void doc_add_line_cell(DocTable *t, uint32_t line) { add_cell(t, CELL_LINE, NULL, line, 0); }
void doc_add_state_cell(DocTable *t, const char *name) { add_cell(t, CELL_STATE, name, 0, 0); }

void doc_add_section_cell(DocTable *t, const char *title, const char *id)
{
    add_cell(t, CELL_SECTION, title, 0, 0);
    t->cell.at[t->cell.n - 1].link = id;
}

void doc_add_badge_cell(DocTable *t, const char *word, const char *tone)
{
    add_cell(t, CELL_BADGE, word, 0, 0);
    t->cell.at[t->cell.n - 1].tone = tone;
}

void doc_add_target_cell(DocTable *t, uint64_t n, const char *id)
{
    add_cell(t, CELL_TARGET, NULL, n, 0);
    t->cell.at[t->cell.n - 1].link = id;
}

void doc_add_linked_badge_cell(DocTable *t, const char *word, const char *tone, const char *id)
{
    doc_add_badge_cell(t, word, tone);
    t->cell.at[t->cell.n - 1].link = id;
}

void doc_add_list_line(DocList *l, unsigned depth, uint32_t line, const char *text)
{
    DocLine one = {depth, text, line, NULL};

    vec_push(l->arena, &l->line, one);
}

// Sets DocLine.comment of the last line.
void doc_set_line_comment(DocList *l, const char *plain) { l->line.at[l->line.n - 1].comment = plain; }
