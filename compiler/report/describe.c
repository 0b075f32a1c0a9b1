// SPDX-License-Identifier: Apache-2.0
// Statements as sentences.  Names and formulas of the author appear in backticks.
#include "compiler/report/describe.h"

#include <string.h>

#include "compiler/analysis/transitions.h"
#include "compiler/report/comment.h"
#include "stdlib/convert.h"

// ---- helpers ----

// Returns what separates item i of n from the one before, in a sentence: "", ", " or " and ".
const char *describe_separator(size_t i, size_t n) { return i == 0 ? "" : i + 1 < n ? ", " : " and "; }

// Returns a count and its noun: "1 state", "2 states".
const char *describe_count(Arena *arena, uint64_t n, const char *one, const char *many)
{
    return format_in(arena, "%llu %s", (unsigned long long)n, n == 1 ? one : many);
}

const char *describe_time(Arena *arena, const Program *p, uint64_t units)
{
    TimeUnit unit = p->time_unit;
    uint64_t per = 1, fraction;               // per: units of G in one `unit`; fraction: units % per, without zeros at its end
    int digits = 0;                           // number of digits of the fraction after the decimal point

    for (; unit < TIME_S && units >= per * 1000; unit++) {
        per *= 1000;
        digits += 3;
    }
    for (fraction = units % per; digits > 0 && fraction % 10 == 0; digits--)
        fraction /= 10;
    if (digits == 0)
        return format_in(arena, "%llu %s", (unsigned long long)(units / per), time_unit_name(unit));
    return format_in(arena, "%llu.%0*llu %s", (unsigned long long)(units / per), digits, (unsigned long long)fraction, time_unit_name(unit));
}

// Returns how far back a window reaches: "step", "10 steps", "2 s, 101 samples".
static const char *describe_window_size(Arena *arena, const Program *p, const Window *w)
{
    if (w->in_time)
        return format_in(arena, "%s, %s", describe_time(arena, p, (w->size - 1) * p->step), describe_count(arena, w->size, "sample", "samples"));
    return w->size == 1 ? "step" : format_in(arena, "%lu steps", (unsigned long)w->size);
}

// Returns what a window samples, as it is written.  The checker adds two `not` to a condition, which have the position of the call.
static const char *describe_sample(Arena *arena, const Window *w)
{
    const Expr *e = w->sample;

    while (e->kind == EX_UNARY && e->op == SM_OP_NOT && e->span.at == w->span.at)
        e = e->arg[0];
    return source_text(arena, e->span);
}

// Returns `prev`, `rising` or `falling` in words: they read a sample and the one before.
static const char *describe_neighbours(Arena *arena, const Window *w, const char *sample)
{
    static const struct { const char *name, *words; } call[] = {
        {"rising", "whether `%s` is true now and was false one step before"},
        {"falling", "whether `%s` is false now and was true one step before"},
    };
    const char *written = source_text(arena, w->span);

    for (size_t i = 0; i < sizeof call / sizeof *call; i++)
        if (strncmp(written, call[i].name, strlen(call[i].name)) == 0)
            return format_in(arena, call[i].words, sample);
    return format_in(arena, "`%s` one step before", sample);
}

// Returns the time of `held(condition, time)` as written.
static const char *describe_held_time(Arena *arena, const Window *w)
{
    const char *call = source_text(arena, w->span), *time = strrchr(call, ',');
    size_t n;

    if (!time)
        return "a time";
    time += 1 + strspn(time + 1, " \t");
    n = strcspn(time, ")");
    return format_in(arena, "`%.*s`", (int)n, time);
}

// Returns a window in words.
const char *describe_window(Arena *arena, const Program *p, const Window *w)
{
    static const char *const name[] = {"the average", "the median", "the smallest", "the largest", "the range"};
    const char *sample = describe_sample(arena, w), *size = describe_window_size(arena, p, w);

    switch (w->stat) {
    case SM_STAT_OLDEST: case SM_STAT_NEWEST: return describe_neighbours(arena, w, sample);
    case SM_STAT_CHANGE: return format_in(arena, "the change of `%s` over the last %s, per second", sample, size);
    case SM_STAT_RUN_STEPS: return format_in(arena, "whether `%s` was true in each of the last %s", sample, size);
    case SM_STAT_RUN_TIME: return format_in(arena, "whether `%s` has been true for %s", sample, describe_held_time(arena, w));
    default: return format_in(arena, "%s of `%s` over the last %s", name[w->stat], sample, size);
    }
}

