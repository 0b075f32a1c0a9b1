// SPDX-License-Identifier: Apache-2.0
// The guarantees of runtime-c/statevec.h for elements, names and the lock, in the simulation.  region.c tests regions, vector_linux.c tests
// threads.
#include <stddef.h>
#include <string.h>

#include "narrow.h"
#include "plain.h"
#include "runtime-c/psl/sim/sim.h"
#include "stdlib/convert.h"
#include "tests/test.h"
#include "wide.h"

#define COUNT(a) (sizeof (a) / sizeof *(a))

static WideSv before;         // the content of the vector when a test began

static void start(void)
{
    sim_reset();
    memset(&wide_sv, 0xA5, sizeof wide_sv);
    before = wide_sv;
    wide_vector.faults = 0;
    CHECK(sm_statevec_init(&wide_vector) == SM_OK);
    CHECK(memcmp(&wide_sv, &before, sizeof before) == 0);
}

// Whether the lock is free, and only the `bytes` from `offset` on have changed.
static bool only_changed(size_t offset, size_t bytes)
{
    const uint8_t *now = (const uint8_t *)&wide_sv, *then = (const uint8_t *)&before;

    if (pal_lock_take(wide_vector.lock, 0) != SM_OK || pal_lock_give(wide_vector.lock) != SM_OK)
        return false;
    return memcmp(now, then, offset) == 0 && memcmp(now + offset + bytes, then + offset + bytes, sizeof before - offset - bytes) == 0;
}

static bool unchanged(void) { return only_changed(0, 0); }

static const SmElement *of_type(SmType type)
{
    for (size_t i = 0; i < WIDE_ELEMENTS; i++)
        if (wide_element[i].type == type && wide_element[i].region == WIDE_R_All)
            return &wide_element[i];
    return NULL;
}

// ---- the tables ----

static void test_tables(void)
{
    uint32_t packed = 0;

    CHECK(wide_layout.hash == WIDE_SV_LAYOUT && wide_layout.whole.size == sizeof(WideSv));
    CHECK(wide_layout.elements == WIDE_ELEMENTS && wide_layout.element == wide_element && wide_layout.regions == WIDE_REGIONS);
    CHECK(wide_vector.at == &wide_sv && wide_vector.guarded && wide_vector.layout == &wide_layout && !plain_vector.guarded);
    CHECK(wide_element[WIDE_E_i8].offset == offsetof(WideSv, i8) && wide_element[WIDE_E_i8].type == SM_I8);
    CHECK(wide_element[WIDE_E_f64].offset == offsetof(WideSv, f64) && wide_element[WIDE_E_f64].region == WIDE_R_All);
    CHECK(wide_element[WIDE_E_proto].offset == offsetof(WideSv, proto) && wide_element[WIDE_E_app].type == SM_BOOL);
    for (uint16_t r = 0; r < WIDE_REGIONS; r++) {
        const SmRegion *at = &wide_layout.region[r];
        for (uint16_t i = at->first; i < at->first + at->count; i++)
            CHECK(wide_element[i].region == r && wide_element[i].offset >= at->offset && wide_element[i].offset < at->offset + at->size);
        packed += at->packed;
    }
    CHECK(wide_layout.whole.packed == packed && packed == 67);
#define SM_TYPE(name, wire, spelling, ctype, bytes, kind) CHECK(sm_type_bytes[SM_##name] == sizeof(ctype));
#include "stdlib/types.def"
#undef SM_TYPE
}

