// SPDX-License-Identifier: Apache-2.0
// Estimates how many cycles an instruction of the VM takes on an ATmega328P, with measured numbers (avr_cycles.def).  The model
// tracks which registers always contain whole numbers, because arithmetic in software takes ten times as long.  It tracks
// nothing else about values.
#ifndef SMC_CYCLES_H
#define SMC_CYCLES_H

#include <stdbool.h>
#include <stdint.h>

#include "bytecode-vm/image.h"

typedef enum CyclesRow {
#define CYCLES_ROW(name, ...) CYCLES_##name,
#define CYCLES_WINDOW(name, ...)
#define CYCLES_STACK(bytes)
#include "compiler/budget/avr_cycles.def"
#undef CYCLES_ROW
#undef CYCLES_WINDOW
#undef CYCLES_STACK
    CYCLES_ROWS
} CyclesRow;

typedef enum CyclesWindow {
#define CYCLES_ROW(name, ...)
#define CYCLES_WINDOW(name, ...) CYCLES_##name,
#define CYCLES_STACK(bytes)
#include "compiler/budget/avr_cycles.def"
#undef CYCLES_ROW
#undef CYCLES_WINDOW
#undef CYCLES_STACK
    CYCLES_WINDOW_ROWS
} CyclesWindow;

enum { CYCLES_KEYS = 6 };                 // how windows store their samples: in 1, 2, 4 or 8 bytes, as F32, as F64

typedef enum CyclesChip { CYCLES_FLASH, CYCLES_EEPROM } CyclesChip;       // an ATmega328P, and where its image is

// What is known about a register.
typedef struct CyclesReg {
    bool whole;               // always a whole number
    bool signed_;             // may be negative
    uint32_t most;            // its largest magnitude
} CyclesReg;

typedef struct Cycles {
    CyclesChip chip;
    const SmvmMachine *m;
    CyclesReg x, y;
} Cycles;

uint32_t cycles_stack(void);              // bytes of stack below a step, the largest measured value
uint32_t cycles_row(CyclesChip chip, CyclesRow row, bool whole);
uint32_t cycles_window(CyclesWindow row, uint8_t type, uint32_t slots);

// Call before the first instruction.  Returns the cost of a step besides its functions.
uint32_t cycles_begin(Cycles *c, CyclesChip chip, const SmvmMachine *m);
// The cost of the next instruction in the order of the image, with its numbers.  One that ends a function includes the call of
// the function.
uint32_t cycles_of(Cycles *c, uint8_t op, const uint32_t number[2], unsigned numbers);

#endif
