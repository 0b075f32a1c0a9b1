// SPDX-License-Identifier: Apache-2.0
// A queue of numbers below a limit, for iterations to a fixed point.  A number that is already in the queue is not added again.
#ifndef SMC_WORKLIST_H
#define SMC_WORKLIST_H

#include <stdbool.h>
#include <stdint.h>

#include "compiler/base/arena.h"

typedef struct Worklist {
    uint32_t *at;                     // a ring buffer
    bool *queued;                     // queued[number]: `number` is in the queue
    size_t first, n, limit;
} Worklist;

static inline Worklist worklist_new(Arena *arena, size_t limit)
{
    return (Worklist){ARENA_ARRAY(arena, uint32_t, limit), ARENA_ARRAY(arena, bool, limit), 0, 0, limit};
}

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

#endif
