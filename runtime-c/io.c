// SPDX-License-Identifier: Apache-2.0
// Pins to elements and back (config.md 9).  Elements go through `value` on their way, so that pins and arithmetic, both slow, stay
// outside of the one critical section.
#include "runtime-c/io.h"

#include "stdlib/convert.h"
#include "stdlib/math.h"

enum { OUTPUT = 1, DIGITAL = 2 };             // bits of SmIoKind

static bool is_mine(const SmIo *io, uint16_t i, uint8_t direction) { return (io->pin[i].kind & OUTPUT) == direction; }
static bool is_digital(const SmIoPin *p) { return p->kind & DIGITAL; }
static SmType type_of(const SmIoPin *p) { return (SmType)p->type; }

// Notes how a call for pin i went.
static SmResult note(SmIo *io, uint16_t i, SmResult r)
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

static SmResult first_of(SmResult before, SmResult now) { return before == SM_OK ? now : before; }

// ---- numbers ----

static SmF64 million(void) { return sm_from_i32(1000000); }

// 9.8: millionths to the element's number.
static SmF64 to_element(const SmIoPin *p, int32_t millionths)
{
    const SmF64 volts = sm_div(sm_from_i32(millionths), million());

    return sm_add(sm_mul(volts, sm_from_bits(p->scale)), sm_from_bits(p->zero));
}

// 9.8: the way back; the nearest millionth, halves away from 0, as far as there are any.
static int32_t to_millionths(const SmIoPin *p, SmF64 x)
{
    const SmF64 volts = sm_div(sm_sub(x, sm_from_bits(p->zero)), sm_from_bits(p->scale));

    return sm_to_i32(sm_round(sm_mul(volts, million())));
}

// What an element holds that nobody knows: NaN, where the type has one.
static uint64_t unknown_cell(SmType type)
{
    return type == SM_F64 ? 0x7FF8000000000000u : type == SM_F32 ? 0x7FC00000u : 0;
}

// ---- one pin ----

static bool is_inverted(const SmIoPin *p) { return p->flags & SM_IO_INVERTED; }

// The level that stands for x, which is 0 for false.
static bool level_of(const SmIoPin *p, SmF64 x) { return sm_to_bool(x) != is_inverted(p); }

static SmResult write_pin(SmIo *io, uint16_t i, SmF64 x)
{
    const SmIoPin *p = &io->pin[i];
    const PalDio dio = {io->handle[i]};
    const PalAio aio = {io->handle[i]};

    return is_digital(p) ? pal_dio_write(dio, level_of(p, x)) : pal_aio_write(aio, to_millionths(p, x));
}

// The pin's element goes to `value`.
static SmResult read_pin(SmIo *io, uint16_t i)
{
    const SmIoPin *p = &io->pin[i];
    const PalDio dio = {io->handle[i]};
    const PalAio aio = {io->handle[i]};
    int32_t millionths = 0;
    bool level = false;
    SmResult r = is_digital(p) ? pal_dio_read(dio, &level) : pal_aio_read(aio, &millionths);

    if (r == SM_OK)
        io->value[i] = is_digital(p) ? level != is_inverted(p) : sm_cell_from_f64(type_of(p), to_element(p, millionths));
    return r;
}

static void close_pin(SmIo *io, uint16_t i)
{
    const PalDio dio = {io->handle[i]};
    const PalAio aio = {io->handle[i]};

    if (is_digital(&io->pin[i]))
        (void)pal_dio_close(dio);
    else
        (void)pal_aio_close(aio);
    io->handle[i] = 0;
}

// ---- opening ----

static bool is_number(uint64_t bits) { return (bits & 0x7FF0000000000000u) != 0x7FF0000000000000u; }

static bool is_sensible(const SmIo *io, const SmIoPin *p)
{
    const uint32_t size = io->sv->layout->whole.size;

    if (p->kind > SM_DIGITAL_OUT || p->type >= SM_TYPE_COUNT || is_digital(p) != (p->type == SM_BOOL))
        return false;
    if (p->offset > size || size - p->offset < sm_type_bytes[p->type] || !is_number(p->safe))
        return false;
    return is_digital(p) || (is_number(p->scale) && is_number(p->zero) && p->scale << 1 != 0);
}

static PalDioMode mode_of(const SmIoPin *p)
{
    if (p->kind == SM_DIGITAL_OUT)
        return PAL_DIO_OUTPUT;
    return p->flags & SM_IO_PULL_UP ? PAL_DIO_PULL_UP : p->flags & SM_IO_PULL_DOWN ? PAL_DIO_PULL_DOWN : PAL_DIO_INPUT;
}

