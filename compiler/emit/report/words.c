// SPDX-License-Identifier: Apache-2.0
// Statements as sentences.  What a sentence calls by the author's names and formulas stands in backticks.
#include "compiler/emit/report/words.h"

#include "compiler/analysis/transitions.h"
#include "stdlib/convert.h"

// ---- small things ----

const char *words_count(Arena *arena, size_t n, const char *one, const char *many)
{
    return format_in(arena, "%lu %s", (unsigned long)n, n == 1 ? one : many);
}

const char *words_window(Arena *arena, const Window *w)
{
    static const char *const name[SM_STAT_COUNT] = {"the average", "the median", "the smallest", "the largest", "the range"};

    return format_in(arena, "%s of `%s` over the last %lu steps", name[w->stat], source_text(arena, w->sample->span),
                     (unsigned long)w->size);
}

// What its author wrote above the statement, given to the sentence before.
static void put_comment(DocList *l, const Stmt *s)
{
    const char *comment = comment_above(l->arena, s->span);

    if (comment)
        list_comment(l, comment);
}

static uint32_t line_of(const Stmt *s) { return source_position(s->span.src, s->span.at).line; }

// ---- assignments ----

static bool is_var(const Expr *e, const Var *v) { return e->kind == EX_VAR && e->var == v; }

// `x = x + c`: "adds `c` to `x`".
static const char *changed_by(Arena *arena, const Stmt *s)
{
    const Expr *e = s->value;

    if (e->kind != EX_BINARY || !is_var(e->arg[0], s->var))
        return NULL;
    if (e->op == SM_OP_ADD)
        return format_in(arena, "adds `%s` to `%s`", source_text(arena, e->arg[1]->span), s->var->name->text);
    if (e->op == SM_OP_SUB)
        return format_in(arena, "subtracts `%s` from `%s`", source_text(arena, e->arg[1]->span), s->var->name->text);
    return NULL;
}

static const char *assignment(Arena *arena, const Stmt *s)
{
    const char *changed = changed_by(arena, s);
    const Expr *e = s->value;

    if (changed)
        return changed;
    if (s->var->type == SM_BOOL && e->kind == EX_NUMBER)
        return format_in(arena, "sets `%s` to `%s`", s->var->name->text, sm_to_bool(e->number) ? "true" : "false");
    return format_in(arena, "sets `%s` to `%s`", s->var->name->text, source_text(arena, e->span));
}

static const char *simple(Arena *arena, const Stmt *s)
{
    return s->kind == ST_ASSIGN ? assignment(arena, s) : format_in(arena, "leaves for ^%s^", s->target->name->text);
}

// ---- conditionals ----

static void put_stmts(DocList *l, const Stmts *stmts, unsigned depth);

static void put_branch(DocList *l, const char *when, const Stmts *stmts, const Stmt *head, unsigned depth)
{
    const Stmt *only = stmts->n == 1 ? stmts->at[0] : NULL;
    const uint32_t line = line_of(head);

    if (only && only->kind == ST_TRANSITION) {
        list_line(l, depth, line, format_in(l->arena, "%s %s", simple(l->arena, only), when));
        put_comment(l, head);
    } else if (only && only->kind == ST_ASSIGN) {
        list_line(l, depth, line, format_in(l->arena, "%s: %s", when, simple(l->arena, only)));
        put_comment(l, head);
    } else {
        list_line(l, depth, line, format_in(l->arena, stmts->n ? "%s:" : "%s: does nothing", when));
        put_comment(l, head);
        put_stmts(l, stmts, depth + 1);
    }
}

// A conditional and the `else if` that hang on it, each in a line of its own depth.
static void put_if(DocList *l, const Stmt *s, unsigned depth)
{
    const char *when = "if";
    const Stmt *last = s;

    for (;; s = s->otherwise.at[0], when = "otherwise, if") {
        put_branch(l, format_in(l->arena, "%s `%s`", when, source_text(l->arena, s->value->span)), &s->then, s, depth);
        last = s;
        if (s->otherwise.n != 1 || s->otherwise.at[0]->kind != ST_IF)
            break;
    }
    if (last->otherwise.n)
        put_branch(l, "otherwise", &last->otherwise, last->otherwise.at[0], depth);
}

// As deep as conditionals nest: AST_DEPTH_MAX bounds it.
static void put_stmts(DocList *l, const Stmts *stmts, unsigned depth)
{
    for (size_t i = 0; i < stmts->n; i++)
        if (stmts->at[i]->kind == ST_IF)
            put_if(l, stmts->at[i], depth);
        else {
            list_line(l, depth, line_of(stmts->at[i]), simple(l->arena, stmts->at[i]));
            put_comment(l, stmts->at[i]);
        }
}

void words_block(DocList *l, const Stmts *block) { put_stmts(l, block, 0); }
