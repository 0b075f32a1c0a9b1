// SPDX-License-Identifier: Apache-2.0
// The guarantees of watchdog.h for a watchdog that is fed.  Each platform's own tests check that it fires.
#include "runtime-c/pal/clock.h"
#include "runtime-c/pal/watchdog.h"
#include "tests/psl/suite.h"

#define PERIOD (20 * (uint64_t)PAL_SECOND)    // much longer than a computer under load needs

static void without(SmResult expected)
{
    uint64_t actual = 7;
    bool bit = true;

    CHECK(pal_watchdog_start(PERIOD, &actual) == expected && actual == 7);
    if (expected != SM_E_UNSUPPORTED)
        return;
    CHECK(pal_watchdog_start(0, NULL) == SM_E_UNSUPPORTED);
    CHECK(pal_watchdog_feed() == SM_E_UNSUPPORTED);
    CHECK(pal_watchdog_stop() == SM_E_UNSUPPORTED);
    CHECK(pal_watchdog_caused_start(&bit) == SM_E_UNSUPPORTED && bit);
}

static void not_running(void)
{
    uint64_t actual = 7;

    CHECK(pal_watchdog_feed() == SM_E_HANDLE);
    CHECK(pal_watchdog_stop() == SM_E_HANDLE);
    CHECK(pal_watchdog_start(0, &actual) == SM_E_ARGUMENT);
    CHECK(pal_watchdog_start(PERIOD, NULL) == SM_E_ARGUMENT);
    CHECK(pal_watchdog_start(PAL_TIMEOUT_MAX + 1, &actual) == SM_E_ARGUMENT);
    CHECK(actual == 7);
}

Tally contract_watchdog(void)
{
    uint64_t actual = 0;
    bool bit = true;
    SmResult r;

    if (bench.watchdog != HAS) {
        without(bench.watchdog == HAS_NONE ? SM_E_UNSUPPORTED : SM_E_MISSING);
        return TALLY();
    }
    not_running();
    for (int round = 0; round < 2; round++) {
        CHECK(pal_watchdog_start(PERIOD, &actual) == SM_OK && actual >= PERIOD);
        CHECK(pal_watchdog_start(PERIOD, &actual) == SM_E_BUSY);
        for (int i = 0; i < 3; i++) {
            pal_clock_sleep_until(pal_clock_now() + MS);
            CHECK(pal_watchdog_feed() == SM_OK);
        }
        CHECK(pal_watchdog_stop() == SM_OK);
        not_running();
    }
    CHECK(pal_watchdog_caused_start(NULL) == SM_E_ARGUMENT);
    r = pal_watchdog_caused_start(&bit);
    CHECK((r == SM_OK && !bit) || r == SM_E_UNSUPPORTED);
    return TALLY();
}
