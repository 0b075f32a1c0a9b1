// SPDX-License-Identifier: Apache-2.0
// What the machine reads, writes and stores: elements, parameters, other locals, windows; with the comments of its author.
#include "compiler/report/comment.h"
#include "compiler/report/describe.h"
#include "compiler/report/page.h"
#include "compiler/report/page_text.h"

// ---- uses of variables by state ----

// The names of the states that read and write a variable; and the last state added to each, so that none is added twice.
typedef struct VarUse { const State *last_read, *last_written; Buf readers, writers; } VarUse;

typedef struct VarUses {
    Arena *arena;
    VarUse *of;                   // by Var.index: where the variable is used
    const State *state;
} VarUses;

static void add_state_name(Buf *list, const State **last, const State *s)
{
    if (*last == s)
        return;
    buf_printf(list, "%s%s", list->n ? ", " : "", s->name->text);
    *last = s;
}

static void record_read(Expr *e, void *context)
{
    VarUses *u = context;

    if (e->kind == EX_VAR)
        add_state_name(&u->of[e->var->index].readers, &u->of[e->var->index].last_read, u->state);
}

// Records the variables that statements read and write.  Recursion is bounded by the nesting of conditionals, AST_DEPTH_MAX.
static void record_statements(VarUses *u, const Stmts *stmts)
{
    for (size_t i = 0; i < stmts->n; i++) {
        const Stmt *s = stmts->at[i];
        if (s->value)
            expr_walk(s->value, record_read, u);
        if (s->kind == ST_ASSIGN)
            add_state_name(&u->of[s->var->index].writers, &u->of[s->var->index].last_written, u->state);
        record_statements(u, &s->then);
        record_statements(u, &s->otherwise);
    }
}

