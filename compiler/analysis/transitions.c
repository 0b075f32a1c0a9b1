// SPDX-License-Identifier: Apache-2.0
#include "compiler/analysis/transitions.h"

#include "compiler/base/buf.h"

// ---- finding transitions ----

typedef struct Finder {
    Arena *arena;
    StmtPlace at;
    void (*f)(const StmtPlace *place, void *context);
    void *context;
} Finder;

static void find_in(Finder *f, const Stmts *stmts, const Condition *when);

static void find_under(Finder *f, const Stmts *stmts, const Stmt *stmt, bool holds, const Condition *outer)
{
    Condition *c;

    if (stmts->n == 0)
        return;
    c = ARENA_NEW(f->arena, Condition);
    *c = (Condition){stmt, holds, outer};
    find_in(f, stmts, c);
}

// Recursion depth equals the nesting of conditionals, which AST_DEPTH_MAX bounds.
static void find_in(Finder *f, const Stmts *stmts, const Condition *when)
{
    for (size_t i = 0; i < stmts->n; i++) {
        const Stmt *s = stmts->at[i];
        f->at.stmt = s;
        f->at.when = when;
        f->f(&f->at, f->context);
        find_under(f, &s->then, s, true, when);
        find_under(f, &s->otherwise, s, false, when);
    }
}

void each_place(Arena *arena, const Program *p, void (*f)(const StmtPlace *place, void *context), void *context)
{
    Finder finder = {arena, {NULL, NULL, BLOCK_ENTRY, NULL}, f, context};

    for (size_t s = 0; s < p->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++) {
            finder.at.state = p->state.at[s];
            finder.at.block = (BlockKind)b;
            find_in(&finder, &finder.at.state->block[b], NULL);
        }
}

typedef struct Found { Arena *arena; Transitions list; } Found;

static void note_transition(const StmtPlace *at, void *context)
{
    Found *out = context;
    const Transition t = {at->state, at->stmt->target, at->block, at->stmt, at->when, (uint32_t)out->list.n};

    if (at->stmt->kind == ST_TRANSITION)
        vec_push(out->arena, &out->list, t);
}

Transitions transitions_of(Arena *arena, const Program *p)
{
    Found out = {arena, {NULL, 0, 0}};

    each_place(arena, p, note_transition, &out);
    return out.list;
}

size_t *transitions_by_state(Arena *arena, const Program *p, const Transitions *all)
{
    size_t *first = ARENA_ARRAY(arena, size_t, p->state.n + 1), t = 0;

    for (size_t s = 0; s <= p->state.n; s++) {
        while (t < all->n && all->at[t].from->number - 1 < s)
            t++;
        first[s] = t;
    }
    return first;
}

// ---- text ----

const char *source_text(Arena *arena, Span span)
{
    Buf out;
    bool comment = false, blank = false;

    buf_init(&out, arena);
    for (uint32_t i = 0; i < span.len; i++) {
        const char c = span.src->text[span.at + i];
        comment = c == '#' || (comment && c != '\n');
        if (comment || c == '\n' || c == ' ' || c == '\t' || c == '\r') {
            blank = true;
            continue;
        }
        if (blank)
            buf_char(&out, ' ');
        blank = false;
        buf_char(&out, c);
    }
    return buf_text(&out);
}

static bool needs_parentheses(const Condition *c, bool alone)
{
    const Expr *g = c->stmt->value;

    if (!c->holds)
        return g->kind != EX_VAR && g->kind != EX_CALL && g->kind != EX_ROLL;
    return !alone && g->kind == EX_BINARY && g->op == SM_OP_OR;
}

static void put_condition(Arena *arena, Buf *out, const Condition *c, bool alone)
{
    const bool parentheses = needs_parentheses(c, alone);

    buf_printf(out, "%s%s%s%s", c->holds ? "" : "not ", parentheses ? "(" : "", source_text(arena, c->stmt->value->span),
               parentheses ? ")" : "");
}

const char *condition_text(Arena *arena, const Condition *when)
{
    const Condition *shown[CONDITIONS_SHOWN];
    size_t n = 0;
    Buf out;

    buf_init(&out, arena);
    for (; when && n < CONDITIONS_SHOWN; when = when->outer)
        shown[n++] = when;
    if (when)
        buf_str(&out, "… and ");
    for (size_t i = n; i-- > 0;) {
        put_condition(arena, &out, shown[i], n == 1 && !when);
        if (i > 0)
            buf_str(&out, " and ");
    }
    return buf_text(&out);
}

const char *condition_brief(Arena *arena, const Condition *when, size_t most)
{
    const Condition *shown[CONDITIONS_SHOWN];
    size_t n = 0;
    Buf out;

    buf_init(&out, arena);
    for (; when && n < most; when = when->outer)
        if (when->holds || n == 0 || shown[n - 1]->holds)              // of adjacent "else" only one is shown
            shown[n++] = when;
    if (when)
        buf_str(&out, "… and ");
    for (size_t i = n; i-- > 0;) {
        if (shown[i]->holds)
            put_condition(arena, &out, shown[i], i == 0);
        else
            buf_str(&out, "else");
        if (i > 0)
            buf_str(&out, shown[i]->holds && shown[i - 1]->holds ? " and " : ", ");
    }
    return buf_text(&out);
}
