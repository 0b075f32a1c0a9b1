// SPDX-License-Identifier: Apache-2.0
// The first page: what the machine is, its parts, and the diagram.
#include "bytecode-vm/image.h"
#include "compiler/report/comment.h"
#include "compiler/report/describe.h"
#include "compiler/report/diagram.h"
#include "compiler/report/page.h"
#include "compiler/report/written.h"

static const DocColumn fact_columns[] = {{"name", "Name"}, {"value", "Value"}};

// Returns the machine's identity, from the image, in hexadecimal.
static const char *identity_text(const Report *r)
{
    SmvmReader at;

    if (smvm_find_section(r->image, SMVM_S_IDENTITY, &at) && at.end - at.at == 8)
        return format_in(r->arena, "%016llx", (unsigned long long)smvm_cell(r->image, at.at, 8));
    return "";
}

static const char *scripts_text(const Report *r)
{
    size_t passed = 0;

    for (size_t i = 0; i < r->runs; i++)
        passed += r->run[i].script && r->run[i].result.outcome == SCRIPT_PASSED;
    if (r->runs == 0)
        return "none were run";
    return format_in(r->arena, "%lu of %lu passed", (unsigned long)passed, (unsigned long)r->runs);
}

// Returns how many transitions were taken.  It is a range if several lead from one state to another: a run does not show which it took.
static const char *transitions_covered_text(const Report *r, Coverage c)
{
    if (c.transitions_least == c.transitions_most)
        return format_in(r->arena, "%lu of %lu", (unsigned long)c.transitions_least, (unsigned long)c.transitions);
    return format_in(r->arena, "%lu to %lu of %lu", (unsigned long)c.transitions_least, (unsigned long)c.transitions_most,
                     (unsigned long)c.transitions);
}

static const char *findings_text(const Report *r)
{
    const FindingCount n = report_count_findings(r);

    if (n.allowed == 0)
        return n.open ? format_in(r->arena, "%lu", (unsigned long)n.open) : "none";
    return format_in(r->arena, "%lu, and %lu allowed", (unsigned long)n.open, (unsigned long)n.allowed);
}

static void add_fact(DocTable *t, const char *name, const char *value)
{
    doc_add_plain_cell(t, name);
    doc_add_plain_cell(t, value);
}

static void add_facts(const Report *r, Doc *d)
{
    const Program *p = r->analysis.p;
    DocTable *t = DOC_ADD_TABLE(d, "facts", fact_columns);
    const char *state = p->state.at[r->cost.worst_state - 1]->name->text;

    t->facts = true;
    add_fact(t, "States", format_in(r->arena, "%lu", (unsigned long)p->state.n));
    add_fact(t, "Transitions", format_in(r->arena, "%lu", (unsigned long)written_transitions(r->arena, p, &r->analysis.transition).n));
    if (p->step)
        add_fact(t, "Step", describe_time(r->arena, p, p->step));
    if (p->uses_time_unit || p->time_unit != TIME_MS)
        add_fact(t, "Unit of time", time_unit_name(p->time_unit));
    add_fact(t, "Findings", findings_text(r));
    add_fact(t, "Scripts", scripts_text(r));
    if (r->runs) {
        const Coverage c = report_measure_coverage(r);
        add_fact(t, "States covered", format_in(r->arena, "%lu of %lu", (unsigned long)c.states_covered, (unsigned long)c.states));
        add_fact(t, "Transitions covered", transitions_covered_text(r, c));
    }
    add_fact(t, "Longest step", format_in(r->arena, "%lu instructions, in %s", (unsigned long)r->cost.worst, state));
    add_fact(t, report_board_name(r), report_board_time(r));
    add_fact(t, "Memory on the VM", format_in(r->arena, "%lu bytes on a 64-bit computer", (unsigned long)r->cost.ram));
    add_fact(t, "Image", format_in(r->arena, "%lu bytes", (unsigned long)r->image_size));
    add_fact(t, "Image CRC", format_in(r->arena, "%08lx", (unsigned long)smvm_uint(r->image, SMVM_CRC_AT, 4)));
    add_fact(t, "Source identity", identity_text(r));
    add_fact(t, "State vector", p->sv->from_machine ? "declared in the machine" : format_in(r->arena, "%s (layout %08lx)", p->sv->name->text,
                                                                               (unsigned long)p->sv->hash));
}

// ---- in words ----

// Returns the names of the variables for which `wanted` is true, in backticks, with "and" before the last.
static const char *variable_names(const Report *r, bool (*wanted)(const Program *p, const Var *v), size_t *n)
{
    const Program *p = r->analysis.p;
    VEC(const Var *) v = {NULL, 0, 0};
    Buf out;

    buf_init(&out, r->arena);
    for (size_t i = 0; i < p->var.n; i++)
        if (wanted(p, p->var.at[i]))
            vec_push(r->arena, &v, p->var.at[i]);
    for (size_t i = 0; i < v.n; i++)
        buf_printf(&out, "%s`%s`", describe_separator(i, v.n), v.at[i]->name->text);
    *n = v.n;
    return buf_text(&out);
}

static bool is_element(const Program *p, const Var *v) { return v->kind == VAR_ELEMENT && v != p->g && v != p->s; }
static bool is_input(const Program *p, const Var *v) { return is_element(p, v) && v->read && !v->written; }
static bool is_output(const Program *p, const Var *v) { return is_element(p, v) && v->written; }

