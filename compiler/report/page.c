// SPDX-License-Identifier: Apache-2.0
// The order of a report, and helpers that its sections share.
#include "compiler/report/page.h"

#include "compiler/base/path.h"
#include "compiler/report/page_text.h"

// Returns the line in the source, from 1; 0 if the position is in no source.
uint32_t report_line_of(Span span) { return span.src ? source_position(span.src, span.at).line : 0; }

const char *report_format_number(Arena *arena, double x)
{
    Buf b;

    buf_init(&b, arena);
    format_number_shortest(&b, x);
    return buf_text(&b);
}

const char *report_format_cell(Arena *arena, SmType type, uint64_t cell)
{
    Buf b;

    buf_init(&b, arena);
    format_cell_stored(&b, type, cell);
    return buf_text(&b);
}

const char *report_section_of(const Report *r, const char *id) { return doc_scoped_id(r->arena, r->of ? r->of->name->text : NULL, id); }

void report_add_source(Report *r, Doc *d)
{
    const StateVec *sv = r->analysis.p->sv;

    doc_add_section(d, "source", "Source");
    doc_add_source(d, r->analysis.p->src);
    if (!sv->from_machine && sv->element.n && !r->of) {
        doc_add_heading(d, NULL, format_in(r->arena, "State vector `%s`", path_portable_name(sv->element.at[0]->span.src->name)));
        doc_add_paragraph(d, TEXT_STATE_VECTOR);
    }
}

void report_add_behaviour(Report *r, Doc *d)
{
    report_add_diagram_section(r, d);
    report_add_outputs(r, d);
    report_add_all_states(r, d);
    report_add_states(r, d);
    report_add_transitions(r, d);
    report_add_variables(r, d);
}

Doc *report_build(Report *r)
{
    Doc *d = ARENA_NEW(r->arena, Doc);
    const Program *p = r->analysis.p;

    d->arena = r->arena;
    d->title = p->name->text;
    d->subtitle = format_in(r->arena, "Design review of the state machine in %s", path_portable_name(p->src->name));
    d->maker = r->maker;
    report_add_overview(r, d);
    doc_begin_chapter(d, TEXT_WHAT_IT_DOES);
    report_add_behaviour(r, d);
    report_add_messages(r, d);
    doc_begin_chapter(d, TEXT_WHAT_MUST_NOT_HAPPEN);
    report_add_requirements(r, d);
    report_add_proofs(r, d);
    report_add_traceability(r, d);
    report_add_findings(r, d);
    report_add_abort_matrix(r, d);
    doc_begin_chapter(d, TEXT_WHAT_WAS_TESTED);
    report_add_scripts(r, d);
    report_add_mutation(r, d);
    doc_begin_chapter(d, TEXT_WHAT_BREAKS_IT);
    report_add_faults(r, d);
    report_add_sweep(r, d);
    doc_begin_chapter(d, TEXT_WHAT_IT_COSTS);
    report_add_costs(r, d);
    doc_begin_chapter(d, TEXT_APPENDIX);
    report_add_source(r, d);
    return d;
}
