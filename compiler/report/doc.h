// SPDX-License-Identifier: Apache-2.0
// The content of a report, independent of its output format: sections of paragraphs, tables, lists and figures.  The sections of a report
// build it; doc_html.c, doc_text.c and doc_json.c each write the whole document.
//
// A parameter or field `text` has markup: `code` in backticks, and ^Name^ for a state.  So it must be the compiler's own words.  What the author of
// a machine wrote has no markup; pass it where a function accepts plain text (`plain`) or code.
#ifndef SMC_DOC_H
#define SMC_DOC_H

#include <stdbool.h>

#include "compiler/base/buf.h"
#include "compiler/base/source.h"
#include "compiler/base/vec.h"

typedef enum DocCellKind {
    CELL_TEXT,                // text that can contain `code`
    CELL_PLAIN,               // plain text, written unchanged
    CELL_CODE,
    CELL_NUMBER,
    CELL_TARGET,              // a number to which cells with the same `link` lead
    CELL_BAR,                 // a number, with a bar that shows its share of `most`
    CELL_LINE,                // a line number in the source; 0: none
    CELL_STATE,               // a state's name
    CELL_SECTION,             // the title of a section of this page
    CELL_BADGE                // a word with a colour; "": none
} DocCellKind;

typedef struct DocCell {
    DocCellKind kind;
    const char *text;
    uint64_t number, most;    // NUMBER, TARGET, BAR, LINE: the number; BAR: the number of a full bar
    const char *link;         // SECTION: its id; TARGET: its own id; BADGE: the id that it links to, or NULL
    const char *tone;         // BADGE: its colour, as DocPart.tone
} DocCell;

typedef struct DocColumn { const char *key, *title; } DocColumn;

typedef struct DocTable {
    Arena *arena;
    const char *key;          // the table's name in JSON, unique in its section
    const DocColumn *column;
    size_t columns;
    bool facts;               // pairs of name and value: shown without column titles
    bool narrow;              // no wider than necessary
    bool dense;               // many columns with short words: smaller
    bool upright;             // dense, with so many columns that their titles are written downwards
    bool last_on_screen;      // the last column is not printed on paper
    bool folds;               // the first rows matter most: HTML shows the others of a long table only when the reader opens them
    VEC(DocCell) cell;        // the cells, row by row
} DocTable;

typedef struct DocLine {
    unsigned depth;           // nesting depth in the list; 0: outermost
    const char *text;
    uint32_t line;            // line of the source; 0: none
    const char *comment;      // the author's comment, plain text; or NULL
} DocLine;

typedef struct DocList {
    Arena *arena;
    const char *key;          // the list's name in JSON, unique in its section
    const char *label;        // precedes the list, such as "On entry, the machine"; or NULL
    VEC(DocLine) line;
} DocList;

// The kinds of parts.  `text`, `id` and so on are members of DocPart.
typedef enum DocKind {
    DOC_HEADING,              // `text`, with a badge if `badge` is set; links refer to it by `id`, unless that is NULL
    DOC_PARAGRAPH,            // `text`
    DOC_QUOTE,                // `text`, plain text by the machine's author
    DOC_TABLE,                // `table`
    DOC_LIST,                 // `list`
    DOC_EXCERPT,              // a line of a source with `span` marked, followed by the plain `text`, unless that is NULL
    DOC_LINES,                // `text`, plain lines that are shown unchanged
    DOC_FIGURE,               // `text`, an SVG, with `caption`; only in HTML
    DOC_SOURCE                // `source`, complete; only in HTML
} DocKind;

typedef enum DocFigure {
    FIGURE_PLOT,              // as wide as the text
    FIGURE_DIAGRAM,           // can be wider than the text; on paper it has a page of its own
    FIGURE_LOW,               // a diagram that is legible on part of a printed page
    FIGURE_TALL,              // a diagram too high for a page: on paper it is replaced by DocPart.print, slices for upright pages
    FIGURE_LARGE              // a diagram too wide for a page: on paper it is replaced by DocPart.print, slices for landscape pages
} DocFigure;

