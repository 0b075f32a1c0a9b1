// SPDX-License-Identifier: Apache-2.0
// Bump allocation.  Each new chunk is twice as large as the last, so that a large input needs few chunks.
#include "compiler/base/arena.h"

#include <stdbool.h>
#include <stdint.h>
#include <string.h>

struct ArenaChunk {
    ArenaChunk *older;
    size_t size;          // usable bytes after this header
};

#ifndef ARENA_FIRST_CHUNK                // a test defines it so small that every allocation calls the host's allocator
#define ARENA_FIRST_CHUNK (32 * 1024)
#define ARENA_LARGEST_CHUNK (16 * 1024 * 1024)
#endif

enum {
    ALIGN = ARENA_ALIGN,
    ZERO_AHEAD = 1024,
    FIRST_CHUNK = ARENA_FIRST_CHUNK,
    LARGEST_CHUNK = ARENA_LARGEST_CHUNK,
    SPARES_TRIED = 64     // chunks of `spare` that an allocation compares with its size
};

#define HEADER ((sizeof(ArenaChunk) + ALIGN - 1) / ALIGN * ALIGN)

void arena_init(Arena *a, SmcAllocFn alloc, void *context, jmp_buf *oom)
{
    memset(a, 0, sizeof *a);
    a->alloc = alloc;
    a->context = context;
    a->oom = oom;
}

// Allocates a chunk for an arena within another one (`parent`).
static void *alloc_within(void *parent, void *old, size_t size)
{
    (void)old;                                        // an arena frees or allocates, it never resizes
    return size ? arena_alloc_unzeroed(parent, size) : NULL;
}

// Initialises an arena whose chunks are memory of `parent`, so that freeing the parent frees it.
void arena_init_within(Arena *a, Arena *parent)
{
    arena_init(a, alloc_within, parent, parent->oom);
}

// Frees a chunk. An arena within another one cannot return it to its parent, so it stores it in its list of spare chunks.
static void free_chunk(Arena *a, ArenaChunk *c)
{
    if (a->alloc == alloc_within) {
        c->older = a->spare;
        a->spare = c;
    } else {
        a->alloc(a->context, c, 0);
    }
}

void arena_free(Arena *a)
{
    ArenaChunk *c = a->chunk;
    while (c) {
        ArenaChunk *older = c->older;
        free_chunk(a, c);
        c = older;
    }
    a->chunk = NULL;
    a->next = a->end = a->zeroed_end = NULL;
}

void arena_free_into(Arena *a, Arena *to)
{
    arena_free(a);
    while (a->spare) {
        ArenaChunk *c = a->spare;
        a->spare = c->older;
        free_chunk(to, c);
    }
}

// Returns the total size of the chunks, in bytes.
size_t arena_size(const Arena *a)
{
    size_t size = 0;

    for (const ArenaChunk *c = a->chunk; c; c = c->older)
        size += c->size;
    return size;
}

// Frees every object, but keeps the newest chunk for later allocations.
void arena_reset(Arena *a)
{
    ArenaChunk *newest = a->chunk;

    if (!newest)
        return;
    a->chunk = newest->older;
    arena_free(a);
    newest->older = NULL;
    a->chunk = newest;
    a->next = a->zeroed_end = (char *)newest + HEADER;
    a->end = a->next + newest->size;
}

static char *start_of_chunk(ArenaChunk *c) { return (char *)c + HEADER; }

// Returns how many bytes of a chunk are in use: of the newest, up to a->next.
static size_t used_bytes(const Arena *a, ArenaChunk *c) { return c == a->chunk ? (size_t)(a->next - start_of_chunk(c)) : c->size; }

// Copies the contents of all chunks into another arena, for arena_restore.
void arena_save(const Arena *a, Arena *into, ArenaCopy *copy)
{
    size_t n = 0;

    for (ArenaChunk *c = a->chunk; c; c = c->older)
        n += used_bytes(a, c);
    copy->was = *a;
    copy->bytes = arena_alloc_unzeroed(into, n);
    n = 0;
    for (ArenaChunk *c = a->chunk; c; c = c->older) {
        memcpy(copy->bytes + n, start_of_chunk(c), used_bytes(a, c));
        n += used_bytes(a, c);
    }
}

// Frees the chunks that were allocated since arena_save, and restores the contents of the others.
void arena_restore(Arena *a, const ArenaCopy *copy)
{
    ArenaChunk *spare;
    size_t n = 0;

    while (a->chunk != copy->was.chunk) {
        ArenaChunk *newest = a->chunk;
        a->chunk = newest->older;
        free_chunk(a, newest);
    }
    spare = a->spare;
    *a = copy->was;
    a->spare = spare;
    a->zeroed_end = a->next;
    for (ArenaChunk *c = a->chunk; c; c = c->older) {
        memcpy(start_of_chunk(c), copy->bytes + n, used_bytes(a, c));
        n += used_bytes(a, c);
    }
}

// Takes a spare chunk with room for `wanted` bytes; NULL: none of the first spare chunks has that room.
static ArenaChunk *take_spare_chunk(Arena *a, size_t wanted)
{
    ArenaChunk **at = &a->spare, *c;

    for (int tries = SPARES_TRIED; *at && (*at)->size < wanted && tries > 0; tries--)
        at = &(*at)->older;
    c = *at;
    if (!c || c->size < wanted)
        return NULL;
    *at = c->older;
    return c;
}

