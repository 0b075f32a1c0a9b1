// SPDX-License-Identifier: Apache-2.0
// The simulated surroundings of an emulated board: they drive the board's inputs and react to its outputs.
#ifndef AVR_PLANTS_H
#define AVR_PLANTS_H

#include <stdbool.h>

typedef struct Plant {
    const char *name;
    void (*step)(double seconds);
    void (*report)(void);             // prints a line to standard output
} Plant;

const Plant *plant_named(const char *name);            // NULL: there is none with this name

// The board, for plants.
bool board_pin(unsigned pin);                          // whether the pin is an output, and high
void board_set_pin(unsigned pin, bool level);
void board_set_volts(unsigned channel, double volts);

#endif
