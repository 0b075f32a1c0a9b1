// SPDX-License-Identifier: Apache-2.0
// Memory of a session.  Each block begins with a header that contains its size, so that the session knows how much it uses.  In an area of the
// program the blocks follow each other without gaps; a free block is merged with free neighbours, and an allocation takes the first that is
// large enough.  There are few blocks, because the compiler allocates in arenas.
#include <stdlib.h>
#include <string.h>

#include "compiler/library/library.h"

enum { BLOCK_ALIGN = 16, IN_USE = 1 };

typedef struct Block {
    uint64_t size;            // bytes of content, a multiple of BLOCK_ALIGN; plus IN_USE
    uint64_t before;          // size of the content of the preceding block; only in an area, and 0 in its first block
} Block;

typedef char block_keeps_alignment[sizeof(Block) == BLOCK_ALIGN ? 1 : -1];

static uint64_t block_size(const Block *b) { return b->size & ~(uint64_t)IN_USE; }
static Block *block_of(void *content) { return (Block *)content - 1; }

// Initialises m for the `size` bytes at `area`, or, if `area` is NULL, for malloc with at most `size` bytes (0: no limit).
void library_memory_init(LibraryMemory *m, void *area, uint64_t size)
{
    memset(m, 0, sizeof *m);
    m->limit = area ? 0 : size;
    if (area) {
        const uint64_t skip = (BLOCK_ALIGN - (uintptr_t)area % BLOCK_ALIGN) % BLOCK_ALIGN;
        Block *first;
        if (size < skip + 2 * sizeof(Block))
            size = skip;                          // too small for any block: every allocation fails
        m->area = (unsigned char *)area + skip;
        m->end = m->area + (size - skip) / BLOCK_ALIGN * BLOCK_ALIGN;
        m->search = m->area;
        if (m->area == m->end)
            return;
        first = (Block *)(void *)m->area;
        first->size = (uint64_t)(m->end - m->area) - sizeof *first;
        first->before = 0;
    }
}

// ---- an area ----

// Returns the block after b; NULL if b is the last one.
static Block *next_block(const LibraryMemory *m, Block *b)
{
    unsigned char *next = (unsigned char *)(b + 1) + block_size(b);

    return next < m->end ? (Block *)(void *)next : NULL;
}

// Makes b `size` bytes long.  The rest of b becomes a free block if the rest is large enough.
static void split_block(const LibraryMemory *m, Block *b, uint64_t size)
{
    const uint64_t rest = block_size(b) - size;
    Block *after = next_block(m, b), *free_block;

    if (rest < 2 * sizeof(Block))
        return;
    b->size = size | (b->size & IN_USE);
    free_block = next_block(m, b);
    free_block->size = rest - sizeof(Block);
    free_block->before = size;
    if (after)
        after->before = block_size(free_block);
}

static void *take_from_area(LibraryMemory *m, uint64_t size)
{
    Block *lowest_free = NULL;

    for (Block *b = m->search < m->end ? (Block *)(void *)m->search : NULL; b; b = next_block(m, b)) {
        if (b->size & IN_USE)
            continue;
        lowest_free = lowest_free ? lowest_free : b;
        if (b->size < size)
            continue;
        split_block(m, b, size);
        b->size |= IN_USE;
        m->search = (unsigned char *)(lowest_free != b || !next_block(m, b) ? lowest_free : next_block(m, b));
        return b + 1;
    }
    return NULL;
}

// Appends the free block after b, if there is one, to b.
static void merge_with_next(const LibraryMemory *m, Block *b)
{
    Block *next = next_block(m, b), *after;

    if (!next || next->size & IN_USE)
        return;
    b->size += sizeof *next + next->size;
    if ((after = next_block(m, b)) != NULL)
        after->before = block_size(b);
}

static void return_to_area(LibraryMemory *m, Block *b)
{
    Block *before = (unsigned char *)b > m->area ? (Block *)(void *)((unsigned char *)b - b->before) - 1 : NULL;

    b->size &= ~(uint64_t)IN_USE;
    merge_with_next(m, b);
    if (before && !(before->size & IN_USE))
        merge_with_next(m, b = before);
    if ((unsigned char *)b < m->search)
        m->search = (unsigned char *)b;
}

// ---- both ----

static void release(LibraryMemory *m, void *content)
{
    Block *b = block_of(content);

    m->used -= block_size(b) + sizeof *b;
    if (m->area)
        return_to_area(m, b);
    else
        free(b);
}

static void *allocate(LibraryMemory *m, uint64_t size)
{
    const uint64_t room = (size + BLOCK_ALIGN - 1) / BLOCK_ALIGN * BLOCK_ALIGN;
    Block *b;

    if (room < size || room > SIZE_MAX - sizeof *b || (m->limit && (m->used > m->limit || room + sizeof *b > m->limit - m->used)))
        return NULL;
    if (m->area) {
        void *content = take_from_area(m, room);
        if (!content)
            return NULL;
        b = block_of(content);
    } else {
        if ((b = malloc((size_t)room + sizeof *b)) == NULL)
            return NULL;
        b->size = room | IN_USE;
        b->before = 0;
    }
    m->used += block_size(b) + sizeof *b;
    m->peak = m->used > m->peak ? m->used : m->peak;
    return b + 1;
}

// Works like realloc; size 0 frees `old`.  Blocks are aligned to 16 bytes.  NULL: out of memory.
void *library_memory_alloc(LibraryMemory *m, void *old, uint64_t size)
{
    void *content = NULL;

    if (size > 0 && (content = allocate(m, size)) == NULL)
        return NULL;
    if (old && content)
        memcpy(content, old, (size_t)(block_size(block_of(old)) < size ? block_size(block_of(old)) : size));
    if (old)
        release(m, old);
    return content;
}
