// SPDX-License-Identifier: Apache-2.0
// An ATmega328P in simavr, or the chip that the variable AVR_MCU names, whose firmware reports its progress in GPIOR0 (mailbox.h).  Cycles are counted exactly.
#ifndef AVR_SIM_H
#define AVR_SIM_H

#include <stdbool.h>
#include <stdint.h>

typedef struct Sim {
    void *avr;
    uint64_t begin, cycles;   // cycle of the last AVR_BEGIN; cycles from it to the last AVR_END, without both writes
    uint8_t said;             // the last value written to GPIOR0
} Sim;

bool sim_open(Sim *s, const char *elf);               // prints the reason of a failure to standard error
bool sim_open_at(Sim *s, const char *elf, uint32_t hertz);     // the same chip with another clock than 16 MHz
bool sim_open_flash(Sim *s, const char *mcu, const uint8_t *flash, uint32_t n);     // another chip of the family
void sim_connect(Sim *s);                             // the firmware's console (console.c) to standard input and output; `begin`: when it was last used
bool sim_until_ready(Sim *s);                         // returns false if the firmware has stopped, or needs more than a second
void *sim_mailbox(const Sim *s);                      // returns the mailbox in the chip's memory
uint8_t *sim_ram(const Sim *s);                       // returns the chip's memory from address 0
uint8_t *sim_flash(const Sim *s);
void sim_eeprom(const Sim *s, uint8_t *bytes, uint16_t n);             // writes these bytes to the EEPROM, from its start
void sim_paint(Sim *s, uint16_t from);                // fills the RAM from this address to the stack with a pattern, for sim_deepest
uint16_t sim_deepest(const Sim *s, uint16_t from);    // returns the number of bytes that the stack has used since

#endif
