// SPDX-License-Identifier: Apache-2.0
// What the machine reads, writes and stores: elements, parameters, other locals, windows; with the comments of its author.
#include "compiler/report/comment.h"
#include "compiler/report/describe.h"
#include "compiler/report/page.h"
#include "compiler/report/page_text.h"

// ---- uses of variables by state ----

typedef struct Use { const State *last_read, *last_written; Buf readers, writers; } Use;      // names of states

typedef struct Uses {
    Arena *arena;
    Use *of;                      // by Var.index
    const State *state;
} Uses;

static void note(Buf *list, const State **last, const State *s)
{
    if (*last == s)
        return;
    buf_printf(list, "%s%s", list->n ? ", " : "", s->name->text);
    *last = s;
}

static void note_read(Expr *e, void *context)
{
    Uses *u = context;

    if (e->kind == EX_VAR)
        note(&u->of[e->var->index].readers, &u->of[e->var->index].last_read, u->state);
}

// Recursion is bounded by the nesting of conditionals, AST_DEPTH_MAX.
static void note_stmts(Uses *u, const Stmts *stmts)
{
    for (size_t i = 0; i < stmts->n; i++) {
        const Stmt *s = stmts->at[i];
        if (s->value)
            expr_walk(s->value, note_read, u);
        if (s->kind == ST_ASSIGN)
            note(&u->of[s->var->index].writers, &u->of[s->var->index].last_written, u->state);
        note_stmts(u, &s->then);
        note_stmts(u, &s->otherwise);
    }
}

static Use *find_uses(const Report *r)
{
    const Program *p = r->analysis.p;
    Uses u = {r->arena, ARENA_ARRAY(r->arena, Use, p->var.n), NULL};

    for (size_t i = 0; i < p->var.n; i++) {
        buf_init(&u.of[i].readers, r->arena);
        buf_init(&u.of[i].writers, r->arena);
    }
    for (size_t s = 0; s < p->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++) {
            u.state = p->state.at[s];
            note_stmts(&u, &u.state->block[b]);
        }
    return u.of;
}

// ---- elements ----

static const DocColumn element_columns[] = {{"name", "Element"},
                                            {"type", "Type"},
                                            {"role", "Role"},
                                            {"range", "Healthy range"},
                                            {"comment", "Comment"},
                                            {"read", "Read in"},
                                            {"written", "Written in"}};

static const char *role(const Program *p, const Var *v)
{
    if (v == p->g)
        return "time";
    if (v == p->s)
        return "state number";
    if (v->written)
        return v->read ? "output, read back" : "output";
    return v->read ? "input" : "unused";
}

static const char *name_of(Arena *arena, const Var *v)
{
    return v->alias ? format_in(arena, "%s (%s)", v->name->text, v->alias->text) : v->name->text;
}

static double number_of(SmF64 x)
{
    return trace_number(SM_F64, sm_bits(x));
}

static const char *range_of(Arena *arena, const Var *v)
{
    if (!v->range)
        return "";
    return format_in(arena, "%s to %s", report_number(arena, number_of(v->range->lo)),
                     report_number(arena, number_of(v->range->hi)));
}

// The comment at the machine's own declaration, otherwise at that in the state vector.
static const char *comment_of(Arena *arena, const Var *v)
{
    const char *own = comment_behind(arena, v->span);

    return own || !v->element ? own : comment_behind(arena, v->element->span);
}

static void put_elements(const Report *r, Doc *d, const Use *use)
{
    const Program *p = r->analysis.p;
    DocTable *t = DOC_TABLE_OF(d, "elements", element_columns);

    for (size_t i = 0; i < p->var.n; i++) {
        const Var *v = p->var.at[i];
        if (v->kind != VAR_ELEMENT)
            continue;
        cell_code(t, name_of(r->arena, v));
        cell_plain(t, sm_type_info[v->type].spelling);
        cell_plain(t, role(p, v));
        cell_plain(t, range_of(r->arena, v));
        cell_plain(t, comment_of(r->arena, v));
        cell_plain(t, buf_text(&use[i].readers));
        cell_plain(t, buf_text(&use[i].writers));
    }
}

// ---- locals ----

