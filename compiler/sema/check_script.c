// SPDX-License-Identifier: Apache-2.0
// Checks a state script (language.md 8) and builds a Script: options, sections of existing states, conditionals with their
// items.
#include "compiler/sema/application.h"
#include "compiler/sema/sema.h"

#include <string.h>

#include "compiler/syntax/parse.h"
#include "stdlib/convert.h"
#include "stdlib/math.h"

typedef struct ScriptCheck {
    Sema s;
    Script *script;
    Str delta_t, init_state, seed, set;   // the names of the options as interned strings
    bool has_delta_t, has_stop;
    uint32_t items, asserts;      // number of items, and of asserts, that have been checked so far
    bool proposes_guards;         // as CheckContext.proposes_guards
    size_t errors;                // Diags.errors_seen when this check began
    Map section;                  // state name to the Span of its section in the current file
} ScriptCheck;

// ---- options ----

// Reports a delta_t that differs from the step that the machine declares.
static void check_declared_step(ScriptCheck *k, const AstOption *o)
{
    const Program *p = k->s.p;
    Diag *d;

    if (p->step == 0 || k->script->delta_t == 0 || k->script->delta_t == p->step)
        return;
    d = diag_report(k->s.diags, DIAG_delta_t_differs, o->value_span, format_in(k->s.arena, "%llu", (unsigned long long)k->script->delta_t),
                    format_in(k->s.arena, "%llu", (unsigned long long)p->step));
    diag_note(k->s.diags, d, p->step_span, DIAG_note_declared_here, "step");
}

// Whether G is 0 in the first step. In an application, [start] can set another value.
static bool starts_at_zero(const Program *p)
{
    const Joint *j = p->joint;

    for (size_t i = 0; j && i < j->start.n; i++)
        if (j->start.at[i].var == p->g && j->start.at[i].cell != 0)
            return false;
    return true;
}

// Checks `delta_t file` in the script of an application.
static void check_app_rows(ScriptCheck *k, const AstOption *o)
{
    const Joint *j = k->s.p->joint;
    const char *why = NULL;

    for (size_t i = 0; i < j->member.n && !why; i++)
        if (j->member.at[i].program->step > 0)
            why = format_in(k->s.arena, "the machine '%s' declares a step", j->member.at[i].name->text);
    if (!starts_at_zero(k->s.p))
        why = "the first row is at the time 0, and [start] sets another one";
    if (why)
        diag_report(k->s.diags, DIAG_delta_t_file, o->value_span, why);
    k->script->by_rows = true;
    k->script->delta_t = k->s.step = 0;
    k->script->delta_t_span = o->value_span;
}

// Checks an option in the script of an application, whose ticks follow from the periods of the .app.
static void check_app_option(ScriptCheck *k, const AstOption *o)
{
    const Joint *j = k->s.p->joint;
    const char *text = format_in(k->s.arena, "%.*s", (int)o->value_span.len, o->value_span.src ? o->value_span.src->text + o->value_span.at : "");

    if (o->name == k->init_state && o->word)
        diag_report(k->s.diags, DIAG_app_init_state, o->name_span);
    if (o->name == k->delta_t && o->word)
        check_app_rows(k, o);
    if (o->name != k->delta_t || !o->number)
        return;
    if (o->number->unit != TIME_NONE && k->s.p->time_unit == TIME_NONE)
        diag_report(k->s.diags, DIAG_app_time_literal, o->value_span, text, app_time_text(k->s.arena, j->unit));
    else if (k->s.p->step == 0 || option_step(o, k->s.p->time_unit) != k->s.p->step)
        diag_report(k->s.diags, DIAG_app_delta_t, o->value_span, text, app_time_text(k->s.arena, j->tick));
    else
        k->script->delta_t_span = o->value_span;
}

static void check_seed(ScriptCheck *k, const AstOption *o)
{
    const AstExpr *n = o->number;

    if (n->unit == TIME_NONE && is_reached_time(n->number, 1) && sm_le(n->number, sm_from_u64(SCRIPT_SEED_MAX)))
        k->script->seed = sm_to_u64(n->number);
    else
        diag_report(k->s.diags, DIAG_seed_value, o->value_span);
}

