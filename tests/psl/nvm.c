// SPDX-License-Identifier: Apache-2.0
// The guarantees of nvm.h, for any sizes of the medium.
#include "runtime-c/pal/nvm.h"
#include "tests/psl/suite.h"

static void without(void)
{
    PalNvm memory = {0};
    PalNvmInfo info;
    uint8_t x = 0;

    CHECK(pal_nvm_open(&memory, "nvm", 1) == SM_E_UNSUPPORTED && memory.id == 0);
    CHECK(pal_nvm_open(NULL, NULL, 0) == SM_E_UNSUPPORTED);
    CHECK(pal_nvm_load("nvm", &x, 1) == SM_E_UNSUPPORTED && pal_nvm_load(NULL, NULL, 0) == SM_E_UNSUPPORTED);
    CHECK(pal_nvm_info(memory, &info) == SM_E_UNSUPPORTED);
    CHECK(pal_nvm_read(memory, 0, &x, 1) == SM_E_UNSUPPORTED);
    CHECK(pal_nvm_write(memory, 0, &x, 1) == SM_E_UNSUPPORTED);
    CHECK(pal_nvm_erase(memory, 0, 1) == SM_E_UNSUPPORTED);
    CHECK(pal_nvm_close(memory) == SM_E_UNSUPPORTED);
}

static PalNvm opened(void)
{
    PalNvm memory = {0};

    CHECK(pal_nvm_open(&memory, bench.nvm_name, bench.nvm_size) == SM_OK && memory.id != 0);
    return memory;
}

static PalNvmInfo info_of(PalNvm memory)
{
    PalNvmInfo info = {0, 0, 0, 0, 0, 0};

    CHECK(pal_nvm_info(memory, &info) == SM_OK);
    return info;
}

// Returns the size of the smallest piece that can be erased and written: 1 to 64 bytes on every bench.
static uint32_t piece_of(const PalNvmInfo *info)
{
    return info->erase > info->write ? info->erase : info->write;
}

static void clear(PalNvm memory, uint32_t at, uint32_t n)
{
    CHECK(pal_nvm_erase(memory, at, n) == SM_OK);
}

static void put(PalNvm memory, uint32_t at, uint8_t value, uint32_t n)
{
    uint8_t bytes[256];

    memset(bytes, value, sizeof bytes);
    CHECK(pal_nvm_write(memory, at, bytes, n) == SM_OK);
}

static bool holds(PalNvm memory, uint32_t at, uint8_t value, uint32_t n)
{
    uint8_t bytes[256], expected[256];

    memset(bytes, (uint8_t)~value, sizeof bytes);
    memset(expected, value, sizeof expected);
    CHECK(pal_nvm_read(memory, at, bytes, n) == SM_OK);
    return memcmp(bytes, expected, n) == 0;
}

static void test_sizes(PalNvm memory)
{
    PalNvmInfo i = info_of(memory);

    CHECK(i.size >= bench.nvm_size && i.write >= 1);
    CHECK(i.size % i.write == 0 && (i.erase == 0 || (i.size % i.erase == 0 && i.erase % i.write == 0)));
    CHECK(i.atomic == 0 || i.size % i.atomic == 0);
    CHECK(piece_of(&i) <= 64 && i.size >= 4 * piece_of(&i));
}

static void test_stores(PalNvm memory)
{
    PalNvmInfo i = info_of(memory);
    uint32_t n = piece_of(&i), last = i.size - n;

    clear(memory, 0, 3 * n);
    CHECK(holds(memory, 0, i.blank, 3 * n));
    put(memory, n, 0x5a, n);
    CHECK(holds(memory, 0, i.blank, n));                  // neighbouring bytes are not changed
    CHECK(holds(memory, n, 0x5a, n));
    CHECK(holds(memory, 2 * n, i.blank, n));
    clear(memory, n, n);
    CHECK(holds(memory, n, i.blank, n));
    clear(memory, last, n);
    put(memory, last, 0x17, n);                           // up to the last byte
    CHECK(holds(memory, last, 0x17, n));
    CHECK(holds(memory, i.size - 1, 0x17, 1));            // reads can have any address and length
}

static void many_bytes(PalNvm memory)
{
    PalNvmInfo i = info_of(memory);
    uint8_t in[256], out[256] = {0};
    uint32_t n = 3 * piece_of(&i);

    for (uint32_t k = 0; k < sizeof in; k++)
        in[k] = (uint8_t)(k * 7 + 1);
    clear(memory, 0, n);
    CHECK(pal_nvm_write(memory, 0, in, n) == SM_OK);
    CHECK(pal_nvm_read(memory, 0, out, n) == SM_OK && memcmp(in, out, n) == 0);
    if (i.erase == 0) {                                   // overwrites existing content
        put(memory, 0, 0x33, n);
        CHECK(holds(memory, 0, 0x33, n));
    }
}

// Reading by name works while the memory is open, and creates nothing if the name is missing.
static void test_loading(PalNvm memory)
{
    char longest[PAL_NAME + 1];
    uint8_t x[2] = {0, 0};
    PalNvmInfo i = info_of(memory);
    const uint32_t n = 2 * piece_of(&i);

    clear(memory, 0, n);
    put(memory, 0, 0x3c, n);
    CHECK(pal_nvm_load(bench.nvm_name, x, 2) == SM_OK && x[0] == 0x3c && x[1] == 0x3c);
    memset(longest, 'x', PAL_NAME);
    longest[PAL_NAME] = '\0';
    CHECK(pal_nvm_load(NULL, x, 1) == SM_E_ARGUMENT && pal_nvm_load(bench.nvm_name, NULL, 1) == SM_E_ARGUMENT);
    CHECK(pal_nvm_load(bench.nvm_name, x, 0) == SM_E_ARGUMENT && pal_nvm_load("", x, 1) == SM_E_ARGUMENT && pal_nvm_load(longest, x, 1) == SM_E_ARGUMENT);
    CHECK(pal_nvm_load(bench.nvm_missing, x, 1) == SM_E_MISSING && pal_nvm_load("not-there", x, 1) == SM_E_MISSING);
    CHECK(pal_nvm_load("not-there", x, 1) == SM_E_MISSING);
}

