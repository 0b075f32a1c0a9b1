// SPDX-License-Identifier: Apache-2.0
// Any bytes as an image.  Either the verifier refuses them, or every machine in them runs on any state vector, in memory of exactly the size
// that it requires.  In place and decoded it must have the same results.  Sanitizers detect invalid accesses.  Shared by tests/unit/vm_mutate.c
// and tests/fuzz/image.c.
#ifndef VM_HAMMER_H
#define VM_HAMMER_H

#include <stdlib.h>
#include <string.h>

#include "bytecode-vm/image.h"
#include "bytecode-vm/swap.h"
#include "stdlib/convert.h"
#include "tests/unit/vm_build.h"

enum { HAMMER_MEMORY = 1 << 24, HAMMER_SLOTS = 1 << 20 };

static inline uint64_t hammer_random(uint64_t *seed)
{
    *seed ^= *seed << 13;
    *seed ^= *seed >> 7;
    *seed ^= *seed << 17;
    return *seed;
}

// Returns numbers that are difficult for some code: infinities, NaNs, the limits of the integers.
static inline uint64_t hammer_word(uint64_t *seed)
{
    static const uint64_t hard[] = {0, 1, UINT64_MAX, 0x7ff0000000000000, 0xfff0000000000000, 0x7ff0000000000001, 0x7ff8000000000000,
                                    0x8000000000000000, 0x7fefffffffffffff, 0x3ff0000000000000, 0x7f8000007f800001, 0x00000000ff800000,
                                    0x0020000000000001, 0xffdfffffffffffff};         // 2^53 + 1 and its negative, which no F64 can represent
    uint64_t r = hammer_random(seed);

    return r % 3 == 0 ? hard[r / 3 % (sizeof hard / sizeof *hard)] : r % 3 == 1 ? r >> (r >> 8 & 63) : hammer_random(seed);
}

static inline void hammer_sink(void *context, const char *text, size_t length)
{
    size_t *sum = context;

    for (size_t i = 0; i < length; i++)
        *sum += (unsigned char)text[i];
}

// Returns how many steps to run: fewer if windows are long, because such steps are slow.
static inline uint32_t hammer_steps(const SmvmMachine *m, uint32_t steps)
{
    uint64_t slots = 0;

    for (uint32_t w = 0; w < m->windows; w++)
        slots += smvm_window(m->image, m->windows_at, w) & SMVM_WINDOW_SIZE_MASK;
    return slots * steps < HAMMER_SLOTS ? steps : (uint32_t)(HAMMER_SLOTS / (slots + 1)) + 1;
}

typedef struct Hammered { uint64_t *sv, *memory, *decoded; SmvmDecoded *code; } Hammered;

static inline void hammer_open(Hammered *h, const SmvmMachine *m, uint32_t state, bool decode)
{
    SmvmVector v;

    memset(h, 0, sizeof *h);
    h->sv = calloc(1, m->sv_size);
    h->memory = malloc(smvm_ram_size(m));
    v.at = h->sv;
    v.size = m->sv_size;
    v.layout = m->layout;
    if (!h->sv || !h->memory || smvm_init(h->memory, smvm_ram_size(m), m, &v, state) != SM_OK)
        abort();
    if (!decode)
        return;
    h->decoded = malloc(smvm_decoded_size(m));
    if (!h->decoded || smvm_decode(&h->code, h->decoded, smvm_decoded_size(m), m, (SmVm *)h->memory, h->sv) != SM_OK)
        abort();
}

static inline void hammer_close(Hammered *h)
{
    free(h->sv);
    free(h->memory);
    free(h->decoded);
}

// Whether the machine in place and the decoded machine agree on everything that a caller can observe.
static inline bool hammer_same(const SmvmMachine *m, const Hammered *a, const Hammered *b)
{
    SmVm *x = (SmVm *)a->memory, *y = (SmVm *)b->memory;

    for (uint32_t i = 0; i < m->outputs; i++)
        if (smvm_stored(x, i) != smvm_stored(y, i))
            return false;
    return smvm_state(x) == smvm_state(y) && smvm_time(x) == smvm_time(y) && smvm_stored_state(x) == smvm_stored_state(y)
        && memcmp(a->sv, b->sv, m->sv_size) == 0 && memcmp(smvm_locals(x), smvm_locals(y), m->locals) == 0;
}

