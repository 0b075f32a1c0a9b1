// SPDX-License-Identifier: Apache-2.0
// The clock: timer 0 counts in steps of 4 µs (at 8 MHz: 8 µs) and restarts every millisecond.
#include "runtime-c/pal/clock.h"

#include "runtime-c/psl/avr/avr.h"

#ifdef PSL_AVR
#include <avr/sleep.h>
#include <util/atomic.h>

enum { STEPS = F_CPU / 64 / 1000, STEP = 1000 / STEPS };       // timer steps in a millisecond; microseconds in a step

static volatile uint32_t milliseconds;
static volatile uint16_t wraps;        // how often `milliseconds` wrapped around
static void (*tick_handler)(void);

ISR(TIMER0_COMPA_vect)
{
    if (++milliseconds == 0)
        wraps++;
    if (tick_handler)
        tick_handler();
}

void avr_clock_start(void (*tick)(void))
{
    tick_handler = tick;
    TCCR0A = 1 << WGM01;               // counts up to OCR0A
    OCR0A = STEPS - 1;
    TCNT0 = 0;
    TIFR0 = 1 << OCF0A;
    TIMSK0 = 1 << OCIE0A;
    TCCR0B = 1 << CS01 | 1 << CS00;    // F_CPU / 64
}

// Returns the milliseconds since the start of the clock, modulo 2^32.
uint32_t avr_milliseconds(void)
{
    uint32_t now;

    ATOMIC_BLOCK(ATOMIC_RESTORESTATE) now = milliseconds;
    return now;
}

// Reads the timer. *more is 1 if it has restarted and the interrupt has not counted that millisecond yet.
static uint8_t read_timer(uint8_t *more)
{
    uint8_t t = TCNT0;

    *more = TIFR0 >> OCF0A & 1;
    if (*more)
        t = TCNT0;
    return t;
}

uint64_t pal_clock_now(void)
{
    uint64_t ms;
    uint8_t t, more;

    ATOMIC_BLOCK(ATOMIC_RESTORESTATE)
    {
        t = read_timer(&more);
        ms = (uint64_t)wraps << 32 | milliseconds;
    }
    return (ms + more) * PAL_MILLISECOND + (uint32_t)t * (STEP * PAL_MICROSECOND);
}

SmResult pal_clock_resolution(uint64_t *ns)
{
    if (!ns)
        return SM_E_ARGUMENT;
    if (TCCR0B == 0) {                 // not started yet
        avr_clock_start(0);
        sei();
    }
    *ns = STEP * PAL_MICROSECOND;
    return SM_OK;
}

SmResult pal_clock_sleep_until(uint64_t time)
{
    uint64_t now = pal_clock_now();

    if (time > now && time - now > PAL_TIMEOUT_MAX)
        return SM_E_ARGUMENT;
    SMCR = 1 << SE;                    // enables idle mode
    for (; now < time; now = pal_clock_now())
        if (time - now > PAL_MILLISECOND)
            sleep_cpu();               // until the next interrupt: that of the timer follows within a millisecond
    SMCR = 0;
    return SM_OK;
}

#endif
