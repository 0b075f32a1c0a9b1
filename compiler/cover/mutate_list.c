// SPDX-License-Identifier: Apache-2.0
// Lists the mutants of a machine: visits every expression, statement, window and initial value, and adds what can be changed there.
#include "compiler/cover/mutant.h"

#include <stdlib.h>
#include <string.h>

#include "stdlib/convert.h"

// ---- expressions ----

static Span own_span(const Mutation *u, Span s) { return (Span){u->p->src, s.at, s.len}; }

// Adds an edit as a mutant, or to the mutant of another copy of the same source that is changed in the same way.
static void add_mutant(Mutation *u, Span span, const char *text, MutantEdit edit)
{
    MutantEdit *copy;
    Mutant m = {.span = own_span(u, span), .text = text, .danger = u->danger, .state = u->state};

    edit.stmt = u->stmt;
    for (uint32_t i = 0; i < u->mutant.n; i++) {
        Mutant *same = &u->mutant.at[i];
        if (same->span.at != span.at || same->span.len != span.len || strcmp(same->text, text) != 0)
            continue;
        edit.next = same->edit;
        same->edit = arena_copy(u->arena, &edit, sizeof edit);
        same->state = same->state == u->state ? same->state : NULL;
        same->danger = same->danger > u->danger ? same->danger : u->danger;
        return;
    }
    copy = arena_copy(u->arena, &edit, sizeof edit);
    m.edit = copy;
    vec_push(u->arena, &u->mutant, m);
}

// Returns the length of the decimal number at the start of the text: digits, with or without a point.  0: it begins with none.
static uint32_t number_length(const char *at, uint32_t len)
{
    uint32_t n = 0;

    while (n < len && ((at[n] >= '0' && at[n] <= '9') || (at[n] == '.' && n > 0)))
        n++;
    return n < len && (at[n] == 'e' || at[n] == 'E' || at[n] == 'x' || at[n] == '_' || at[n] == 'b') ? 0 : n;
}

// Returns the position of the digits of a number: s itself, or if a definition is used at s, the position in that definition, and so on.
static Span written_number(const Mutation *u, Span s)
{
    const Defines *all = &u->p->define;

    for (size_t left = all->n; left > 0 && number_length(u->p->src->text + s.at, s.len) == 0; left--) {
        const Define *used = NULL;
        for (size_t i = 0; i < all->n && !used; i++)
            for (size_t k = 0; k < all->at[i]->use.n && !used; k++)
                if (all->at[i]->use.at[k].span.at == s.at && all->at[i]->use.at[k].span.len == s.len)
                    used = all->at[i];
        if (!used)
            break;
        s = used->value_span;
    }
    return s;
}

// Adds the mutants of a number: about a tenth more and a tenth less, and at least 1 if it is whole.  A number with a unit has to be whole.
static void add_numbers(Mutation *u, Span span, double value, MutantEdit edit)
{
    const uint32_t n = span.src ? number_length(span.src->text + span.at, span.len) : 0;
    const bool whole = n > 0 && !memchr(span.src->text + span.at, '.', n), plain = n == span.len;
    double written = 0, unit;

    if (n == 0 || n > 15 || (!whole && !plain))
        return;
    for (uint32_t i = 0; whole && i < n; i++)
        written = written * 10 + (span.src->text[span.at + i] - '0');
    written = whole ? written : value;
    unit = plain || written == 0 ? 1 : value / written;
    if (unit < 1 || unit != (double)(uint64_t)unit || written * unit != value)
        return;
    for (int sign = 1; sign >= -1; sign -= 2) {
        double by = whole ? (double)(uint64_t)(written / 10) : written / 10;
        Buf text;
        by = whole && by < 1 ? 1 : by;
        if (written + sign * by < 0)
            continue;
        buf_init(&text, u->arena);
        format_number_shortest(&text, written + sign * by);
        edit.number = (written + sign * by) * unit;
        add_mutant(u, (Span){span.src, span.at, n}, buf_text(&text), edit);
    }
}

