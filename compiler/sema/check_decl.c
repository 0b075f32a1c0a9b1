// SPDX-License-Identifier: Apache-2.0
// [state_vector] and [local] of a machine: builds its variables (language.md 5).  Checks that each name has one meaning, that
// listed elements agree with the state vector, and that G and S exist.  Computes initial values.
#include "compiler/sema/sema.h"

#include <string.h>

#include "stdlib/convert.h"
#include "stdlib/math.h"

typedef struct LocalDecl { Var *var; const AstDecl *decl; } LocalDecl;

// The check of the declarations of one machine.
typedef struct Declarations {
    Sema *s;
    Program *p;
    StateVec *sv;                 // the state vector; without a .sv, the machine's own elements are added to it
    const Map *written_outside;
    const MachineInstance *instance;      // how the machine differs from its file; or NULL
    VEC(LocalDecl) local;         // the locals, with their declarations
    Str time;                     // the interned name "T"
    const AstSection *list;       // the machine's [state_vector] section, or NULL
} Declarations;

// ---- one name, one meaning ----

// Binds `name` to v.  Reports the name if it already has a meaning.
static void declare_name(Declarations *k, Var *v, Str name, Span span)
{
    if (name == k->time) {
        diag_report(k->s->diags, DIAG_time_declared, span);
        map_put(&k->s->doubtful, name, (void *)name);
    } else if (map_find(&k->p->by_name, name)) {
        const Var *first = map_find(&k->p->by_name, name);
        const char *what = first->kind == VAR_LOCAL ? "a local" : first->alias == name && first->name != name ? "an alias" : "an element";
        bool same_element = v->kind == VAR_ELEMENT && first->kind == VAR_ELEMENT && v->name == name && first->name == name;
        Diag *d = same_element ? diag_report(k->s->diags, DIAG_element_listed_twice, span, name->text)
                               : diag_report(k->s->diags, DIAG_name_taken, span, name->text, what);

        scope_note_declared(k->s, d, name);
        map_put(&k->s->doubtful, name, (void *)name);
    } else {
        Span *place = ARENA_NEW(k->s->arena, Span);
        *place = span;
        map_put(&k->s->declared_at, name, place);
        map_put(&k->p->by_name, name, v);
    }
}

// ---- annotations ----

// Whether a declaration has a valid type.  If not, the parser has already reported it.
static bool is_known_type(SmType type)
{
    return type < SM_TYPE_COUNT;
}

bool has_annotation(const AstAnnotations *all, AstAnnotationKind kind)
{
    for (size_t i = 0; i < all->n; i++)
        if (all->at[i].kind == kind)
            return true;
    return false;
}

// Returns a new variable for a declaration, without index, element and initial value.
Var *sema_new_var(Sema *s, VarKind kind, const AstDecl *decl)
{
    const CheckContext c = {.arena = s->arena, .strings = s->strings, .diags = s->diags};
    Var *v = ARENA_NEW(s->arena, Var);

    v->kind = kind;
    v->name = v->report_name = decl->name;
    v->type = is_known_type(decl->type) ? decl->type : SM_F64;
    v->span = decl->name_span;
    if (!is_known_type(decl->type))
        map_put(&s->doubtful, decl->name, (void *)decl->name);
    v->read_only = has_annotation(&decl->annotations, AST_READ_ONLY);
    v->unit = check_unit(&c, &decl->annotations, v->name, v->type == SM_BOOL);
    s->has_units |= v->unit != NULL;
    return v;
}

static void add_alias(Declarations *k, Var *v, const AstAnnotation *a)
{
    if (!a->name || v->alias)
        return;                   // the parser has reported an error in the annotation
    if (a->name == v->name) {
        diag_report(k->s->diags, DIAG_alias_own_name, a->span, v->name->text);
        return;
    }
    v->alias = a->name;
    if (strcmp(v->alias->text, v->name->text) < 0)
        v->report_name = v->alias;
    declare_name(k, v, a->name, a->name_span);
}

// ---- @range ----

