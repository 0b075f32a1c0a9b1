// SPDX-License-Identifier: Apache-2.0
// The section on mutation: the changes of the machine that no script notices, the most dangerous first, and how many are noticed by state.
#include "compiler/report/page.h"

#include <string.h>

#include "compiler/report/page_text.h"

static const DocColumn state_columns[] = {{"state", "State"}, {"noticed", "Noticed"}, {"changes", "Of"}};
static const DocColumn change_columns[] = {{"line", "Line"}, {"text", "As written"}, {"change", "Change that no script notices"},
                                           {"inputs", "Inputs that would show it"}};

typedef struct StateScore { uint32_t noticed, changes; } StateScore;

// Whether the change enters the score: one that has not run, or that is proved to make no difference, does not.
static bool counts_for_score(const Mutant *m)
{
    return m->verdict == MUTANT_NOTICED || m->verdict == MUTANT_GENERATED || m->verdict == MUTANT_UNNOTICED;
}

// Changes in this state, and how many of them a script noticed. State 0: changes that belong to several states or to none.
static StateScore score_of(const Report *r, uint32_t state)
{
    StateScore s = {0, 0};
    uint32_t n;
    const Mutant *m = mutation_list(r->mutation, &n);

    for (uint32_t i = 0; i < n; i++)
        if (counts_for_score(&m[i]) && (m[i].state ? m[i].state->number : 0) == state) {
            s.changes++;
            s.noticed += m[i].verdict == MUTANT_NOTICED;
        }
    return s;
}

static void add_score_row(DocTable *t, const char *state, StateScore s)
{
    if (s.changes == 0)
        return;
    doc_add_plain_cell(t, state);
    doc_add_number_cell(t, s.noticed);
    doc_add_number_cell(t, s.changes);
}

static void add_scores(const Report *r, Doc *d)
{
    const Program *p = r->analysis.p;
    DocTable *t = DOC_ADD_TABLE(d, "mutation-states", state_columns);

    t->narrow = true;
    for (size_t i = 0; i < p->state.n; i++)
        add_score_row(t, p->state.at[i]->name->text, score_of(r, p->state.at[i]->number));
    add_score_row(t, "several, or none", score_of(r, 0));
}

// Returns a line of the source without the blanks around it and without its comment.
static const char *written_line(const Report *r, Span span)
{
    uint32_t n;
    const char *text = source_line(span.src, report_line_of(span), &n);
    const char *comment = memchr(text, '#', n);

    n = comment ? (uint32_t)(comment - text) : n;
    while (n > 0 && (*text == ' ' || *text == '\t')) {
        text++;
        n--;
    }
    while (n > 0 && (text[n - 1] == ' ' || text[n - 1] == '\t' || text[n - 1] == '\r'))
        n--;
    return format_in(r->arena, "%.*s", (int)n, text);
}

// A change that no script notices: where, what was changed, and inputs that would show the difference.
static void add_change_row(const Report *r, DocTable *t, const Mutant *m)
{
    Mutant without_danger = *m;                        // the heading of the table already names the danger
    Buf change, inputs;

    without_danger.danger = DANGER_OTHER;
    buf_init(&change, r->arena);
    buf_init(&inputs, r->arena);
    mutant_write_change(r->arena, &without_danger, &change);
    if (m->scenario)
        mutant_write_scenario(r->analysis.p, m, MUTANT_INPUTS_SHOWN, &inputs);
    else
        buf_str(&inputs, "none were found");
    doc_add_line_cell(t, report_line_of(m->span));
    doc_add_code_cell(t, written_line(r, m->span));
    doc_add_text_cell(t, buf_text(&change));
    doc_add_plain_cell(t, buf_text(&inputs));
}

// Adds the changes of one degree of danger.
static void add_changes(const Report *r, Doc *d, MutantDanger danger, const char *key, const char *title)
{
    DocTable *t = NULL;

    for (int found = 1; found >= 0; found--) {
        uint32_t n;
        const Mutant **m = mutation_order(r->mutation, r->arena, found ? MUTANT_GENERATED : MUTANT_UNNOTICED, &n);
        for (uint32_t i = 0; i < n; i++) {
            if (m[i]->danger != danger)
                continue;
            if (!t) {
                doc_add_heading(d, NULL, title);
                t = DOC_ADD_TABLE(d, key, change_columns);
                t->last_on_screen = t->folds = true;
            }
            add_change_row(r, t, m[i]);
        }
    }
}

void report_add_left_out(const Report *r, Doc *d)
{
    for (size_t i = 0; i < r->left_out.n; i++)
        doc_add_plain(d, r->left_out.at[i]);
}

void report_add_mutation(Report *r, Doc *d)
{
    MutationScore s;
    Buf percent;

    if (!r->mutation && !r->not_mutated)
        return;
    doc_add_section(d, "mutation", "What no script notices");
    if (r->not_mutated) {
        doc_add_plain(d, format_in(r->arena, "No change of the machine was tried, because %s.", r->not_mutated));
        return;
    }
    s = mutation_score(r->mutation);
    doc_add_legend(d, TEXT_MUTATION);
    report_add_left_out(r, d);
    buf_init(&percent, r->arena);
    buf_percent(&percent, s.of[MUTANT_NOTICED], s.noticeable, 1);
    if (s.of[MUTANT_WAITING])
        doc_add_plain(d, format_in(r->arena, TEXT_MUTATION_STOPPED, s.all - s.of[MUTANT_WAITING], s.all));
    doc_add_plain(d, format_in(r->arena, "The scripts notice %lu of %lu changes (%s %%). Changes that make no difference are not counted: %lu.%s",
                               s.of[MUTANT_NOTICED], s.noticeable, buf_text(&percent), s.of[MUTANT_EQUIVALENT],
                               s.of[MUTANT_EQUIVALENT] ? TEXT_MUTATION_EQUIVALENT : ""));
    add_scores(r, d);
    add_changes(r, d, DANGER_ABORT, "mutation-abort", "On the way to an abort");
    add_changes(r, d, DANGER_HAZARD, "mutation-hazard", "At a hazardous output");
    add_changes(r, d, DANGER_OUTPUT, "mutation-output", "At another output");
    add_changes(r, d, DANGER_TRANSITION, "mutation-transition", "At another transition");
    add_changes(r, d, DANGER_OTHER, "mutation-other", "Elsewhere");
}
