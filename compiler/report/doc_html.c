// SPDX-License-Identifier: Apache-2.0
// A report as one HTML page.  It loads nothing and contains no scripts, and all text of the machine's author is escaped.
#include <string.h>

#include "compiler/report/comment.h"
#include "compiler/report/doc.h"
#include "compiler/report/page_style.h"
#include "compiler/report/xml.h"

// ---- text ----

static bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

static bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }

// In characters: the longest word that is not divided; the shortest and the longest part of a longer word.
enum { DIVIDED = 12, PART_SHORTEST = 4, PART_LONGEST = 16 };

// Whether a word can be divided before `at`: after `_`, `.`, `/` or `(`, and before a capital letter.  `last`: where it was divided before.
static bool is_word_part(const char *text, size_t last, size_t at)
{
    const char before = text[at - 1], after = text[at];

    if (at < last + PART_SHORTEST || ((unsigned char)after & 0xC0) == 0x80)
        return false;
    if (is_letter(after) && (before == '_' || before == '.' || before == '/' || before == '('))
        return true;
    return (is_capital(after) && !is_capital(before)) || at >= last + PART_LONGEST;
}

// Writes text in which a browser can divide long names where a column is narrow: `chamber|Pressure|A`.  The style sheet allows it on paper.
static void write_names(Buf *out, const char *text, size_t n)
{
    size_t written = 0, end;

    for (size_t word = 0; word < n; word = end + 1) {
        size_t last = word;
        for (end = word; end < n && text[end] != ' '; end++)
            continue;
        for (size_t at = word + 1; end - word > DIVIDED && at + 1 < end; at++)
            if (is_word_part(text, last, at)) {
                xml_write(out, text + written, at - written);
                buf_str(out, "<wbr/>");
                written = last = at;
            }
    }
    xml_write(out, text + written, n - written);
}

// Writes code.  An option, as --all, is not divided after its hyphens, nor is an arrow.
static void write_code(Buf *out, const char *text, size_t n)
{
    enum { LONGEST = 24 };                               // more characters do not fit on a line beside other text
    const char *hyphens = strstr(text, "--");
    const bool has_option = hyphens && hyphens < text + n && n <= LONGEST;

    buf_str(out, has_option ? "<code class=\"b\">" : "<code>");
    for (const char *end = text + n, *arrow; text < end; text = arrow + 2) {
        arrow = strstr(text, "->");
        write_names(out, text, (size_t)((arrow && arrow < end ? arrow : end) - text));
        if (!arrow || arrow >= end)
            break;
        buf_str(out, "<span class=\"b\">-&gt;</span>");
    }
    buf_str(out, "</code>");
}

static void write_state_link(Buf *out, const char *name, size_t n)
{
    buf_str(out, "<a class=\"st\" href=\"#state-");
    xml_write(out, name, n);
    buf_str(out, "\">");
    write_names(out, name, n);
    buf_str(out, "</a>");
}

// Writes text with its markup as HTML: `code` in backticks, ^a state^.
static void write_markup(Buf *out, const char *text)
{
    while (*text) {
        const size_t n = strcspn(text, "`^");
        const char mark = text[n];
        size_t inner;
        write_names(out, text, n);
        if (!mark)
            break;
        text += n + 1;
        inner = strcspn(text, mark == '`' ? "`" : "^");
        if (mark == '^')
            write_state_link(out, text, inner);
        else
            write_code(out, text, inner);
        text += inner + (text[inner] != '\0');
    }
}

static void write_line_link(Buf *out, uint32_t line)
{
    if (line)
        buf_printf(out, "<a class=\"ln\" href=\"#L%lu\">%lu</a>", (unsigned long)line, (unsigned long)line);
}

// ---- tables ----

// A horizontal bar for n of `most`, followed by n in digits.
static void write_bar(Buf *out, uint64_t n, uint64_t most)
{
    const unsigned long share = most ? (unsigned long)(n * 100 / most) : 0;

    buf_printf(out, "<span class=\"bar\"><i style=\"width:%lu%%\"></i></span> %llu", share, (unsigned long long)n);
}