static void test_names(void)
{
    for (uint16_t i = 0; i < WIDE_ELEMENTS; i++)
        CHECK(sm_find_element(&wide_names, wide_names.element[i]) == &wide_element[i]);
    CHECK(sm_find_element(&wide_names, "f64") == &wide_element[WIDE_E_f64]);
    CHECK(sm_find_element(&wide_names, "class") == &wide_element[WIDE_E_class]);
    CHECK(sm_find_element(&wide_names, "__proto") == &wide_element[WIDE_E_proto]);
    CHECK(!sm_find_element(&wide_names, "f6") && !sm_find_element(&wide_names, "f644") && !sm_find_element(&wide_names, ""));
    CHECK(!sm_find_element(&wide_names, "F64") && !sm_find_element(&wide_names, "All") && !sm_find_element(&wide_names, "*"));
    CHECK(!sm_find_element(NULL, "f64") && !sm_find_element(&wide_names, NULL));
    CHECK(sm_find_region(&wide_names, "Clock") == &wide_layout.region[WIDE_R_Clock]);
    CHECK(sm_find_region(&wide_names, "Names") == &wide_layout.region[WIDE_R_Names]);
    CHECK(sm_find_region(&wide_names, "*") == &wide_layout.whole);
    CHECK(!sm_find_region(&wide_names, "f64") && !sm_find_region(&wide_names, "") && !sm_find_region(&wide_names, "**"));
    CHECK(!sm_find_region(NULL, "All") && !sm_find_region(&wide_names, NULL));
    CHECK(strcmp(wide_names.vector, "wide") == 0 && wide_names.layout == &wide_layout);
}

// ---- a function an element ----

static void test_functions(void)
{
    start();
    wide_set_f64(120.5);
    CHECK(wide_f64() == 120.5 && wide_sv.f64 == 120.5 && only_changed(offsetof(WideSv, f64), 8));
    wide_set_i64(INT64_MIN);
    CHECK(wide_i64() == INT64_MIN && wide_sv.i64 == INT64_MIN);
    wide_set_u64(UINT64_MAX);
    CHECK(wide_u64() == UINT64_MAX);
    wide_set_f32(-0.5f);
    CHECK(wide_f32() == -0.5f);
    wide_sv.flag = 7;
    CHECK(wide_flag() == 1);
    wide_set_flag(true);
    CHECK(wide_sv.flag == 1);
    CHECK(sim_count(SIM_lock_take) == 10 + 1);            // one critical section for each call, and one for only_changed
    CHECK(wide_vector.faults == 0 && pal_lock_close(wide_vector.lock) == SM_OK);
}

static void test_functions_of_gentle_names(void)
{
    start();
    wide_set_class_2(3);      // `set_class` is another element
    wide_set_set_class(4);
    wide_set_vector(5);
    wide_set_app(true);
    wide_set_proto(6);
    CHECK(wide_sv.class_ == 3 && wide_sv.set_class == 4 && wide_sv.vector == 5 && wide_sv.app == 1 && wide_sv.proto == 6);
    CHECK(wide_class() == 3 && wide_set_class() == 4 && wide_vector_2() == 5 && wide_app_2() && wide_proto() == 6);
}

static void test_without_a_lock(void)
{
    uint8_t bytes[sizeof(PlainSv)];
    int16_t value = 0;

    sim_reset();
    CHECK(sm_statevec_init(&plain_vector) == SM_OK);
    sim_break(SIM_lock_take, 0, SM_E_TIMEOUT);
    plain_set_i16(-3);
    CHECK(plain_i16() == -3 && plain_sv.i16 == -3);
    CHECK(sm_read_I16(&plain_vector, &plain_element[PLAIN_E_i16], &value) == SM_OK && value == -3);
    CHECK(sm_write_number(&plain_vector, &plain_element[PLAIN_E_i16], 5) == SM_OK && plain_sv.i16 == 5);
    CHECK(sm_pack_region(&plain_vector, &plain_layout.whole, bytes, sizeof bytes) == SM_OK);
    CHECK(sm_enter(&plain_vector) == SM_OK);
    sm_leave(&plain_vector);
    CHECK(sim_count(SIM_lock_take) == 0 && plain_vector.faults == 0);
}

// ---- by element, typed ----

