// SPDX-License-Identifier: Apache-2.0
// Implements the runner.  A step needs only the fields of an SmIoPin before `safe`, or before `scale` for a digital pin.  So each pin is
// stored as the beginning of an SmIoPin, a row; the rows are consecutive after the machines.  A row's field `hold` contains the pin's
// handle: a pin of a chip always delivers a value, so no value has to be held.
#include "bytecode-vm/firmware/runner.h"

#include <string.h>

#include "bytecode-vm/image.h"
#include "bytecode-vm/target/io.h"

enum { KIND_OUTPUT = 1, KIND_DIGITAL = 2 };           // bits of SmvmPin.kind and SmIoPin.kind

// ---- memory needed ----

static uint16_t round_up_8(uint32_t n) { return (uint16_t)(((uint16_t)n + 7u) & ~7u); }

// Subtracts bytes, rounded up to 8, from the memory that is left.  Returns false if there are too few.  The verifier has checked that
// `bytes` is at most SMVM_RAM_MAX, so rounding up does not overflow.
static bool claim_bytes(uint16_t *left, SmvmAt bytes)
{
    if (bytes > *left || round_up_8(bytes) > *left)
        return false;
    *left = (uint16_t)(*left - round_up_8(bytes));
    return true;
}

// These return the bytes of memory for a pin of this kind. The first one is inlined, for code in which steps must be fast.
SMVM_INLINE uint8_t row_bytes_inline(uint8_t kind) { return kind & KIND_DIGITAL ? SMVM_RUNNER_DIGITAL : SMVM_RUNNER_ANALOG; }
SMVM_NOINLINE static uint8_t row_bytes(uint8_t kind) { return row_bytes_inline(kind); }

// Subtracts the rows of all pins from the memory that is left.  SM_E_MISSING: the chip has no such pin.  SM_E_MEMORY: too little is left.
static SmResult claim_pins(const SmvmRunner *r, uint16_t *left, SmvmPins *p)
{
    SmvmPin pin;

    while (smvm_next_pin(p, &pin)) {
        if (r->physical_pin && r->physical_pin((uint16_t)pin.pin, smvm_pin_kind(&pin)) == SMVM_NO_PIN)
            return SM_E_MISSING;
        if (row_bytes(pin.kind) > *left)
            return SM_E_MEMORY;
        *left = (uint16_t)(*left - row_bytes(pin.kind));
    }
    return SM_OK;
}

// Whether an image that smvm_verify has accepted fits the board; if not, the result is the reason.
SmResult smvm_runner_fits(const SmvmRunner *r, SmvmBytes image)
{
    SmvmMachine m;
    SmvmPins p;
    uint32_t layout = 0, sv = 0;
    uint16_t left = r->size;
    uint8_t n = 0;

    for (; smvm_machine(image, n, &m); n++) {
        if (n == SMVM_RUNNER_MACHINES)
            return SM_E_MEMORY;
        if (n > 0 && (m.layout != layout || m.sv_size != sv))
            return SM_E_LAYOUT;
        if (!claim_bytes(&left, n == 0 ? m.sv_size : 0) || !claim_bytes(&left, smvm_ram_size(&m)))
            return SM_E_MEMORY;
        layout = m.layout;
        sv = m.sv_size;
    }
    if (!smvm_pins(image, &p))
        return SM_OK;
    return p.layout != layout || 8 * p.sv_size != sv ? SM_E_LAYOUT : claim_pins(r, &left, &p);
}

// ---- machines ----

// Starts a machine at offset `at` of r->memory, in its initial state.
static SmResult start_machine(SmvmRunner *r, uint8_t number, const SmvmMachine *m, uint16_t at)
{
    const SmvmVector v = {r->memory, m->sv_size, m->layout};

    r->vm[number] = (SmVm *)(void *)((uint8_t *)r->memory + at);
    r->g[number] = (uint16_t)m->g;
    return smvm_init(r->vm[number], r->size - at, m, &v, 1);
}

static SmResult start_machines(SmvmRunner *r)
{
    SmvmMachine m;
    SmResult result = SM_OK;
    uint16_t at = 0;
    uint8_t n = 0;

    for (; result == SM_OK && smvm_machine(r->image, n, &m); n++) {
        if (n == 0)
            at = (uint16_t)m.sv_size;
        result = start_machine(r, n, &m, at);
        at = (uint16_t)(at + round_up_8(smvm_ram_size(&m)));
    }
    r->machines = result == SM_OK ? n : 0;
    r->rows = r->rows_end = at;
    return result;
}

