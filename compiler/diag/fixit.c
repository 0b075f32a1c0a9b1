// SPDX-License-Identifier: Apache-2.0
// Applies the edits that diagnostics propose. The edits of one diagnostic belong together: either all are applied or none.
#include <stdlib.h>
#include <string.h>

#include "compiler/diag/diag.h"

typedef struct EditChange {
    const DiagEdit *edit;
    size_t owner;             // index of its diagnostic
    size_t order;             // in the order of the calls of diag_edit
} EditChange;

typedef VEC(EditChange) EditChanges;

// Orders edits by position; edits at the same position by the order of the calls of diag_edit.
static int compare_changes(const void *a, const void *b)
{
    const EditChange *x = a, *y = b;

    if (x->edit->span.at != y->edit->span.at)
        return x->edit->span.at < y->edit->span.at ? -1 : 1;
    return x->order < y->order ? -1 : 1;
}

// Returns the edits of `src` in file order. A diagnostic that also edits another file contributes none.
static EditChanges collect_changes(const Diags *d, const Source *src)
{
    EditChanges all = {0};

    for (size_t i = 0; i < d->list.n + d->folded.n; i++) {
        const Diag *x = i < d->list.n ? d->list.at[i] : d->folded.at[i - d->list.n];
        bool elsewhere = false;
        for (size_t k = 0; k < x->edits.n; k++)
            elsewhere = elsewhere || x->edits.at[k].span.src != src;
        for (size_t k = 0; !elsewhere && k < x->edits.n; k++) {
            EditChange c = {&x->edits.at[k], i, all.n};
            vec_push(d->arena, &all, c);
        }
    }
    if (all.n)
        qsort(all.at, all.n, sizeof *all.at, compare_changes);
    return all;
}

// Sets refused[i] for each diagnostic i with an edit that touches an accepted edit of another diagnostic.
static void refuse_overlaps(const EditChanges *all, bool *refused)
{
    uint32_t end = 0;
    size_t last = 0;
    bool any = false;

    for (size_t i = 0; i < all->n; i++) {
        const Span *s = &all->at[i].edit->span;
        size_t owner = all->at[i].owner;
        if (refused[owner])
            continue;
        if (any && owner != last && (s->at < end || (s->at == end && s->len == 0))) {
            refused[owner] = true;
            continue;
        }
        any = true;
        end = s->at + s->len;
        last = owner;
    }
}

// Appends the text of src with the proposed edits applied.  Edits that touch each other are skipped.  Returns the number of diagnostics
// fixed.
size_t diags_apply_edits(const Diags *d, const Source *src, Buf *out)
{
    EditChanges all = collect_changes(d, src);
    const size_t n = d->list.n + d->folded.n;
    bool *refused = ARENA_ARRAY(d->arena, bool, n + 1), *counted = ARENA_ARRAY(d->arena, bool, n + 1);
    uint32_t at = 0;
    size_t made = 0;

    refuse_overlaps(&all, refused);
    for (size_t i = 0; i < all.n; i++) {
        const DiagEdit *e = all.at[i].edit;
        if (refused[all.at[i].owner])
            continue;
        made += !counted[all.at[i].owner];
        counted[all.at[i].owner] = true;
        buf_put(out, src->text + at, e->span.at - at);
        buf_str(out, e->text);
        at = e->span.at + e->span.len;
    }
    buf_put(out, src->text + at, src->len - at);
    return made;
}
