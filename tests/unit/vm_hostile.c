// SPDX-License-Identifier: Apache-2.0
// The VM as a small target configures it (vm_small.h), on randomly changed images.  It reads no byte outside the image, writes no byte outside
// its memory and the outputs, and no step executes more instructions than the verifier's bound.
#define SMVM_CONFIG "tests/unit/vm_small.h"
#include "bytecode-vm/load.c"
#define take pins_take
#include "bytecode-vm/pins.c"
#undef take
#include "bytecode-vm/verify.c"
#include "bytecode-vm/interp.c"

#include <stdlib.h>

#include "tests/test.h"
#include "tests/unit/vm_build.h"

enum { START = 100, SV_WORDS = 8, MEMORY = 4096, GUARD = 8, JUMPS = 10 };

enum { LOCALS = 48, ELEMENTS = 8 * SV_WORDS };

static uint64_t seed = 1;
static uint32_t accepted, exact, most_opcodes;

static uint32_t random_below(uint32_t n)
{
    seed ^= seed << 13;
    seed ^= seed >> 7;
    seed ^= seed << 17;
    return (uint32_t)(seed >> 20) % n;
}

// ---- machines of random code ----

// Puts a random load to X (y: 0) or Y (y: 0x20).
static void put_load(Build *b, unsigned y)
{
    const unsigned t = random_below(SM_TYPE_COUNT);

    switch (random_below(8)) {
    case 0: code(b, SMVM_ldx_plus + y, 1, random_below(2) ? random_below(100) : random_below(0x1000c60)); break;
    case 1: code(b, SMVM_ldx_minus + y, 1, random_below(2) ? random_below(100) : random_below(0x1000c60)); break;
    case 2: code(b, SMVM_ldx_f32 + y, 1, 0); break;
    case 3: code(b, SMVM_ldx_f64 + y, 1, 0); break;
    case 4: code(b, SMVM_ldx_time + y, 0); break;
    case 5: code(b, SMVM_ldx_local + SMVM_RAW + y, 1, random_below(LOCALS / 8)); break;
    case 6: code(b, SMVM_ldx_local + t + y, 1, random_below(LOCALS >> smvm_type_shift(t))); break;
    default: code(b, SMVM_ldx_elem + t + y, 1, random_below(ELEMENTS >> smvm_type_shift(t)));
    }
}

// Puts a random instruction that reads X and Y, which have numbers before it.
static void put_instruction(Build *b)
{
    const unsigned t = random_below(SM_TYPE_COUNT + 1), op = random_below(16);

    switch (random_below(9)) {
    case 0: code(b, SMVM_add + op, 0); break;
    case 1: code(b, SMVM_set, 1, 1 + random_below(14)); break;
    case 2: code(b, SMVM_cvt, 1, random_below(SM_TYPE_COUNT)); break;
    case 3: code(b, SMVM_addi + random_below(2), 1, random_below(2) ? random_below(100) : random_below(0x1000c60)); break;
    case 4: code(b, SMVM_st_local + t, 1, random_below(t == SMVM_RAW ? LOCALS / 8u : (unsigned)LOCALS >> smvm_type_shift(t))); break;
    case 5: code(b, SMVM_out, 1, random_below(2)); break;
    case 6: code(b, random_below(2) ? SMVM_jt : SMVM_jf, 1, 0); break;
    case 7: code(b, SMVM_jxy + random_below(14), 1, 0); break;
    default: code(b, SMVM_jxn + random_below(14), 2, random_below(2) ? random_below(100) : random_below(0x1000c60), 0);
    }
}

// Puts loads and instructions that use them.
static void put_line(Build *b)
{
    if (random_below(8) == 0)
        code(b, SMVM_stat, 2, random_below(SM_STAT_ELAPSED), 0);
    else
        put_load(b, 0);
    for (unsigned n = random_below(4); n > 0; n--) {
        put_load(b, 0x20);
        put_instruction(b);
    }
    if (random_below(6) == 0)
        code(b, SMVM_jmp, 1, 0);
}

static bool is_jump(uint8_t op) { return (smvm_shape(op) & SMVM_SHAPE_J) != 0; }

static bool is_target_of(const Build *b, uint32_t at)
{
    const uint8_t op = b->code[at];

    return op == SMVM_end || op == SMVM_goto || op == SMVM_jmp || (op >= 0x80 && op <= SMVM_stat);
}

