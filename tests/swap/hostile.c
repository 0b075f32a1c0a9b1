// SPDX-License-Identifier: Apache-2.0
// Swaps between images whose DEBUG sections are damaged (clause 12.18).  The verifier accepts them, because it does not check names.
//
//     hostile SEED COUNT
//
// Every byte of both sections is set to 0, 255 and other values.  Random parts are overwritten with random bytes, with other parts of the
// section, or with equal names.  A swap must not access memory outside its blocks, and the new machine must then run equally in place and
// decoded.  Each block of memory has its exact size, so that a sanitizer notices the first byte beyond it.
#include <stdlib.h>
#include <string.h>

#include "tests/swap/machine.h"
#include "tests/test.h"

#define OLD "[state_vector]\nU64 G\nU32 S\nF64 p\nbool b\n[local]\nU16 n = 3\nF32 f = 1\nI64 big = 4\nbool yes = true\nU8 end = 9\n"                \
            "[One] @swap\n.step\nn = n + 1\nroll_avg(p + n, 5) > 3: b = true\nroll_median(p, 40) > roll_max(p * 2, 70): f = 2\n-> Two\n"             \
            "[Two] @abort\n.entry\nend = end + 1\n.step\nbig = big - roll_range(n, 9)\nyes = not yes\np > 1: -> One\n[Three] @safe\n"
#define NEW "[state_vector]\nU64 G\nU32 S\nF64 p\nbool b\n[local]\nU8 end = 1\nF32 f = 5\nU32 n = 1\nI64 big = 2\nbool yes = false\nU8 last = 7\n"   \
            "[Three]\n[Two] @safe\n.step\nroll_max(p + big, 5) > 3: b = yes\nroll_min(p, 40) > roll_min(p * 2, 70): f = n\nlast = last + end\n"      \
            "[One]\n.step\nroll_range(p * 2, 70) > roll_max(n, 9): b = false\n-> Two\n"

static uint64_t random_state;

static uint32_t random_below(uint32_t n)
{
    random_state = random_state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (uint32_t)((random_state >> 33) % n);
}

// A machine whose image the test can damage: a copy of exactly its size.
typedef struct Victim {
    SwapMachine machine;
    uint8_t *image;
} Victim;

static void open_victim(Victim *v, const char *text)
{
    machine_compile(&v->machine, text, NULL, 2, true);
    v->image = malloc(v->machine.image_size);
    memcpy(v->image, v->machine.image, v->machine.image_size);
    v->machine.m.image = v->image;
}

static void restore(Victim *v) { memcpy(v->image, v->machine.image, v->machine.image_size); }

static void close_victim(Victim *v)
{
    free(v->image);
    machine_free(&v->machine);
}

static void step_both(SwapMachine *s, uint64_t *sv, uint64_t *sv_decoded, SmVm *decoded_vm, uint64_t g)
{
    const double p = (double)(g % 7);

    sv[0] = sv_decoded[0] = g;
    memcpy(&sv[2], &p, 8);
    memcpy(&sv_decoded[2], &p, 8);
    CHECK(smvm_step(s->vm, sv) == smvm_step_decoded(s->decoded, sv_decoded));
    CHECK(memcmp(sv, sv_decoded, s->m.sv_size) == 0 && smvm_state(s->vm) == smvm_state(decoded_vm));
}

