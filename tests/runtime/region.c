// SPDX-License-Identifier: Apache-2.0
// The guarantees of runtime-c/statevec.h for regions, in memory and in wire form (language.md 4.12, 4.13).
#include <stddef.h>
#include <string.h>

#include "plain.h"
#include "runtime-c/psl/sim/sim.h"
#include "tests/test.h"
#include "wide.h"

#define ALL (&wide_layout.region[WIDE_R_All])

// The wire form of region All of wide.sv, which is the same on every computer.
static const uint8_t wire[] = {
    0xFE,                                                 // i8 = -2
    0xF0, 0xDE, 0xBC, 0x9A, 0x78, 0x56, 0x34, 0x12,       // i64 = 0x123456789abcdef0
    0x01,                                                 // flag, which has the value 0x80 in memory
    0x00, 0x80,                                           // i16 = -32768
    0xC8,                                                 // u8 = 200
    0xFF, 0xFF, 0xFF, 0x7F,                               // i32 = 2147483647
    0x34, 0x12,                                           // u16 = 0x1234
    0x08, 0x07, 0x06, 0x05, 0x04, 0x03, 0x02, 0x01,       // u64 = 0x0102030405060708
    0x23, 0x01, 0xA0, 0x7F,                               // f32: a NaN
    0x78, 0x56, 0x34, 0x12,                               // u32 = 0x12345678
    0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xF8, 0xBF,       // f64 = -1.5
};

static const uint32_t nan_bits = 0x7FA00123u;

static void start(void)
{
    sim_reset();
    CHECK(sm_statevec_init(&wide_vector) == SM_OK);
    memset(&wide_sv, 0, sizeof wide_sv);
    wide_sv.time = 7;
    wide_sv.i8 = -2;
    wide_sv.i64 = 0x123456789abcdef0;
    wide_sv.flag = 0x80;
    wide_sv.i16 = -32768;
    wide_sv.u8 = 200;
    wide_sv.i32 = 2147483647;
    wide_sv.u16 = 0x1234;
    wide_sv.u64 = 0x0102030405060708u;
    memcpy(&wide_sv.f32, &nan_bits, 4);
    wide_sv.u32 = 0x12345678u;
    wide_sv.f64 = -1.5;
    wide_sv.class_ = 9;
}

static bool is_free(void) { return pal_lock_take(wide_vector.lock, 0) == SM_OK && pal_lock_give(wide_vector.lock) == SM_OK; }

// Whether bytes[from …n) still have the values that poison has written.
static void poison(uint8_t *bytes, size_t n) { memset(bytes, 0x5C, n); }
static bool poisoned(const uint8_t *bytes, size_t from, size_t n)
{
    while (from < n && bytes[from] == 0x5C)
        from++;
    return from == n;
}

static void test_memory(void)
{
    WideSv copy;
    uint8_t bytes[sizeof copy], *in_copy = (uint8_t *)&copy + ALL->offset;

    start();
    poison(bytes, sizeof bytes);
    CHECK(sm_read_region(&wide_vector, ALL, bytes) == SM_OK && poisoned(bytes, ALL->size, sizeof bytes) && is_free());
    CHECK(memcmp(bytes, (uint8_t *)&wide_sv + ALL->offset, ALL->size) == 0);
    CHECK(sm_read_region(&wide_vector, &wide_layout.whole, &copy) == SM_OK && memcmp(&copy, &wide_sv, sizeof copy) == 0);
    memset(&wide_sv, 0, sizeof wide_sv);
    wide_sv.time = 8;
    wide_sv.class_ = 3;
    CHECK(sm_write_region(&wide_vector, ALL, in_copy) == SM_OK && is_free());
    CHECK(wide_sv.time == 8 && wide_sv.class_ == 3);      // elements of other regions
    CHECK(memcmp(bytes, (uint8_t *)&wide_sv + ALL->offset, ALL->size) == 0);
    CHECK(sm_write_region(&wide_vector, &wide_layout.whole, &copy) == SM_OK && memcmp(&copy, &wide_sv, sizeof copy) == 0);
    CHECK(wide_vector.faults == 0);
}

// The functions that smc emits for a region access only its members of the copy.
static void test_functions(void)
{
    WideSv copy, was;

    start();
    memset(&copy, 0xA5, sizeof copy);
    was = copy;
    CHECK(wide_read_All(&copy) == SM_OK && copy.i8 == -2 && copy.f64 == -1.5 && is_free());
    CHECK(memcmp(&copy, &was, ALL->offset) == 0 && copy.class_ == 0xA5);
    copy.u16 = 99;
    CHECK(wide_write_All(&copy) == SM_OK && wide_sv.u16 == 99 && wide_sv.time == 7 && wide_sv.class_ == 9 && is_free());
    sim_break(SIM_lock_take, 0, SM_E_TIMEOUT);
    was = copy;
    CHECK(wide_read_Names(&copy) == SM_E_TIMEOUT && memcmp(&copy, &was, sizeof was) == 0);
    CHECK(wide_write_Names(&copy) == SM_E_TIMEOUT && wide_sv.class_ == 9 && wide_vector.faults == 2);
    wide_vector.faults = 0;
}

