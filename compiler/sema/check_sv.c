// SPDX-License-Identifier: Apache-2.0
// Checks a state vector file (language.md 4) and builds a StateVec: names are unique, regions are not empty, all offsets are
// computed.
#include "compiler/sema/sema.h"

typedef struct SvCheck {
    const CheckContext *c;
    StateVec *sv;
    Map region_by_name;
} SvCheck;

static void check_element(SvCheck *k, Region *r, const AstDecl *decl)
{
    const Element *first = map_find(&k->sv->by_name, decl->name);
    Element *e = ARENA_NEW(k->c->arena, Element);

    if (first) {
        Diag *d = diag_report(k->c->diags, DIAG_element_twice, decl->name_span, decl->name->text);
        diag_note(k->c->diags, d, first->span, DIAG_note_declared_here, first->name->text);
        return;
    }
    e->name = decl->name;
    e->untyped = decl->type == SM_TYPE_COUNT;
    e->type = e->untyped ? SM_F64 : decl->type;
    e->region = r;
    e->span = decl->name_span;
    e->first_allow = (uint32_t)k->sv->allow.n;
    add_sv_allows(k->c, k->sv, decl);
    e->allows = (uint32_t)k->sv->allow.n - e->first_allow;
    e->range = check_range(k->c, &decl->annotations, e->name, e->type);
    e->unit = check_unit(k->c, &decl->annotations, e->name, e->type == SM_BOOL);
    e->command = has_annotation(&decl->annotations, AST_COMMAND);
    e->index = (uint32_t)k->sv->element.n;
    vec_push(k->c->arena, &k->sv->element, e);
    map_put(&k->sv->by_name, e->name, e);
    r->count++;
}

static void check_region(SvCheck *k, const AstSection *section, bool names_lost)
{
    const Region *first = map_find(&k->region_by_name, section->name);
    Region *r = ARENA_NEW(k->c->arena, Region);

    r->name = section->name;
    r->span = section->name_span;
    r->first = (uint32_t)k->sv->element.n;
    vec_push(k->c->arena, &k->sv->region, r);
    if (first && section->name->len > 0) {      // the parser sets an empty name if it could not read the header
        Diag *d = diag_report(k->c->diags, DIAG_region_twice, section->name_span, section->name->text);
        diag_note(k->c->diags, d, first->span, DIAG_note_declared_here, first->name->text);
    } else
        map_put(&k->region_by_name, section->name, r);
    if (section->decls.n == 0 && !names_lost)
        diag_report(k->c->diags, DIAG_region_empty, section->header, section->name->text);
    for (size_t i = 0; i < section->decls.n; i++)
        check_element(k, r, &section->decls.at[i]);
}

StateVec *check_state_vector(CheckContext *c, const AstFile *f)
{
    size_t errors = c->diags->errors_seen;
    bool names_lost = find_hidden_names(c, f)->names;
    SvCheck k = {c, ARENA_NEW(c->arena, StateVec), {c->arena, NULL, NULL, 0, 0}};
    const Str lock = str_c(c->strings, "lock");

    k.sv->name = sema_file_stem(c->strings, f->src);
    k.sv->by_name.arena = c->arena;
    for (size_t i = 0; i < f->sections.n; i++) {
        const AstSection *section = f->sections.at[i];
        if (section->kind == AST_REGION)
            check_region(&k, section, names_lost);
        else if (section->kind == AST_OPTIONS)
            for (size_t o = 0; o < section->options.n; o++)
                if (section->options.at[o].name == lock)
                    k.sv->lock = true;
    }
    if (k.sv->region.n == 0 && !names_lost)
        diag_report(c->diags, DIAG_no_region, (Span){f->src, 0, 0});
    if (c->diags->errors_seen > errors)
        return NULL;
    layout_state_vector(k.sv);
    return k.sv;
}