// The sizes of windows are computed at compile time; no state reads them.
static const char *readers_of(const Report *r, const Var *v, Use *use)
{
    return format_in(r->arena, "%s%s%s", buf_text(&use->readers), v->sizes && use->readers.n ? ", " : "",
                     v->sizes ? "sizes of windows" : "");
}

static const DocColumn parameter_columns[] = {{"name", "Parameter"},
                                              {"type", "Type"},
                                              {"value", "Value"},
                                              {"formula", "Formula"},
                                              {"comment", "Comment"},
                                              {"read", "Read in"},
                                              {"line", "Line"}};

static const DocColumn local_columns[] = {
    {"name", "Local"}, {"type", "Type"}, {"value", "Initial value"}, {"comment", "Comment"}, {"read", "Read in"},
    {"written", "Written in"}, {"line", "Line"}};

static bool is_parameter(const Var *v) { return v->kind == VAR_LOCAL && !v->written; }
static bool is_memory(const Var *v) { return v->kind == VAR_LOCAL && v->written; }

static size_t count(const Program *p, bool (*wanted)(const Var *v))
{
    size_t n = 0;

    for (size_t i = 0; i < p->var.n; i++)
        n += wanted(p->var.at[i]);
    return n;
}

static void put_parameters(const Report *r, Doc *d, Use *use)
{
    const Program *p = r->analysis.p;
    DocTable *t;

    if (count(p, is_parameter) == 0)
        return;
    doc_heading(d, "parameters", "Parameters");
    doc_paragraph(d, TEXT_PARAMETERS);
    t = DOC_TABLE_OF(d, "parameters", parameter_columns);
    for (size_t i = 0; i < p->var.n; i++) {
        const Var *v = p->var.at[i];
        if (!is_parameter(v))
            continue;
        cell_code(t, v->name->text);
        cell_plain(t, sm_type_info[v->type].spelling);
        cell_plain(t, report_cell(r->arena, v->type, v->init));
        cell_code(t, v->init_value && v->init_value->kind != EX_NUMBER ? source_text(r->arena, v->init_value->span) : "");
        cell_plain(t, comment_of(r->arena, v));
        cell_plain(t, readers_of(r, v, &use[i]));
        cell_line(t, report_line(v->span));
    }
}

static void put_locals(const Report *r, Doc *d, Use *use)
{
    const Program *p = r->analysis.p;
    DocTable *t;

    if (count(p, is_memory) == 0)
        return;
    doc_heading(d, "locals", "Locals");
    doc_paragraph(d, TEXT_LOCALS);
    t = DOC_TABLE_OF(d, "locals", local_columns);
    for (size_t i = 0; i < p->var.n; i++) {
        const Var *v = p->var.at[i];
        if (!is_memory(v))
            continue;
        cell_code(t, v->name->text);
        cell_plain(t, sm_type_info[v->type].spelling);
        cell_plain(t, report_cell(r->arena, v->type, v->init));
        cell_plain(t, comment_of(r->arena, v));
        cell_plain(t, readers_of(r, v, &use[i]));
        cell_plain(t, buf_text(&use[i].writers));
        cell_line(t, report_line(v->span));
    }
}

// ---- windows ----

static const DocColumn window_columns[] = {{"call", "Call"}, {"meaning", "Meaning"}, {"steps", "Steps"}, {"line", "Line"}};

static void put_windows(const Report *r, Doc *d)
{
    const Windows *w = &r->analysis.p->window;
    DocTable *t;

    if (w->n == 0)
        return;
    doc_heading(d, "windows", "Rolling statistics");
    doc_paragraph(d, TEXT_WINDOWS);
    t = DOC_TABLE_OF(d, "windows", window_columns);
    for (size_t i = 0; i < w->n; i++) {
        cell_code(t, source_text(r->arena, w->at[i].span));
        cell_text(t, describe_window(r->arena, &w->at[i]));
        cell_number(t, w->at[i].size);
        cell_line(t, report_line(w->at[i].span));
    }
}

void report_variables(Report *r, Doc *d)
{
    Use *use = find_uses(r);

    doc_section(d, "variables", "Inputs, outputs and parameters");
    put_elements(r, d, use);
    put_parameters(r, d, use);
    put_locals(r, d, use);
    put_windows(r, d);
}
