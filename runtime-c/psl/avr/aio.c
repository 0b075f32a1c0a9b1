// SPDX-License-Identifier: Apache-2.0
// Analog inputs: channel n is pin An, 10 bits, relative to the supply.  Analog outputs: channel n is pin n, a PWM of 976 Hz (at 8 MHz:
// 488 Hz) between 0 and the supply.  A resistor and a capacitor at the pin turn it into a voltage.
#include "runtime-c/pal/aio.h"

#include "runtime-c/psl/avr/avr.h"
#include "runtime-c/psl/avr/board.h"

#ifdef PSL_AVR
#include <util/atomic.h>

enum { DDR = 1, PORT = 2 };                    // offsets of registers from PIN
// Channel indexes: inputs first; from OUTPUT on, the rows of avr_pwms.  The handle is the index plus 1.
enum { OUTPUT = AVR_ANALOGS };

// The supply in microvolts.  Boards of 8 MHz have 3.3 V, which is too little for 16 MHz.
#ifndef AVR_SUPPLY
#define AVR_SUPPLY (F_CPU == 8000000 ? 3300000 : 5000000)
#endif

// Copies the row of an output channel from flash.
static void load_pwm(uint8_t channel, AvrPwm *p) { memcpy_P(p, &avr_pwms[(uint8_t)(channel - OUTPUT)], sizeof *p); }

// Returns the row of the pin in avr_pwms; AVR_PWMS if the pin has no PWM.
static uint8_t pwm_row(uint16_t pin)
{
    uint8_t row = 0;

    while (row < AVR_PWMS && pgm_read_byte(&avr_pwms[row].pin) != pin)
        row++;
    return row;
}

// Returns a pointer to the register at an address.
static volatile uint8_t *register_at(uint16_t address) { return (volatile uint8_t *)address; }

// ---- opening ----

// Claims the pin, and marks the channel as open under the number AVR_PINS + index.
static SmResult claim_channel(PalAio *channel, uint8_t index, uint8_t pin)
{
    const SmResult r = avr_pin_claim(pin);

    if (r == SM_OK) {
        (void)avr_pin_claim((uint8_t)(AVR_PINS + index));
        channel->id = (uint8_t)(index + 1);
    }
    return r;
}

// Opens an input.  Clears direction and pull-up first, because the pin may have been a digital output or had a pull-up resistor.
static SmResult open_input(PalAio *channel, uint16_t number)
{
    const uint8_t pin = (uint8_t)(AVR_ANALOG_FIRST + number);
    volatile uint8_t *port;
    uint8_t mask;
    SmResult r;

    if (number >= AVR_ANALOGS)
        return SM_E_MISSING;
    if ((r = claim_channel(channel, (uint8_t)number, pin)) != SM_OK)
        return r;
    port = avr_pin_port(pin, &mask);
    avr_pin_set(port + PORT, mask, false);
    avr_pin_set(port + DDR, mask, false);
    ADCSRA = 1 << ADEN | (F_CPU == 8000000 ? 6 : 7) << ADPS0;  // 125 kHz ADC clock
    return SM_OK;
}

// Disconnects the pin from its timer's PWM, if it has one.
void avr_pin_disconnect(uint8_t number)
{
    const uint8_t row = pwm_row(number);
    AvrPwm p;

    if (row == AVR_PWMS)
        return;
    load_pwm((uint8_t)(OUTPUT + row), &p);
    avr_pin_set(register_at(p.control), p.connect, false);
}

// Starts a timer for 8-bit PWM, clocked at F_CPU / 64.  Timer 2 counts to its maximum, the 16-bit timers to 255.
static void start_timer(const AvrPwm *p)
{
    const bool narrow = p->control == _SFR_ADDR(TCCR2A);

    *register_at(p->control) = (uint8_t)(*register_at(p->control) | (narrow ? 1 << WGM21 | 1 << WGM20 : 1 << WGM10));
    *register_at(p->control + 1) = narrow ? 1 << CS22 : 1 << WGM12 | 1 << CS11 | 1 << CS10;
}

static SmResult open_output(PalAio *channel, uint16_t number)
{
    const uint8_t row = pwm_row(number);
    volatile uint8_t *port;
    uint8_t mask;
    AvrPwm p;
    SmResult r;

    if (row == AVR_PWMS)
        return number < AVR_PINS ? SM_E_UNSUPPORTED : SM_E_MISSING;
    if ((r = claim_channel(channel, (uint8_t)(OUTPUT + row), (uint8_t)number)) != SM_OK)
        return r;
    load_pwm((uint8_t)(OUTPUT + row), &p);
    start_timer(&p);
    port = avr_pin_port((uint8_t)number, &mask);
    ATOMIC_BLOCK(ATOMIC_RESTORESTATE)
    {
        *register_at(p.control) &= (uint8_t)~p.connect;
        port[PORT] &= (uint8_t)~mask;
        port[DDR] |= mask;
    }
    return SM_OK;
}

