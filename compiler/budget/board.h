// SPDX-License-Identifier: Apache-2.0
// What the firmware of a board can run.
#ifndef SMC_BOARD_H
#define SMC_BOARD_H

#include <stdbool.h>
#include <stdint.h>

#include "compiler/base/arena.h"

// A row of boards.def.
typedef struct Board { const char *mcu, *name; uint32_t image, ram, digital, analog, functions; } Board;

const Board *board_find(const char *mcu);         // NULL if the firmware does not support the chip
// Returns the board with the least memory that can run a machine; NULL if none can.  `image`, `ram`: bytes; `functions`: those it calls.
const Board *board_smallest(uint32_t image, uint32_t ram, uint32_t functions);
const Board *board_largest(void);
bool board_has_function(const Board *b, const char *name);        // whether machines can call this elementary function
// Returns the names of the boards that have the function, as in "a Mega"; NULL if none has it.
const char *board_list_with_function(Arena *arena, const char *name);

#endif
