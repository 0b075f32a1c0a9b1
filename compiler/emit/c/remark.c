// SPDX-License-Identifier: Apache-2.0
// Source text that emitted C repeats in its comments: the author's comment on an element, the call that reads a window.
#include <string.h>

#include "compiler/emit/c/fn.h"

enum { REMARK_MAX = 60 };

// Whether the text can appear in a // comment: short, printable, and without a backslash or the trigraph for one, which would join the next
// line to the comment.
static bool can_be_in_comment(const char *text, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if ((unsigned char)text[i] < ' ' || text[i] == 0x7f || text[i] == '\\' || (text[i] == '?' && i + 1 < n && text[i + 1] == '?'))
            return false;
    return n > 0 && n <= REMARK_MAX;
}

// Returns the text without spaces around it; "" if it cannot appear in a comment.
static const char *trim_remark(Arena *a, const char *text, size_t n)
{
    while (n > 0 && (*text == ' ' || *text == '\t'))
        text++, n--;
    while (n > 0 && (text[n - 1] == ' ' || text[n - 1] == '\t' || text[n - 1] == '\r'))
        n--;
    return can_be_in_comment(text, n) ? format_in(a, "%.*s", (int)n, text) : "";
}

// Returns the source comment at the end of the line of `s`; "" if the line has no comment, or if the comment cannot be copied into a C comment.
const char *remark_of_line(Arena *a, Span s)
{
    const char *line, *hash;
    uint32_t len;

    if (!s.src)
        return "";
    line = source_line(s.src, source_position(s.src, s.at).line, &len);
    hash = memchr(line, '#', len);
    return hash ? trim_remark(a, hash + 1, (size_t)(line + len - hash - 1)) : "";
}

// Returns the source at s; "" if it cannot appear in a comment.
static const char *source_of_span(Arena *a, Span s) { return s.src ? trim_remark(a, s.src->text + s.at, s.len) : ""; }

// ---- constants ----

// Fills u->constants.
static void collect_constants(CUnit *u)
{
    const Program *p = u->m->program;

    str_pool_init(&u->constant_names, u->arena);
    u->constants.arena = u->arena;
    for (size_t i = 0; p && i < p->var.n; i++)
        if (p->var.at[i]->is_constant)
            map_put(&u->constants, str_intern(&u->constant_names, p->var.at[i]->name->text, p->var.at[i]->name->len), p->var.at[i]);
}

// Returns the name of the constant local whose name is the source at `s`; "" if `s` is not such a name.
const char *remark_constant_name(CUnit *u, Span s)
{
    Str name;

    if (!u->constants.arena)
        collect_constants(u);
    if (!s.src || s.len > REMARK_MAX || u->constants.n == 0)
        return "";
    name = str_intern(&u->constant_names, s.src->text + s.at, s.len);
    return map_find(&u->constants, name) ? name->text : "";
}

// ---- the calls that read a window ----

// If `in` is the first call that reads a window, stores its source in call[window].
static void record_statistic_call(CUnit *u, const IrIns *in, const char **call)
{
    if (in->op == IR_stat && !call[in->var] && *source_of_span(u->arena, in->span))
        call[in->var] = source_of_span(u->arena, in->span);
}

static void record_statistic_calls(CUnit *u, const IrFn *f, const char **call)
{
    for (size_t b = 0; f && b < f->blk.n; b++)
        for (size_t i = 0; i < f->blk.at[b].ins.n; i++)
            record_statistic_call(u, &f->ins.at[f->blk.at[b].ins.at[i]], call);
}

// Returns, by window, the source of the first call that reads it; NULL where unknown.
const char **remark_window_calls(CUnit *u)
{
    const IrMachine *m = u->m;
    const char **call = ARENA_ARRAY(u->arena, const char *, m->window.n);

    if (m->window.n == 0)
        return call;
    record_statistic_calls(u, m->sample, call);
    for (size_t s = 0; s < m->state.n; s++)
        for (int k = 0; k < BLOCK_COUNT; k++)
            record_statistic_calls(u, m->state.at[s].block[k], call);
    for (size_t w = 0; w < m->window.n; w++)
        if (call[w] && (m->window.at[w].stats & (m->window.at[w].stats - 1)) != 0)
            call[w] = format_in(u->arena, "%s and other statistics", call[w]);
    return call;
}