SmResult pal_aio_open(PalAio *channel, uint16_t number, PalAioMode mode)
{
    if (!channel || (unsigned)mode > PAL_AIO_OUTPUT)
        return SM_E_ARGUMENT;
    return mode == PAL_AIO_INPUT ? open_input(channel, number) : open_output(channel, number);
}

static bool is_open(PalAio c) { return c.id >= 1 && c.id <= OUTPUT + AVR_PWMS && avr_pin_is_claimed((uint8_t)(AVR_PINS + c.id - 1)); }
static bool is_input(PalAio c) { return c.id <= OUTPUT; }

SmResult pal_aio_info(PalAio channel, PalAioInfo *info)
{
    if (!info)
        return SM_E_ARGUMENT;
    if (!is_open(channel))
        return SM_E_HANDLE;
    info->lowest = 0;
    info->highest = is_input(channel) ? AVR_SUPPLY - AVR_SUPPLY / 1024 : AVR_SUPPLY;
    info->step = is_input(channel) ? AVR_SUPPLY / 1024 : AVR_SUPPLY / 255;
    return SM_OK;
}

// ---- values ----

SmResult pal_aio_read(PalAio channel, int32_t *millionths)
{
    const uint8_t n = (uint8_t)(channel.id - 1);

    if (!millionths)
        return SM_E_ARGUMENT;
    if (!is_open(channel))
        return SM_E_HANDLE;
    if (!is_input(channel))
        return SM_E_ARGUMENT;
    ADMUX = (uint8_t)(1 << REFS0 | (n & 7));
#ifdef MUX5
    ADCSRB = (uint8_t)(n >> 3 << MUX5);
#endif
    ADCSRA |= 1 << ADSC;
    while (ADCSRA & 1 << ADSC)                 // 13 cycles of the ADC clock
        ;
    *millionths = (int32_t)((uint32_t)ADC * (AVR_SUPPLY / 32) >> 5);
    return SM_OK;
}

// Sets the duty of a PWM output, 0 to 255.  At both ends the pin is disconnected from the timer, because a PWM with duty 0 still has pulses.
static void set_duty(const AvrPwm *p, uint8_t duty)
{
    volatile uint8_t *port;
    uint8_t mask;

    port = avr_pin_port(p->pin, &mask);
    ATOMIC_BLOCK(ATOMIC_RESTORESTATE)
    {
        if (p->control != _SFR_ADDR(TCCR2A))
            *register_at(p->compare + 1) = 0;          // the high byte is buffered until the low one is written
        *register_at(p->compare) = duty;
    }
    avr_pin_set(port + PORT, mask, duty == 255);           // first: the pin has this level as soon as the timer is disconnected
    avr_pin_set(register_at(p->control), p->connect, duty != 0 && duty != 255);
}

// Returns the duty of an output voltage, 0 to 255 for 0 to AVR_SUPPLY, rounded.  The division bit by bit takes half the time and half the code
// of gcc's division.
static uint8_t compute_duty(uint32_t millionths)
{
    uint32_t left = millionths * 51 + AVR_SUPPLY / 10, part = AVR_SUPPLY / 5 * UINT32_C(128);
    uint8_t duty = 0;

    for (uint8_t bit = 128; bit > 0; bit >>= 1, part >>= 1)
        if (left >= part) {
            left -= part;
            duty |= bit;
        }
    return duty;
}

SmResult pal_aio_write(PalAio channel, int32_t millionths)
{
    AvrPwm p;

    if (!is_open(channel))
        return SM_E_HANDLE;
    if (is_input(channel))
        return SM_E_ARGUMENT;
    load_pwm((uint8_t)(channel.id - 1), &p);
    set_duty(&p, millionths <= 0 ? 0 : millionths >= AVR_SUPPLY ? 255 : compute_duty((uint32_t)millionths));
    return SM_OK;
}

// An output keeps its value after the close.
SmResult pal_aio_close(PalAio channel)
{
    if (!is_open(channel))
        return SM_E_HANDLE;
    avr_pin_release((uint8_t)(AVR_PINS + channel.id - 1));
    avr_pin_release((uint8_t)(is_input(channel) ? AVR_ANALOG_FIRST + channel.id - 1
                                             : pgm_read_byte(&avr_pwms[channel.id - OUTPUT - 1].pin)));
    return SM_OK;
}

uint8_t avr_physical_pin(uint16_t number, uint8_t kind)
{
    if ((kind & 3) == 0)
        return number < AVR_ANALOGS ? (uint8_t)(AVR_ANALOG_FIRST + number) : AVR_NO_PIN;
    if (kind & 16)
        return AVR_NO_PIN;                     // the chip has no pull-down resistors
    return (kind & 2 ? number >= AVR_SERIAL_PINS && number < AVR_PINS : pwm_row(number) < AVR_PWMS) ? (uint8_t)number : AVR_NO_PIN;
}

#endif
