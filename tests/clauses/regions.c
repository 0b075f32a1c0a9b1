// SPDX-License-Identifier: Apache-2.0
// Positions and sizes of regions, in memory and packed (docs/language.md, chapter 4).
#include <stdlib.h>
#include <string.h>

#include "compiler/compile.h"
#include "tests/heap.h"
#include "tests/test.h"

static const char text[] = "[a]\nU8 a1\nF64 a2\nbool a3\n[b]\nU16 b1\n[c]\nU32 c1\nI64 c2\nF32 c3\nI8 c4\nU16 c5\n";

// clause 4.9: a region begins at a multiple of 8 and ends with its last element.
// clause 4.12: packed, its size is the sum of the sizes of its elements.
static const struct { unsigned offset, size, packed; } want[] = {{0, 17, 10}, {24, 2, 2}, {32, 24, 19}};

int main(void)
{
    jmp_buf oom;
    Session s;
    StateVec *volatile sv = NULL;

    if (setjmp(oom) == 0) {
        session_init(&s, heap_alloc, NULL, &oom);
        sv = session_state_vector(&s, source_new(&s.arena, "app.sv", text, strlen(text)));
    }
    CHECK(sv && sv->region.n == 3 && sv->size == 56);
    for (size_t i = 0; sv && i < sv->region.n; i++) {
        CHECK(sv->region.at[i]->offset == want[i].offset);
        CHECK(sv->region.at[i]->size == want[i].size);
        CHECK(sv->region.at[i]->packed_size == want[i].packed);
    }
    session_free(&s);
    return test_end("clauses: regions");
}
