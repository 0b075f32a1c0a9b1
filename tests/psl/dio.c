// SPDX-License-Identifier: Apache-2.0
// The guarantees of dio.h.
#include "runtime-c/pal/dio.h"
#include "tests/psl/suite.h"

static void without(SmResult expected)
{
    PalDio pin = {0};
    bool level = true;

    CHECK(pal_dio_open(&pin, bench.pins[0], PAL_DIO_OUTPUT, false) == expected && pin.id == 0);
    if (expected != SM_E_UNSUPPORTED)
        return;
    CHECK(pal_dio_open(NULL, 0, PAL_DIO_INPUT, false) == SM_E_UNSUPPORTED);
    CHECK(pal_dio_read(pin, &level) == SM_E_UNSUPPORTED && level);
    CHECK(pal_dio_write(pin, true) == SM_E_UNSUPPORTED);
    CHECK(pal_dio_close(pin) == SM_E_UNSUPPORTED);
}

static void bad_arguments(void)
{
    const uint8_t bad[] = {0, PAL_DIOS, PAL_DIOS + 1, 255};
    PalDio pin = {0};
    bool level;

    CHECK(pal_dio_open(NULL, bench.pins[0], PAL_DIO_INPUT, false) == SM_E_ARGUMENT);
    CHECK(pal_dio_open(&pin, bench.pins[0], (PalDioMode)99, false) == SM_E_ARGUMENT);
    for (int i = 0; i < PAL_DIOS + 1; i++)                // a failed call uses up no entry
        CHECK(pal_dio_open(&pin, bench.pin_missing, PAL_DIO_INPUT, false) == SM_E_MISSING);
    CHECK(pin.id == 0);
    for (size_t i = 0; i < COUNT(bad); i++) {
        pin.id = bad[i];
        CHECK(pal_dio_read(pin, &level) == SM_E_HANDLE);
        CHECK(pal_dio_write(pin, true) == SM_E_HANDLE);
        CHECK(pal_dio_close(pin) == SM_E_HANDLE);
    }
}

static bool level_of(PalDio pin)
{
    bool level = false;

    CHECK(pal_dio_read(pin, &level) == SM_OK);
    return level;
}

static void outputs(void)
{
    PalDio pin = {0}, again = {0};

    for (int first = 0; first < 2; first++) {
        CHECK(pal_dio_open(&pin, bench.pins[0], PAL_DIO_OUTPUT, first) == SM_OK && pin.id != 0);
        CHECK(level_of(pin) == first);                    // it has the level with which it was opened
        CHECK(pal_dio_open(&again, bench.pins[0], PAL_DIO_INPUT, false) == SM_E_BUSY && again.id == 0);
        for (int i = 0; i < 4; i++) {
            CHECK(pal_dio_write(pin, i & 1) == SM_OK);
            CHECK(level_of(pin) == (i & 1));
        }
        CHECK(pal_dio_read(pin, NULL) == SM_E_ARGUMENT);
        CHECK(pal_dio_close(pin) == SM_OK);
        CHECK(pal_dio_close(pin) == SM_E_HANDLE);
        CHECK(pal_dio_write(pin, true) == SM_E_HANDLE);
    }
}

static void inputs(void)
{
    PalDio pin = {0}, other = {0};

    CHECK(pal_dio_open(&pin, bench.pins[1], PAL_DIO_INPUT, true) == SM_OK);
    CHECK(pal_dio_write(pin, true) == SM_E_ARGUMENT);
    level_of(pin);
    CHECK(pal_dio_open(&other, bench.pins[0], PAL_DIO_OUTPUT, true) == SM_OK && other.id != pin.id);
    for (int i = 0; bench.wired && i < 4; i++) {
        CHECK(pal_dio_write(other, i & 1) == SM_OK);
        CHECK(level_of(pin) == (i & 1));
    }
    CHECK(pal_dio_close(other) == SM_OK);
    CHECK(pal_dio_close(pin) == SM_OK);
}

Tally contract_dio(void)
{
    if (bench.dio != HAS) {
        without(bench.dio == HAS_NONE ? SM_E_UNSUPPORTED : SM_E_MISSING);
        return TALLY();
    }
    bad_arguments();
    outputs();
    inputs();
    return TALLY();
}
