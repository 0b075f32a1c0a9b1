// SPDX-License-Identifier: Apache-2.0
// The arena: allocated memory is zeroed, copies are complete, and bytes after a copy are zeroed where it grows;
// memory that is not zeroed is unchanged, and the bytes after it are zeroed.
#include "compiler/base/arena.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "compiler/base/vec.h"
#include "tests/test.h"

// Allocates memory that is not zero.
static void *alloc_dirty(void *context, void *old, size_t size)
{
    void *p = NULL;

    (void)context;
    if (size == 0)
        free(old);
    else if ((p = realloc(old, size)) != NULL)
        memset(p, 0xa5, size);
    return p;
}

static bool is_zero(const char *p, size_t n)
{
    while (n && p[n - 1] == 0)
        n--;
    return n == 0;
}

static void test_copies(Arena *a)
{
    char text[3000];

    memset(text, 'x', sizeof text);
    for (size_t n = 0; n < sizeof text; n = n * 2 + 1) {
        char *p = arena_copy(a, text, n), *q;
        CHECK(n == 0 || memcmp(p, text, n) == 0);
        q = arena_grow(a, p, n, n + 700);
        CHECK(memcmp(q, text, n) == 0 && is_zero(q + n, 700));
        CHECK(is_zero(arena_alloc(a, 40), 40));
        p = arena_copy(a, text, n);
        q = arena_grow_unzeroed(a, p, n, n + 700);
        CHECK(memcmp(q, text, n) == 0);
        memset(q, 'y', n + 700);
        CHECK(is_zero(arena_alloc(a, 40), 40) && q[n + 699] == 'y');
    }
}

// An allocation that is not zeroed, and the bytes after it.
static void test_room_is_not_zeroed(Arena *a)
{
    for (size_t n = 0; n < 5000; n = n * 2 + 1) {
        char *p = arena_alloc_unzeroed(a, n);
        memset(p, 'x', n);
        CHECK(is_zero(arena_alloc(a, 40), 40) && is_zero(arena_alloc(a, 3000), 3000));
        CHECK(n == 0 || (p[0] == 'x' && p[n - 1] == 'x'));
    }
}

static size_t counted;

static void *alloc_counted(void *context, void *old, size_t size)
{
    counted += size;
    return alloc_dirty(context, old, size);
}

// An arena within another one reuses the chunks that it frees: the other one cannot.
static void test_reused_chunks(jmp_buf *oom)
{
    Arena parent, a;
    size_t after_first = 0;

    arena_init(&parent, alloc_counted, NULL, oom);
    arena_init_within(&a, &parent);
    for (int round = 0; round < 40; round++) {
        for (int i = 0; i < 300; i++) {
            char *p = arena_alloc(&a, 9000);
            CHECK(is_zero(p, 9000));
            memset(p, 'x', 9000);
        }
        if (round == 0)
            after_first = counted;
        if (round % 2)
            arena_reset(&a);
        else
            arena_free(&a);
    }
    CHECK(after_first >= 300 * 9000 && counted == after_first);
    arena_free(&parent);
}

// Of two arenas within another one, the second uses the chunks that the first has freed.
static void test_passed_chunks(jmp_buf *oom)
{
    Arena parent, a, b;
    size_t before;

    counted = 0;
    arena_init(&parent, alloc_counted, NULL, oom);
    arena_init_within(&a, &parent);
    arena_init_within(&b, &parent);
    for (int i = 0; i < 300; i++)
        memset(arena_alloc(&a, 9000), 'x', 9000);
    before = counted;
    arena_free_into(&a, &b);
    CHECK(arena_size(&a) == 0 && !a.spare);
    for (int i = 0; i < 300; i++)
        CHECK(is_zero(arena_alloc(&b, 9000), 9000));
    CHECK(before >= 300 * 9000 && counted == before);
    arena_free(&parent);
}

// Several lists share one allocation.  Each has room up to the beginning of the next list, and moves when it grows beyond.
static void test_lists_in_one_piece(Arena *a)
{
    typedef VEC(uint32_t) List;
    uint32_t room = vec_room(3, sizeof(uint32_t));
    uint32_t *piece = ARENA_ARRAY(a, uint32_t, room + vec_room(1, sizeof *piece));
    List one = {piece, 3, room}, two = {piece + room, 1, 1};

    two.at[0] = 7;
    for (uint32_t i = 0; i < 30; i++)
        vec_push(a, &one, i);
    CHECK(two.at[0] == 7 && one.at[3] == 0 && one.at[32] == 29);
}

// An allocation of 0 bytes from an empty arena also has an address.
static void test_empty_allocation_has_an_address(Arena *a)
{
    CHECK(arena_alloc(a, 0) != NULL);
    arena_free(a);
    CHECK(arena_copy(a, NULL, 0) != NULL);
    arena_free(a);
    CHECK(arena_alloc_unzeroed(a, 0) != NULL);
}

static void test_size(Arena *a)
{
    const size_t before = arena_size(a);

    arena_alloc(a, 5 << 20);
    CHECK(arena_size(a) >= before + (5 << 20) && arena_size(a) < before + (40 << 20));
    arena_free(a);
    CHECK(arena_size(a) == 0);
}

int main(void)
{
    jmp_buf oom;
    Arena a;

    arena_init(&a, alloc_dirty, NULL, &oom);
    if (setjmp(oom) != 0)
        return 3;
    test_empty_allocation_has_an_address(&a);
    test_copies(&a);
    test_room_is_not_zeroed(&a);
    test_lists_in_one_piece(&a);
    test_size(&a);
    arena_free(&a);
    test_reused_chunks(&oom);
    test_passed_chunks(&oom);
    return test_end("arena");
}
