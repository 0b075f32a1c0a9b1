// SPDX-License-Identifier: Apache-2.0
// The page of an application: the chapters of a machine's page.  Each begins with what is about all machines, then has sections for each machine.
#include "compiler/sema/application.h"

#include "compiler/base/path.h"
#include "compiler/report/comment.h"
#include "compiler/report/describe.h"
#include "compiler/report/page.h"
#include "compiler/report/page_text.h"

static const DocColumn machine_columns[] = {{"machine", "Machine"}, {"file", "File"}, {"period", "Runs every"}, {"mode", "Only if enabled by"},
                                            {"states", "States"}, {"first", "Starts in"}};

// ---- overview ----

static void add_machines(const Report *r, Doc *d)
{
    const Joint *j = r->analysis.p->joint;
    DocTable *t = DOC_ADD_TABLE(d, "machines", machine_columns);

    for (size_t i = 0; i < r->members; i++) {
        const Member *m = &j->member.at[i];
        doc_add_section_cell(t, m->name->text, report_section_of(&r->member[i], "diagram"));
        doc_add_plain_cell(t, path_portable_name(m->program->src->name));
        doc_add_plain_cell(t, app_time_text(r->arena, m->every * j->tick));
        doc_add_plain_cell(t, m->mode ? m->mode->name->text : "");
        doc_add_number_cell(t, m->program->state.n);
        doc_add_plain_cell(t, m->initial->name->text);
    }
}

static void add_overview(Report *r, Doc *d)
{
    const Joint *j = r->analysis.p->joint;

    doc_add_section(d, "overview", "Overview");
    report_add_verdicts(r, d);
    doc_add_paragraph(d, TEXT_APP_ALONE);
    doc_add_quote(d, comment_of_file(r->arena, r->analysis.p->src));
    doc_add_paragraph(d, format_in(r->arena, "The application has %s, and a tick every %s.",
                                   describe_count(r->arena, r->members, "machine", "machines"), app_time_text(r->arena, j->tick)));
    add_machines(r, d);
}

// ---- shared variables ----

// What one machine does with an element.
typedef struct ElementUse { bool is_listed, is_state, read, written; } ElementUse;

static ElementUse use_of(const Program *joint, const Member *m, const Var *element)
{
    ElementUse u = {false, m->s == element, false, false};

    for (size_t i = 0; i < m->program->var.n; i++)
        if (m->var[i] == element) {
            u.is_listed = true;
            u.read |= m->program->var.at[i]->read && element != joint->g;
            u.written |= m->program->var.at[i]->written;
        }
    return u;
}

static const char *use_text(const Program *joint, const Var *element, ElementUse u)
{
    if (u.is_state)
        return "its state";
    if (element == joint->g)
        return u.is_listed ? "time" : "";
    if (u.written)
        return u.read ? "reads and writes" : "writes";
    return u.read ? "reads" : u.is_listed ? "lists" : "";
}

// Returns where the element gets its values, and what is unusual about that.
static const char *source_of_element(const Report *r, const Var *element)
{
    const Program *p = r->analysis.p;
    size_t writers = 0, readers = 0;

    for (size_t i = 0; i < r->members; i++) {
        const ElementUse u = use_of(p, &p->joint->member.at[i], element);
        writers += u.written || u.is_state;
        readers += u.read;
    }
    if (element == p->g)
        return "the clock";
    if (writers > 1)
        return "several machines";
    if (writers == 1)
        return "a machine";
    return readers ? "outside" : "";
}

