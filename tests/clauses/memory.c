// SPDX-License-Identifier: Apache-2.0
// The state vector in memory (docs/language.md, chapter 4), as emitted C declares it and as the VM addresses it.  This program computes the same
// offsets independently.  Its argument is the path of probe.smb.
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "bytecode-vm/smvm.h"
#include "probe.h"
#include "tests/test.h"

enum { PLACES = 14 };

static const struct { unsigned size; size_t at; bool begins_region; } place[PLACES] = {
    {1, offsetof(ProbeSv, first), true}, {8, offsetof(ProbeSv, second), false}, {1, offsetof(ProbeSv, third), false},
    {2, offsetof(ProbeSv, fourth), false}, {1, offsetof(ProbeSv, fifth), false}, {4, offsetof(ProbeSv, sixth), false},
    {1, offsetof(ProbeSv, seventh), false}, {1, offsetof(ProbeSv, only), true}, {4, offsetof(ProbeSv, real32), true},
    {8, offsetof(ProbeSv, real64), false}, {2, offsetof(ProbeSv, last), false}, {4, offsetof(ProbeSv, mode), true},
    {8, offsetof(ProbeSv, time), false}, {4, offsetof(ProbeSv, end), false}};

static size_t round_up(size_t n, size_t to) { return (n + to - 1) / to * to; }

// clause 4.7, clause 4.8, clause 4.9, clause 4.10, clause 4.11: the rule defines the offsets, whatever the compiler's own layout.
static void check_offsets(void)
{
    size_t at = 0;

    for (int i = 0; i < PLACES; i++) {
        at = round_up(at, place[i].begins_region ? 8 : place[i].size);
        CHECK(place[i].at == at);
        at += place[i].size;
    }
    CHECK(offsetof(ProbeSv, flag) == at);
    CHECK(sizeof(ProbeSv) == round_up(at + 1, 8));
}

// Checks the values after a step, at the offsets that check_offsets has checked.  `first` is the byte of a bool.
static void expect_values(const ProbeSv *sv, uint8_t first)
{
    bool truth = first != 0;

    CHECK(sv->first == first);
    CHECK(sv->third == (truth ? 11 : 0) && sv->seventh == truth && sv->flag == !truth);       // clause 4.13
    CHECK(sv->fourth == (truth ? 513 : 0));
    CHECK(sv->second == -2 && sv->fifth == -3 && sv->sixth == 16909060 && sv->only == 9);
    CHECK(sv->real32 == 1.5f && sv->real64 == -2.5 && sv->last == -258 && sv->end == -16909060 && sv->mode == 1);
}

// clause 4.10: bytes between elements stay zero.
static void no_byte_between(const ProbeSv *sv)
{
    unsigned char bytes[sizeof *sv];

    memcpy(bytes, sv, sizeof *sv);
    for (int i = 0; i < PLACES; i++)
        memset(bytes + place[i].at, 0, place[i].size);
    bytes[offsetof(ProbeSv, flag)] = 0;
    for (size_t i = 0; i < sizeof bytes; i++)
        CHECK(bytes[i] == 0);
}

static const uint8_t truths[] = {0, 1, 2, 0x80, 0xff};

// clause 4.13: any byte but zero is true.
static void check_emitted_c(void)
{
    for (size_t i = 0; i < sizeof truths; i++) {
        ProbeSv sv;
        Probe m;
        memset(&sv, 0, sizeof sv);
        CHECK(probe_init(&m, &sv, 1) == PROBE_OK);
        sv.first = truths[i];
        CHECK(probe_step(&m, &sv) == PROBE_OK);
        expect_values(&sv, truths[i]);
        no_byte_between(&sv);
    }
}

static void check_vm(const uint8_t *image, uint32_t size)
{
    SmvmVerdict why;
    SmvmMachine m;

    CHECK(smvm_verify(image, size, &why) == 0);
    CHECK(smvm_machine(image, 0, &m) && m.sv_size == sizeof(ProbeSv) && m.layout == PROBE_SV_LAYOUT);
    for (size_t i = 0; i < sizeof truths; i++) {
        ProbeSv sv;
        const SmvmVector vector = {&sv, sizeof sv, PROBE_SV_LAYOUT};
        void *memory = malloc(smvm_ram_size(&m));
        memset(&sv, 0, sizeof sv);
        CHECK(smvm_init(memory, smvm_ram_size(&m), &m, &vector, 1) == SM_OK);
        sv.first = truths[i];
        CHECK(smvm_step(memory, &sv) == SM_OK);
        expect_values(&sv, truths[i]);
        no_byte_between(&sv);
        free(memory);
    }
}

int main(int argc, char **argv)
{
    static uint8_t image[10000];
    FILE *f = argc == 2 ? fopen(argv[1], "rb") : NULL;
    size_t size = f ? fread(image, 1, sizeof image, f) : 0;

    check_offsets();
    check_emitted_c();
    CHECK(size > 0);
    if (size > 0)
        check_vm(image, (uint32_t)size);
    if (f)
        fclose(f);
    return test_end("clauses: memory");
}
