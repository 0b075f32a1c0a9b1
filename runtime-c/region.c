// SPDX-License-Identifier: Apache-2.0
// Regions of the state vector, in memory layout and in wire form (language.md 4.12, 4.13).
#include "runtime-c/statevec.h"

#include <string.h>

#include "stdlib/convert.h"

// Returns the address of r; NULL if it is not a region of the vector.  The offsets and counts in the vector's own table are trusted.
static uint8_t *region_address(const SmStateVec *sv, const SmRegion *r)
{
    if (!sv || (r != &sv->layout->whole && (uintptr_t)r - (uintptr_t)sv->layout->region >= sv->layout->regions * sizeof *r))
        return NULL;
    return (uint8_t *)sv->at + r->offset;
}

// Copies a region in its memory layout, r->size bytes, in one critical section.
SmResult sm_read_region(SmStateVec *sv, const SmRegion *r, void *bytes)
{
    const uint8_t *at = region_address(sv, r);
    SmResult result = at && bytes ? sm_enter(sv) : SM_E_ARGUMENT;

    if (result != SM_OK)
        return result;
    memcpy(bytes, at, (size_t)r->size);
    sm_leave(sv);
    return SM_OK;
}

// Copies bytes in the memory layout into a region, r->size of them, in one critical section.
SmResult sm_write_region(SmStateVec *sv, const SmRegion *r, const void *bytes)
{
    uint8_t *at = region_address(sv, r);
    SmResult result = at && bytes ? sm_enter(sv) : SM_E_ARGUMENT;

    if (result != SM_OK)
        return result;
    memcpy(at, bytes, (size_t)r->size);
    sm_leave(sv);
    return SM_OK;
}

// ---- wire form ----

// Copies elements to their positions in wire form, still in memory byte order.  The caller converts the byte order after it has
// released the lock.  Adjacent elements are copied together, to hold the lock as briefly as possible.
static void copy_packed(const SmStateVec *sv, const SmRegion *r, uint8_t *out)
{
    const SmElement *e = &sv->layout->element[r->first], *end = e + r->count;

    while (e < end) {
        const uint32_t from = e->offset;
        uint32_t to = from;

        for (; e < end && e->offset == to; e++)
            to += sm_type_bytes[e->type];
        memcpy(out, (const uint8_t *)sv->at + from, (size_t)(to - from));
        out += to - from;
    }
}

// Stores the low n bytes of an integer in wire byte order, little-endian.  Shifts work the same on every processor.
static void store_wire(uint8_t *out, uint64_t cell, uint8_t n)
{
    switch (n) {
    case 8:
        out[7] = (uint8_t)(cell >> 56), out[6] = (uint8_t)(cell >> 48), out[5] = (uint8_t)(cell >> 40), out[4] = (uint8_t)(cell >> 32);
        // fall through
    case 4:
        out[3] = (uint8_t)(cell >> 24), out[2] = (uint8_t)(cell >> 16);
        // fall through
    case 2:
        out[1] = (uint8_t)(cell >> 8);
        // fall through
    default:
        out[0] = (uint8_t)cell;
    }
}

// Returns the number of n bytes in its wire form, little-endian.
static uint64_t load_wire(const uint8_t *in, uint8_t n)
{
    uint64_t cell = 0;

    while (n > 0)
        cell = cell << 8 | in[--n];
    return cell;
}

// Converts the bytes of each element to wire order, in place.
static void convert_to_wire(const SmStateVec *sv, const SmRegion *r, uint8_t *out)
{
    const SmElement *e = &sv->layout->element[r->first];

    for (uint16_t i = 0; i < r->count; i++) {
        const uint8_t n = sm_type_bytes[e[i].type];

        store_wire(out, sm_cell_load((SmType)e[i].type, out), n);
        out += n;
    }
}

// Copies a region to its wire form, r->packed bytes that are identical on every computer.
SmResult sm_pack_region(SmStateVec *sv, const SmRegion *r, void *bytes, size_t room)
{
    SmResult result = region_address(sv, r) && bytes ? SM_OK : SM_E_ARGUMENT;

    if (result == SM_OK && room < r->packed)
        result = SM_E_SIZE;
    if (result == SM_OK)
        result = sm_enter(sv);
    if (result != SM_OK)
        return result;
    copy_packed(sv, r, (uint8_t *)bytes);
    sm_leave(sv);
    convert_to_wire(sv, r, (uint8_t *)bytes);
    return SM_OK;
}

// Stores the elements of a region from their wire form. Called inside the critical section.
static void store_unpacked(const SmStateVec *sv, const SmRegion *r, const uint8_t *in)
{
    const SmElement *e = &sv->layout->element[r->first];

    for (uint16_t i = 0; i < r->count; i++) {
        const uint8_t n = sm_type_bytes[e[i].type];

        sm_cell_store((SmType)e[i].type, (uint8_t *)sv->at + e[i].offset, load_wire(in, n));
        in += n;
    }
}

// Copies a region from its wire form; SM_E_SIZE if n is not r->packed.
SmResult sm_unpack_region(SmStateVec *sv, const SmRegion *r, const void *bytes, size_t n)
{
    SmResult result = region_address(sv, r) && bytes ? SM_OK : SM_E_ARGUMENT;

    if (result == SM_OK && n != r->packed)
        result = SM_E_SIZE;
    if (result == SM_OK)
        result = sm_enter(sv);
    if (result != SM_OK)
        return result;
    store_unpacked(sv, r, (const uint8_t *)bytes);
    sm_leave(sv);
    return SM_OK;
}
