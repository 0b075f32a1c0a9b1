// SPDX-License-Identifier: Apache-2.0
// Fuzz target: any bytes as IR text.  The reader refuses the text, or printing the result reproduces it.  A valid IR remains valid after every
// pass; C can be emitted from it, and an image that the VM's verifier accepts.
#include <string.h>

#include "bytecode-vm/smvm.h"
#include "compiler/passes/pass.h"
#include "compiler/compile.h"
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
    const IrBlkRef *post = f ? ir_find_postdominators(a, f) : NULL;

    for (size_t b = 0; f && b < f->blk.n; b++)
        FUZZ_CHECK(post[b] == IR_NONE || (post[b] > b && post[b] < f->blk.n));
}

static void check_backends(Session *s, IrMachine *m)
{
    ImageOptions o = {true, NULL};
    EmitCOptions c;
    SmvmVerdict why;
    Buf image, header, code;

    memset(&c, 0, sizeof c);
    c.header = "m.h";
    c.source = "m.sm";
    buf_init(&image, &s->arena);
    buf_init(&header, &s->arena);
    buf_init(&code, &s->arena);
    if (session_image(s, &m, 1, &o, &image))
        FUZZ_CHECK(smvm_verify((SmvmBytes)image.at, (uint32_t)image.n, &why) == 0);
    session_emit_c(s, m, &c, &header, &code);
    FUZZ_CHECK(header.n > 0 && code.n > 0);
}

static void check_sound(Session *s, IrMachine *m)
{
    PassOptions o = {.level = 2, .verify = true};
    const char *text;

    for (size_t k = 0; k < m->state.n * BLOCK_COUNT; k++)
        check_postdominators(&s->arena, m->state.at[k / BLOCK_COUNT].block[k % BLOCK_COUNT]);
    check_backends(s, m);
    FUZZ_CHECK(passes_run(&s->arena, m, &o) == NULL);
    check_backends(s, m);
    text = print(&s->arena, m);
    m = read(&s->arena, &s->strings, text, strlen(text));
    FUZZ_CHECK(m && ir_verify(&s->arena, m) == NULL);
}

unsigned long fuzz_reached;           // inputs that are IR text
const unsigned fuzz_floor = 4;

static void check(Session *s, const char *text, size_t n)
{
    IrMachine *m, *again;
    const char *once;

    if (!(m = read(&s->arena, &s->strings, text, n)) || ir_verify(&s->arena, m))
        return;
    fuzz_reached++;
    once = print(&s->arena, m);
    again = read(&s->arena, &s->strings, once, strlen(once));
    FUZZ_CHECK(again && strcmp(print(&s->arena, again), once) == 0);
    check_sound(s, m);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    jmp_buf oom;
    Session s;

    session_init(&s, heap_alloc, NULL, &oom);
    if (setjmp(oom) == 0)
        check(&s, (const char *)data, size);
    session_free(&s);
    return 0;
}
