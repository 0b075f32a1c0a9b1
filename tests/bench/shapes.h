// SPDX-License-Identifier: Apache-2.0
// Machines of any size, and mistakes in any number, for measuring how the compiler does with them.
#ifndef BENCH_SHAPES_H
#define BENCH_SHAPES_H

#include "compiler/compile.h"

typedef void WriteFn(Buf *b, unsigned n);

typedef struct Shape {
    const char *name;
    WriteFn *write;           // the machine
    unsigned n;               // the smaller size
    WriteFn *sv, *ss;         // a state vector and a script beside it; or NULL
    unsigned left_out;        // groups of warnings that the bench of growth does not check, as 1u << DiagGroup
} Shape;

extern const Shape shapes[];
extern const size_t shapes_n;
const Shape *shape_find(const char *name);                // NULL when there is none

// What `write` writes at size n, in the session's memory; NULL when write is.
const Source *shape_source(Session *s, const char *name, WriteFn *write, unsigned n);

// One block of memory that every session uses again, so that the time of the system's page allocation is not measured.
bool pool_open(void);
void pool_empty(void);
size_t pool_used(void);
void *pool_alloc(void *context, void *old, size_t size);  // an SmcAllocFn; nothing is given back

#endif
