// SPDX-License-Identifier: Apache-2.0
#include "compiler/script/why_words.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "compiler/diag/diag.h"
#include "compiler/script/script.h"

enum { QUOTE_MOST = 60 };             // the most bytes of source that are quoted

const char *why_quote(Arena *arena, Span span)
{
    const char *s = span.src ? span.src->text + span.at : "";
    uint32_t n = 0;
    Buf out;

    buf_init(&out, arena);
    while (n < span.len && n < QUOTE_MOST && s[n] != '\n' && s[n] != '\r' && s[n] != '#')
        n++;
    while (n < span.len && n > 0 && (s[n] & 0xC0) == 0x80)           // do not cut inside a UTF-8 character
        n--;
    buf_char(&out, '`');
    diag_put_printable(&out, s, n);
    buf_str(&out, n < span.len ? "...`" : "`");
    return buf_text(&out);
}

const char *why_place(Arena *arena, Span span)
{
    return format_in(arena, "%s:%lu", span.src->name, (unsigned long)source_position(span.src, span.at).line);
}

const char *why_step(Arena *arena, uint64_t step, uint64_t g) { return format_in(arena, "step %" PRIu64 " (G = %" PRIu64 ")", step, g); }

// ---- values ----

void why_append_cell(const Var *v, uint64_t cell, Buf *out)
{
    const Program *p = v->state_of;

    if (p && cell - 1 < p->state.n)
        buf_str(out, p->state.at[cell - 1]->name->text);
    else
        format_cell_shortest(out, v->type, cell);
}

void why_append_value(const WatchStmt *s, const uint64_t *value, uint32_t node, Buf *out)
{
    const Expr *e = s->node[node].e;

    if (e->kind == EX_VAR)
        why_append_cell(e->var, value[s->base + node], out);
    else
        format_number_shortest(out, watch_number(s, value, node));
}

// Appends " from 4 of 10 samples" if an operand of the last step is a statistic of a window that is not full.
static void append_samples(const WhyWords *words, const WatchStmt *s, const Expr *e, Buf *out)
{
    const RefWindow *w = e->kind == EX_ROLL && words->windows && s->step == words->w->step ? &words->windows->at[e->window] : NULL;

    if (w && w->what->size > 1 && w->filled < w->what->size && !(1u << w->what->stat & SM_STATS_OF_RUNS))
        buf_printf(out, " from %lu of %lu samples", (unsigned long)w->filled, (unsigned long)w->what->size);
}

// Whether an operand has the source of the whole call that contains it, because the checker composed the call from operations.
static bool is_inside_call(const WatchStmt *s, uint32_t leaf, uint32_t operand)
{
    const Expr *e = s->node[operand].e;

    return watch_is_run(e) || watch_same_span(s->node[leaf].e->span, e->span);
}

// Whether an operand of which the text and the value are in the list is node i.
static bool is_listed(const WatchStmt *s, const uint64_t *value, const uint32_t *listed, size_t n, uint32_t i)
{
    const Span span = s->node[i].e->span;

    for (size_t k = 0; k < n; k++) {
        const Span other = s->node[listed[k]].e->span;
        if (value[s->base + listed[k]] == value[s->base + i] && other.len == span.len &&
            memcmp(other.src->text + other.at, span.src->text + span.at, span.len) == 0)
            return true;
    }
    return false;
}

void why_append_operands(const WhyWords *words, const WatchStmt *s, const uint64_t *value, uint32_t node, Buf *out)
{
    enum { LISTED_MOST = 32 };                            // of more operands, the later ones can be listed twice
    uint32_t leaf = node, listed[LISTED_MOST];
    size_t n = 0;

    for (uint32_t i = node; i < s->node[node].end; i++) {
        const Span span = s->node[i].e->span;
        if (s->node[i].kind == WATCH_LEAF)
            leaf = i;
        if (s->node[i].kind == WATCH_OPERAND ? is_inside_call(s, leaf, i) : i == node || s->node[i].e->kind != EX_VAR)
            continue;
        if (expr_is_negative_number(s->node[i].e) || is_listed(s, value, listed, n, i))
            continue;
        buf_str(out, n ? ", " : "");
        diag_put_printable(out, span.src->text + span.at, span.len);
        buf_str(out, " = ");
        why_append_value(s, value, i, out);
        append_samples(words, s, s->node[i].e, out);
        if (n < LISTED_MOST)
            listed[n++] = i;
    }
}

