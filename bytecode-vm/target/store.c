// SPDX-License-Identifier: Apache-2.0
// Implements the store.  Only one kind of write changes which image is chosen: overwriting the older of the two selector records.  All
// writes before that go to memory that the current record does not refer to.
#include "bytecode-vm/target/store.h"

#include <string.h>

#include "bytecode-vm/image.h"
#include "runtime-c/link/link.h"
#include "stdlib/crc32.h"

enum { VERSION = 1, CHECKED = STORE_RECORD - 4 };      // version of the format of records; number of bytes of a record that its CRC covers

typedef char store_choice_is_a_record[sizeof(StoreChoice) == STORE_RECORD ? 1 : -1];

SMVM_NOINLINE static uint32_t load32(const uint8_t *at) { return sm_link_load(at, 4); }
SMVM_NOINLINE static void store32(uint8_t *at, uint32_t value) { sm_link_store(at, value, 4); }

// Reads an offset or length of three bytes.  Returns false if it exceeds every image on this target.
bool smvm_load_offset(const uint8_t *field, SmvmAt *at)
{
    *at = (SmvmAt)sm_link_load(field, sizeof *at < 3 ? 2 : 3);
    return sizeof *at > 2 || field[2] == 0;
}

// ---- the memory ----

// These return the erase unit (0: the memory need not be erased) and the write unit.  They are constants if SMVM_STORE_BYTES is 1.
static SmvmAt erase_unit(const Store *s) { return (SmvmAt)(SMVM_STORE_BYTES ? 0 : s->erase); }
static uint8_t write_unit(const Store *s) { return (uint8_t)(SMVM_STORE_BYTES ? 1 : s->write); }

SMVM_NOINLINE static SmResult write_memory(const Store *s, SmvmAt at, const void *from, uint8_t n) { return pal_nvm_write(s->nvm, at, from, n); }
static SmResult erase_memory(const Store *s, SmvmAt at, SmvmAt n) { return erase_unit(s) ? pal_nvm_erase(s->nvm, at, n) : SM_OK; }

// ---- the selector ----

static bool is_slot(uint8_t slot, const Store *s) { return slot < s->plan.slots || slot == STORE_BUILT_IN; }

static bool is_valid_record(const Store *s, const StoreChoice *c)
{
    return c->version == VERSION && sm_link_crc(c->number, STORE_RECORD) == SM_CRC32_RESIDUE && is_slot(c->active, s) &&
           is_slot(c->previous, s) && c->tries <= STORE_TRIES * STORE_START;
}

// Returns the offset in the memory of the record with this number: even numbers at 0, odd numbers after that.
static SmvmAt record_offset(const Store *s, const uint8_t *number) { return number[0] & 1u ? s->record_size : 0; }

// Sets s->choice to the newest valid record.  Without one, the built-in image is chosen.
static void read_selector(Store *s)
{
    StoreChoice c;
    bool found = false;

    memset(&s->choice, 0, STORE_RECORD);
    s->choice.active = s->choice.previous = STORE_BUILT_IN;
    s->choice.confirmed = 1;
    for (uint8_t i = 0; i < 2; i++)
        if (pal_nvm_read(s->nvm, record_offset(s, &i), &c, STORE_RECORD) == SM_OK && is_valid_record(s, &c) && (c.number[0] & 1u) == i &&
            (!found || (int32_t)(load32(c.number) - load32(s->choice.number)) > 0)) {
            s->choice = c;
            found = true;
        }
}

// Writes s->choice, which the caller has changed, as the next record.  Until the write is complete, the previous record remains the newest
// valid one.  If it fails, s->choice becomes what is on the medium.
SMVM_NOINLINE static SmResult write_choice(Store *s)
{
    StoreChoice *const c = &s->choice;
    SmvmAt at;
    SmResult r;

    store32(c->number, load32(c->number) + 1);
    c->version = VERSION;
    store32(c->crc, sm_link_crc(c->number, CHECKED));
    at = record_offset(s, c->number);
    r = erase_memory(s, at, s->record_size);
    if (r == SM_OK)
        r = write_memory(s, at, c, STORE_RECORD);
    if (r != SM_OK)
        read_selector(s);
    return r;
}

// ---- layout ----

static bool is_power_of_two(uint32_t unit) { return (unit & (unit - 1)) == 0; }  // also true for 0

static SmvmAt slot_unit(const Store *s) { return erase_unit(s) ? erase_unit(s) : write_unit(s); }

