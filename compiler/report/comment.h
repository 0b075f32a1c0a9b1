// SPDX-License-Identifier: Apache-2.0
// The comments that the author of a machine wrote beside its parts.  The parser does not store comments: these functions find them in the source, by
// line.
#ifndef SMC_COMMENT_H
#define SMC_COMMENT_H

#include <stdbool.h>

#include "compiler/base/buf.h"
#include "compiler/base/source.h"
#include "compiler/sema/program.h"

// Each returns NULL if there is no comment.
const char *comment_after(Arena *arena, Span span);       // after the code on the first line of `span`
const char *comment_above(Arena *arena, Span span);       // on the lines directly above it that contain only a comment
const char *comment_after_lines(Arena *arena, Span span);  // after the code, on each of its lines
const char *comment_around(Arena *arena, Span span);      // above and after
const char *comment_of_file(Arena *arena, const Source *src);     // on the first lines of the file
const char *comment_of_variable(Arena *arena, const Var *v);       // at its declaration in the machine, otherwise in the state vector
// Returns the start of the line of the `else` whose first statement is `first`; `first` itself if it is on that line.
Span comment_else_line(Span first);
bool comment_find_start(const char *line, uint32_t len, uint32_t *at);    // sets *at to the index of the comment's '#'; false: no comment

#endif
