// SPDX-License-Identifier: Apache-2.0
// The state vector: the memory through which all tasks of an application speak with each other (language.md 4).
//
// `smc build rocket.sv --emit=c --runtime` makes one: its storage, a struct with the layout of language.md; its description, for whoever
// wants elements by name; and a function to read and one to write for each element:
//
//     rocket_set_altitude(120.5);                        // typed, guarded where the .sv says `lock`
//     double altitude = rocket_altitude();
//     RocketSv copy;
//     rocket_read_Sensors(&copy);                        // the region [Sensors] of it, in one go; rocket_write_Sensors the other way
//     sm_find_element(&rocket_names, "altitude") == &rocket_element[ROCKET_E_altitude]
//     sm_read_region(&rocket_vector, &rocket_layout.whole, &copy);
//
// Without `lock` the vector belongs to one thread, and its members (rocket_sv.altitude) may as well be used as they are.  With `lock` any
// thread may call anything here: every call is one critical section of a few memory accesses.  Several elements that belong together
// are read and written together: as a region, as a snapshot.
//
// A lock that cannot be had within SM_LOCK_WAIT (config.h) means that a thread died inside a critical section, which Linux tells at once.  Then a call does not
// touch the vector, says SM_E_TIMEOUT and counts in `faults`.  A value that could not be read is 0, whatever the reason.
//
// Wrong arguments are refused (SM_E_ARGUMENT) and change nothing: a null pointer, an element or a region that is not in the vector's own table.
#ifndef SM_STATEVEC_H
#define SM_STATEVEC_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "runtime-c/config.h"
#include "runtime-c/pal/lock.h"
#include "stdlib/result.h"
#include "stdlib/types.h"

#ifdef __cplusplus
extern "C" {
#endif

// ---- what a vector is: constant tables, made by smc ----

extern const uint8_t sm_type_bytes[SM_TYPE_COUNT];     // by SmType: how many it takes, in memory and on the wire

typedef struct SmElement {
    uint32_t offset;          // bytes from the start of the vector
    uint8_t type;             // SmType
    uint16_t region;          // which: SmLayout.region[region]
} SmElement;

typedef struct SmRegion {
    uint32_t offset, size;    // in memory
    uint32_t packed;          // bytes on the wire: its elements without gaps, least significant byte first (language.md 4.12)
    uint16_t first, count;    // its elements: SmLayout.element[first …]
} SmRegion;

typedef struct SmLayout {
    uint32_t hash;            // of names, types and order: what has another was made from another .sv
    uint16_t elements, regions;
    const SmElement *element;
    const SmRegion *region;
    SmRegion whole;           // the whole vector as a region
} SmLayout;

// The names stand apart, and nothing else refers to them: in a program that asks for none they take no memory.
typedef struct SmNames {
    const SmLayout *layout;
    const char *vector;               // of the .sv
    const char *const *element;       // in the order of SmLayout.element
    const char *const *region;
} SmNames;

// ---- one vector ----

typedef struct SmStateVec {
    const SmLayout *layout;
    void *at;                 // layout->whole.size bytes, aligned as a uint64_t
    bool guarded;             // the .sv says `lock`
    PalLock lock;
    uint32_t faults;          // how often the lock could not be had; others read it by sm_shared_read (shared.h)
} SmStateVec;

// Opens the lock of a guarded vector.  Changes no element.  SM_E_FULL: no lock left (config.h, PAL_LOCKS).  SM_E_ALIGNMENT: sv->at.
SmResult sm_statevec_init(SmStateVec *sv);

// Around accesses to sv->at that belong together: nothing but memory accesses in between, no other call of this header.
// SM_E_TIMEOUT: not entered; do not leave then.  SM_E_BUSY: the caller is inside already.  Without `lock` these do nothing.
SmResult sm_enter(SmStateVec *sv);
void sm_leave(SmStateVec *sv);

// ---- elements ----

// By name; NULL if there is none.  Linear: do it at start.
const SmElement *sm_find_element(const SmNames *names, const char *name);

// Any element as a number, converted as the language converts (language.md 2): a NaN is read and stored as 0, integers lose the
// fraction and saturate.
SmResult sm_read_number(SmStateVec *sv, const SmElement *e, SmF64 *value);
SmResult sm_write_number(SmStateVec *sv, const SmElement *e, SmF64 value);

// sm_read_U8(sv, e, &value), sm_write_U8(sv, e, value), and so for each type of stdlib/types.def: the value as it lies in memory, a NaN
// too, but a bool is 0 or 1.  SM_E_ARGUMENT: e is not of that type.
#define SM_TYPE(name, wire, spelling, ctype, bytes, kind) \
    SmResult sm_read_##name(SmStateVec *sv, const SmElement *e, ctype *value); \
    SmResult sm_write_##name(SmStateVec *sv, const SmElement *e, ctype value);
#include "stdlib/types.def"
#undef SM_TYPE

// ---- regions, and the whole vector ----

// By name, "*" is the whole vector; NULL if there is none.
const SmRegion *sm_find_region(const SmNames *names, const char *name);

// Copies r->size bytes as they lie in memory, in one go.  (What is written has zeros between its elements, as memory has.)
SmResult sm_read_region(SmStateVec *sv, const SmRegion *r, void *bytes);
SmResult sm_write_region(SmStateVec *sv, const SmRegion *r, const void *bytes);

// The same in wire form, r->packed bytes, equal on every computer.  SM_E_SIZE: room is less than that, n is another number.
SmResult sm_pack_region(SmStateVec *sv, const SmRegion *r, void *bytes, size_t room);
SmResult sm_unpack_region(SmStateVec *sv, const SmRegion *r, const void *bytes, size_t n);

#ifdef __cplusplus
}
#endif
#endif