// Returns the position of the operator between two operands; an empty span if it is not found.
static Span find_operator(Span left, Span right, const char *spelling)
{
    const uint32_t n = (uint32_t)strlen(spelling), end = right.at;
    const char *text = left.src->text;
    bool comment = false;

    for (uint32_t at = left.at + left.len; at + n <= end; at++) {
        comment = text[at] == '#' || (comment && text[at] != '\n');
        if (!comment && memcmp(text + at, spelling, n) == 0)
            return (Span){left.src, at, n};
    }
    return (Span){NULL, 0, 0};
}

// The operators by which a mutant replaces `op`; SM_OP_COUNT: no second one.
typedef struct OtherOperators { SmOperator op, other[2]; } OtherOperators;

static const OtherOperators others[] = {
    {SM_OP_LT, {SM_OP_LE, SM_OP_GE}}, {SM_OP_LE, {SM_OP_LT, SM_OP_GT}}, {SM_OP_GT, {SM_OP_GE, SM_OP_LE}}, {SM_OP_GE, {SM_OP_GT, SM_OP_LT}},
    {SM_OP_EQ, {SM_OP_NE, SM_OP_COUNT}}, {SM_OP_NE, {SM_OP_EQ, SM_OP_COUNT}}, {SM_OP_AND, {SM_OP_OR, SM_OP_COUNT}},
    {SM_OP_OR, {SM_OP_AND, SM_OP_COUNT}}, {SM_OP_ADD, {SM_OP_SUB, SM_OP_COUNT}}, {SM_OP_SUB, {SM_OP_ADD, SM_OP_COUNT}},
    {SM_OP_MUL, {SM_OP_DIV, SM_OP_COUNT}}, {SM_OP_DIV, {SM_OP_MUL, SM_OP_COUNT}}};

// Whether the parser groups the operands in the same way if the source has `op` instead of `was`.  alone: no other `and` or `or` is next to it.
static bool keeps_grouping(SmOperator was, SmOperator op, bool alone)
{
    return alone || (was != SM_OP_AND && was != SM_OP_OR) || op == was;
}

static void add_operators(Mutation *u, Expr *e, uint32_t link, SmOperator was, Span left, Span right, bool alone)
{
    const Span at = find_operator(left, right, sm_op_info[was].spelling);

    for (size_t i = 0; at.src && i < sizeof others / sizeof *others; i++)
        for (int k = 0; k < 2 && others[i].op == was; k++) {
            const SmOperator op = others[i].other[k];
            if (op != SM_OP_COUNT && keeps_grouping(was, op, alone))
                add_mutant(u, at, sm_op_info[op].spelling,
                           (MutantEdit){.kind = e->kind == EX_CHAIN ? EDIT_LINK : EDIT_OPERATOR, .e = e, .link = link, .op = op});
        }
}

static bool same_span(Span a, Span b) { return a.at == b.at && a.len == b.len; }

// Whether the user wrote operator i of e: then its operands are on both sides of it in the source.  The checker adds other
// operators, for example when it composes a median of comparisons (list.h).
static bool is_in_source(const Expr *e, uint32_t i)
{
    return e->arg[i]->span.at < e->arg[i + 1]->span.at && e->arg[i]->span.src == e->arg[i + 1]->span.src;
}

static bool is_and_or(const Expr *e) { return e->kind == EX_BINARY && (e->op == SM_OP_AND || e->op == SM_OP_OR); }

// Whether e contains, or is an operand of, another `and` or `or`.  To replace the operator of e would then group the operands in another way.
static bool is_beside_and_or(const Expr *e, const Expr *outer)
{
    return (outer && is_and_or(outer)) || is_and_or(e->arg[0]) || is_and_or(e->arg[1]);
}

// Adds the mutant of a unary operator: it is left out.
static void add_unary(Mutation *u, Expr *e)
{
    const char *const spelling = e->op == SM_OP_NOT ? "not" : "-";
    const uint32_t n = (uint32_t)strlen(spelling);

    if (e->op != SM_OP_PLUS && !same_span(e->span, e->arg[0]->span) && e->span.len > n && memcmp(e->span.src->text + e->span.at, spelling, n) == 0)
        add_mutant(u, (Span){e->span.src, e->span.at, n}, "", (MutantEdit){.kind = EDIT_DROP_UNARY, .e = e});
}

