// SPDX-License-Identifier: Apache-2.0
// See sim.h.
#include "tests/avr/sim.h"

#include <simavr/avr_eeprom.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>
#include <simavr/sim_io.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

#include "tests/avr/mailbox.h"

enum { HERTZ = 16000000, GPIOR0 = 0x3E, GPIOR1 = 0x4A, GPIOR2 = 0x4B, PAINT = 0xA5 };

static void on_write(struct avr_t *avr, avr_io_addr_t address, uint8_t value, void *param)
{
    Sim *s = param;

    avr->data[address] = value;
    s->said = value;
    if (value == AVR_BEGIN)
        s->begin = avr->cycle;
    else if (value == AVR_END)
        s->cycles = avr->cycle - s->begin - 2;        // loading AVR_END and writing it
}

static void say_errors(struct avr_t *avr, const int level, const char *format, va_list args)
{
    (void)avr;
    if (level <= LOG_ERROR)
        vfprintf(stderr, format, args);
}

// The chip of the programs that open an ELF file: an ATmega328P, or the one that AVR_MCU names.
static const char *chip(void) { return getenv("AVR_MCU") != NULL ? getenv("AVR_MCU") : "atmega328p"; }

static avr_t *make(Sim *s, const char *mcu)
{
    avr_t *avr;

    avr_global_logger_set(say_errors);
    avr = avr_make_mcu_by_name(mcu);
    *s = (Sim){ .avr = avr };
    if (avr != NULL)
        avr_init(avr);
    return avr;
}

bool sim_open_flash(Sim *s, const char *mcu, const uint8_t *flash, uint32_t n)
{
    avr_t *avr = make(s, mcu);

    if (avr == NULL || n > avr->flashend) {
        fprintf(stderr, "%s: cannot be had, or is too small\n", mcu);
        return false;
    }
    avr->frequency = HERTZ;
    avr_loadcode(avr, (uint8_t *)flash, n, 0);
    return true;
}

bool sim_open(Sim *s, const char *elf) { return sim_open_at(s, elf, HERTZ); }

bool sim_open_at(Sim *s, const char *elf, uint32_t hertz)
{
    elf_firmware_t firmware = {0};
    avr_t *avr = make(s, chip());

    if (avr == NULL || elf_read_firmware(elf, &firmware) != 0) {
        fprintf(stderr, "%s: cannot be run\n", elf);
        return false;
    }
    firmware.frequency = hertz;
    avr_load_firmware(avr, &firmware);
    avr_register_io_write(avr, GPIOR0, on_write, s);
    return true;
}

bool sim_until_ready(Sim *s)
{
    avr_t *avr = s->avr;
    const avr_cycle_count_t limit = avr->cycle + HERTZ;

    s->said = 0;
    while (avr->cycle < limit) {
        const int state = avr_run(avr);
        if (state == cpu_Done || state == cpu_Crashed)
            break;
        if (s->said == AVR_READY)
            return true;
    }
    fprintf(stderr, "the firmware does not answer\n");
    return false;
}

// ---- the console ----

static uint8_t on_take(struct avr_t *avr, avr_io_addr_t address, void *param)
{
    int c;

    (void)address;
    ((Sim *)param)->begin = avr->cycle;
    fflush(stdout);
    if ((c = getchar()) == EOF)
        exit(0);
    return (uint8_t)c;
}

static void on_give(struct avr_t *avr, avr_io_addr_t address, uint8_t value, void *param)
{
    (void)address;
    ((Sim *)param)->begin = avr->cycle;
    putchar(value);
}

void sim_connect(Sim *s)
{
    avr_register_io_write(s->avr, GPIOR1, on_give, s);
    avr_register_io_read(s->avr, GPIOR2, on_take, s);
}

void *sim_mailbox(const Sim *s)
{
    const avr_t *avr = s->avr;

    return avr->data + (avr->data[GPIOR1] | avr->data[GPIOR2] << 8);
}

uint8_t *sim_ram(const Sim *s) { return ((avr_t *)s->avr)->data; }
uint8_t *sim_flash(const Sim *s) { return ((avr_t *)s->avr)->flash; }

void sim_eeprom(const Sim *s, uint8_t *bytes, uint16_t n)
{
    avr_eeprom_desc_t d = {bytes, 0, n};

    avr_ioctl(s->avr, AVR_IOCTL_EEPROM_SET, &d);
}

void sim_paint(Sim *s, uint16_t from)
{
    const avr_t *avr = s->avr;
    const unsigned sp = avr->data[R_SPL] | avr->data[R_SPH] << 8;

    for (unsigned i = from; i < sp; i++)
        avr->data[i] = PAINT;
}

uint16_t sim_deepest(const Sim *s, uint16_t from)
{
    const avr_t *avr = s->avr;

    while (avr->data[from] == PAINT)
        from++;
    return (uint16_t)(avr->ramend + 1 - from);
}
