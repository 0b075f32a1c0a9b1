// SPDX-License-Identifier: Apache-2.0
// The trace of a script: its values after every step, as CSV for spreadsheets and data tools, or bit-exact.
#include <inttypes.h>
#include <string.h>

#include "compiler/script/script.h"

// Whether a variable has the same name as one of the columns that are not variables, such as the step.
static bool is_fixed_column_name(const Program *p, const Var *v, bool has_requirements)
{
    const char *name = v->report_name->text;

    for (size_t i = 0; p->joint && i < p->joint->member.n; i++)
        if (strcmp(name, p->joint->member.at[i].name->text) == 0)
            return true;
    return strcmp(name, "script") == 0 || strcmp(name, "step") == 0 || strcmp(name, "state") == 0 ||
           (has_requirements && strcmp(name, "violated") == 0);
}

void script_trace_header(Buf *out, const Program *p, const Var *const *column, size_t n, const Requirements *rq)
{
    buf_str(out, p->joint ? "script,step,G" : "script,step,G,state");
    for (size_t i = 0; p->joint && i < p->joint->member.n; i++)
        buf_printf(out, ",%s", p->joint->member.at[i].name->text);
    for (size_t i = 0; i < n; i++) {
        buf_char(out, ',');
        if (is_fixed_column_name(p, column[i], rq != NULL)) {
            buf_str(out, p->name->text);
            buf_char(out, '.');
        }
        buf_str(out, column[i]->report_name->text);
    }
    buf_str(out, rq ? ",violated\n" : "\n");
}

// Appends a CSV field, quoted if necessary.
static void append_csv_field(Buf *out, const char *text)
{
    if (!strpbrk(text, ",\"\r\n")) {
        buf_str(out, text);
        return;
    }
    buf_char(out, '"');
    for (; *text; text++) {
        if (*text == '"')
            buf_char(out, '"');
        buf_char(out, *text);
    }
    buf_char(out, '"');
}

// Appends the name of the machine's state as a column; for an application, a column for each machine.
static void append_states(Buf *out, const ScriptStep *step)
{
    const Program *p = step->program;

    if (!step->states)
        buf_printf(out, ",%s", step->state->name->text);
    for (size_t i = 0; step->states && i < p->joint->member.n; i++)
        buf_printf(out, ",%s", step->states[i]->name->text + p->joint->member.at[i].name->len + 1);
}

// Appends the ids of the requirements that the step has violated, with spaces between them.
static void append_violated(Buf *out, const Requirements *rq, const uint8_t *results)
{
    const char *between = ",";

    for (size_t i = 0; i < rq->at.n; i++)
        if (results[i] == MONITOR_VIOLATED) {
            buf_printf(out, "%s%s", between, rq->at.at[i].id->text);
            between = " ";
        }
    if (between[0] == ',')
        buf_char(out, ',');
}

void script_trace_row(Buf *out, const char *script, const ScriptStep *step, const Var *const *column, size_t n, const Requirements *rq)
{
    append_csv_field(out, script);
    buf_printf(out, ",%" PRIu64 ",%" PRIu64, step->number, step->g);
    append_states(out, step);
    for (size_t i = 0; i < n; i++) {
        const uint64_t cell = step->cell[column[i]->index];
        size_t start;
        buf_char(out, ',');
        start = out->n;
        if (column[i]->type == SM_BOOL)
            buf_char(out, cell ? '1' : '0');
        else
            format_cell_shortest(out, column[i]->type, cell);
        if (out->n == start + 2 && memcmp(out->at + start, "-0", 2) == 0)      // a reader of integers would convert it to 0
            buf_str(out, ".0");
    }
    if (rq)
        append_violated(out, rq, step->results);
    buf_char(out, '\n');
}

// Appends a line `STEP NAME VALUE` for each variable of `order`.
void script_trace_exact(Buf *out, const ScriptStep *step, const Var *const *order, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        buf_printf(out, "%" PRIu64 " %s ", step->number, order[i]->report_name->text);
        format_cell_exact(out, order[i]->type, step->cell[order[i]->index]);
        buf_char(out, '\n');
    }
}