static SmvmAt round_up(SmvmAt n, SmvmAt unit) { return (SmvmAt)((n + unit - 1u) & ~(unit - 1u)); }

static SmResult lay_out_slots(Store *s)
{
    const SmvmAt unit = slot_unit(s), size = (SmvmAt)s->plan.size;
    SmvmAt records;

    s->record_size = round_up(STORE_RECORD, unit);
    records = (SmvmAt)(2 * s->record_size);
    if (size < records)
        return SM_E_SPACE;
    s->slot_size = (SmvmAt)((size - records) >> (s->plan.slots - 1) & ~(unit - 1u));
    s->slot_at[0] = records;
    s->slot_at[1] = (SmvmAt)(records + s->slot_size);
    return s->slot_size >= SMVM_HEADER ? SM_OK : SM_E_SPACE;
}

static SmResult check_memory(Store *s)
{
    PalNvmInfo info;
    const SmResult r = pal_nvm_info(s->nvm, &info);

    if (r != SM_OK)
        return r;
    if (SMVM_STORE_BYTES ? info.write > 1 || info.erase > 0 : info.write > STORE_UNIT || !is_power_of_two(info.write) || !is_power_of_two(info.erase))
        return SM_E_UNSUPPORTED;
    if (s->plan.size > info.size || (SmvmAt)s->plan.size != s->plan.size || info.erase > s->plan.size)
        return SM_E_SPACE;
    s->write = info.write > 1 ? (uint8_t)info.write : 1;
    s->erase = (SmvmAt)info.erase;
    s->blank = info.blank;
    return lay_out_slots(s);
}

// Opens a store and reads its selector.  Without a valid record, as in a new chip, the built-in image is chosen.
SmResult smvm_store_open(Store *s, PalNvm nvm, const StorePlan *plan)
{
    SmResult r;

    if (!s || !plan || plan->slots < 1 || plan->slots > 2)
        return SM_E_ARGUMENT;
    memset(s, 0, sizeof *s);
    s->nvm = nvm;
    s->plan = *plan;
    s->running = STORE_BUILT_IN;
    if ((r = check_memory(s)) == SM_OK)
        read_selector(s);
    return r;
}

// ---- contents of slots ----

// Returns the length field of the image in a slot; 0: the slot cannot contain an image.
SMVM_NOINLINE static SmvmAt image_length(const Store *s, uint8_t slot)
{
    SmvmAt length;

    if (slot >= s->plan.slots || smvm_u24(s->plan.image[slot], 0) != SMVM_MAGIC)
        return 0;
    length = smvm_read_offset(s->plan.image[slot], SMVM_LENGTH_AT, 3);
    return length >= SMVM_HEADER && length <= s->slot_size ? length : 0;
}

SMVM_NOINLINE static uint32_t image_checksum(const Store *s, uint8_t slot) { return smvm_uint(s->plan.image[slot], SMVM_CRC_AT, 4); }

// Whether the image in a slot, which the verifier accepts, has a correct authentication code; sets *number to its number.  Without a key:
// true, and the number 0.  Also called at every start, because a checksum can be forged.
static bool authenticate(const Store *s, uint8_t slot, uint32_t *number)
{
    *number = 0;
    return !smvm_store_has_key(s) || s->is_authentic(s->plan.image[slot], number);
}

static bool is_intact(const Store *s, uint8_t slot)
{
    const SmvmAt length = image_length(s, slot);
    SmvmVerdict why;
    uint32_t number;

    return length != 0 && smvm_verify(s->plan.image[slot], length, &why) == 0 && authenticate(s, slot, &number);
}

static bool has_image(const Store *s, uint8_t slot, const uint8_t *checksum)
{
    return is_intact(s, slot) && image_checksum(s, slot) == load32(checksum);
}

StoreState smvm_store_state(const Store *s, uint8_t slot)
{
    if (!is_intact(s, slot))
        return STORE_EMPTY;
    if (slot != s->choice.active || image_checksum(s, slot) != load32(s->choice.checksum))
        return STORE_INTACT;
    return s->choice.confirmed ? STORE_CONFIRMED : STORE_TRIAL;
}

uint8_t smvm_store_flags(const Store *s, uint8_t slot)
{
    if (slot >= s->plan.slots || image_checksum(s, slot) != load32(s->choice.checksum_previous))
        return 0;
    // `ended` is nonzero only if there is no previous image
    return slot == s->choice.previous && s->plan.slots > 1 ? STORE_FALLBACK : s->choice.ended;
}