// Adds a chunk with room for `wanted` bytes: a spare one if it fits, else a new one, twice as large as the last.
static void add_chunk(Arena *a, size_t wanted)
{
    size_t size = a->chunk ? a->chunk->size * 2 : FIRST_CHUNK;
    ArenaChunk *c = take_spare_chunk(a, wanted);

    if (size > LARGEST_CHUNK)
        size = LARGEST_CHUNK;
    if (size < wanted)
        size = wanted;
    if (!c) {
        if (size > SIZE_MAX - HEADER || (c = a->alloc(a->context, NULL, HEADER + size)) == NULL)
            longjmp(*a->oom, 1);
        c->size = size;
    }
    c->older = a->chunk;
    a->chunk = c;
    a->next = (char *)c + HEADER;
    a->end = a->next + c->size;
    a->zeroed_end = a->next;
}

// Allocates and frees one byte, so that a host whose allocator returns NULL ends a long computation that allocates nothing.
void arena_check_host(const Arena *a)
{
    void *byte = a->alloc(a->context, NULL, 1);

    if (!byte)
        longjmp(*a->oom, 1);
    a->alloc(a->context, byte, 0);
}

// Zeroes the chunk up to `to` and up to ZERO_AHEAD bytes after `to`, so that one memset serves many small allocations.
static void zero_up_to(Arena *a, char *to)
{
    char *up = (size_t)(a->end - to) > ZERO_AHEAD ? to + ZERO_AHEAD : a->end;

    memset(a->zeroed_end, 0, (size_t)(up - a->zeroed_end));
    a->zeroed_end = up;
}

// Returns `size` bytes of the newest chunk, or of a new chunk if they do not fit.  The caller zeroes them.
static char *bump_unzeroed(Arena *a, size_t size)
{
    char *p;

    if (size > SIZE_MAX - ALIGN)
        longjmp(*a->oom, 1);
    size = (size + ALIGN - 1) / ALIGN * ALIGN;
    if (!a->chunk || (size_t)(a->end - a->next) < size)
        add_chunk(a, size);
    p = a->next;
    a->next += size;
    return p;
}

// Allocates when the zeroed memory of the newest chunk is too short: the slow path of arena_alloc.
void *arena_alloc_more(Arena *a, size_t size)
{
    char *p = bump_unzeroed(a, size);

    if (a->next > a->zeroed_end)
        zero_up_to(a, a->next);
    return p;
}

void *arena_alloc_unzeroed(Arena *a, size_t size)
{
    char *p = bump_unzeroed(a, size);

    if (a->next > a->zeroed_end)
        a->zeroed_end = a->next;
    return p;
}

// Allocates `room` bytes, copies `size` bytes to their start, and zeroes the rest.
static void *alloc_copy(Arena *a, const void *from, size_t size, size_t room)
{
    char *p = bump_unzeroed(a, room);

    if (p + size > a->zeroed_end)
        a->zeroed_end = p + size;
    if (a->next > a->zeroed_end)
        zero_up_to(a, a->next);
    if (size)
        memcpy(p, from, size);
    return p;
}

void *arena_copy(Arena *a, const void *from, size_t size)
{
    return alloc_copy(a, from, size, size);
}

// Allocates a zeroed array.  Jumps to *oom if its size overflows.
void *arena_array(Arena *a, size_t count, size_t size)
{
    if (size != 0 && count > SIZE_MAX / size)
        longjmp(*a->oom, 1);
    return arena_alloc(a, count * size);
}

// If `old` was the last allocation and its longer block fits in the chunk, extends it, does not zero what it adds, and returns true.
static bool extend_in_place(Arena *a, char *old, size_t old_size, size_t new_size)
{
    const size_t room = (new_size + ALIGN - 1) / ALIGN * ALIGN;

    if (!old || old + (old_size + ALIGN - 1) / ALIGN * ALIGN != a->next || new_size < old_size || (size_t)(a->end - old) < new_size + ALIGN)
        return false;
    a->next = old + room;
    return true;
}

// Returns a longer block with the contents of `old`, and zeros after them: a copy, or `old` itself, extended, if it was the last allocation.
void *arena_grow(Arena *a, void *old, size_t old_size, size_t new_size)
{
    if (extend_in_place(a, old, old_size, new_size)) {
        if (a->next > a->zeroed_end)
            zero_up_to(a, a->next);
        return old;
    }
    return alloc_copy(a, old, !old ? 0 : old_size < new_size ? old_size : new_size, new_size);
}

// Like arena_grow, but what follows the contents is not zeroed.
void *arena_grow_unzeroed(Arena *a, void *old, size_t old_size, size_t new_size)
{
    char *p = old;

    if (!extend_in_place(a, old, old_size, new_size)) {
        p = bump_unzeroed(a, new_size);
        if (old)
            memcpy(p, old, old_size < new_size ? old_size : new_size);
    }
    if (a->next > a->zeroed_end)
        a->zeroed_end = a->next;
    return p;
}
