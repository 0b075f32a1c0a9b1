// SPDX-License-Identifier: Apache-2.0
// Renders the diagnostics for people: position and message, the source line with a caret below the marked text, notes, a count. A tab
// becomes a space, and an unprintable byte is written as an escape such as \x07.
#include <string.h>

#include "compiler/base/utf8.h"
#include "compiler/diag/diag.h"

enum {
    WIDEST = 160,             // columns of a source line that are printed
    BEFORE = 60               // columns before the caret in a line that is too long to print
};

typedef enum Paint { PAINT_OFF, PAINT_POSITION, PAINT_ERROR, PAINT_WARNING, PAINT_NOTE, PAINT_CARET } Paint;

static void set_color(const DiagStyle *style, Buf *out, Paint what)
{
    static const char *const code[] = {"\033[0m", "\033[1m", "\033[1;31m", "\033[1;35m", "\033[1;36m", "\033[1;32m"};

    if (style->color)
        buf_str(out, code[what]);
}

// ---- printable text ----

// Writes the first character of the n bytes at s in printable form.  Returns its length in s, and sets *width to the columns written.
static size_t put_character(Buf *out, const char *s, size_t n, size_t *width)
{
    uint32_t code = 0;
    size_t len = utf8_decode(s, n, &code);
    size_t start = out->n;

    if (*s == '\t') {
        buf_char(out, ' ');
    } else if (len > 0 && !utf8_is_hidden(code)) {
        buf_put(out, s, len);
        *width = 1;
        return len;
    } else if (len > 1) {
        buf_printf(out, "<U+%04X>", (unsigned)code);
    } else {
        buf_printf(out, "\\x%02X", (unsigned)(unsigned char)*s);
    }
    *width = out->n - start;
    return len ? len : 1;
}

// Appends text of a source in a form that is safe on a terminal; returns the number of columns.
size_t diag_put_printable(Buf *out, const char *s, size_t n)
{
    size_t columns = 0, width, len;

    for (; n; s += len, n -= len) {
        len = put_character(out, s, n, &width);
        columns += width;
    }
    return columns;
}

static void put_text(Buf *out, const char *s) { diag_put_printable(out, s, strlen(s)); }

// ---- the source line ----

typedef struct Excerpt {
    const char *text;         // the line
    size_t len, from, to;     // bytes [from, to) are printed
    size_t at, end;           // the marked bytes: from <= at <= end <= to
} Excerpt;

static size_t min_size(size_t a, size_t b) { return a < b ? a : b; }

// Returns the end of the bytes from `from` on that fit in `columns`; *left is the number of columns that remain.
static size_t end_of_fitting_bytes(Buf *scratch, const Excerpt *e, size_t from, size_t columns, size_t *left)
{
    while (from < e->len) {
        size_t width, len = put_character(scratch, e->text + from, e->len - from, &width);
        if (width > columns)
            break;
        columns -= width;
        from += len;
    }
    scratch->n = 0;
    *left = columns;
    return from;
}

// Finds the part of the line that is printed: all of it, or of a long line the text around the mark.
static Excerpt find_excerpt(Buf *scratch, Span span, LineCol where)
{
    Excerpt e = {0};
    uint32_t len;
    size_t left;

    e.text = source_line(span.src, where.line, &len);
    e.len = e.to = len;
    e.at = min_size(where.col - 1, e.len);
    if (end_of_fitting_bytes(scratch, &e, 0, WIDEST, &left) < e.len) {
        e.from = e.at > BEFORE ? e.at - BEFORE : 0;
        while (e.from > 0 && e.from < e.at && ((unsigned char)e.text[e.from] & 0xc0) == 0x80)
            e.from++;                                             // do not split a character
        while (end_of_fitting_bytes(scratch, &e, e.from, BEFORE, &left) < e.at)
            e.from++;
        e.to = end_of_fitting_bytes(scratch, &e, e.at, WIDEST - BEFORE + left, &left);
    }
    e.end = min_size(e.at + (span.len ? span.len : 1), e.to);      // a span over several lines ends at the end of the first
    return e;
}

