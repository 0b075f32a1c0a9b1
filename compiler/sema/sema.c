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

static bool holds_code(const AstSection *section, uint32_t at)
{
    return section && (section->kind == AST_STATE || section->kind == AST_SCRIPT_STATE)
           && at >= section->header.at + section->header.len;
}

bool sema_lost_names(const Diags *d, const AstFile *f)
{
    for (size_t i = 0; i < d->list.n; i++) {
        const Diag *e = d->list.at[i];
        if (e->severity == DIAG_ERROR && e->span.src == f->src && !holds_code(section_at(f, e->span.at), e->span.at))
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
