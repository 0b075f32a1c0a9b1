// SPDX-License-Identifier: Apache-2.0
// Images in non-volatile memory, so that an update cut off at any byte leaves the old image or the new one, never neither.
//
//     StorePlan plan = {1024, 2, {SLOT_0, SLOT_1}};
//     smvm_store_open(&store, nvm, &plan);
//     smvm_store_boot(&store, &slot);                         // which image to run: a slot, or STORE_BUILT_IN
//
// Two records of a selector stand at the start of the memory.  They are written in turn, each with a number and a checksum: the
// newest whole one counts, so that one write changes everything at once.  Behind them are two slots, or one.
//
// An update writes the slot that does not run, verifies it where it lies, and only then chooses it.  It starts as a trial: every
// start counts it down before it runs, and when nothing is left the image before it runs again.  Confirmed, it stays.
//
// A board that has a key runs no image whose code (bytecode-vm/auth.h) is not made with it, nor takes one again whose number is not above
// that of an image that was confirmed.  That number is part of the record that confirms.
//
// With one slot (the EEPROM of an Uno has 1 KB) there is no image before it but the one that is built into the firmware: it runs
// from the first byte of an update to its choice, and whoever runs the image in the slot must have changed to it before.
#ifndef SMVM_STORE_H
#define SMVM_STORE_H

#include "bytecode-vm/smvm.h"
#include "runtime-c/pal/nvm.h"

#ifdef __cplusplus
extern "C" {
#endif

enum {
    STORE_TRIES = 3,          // starts that a trial has
    STORE_RECORD = 32,        // bytes of a selector record, before it is rounded up to what the memory erases
    STORE_UNIT = 32           // the largest unit of writing that is supported
};
#define STORE_BUILT_IN 0xffu  // stands for a slot: the image that is part of the firmware

typedef struct StorePlan {
    uint32_t size;            // bytes of the memory that may be used
    uint8_t slots;            // 1 or 2
    SmvmBytes image[2];       // how the VM reads the slots (SMVM_FETCH)
} StorePlan;

// What the selector says: a record, byte for byte as it lies on the medium; numbers have their least significant byte first.
typedef struct StoreChoice {
    uint8_t number[4];        // of the record; each is one larger
    uint8_t version;
    uint8_t active;           // what runs: a slot or STORE_BUILT_IN
    uint8_t before;           // what runs again if the trial fails
    uint8_t tries;            // starts that are left to a trial
    uint8_t confirmed;        // 0 or 1
    uint8_t zeros[3];
    uint8_t checksum[4];      // of the active image: a slot that holds another is not run
    uint8_t checksum_before[4];   // the same for `before`
    uint8_t newest[4];        // the highest number (image section AUTH) of an image that a board with a key has confirmed
    uint8_t period[2], period_before[2];      // milliseconds between steps of each, as the host gave them; 0: the board's own
    uint8_t crc[4];           // CRC-32 of all before it
} StoreChoice;

typedef struct Store {
    PalNvm nvm;
    StorePlan plan;
    SmvmAt record_size, slot_size, slot_at[2];
    SmvmAt erase;             // of the memory: PalNvmInfo; write is 1 at least
    uint8_t write, blank;
    StoreChoice now;
    uint8_t running;          // what smvm_store_boot gave
    // Whether the board's key has made this image's code, and its number (smvm_auth_check); NULL: there is no key.  To be set between
    // smvm_store_open and smvm_store_boot.
    bool (*is_authentic)(SmvmBytes image, uint32_t *number);
    // An update under way.
    uint16_t session;         // as the host numbers it; 0: none
    uint8_t target;
    bool whole;               // smvm_store_end has accepted it
    SmvmAt length, next;
    uint8_t checksum[4];
} Store;

// Reads the selector; where no record is whole, as in a new chip, the built-in image is chosen.  SM_E_SPACE: the memory has no room
// for records and slots.  SM_E_UNSUPPORTED: it writes in units larger than STORE_UNIT, or its units are no powers of two.
SmResult smvm_store_open(Store *s, PalNvm nvm, const StorePlan *plan);

// Which image to run; once a start.  A trial is counted down on the medium before this returns.  An image that is not whole any
// more is passed over: the one before it, then the built-in one.
SmResult smvm_store_boot(Store *s, uint8_t *slot);

// The caller cannot run the image that smvm_store_boot gave, for a pin of it is taken: which to run instead.  A trial is over by that; a
// confirmed image stays chosen, for other firmware can.
SmResult smvm_store_pass_over(Store *s, uint8_t *slot);

// The caller does not run the image in the slot any more, but the built-in one.
void smvm_store_leave(Store *s);

// ---- an update, step by step; each step may be repeated ----

// Whether an update may begin once a slot is free (with one slot: left).  SM_E_SPACE: longer than a slot.  SM_E_BUSY: the chosen
// image is on trial.
SmResult smvm_store_may_begin(const Store *s, SmvmAt length);

// SM_E_SPACE: longer than a slot.  SM_E_BUSY: the chosen image is on trial, it is to be confirmed or erased first; or every slot is
// chosen or running.
SmResult smvm_store_begin(Store *s, uint16_t session, SmvmAt length, uint32_t checksum);

// n bytes from place `at` on, which is s->next or, of what was written before, less; a multiple of s->write, and so is n but at the
// end.  SM_E_HANDLE: no such session.  SM_E_ARGUMENT: not the next bytes, and not the same as before.
SmResult smvm_store_write(Store *s, uint16_t session, SmvmAt at, const uint8_t *bytes, uint8_t n);

// Reads it back and verifies it where it lies.  SM_E_DEVICE: it is not what was sent.  SM_E_ARGUMENT: the verifier refuses it, *why
// says.  SM_E_UNSIGNED: its code is wrong, or it has none.  SM_E_REPLAY: it is not newer than one that was confirmed.
SmResult smvm_store_end(Store *s, uint16_t session, SmvmVerdict *why);

// Chooses it: from the next start on it is on trial, and runs every `period` milliseconds (0: as the board does).  SM_E_HANDLE:
// smvm_store_end has not accepted it.
SmResult smvm_store_activate(Store *s, uint16_t session, uint16_t period);

// ---- afterwards ----

// The running image stays.  SM_E_ARGUMENT: another one runs.
SmResult smvm_store_confirm(Store *s, uint32_t checksum);

// From the next start on the image with this checksum is not run: the one before it or the built-in one is.  SM_E_MISSING: no slot
// holds it.  Another failure: some slots may still hold it, the caller can try again.
SmResult smvm_store_erase(Store *s, uint32_t checksum);

// ---- what there is ----

// A place or length of three bytes; false: it is beyond any image here.
bool smvm_get_at(const uint8_t *field, SmvmAt *at);

static inline bool smvm_store_has_key(const Store *s) { return SMVM_STORE_KEY && s->is_authentic; }

typedef enum StoreState { STORE_EMPTY, STORE_WHOLE, STORE_TRIAL, STORE_CONFIRMED } StoreState;

uint16_t smvm_store_period(const Store *s, uint8_t slot);      // 0 where nobody has said

StoreState smvm_store_state(const Store *s, uint8_t slot);

bool smvm_store_is_before(const Store *s, uint8_t slot);       // it runs where the chosen one cannot, if it is whole

#ifdef __cplusplus
}
#endif
#endif
