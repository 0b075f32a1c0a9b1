// SPDX-License-Identifier: Apache-2.0
// Stores images in non-volatile memory.  An update that is interrupted at any byte leaves either the old image or the new one.
//
//     StorePlan plan = {1024, 2, {SLOT_0, SLOT_1}};
//     smvm_store_open(&store, nvm, &plan);
//     smvm_store_boot(&store, &slot);                         // which image to run: a slot, or STORE_BUILT_IN
//
// The memory starts with two records of a selector.  They are written alternately, each with a number and a checksum.  The newest
// valid record is in effect, so that a single write replaces all its fields at once.  One or two slots follow.
//
// An update writes a slot that is not running, verifies it in place, and only then chooses it.  The new image starts as a trial: every
// start decrements its count before the image runs, and when the count is used up, the previous image runs again.  A start counts in full
// only when the caller reports that the image has run for a while.  So an image that makes the board restart at once also loses its
// trial, but a host that restarts the board whenever it opens the line can do so several times.  A confirmed image remains chosen.
//
// A board with a key runs only images whose code (bytecode-vm/auth.h) was computed with that key.  It rejects an update whose number is
// not above that of every confirmed image.  The highest confirmed number is part of the record that confirms.
//
// With one slot (the EEPROM of an Uno has 1 KB) the only previous image is the one built into the firmware.  It runs from the first byte
// of an update until the new image is chosen.  The caller must switch to it before an update overwrites the slot.
#ifndef SMVM_STORE_H
#define SMVM_STORE_H

#include "bytecode-vm/smvm.h"
#include "runtime-c/pal/nvm.h"

