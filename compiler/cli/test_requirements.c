// SPDX-License-Identifier: Apache-2.0
// The table of requirements of smc test: where each is implemented, which scripts and asserts test it, how often it was judged, and the result.
#include <string.h>

#include "compiler/base/path.h"
#include "compiler/cli/test.h"

struct RequirementTable {
    TestRun *t;
    const Requirements *what;
    RequirementTotal *total;  // by requirement: how often it was judged and violated
    Buf *judged, *asserts;    // by requirement: TestRequirement.judged and .asserts
    bool *visited;            // by State.number - 1: a script came to the state
    Map number;               // from the id of a requirement to a pointer into `ids`
    size_t *ids;              // 1 + the index of the requirement
};

// Begins the table of the requirements `what`; without any (NULL) it stays empty.
RequirementTable *test_requirements_begin(TestRun *t, const Requirements *what)
{
    RequirementTable *table = ARENA_NEW(t->arena, RequirementTable);

    table->t = t;
    table->what = what;
    table->number.arena = t->arena;
    if (!what)
        return table;
    table->total = ARENA_ARRAY(t->arena, RequirementTotal, what->at.n);
    table->judged = ARENA_ARRAY(t->arena, Buf, what->at.n);
    table->asserts = ARENA_ARRAY(t->arena, Buf, what->at.n);
    table->ids = ARENA_ARRAY(t->arena, size_t, what->at.n);
    table->visited = ARENA_ARRAY(t->arena, bool, what->program->state.n);
    for (size_t i = 0; i < what->at.n; i++) {
        buf_init(&table->judged[i], t->arena);
        buf_init(&table->asserts[i], t->arena);
        table->ids[i] = i;
        map_put(&table->number, what->at.at[i].id, &table->ids[i]);
    }
    return table;
}

// Appends `path:line` and the result to a list, unless it is the last entry.
static void append_source_line(Arena *arena, Buf *list, Span span, const char *result)
{
    const char *place = format_in(arena, "%s:%lu%s", source_short_name(span.src), (unsigned long)source_position(span.src, span.at).line,
                                  result);
    const size_t n = strlen(place);

    if (list->n >= n && memcmp(list->at + list->n - n, place, n) == 0)
        return;
    buf_printf(list, "%s%s", list->n ? ", " : "", place);
}

// Adds the asserts of a script that test requirements and were evaluated.
static void add_asserts(RequirementTable *table, const Script *s, const ScriptResult *r)
{
    for (size_t i = 0; i < s->section.n; i++)
        for (size_t k = 0; k < s->section.at[i].item.n; k++) {
            const ScriptItem *item = s->section.at[i].item.at[k];
            for (size_t n = 0; n < item->asserts.n; n++) {
                const ScriptAssert *a = &item->asserts.at[n];
                const size_t *number = a->remark && a->remark->requirement ? map_find(&table->number, a->remark->requirement) : NULL;
                if (number && (a->kind == SCRIPT_FAIL || r->evaluated[item->first_assert + n]))
                    append_source_line(table->t->arena, &table->asserts[*number], a->remark->span,
                              r->failed_asserts[item->first_assert + n] ? " (failed)" : "");
            }
        }
}

// Adds what the run of a script has judged and asserted.
void test_requirements_add(RequirementTable *table, const Script *s, const ScriptResult *r)
{
    if (!table->what)
        return;
    requirement_add_run(table->total, table->what, r);
    requirement_add_visits(table->visited, table->what->program, r);
    for (size_t i = 0; i < table->what->at.n; i++)
        if (r->requirement[i].judged)
            buf_printf(&table->judged[i], "%s%s: %llu", table->judged[i].n ? ", " : "", source_short_name(s->src),
                       (unsigned long long)r->requirement[i].judged);
    add_asserts(table, s, r);
}

static const char *list_marks(Arena *arena, const Program *p, Str id)
{
    Buf out;

    buf_init(&out, arena);
    for (size_t i = 0; i < p->mark.n; i++)
        if (p->mark.at[i].requirement == id)
            append_source_line(arena, &out, p->mark.at[i].span, "");
    return buf_text(&out);
}

// Reports what no script has judged, and stores the rows in t->requirement. complete: all scripts have reached a @stop.
void test_requirements_end(RequirementTable *table, bool complete)
{
    TestRun *t = table->t;

    if (complete)
        requirement_report_unjudged(&t->c->session.diags, table->what, table->total);
    for (size_t i = 0; i < table->what->at.n; i++) {
        const Requirement *r = &table->what->at.at[i];
        const TestRequirement row = {r, table->total[i], list_marks(t->arena, table->what->program, r->id), buf_text(&table->judged[i]),
                                     requirement_unvisited(t->arena, r, table->what->program, table->visited), buf_text(&table->asserts[i])};
        vec_push(t->arena, &t->requirement, row);
    }
}

// ---- for people ----

static size_t max_size(size_t a, size_t b) { return a > b ? a : b; }

static void write_detail(Buf *out, size_t indent, const char *what, const char *places)
{
    if (!*places)
        return;
    buf_spaces(out, indent);
    buf_printf(out, "%s %s\n", what, places);
}

static bool has_marks(const TestRun *t)
{
    for (size_t i = 0; i < t->requirement.n; i++)
        if (*t->requirement.at[i].implemented)
            return true;
    return false;
}

// Writes a line for each requirement with its id, the result and its text; below it how often each script judged it, and where it is implemented and
// tested.
void test_requirements_write(const TestRun *t, Buf *out)
{
    const bool marks = has_marks(t);
    size_t id = 0, verdict = 0;

    for (size_t i = 0; i < t->requirement.n; i++) {
        id = max_size(id, t->requirement.at[i].what->id->len);
        verdict = max_size(verdict, strlen(requirement_verdict(&t->requirement.at[i].total)));
    }
    if (t->requirement.n)
        buf_str(out, "requirements:\n");
    for (size_t i = 0; i < t->requirement.n; i++) {
        const TestRequirement *r = &t->requirement.at[i];
        buf_printf(out, "  %-*s  %-*s  %s\n", (int)id, r->what->id->text, (int)verdict, requirement_verdict(&r->total), r->what->text->text);
        write_detail(out, id + 4, "judged in", r->judged);
        write_detail(out, id + 4, "no script came to", r->unvisited);
        write_detail(out, id + 4, "tested by", r->asserts);
        if (marks)
            write_detail(out, id + 4, "implemented", *r->implemented ? format_in(t->arena, "in %s", r->implemented) : "nowhere");
    }
}
