// SPDX-License-Identifier: Apache-2.0
// Queues of numbers below a limit, for iterations to a fixed point.  A number that is already in the queue is not added again.
#ifndef SMC_WORKLIST_H
#define SMC_WORKLIST_H

#include <stdbool.h>
#include <stdint.h>

#include "compiler/base/arena.h"
#include "compiler/base/bitset.h"

typedef struct Worklist {
    uint32_t *at;                     // a ring buffer
    bool *queued;                     // queued[number]: `number` is in the queue
    size_t first, n, limit;
} Worklist;

static inline Worklist worklist_new(Arena *arena, size_t limit)
{
    return (Worklist){ARENA_ARRAY(arena, uint32_t, limit), ARENA_ARRAY(arena, bool, limit), 0, 0, limit};
}

// Adds a number at the end, unless it is in the queue.
static inline void worklist_add(Worklist *w, uint32_t number)
{
    if (w->queued[number])
        return;
    w->queued[number] = true;
    w->at[(w->first + w->n++) % w->limit] = number;
}

// Removes and returns the number that was added first.  The queue must not be empty.
static inline uint32_t worklist_next(Worklist *w)
{
    const uint32_t number = w->at[w->first];

    w->first = (w->first + 1) % w->limit;
    w->n--;
    w->queued[number] = false;
    return number;
}

// A queue whose numbers are removed in ascending order, again and again: after the largest number, the smallest one follows.
typedef struct SweepList {
    uint64_t *queued;                 // a set of numbers (bitset.h)
    size_t n, words;
} SweepList;

static inline SweepList sweep_list_new(Arena *arena, size_t limit)
{
    const size_t words = bitset_words(limit);

    return (SweepList){ARENA_ARRAY(arena, uint64_t, words), 0, words};
}

// Adds a number, unless it is in the list.
static inline void sweep_list_add(SweepList *w, uint32_t number)
{
    w->n += !bitset_has(w->queued, number);
    bitset_add(w->queued, number);
}

// Removes and returns the smallest number that is not below `from`, or else the smallest of all.  The queue must not be empty.
static inline uint32_t sweep_list_next(SweepList *w, uint32_t from)
{
    size_t at = from / 64;
    uint64_t set = w->queued[at] >> from % 64 << from % 64;
    uint32_t bit = 0;

    while (set == 0) {
        at = at + 1 < w->words ? at + 1 : 0;
        set = w->queued[at];
    }
    while (!(set >> bit & 1))
        bit++;
    w->n--;
    bitset_remove(w->queued, at * 64 + bit);
    return (uint32_t)(at * 64) + bit;
}

#endif
