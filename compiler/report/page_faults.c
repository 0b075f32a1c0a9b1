// SPDX-License-Identifier: Apache-2.0
// The section on faults of sensors: a matrix of inputs and kinds of faults, and a list of what they do.
#include "compiler/report/page.h"
#include "compiler/report/page_text.h"

enum {
    PAIRS_MOST = 100,         // lines of two faults on the page
    INPUTS_MOST = 40          // rows of the matrix
};

static const DocColumn kind_columns[] = {{"kind", "Fault"}, {"reads", "What the machine reads"}};
static const DocColumn line_columns[] = {{"number", "No."}, {"fault", "Fault"}, {"trigger", "Begins"}, {"effect", "What happens"},
                                         {"others", "Other triggers"}, {"script", "Script"}};

static const char *const tone[] = {"good", "note", "bad"};        // by ReportDanger

static const char *line_id(const Report *r, uint32_t number) { return format_in(r->arena, "fault-%lu", (unsigned long)number); }

// Returns the worst outcome of an input's faults, as an index into ReportFaults.outcome.
static uint32_t worst_of_input(const ReportFaults *f, uint32_t input)
{
    uint32_t worst = 0;

    for (uint32_t k = 0; k < f->kind.n; k++) {
        const ReportFaultCell *c = &f->cell.at[input * f->kind.n + k];
        worst = c->line && c->outcome > worst ? c->outcome : worst;
    }
    return worst;
}

// Returns the inputs in the order of the table: as written, but the worst first if not all have room.
static uint32_t *order_inputs(const Report *r, bool worst_first)
{
    const ReportFaults *f = r->faults;
    uint32_t *order = ARENA_ARRAY(r->arena, uint32_t, f->input.n);

    for (uint32_t i = 0; i < f->input.n; i++) {
        uint32_t at = i;
        for (; worst_first && at > 0 && worst_of_input(f, order[at - 1]) < worst_of_input(f, i); at--)
            order[at] = order[at - 1];
        order[at] = i;
    }
    return order;
}

// Adds a row of the matrix.
static void add_input(const Report *r, DocTable *t, uint32_t input)
{
    const ReportFaults *f = r->faults;

    doc_add_code_cell(t, f->input.at[input]);
    for (uint32_t k = 0; k < f->kind.n; k++) {
        const ReportFaultCell *c = &f->cell.at[input * f->kind.n + k];
        if (c->line)
            doc_add_linked_badge_cell(t, format_in(r->arena, "%s (%lu)", c->effect, (unsigned long)c->line), tone[f->outcome[c->outcome].danger],
                                      line_id(r, c->line));
        else
            doc_add_plain_cell(t, c->applies ? "-" : "");
    }
}

// Table of inputs by kinds of fault. Each cell shows what happens; its number is that of the line below that explains the fault.
static void add_matrix(const Report *r, Doc *d)
{
    const ReportFaults *f = r->faults;
    const uint32_t shown = f->input.n <= INPUTS_MOST ? f->input.n : INPUTS_MOST, *order = order_inputs(r, shown < f->input.n);
    DocColumn *column = ARENA_ARRAY(r->arena, DocColumn, f->kind.n + 1u);
    DocTable *t;

    column[0] = (DocColumn){"input", "Input"};
    for (uint32_t k = 0; k < f->kind.n; k++)
        column[k + 1] = (DocColumn){f->kind.at[k].name, f->kind.at[k].name};
    t = doc_add_table(d, "matrix", column, f->kind.n + 1u);
    t->narrow = t->dense = true;
    for (uint32_t i = 0; i < shown; i++)
        add_input(r, t, order[i]);
    if (shown < f->input.n)
        doc_add_paragraph(d, format_in(r->arena, TEXT_FAULTS_INPUTS, (unsigned long)(f->input.n - shown),
                                       f->outcome[worst_of_input(f, order[shown])].name));
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
            t->folds = true;
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
    report_add_left_out(r, d);
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