static void write_cell(Buf *out, const DocCell *c)
{
    switch (c->kind) {
    case CELL_TEXT: write_markup(out, c->text); break;
    case CELL_PLAIN: write_names(out, c->text, strlen(c->text)); break;
    case CELL_CODE:
        if (*c->text)
            write_code(out, c->text, strlen(c->text));
        break;
    case CELL_NUMBER: buf_printf(out, "%llu", (unsigned long long)c->number); break;
    case CELL_TARGET: buf_printf(out, "<span id=\"%s\">%llu</span>", c->link, (unsigned long long)c->number); break;
    case CELL_BAR: write_bar(out, c->number, c->most); break;
    case CELL_LINE: write_line_link(out, (uint32_t)c->number); break;
    case CELL_STATE:
        write_state_link(out, c->text, strlen(c->text));
        break;
    case CELL_SECTION:
        buf_printf(out, "<a href=\"#%s\">", c->link);
        xml_write_str(out, c->text);
        buf_str(out, "</a>");
        break;
    case CELL_BADGE:
        if (!*c->text)
            break;
        if (c->link)
            buf_printf(out, "<a class=\"badge %s\" href=\"#%s\">", c->tone, c->link);
        else
            buf_printf(out, "<span class=\"badge %s\">", c->tone);
        xml_write_str(out, c->text);
        buf_str(out, c->link ? "</a>" : "</span>");
        break;
    }
}

// Returns the class attribute of a table cell; "": none.  The class of an option, as -Wflight, prevents a line break at its hyphen.
static const char *cell_class(const DocTable *t, size_t i)
{
    const DocCell *c = &t->cell.at[i];

    if (t->last_on_screen && (i + 1) % t->columns == 0)
        return " class=\"screen\"";
    if (c->kind == CELL_PLAIN && c->text[0] == '-')
        return " class=\"b\"";
    return c->kind == CELL_NUMBER || c->kind == CELL_TARGET || c->kind == CELL_LINE ? " class=\"n\"" : c->kind == CELL_BAR ? " class=\"b\"" : "";
}

// A table of names and values as a description list, with no heads of columns.
static void write_facts(Buf *out, const DocTable *t)
{
    buf_str(out, "<dl>\n");
    for (size_t i = 0; i + 1 < t->cell.n; i += t->columns) {
        buf_str(out, "<div><dt>");
        write_cell(out, &t->cell.at[i]);
        buf_str(out, "</dt><dd>");
        write_cell(out, &t->cell.at[i + 1]);
        buf_str(out, "</dd></div>\n");
    }
    buf_str(out, "</dl>\n");
}

// Writes the rows from `row` to before `end` as a table.
static void write_rows(Buf *out, const DocTable *t, const bool *used, size_t row, size_t end)
{
    buf_printf(out, "<div class=\"wide\"><table%s>\n<thead><tr>",
               t->upright ? " class=\"narrow dense upright\"" : t->dense ? " class=\"narrow dense\"" : t->narrow ? " class=\"narrow\"" : "");
    for (size_t i = 0; i < t->columns; i++) {
        if (!used[i])
            continue;
        buf_printf(out, "<th scope=\"col\"%s>", t->cell.n ? cell_class(t, i) : "");
        write_names(out, t->column[i].title, strlen(t->column[i].title));
        buf_str(out, "</th>");
    }
    buf_str(out, "</tr></thead>\n<tbody>\n");
    for (size_t i = row * t->columns; i < end * t->columns; i++) {
        if (i % t->columns == 0)
            buf_str(out, i > row * t->columns ? "</tr>\n<tr>" : "<tr>");
        if (!used[i % t->columns])
            continue;
        buf_printf(out, "<td%s>", cell_class(t, i));
        write_cell(out, &t->cell.at[i]);
        buf_str(out, "</td>");
    }
    buf_str(out, end > row ? "</tr>\n" : "");
    buf_str(out, "</tbody>\n</table></div>\n");
}

static void write_table(Buf *out, const DocTable *t)
{
    enum { SHOWN = 20, FOLDED_LEAST = 5 };            // rows
    const bool *used = doc_columns_used(t);
    const size_t rows = t->cell.n / t->columns, shown = t->folds && rows >= SHOWN + FOLDED_LEAST ? SHOWN : rows;

    if (t->facts) {
        write_facts(out, t);
        return;
    }
    write_rows(out, t, used, 0, shown);
    if (shown == rows)
        return;
    buf_printf(out, "<details><summary>%lu more rows</summary>\n", (unsigned long)(rows - shown));
    write_rows(out, t, used, shown, rows);
    buf_str(out, "</details>\n");
}

// ---- lists ----

static void write_item(Buf *out, const DocLine *l)
{
    write_markup(out, l->text);
    if (l->line) {
        buf_char(out, ' ');
        write_line_link(out, l->line);
    }
    if (l->comment) {
        buf_str(out, "<span class=\"c\">");
        xml_write_str(out, l->comment);
        buf_str(out, "</span>");
    }
}

