// SPDX-License-Identifier: Apache-2.0
// Checks requirements (docs/requirements.md): binds the names in them to variables and states of a machine, and compares their ids with the marks
// @req.
#include "compiler/sema/sema.h"

#include "compiler/syntax/ast_rq.h"
#include "stdlib/convert.h"
#include "stdlib/math.h"

// ---- conditions ----

// Builds the condition that a step has run the state. S and the number have no position, because the source does not contain them.
// *machine: as in Requirement.
static Expr *new_state_operand(Sema *s, const State *state, Span span, uint32_t *machine)
{
    const Joint *j = s->p->joint;
    const Member *m = j ? &j->member.at[joint_machine_of(j, state->number)] : NULL;
    Expr *e = expr_new(s, EX_BINARY, span, 2);

    *machine = m ? 1 + (uint32_t)(m - j->member.at) : 0;
    e->op = SM_OP_EQ;
    e->arg[0] = expr_new(s, EX_VAR, (Span){0}, 0);
    e->arg[0]->var = m ? m->s : s->p->s;
    e->arg[1] = expr_new(s, EX_NUMBER, (Span){0}, 0);
    e->arg[1]->number = sm_from_u32(m ? state->number - m->first : state->number);
    s->knows_a_name = true;
    return e;
}

// Reports a name without parentheses that is a variable or a definition, not a state.
static void report_variable_operand(Sema *s, const AstExpr *name)
{
    Diag *d = diag_report(s->diags, DIAG_requirement_variable, name->span, name->name->text);

    diag_label(s->diags, d, DIAG_label_write, format_in(s->arena, "(%s)", name->name->text));
    diag_edit(s->diags, d, (Span){name->span.src, name->span.at, 0}, "(");
    diag_edit(s->diags, d, (Span){name->span.src, name->span.at + name->span.len, 0}, ")");
}

// Checks an operand of before, after or without: the name of a state, true in each step that ran it, or an expression in parentheses
// (requirements.md 13.9). *machine: as in Requirement.
static Expr *check_operand(Sema *s, const AstExpr *in, uint32_t *machine)
{
    const bool is_variable = in->kind == AST_NAME && (scope_find_variable(s, in->name) || map_find(&s->defines, in->name));
    State *state;

    if (in->kind != AST_NAME)
        return in->kind == AST_PAREN ? check_expr(s, in) : NULL;      // the parser has reported anything but parentheses
    state = map_find(&s->p->state_by_name, in->name);
    if (!state && is_variable) {
        report_variable_operand(s, in);
        return NULL;
    }
    if (state && is_variable)
        scope_note_declared(s, diag_report(s->diags, DIAG_requirement_state_or_variable, in->span, in->name->text, in->name->text), in->name);
    if (!state)
        state = scope_find_state(s, s->p, in->name, in->span);
    return state ? new_state_operand(s, state, in->span, machine) : NULL;
}

static const AstExpr *without_parens(const AstExpr *e)
{
    while (e->kind == AST_PAREN)
        e = e->a;
    return e;
}

// Checks `always b` or `always a implies b`.
static bool check_always(Sema *s, const AstExpr *in, Requirement *out)
{
    const AstExpr *e = without_parens(in);

    if (e->kind != AST_IMPLIES)
        return (out->b = check_expr(s, in)) != NULL;
    out->a = check_expr(s, e->a);
    out->b = check_expr(s, e->b);
    return out->a && out->b;
}

// Returns the time after `within`, in units of G; 0 after a report.
static uint64_t check_within(Sema *s, const AstExpr *in)
{
    const Expr *e = check_expr(s, in);
    const bool is_constant = e && expr_is_constant(e);

    if (e && (!is_constant || !sm_le(sm_from_i32(0), expr_constant_value(e))))
        diag_report(s->diags, DIAG_within_value, in->span);
    return is_constant ? sm_to_u64(expr_constant_value(e)) : 0;
}

static bool check_conditions(Sema *s, const AstRequirement *in, Requirement *out)
{
    switch (in->kind) {
    case AST_NEVER:  return (out->a = check_expr(s, in->a)) != NULL;
    case AST_ALWAYS: return check_always(s, in->a, out);
    case AST_LEADS_TO:
        out->a = check_expr(s, in->a);
        out->b = check_expr(s, in->b);
        out->within = check_within(s, in->within);
        return out->a && out->b;
    case AST_NEVER_BEFORE: case AST_NEVER_AFTER:
        out->a = check_operand(s, in->a, &out->machine[0]);
        out->b = check_operand(s, in->b, &out->machine[1]);
        out->c = in->c ? check_operand(s, in->c, &out->machine[2]) : NULL;
        return out->a && out->b && (out->c || !in->c);
    }
    return false;
}

