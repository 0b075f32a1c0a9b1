// SPDX-License-Identifier: Apache-2.0
// Checks a state script (language.md 8) and builds a Script: options, sections of existing states, conditionals with their
// items.
#include "compiler/sema/sema.h"

#include <string.h>

#include "stdlib/convert.h"
#include "stdlib/math.h"

typedef struct ScriptCheck {
    Sema s;
    Script *script;
    Str delta_t, init_state;      // the names of the options
    bool has_delta_t, has_stop;
    Map section;                  // state name to the Span of its section
} ScriptCheck;

// ---- options ----

// Accepts one whole number without a sign, 1 … 2^63.  Returns 0 for anything else.
static uint64_t delta_t_value(const AstOption *o)
{
    const SmF64 highest = sm_from_u64(0x8000000000000000u);
    SmF64 x;

    if (!o->number || o->number->kind != AST_NUMBER)
        return 0;
    x = o->number->number;
    if (!sm_eq(sm_trunc(x), x) || sm_lt(x, sm_from_i32(1)) || sm_lt(highest, x))
        return 0;
    return sm_to_u64(x);
}

static void check_delta_t(ScriptCheck *k, const AstOption *o)
{
    k->has_delta_t = true;
    k->script->delta_t_span = o->value_span;
    k->script->delta_t = delta_t_value(o);
    if (k->script->delta_t == 0 && o->number && o->number->kind == AST_NUMBER)        // otherwise the parser has reported it
        diag_report(k->s.diags, DIAG_delta_t_value, o->value_span);
}

static void check_init_state(ScriptCheck *k, const AstOption *o)
{
    State *state = o->word ? scope_find_state(&k->s, o->word, o->value_span) : NULL;

    if (state)
        k->script->init_state = state;
}

static void check_option(ScriptCheck *k, const AstOption *o)
{
    if (o->name == k->delta_t)
        check_delta_t(k, o);
    else if (o->name == k->init_state)
        check_init_state(k, o);
}

// ---- conditionals ----

static void check_assert(ScriptCheck *k, ScriptItem *item, const AstStmt *in)
{
    Expr *e = check_expr(&k->s, in->value);

    if (e)
        vec_push(k->s.arena, &item->asserts, e);
}

static void check_input(ScriptCheck *k, ScriptItem *item, const AstStmt *in)
{
    Stmt *stmt = check_assignment(&k->s, in);

    if (stmt)
        vec_push(k->s.arena, &item->inputs, stmt);
}

static void check_item(ScriptCheck *k, ScriptItem *item, const AstStmt *in)
{
    switch (in->kind) {
    case AST_ASSIGN: check_input(k, item, in); break;
    case AST_ASSERT: check_assert(k, item, in); break;
    case AST_STOP:
        item->stop = k->has_stop = true;
        item->stop_span = in->span;
        break;
    case AST_TRANSITION: case AST_IF: case AST_STMT_ERROR: case AST_ALLOWED: break;     // the parser has reported them
    }
}

static void check_items(ScriptCheck *k, ScriptItem *item, const AstStmts *in)
{
    for (size_t i = 0; i < in->n; i++)
        check_item(k, item, in->at[i]);
}

static void check_conditional(ScriptCheck *k, ScriptSection *section, const AstStmt *in)
{
    ScriptItem item;

    memset(&item, 0, sizeof item);
    item.span = in->span;
    item.guard = check_expr(&k->s, in->value);
    check_items(k, &item, &in->arms->then);
    vec_push(k->s.arena, &section->item, item);
}

// ---- sections ----

static void check_section_twice(ScriptCheck *k, const AstSection *in)
{
    Span *first = map_find(&k->section, in->name);

    if (first) {
        Diag *d = diag_report(k->s.diags, DIAG_script_section_twice, in->name_span, in->name->text);
        diag_note(k->s.diags, d, *first, DIAG_note_first_here);
        return;
    }
    first = ARENA_NEW(k->s.arena, Span);
    *first = in->name_span;
    map_put(&k->section, in->name, first);
}

static bool means_all_states(const char *name)
{
    return strcmp(name, "all") == 0 || strcmp(name, "any") == 0 || strcmp(name, "every") == 0 || strcmp(name, "always") == 0;
}

// Reports [All_States] or [option]: not a state, but similar to a section that every script can have.  Returns whether it reported one.
static bool report_misspelt_section(ScriptCheck *k, const AstSection *in)
{
    Guess g = guess_init(in->name);
    Diag *d;

    if (map_find(&k->s.p->state_by_name, in->name))
        return false;
    guess_consider(&g, str_c(k->s.strings, "all_states"));
    guess_consider(&g, str_c(k->s.strings, "options"));
    if (means_all_states(in->name->text))
        g.best = str_c(k->s.strings, "all_states");
    if (!g.best)
        return false;
    d = diag_report(k->s.diags, DIAG_unknown_state, in->name_span, in->name->text);
    diag_label(k->s.diags, d, DIAG_label_did_you_mean, format_in(k->s.arena, "[%s]", g.best->text));
    return true;
}

static void check_section(ScriptCheck *k, const AstSection *in)
{
    ScriptSection section;

    memset(&section, 0, sizeof section);
    if (!in->all_states && in->name->len > 0 && !report_misspelt_section(k, in)) {
        section.state = scope_find_state(&k->s, in->name, in->name_span);
        check_section_twice(k, in);
    }
    for (size_t i = 0; i < in->items.n; i++)
        if (in->items.at[i]->kind == AST_IF)
            check_conditional(k, &section, in->items.at[i]);
    vec_push(k->s.arena, &k->script->section, section);
}