// Lets each jump of the function that begins at `start` lead to a random instruction after the jump.
static void aim_jumps(Build *b, uint32_t start)
{
    for (uint32_t at = start, next; at < b->size; at = next) {
        uint32_t to;
        for (next = at + 1; next < b->size && b->code[next] < 0x80; next++)
            ;
        if (!is_jump(b->code[at]))
            continue;
        for (to = next + random_below(b->size - next < 60 ? b->size - next : 60); to < b->size && !is_target_of(b, to); to++)
            ;
        while (to >= b->size || !is_target_of(b, to))            // no target follows: the last one is valid
            to--;
        CHECK(to - next < 96);
        b->code[next - 1] = (uint8_t)(to - next);
    }
}

static void put_function(Build *b, bool may_go)
{
    const uint32_t start = b->size;

    for (uint32_t n = random_below(12); n > 0; n--)
        put_line(b);
    code(b, SMVM_end, 0);
    if (may_go && random_below(2))
        code(b, SMVM_goto, 1, (unsigned)(1 + random_below(2)));
    aim_jumps(b, start);
    end_function(b);
}

static void make_random_machine(Build *b)
{
    memset(b, 0, sizeof *b);
    b->sv_words = SV_WORDS;
    b->locals = LOCALS;
    b->windows = b->f32s = b->f64s = 1;
    b->outputs = b->states = b->width = b->s = 2;
    b->window[0] = WINDOW(5, 255);
    b->f32[0] = 0xff800000u;
    b->f64[0] = 0x7ff8000000000000u;
    b->output[0] = PLACE(F64, 16);
    b->output[1] = PLACE(BOOL, 24);
    typed(b, SMVM_ldx_elem, SM_F64, 32);
    code(b, SMVM_sample, 1, 0);
    put_function(b, false);
    for (unsigned f = 0; f < 6; f++)
        put_function(b, f % 3 < 2);
}

// ---- running accepted images ----

static uint64_t random_word(void)
{
    static const uint64_t hard[] = {0, UINT64_MAX, 0x7ff0000000000000u, 0x7ff0000000000001u, 0xffffffffffffff00u, 0x8000000000000000u, 1};
    const uint32_t i = random_below(9);

    return i < 7 ? hard[i] : seed;
}

// Runs one step.  Elements other than outputs and S must not change.
static void run_checked_step(const SmvmMachine *m, SmVm *vm, uint64_t *sv, uint64_t g, uint32_t longest)
{
    uint8_t before[8 * SV_WORDS], *bytes = (uint8_t *)sv, written[8 * SV_WORDS] = {0};

    for (uint32_t i = 0; i < SV_WORDS; i++)
        sv[i] = random_word();
    memcpy(bytes + m->g, &g, 8);
    memcpy(before, sv, sizeof before);
    memset(written + m->s, 1, 4);
    for (uint32_t i = 0; i < m->outputs; i++) {
        const SmvmLocation p = smvm_output(m, i);
        memset(written + p.offset, 1, (size_t)1 << smvm_type_shift(p.type));
    }
    small_opcodes = 0;
    CHECK(smvm_step(vm, sv) == SM_OK && smvm_state(vm) >= 1 && smvm_state(vm) <= m->states);
    CHECK(small_opcodes <= longest);
    most_opcodes = longest_max(most_opcodes, small_opcodes);
    for (uint32_t i = 0; i < sizeof before; i++)
        CHECK(written[i] || bytes[i] == before[i]);
}

static void run_image(uint32_t longest)
{
    static uint64_t memory[MEMORY / 8 + GUARD];
    uint64_t sv[SV_WORDS];
    SmvmVector v = {sv, sizeof sv, 0};
    SmvmMachine m;
    uint32_t size;

    if (!smvm_machine(START, 0, &m) || m.sv_size != sizeof sv || (size = smvm_ram_size(&m)) > MEMORY)
        return;
    v.layout = m.layout;
    memset(memory, 0xa5, sizeof memory);
    CHECK(smvm_init(memory, size, &m, &v, 1 + random_below(m.states)) == SM_OK);
    most_opcodes = 0;
    for (uint64_t g = 0; g < JUMPS; g++)
        run_checked_step(&m, (SmVm *)memory, sv, g, longest);
    for (uint32_t i = size; i < sizeof memory; i++)
        CHECK(((uint8_t *)memory)[i] == 0xa5);
    exact += most_opcodes == longest;
}

static bool try_image(uint32_t n)
{
    SmvmVerdict v;

    small_image = START;
    small_end = START + n;
    if (smvm_verify(START, n, &v) != 0)
        return false;
    accepted++;
    run_image(v.longest);
    return true;
}

