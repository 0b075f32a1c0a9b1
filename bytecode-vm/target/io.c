// SPDX-License-Identifier: Apache-2.0
#include "bytecode-vm/target/io.h"

// Converts a pin that smvm_next_pin has read to a row of a table of the flight runtime.
SMVM_NOINLINE void smvm_target_pin(const SmvmPin *p, SmIoPin *row)
{
    row->kind = p->kind;
    row->type = p->type;
    row->flags = p->flags;
    row->hold = p->hold;
    row->pin = (uint16_t)p->pin;
    row->offset = p->offset;
    row->scale = sm_bits(p->scale);
    row->zero = sm_bits(p->zero);
    row->safe = sm_bits(p->safe);
}

// Fills `row` and *n with the pins of a verified image, in the order of the .io file; *n is 0 if the image has no pins.
SmResult smvm_target_pins(SmvmBytes image, const SmStateVec *sv, SmIoPin *row, uint16_t room, uint16_t *n)
{
    SmvmPins all;
    SmvmPin pin;

    *n = 0;
    if (!smvm_pins(image, &all))
        return SM_OK;
    if (all.layout != sv->layout->hash || 8 * all.sv_size != sv->layout->whole.size)
        return SM_E_LAYOUT;
    if (all.left > room)
        return SM_E_MEMORY;
    while (smvm_next_pin(&all, &pin))
        smvm_target_pin(&pin, &row[(*n)++]);
    return SM_OK;
}
