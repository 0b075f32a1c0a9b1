// SPDX-License-Identifier: Apache-2.0
// Digital pins by Arduino pin number; pin n has handle n + 1.
#include "runtime-c/pal/dio.h"

#include "runtime-c/psl/avr/avr.h"
#include "runtime-c/psl/avr/board.h"

#ifdef PSL_AVR
#include <util/atomic.h>

enum { DDR = 1, PORT = 2 };                    // offsets of registers from PIN

static uint8_t claimed[(AVR_PINS + AVR_ANALOGS + AVR_PWMS + 7) / 8] = {(1 << AVR_SERIAL_PINS) - 1};

// Returns the mask with bit number % 8 set.
static uint8_t bit_of(uint8_t number)
{
    uint8_t bit = 1;

    for (number &= 7; number > 0; number--)
        bit = (uint8_t)(bit << 1);
    return bit;
}

// Returns the PIN register of the pin's port, which DDR and PORT follow; *mask receives the pin's bit.
volatile uint8_t *avr_pin_port(uint8_t number, uint8_t *mask)
{
    const uint8_t port_and_bit = pgm_read_byte(&avr_pins[number]);
    const uint8_t port = port_and_bit >> 3;

    *mask = bit_of(port_and_bit);
    return (volatile uint8_t *)(uint16_t)(port < AVR_PORTS_LOW ? AVR_PORT_LOW + 3 * port : AVR_PORT_HIGH + 3 * (port - AVR_PORTS_LOW));
}

// Whether the pin is in use; numbers from AVR_PINS on are analog channels.
bool avr_pin_is_claimed(uint8_t number) { return (claimed[number >> 3] & bit_of(number)) != 0; }

// Marks a pin as in use; SM_E_BUSY: it already is, or it belongs to the serial line.
SmResult avr_pin_claim(uint8_t number)
{
    if (avr_pin_is_claimed(number))
        return SM_E_BUSY;
    claimed[number >> 3] |= bit_of(number);
    return SM_OK;
}

void avr_pin_release(uint8_t number) { claimed[number >> 3] &= (uint8_t)~bit_of(number); }

// Sets or clears bits of a port's register, with interrupts off.
void avr_pin_set(volatile uint8_t *byte, uint8_t mask, bool level)
{
    ATOMIC_BLOCK(ATOMIC_RESTORESTATE) *byte = (uint8_t)(level ? *byte | mask : *byte & ~mask);
}

SmResult pal_dio_open(PalDio *pin, uint16_t number, PalDioMode mode, bool level)
{
    const bool output = mode == PAL_DIO_OUTPUT;
    volatile uint8_t *port;
    uint8_t mask;
    SmResult r;

    if (!pin || (unsigned)mode > PAL_DIO_OUTPUT)
        return SM_E_ARGUMENT;
    if (number >= AVR_PINS)
        return SM_E_MISSING;
    if (mode == PAL_DIO_PULL_DOWN)
        return SM_E_UNSUPPORTED;
    if ((r = avr_pin_claim((uint8_t)number)) != SM_OK)
        return r;
    port = avr_pin_port((uint8_t)number, &mask);
    if (!output) {
        avr_pin_set(port + DDR, mask, false);  // DDR before PORT: PORT then selects the pull-up; on an output it would drive the level
        level = mode == PAL_DIO_PULL_UP;
    }
    avr_pin_set(port + PORT, mask, level);
    avr_pin_disconnect((uint8_t)number);       // after the level is set: the pin may still have the value of an analog output
    if (output)
        avr_pin_set(port + DDR, mask, true);
    pin->id = (uint8_t)(number + 1);
    return SM_OK;
}

static bool is_open(PalDio pin) { return pin.id > AVR_SERIAL_PINS && pin.id <= AVR_PINS && avr_pin_is_claimed((uint8_t)(pin.id - 1)); }

SmResult pal_dio_read(PalDio pin, bool *level)
{
    const volatile uint8_t *port;
    uint8_t mask;

    if (!level)
        return SM_E_ARGUMENT;
    if (!is_open(pin))
        return SM_E_HANDLE;
    port = avr_pin_port((uint8_t)(pin.id - 1), &mask);
    *level = ((port[DDR] & mask ? port[PORT] : port[0]) & mask) != 0;
    return SM_OK;
}

SmResult pal_dio_write(PalDio pin, bool level)
{
    volatile uint8_t *port;
    uint8_t mask;

    if (!is_open(pin))
        return SM_E_HANDLE;
    port = avr_pin_port((uint8_t)(pin.id - 1), &mask);
    if ((port[DDR] & mask) == 0)
        return SM_E_ARGUMENT;
    avr_pin_set(port + PORT, mask, level);
    return SM_OK;
}

// An output keeps its level after the close.
SmResult pal_dio_close(PalDio pin)
{
    if (!is_open(pin))
        return SM_E_HANDLE;
    avr_pin_release((uint8_t)(pin.id - 1));
    return SM_OK;
}

#endif
