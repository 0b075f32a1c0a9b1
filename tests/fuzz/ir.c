// SPDX-License-Identifier: Apache-2.0
// Any text as IR: it is refused, or it comes back from its text as it is; if it is sound, every pass leaves it sound.
#include <string.h>

#include "compiler/ir/ir.h"
#include "compiler/passes/pass.h"
#include "tests/fuzz/fuzz.h"

static const char *print(Arena *a, const IrMachine *m)
{
    Buf out;

    buf_init(&out, a);
    ir_print(m, &out);
    return buf_text(&out);
}

static IrMachine *read(Arena *a, StrPool *strings, const char *text, size_t n)
{
    const char *error = NULL;
    IrMachine *m = ir_read(a, strings, text, n, &error);

    FUZZ_CHECK((m == NULL) == (error != NULL));
    return m;
}

static void check_postdominators(Arena *a, const IrFn *f)
{
    const IrBlkRef *post = f ? ir_postdominators(a, f) : NULL;

    for (size_t b = 0; f && b < f->blk.n; b++)
        FUZZ_CHECK(post[b] == IR_NONE || (post[b] > b && post[b] < f->blk.n));
}

static void check_sound(Arena *a, StrPool *strings, IrMachine *m)
{
    PassOptions o = {2, NULL, true, NULL, NULL};
    const char *text;

    for (size_t s = 0; s < m->state.n; s++)
        for (int k = 0; k < BLOCK_COUNT; k++)
            check_postdominators(a, m->state.at[s].block[k]);
    FUZZ_CHECK(passes_run(a, m, &o) == NULL);
    text = print(a, m);
    m = read(a, strings, text, strlen(text));
    FUZZ_CHECK(m && ir_verify(a, m) == NULL);
}

static void check(Arena *a, const char *text, size_t n)
{
    StrPool strings;
    IrMachine *m, *again;
    const char *once;

    str_pool_init(&strings, a);
    if (!(m = read(a, &strings, text, n)) || ir_verify(a, m))
        return;
    once = print(a, m);
    again = read(a, &strings, once, strlen(once));
    FUZZ_CHECK(again && strcmp(print(a, again), once) == 0);
    check_sound(a, &strings, m);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    jmp_buf oom;
    Arena a;

    arena_init(&a, fuzz_alloc, NULL, &oom);
    if (setjmp(oom) == 0)
        check(&a, (const char *)data, size);
    arena_free(&a);
    return 0;
}