// Returns the milliseconds between steps of a slot's image; 0: none was set.
uint16_t smvm_store_period(const Store *s, uint8_t slot)
{
    const uint8_t *period = slot == s->choice.active ? s->choice.period : slot == s->choice.previous ? s->choice.period_previous : NULL;

    return period && slot != STORE_BUILT_IN ? (uint16_t)sm_link_load(period, 2) : 0;
}

// ---- starting ----

// Whether the previous image can still run. With one slot it cannot: an update has overwritten it. If the slot's image has the checksum of the
// previous image, that image has been sent again, but is not accepted yet.
static bool has_previous(const Store *s)
{
    return s->plan.slots > 1 && s->choice.previous != STORE_BUILT_IN && has_image(s, s->choice.previous, s->choice.checksum_previous);
}

// Chooses the image that runs instead of the active one, and sets *slot to it: the previous image if `there`, else the built-in one.  `end`: why
// the trial of the active image ended, if it is on trial.  (A confirmed image that does not start is damaged, and no longer listed.)  Callers
// compute `there` with has_previous, and this function is not inlined, so that the verifier and a record are not on the stack at the same time.
SMVM_NOINLINE static SmResult fall_back(Store *s, bool there, uint8_t end, uint8_t *slot)
{
    StoreChoice *const c = &s->choice;

    c->active = there ? c->previous : STORE_BUILT_IN;
    for (uint8_t i = 0; i < 4; i++) {
        const uint8_t ended = c->checksum[i];
        c->checksum[i] = c->checksum_previous[i];
        c->checksum_previous[i] = ended;
    }
    memcpy(c->period, c->period_previous, 2);
    c->previous = STORE_BUILT_IN;
    c->tries = 0;
    c->confirmed = 1;
    c->ended = end;
    *slot = c->active;
    return write_choice(s);
}

// Returns whether the active image may run now.  For an image on trial, first writes its decremented count to the medium.  If that write
// fails, the image must not run: its trial might never end.
static bool try_start_active(Store *s)
{
    StoreChoice *const c = &s->choice;

    if (c->active == STORE_BUILT_IN)
        return true;
    if (!has_image(s, c->active, c->checksum))
        return false;
    if (c->confirmed)
        return true;
    if (c->tries == 0)
        return false;
    c->tries--;
    return write_choice(s) == SM_OK;
}

// Decides which image to run; call it once per start.  A trial's count is decremented on the medium before this returns.
SmResult smvm_store_boot(Store *s, uint8_t *slot)
{
    SmResult r = SM_OK;

    if (!s || !slot)
        return SM_E_ARGUMENT;
    if (try_start_active(s))
        *slot = s->choice.active;
    else
        r = fall_back(s, has_previous(s), STORE_STARTS_USED, slot);  // the image runs even if this choice could not be written
    s->running = *slot;
    return r;
}

// Reports that the caller cannot run the image that smvm_store_boot returned, for example because one of its pins is in use.
SmResult smvm_store_skip_image(Store *s, uint8_t *slot)
{
    SmResult r = SM_OK;

    *slot = STORE_BUILT_IN;
    if (!s->choice.confirmed)
        r = fall_back(s, has_previous(s), STORE_NOT_RUNNABLE, slot);
    s->running = *slot;
    return r;
}

// Reports that the running image has run for a while: its start counts in full.
SmResult smvm_store_count_start(Store *s)
{
    if (s->choice.tries % STORE_START == 0)
        return SM_OK;
    s->choice.tries &= (uint8_t)~(STORE_START - 1u);
    return write_choice(s);
}

// Records that the caller runs the built-in image: it has stopped the one in the slot, or runs none.
void smvm_store_run_built_in(Store *s) { s->running = STORE_BUILT_IN; }

// ---- an update ----

static bool is_on_trial(const Store *s) { return s->choice.active != STORE_BUILT_IN && !s->choice.confirmed; }

// Finds a slot for an update, which is neither chosen nor running.  If the memory has only one slot, it may be chosen, but not running.  (The
// choice includes the image's checksum, so a partly overwritten image never runs.)
static bool find_target(const Store *s, uint8_t *target)
{
    for (uint8_t i = 0; i < s->plan.slots; i++)
        if (i != s->running && (i != s->choice.active || s->plan.slots == 1)) {
            *target = i;
            return true;
        }
    return false;
}

