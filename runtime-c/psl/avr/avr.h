// SPDX-License-Identifier: Apache-2.0
// What the files of this platform share, and what a firmware for AVR may use beyond the PAL: it runs its control steps in the clock's
// interrupt, and the line and the EEPROM behind them.
#ifndef PSL_AVR_H
#define PSL_AVR_H

#include <stdbool.h>
#include <stdint.h>

#include "stdlib/result.h"

// The chips of Uno and Mega; elsewhere these files are there, and empty.  Another one is a table in board.h, too.
#if defined(__AVR_ATmega328P__) || defined(__AVR_ATmega2560__)
#define PSL_AVR
#include <avr/interrupt.h>
#include <avr/io.h>

// ---- clock: timer 0, a millisecond a tick (so the pins of timer 0 have no PWM) ----

void avr_clock_start(void (*tick)(void));              // `tick`, or NULL, is called every millisecond in the interrupt
uint32_t avr_milliseconds(void);                       // since then, modulo 2^32
uint16_t avr_fine(void);                               // in units of 4 microseconds, modulo 2^16; with interrupts off

// ---- pins: one owner each, digital or analog ----

#ifdef __AVR_ATmega2560__
#define AVR_PINS 70
#else
#define AVR_PINS 20
#endif
#define AVR_LINE 2            // pins 0 and 1 are the serial line's
#define AVR_NO_PIN 0xffu
// The digital number of what an analog channel, too, is a pin of.  AVR_NO_PIN: there is none, or the serial line has it.
uint8_t avr_pin_place(uint16_t number, uint8_t kind);         // 1: an output, 2: digital, 16: pulled down
SmResult avr_pin_take(uint8_t number);                 // SM_E_BUSY: it is taken, or the serial line has it
void avr_pin_free(uint8_t number);
bool avr_pin_taken(uint8_t number);                    // behind the pins are numbers for what else is taken: analog channels
volatile uint8_t *avr_pin_port(uint8_t number, uint8_t *mask);         // the port's PIN; DDR and PORT stand behind it

// ---- EEPROM ----

// A byte takes 3.4 ms to be written, and until then none can be read.  Before each, `may` is asked with interrupts off until it says
// yes: what must read in time says no when it is soon to do so.  NULL: always.
void avr_eeprom_ask(bool (*may)(void));

static inline uint8_t avr_eeprom_read(uint16_t at)
{
    while (EECR & 1 << EEPE)
        ;
    EEAR = at;
    EECR |= 1 << EERE;
    return EEDR;
}

// An interrupt that reads: around all its reads.  What was interrupted may have been about to.
static inline uint16_t avr_eeprom_enter(void) { return EEAR; }
static inline void avr_eeprom_leave(uint16_t address)
{
    if (EECR & 1 << EEPE)
        return;                            // then nothing was read
    EEAR = address;
    EECR |= 1 << EERE;
}

// ---- the end ----

void avr_restart(void) __attribute__((noreturn));      // from the reset vector on; pins keep their levels until they are opened

#endif
#endif