// Reports the lower or upper limit of a @range if the element's type cannot represent it.
static void check_range_limit(const CheckContext *c, const AstAnnotation *a, SmF64 limit, Str name, SmType type)
{
    const SmF64 stored = sm_cell_to_f64(type, sm_cell_from_f64(type, sm_trunc(limit)));

    if (sm_type_info[type].kind != SM_KIND_FLOAT && !sm_eq(stored, sm_trunc(limit)))
        diag_report(c->diags, DIAG_range_beyond_type, a->span, name->text, const_text(c->arena, limit), sm_type_info[type].spelling,
                    const_text(c->arena, stored));
}

// Returns the @range among the annotations of an element; NULL if no annotation is a @range, or if the range is invalid, which is reported.
const Range *check_range(const CheckContext *c, const AstAnnotations *all, Str name, SmType type)
{
    Range *r = NULL;

    for (size_t i = 0; i < all->n; i++) {
        const AstAnnotation *a = &all->at[i];
        if (a->kind != AST_RANGE)
            continue;
        if (type == SM_BOOL) {
            diag_report(c->diags, DIAG_range_of_bool, a->span, name->text);
        } else if (sm_lt(a->hi.value, a->lo.value)) {
            diag_label(c->diags, diag_report(c->diags, DIAG_range_empty, a->span, name->text, const_text(c->arena, a->lo.value),
                                             const_text(c->arena, a->hi.value)), DIAG_label_range_form);
        } else {
            check_range_limit(c, a, a->lo.value, name, type);
            check_range_limit(c, a, a->hi.value, name, type);
            r = ARENA_NEW(c->arena, Range);
            *r = (Range){a->lo.value, a->hi.value, a->span};
        }
    }
    return r;
}

// Sets the range of v to the @range in the machine's list, or else to the @range in the .sv.  Reports a @range in the list that differs
// from that in the .sv.
static void set_range(Declarations *k, Var *v, const AstDecl *decl)
{
    const CheckContext c = {.arena = k->s->arena, .strings = k->s->strings, .diags = k->s->diags};
    Diag *d;

    v->range = check_range(&c, &decl->annotations, v->name, v->type);
    if (!v->element)
        return;
    if (k->sv->from_machine)
        v->element->range = v->range;
    else if (!v->range)
        v->range = v->element->range;
    else if (v->element->range && (!sm_eq(v->range->lo, v->element->range->lo) || !sm_eq(v->range->hi, v->element->range->hi))) {
        d = diag_report(k->s->diags, DIAG_range_differs, v->range->span, v->name->text);
        diag_note(k->s->diags, d, v->element->range->span, DIAG_note_range_in_sv);
    }
}

// ---- elements ----

// Whether a declaration declares G or S, by name or alias, with the type that the language requires.
static bool is_g_or_s(const AstDecl *decl)
{
    const char *name = decl->name->text;

    for (size_t i = 0; i < decl->annotations.n; i++)
        if (decl->annotations.at[i].kind == AST_ALIAS && decl->annotations.at[i].name)
            name = decl->annotations.at[i].name->text;
    return (strcmp(name, "G") == 0 && decl->type == SM_U64) || (strcmp(name, "S") == 0 && decl->type == SM_U32);
}

// Returns the element that a declaration lists; NULL if the .sv does not have it.  Reports a missing element and a type that differs.
static Element *find_element(Declarations *k, const AstDecl *decl)
{
    Element *e = map_find(&k->sv->by_name, decl->name);
    Diag *d;

    if (!e && k->instance && k->instance->lost)
        return NULL;                  // the element may be bound by a binding that had an error
    if (!e) {
        d = diag_report(k->s->diags, DIAG_element_not_in_vector, decl->name_span, decl->name->text);
        suggest_element(k->s->diags, d, &k->s->guesses, k->sv, decl->name);
        if (k->instance && k->instance->span.src)
            diag_note(k->s->diags, d, k->instance->span, DIAG_note_bind_it, k->instance->name->text, decl->name->text);
    } else if (e->type != decl->type && is_known_type(decl->type) && !e->untyped) {
        d = diag_report(k->s->diags, DIAG_element_other_type, decl->type_span, e->name->text,
                        sm_type_info[e->type].spelling, sm_type_info[decl->type].spelling);
        if (is_g_or_s(decl))
            diag_label(k->s->diags, d, DIAG_label_type_of_special, sm_type_info[decl->type].spelling);
        else
            diag_label(k->s->diags, d, DIAG_label_write_type, sm_type_info[e->type].spelling);
        diag_note(k->s->diags, d, e->span, DIAG_note_declared_here, e->name->text);
    }
    return e;
}