// Returns the setting of a variable in the script; NULL: none.
static ScriptSetting *find_setting(const Script *s, const Var *v)
{
    for (size_t i = 0; i < s->setting.n; i++)
        if (s->setting.at[i].parameter == v)
            return &s->setting.at[i];
    return NULL;
}

// Checks `set NAME VALUE`.
static void check_setting(ScriptCheck *k, const AstOption *o)
{
    ScriptSetting setting = {program_parameter(k->s.p, o->word), 0, o->word_span};
    const ScriptSetting *earlier;

    if (!o->number)
        return;
    k->s.knows_a_name |= setting.parameter != NULL;
    if (!check_parameter_value(&k->s, k->s.p, o->word, o->word_span, o->number, &setting.cell))
        return;
    earlier = find_setting(k->script, setting.parameter);
    if (earlier)
        diag_note(k->s.diags, diag_report(k->s.diags, DIAG_parameter_set_twice, o->word_span, o->word->text), earlier->span, DIAG_note_first_here);
    else
        vec_push(k->s.arena, &k->script->setting, setting);
}

static void check_option(ScriptCheck *k, const AstOption *o)
{
    if (o->name == k->seed) {
        check_seed(k, o);
    } else if (o->name == k->set) {
        check_setting(k, o);
    } else if (k->s.p->joint) {
        check_app_option(k, o);
    } else if (o->name == k->delta_t) {
        k->has_delta_t = true;
        k->script->delta_t_span = o->value_span;
        k->script->by_rows = o->word != NULL;
        k->script->delta_t = option_step(o, k->s.p->time_unit);
        if (o->word && k->s.p->step > 0)
            diag_note(k->s.diags, diag_report(k->s.diags, DIAG_delta_t_file, o->value_span, "the machine declares a step"), k->s.p->step_span,
                      DIAG_note_declared_here, "step");
        if (k->script->delta_t == 0 && o->number)                                     // without a number the parser has reported the option
            diag_report(k->s.diags, DIAG_step_value, o->value_span, "delta_t");
        check_declared_step(k, o);
        k->s.step = k->script->delta_t;
    } else if (o->name == k->init_state) {
        State *state = o->word ? scope_find_state(&k->s, k->s.p, o->word, o->value_span) : NULL;
        if (state)
            k->script->init_state = state;
    }
}

// ---- conditionals ----

static bool is_assert(const AstStmt *s)
{
    return s->kind == AST_ASSERT || s->kind == AST_FAIL || s->kind == AST_EXPECT || s->kind == AST_PRINT;
}

// Returns the time after `within`, in units of G; 0 after a report.
static uint64_t check_within(ScriptCheck *k, const AstExpr *in)
{
    Expr *e = check_expr(&k->s, in);
    SmF64 x = sm_from_i32(0);

    if (!e)
        return 0;
    if (expr_is_constant(e))
        x = expr_constant_value(e);
    if (!expr_is_constant(e) || !sm_le(sm_from_i32(0), x))
        diag_report(k->s.diags, DIAG_within_value, in->span);
    return sm_to_u64(x);
}

// Checks the text, the time and the values that can follow an item's condition (AstRemark).  Returns NULL if the condition is alone.
static const ScriptRemark *check_remark(ScriptCheck *k, const AstStmt *in)
{
    const AstRemark *from = in->remark;
    ScriptRemark *r;

    if (!from)
        return NULL;
    r = ARENA_NEW(k->s.arena, ScriptRemark);
    r->span = in->span;
    r->text = from->text;
    r->requirement = from->requirement;
    if (from->within)
        r->within = check_within(k, from->within);
    for (size_t i = 0; i < from->values.n; i++)
        vec_push(k->s.arena, &r->printed, check_expr(&k->s, from->values.at[i]));
    return r;
}