// Writes the source line, and below it the caret with the label.
static void put_snippet(const DiagStyle *style, Buf *out, const Diag *d, LineCol where)
{
    static const char ellipsis[] = "...";
    Excerpt e;
    Buf scratch;
    size_t indent = 0, marked, start = out->n, gutter;    // in columns: the text before the mark; the marked text; the line's number

    buf_init(&scratch, out->arena);
    e = find_excerpt(&scratch, d->span, where);
    buf_printf(out, "%5lu", (unsigned long)where.line);
    gutter = out->n - start;
    buf_str(out, " | ");
    if (e.from > 0) {
        buf_str(out, ellipsis);
        indent += sizeof ellipsis - 1;
    }
    indent += diag_put_printable(out, e.text + e.from, e.at - e.from);
    marked = diag_put_printable(out, e.text + e.at, e.end - e.at);
    diag_put_printable(out, e.text + e.end, e.to - e.end);
    if (e.to < e.len)
        buf_str(out, ellipsis);
    buf_char(out, '\n');
    buf_spaces(out, gutter);
    buf_str(out, " | ");
    buf_spaces(out, indent);
    set_color(style, out, PAINT_CARET);
    buf_char(out, '^');
    for (size_t i = 1; i < marked; i++)
        buf_char(out, '~');
    if (d->label) {
        buf_char(out, ' ');
        put_text(out, d->label);
    }
    set_color(style, out, PAINT_OFF);
    buf_char(out, '\n');
}

// ---- one diagnostic ----

static void put_position(const DiagStyle *style, Buf *out, Span span)
{
    LineCol where;

    if (!span.src)
        return;
    where = source_position(span.src, span.at);
    set_color(style, out, PAINT_POSITION);
    put_text(out, span.src->name);
    buf_printf(out, ":%lu:%lu: ", (unsigned long)where.line, (unsigned long)where.col);
    set_color(style, out, PAINT_OFF);
}

static void put_severity(const DiagStyle *style, Buf *out, DiagSeverity severity)
{
    static const char *const word[] = {"error: ", "warning: ", "note: "};
    static const Paint color[] = {PAINT_ERROR, PAINT_WARNING, PAINT_NOTE};

    set_color(style, out, color[severity]);
    buf_str(out, word[severity]);
    set_color(style, out, PAINT_OFF);
}

static void put_note(const DiagStyle *style, Buf *out, const DiagNote *n)
{
    put_position(style, out, n->span);
    put_severity(style, out, DIAG_NOTE);
    if (n->step)
        buf_printf(out, "step %u: ", n->step);
    for (const char *line = n->text;; line++) {           // a table is printed below its note, one row per line
        const size_t len = strcspn(line, "\n");
        if (line != n->text)
            buf_str(out, "      ");
        diag_put_printable(out, line, len);
        buf_char(out, '\n');
        if (*(line += len) == '\0')
            return;
    }
}

static void put_diag(const DiagStyle *style, Buf *out, const Diag *d)
{
    put_position(style, out, d->span);
    put_severity(style, out, d->severity);
    put_text(out, d->text);
    buf_printf(out, " [%s]\n", diag_code_and_name(d, out->arena));
    if (d->span.src)
        put_snippet(style, out, d, source_position(d->span.src, d->span.at));
    for (size_t i = 0; i < d->notes.n; i++)
        put_note(style, out, &d->notes.at[i]);
}

// ---- the closing line ----

// Writes "2 more errors" or the like; nothing for n = 0. `more`: "" or "more ".
static void put_count(Buf *out, size_t n, const char *more, const char *what)
{
    if (n)
        buf_printf(out, "%lu %s%s%s", (unsigned long)n, more, what, n == 1 ? "" : "s");
}

static void put_counts(Buf *out, size_t errors, size_t warnings, const char *more)
{
    put_count(out, errors, more, "error");
    if (errors && warnings)
        buf_str(out, ", ");
    put_count(out, warnings, more, "warning");
    if (errors || warnings)
        buf_char(out, '\n');
}

// Renders the list for the user. "1 error, 2 warnings" follows if there are any.
void diags_render_text(const Diags *d, const DiagStyle *style, Buf *out)
{
    size_t shown[2] = {0, 0};                 // how many errors, how many warnings were shown

    for (size_t i = 0; i < d->list.n; i++) {
        const Diag *x = d->list.at[i];
        size_t *n = &shown[x->severity != DIAG_ERROR];
        if (style->most && *n == style->most)
            continue;
        ++*n;
        put_diag(style, out, x);
    }
    if (d->errors > shown[0] || d->warnings > shown[1]) {
        buf_str(out, "and ");
        put_counts(out, d->errors > shown[0] ? d->errors - shown[0] : 0,
                   d->warnings > shown[1] ? d->warnings - shown[1] : 0, "more ");
    }
    put_counts(out, d->errors, d->warnings, "");
}