// Whether an update can begin once a slot is free (with one slot: after smvm_store_run_built_in).
SmResult smvm_store_may_begin(const Store *s, SmvmAt length)
{
    return length < SMVM_HEADER ? SM_E_ARGUMENT : length > s->slot_size ? SM_E_SPACE : is_on_trial(s) ? SM_E_BUSY : SM_OK;
}

// Removes the previous image from the record, so that the built-in image runs if the chosen one cannot.
SMVM_NOINLINE static SmResult forget_previous(Store *s)
{
    s->choice.previous = STORE_BUILT_IN;
    return write_choice(s);
}

// Begins an update; `session` is the host's number for the update, not 0.
SmResult smvm_store_begin(Store *s, uint16_t session, SmvmAt length, uint32_t checksum)
{
    SmResult r;

    if (session == 0)
        return SM_E_ARGUMENT;
    if (session == s->session && length == s->length && checksum == load32(s->checksum))
        return SM_OK;
    if ((r = smvm_store_may_begin(s, length)) != SM_OK)
        return r;
    s->session = 0;
    if (!find_target(s, &s->target))
        return SM_E_BUSY;
    s->length = length;
    store32(s->checksum, checksum);
    s->next = 0;
    s->is_accepted = false;
    // With a key, never fall back to a slot that has been overwritten: a replayed old image would run without its number being checked.
    r = smvm_store_has_key(s) && s->target == s->choice.previous ? forget_previous(s) : SM_OK;
    if (r == SM_OK)
        r = erase_memory(s, s->slot_at[s->target], round_up(s->length, slot_unit(s)));
    if (r == SM_OK)
        s->session = session;
    return r;
}

// Whether the target slot contains these n bytes at offset `at`.
static bool has_bytes_at(const Store *s, SmvmAt at, const uint8_t *bytes, uint8_t n)
{
    for (; n > 0; n--)
        if (smvm_u8(s->plan.image[s->target], at++) != *bytes++)
            return false;
    return true;
}

// Writes n bytes: first the whole write units, then the rest, padded to a write unit with the value of an erased byte.
SMVM_NOINLINE static SmResult write_padded(const Store *s, SmvmAt to, const uint8_t *bytes, uint8_t n)
{
    const uint8_t rest = n & (uint8_t)(write_unit(s) - 1), whole = (uint8_t)(n - rest);
    uint8_t last[STORE_UNIT];
    SmResult r = whole ? write_memory(s, to, bytes, whole) : SM_OK;

    if (r != SM_OK || rest == 0)
        return r;
    memset(last, s->blank, sizeof last);
    memcpy(last, bytes + whole, rest);
    return write_memory(s, (SmvmAt)(to + whole), last, write_unit(s));
}

// Whether n bytes at `at`, which is at most s->next, either continue the data written so far or are inside it.  Requires whole units except
// at the image's end.
static bool is_valid_chunk(const Store *s, SmvmAt at, uint8_t n)
{
    const uint8_t rest = (uint8_t)(write_unit(s) - 1);
    const SmvmAt left = (SmvmAt)(s->length - at);

    return n != 0 && n <= left && ((uint8_t)at & rest) == 0 && ((n & rest) == 0 || n == left) &&
           (at == s->next || n <= s->next - at);
}

static bool is_current_session(const Store *s, uint16_t session) { return session != 0 && session == s->session; }

// Writes n bytes at offset `at`: s->next, or less to repeat bytes written before.  `at` must be a multiple of s->write, and n too except at
// the end.
SmResult smvm_store_write(Store *s, uint16_t session, SmvmAt at, const uint8_t *bytes, uint8_t n)
{
    const bool again = at < s->next;
    bool there;

    if (!is_current_session(s, session))
        return SM_E_HANDLE;
    if (at > s->next || !is_valid_chunk(s, at, n))
        return SM_E_ARGUMENT;
    there = (again || !erase_unit(s)) && has_bytes_at(s, at, bytes, n);
    if (again)
        return there ? SM_OK : SM_E_ARGUMENT;
    if (!there) {
        const SmResult r = write_padded(s, (SmvmAt)(s->slot_at[s->target] + at), bytes, n);
        if (r != SM_OK) {
            s->session = 0;            // the slot's contents are unknown now
            return r;
        }
    }
    s->next = (SmvmAt)(s->next + n);
    return SM_OK;
}