// Whether e compares S with the number of a state and is true in the state `in`.  S does not change during a step, even if the step makes a
// transition.
static bool is_true_in_state(const ScriptCheck *k, const Expr *e, const State *in)
{
    const Joint *j = k->s.p->joint;
    const Member *m = j ? &j->member.at[joint_machine_of(j, in->number)] : NULL;
    const Var *s = m ? m->s : k->s.p->s;
    const SmF64 number = sm_from_u32(in->number - (m ? m->first : 0));
    const bool compares = e->kind == EX_BINARY && (e->op == SM_OP_EQ || e->op == SM_OP_NE);
    const int var = compares && e->arg[1]->kind == EX_VAR;

    return compares && e->arg[var]->kind == EX_VAR && e->arg[var]->var == s && expr_is_constant(e->arg[1 - var]) &&
           (e->op == SM_OP_EQ) == sm_eq(expr_constant_value(e->arg[1 - var]), number);
}

// Warns of conditions of an assert such as S == A in [A]: they are judged only where they are true. Recursion depth equals the nesting of
// expressions, which AST_DEPTH_MAX bounds.
static void warn_of_decided_conditions(ScriptCheck *k, const Expr *e, const State *in)
{
    const bool is_and = e->kind == EX_BINARY && e->op == SM_OP_AND;

    for (uint32_t i = 0; is_and && i < 2; i++)
        warn_of_decided_conditions(k, e->arg[i], in);
    if (is_true_in_state(k, e, in))
        diag_label(k->s.diags, diag_report(k->s.diags, DIAG_assert_decided, e->span), DIAG_label_judged_in_state, in->name->text);
}

static void add_assert(ScriptCheck *k, ScriptItem *item, const AstStmt *in)
{
    static const ScriptAssertKind kind[] = {
        [AST_ASSERT] = SCRIPT_ASSERT, [AST_FAIL] = SCRIPT_FAIL, [AST_EXPECT] = SCRIPT_EXPECT, [AST_PRINT] = SCRIPT_PRINT};
    ScriptAssert a = {kind[in->kind], in->value ? check_expr(&k->s, in->value) : NULL, NULL};
    const State *in_state = k->script->section.at[k->script->section.n - 1].state;

    a.remark = check_remark(k, in);
    if (a.kind == SCRIPT_ASSERT && a.condition && in_state)
        warn_of_decided_conditions(k, a.condition, in_state);
    if (a.condition || !in->value)
        vec_push(k->s.arena, &item->asserts, a);
}

// Adds an item without its guard to the section.
static ScriptItem *add_item(ScriptCheck *k, const ScriptItem *parent, bool otherwise)
{
    ScriptSection *section = &k->script->section.at[k->script->section.n - 1];
    ScriptItem *item = ARENA_NEW(k->s.arena, ScriptItem);

    item->parent = parent;
    item->otherwise = otherwise;
    item->number = k->items++;
    item->first_assert = k->asserts;
    item->machine = section->machine & 0xffffff;
    vec_push(k->s.arena, &section->item, item);
    return item;
}

// Adds an item whose guard is true whenever it is reached.
static ScriptItem *add_unconditional_item(ScriptCheck *k, Span span, const ScriptItem *parent, bool otherwise)
{
    ScriptItem *item = add_item(k, parent, otherwise);

    item->guard = expr_new(&k->s, EX_NUMBER, span, 0);
    item->guard->number = sm_from_i32(1);
    return item;
}

// Checks the statements of an item: those of the body with the indices from `from` on, up to a conditional. Returns the index after the last of
// them. The lists have exactly the capacity that they need, because a script can have a million items.
static size_t check_statements(ScriptCheck *k, ScriptItem *item, const AstStmts *body, size_t from)
{
    size_t i, end;

    for (end = from; end < body->n && body->at[end]->kind != AST_IF; end++) {
        item->inputs.cap += body->at[end]->kind == AST_ASSIGN;
        item->asserts.cap += is_assert(body->at[end]);
    }
    item->inputs.at = ARENA_ARRAY(k->s.arena, ScriptInput, item->inputs.cap);
    item->asserts.at = ARENA_ARRAY(k->s.arena, ScriptAssert, item->asserts.cap);
    for (i = from; i < end; i++) {
        const AstStmt *stmt = body->at[i];
        Stmt input = {.kind = ST_ASSIGN};

        switch (stmt->kind) {
        case AST_ASSIGN:
            if (check_assignment(&k->s, stmt, &input))
                vec_push(k->s.arena, &item->inputs, ((ScriptInput){input.var, input.value, stmt->span.at, stmt->span.len}));
            break;
        case AST_ASSERT: case AST_FAIL: case AST_EXPECT: case AST_PRINT:
            add_assert(k, item, stmt);
            break;
        case AST_STOP:
            item->stop = k->has_stop = true;
            item->stop_at = stmt->span.at;
            break;
        case AST_TRANSITION: case AST_IF: case AST_STMT_ERROR: case AST_ALLOWED: break;     // the parser has reported them
        }
    }
    k->asserts += item->asserts.n;
    return end;
}

