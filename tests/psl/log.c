// SPDX-License-Identifier: Apache-2.0
// The guarantees of log.h.
#include "runtime-c/pal/log.h"
#include "tests/psl/suite.h"

static void without(void)
{
    PalLogFile file = {0};
    uint64_t size;

    CHECK(pal_log_open(&file, "flight.log") == SM_E_UNSUPPORTED && file.id == 0);
    CHECK(pal_log_open(NULL, NULL) == SM_E_UNSUPPORTED);
    CHECK(pal_log_append(file, "x", 1) == SM_E_UNSUPPORTED);
    CHECK(pal_log_sync(file) == SM_E_UNSUPPORTED);
    CHECK(pal_log_size(file, &size) == SM_E_UNSUPPORTED);
    CHECK(pal_log_read(file, &size, 1) == SM_E_UNSUPPORTED);
    CHECK(pal_log_close(file) == SM_E_UNSUPPORTED);
}

static PalLogFile opened(void)
{
    PalLogFile file = {0};

    CHECK(pal_log_open(&file, bench.log_name) == SM_OK && file.id != 0);
    return file;
}

static uint64_t size_of(PalLogFile file)
{
    uint64_t size = UINT64_MAX;

    CHECK(pal_log_size(file, &size) == SM_OK);
    return size;
}

static bool holds(const char *text)
{
    char bytes[256] = {0};

    return bench.log_read(bytes, sizeof bytes) == strlen(text) && memcmp(bytes, text, strlen(text)) == 0;
}

static void grows(void)
{
    char first[8];
    PalLogFile file = opened();

    CHECK(size_of(file) == 0 && holds(""));               // created, empty
    CHECK(pal_log_append(file, "one", 3) == SM_OK);
    CHECK(size_of(file) == 3 && holds("one"));            // other readers see it at once
    CHECK(pal_log_append(file, "", 0) == SM_OK);
    CHECK(pal_log_append(file, "\0two", 4) == SM_OK);
    CHECK(pal_log_sync(file) == SM_OK);
    CHECK(size_of(file) == 7);
    CHECK(pal_log_read(file, first, 5) == SM_OK && memcmp(first, "one\0t", 5) == 0);
    CHECK(pal_log_read(file, first, 8) == SM_E_ARGUMENT && pal_log_read(file, NULL, 1) == SM_E_ARGUMENT);
    CHECK(pal_log_close(file) == SM_OK);
    CHECK(pal_log_read(file, first, 1) == SM_E_HANDLE);
    file = opened();                                      // appends to the existing content
    CHECK(size_of(file) == 7);
    CHECK(pal_log_append(file, "3", 1) == SM_OK && size_of(file) == 8);
    CHECK(pal_log_close(file) == SM_OK);
}

static void much(void)
{
    PalLogFile file = opened();
    const uint64_t before = size_of(file);
    uint8_t bytes[1000];

    memset(bytes, 0x5a, sizeof bytes);
    for (int i = 0; i < 100; i++)
        CHECK(pal_log_append(file, bytes, sizeof bytes) == SM_OK);
    CHECK(size_of(file) == before + 100000);
    CHECK(pal_log_sync(file) == SM_OK);
    CHECK(pal_log_close(file) == SM_OK);
}

static void bad_arguments(void)
{
    char name[PAL_NAME + 1];
    PalLogFile file = {0};
    uint64_t size = 17;

    memset(name, 'x', PAL_NAME);
    name[PAL_NAME] = '\0';
    CHECK(pal_log_open(NULL, bench.log_name) == SM_E_ARGUMENT);
    CHECK(pal_log_open(&file, NULL) == SM_E_ARGUMENT);
    CHECK(pal_log_open(&file, "") == SM_E_ARGUMENT);
    CHECK(pal_log_open(&file, name) == SM_E_ARGUMENT);
    CHECK(pal_log_open(&file, bench.log_missing) == SM_E_MISSING);
    CHECK(file.id == 0);
    file = opened();
    CHECK(pal_log_append(file, NULL, 1) == SM_E_ARGUMENT);
    CHECK(pal_log_size(file, NULL) == SM_E_ARGUMENT);
    CHECK(size_of(file) == 0);
    CHECK(pal_log_close(file) == SM_OK);
    CHECK(size == 17);
}

static void bad_handles(void)
{
    const uint8_t bad[] = {0, PAL_LOGS, PAL_LOGS + 1, 255};
    uint64_t size;

    for (size_t k = 0; k < COUNT(bad); k++) {
        PalLogFile file = {bad[k]};

        CHECK(pal_log_append(file, "x", 1) == SM_E_HANDLE);
        CHECK(pal_log_sync(file) == SM_E_HANDLE);
        CHECK(pal_log_size(file, &size) == SM_E_HANDLE);
        CHECK(pal_log_close(file) == SM_E_HANDLE);
    }
}

static void one_at_a_time(void)
{
    PalLogFile file = opened(), again = {0};

    CHECK(pal_log_open(&again, bench.log_name) == SM_E_BUSY && again.id == 0);
    CHECK(pal_log_close(file) == SM_OK);
    CHECK(pal_log_close(file) == SM_E_HANDLE);
    for (int i = 0; i < 2 * PAL_LOGS; i++) {              // entries are freed, also by refused calls
        CHECK(pal_log_open(&again, bench.log_missing) == SM_E_MISSING);
        CHECK(pal_log_close(opened()) == SM_OK);
    }
}

Tally contract_log(void)
{
    if (bench.log == HAS_NONE) {
        without();
        return TALLY();
    }
    bad_handles();
    bad_arguments();
    grows();
    much();
    one_at_a_time();
    return TALLY();
}
