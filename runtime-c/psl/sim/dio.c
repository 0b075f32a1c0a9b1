// SPDX-License-Identifier: Apache-2.0
// Simulated digital pins, 0 to SIM_PINS - 1.  A pin has an external level and, as an output, its own level.
#include <string.h>

#include "runtime-c/pal/dio.h"
#include "runtime-c/psl/sim/world.h"

typedef struct SimPin {
    bool open, output, level;      // level: what the pin drives as an output
    bool driven, external_level;   // whether it is driven externally, and to which level
    bool pulled_up;
    uint16_t source;               // 1 + number of the pin to which it is wired; 0: none
    uint32_t edges;
} SimPin;

static SimPin pins[SIM_PINS];
static bool used[PAL_DIOS];
static uint8_t pin_of_entry[PAL_DIOS];

void sim_dio_reset(void)
{
    memset(pins, 0, sizeof pins);
    memset(used, 0, sizeof used);
}

// Returns the level at a pin that is not an output.  A wire connects to an output, not to another wire.
static bool input_level(const SimPin *p)
{
    if (p->source != 0 && pins[p->source - 1].output)
        return pins[p->source - 1].level;
    return p->driven ? p->external_level : p->pulled_up;
}

// Returns the level at a pin, as an oscilloscope shows it.
bool sim_pin(uint16_t pin)
{
    return pins[pin].output ? pins[pin].level : input_level(&pins[pin]);
}

// Returns how often the level has changed, in either direction, since sim_reset.
uint32_t sim_count_pin_changes(uint16_t pin)
{
    return pins[pin].edges;
}

// Drives a pin externally to `level`.
void sim_drive(uint16_t pin, bool level)
{
    bool before = sim_pin(pin);

    pins[pin].driven = true;
    pins[pin].external_level = level;
    pins[pin].edges += sim_pin(pin) != before;
}

// Connects output pin `from` to pin `to`.
void sim_wire(uint16_t from, uint16_t to)
{
    pins[to].source = (uint16_t)(from + 1);
}

// Sets direction and own level of a pin, and counts the edges at it and at the pins wired to it.
static void set_pin(SimPin *p, bool output, bool level)
{
    uint16_t number = (uint16_t)(p - pins);
    bool before = sim_pin(number);

    p->output = output;
    p->level = level;
    if (sim_pin(number) == before)
        return;
    p->edges++;
    for (uint16_t i = 0; i < SIM_PINS; i++)
        pins[i].edges += pins[i].source == number + 1 && !pins[i].output;
}

SmResult pal_dio_open(PalDio *pin, uint16_t number, PalDioMode mode, bool level)
{
    SmResult r;
    uint8_t id;

    if (!pin || (unsigned)mode > PAL_DIO_OUTPUT)
        return SM_E_ARGUMENT;
    if (number >= SIM_PINS)
        return SM_E_MISSING;
    r = pins[number].open ? SM_E_BUSY : sim_begin_call(SIM_dio_open);
    if (r != SM_OK)
        return r;
    id = psl_table_allocate(used, PAL_DIOS);
    if (id == 0)
        return SM_E_FULL;
    pin_of_entry[id - 1] = (uint8_t)number;
    pins[number].open = true;
    pins[number].pulled_up = mode == PAL_DIO_PULL_UP;
    set_pin(&pins[number], mode == PAL_DIO_OUTPUT, level);
    pin->id = id;
    return SM_OK;
}

SmResult pal_dio_read(PalDio pin, bool *level)
{
    SmResult r;

    if (!level)
        return SM_E_ARGUMENT;
    if (!psl_table_is_used(used, PAL_DIOS, pin.id))
        return SM_E_HANDLE;
    r = sim_begin_call(SIM_dio_read);
    if (r == SM_OK)
        *level = sim_pin(pin_of_entry[pin.id - 1]);
    return r;
}

SmResult pal_dio_write(PalDio pin, bool level)
{
    SimPin *p;
    SmResult r;

    if (!psl_table_is_used(used, PAL_DIOS, pin.id))
        return SM_E_HANDLE;
    p = &pins[pin_of_entry[pin.id - 1]];
    if (!p->output)
        return SM_E_ARGUMENT;
    r = sim_begin_call(SIM_dio_write);
    if (r == SM_OK)
        set_pin(p, true, level);
    return r;
}

// An output keeps its level after the close, as on most hardware.
SmResult pal_dio_close(PalDio pin)
{
    if (!psl_table_is_used(used, PAL_DIOS, pin.id))
        return SM_E_HANDLE;
    used[pin.id - 1] = false;
    pins[pin_of_entry[pin.id - 1]].open = false;
    return SM_OK;
}