// Continues `old` in `new` and runs `new` for some steps, in place and decoded.
static void swap(Victim *old, Victim *new, bool *continued)
{
    SwapMachine *to = &new->machine;
    uint64_t sv[4] = {0, 0, 0, 0}, sv_decoded[4];
    SmVm *decoded_vm = malloc(to->ram);
    const SmvmVector none = {NULL, to->m.sv_size, to->m.layout};
    SmResult result;
    SmvmSwapItem item;
    uint32_t sum = 0;

    CHECK(machine_start(&old->machine, sv, 1) == SM_OK);
    for (uint64_t g = 1; g < 40; g++) {
        sv[0] = g;
        CHECK(smvm_step(old->machine.vm, sv) == SM_OK);
    }
    memcpy(sv_decoded, sv, sizeof sv);
    CHECK(machine_start(to, NULL, 1) == SM_OK && smvm_prepare(decoded_vm, to->ram, &to->m, &none, 1) == SM_OK);
    CHECK(smvm_decode(&to->decoded, to->decoded_memory, smvm_decoded_size(&to->m), &to->m, decoded_vm, sv_decoded) == SM_OK);
    SmvmSwap *plan = machine_plan(&old->machine, to, &result);
    CHECK(plan != NULL);
    for (uint32_t i = 0; smvm_swap_item(plan, i, &item); i++)
        for (uint32_t k = 0; k < item.length; k++)
            sum += (uint8_t)item.name[k];
    for (uint32_t s = 0; s <= old->machine.m.states + 1; s++)
        CHECK(smvm_swap_state(plan, s) <= to->m.states);
    result = smvm_swap_continue(plan, old->machine.vm, to->vm, sv);
    CHECK(result == smvm_swap_continue(plan, old->machine.vm, decoded_vm, sv_decoded) && (result == SM_OK || result == SM_E_ARGUMENT));
    *continued = result == SM_OK && sum > 0;
    for (uint64_t g = 40; g < 60 && result == SM_OK; g++)
        step_both(to, sv, sv_decoded, decoded_vm, g);
    free(plan);
    free(decoded_vm);
}

static void overwrite(Victim *v)
{
    const SmvmMachine *m = &v->machine.m;
    uint8_t *debug = v->image + m->debug_at;
    const uint32_t at = random_below(m->debug_size), n = 1 + random_below(m->debug_size - at < 60 ? m->debug_size - at : 60);

    switch (random_below(3)) {
    case 0:
        for (uint32_t i = 0; i < n; i++)
            debug[at + i] = (uint8_t)random_below(256);
        break;
    case 1: memmove(debug + at, debug + random_below(m->debug_size - n + 1), n); break;
    default:                              // the table: an offset near the start or the end
        for (uint32_t i = 12 + 3 * m->states; i + 7 <= m->debug_size && i < 12 + 3 * m->states + 7 * 16; i += 7)
            if (random_below(4) == 0)
                debug[i + random_below(7)] = (uint8_t)(random_below(2) ? random_below(4) : 255 - random_below(4));
    }
}

int main(int argc, char **argv)
{
    const uint32_t count = argc > 2 ? (uint32_t)strtoul(argv[2], NULL, 10) : 3000;
    static const uint8_t value[] = {0, 1, 3, 0x7f, 0x80, 0xff};
    uint32_t continued = 0, swaps = 0;
    Victim v[2];
    bool did;

    random_state = argc > 1 ? strtoull(argv[1], NULL, 10) : 1;
    open_victim(&v[0], OLD);
    open_victim(&v[1], NEW);
    swap(&v[0], &v[1], &did);
    CHECK(did);
    for (int which = 0; which < 2; which++)
        for (uint32_t i = 0; i < v[which].machine.m.debug_size; i++)
            for (size_t k = 0; k < sizeof value; k++, swaps++) {
                v[which].image[v[which].machine.m.debug_at + i] = value[k];
                swap(&v[0], &v[1], &did);
                continued += did;
                restore(&v[which]);
            }
    for (uint32_t i = 0; i < count; i++, swaps++) {
        for (uint32_t n = 1 + random_below(6); n > 0; n--)
            overwrite(&v[random_below(2)]);
        swap(&v[0], &v[1], &did);
        continued += did;
        restore(&v[0]);
        restore(&v[1]);
    }
    printf("%lu swaps, %lu continued\n", (unsigned long)swaps, (unsigned long)continued);
    CHECK(continued > swaps / 4 && continued < swaps);
    close_victim(&v[0]);
    close_victim(&v[1]);
    return test_end("swap/hostile");
}