static void test_accesses_outside(PalNvm memory)
{
    PalNvmInfo i = info_of(memory);
    uint8_t bytes[64] = {0};

    CHECK(pal_nvm_read(memory, i.size, bytes, 1) == SM_E_ARGUMENT);
    CHECK(pal_nvm_read(memory, i.size - 1, bytes, 2) == SM_E_ARGUMENT);
    CHECK(pal_nvm_read(memory, UINT32_MAX, bytes, 2) == SM_E_ARGUMENT);
    CHECK(pal_nvm_read(memory, 1, bytes, UINT32_MAX) == SM_E_ARGUMENT);
    CHECK(pal_nvm_read(memory, 0, NULL, 1) == SM_E_ARGUMENT);
    CHECK(pal_nvm_write(memory, i.size, bytes, i.write) == SM_E_ARGUMENT);
    CHECK(pal_nvm_write(memory, UINT32_MAX - i.write + 1, bytes, 2 * i.write) == SM_E_ARGUMENT);
    CHECK(pal_nvm_write(memory, 0, NULL, i.write) == SM_E_ARGUMENT);
    CHECK(pal_nvm_erase(memory, i.size, piece_of(&i)) == SM_E_ARGUMENT);
    CHECK(pal_nvm_erase(memory, 0, i.size + piece_of(&i)) == SM_E_ARGUMENT);
    CHECK(pal_nvm_info(memory, NULL) == SM_E_ARGUMENT);
    CHECK(pal_nvm_read(memory, i.size, bytes, 0) == SM_OK);
    CHECK(pal_nvm_write(memory, i.size, bytes, 0) == SM_OK);
    if (i.write > 1)
        CHECK(pal_nvm_write(memory, 1, bytes, i.write) == SM_E_ARGUMENT && pal_nvm_write(memory, 0, bytes, 1) == SM_E_ARGUMENT);
    if (i.erase > 1)
        CHECK(pal_nvm_erase(memory, 1, i.erase) == SM_E_ARGUMENT && pal_nvm_erase(memory, 0, 1) == SM_E_ARGUMENT);
}

// Written bytes are still there when the memory is opened again.
static void test_content_stays(void)
{
    PalNvm memory = opened();
    PalNvmInfo i = info_of(memory);
    uint32_t n = piece_of(&i);

    clear(memory, n, n);
    put(memory, n, 0xc3, n);
    CHECK(pal_nvm_close(memory) == SM_OK);
    memory = opened();
    CHECK(holds(memory, n, 0xc3, n));
    CHECK(pal_nvm_close(memory) == SM_OK);
}

static void bad_arguments(void)
{
    char name[PAL_NAME + 1];
    PalNvm memory = {0};

    memset(name, 'x', PAL_NAME);
    name[PAL_NAME] = '\0';
    CHECK(pal_nvm_open(NULL, bench.nvm_name, 1) == SM_E_ARGUMENT);
    CHECK(pal_nvm_open(&memory, NULL, 1) == SM_E_ARGUMENT);
    CHECK(pal_nvm_open(&memory, bench.nvm_name, 0) == SM_E_ARGUMENT);
    CHECK(pal_nvm_open(&memory, name, 1) == SM_E_ARGUMENT);
    CHECK(pal_nvm_open(&memory, "", 1) == SM_E_ARGUMENT);
    CHECK(pal_nvm_open(&memory, bench.nvm_missing, 1) == SM_E_MISSING);
    CHECK(memory.id == 0);
}

static void bad_handles(void)
{
    const uint8_t bad[] = {0, PAL_NVMS, PAL_NVMS + 1, 255};
    PalNvmInfo info;
    uint8_t x = 0;

    for (size_t k = 0; k < COUNT(bad); k++) {
        PalNvm memory = {bad[k]};

        CHECK(pal_nvm_info(memory, &info) == SM_E_HANDLE);
        CHECK(pal_nvm_read(memory, 0, &x, 1) == SM_E_HANDLE);
        CHECK(pal_nvm_write(memory, 0, &x, 1) == SM_E_HANDLE);
        CHECK(pal_nvm_erase(memory, 0, 1) == SM_E_HANDLE);
        CHECK(pal_nvm_close(memory) == SM_E_HANDLE);
    }
}

static void one_at_a_time(void)
{
    PalNvm memory = opened(), again = {0};

    CHECK(pal_nvm_open(&again, bench.nvm_name, 1) == SM_E_BUSY && again.id == 0);
    CHECK(pal_nvm_close(memory) == SM_OK);
    CHECK(pal_nvm_close(memory) == SM_E_HANDLE);
    memory = opened();
    CHECK(pal_nvm_close(memory) == SM_OK);
}

Tally contract_nvm(void)
{
    PalNvm memory;

    if (bench.nvm == HAS_NONE) {
        without();
        return TALLY();
    }
    bad_arguments();
    bad_handles();
    memory = opened();
    test_sizes(memory);
    test_stores(memory);
    many_bytes(memory);
    test_loading(memory);
    test_accesses_outside(memory);
    CHECK(pal_nvm_close(memory) == SM_OK);
    test_content_stays();
    one_at_a_time();
    return TALLY();
}
