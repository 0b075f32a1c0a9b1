// SPDX-License-Identifier: Apache-2.0
// Copies pins to elements and back (config.md 9).  Values are kept in SmIo.value in between, so that slow pin accesses and arithmetic stay
// outside the single critical section.
#include "runtime-c/io.h"

#include "stdlib/convert.h"

enum { OUTPUT = 1, DIGITAL = 2 };             // bit masks of SmIoKind

static bool has_direction(const SmIo *io, uint16_t i, uint8_t direction) { return (io->pin[i].kind & OUTPUT) == direction; }
static bool is_digital(const SmIoPin *p) { return p->kind & DIGITAL; }
static SmType type_of(const SmIoPin *p) { return (SmType)p->type; }

// Counts the consecutive failures of pin i in `missed`: r is the result of the last access to it.  Returns r.
static SmResult record_result(SmIo *io, uint16_t i, SmResult r)
{
    if (r == SM_OK) {
        io->missed[i] = 0;
        return SM_OK;
    }
    if (io->missed[i] < UINT16_MAX)
        io->missed[i]++;
    io->failed = i;
    return r;
}

static SmResult first_error(SmResult before, SmResult now) { return before == SM_OK ? now : before; }

// Returns the bits of an element without a valid measurement: NaN if the type has one, else 0.
static uint64_t unknown_cell(SmType type)
{
    return type == SM_F64 ? 0x7FF8000000000000u : type == SM_F32 ? 0x7FC00000u : 0;
}

// ---- one pin ----

// Reads pin i and stores the bits of its element in io->value[i].
static SmResult read_pin(SmIo *io, uint16_t i)
{
    SmF64 x;
    const SmResult r = sm_pin_read(&io->pin[i], io->handle[i], &x);

    if (r == SM_OK)
        io->value[i] = sm_cell_from_f64(type_of(&io->pin[i]), x);
    return r;
}

static SmResult write_pin(SmIo *io, uint16_t i, SmF64 x) { return sm_pin_write(&io->pin[i], io->handle[i], x); }

// ---- opening ----

// Compares the upper half alone, because avr-gcc 5.4 takes a comparison of all 64 masked bits for true.
static bool is_finite(uint64_t bits) { return ((uint32_t)(bits >> 32) & 0x7FF00000u) != 0x7FF00000u; }

// Whether the row of the pin table is consistent: kind, type, offset, and finite numbers; p->scale << 1 is 0 for a scale of 0 or
// -0.
static bool is_row_valid(const SmIo *io, const SmIoPin *p)
{
    const uint32_t size = io->sv->layout->whole.size;

    if (p->kind > SM_DIGITAL_OUT || p->type >= SM_TYPE_COUNT || is_digital(p) != (p->type == SM_BOOL))
        return false;
    if (p->offset > size || size - p->offset < sm_type_bytes[p->type] || !is_finite(p->safe))
        return false;
    return is_digital(p) || (is_finite(p->scale) && is_finite(p->zero) && p->scale << 1 != 0);
}

static SmResult open_pin(SmIo *io, uint16_t i)
{
    if (!is_row_valid(io, &io->pin[i]))
        return SM_E_ARGUMENT;
    return sm_pin_open(&io->pin[i], &io->handle[i]);
}

// Closes those of the first n pins that have this direction, 0 for inputs or OUTPUT.
static void close_pins(SmIo *io, uint16_t n, uint8_t direction)
{
    for (uint16_t i = 0; i < n; i++)
        if (has_direction(io, i, direction)) {
            sm_pin_close(&io->pin[i], io->handle[i]);
            io->handle[i] = 0;
        }
}

// Opens all pins of a direction, 0 for inputs or OUTPUT. After a failure, none of them is open.
static SmResult open_pins(SmIo *io, uint8_t direction)
{
    SmResult r = SM_OK;

    if (!io || !io->sv || !io->sv->layout || (io->pins && (!io->pin || !io->handle || !io->missed || !io->value)))
        return SM_E_ARGUMENT;
    for (uint16_t i = 0; i < io->pins; i++) {
        if (!has_direction(io, i, direction))
            continue;
        r = record_result(io, i, open_pin(io, i));
        if (r != SM_OK) {
            close_pins(io, i, direction);
            return r;
        }
    }
    return SM_OK;
}

SmResult sm_inputs_init(void *io) { return open_pins((SmIo *)io, 0); }
SmResult sm_outputs_init(void *io) { return open_pins((SmIo *)io, OUTPUT); }

// ---- inputs ----

static uint8_t *element_address(const SmIo *io, uint16_t i) { return (uint8_t *)io->sv->at + io->pin[i].offset; }

// Stores the values of all inputs in their elements.  After more than `hold` consecutive failures of a pin its value is no longer valid
// (config.md 9.11).
static void store_inputs(SmIo *io)
{
    for (uint16_t i = 0; i < io->pins; i++) {
        const SmIoPin *p = &io->pin[i];
        if (!has_direction(io, i, 0))
            continue;
        if (io->missed[i] == 0)
            sm_cell_store(type_of(p), element_address(io, i), io->value[i]);
        else if (io->missed[i] > p->hold)
            sm_cell_store(type_of(p), element_address(io, i), unknown_cell(type_of(p)));
    }
}

// Reads all input pins into the elements.  Returns SM_OK, or the error of the first pin that failed.
SmResult sm_inputs_step(void *context, const SmTick *tick)
{
    SmIo *io = (SmIo *)context;
    SmResult result = SM_OK, r;

    (void)tick;
    for (uint16_t i = 0; i < io->pins; i++)
        if (has_direction(io, i, 0))
            result = first_error(result, record_result(io, i, read_pin(io, i)));
    r = sm_enter(io->sv);
    if (r != SM_OK)
        return r;
    store_inputs(io);
    sm_leave(io->sv);
    return result;
}

// ---- outputs ----

// Copies the elements of all outputs to io->value. Called inside the critical section.
static void load_outputs(SmIo *io)
{
    for (uint16_t i = 0; i < io->pins; i++)
        if (has_direction(io, i, OUTPUT))
            io->value[i] = sm_cell_load(type_of(&io->pin[i]), element_address(io, i));
}

// Sets every output in every step, even if its element has not changed, so that a pin disturbed from outside is wrong for at most one step.
SmResult sm_outputs_step(void *context, const SmTick *tick)
{
    SmIo *io = (SmIo *)context;
    SmResult result = sm_enter(io->sv);

    (void)tick;
    if (result != SM_OK)
        return result;
    load_outputs(io);
    sm_leave(io->sv);
    for (uint16_t i = 0; i < io->pins; i++)
        if (has_direction(io, i, OUTPUT))
            result = first_error(result, record_result(io, i, write_pin(io, i, sm_cell_to_f64(type_of(&io->pin[i]), io->value[i]))));
    return result;
}

// Sets every output to its safe value.
SmResult sm_outputs_safe(void *context, const SmTick *tick)
{
    SmIo *io = (SmIo *)context;
    SmResult result = SM_OK;

    (void)tick;
    for (uint16_t i = 0; i < io->pins; i++)
        if (has_direction(io, i, OUTPUT))
            result = first_error(result, record_result(io, i, write_pin(io, i, sm_from_bits(io->pin[i].safe))));
    return result;
}

// ---- closing ----

// Closes all input pins.
void sm_inputs_close(SmIo *io) { close_pins(io, io->pins, 0); }

// Sets all outputs to their safe values and closes their pins.
void sm_outputs_close(SmIo *io)
{
    (void)sm_outputs_safe(io, NULL);
    close_pins(io, io->pins, OUTPUT);
}
