// SPDX-License-Identifier: Apache-2.0
// Finds comments by lines of the source.
#include "compiler/report/comment.h"

// Finds the start of a line's comment; false: the line has no comment.
bool comment_find_start(const char *line, uint32_t len, uint32_t *at)
{
    bool quoted = false;              // position i is inside the quoted reason of an @allow

    for (uint32_t i = 0; i < len; i++) {
        quoted ^= line[i] == '"';
        if (line[i] == '#' && !quoted) {
            *at = i;
            return true;
        }
    }
    return false;
}

// Appends the text of the comment that starts at `at`, without its '#' and surrounding whitespace.
static void append_comment(Buf *out, const char *line, uint32_t len, uint32_t at)
{
    while (at < len && (line[at] == '#' || is_space_tab_or_return(line[at])))
        at++;
    while (len > at && is_space_tab_or_return(line[len - 1]))
        len--;
    buf_put(out, line + at, len - at);
}

static const char *buf_text_or_null(const Buf *b) { return b->n ? buf_text(b) : NULL; }

// Returns the comment of a line; NULL if the line has no comment.
static const char *comment_of_line(Arena *arena, const Source *src, uint32_t number)
{
    uint32_t len, at;
    const char *line = source_line(src, number, &len);
    Buf out;

    if (!comment_find_start(line, len, &at))
        return NULL;
    buf_init(&out, arena);
    append_comment(&out, line, len, at);
    return buf_text_or_null(&out);
}

// Returns the comment after the code on the first line of `span`; NULL if that line has no comment.
const char *comment_after(Arena *arena, Span span)
{
    return span.src ? comment_of_line(arena, span.src, source_position(span.src, span.at).line) : NULL;
}

const char *comment_after_lines(Arena *arena, Span span)
{
    uint32_t line, last;
    Buf out;

    if (!span.src)
        return NULL;
    line = source_position(span.src, span.at).line;
    last = source_position(span.src, span.at + span.len).line;
    buf_init(&out, arena);
    for (; line <= last; line++) {
        const char *text = comment_of_line(arena, span.src, line);
        if (text)
            buf_printf(&out, "%s%s", out.n ? "\n" : "", text);
    }
    return buf_text_or_null(&out);
}

// Whether the line contains only a comment.
static bool is_comment_line(const Source *src, uint32_t number)
{
    uint32_t len, at, i = 0;
    const char *line = source_line(src, number, &len);

    while (i < len && is_space_tab_or_return(line[i]))
        i++;
    return comment_find_start(line, len, &at) && at == i;
}

// Whether only whitespace and '{' precede the line's comment or, if the line has no comment, its end.  `len`: length of the line in bytes.
static bool has_no_code(const char *line, uint32_t len)
{
    uint32_t i = 0;

    while (i < len && (is_space_tab_or_return(line[i]) || line[i] == '{'))
        i++;
    return i == len || line[i] == '#';
}

// Returns the start of the line of the `else` whose first statement is `first`; `first` itself if it is on that line.
Span comment_else_line(Span first)
{
    uint32_t line, len;
    const char *text;
    LineCol at;

    if (!first.src)
        return first;
    at = source_position(first.src, first.at);
    text = source_line(first.src, at.line, &len);
    if (at.line == 1 || !has_no_code(text, at.col - 1u))
        return first;
    for (line = at.line - 1; line > 1 && has_no_code(source_line(first.src, line, &len), len);)
        line--;
    text = source_line(first.src, line, &len);
    return (Span){first.src, (uint32_t)(text - first.src->text), 0};
}

// Whether the '#' at index `at` of the line has two blanks after it, so that the text of the comment is indented.
static bool is_indented(const char *line, uint32_t len, uint32_t at)
{
    return at + 2 < len && is_space_tab_or_return(line[at + 1]) && is_space_tab_or_return(line[at + 2]);
}

// Joins the lines of a paragraph.  An empty line, an indented one, and one that starts a list item remain separate.
static void join_paragraph(Buf *out, size_t before, bool indented)
{
    const char first = before < out->n ? out->at[before] : '\0';
    const bool apart = indented || first == '\0' || first == '-' || first == '*' || (before && out->at[before - 1] == '\n');
    Buf line;

    if (before == 0)
        return;
    buf_init(&line, out->arena);
    buf_put(&line, out->at + before, out->n - before);
    out->n = before;
    buf_char(out, apart ? '\n' : ' ');
    buf_put(out, line.at, line.n);
}

// Returns the comment on the lines from `from` to `to`; NULL if these lines have no comment.
static const char *comment_of_lines(Arena *arena, const Source *src, uint32_t from, uint32_t to)
{
    Buf out;

    buf_init(&out, arena);
    for (; from < to; from++) {
        uint32_t len, at = 0;
        const char *line = source_line(src, from, &len);
        const size_t before = out.n;
        comment_find_start(line, len, &at);
        append_comment(&out, line, len, at);
        join_paragraph(&out, before, is_indented(line, len, at));
    }
    return buf_text_or_null(&out);
}

const char *comment_above(Arena *arena, Span span)
{
    const uint32_t line = span.src ? source_position(span.src, span.at).line : 1;
    uint32_t from = line;

    while (from > 1 && is_comment_line(span.src, from - 1))
        from--;
    return from < line ? comment_of_lines(arena, span.src, from, line) : NULL;
}

const char *comment_around(Arena *arena, Span span)
{
    const char *above = comment_above(arena, span), *beside = comment_after_lines(arena, span);

    return above && beside ? format_in(arena, "%s\n%s", above, beside) : above ? above : beside;
}

const char *comment_of_file(Arena *arena, const Source *src)
{
    uint32_t to = 1;

    while (to <= src->lines && is_comment_line(src, to))
        to++;
    return comment_of_lines(arena, src, 1, to);
}

// Returns the comment at the variable's declaration in the machine, otherwise the one in the state vector; NULL if neither has a comment.
const char *comment_of_variable(Arena *arena, const Var *v)
{
    const char *comment = comment_after(arena, v->span);

    return comment || !v->element ? comment : comment_after(arena, v->element->span);
}
