// SPDX-License-Identifier: Apache-2.0
// An emulated Uno or Mega that controls the tank of plant.h.  Prints what the sketch sends on its serial line, and the largest size of its
// stack.
//   board MCU ELF
#include <simavr/avr_adc.h>
#include <simavr/avr_ioport.h>
#include <simavr/avr_uart.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "tests/arduino/plant.h"

enum { HERTZ = 16000000, MILLIVOLTS = 5000, COUNTS = 1023, PAINT = 0xA5 };

typedef struct Board {
    avr_t *avr;
    int pressure, step;
    unsigned statics;         // the first address after static data
} Board;

static void say_errors(struct avr_t *avr, const int level, const char *format, va_list args)
{
    (void)avr;
    if (level <= LOG_ERROR)
        vfprintf(stderr, format, args);
}

// Pin 8 is PB0 of an Uno, PH5 of a Mega.
static bool valve_is_open(const Board *b)
{
    avr_ioport_state_t port;

    if (avr_ioctl(b->avr, AVR_IOCTL_IOPORT_GETSTATE('H'), &port) == 0)
        return (port.port >> 5 & 1) != 0;
    return avr_ioctl(b->avr, AVR_IOCTL_IOPORT_GETSTATE('B'), &port) == 0 && (port.port & 1) != 0;
}

static void measure(Board *b)
{
    avr_raise_irq(avr_io_getirq(b->avr, AVR_IOCTL_ADC_GETIRQ, ADC_IRQ_ADC0), (uint32_t)(b->pressure * MILLIVOLTS + COUNTS - 1) / COUNTS);
}

static void on_character(struct avr_irq_t *irq, uint32_t c, void *param)
{
    Board *b = param;

    (void)irq;
    if (c != '\r')
        putchar((int)c);
    if (c == '\n') {
        b->pressure = plant_next(b->pressure, valve_is_open(b), b->step++);
        measure(b);
    }
}

static bool board_open(Board *b, const char *mcu, const char *elf)
{
    elf_firmware_t firmware;
    uint32_t flags = 0;

    memset(&firmware, 0, sizeof firmware);
    avr_global_logger_set(say_errors);
    b->avr = avr_make_mcu_by_name(mcu);
    if (b->avr == NULL || elf_read_firmware(elf, &firmware) != 0)
        return false;
    avr_init(b->avr);
    firmware.frequency = HERTZ;
    avr_load_firmware(b->avr, &firmware);
    b->avr->vcc = b->avr->avcc = b->avr->aref = MILLIVOLTS;
    avr_ioctl(b->avr, AVR_IOCTL_UART_SET_FLAGS('0'), &flags);
    avr_irq_register_notify(avr_io_getirq(b->avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_OUTPUT), on_character, b);
    b->statics = b->avr->ioend + 1u + firmware.datasize + firmware.bsssize;
    memset(b->avr->data + b->statics, PAINT, b->avr->ramend + 1u - b->statics);
    return true;
}

// The RAM is filled with a pattern before the start.  The first byte, from below, without the pattern is the deepest that the stack has reached.
static unsigned deepest(const Board *b)
{
    unsigned at = b->statics;

    while (at <= b->avr->ramend && b->avr->data[at] == PAINT)
        at++;
    return b->avr->ramend + 1u - at;
}

int main(int argc, char **argv)
{
    Board b = {NULL, PLANT_FIRST, 0, 0};

    if (argc != 3 || !board_open(&b, argv[1], argv[2]))
        return 2;
    measure(&b);
    while (b.step < PLANT_STEPS && b.avr->cycle < (avr_cycle_count_t)HERTZ * 30) {
        const int state = avr_run(b.avr);
        if (state == cpu_Done || state == cpu_Crashed)
            return 1;
    }
    fprintf(stderr, "%u bytes of stack\n", deepest(&b));
    return 0;
}
