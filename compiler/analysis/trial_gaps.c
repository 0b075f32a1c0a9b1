// SPDX-License-Identifier: Apache-2.0
#include "compiler/analysis/trial_gaps.h"

#include "compiler/analysis/trial_near.h"

enum { NAMES_SHOWN = 4 };         // the most names in a list; of further names, the text gives only the number

void trial_add_gap(TrialGaps *gaps, TrialGap gap)
{
    if (!gaps)
        return;
    for (size_t i = 0; i < gaps->list.n; i++) {
        const TrialGap *old = &gaps->list.at[i];
        if (old->kind == gap.kind && old->state == gap.state && old->sensor == gap.sensor && old->name == gap.name)
            return;
    }
    vec_push(gaps->arena, &gaps->list, gap);
}

// ---- the sentence ----

typedef struct GapNames { Buf text; uint32_t n; } GapNames;

// Adds a name in quotes to the list. After NAMES_SHOWN names, only counts it.
static void add_name(GapNames *l, const char *name)
{
    if (l->n++ < NAMES_SHOWN)
        buf_printf(&l->text, "%s'%s'", l->n > 1 ? ", " : "", name);
}

static const char *finish_names(GapNames *l)
{
    if (l->n > NAMES_SHOWN)
        buf_printf(&l->text, " and %lu more", (unsigned long)(l->n - NAMES_SHOWN));
    return buf_text(&l->text);
}

// Returns the states of the gaps of a kind, of one sensor if it is not NULL.
static const char *names_of_states(Arena *arena, const TrialGaps *gaps, TrialGapKind kind, const Var *sensor)
{
    GapNames l = {.n = 0};

    buf_init(&l.text, arena);
    for (size_t i = 0; i < gaps->list.n; i++)
        if (gaps->list.at[i].kind == kind && gaps->list.at[i].sensor == sensor)
            add_name(&l, gaps->list.at[i].state->name->text);
    return finish_names(&l);
}

// Returns what was not tried, as a part of a sentence.
static const char *gap_text(Arena *arena, const TrialGaps *gaps, const TrialGap *gap)
{
    switch (gap->kind) {
    case GAP_STATE: return format_in(arena, "no run reached %s", names_of_states(arena, gaps, GAP_STATE, NULL));
    case GAP_SENSOR:
        return format_in(arena, "not every failure of '%s' was tried in %s", gap->sensor->name->text,
                         names_of_states(arena, gaps, GAP_SENSOR, gap->sensor));
    case GAP_NUMBERS: return format_in(arena, "'%s' is compared with too many numbers", gap->sensor ? gap->sensor->name->text : "T");
    case GAP_CHECK: return format_in(arena, "the search for '%s' has used its effort", gap->name);
    case GAP_KINDS: break;
    }
    return "";
}

// Whether an earlier gap belongs to the same part of the sentence.
static bool is_said(const TrialGaps *gaps, size_t n)
{
    const TrialGap *gap = &gaps->list.at[n];

    for (size_t i = 0; i < n; i++)
        if (gaps->list.at[i].kind == gap->kind && (gap->kind == GAP_STATE || (gap->kind == GAP_SENSOR && gaps->list.at[i].sensor == gap->sensor)))
            return true;
    return false;
}

void trial_report_gaps(const Analysis *a, const TrialGaps *gaps)
{
    static const DiagCode advice[GAP_KINDS] = {DIAG_note_gap_state, DIAG_note_gap_sensor, DIAG_note_gap_numbers, DIAG_note_gap_check};
    bool has[GAP_KINDS] = {false};
    const State *at = NULL;
    Diag *d;
    Buf text;

    buf_init(&text, a->arena);
    for (size_t i = 0; i < gaps->list.n; i++) {
        const TrialGap *gap = &gaps->list.at[i];
        has[gap->kind] = true;
        if (gap->state && (!at || gap->state->number < at->number))
            at = gap->state;
        if (!is_said(gaps, i))
            buf_printf(&text, "%s%s", text.n > 0 ? "; " : "", gap_text(a->arena, gaps, gap));
    }
    if (gaps->list.n == 0)
        return;
    d = diag_report(a->diags, DIAG_not_tried, (at ? at : a->p->state.at[0])->span, buf_text(&text));
    if (gaps->near)
        trial_near_note(gaps->near, d);
    for (int kind = 0; kind < GAP_KINDS; kind++)
        if (has[kind])
            diag_note(a->diags, d, (Span){0}, advice[kind]);
}