// ---- requirements that cannot fail, or cannot be met ----

static bool is_constant_true(const Expr *e) { return expr_is_constant(e) && sm_to_bool(expr_constant_value(e)); }
static bool is_constant_false(const Expr *e) { return expr_is_constant(e) && !sm_to_bool(expr_constant_value(e)); }

// Returns what a constant or repeated condition decides, as a predicate of the requirement; NULL: nothing.
static const char *find_verdict(const Requirement *r)
{
    switch (r->kind) {
    case REQUIREMENT_NEVER:
        return is_constant_true(r->a) ? "violated in every step" : is_constant_false(r->a) ? "never violated" : NULL;
    case REQUIREMENT_ALWAYS:
        if ((r->a && is_constant_false(r->a)) || is_constant_true(r->b) || (r->a && expr_equal(r->a, r->b, NULL)))
            return "never violated";
        return is_constant_false(r->b) ? r->a ? "violated whenever its premise is true" : "violated in every step" : NULL;
    case REQUIREMENT_BEFORE:
        return expr_equal(r->a, r->b, NULL) ? "violated whenever its first condition is true" : is_constant_false(r->a) ? "never violated" : NULL;
    case REQUIREMENT_AFTER:
        return is_constant_false(r->a) || is_constant_false(r->b) ? "never violated" : NULL;
    case REQUIREMENT_LEADS_TO:
        return is_constant_false(r->a) || is_constant_true(r->b) || expr_equal(r->a, r->b, NULL) ? "never violated" : NULL;
    }
    return NULL;
}

static void warn_of_verdict(Sema *s, const Requirement *r)
{
    const char *verdict = find_verdict(r);

    if (verdict)
        diag_report(s->diags, DIAG_requirement_decided, r->span, r->id->text, verdict);
}

// ---- the files ----

// Checks a requirement; a second one with the same id is reported, and checked too.
static void check_requirement(Sema *s, Requirements *out, const AstRequirement *in)
{
    static const RequirementKind kinds[] = {[AST_NEVER] = REQUIREMENT_NEVER,
                                            [AST_ALWAYS] = REQUIREMENT_ALWAYS,
                                            [AST_NEVER_BEFORE] = REQUIREMENT_BEFORE,
                                            [AST_NEVER_AFTER] = REQUIREMENT_AFTER,
                                            [AST_LEADS_TO] = REQUIREMENT_LEADS_TO};
    Requirement r = {.kind = kinds[in->kind], .id = in->id, .text = in->text, .span = in->id_span};
    const Span *first = map_find(&out->by_id, in->id);

    s->searched_left = NULL;
    if (first)
        diag_note(s->diags, diag_report(s->diags, DIAG_requirement_twice, in->id_span, in->id->text), *first, DIAG_note_first_here);
    else
        map_put(&out->by_id, in->id, arena_copy(s->arena, &in->id_span, sizeof in->id_span));
    if (!check_conditions(s, in, &r))
        return;
    warn_of_verdict(s, &r);
    vec_push(s->arena, &out->at, r);
}

// Adds a note to the first unknown name if the files use no name of the machine.
static void note_other_machine(Sema *s)
{
    if (s->unknown && !s->knows_a_name && s->unknown_name.n + s->unknown_state.n > 1)
        diag_note(s->diags, s->unknown, (Span){0}, DIAG_note_requirements_of_other_machine, s->p->src->name);
}

// Checks the requirements of n files, which are those of one machine or one application.
Requirements *check_requirements(CheckContext *c, const AstFile *const *file, size_t n, const Program *p)
{
    const size_t errors = c->diags->errors_seen;
    Requirements *out = ARENA_NEW(c->arena, Requirements);
    HiddenNames *hidden = ARENA_NEW(c->arena, HiddenNames);
    Sema s;

    hidden->word.arena = c->arena;
    out->program = p;
    out->by_id.arena = c->arena;
    for (size_t i = 0; i < n; i++)
        add_names_of_sections(c, file[i], hidden);
    sema_init(&s, c, hidden, p, &out->window);
    s.in_script = s.in_requirements = true;
    s.step = p->step;
    add_definitions_of_machine(&s);
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < file[i]->requirements->at.n; k++)
            check_requirement(&s, out, &file[i]->requirements->at.at[k]);
    note_other_machine(&s);
    if (c->has_requirements)
        report_unused_definitions(c->diags, &p->define);
    return c->diags->errors_seen > errors ? NULL : out;
}

// ---- marks ----

