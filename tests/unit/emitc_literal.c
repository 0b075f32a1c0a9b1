// SPDX-License-Identifier: Apache-2.0
// Constants in emitted C preserve every bit: the C library reads the output of literal_write, and the result is compared.  No constant is longer
// than necessary.
#include <stdlib.h>
#include <string.h>

#include "compiler/emit/c/unit.h"
#include "stdlib/convert.h"
#include "tests/heap.h"
#include "tests/test.h"

static uint64_t next_random(uint64_t *seed)
{
    *seed ^= *seed << 13;
    *seed ^= *seed >> 7;
    *seed ^= *seed << 17;
    return *seed;
}

typedef struct Fixture {
    Arena arena;
    CUnit u;
    Buf out;
} Fixture;

static const char *written(Fixture *f, SmType type, uint64_t cell)
{
    f->out.n = 0;
    literal_write(&f->u, &f->out, type, cell);
    return buf_text(&f->out);
}

static bool is(Fixture *f, SmType type, uint64_t cell, const char *text)
{
    const bool same = strcmp(written(f, type, cell), text) == 0;

    if (!same)
        fprintf(stderr, "%s instead of %s\n", buf_text(&f->out), text);
    return same;
}

static void check_f64(Fixture *f, uint64_t bits)
{
    const char *text = written(f, SM_F64, bits);
    const bool finite = (bits >> 52 & 0x7FF) != 0x7FF;

    if (finite)
        CHECK(sm_bits(strtod(text, NULL)) == bits && strpbrk(text, ".e") != NULL && strlen(text) <= 24);
    else
        CHECK(strncmp(text, "sm_from_bits(0x", 15) == 0);
}

static void check_f32(Fixture *f, uint32_t bits)
{
    const char *text = written(f, SM_F32, bits);

    if ((bits >> 23 & 0xFF) != 0xFF)
        CHECK(sm_f32_bits(strtof(text, NULL)) == bits && text[strlen(text) - 1] == 'f' && strpbrk(text, ".e") != NULL);
}

static void test_floats_are_exact(Fixture *f)
{
    uint64_t seed = 0x9E3779B97F4A7C15u;

    for (int i = 0; i < 20000; i++) {
        const uint64_t bits = next_random(&seed);
        check_f64(f, bits);
        check_f64(f, bits & 0x800FFFFFFFFFFFFFu);                     // a subnormal
        check_f64(f, sm_bits((double)(int64_t)(bits >> (bits & 63))));
        check_f64(f, sm_bits((double)(int32_t)bits / 1000));
        check_f32(f, (uint32_t)bits);
    }
    CHECK(is(f, SM_F64, sm_bits(775), "775.0") && is(f, SM_F64, sm_bits(0.1), "0.1") && is(f, SM_F64, sm_bits(-0.0), "-0.0"));
    CHECK(is(f, SM_F64, sm_bits(1e300), "1e300") && is(f, SM_F64, 1, "5e-324") && is(f, SM_F64, sm_bits(1e22), "1e22"));
    CHECK(is(f, SM_F32, sm_f32_bits(0.1f), "0.1f") && is(f, SM_F32, sm_f32_bits(3), "3.0f"));
}

static void test_integers_have_their_type(Fixture *f)
{
    CHECK(is(f, SM_I8, 0x80, "-128") && is(f, SM_I8, 0xff, "-1") && is(f, SM_U8, 255, "255"));
    CHECK(is(f, SM_I16, 0x8000, "-32768") && is(f, SM_U16, 65535, "65535"));
    CHECK(is(f, SM_I32, 0x80000000u, "INT32_MIN") && is(f, SM_I32, 0x7fffffff, "2147483647"));
    CHECK(is(f, SM_U32, 0xffffffffu, "4294967295u") && is(f, SM_U32, 7, "7"));
    CHECK(is(f, SM_I64, UINT64_C(1) << 63, "INT64_MIN") && is(f, SM_I64, UINT64_MAX, "-1"));
    CHECK(is(f, SM_I64, UINT64_MAX >> 1, "INT64_C(9223372036854775807)"));
    CHECK(is(f, SM_U64, UINT64_MAX, "UINT64_C(18446744073709551615)") && is(f, SM_U64, 0, "0"));
    CHECK(is(f, SM_BOOL, 1, "true") && is(f, SM_BOOL, 0, "false"));
}

int main(void)
{
    Fixture f;
    jmp_buf oom;

    memset(&f, 0, sizeof f);
    if (setjmp(oom))
        return 3;
    arena_init(&f.arena, heap_alloc, NULL, &oom);
    f.u.arena = &f.arena;
    f.u.helper = ARENA_ARRAY(&f.arena, uint32_t, helper_count());
    buf_init(&f.out, &f.arena);
    test_floats_are_exact(&f);
    test_integers_have_their_type(&f);
    arena_free(&f.arena);
    return test_end("emitc_literal");
}