static SmResult open_digital(SmIo *io, uint16_t i)
{
    const SmIoPin *p = &io->pin[i];
    PalDio dio = {0};
    SmResult r = pal_dio_open(&dio, p->pin, mode_of(p), level_of(p, sm_from_bits(p->safe)));

    io->handle[i] = dio.id;
    return r;
}

// An output has no value before its first write: it is open when it is safe.
static SmResult open_analog(SmIo *io, uint16_t i)
{
    const SmIoPin *p = &io->pin[i];
    PalAio aio = {0};
    SmResult r = pal_aio_open(&aio, p->pin, p->kind == SM_ANALOG_OUT ? PAL_AIO_OUTPUT : PAL_AIO_INPUT);

    io->handle[i] = aio.id;
    if (r != SM_OK || p->kind != SM_ANALOG_OUT)
        return r;
    r = write_pin(io, i, sm_from_bits(p->safe));
    if (r != SM_OK)
        close_pin(io, i);
    return r;
}

static SmResult open_pin(SmIo *io, uint16_t i)
{
    if (!is_sensible(io, &io->pin[i]))
        return SM_E_ARGUMENT;
    return is_digital(&io->pin[i]) ? open_digital(io, i) : open_analog(io, i);
}

static void close_first(SmIo *io, uint16_t n, uint8_t direction)
{
    for (uint16_t i = 0; i < n; i++)
        if (is_mine(io, i, direction))
            close_pin(io, i);
}

static SmResult open_all(SmIo *io, uint8_t direction)
{
    SmResult r = SM_OK;

    if (!io || !io->sv || !io->sv->layout || (io->pins && (!io->pin || !io->handle || !io->missed || !io->value)))
        return SM_E_ARGUMENT;
    for (uint16_t i = 0; i < io->pins; i++) {
        if (!is_mine(io, i, direction))
            continue;
        r = note(io, i, open_pin(io, i));
        if (r != SM_OK) {
            close_first(io, i, direction);
            return r;
        }
    }
    return SM_OK;
}

SmResult sm_inputs_init(void *io) { return open_all((SmIo *)io, 0); }
SmResult sm_outputs_init(void *io) { return open_all((SmIo *)io, OUTPUT); }

// ---- inputs ----

static uint8_t *element_of(const SmIo *io, uint16_t i) { return (uint8_t *)io->sv->at + io->pin[i].offset; }

// 9.11: what has failed for longer than it may be held is not known any more.
static void store_inputs(SmIo *io)
{
    for (uint16_t i = 0; i < io->pins; i++) {
        const SmIoPin *p = &io->pin[i];
        if (!is_mine(io, i, 0))
            continue;
        if (io->missed[i] == 0)
            sm_cell_store(type_of(p), element_of(io, i), io->value[i]);
        else if (io->missed[i] > p->hold)
            sm_cell_store(type_of(p), element_of(io, i), unknown_cell(type_of(p)));
    }
}

SmResult sm_inputs_step(void *context, const SmTick *tick)
{
    SmIo *io = (SmIo *)context;
    SmResult result = SM_OK, r;

    (void)tick;
    for (uint16_t i = 0; i < io->pins; i++)
        if (is_mine(io, i, 0))
            result = first_of(result, note(io, i, read_pin(io, i)));
    r = sm_enter(io->sv);
    if (r != SM_OK)
        return r;
    store_inputs(io);
    sm_leave(io->sv);
    return result;
}

// ---- outputs ----

static void load_outputs(SmIo *io)
{
    for (uint16_t i = 0; i < io->pins; i++)
        if (is_mine(io, i, OUTPUT))
            io->value[i] = sm_cell_load(type_of(&io->pin[i]), element_of(io, i));
}

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
        if (is_mine(io, i, OUTPUT))
            result = first_of(result, note(io, i, write_pin(io, i, sm_cell_to_f64(type_of(&io->pin[i]), io->value[i]))));
    return result;
}

SmResult sm_outputs_safe(void *context, const SmTick *tick)
{
    SmIo *io = (SmIo *)context;
    SmResult result = SM_OK;

    (void)tick;
    for (uint16_t i = 0; i < io->pins; i++)
        if (is_mine(io, i, OUTPUT))
            result = first_of(result, note(io, i, write_pin(io, i, sm_from_bits(io->pin[i].safe))));
    return result;
}

// ---- closing ----

void sm_inputs_close(SmIo *io) { close_first(io, io->pins, 0); }

void sm_outputs_close(SmIo *io)
{
    (void)sm_outputs_safe(io, NULL);
    close_first(io, io->pins, OUTPUT);
}
