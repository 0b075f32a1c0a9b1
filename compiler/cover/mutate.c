// SPDX-License-Identifier: Apache-2.0
#include "compiler/cover/mutant.h"

#include <stdlib.h>
#include <string.h>

#include "compiler/cover/mutant_runs.h"
#include "compiler/cover/mutant_search.h"
#include "compiler/passes/pass.h"
#include "stdlib/convert.h"

const char *const mutant_danger_name[] = {"other", "transition", "output", "abort"};
const char *const mutant_verdict_name[] = {"waiting", "noticed", "unnoticed", "equivalent", "generated"};

struct Mutation {
    Arena *arena, work;       // `work` is emptied before every mutant
    const Program *p;
    MutantRuns *runs;
    uint64_t step;            // mutant_step
    uint32_t scripts;
    VEC(Mutant) mutant;
    uint32_t next, next_search;       // the next mutant to run; to search for
    MutantSearch *search;     // NULL: not needed yet
    const State **start;      // in which scenarios begin, `starts` of them
    uint32_t starts;
    const char *original;     // the IR of the machine without a change, as text; NULL: not needed yet
    uint64_t *initial;        // by Var.index: the initial value as it was
    // The current place, while mutants are listed:
    const State *state;
    Stmt *stmt;               // NULL: none
    MutantDanger danger;
    MutantDanger *of_local, *of_window;       // by Var.index, by window: the most dangerous use of its value
};

// ---- listing ----

static Span own_span(const Mutation *u, Span s) { return (Span){u->p->src, s.at, s.len}; }

// Adds an edit as a mutant, or to the mutant of another copy of the same source that is changed in the same way.
static void add_mutant(Mutation *u, Span span, const char *text, MutantEdit edit)
{
    MutantEdit *copy;
    Mutant m = {own_span(u, span), text, u->danger, u->state, NULL, MUTANT_WAITING, 0, NULL, NULL, NULL};

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

// Returns where a number is written: its own place, or that of the definition, or of the definition of the definition, that is used there.
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

typedef struct OtherOperators { SmOperator op, other[2]; } OtherOperators;      // SM_OP_COUNT: none

static const OtherOperators others[] = {
    {SM_OP_LT, {SM_OP_LE, SM_OP_GE}}, {SM_OP_LE, {SM_OP_LT, SM_OP_GT}}, {SM_OP_GT, {SM_OP_GE, SM_OP_LE}}, {SM_OP_GE, {SM_OP_GT, SM_OP_LT}},
    {SM_OP_EQ, {SM_OP_NE, SM_OP_COUNT}}, {SM_OP_NE, {SM_OP_EQ, SM_OP_COUNT}}, {SM_OP_AND, {SM_OP_OR, SM_OP_COUNT}},
    {SM_OP_OR, {SM_OP_AND, SM_OP_COUNT}}, {SM_OP_ADD, {SM_OP_SUB, SM_OP_COUNT}}, {SM_OP_SUB, {SM_OP_ADD, SM_OP_COUNT}},
    {SM_OP_MUL, {SM_OP_DIV, SM_OP_COUNT}}, {SM_OP_DIV, {SM_OP_MUL, SM_OP_COUNT}}};

// Whether op, written in place of `was`, has operands that the parser groups in the same way.
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
                add_mutant(u, at, sm_op_info[op].spelling, (MutantEdit){.kind = e->kind == EX_CHAIN ? EDIT_LINK : EDIT_OPERATOR, .e = e, .link = link, .op = op});
        }
}

static bool same_span(Span a, Span b) { return a.at == b.at && a.len == b.len; }

// Whether the source contains operator i of e: its operands are on both sides of it.  The checker composes others, as
// those of a median (list.h).
static bool is_in_source(const Expr *e, uint32_t i) { return e->arg[i]->span.at < e->arg[i + 1]->span.at && e->arg[i]->span.src == e->arg[i + 1]->span.src; }

