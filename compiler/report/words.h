// SPDX-License-Identifier: Apache-2.0
// What a machine does, in sentences, with its author's comments.
#ifndef SMC_WORDS_H
#define SMC_WORDS_H

#include "compiler/report/doc.h"
#include "compiler/sema/program.h"

// Adds a description of a block, one line per statement: "leaves for ^Hold^ if `pressure > 500`".
void words_block(DocList *l, const Stmts *block);

// "the average of `pressure` over the last 10 steps".
const char *words_window(Arena *arena, const Window *w);
// "1 state", "2 states".
const char *words_count(Arena *arena, size_t n, const char *one, const char *many);

// ---- comments; NULL if there is none ----

const char *comment_behind(Arena *arena, Span span);      // after the code on the first line of `span`
const char *comment_above(Arena *arena, Span span);       // on the lines directly above it that contain only a comment
const char *comment_beside(Arena *arena, Span span);      // after the code, on each of its lines
const char *comment_at(Arena *arena, Span span);          // above and beside
const char *comment_of_file(Arena *arena, const Source *src);     // on the first lines of the file
// The start of the line of the `else` whose first statement is `first`; `first` itself if it is on that line.
Span comment_else(Span first);
bool comment_starts(const char *line, uint32_t len, uint32_t *at);        // finds the start of a line's comment; false: it has none

#endif
