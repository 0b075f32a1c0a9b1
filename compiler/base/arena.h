// SPDX-License-Identifier: Apache-2.0
// Arenas: memory for objects with one lifetime.  An arena allocates zeroed memory and frees all of it at once, never single allocations.
// If the host is out of memory, arena_alloc does not return: it longjmps to the entry point of the library (*oom).
#ifndef SMC_ARENA_H
#define SMC_ARENA_H

#include <setjmp.h>
#include <stddef.h>

// The host's allocator.  It works like realloc; size 0 frees `old`.  It returns NULL if it is out of memory.
typedef void *(*SmcAllocFn)(void *context, void *old, size_t size);

typedef struct ArenaChunk ArenaChunk;

typedef struct Arena {
    SmcAllocFn alloc;
    void *context;        // passed to alloc
    jmp_buf *oom;         // the longjmp target when alloc returns NULL; must be set before the first arena_alloc
    ArenaChunk *chunk;    // the list of chunks, the newest first
    char *next, *end;     // the free part of the newest chunk
    char *zeroed_end;     // memory from `next` up to zeroed_end is zeroed
    ArenaChunk *spare;    // if the arena is inside another one: chunks that it has freed, for later allocations
} Arena;

void arena_init(Arena *a, SmcAllocFn alloc, void *context, jmp_buf *oom);
void arena_free(Arena *a);                       // frees every chunk; the arena may be used again
void arena_reset(Arena *a);                      // frees every object, but keeps the newest chunk for later allocations
size_t arena_size(const Arena *a);               // returns the bytes of its chunks, without the spare ones
// Initialises an arena whose chunks are memory of `parent`, so that freeing the parent frees it.  For objects that arena_reset frees often: this
// arena keeps all its chunks for later allocations, because the parent cannot free them.
void arena_init_within(Arena *a, Arena *parent);

// Frees every chunk of `a`, for later allocations of `to`.  Both arenas are inside the same one.
void arena_free_into(Arena *a, Arena *to);

// The contents of an arena, to return to.
typedef struct ArenaCopy {
    Arena was;
    char *bytes;          // the used bytes of its chunks, the newest first
} ArenaCopy;

// Copies the contents of `a` to memory of `into`, another arena.
void arena_save(const Arena *a, Arena *into, ArenaCopy *copy);
// Returns the arena to the contents that arena_save has copied: every object has the same address and the same bytes, and what was allocated since
// is freed.  Possible any number of times, until an arena_reset or arena_free.
void arena_restore(Arena *a, const ArenaCopy *copy);

// Alignment of every allocation: enough for the numbers and pointers of the compiler.  On 64-bit Windows setjmp stores registers of 16 bytes.
#ifdef _WIN64
enum { ARENA_ALIGN = 16 };
#else
enum { ARENA_ALIGN = 8 };
#endif
void *arena_alloc_more(Arena *a, size_t size);   // the slow path of arena_alloc, when the zeroed memory is too short

// Returns zeroed memory, aligned to ARENA_ALIGN.  Never returns NULL; size 0 is allowed.
static inline void *arena_alloc(Arena *a, size_t size)
{
    const size_t room = (size + ARENA_ALIGN - 1) / ARENA_ALIGN * ARENA_ALIGN;

    if (a->next >= a->zeroed_end || (size_t)(a->zeroed_end - a->next) < room || room < size)
        return arena_alloc_more(a, size);
    a->next += room;
    return a->next - room;
}
void *arena_array(Arena *a, size_t count, size_t size);          // longjmps to *oom if count * size overflows
void *arena_alloc_unzeroed(Arena *a, size_t size);               // as arena_alloc, but not zeroed
void *arena_copy(Arena *a, const void *from, size_t size);
void *arena_grow(Arena *a, void *old, size_t old_size, size_t new_size);   // copies, or extends the last allocation in place; zeroes the rest
void *arena_grow_unzeroed(Arena *a, void *old, size_t old_size, size_t new_size);    // does not zero the rest

// Allocates and frees one byte, so that a host whose allocator returns NULL ends a long computation that allocates nothing.
void arena_check_host(const Arena *a);

#define ARENA_NEW(a, T) ((T *)arena_alloc((a), sizeof(T)))
#define ARENA_ARRAY(a, T, count) ((T *)arena_array((a), (count), sizeof(T)))

#endif
