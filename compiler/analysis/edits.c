// SPDX-License-Identifier: Apache-2.0
#include "compiler/analysis/edits.h"

static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

// Where the line of `at` begins, if only blanks stand before it; else UINT32_MAX.
static uint32_t line_begin(const Source *src, uint32_t at)
{
    while (at > 0 && is_blank(src->text[at - 1]))
        at--;
    return at == 0 || src->text[at - 1] == '\n' ? at : UINT32_MAX;
}

static uint32_t skip_blanks(const Source *src, uint32_t at)
{
    while (at < src->len && is_blank(src->text[at]))
        at++;
    return at;
}

// Whether the line above begins with an annotation: it belongs to what stands here.
static bool is_annotated(const Source *src, uint32_t at)
{
    while (at > 0 && (is_blank(src->text[at - 1]) || src->text[at - 1] == '\n'))
        at--;
    while (at > 0 && src->text[at - 1] != '\n')
        at--;
    return src->text[skip_blanks(src, at)] == '@';
}

// The whole line goes; a remark behind the statement stays, on a line of its own.
void edit_remove(Diags *diags, Diag *d, const Stmt *stmt, const Stmts *list, bool is_block)
{
    const Source *src = stmt->span.src;
    const uint32_t begin = line_begin(src, stmt->span.at), end = skip_blanks(src, stmt->span.at + stmt->span.len);
    Span span = {src, stmt->span.at, 0};

    if ((!is_block && list->n == 1) || begin == UINT32_MAX || end >= src->len || is_annotated(src, begin))
        return;
    if (src->text[end] == '\n') {
        span.at = begin;
        span.len = end + 1 - begin;
    } else if (src->text[end] == '#') {
        span.len = end - stmt->span.at;
    } else {
        return;
    }
    diag_edit(diags, d, span, "");
}

// Behind the last ')' of the initial value, for the parentheses around an expression are not part of its place.
void edit_mark_read_only(Diags *diags, Diag *d, const Var *local)
{
    const Source *src = local->span.src;
    Span span = {src, local->init_value->span.at + local->init_value->span.len, 0};
    uint32_t at = span.at;

    while (at < src->len && (is_blank(src->text[at]) || src->text[at] == '\n' || src->text[at] == '#' || src->text[at] == ')')) {
        if (src->text[at] == '#')
            while (at < src->len && src->text[at] != '\n')
                at++;
        else if (src->text[at++] == ')')
            span.at = at;
    }
    diag_edit(diags, d, span, " @read_only");
}
