// SPDX-License-Identifier: Apache-2.0
// @allow (language.md 5): computes which part of the source each annotation covers, and registers it with the diagnostics (diag/allow.c)
// at once, so that it applies even if errors prevent a Program.  The copies in Program.allow are for reports.
#include "compiler/sema/sema.h"

static Span span_from_to(const Source *src, uint32_t at, uint32_t end)
{
    return (Span){src, at, end - at};
}

static uint32_t span_end(Span s) { return s.at + s.len; }

// Describes an `allow` annotation, which suppresses a warning in the source text `covers`.
static Allow make_allow(const AstAnnotation *a, Span covers)
{
    Allow out = {a->name->text, a->reason, a->span, covers};

    return out;
}

// Adds the suppression to the machine that is being built and to the diagnostics.
static void register_allow(Sema *s, Allow a)
{
    vec_push(s->arena, &s->building->allow, a);
    diag_allow(s->diags, a.flag, a.reason->text, a.span, a.covers);
}

// ---- declarations ----

// Returns the text of a declaration from its type to its last annotation.
static Span decl_span(const AstDecl *decl)
{
    Span all = span_join(decl->type_span, decl->name_span);

    if (decl->value)
        all = span_join(all, decl->value->span);
    if (decl->annotations.n)
        all = span_join(all, decl->annotations.at[decl->annotations.n - 1].span);
    return all;
}

void add_sv_allows(const CheckContext *c, StateVec *sv, const AstDecl *decl)
{
    for (size_t i = 0; i < decl->annotations.n; i++) {
        const AstAnnotation *a = &decl->annotations.at[i];
        if (a->kind != AST_ALLOW)
            continue;
        vec_push(c->arena, &sv->allow, make_allow(a, decl_span(decl)));
        diag_allow_shared(c->diags, a->name->text, a->reason->text, a->span, decl_span(decl));
    }
}

void add_decl_allows(Sema *s, const AstDecl *decl)
{
    for (size_t i = 0; i < decl->annotations.n; i++)
        if (decl->annotations.at[i].kind == AST_ALLOW)
            register_allow(s, make_allow(&decl->annotations.at[i], decl_span(decl)));
}

void add_definition_allows(Sema *s, const AstDefinition *in)
{
    for (size_t i = 0; s->building && i < in->annotations.n; i++)
        if (in->annotations.at[i].kind == AST_ALLOW)
            register_allow(s, make_allow(&in->annotations.at[i], span_join(in->name_span, in->annotations.at[i].span)));
}

// Registers the annotations of an element in the .sv for the position where a machine lists the element.
void add_listed_allows(Sema *s, const Element *e, const AstDecl *listed)
{
    for (uint32_t i = 0; i < e->allows; i++) {
        Allow a = s->sv->allow.at[e->first_allow + i];
        a.covers = decl_span(listed);
        vec_push(s->arena, &s->building->allow, a);
        diag_allow_shared(s->diags, a.flag, a.reason->text, a.span, a.covers);
    }
}

// ---- states and statements ----

// Registers the annotations after the header of a state.  `end` is the end of its section.
void add_state_allows(Sema *s, const AstSection *section, uint32_t end)
{
    for (size_t i = 0; i < section->annotations.n; i++)
        if (section->annotations.at[i].kind == AST_ALLOW)
            register_allow(s, make_allow(&section->annotations.at[i], span_from_to(section->header.src, section->header.at, end)));
}

// Returns the end position of a conditional, including all its branches.
static uint32_t conditional_end(const AstStmt *s)
{
    while (s->arms->has_else && !s->arms->else_body_span.src && s->arms->otherwise.n)           // the body is an `else if`
        s = s->arms->otherwise.at[0];
    return span_end(s->arms->has_else && s->arms->else_body_span.src ? s->arms->else_body_span : s->arms->body_span);
}

void add_stmt_allow(Sema *s, const AstAnnotation *a, const AstStmt *stmt)
{
    uint32_t end = stmt->kind == AST_IF && stmt->arms->body_span.src ? conditional_end(stmt) : span_end(stmt->span);

    register_allow(s, make_allow(a, span_from_to(a->span.src, a->span.at, end)));
}
