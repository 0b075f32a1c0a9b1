// SPDX-License-Identifier: Apache-2.0
#include "compiler/analysis/transitions.h"

#include "compiler/base/buf.h"

// ---- finding transitions ----

typedef struct StmtWalk {
    Arena *arena;
    StmtLocation at;
    void (*f)(const StmtLocation *at, void *context);
    void *context;
} StmtWalk;

// Calls w->f for each of `stmts` and for the statements of their branches. `when`: the conditions around all of `stmts`.
// The recursion depth equals the nesting of conditionals, which AST_DEPTH_MAX bounds.
static void walk_stmts(StmtWalk *w, const Stmts *stmts, const Condition *when)
{
    for (size_t i = 0; i < stmts->n; i++) {
        const Stmt *s = stmts->at[i];
        w->at.stmt = s;
        w->at.when = when;
        w->f(&w->at, w->context);
        for (int holds = 1; holds >= 0; holds--) {
            const Stmts *branch = holds ? &s->then : &s->otherwise;
            Condition *c;
            if (branch->n == 0)
                continue;
            c = ARENA_NEW(w->arena, Condition);
            *c = (Condition){s, holds, when};
            walk_stmts(w, branch, c);
        }
    }
}

// Calls f for every statement in file order.
void each_stmt_location(Arena *arena, const Program *p, void (*f)(const StmtLocation *at, void *context), void *context)
{
    StmtWalk walk = {arena, {NULL, NULL, BLOCK_ENTRY, NULL}, f, context};

    for (size_t s = 0; s < p->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++) {
            walk.at.state = p->state.at[s];
            walk.at.block = (BlockKind)b;
            walk_stmts(&walk, &walk.at.state->block[b], NULL);
        }
}

typedef struct TransitionList { Arena *arena; Transitions list; } TransitionList;

static void add_transition(const StmtLocation *at, void *context)
{
    TransitionList *out = context;
    const Transition t = {at->state, at->stmt->target, at->block, at->stmt, at->when, (uint32_t)out->list.n};

    if (at->stmt->kind == ST_TRANSITION)
        vec_push(out->arena, &out->list, t);
}

// Returns all transitions in file order.  `when` does not include the condition that no earlier transition of the block was taken.
Transitions transitions_of(Arena *arena, const Program *p)
{
    TransitionList out = {arena, {NULL, 0, 0}};

    each_stmt_location(arena, p, add_transition, &out);
    return out.list;
}

// Returns for each state (from 0) the index of its first transition in `all`, where the transitions of a state are adjacent.
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

// ---- text of expressions and conditions ----

// Returns the source of an expression on one line, without comments.
const char *source_text(Arena *arena, Span span)
{
    Buf out;
    bool comment = false, space_before = false;

    buf_init(&out, arena);
    for (uint32_t i = 0; i < span.len; i++) {
        const char c = span.src->text[span.at + i];
        comment = c == '#' || (comment && c != '\n');
        if (comment || c == '\n' || c == ' ' || c == '\t' || c == '\r') {
            space_before = true;
            continue;
        }
        if (space_before)
            buf_char(&out, ' ');
        space_before = false;
        buf_char(&out, c);
    }
    return buf_text(&out);
}

// Writes one condition.  Puts it in parentheses after "not", and if it is an `or` next to other conditions (not `alone`).
static void write_condition(Arena *arena, Buf *out, const Condition *c, bool alone)
{
    const Expr *g = c->stmt->value;
    const bool parentheses = c->holds ? !alone && g->kind == EX_BINARY && g->op == SM_OP_OR
                                      : g->kind != EX_VAR && g->kind != EX_CALL && g->kind != EX_ROLL;

    buf_printf(out, "%s%s%s%s", c->holds ? "" : "not ", parentheses ? "(" : "", source_text(arena, g->span), parentheses ? ")" : "");
}

// Returns a condition and its outer conditions as text, outermost first: "pressure > 800 and not (valveOpen)"; "" for NULL.
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
        write_condition(arena, &out, shown[i], n == 1 && !when);
        if (i > 0)
            buf_str(&out, " and ");
    }
    return buf_text(&out);
}

// Like condition_text, but "else" replaces conditions that must be false, and at most `most` (1 to CONDITIONS_SHOWN) are shown.
const char *condition_brief(Arena *arena, const Condition *when, size_t most)
{
    const Condition *shown[CONDITIONS_SHOWN];
    size_t n = 0;
    Buf out;

    buf_init(&out, arena);
    for (; when && n < most; when = when->outer)
        if (when->holds || n == 0 || shown[n - 1]->holds)              // several consecutive "else" are shown as one
            shown[n++] = when;
    if (when)
        buf_str(&out, "… and ");
    for (size_t i = n; i-- > 0;) {
        if (shown[i]->holds)
            write_condition(arena, &out, shown[i], i == 0);
        else
            buf_str(&out, "else");
        if (i > 0)
            buf_str(&out, shown[i]->holds && shown[i - 1]->holds ? " and " : ", ");
    }
    return buf_text(&out);
}
