// SPDX-License-Identifier: Apache-2.0
// Costs: the longest steps with their most expensive lines, and bytes.
#include "compiler/budget/board.h"
#include "compiler/budget/cycles.h"
#include "compiler/report/comment.h"
#include "compiler/report/describe.h"
#include "compiler/report/page.h"
#include "compiler/report/page_text.h"

static const DocColumn step_columns[] = {
    {"state", "State"}, {"first", "First step"}, {"later", "Later steps"}, {"lines", "Most expensive lines of the longest step"},
    {"cycles", "Cycles on AVR"}};
static const DocColumn byte_columns[] = {{"part", "Part"}, {"bytes", "Bytes"}};
static const DocColumn board_columns[] = {{"part", "Part"}, {"value", "Value"}};
static const DocColumn longest_columns[] = {{"block", "Block"}, {"line", "Line"}, {"text", "Statement"}, {"instructions", "Instructions"}};

// ---- where the time goes ----

// Returns the time of the longest step of all states, at the clock of a stock Uno or Mega.
static const char *longest_step_time(const Report *r, const Cost *cycles)
{
    enum { MHZ = 16 };
    const unsigned long hundredths = (cycles->worst + 10 * MHZ - 1) / (10 * MHZ);

    return format_in(r->arena, "%lu cycles, %lu.%02lu ms, in %s", (unsigned long)cycles->worst, hundredths / 100, hundredths % 100,
                     r->analysis.p->state.at[cycles->worst_state - 1]->name->text);
}

// The three source lines that cost most in a step of the state, with the units of each.
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

// The costs of a step in each state, for the first step and later ones, as bars relative to the longest step; then the lines that cost most.
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

// The lines that the longest step of the machine executes, in order; cut off after SHOWN.
static void add_longest_step(const Report *r, Doc *d)
{
    enum { SHOWN = 60 };
    static const char *const block[] = {".entry", ".step", ".exit", "samples"};
    const StateCost *s = &r->cost.state[r->cost.worst_state - 1];
    DocTable *t;

    if (s->path.n == 0)                                  // the machine has no statements
        return;
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

static uint32_t board_ram(const Report *r) { return r->analysis.p->sv->size + r->cost.locals + r->cost.windows_small; }

// Returns the smallest board whose firmware can run the machine; NULL if no board can.
static const Board *find_board(const Report *r) { return board_smallest((uint32_t)r->image_size, board_ram(r), r->cost.functions); }

// Returns the smallest board whose firmware has room for the machine, as "On an Arduino Uno"; "On an Arduino" if no board has enough room.
const char *report_board_name(const Report *r)
{
    const Board *board = find_board(r);

    return board ? format_in(r->arena, "On an Arduino %s", board->name) : "On an Arduino";
}

const char *report_board_time(const Report *r)
{
    return find_board(r) ? format_in(r->arena, "about %s", longest_step_time(r, &r->eeprom)) : "does not fit into its memory";
}

static void add_board(const Report *r, Doc *d)
{
    const Board *board = find_board(r), *limits = board ? board : board_largest();
    DocTable *t;

    doc_add_heading(d, "board", report_board_name(r));
    if (board)
        doc_add_legend(d, TEXT_COSTS_BOARD);
    t = DOC_ADD_TABLE(d, "board", board_columns);
    t->narrow = true;
    if (board) {
        doc_add_plain_cell(t, "Longest step, image in EEPROM");
        doc_add_plain_cell(t, longest_step_time(r, &r->eeprom));
        doc_add_plain_cell(t, "Longest step, image in flash");
        doc_add_plain_cell(t, longest_step_time(r, &r->flash));
        doc_add_plain_cell(t, "Stack of a step, largest measured");
        doc_add_plain_cell(t, format_in(r->arena, "%lu bytes", (unsigned long)cycles_stack_bytes(r->eeprom.functions != 0)));
    }
    doc_add_plain_cell(t, "RAM of state vector, locals and windows");
    doc_add_plain_cell(t, format_in(r->arena, "%lu bytes of at most %lu", (unsigned long)board_ram(r), (unsigned long)limits->ram));
    doc_add_plain_cell(t, "Image");
    doc_add_plain_cell(t, format_in(r->arena, "%lu bytes of at most %lu", (unsigned long)r->image_size, (unsigned long)limits->image));
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
    doc_add_legend(d, TEXT_COSTS_MEMORY);
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
    doc_add_legend(d, TEXT_COSTS);
    if (r->cost.sample)
        doc_add_paragraph(d, format_in(r->arena, TEXT_COSTS_SAMPLES,
                                       describe_count(r->arena, r->cost.sample, "instruction", "instructions")));
    add_steps(r, d);
    add_longest_step(r, d);
    add_board(r, d);
    add_bytes(r, d);
}