static void check_conditional(ScriptCheck *k, const AstStmt *in, const ScriptItem *parent, bool otherwise);

// Checks a body whose first statements belong to `first`. Recursion depth equals the nesting of conditionals, which AST_DEPTH_MAX bounds.
static void check_body(ScriptCheck *k, ScriptItem *first, const AstStmts *body)
{
    size_t i = check_statements(k, first, body, 0);

    while (i < body->n) {
        if (body->at[i]->kind == AST_IF)
            check_conditional(k, body->at[i++], first, false);
        else
            i = check_statements(k, add_unconditional_item(k, body->at[i]->span, first, false), body, i);
    }
}

static void check_otherwise(ScriptCheck *k, const AstStmt *in, const ScriptItem *item)
{
    const AstStmts *body = &in->arms->otherwise;

    if (body->n == 1 && body->at[0]->kind == AST_IF)
        check_conditional(k, body->at[0], item, true);
    else
        check_body(k, add_unconditional_item(k, in->arms->else_span, item, true), body);
}

static void check_conditional(ScriptCheck *k, const AstStmt *in, const ScriptItem *parent, bool otherwise)
{
    ScriptItem *item = add_item(k, parent, otherwise);

    k->s.searched_left = NULL;                // it may point into the freed tree of an earlier item, at an address that is used again
    warn_of_time_as_guard(&k->s, in->value);
    item->guard = check_guard(&k->s, in->value);
    item->by_time = in->value->kind == AST_WHEN;
    if (k->proposes_guards && !item->by_time)
        propose_when(&k->s, in->value, k->script->delta_t);
    check_body(k, item, &in->arms->then);
    if (in->arms->has_else)
        check_otherwise(k, in, item);
}

// ---- sections ----

// Reports a section such as [All_States] or [option]: it is not a state, but similar to a section that every script can have.  Returns
// false if the name is a state or is not similar.
static bool report_misspelt_section(ScriptCheck *k, const AstSection *in)
{
    static const char *const for_all[] = {"all", "any", "every", "always"};
    Guess g = guess_init(in->name);
    Diag *d;

    if (map_find(&k->s.p->state_by_name, in->name))
        return false;
    guess_consider(&g, str_c(k->s.strings, "all_states"));
    guess_consider(&g, str_c(k->s.strings, "options"));
    for (size_t i = 0; i < sizeof for_all / sizeof *for_all; i++)
        if (strcmp(in->name->text, for_all[i]) == 0)
            g.best = str_c(k->s.strings, "all_states");
    if (!g.best)
        return false;
    d = diag_report(k->s.diags, DIAG_unknown_state, in->name_span, in->name->text);
    diag_label(k->s.diags, d, DIAG_label_did_you_mean, format_in(k->s.arena, "[%s]", g.best->text));
    return true;
}

static void open_section(ScriptCheck *k, const AstSection *in)
{
    ScriptSection section;

    memset(&section, 0, sizeof section);
    if (!in->all_states && in->name->len > 0 && !report_misspelt_section(k, in)) {
        const Span *first = map_find(&k->section, in->name);
        section.state = scope_find_state(&k->s, k->s.p, in->name, in->name_span);
        if (first)
            diag_note(k->s.diags, diag_report(k->s.diags, DIAG_script_section_twice, in->name_span, in->name->text), *first,
                      DIAG_note_first_here);
        else
            map_put(&k->section, in->name, arena_copy(k->s.arena, &in->name_span, sizeof in->name_span));
    }
    if (section.state && k->s.p->joint)
        section.machine = 1 + joint_machine_of(k->s.p->joint, section.state->number);
    vec_push(k->s.arena, &k->script->section, section);
}