static void write_list(Buf *out, const DocList *l)
{
    unsigned open = 0;                                // number of open lists, each inside an item of the previous one

    buf_str(out, "<div class=\"do\">");
    if (l->label) {
        buf_str(out, "<b>");
        xml_write_str(out, l->label);
        buf_str(out, "</b>");
    }
    for (size_t i = 0; i < l->line.n; i++) {
        const unsigned depth = l->line.at[i].depth + 1;
        if (depth <= open)
            buf_str(out, "</li>\n");
        for (; open < depth; open++)
            buf_str(out, "\n<ul>");
        for (; open > depth; open--)
            buf_str(out, "</ul></li>\n");
        buf_str(out, "<li>");
        write_item(out, &l->line.at[i]);
    }
    for (; open > 0; open--)
        buf_str(out, "</li></ul>");
    buf_str(out, "</div>\n");
}

// ---- sources ----

// Writes a source line with its comment in a separate style; `from` to `to` is marked.
static void write_source_text(Buf *out, const char *line, uint32_t len, uint32_t from, uint32_t to)
{
    xml_write(out, line, from);
    if (to > from) {
        buf_str(out, "<mark>");
        xml_write(out, line + from, to - from);
        buf_str(out, "</mark>");
    }
    xml_write(out, line + to, len - to);
}

static void write_excerpt(Buf *out, const DocPart *p)
{
    const LineCol at = source_position(p->span.src, p->span.at);
    uint32_t len, from = at.col - 1, to;
    const char *line = source_line(p->span.src, at.line, &len);

    from = from < len ? from : len;
    to = p->span.len < len - from ? from + p->span.len : len;
    buf_printf(out, "<pre class=\"ex\"><span class=\"no\">%lu</span>", (unsigned long)at.line);
    write_source_text(out, line, len, from, to);
    buf_str(out, "</pre>\n");
    if (p->text) {
        buf_str(out, "<p class=\"label\">");
        xml_write_str(out, p->text);
        buf_str(out, "</p>\n");
    }
}

// The numbered lines of a source file, comments in their own colour; each line is a target (#L12) of links from other sections.
static void write_source(Buf *out, const Source *src)
{
    buf_str(out, "<pre class=\"source\">");
    for (uint32_t i = 1; i <= src->lines; i++) {
        uint32_t len;
        const char *line = source_line(src, i, &len);
        uint32_t comment = len;
        comment_find_start(line, len, &comment);
        if (i == src->lines && len == 0)
            break;
        buf_printf(out, "<span id=\"L%lu\"><span class=\"no\">%lu</span>", (unsigned long)i, (unsigned long)i);
        xml_write(out, line, comment);
        if (comment < len) {
            buf_str(out, "<span class=\"c\">");
            xml_write(out, line + comment, len - comment);
            buf_str(out, "</span>");
        }
        buf_str(out, "</span>\n");
    }
    buf_str(out, "</pre>\n");
}

// ---- parts ----

static void write_heading(Buf *out, const DocPart *p)
{
    buf_str(out, "<h3");
    if (p->id || p->state) {
        buf_str(out, p->state ? " id=\"state-" : " id=\"");
        xml_write_str(out, p->state ? p->state : p->id);
        buf_char(out, '"');
    }
    buf_char(out, '>');
    if (p->plain)
        xml_write_str(out, p->text);
    else
        write_markup(out, p->text);
    if (p->badge) {
        buf_printf(out, " <span class=\"badge %s\">", p->tone ? p->tone : "note");
        xml_write_str(out, p->badge);
        buf_str(out, "</span>");
    }
    buf_str(out, "</h3>\n");
}

static void write_element(Buf *out, const char *open, const char *text, bool has_markup, const char *close)
{
    buf_str(out, open);
    if (has_markup)
        write_markup(out, text);
    else
        xml_write_str(out, text);
    buf_str(out, close);
}

// The picture with its caption. `print`: the same picture cut into pages, which the style sheet shows only on paper.
static void write_figure(Buf *out, const DocPart *p)
{
    static const char *const class[] = {"", " class=\"diagram\"", " class=\"diagram low\"", " class=\"diagram tall\"", " class=\"diagram large\""};

    buf_printf(out, "<figure%s", class[p->figure]);
    if (p->figure != FIGURE_PLOT)
        buf_printf(out, " style=\"--width:%ldpx\"", (long)p->width);
    buf_str(out, ">\n");
    buf_str(out, p->text);
    if (p->print) {
        buf_str(out, "<div class=\"print\" aria-hidden=\"true\">\n");
        buf_str(out, p->print);
        buf_str(out, "</div>\n");
    }
    if (p->caption)
        write_element(out, "<figcaption>", p->caption, true, "</figcaption>\n");
    buf_str(out, "</figure>\n");
}