static void test_random_images_are_safe(void)
{
    for (unsigned k = 0; k < 600; k++) {
        Build b;
        uint32_t n, at;
        make_random_machine(&b);
        n = build_image(&b, small_flash + START);
        CHECK(try_image(n));
        for (unsigned i = 0; i < 50; i++) {
            uint8_t old;
            at = random_below(n);
            old = small_flash[START + at];
            small_flash[START + at] = (uint8_t)(random_below(3) ? old ^ 1u << random_below(8) : random_below(256));
            if (at < 8 || at > 10)
                fix_crc(small_flash + START);
            try_image(n);
            small_flash[START + at] = old;
        }
    }
    CHECK(small_beyond == 0 && accepted > 5000 && exact > 50);
}

// ---- one by one ----

static uint8_t verify_build(const Build *b)
{
    SmvmVerdict v;
    const uint32_t n = build_image(b, small_flash + START);

    small_image = START;
    small_end = START + n;
    return smvm_verify(START, n, &v);
}

// A machine must not write the number of its state to the clock that all machines share.
static void test_state_cannot_overwrite_time(void)
{
    Build b;

    for (unsigned i = 0; i < 2; i++) {
        make_random_machine(&b);
        b.s = i;
        CHECK(verify_build(&b) == SMVM_R_PROTECTED);
    }
    b.s = 14;
    CHECK(verify_build(&b) == 0);
}

static void test_image_too_large_for_the_target_is_refused(void)
{
    Build b;

    make_random_machine(&b);
    b.sv_words = 0x8000 / 8;
    CHECK(verify_build(&b) == 0);
    b.sv_words++;
    CHECK(verify_build(&b) == SMVM_R_RAM);
    b.sv_words = b.to = 0x10000 / 8 + SV_WORDS;       // in 16 bits this would be SV_WORDS
    CHECK(verify_build(&b) == SMVM_R_RAM);
    make_random_machine(&b);
    b.locals = 0x10000 + LOCALS;
    CHECK(verify_build(&b) == SMVM_R_RAM);
    make_random_machine(&b);
    b.g = 0x10000 / 8;
    CHECK(verify_build(&b) == SMVM_R_RAM);
    make_random_machine(&b);
    b.output[0] = PLACE_OF(SM_F64, 0x10000 / 8 + 2);
    CHECK(verify_build(&b) == SMVM_R_OUTPUTS);
    make_random_machine(&b);
    b.window[0] = WINDOW(0x2000 + 1, 1);              // 65544 bytes: a 16-bit sum would overflow to 8
    CHECK(verify_build(&b) == SMVM_R_RAM);
    b.window[0] = WINDOW(100000, 255);
    CHECK(verify_build(&b) == SMVM_R_RAM);
    b.window[0] = WINDOW(100001, 31);
    CHECK(verify_build(&b) == SMVM_R_WINDOW);
}

// An optional section of an unknown version is skipped, wherever it is.
static void test_unknown_optional_section_is_skipped(void)
{
    static const uint8_t id[] = {0x02, 0x81, 0x82};
    uint8_t *image = small_flash + START;
    SmvmVerdict v;
    Build b;

    make_random_machine(&b);
    small_image = START;
    small_end = START + build_sections(&b, 3, id, image);
    CHECK(smvm_verify(START, small_end - START, &v) == SMVM_R_GROUP);
    image[13] = 3;
    fix_crc(image);
    CHECK(smvm_verify(START, small_end - START, &v) == 0);
}

// A VM without parameters refuses images that have them, even an empty section: otherwise it would ignore values that the image sets.
static void test_parameters_are_refused_where_the_vm_has_none(void)
{
    static const uint8_t id[] = {0x81, 0x82, 0x84};
    uint8_t *image = small_flash + START;
    SmvmVerdict v;
    Build b;

    make_random_machine(&b);
    small_image = START;
    small_end = START + build_sections(&b, 3, id, image);
    image[12 + 2 * SMVM_SECTION_ENTRY + 1] = 1;
    fix_crc(image);
    CHECK(smvm_verify(START, small_end - START, &v) == SMVM_R_UNKNOWN);
}

int main(void)
{
    test_random_images_are_safe();
    test_state_cannot_overwrite_time();
    test_image_too_large_for_the_target_is_refused();
    test_unknown_optional_section_is_skipped();
    test_parameters_are_refused_where_the_vm_has_none();
    return test_end("vm_hostile");
}