// Called for each section when its header and options are parsed, before its items.
static void check_section(void *context, const AstSection *in)
{
    ScriptCheck *k = context;

    if (in->kind == AST_SCRIPT_STATE)
        open_section(k, in);
    if (in->kind == AST_DEFINE && map_find(&k->s.p->state_by_name, in->name))
        diag_report(k->s.diags, DIAG_script_unguarded, in->definitions.n ? in->definitions.at[0].name_span : in->header);
    else if (in->kind == AST_DEFINE)
        declare_definitions(&k->s, in, &k->script->define);
    if (in->kind == AST_DATA)
        check_data(&k->s, k->script, in);
    for (size_t o = 0; in->kind == AST_OPTIONS && o < in->options.n; o++)
        check_option(k, &in->options.at[o]);
}

// Called for each item of the current section.
static void check_item(void *context, const AstStmt *in)
{
    ScriptCheck *k = context;

    if (in->kind == AST_IF)
        check_conditional(k, in, NULL, false);
}

// ---- times that the script compares with ----

// Warns of e, which compares G or T with `at`, if no step has that time.
static void warn_of_missed_time(ScriptCheck *k, const Expr *e, const Var *time, SmF64 at)
{
    const Span delta_t = k->script->delta_t_span;

    if (!is_reached_time(at, k->script->delta_t))
        diag_report(k->s.diags, DIAG_moment_missed, e->span, time == k->s.p->g ? "G" : "T", const_text(k->s.arena, at),
                    format_in(k->s.arena, "%.*s", (int)delta_t.len, delta_t.src->text + delta_t.at));
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
        if (time->kind == EX_VAR && (time->var == k->s.p->g || time->var == k->s.p->t) && expr_is_constant(at))
            warn_of_missed_time(k, e, time->var, expr_constant_value(at));
    }
    if (e->kind == EX_AT)
        warn_of_missed_time(k, e, e->var, e->number);
}

// Whether G is certain to be a multiple of delta_t in every step.
static bool has_regular_times(const ScriptCheck *k) { return k->script->delta_t > 0 && starts_at_zero(k->s.p); }

// Reports guards by time that no step has, and warns of missed times in other guards, those of conditionals without asserts.  If a guard with asserts
// is never true, the run itself reports its asserts as unevaluated.
static void check_guard_times(ScriptCheck *k)
{
    for (size_t i = 0; has_regular_times(k) && i < k->script->section.n; i++)
        for (size_t n = 0; n < k->script->section.at[i].item.n; n++) {
            const ScriptItem *item = k->script->section.at[i].item.at[n];
            if (item->by_time)
                check_when_times(&k->s, item->guard, k->script->delta_t);
            else if (item->asserts.n == 0)
                warn_of_missed_times(k, item->guard);
        }
}

// ---- entry points ----

static void begin_check(ScriptCheck *k, CheckContext *c, const AstFile *const *file, size_t n, const Program *program)
{
    const AstFile *ss = file[n - 1];
    HiddenNames *hidden = find_hidden_names(c, ss);

    for (size_t i = 0; i + 1 < n; i++)
        add_hidden_names(c, file[i], hidden);
    memset(k, 0, sizeof *k);
    k->errors = c->diags->errors_seen;
    k->script = ARENA_NEW(c->arena, Script);
    k->script->src = ss->src;
    k->script->program = program;
    k->script->init_state = program->state.at[0];
    k->script->delta_t = program->step;
    k->script->delta_t_span = program->step_span;
    k->has_delta_t = program->step > 0 || program->joint;
    sema_init(&k->s, c, hidden, program, &k->script->window);
    k->s.in_script = true;
    k->s.random = &k->script->random;
    k->proposes_guards = c->proposes_guards;
    k->s.step = program->step;
    add_definitions_of_machine(&k->s);
    k->delta_t = str_c(c->strings, "delta_t");
    k->seed = str_c(c->strings, "seed");
    k->init_state = str_c(c->strings, "init_state");
    k->set = str_c(c->strings, "set");
    check_script_locals(&k->s, k->script, file, n);
}

