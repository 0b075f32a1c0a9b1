// SPDX-License-Identifier: Apache-2.0
// The section on faults of sensors: a matrix of inputs and kinds of faults, and a list of what they do.
#include "compiler/report/page.h"
#include "compiler/report/page_text.h"

enum { PAIRS_MOST = 100 };    // lines of two faults on the page

static const DocColumn kind_columns[] = {{"kind", "Fault"}, {"reads", "What the machine reads"}};
static const DocColumn line_columns[] = {{"number", "No."}, {"fault", "Fault"}, {"trigger", "Begins"}, {"effect", "What happens"},
                                         {"others", "Other triggers"}, {"script", "Script"}};

static const char *const tone[] = {"good", "note", "bad"};        // by ReportDanger

static const char *line_id(const Report *r, uint32_t number) { return format_in(r->arena, "fault-%lu", (unsigned long)number); }

// Table of inputs by kinds of fault. Each cell shows the outcome; its number links to the line below that explains the fault.
static void add_matrix(const Report *r, Doc *d)
{
    const ReportFaults *f = r->faults;
    DocColumn *column = ARENA_ARRAY(r->arena, DocColumn, f->kind.n + 1u);
    DocTable *t;

    column[0] = (DocColumn){"input", "Input"};
    for (uint32_t k = 0; k < f->kind.n; k++)
        column[k + 1] = (DocColumn){f->kind.at[k].name, f->kind.at[k].name};
    t = doc_add_table(d, "matrix", column, f->kind.n + 1u);
    t->narrow = t->dense = true;
    for (uint32_t i = 0; i < f->input.n; i++) {
        doc_add_code_cell(t, f->input.at[i]);
        for (uint32_t k = 0; k < f->kind.n; k++) {
            const ReportFaultCell *c = &f->cell.at[i * f->kind.n + k];
            const ReportOutcome *outcome = &f->outcome[c->outcome];
            if (c->line)
                doc_add_linked_badge_cell(t, format_in(r->arena, "%s %lu", outcome->name, (unsigned long)c->line), tone[outcome->danger],
                                          line_id(r, c->line));
            else
                doc_add_plain_cell(t, c->applies ? "-" : "");
        }
    }
}

// Explains each kind of sensor fault in a sentence.
static void add_kinds(const Report *r, Doc *d)
{
    DocTable *t = DOC_ADD_TABLE(d, "kinds", kind_columns);

    t->narrow = true;
    for (uint32_t k = 0; k < r->faults->kind.n; k++) {
        doc_add_code_cell(t, r->faults->kind.at[k].name);
        doc_add_plain_cell(t, r->faults->kind.at[k].sentence);
    }
}

// Adds row i of the explained faults; cells of the matrix link to it.
static void add_line(const Report *r, DocTable *t, uint32_t i)
{
    const ReportFaultLine *l = &r->faults->line.at[i];

    doc_add_target_cell(t, i + 1u, line_id(r, i + 1));
    doc_add_plain_cell(t, l->fault);
    doc_add_plain_cell(t, l->trigger);
    doc_add_plain_cell(t, l->effect);
    doc_add_plain_cell(t, l->others ? format_in(r->arena, "%lu", (unsigned long)l->others) : "");
    doc_add_plain_cell(t, l->script ? l->script : "");
}

// Adds a table for each outcome, of single faults and then of pairs.
static void add_lines(const Report *r, Doc *d)
{
    const ReportFaults *f = r->faults;
    DocTable *t = NULL;
    uint32_t pairs = 0;

    for (uint32_t i = 0; i < f->line.n; i++) {
        const ReportFaultLine *l = &f->line.at[i];
        const char *words = f->outcome[l->outcome].words, *name = f->outcome[l->outcome].name;
        pairs += l->is_pair;
        if (pairs > PAIRS_MOST)
            continue;
        if (i == 0 || l->is_pair != l[-1].is_pair || l->outcome != l[-1].outcome) {
            DocPart *heading = doc_add_heading(d, NULL,
                                               format_in(r->arena, "%s%s", l->is_pair
                                                         ? "Two faults, and worse than each alone: " : "With one fault, ", words));
            heading->badge = name;
            heading->tone = tone[f->outcome[l->outcome].danger];
            t = doc_add_table(d, format_in(r->arena, "%s%s", l->is_pair ? "two-" : "", name), line_columns,
                              sizeof line_columns / sizeof *line_columns);
        }
        add_line(r, t, i);
    }
    if (pairs > PAIRS_MOST)
        doc_add_plain(d, format_in(r->arena, "And %lu more lines of two faults.", (unsigned long)(pairs - PAIRS_MOST)));
}

void report_add_faults(Report *r, Doc *d)
{
    const ReportFaults *f = r->faults;

    if (!f)
        return;
    doc_add_section(d, "faults", "Faults of sensors");
    if (f->not_run) {
        doc_add_plain(d, format_in(r->arena, "No fault was tried, because %s.", f->not_run));
        return;
    }
    doc_add_paragraph(d, TEXT_FAULTS);
    doc_add_plain(d, f->summary);
    if (f->is_cut)
        doc_add_paragraph(d, TEXT_FAULTS_CUT);
    if (!r->requirements)
        doc_add_paragraph(d, TEXT_FAULTS_NO_REQUIREMENTS);
    for (uint32_t i = 0; i < f->note.n; i++)
        doc_add_plain(d, f->note.at[i]);
    if (f->input.n)
        add_matrix(r, d);
    if (f->line.n == 0)
        doc_add_paragraph(d, TEXT_FAULTS_NOTHING);
    else
        doc_add_paragraph(d, f->has_scripts ? TEXT_FAULTS_SCRIPTS : TEXT_FAULTS_NO_SCRIPTS);
    add_lines(r, d);
    if (f->input.n) {
        doc_add_heading(d, NULL, "Kinds of faults");
        add_kinds(r, d);
    }
}
