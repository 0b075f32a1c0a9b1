// SPDX-License-Identifier: Apache-2.0
// What is not covered, in words, and the totals.
#include <stdlib.h>

#include "compiler/analysis/transitions.h"
#include "compiler/cover/cover.h"
#include "compiler/script/script.h"
#include "stdlib/convert.h"

static bool is_open(const Cover *c, uint32_t i) { return c->hits[i] == 0; }

// Whether a report names another place instead: the statement, guard or state without which no run can cover this one.
static bool has_named_cause(const Cover *c, uint32_t i, unsigned kinds)
{
    const CoverPlace *p = &c->place.at[i];

    if (p->kind == COVER_TRANSITION && kinds >> COVER_STATE & 1 && is_open(c, c->entry[p->from->number - 1]))
        return true;
    for (uint32_t above = p->part_of; above; above = c->place.at[above].part_of)
        if (is_open(c, above) && kinds >> c->place.at[above].kind & 1)
            return true;
    return false;
}

// ---- words ----

static bool is_within(Span inner, Span outer) { return inner.at >= outer.at && inner.at + inner.len <= outer.at + outer.len; }

// Returns the source text of a place.  If the text is in a definition that the reported line uses, the name of the definition follows it:
// "`p > 5` of `tooHot`".
static const char *quote_place(const Cover *c, const CoverPlace *p)
{
    const Defines *all = &c->p->define;
    const Define *inner = NULL;

    for (uint32_t i = 0; i < all->n && !is_within(p->span, p->where); i++)
        if (is_within(p->span, all->at[i]->value_span) && (!inner || is_within(all->at[i]->value_span, inner->value_span)))
            inner = all->at[i];
    return inner ? format_in(c->arena, "`%s` of `%s`", source_text(c->arena, p->span), inner->name->text)
           : format_in(c->arena, "`%s`", source_text(c->arena, p->span));
}

// Returns the states from which a transition of [all_states] was not taken, in the order of the places: "Fill and Hold".
static const char *list_origins(const Cover *c, uint32_t first, unsigned kinds, bool impossible)
{
    const CoverPlace *p = &c->place.at[first];
    VEC(const char *) name = {NULL, 0, 0};
    Buf out;

    for (uint32_t i = first; i < c->place.n; i++) {
        const CoverPlace *q = &c->place.at[i];
        if (q->kind == COVER_TRANSITION && q->span.at == p->span.at && is_open(c, i) && !has_named_cause(c, i, kinds) &&
            !q->impossible == !impossible)
            vec_push(c->arena, &name, q->from->name->text);
    }
    buf_init(&out, c->arena);
    for (uint32_t i = 0; i < name.n; i++)
        buf_printf(&out, "%s%s", i == 0 ? "" : i + 1 < name.n ? ", " : " and ", name.at[i]);
    return buf_text(&out);
}

// Returns the value of a parameter: "its default 15", "its lowest value 5".
static const char *describe_parameter_value(const Cover *c, const CoverPlace *p)
{
    const Var *v = p->parameter;
    const bool is_default = p->cell == v->parameter->standard, is_low = p->cell == sm_cell_from_f64(v->type, v->parameter->lo);
    Buf out;

    buf_init(&out, c->arena);
    buf_str(&out, is_default ? "its default " : is_low ? "its lowest value " : "its highest value ");
    format_cell_shortest(&out, v->type, p->cell);
    return buf_text(&out);
}

static const char *text_of_place(const Cover *c, uint32_t i, unsigned kinds)
{
    const CoverPlace *p = &c->place.at[i];
    const char *text = quote_place(c, p);

    switch (p->kind) {
    case COVER_TRANSITION:
        return format_in(c->arena, "%s was never taken from %s", text,
                         p->of_all_states ? list_origins(c, i, kinds, p->impossible) : p->from->name->text);
    case COVER_STATEMENT: return format_in(c->arena, "%s was never executed", text);
    case COVER_GUARD: return format_in(c->arena, "%s was never %s", text, p->value ? "true" : "false");
    case COVER_CONDITION: return format_in(c->arena, "%s was never %s while it decided", text, p->value ? "true" : "false");
    case COVER_WINDOW: return format_in(c->arena, "%s was never full when its value mattered", text);
    case COVER_STATE: return format_in(c->arena, "state %s was never %s", source_text(c->arena, p->span), p->value ? "entered" : "left");
    case COVER_PARAMETER: return format_in(c->arena, "parameter %s never had %s", text, describe_parameter_value(c, p));
    case COVER_KIND_COUNT: break;
    }
    return "";
}

