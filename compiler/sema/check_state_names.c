// SPDX-License-Identifier: Apache-2.0
// Checks names of states in expressions (language.md 3.30 to 3.33). A name of a state has a value only where S is compared with it, as in S == Run.
// Reports other uses that can only mean such a comparison.
#include "compiler/sema/sema.h"

#include <string.h>

static const AstExpr *without_parens(const AstExpr *e)
{
    while (e->kind == AST_PAREN)
        e = e->a;
    return e;
}

static bool is_equality(const AstExpr *e) { return sm_op_info[e->op].op_class == SM_CLASS_EQUALITY; }

// Returns the machine whose S is e, by any of its names; NULL if e is no S.
static const Program *machine_of_state(const Sema *s, const AstExpr *e)
{
    const Var *v;

    e = without_parens(e);
    v = e->kind == AST_NAME ? scope_find_variable(s, e->name) : NULL;
    return v ? v->state_of : NULL;
}

// Returns the name in e if it can only be the name of a state of machine m. Warns of a name that is also that of a variable, as which it is
// read.
static const AstExpr *name_of_state(Sema *s, const Program *m, const AstExpr *e)
{
    const State *state;
    Diag *d;

    e = without_parens(e);
    state = e->kind == AST_NAME ? map_find(&m->state_by_name, e->name) : NULL;
    if (e->kind != AST_NAME || (!scope_find_variable(s, e->name) && !map_find(&s->defines, e->name)))
        return state ? e : NULL;
    if (state) {
        d = diag_report(s->diags, DIAG_state_or_variable, e->span, e->name->text);
        scope_note_declared(s, d, e->name);
        diag_note(s->diags, d, state->span, DIAG_note_state_declared, state->name->text);
    }
    return NULL;
}

// Builds `S == Run` or `S != Run`, where the number of the state is the value of its name. Returns NULL if e is no such comparison.
static Expr *check_state_comparison(Sema *s, const AstExpr *e)
{
    const AstExpr *name;
    const Program *m;
    Expr *out, *number;
    bool first;

    if (!is_equality(e))
        return NULL;
    first = machine_of_state(s, e->a) != NULL;
    m = machine_of_state(s, first ? e->a : e->b);
    if (!m || !(name = name_of_state(s, m, first ? e->b : e->a)))
        return NULL;
    sema_record_operator(s, e->op);
    s->knows_a_name = true;
    out = expr_new(s, EX_BINARY, e->span, 2);
    out->op = e->op;
    number = expr_new(s, EX_NUMBER, name->span, 0);
    number->number = sm_from_u32(((const State *)map_find(&m->state_by_name, name->name))->number);
    number->window = 1;
    out->arg[first] = number;
    out->arg[!first] = check_expr(s, first ? e->a : e->b);
    return out->arg[!first] ? out : NULL;
}

// Warns of `S == 3`, and proposes the name of the state with that number, unless the name means something else there.
void warn_of_state_number(Sema *s, const AstExpr *e)
{
    const bool first = machine_of_state(s, e->a) != NULL;
    const Program *m = machine_of_state(s, first ? e->a : e->b);
    const AstExpr *number = m ? without_parens(first ? e->b : e->a) : NULL;
    const State *state;
    Diag *d;

    if (!number || number->kind != AST_NUMBER || number->unit != TIME_NONE || !sm_eq(sm_trunc(number->number), number->number) ||
        sm_lt(number->number, sm_from_i32(1)) || sm_lt(sm_from_u32((uint32_t)m->state.n), number->number))
        return;
    state = m->state.at[sm_to_u32(number->number) - 1];
    if (scope_find_variable(s, state->name) || map_find(&s->defines, state->name) || map_find(&m->state_by_name, state->name) != state)
        return;
    d = diag_report(s->diags, DIAG_state_number, number->span, sema_quote_source(s, number->span), state->name->text);
    diag_label(s->diags, d, DIAG_label_write, state->name->text);
    diag_edit(s->diags, d, number->span, state->name->text);
}

