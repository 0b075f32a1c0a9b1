// SPDX-License-Identifier: Apache-2.0
// Implements @allow: removes warnings that the user has accepted from the list, and reports an @allow that no warning needs. The parts of
// a source that two @allow cover are either nested or disjoint. So one pass over allows and warnings in file order, with a stack of the
// allows that cover the current position, finds the innermost @allow for each warning.
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "compiler/base/str.h"
#include "compiler/diag/diag.h"

// Adds an @allow.  It is reported as unused if no warning needs it.
void diag_allow(Diags *d, const char *flag, const char *reason, Span span, Span covers)
{
    const DiagAllow a = {flag, reason, span, covers, false, false};

    vec_push(d->arena, &d->allow, a);
}

// Adds an @allow that is never reported as unused, because another machine may need it.
void diag_allow_shared(Diags *d, const char *flag, const char *reason, Span span, Span covers)
{
    const DiagAllow a = {flag, reason, span, covers, true, false};

    vec_push(d->arena, &d->allow, a);
}

// ---- order ----

// Orders positions by source, in any fixed order, then by offset. Returns a number below, equal to or above 0.
static int compare_positions(const Span *a, const Span *b)
{
    uintptr_t x = (uintptr_t)a->src, y = (uintptr_t)b->src;

    if (x != y)
        return x < y ? -1 : 1;
    return (a->at > b->at) - (a->at < b->at);
}

// Sorts allows by the start of the text that they cover; if two begin at the same position, the longer comes first.
static int compare_covers(const void *a, const void *b)
{
    const DiagAllow *x = *(DiagAllow *const *)a, *y = *(DiagAllow *const *)b;
    int order = compare_positions(&x->covers, &y->covers);

    return order ? order : (x->covers.len < y->covers.len) - (x->covers.len > y->covers.len);
}

static int compare_spans(const void *a, const void *b)
{
    const DiagAllow *x = *(DiagAllow *const *)a, *y = *(DiagAllow *const *)b;

    return compare_positions(&x->span, &y->span);
}

// A position where an @allow can cover a warning: the warning's own, or a declaration that it names.
typedef struct AllowPosition {
    Diag *diag;
    Span span;
    DiagAllow *by;            // the innermost @allow that covers the position; NULL: none
} AllowPosition;

static int compare_diag_positions(const void *a, const void *b)
{
    const AllowPosition *x = *(AllowPosition *const *)a, *y = *(AllowPosition *const *)b;

    return compare_positions(&x->span, &y->span);
}

// Returns pointers to all @allow, sorted with `compare`.
static DiagAllow **sorted_allows(const Diags *d, int (*compare)(const void *, const void *))
{
    DiagAllow **all = ARENA_ARRAY(d->arena, DiagAllow *, d->allow.n);

    for (size_t i = 0; i < d->allow.n; i++)
        all[i] = &d->allow.at[i];
    qsort(all, d->allow.n, sizeof *all, compare);
    return all;
}

// ---- removing allowed warnings ----

typedef struct AllowWalk {
    DiagAllow **all;          // sorted by compare_covers
    size_t n, next;           // all[next] is the first whose text begins after the current position
    DiagAllow **open;
    size_t depth;
} AllowWalk;

// Whether the text that an @allow covers ends before this position.
static bool has_ended(const DiagAllow *a, const Span *at)
{
    return a->covers.src != at->src || a->covers.at + a->covers.len <= at->at;
}

// Sets x->by to the innermost @allow that covers the position of x.  Must be called for positions in file order: each call advances the stack of
// @allow whose text has begun and not ended.
static void find_innermost_allow(AllowWalk *w, AllowPosition *x)
{
    const char *flag = diag_info[x->diag->code].flag;
    const Span *at = &x->span;

    for (; w->next < w->n && compare_positions(&w->all[w->next]->covers, at) <= 0; w->next++) {
        while (w->depth && has_ended(w->open[w->depth - 1], &w->all[w->next]->covers))
            w->depth--;
        w->open[w->depth++] = w->all[w->next];
    }
    while (w->depth && has_ended(w->open[w->depth - 1], at))
        w->depth--;
    for (size_t i = w->depth; i-- > 0 && !x->by; )
        if (strcmp(w->open[i]->flag, flag) == 0)
            x->by = w->open[i];
}

// Decides whether warning x is allowed. places[0] is the position of the warning; the others are the declarations of variables that it names. A
// warning that names several outputs is allowed only if each of them has an @allow. Even if some have none, the @allow of the others count as used.
static void decide_if_allowed(Diag *x, const AllowPosition *places)
{
    size_t open[DIAG_SUBJECTS] = {0};
    const char *reason[DIAG_SUBJECTS] = {NULL};

    if (places[0].by) {
        places[0].by->used = true;
        x->allowed = places[0].by->reason;
        return;
    }
    for (size_t i = 0; i < x->about.n; i++) {
        DiagAllow *by = places[i + 1].by;
        const DiagSubject subject = x->about.at[i].subject;
        open[subject] += !by;
        if (!by)
            continue;
        by->used = true;
        if (!reason[subject])
            reason[subject] = by->reason;
    }
    for (int s = 0; s < DIAG_SUBJECTS && !x->allowed; s++)
        if (open[s] == 0)
            x->allowed = reason[s];
}