// Adds a row for each element of the state vector, with a column for each machine.
static void add_shared(const Report *r, Doc *d)
{
    const Program *p = r->analysis.p;
    DocColumn *column = ARENA_ARRAY(r->arena, DocColumn, r->members + 4);
    DocTable *t;

    column[0] = (DocColumn){"element", "Element"};
    column[1] = (DocColumn){"type", "Type"};
    column[2] = (DocColumn){"from", "Values from"};
    for (size_t i = 0; i < r->members; i++)
        column[3 + i] = (DocColumn){p->joint->member.at[i].name->text, p->joint->member.at[i].name->text};
    column[3 + r->members] = (DocColumn){"comment", "Comment"};
    doc_add_section(d, "shared", "Shared variables");
    doc_add_paragraph(d, TEXT_SHARED_VARIABLES);
    t = doc_add_table(d, "elements", column, r->members + 4);
    for (size_t v = 0; v < p->var.n; v++) {
        const Var *element = p->var.at[v];
        if (element->kind != VAR_ELEMENT)
            continue;
        doc_add_code_cell(t, element->name->text);
        doc_add_plain_cell(t, sm_type_info[element->type].spelling);
        doc_add_plain_cell(t, source_of_element(r, element));
        for (size_t i = 0; i < r->members; i++)
            doc_add_plain_cell(t, use_text(p, element, use_of(p, &p->joint->member.at[i], element)));
        doc_add_plain_cell(t, comment_of_variable(r->arena, element));
    }
}

// ---- the page ----

// Returns the first machine that was made from the same file as member i: i itself if that is the first.
static size_t first_of_file(const Report *r, size_t i)
{
    size_t first = 0;

    while (r->member[first].analysis.p->src != r->member[i].analysis.p->src)
        first++;
    return first;
}

// Adds what one machine must never do: its findings, once for each file, and its abort matrix.
static void add_dangers(Report *r, Doc *d, size_t i)
{
    const size_t first = first_of_file(r, i);

    if (first == i)
        report_add_findings(&r->member[i], d);
    else {
        doc_add_section(d, "findings", "Findings");
        doc_add_paragraph(d, format_in(r->arena, TEXT_FINDINGS_OF_FILE, path_portable_name(r->member[i].analysis.p->src->name),
                                       r->member[first].of->name->text));
    }
    report_add_abort_matrix(&r->member[i], d);
}

static void add_behaviour(Report *r, Doc *d, size_t i) { report_add_behaviour(&r->member[i], d); }

static void add_tests(Report *r, Doc *d, size_t i)
{
    report_add_scripts(&r->member[i], d);
    report_add_mutation(&r->member[i], d);
}

static void add_costs(Report *r, Doc *d, size_t i) { report_add_costs(&r->member[i], d); }

static void add_source(Report *r, Doc *d, size_t i) { report_add_source(&r->member[i], d); }

// Adds sections about each machine; the name of the machine begins their titles.
static void add_for_each_machine(Report *r, Doc *d, void (*add)(Report *r, Doc *d, size_t i))
{
    for (size_t i = 0; i < r->members; i++) {
        d->scope = r->member[i].of->name->text;
        add(r, d, i);
    }
    d->scope = NULL;
}

Doc *report_build_app(Report *r)
{
    Doc *d = ARENA_NEW(r->arena, Doc);

    d->arena = r->arena;
    d->title = r->analysis.p->name->text;
    d->subtitle = format_in(r->arena, "Design review of the application in %s", path_portable_name(r->analysis.p->src->name));
    d->maker = r->maker;
    d->of_application = true;
    add_overview(r, d);
    doc_begin_chapter(d, TEXT_WHAT_IT_DOES);
    add_shared(r, d);
    report_add_messages(r, d);
    add_for_each_machine(r, d, add_behaviour);
    doc_begin_chapter(d, TEXT_WHAT_MUST_NOT_HAPPEN);
    report_add_requirements(r, d);
    report_add_proofs(r, d);
    if (r->analysis.diags->list.n || r->analysis.diags->allowed.n)
        report_add_findings(r, d);
    add_for_each_machine(r, d, add_dangers);
    doc_begin_chapter(d, TEXT_WHAT_WAS_TESTED);
    report_add_scripts(r, d);
    add_for_each_machine(r, d, add_tests);
    doc_begin_chapter(d, TEXT_WHAT_BREAKS_IT);
    report_add_faults(r, d);
    report_add_sweep(r, d);
    doc_begin_chapter(d, TEXT_WHAT_IT_COSTS);
    add_for_each_machine(r, d, add_costs);
    doc_begin_chapter(d, TEXT_APPENDIX);
    doc_add_section(d, "source", "Source");
    doc_add_source(d, r->analysis.p->src);
    add_for_each_machine(r, d, add_source);
    return d;
}