// Returns S, as it is written in the comparison; NULL if neither side is S.
static const AstExpr *state_element_in(const Sema *s, const AstExpr *comparison)
{
    if (!comparison)
        return NULL;
    return machine_of_state(s, comparison->a) ? comparison->a : machine_of_state(s, comparison->b) ? comparison->b : NULL;
}

// Returns the first operand of a chain of `or`, before those that are names.
static const AstExpr *first_of_names(const AstExpr *e)
{
    while (e->kind == AST_BINARY && e->op == SM_OP_OR && e->b->kind == AST_NAME)
        e = e->a;
    return e;
}

// Reports B in `S == A or B`, where it has no value: the user means `S == A or S == B`. With another operator, or another left side, what the
// user means is not certain.
static void report_state_as_condition(Sema *s, const AstExpr *e)
{
    const AstExpr *before = e->op == SM_OP_OR ? first_of_names(e->a) : NULL;
    const AstExpr *element = before && before->kind == AST_BINARY ? state_element_in(s, before) : NULL;
    const AstExpr *name = element ? name_of_state(s, machine_of_state(s, element), e->b) : NULL;
    const char *start;
    Diag *d;

    if (!name || before->op != SM_OP_EQ)
        return;
    start = format_in(s->arena, "%s %s ", sema_quote_source(s, element->span), sm_op_info[before->op].spelling);
    d = diag_report(s->diags, DIAG_unknown_element, name->span, name->name->text);
    diag_label(s->diags, d, DIAG_label_write, format_in(s->arena, "%s%s", start, name->name->text));
    diag_edit(s->diags, d, (Span){name->span.src, name->span.at, 0}, start);
}

// Appends the comparisons of an element with the states of `A or B`. Returns false if an operand is no state of the machine.
static bool write_state_choice(Sema *s, const Program *m, const char *element, const AstExpr *e, Buf *out)
{
    const AstExpr *name = e->kind == AST_NAME ? name_of_state(s, m, e) : NULL;

    if (name) {
        buf_printf(out, "%s%s == %s", out->n ? " or " : "", element, name->name->text);
        return true;
    }
    return e->kind == AST_BINARY && e->op == SM_OP_OR && write_state_choice(s, m, element, e->a, out) && write_state_choice(s, m, element, e->b, out);
}

// Reports `S == (A or B)`, where A and B have no value: the user means `S == A or S == B`.
static bool report_state_choice(Sema *s, const AstExpr *e)
{
    const Program *m = e->op == SM_OP_EQ && e->b->kind == AST_PAREN ? machine_of_state(s, e->a) : NULL;
    const AstExpr *states = m ? without_parens(e->b) : NULL;
    Buf out;
    Diag *d;

    buf_init(&out, s->arena);
    if (!states || states->kind != AST_BINARY || !write_state_choice(s, m, sema_quote_source(s, e->a->span), states, &out))
        return false;
    s->knows_a_name = true;
    while (states->kind == AST_BINARY)
        states = states->a;
    d = diag_report(s->diags, DIAG_unknown_element, states->span, states->name->text);
    diag_label(s->diags, d, DIAG_label_write, format_in(s->arena, "(%s)", buf_text(&out)));
    diag_edit(s->diags, d, e->span, format_in(s->arena, "(%s)", buf_text(&out)));
    return true;
}

// Reports A in `not S == A`, where it has no value, because `not` applies to S alone: the user means `S != A`.
static void report_negated_state(Sema *s, const AstExpr *e)
{
    const bool is_negated = is_equality(e) && e->a->kind == AST_UNARY && e->a->op == SM_OP_NOT &&
                            machine_of_state(s, e->a->a);
    const AstExpr *name = is_negated ? name_of_state(s, machine_of_state(s, e->a->a), e->b) : NULL;
    const char *text;
    Diag *d;

    if (!name)
        return;
    text = format_in(s->arena, "%s %s %s", sema_quote_source(s, e->a->a->span), e->op == SM_OP_EQ ? "!=" : "==", name->name->text);
    d = diag_report(s->diags, DIAG_unknown_element, name->span, name->name->text);
    diag_label(s->diags, d, DIAG_label_write, text);
    diag_edit(s->diags, d, e->span, text);
}

