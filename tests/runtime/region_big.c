// SPDX-License-Identifier: Apache-2.0
// The wire form on a big-endian computer: the same code, with a memory in which every number is big-endian.
#include <string.h>

#include "stdlib/convert.h"
#include "tests/test.h"

// Loads and stores of cells on such a computer.
static uint64_t big_load(SmType type, const void *p)
{
    uint64_t cell = 0;

    for (uint8_t i = 0; i < sm_type_info[type].bytes; i++)
        cell = cell << 8 | ((const uint8_t *)p)[i];
    return type == SM_BOOL ? cell != 0 : cell;
}

static void big_store(SmType type, void *p, uint64_t cell)
{
    for (uint8_t i = sm_type_info[type].bytes; i > 0; i--, cell >>= 8)
        ((uint8_t *)p)[i - 1] = type == SM_BOOL ? cell != 0 : (uint8_t)cell;
}

#define sm_cell_load big_load
#define sm_cell_store big_store
#include "runtime-c/region.c"
#undef sm_cell_load
#undef sm_cell_store

#include "wide.h"

// Reverses the bytes of each element of the little vector's memory.
static void turn(const WideSv *from, uint8_t *to)
{
    memset(to, 0, sizeof *from);
    for (uint16_t i = 0; i < WIDE_ELEMENTS; i++)
        big_store((SmType)wide_element[i].type, to + wide_element[i].offset,
                  sm_cell_load((SmType)wide_element[i].type, (const uint8_t *)from + wide_element[i].offset));
}

// The expected little-endian bytes, computed from the elements alone.
static void wire_of(const WideSv *from, uint8_t *to)
{
    for (uint16_t i = 0; i < WIDE_ELEMENTS; i++) {
        const uint8_t n = sm_type_bytes[wide_element[i].type];
        memcpy(to, (const uint8_t *)from + wide_element[i].offset, n);
        to += n;
    }
}

int main(void)
{
    static WideSv little;
    static uint64_t big[sizeof little / 8], again[sizeof little / 8];
    SmStateVec vector = {&wide_layout, big, false, {0}, 0}, other = {&wide_layout, again, false, {0}, 0};
    uint8_t expected[67], bytes[67];
    const uint16_t one = 1;

    if (*(const uint8_t *)&one != 1) {
        puts("region_big: this computer is one: 0 passed, 0 failed, 1 skipped");
        return 0;
    }
    for (uint16_t i = 0; i < WIDE_ELEMENTS; i++)
        sm_cell_store((SmType)wide_element[i].type, (uint8_t *)&little + wide_element[i].offset, 0xF1E2D3C4B5A69788u * (i + 1u));
    turn(&little, (uint8_t *)big);
    wire_of(&little, expected);
    CHECK(sm_pack_region(&vector, &wide_layout.whole, bytes, sizeof bytes) == SM_OK && memcmp(bytes, expected, sizeof bytes) == 0);
    CHECK(sm_unpack_region(&other, &wide_layout.whole, bytes, sizeof bytes) == SM_OK && memcmp(big, again, sizeof big) == 0);
    return test_end("region_big");
}
