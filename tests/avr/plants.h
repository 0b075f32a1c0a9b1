// SPDX-License-Identifier: Apache-2.0
// The simulated surroundings of an emulated board: they drive the board's inputs and react to its outputs.
#ifndef AVR_PLANTS_H
#define AVR_PLANTS_H

#include <stdbool.h>

typedef struct Plant {
    const char *name;
    void (*step)(double seconds);
    void (*report)(void);             // to standard output, a line
} Plant;

const Plant *plant_named(const char *name);            // NULL: none

// The board, for plants.
bool board_pin(unsigned pin);                          // an output, and high
void board_set_pin(unsigned pin, bool level);
void board_set_volts(unsigned channel, double volts);

#endif
