// SPDX-License-Identifier: Apache-2.0
// Growable arrays in an arena: a count, a capacity and the items.  VEC(T) declares one; zeroed memory is an empty one.
#ifndef SMC_VEC_H
#define SMC_VEC_H

#include <stddef.h>

#include "compiler/base/arena.h"

#define VEC(T) struct { T *at; size_t n, cap; }

// Appends one item.  Items move when the array grows: keep indices, not pointers.
#define vec_push(arena, v, item)                                                                        \
    ((v)->n == (v)->cap ? vec_reserve((arena), (void **)&(v)->at, &(v)->cap, sizeof *(v)->at) : (void)0, \
     (v)->at[(v)->n++] = (item))

// What a list of n items may hold in the same memory: none shorter ends where another begins (arena.c aligns to 16).
#define vec_room(n, item_size) (((n) * (item_size) + 15) / 16 * 16 / (item_size))

void vec_reserve(Arena *a, void **items, size_t *cap, size_t item_size);   // doubles the capacity

#endif