static bool is_and_or(const Expr *e) { return e->kind == EX_BINARY && (e->op == SM_OP_AND || e->op == SM_OP_OR); }

// Whether e contains, or is an operand of, another `and` or `or`.  To replace the operator of e would then group the operands in another way.
static bool is_beside_and_or(const Expr *e, const Expr *outer)
{
    return (outer && is_and_or(outer)) || is_and_or(e->arg[0]) || is_and_or(e->arg[1]);
}

static void list_expression(Mutation *u, Expr *e, const Expr *outer)
{
    switch (e->kind) {
    case EX_NUMBER:
        add_numbers(u, written_number(u, own_span(u, e->span)), e->number, (MutantEdit){.kind = EDIT_NUMBER, .e = e});
        return;
    case EX_UNARY:
        if (e->op == SM_OP_NOT && !same_span(e->span, e->arg[0]->span) && e->span.len > 4 && memcmp(e->span.src->text + e->span.at, "not", 3) == 0)
            add_mutant(u, (Span){e->span.src, e->span.at, 3}, "", (MutantEdit){.kind = EDIT_DROP_NOT, .e = e});
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

// Returns the most dangerous thing that the statements do.
static MutantDanger danger_of(const Mutation *u, const Stmts *list)
{
    MutantDanger most = DANGER_OTHER;

    for (size_t i = 0; i < list->n; i++) {
        const Stmt *s = list->at[i];
        const MutantDanger then = danger_of(u, &s->then), otherwise = danger_of(u, &s->otherwise);
        MutantDanger own = DANGER_OTHER;
        if (s->kind == ST_TRANSITION)
            own = s->target->is_abort ? DANGER_ABORT : DANGER_TRANSITION;
        else if (s->kind == ST_ASSIGN)
            own = s->var->kind == VAR_ELEMENT ? DANGER_OUTPUT : u->of_local[s->var->index];
        own = then > own ? then : own;
        own = otherwise > own ? otherwise : own;
        most = own > most ? own : most;
    }
    return most;
}

// Notes that an expression is used for something of this danger.  Returns whether a local or a window is more dangerous than before.
static bool note_use(Mutation *u, const Expr *e, MutantDanger danger)
{
    MutantDanger *of = e->kind == EX_ROLL ? &u->of_window[e->window] : e->kind == EX_VAR && e->var->kind == VAR_LOCAL ? &u->of_local[e->var->index] : NULL;
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

// Finds how dangerous locals and windows are: a limit is as dangerous as the guards that compare with it, and a counter as those that read it.
static void find_dangers(Mutation *u)
{
    bool any = true;

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

    for (size_t i = 0; i < n && !s->span.src->written; i++) {
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

// What windows sample, which is computed at every step.
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

// Initial values that are numbers.  If a window's size depends on some local, they are left out, because windows are not built again.
static void list_initial_values(Mutation *u)
{
    u->stmt = NULL;
    for (size_t i = 0; i < u->p->var.n && !sizes_a_window(u->p); i++) {
        Var *v = u->p->var.at[i];
        u->danger = u->of_local[v->index];
        if (v->kind == VAR_LOCAL && v->init_value && v->init_value->kind == EX_NUMBER)
            add_numbers(u, v->init_value->span, v->init_value->number, (MutantEdit){.kind = EDIT_INITIAL, .var = v});
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

static void list_mutants(Mutation *u)
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

// ---- changing the program ----

// What an edit has replaced.
typedef struct Undo {
    SmF64 number;             // NUMBER, INITIAL: as it was
    SmOperator op;            // OPERATOR, LINK, DROP_NOT: as it was
    Stmt stmt;                // GUARD, TARGET, DELETE: as it was
} Undo;

// Computes the initial values of all locals again, in their order.
static void compute_initial_values(Mutation *u)
{
    for (size_t i = 0; i < u->p->var.n; i++) {
        Var *v = u->p->var.at[i];
        if (v->kind == VAR_LOCAL && v->init_value)
            v->init = sm_cell_from_f64(v->type, expr_constant_value(v->init_value));
    }
}

static void restore_initial_values(Mutation *u)
{
    for (size_t i = 0; i < u->p->var.n; i++)
        u->p->var.at[i]->init = u->initial[i];
}

static Expr *new_number(Mutation *u, double x)
{
    Expr *e = ARENA_NEW(&u->work, Expr);

    e->kind = EX_NUMBER;
    e->number = x;
    return e;
}

static void apply_edit(Mutation *u, const MutantEdit *d, Undo *undo)
{
    if (d->e) {
        undo->number = d->e->number;
        undo->op = d->e->op;
    }
    if (d->stmt)
        undo->stmt = *d->stmt;
    switch (d->kind) {
    case EDIT_NUMBER: d->e->number = d->number; break;
    case EDIT_OPERATOR: d->e->op = d->op; break;
    case EDIT_LINK:
        undo->op = expr_ops(d->e)[d->link];
        expr_ops(d->e)[d->link] = d->op;
        break;
    case EDIT_DROP_NOT: d->e->op = SM_OP_PLUS; break;
    case EDIT_GUARD: d->stmt->value = new_number(u, d->number); break;
    case EDIT_TARGET: d->stmt->target = d->target; break;
    case EDIT_DELETE:
        d->stmt->kind = ST_IF;
        d->stmt->value = new_number(u, 0);
        memset(&d->stmt->then, 0, sizeof d->stmt->then);
        memset(&d->stmt->otherwise, 0, sizeof d->stmt->otherwise);
        break;
    case EDIT_INITIAL:
        undo->number = d->var->init_value->number;
        d->var->init_value->number = d->number;
        compute_initial_values(u);
        break;
    }
}

static void undo_edit(Mutation *u, const MutantEdit *d, const Undo *undo)
{
    if (d->kind == EDIT_LINK) {
        expr_ops(d->e)[d->link] = undo->op;
    } else if (d->e) {
        d->e->number = undo->number;
        d->e->op = undo->op;
    }
    if (d->stmt)
        *d->stmt = undo->stmt;
    if (d->kind == EDIT_INITIAL) {
        d->var->init_value->number = undo->number;
        restore_initial_values(u);
    }
}

// Undoes the edits of a list, the last one first, because two of them can change one expression.
static void undo_edits(Mutation *u, const MutantEdit *list, const Undo *undo)
{
    if (!list)
        return;
    undo_edits(u, list->next, undo + 1);
    undo_edit(u, list, undo);
}

static uint32_t count_edits(const Mutant *m)
{
    uint32_t n = 0;

    for (const MutantEdit *d = m->edit; d; d = d->next)
        n++;
    return n;
}

// ---- running ----

static const char *optimised_text(Mutation *u, Arena *arena)
{
    const PassOptions o = {2, NULL, false, false, NULL, NULL};
    IrMachine *m = ir_build(&u->work, u->p);
    Buf out;

    passes_run(&u->work, m, &o);
    buf_init(&out, arena);
    ir_print(m, &out);
    return buf_text(&out);
}

// Returns the first script that fails on the current program, or the number of scripts.
static uint32_t find_noticing(Mutation *u, Mutant *m)
{
    uint32_t n = 0, *stmt = ARENA_ARRAY(&u->work, uint32_t, count_edits(m));

    for (const MutantEdit *d = m->edit; d; d = d->next)
        stmt[n++] = d->stmt ? d->stmt->number : d->kind == EDIT_INITIAL ? MUTANT_START : MUTANT_EACH_STEP;
    return mutant_runs_find_noticing(u->runs, &u->work, flat_new(&u->work, ir_build(&u->work, u->p), NULL), stmt, n, &m->violated);
}

// Makes the program that of the mutant.  Returns what undo_edits needs.
static Undo *apply_edits(Mutation *u, const Mutant *m)
{
    Undo *undo = arena_array(&u->work, count_edits(m), sizeof *undo);
    uint32_t n = 0;

    for (const MutantEdit *d = m->edit; d; d = d->next)
        apply_edit(u, d, &undo[n++]);
    return undo;
}

bool mutation_run_next(Mutation *u)
{
    Mutant *m;
    Undo *undo;
    uint32_t noticing;

    if (u->next == u->mutant.n)
        return false;
    arena_reset(&u->work);
    m = &u->mutant.at[u->next++];
    undo = apply_edits(u, m);
    noticing = find_noticing(u, m);
    m->verdict = noticing < u->scripts ? MUTANT_NOTICED : strcmp(optimised_text(u, &u->work), u->original) == 0 ? MUTANT_EQUIVALENT : MUTANT_UNNOTICED;
    m->script = noticing;
    undo_edits(u, m->edit, undo);
    if (m->verdict == MUTANT_UNNOTICED && mutant_is_equivalent(&u->work, u->p, m->edit, u->step))
        m->verdict = MUTANT_EQUIVALENT;
    return true;
}

// ---- searching ----

enum {
    SEARCH_STEP = 10,         // by how much G grows, if it is not known
    GIVEN_STEPS_MOST = 20000  // of a script whose situations the search uses
};

// The numbers that a change concerns.
typedef struct Around { double at[32]; uint32_t n; } Around;

static void add_around(Around *list, double x)
{
    if (list->n < sizeof list->at / sizeof *list->at)
        list->at[list->n++] = x;
}

static void collect_around(Expr *e, void *context)
{
    if (e->kind == EX_NUMBER || (e->kind == EX_VAR && e->var->is_constant))
        add_around(context, expr_constant_value(e));
}

static bool contains_statement(const Stmts *list, const Stmt *s)
{
    for (size_t i = 0; i < list->n; i++)
        if (list->at[i] == s || contains_statement(&list->at[i]->then, s) || contains_statement(&list->at[i]->otherwise, s))
            return true;
    return false;
}

// Adds the numbers of the guards around a statement.
static void add_guards(Around *around, const Stmts *list, const Stmt *inside)
{
    for (size_t i = 0; i < list->n; i++) {
        const Stmt *s = list->at[i];
        if (s->kind != ST_IF || (!contains_statement(&s->then, inside) && !contains_statement(&s->otherwise, inside)))
            continue;
        expr_walk(s->value, collect_around, around);
        add_guards(around, &s->then, inside);
        add_guards(around, &s->otherwise, inside);
    }
}

static void add_all_guards(const Program *p, Around *around, const Stmt *inside)
{
    for (size_t i = 0; i < p->state.n; i++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            add_guards(around, &p->state.at[i]->block[b], inside);
}

static Around find_around(const Program *p, const Mutant *m)
{
    Around list = {.n = 0};

    for (const MutantEdit *d = m->edit; d; d = d->next) {
        if (d->kind == EDIT_NUMBER || d->kind == EDIT_INITIAL)
            add_around(&list, d->number);
        if (d->kind == EDIT_INITIAL)
            add_around(&list, d->var->init_value->number);
        if (d->stmt && d->stmt->value)
            expr_walk(d->stmt->value, collect_around, &list);
        else if (d->e)
            expr_walk(d->e, collect_around, &list);
        if (d->stmt)
            add_all_guards(p, &list, d->stmt);
    }
    return list;
}

static bool reads_var(const Expr *e, const Var *v)
{
    bool found = e->kind == EX_VAR && e->var == v;

    for (uint32_t i = 0; i < e->n && !found; i++)
        found = reads_var(e->arg[i], v);
    return found;
}

// Whether some statement of the list reads a variable.
static bool reads(const Stmts *list, const Var *v)
{
    for (size_t i = 0; i < list->n; i++)
        if ((list->at[i]->value && reads_var(list->at[i]->value, v)) || reads(&list->at[i]->then, v) || reads(&list->at[i]->otherwise, v))
            return true;
    return false;
}

// Returns the state in which a change has its effect: for an initial value the last one that reads it; NULL: several.
static const State *find_state(const Program *p, const Mutant *m)
{
    const State *found = m->state;

    for (size_t i = 0; i < p->state.n && m->edit->kind == EDIT_INITIAL; i++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            if (reads(&p->state.at[i]->block[b], m->edit->var))
                found = p->state.at[i];
    return found;
}

static void add_start(Mutation *u, const State *start)
{
    for (uint32_t i = 0; i < u->starts; i++)
        if (u->start[i] == start)
            return;
    u->start[u->starts++] = start;
}

static MutantSearch *new_search(Mutation *u)
{
    const uint64_t step = u->step ? u->step : SEARCH_STEP;
    const Scenario **given = arena_array(u->arena, u->scripts + (size_t)1, sizeof *given);
    uint32_t n = 0;

    for (uint32_t i = 0; i < u->scripts; i++) {
        given[n] = mutant_runs_scenario(u->runs, u->arena, i);
        n += given[n] && given[n]->delta_t == step && given[n]->steps <= GIVEN_STEPS_MOST;
    }
    return mutant_search_new(u->arena, u->p, mutant_runs_original(u->runs), step, u->start, u->starts, given, n);
}

FlatMachine *mutation_build(Mutation *u, Arena *arena, const Mutant *m)
{
    Undo *undo = apply_edits(u, m);
    FlatMachine *f = flat_new(arena, ir_build(arena, u->p), NULL);

    undo_edits(u, m->edit, undo);
    return f;
}

bool mutation_search_next(Mutation *u, uint64_t steps)
{
    Mutant *m;
    FlatMachine *mutant;
    Around around;

    while (u->next_search < u->mutant.n && u->mutant.at[u->next_search].verdict != MUTANT_UNNOTICED)
        u->next_search++;
    if (u->next_search == u->mutant.n)
        return false;
    m = &u->mutant.at[u->next_search++];
    if (!u->search)
        u->search = new_search(u);
    arena_reset(&u->work);
    mutant = mutation_build(u, &u->work, m);
    around = find_around(u->p, m);
    m->scenario = mutant_search_run(u->search, u->arena, &u->work, mutant, find_state(u->p, m), around.at, around.n, steps, &m->differs);
    if (m->scenario)
        m->verdict = MUTANT_GENERATED;
    return true;
}

Mutation *mutation_new(Arena *arena, const Program *p, const Script *const *script, uint32_t scripts, const Requirements *rq, uint64_t max_steps)
{
    Mutation *u = ARENA_NEW(arena, Mutation);

    u->arena = arena;
    arena_init(&u->work, arena->alloc, arena->context, arena->oom);
    u->p = p;
    u->scripts = scripts;
    u->step = mutant_step(p, script, scripts);
    u->start = arena_array(arena, scripts + (size_t)1, sizeof *u->start);
    add_start(u, p->state.at[0]);
    for (uint32_t i = 0; i < scripts; i++)
        add_start(u, script[i]->init_state);
    u->runs = mutant_runs_new(arena, p, script, scripts, rq, max_steps);
    u->initial = ARENA_ARRAY(arena, uint64_t, p->var.n);
    for (size_t i = 0; i < p->var.n; i++)
        u->initial[i] = p->var.at[i]->init;
    arena_reset(&u->work);
    u->original = optimised_text(u, arena);
    list_mutants(u);
    return u;
}

uint32_t mutation_find_failing(const Mutation *u) { return mutant_runs_find_failing(u->runs); }

const Mutant *mutation_list(const Mutation *u, uint32_t *n)
{
    *n = (uint32_t)u->mutant.n;
    return u->mutant.at;
}

void mutation_end(Mutation *u) { arena_free(&u->work); }
