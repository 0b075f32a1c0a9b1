// SPDX-License-Identifier: Apache-2.0
// What the machine reads, writes and stores: elements, parameters that can be set, constants, other locals, definitions, windows; with the comments
// of its author.
#include <string.h>

#include "compiler/report/comment.h"
#include "compiler/report/describe.h"
#include "compiler/report/page.h"
#include "compiler/report/page_text.h"
#include "compiler/report/written.h"

// ---- uses of variables by state ----

// The names of the states and sections [all_states] that read and write a variable; and the last name added to each, so that none is added
// twice.
typedef struct VarUse { const char *last_read, *last_written; Buf readers, writers; } VarUse;

typedef struct VarUses {
    Arena *arena;
    VarUse *of;                   // by Var.index: where the variable is used
    const char *place;            // name of the state or section whose statements are being recorded
} VarUses;

// Appends the state (or section) that uses a variable. `last`: the one appended last, which is not repeated.
static void add_place(Buf *list, const char **last, const char *place)
{
    if (*last == place)
        return;
    buf_printf(list, "%s%s", list->n ? ", " : "", place);
    *last = place;
}

// Notes that the current state reads the variable of this expression; the caller visits all subexpressions.
static void record_read(Expr *e, void *context)
{
    VarUses *u = context;

    if (e->kind == EX_VAR)
        add_place(&u->of[e->var->index].readers, &u->of[e->var->index].last_read, u->place);
}

// Records the variables that statements read and write.  Recursion is bounded by the nesting of conditionals, AST_DEPTH_MAX.
static void record_statements(VarUses *u, const Stmts *stmts)
{
    for (size_t i = 0; i < stmts->n; i++) {
        const Stmt *s = stmts->at[i];
        if (s->value)
            expr_walk(s->value, record_read, u);
        if (s->kind == ST_ASSIGN)
            add_place(&u->of[s->var->index].writers, &u->of[s->var->index].last_written, u->place);
        record_statements(u, &s->then);
        record_statements(u, &s->otherwise);
    }
}

// For each variable, the states and [all_states] sections that read and write it.
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
            const Stmts own = written_own_stmts(p->state.at[s], (BlockKind)b);
            u.place = p->state.at[s]->name->text;
            record_statements(&u, &own);
        }
    for (size_t i = 0; i < p->all_states.n; i++) {
        const Stmts stmts = written_section_stmts(p, p->all_states.at[i]);
        u.place = written_section_name(r->arena, p, p->all_states.at[i], "");
        record_statements(&u, &stmts);
    }
    return u.of;
}

// ---- elements ----

static const DocColumn element_columns[] = {{"name", "Element"},
                                            {"type", "Type"},
                                            {"unit", "Unit"},
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
    return v->command ? "command" : v->read ? "input" : "unused";
}

static const char *unit_of(const Measure *unit) { return unit ? unit->text : ""; }

// Returns a range as text: "lo to hi".
static const char *numbers_text(Arena *arena, SmF64 lo, SmF64 hi)
{
    return format_in(arena, "%s to %s", report_format_number(arena, trace_cell_value(SM_F64, sm_bits(lo))),
                     report_format_number(arena, trace_cell_value(SM_F64, sm_bits(hi))));
}

// Returns the names of an element: that of the machine, its alias, and that of the state vector if a binding makes it another one.
static const char *names_of_element(Arena *arena, const Var *v)
{
    const char *name = v->alias ? format_in(arena, "%s (%s)", v->name->text, v->alias->text) : v->name->text;

    return v->element->name != v->name ? format_in(arena, "%s = %s", name, v->element->name->text) : name;
}

