// SPDX-License-Identifier: Apache-2.0
// Prepares an image in a slot, and exchanges it for the one in the other slot.
#include "bytecode-vm/target/slot.h"

#include <string.h>

#include "bytecode-vm/image.h"

static bool has_names(const SmvmSlot *s) { return s->m.debug_size > 0; }

static uint32_t read_identity(const SmvmTarget *t) { return smvm_uint(t->image, SMVM_CRC_AT, 4); }

static void init_slot(void *slot, void *other)
{
    SmvmSlot *s = slot, *o = other;

    smvm_machine(s->target.image, s->target.machine, &s->m);
    s->identity = read_identity(&s->target);
    s->plan = s->back = NULL;
    s->built_in = o->built_in = s->target.image;
    s->built_in_size = o->built_in_size = s->target.size;
}

// ---- preparation ----

typedef SmSwapReason PreparePart(SmvmSlot *to, const SmvmSlot *from, const SmSwapChange *change, const SmMachine *m);

// Allocates `bytes` of the slot's memory, aligned as a uint64_t; NULL if they do not fit.
static void *allocate(SmvmSlot *s, uint32_t bytes)
{
    void *at = (uint8_t *)s->memory + s->used;

    if (bytes > s->size - s->used || s->size - s->used - bytes < (8 - bytes % 8) % 8)
        return NULL;
    s->used += bytes + (8 - bytes % 8) % 8;
    return at;
}

// Copies the image of the change into the slot's memory, and verifies the copy, because nothing changes it any more.
static SmSwapReason copy_image(SmvmSlot *to, const SmvmSlot *from, const SmSwapChange *change, const SmMachine *m)
{
    uint8_t *image;

    (void)from, (void)m;
    to->identity = to->used = 0;
    to->plan = to->back = NULL;
    to->target.vm = NULL;
    to->target.machine = 0;
    if (change->built_in) {
        to->target.image = to->built_in;
        to->target.size = to->built_in_size;
        return SM_SWAP_NOT_REFUSED;
    }
    if (!change->image)
        return SM_SWAP_NO_IMAGE;
    image = allocate(to, change->size);
    if (!image)
        return SM_SWAP_NO_MEMORY;
    memcpy(image, change->image, change->size);
    to->target.image = SMVM_IMAGE(image);
    to->target.size = change->size;
    return SM_SWAP_NOT_REFUSED;
}

static SmSwapReason verify_image(SmvmSlot *to, const SmvmSlot *from, const SmSwapChange *change, const SmMachine *m)
{
    const SmResult r = m->type->open(&to->target, m->sv->layout->hash, m->sv->layout->whole.size);

    (void)from, (void)change;
    if (r != SM_OK)
        return r == SM_E_LAYOUT ? SM_SWAP_NO_LAYOUT : SM_SWAP_NO_IMAGE;
    to->identity = read_identity(&to->target);
    if (smvm_machine(to->target.image, 1, &to->m))
        return SM_SWAP_NO_SEVERAL;
    smvm_machine(to->target.image, 0, &to->m);
    return to->longest > 0 && smvm_longest_step(&to->m) > to->longest ? SM_SWAP_NO_SLOW : SM_SWAP_NOT_REFUSED;
}

static bool is_name(SmvmBytes image, SmvmName n, const char *text)
{
    SmvmAt i = 0;

    while (i < n.size && text[i] != '\0' && (char)smvm_u8(image, (SmvmAt)(n.at + i)) == text[i])
        i++;
    return i > 0 && i == n.size && text[i] == '\0';
}

// Stores the number of the state in which the machine starts.
static SmSwapReason find_first_state(SmvmSlot *to, const SmvmSlot *from, const SmSwapChange *change, const SmMachine *m)
{
    (void)from, (void)m;
    to->first = 1;
    while (change->state && to->first <= to->m.states && !is_name(to->target.image, smvm_state_name(&to->m, to->first), change->state))
        to->first++;
    return to->first <= to->m.states ? SM_SWAP_NOT_REFUSED : SM_SWAP_NO_STATE;
}

// Returns the address of the state vector on which the machine steps.
static void *vector_address(const SmMachine *m) { return m->sv->guarded ? m->copy : m->sv->at; }

// Starts the machine in its memory, without an access to the state vector.
static SmResult start_machine(SmvmSlot *s, const SmMachine *m, uint32_t state)
{
    SmvmVector v;

    v.at = vector_address(m);
    v.size = s->m.sv_size;
    v.layout = s->m.layout;
    return smvm_prepare(s->target.memory, s->target.memory_size, &s->m, &v, state);
}

static SmSwapReason start_in_slot(SmvmSlot *to, const SmvmSlot *from, const SmSwapChange *change, const SmMachine *m)
{
    (void)from, (void)change;
    to->target.memory_size = smvm_ram_size(&to->m);
    to->target.memory = allocate(to, to->target.memory_size);
    if (!to->target.memory || start_machine(to, m, to->first) != SM_OK)
        return SM_SWAP_NO_MEMORY;
    to->target.vm = to->target.memory;
    to->target.more = smvm_parts(to->target.vm, &to->m).stored;
    return SM_SWAP_NOT_REFUSED;
}

static SmSwapReason decode_in_slot(SmvmSlot *to, const SmvmSlot *from, const SmSwapChange *change, const SmMachine *m)
{
    SmvmTarget *t = &to->target;

    (void)from, (void)change;
    t->fast = NULL;
    if (!t->decoder)
        return SM_SWAP_NOT_REFUSED;
    t->decoded_size = t->decoder->size(&to->m);
    t->decoded = allocate(to, t->decoded_size);
    if (!t->decoded || t->decoder->decode(&t->fast, t->decoded, t->decoded_size, &to->m, t->vm, vector_address(m)) != SM_OK)
        return SM_SWAP_NO_MEMORY;
    return SM_SWAP_NOT_REFUSED;
}

