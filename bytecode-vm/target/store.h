// SPDX-License-Identifier: Apache-2.0
// Images in non-volatile memory, so that an update cut off at any byte leaves the old image or the new one, never neither.
//
// Two records of a selector stand at the start, written in turn, each with a number and a checksum: the newest whole one counts.  Behind it
// are one slot or two.  An image is written to the slot that does not run, verified where it lies, and only then chosen, by one write of a
// selector record.  It starts as a trial: each start counts down before the image runs; when none is left, or it is refused, the one before it
// runs again, or the image that is built into the firmware.  Confirmed, it stays.
//
// With one slot (an Uno's EEPROM has 1 KB) an update overwrites the image; until the new one is chosen the built-in image is what runs.
#ifndef SMVM_STORE_H
#define SMVM_STORE_H

#include "bytecode-vm/smvm.h"
#include "runtime-c/pal/nvm.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { STORE_TRIES = 3, STORE_BUILT_IN = 0xff };

typedef enum StoreState {
    STORE_EMPTY,              // nothing, or not whole
    STORE_WHOLE,              // a whole image that is not chosen
    STORE_TRIAL,              // chosen, not yet confirmed
    STORE_CONFIRMED
} StoreState;

typedef struct Store {
    PalNvm nvm;
    uint32_t slot_at[2], slot_size;
    uint8_t slots;
    // What the newest selector record says.
    uint32_t number;          // of the record
    uint8_t active;           // slot, or STORE_BUILT_IN
    uint8_t before;           // what runs again if the trial fails
    uint8_t tries;            // left; of a confirmed image 0
    bool confirmed;
    uint32_t counter;         // of the newest image that was ever chosen, for those that carry one (AUTH): older ones are refused
    // An update under way.
    uint16_t session;         // 0: none
    uint8_t target;
    uint32_t length, checksum, next;
} Store;

// Reads the selector.  Where both records are broken, as in a new chip, the built-in image runs.
SmResult store_open(Store *s, PalNvm nvm);

// Which image to run now; counts a trial down, on the medium, before it returns.  To be called once a start.
SmResult store_boot(Store *s, uint8_t *slot);

// An update.  SM_E_SPACE: larger than a slot.  SM_E_BUSY from begin: never; it ends another one that was under way.
SmResult store_begin(Store *s, uint32_t length, uint32_t checksum);
SmResult store_write(Store *s, uint32_t at, const uint8_t *bytes, uint8_t n);      // repeated writes of what is there are no writes
SmResult store_end(Store *s, SmvmVerdict *why);                                    // reads it back and verifies it where it lies
SmResult store_activate(Store *s);

SmResult store_confirm(Store *s, uint32_t checksum);
SmResult store_erase(Store *s, uint32_t checksum);
StoreState store_state(const Store *s, uint8_t slot);

#ifdef __cplusplus
}
#endif
#endif
