// SPDX-License-Identifier: Apache-2.0
// A report for a terminal: the tables and lists, without figures and sources.
#include <string.h>

#include "compiler/base/utf8.h"
#include "compiler/report/doc.h"

enum { WIDE = 100 };                  // maximum width of a paragraph, in columns

static size_t columns_in(const char *text, size_t n)              // counts characters: each takes one column
{
    size_t columns = 0;

    for (size_t i = 0; i < n; i++)
        columns += ((unsigned char)text[i] & 0xc0) != 0x80;
    return columns;
}

// Writes text; invisible characters and those that change the text direction are spelled out.
static void write_visible(Buf *out, const char *text, size_t n)
{
    while (n > 0) {
        uint32_t code = 0;
        size_t len = utf8_decode(text, n, &code);
        if (len == 0)
            buf_char(out, '?');
        else if (utf8_is_hidden(code))
            buf_printf(out, "<U+%04lX>", (unsigned long)code);
        else
            buf_put(out, text, len);
        text += len ? len : 1;
        n -= len ? len : 1;
    }
}

static void write_underlined(Buf *out, const char *text, char line)
{
    const size_t start = out->n;
    size_t columns;

    write_visible(out, text, strlen(text));
    columns = columns_in(out->at + start, out->n - start);
    buf_char(out, '\n');
    while (columns-- > 0)
        buf_char(out, line);
    buf_char(out, '\n');
}

// Wraps a paragraph at WIDE columns; its line ends are preserved.
static void write_wrapped(Buf *out, const char *text)
{
    size_t column = 0;

    while (*text) {
        const size_t n = strcspn(text, " \n"), columns = columns_in(text, n);
        if (column > 0 && column + 1 + columns > WIDE) {
            buf_char(out, '\n');
            column = 0;
        }
        buf_str(out, column ? " " : "");
        write_visible(out, text, n);
        column += columns + 1;
        text += n;
        if (*text == '\n') {
            buf_char(out, '\n');
            column = 0;
        }
        text += *text != '\0';
    }
    buf_str(out, "\n\n");
}

// ---- tables ----

// The cell as text of one line: line breaks become "; ".
static const char *cell_string(const DocTable *t, size_t i)
{
    const DocCell *c = &t->cell.at[i];
    Buf b;

    if (c->kind == CELL_LINE && c->number == 0)
        return "";
    if (c->kind == CELL_NUMBER || c->kind == CELL_TARGET || c->kind == CELL_BAR || c->kind == CELL_LINE)
        return format_in(t->arena, "%llu", (unsigned long long)c->number);
    buf_init(&b, t->arena);
    for (const char *s = c->kind == CELL_TEXT ? doc_replace_links(t->arena, c->text) : c->text; *s;) {
        const size_t n = strcspn(s, "\n");
        write_visible(&b, s, n);
        s += n;
        buf_str(&b, *s ? "; " : "");
        s += *s != '\0';
    }
    return buf_text(&b);
}

static bool is_right(const DocTable *t, size_t i)     // whether a column is right-aligned, as numbers are
{
    const DocCellKind k = t->cell.at[i].kind;

    return k == CELL_NUMBER || k == CELL_TARGET || k == CELL_BAR || k == CELL_LINE;
}

static void write_padded(Buf *out, const char *text, size_t wide, bool align_right)
{
    const size_t n = columns_in(text, strlen(text)), pad = wide > n ? wide - n : 0;

    buf_spaces(out, align_right ? pad : 0);
    buf_str(out, text);
    buf_spaces(out, align_right ? 0 : pad);
}

// Ends a row without trailing spaces.
static void end_row(Buf *out)
{
    while (out->n && out->at[out->n - 1] == ' ')
        out->n--;
    buf_char(out, '\n');
}

// Returns the widths of the columns, in characters, and stores the text of each cell in `text`.
static size_t *measure_columns(const DocTable *t, const char **text)
{
    size_t *wide = ARENA_ARRAY(t->arena, size_t, t->columns);

    for (size_t i = 0; i < t->columns && !t->facts; i++)
        wide[i] = strlen(t->column[i].title);
    for (size_t i = 0; i < t->cell.n; i++) {
        size_t n;
        text[i] = cell_string(t, i);
        n = columns_in(text[i], strlen(text[i]));
        wide[i % t->columns] = wide[i % t->columns] > n ? wide[i % t->columns] : n;
    }
    return wide;
}

