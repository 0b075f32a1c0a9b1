// SPDX-License-Identifier: Apache-2.0
// Costs: the longest steps with their most expensive lines, and bytes.
#include "compiler/budget/cycles.h"
#include "compiler/report/comment.h"
#include "compiler/report/describe.h"
#include "compiler/report/page.h"
#include "compiler/report/page_text.h"

static const DocColumn step_columns[] = {
    {"state", "State"}, {"first", "First step"}, {"later", "Later steps"}, {"lines", "Most expensive lines of the longest step"},
    {"cycles", "Cycles on an Uno"}};
static const DocColumn byte_columns[] = {{"part", "Part"}, {"bytes", "Bytes"}};
static const DocColumn board_columns[] = {{"part", "Part"}, {"value", "Value"}};
static const DocColumn longest_columns[] = {{"block", "Block"}, {"line", "Line"}, {"text", "Statement"}, {"instructions", "Instructions"}};

// ---- where the time goes ----

const char *report_format_cycles(const Report *r, uint32_t cycles)
{
    enum { MHZ = 16 };                                // of a stock Uno
    const unsigned long hundredths = (cycles + 10 * MHZ - 1) / (10 * MHZ);

    return format_in(r->arena, "%lu cycles, %lu.%02lu ms", (unsigned long)cycles, hundredths / 100, hundredths % 100);
}

static const char *expensive_lines_text(const Report *r, const StateCost *s)
{
    enum { SHOWN = 3 };
    const CostLine *l = NULL;
    Buf b;

    buf_init(&b, r->arena);
    for (int i = 0; i < SHOWN && (l = cost_next_most_expensive(s, l)) != NULL; i++)
        buf_printf(&b, "%sline %lu%s: %lu", b.n ? ", " : "", (unsigned long)l->line, l->part == COST_SAMPLE ? " (samples)" : "",
                   (unsigned long)l->units);
    return buf_text(&b);
}

static void add_steps(const Report *r, Doc *d)
{
    const Cost *c = &r->cost;
    DocTable *t = DOC_ADD_TABLE(d, "steps", step_columns);

    for (uint32_t i = 0; i < c->states; i++) {
        doc_add_state_cell(t, r->analysis.p->state.at[i]->name->text);
        doc_add_bar_cell(t, c->state[i].first, c->worst);
        doc_add_bar_cell(t, c->state[i].later, c->worst);
        doc_add_plain_cell(t, expensive_lines_text(r, &c->state[i]));
        doc_add_number_cell(t, r->eeprom.state[i].worst);
    }
}

// ---- the longest step of all ----

static const char *line_text(const Report *r, uint32_t line)     // line 0: shared by several lines
{
    uint32_t len, at;
    const char *text;

    if (line == 0)
        return "-> of several lines";
    text = source_line(r->analysis.p->src, line, &len);
    if (comment_find_start(text, len, &at))
        len = at;
    while (len > 0 && is_space_or_tab(text[len - 1]))
        len--;
    while (len > 0 && is_space_or_tab(*text))
        text++, len--;
    return format_in(r->arena, "%.*s", (int)len, text);
}

static void add_longest_step(const Report *r, Doc *d)
{
    enum { SHOWN = 60 };
    static const char *const block[] = {".entry", ".step", ".exit", "samples"};
    const StateCost *s = &r->cost.state[r->cost.worst_state - 1];
    DocTable *t;

    doc_add_heading(d, "longest",
                    format_in(r->arena, "The longest step, in ^%s^", r->analysis.p->state.at[r->cost.worst_state - 1]->name->text));
    t = DOC_ADD_TABLE(d, "longest", longest_columns);
    for (size_t i = 0; i < s->path.n && i < SHOWN; i++) {
        doc_add_plain_cell(t, block[s->path.at[i].part]);
        doc_add_line_cell(t, s->path.at[i].line);
        doc_add_code_cell(t, line_text(r, s->path.at[i].line));
        doc_add_number_cell(t, s->path.at[i].units);
    }
    if (s->path.n > SHOWN)
        doc_add_paragraph(d, format_in(r->arena, "And %lu more.", (unsigned long)(s->path.n - SHOWN)));
}

// ---- a board ----

enum { UNO_RAM = 2048 };              // bytes

bool report_fits_uno(const Report *r) { return r->cost.windows_small < UNO_RAM; }

static void add_board(const Report *r, Doc *d)
{
    DocTable *t;

    doc_add_heading(d, "board", "On an Arduino Uno");
    doc_add_paragraph(d, TEXT_COSTS_BOARD);
    t = DOC_ADD_TABLE(d, "board", board_columns);
    t->narrow = true;
    doc_add_plain_cell(t, "Longest step, image in EEPROM");
    doc_add_plain_cell(t, report_format_cycles(r, r->eeprom.worst));
    doc_add_plain_cell(t, "Longest step, image in flash");
    doc_add_plain_cell(t, report_format_cycles(r, r->flash.worst));
    doc_add_plain_cell(t, "Stack of a step, largest measured");
    doc_add_plain_cell(t, format_in(r->arena, "%lu bytes", (unsigned long)cycles_stack_bytes()));
    if (report_fits_uno(r))
        return;
    doc_add_plain_cell(t, "Windows alone");
    doc_add_plain_cell(t, "more than its 2048 bytes of memory");
}

// ---- bytes ----

static void add_bytes_row(DocTable *t, const char *part, uint32_t n)
{
    doc_add_plain_cell(t, part);
    doc_add_number_cell(t, n);
}

static void add_bytes(const Report *r, Doc *d)
{
    const Cost *c = &r->cost;
    DocTable *t;

    doc_add_heading(d, "bytes", "Memory");
    doc_add_paragraph(d, TEXT_COSTS_MEMORY);
    t = DOC_ADD_TABLE(d, "bytes", byte_columns);
    t->narrow = true;
    add_bytes_row(t, "Windows of rolling statistics", c->windows);
    add_bytes_row(t, "Locals and temporary values", c->locals);
    add_bytes_row(t, "State of the VM", c->own);
    add_bytes_row(t, "RAM in total", c->ram);
    add_bytes_row(t, "State vector", r->analysis.p->sv->size);
    add_bytes_row(t, "Image, in flash or RAM", (uint32_t)r->image_size);
    add_bytes_row(t, "of which code", c->code);
}

void report_add_costs(Report *r, Doc *d)
{
    doc_add_section(d, "cost", "Costs");
    doc_add_paragraph(d, TEXT_COSTS);
    if (r->cost.sample)
        doc_add_paragraph(d, format_in(r->arena, TEXT_COSTS_SAMPLES,
                                       describe_count(r->arena, r->cost.sample, "instruction", "instructions")));
    add_steps(r, d);
    add_longest_step(r, d);
    add_board(r, d);
    add_bytes(r, d);
}