// Adds an element to a state vector that is declared in the machine's own file.
static Element *add_element(Declarations *k, const AstDecl *decl)
{
    Element *e = ARENA_NEW(k->s->arena, Element);

    e->name = decl->name;
    e->type = is_known_type(decl->type) ? decl->type : SM_F64;
    e->region = k->sv->region.at[0];
    e->region->count++;
    e->span = decl->name_span;
    e->index = (uint32_t)k->sv->element.n;
    vec_push(k->s->arena, &k->sv->element, e);
    map_put(&k->sv->by_name, e->name, e);
    return e;
}

static void declare_element(Declarations *k, const AstDecl *decl)
{
    const AstBinding *bound = find_binding(k->instance, decl);
    Var *v = sema_new_var(k->s, VAR_ELEMENT, decl);

    v->element = k->sv->from_machine ? add_element(k, decl) : bound ? find_bound_element(k->s, k->sv, decl, bound) : find_element(k, decl);
    declare_name(k, v, v->name, v->span);
    set_range(k, v, decl);
    set_listed_unit(k->s, v, decl, k->sv->from_machine);
    v->command = has_annotation(&decl->annotations, AST_COMMAND) || (v->element && v->element->command);
    add_decl_allows(k->s, decl);
    if (v->element && !k->sv->from_machine)
        add_listed_allows(k->s, v->element, decl);
    for (size_t i = 0; i < decl->annotations.n; i++)
        if (decl->annotations.at[i].kind == AST_ALIAS)
            add_alias(k, v, &decl->annotations.at[i]);
    vec_push(k->s->arena, &k->p->var, v);
}

// ---- locals ----

static void warn_of_local_like_element(Declarations *k, const Var *v)
{
    const Element *e = map_find(&k->sv->by_name, v->name);
    Diag *d;

    if (k->sv->from_machine || !e || map_find(&k->p->by_name, v->name) != v)
        return;
    d = diag_report(k->s->diags, DIAG_local_like_element, v->span, v->name->text);
    diag_note(k->s->diags, d, e->span, DIAG_note_declared_here, e->name->text);
}

static void declare_local(Declarations *k, const AstDecl *decl)
{
    LocalDecl l = {sema_new_var(k->s, VAR_LOCAL, decl), decl};

    l.var->parameter = check_parameter(k->s, l.var, decl);
    l.var->read_only |= l.var->parameter != NULL;
    l.var->outside = !l.var->parameter && k->written_outside && map_find(k->written_outside, decl->name);
    l.var->is_constant = l.var->read_only && !l.var->outside && !l.var->parameter;
    declare_name(k, l.var, l.var->name, l.var->span);
    add_decl_allows(k->s, decl);
    vec_push(k->s->arena, &k->local, l);
}

// Completes Program.var and numbers it: locals follow the elements, T follows the locals.
static void number_variables(Declarations *k)
{
    Var *t = ARENA_NEW(k->s->arena, Var);

    for (size_t i = 0; i < k->local.n; i++) {
        vec_push(k->s->arena, &k->p->var, k->local.at[i].var);
        warn_of_local_like_element(k, k->local.at[i].var);
    }
    t->kind = VAR_TIME;
    t->name = t->report_name = k->time;
    t->type = SM_U64;
    t->read_only = true;
    vec_push(k->s->arena, &k->p->var, t);
    map_put(&k->p->by_name, k->time, t);
    k->p->t = t;
    for (size_t i = 0; i < k->p->var.n; i++)
        k->p->var.at[i]->index = (uint32_t)i;
}

