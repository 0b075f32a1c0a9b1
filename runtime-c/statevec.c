// SPDX-License-Identifier: Apache-2.0
// The state vector: its lock and its single elements.  (Regions and wire form: region.c; names: names.c.)
#include "runtime-c/statevec.h"

#include "runtime-c/shared.h"
#include "stdlib/convert.h"

struct alignment { char c; uint64_t aligned; };

// Opens the lock of a guarded vector.  Changes no element.
SmResult sm_statevec_init(SmStateVec *sv)
{
    if (!sv || !sv->layout || !sv->at)
        return SM_E_ARGUMENT;
    if ((uintptr_t)sv->at % offsetof(struct alignment, aligned) != 0)
        return SM_E_ALIGNMENT;
    return sv->guarded ? pal_lock_open(&sv->lock) : SM_OK;
}

// Locks the state vector, if it is guarded.  SM_E_TIMEOUT: it is not locked.
SmResult sm_enter(SmStateVec *sv)
{
    SmResult r;

    if (!sv)
        return SM_E_ARGUMENT;
    if (!sv->guarded)
        return SM_OK;
    r = pal_lock_take(sv->lock, SM_LOCK_WAIT);
    if (r != SM_OK)
        sm_shared_increment(&sv->faults);
    return r;
}

void sm_leave(SmStateVec *sv)
{
    if (sv && sv->guarded)
        pal_lock_give(sv->lock);
}

// ---- location of an element ----

const uint8_t sm_type_bytes[SM_TYPE_COUNT] = {
#define SM_TYPE(name, wire, spelling, ctype, bytes, kind) bytes,
#include "stdlib/types.def"
#undef SM_TYPE
};

// Returns the address of e in memory; NULL if it is not an element of the vector.  The offsets and types in the vector's own table are
// trusted.
static uint8_t *element_address(const SmStateVec *sv, const SmElement *e)
{
    if (!sv || (uintptr_t)e - (uintptr_t)sv->layout->element >= sv->layout->elements * sizeof *e)
        return NULL;
    return (uint8_t *)sv->at + e->offset;
}

// ---- as numbers ----

// Reads any element as a number, by the rules of the language (language.md 2): a NaN is read as 0.
SmResult sm_read_number(SmStateVec *sv, const SmElement *e, SmF64 *value)
{
    const uint8_t *at = element_address(sv, e);
    SmResult r = at && value ? sm_enter(sv) : SM_E_ARGUMENT;
    uint64_t cell;

    if (value)
        *value = sm_from_i32(0);
    if (r != SM_OK)
        return r;
    cell = sm_cell_load((SmType)e->type, at);
    sm_leave(sv);
    *value = sm_cell_to_f64((SmType)e->type, cell);
    return SM_OK;
}

// Stores a number in any element, by the rules of the language (language.md 2): integers lose the fraction and saturate.
SmResult sm_write_number(SmStateVec *sv, const SmElement *e, SmF64 value)
{
    uint8_t *at = element_address(sv, e);
    uint64_t cell;
    SmResult r;

    if (!at)
        return SM_E_ARGUMENT;
    cell = sm_cell_from_f64((SmType)e->type, value);
    r = sm_enter(sv);
    if (r != SM_OK)
        return r;
    sm_cell_store((SmType)e->type, at, cell);
    sm_leave(sv);
    return SM_OK;
}

// ---- typed ----

static SmResult read_typed(SmStateVec *sv, const SmElement *e, SmType type, void *value)
{
    const uint8_t *at = element_address(sv, e);
    SmResult r = at && value && e->type == type ? sm_enter(sv) : SM_E_ARGUMENT;
    uint64_t cell = 0;

    if (r == SM_OK) {
        cell = sm_cell_load(type, at);
        sm_leave(sv);
    }
    if (value)
        sm_cell_store(type, value, cell);
    return r;
}

static SmResult write_typed(SmStateVec *sv, const SmElement *e, SmType type, const void *value)
{
    uint8_t *at = element_address(sv, e);
    uint64_t cell = sm_cell_load(type, value);
    SmResult r = at && e->type == type ? sm_enter(sv) : SM_E_ARGUMENT;

    if (r == SM_OK) {
        sm_cell_store(type, at, cell);
        sm_leave(sv);
    }
    return r;
}

#define SM_TYPE(name, wire, spelling, ctype, bytes, kind) \
    SmResult sm_read_##name(SmStateVec *sv, const SmElement *e, ctype *value) { return read_typed(sv, e, SM_##name, value); } \
    SmResult sm_write_##name(SmStateVec *sv, const SmElement *e, ctype value) { return write_typed(sv, e, SM_##name, &value); }
#include "stdlib/types.def"
#undef SM_TYPE
