// SPDX-License-Identifier: Apache-2.0
// Parameters of a machine (language.md 5.77 to 5.84): their ranges and defaults, what cannot depend on them, and how they get other values.
#include "compiler/sema/sema.h"

#include <string.h>

#include "stdlib/parameter.h"

// ---- declarations ----

static const AstAnnotation *find_annotation(const AstAnnotations *all, AstAnnotationKind kind)
{
    for (size_t i = 0; i < all->n; i++)
        if (all->at[i].kind == kind)
            return &all->at[i];
    return NULL;
}

// Sets *end to the lower or upper end of a range, as the type stores it.  Reports an end that the type cannot store; an F32 is rounded.
static bool store_end(Sema *s, const Var *v, const AstNumber *written, SmF64 *end)
{
    const SmF64 x = sm_parameter_rounded(v->type, written->value), stored = sm_cell_to_f64(v->type, sm_cell_from_f64(v->type, x));
    const bool is_finite = sm_eq(sm_sub(x, x), sm_from_i32(0));
    const bool saturates = (v->type == SM_U64 && sm_eq(x, sm_from_bits(0x43F0000000000000u))) ||         // 2^64
                           (v->type == SM_I64 && sm_eq(x, sm_from_bits(0x43E0000000000000u)));           // 2^63

    *end = stored;
    if (is_finite && !saturates && sm_eq(stored, x))
        return true;
    diag_report(s->diags, DIAG_parameter_range_end, written->span, v->name->text, const_text(s->arena, written->value),
                sm_type_info[v->type].spelling);
    return false;
}

// Sets both ends of the range, also if the first has an error, so that both are reported.
static bool store_ends(Sema *s, const Var *v, const AstAnnotation *range, Parameter *p)
{
    const bool lo = store_end(s, v, &range->lo, &p->lo), hi = store_end(s, v, &range->hi, &p->hi);

    return lo && hi;
}

// Sets the range of a parameter.  Without a valid one the parameter accepts every number, so that nothing else is reported.
static void set_range(Sema *s, const Var *v, const AstDecl *decl, Parameter *p)
{
    const SmF64 highest = sm_from_bits(0x7FEFFFFFFFFFFFFFu);
    const AstAnnotation *range = find_annotation(&decl->annotations, AST_RANGE);

    if (v->type == SM_BOOL && range)
        diag_report(s->diags, DIAG_range_of_bool, range->span, v->name->text);
    p->lo = sm_neg(highest);
    p->hi = highest;
    if (v->type == SM_BOOL) {
        p->lo = sm_from_i32(0);
        p->hi = sm_from_i32(1);
    } else if (!range) {
        if (!decl->is_incomplete)
            diag_label(s->diags, diag_report(s->diags, DIAG_parameter_without_range, p->span, v->name->text), DIAG_label_parameter_range);
    } else if (sm_lt(range->hi.value, range->lo.value)) {
        diag_report(s->diags, DIAG_range_empty, range->span, v->name->text, const_text(s->arena, range->lo.value),
                    const_text(s->arena, range->hi.value));
    } else if (!store_ends(s, v, range, p)) {
        p->lo = sm_neg(highest);
        p->hi = highest;
    }
}

const Parameter *check_parameter(Sema *s, const Var *v, const AstDecl *decl)
{
    const AstAnnotation *mark = find_annotation(&decl->annotations, AST_PARAMETER), *range = find_annotation(&decl->annotations, AST_RANGE);
    Parameter *p;

    if (!mark && range)
        diag_report(s->diags, DIAG_annotation_on_local, range->span, "range", "elements of the state vector and parameters");
    if (!mark)
        return NULL;
    p = ARENA_NEW(s->arena, Parameter);
    p->span = mark->span;
    p->unit = v->unit;
    if (!scope_is_doubtful(s, v->name))
        set_range(s, v, decl, p);
    return p;
}

