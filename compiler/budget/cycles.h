// SPDX-License-Identifier: Apache-2.0
// Estimates how many cycles an instruction of the VM takes on an ATmega328P, from measurements (avr_cycles.def).  The model tracks
// whether X and Y always contain whole numbers, because floating-point arithmetic in software takes ten times as long.  It tracks
// nothing else about values.
#ifndef SMC_CYCLES_H
#define SMC_CYCLES_H

#include <stdbool.h>
#include <stdint.h>

#include "bytecode-vm/image.h"

typedef enum CyclesRow {
#define CYCLES_ROW(name, ...) CYCLES_##name,
#define CYCLES_WINDOW(name, ...)
#define CYCLES_STACK(bytes, with_calls)
#include "compiler/budget/avr_cycles.def"
#undef CYCLES_ROW
#undef CYCLES_WINDOW
#undef CYCLES_STACK
    CYCLES_ROWS
} CyclesRow;

typedef enum CyclesWindow {
#define CYCLES_ROW(name, ...)
#define CYCLES_WINDOW(name, ...) CYCLES_##name,
#define CYCLES_STACK(bytes, with_calls)
#include "compiler/budget/avr_cycles.def"
#undef CYCLES_ROW
#undef CYCLES_WINDOW
#undef CYCLES_STACK
    CYCLES_WINDOW_ROWS
} CyclesWindow;

enum { CYCLES_SAMPLE_KINDS = 6 };         // how windows store their samples: as integers of 1, 2, 4 or 8 bytes, as F32, as F64

typedef enum CyclesChip { CYCLES_FLASH, CYCLES_EEPROM } CyclesChip;       // an ATmega328P with its image in flash or in EEPROM

// What is known about a register.
typedef struct CyclesReg {
    bool whole;               // the value is always a whole number
    bool signed_;             // this number may be negative
    uint32_t most;            // the largest possible magnitude of that number
} CyclesReg;

typedef struct Cycles {
    CyclesChip chip;
    const SmvmMachine *m;
    CyclesReg x, y;           // X and Y after the last instruction
} Cycles;

// Returns the bytes of stack that a step uses: the largest measured value.  `calls`: the step calls elementary functions.
uint32_t cycles_stack_bytes(bool calls);
// Returns the cycles in a row of CYCLES_ROW; `whole`: the registers contain whole numbers.
uint32_t cycles_in_row(CyclesChip chip, CyclesRow row, bool whole);
// Returns the cycles in a row of CYCLES_WINDOW, for a window of this sample type and size.
uint32_t cycles_of_window_row(CyclesWindow row, uint8_t type, uint32_t slots);

// Returns the cost of a step without the code of the machine that it runs (.entry, .step, .exit).  Call before the first instruction.
uint32_t cycles_begin(Cycles *c, CyclesChip chip, const SmvmMachine *m);
// Returns the cost of the next instruction in the order of the image, and updates the registers.  number: its operands.  The cost of
// `end` and `goto` includes the call of the function that they end.
uint32_t cycles_of_ins(Cycles *c, uint8_t op, const uint32_t number[2], unsigned numbers);

#endif
