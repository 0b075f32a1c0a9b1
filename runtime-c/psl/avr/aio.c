// SPDX-License-Identifier: Apache-2.0
// Analog inputs: channel n is An, 10 bits of the supply, 5 V.  Analog outputs: channel n is pin n, a PWM of 976 Hz between 0 and 5 V; what
// wants a voltage puts a resistor and a capacitor behind it.
#include "runtime-c/pal/aio.h"

#include "runtime-c/psl/avr/avr.h"
#include "runtime-c/psl/avr/board.h"

#ifdef PSL_AVR
#include <util/atomic.h>

enum { OUTPUT = 0x80, DDR = 1, PORT = 2, PWMS = sizeof avr_pwms / sizeof *avr_pwms };
// Handles: n + 1 of an input, OUTPUT + row + 1 of a PWM.

#define SUPPLY 5000000                         // microvolts

static uint16_t inputs;                        // open ones
static bool outputs[PWMS];

static AvrPwm pwm_of(uint8_t row)
{
    AvrPwm p;

    memcpy_P(&p, &avr_pwms[row], sizeof p);
    return p;
}

static uint8_t row_of(uint16_t pin)            // PWMS: it has none
{
    uint8_t row = 0;

    while (row < PWMS && pgm_read_byte(&avr_pwms[row].pin) != pin)
        row++;
    return row;
}

static volatile uint8_t *reg(uint16_t address) { return (volatile uint8_t *)address; }

// ---- opening ----

static SmResult open_input(PalAio *channel, uint16_t number)
{
    SmResult r;

    if (number >= AVR_ANALOGS)
        return SM_E_MISSING;
    if ((r = avr_pin_take((uint8_t)(AVR_ANALOG_FIRST + number))) != SM_OK)
        return r;
    ADCSRA = 1 << ADEN | 7 << ADPS0;           // 125 kHz
    inputs |= (uint16_t)(1u << number);
    channel->id = (uint8_t)(number + 1);
    return SM_OK;
}

// 8 bits, from the crystal through 64: timer 2 counts up to its end, the wide ones to 255.
static void start_timer(const AvrPwm *p)
{
    const bool narrow = p->control == _SFR_ADDR(TCCR2A);

    *reg(p->control) = (uint8_t)(*reg(p->control) | (narrow ? 1 << WGM21 | 1 << WGM20 : 1 << WGM10));
    *reg(p->control + 1) = narrow ? 1 << CS22 : 1 << WGM12 | 1 << CS11 | 1 << CS10;
}

static SmResult open_output(PalAio *channel, uint16_t number)
{
    const uint8_t row = row_of(number);
    volatile uint8_t *port;
    uint8_t mask;
    AvrPwm p;
    SmResult r;

    if (row == PWMS)
        return number < AVR_PINS ? SM_E_UNSUPPORTED : SM_E_MISSING;
    if ((r = avr_pin_take((uint8_t)number)) != SM_OK)
        return r;
    p = pwm_of(row);
    start_timer(&p);
    outputs[row] = true;
    channel->id = (uint8_t)(OUTPUT + row + 1);
    port = avr_pin_port((uint8_t)number, &mask);
    ATOMIC_BLOCK(ATOMIC_RESTORESTATE)
    {
        *reg(p.control) &= (uint8_t)~p.connect;
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

static bool is_input(PalAio c) { return c.id >= 1 && c.id <= AVR_ANALOGS && inputs >> (c.id - 1) & 1; }
static bool is_output(PalAio c) { return c.id > OUTPUT && c.id <= OUTPUT + PWMS && outputs[c.id - OUTPUT - 1]; }

SmResult pal_aio_info(PalAio channel, PalAioInfo *info)
{
    if (!info)
        return SM_E_ARGUMENT;
    if (!is_input(channel) && !is_output(channel))
        return SM_E_HANDLE;
    info->lowest = 0;
    info->highest = is_input(channel) ? SUPPLY - SUPPLY / 1024 : SUPPLY;
    info->step = is_input(channel) ? SUPPLY / 1024 : SUPPLY / 255;
    return SM_OK;
}

// ---- values ----

SmResult pal_aio_read(PalAio channel, int32_t *millionths)
{
    const uint8_t n = (uint8_t)(channel.id - 1);

    if (!millionths || is_output(channel))
        return SM_E_ARGUMENT;
    if (!is_input(channel))
        return SM_E_HANDLE;
    ADMUX = (uint8_t)(1 << REFS0 | (n & 7));
#ifdef MUX5
    ADCSRB = (uint8_t)(n >> 3 << MUX5);
#endif
    ADCSRA |= 1 << ADSC;
    while (ADCSRA & 1 << ADSC)                 // 13 cycles of its clock
        ;
    *millionths = (int32_t)((uint32_t)ADC * (SUPPLY / 64) >> 4);
    return SM_OK;
}

// At both ends no timer is asked: a PWM of 0 still has pulses.
static void set(const AvrPwm *p, uint8_t duty)
{
    volatile uint8_t *port;
    uint8_t mask;

    port = avr_pin_port(p->pin, &mask);
    ATOMIC_BLOCK(ATOMIC_RESTORESTATE)
    {
        if (p->control != _SFR_ADDR(TCCR2A))
            *reg(p->compare + 1) = 0;          // the high byte waits for the low one
        *reg(p->compare) = duty;
        *reg(p->control) = (uint8_t)(duty == 0 || duty == 255 ? *reg(p->control) & ~p->connect : *reg(p->control) | p->connect);
        port[PORT] = (uint8_t)(duty == 255 ? port[PORT] | mask : port[PORT] & ~mask);
    }
}

SmResult pal_aio_write(PalAio channel, int32_t millionths)
{
    AvrPwm p;

    if (is_input(channel))
        return SM_E_ARGUMENT;
    if (!is_output(channel))
        return SM_E_HANDLE;
    p = pwm_of((uint8_t)(channel.id - OUTPUT - 1));
    set(&p, millionths <= 0 ? 0 : millionths >= SUPPLY ? 255 : (uint8_t)(((uint32_t)millionths * 51 + SUPPLY / 10) / (SUPPLY / 5)));
    return SM_OK;
}

SmResult pal_aio_close(PalAio channel)
{
    if (is_input(channel)) {
        inputs &= (uint16_t)~(1u << (channel.id - 1));
        avr_pin_free((uint8_t)(AVR_ANALOG_FIRST + channel.id - 1));
        return SM_OK;
    }
    if (!is_output(channel))
        return SM_E_HANDLE;
    outputs[channel.id - OUTPUT - 1] = false;
    avr_pin_free(pwm_of((uint8_t)(channel.id - OUTPUT - 1)).pin);
    return SM_OK;
}

bool avr_pin_exists(uint16_t number, bool digital, bool output)
{
    return digital ? number < AVR_PINS : output ? row_of(number) < PWMS : number < AVR_ANALOGS;
}

#endif
