// SPDX-License-Identifier: Apache-2.0
// Opens, reads, writes and closes single pins, and converts between their levels or voltages and the values of elements.
#include "runtime-c/pin.h"

#include "runtime-c/pal/aio.h"
#include "runtime-c/pal/dio.h"
#include "stdlib/convert.h"

static bool is_digital(const SmIoPin *p) { return p->kind & 2; }        // SmIoKind
static bool is_inverted(const SmIoPin *p) { return p->flags & SM_IO_INVERTED; }

// ---- conversion ----

// Returns 1,000,000: the millionths of a volt in a volt.
static SmF64 million(void) { return sm_from_bits(0x412E848000000000u); }

// Converts a pin's value in millionths to the value of the element (config.md 9.8).
SmF64 sm_pin_from_raw(const SmIoPin *p, int32_t v)
{
    if (is_digital(p))
        return sm_from_i32(v);
    return sm_add(sm_mul(sm_div(sm_from_i32(v), million()), sm_from_bits(p->scale)), sm_from_bits(p->zero));
}

// Equals sm_to_i32(sm_round(x)), but does not link sm_round, which also handles numbers beyond int32_t.
static int32_t round_to_i32(SmF64 x)
{
    const int32_t n = sm_to_i32(x);
    const SmF64 rest = sm_sub(x, sm_from_i32(n)), half = sm_from_bits(0x3FE0000000000000u);

    if (n < INT32_MAX && sm_le(half, rest))
        return n + 1;
    return n > INT32_MIN && sm_le(rest, sm_neg(half)) ? n - 1 : n;
}

// Converts the value of an element to that of its pin: the nearest millionth, saturated.
int32_t sm_pin_to_raw(const SmIoPin *p, SmF64 x)
{
    if (is_digital(p))
        return sm_to_bool(x);
    return round_to_i32(sm_mul(sm_div(sm_sub(x, sm_from_bits(p->zero)), sm_from_bits(p->scale)), million()));
}

// ---- one pin ----

// Sets a pin: to millionths for an analog pin, to 0 or 1 for a digital one.
SmResult sm_pin_write_raw(const SmIoPin *p, uint8_t handle, int32_t v)
{
    const PalDio dio = {handle};
    const PalAio aio = {handle};

    return is_digital(p) ? pal_dio_write(dio, (v != 0) != is_inverted(p)) : pal_aio_write(aio, v);
}

// Reads a pin: in millionths for an analog pin, 0 or 1 for a digital one.
SmResult sm_pin_read_raw(const SmIoPin *p, uint8_t handle, int32_t *v)
{
    const PalDio dio = {handle};
    const PalAio aio = {handle};
    bool level = false;
    SmResult r;

    if (!is_digital(p))
        return pal_aio_read(aio, v);
    r = pal_dio_read(dio, &level);
    *v = level != is_inverted(p);
    return r;
}

SmResult sm_pin_write(const SmIoPin *p, uint8_t handle, SmF64 x) { return sm_pin_write_raw(p, handle, sm_pin_to_raw(p, x)); }

// Reads a pin as the value of its element.
SmResult sm_pin_read(const SmIoPin *p, uint8_t handle, SmF64 *x)
{
    int32_t v = 0;
    const SmResult r = sm_pin_read_raw(p, handle, &v);

    if (r == SM_OK)
        *x = sm_pin_from_raw(p, v);
    return r;
}

// Closes the pin.  The level of an output does not change.
void sm_pin_close(const SmIoPin *p, uint8_t handle)
{
    const PalDio dio = {handle};
    const PalAio aio = {handle};

    if (is_digital(p))
        (void)pal_dio_close(dio);
    else
        (void)pal_aio_close(aio);
}

// ---- opening ----

static PalDioMode dio_mode(const SmIoPin *p)
{
    if (p->kind == SM_DIGITAL_OUT)
        return PAL_DIO_OUTPUT;
    return p->flags & SM_IO_PULL_UP ? PAL_DIO_PULL_UP : p->flags & SM_IO_PULL_DOWN ? PAL_DIO_PULL_DOWN : PAL_DIO_INPUT;
}

static SmResult open_digital(const SmIoPin *p, uint8_t *handle)
{
    PalDio dio = {0};
    SmResult r = pal_dio_open(&dio, p->pin, dio_mode(p), sm_to_bool(sm_from_bits(p->safe)) != is_inverted(p));

    *handle = dio.id;
    return r;
}

// Opens an analog pin.  An output is undefined before its first write, so this also writes its safe value.
static SmResult open_analog(const SmIoPin *p, uint8_t *handle)
{
    PalAio aio = {0};
    SmResult r = pal_aio_open(&aio, p->pin, p->kind == SM_ANALOG_OUT ? PAL_AIO_OUTPUT : PAL_AIO_INPUT);

    *handle = aio.id;
    if (r != SM_OK || p->kind != SM_ANALOG_OUT)
        return r;
    r = sm_pin_write(p, *handle, sm_from_bits(p->safe));
    if (r == SM_OK)
        return r;
    sm_pin_close(p, *handle);
    *handle = 0;
    return r;
}

// Opens the pin; an output starts at its safe value.
SmResult sm_pin_open(const SmIoPin *p, uint8_t *handle)
{
    return is_digital(p) ? open_digital(p, handle) : open_analog(p, handle);
}