#ifdef __cplusplus
extern "C" {
#endif

enum {
    STORE_TRIES = 3,          // how many times an image on trial is started before the previous image runs again
    STORE_START = 4,          // units of a trial's count that a start uses up: one at once, the others when the image has run for a while
    STORE_RECORD = 32,        // bytes of a selector record, before rounding up to the erase unit of the memory
    STORE_UNIT = 32           // the largest supported write unit
};
#define STORE_BUILT_IN 0xffu  // instead of the number of a slot: the image that is part of the firmware

typedef struct StorePlan {
    uint32_t size;            // bytes of the memory that the store may use
    uint8_t slots;            // number of slots, 1 or 2
    SmvmBytes image[2];       // the addresses at which the VM reads the slots (SMVM_FETCH)
} StorePlan;

// A record of the selector, byte for byte as on the medium.  Integers are little-endian.
typedef struct StoreChoice {
    uint8_t number[4];        // the record's sequence number: one more than that of the record before
    uint8_t version;                // of the format of records
    uint8_t active;           // the image that runs: a slot or STORE_BUILT_IN
    uint8_t previous;         // the image that runs again if the trial fails
    uint8_t tries;            // remaining units of a trial, STORE_START for each start
    uint8_t confirmed;        // 1: the active image is not on trial, because a host confirmed it or it is a fallback; 0: on trial
    uint8_t ended;            // why the trial of the image with checksum_previous ended: STORE_STARTS_USED …; 0: no trial has ended
    uint8_t zeros[2];
    uint8_t checksum[4];      // checksum of the active image; a slot whose image has another checksum does not run
    uint8_t checksum_previous[4];  // checksum of the previous image, or of the image whose trial has ended if `ended` is nonzero
    uint8_t newest[4];        // the highest number (image section AUTH) of an image that a board with a key has confirmed
    uint8_t period[2], period_previous[2];    // milliseconds between steps of each image, as set by the host; 0: the board's default
    uint8_t crc[4];           // CRC-32 of all bytes before this field
} StoreChoice;

typedef struct Store {
    PalNvm nvm;
    StorePlan plan;
    SmvmAt record_size, slot_size, slot_at[2];    // bytes of a record and of a slot; offsets of the slots in the memory
    SmvmAt erase;             // erase unit of the memory in bytes, see PalNvmInfo
    uint8_t write, blank;     // write unit of the memory in bytes; value of an erased byte
    StoreChoice choice;       // the newest valid record
    uint8_t running;          // the image that the caller runs: a slot or STORE_BUILT_IN
    // Checks an image's authentication code with the board's key (smvm_auth_check).  Returns whether it is correct; sets *number to the
    // image's number.  NULL: the board has no key.  Set it after smvm_store_open and before smvm_store_boot.
    bool (*is_authentic)(SmvmBytes image, uint32_t *number);
    // The current update.
    uint16_t session;         // the host's number for this update; 0: no update
    uint8_t target;           // the slot that the update writes
    bool is_accepted;         // smvm_store_end has accepted the image
    SmvmAt length, next;      // size of the image; number of bytes written so far
    uint8_t checksum[4];      // checksum of the image, as sent by the host
} Store;

// Opens a store and reads its selector.  Without a valid record, as in a new chip, the built-in image is chosen.  SM_E_SPACE: the memory is
// too small for records and slots.  SM_E_UNSUPPORTED: its write unit is larger than STORE_UNIT, or its units are not powers of two.
SmResult smvm_store_open(Store *s, PalNvm nvm, const StorePlan *plan);

// Decides which image to run; call it once per start.  A trial's count is decremented on the medium before this returns.  An image that
// is damaged is skipped: the previous image runs, or else the built-in one.
SmResult smvm_store_boot(Store *s, uint8_t *slot);

// Reports that the caller cannot run the image that smvm_store_boot returned, for example because one of its pins is in use.  Sets *slot to
// the image to run instead.  If the image is on trial, its trial ends, and *slot is the previous image, or else the built-in one.  A confirmed
// image stays chosen, because other firmware may be able to run it, and *slot is the built-in one.
SmResult smvm_store_skip_image(Store *s, uint8_t *slot);

// Reports that the running image has run for a while: its start counts in full.  Writes a record if the image is on trial and this start has
// not counted in full yet; otherwise does nothing.
SmResult smvm_store_count_start(Store *s);

// Reports that the caller has stopped the image in the slot and runs the built-in one.
void smvm_store_run_built_in(Store *s);

// ---- an update, step by step; each step may be repeated ----

// Whether an update can begin once a slot is free (with one slot: after smvm_store_run_built_in).  SM_E_ARGUMENT: no image is as
// short as `length`.  SM_E_SPACE: `length` is more than a slot has.  SM_E_BUSY: the chosen image is on trial.
SmResult smvm_store_may_begin(const Store *s, SmvmAt length);

// Begins an update; `session` is the host's number for the update, not 0.  A repeated call with the same arguments changes nothing and returns SM_OK.
// SM_E_ARGUMENT: `session` is 0, or `length` is less than that of any image.  SM_E_SPACE: longer than a slot.  SM_E_BUSY: the chosen image is
// on trial and must first be confirmed or erased; or every slot is chosen or running.
SmResult smvm_store_begin(Store *s, uint16_t session, SmvmAt length, uint32_t checksum);

// Writes n bytes at offset `at`: s->next, or less to repeat bytes written before.  `at` must be a multiple of s->write, and n too except at
// the end.  SM_E_HANDLE: no such session.  SM_E_ARGUMENT: these bytes neither continue nor repeat what was written.
SmResult smvm_store_write(Store *s, uint16_t session, SmvmAt at, const uint8_t *bytes, uint8_t n);

// Reads the image back and verifies it in place.  SM_E_HANDLE: no such session.  SM_E_DEVICE: the image differs from what was sent.
// SM_E_ARGUMENT: bytes are missing (then why->rule is 0), or the verifier rejects the image, see *why.  SM_E_UNSIGNED: its
// authentication code is wrong or missing.  SM_E_REPLAY: its number is not above that of a confirmed image.
SmResult smvm_store_end(Store *s, uint16_t session, SmvmVerdict *why);

// Chooses the image that was sent.  From the next start on it is on trial, with `period` milliseconds between steps (0: the board's
// default).  SM_E_HANDLE: smvm_store_end has not accepted it.
SmResult smvm_store_activate(Store *s, uint16_t session, uint16_t period);

// ---- after an update ----

// Confirms the running image, which has this checksum.  SM_E_ARGUMENT: another image is running, or the built-in one.  SM_E_UNSIGNED: the
// slot's contents have changed and no longer have a correct code.
SmResult smvm_store_confirm(Store *s, uint32_t checksum);

// From the next start on, the image with this checksum does not run; the previous or the built-in one does.  SM_E_MISSING: no slot contains
// it.  Any other error: some slots may still contain it, and the caller can try again.
SmResult smvm_store_erase(Store *s, uint32_t checksum);

// ---- queries ----

// Reads an offset or length of three bytes.  Returns false if it exceeds every image on this target.
bool smvm_load_offset(const uint8_t *field, SmvmAt *at);

static inline bool smvm_store_has_key(const Store *s) { return SMVM_STORE_KEY && s->is_authentic; }

typedef enum StoreState { STORE_EMPTY, STORE_INTACT, STORE_TRIAL, STORE_CONFIRMED } StoreState;

uint16_t smvm_store_period(const Store *s, uint8_t slot);      // milliseconds between steps of the slot's image; 0: none was set

StoreState smvm_store_state(const Store *s, uint8_t slot);

// What the record knows about an image that is not chosen, as flags of IMAGE (runtime-c/link/link.def).  STORE_FALLBACK: if it is intact, it runs
// when the chosen image cannot.  STORE_STARTS_USED and STORE_NOT_RUNNABLE: its trial was the last to end, because its starts were used up, or
// because the board could not run it (smvm_store_skip_image).
enum { STORE_FALLBACK = 4, STORE_STARTS_USED = 8, STORE_NOT_RUNNABLE = 16 };
uint8_t smvm_store_flags(const Store *s, uint8_t slot);

#ifdef __cplusplus
}
#endif
#endif