static bool can_be_allowed(const Diag *x) { return x->severity == DIAG_WARNING && diag_info[x->code].flag && !x->allowed && !x->allow_checked; }

// Finds the @allow of each warning in the list, and marks the warnings that are allowed.
static void match_allows(Diags *d)
{
    AllowWalk w = {sorted_allows(d, compare_covers), d->allow.n, 0, ARENA_ARRAY(d->arena, DiagAllow *, d->allow.n), 0};
    AllowPosition *place, **sorted;
    size_t most = 1, n = 0;

    for (size_t i = 0; i < d->list.n; i++)
        most += 1 + d->list.at[i]->about.n;
    place = ARENA_ARRAY(d->arena, AllowPosition, most);
    sorted = ARENA_ARRAY(d->arena, AllowPosition *, most);
    for (size_t i = 0; i < d->list.n; i++) {
        Diag *x = d->list.at[i];
        if (!can_be_allowed(x))
            continue;
        place[n++] = (AllowPosition){x, x->span, NULL};
        for (size_t k = 0; k < x->about.n; k++)
            place[n++] = (AllowPosition){x, x->about.at[k].span, NULL};
    }
    for (size_t i = 0; i < n; i++)
        sorted[i] = &place[i];
    qsort(sorted, n, sizeof *sorted, compare_diag_positions);
    for (size_t i = 0; i < n; i++)
        find_innermost_allow(&w, sorted[i]);
    for (size_t i = 0; i < n; i += 1 + place[i].diag->about.n)
        decide_if_allowed(place[i].diag, &place[i]);
}

// ---- unused @allow ----

// Returns the annotation with the spaces before it, or the whole line if it contains nothing else.
static Span span_to_remove(Span s)
{
    const char *text = s.src->text;
    uint32_t at = s.at, end = s.at + s.len;

    while (at && is_space_or_tab(text[at - 1]))
        at--;
    if (at && text[at - 1] != '\n')
        return (Span){s.src, at, s.at + s.len - at};
    while (end < s.src->len && is_space_or_tab(text[end]))
        end++;
    if (end < s.src->len && text[end] == '\r')
        end++;
    if (end == s.src->len || text[end] == '\n')
        return (Span){s.src, at, end + (end < s.src->len) - at};
    return (Span){s.src, s.at, end - s.at};                       // a statement follows on its line
}

// Whether this run could have reported warnings of the flag.
static bool could_report(const Diags *d, const char *name)
{
    const DiagFlag *flag = diag_find_flag(name);

    return (d->analysed >> flag->group & 1u) && (flag->judged == DIAG_JUDGED_ALWAYS || d->known >> flag->judged & 1u);
}

// Reports each @allow that no warning has used: if `about_itself`, only @allow(unused-allow), else all others. d->allow contains an
// annotation once for each part of the source that it covers. An @allow is not reported if this run could not have produced its finding.
static void report_unused(Diags *d, bool about_itself)
{
    DiagAllow **all = sorted_allows(d, compare_spans);
    const char *itself = diag_info[DIAG_unused_allow].flag;
    bool used = false;

    for (size_t i = 0; i < d->allow.n; i++) {
        used = used || all[i]->used || all[i]->shared;
        if (i + 1 < d->allow.n && compare_spans(&all[i], &all[i + 1]) == 0)
            continue;
        if (!used && (strcmp(all[i]->flag, itself) == 0) == about_itself && could_report(d, all[i]->flag)) {
            Diag *x = diag_report(d, DIAG_unused_allow, all[i]->span, all[i]->flag);
            diag_label(d, x, DIAG_label_leave_out);
            diag_edit(d, x, span_to_remove(all[i]->span), "");
        }
        used = false;
    }
}

// Moves the warnings that are allowed from the list into `allowed`.
void diags_apply_allows(Diags *d)
{
    uint32_t kept = 0;

    if (d->allow.n == 0)
        return;
    match_allows(d);
    if (d->analysed && d->errors == 0) {
        report_unused(d, false);
        match_allows(d);
        report_unused(d, true);
    }
    for (size_t i = 0; i < d->list.n; i++) {
        Diag *x = d->list.at[i];
        if (x->allowed) {
            vec_push(d->arena, &d->allowed, x);
            d->warnings--;
        } else {
            x->allow_checked = true;
            d->list.at[kept++] = x;
        }
    }
    d->list.n = kept;
    for (size_t i = 0; i < d->allow.n; i++)
        d->allow.at[i].shared = true;
}