// ---- the list ----

// Whether an earlier copy of a transition of [all_states] has already been listed, with the states of all copies.
static bool is_listed_with_earlier(const Cover *c, uint32_t i, unsigned kinds)
{
    const CoverPlace *p = &c->place.at[i];

    for (uint32_t k = 1; p->of_all_states && k < i; k++) {
        const CoverPlace *q = &c->place.at[k];
        if (q->kind == COVER_TRANSITION && q->span.at == p->span.at && is_open(c, k) && !has_named_cause(c, k, kinds) &&
            !q->impossible == !p->impossible)
            return true;
    }
    return false;
}

// Whether place i is about a condition that is a whole decision, and the list already names the decision's own place, which has the same outcome.
static bool repeats_guard(const Cover *c, uint32_t i, unsigned kinds)
{
    const CoverPlace *p = &c->place.at[i];

    return p->kind == COVER_CONDITION && kinds >> COVER_GUARD & 1 && is_open(c, p->result);
}

static int compare_gaps(const void *a, const void *b)
{
    const CoverGap *x = a, *y = b;

    if (x->is_impossible != y->is_impossible)
        return x->is_impossible - y->is_impossible;
    if (x->span.at != y->span.at)
        return x->span.at < y->span.at ? -1 : 1;
    return x->place < y->place ? -1 : x->place > y->place;
}

CoverGaps cover_list_gaps(const Cover *c, unsigned kinds)
{
    CoverGaps out = {NULL, 0, 0};

    for (uint32_t i = 1; i < c->place.n; i++) {
        const CoverPlace *p = &c->place.at[i];
        CoverGap gap = {p->where, i, NULL, p->impossible != NULL};
        if (!is_open(c, i) || !(kinds >> p->kind & 1) || has_named_cause(c, i, kinds) || repeats_guard(c, i, kinds) ||
            is_listed_with_earlier(c, i, kinds))
            continue;
        gap.text = text_of_place(c, i, kinds);
        if (p->impossible)
            gap.text = format_in(c->arena, "%s: %s", gap.text, p->impossible);
        vec_push(c->arena, &out, gap);
    }
    if (out.n)
        qsort(out.at, out.n, sizeof *out.at, compare_gaps);
    return out;
}

static void write_totals(const Cover *c, Buf *out)
{
    for (int k = 0; k < COVER_KIND_COUNT; k++) {
        const CoverTotal t = cover_total(c, (CoverKind)k);
        if (t.possible + t.impossible == 0)
            continue;
        buf_printf(out, "  %-11s  %lu of %lu", cover_kind_name[k], (unsigned long)t.covered, (unsigned long)t.possible);
        if (t.impossible)
            buf_printf(out, ", and %lu impossible", (unsigned long)t.impossible);
        buf_char(out, '\n');
    }
}

void cover_write_text(const Cover *c, Buf *out)
{
    const CoverGaps gaps = cover_list_gaps(c, (1u << COVER_KIND_COUNT) - 1);
    bool impossible = false;

    buf_printf(out, "coverage of %s:\n", c->p->name->text);
    write_totals(c, out);
    if (gaps.n && !gaps.at[0].is_impossible)
        buf_str(out, "not covered:\n");
    for (uint32_t i = 0; i < gaps.n; i++) {
        const CoverGap *g = &gaps.at[i];
        if (g->is_impossible && !impossible)
            buf_str(out, "impossible:\n");
        impossible = g->is_impossible;
        buf_printf(out, "  line %lu: %s\n", (unsigned long)source_position(g->span.src, g->span.at).line, g->text);
    }
}
