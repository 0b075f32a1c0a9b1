// SPDX-License-Identifier: Apache-2.0
// About how many cycles an instruction of the VM takes on an ATmega328P: a model whose numbers were measured (avr_cycles.def).  It knows which
// registers surely hold whole numbers, for what is calculated in software takes ten times as long; of a value it knows no more.
#ifndef SMC_CYCLES_H
#define SMC_CYCLES_H

#include <stdbool.h>
#include <stdint.h>

#include "bytecode-vm/image.h"

typedef enum CyclesRow {
#define CYCLES_ROW(name, ...) CYCLES_##name,
#define CYCLES_WINDOW(name, ...)
#define CYCLES_STACK(bytes)
#include "compiler/analysis/avr_cycles.def"
#undef CYCLES_ROW
#undef CYCLES_WINDOW
#undef CYCLES_STACK
    CYCLES_ROWS
} CyclesRow;

typedef enum CyclesWindow {
#define CYCLES_ROW(name, ...)
#define CYCLES_WINDOW(name, ...) CYCLES_##name,
#define CYCLES_STACK(bytes)
#include "compiler/analysis/avr_cycles.def"
#undef CYCLES_ROW
#undef CYCLES_WINDOW
#undef CYCLES_STACK
    CYCLES_WINDOW_ROWS
} CyclesWindow;

enum { CYCLES_KEYS = 6 };                 // how windows keep their samples: in 1, 2, 4 or 8 bytes, as F32, as F64

typedef enum CyclesChip { CYCLES_FLASH, CYCLES_EEPROM } CyclesChip;       // an ATmega328P, and where its image is

// What is known of a register.
typedef struct CyclesReg {
    bool whole;               // surely a whole number
    bool signed_;             // perhaps below 0
    uint32_t most;            // its largest magnitude
} CyclesReg;

typedef struct Cycles {
    CyclesChip chip;
    const SmvmMachine *m;
    CyclesReg x, y;
} Cycles;

uint32_t cycles_stack(void);              // bytes of stack below a step, the most that was seen
uint32_t cycles_row(CyclesChip chip, CyclesRow row, bool whole);
uint32_t cycles_window(CyclesWindow row, uint8_t type, uint32_t slots);

// Before the first instruction; gives what a step takes beside its functions.
uint32_t cycles_begin(Cycles *c, CyclesChip chip, const SmvmMachine *m);
// Of the next instruction in the order of the image, with its numbers; one that ends a function holds its call.
uint32_t cycles_of(Cycles *c, uint8_t op, const uint32_t number[2], unsigned numbers);

#endif
