// SPDX-License-Identifier: Apache-2.0
// The cost of a machine on the VM: the longest step of each state, and its bytes.  It is computed from the image, so it equals the
// result of the target's own verifier.  Paths that no input can take are not excluded, so real steps may execute fewer
// instructions, but never more.  Cycles are an estimate, because not all operands were measured (avr_cycles.def).
#ifndef SMC_COST_H
#define SMC_COST_H

#include "compiler/base/vec.h"
#include "stdlib/types.h"

typedef enum CostPart { COST_ENTRY, COST_STEP, COST_EXIT, COST_SAMPLE } CostPart;      // the first three as in BlockKind

// The unit in which steps are compared.  Cycles are those of an ATmega328P with the image in flash or in EEPROM.  Different units may
// have different longest paths.
typedef enum CostUnit { COST_INSTRUCTIONS, COST_CYCLES_FLASH, COST_CYCLES_EEPROM, COST_UNITS } CostUnit;

// Consecutive instructions of the longest path that belong to the same source line.
typedef struct CostLine {
    CostPart part;
    uint32_t line;                // line of the machine's source; 0: instructions of several lines, or the image has no lines
    uint32_t units;               // cost of these instructions, in the CostUnit
} CostLine;

typedef struct StateCost {
    uint32_t first;               // the cost of the longest first step of the state: samples, .entry, .step, .exit
    uint32_t later;               // the cost of the longest of its other steps; 0: no other step
    uint32_t worst;               // the larger of `first` and `later`
    VEC(CostLine) path;           // the path through the worst step, in order
} StateCost;

typedef struct CostWindow {
    uint32_t size;                // how many samples the window stores
    SmType type;
    uint32_t bytes;               // bytes of the samples and of the data that speeds up statistics
} CostWindow;

typedef struct Cost {
    uint32_t sample;              // the cost of the code that samples the rolling windows, which every step includes
    uint32_t worst;               // the cost of the longest step of all states
    uint32_t worst_state;         // the number (from 1) of the first state with this step
    StateCost *state;             // costs of the states; state[0] is that of state 1
    uint32_t states;
    uint32_t ram;                 // bytes of memory that the machine needs on a computer with 64-bit pointers
    uint32_t own, windows, locals;        // parts of `ram`: the VM's own structures, the windows, the locals
    uint32_t windows_small;       // bytes of the windows if the target is compiled with SM_ROLL_SMALL
    CostWindow *window;
    uint32_t window_count;
    uint32_t code;                // bytes of instructions in the image
    uint32_t functions;           // the elementary functions that the machine calls: bit n for number n (stdlib/elementary.def)
} Cost;

// Computes the cost of machine `number`, counted from 0, of an image that the verifier has accepted.
void cost_of_machine(Arena *arena, const uint8_t *image, uint32_t number, CostUnit unit, Cost *out);

// Iterates over the entries of a state's path that have a source line, the most expensive first: returns the first one if `before`
// is NULL, else the one after it.  NULL: there are no more.
const CostLine *cost_next_most_expensive(const StateCost *s, const CostLine *before);

#endif