// Sets the parameter's default value to x, and reports x if it is outside the parameter's range.
void check_default(Sema *s, Var *v, SmF64 x)
{
    const SmParameterRange range = {v->type, v->parameter->lo, v->parameter->hi};
    const SmRefusal refusal = sm_parameter_judge(&range, x);

    v->init = sm_cell_from_f64(v->type, x);
    ((Parameter *)v->parameter)->standard = v->init;
    if (refusal && !scope_is_doubtful(s, v->name))
        diag_report(s->diags, DIAG_parameter_default, v->init_value->span, v->name->text, const_text(s->arena, x), parameter_refusal_text(refusal));
}

// ---- what cannot depend on a parameter ----

// Reports a parameter in an initial value, and records the local for propose_definitions.
void report_parameter_in_initial(Sema *s, const Var *v, const AstExpr *e)
{
    const DependentLocal dependent = {s->local, diag_report(s->diags, DIAG_parameter_in_initial, e->span, s->local->name->text, v->name->text)};

    scope_note_declared(s, dependent.report, e->name);
    vec_push(s->arena, &s->dependent, dependent);
}

void report_parameter_in_size(Sema *s, const Var *v, const AstExpr *e)
{
    Diag *d = diag_report(s->diags, DIAG_parameter_in_size, e->span, s->size_of->text, v->name->text);

    diag_label(s->diags, d, DIAG_label_constant_size, v->name->text);
    scope_note_declared(s, d, e->name);
}

void report_parameter_assigned(Sema *s, const Var *v, Str name, Span span)
{
    Diag *d;

    if (s->in_script) {
        d = diag_report(s->diags, DIAG_parameter_in_script, span, name->text);
        diag_label(s->diags, d, DIAG_label_parameter_set, v->name->text);
    } else
        d = diag_report(s->diags, DIAG_parameter_assigned, span, name->text);
    scope_note_declared(s, d, name);
}

// ---- a definition instead of a local ----

// Returns the declaration of the local, found by the position of its name, or NULL.
static const AstDecl *find_declaration(const AstFile *sm, const Var *local)
{
    for (size_t i = 0; i < sm->sections.n; i++)
        for (size_t k = 0; k < sm->sections.at[i]->decls.n; k++)
            if (sm->sections.at[i]->decls.at[k].name_span.at == local->span.at)
                return &sm->sections.at[i]->decls.at[k];
    return NULL;
}

// Returns the position of the first section of states, before which definitions can be inserted.
static Span position_before_states(const AstFile *sm)
{
    for (size_t i = 0; i < sm->sections.n; i++)
        if (sm->sections.at[i]->kind == AST_STATE || sm->sections.at[i]->kind == AST_ALL_STATES)
            return (Span){sm->src, sm->sections.at[i]->header.at, 0};
    return (Span){sm->src, sm->src->len, 0};
}

// Returns the part of the source with this declaration; its whole line if nothing else is on it.
static Span span_of_declaration(const AstDecl *decl)
{
    const Source *src = decl->name_span.src;
    const Span last = decl->annotations.n > 0 ? decl->annotations.at[decl->annotations.n - 1].span : decl->value->span;
    const uint32_t first = decl->type_span.at, after = last.at + last.len;
    uint32_t from = first, to = after;

    while (from > 0 && (src->text[from - 1] == ' ' || src->text[from - 1] == '\t'))
        from--;
    while (to < src->len && (src->text[to] == ' ' || src->text[to] == '\t' || src->text[to] == '\r'))
        to++;
    if ((from == 0 || src->text[from - 1] == '\n') && to < src->len && src->text[to] == '\n')
        return (Span){src, from, to + 1 - from};
    return (Span){src, first, after - first};
}

// Whether a definition could replace a local: the local is never assigned, its type does not change the value, and the value is on one line.
static bool could_be_definition(const Var *local, const AstDecl *decl)
{
    const Span value = decl->value->span;

    return local->type == SM_F64 && !local->written && !local->outside && !local->sizes && !local->parameter &&
           decl->annotations.n == has_annotation(&decl->annotations, AST_READ_ONLY) && !memchr(value.src->text + value.at, '\n', value.len);
}