static void check_any_section(ScriptCheck *k, const AstSection *in)
{
    if (in->kind == AST_SCRIPT_STATE)
        check_section(k, in);
    else if (in->kind == AST_OPTIONS)
        for (size_t i = 0; i < in->options.n; i++)
            check_option(k, &in->options.at[i]);
}

// ---- times that the script compares with ----

static bool is_reached_time(const ScriptCheck *k, SmF64 x)
{
    const SmF64 limit = sm_from_u64(0x20000000000000u);          // 2^53: above it some whole numbers are not an F64

    if (sm_lt(x, sm_from_i32(0)) || !sm_eq(sm_trunc(x), x))
        return false;
    return !sm_lt(x, limit) || sm_to_u64(x) % k->script->delta_t == 0;
}

static const char *source_text(const ScriptCheck *k, Span span)
{
    return format_in(k->s.arena, "%.*s", (int)span.len, span.src->text + span.at);
}

// Warns of a comparison such as G == 15 where G is 0, 10, 20.  Recursion depth equals the nesting of expressions, which AST_DEPTH_MAX
// bounds.
static void warn_of_missed_times(ScriptCheck *k, const Expr *e)
{
    const bool logic = e->kind == EX_BINARY && (e->op == SM_OP_AND || e->op == SM_OP_OR);

    for (uint32_t i = 0; logic && i < 2; i++)
        warn_of_missed_times(k, e->arg[i]);
    for (uint32_t i = 0; e->kind == EX_BINARY && e->op == SM_OP_EQ && i < 2; i++) {
        const Expr *time = e->arg[i], *at = e->arg[1 - i];
        if (time->kind == EX_VAR && (time->var == k->s.p->g || time->var == k->s.p->t) && expr_is_constant(at) &&
            !is_reached_time(k, expr_constant_value(at)))
            diag_report(k->s.diags, DIAG_moment_missed, e->span, time->var == k->s.p->g ? "G" : "T",
                        const_text(k->s.arena, expr_constant_value(at)), source_text(k, k->script->delta_t_span));
    }
}

// If the body has only asserts, the unchecked asserts are reported after the run instead.
static void check_guard_times(ScriptCheck *k)
{
    for (size_t i = 0; k->script->delta_t > 0 && i < k->script->section.n; i++)
        for (size_t n = 0; n < k->script->section.at[i].item.n; n++) {
            const ScriptItem *item = &k->script->section.at[i].item.at[n];
            if (item->guard && item->asserts.n == 0)
                warn_of_missed_times(k, item->guard);
        }
}

// ---- entry points ----

static void init_check(ScriptCheck *k, CheckContext *c, const AstFile *ss, const Program *program)
{
    memset(k, 0, sizeof *k);
    k->script = ARENA_NEW(c->arena, Script);
    k->script->src = ss->src;
    k->script->program = program;
    k->script->init_state = program->state.at[0];
    sema_init(&k->s, c, find_hidden_names(c, ss), program, &k->script->window);
    k->s.in_script = true;
    k->delta_t = str_c(c->strings, "delta_t");
    k->init_state = str_c(c->strings, "init_state");
    k->section.arena = c->arena;
}

Script *check_script(CheckContext *c, const AstFile *ss, const Program *program)
{
    size_t errors = c->diags->met;
    Span start = {ss->src, 0, 0};
    ScriptCheck k;

    init_check(&k, c, ss, program);
    for (size_t i = 0; i < ss->sections.n; i++)
        check_any_section(&k, ss->sections.at[i]);
    if (!k.has_delta_t && !k.s.lost->any)
        diag_report(c->diags, DIAG_no_delta_t, start);
    if (!k.has_stop && !k.s.lost->any)
        diag_report(c->diags, DIAG_no_stop, start);
    if (k.s.unknown && !k.s.knows_a_name && k.s.unknown_name.n + k.s.unknown_state.n > 1)
        diag_note(c->diags, k.s.unknown, (Span){0}, DIAG_note_other_machine, program->src->name);
    if (c->diags->met == errors && !k.s.lost->any)
        check_guard_times(&k);
    return c->diags->met > errors ? NULL : k.script;
}

static void add_written(const AstStmts *stmts, Map *names)
{
    for (size_t i = 0; i < stmts->n; i++)
        if (stmts->at[i]->kind == AST_ASSIGN)
            map_put(names, stmts->at[i]->name, (void *)stmts->at[i]->name);
}

uint64_t script_delta_t(const AstFile *ss)
{
    uint64_t found = 0;

    for (size_t i = 0; i < ss->sections.n; i++)
        for (size_t o = 0; ss->sections.at[i]->kind == AST_OPTIONS && o < ss->sections.at[i]->options.n; o++)
            if (strcmp(ss->sections.at[i]->options.at[o].name->text, "delta_t") == 0)
                found = delta_t_value(&ss->sections.at[i]->options.at[o]);
    return found;
}

void script_add_written_names(const AstFile *ss, Map *names)
{
    for (size_t i = 0; i < ss->sections.n; i++) {
        const AstStmts *items = &ss->sections.at[i]->items;
        for (size_t j = 0; j < items->n; j++)
            if (items->at[j]->kind == AST_IF)
                add_written(&items->at[j]->arms->then, names);
    }
}