// ---- what a condition lacks ----

bool why_operand(const WatchStmt *s, const Expr *e, double *x)
{
    for (uint32_t i = 0; i < s->nodes; i++)
        if (s->node[i].e == e || (e->kind == EX_VAR && s->node[i].e->kind == EX_VAR && s->node[i].e->var == e->var)) {
            *x = watch_number(s, s->value, i);
            return true;
        }
    *x = e->kind == EX_NUMBER ? e->number : 0;
    return e->kind == EX_NUMBER;
}

// Returns the relation with exchanged sides.
static SmOperator mirrored(SmOperator op)
{
    switch (op) {
    case SM_OP_LT: return SM_OP_GT;
    case SM_OP_LE: return SM_OP_GE;
    case SM_OP_GT: return SM_OP_LT;
    case SM_OP_GE: return SM_OP_LE;
    default: return op;
    }
}

// A comparison `left op limit`, where `limit` does not change, and the value x of `left`.
typedef struct LimitComparison { const Expr *left; SmOperator op; double x, limit; } LimitComparison;

static bool is_fixed(const Expr *e) { return e->kind == EX_NUMBER || expr_is_constant(e) || (e->kind == EX_VAR && e->var->parameter); }

// Splits a leaf into a value that changes, an operator and a limit that does not.  Returns false if the leaf is no such comparison.
static bool read_comparison(const WatchStmt *s, uint32_t leaf, LimitComparison *c)
{
    const Expr *e = s->node[leaf].e;
    double x, y;

    if (e->kind != EX_BINARY || !watch_is_relation(e))
        return false;
    if (!why_operand(s, e->arg[0], &x) || !why_operand(s, e->arg[1], &y))
        return false;
    *c = is_fixed(e->arg[0]) && !is_fixed(e->arg[1]) ? (LimitComparison){e->arg[1], mirrored(e->op), y, x}
        : (LimitComparison){e->arg[0], e->op, x, y};
    return !(x != x || y != y);
}

// Returns the distance of two numbers as text; NULL if a few digits do not express it exactly.
static const char *distance_text(Arena *arena, double from, double to)
{
    const double d = to > from ? to - from : from - to;
    const char *text = format_in(arena, "%.7g", d);

    return d - d == 0 && strtod(text, NULL) == d && from + (to > from ? d : -d) == to && !strchr(text, 'e') ? text : NULL;
}

// Appends by how much the value was too small or too large.
static void append_distance(const WhyWords *words, const LimitComparison *c, Buf *out)
{
    const bool strict = c->op == SM_OP_LT || c->op == SM_OP_GT;
    const bool more = c->op == SM_OP_GT || c->op == SM_OP_GE || (c->op == SM_OP_EQ && c->limit > c->x);
    const char *d = distance_text(words->arena, c->x, c->limit);

    if (c->op == SM_OP_NE || (c->left->kind == EX_VAR && (c->left->var->state_of || c->left->var->type == SM_BOOL)))
        return;
    if (c->x == c->limit)
        buf_printf(out, ", needs %s", more ? "more" : "less");
    else if (d)
        buf_printf(out, ", needs %s%s %s", strict ? "more than " : "", d, more ? "more" : "less");
}

static bool is_whole_time(double x) { return x >= 0 && x < 9007199254740992.0 && (double)(uint64_t)x == x; }

// Appends when a condition about T becomes true.
static void append_due(const WhyWords *words, const LimitComparison *c, Buf *out)
{
    const uint64_t start = words->w->entered_g;

    if ((c->op == SM_OP_GE || c->op == SM_OP_GT) && is_whole_time(c->limit) && start <= UINT64_MAX / 2)
        buf_printf(out, ", true %s G = %" PRIu64 " if the machine stays in %s", c->op == SM_OP_GE ? "from" : "after",
                   start + (uint64_t)c->limit, words->w->state->name->text);
}