static inline void hammer_machine(const SmvmMachine *m, uint32_t steps, uint64_t *seed)
{
    uint32_t words = m->sv_size / 8, g = m->g / 8, state = 1 + (uint32_t)(hammer_random(seed) % m->states);
    Hammered plain, fast;

    if (smvm_ram_size(m) > HAMMER_MEMORY || m->sv_size > HAMMER_MEMORY || smvm_decoded_size(m) > HAMMER_MEMORY)
        return;
    hammer_open(&plain, m, state, false);
    hammer_open(&fast, m, state, true);
    steps = hammer_steps(m, steps);
    for (uint32_t i = 0; i < steps; i++) {
        for (uint32_t w = 0; w < words && w < 64; w++)
            if (hammer_random(seed) % 4 == 0)
                plain.sv[hammer_random(seed) % words] = hammer_word(seed);
        if (i % 8 != 7)
            plain.sv[g] = i;
        memcpy(fast.sv, plain.sv, m->sv_size);
        if (smvm_step((SmVm *)plain.memory, plain.sv) != smvm_step_decoded(fast.code, fast.sv) || !hammer_same(m, &plain, &fast))
            abort();
        if (smvm_state((SmVm *)plain.memory) < 1 || smvm_state((SmVm *)plain.memory) > m->states)
            abort();
    }
    hammer_close(&plain);
    hammer_close(&fast);
}

// Swaps `from` for `to`, even if their names differ, and runs `to` in place and decoded.
static inline void hammer_swap(const SmvmMachine *from, const SmvmMachine *to, uint32_t steps, uint64_t *seed)
{
    const uint32_t size = smvm_swap_size(from, to);
    Hammered old, plain, fast;
    SmvmSwapItem item;
    SmvmSwap *plan;
    size_t sum = 0;

    if (smvm_ram_size(from) > HAMMER_MEMORY || smvm_ram_size(to) > HAMMER_MEMORY || to->sv_size > HAMMER_MEMORY || smvm_decoded_size(to) > HAMMER_MEMORY)
        return;
    plan = malloc(size);
    if (!plan)
        abort();
    if (smvm_swap_plan(plan, size, from, to) != SM_OK) {
        free(plan);
        return;
    }
    hammer_open(&old, from, 1 + (uint32_t)(hammer_random(seed) % from->states), false);
    hammer_open(&plain, to, 1, false);
    hammer_open(&fast, to, 1, true);
    for (uint32_t i = 0; i < 10; i++) {
        old.sv[from->g / 8] = i;
        smvm_step((SmVm *)old.memory, old.sv);
    }
    for (uint32_t i = 0; smvm_swap_item(plan, i, &item); i++)
        hammer_sink(&sum, item.name, item.length);
    memcpy(plain.sv, old.sv, to->sv_size);
    memcpy(fast.sv, old.sv, to->sv_size);
    if (smvm_swap_continue(plan, (SmVm *)old.memory, (SmVm *)plain.memory, plain.sv)
        != smvm_swap_continue(plan, (SmVm *)old.memory, (SmVm *)fast.memory, fast.sv))
        abort();
    for (uint32_t i = 10; i < 10 + steps; i++) {
        plain.sv[to->g / 8] = fast.sv[to->g / 8] = i;
        if (smvm_step((SmVm *)plain.memory, plain.sv) != smvm_step_decoded(fast.code, fast.sv) || !hammer_same(to, &plain, &fast))
            abort();
    }
    hammer_close(&old);
    hammer_close(&plain);
    hammer_close(&fast);
    free(plan);
}

// Checks that the descriptions of the pins are usable: their elements are inside a vector of exactly that size.
static inline void hammer_pins(const uint8_t *image)
{
    SmvmPins all;
    SmvmPin p;
    uint8_t *sv;

    if (!smvm_pins(image, &all) || all.sv_size > HAMMER_MEMORY / 8)
        return;
    sv = (uint8_t *)calloc(1, 8 * all.sv_size + !all.sv_size);
    if (!sv)
        abort();
    while (smvm_next_pin(&all, &p)) {
        sm_store((SmType)p.type, sv + p.offset, sm_mul(p.scale, p.zero));
        if (p.kind > 3 || p.pin > UINT16_MAX || sm_eq(p.scale, sm_from_i32(0)))
            abort();
    }
    if (all.left > 0)
        abort();
    free(sv);
}

// Verifies an image and runs each of its machines.  Returns the rule by which the verifier refused it; 0 if it accepted.
static inline uint8_t hammer(const uint8_t *image, uint32_t n, uint32_t steps, uint64_t seed)
{
    SmvmVerdict v;
    SmvmMachine m, before;
    size_t sum = 0;

    if (smvm_verify(image, n, &v) != 0)
        return v.rule;
    for (uint32_t i = 0; smvm_machine(image, i, &m); i++, before = m) {
        hammer_machine(&m, steps, &seed);
        hammer_swap(i > 0 ? &before : &m, &m, steps < 20 ? steps : 20, &seed);
    }
    hammer_pins(image);
    smvm_disasm(image, hammer_sink, &sum);
    return 0;
}

#endif