static void test_wire(void)
{
    uint8_t bytes[sizeof wire + 8];
    WideSv was;

    start();
    CHECK(ALL->packed == sizeof wire);
    poison(bytes, sizeof bytes);
    CHECK(sm_pack_region(&wide_vector, ALL, bytes, sizeof wire) == SM_OK && is_free());
    CHECK(memcmp(bytes, wire, sizeof wire) == 0 && poisoned(bytes, sizeof wire, sizeof bytes));
    CHECK(sm_pack_region(&wide_vector, ALL, bytes, sizeof bytes) == SM_OK);         // more room than needed
    was = wide_sv;
    was.flag = 1;
    memset(&wide_sv.i8, 0, ALL->size);
    CHECK(sm_unpack_region(&wide_vector, ALL, wire, sizeof wire) == SM_OK && is_free());
    CHECK(memcmp(&was, &wide_sv, sizeof was) == 0);       // the zeros between elements, too
}

static void test_whole_on_the_wire(void)
{
    uint8_t bytes[67], again[67];

    start();
    CHECK(wide_layout.whole.packed == sizeof bytes);
    CHECK(sm_pack_region(&wide_vector, &wide_layout.whole, bytes, sizeof bytes) == SM_OK);
    CHECK(bytes[0] == 7 && memcmp(bytes + 12, wire, sizeof wire) == 0 && bytes[12 + sizeof wire] == 9);
    memset(&wide_sv, 0, sizeof wide_sv);
    CHECK(sm_unpack_region(&wide_vector, &wide_layout.whole, bytes, sizeof bytes) == SM_OK && wide_sv.time == 7 && wide_sv.class_ == 9);
    CHECK(sm_pack_region(&wide_vector, &wide_layout.whole, again, sizeof again) == SM_OK && memcmp(bytes, again, sizeof again) == 0);
}

// Each value of a bool's byte: any value except zero is 1, when it is packed and when it is unpacked.
static void test_bools(void)
{
    const SmRegion *names = &wide_layout.region[WIDE_R_Names];
    uint8_t bytes[12] = {0};

    start();
    CHECK(names->packed == sizeof bytes);
    for (int v = 0; v < 256; v++) {
        wide_sv.app = (uint8_t)v;
        CHECK(sm_pack_region(&wide_vector, names, bytes, sizeof bytes) == SM_OK && bytes[11] == (v != 0));
        bytes[11] = (uint8_t)v;
        CHECK(sm_unpack_region(&wide_vector, names, bytes, sizeof bytes) == SM_OK && wide_sv.app == (v != 0));
    }
}

static void test_sizes(void)
{
    uint8_t bytes[sizeof wire + 1];
    WideSv was;

    start();
    was = wide_sv;
    poison(bytes, sizeof bytes);
    CHECK(sm_pack_region(&wide_vector, ALL, bytes, sizeof wire - 1) == SM_E_SIZE && poisoned(bytes, 0, sizeof bytes));
    CHECK(sm_pack_region(&wide_vector, ALL, bytes, 0) == SM_E_SIZE);
    CHECK(sm_unpack_region(&wide_vector, ALL, bytes, sizeof wire - 1) == SM_E_SIZE);
    CHECK(sm_unpack_region(&wide_vector, ALL, bytes, sizeof wire + 1) == SM_E_SIZE);
    CHECK(sm_unpack_region(&wide_vector, ALL, bytes, 0) == SM_E_SIZE);
    CHECK(memcmp(&was, &wide_sv, sizeof was) == 0 && is_free());
    CHECK(sim_count(SIM_lock_take) == 1);                 // refused before the lock is taken
}

static void refused(SmStateVec *sv, const SmRegion *r, void *bytes)
{
    CHECK(sm_read_region(sv, r, bytes) == SM_E_ARGUMENT);
    CHECK(sm_write_region(sv, r, bytes) == SM_E_ARGUMENT);
    CHECK(sm_pack_region(sv, r, bytes, sizeof(WideSv)) == SM_E_ARGUMENT);
    CHECK(sm_unpack_region(sv, r, bytes, sizeof wire) == SM_E_ARGUMENT);
}

static void test_arguments(void)
{
    const SmRegion own = {0, sizeof(WideSv) + 1, sizeof wire, 0, 1};
    uint8_t bytes[sizeof(WideSv)];
    WideSv was;

    start();
    was = wide_sv;
    poison(bytes, sizeof bytes);
    refused(NULL, ALL, bytes);
    refused(&wide_vector, NULL, bytes);
    refused(&wide_vector, ALL, NULL);
    refused(&wide_vector, &own, bytes);                               // not a region of any layout
    refused(&wide_vector, &plain_layout.region[1], bytes);            // of another vector
    refused(&wide_vector, &plain_layout.whole, bytes);
    refused(&wide_vector, wide_layout.region + WIDE_REGIONS, bytes);  // after the end of the table
    CHECK(memcmp(&was, &wide_sv, sizeof was) == 0 && poisoned(bytes, 0, sizeof bytes) && wide_vector.faults == 0);
}

int main(void)
{
    test_memory();
    test_functions();
    test_wire();
    test_whole_on_the_wire();
    test_bools();
    test_sizes();
    test_arguments();
    return test_end("region");
}
