// SPDX-License-Identifier: Apache-2.0
// Internal to this platform, and used by firmware for AVR that needs more than the PAL.  Such firmware runs its control steps in
// the clock's interrupt.  The serial line and the EEPROM have lower priority.
#ifndef PSL_AVR_H
#define PSL_AVR_H

#include <stdbool.h>
#include <stdint.h>

#include "runtime-c/psl/avr/chip.h"
#include "stdlib/result.h"

#ifdef PSL_AVR                // a new chip also needs a table in board.h
#include <avr/interrupt.h>
#include <avr/io.h>

// ---- clock: timer 0 with a period of 1 ms (so its pins have no PWM) ----

void avr_clock_start(void (*tick)(void));              // the interrupt calls `tick`, unless NULL, every ms
uint32_t avr_milliseconds(void);                       // milliseconds since the start of the clock, modulo 2^32

// ---- pins: one owner each, digital or analog ----

#ifdef __AVR_ATmega2560__
#define AVR_PINS 70
#else
#define AVR_PINS 20
#endif
#define AVR_SERIAL_PINS 2     // pins 0 and 1 belong to the serial line
#define AVR_NO_PIN 0xffu
// Returns the number of the digital pin that a pin or analog channel uses.  AVR_NO_PIN: it does not exist, or belongs to the serial line.
uint8_t avr_physical_pin(uint16_t number, uint8_t kind);      // kind: 1: output, 2: digital, 16: pull-down
SmResult avr_pin_claim(uint8_t number);                // marks a pin as in use; SM_E_BUSY: it already is, or it belongs to the serial line
void avr_pin_release(uint8_t number);
bool avr_pin_is_claimed(uint8_t number);               // whether the pin is in use; numbers from AVR_PINS on are analog channels
void avr_pin_set(volatile uint8_t *byte, uint8_t mask, bool level);     // sets or clears bits of a port's register, with interrupts off
void avr_pin_disconnect(uint8_t number);               // disconnects the pin from its timer's PWM, if it has one
volatile uint8_t *avr_pin_port(uint8_t number, uint8_t *mask);         // the port's PIN register; DDR and PORT follow it

// ---- EEPROM ----

// A byte takes 3.4 ms to write, and no byte can be read meanwhile.  Before each write, `may` is called with interrupts off,
// repeatedly until it returns true.  Code that reads the EEPROM in real time returns false shortly before it reads.  NULL: always
// allowed.
void avr_eeprom_guard_writes(bool (*may)(void));

// Begins to write a byte and does not wait for its end.  Returns false if another write is in progress or `may` returns false.
bool avr_eeprom_begin_write(uint16_t at, uint8_t byte);

static inline uint8_t avr_eeprom_read(uint16_t at)
{
    while (EECR & 1 << EEPE)
        ;
    EEAR = at;
    EECR |= 1 << EERE;
    return EEDR;
}

// An interrupt handler that reads the EEPROM calls these two around its reads.  They restore the address and the data of a read
// that the interrupt may have interrupted.
static inline uint16_t avr_eeprom_save_address(void) { return EEAR; }
static inline void avr_eeprom_restore_address(uint16_t address)
{
    if (EECR & 1 << EEPE)
        return;                            // a write is in progress, so the handler has read nothing
    EEAR = address;
    EECR |= 1 << EERE;
}

// ---- restart ----

void avr_restart(void) __attribute__((noreturn));      // jumps to the reset vector; pins keep their levels until they are opened

#endif
#endif