// Reports what the script as a whole lacks.  Returns the script, or NULL if there were errors.
static Script *end_check(ScriptCheck *k)
{
    Diags *diags = k->s.diags;
    const Span start = {k->script->src, 0, 0};

    check_unused_definitions(&k->s, &k->script->define);
    report_unused_definitions(diags, &k->script->define);
    k->script->has_units = k->s.has_units;
    if (!k->has_delta_t && !k->s.lost->any)
        diag_report(diags, DIAG_no_delta_t, start);
    if (!k->has_stop && !k->s.lost->any)
        diag_report(diags, DIAG_no_stop, start);
    if (k->script->by_rows && !k->script->data && !k->s.lost->any)
        diag_report(diags, DIAG_delta_t_file, k->script->delta_t_span, "the script has no [data]");
    if (k->s.unknown && !k->s.knows_a_name && k->s.unknown_name.n + k->s.unknown_state.n > 1)
        diag_note(diags, k->s.unknown, (Span){0}, DIAG_note_other_machine, k->script->program->src->name);
    if (diags->errors_seen == k->errors && !k->s.lost->any)
        check_guard_times(k);
    return diags->errors_seen > k->errors ? NULL : k->script;
}

static void begin_file(ScriptCheck *k, const AstFile *ss)
{
    k->section = (Map){k->s.arena, NULL, NULL, 0, 0};
    number_random_definitions(&k->s, ss);
}

Script *check_script(CheckContext *c, const AstFile *const *file, size_t n, const Program *program)
{
    ScriptCheck k;

    begin_check(&k, c, file, n, program);
    for (size_t i = 0; i < n; i++) {
        begin_file(&k, file[i]);
        for (size_t s = 0; s < file[i]->sections.n; s++) {
            const AstSection *section = file[i]->sections.at[s];
            check_section(&k, section);
            for (size_t m = 0; m < section->items.n; m++)
                check_item(&k, section->items.at[m]);
        }
    }
    return end_check(&k);
}

// Checks a script without syntax errors.  Only some of its items are in memory at a time.
Script *check_script_source(CheckContext *c, Arena *tree, Arena *items, const AstFile *const *outline, size_t n, const Program *program)
{
    ScriptCheck k;
    const ScriptVisitor v = {check_section, check_item, &k, items};

    begin_check(&k, c, outline, n, program);
    k.s.scratch = items;
    for (size_t i = 0; i < n; i++) {
        begin_file(&k, outline[i]);
        parse_script(tree, c->strings, c->diags, outline[i]->src, &v);
    }
    return end_check(&k);
}

void script_add_names_of_section(const AstSection *section, Map *names)
{
    for (size_t i = 0; section->data && i < section->data->line.n; i++)
        if (!section->data->line.at[i].is_compare)
            map_put(names, section->data->line.at[i].element, (void *)section->data->line.at[i].element);
}

void script_add_names_of_item(const AstStmt *item, Map *names)
{
    if (item->kind == AST_ASSIGN)
        map_put(names, item->name, (void *)item->name);
    if (item->kind != AST_IF)
        return;
    for (size_t n = 0; n < item->arms->then.n; n++)
        script_add_names_of_item(item->arms->then.at[n], names);
    for (size_t n = 0; n < item->arms->otherwise.n; n++)
        script_add_names_of_item(item->arms->otherwise.at[n], names);
}

// Adds the names that the script assigns to `names`; each is key and value. `names` is then the parameter written_outside of check_machine.
void script_add_written_names(const AstFile *ss, Map *names)
{
    for (size_t i = 0; i < ss->sections.n; i++) {
        script_add_names_of_section(ss->sections.at[i], names);
        for (size_t j = 0; j < ss->sections.at[i]->items.n; j++)
            script_add_names_of_item(ss->sections.at[i]->items.at[j], names);
    }
}