static void list_expression(Mutation *u, Expr *e, const Expr *outer)
{
    switch (e->kind) {
    case EX_NUMBER:
        add_numbers(u, written_number(u, own_span(u, e->span)), e->number, (MutantEdit){.kind = EDIT_NUMBER, .e = e});
        return;
    case EX_UNARY:
        add_unary(u, e);
        break;
    case EX_BINARY:
        if (is_in_source(e, 0))
            add_operators(u, e, 0, e->op, e->arg[0]->span, e->arg[1]->span, !is_beside_and_or(e, outer));
        break;
    case EX_CHAIN:
        for (uint32_t i = 0; i + 1 < e->n; i++)
            if (is_in_source(e, i))
                add_operators(u, e, i, expr_ops(e)[i], e->arg[i]->span, e->arg[i + 1]->span, true);
        break;
    case EX_VAR: case EX_CALL: case EX_ROLL: case EX_EVERY: case EX_AT: case EX_RANDOM: break;
    }
    for (uint32_t i = 0; i < e->n && e->kind != EX_ROLL; i++)
        list_expression(u, e->arg[i], e);
}

// ---- statements ----

// Returns the highest danger of the statements' effects: of their transitions and assignments.
static MutantDanger danger_of(const Mutation *u, const Stmts *list)
{
    MutantDanger most = DANGER_OTHER;

    for (size_t i = 0; i < list->n; i++) {
        const Stmt *s = list->at[i];
        const MutantDanger then = danger_of(u, &s->then), otherwise = danger_of(u, &s->otherwise);
        MutantDanger own = DANGER_OTHER;
        if (s->kind == ST_TRANSITION)
            own = s->target->is_abort ? DANGER_ABORT : u->leads_to_hazard[s->target->number - 1] ? DANGER_HAZARD : DANGER_TRANSITION;
        else if (s->kind == ST_ASSIGN)
            own = u->hazard[s->var->index] ? DANGER_HAZARD : s->var->kind == VAR_ELEMENT ? DANGER_OUTPUT : u->of_local[s->var->index];
        own = then > own ? then : own;
        own = otherwise > own ? otherwise : own;
        most = own > most ? own : most;
    }
    return most;
}

// Notes that the value of an expression affects something of this danger.  Returns whether this raises the danger of a local or a window in it.
static bool note_use(Mutation *u, const Expr *e, MutantDanger danger)
{
    MutantDanger *of = e->kind == EX_ROLL ? &u->of_window[e->window] : e->kind == EX_VAR && e->var->kind == VAR_LOCAL
        ? &u->of_local[e->var->index] : NULL;
    const bool is_raised = of && *of < danger;
    bool any = is_raised;

    if (is_raised)
        *of = danger;
    for (uint32_t i = 0; i < e->n; i++)
        any |= note_use(u, e->arg[i], danger);
    return any;
}

static bool note_uses(Mutation *u, const Stmts *list)
{
    bool any = false;

    for (size_t i = 0; i < list->n; i++) {
        const Stmts only = {&list->at[i], 1, 1};
        if (list->at[i]->value)
            any |= note_use(u, list->at[i]->value, danger_of(u, &only));
        any |= note_uses(u, &list->at[i]->then);
        any |= note_uses(u, &list->at[i]->otherwise);
    }
    return any;
}

// Computes the dangers of locals and windows: each is as dangerous as the most dangerous guard or statement that reads it.
static void find_dangers(Mutation *u)
{
    bool any = true;

    u->hazard = ARENA_ARRAY(u->arena, bool, u->p->var.n + 1);
    u->leads_to_hazard = ARENA_ARRAY(u->arena, bool, u->p->state.n + 1);
    for (size_t v = 0; v < u->p->var.n; v++)
        u->hazard[v] = mutant_is_hazard(u->p, u->p->var.at[v]);
    for (size_t s = 0; s < u->p->state.n; s++)
        u->leads_to_hazard[s] = mutant_state_has_hazard(u->p, u->p->state.at[s], u->hazard);
    u->of_local = ARENA_ARRAY(u->arena, MutantDanger, u->p->var.n + 1);
    u->of_window = ARENA_ARRAY(u->arena, MutantDanger, u->p->window.n + 1);
    while (any) {
        any = false;
        for (size_t s = 0; s < u->p->state.n; s++)
            for (int b = 0; b < BLOCK_COUNT; b++)
                any |= note_uses(u, &u->p->state.at[s]->block[b]);
    }
}