// Appends for how much of its time the condition of held(c, t) has been true.
static void append_held(const WhyWords *words, const WatchStmt *s, uint32_t leaf, Buf *out)
{
    const Expr *e = s->node[leaf].e, *run = watch_held_run(e);
    const RefWindow *w = &words->windows->at[run->window];
    const uint64_t limit = (uint64_t)e->arg[1]->number;

    if (w->filled == 0)
        buf_str(out, "; its condition was false when the step began");
    else if (run->stat == SM_STAT_RUN_STEPS)
        buf_printf(out, "; its condition was true for %lu of %" PRIu64 " steps", (unsigned long)w->filled, limit);
    else
        buf_printf(out, "; its condition was true since G = %" PRIu64 ", for %" PRIu64 " of %" PRIu64, w->time[0], w->last - w->time[0], limit);
}

void why_append_need(const WhyWords *words, const WatchStmt *s, uint32_t node, Buf *out)
{
    const Expr *e = s->node[node].e;
    LimitComparison c;

    if (s->node[node].kind != WATCH_LEAF || watch_truth(s, s->value, node) || s->step != words->w->step)
        return;
    if (watch_held_run(e)) {
        if (words->windows)
            append_held(words, s, node, out);
    } else if (read_comparison(s, node, &c)) {
        if (c.left->kind == EX_VAR && c.left->var->kind == VAR_TIME)
            append_due(words, &c, out);
        else
            append_distance(words, &c, out);
    }
}

// ---- conditions ----

const char *why_condition(const WhyWords *words, const WatchStmt *s, uint32_t node, bool since)
{
    Buf out, operands;

    buf_init(&out, words->arena);
    buf_init(&operands, words->arena);
    buf_printf(&out, "%s was %s", why_quote(words->arena, s->node[node].e->span), watch_truth(s, s->value, node) ? "true" : "false");
    if (since && s->since[node] < s->step)
        buf_printf(&out, " since %s", why_step(words->arena, s->since[node], s->since_g[node]));
    else if (since && !words->w->is_first)
        buf_str(&out, ", since this step");
    if (s->node[node].kind != WATCH_LEAF)
        return buf_text(&out);
    why_append_operands(words, s, s->value, node, &operands);
    if (operands.n)
        buf_printf(&out, ": %s", buf_text(&operands));
    why_append_need(words, s, node, &out);
    return buf_text(&out);
}

const WatchStmt *why_obstacle(const Watch *w, const WatchStmt *s)
{
    const WatchStmt *outer = s->parent ? why_obstacle(w, s->parent) : NULL;

    return outer ? outer : s->step == w->step ? NULL : s;
}

bool why_is_blocked(const WatchStmt *obstacle)
{
    return obstacle->parent && watch_truth(obstacle->parent, obstacle->parent->value, 0) == obstacle->in_else;
}

static void append_guard(const WhyWords *words, const WatchStmt *guard, const uint64_t *value, Buf *out)
{
    Buf operands;

    buf_init(&operands, words->arena);
    why_append_operands(words, guard, value, 0, &operands);
    buf_printf(out, "%s%s was %s%s%s", out->n ? "; " : "", why_quote(words->arena, guard->node[0].e->span),
               watch_truth(guard, value, 0) ? "true" : "false", operands.n ? ": " : "", buf_text(&operands));
}

static void append_guards(const WhyWords *words, const WatchStmt *s, const uint64_t *value, Buf *out)
{
    if (!s->parent)
        return;
    append_guards(words, s->parent, value, out);
    append_guard(words, s->parent, value, out);
}

const char *why_guards(const WhyWords *words, const WatchStmt *s, const uint64_t *value)
{
    Buf out;

    buf_init(&out, words->arena);
    append_guards(words, s, value, &out);
    return buf_text(&out);
}

const char *why_store(const WhyWords *words, const WatchStmt *s)
{
    const uint64_t cell = ref_convert(s->stmt->var->type, watch_number(s, s->value, 0));
    Buf out, operands;

    buf_init(&out, words->arena);
    buf_init(&operands, words->arena);
    if (s->nodes == 1 && s->node[0].e->kind != EX_VAR)
        return format_in(words->arena, "%s was executed", why_quote(words->arena, s->stmt->span));
    buf_printf(&out, "%s stored ", why_quote(words->arena, s->stmt->span));
    why_append_cell(s->stmt->var, cell, &out);
    why_append_operands(words, s, s->value, 0, &operands);
    if (operands.n)
        buf_printf(&out, ": %s", buf_text(&operands));
    return buf_text(&out);
}
