// SPDX-License-Identifier: Apache-2.0
// The chip's watchdog.  After it has fired it keeps running with its shortest period, so it is stopped before any other start-up
// code.
#include "runtime-c/pal/watchdog.h"

#include "runtime-c/psl/avr/avr.h"

#ifdef PSL_AVR
#include <avr/wdt.h>

enum { LONGEST = WDTO_8S };

static uint8_t reset_cause __attribute__((section(".noinit")));  // cause of the reset; 0: a boot loader has cleared it
static bool running;

static void read_reset_cause(void) __attribute__((naked, used, section(".init3")));
static void read_reset_cause(void)
{
    reset_cause = MCUSR;
    MCUSR = 0;
    wdt_disable();
}

// The periods are 16 ms times powers of two.  (Without a loop, the compiler can evaluate a constant period.)
#define PERIOD(i) ((uint64_t)16 * PAL_MILLISECOND << (i))
#define ABOVE(i) (period > PERIOD(i))

SmResult pal_watchdog_start(uint64_t period, uint64_t *actual)
{
    const uint8_t i = (uint8_t)(ABOVE(0) + ABOVE(1) + ABOVE(2) + ABOVE(3) + ABOVE(4) + ABOVE(5) + ABOVE(6) + ABOVE(7) + ABOVE(8));

    if (!actual || period == 0 || ABOVE(LONGEST))
        return SM_E_ARGUMENT;
    if (running)
        return SM_E_BUSY;
    wdt_enable(i);
    running = true;
    *actual = PERIOD(i);
    return SM_OK;
}

SmResult pal_watchdog_feed(void)
{
    if (!running)
        return SM_E_HANDLE;
    wdt_reset();
    return SM_OK;
}

SmResult pal_watchdog_stop(void)
{
    if (!running)
        return SM_E_HANDLE;
    wdt_disable();
    running = false;
    return SM_OK;
}

SmResult pal_watchdog_caused_start(bool *caused)
{
    if (!caused)
        return SM_E_ARGUMENT;
    if (reset_cause == 0)
        return SM_E_UNSUPPORTED;
    *caused = reset_cause >> WDRF & 1;
    return SM_OK;
}

// Jumps to the reset vector; pins keep their levels until they are opened.
void avr_restart(void)
{
    cli();
    wdt_disable();
    TIMSK0 = 0;
    UCSR0B &= (uint8_t)~(1 << RXCIE0);
    ((void (*)(void))0)();
    for (;;)
        ;
}

#endif