static uint32_t line_of(Span span) { return source_position(span.src, span.at).line; }

// Adds a sentence, with the comments above and after the statement.  Comments of a line with several statements go to the first one.
static void add_sentence(DocList *l, unsigned depth, Span span, const char *text)
{
    const uint32_t line = line_of(span);
    const bool first = l->line.n == 0 || l->line.at[l->line.n - 1].line != line;

    doc_add_list_line(l, depth, line, text);
    if (first)
        doc_set_line_comment(l, comment_around(l->arena, span));
}

// ---- assignments ----

static bool is_var(const Expr *e, const Var *v) { return e->kind == EX_VAR && e->var == v; }

// Returns "adds `c` to `x`" for `x = x + c`, and "subtracts" for `x = x - c`; NULL for any other assignment.
static const char *describe_increment(Arena *arena, const Stmt *s)
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

// The assignment in words: an increment or decrement as such, else "sets x to value". A number stored in a boolean reads as true or false.
static const char *describe_assignment(Arena *arena, const Stmt *s)
{
    const char *changed = describe_increment(arena, s);
    const Expr *e = s->value;

    if (changed)
        return changed;
    if (s->var->type == SM_BOOL && e->kind == EX_NUMBER)
        return format_in(arena, "sets `%s` to `%s`", s->var->name->text, sm_to_bool(e->number) ? "true" : "false");
    return format_in(arena, "sets `%s` to `%s`", s->var->name->text, source_text(arena, e->span));
}

// Describes an assignment or a transition.
static const char *describe_unconditional(Arena *arena, const Stmt *s)
{
    return s->kind == ST_ASSIGN ? describe_assignment(arena, s) : format_in(arena, "goes to ^%s^", s->target->name->text);
}

// ---- conditionals ----

static void add_statements(DocList *l, const Stmts *stmts, unsigned depth);

// Adds one sentence for a branch and `only`, its only statement, with the comments of both.
static void add_short_branch(DocList *l, unsigned depth, Span span, const char *text, const Stmt *only)
{
    DocLine *line;
    const char *comment;

    add_sentence(l, depth, span, text);
    line = &l->line.at[l->line.n - 1];
    comment = line_of(only->span) == line->line ? NULL : comment_around(l->arena, only->span);
    if (comment)
        line->comment = line->comment ? format_in(l->arena, "%s\n%s", line->comment, comment) : comment;
}

// Adds a branch, in one sentence if it contains only one assignment or transition.  `when`: "if `p > 5`" or "otherwise".
static void add_branch(DocList *l, const char *when, const Stmts *stmts, Span span, unsigned depth)
{
    const Stmt *only = stmts->n == 1 ? stmts->at[0] : NULL;

    if (only && only->kind == ST_TRANSITION)
        add_short_branch(l, depth, span, format_in(l->arena, "%s %s", describe_unconditional(l->arena, only), when), only);
    else if (only && only->kind == ST_ASSIGN)
        add_short_branch(l, depth, span, format_in(l->arena, "%s: %s", when, describe_unconditional(l->arena, only)), only);
    else {
        add_sentence(l, depth, span, format_in(l->arena, stmts->n ? "%s:" : "%s: does nothing", when));
        add_statements(l, stmts, depth + 1);
    }
}

// Writes a conditional and its `else if` branches, one line each, at the same depth.
static void add_conditional(DocList *l, const Stmt *s, unsigned depth)
{
    const char *when = "if";
    const Stmt *last = s;

    for (;; s = s->otherwise.at[0], when = "otherwise, if") {
        add_branch(l, format_in(l->arena, "%s `%s`", when, source_text(l->arena, s->value->span)), &s->then, s->span, depth);
        last = s;
        if (s->otherwise.n != 1 || s->otherwise.at[0]->kind != ST_IF)
            break;
    }
    if (last->otherwise.n)
        add_branch(l, "otherwise", &last->otherwise, comment_else_line(last->otherwise.at[0]->span), depth);
}

// Adds a sentence for each statement.  Recursion is bounded by the nesting of conditionals, AST_DEPTH_MAX.
static void add_statements(DocList *l, const Stmts *stmts, unsigned depth)
{
    for (size_t i = 0; i < stmts->n; i++)
        if (stmts->at[i]->kind == ST_IF)
            add_conditional(l, stmts->at[i], depth);
        else
            add_sentence(l, depth, stmts->at[i]->span, describe_unconditional(l->arena, stmts->at[i]));
}

void describe_block(DocList *l, const Stmts *block) { add_statements(l, block, 0); }
