// SPDX-License-Identifier: Apache-2.0
// Writes statements and expressions as text that is equal if they mean the same, however the source spells them (diff_part.h).
#include <inttypes.h>
#include <string.h>

#include "compiler/diff/diff_part.h"
#include "stdlib/convert.h"
#include "stdlib/f64.h"

// Returns the state whose number the expression e is, where e is compared with S or assigned to it: e is the name of a state (language.md 3.30) or
// a plain number.  A plain
// number means the same in both machines only if all states have the same numbers in both.
static const State *state_of_number(const Canon *c, const Expr *e)
{
    const Program *p = c->p;
    const double x = e->kind == EX_NUMBER ? e->number : 0;
    const State *s;

    if (!(x >= 1 && x <= p->state.n) || !e->span.src)
        return NULL;
    s = p->state.at[(uint32_t)x - 1];
    if (e->number == s->number && c->keeps_numbers)
        return s;
    return e->number == s->number && e->span.len == s->name->len && memcmp(e->span.src->text + e->span.at, s->name->text, s->name->len) == 0
           ? s : NULL;
}

static bool is_s(const Program *p, const Expr *e) { return e->kind == EX_VAR && e->var == p->s; }

// Writes a comparison of S with the name of a state.  Returns false if e is no such comparison.
static bool canon_state_comparison(const Canon *c, const Expr *e, Buf *out)
{
    const State *s = NULL;

    if (e->kind != EX_BINARY || (e->op != SM_OP_EQ && e->op != SM_OP_NE))
        return false;
    if (is_s(c->p, e->arg[0]))
        s = state_of_number(c, e->arg[1]);
    else if (is_s(c->p, e->arg[1]))
        s = state_of_number(c, e->arg[0]);
    if (s)
        buf_printf(out, "(S%d %s)", (int)e->op, c->state[s->number]);
    return s != NULL;
}

// Writes the canonical name of a variable. A constant becomes its value, so that its name does not matter.
static void canon_var(const Canon *c, const Var *v, Buf *out)
{
    if (v->kind == VAR_LOCAL && v->is_constant)
        buf_printf(out, "%a", (double)sm_cell_to_f64(v->type, v->init));
    else
        buf_printf(out, "%s%s", c->var[v->index], v == c->p->s && !c->keeps_numbers ? c->side : "");
}

// Writes what a window stores: statistic, size, gap between samples, whether it is measured in time, and the sampled expression.
static void canon_window(const Canon *c, const Window *w, Buf *out)
{
    buf_printf(out, "window%d/%lu/%" PRIu64 "/%d[", (int)w->stat, (unsigned long)w->size, w->gap, w->time != NULL);
    canon_expr(c, w->sample, out);
    buf_char(out, ']');
}

// Writes an expression in canonical form.  Recursion is bounded: expressions by AST_DEPTH_MAX, windows inside windows by the size of the file.
void canon_expr(const Canon *c, const Expr *e, Buf *out)
{
    if (canon_state_comparison(c, e, out))
        return;
    switch (e->kind) {
    case EX_NUMBER: buf_printf(out, "%a", (double)e->number); return;
    case EX_VAR: canon_var(c, e->var, out); return;
    case EX_ROLL:
        buf_printf(out, "stat%d:", (int)e->stat);
        canon_window(c, &c->p->window.at[e->window], out);
        return;
    case EX_UNARY: buf_printf(out, "u%d(", (int)e->op); break;
    case EX_BINARY:
        if (e->op == SM_OP_GT || e->op == SM_OP_GE) {     // written as b < a, so that both spellings are equal
            buf_printf(out, "b%d(", (int)(e->op == SM_OP_GT ? SM_OP_LT : SM_OP_LE));
            canon_expr(c, e->arg[1], out);
            buf_char(out, ',');
            canon_expr(c, e->arg[0], out);
            buf_char(out, ')');
            return;
        }
        buf_printf(out, "b%d(", (int)e->op);
        break;
    case EX_CHAIN:
        buf_str(out, "chain");
        for (uint32_t i = 0; i + 1 < e->n; i++)
            buf_printf(out, " %d", (int)expr_ops(e)[i]);
        buf_char(out, '(');
        break;
    case EX_CALL: buf_printf(out, "f%d(", (int)e->fn); break;
    case EX_EVERY: case EX_AT: case EX_RANDOM: buf_str(out, "script("); break;       // never in a machine
    }
    for (uint32_t i = 0; i < e->n; i++) {
        buf_str(out, i ? "," : "");
        canon_expr(c, e->arg[i], out);
    }
    buf_char(out, ')');
}

void canon_stmt(const Canon *c, const Stmt *s, Buf *out)
{
    switch (s->kind) {
    case ST_TRANSITION:
        buf_printf(out, "->%s;", c->state[s->target->number]);
        break;
    case ST_ASSIGN:
        buf_printf(out, "%s=", c->var[s->var->index]);
        canon_expr(c, s->value, out);
        buf_char(out, ';');
        break;
    case ST_IF:
        buf_str(out, "if ");
        canon_expr(c, s->value, out);
        buf_char(out, '{');
        canon_stmts(c, &s->then, out);
        buf_str(out, "}{");
        canon_stmts(c, &s->otherwise, out);
        buf_char(out, '}');
        break;
    }
}

void canon_stmts(const Canon *c, const Stmts *list, Buf *out)
{
    for (size_t i = 0; i < list->n; i++)
        canon_stmt(c, list->at[i], out);
}

void canon_state(const Canon *c, const State *s, Buf *out)
{
    for (int b = 0; b < BLOCK_COUNT; b++) {
        buf_printf(out, ".%d ", b);
        canon_stmts(c, &s->block[b], out);
    }
}

// Returns a condition and all the conditions around it in canonical form, joined by "&", each with "!" if it must be false.
const char *canon_condition(Arena *arena, const Canon *c, const Condition *when)
{
    Buf out;

    buf_init(&out, arena);
    for (; when; when = when->outer) {
        buf_str(&out, when->holds ? "&" : "&!");
        canon_expr(c, when->stmt->value, &out);
    }
    return buf_text(&out);
}
