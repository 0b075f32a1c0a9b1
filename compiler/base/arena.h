// SPDX-License-Identifier: Apache-2.0
// Memory by lifetime.  An arena hands out zeroed memory and takes it all back at once; nothing is freed singly.
// When the host has no more to give, arena_alloc does not return: it longjmps to the edge of the library (*oom).
#ifndef SMC_ARENA_H
#define SMC_ARENA_H

#include <setjmp.h>
#include <stddef.h>

// Where memory comes from: like realloc, with size 0 to free.  NULL when there is none.
typedef void *(*SmcAllocFn)(void *context, void *old, size_t size);

typedef struct ArenaChunk ArenaChunk;

typedef struct Arena {
    SmcAllocFn alloc;
    void *context;        // handed to alloc
    jmp_buf *oom;         // where to go when alloc gives NULL; must be set before the first arena_alloc
    ArenaChunk *chunk;    // newest first
    char *next, *end;     // what is left of the newest chunk
    char *clean;          // from `next` up to here it is zeroed
} Arena;

void arena_init(Arena *a, SmcAllocFn alloc, void *context, jmp_buf *oom);
void arena_free(Arena *a);                       // gives every chunk back; the arena may be used again

enum { ARENA_ALIGN = 8 };                         // for anything that a compiler of ours keeps: numbers and pointers
void *arena_alloc_more(Arena *a, size_t size);   // where what is zeroed does not reach

// Zeroed memory, aligned for anything.  Never NULL; size 0 is allowed.
static inline void *arena_alloc(Arena *a, size_t size)
{
    const size_t room = (size + ARENA_ALIGN - 1) / ARENA_ALIGN * ARENA_ALIGN;

    if (a->next >= a->clean || (size_t)(a->clean - a->next) < room || room < size)
        return arena_alloc_more(a, size);
    a->next += room;
    return a->next - room;
}
void *arena_array(Arena *a, size_t count, size_t size);          // checks count * size
void *arena_room(Arena *a, size_t size);                         // what is in it is not known, nor what it grows by
void *arena_copy(Arena *a, const void *from, size_t size);
void *arena_grow(Arena *a, void *old, size_t old_size, size_t new_size);   // copies; in place when it was the last

#define ARENA_NEW(a, T) ((T *)arena_alloc((a), sizeof(T)))
#define ARENA_ARRAY(a, T, count) ((T *)arena_array((a), (count), sizeof(T)))

#endif