static void add_elements(const Report *r, Doc *d, const VarUse *use)
{
    const Program *p = r->analysis.p;
    DocTable *t = DOC_ADD_TABLE(d, "elements", element_columns);

    for (size_t i = 0; i < p->var.n; i++) {
        const Var *v = p->var.at[i];
        if (v->kind != VAR_ELEMENT)
            continue;
        doc_add_code_cell(t, names_of_element(r->arena, v));
        doc_add_plain_cell(t, sm_type_info[v->type].spelling);
        doc_add_plain_cell(t, unit_of(v->unit));
        doc_add_plain_cell(t, role_text(p, v));
        doc_add_plain_cell(t, v->range ? numbers_text(r->arena, v->range->lo, v->range->hi) : "");
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
                                              {"unit", "Unit"},
                                              {"formula", "Formula"},
                                              {"comment", "Comment"},
                                              {"read", "Read in"},
                                              {"line", "Line"}};

static const DocColumn local_columns[] = {
    {"name", "Local"}, {"type", "Type"}, {"value", "Initial value"}, {"unit", "Unit"}, {"comment", "Comment"}, {"read", "Read in"},
    {"written", "Written in"}, {"line", "Line"}};

static bool is_settable(const Var *v) { return v->kind == VAR_LOCAL && v->parameter; }
static bool is_parameter(const Var *v) { return v->kind == VAR_LOCAL && !v->written && !v->parameter; }
static bool is_changing_local(const Var *v) { return v->kind == VAR_LOCAL && v->written; }

static size_t count_variables(const Program *p, bool (*wanted)(const Var *v))
{
    size_t n = 0;

    for (size_t i = 0; i < p->var.n; i++)
        n += wanted(p->var.at[i]);
    return n;
}

static const DocColumn setting_columns[] = {{"name", "Parameter"}, {"type", "Type"}, {"unit", "Unit"},       {"range", "Range"},
                                            {"default", "Default"},
                                            {"value", "Value"},                      {"comment", "Comment"}, {"read", "Read in"}, {"line", "Line"}};

// Lists what is marked @parameter.
static void add_settings(const Report *r, Doc *d, VarUse *use)
{
    const Program *p = r->analysis.p;
    DocTable *t;

    if (count_variables(p, is_settable) == 0)
        return;
    doc_add_heading(d, "settings", "Parameters that can be set");
    doc_add_legend(d, TEXT_SETTINGS);
    t = DOC_ADD_TABLE(d, "settings", setting_columns);
    for (size_t i = 0; i < p->var.n; i++) {
        const Var *v = p->var.at[i];
        if (!is_settable(v))
            continue;
        doc_add_code_cell(t, v->name->text);
        doc_add_plain_cell(t, sm_type_info[v->type].spelling);
        doc_add_plain_cell(t, unit_of(v->unit));
        doc_add_plain_cell(t, v->type == SM_BOOL ? "" : numbers_text(r->arena, v->parameter->lo, v->parameter->hi));
        doc_add_plain_cell(t, report_format_cell(r->arena, v->type, v->parameter->standard));
        doc_add_plain_cell(t, report_format_cell(r->arena, v->type, v->init));
        doc_add_plain_cell(t, comment_of_variable(r->arena, v));
        doc_add_plain_cell(t, readers_text(r, v, &use[i]));
        doc_add_line_cell(t, report_line_of(v->span));
    }
}

static void add_parameters(const Report *r, Doc *d, VarUse *use)
{
    const Program *p = r->analysis.p;
    DocTable *t;

    if (count_variables(p, is_parameter) == 0)
        return;
    doc_add_heading(d, "parameters", "Parameters");
    doc_add_legend(d, TEXT_PARAMETERS);
    t = DOC_ADD_TABLE(d, "parameters", parameter_columns);
    for (size_t i = 0; i < p->var.n; i++) {
        const Var *v = p->var.at[i];
        if (!is_parameter(v))
            continue;
        doc_add_code_cell(t, v->name->text);
        doc_add_plain_cell(t, sm_type_info[v->type].spelling);
        doc_add_plain_cell(t, report_format_cell(r->arena, v->type, v->init));
        doc_add_plain_cell(t, unit_of(v->unit));
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
    doc_add_legend(d, TEXT_LOCALS);
    t = DOC_ADD_TABLE(d, "locals", local_columns);
    for (size_t i = 0; i < p->var.n; i++) {
        const Var *v = p->var.at[i];
        if (!is_changing_local(v))
            continue;
        doc_add_code_cell(t, v->name->text);
        doc_add_plain_cell(t, sm_type_info[v->type].spelling);
        doc_add_plain_cell(t, report_format_cell(r->arena, v->type, v->init));
        doc_add_plain_cell(t, unit_of(v->unit));
        doc_add_plain_cell(t, comment_of_variable(r->arena, v));
        doc_add_plain_cell(t, readers_text(r, v, &use[i]));
        doc_add_plain_cell(t, buf_text(&use[i].writers));
        doc_add_line_cell(t, report_line_of(v->span));
    }
}

// ---- definitions ----

static const DocColumn define_columns[] = {
    {"name", "Definition"}, {"meaning", "Expression"}, {"unit", "Unit"}, {"comment", "Comment"}, {"used", "Used in"}, {"line", "Line"}};

// Returns the state whose own part of the source contains the position; NULL: it is elsewhere.  States have the order of the file.
static const State *state_at(const Program *p, Span at)
{
    const State *state = NULL;
    Span range;

    for (size_t s = 0; s < p->state.n && p->state.at[s]->span.at <= at.at; s++)
        state = p->state.at[s];
    if (!state)
        return NULL;
    range = written_state_range(state);
    return at.at < range.at + range.len ? state : NULL;
}

// Returns the name of the part of the machine that contains a use.
static const char *place_of_use(const Report *r, const DefineUse *use)
{
    const Program *p = r->analysis.p;
    const AllStates *all = written_section(p, use->span);
    const State *state = all ? NULL : state_at(p, use->span);

    return use->inside ? use->inside->name->text : all ? written_section_name(r->arena, p, all, "") : state ? state->name->text : "initial values";
}

// Returns where a definition is used: other definitions, states and sections [all_states], each once.
static const char *uses_text(const Report *r, const Define *d)
{
    VEC(const char *) place = {NULL, 0, 0};
    Buf out;

    buf_init(&out, r->arena);
    for (size_t i = 0; i < d->use.n; i++) {
        const char *name = place_of_use(r, &d->use.at[i]);
        bool listed = false;
        for (size_t k = 0; k < place.n && !listed; k++)
            listed = strcmp(place.at[k], name) == 0;
        if (listed)
            continue;
        buf_printf(&out, "%s%s", place.n ? ", " : "", name);
        vec_push(r->arena, &place, name);
    }
    return buf_text(&out);
}

static void add_definitions(const Report *r, Doc *d)
{
    const Defines *all = &r->analysis.p->define;
    DocTable *t;

    if (all->n == 0)
        return;
    doc_add_heading(d, "definitions", "Definitions");
    doc_add_legend(d, TEXT_DEFINITIONS);
    t = DOC_ADD_TABLE(d, "definitions", define_columns);
    for (size_t i = 0; i < all->n; i++) {
        const Define *def = all->at[i];
        doc_add_code_cell(t, def->name->text);
        doc_add_code_cell(t, source_text(r->arena, def->value_span));
        doc_add_plain_cell(t, unit_of(def->unit));
        doc_add_plain_cell(t, comment_around(r->arena, (Span){def->span.src, def->span.at, def->value_span.at + def->value_span.len - def->span.at}));
        doc_add_plain_cell(t, uses_text(r, def));
        doc_add_line_cell(t, report_line_of(def->span));
    }
}

// ---- windows ----

static const DocColumn window_columns[] = {{"call", "Call"}, {"meaning", "Meaning"}, {"steps", "Steps"}, {"line", "Line"}};

// Lists each call once: those in [all_states] and in definitions have a window for each copy and use.
static void add_windows(const Report *r, Doc *d)
{
    const Windows *w = &r->analysis.p->window;
    bool *listed = ARENA_ARRAY(r->arena, bool, r->analysis.p->src->len + 1u);     // by position in the source
    DocTable *t;

    if (w->n == 0)
        return;
    doc_add_heading(d, "windows", "Rolling statistics");
    doc_add_legend(d, TEXT_WINDOWS);
    t = DOC_ADD_TABLE(d, "windows", window_columns);
    for (size_t i = 0; i < w->n; i++) {
        if (listed[w->at[i].span.at] || w->at[i].stat == SM_STAT_ELAPSED)      // listed already, or an internal part of `held` or `rate`
            continue;
        listed[w->at[i].span.at] = true;
        doc_add_code_cell(t, source_text(r->arena, w->at[i].span));
        doc_add_text_cell(t, describe_window(r->arena, r->analysis.p, &w->at[i]));
        if (w->at[i].stat == SM_STAT_RUN_TIME)         // it counts time and stores no samples
            doc_add_plain_cell(t, "");
        else
            doc_add_number_cell(t, w->at[i].size);
        doc_add_line_cell(t, report_line_of(w->at[i].span));
    }
}

void report_add_variables(Report *r, Doc *d)
{
    VarUse *use = find_variable_uses(r);

    doc_add_section(d, "variables", "Inputs, outputs and parameters");
    add_elements(r, d, use);
    add_settings(r, d, use);
    add_parameters(r, d, use);
    add_locals(r, d, use);
    add_definitions(r, d);
    add_windows(r, d);
}