void propose_definitions(Sema *s, const AstFile *sm)
{
    const Var *last = NULL;

    for (size_t i = 0; i < s->dependent.n; i++) {
        const Var *local = s->dependent.at[i].local;
        const AstDecl *decl = find_declaration(sm, local);
        Diag *d = s->dependent.at[i].report;
        if (local == last || !decl || !could_be_definition(local, decl))
            continue;
        diag_edit(s->diags, d, span_of_declaration(decl), "");
        diag_edit(s->diags, d, position_before_states(sm),
                  format_in(s->arena, "[define]\n%s = %.*s\n\n", local->name->text, (int)decl->value->span.len,
                            decl->value->span.src->text + decl->value->span.at));
        last = local;
    }
}

// ---- setting parameters ----

const char *parameter_refusal_text(SmRefusal refusal)
{
    static const char *const text[] = {
        "",
#define REFUSAL(name, text) text,
#include "stdlib/parameters.def"
#undef REFUSAL
    };

    return text[refusal];
}

bool program_has_parameters(const Program *p)
{
    for (size_t i = 0; i < p->var.n; i++)
        if (p->var.at[i]->parameter)
            return true;
    return false;
}

// Returns the program's parameter of this name, or NULL.
const Var *program_parameter(const Program *p, Str name)
{
    const Var *v = map_find(&p->by_name, name);

    return v && v->kind == VAR_LOCAL && v->parameter ? v : NULL;
}

SmRefusal parameter_judge(const Var *parameter, SmF64 x, uint64_t *cell)
{
    const SmParameterRange range = {parameter->type, parameter->parameter->lo, parameter->parameter->hi};
    const SmRefusal refusal = sm_parameter_judge(&range, x);

    if (!refusal)
        *cell = sm_cell_from_f64(parameter->type, x);
    return refusal;
}

// Whether the parameter `name` of p can have the value x; *cell is then the value as a bit cell of its type.  If not, reports why at `span`;
// `shown`: the value in the message.
static bool check_refusal(Sema *s, const Program *p, Str name, Span span, const char *shown, SmF64 x, uint64_t *cell)
{
    const Var *v = program_parameter(p, name);
    const SmRefusal refusal = v ? parameter_judge(v, x, cell) : SM_REFUSAL_UNKNOWN;
    Diag *d;

    if (!refusal)
        return true;
    d = diag_report(s->diags, DIAG_parameter_refused, span, name->text, shown, parameter_refusal_text(refusal));
    if (v && v->type != SM_BOOL)
        diag_label(s->diags, d, DIAG_label_parameter_values, const_text(s->arena, v->parameter->lo), const_text(s->arena, v->parameter->hi));
    if (v)
        diag_note(s->diags, d, v->span, DIAG_note_declared_here, v->name->text);
    return false;
}

// Sets *x to the value of a number or a time, with or without signs, or of true or false.  Anything else is NaN, which every parameter refuses.
static void read_value(Sema *s, const AstExpr *e, SmF64 *x)
{
    bool negative = false;

    for (; e->kind == AST_UNARY && (e->op == SM_OP_NEG || e->op == SM_OP_PLUS); e = e->a)
        negative ^= e->op == SM_OP_NEG;
    *x = e->kind != AST_NUMBER ? sm_from_bits(UINT64_C(0x7ff8000000000000)) : e->unit ? check_time_literal(s, e) : e->number;
    if (negative)
        *x = sm_neg(*x);
}

bool check_parameter_value(Sema *s, const Program *p, Str name, Span name_span, const AstExpr *value, uint64_t *cell)
{
    const Span span = program_parameter(p, name) ? value->span : name_span;
    SmF64 x;

    read_value(s, value, &x);
    return check_refusal(s, p, name, span, sm_is_nan(x) ? sema_quote_source(s, value->span) : const_text(s->arena, x), x, cell);
}

bool set_parameter_of_machine(Sema *s, Program *p, Str name, Span name_span, const AstExpr *value)
{
    uint64_t cell;

    if (!check_parameter_value(s, p, name, name_span, value, &cell))
        return false;
    ((Var *)map_find(&p->by_name, name))->init = cell;
    return true;
}
