// SPDX-License-Identifier: Apache-2.0
// The bindings of a machine that uses elements of the state vector under its own names (docs/config.md 10.29 to 10.32).
#include "compiler/sema/sema.h"

// ---- one declaration ----

// Returns the binding of the machine instance for a name of the machine, or NULL.
static const AstBinding *find_by_name(const MachineInstance *instance, Str name)
{
    for (size_t i = 0; name && i < instance->bindings; i++)
        if (instance->binding[i].name.text == name)
            return &instance->binding[i];
    return NULL;
}

const AstBinding *find_binding(const MachineInstance *instance, const AstDecl *decl)
{
    const AstBinding *b = instance ? find_by_name(instance, decl->name) : NULL;

    for (size_t i = 0; instance && !b && i < decl->annotations.n; i++)
        if (decl->annotations.at[i].kind == AST_ALIAS)
            b = find_by_name(instance, decl->annotations.at[i].name);
    return b;
}

static void report_type(Sema *s, const StateVec *sv, const AstDecl *decl, const AstBinding *b, const Element *e)
{
    Diag *d = diag_report(s->diags, DIAG_binding_type, b->element.span, b->name.text->text, sm_type_info[decl->type].spelling, e->name->text,
                          sm_type_info[e->type].spelling);
    Guess g = guess_init(e->name);

    for (size_t i = 0; i < sv->element.n; i++)
        if (sv->element.at[i]->type == decl->type)
            guess_consider(&g, sv->element.at[i]->name);
    guess_add_label(s->diags, d, &g);
    diag_note(s->diags, d, e->span, DIAG_note_declared_here, e->name->text);
    diag_note(s->diags, d, decl->name_span, DIAG_note_declared_here, decl->name->text);
}

// Returns the element to which the declaration is bound; NULL after a report.
Element *find_bound_element(Sema *s, const StateVec *sv, const AstDecl *decl, const AstBinding *b)
{
    Element *e = b->element.text ? map_find(&sv->by_name, b->element.text) : NULL;
    Diag *d;

    if (!b->element.text) {
        d = diag_report(s->diags, DIAG_binding_value, b->value->span, b->name.text->text);
        diag_note(s->diags, d, decl->name_span, DIAG_note_declared_here, decl->name->text);
    } else if (!e) {
        d = diag_report(s->diags, DIAG_unknown_element, b->element.span, b->element.text->text);
        suggest_element(s->diags, d, &s->guesses, sv, b->element.text);
    } else if (e->type != decl->type && decl->type < SM_TYPE_COUNT && !e->untyped) {
        report_type(s, sv, decl, b, e);
    }
    return e;
}

// ---- all bindings ----

// Sets a parameter of one instance to a value. No other local can be set.
static void bind_local(Sema *s, Program *p, const Var *v, const AstBinding *b)
{
    Diag *d;

    if (v->parameter) {
        set_parameter_of_machine(s, p, b->name.text, b->name.span, b->value);
        return;
    }
    d = diag_report(s->diags, DIAG_binding_local, b->name.span, v->name->text, v->kind == VAR_TIME ? "the time in the state" : "a local");
    if (v->span.src)
        diag_note(s->diags, d, v->span, DIAG_note_declared_here, v->name->text);
}

// Reports `fireDrogue = fire`, whose sides are exchanged. Returns false if they are not.
static bool report_exchanged_sides(Sema *s, const Program *p, const AstBinding *b)
{
    const Var *v = b->element.text ? map_find(&p->by_name, b->element.text) : NULL;
    const char *text;
    Diag *d;

    if (!v || v->kind != VAR_ELEMENT || !map_find(&p->sv->by_name, b->name.text))
        return false;
    text = format_in(s->arena, "%s = %s", b->element.text->text, b->name.text->text);
    d = diag_report(s->diags, DIAG_binding_unknown, b->name.span, p->name->text, b->name.text->text);
    diag_label(s->diags, d, DIAG_label_write, text);
    diag_edit(s->diags, d, b->span, text);
    return true;
}

static void report_unknown_name(Sema *s, const Program *p, const AstBinding *b)
{
    Diag *d = diag_report(s->diags, DIAG_binding_unknown, b->name.span, p->name->text, b->name.text->text);
    Guess g = guess_init(b->name.text);

    for (size_t i = 0; i < p->var.n; i++) {
        const Var *v = p->var.at[i];
        if (v->kind != VAR_ELEMENT && !v->parameter)
            continue;
        guess_consider(&g, v->name);
        if (v->alias)
            guess_consider(&g, v->alias);
    }
    guess_add_label(s->diags, d, &g);
    if (g.best)
        scope_note_declared(s, d, g.best);
}

// Reports two variables of the machine for one element of the state vector. At least one of them is bound to it.
static void check_elements_differ(Sema *s, const Program *p, const MachineInstance *instance, const Var **bound_by)
{
    Map first = {s->arena, NULL, NULL, 0, 0};

    for (size_t i = 0; i < p->var.n; i++) {
        const Var *v = p->var.at[i], *other;
        if (v->kind != VAR_ELEMENT || !v->element)
            continue;
        if ((other = map_find(&first, v->element->name)) == NULL) {
            map_put(&first, v->element->name, (void *)(size_t)v);
            continue;
        }
        for (size_t b = instance->bindings; b-- > 0; )
            if (bound_by[b] == v || bound_by[b] == other) {
                Diag *d = diag_report(s->diags, DIAG_binding_shared, instance->binding[b].span, other->name->text, v->name->text,
                                      v->element->name->text);
                diag_note(s->diags, d, v->element->span, DIAG_note_declared_here, v->element->name->text);
                break;
            }
    }
}

// Checks the left sides of all bindings, when the machine's variables are complete.
void check_bindings(Sema *s, Program *p, const MachineInstance *instance)
{
    const Var **bound_by = ARENA_ARRAY(s->arena, const Var *, instance->bindings);

    for (size_t i = 0; i < instance->bindings; i++) {
        const AstBinding *b = &instance->binding[i];
        const Var *v = map_find(&p->by_name, b->name.text);
        size_t first = 0;

        while (first < i && (!v || bound_by[first] != v))
            first++;
        bound_by[i] = v;
        if (!v && !s->lost->names && !map_find(&s->lost->word, b->name.text) && !report_exchanged_sides(s, p, b))
            report_unknown_name(s, p, b);
        else if (v && first < i)
            diag_note(s->diags, diag_report(s->diags, DIAG_binding_twice, b->span, b->name.text->text), instance->binding[first].span,
                      DIAG_note_first_here);
        else if (v && v->kind != VAR_ELEMENT)
            bind_local(s, p, v, b);
    }
    check_elements_differ(s, p, instance, bound_by);
}
