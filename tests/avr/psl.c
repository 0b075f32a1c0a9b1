// SPDX-License-Identifier: Apache-2.0
// Firmware: calls of the platform layer, checked on the chip.  It checks the state of a pin that is opened for another use, and results that
// need no device at the other end of a line.
#include "runtime-c/pal/aio.h"
#include "runtime-c/pal/clock.h"
#include "runtime-c/pal/dio.h"
#include "runtime-c/pal/serial.h"
#include "runtime-c/psl/avr/avr.h"
#include "tests/avr/mailbox.h"

static PslBox box;

// Stores the line of the first check that fails.
#define CHECK(condition) check((condition), __LINE__)

static void check(bool held, uint16_t line)
{
    box.passed += held;
    if (!held && box.failed++ == 0)
        box.line = line;
}

// The pins with PWM: their control register, the bit in it that connects the timer, port and bit.
static const struct {
    uint8_t pin;
    volatile uint8_t *control;
    uint8_t connect;
    volatile uint8_t *port;   // its DDR is one below
    uint8_t mask;
} pwm[] = {
    {3, &TCCR2A, 1 << COM2B1, &PORTD, 1 << 3},
    {9, &TCCR1A, 1 << COM1A1, &PORTB, 1 << 1},
    {10, &TCCR1A, 1 << COM1B1, &PORTB, 1 << 2},
    {11, &TCCR2A, 1 << COM2A1, &PORTB, 1 << 3},
};
enum { PWMS = sizeof pwm / sizeof *pwm };

static bool is_connected(uint8_t i) { return (*pwm[i].control & pwm[i].connect) != 0; }
static bool drives(uint8_t i) { return (pwm[i].port[-1] & pwm[i].mask) != 0; }
static bool is_high(uint8_t i) { return (*pwm[i].port & pwm[i].mask) != 0; }

// Closing keeps the value of an output, here half of the supply, because that is the safe value.
static void leave_analog(uint8_t i)
{
    PalAio channel = {0};

    CHECK(pal_aio_open(&channel, pwm[i].pin, PAL_AIO_OUTPUT) == SM_OK && !is_connected(i));
    CHECK(pal_aio_write(channel, 2500000) == SM_OK && is_connected(i));
    CHECK(pal_aio_close(channel) == SM_OK && is_connected(i) && drives(i));
}

// An analog output becomes a digital pin: its level is only that of the port, and the other analog outputs are not changed.
static void check_analog_to_digital(uint8_t i, PalDioMode mode, bool level)
{
    const bool output = mode == PAL_DIO_OUTPUT;
    PalDio pin = {0};

    for (uint8_t k = 0; k < PWMS; k++)
        leave_analog(k);
    CHECK(pal_dio_open(&pin, pwm[i].pin, mode, level) == SM_OK);
    for (uint8_t k = 0; k < PWMS; k++)
        CHECK(is_connected(k) == (k != i));
    CHECK(drives(i) == output && is_high(i) == (output ? level : mode == PAL_DIO_PULL_UP));
    if (output) {
        CHECK(pal_dio_write(pin, !level) == SM_OK && is_high(i) == !level);
        CHECK(!is_connected(i));
    }
    CHECK(pal_dio_close(pin) == SM_OK);
}

// A digital output, or an input with a pull-up resistor, becomes an analog input: it neither drives nor pulls.
static void check_digital_to_analog(uint8_t channel, PalDioMode mode)
{
    const uint8_t mask = (uint8_t)(1 << channel);
    PalDio pin = {0};
    PalAio input = {0};

    CHECK(pal_dio_open(&pin, (uint16_t)(14 + channel), mode, true) == SM_OK && (PORTC & mask) != 0);
    CHECK(pal_dio_close(pin) == SM_OK);
    CHECK(pal_aio_open(&input, channel, PAL_AIO_INPUT) == SM_OK);
    CHECK((DDRC & mask) == 0 && (PORTC & mask) == 0);
    CHECK(pal_aio_close(input) == SM_OK);
}

// *sent is set whatever the result.
static void check_sending(void)
{
    const PalSerial none = {0};
    PalSerial line = {0};
    uint8_t x = 0;
    size_t n = 7;

    CHECK(pal_serial_send(none, &x, 1, &n, 0) == SM_E_HANDLE && n == 0);
    CHECK(pal_serial_open(&line, "Serial", 115200) == SM_OK);
    n = 7;
    CHECK(pal_serial_send(line, NULL, 1, &n, 0) == SM_E_ARGUMENT && n == 0);
    n = 7;
    CHECK(pal_serial_send(line, &x, 1, &n, PAL_TIMEOUT_MAX + 1) == SM_E_ARGUMENT && n == 0);
    CHECK(pal_serial_send(line, &x, 1, NULL, 0) == SM_E_ARGUMENT);
    CHECK(pal_serial_close(line) == SM_OK);
}

// Sleeps while the computer counts cycles: the clock counts true milliseconds at every frequency of the chip.
static void sleep_on_clock(void) { (void)pal_clock_sleep_until(pal_clock_now() + PSL_SLEEP * (uint64_t)PAL_MILLISECOND); }

// The supply is 5 V at 16 MHz, 3.3 V at 8 MHz.
static void check_analog_range(void)
{
    PalAio channel = {0};
    PalAioInfo info = {0};

    CHECK(pal_aio_open(&channel, 9, PAL_AIO_OUTPUT) == SM_OK && pal_aio_info(channel, &info) == SM_OK);
    CHECK(info.lowest == 0 && info.highest == (F_CPU == 8000000 ? 3300000 : 5000000));
    CHECK(pal_aio_write(channel, info.highest / 2) == SM_OK && (OCR1A == 127 || OCR1A == 128));
    CHECK(pal_aio_close(channel) == SM_OK);
}

static void run_checks(void)
{
    for (uint8_t i = 0; i < PWMS; i++) {
        check_analog_to_digital(i, PAL_DIO_INPUT, false);
        check_analog_to_digital(i, PAL_DIO_PULL_UP, false);
        check_analog_to_digital(i, PAL_DIO_OUTPUT, false);
        check_analog_to_digital(i, PAL_DIO_OUTPUT, true);
    }
    for (uint8_t channel = 0; channel < 6; channel++) {
        check_digital_to_analog(channel, PAL_DIO_OUTPUT);
        check_digital_to_analog(channel, PAL_DIO_PULL_UP);
    }
    check_analog_range();
    check_sending();
}

int main(void)
{
    uint64_t resolution;

    (void)pal_clock_resolution(&resolution);           // starts the clock
    mailbox_serve(&box, sleep_on_clock, run_checks);
}
