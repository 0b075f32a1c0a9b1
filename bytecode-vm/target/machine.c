// SPDX-License-Identifier: Apache-2.0
// Implements the interface of runtime-c/machine_type.h for an image.
#include "bytecode-vm/target/machine.h"

#include <string.h>

#include "bytecode-vm/image.h"

// ---- open, init ----

static SmRange make_range(uint32_t offset, uint32_t size)
{
    SmRange p;

    p.offset = offset;
    p.size = size;
    return p;
}

// Copies the properties of the machine that later calls need.
static void store_machine_facts(SmvmTarget *t, const SmvmMachine *m)
{
    t->states = m->states;
    t->outputs = m->outputs;
    t->outputs_at = m->outputs_at;
    t->accessed = make_range(m->from, (uint32_t)m->to - m->from);
    t->state_number = make_range(m->s, 4);
}

static SmResult target_open(void *self, uint32_t layout, uint32_t size)
{
    SmvmTarget *t = self;
    SmvmMachine m;

    t->vm = NULL;
    if (smvm_verify(t->image, t->size, &t->why) != 0)
        return SM_E_IMAGE;
    if (!smvm_machine(t->image, t->machine, &m))
        return SM_E_MISSING;
    if (m.layout != layout || m.sv_size != size)
        return SM_E_LAYOUT;
    store_machine_facts(t, &m);
    return SM_OK;
}

static void copy_range(const void *from, void *to, SmRange p)
{
    memcpy((uint8_t *)to + p.offset, (const uint8_t *)from + p.offset, (size_t)p.size);
}

// Creates the decoded form, if there is a decoder.  If that fails, restores element S to s, its value before smvm_init: a failed init must
// not change the state vector.
static SmResult decode_machine(SmvmTarget *t, const SmvmMachine *m, void *sv, uint32_t s)
{
    SmResult r = SM_OK;

    if (t->decoder != NULL)
        r = t->decoder->decode(&t->fast, t->decoded, t->decoded_size, m, t->memory, sv);
    if (r != SM_OK)
        memcpy((uint8_t *)sv + t->state_number.offset, &s, sizeof s);
    return r;
}

static SmResult target_init(void *self, void *sv, uint32_t state)
{
    SmvmTarget *t = self;
    SmvmMachine m;
    SmvmVector v;
    SmResult r;
    uint32_t s;

    t->vm = NULL;
    t->fast = NULL;
    smvm_machine(t->image, t->machine, &m);
    v.at = sv;
    v.size = m.sv_size;
    v.layout = m.layout;
    memcpy(&s, (uint8_t *)sv + t->state_number.offset, sizeof s);
    r = smvm_init(t->memory, t->memory_size, &m, &v, state);
    if (r == SM_OK)
        r = decode_machine(t, &m, sv, s);
    if (r != SM_OK)
        return r;
    t->vm = t->memory;
    t->more = smvm_parts(t->vm, &m).stored;
    return SM_OK;
}

// ---- step ----

static SmResult target_step(void *self, void *sv)
{
    SmvmTarget *t = self;

    if (t->vm == NULL)
        return SM_E_ARGUMENT;
    return t->fast != NULL ? t->decoder->step(t->fast, sv) : smvm_step(t->vm, sv);
}

// Copies the elements that the last step stored, from one state vector to another.
static void target_publish(const void *self, const void *from, void *to)
{
    const SmvmTarget *t = self;
    SmvmLocation o;

    if (smvm_stored_state(t->vm))
        copy_range(from, to, t->state_number);
    for (uint32_t i = 0; i < t->outputs; i++) {
        uint8_t bits = i < 64 ? t->vm->stored[i >> 3] : t->more[(i - 64) >> 3];
        if ((bits >> (i & 7) & 1) == 0)
            continue;
        o = smvm_location(t->image, (SmvmAt)(t->outputs_at + SMVM_LOCATION_BYTES * i));
        copy_range(from, to, make_range(o.offset, (uint32_t)1 << smvm_type_shift(o.type)));
    }
}

// ---- queries ----

static uint32_t target_state(const void *self) { return smvm_state(((const SmvmTarget *)self)->vm); }
static bool target_moved(const void *self) { return ((const SmvmTarget *)self)->vm->first; }
static uint64_t target_time(const void *self) { return smvm_time(((const SmvmTarget *)self)->vm); }
static uint32_t target_states(const void *self) { return ((const SmvmTarget *)self)->states; }
static SmRange target_accessed(const void *self) { return ((const SmvmTarget *)self)->accessed; }
static SmRange target_state_number(const void *self) { return ((const SmvmTarget *)self)->state_number; }

// Returns the name of a state.  The verifier does not check names, so a name without a terminating 0 after its last character counts as absent.
static const char *target_state_name(const void *self, uint32_t state)
{
    const SmvmTarget *t = self;
    SmvmMachine m;
    SmvmName n;
    SmvmAt end;

    if (state < 1 || state > t->states || !smvm_machine(t->image, t->machine, &m))
        return "";
    n = smvm_state_name(&m, state);
    end = (SmvmAt)(n.at + n.size);
    if (n.size == 0 || end >= m.debug_at + m.debug_size || smvm_u8(t->image, end) != 0)
        return "";
    return SMVM_TEXT(t->image, n.at);
}

const SmMachineType smvm_machine_type = {
    target_open, target_init, target_step, target_state, target_moved, target_time, target_state_name, target_states, target_accessed,
    target_state_number, target_publish,
};

// Verifies an image.  Returns how many bytes of SmvmTarget.memory this machine of the image needs; 0 if the image is rejected or has no such machine.
uint32_t smvm_target_memory(SmvmBytes image, uint32_t size, uint32_t machine)
{
    SmvmVerdict why;
    SmvmMachine m;

    return smvm_verify(image, size, &why) == 0 && smvm_machine(image, machine, &m) ? smvm_ram_size(&m) : 0;
}
