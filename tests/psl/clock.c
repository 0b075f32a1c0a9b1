// SPDX-License-Identifier: Apache-2.0
// The guarantees of clock.h.
#include "runtime-c/pal/clock.h"
#include "tests/psl/suite.h"

static void without(void)
{
    uint64_t tick = 7;

    CHECK(pal_clock_resolution(&tick) == SM_E_UNSUPPORTED && tick == 7);
    CHECK(pal_clock_now() == 0);
    CHECK(pal_clock_sleep_until(0) == SM_E_UNSUPPORTED);
}

static void never_goes_back(void)
{
    uint64_t last = pal_clock_now();

    for (int i = 0; i < 10000; i++) {
        uint64_t now = pal_clock_now();

        CHECK(now >= last);
        last = now;
    }
}

static void sleeps_until(void)
{
    uint64_t start = pal_clock_now(), next = start;

    for (int i = 0; i < 5; i++) {
        next += 2 * MS;
        CHECK(pal_clock_sleep_until(next) == SM_OK);
        CHECK(pal_clock_now() >= next);
    }
    CHECK(pal_clock_now() - start < 10 * (uint64_t)PAL_SECOND);    // five times 2 ms: a longer time is a wrong unit
    CHECK(pal_clock_sleep_until(0) == SM_OK);
    CHECK(pal_clock_sleep_until(start) == SM_OK);
    CHECK(pal_clock_sleep_until(pal_clock_now() + 2 * PAL_TIMEOUT_MAX) == SM_E_ARGUMENT);
    CHECK(pal_clock_sleep_until(UINT64_MAX) == SM_E_ARGUMENT);
}

Tally contract_clock(void)
{
    uint64_t tick = 0;

    if (bench.clock == HAS_NONE) {
        without();
        return TALLY();
    }
    CHECK(pal_clock_resolution(NULL) == SM_E_ARGUMENT);
    CHECK(pal_clock_resolution(&tick) == SM_OK && tick >= 1 && tick <= 20 * MS);
    never_goes_back();
    sleeps_until();
    return TALLY();
}