// ---- pins ----

static SmIoPin *row_at(const SmvmRunner *r, uint16_t at) { return (SmIoPin *)(void *)((uint8_t *)r->memory + at); }

static bool is_output(const SmIoPin *row) { return row->kind & KIND_OUTPUT; }
static bool is_digital(const SmIoPin *row) { return row->kind & KIND_DIGITAL; }

// Opens all pins, up to the first that fails.  r->rows_end is the end of the rows of the open ones.
static SmResult open_pins(SmvmRunner *r)
{
    SmvmPins p;
    SmvmPin pin;
    SmIoPin row;
    SmResult result = SM_OK;

    (void)smvm_pins(r->image, &p);
    while (smvm_next_pin(&p, &pin)) {
        smvm_target_pin(&pin, &row);
        if ((result = sm_pin_open(&row, &row.hold)) != SM_OK)
            break;
        memcpy(row_at(r, r->rows_end), &row, row_bytes(row.kind));
        r->rows_end = (uint16_t)(r->rows_end + row_bytes(row.kind));
    }
    return result;
}

// Closes the open pins, outputs at their safe values.
static void close_pins(SmvmRunner *r)
{
    SmvmPins p;
    SmvmPin pin;
    SmIoPin row;

    if (r->rows == r->rows_end)
        return;
    (void)smvm_pins(r->image, &p);
    for (uint16_t at = r->rows; at < r->rows_end && smvm_next_pin(&p, &pin); at = (uint16_t)(at + row_bytes(row.kind))) {
        const uint8_t handle = row_at(r, at)->hold;
        smvm_target_pin(&pin, &row);
        if (is_output(&row))
            (void)sm_pin_write(&row, handle, pin.safe);
        sm_pin_close(&row, handle);
    }
    r->rows_end = r->rows;
}

// Reads an input pin into its element.  The element of a digital pin is a bool.  The value of an analog pin is never NaN, so an F64 element
// can store it without conversion.
static void read_pin(const SmIoPin *row, uint8_t *element)
{
    int32_t v;
    SmF64 x;

    if (sm_pin_read_raw(row, row->hold, &v) != SM_OK)
        return;
    if (is_digital(row)) {
        *element = (uint8_t)v;
        return;
    }
    x = sm_pin_from_raw(row, v);
    if (row->type == SM_F64)
        memcpy(element, &x, sizeof x);
    else
        smvm_store(x, row->type, element);
}

// Writes an output pin from its state-vector element.
static void write_pin(const SmIoPin *row, const uint8_t *element)
{
    (void)sm_pin_write_raw(row, row->hold, is_digital(row) ? *element : sm_pin_to_raw(row, smvm_load(row->type, element)));
}

// Reads all input pins, or writes all output pins if `outputs`.
static void transfer_pins(SmvmRunner *r, bool outputs)
{
    const SmIoPin *row;

    for (uint16_t at = r->rows; at < r->rows_end; at = (uint16_t)(at + row_bytes_inline(row->kind))) {
        row = row_at(r, at);
        if (is_output(row) != outputs)
            continue;
        if (outputs)
            write_pin(row, (uint8_t *)r->memory + (uint16_t)row->offset);
        else
            read_pin(row, (uint8_t *)r->memory + (uint16_t)row->offset);
    }
}

// ---- the application ----

// Sets all machines to their initial states and opens all pins, outputs at their safe values.  Returns the first error.
SmResult smvm_runner_open(SmvmRunner *r, SmvmBytes image)
{
    SmResult result = smvm_runner_fits(r, image);

    if (result != SM_OK)
        return result;
    r->image = image;
    memset(r->memory, 0, r->size);
    if ((result = start_machines(r)) == SM_OK)
        result = open_pins(r);
    if (result != SM_OK)
        smvm_runner_stop(r);
    return result;
}

// Reads the input pins, steps each machine and writes the output pins.  g points to the time of the step, a U64.
void smvm_runner_step(SmvmRunner *r, const void *g)
{
    transfer_pins(r, false);
    for (uint8_t i = 0; i < r->machines; i++)
        memcpy((uint8_t *)r->memory + r->g[i], g, 8);
    for (uint8_t i = 0; i < r->machines; i++)
        (void)smvm_step(r->vm[i], r->memory);
    transfer_pins(r, true);
}

// Sets outputs to their safe values, closes the pins and stops all machines.
void smvm_runner_stop(SmvmRunner *r)
{
    close_pins(r);
    r->machines = 0;
}