// Adds a transition to another state: the next one of the file that is neither its own state nor its target.
static void add_target(Mutation *u, Stmt *s)
{
    const size_t n = u->p->state.n;
    const Span name = {s->span.src, s->span.at + s->span.len - s->target->name->len, s->target->name->len};

    for (size_t i = 0; i < n && !s->span.src->copy_of; i++) {
        State *other = u->p->state.at[(s->target->number + i) % n];
        if (other == s->target || other == u->state)
            continue;
        add_mutant(u, name, other->name->text, (MutantEdit){.kind = EDIT_TARGET, .target = other});
        return;
    }
}

static void list_statements(Mutation *u, const Stmts *list);

static void list_statement(Mutation *u, Stmt *s)
{
    const Stmts only = {&s, 1, 1};

    u->stmt = s;
    u->danger = danger_of(u, &only);
    switch (s->kind) {
    case ST_ASSIGN:
        list_expression(u, s->value, NULL);
        add_mutant(u, s->span, "if 0 { } else { }", (MutantEdit){.kind = EDIT_DELETE});
        break;
    case ST_TRANSITION:
        add_target(u, s);
        add_mutant(u, s->span, "if 0 { } else { }", (MutantEdit){.kind = EDIT_DELETE});
        break;
    case ST_IF:
        list_expression(u, s->value, NULL);
        add_mutant(u, s->value->span, "0", (MutantEdit){.kind = EDIT_GUARD, .number = 0});
        add_mutant(u, s->value->span, "1", (MutantEdit){.kind = EDIT_GUARD, .number = 1});
        list_statements(u, &s->then);
        list_statements(u, &s->otherwise);
        break;
    }
}

static void list_statements(Mutation *u, const Stmts *list)
{
    for (size_t i = 0; i < list->n; i++)
        list_statement(u, list->at[i]);
}

// Lists the changes in what windows sample.
static void list_windows(Mutation *u)
{
    u->stmt = NULL;
    u->state = NULL;
    for (size_t i = 0; i < u->p->window.n; i++) {
        u->danger = u->of_window[i];
        list_expression(u, u->p->window.at[i].sample, NULL);
    }
}

static bool sizes_a_window(const Program *p)
{
    for (size_t i = 0; i < p->var.n; i++)
        if (p->var.at[i]->sizes)
            return true;
    return false;
}

// Adds the mutants of an initial value: other numbers, and the same one without its sign.  The new number of an edit has the sign of the source.
static void add_initial(Mutation *u, Var *v)
{
    const Expr *number = mutant_initial_number(v), *value = v->init_value;
    const MutantEdit edit = {.kind = EDIT_INITIAL, .var = v, .number = number ? -number->number : 0};

    if (!number)
        return;
    if (number != value && value->span.len > 1 && value->span.src->text[value->span.at] == '-')
        add_mutant(u, (Span){value->span.src, value->span.at, 1}, "", edit);
    add_numbers(u, number->span, number->number, edit);
}

// Lists the initial values that are numbers.  None if the size of a window depends on a local, because windows are not built again.
static void list_initial_values(Mutation *u)
{
    u->stmt = NULL;
    for (size_t i = 0; i < u->p->var.n && !sizes_a_window(u->p); i++) {
        Var *v = u->p->var.at[i];
        u->danger = u->of_local[v->index];
        if (v->kind == VAR_LOCAL)
            add_initial(u, v);
    }
}

static int compare_mutants(const void *a, const void *b)
{
    const Mutant *x = a, *y = b;

    if (x->span.at != y->span.at)
        return x->span.at < y->span.at ? -1 : 1;
    if (x->span.len != y->span.len)
        return x->span.len < y->span.len ? -1 : 1;
    return strcmp(x->text, y->text);
}

void mutation_list_all(Mutation *u)
{
    find_dangers(u);
    for (size_t s = 0; s < u->p->state.n; s++) {
        u->state = u->p->state.at[s];
        for (int b = 0; b < BLOCK_COUNT; b++)
            list_statements(u, &u->p->state.at[s]->block[b]);
    }
    list_windows(u);
    list_initial_values(u);
    if (u->mutant.n)
        qsort(u->mutant.at, u->mutant.n, sizeof *u->mutant.at, compare_mutants);
}