typedef struct DocPart {
    DocKind kind;
    const char *id, *text;
    bool plain;               // HEADING, PARAGRAPH: the text has no markup
    const char *state;        // HEADING: the name of its state
    const char *tone;         // HEADING: the badge's colour, "good", "bad" or "note"
    const char *badge;        // HEADING: text of a badge beside it; or NULL
    const char *caption;      // FIGURE: text below it; or NULL
    DocFigure figure;         // FIGURE: how it is laid out
    const char *print;        // FIGURE: an SVG that replaces `text` on paper; or NULL
    int32_t width;            // FIGURE: width of a diagram, in pixels
    DocTable *table;          // TABLE: the table
    DocList *list;            // LIST: the list
    Span span;                // EXCERPT: the marked part of the source
    const Source *source;     // SOURCE: the whole source
} DocPart;

typedef struct DocSection {
    const char *id, *title;
    const char *scope;        // the machine that the section is about, in a document about several; NULL: none
    const char *chapter;      // the title of the chapter that begins with this section; NULL: no chapter begins
    VEC(DocPart) part;
} DocSection;

typedef struct Doc {
    Arena *arena;
    const char *title;
    const char *subtitle;
    const char *maker;        // program and version: "smc 0.1"
    bool of_application;      // the document is about an application, not about one machine
    const char *chapter;      // the chapter that begins with the next section; NULL: none
    const char *scope;        // DocSection.scope of the next sections
    VEC(DocSection *) section;
    VEC(const char *) legend; // the texts of doc_add_legend so far
} Doc;

// ---- building: each adds to the end of the last section ----

// Begins a chapter with the next section.  A chapter without a section is left out.
void doc_begin_chapter(Doc *d, const char *title);
// With a scope, its name precedes id and title.  Parts of such a section link to sections of the same scope only.
void doc_add_section(Doc *d, const char *id, const char *title);
// Returns the id of a section in a scope; `id` if that is NULL.
const char *doc_scoped_id(Arena *arena, const char *scope, const char *id);
DocPart *doc_add_heading(Doc *d, const char *id, const char *text);        // the pointer is valid until the next part is added
void doc_add_paragraph(Doc *d, const char *text);
void doc_add_legend(Doc *d, const char *text);            // a paragraph that explains what follows; only the first time that a page has it
void doc_add_plain(Doc *d, const char *text);             // a paragraph without markup
void doc_add_quote(Doc *d, const char *plain);            // adds nothing for NULL and ""
void doc_add_excerpt(Doc *d, Span span, const char *label);
void doc_add_lines(Doc *d, const char *plain);            // lines shown as they are; adds nothing for ""
DocPart *doc_add_figure(Doc *d, const char *svg, const char *caption);     // the pointer is valid until the next part is added
void doc_add_source(Doc *d, const Source *src);
DocTable *doc_add_table(Doc *d, const char *key, const DocColumn *column, size_t columns);
DocList *doc_add_list(Doc *d, const char *key, const char *label);

#define DOC_ADD_TABLE(d, key, column) doc_add_table((d), (key), (column), sizeof(column) / sizeof(column)[0])

// Each adds a cell to the last row of a table, or to a new row if that is full.
void doc_add_text_cell(DocTable *t, const char *text);
void doc_add_plain_cell(DocTable *t, const char *text);
void doc_add_code_cell(DocTable *t, const char *text);
void doc_add_number_cell(DocTable *t, uint64_t n);
void doc_add_bar_cell(DocTable *t, uint64_t n, uint64_t most);
void doc_add_line_cell(DocTable *t, uint32_t line);
void doc_add_state_cell(DocTable *t, const char *name);
void doc_add_section_cell(DocTable *t, const char *title, const char *id);
void doc_add_badge_cell(DocTable *t, const char *word, const char *tone);
void doc_add_target_cell(DocTable *t, uint64_t n, const char *id);
void doc_add_linked_badge_cell(DocTable *t, const char *word, const char *tone, const char *id);

void doc_add_list_line(DocList *l, unsigned depth, uint32_t line, const char *text);
void doc_set_line_comment(DocList *l, const char *plain);  // sets DocLine.comment of the last line

// ---- writing ----

// Returns, by column, whether some row has content in the column.  Columns without content are omitted, except in JSON.
bool *doc_columns_used(const DocTable *t);
const char *doc_replace_links(Arena *arena, const char *text);         // writes ^Name^ as `Name`, for formats without links

void doc_write_html(const Doc *d, Buf *out);
void doc_write_text(const Doc *d, Buf *out);
void doc_write_json(const Doc *d, Buf *out);

#endif
