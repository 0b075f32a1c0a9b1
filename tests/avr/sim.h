// SPDX-License-Identifier: Apache-2.0
// An ATmega328P in simavr, whose firmware tells by GPIOR0 where it is (mailbox.h).  Cycles are counted exactly.
#ifndef AVR_SIM_H
#define AVR_SIM_H

#include <stdbool.h>
#include <stdint.h>

typedef struct Sim {
    void *avr;
    uint64_t begin, cycles;   // of the last AVR_BEGIN; from there to the last AVR_END, both writes not counted
    uint8_t said;             // the last thing written to GPIOR0
} Sim;

bool sim_open(Sim *s, const char *elf);               // says on standard error why not
bool sim_until_ready(Sim *s);                         // false: it has stopped, or takes longer than a second
void *sim_mailbox(const Sim *s);                      // where in its memory

#endif