static void write_part(Buf *out, const DocPart *p)
{
    switch (p->kind) {
    case DOC_HEADING: write_heading(out, p); break;
    case DOC_PARAGRAPH: write_element(out, "<p>", p->text, !p->plain, "</p>\n"); break;
    case DOC_QUOTE: write_element(out, "<blockquote>", p->text, false, "</blockquote>\n"); break;
    case DOC_TABLE: write_table(out, p->table); break;
    case DOC_LIST: write_list(out, p->list); break;
    case DOC_EXCERPT: write_excerpt(out, p); break;
    case DOC_LINES: write_element(out, "<pre class=\"ex\">", p->text, false, "</pre>\n"); break;
    case DOC_FIGURE: write_figure(out, p); break;
    case DOC_SOURCE: write_source(out, p->source); break;
    }
}

// Appends the HTML of a section of one machine among several: each id and each link within the page gets the name of the machine before it.  Text
// contains no quotes (xml.h), so that only attributes match.
static void write_in_scope(Buf *out, const char *html, const char *scope)
{
    static const char *const before[] = {" id=\"", " href=\"#"};
    const char *at = html;

    while (*at) {
        size_t n = 0;
        for (int i = 0; i < 2; i++)
            n = strncmp(at, before[i], strlen(before[i])) == 0 ? strlen(before[i]) : n;
        buf_put(out, at, n ? n : 1);
        if (n)
            buf_printf(out, "%s-", scope);
        at += n ? n : 1;
    }
}

// Keeps a heading and everything up to the next heading together on paper.
static void write_parts(Buf *out, const DocSection *s)
{
    bool open = false;

    for (size_t i = 0; i < s->part.n; i++) {
        if (s->part.at[i].kind == DOC_HEADING) {
            buf_str(out, open ? "</article>\n<article>\n" : "<article>\n");
            open = true;
        }
        write_part(out, &s->part.at[i]);
    }
    buf_str(out, open ? "</article>\n</section>\n" : "</section>\n");
}

static void write_section(Buf *out, const DocSection *s)
{
    Buf parts;

    if (s->chapter) {
        buf_str(out, "<p class=\"chapter\">");
        xml_write_str(out, s->chapter);
        buf_str(out, "</p>\n");
    }
    buf_printf(out, "<section id=\"%s\">\n<h2>", s->id);
    xml_write_str(out, s->title);
    buf_str(out, "</h2>\n");
    if (!s->scope) {
        write_parts(out, s);
        return;
    }
    buf_init(&parts, out->arena);
    write_parts(&parts, s);
    write_in_scope(out, buf_text(&parts), s->scope);
}

// Writes the list of sections, by chapter.  Successive sections about one machine are one entry, with its name.
static void write_contents(Buf *out, const Doc *d)
{
    buf_str(out, "<nav><ul>\n");
    for (size_t i = 0; i < d->section.n; i++) {
        const DocSection *s = d->section.at[i];
        if (s->scope && i > 0 && !s->chapter && d->section.at[i - 1]->scope == s->scope)
            continue;
        if (s->chapter) {
            buf_str(out, i > 0 ? "</ul><ul>\n<li><b>" : "<li><b>");
            xml_write_str(out, s->chapter);
            buf_str(out, "</b></li>\n");
        }
        buf_printf(out, "<li><a href=\"#%s\">", s->id);
        xml_write_str(out, s->scope ? s->scope : s->title);
        buf_str(out, "</a></li>\n");
    }
    buf_str(out, "</ul></nav>\n");
}

void doc_write_html(const Doc *d, Buf *out)
{
    buf_str(out,
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n<meta name=\"generator\" content=\"smc\"/>\n"
            "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
            "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'\"/>\n<title>");
    xml_write_str(out, d->title);
    buf_str(out, " &#8211; design review</title>\n<style>\n");
    for (size_t i = 0; report_style[i]; i++)
        buf_str(out, report_style[i]);
    buf_str(out, "</style>\n</head>\n<body>\n<header>\n<h1>");
    xml_write_str(out, d->title);
    buf_str(out, "</h1>\n<p>");
    xml_write_str(out, d->subtitle);
    buf_str(out, "</p>\n");
    write_contents(out, d);
    buf_str(out, "</header>\n<main>\n");
    for (size_t i = 0; i < d->section.n; i++)
        write_section(out, d->section.at[i]);
    buf_str(out, "</main>\n<footer><p>Generated by ");
    xml_write_str(out, d->maker);
    buf_str(out, ". The same sources produce the same page, byte for byte.</p></footer>\n</body>\n</html>\n");
}
