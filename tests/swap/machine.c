// SPDX-License-Identifier: Apache-2.0
// Compiles and starts machines for the tests of swaps.
#include "tests/swap/machine.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static jmp_buf out_of_memory;

static void *heap(void *context, void *old, size_t size)
{
    (void)context;
    if (size == 0) {
        free(old);
        return NULL;
    }
    void *p = realloc(old, size);
    if (p == NULL)
        exit(3);
    return p;
}

bool machine_build(SwapMachine *s, int opt_level, bool names)
{
    const ImageOptions options = {.debug = names};
    Buf image;
    SmvmVerdict why;

    s->session.locals = names ? LOCALS_SWAPPED : LOCALS_HIDDEN;
    s->ir = session_ir(&s->session, s->program, opt_level);
    buf_init(&image, &s->session.arena);
    if (!session_image(&s->session, &s->ir, 1, &options, &image))
        return false;
    s->image = (const uint8_t *)image.at;
    s->image_size = (uint32_t)image.n;
    if (smvm_verify(s->image, s->image_size, &why) != 0 || !smvm_machine(s->image, 0, &s->m))
        return false;
    s->ram = smvm_ram_size(&s->m);
    s->vm = heap(NULL, NULL, s->ram);
    s->decoded_memory = heap(NULL, NULL, smvm_decoded_size(&s->m));
    return true;
}

void machine_compile(SwapMachine *s, const char *sm, const char *sv, int opt_level, bool names)
{
    MachineInput in = {0};

    memset(s, 0, sizeof *s);
    session_init(&s->session, heap, NULL, &out_of_memory);
    in.sm = source_new(&s->session.arena, "app.sm", sm, strlen(sm));
    in.sv = sv != NULL ? source_new(&s->session.arena, "bus.sv", sv, strlen(sv)) : NULL;
    s->program = session_program(&s->session, &in);
    if (s->program == NULL || !machine_build(s, opt_level, names)) {
        const DiagStyle style = {false, 3};
        Buf text;
        buf_init(&text, &s->session.arena);
        diags_render_text(&s->session.diags, &style, &text);
        fprintf(stderr, "this machine does not compile:\n%s\n%s", sm, buf_text(&text));
        exit(1);
    }
}

SmResult machine_start(SwapMachine *s, void *sv, uint32_t state)
{
    const SmvmVector vector = {sv, s->m.sv_size, s->m.layout};

    return sv == NULL ? smvm_prepare(s->vm, s->ram, &s->m, &vector, state) : smvm_init(s->vm, s->ram, &s->m, &vector, state);
}

SmResult machine_decode(SwapMachine *s, void *sv)
{
    return smvm_decode(&s->decoded, s->decoded_memory, smvm_decoded_size(&s->m), &s->m, s->vm, sv);
}

void machine_free(SwapMachine *s)
{
    free(s->vm);
    free(s->decoded_memory);
    session_free(&s->session);
}

SmvmSwap *machine_plan(const SwapMachine *from, const SwapMachine *to, SmResult *result)
{
    const uint32_t size = smvm_swap_size(&from->m, &to->m);
    SmvmSwap *plan = heap(NULL, NULL, size);

    *result = smvm_swap_plan(plan, size, &from->m, &to->m);
    if (*result == SM_OK)
        return plan;
    free(plan);
    return NULL;
}