// Each type: a written value is stored at the right offset and read again; other types are refused.
#define SM_TYPE(name, wire, spelling, ctype, bytes, kind)                                                               \
    static void test_##name(void)                                                                                       \
    {                                                                                                                   \
        const SmElement *e = of_type(SM_##name);                                                                        \
        ctype value = (ctype)(kind == SM_KIND_BOOL ? 1 : 77), got;                                                       \
                                                                                                                        \
        start();                                                                                                        \
        CHECK(sm_write_##name(&wide_vector, e, value) == SM_OK && only_changed(e->offset, bytes));                      \
        CHECK(memcmp((uint8_t *)&wide_sv + e->offset, &value, bytes) == 0);                                             \
        CHECK(sm_read_##name(&wide_vector, e, &got) == SM_OK && memcmp(&got, &value, bytes) == 0);                      \
        before = wide_sv;                                                                                               \
        for (int type = 0; type < SM_TYPE_COUNT; type++) {                                                              \
            if (type == SM_##name)                                                                                      \
                continue;                                                                                               \
            memset(&got, 0xEE, sizeof got);                                                                             \
            CHECK(sm_read_##name(&wide_vector, of_type((SmType)type), &got) == SM_E_ARGUMENT && got == 0 && unchanged()); \
            CHECK(sm_write_##name(&wide_vector, of_type((SmType)type), value) == SM_E_ARGUMENT && unchanged());         \
        }                                                                                                               \
        CHECK(sm_read_##name(&wide_vector, NULL, &got) == SM_E_ARGUMENT && sm_read_##name(NULL, e, &got) == SM_E_ARGUMENT); \
        CHECK(sm_read_##name(&wide_vector, e, NULL) == SM_E_ARGUMENT);                                                  \
        CHECK(sm_write_##name(&wide_vector, NULL, value) == SM_E_ARGUMENT);                                             \
        CHECK(sm_write_##name(NULL, e, value) == SM_E_ARGUMENT && unchanged());                                         \
        CHECK(wide_vector.faults == 0);                                                                                 \
    }
#include "stdlib/types.def"
#undef SM_TYPE

static void test_bool_normalises(void)
{
    uint8_t value;

    start();
    CHECK(sm_write_BOOL(&wide_vector, &wide_element[WIDE_E_flag], 0x80) == SM_OK && wide_sv.flag == 1);
    CHECK(sm_write_BOOL(&wide_vector, &wide_element[WIDE_E_flag], 0) == SM_OK && wide_sv.flag == 0);
    wide_sv.flag = 0xFE;
    CHECK(sm_read_BOOL(&wide_vector, &wide_element[WIDE_E_flag], &value) == SM_OK && value == 1);
}

// Typed access preserves all bits of a NaN.  This NaN is quiet: 32-bit x86 converts a signaling NaN to a quiet one when a function returns it.
static void test_nan_is_kept(void)
{
    const uint64_t bits = 0xFFFC000000001234u;
    const uint32_t bits32 = 0xFFA00123u;
    SmF64 x;
    float f;

    start();
    CHECK(sm_write_F64(&wide_vector, &wide_element[WIDE_E_f64], sm_from_bits(bits)) == SM_OK);
    CHECK(sm_read_F64(&wide_vector, &wide_element[WIDE_E_f64], &x) == SM_OK && sm_bits(x) == bits);
    memcpy(&wide_sv.f32, &bits32, 4);
    CHECK(sm_read_F32(&wide_vector, &wide_element[WIDE_E_f32], &f) == SM_OK && memcmp(&f, &bits32, 4) == 0);
}

// ---- by element, as numbers ----

static const struct { const char *name; double stored, read; } number_case[] = {
    {"u8", 300, 255}, {"u8", -1, 0}, {"u8", 127.9, 127}, {"i8", -0.5, 0}, {"i8", 1e9, 127}, {"i8", -1e9, -128}, {"i16", -32769, -32768},
    {"u16", 65535.9, 65535}, {"i32", 3e9, 2147483647}, {"u32", 4294967296.0, 4294967295.0}, {"i64", -1e30, -9223372036854775808.0},
    {"u64", 1e30, 18446744073709551616.0}, {"u64", 18446744073709549568.0, 18446744073709549568.0}, {"f64", 1e-300, 1e-300},
    {"f32", 0.1, 0.10000000149011612}, {"flag", 1e-300, 1}, {"flag", -5, 1}, {"flag", 0, 0}, {"u16", 12.5, 12},
};

static void test_numbers(void)
{
    for (size_t i = 0; i < COUNT(number_case); i++) {
        const SmElement *e = sm_find_element(&wide_names, number_case[i].name);
        SmF64 value = 99;

        start();
        CHECK(sm_write_number(&wide_vector, e, number_case[i].stored) == SM_OK && only_changed(e->offset, sm_type_bytes[e->type]));
        CHECK(sm_read_number(&wide_vector, e, &value) == SM_OK && value == number_case[i].read);
    }
}

static void test_numbers_and_nan(void)
{
    const SmF64 nan = sm_from_bits(0x7FF8000000000001u);
    SmF64 value = 1;

    start();
    for (uint16_t i = 0; i < WIDE_ELEMENTS; i++) {
        CHECK(sm_write_number(&wide_vector, &wide_element[i], nan) == SM_OK);
        CHECK(sm_read_number(&wide_vector, &wide_element[i], &value) == SM_OK && value == 0);
    }
    memset(&wide_sv, 0xFF, sizeof wide_sv);               // NaN in F32 and F64, true in bool, -1 or the largest elsewhere
    CHECK(sm_read_number(&wide_vector, &wide_element[WIDE_E_f64], &value) == SM_OK && value == 0);
    CHECK(sm_read_number(&wide_vector, &wide_element[WIDE_E_f32], &value) == SM_OK && value == 0);
    CHECK(sm_read_number(&wide_vector, &wide_element[WIDE_E_flag], &value) == SM_OK && value == 1);
    CHECK(sm_read_number(&wide_vector, &wide_element[WIDE_E_i64], &value) == SM_OK && value == -1);
}

static void test_numbers_refuse(void)
{
    const SmElement of_nothing = {0, SM_U8, 0};
    SmF64 value = 9;
    uint8_t byte = 9;

    start();
    CHECK(sm_read_number(&wide_vector, NULL, &value) == SM_E_ARGUMENT && value == 0);
    value = 9;
    CHECK(sm_read_number(NULL, wide_element, &value) == SM_E_ARGUMENT && value == 0);
    CHECK(sm_read_number(&wide_vector, wide_element, NULL) == SM_E_ARGUMENT);
    CHECK(sm_write_number(&wide_vector, NULL, 1) == SM_E_ARGUMENT && sm_write_number(NULL, wide_element, 1) == SM_E_ARGUMENT);
    // an element of another vector, of none, and after the end of the table
    CHECK(sm_write_number(&wide_vector, &plain_element[0], 1) == SM_E_ARGUMENT);
    CHECK(sm_write_number(&wide_vector, &of_nothing, 1) == SM_E_ARGUMENT);
    CHECK(sm_write_number(&wide_vector, wide_element + WIDE_ELEMENTS, 1) == SM_E_ARGUMENT);
    CHECK(sm_read_U8(&wide_vector, &of_nothing, &byte) == SM_E_ARGUMENT && byte == 0);
    CHECK(unchanged() && wide_vector.faults == 0);
}

// ---- the lock ----

// Calls each function once while the lock cannot be acquired.  Each returns the error, changes no element, reads 0, and adds 1 to the vector's
// `faults`.
static void test_faults(void)
{
    const SmElement *e = &wide_element[WIDE_E_u16];
    uint8_t bytes[sizeof wide_sv], same[sizeof wide_sv];
    uint16_t value = 9;
    SmF64 number = 9;

    start();
    memset(bytes, 0x5C, sizeof bytes);
    memcpy(same, bytes, sizeof bytes);
    sim_break(SIM_lock_take, 0, SM_E_TIMEOUT);
    CHECK(sm_read_U16(&wide_vector, e, &value) == SM_E_TIMEOUT && value == 0);
    CHECK(sm_write_U16(&wide_vector, e, 1) == SM_E_TIMEOUT);
    CHECK(sm_read_number(&wide_vector, e, &number) == SM_E_TIMEOUT && number == 0);
    CHECK(sm_write_number(&wide_vector, e, 1) == SM_E_TIMEOUT);
    CHECK(sm_read_region(&wide_vector, &wide_layout.whole, bytes) == SM_E_TIMEOUT);
    CHECK(sm_write_region(&wide_vector, &wide_layout.whole, bytes) == SM_E_TIMEOUT);
    CHECK(sm_pack_region(&wide_vector, &wide_layout.whole, bytes, sizeof bytes) == SM_E_TIMEOUT);
    CHECK(sm_unpack_region(&wide_vector, &wide_layout.whole, bytes, wide_layout.whole.packed) == SM_E_TIMEOUT);
    CHECK(sm_enter(&wide_vector) == SM_E_TIMEOUT);
    CHECK(wide_vector.faults == 9 && memcmp(bytes, same, sizeof bytes) == 0);
    CHECK(wide_f64() == 0 && !wide_flag() && wide_vector.faults == 11);
    wide_set_f64(1);
    CHECK(wide_vector.faults == 12);
    sim_break(SIM_lock_take, 0, SM_OK);
    CHECK(unchanged());
}

static void test_one_fault_among_many(void)
{
    start();
    sim_fail(SIM_lock_take, 1, SM_E_TIMEOUT);
    wide_set_u8(1);
    wide_set_u8(2);
    wide_set_u8(3);
    CHECK(wide_vector.faults == 1 && wide_u8() == 3);
}

static void test_inside(void)
{
    uint16_t value = 9;

    start();
    CHECK(sm_enter(&wide_vector) == SM_OK);
    CHECK(sm_enter(&wide_vector) == SM_E_BUSY && wide_vector.faults == 1);
    CHECK(sm_read_U16(&wide_vector, &wide_element[WIDE_E_u16], &value) == SM_E_BUSY && value == 0);
    sm_leave(&wide_vector);
    CHECK(sm_enter(&wide_vector) == SM_OK);
    sm_leave(&wide_vector);
    CHECK(sm_enter(NULL) == SM_E_ARGUMENT);
    sm_leave(NULL);
}

// ---- init ----

static void test_init_refuses(void)
{
    uint64_t memory[sizeof(WideSv) / 8 + 1];
    SmStateVec vector = {&wide_layout, (uint8_t *)memory + 1, false, {0}, 0};

    sim_reset();
    CHECK(sm_statevec_init(NULL) == SM_E_ARGUMENT);
    CHECK(sm_statevec_init(&vector) == SM_E_ALIGNMENT);
    vector.at = NULL;
    CHECK(sm_statevec_init(&vector) == SM_E_ARGUMENT);
    vector.at = memory;
    CHECK(sm_statevec_init(&vector) == SM_OK);
    vector.layout = NULL;
    CHECK(sm_statevec_init(&vector) == SM_E_ARGUMENT);
}

// The vector is aligned even if its members do not need it, because images require it.
static void test_narrow(void)
{
    CHECK((uintptr_t)&narrow_sv % 8 == 0 && sizeof narrow_sv == 8);
    CHECK(sm_statevec_init(&narrow_vector) == SM_OK);
    narrow_set_one(7);
    CHECK(narrow_one() == 7 && !narrow_two());
}

static void test_no_lock_left(void)
{
    PalLock taken[PAL_LOCKS];

    sim_reset();
    for (int i = 0; i < PAL_LOCKS; i++)
        CHECK(pal_lock_open(&taken[i]) == SM_OK);
    CHECK(sm_statevec_init(&wide_vector) == SM_E_FULL);
    CHECK(sm_statevec_init(&plain_vector) == SM_OK);      // this vector needs no lock
}

static void test_used_before_init(void)
{
    uint16_t value = 9;

    start();
    wide_vector.lock.id = 0;
    CHECK(sm_read_U16(&wide_vector, &wide_element[WIDE_E_u16], &value) == SM_E_HANDLE && value == 0 && wide_vector.faults == 1);
}

int main(void)
{
    test_tables();
    test_names();
    test_functions();
    test_functions_of_gentle_names();
    test_without_a_lock();
#define SM_TYPE(name, wire, spelling, ctype, bytes, kind) test_##name();
#include "stdlib/types.def"
#undef SM_TYPE
    test_bool_normalises();
    test_nan_is_kept();
    test_numbers();
    test_numbers_and_nan();
    test_numbers_refuse();
    test_faults();
    test_one_fault_among_many();
    test_inside();
    test_init_refuses();
    test_narrow();
    test_no_lock_left();
    test_used_before_init();
    return test_end("statevec");
}