static void add_mark(Sema *s, Str requirement, const State *state, const Stmt *stmt, bool is_statement, Span span)
{
    const RequirementMark m = {requirement, state, is_statement, stmt, span};

    vec_push(s->arena, &s->building->mark, m);
}

void add_section_marks(Sema *s, const AstSection *section, const State *state)
{
    for (size_t i = 0; i < section->annotations.n; i++) {
        const AstAnnotation *a = &section->annotations.at[i];
        if (a->kind == AST_REQ)
            add_mark(s, a->name, state, NULL, false, a->name_span);
    }
}

void add_stmt_marks(Sema *s, const AstStmt *in, const Stmt *stmt)
{
    for (size_t i = 0; i < in->marks->at.n; i++)
        add_mark(s, in->marks->at.at[i], s->state, stmt, true, in->marks->span.at[i]);
}

// The marks whose id no requirement has; each id is reported once.
typedef struct UnknownIds { Map reported; VEC(const RequirementMark *) at; } UnknownIds;

static void note_unknown_id(CheckContext *c, const Requirements *r, UnknownIds *unknown, const RequirementMark *m)
{
    if (map_find(&r->by_id, m->requirement) || map_find(&unknown->reported, m->requirement))
        return;
    map_put(&unknown->reported, m->requirement, (void *)m->requirement);
    vec_push(c->arena, &unknown->at, m);
}

// Reports the unknown ids.  A few are probably misspelt.  Many are in a file of requirements that was not given: one warning lists them.
static void report_unknown_ids(CheckContext *c, const Requirements *r, const UnknownIds *unknown)
{
    enum { FEW = 3, LISTED = 8 };
    const size_t n = unknown->at.n;
    Buf others;

    for (size_t i = 0; i < n && n <= FEW; i++) {
        const RequirementMark *m = unknown->at.at[i];
        Guess g = guess_init(m->requirement);
        for (size_t k = 0; k < r->at.n; k++)
            guess_consider(&g, r->at.at[k].id);
        guess_add_label(c->diags, diag_report(c->diags, DIAG_requirement_unknown, m->span, m->requirement->text), &g);
    }
    if (n <= FEW)
        return;
    buf_init(&others, c->arena);
    for (size_t i = 1; i < n && i <= LISTED; i++)
        buf_printf(&others, "%s'%s'", i == 1 ? "" : i + 1 == n ? " and " : ", ", unknown->at.at[i]->requirement->text);
    if (n - 1 > LISTED)
        buf_printf(&others, " and %lu more", (unsigned long)(n - 1 - LISTED));
    diag_note(c->diags, diag_report(c->diags, DIAG_requirement_unknown, unknown->at.at[0]->span, unknown->at.at[0]->requirement->text), (Span){0},
              DIAG_note_requirements_unknown, buf_text(&others));
}

void check_requirement_marks(CheckContext *c, const Requirements *r)
{
    UnknownIds unknown = {{c->arena, NULL, NULL, 0, 0}, {0}};

    for (size_t i = 0; i < r->program->mark.n; i++)
        note_unknown_id(c, r, &unknown, &r->program->mark.at[i]);
    report_unknown_ids(c, r, &unknown);
}

// Reports the ids of a script that no file has.  Those that the machine marks, too, have been reported there.
static void check_marks_of_asserts(CheckContext *c, const Requirements *r, const Script *script)
{
    UnknownIds unknown = {{c->arena, NULL, NULL, 0, 0}, {0}};

    for (size_t i = 0; i < r->program->mark.n; i++)
        map_put(&unknown.reported, r->program->mark.at[i].requirement, (void *)r->program->mark.at[i].requirement);
    for (size_t i = 0; i < script->section.n; i++)
        for (size_t k = 0; k < script->section.at[i].item.n; k++) {
            const ScriptItem *item = script->section.at[i].item.at[k];
            for (size_t n = 0; n < item->asserts.n; n++) {
                const ScriptRemark *remark = item->asserts.at[n].remark;
                if (remark && remark->requirement) {
                    RequirementMark *m = ARENA_NEW(c->arena, RequirementMark);
                    m->requirement = remark->requirement;
                    m->span = remark->span;
                    note_unknown_id(c, r, &unknown, m);
                }
            }
        }
    report_unknown_ids(c, r, &unknown);
}

void check_requirements_of_script(CheckContext *c, const Requirements *r, const Script *script)
{
    for (size_t i = 0; i < r->window.n && script->by_rows && script->program->joint; i++)
        if (r->window.at[i].in_time || r->window.at[i].gap > 0) {
            diag_report(c->diags, DIAG_delta_t_file, script->delta_t_span, "a requirement depends on the time from tick to tick");
            break;
        }
    check_marks_of_asserts(c, r, script);
}
