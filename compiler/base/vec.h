// SPDX-License-Identifier: Apache-2.0
// Growable arrays in an arena: a count, a capacity and the items.  VEC(T) declares one; zeroed memory is an empty array.
#ifndef SMC_VEC_H
#define SMC_VEC_H

#include <stddef.h>
#include <stdint.h>

#include "compiler/base/arena.h"

#define VEC(T) struct { T *at; uint32_t n, cap; }

// Appends one item.  Items move when the array grows: store indices of items, not pointers to them.
#define vec_push(arena, v, item)                                                                        \
    ((v)->n == (v)->cap ? vec_reserve((arena), (void **)&(v)->at, &(v)->cap, sizeof *(v)->at) : (void)0, \
     (v)->at[(v)->n++] = (item))

// How many items fit in the allocation for n items: the arena rounds its size up to ARENA_ALIGN.
#define vec_room(n, item_size) ((uint32_t)(((n) * (item_size) + ARENA_ALIGN - 1) / ARENA_ALIGN * ARENA_ALIGN / (item_size)))

void vec_reserve(Arena *a, void **items, uint32_t *cap, size_t item_size);   // doubles the capacity; what it adds is not zeroed

#endif