// Returns S of `prev(S)`, or NULL.
static const AstExpr *previous_state_element(const Sema *s, const AstExpr *e)
{
    const bool is_prev = e->kind == AST_CALL && strcmp(e->name->text, "prev") == 0 && e->args->n == 1;

    return is_prev && machine_of_state(s, e->args->at[0]) ? e->args->at[0] : NULL;
}

// Reports A in `prev(S) == A`, where it has no value, because only S itself can be compared with a name: the user means `prev(S == A)`.
static void report_previous_state(Sema *s, const AstExpr *e)
{
    const AstExpr *element = is_equality(e) ? previous_state_element(s, e->a) : NULL;
    const AstExpr *name = element ? name_of_state(s, machine_of_state(s, element), e->b) : NULL;
    const char *text;
    Diag *d;

    if (!name)
        return;
    text = format_in(s->arena, "prev(%s %s %s)", sema_quote_source(s, element->span), sm_op_info[e->op].spelling, name->name->text);
    d = diag_report(s->diags, DIAG_unknown_element, name->span, name->name->text);
    diag_label(s->diags, d, DIAG_label_write, text);
    diag_edit(s->diags, d, e->span, text);
}

// Whether e is a name that has no value.
static bool is_name_without_value(const Sema *s, const AstExpr *e)
{
    return e->kind == AST_NAME && !scope_find_variable(s, e->name) && !map_find(&s->defines, e->name) && !map_find(&s->lost->word, e->name);
}

// Reports an unknown name that is compared with S as an unknown state. Returns false if the name is known, or if e compares no S with a name.
static bool report_unknown_state(Sema *s, const AstExpr *e)
{
    const bool first = is_equality(e) && machine_of_state(s, e->a);
    const Program *m = is_equality(e) ? machine_of_state(s, first ? e->a : e->b) : NULL;
    const AstExpr *name = without_parens(first ? e->b : e->a);

    if (!m || !is_name_without_value(s, name))
        return false;
    scope_find_state(s, m, name->name, name->span);
    return true;
}

// Reports an unknown name that is compared with the name of a state, as in `state == Idle`: the user means S.
static bool report_other_name_of_s(Sema *s, const AstExpr *e)
{
    const AstExpr *state = without_parens(e->a), *name = without_parens(e->b);
    const char *own;
    Diag *d;

    if (!is_equality(e) || !s->p->s || !is_name_without_value(s, state) || !is_name_without_value(s, name))
        return false;
    if (!map_find(&s->p->state_by_name, state->name)) {
        state = name;
        name = without_parens(e->a);
    }
    if (!map_find(&s->p->state_by_name, state->name) || map_find(&s->p->state_by_name, name->name))
        return false;
    own = s->p->s->report_name->text;
    d = diag_report(s->diags, DIAG_unknown_element, name->span, name->name->text);
    diag_label(s->diags, d, DIAG_label_write, format_in(s->arena, "%s %s %s", own, sm_op_info[e->op].spelling, state->name->text));
    if (strcmp(name->name->text, "state") == 0)
        diag_edit(s->diags, d, name->span, own);
    return true;
}

bool check_state_names(Sema *s, const AstExpr *e, Expr **out)
{
    const AstExpr *state = is_equality(e) ? state_element_in(s, e) : NULL;

    if (state && s->at == EXPR_IN_INITIAL) {                  // S is an error there; the names of states are not known yet
        *out = check_expr(s, state);
        return true;
    }
    *out = check_state_comparison(s, e);
    if (*out || report_unknown_state(s, e) || report_other_name_of_s(s, e) || report_state_choice(s, e))
        return true;
    report_state_as_condition(s, e);
    report_negated_state(s, e);
    report_previous_state(s, e);
    return false;
}