static void compute_initial_values(Declarations *k)
{
    Sema *s = k->s;

    s->no_value = ARENA_ARRAY(s->arena, bool, k->p->var.n);
    s->at = EXPR_IN_INITIAL;
    for (size_t i = 0; i < k->local.n; i++) {
        Var *v = k->local.at[i].var;
        const AstExpr *value = k->local.at[i].decl->value;
        Expr *e;

        s->local = v;
        e = value ? check_expr(s, value) : NULL;
        v->init_value = e;
        s->no_value[v->index] = !e;
        if (e && v->parameter)
            check_default(s, v, expr_constant_value(e));
        else if (e)
            v->init = sm_cell_from_f64(v->type, expr_constant_value(e));
    }
    s->at = EXPR_IN_STEP;
}

// ---- G and S ----

// Returns the variable named G or S after checking its type; NULL if it is missing, which is reported.
static Var *find_g_or_s(Declarations *k, const char *name, SmType type, DiagCode missing, DiagCode wrong)
{
    Str key = str_c(k->s->strings, name);
    Var *v = map_find(&k->p->by_name, key);
    bool is_reported;             // [state_vector] has another type than the .sv, whose type is right: already reported as E0206

    if (!v && !k->s->lost->names)
        diag_report(k->s->diags, missing, k->list->header);
    if (!v || scope_is_doubtful(k->s, key) || scope_is_doubtful(k->s, v->name))
        return v;
    is_reported = v->element && v->element->type == type;
    if ((v->kind != VAR_ELEMENT || v->type != type) && !is_reported)
        diag_report(k->s->diags, wrong, v->span, v->kind == VAR_ELEMENT ? sm_type_info[v->type].spelling : "a local");
    v->read_only = true;
    return v;
}

static void find_g_and_s(Declarations *k)
{
    bool any = k->p->var.n > k->local.n + 1;       // the machine lists an element, because it has more variables than locals and T

    if (any && k->list) {
        k->p->g = find_g_or_s(k, "G", SM_U64, DIAG_no_global_time, DIAG_global_time_type);
        k->p->s = find_g_or_s(k, "S", SM_U32, DIAG_no_state_element, DIAG_state_element_type);
        if (k->p->s)
            k->p->s->state_of = k->p;
    } else if (!k->s->lost->names) {
        k->s->no_elements = true;
        diag_report(k->s->diags, DIAG_no_elements, k->list ? k->list->header : (Span){k->p->src, 0, 0});
    }
}

// ---- entry points ----

// Checks the [state_vector] and [local] sections of a machine, and builds its variables.
void check_declarations(Sema *s, Program *p, const AstFile *sm, StateVec *sv, const Map *written_outside, const MachineInstance *instance)
{
    Declarations k;

    memset(&k, 0, sizeof k);
    k.s = s;
    k.p = p;
    k.sv = sv;
    k.written_outside = written_outside;
    k.instance = instance;
    k.time = str_c(s->strings, "T");
    for (size_t i = 0; i < sm->sections.n; i++) {
        const AstSection *section = sm->sections.at[i];
        if (section->kind == AST_STATE_VECTOR)
            k.list = section;
        for (size_t j = 0; j < section->decls.n; j++)
            if (section->kind == AST_STATE_VECTOR)
                declare_element(&k, &section->decls.at[j]);
            else if (section->kind == AST_LOCAL)
                declare_local(&k, &section->decls.at[j]);
    }
    number_variables(&k);
    for (size_t i = 0; i < sm->sections.n; i++)
        if (sm->sections.at[i]->kind == AST_DEFINE)
            declare_definitions(s, sm->sections.at[i], &p->define);
    find_g_and_s(&k);
    compute_initial_values(&k);
    if (instance)
        check_bindings(s, p, instance);
}