// Allocates and computes a plan in the memory of `in`; stores it in *plan.
static SmSwapReason make_plan(SmvmSlot *in, SmvmSwap **plan, const SmvmMachine *from, const SmvmMachine *to)
{
    const uint32_t size = smvm_swap_size(from, to);
    SmvmSwap *at = allocate(in, size);

    if (!at || smvm_swap_plan(at, size, from, to) != SM_OK)
        return SM_SWAP_NO_MEMORY;
    *plan = at;
    return SM_SWAP_NOT_REFUSED;
}

static SmSwapReason plan_exchange(SmvmSlot *to, const SmvmSlot *from, const SmSwapChange *change, const SmMachine *m)
{
    (void)m;
    if (change->mode != SM_SWAP_CONTINUE)
        return SM_SWAP_NOT_REFUSED;
    return has_names(from) && has_names(to) ? make_plan(to, &to->plan, &from->m, &to->m) : SM_SWAP_NO_NAMES;
}

static SmSwapReason plan_return(SmvmSlot *to, const SmvmSlot *from, const SmSwapChange *change, const SmMachine *m)
{
    (void)change, (void)m;
    return has_names(from) && has_names(to) ? make_plan(to, &to->back, &to->m, &from->m) : SM_SWAP_NOT_REFUSED;
}

static PreparePart *const parts[] = {copy_image, verify_image, find_first_state, start_in_slot, decode_in_slot, plan_exchange, plan_return};
enum { PARTS = sizeof parts / sizeof *parts, PARTS_WITHOUT_PLANS = PARTS - 2 };

static SmSwapReason prepare_slot(void *to, const void *from, const SmSwapChange *change, const SmMachine *m, uint8_t part)
{
    return parts[part](to, from, change, m);
}

// Runs the parts of the preparation except plans, because nothing is exchanged: without plans, an image that was exchanged before fits again.
SmSwapReason smvm_slot_load(SmvmSlot *to, const SmvmSlot *from, const SmSwapChange *image, const SmMachine *m)
{
    SmSwapChange c = *image;
    SmSwapReason why = SM_SWAP_NOT_REFUSED;

    for (uint8_t part = 0; part < PARTS_WITHOUT_PLANS && why == SM_SWAP_NOT_REFUSED; part++) {
        why = parts[part](to, from, &c, m);
        if (why == SM_SWAP_NO_STATE) {
            c.state = NULL;
            why = parts[part](to, from, &c, m);
        }
    }
    return why;
}

// ---- exchange and return ----

static SmSwapReason check_slots(const void *from, const void *to, uint8_t mode)
{
    const SmvmSlot *f = from, *t = to;
    const uint32_t state = smvm_state(f->target.vm);

    if (!smvm_state_allows_swap(&f->m, state))
        return SM_SWAP_NO_UNMARKED;
    return mode == SM_SWAP_CONTINUE && smvm_swap_state(t->plan, state) == 0 ? SM_SWAP_NO_GONE : SM_SWAP_NOT_REFUSED;
}

static void hand_over_to_slot(const void *from, void *to, uint8_t mode, const SmMachine *m)
{
    const SmvmSlot *f = from;
    SmvmSlot *t = to;

    if (mode == SM_SWAP_CONTINUE)
        (void)smvm_swap_continue(t->plan, f->target.vm, t->target.vm, m->sv->at);
    else
        smvm_write_state(t->target.vm, &t->m, m->sv->at);
}

// Returns the first state marked @safe; the last state if no earlier one is.
static uint32_t first_safe_state(const SmvmMachine *m)
{
    uint32_t state = 1;

    while (state < m->states && !smvm_state_is_safe(m, state))
        state++;
    return state;
}

// Lets the old machine in slot `to` continue where the new one in `from` is, as far as it can (swapping.md 12.20). First starts it again, because
// its memory still has its values from before the exchange. Returns false if it begins in its first @safe state instead.
static bool give_back_slot(const void *from, void *to, const SmMachine *m)
{
    const SmvmSlot *f = from;
    SmvmSlot *t = to;

    (void)start_machine(t, m, first_safe_state(&t->m));
    if (f->back && smvm_swap_continue(f->back, f->target.vm, t->target.vm, m->sv->at) == SM_OK)
        return true;
    smvm_write_state(t->target.vm, &t->m, m->sv->at);
    return false;
}

static bool is_slot_aborting(const void *slot)
{
    const SmvmSlot *s = slot;

    return smvm_state_is_abort(&s->m, smvm_state(s->target.vm));
}

static uint32_t slot_identity(const void *slot) { return ((const SmvmSlot *)slot)->identity; }

static bool read_output(const void *slot, uint32_t i, SmRange *range)
{
    const SmvmSlot *s = slot;

    if (s->identity == 0 || i > s->m.outputs)
        return false;
    if (i == s->m.outputs) {
        *range = s->target.state_number;
    } else {
        const SmvmLocation o = smvm_output(&s->m, i);
        range->offset = o.offset;
        range->size = (uint32_t)1 << smvm_type_shift(o.type);
    }
    return true;
}

const SmSwapType smvm_slot_type = {
    init_slot, PARTS, prepare_slot, check_slots, hand_over_to_slot, give_back_slot, is_slot_aborting, slot_identity, read_output,
};

bool smvm_slot_item(const SmvmSlot *slot, uint32_t i, SmvmSwapItem *item) { return slot->plan && smvm_swap_item(slot->plan, i, item); }
