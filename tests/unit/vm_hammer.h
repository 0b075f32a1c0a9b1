// SPDX-License-Identifier: Apache-2.0
// Bytes as an image: they are refused, or every machine in them runs on whatever the state vector holds, in memory of exactly
// the size it asked for.  What goes wrong is for the sanitizers to see.  Shared by tests/unit/vm_mutate.c and tests/fuzz/image.c.
#ifndef VM_HAMMER_H
#define VM_HAMMER_H

#include <stdlib.h>
#include <string.h>

#include "bytecode-vm/image.h"
#include "bytecode-vm/smvm.h"
#include "tests/unit/vm_build.h"

enum { HAMMER_MEMORY = 1 << 24, HAMMER_SLOTS = 1 << 20 };

static inline uint64_t hammer_random(uint64_t *seed)
{
    *seed ^= *seed << 13;
    *seed ^= *seed >> 7;
    *seed ^= *seed << 17;
    return *seed;
}

// Words that are hard on somebody: infinities, NaNs, the ends of the integers.
static inline uint64_t hammer_word(uint64_t *seed)
{
    static const uint64_t hard[] = {0, 1, UINT64_MAX, 0x7ff0000000000000, 0xfff0000000000000, 0x7ff0000000000001, 0x7ff8000000000000,
                                    0x8000000000000000, 0x7fefffffffffffff, 0x3ff0000000000000, 0x7f8000007f800001, 0x00000000ff800000};
    uint64_t r = hammer_random(seed);

    return r % 3 == 0 ? hard[r / 3 % (sizeof hard / sizeof *hard)] : r % 3 == 1 ? r >> (r >> 8 & 63) : hammer_random(seed);
}

static inline void hammer_sink(void *context, const char *text, size_t length)
{
    size_t *sum = context;

    for (size_t i = 0; i < length; i++)
        *sum += (unsigned char)text[i];
}

// How many steps are affordable: long windows take long.
static inline uint32_t hammer_steps(const SmvmMachine *m, uint32_t steps)
{
    uint64_t slots = 0;

    for (uint32_t w = 0; w < m->windows; w++)
        slots += smvm_uint(m->image, m->windows_at + 3 * w, 3) & 0x1ffff;
    return slots * steps < HAMMER_SLOTS ? steps : (uint32_t)(HAMMER_SLOTS / (slots + 1)) + 1;
}

static inline void hammer_machine(const SmvmMachine *m, uint32_t steps, uint64_t *seed)
{
    uint32_t size = smvm_ram_size(m), words = m->sv_size / 8, g = smvm_operand(m, m->outputs).offset / 8;
    uint64_t *sv, *memory;
    SmvmVector v;

    if (size > HAMMER_MEMORY || m->sv_size > HAMMER_MEMORY)
        return;
    sv = calloc(1, m->sv_size);
    memory = malloc(size);
    v.at = sv;
    v.size = m->sv_size;
    v.layout = m->layout;
    if (!sv || !memory || smvm_init(memory, size, m, &v, 1 + (uint32_t)(hammer_random(seed) % m->states)) != SM_OK)
        abort();
    steps = hammer_steps(m, steps);
    for (uint32_t i = 0; i < steps; i++) {
        for (uint32_t w = 0; w < words && w < 64; w++)
            if (hammer_random(seed) % 4 == 0)
                sv[hammer_random(seed) % words] = hammer_word(seed);
        if (i % 8 != 7)
            sv[g] = i;
        smvm_step((SmVm *)memory, sv);
        if (smvm_state((SmVm *)memory) < 1 || smvm_state((SmVm *)memory) > m->states)
            abort();
    }
    free(sv);
    free(memory);
}

// Gives the rule that refused it, or 0.
static inline uint8_t hammer(const uint8_t *image, uint32_t n, uint32_t steps, uint64_t seed)
{
    SmvmVerdict v;
    SmvmMachine m;
    size_t sum = 0;

    if (smvm_verify(image, n, &v) != 0)
        return v.rule;
    for (uint32_t i = 0; smvm_machine(image, i, &m); i++)
        hammer_machine(&m, steps, &seed);
    smvm_disasm(image, hammer_sink, &sum);
    return 0;
}

#endif
