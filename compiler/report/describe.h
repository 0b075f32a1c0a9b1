// SPDX-License-Identifier: Apache-2.0
// Describes what a machine does, in sentences, with the comments of its author.
#ifndef SMC_DESCRIBE_H
#define SMC_DESCRIBE_H

#include "compiler/report/doc.h"
#include "compiler/sema/program.h"

// Adds a description of a block, one line per statement: "goes to ^Hold^ if `pressure > 500`".
void describe_block(DocList *l, const Stmts *block);

// "the average of `pressure` over the last 10 steps"; for a window in time "over the last 2 s, 101 samples".
const char *describe_window(Arena *arena, const Program *p, const Window *w);
// A number of units of the machine's time G, in the largest unit up to the second that it has at least one of: "1.5 s", "20 ms".
const char *describe_time(Arena *arena, const Program *p, uint64_t units);
// Separates item i of n in a sentence: "", ", " or " and ".
const char *describe_separator(size_t i, size_t n);
// "1 state", "2 states".
const char *describe_count(Arena *arena, uint64_t n, const char *one, const char *many);

#endif
