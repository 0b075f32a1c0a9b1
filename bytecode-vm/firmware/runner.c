// SPDX-License-Identifier: Apache-2.0
// See runner.h.  Rows of pins are not kept, they are read out of the image in every step: a row takes 36 bytes of RAM, and reading one
// takes a tenth of the time that its analog value takes.
#include "bytecode-vm/firmware/runner.h"

#include <string.h>

#include "bytecode-vm/target/io.h"
#include "stdlib/convert.h"

// ---- what it takes ----

static uint16_t time_at(const SmvmMachine *m) { return (uint16_t)m->g; }

static uint16_t up8(uint32_t n) { return (uint16_t)(((uint16_t)n + 7u) & ~7u); }

// Of memory that is left; what the verifier accepts needs no more than SMVM_RAM_MAX.
static bool take(uint16_t *left, uint32_t bytes)
{
    if (bytes > *left || up8(bytes) > *left)
        return false;
    *left = (uint16_t)(*left - up8(bytes));
    return true;
}

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
        if (!take(&left, n == 0 ? m.sv_size : 0) || !take(&left, smvm_ram_size(&m)))
            return SM_E_MEMORY;
        layout = m.layout;
        sv = m.sv_size;
    }
    if (smvm_pins(image, &p)) {
        if (p.layout != layout || 8 * p.sv_size != sv)
            return SM_E_LAYOUT;
        if (p.left > r->pins_most)
            return SM_E_MEMORY;
    }
    return SM_OK;
}

// ---- machines ----

static SmResult start(SmvmRunner *r, uint8_t number, const SmvmMachine *m, uint16_t at)
{
    const SmvmVector v = {r->memory, m->sv_size, m->layout};

    r->vm[number] = (SmVm *)(void *)((uint8_t *)r->memory + at);
    r->g[number] = time_at(m);
    return smvm_init(r->vm[number], r->size - at, m, &v, 1);
}

static SmResult start_all(SmvmRunner *r)
{
    SmvmMachine m;
    SmResult result = SM_OK;
    uint16_t at = 0;
    uint8_t n = 0;

    for (; result == SM_OK && smvm_machine(r->image, n, &m); n++) {
        if (n == 0)
            at = (uint16_t)m.sv_size;
        result = start(r, n, &m, at);
        at = (uint16_t)(at + up8(smvm_ram_size(&m)));
    }
    r->machines = result == SM_OK ? n : 0;
    return result;
}

// ---- pins ----

typedef enum Way { INPUTS, OUTPUTS, SAFE, OPEN, CLOSE } Way;

static uint8_t *element_of(const SmvmRunner *r, const SmIoPin *row) { return (uint8_t *)r->memory + (uint16_t)row->offset; }

static bool is_output(const SmIoPin *row) { return row->kind & 1; }

SMVM_APART static SmResult one_pin(SmvmRunner *r, const SmIoPin *row, uint8_t i, Way way)
{
    SmF64 x;

    switch (way) {
    case INPUTS:
        if (!is_output(row) && sm_pin_read(row, r->handle[i], &x) == SM_OK)
            sm_store((SmType)row->type, element_of(r, row), x);
        return SM_OK;
    case OUTPUTS:
    case SAFE:
        x = way == SAFE ? sm_from_bits(row->safe) : sm_load((SmType)row->type, element_of(r, row));
        return is_output(row) ? sm_pin_write(row, r->handle[i], x) : SM_OK;
    case OPEN:
        return sm_pin_open(row, &r->handle[i]);
    case CLOSE:
        sm_pin_close(row, r->handle[i]);
    }
    return SM_OK;
}

// The first `n` pins; of OPEN it gives up at the first that fails, and r->pins tells how many are open.
static SmResult each_pin(SmvmRunner *r, uint8_t n, Way way)
{
    SmvmPins p;
    SmvmPin pin;
    SmIoPin row;
    SmResult result = SM_OK;

    if (n == 0 || !smvm_pins(r->image, &p))
        return SM_OK;
    for (uint8_t i = 0; i < n && smvm_next_pin(&p, &pin); i++) {
        smvm_target_pin(&pin, &row);
        result = one_pin(r, &row, i, way);
        if (way == OPEN && result != SM_OK)
            return result;
        if (way == OPEN)
            r->pins++;
    }
    return SM_OK;
}

// ---- all ----

SmResult smvm_runner_open(SmvmRunner *r, SmvmBytes image)
{
    SmResult result = smvm_runner_fits(r, image);

    if (result != SM_OK)
        return result;
    r->image = image;
    memset(r->memory, 0, r->size);
    if ((result = start_all(r)) == SM_OK)
        result = each_pin(r, r->pins_most, OPEN);
    if (result != SM_OK)
        smvm_runner_stop(r);
    return result;
}

void smvm_runner_step(SmvmRunner *r, uint64_t g)
{
    (void)each_pin(r, r->pins, INPUTS);
    for (uint8_t i = 0; i < r->machines; i++)
        memcpy((uint8_t *)r->memory + r->g[i], &g, sizeof g);
    for (uint8_t i = 0; i < r->machines; i++)
        (void)smvm_step(r->vm[i], r->memory);
    (void)each_pin(r, r->pins, OUTPUTS);
}

void smvm_runner_stop(SmvmRunner *r)
{
    (void)each_pin(r, r->pins, SAFE);
    (void)each_pin(r, r->pins, CLOSE);
    r->pins = 0;
    r->machines = 0;
}