// Returns the names of the states that no transition leaves.
static const char *final_states(const Report *r, size_t *n)
{
    const Program *p = r->analysis.p;
    const Transitions *t = &r->analysis.transition;
    bool *is_left = ARENA_ARRAY(r->arena, bool, p->state.n + 1u);         // by State.number: some transition leaves the state
    VEC(const State *) final = {NULL, 0, 0};
    Buf out;

    buf_init(&out, r->arena);
    for (size_t i = 0; i < t->n; i++)
        if (t->at[i].from != t->at[i].to)
            is_left[t->at[i].from->number] = true;
    for (size_t i = 0; i < p->state.n; i++)
        if (!is_left[i + 1])
            vec_push(r->arena, &final, p->state.at[i]);
    for (size_t i = 0; i < final.n; i++)
        buf_printf(&out, "%s^%s^", describe_separator(i, final.n), final.at[i]->name->text);
    *n = final.n;
    return buf_text(&out);
}

static void add_summary(Report *r, Doc *d)
{
    const Program *p = r->analysis.p;
    size_t reads, writes, final;
    const char *read = variable_names(r, is_input, &reads), *written = variable_names(r, is_output, &writes), *last = final_states(r, &final);
    Buf b;

    buf_init(&b, r->arena);
    buf_printf(&b, "The machine has %s and starts in ^%s^. ", describe_count(r->arena, p->state.n, "state", "states"),
               p->state.at[0]->name->text);
    if (reads)
        buf_printf(&b, "It reads %s. ", read);
    buf_printf(&b, writes ? "It writes %s. " : "It writes no element of the state vector%s. ", writes ? written : "");
    if (final)
        buf_printf(&b, final == 1 ? "It never leaves %s." : "It never leaves its final states %s.", last);
    doc_add_paragraph(d, buf_text(&b));
}

// In pixels, for the margins of page_style.c.  PAPER_W: width of an upright page of A4 between its margins; PAPER_H: height of an upright page of
// Letter that is left below headings; LANDSCAPE_W and _H: the same of landscape pages; LOW: height of a diagram that shares a page.  Scaled to less
// than LEGIBLE percent, letters are too small to read: those of conditions, 11 pixels or 8.25 points, would have less than 6 points.
enum { PAPER_W = 688, PAPER_H = 812, LANDSCAPE_W = 1017, LANDSCAPE_H = 580, LOW = 416, LEGIBLE = 73 };

// Whether a diagram that is scaled to at most w × h pixels is legible.
static bool is_legible_in(DiagramSize s, int64_t w, int64_t h)
{
    return (int64_t)s.w * LEGIBLE <= w * 100 && (int64_t)s.h * LEGIBLE <= h * 100;
}

// How the diagram is shown on paper: the first form in which its text stays legible.
static DocFigure choose_figure(DiagramSize s)
{
    if (is_legible_in(s, PAPER_W, LOW))
        return FIGURE_LOW;
    if (!is_legible_in(s, PAPER_W, INT32_MAX))
        return FIGURE_LARGE;
    return is_legible_in(s, PAPER_W, PAPER_H) ? FIGURE_DIAGRAM : FIGURE_TALL;
}

// Returns the size of the slices for paper: as wide as the diagram, or as a part of it that is legible on a landscape page, and as high as then
// fits on the page.
static DiagramSize choose_slice(DiagramSize s, DocFigure figure)
{
    const int32_t page_w = figure == FIGURE_TALL ? PAPER_W : LANDSCAPE_W, page_h = figure == FIGURE_TALL ? PAPER_H : LANDSCAPE_H;
    const int32_t w = diagram_slice_width(s.w, page_w * 100 / LEGIBLE);

    return (DiagramSize){w, w > page_w ? (int32_t)((int64_t)page_h * w / page_w) : page_h};
}

// Adds the state diagram.
void report_add_diagram(Report *r, Doc *d, const Diags *findings, const DiagramCounts *counts, const char *caption)
{
    DiagramSize size;
    const DiagramOptions o = {.findings = findings, .counts = counts, .size = &size};
    DocPart *figure;
    Buf svg, print;

    buf_init(&svg, r->arena);
    buf_init(&print, r->arena);
    diagram_write_svg(&r->analysis, &o, &svg);
    figure = doc_add_figure(d, buf_text(&svg), caption);
    figure->figure = choose_figure(size);
    figure->width = size.w;
    if (figure->figure == FIGURE_TALL || figure->figure == FIGURE_LARGE) {
        diagram_write_slices(&r->analysis, &o, choose_slice(size, figure->figure), &print);
        figure->print = buf_text(&print);
    }
}

void report_add_overview(Report *r, Doc *d)
{
    doc_add_section(d, "overview", "Overview");
    report_add_verdicts(r, d);
    doc_add_quote(d, comment_of_file(r->arena, r->analysis.p->src));
    add_summary(r, d);
    add_facts(r, d);
}

void report_add_diagram_section(Report *r, Doc *d)
{
    doc_add_section(d, "diagram", "State diagram");
    report_add_diagram(r, d, r->analysis.diags, NULL, NULL);
}
