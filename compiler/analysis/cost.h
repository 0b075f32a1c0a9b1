// SPDX-License-Identifier: Apache-2.0
// What a machine costs on the VM: its longest step, state by state, and bytes.  Read from the image that flies, so it is what the
// target's own verifier finds; that a way through the code can be gone by some input is not asked, so a step may be shorter than what is
// said here.  Never longer, in instructions; in cycles it is an estimate, for nobody has seen all operands (avr_cycles.def).
#ifndef SMC_COST_H
#define SMC_COST_H

#include "compiler/base/vec.h"
#include "compiler/sema/program.h"

typedef enum CostPart { COST_ENTRY, COST_STEP, COST_EXIT, COST_SAMPLE } CostPart;      // the first three as BlockKind

// In what the longest step is counted: cycles are those of an ATmega328P, by where its image is.  The longest way is not the same in all.
typedef enum CostUnit { COST_INSTRUCTIONS, COST_CYCLES_FLASH, COST_CYCLES_EEPROM, COST_UNITS } CostUnit;

// A stretch of the longest way.
typedef struct CostLine {
    CostPart part;
    uint32_t line;                // of the machine's source; 0: what several lines lead to, or the image has no lines
    uint32_t units;
} CostLine;

typedef struct StateCost {
    uint32_t first;               // the longest first step of the state: samples, .entry, .step, .exit
    uint32_t later;               // the longest of its other steps; 0: it has none
    uint32_t worst;               // the larger of the two
    VEC(CostLine) way;            // through the worst step, in order
} StateCost;

typedef struct CostWindow {
    uint32_t size;                // slots
    SmType type;
    uint32_t bytes;               // samples and what answers quickly
} CostWindow;

typedef struct Cost {
    uint32_t sample;              // what gives the windows their samples: part of every step
    uint32_t worst;               // the longest step
    uint32_t worst_state;         // number of the first state that has it
    StateCost *state;             // at[0] is state 1
    uint32_t states;
    uint32_t ram;                 // bytes in all, with pointers of 64 bits: the VM's own, windows, locals
    uint32_t own, windows, locals;
    uint32_t windows_small;       // what these windows take on a chip, where they have SM_ROLL_SMALL
    CostWindow *window;
    uint32_t window_count;
    uint32_t code;                // bytes of its instructions in the image
} Cost;

// Of machine `number`, counted from 0, of an image that the verifier has accepted.
void cost_of_machine(Arena *arena, const uint8_t *image, uint32_t number, CostUnit unit, Cost *out);

// The stretch of the longest way that takes most, of those with a line; after `before`, the next.  NULL: there is none.
const CostLine *cost_next_dearest(const StateCost *s, const CostLine *before);

#endif
