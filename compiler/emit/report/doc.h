// SPDX-License-Identifier: Apache-2.0
// A report between what is said and how it looks: sections of paragraphs, tables, lists and figures.  Who has something to say
// builds it; doc_html.c, doc_text.c and doc_json.c each write all of it.
//
// Texts may hold `code` in backticks, and ^Name^ for a state, so they are ours; what an author of a machine wrote goes in as plain
// text or code.
#ifndef SMC_DOC_H
#define SMC_DOC_H

#include <stdbool.h>

#include "compiler/base/buf.h"
#include "compiler/base/source.h"
#include "compiler/base/vec.h"

typedef enum DocCellKind {
    CELL_TEXT,                // may hold `code`
    CELL_PLAIN,               // as it is
    CELL_CODE,
    CELL_NUMBER,
    CELL_BAR,                 // a number, shown beside a bar of its share in `most`
    CELL_LINE,                // the number of a line of the source; 0: none
    CELL_STATE                // a state's name
} DocCellKind;

typedef struct DocCell {
    DocCellKind kind;
    const char *text;
    uint64_t number, most;
} DocCell;

typedef struct DocColumn { const char *key, *title; } DocColumn;

typedef struct DocTable {
    Arena *arena;
    const char *key;          // its name in JSON, unique in its section
    const DocColumn *column;
    size_t columns;
    bool facts;               // names and values: shown without a head
    bool narrow;              // no wider than it has to be
    VEC(DocCell) cell;        // row by row
} DocTable;

typedef struct DocLine {
    unsigned depth;           // 0: the outermost
    const char *text;
    uint32_t line;            // of the source; 0: none
    const char *comment;      // plain: what its author wrote above it; or NULL
} DocLine;

typedef struct DocList {
    Arena *arena;
    const char *key;
    const char *label;        // before it, as "When it enters"; or NULL
    VEC(DocLine) line;
} DocList;

typedef enum DocKind {
    DOC_HEADING,              // text; id: what links lead to, or NULL
    DOC_PARAGRAPH,            // text
    DOC_QUOTE,                // plain: words of the machine's author
    DOC_TABLE,
    DOC_LIST,
    DOC_EXCERPT,              // a line of a source with a part of it marked; text: plain, behind the mark, or NULL
    DOC_FIGURE,               // text: SVG, for HTML alone; caption
    DOC_SOURCE                // a whole source, for HTML alone
} DocKind;

typedef struct DocPart {
    DocKind kind;
    const char *id, *text;
    bool plain;               // HEADING, PARAGRAPH: the text has no marks
    const char *state;        // HEADING: of a state
    const char *tone;         // HEADING: "good", "bad", "note": a badge's colour; badge: its text; or NULL
    const char *badge;
    bool low;                 // FIGURE: on paper it takes a part of a page, so that it need not begin a new one
    DocTable *table;
    DocList *list;
    Span span;                // EXCERPT
    const Source *source;     // SOURCE
} DocPart;

typedef struct DocSection {
    const char *id, *title;
    VEC(DocPart) part;
} DocSection;

typedef struct Doc {
    Arena *arena;
    const char *title;
    const char *subtitle;
    const char *maker;        // "smc 0.1"
    VEC(DocSection *) section;
} Doc;

// ---- building: each adds to the end of the last section ----

void doc_section(Doc *d, const char *id, const char *title);
DocPart *doc_heading(Doc *d, const char *id, const char *text);        // good until the next part
void doc_paragraph(Doc *d, const char *text);
void doc_plain(Doc *d, const char *text);             // a paragraph without marks
void doc_quote(Doc *d, const char *plain);            // nothing of NULL and ""
void doc_excerpt(Doc *d, Span span, const char *label);
DocPart *doc_figure(Doc *d, const char *svg, const char *caption);     // good until the next part
void doc_source(Doc *d, const Source *src);
DocTable *doc_table(Doc *d, const char *key, const DocColumn *column, size_t columns);
DocList *doc_list(Doc *d, const char *key, const char *label);

#define DOC_TABLE_OF(d, key, column) doc_table((d), (key), (column), sizeof(column) / sizeof(column)[0])

// The next cell of a table.
void cell_text(DocTable *t, const char *text);
void cell_plain(DocTable *t, const char *text);
void cell_code(DocTable *t, const char *text);
void cell_number(DocTable *t, uint64_t n);
void cell_bar(DocTable *t, uint64_t n, uint64_t most);
void cell_line(DocTable *t, uint32_t line);
void cell_state(DocTable *t, const char *name);

void list_line(DocList *l, unsigned depth, uint32_t line, const char *text);
void list_comment(DocList *l, const char *plain);     // to the line before

// ---- writing ----

// By column, whether any row says something in it.  JSON has them all.
bool *doc_columns_used(const DocTable *t);
const char *doc_unmarked(Arena *arena, const char *text);         // ^Name^ as `Name`, for who has no links

void doc_write_html(const Doc *d, Buf *out);
void doc_write_text(const Doc *d, Buf *out);
void doc_write_json(const Doc *d, Buf *out);

// Text in HTML, and in the values of attributes.  What would not be seen or would turn the writing is spelled out.
void html_put(Buf *out, const char *text, size_t n);
void html_str(Buf *out, const char *text);

#endif