// The row of column titles. `used` leaves out columns whose cells are all empty; `wide`: widths in characters.
static void write_head(Buf *out, const DocTable *t, const bool *used, const size_t *wide)
{
    for (size_t i = 0; i < t->columns; i++)
        if (used[i]) {
            buf_str(out, "  ");
            write_padded(out, t->column[i].title, wide[i], t->cell.n && is_right(t, i));
        }
    end_row(out);
}

static void write_table(Buf *out, const DocTable *t)
{
    const char **text = ARENA_ARRAY(t->arena, const char *, t->cell.n);
    const size_t *wide = measure_columns(t, text);
    const bool *used = doc_columns_used(t);

    if (!t->facts)
        write_head(out, t, used, wide);
    for (size_t i = 0; i < t->cell.n; i++) {
        const size_t column = i % t->columns;
        if (used[column]) {
            buf_str(out, "  ");
            write_padded(out, text[i], wide[column], is_right(t, i) && !t->facts);
        }
        if (column + 1 == t->columns)
            end_row(out);
    }
    buf_char(out, '\n');
}

// ---- lists, excerpts and the whole report ----

static void write_comment(Buf *out, const char *comment, size_t indent)
{
    while (*comment) {
        const size_t n = strcspn(comment, "\n");
        buf_spaces(out, indent);
        buf_str(out, "# ");
        write_visible(out, comment, n);
        buf_char(out, '\n');
        comment += n + (comment[n] == '\n');
    }
}

static void write_list(Buf *out, const DocList *l)
{
    if (l->label)
        buf_printf(out, "  %s\n", l->label);
    for (size_t i = 0; i < l->line.n; i++) {
        buf_spaces(out, 4 + 2 * l->line.at[i].depth);
        buf_printf(out, "- %s\n", doc_replace_links(out->arena, l->line.at[i].text));
        if (l->line.at[i].comment)
            write_comment(out, l->line.at[i].comment, 6 + 2 * l->line.at[i].depth);
    }
    buf_char(out, '\n');
}

static void write_excerpt(Buf *out, const DocPart *p)
{
    const LineCol at = source_position(p->span.src, p->span.at);
    uint32_t len;
    const char *line = source_line(p->span.src, at.line, &len);

    buf_printf(out, "  %5lu | ", (unsigned long)at.line);
    write_visible(out, line, len);
    if (p->text)
        buf_printf(out, "\n        | %s", p->text);
    buf_str(out, "\n\n");
}

static void write_lines(Buf *out, const char *text)
{
    while (*text) {
        const size_t n = strcspn(text, "\n");
        buf_str(out, n ? "  " : "");
        buf_put(out, text, n);
        buf_char(out, '\n');
        text += n + (text[n] == '\n');
    }
    buf_char(out, '\n');
}

static const char *part_text(const Buf *out, const DocPart *p)
{
    return p->plain || p->kind == DOC_QUOTE ? p->text : doc_replace_links(out->arena, p->text);
}

static void write_part(Buf *out, const DocPart *p)
{
    switch (p->kind) {
    case DOC_HEADING:
        buf_printf(out, "%s%s%s%s\n", part_text(out, p), p->badge ? " [" : "", p->badge ? p->badge : "", p->badge ? "]" : "");
        break;
    case DOC_PARAGRAPH: case DOC_QUOTE: write_wrapped(out, part_text(out, p)); break;
    case DOC_TABLE: write_table(out, p->table); break;
    case DOC_LIST: write_list(out, p->list); break;
    case DOC_EXCERPT: write_excerpt(out, p); break;
    case DOC_LINES: write_lines(out, p->text); break;
    case DOC_FIGURE: case DOC_SOURCE: break;
    }
}

// Whether the section has anything but pictures and source text, which the text report leaves out.
static bool has_text(const DocSection *s)
{
    for (size_t i = 0; i < s->part.n; i++)
        if (s->part.at[i].kind != DOC_FIGURE && s->part.at[i].kind != DOC_SOURCE)
            return true;
    return false;
}

void doc_write_text(const Doc *d, Buf *out)
{
    const char *chapter = NULL;           // the title of a chapter that has not been written

    write_underlined(out, d->title, '=');
    buf_printf(out, "%s\n\n", d->subtitle);
    for (size_t i = 0; i < d->section.n; i++) {
        const DocSection *s = d->section.at[i];
        if (s->chapter)
            chapter = s->chapter;
        if (!has_text(s))
            continue;
        if (chapter) {
            write_underlined(out, chapter, '=');
            buf_char(out, '\n');
        }
        chapter = NULL;
        write_underlined(out, s->title, '-');
        buf_char(out, '\n');
        for (size_t k = 0; k < s->part.n; k++)
            write_part(out, &s->part.at[k]);
    }
}
