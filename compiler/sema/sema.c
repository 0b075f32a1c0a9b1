// SPDX-License-Identifier: Apache-2.0
// Begins the check of a machine or script: empty scopes, the functions that exist, what the parser may have lost.
#include "compiler/sema/sema.h"

#include <string.h>

static void add_functions(Sema *s)
{
    for (int i = 0; i < SM_FN_COUNT; i++)
        map_put(&s->functions, str_c(s->strings, sm_builtin_info[i].name), (void *)&sm_builtin_info[i]);
}

void sema_init(Sema *s, const CheckContext *c, const Program *p, Windows *windows)
{
    enum { GUESSES = 30 };        // more than are shown

    memset(s, 0, sizeof *s);
    s->arena = c->arena;
    s->strings = c->strings;
    s->diags = c->diags;
    s->p = p;
    s->windows = windows;
    s->guesses = GUESSES;
    s->functions.arena = s->arena;
    s->unknown_name.arena = s->unknown_state.arena = s->unknown_function.arena = s->arena;
    s->said.arena = s->doubtful.arena = s->place.arena = s->arena;
    add_functions(s);
}

// The section that a place is in; NULL before the first.
static const AstSection *section_at(const AstFile *f, uint32_t at)
{
    size_t low = 0, high = f->sections.n;       // sections before `low` start at or before `at`, those from `high` after

    while (low < high) {
        size_t middle = (low + high) / 2;
        if (f->sections.at[middle]->header.at <= at)
            low = middle + 1;
        else
            high = middle;
    }
    return low ? f->sections.at[low - 1] : NULL;
}

// The last declaration that begins at or before a place; NULL if there is none.
static const AstDecl *decl_at(const AstSection *section, uint32_t at)
{
    size_t low = 0, high = section->decls.n;

    while (low < high) {
        size_t middle = (low + high) / 2;
        if (section->decls.at[middle].type_span.at <= at)
            low = middle + 1;
        else
            high = middle;
    }
    return low ? &section->decls.at[low - 1] : NULL;
}

// A mistake behind a name, on its line, has lost nothing; but behind an @ it may have lost an alias.
static bool keeps_names(const AstSection *section, Span error)
{
    const AstDecl *decl = decl_at(section, error.at);
    const char *c, *end = error.src->text + error.at;

    if (!decl)
        return false;
    for (c = error.src->text + decl->type_span.at; c < end; c++)
        if (*c == '\n' || *c == '@')
            return false;
    return *end != '@';
}

// Whether a mistake may have swallowed a declaration or the name of a section.
static bool may_hide(const AstSection *section, Span error)
{
    if (!section || section->name->len == 0)
        return true;
    switch (section->kind) {
    case AST_STATE_VECTOR: case AST_LOCAL: case AST_REGION:
        return error.at >= section->header.at + section->header.len && !keeps_names(section, error);
    case AST_STATE: case AST_SCRIPT_STATE: case AST_OPTIONS: case AST_IGNORED:
        return false;
    }
    return true;
}

bool sema_lost_names(const Diags *d, const AstFile *f)
{
    for (size_t i = 0; i < d->list.n; i++) {
        const Diag *e = d->list.at[i];
        if (e->severity == DIAG_ERROR && e->span.src == f->src && may_hide(section_at(f, e->span.at), e->span))
            return true;
    }
    return false;
}

Str sema_stem(StrPool *strings, const Source *src)
{
    const char *name = src->name, *end;

    for (const char *c = name; *c; c++)
        if (*c == '/' || *c == '\\')
            name = c + 1;
    end = strrchr(name, '.');
    return str_intern(strings, name, end && end != name ? (size_t)(end - name) : strlen(name));
}