// Whether the image comes from an owner of the key and is newer than all confirmed ones.
static SmResult check_authenticity(const Store *s)
{
    uint32_t number;

    if (!authenticate(s, s->target, &number))
        return SM_E_UNSIGNED;
    return smvm_store_has_key(s) && number <= load32(s->choice.newest) ? SM_E_REPLAY : SM_OK;
}

// Reads the image back and verifies it in place.  SM_E_DEVICE: the image differs from what was sent. *why: why the verifier rejects the image.
SmResult smvm_store_end(Store *s, uint16_t session, SmvmVerdict *why)
{
    SmResult r;

    why->rule = 0;
    why->at = 0;
    if (!is_current_session(s, session))
        return SM_E_HANDLE;
    if (s->next != s->length)
        return SM_E_ARGUMENT;
    if (image_length(s, s->target) != s->length || image_checksum(s, s->target) != load32(s->checksum))
        return SM_E_DEVICE;
    r = smvm_verify(s->plan.image[s->target], s->length, why) == 0 ? check_authenticity(s) : SM_E_ARGUMENT;
    s->is_accepted = r == SM_OK;
    return r;
}

// Chooses the image that was sent.  From the next start on it is on trial, with `period` milliseconds between steps.  A repeated
// request changes nothing.
SmResult smvm_store_activate(Store *s, uint16_t session, uint16_t period)
{
    StoreChoice *const c = &s->choice;

    if (!is_current_session(s, session) || !s->is_accepted)
        return SM_E_HANDLE;
    if (c->active != s->target || memcmp(c->checksum, s->checksum, 4) != 0) {
        c->previous = c->active;
        memcpy(c->checksum_previous, c->checksum, 4);
        memcpy(c->period_previous, c->period, 2);
    } else if (sm_link_load(c->period, 2) == period) {
        return SM_OK;                  // a repeated request: the answer was lost.  The image may already be confirmed
    }
    c->active = s->target;
    sm_link_store(c->period, period, 2);
    memcpy(c->checksum, s->checksum, 4);
    c->tries = STORE_TRIES * STORE_START;
    c->confirmed = c->ended = 0;
    return write_choice(s);
}

// ---- after an update ----

// Confirms the running image, which has this checksum.
SmResult smvm_store_confirm(Store *s, uint32_t checksum)
{
    StoreChoice *const c = &s->choice;
    uint32_t number;

    if (c->active == STORE_BUILT_IN || c->active != s->running || load32(c->checksum) != checksum)
        return SM_E_ARGUMENT;
    if (c->confirmed)
        return SM_OK;
    if (!authenticate(s, c->active, &number))
        return SM_E_UNSIGNED;          // the slot has changed since it was chosen
    if (smvm_store_has_key(s) && number > load32(c->newest))
        store32(c->newest, number);
    c->confirmed = 1;
    c->tries = 0;
    return write_choice(s);
}

// Overwrites or erases the beginning of a slot, so that it contains no image.  Does nothing if the slot is running.
static SmResult destroy_image(const Store *s, uint8_t slot)
{
    uint8_t nothing[SMVM_STORE_BYTES ? 4 : STORE_UNIT];

    if (slot == s->running)
        return SM_OK;
    if (erase_unit(s))
        return erase_memory(s, s->slot_at[slot], erase_unit(s));
    memset(nothing, s->blank, sizeof nothing);
    return write_memory(s, s->slot_at[slot], nothing, write_unit(s) > 4 ? write_unit(s) : 4);
}

// Makes sure that the image in a slot never runs again: removes it from the selector, then destroys it.
static SmResult remove_image(Store *s, uint8_t slot)
{
    SmResult r = SM_OK;
    uint8_t instead;

    if (slot == s->choice.active)
        r = fall_back(s, has_previous(s), 0, &instead);
    else if (slot == s->choice.previous)
        r = forget_previous(s);
    return r == SM_OK ? destroy_image(s, slot) : r;
}

// From the next start on, the image with this checksum does not run; the previous or the built-in one does.
SmResult smvm_store_erase(Store *s, uint32_t checksum)
{
    SmResult r = SM_E_MISSING;

    s->session = 0;
    for (uint8_t i = 0; i < s->plan.slots; i++)
        if (image_length(s, i) != 0 && image_checksum(s, i) == checksum && (r = remove_image(s, i)) != SM_OK)
            break;
    return r;
}