static VarUse *find_variable_uses(const Report *r)
{
    const Program *p = r->analysis.p;
    VarUses u = {r->arena, ARENA_ARRAY(r->arena, VarUse, p->var.n), NULL};

    for (size_t i = 0; i < p->var.n; i++) {
        buf_init(&u.of[i].readers, r->arena);
        buf_init(&u.of[i].writers, r->arena);
    }
    for (size_t s = 0; s < p->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++) {
            u.state = p->state.at[s];
            record_statements(&u, &u.state->block[b]);
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

// Returns what the variable is to the machine, in a word: input, output, constant, and so on.
static const char *role_text(const Program *p, const Var *v)
{
    if (v == p->g)
        return "time";
    if (v == p->s)
        return "state number";
    if (v->written)
        return v->read ? "output, read back" : "output";
    return v->read ? "input" : "unused";
}

static const char *range_text(Arena *arena, const Var *v)
{
    if (!v->range)
        return "";
    return format_in(arena, "%s to %s", report_format_number(arena, trace_cell_value(SM_F64, sm_bits(v->range->lo))),
                     report_format_number(arena, trace_cell_value(SM_F64, sm_bits(v->range->hi))));
}

static void add_elements(const Report *r, Doc *d, const VarUse *use)
{
    const Program *p = r->analysis.p;
    DocTable *t = DOC_ADD_TABLE(d, "elements", element_columns);

    for (size_t i = 0; i < p->var.n; i++) {
        const Var *v = p->var.at[i];
        if (v->kind != VAR_ELEMENT)
            continue;
        doc_add_code_cell(t, v->alias ? format_in(r->arena, "%s (%s)", v->name->text, v->alias->text) : v->name->text);
        doc_add_plain_cell(t, sm_type_info[v->type].spelling);
        doc_add_plain_cell(t, role_text(p, v));
        doc_add_plain_cell(t, range_text(r->arena, v));
        doc_add_plain_cell(t, comment_of_variable(r->arena, v));
        doc_add_plain_cell(t, buf_text(&use[i].readers));
        doc_add_plain_cell(t, buf_text(&use[i].writers));
    }
}

// ---- locals ----

// Returns where a variable is read: the names of states, and "sizes of windows" if a window's size, computed at compile time, depends on it.
static const char *readers_text(const Report *r, const Var *v, VarUse *use)
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
static bool is_changing_local(const Var *v) { return v->kind == VAR_LOCAL && v->written; }

static size_t count_variables(const Program *p, bool (*wanted)(const Var *v))
{
    size_t n = 0;

    for (size_t i = 0; i < p->var.n; i++)
        n += wanted(p->var.at[i]);
    return n;
}

static void add_parameters(const Report *r, Doc *d, VarUse *use)
{
    const Program *p = r->analysis.p;
    DocTable *t;

    if (count_variables(p, is_parameter) == 0)
        return;
    doc_add_heading(d, "parameters", "Parameters");
    doc_add_paragraph(d, TEXT_PARAMETERS);
    t = DOC_ADD_TABLE(d, "parameters", parameter_columns);
    for (size_t i = 0; i < p->var.n; i++) {
        const Var *v = p->var.at[i];
        if (!is_parameter(v))
            continue;
        doc_add_code_cell(t, v->name->text);
        doc_add_plain_cell(t, sm_type_info[v->type].spelling);
        doc_add_plain_cell(t, report_format_cell(r->arena, v->type, v->init));
        doc_add_code_cell(t, v->init_value && v->init_value->kind != EX_NUMBER ? source_text(r->arena, v->init_value->span) : "");
        doc_add_plain_cell(t, comment_of_variable(r->arena, v));
        doc_add_plain_cell(t, readers_text(r, v, &use[i]));
        doc_add_line_cell(t, report_line_of(v->span));
    }
}

static void add_locals(const Report *r, Doc *d, VarUse *use)
{
    const Program *p = r->analysis.p;
    DocTable *t;

    if (count_variables(p, is_changing_local) == 0)
        return;
    doc_add_heading(d, "locals", "Locals");
    doc_add_paragraph(d, TEXT_LOCALS);
    t = DOC_ADD_TABLE(d, "locals", local_columns);
    for (size_t i = 0; i < p->var.n; i++) {
        const Var *v = p->var.at[i];
        if (!is_changing_local(v))
            continue;
        doc_add_code_cell(t, v->name->text);
        doc_add_plain_cell(t, sm_type_info[v->type].spelling);
        doc_add_plain_cell(t, report_format_cell(r->arena, v->type, v->init));
        doc_add_plain_cell(t, comment_of_variable(r->arena, v));
        doc_add_plain_cell(t, readers_text(r, v, &use[i]));
        doc_add_plain_cell(t, buf_text(&use[i].writers));
        doc_add_line_cell(t, report_line_of(v->span));
    }
}

// ---- windows ----

static const DocColumn window_columns[] = {{"call", "Call"}, {"meaning", "Meaning"}, {"steps", "Steps"}, {"line", "Line"}};

static void add_windows(const Report *r, Doc *d)
{
    const Windows *w = &r->analysis.p->window;
    DocTable *t;

    if (w->n == 0)
        return;
    doc_add_heading(d, "windows", "Rolling statistics");
    doc_add_paragraph(d, TEXT_WINDOWS);
    t = DOC_ADD_TABLE(d, "windows", window_columns);
    for (size_t i = 0; i < w->n; i++) {
        doc_add_code_cell(t, source_text(r->arena, w->at[i].span));
        doc_add_text_cell(t, describe_window(r->arena, &w->at[i]));
        doc_add_number_cell(t, w->at[i].size);
        doc_add_line_cell(t, report_line_of(w->at[i].span));
    }
}

void report_add_variables(Report *r, Doc *d)
{
    VarUse *use = find_variable_uses(r);

    doc_add_section(d, "variables", "Inputs, outputs and parameters");
    add_elements(r, d, use);
    add_parameters(r, d, use);
    add_locals(r, d, use);
    add_windows(r, d);
}
