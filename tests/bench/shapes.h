// SPDX-License-Identifier: Apache-2.0
// Machines of any size, and any number of mistakes, to measure how the cost of the compiler grows.
#ifndef BENCH_SHAPES_H
#define BENCH_SHAPES_H

#include "compiler/compile.h"

typedef void WriteFn(Buf *b, unsigned n);

typedef struct Shape {
    const char *name;
    WriteFn *write;           // writes the machine
    unsigned n;               // the smaller of the two sizes
    WriteFn *sv, *ss;         // write its state vector and its script; NULL: it has none
    unsigned left_out;        // groups of warnings that the benchmark of growth does not check, as 1u << DiagGroup
} Shape;

extern const Shape shapes[];
extern const size_t shapes_n;
const Shape *shape_find(const char *name);                // NULL when there is none

// Returns what `write` writes at size n, in the session's memory; NULL if `write` is NULL.
const Source *shape_source(Session *s, const char *name, WriteFn *write, unsigned n);

// One block of memory that all sessions use in turn, so that the time in which the system allocates pages is not measured.
bool pool_open(void);
void pool_empty(void);
size_t pool_used(void);
void *pool_alloc(void *context, void *old, size_t size);  // an SmcAllocFn that gives no memory back to the system

#endif
