// SPDX-License-Identifier: Apache-2.0
// Definitions that were changed.  What they change is reported where they are used, so the definition itself is a note.
#include <string.h>

#include "compiler/diff/diff_part.h"

static const char *value_text(Arena *arena, const Define *d)
{
    return format_in(arena, "%.*s", (int)d->value_span.len, d->value_span.src->text + d->value_span.at);
}

// Returns the definition of p with the same name, or NULL.
static const Define *find_define(const Program *p, const Define *like)
{
    for (size_t i = 0; i < p->define.n; i++)
        if (strcmp(p->define.at[i]->name->text, like->name->text) == 0)
            return p->define.at[i];
    return NULL;
}

void diff_compare_defines(ProgramDiff *d)
{
    const Program *p = d->old.p, *q = d->new.p;

    for (int side = 0; side < 2; side++)
        for (size_t i = 0; i < (side ? q : p)->define.n; i++) {
            const Define *a = (side ? q : p)->define.at[i], *b = find_define(side ? p : q, a);
            DiffChange c = {.part = DIFF_VARIABLE, .how = b ? DIFF_CHANGED : side ? DIFF_ADDED : DIFF_REMOVED, .weight = DIFF_NOTE};
            if (b && (side || strcmp(value_text(d->arena, a), value_text(d->arena, b)) == 0))
                continue;
            c.what = format_in(d->arena, "definition %s", a->name->text);
            c.old = side ? NULL : value_text(d->arena, a);
            c.new = side ? value_text(d->arena, a) : b ? value_text(d->arena, b) : NULL;
            diff_add(d, c);
        }
}

// Whether definition e is used in the range s of the source, directly or inside other definitions.  left: how many more levels of definitions inside
// definitions are followed.
static bool is_used_in(const Define *e, Span s, size_t left)
{
    for (size_t i = 0; i < e->use.n; i++) {
        const DefineUse *u = &e->use.at[i];
        if (u->inside ? left > 0 && is_used_in(u->inside, s, left - 1) : u->span.src == s.src && u->span.at >= s.at && u->span.at < s.at + s.len)
            return true;
    }
    return false;
}

// Returns why a statement with the same text means something else in the new machine: the changed definitions that it uses.
const char *diff_describe_defines(ProgramDiff *d, const Stmt *stmt, const Condition *when)
{
    const Program *p = d->old.p;
    Buf out;

    buf_init(&out, d->arena);
    for (size_t i = 0; i < p->define.n; i++) {
        const Define *a = p->define.at[i], *b = find_define(d->new.p, a);
        bool used = is_used_in(a, stmt->span, p->define.n);
        for (const Condition *c = when; c && !used; c = c->outer)
            used = is_used_in(a, c->stmt->value->span, p->define.n);
        if (used && b && strcmp(value_text(d->arena, a), value_text(d->arena, b)) != 0)
            buf_printf(&out, "%s'%s' was %s and is %s", out.n ? "; " : "written as before, but ", a->name->text, value_text(d->arena, a),
                       value_text(d->arena, b));
    }
    return out.n ? buf_text(&out) : "written as before, but a name in it means something else";
}
