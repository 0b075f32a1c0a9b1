// SPDX-License-Identifier: Apache-2.0
// Selector records and slots.  What is chosen changes by one write of the older record; everything before it touches only what is not chosen.
// A record is little-endian, with a CRC-32 behind it:
//   u32 number, u8 version, u8 active, u8 before, u8 tries, u8 confirmed, 3 zeros, u32 checksum, u32 checksum before, u32 newest, u32 CRC
#include "bytecode-vm/target/store.h"

#include <string.h>

#include "bytecode-vm/image.h"
#include "stdlib/crc32.h"

enum { VERSION = 1, CRC_AT = STORE_RECORD - 4, HEADER = 11 };

// ---- bytes ----

static void put32(uint8_t *at, uint32_t value)
{
    for (unsigned i = 0; i < 4; i++)
        at[i] = (uint8_t)(value >> 8 * i);
}

static uint32_t get(const uint8_t *at, unsigned bytes)
{
    uint32_t value = 0;

    while (bytes-- > 0)
        value = value << 8 | at[bytes];
    return value;
}

static uint32_t round_up(uint32_t n, uint32_t unit) { return unit > 1 ? (n + unit - 1) / unit * unit : n; }

// ---- the selector ----

static void write_record(uint8_t *r, const StoreChoice *c)
{
    memset(r, 0, STORE_RECORD);
    put32(r, c->number);
    r[4] = VERSION;
    r[5] = c->active;
    r[6] = c->before;
    r[7] = c->tries;
    r[8] = c->confirmed;
    put32(r + 12, c->checksum);
    put32(r + 16, c->checksum_before);
    put32(r + 20, c->newest);
    put32(r + CRC_AT, sm_crc32(r, CRC_AT));
}

static bool is_choice(uint8_t slot, const Store *s) { return slot < s->plan.slots || slot == STORE_BUILT_IN; }

static bool read_record(const Store *s, const uint8_t *r, StoreChoice *c)
{
    if (get(r + CRC_AT, 4) != sm_crc32(r, CRC_AT) || r[4] != VERSION || !is_choice(r[5], s) || !is_choice(r[6], s) || r[7] > STORE_TRIES)
        return false;
    c->number = get(r, 4);
    c->active = r[5];
    c->before = r[6];
    c->tries = r[7];
    c->confirmed = r[8] != 0;
    c->checksum = get(r + 12, 4);
    c->checksum_before = get(r + 16, 4);
    c->newest = get(r + 20, 4);
    return true;
}

// Where the record of a number stands: they take turns.
static uint32_t record_at(const Store *s, uint32_t number) { return (number & 1u) * s->record_size; }

static void read_selector(Store *s)
{
    uint8_t bytes[STORE_RECORD];
    StoreChoice c;
    bool found = false;

    for (uint32_t i = 0; i < 2; i++)
        if (pal_nvm_read(s->nvm, record_at(s, i), bytes, STORE_RECORD) == SM_OK && read_record(s, bytes, &c) && (c.number & 1u) == i &&
            (!found || (int32_t)(c.number - s->now.number) > 0)) {
            s->now = c;
            found = true;
        }
}

// Makes a choice last.  Until the write is done the choice before counts.
static SmResult choose(Store *s, StoreChoice c)
{
    uint8_t bytes[STORE_RECORD];
    uint32_t at;
    SmResult r = SM_OK;

    c.number = s->now.number + 1;
    at = record_at(s, c.number);
    write_record(bytes, &c);
    if (s->info.erase)
        r = pal_nvm_erase(s->nvm, at, s->record_size);
    if (r == SM_OK)
        r = pal_nvm_write(s->nvm, at, bytes, STORE_RECORD);
    if (r == SM_OK)
        s->now = c;
    return r;
}

static SmResult place_slots(Store *s)
{
    const uint32_t unit = s->info.erase ? s->info.erase : s->info.write ? s->info.write : 1;

    s->record_size = round_up(STORE_RECORD, unit);
    if (s->plan.size > s->info.size || s->plan.size < 2 * s->record_size)
        return SM_E_SPACE;
    s->slot_size = (s->plan.size - 2 * s->record_size) / s->plan.slots / unit * unit;
    for (uint8_t i = 0; i < s->plan.slots; i++)
        s->slot_at[i] = 2 * s->record_size + i * s->slot_size;
    return s->slot_size > HEADER ? SM_OK : SM_E_SPACE;
}

SmResult store_open(Store *s, PalNvm nvm, const StorePlan *plan)
{
    SmResult r;

    if (!s || !plan || plan->slots < 1 || plan->slots > 2)
        return SM_E_ARGUMENT;
    memset(s, 0, sizeof *s);
    s->nvm = nvm;
    s->plan = *plan;
    s->now.active = s->now.before = s->running = STORE_BUILT_IN;
    s->now.confirmed = true;
    r = pal_nvm_info(nvm, &s->info);
    if (r == SM_OK && (s->info.write > STORE_UNIT || STORE_RECORD % (s->info.write ? s->info.write : 1) != 0))
        r = SM_E_UNSUPPORTED;
    if (r == SM_OK)
        r = place_slots(s);
    if (r == SM_OK)
        read_selector(s);
    return r;
}

// ---- what slots hold ----

// The checksum and length that the image in a slot says it has.  False: it says nothing that could be.
static bool read_header(const Store *s, uint8_t slot, uint32_t *checksum, uint32_t *length)
{
    uint8_t head[HEADER];

    if (slot >= s->plan.slots || pal_nvm_read(s->nvm, s->slot_at[slot], head, HEADER) != SM_OK || memcmp(head, "smb", 3) != 0)
        return false;
    *checksum = get(head + SMVM_CRC_AT, 4);
    *length = get(head + 8, 3);
    return *length >= HEADER && *length <= s->slot_size;
}

static bool is_whole(const Store *s, uint8_t slot, uint32_t *checksum, uint32_t *length)
{
    SmvmVerdict why;

    return read_header(s, slot, checksum, length) && smvm_verify(s->plan.image[slot], *length, &why) == 0;
}

static bool holds(const Store *s, uint8_t slot, uint32_t wanted)
{
    uint32_t checksum, length;

    return is_whole(s, slot, &checksum, &length) && checksum == wanted;
}

StoreState store_state(const Store *s, uint8_t slot, uint32_t *checksum, uint32_t *length)
{
    *checksum = *length = 0;
    if (!is_whole(s, slot, checksum, length))
        return STORE_EMPTY;
    if (slot != s->now.active || *checksum != s->now.checksum)
        return STORE_WHOLE;
    return s->now.confirmed ? STORE_CONFIRMED : STORE_TRIAL;
}

// ---- starting ----

// What runs when the active image is not to be run: the one before it, if it is what it was.
static StoreChoice step_back(const Store *s)
{
    StoreChoice c = s->now;
    const bool there = c.before != STORE_BUILT_IN && holds(s, c.before, c.checksum_before);

    c.active = there ? c.before : STORE_BUILT_IN;
    c.checksum = there ? c.checksum_before : 0;
    c.before = STORE_BUILT_IN;
    c.checksum_before = 0;
    c.tries = 0;
    c.confirmed = true;
    return c;
}

// Whether the active image may run now.  A trial is counted first: what cannot be counted is not run, or it might be run for ever.
static bool may_run(Store *s)
{
    StoreChoice c = s->now;

    if (c.active == STORE_BUILT_IN)
        return true;
    if (!holds(s, c.active, c.checksum))
        return false;
    if (c.confirmed)
        return true;
    if (c.tries == 0)
        return false;
    c.tries--;
    return choose(s, c) == SM_OK;
}

SmResult store_boot(Store *s, uint8_t *slot)
{
    SmResult r = SM_OK;

    if (!s || !slot)
        return SM_E_ARGUMENT;
    if (may_run(s)) {
        s->running = s->now.active;
    } else {
        const StoreChoice c = step_back(s);
        r = choose(s, c);
        s->running = c.active;         // even where that could not be written down
    }
    *slot = s->running;
    return r;
}

void store_leave(Store *s) { s->running = STORE_BUILT_IN; }

// ---- an update ----

static bool on_trial(const Store *s) { return s->now.active != STORE_BUILT_IN && !s->now.confirmed; }

// A slot that is neither chosen nor running; with one slot, that one, once it does not run.  (What is chosen by its checksum is not
// run any more as soon as the first byte of it has changed.)
static bool find_target(const Store *s, uint8_t *target)
{
    for (uint8_t i = 0; i < s->plan.slots; i++)
        if (i != s->running && (i != s->now.active || s->plan.slots == 1)) {
            *target = i;
            return true;
        }
    return false;
}

static bool is_same_update(const Store *s, uint16_t session, uint32_t length, uint32_t checksum)
{
    return session == s->session && length == s->length && checksum == s->checksum;
}

SmResult store_may_begin(const Store *s, uint32_t length)
{
    return length < HEADER ? SM_E_ARGUMENT : length > s->slot_size ? SM_E_SPACE : on_trial(s) ? SM_E_BUSY : SM_OK;
}

SmResult store_begin(Store *s, uint16_t session, uint32_t length, uint32_t checksum)
{
    SmResult r;

    if (session == 0)
        return SM_E_ARGUMENT;
    if (is_same_update(s, session, length, checksum))
        return SM_OK;
    if ((r = store_may_begin(s, length)) != SM_OK)
        return r;
    s->session = 0;
    if (!find_target(s, &s->target))
        return SM_E_BUSY;
    if (s->info.erase && (r = pal_nvm_erase(s->nvm, s->slot_at[s->target], round_up(length, s->info.erase))) != SM_OK)
        return r;
    s->session = session;
    s->length = length;
    s->checksum = checksum;
    s->next = 0;
    s->whole = false;
    return SM_OK;
}

static bool is_there(const Store *s, uint32_t at, const uint8_t *bytes, uint8_t n)
{
    uint8_t there[STORE_UNIT];

    for (uint8_t done = 0; done < n;) {
        const uint8_t part = (uint8_t)(n - done < STORE_UNIT ? n - done : STORE_UNIT);
        if (pal_nvm_read(s->nvm, s->slot_at[s->target] + at + done, there, part) != SM_OK || memcmp(there, bytes + done, part) != 0)
            return false;
        done = (uint8_t)(done + part);
    }
    return true;
}

// Whole units at once, and what is left padded with blanks.
static SmResult write_padded(Store *s, uint32_t at, const uint8_t *bytes, uint8_t n)
{
    const uint32_t unit = s->info.write ? s->info.write : 1, place = s->slot_at[s->target] + at;
    const uint8_t rest = (uint8_t)(n % unit), whole = (uint8_t)(n - rest);
    uint8_t last[STORE_UNIT];
    SmResult r = whole ? pal_nvm_write(s->nvm, place, bytes, whole) : SM_OK;

    if (r != SM_OK || rest == 0)
        return r;
    memset(last, s->info.blank, sizeof last);
    memcpy(last, bytes + whole, rest);
    return pal_nvm_write(s->nvm, place + whole, last, unit);
}

SmResult store_write(Store *s, uint16_t session, uint32_t at, const uint8_t *bytes, uint8_t n)
{
    const uint32_t unit = s->info.write ? s->info.write : 1;
    SmResult r;

    if (session == 0 || session != s->session)
        return SM_E_HANDLE;
    if (n == 0 || at > s->next || at > s->length || n > s->length - at || at % unit != 0 || (n % unit != 0 && at + n != s->length))
        return SM_E_ARGUMENT;
    if (at < s->next)
        return at + n <= s->next && is_there(s, at, bytes, n) ? SM_OK : SM_E_ARGUMENT;
    r = !s->info.erase && is_there(s, at, bytes, n) ? SM_OK : write_padded(s, at, bytes, n);
    if (r == SM_OK)
        s->next = at + n;
    else
        s->session = 0;                // what is there now is not known
    return r;
}

SmResult store_end(Store *s, uint16_t session, SmvmVerdict *why)
{
    uint32_t checksum, length;

    memset(why, 0, sizeof *why);
    if (session == 0 || session != s->session)
        return SM_E_HANDLE;
    if (s->next != s->length)
        return SM_E_ARGUMENT;
    if (!read_header(s, s->target, &checksum, &length) || checksum != s->checksum || length != s->length)
        return SM_E_DEVICE;
    s->whole = smvm_verify(s->plan.image[s->target], s->length, why) == 0;
    return s->whole ? SM_OK : SM_E_ARGUMENT;
}

SmResult store_activate(Store *s, uint16_t session)
{
    StoreChoice c = s->now;

    if (session == 0 || session != s->session || !s->whole)
        return SM_E_HANDLE;
    if (c.active == s->target && c.checksum == s->checksum && !c.confirmed)
        return SM_OK;                  // the answer was lost
    c.before = c.active;
    c.checksum_before = c.checksum;
    c.active = s->target;
    c.checksum = s->checksum;
    c.tries = STORE_TRIES;
    c.confirmed = false;
    return choose(s, c);
}

// ---- afterwards ----

SmResult store_confirm(Store *s, uint32_t checksum)
{
    StoreChoice c = s->now;

    if (c.active == STORE_BUILT_IN || c.active != s->running || c.checksum != checksum)
        return SM_E_ARGUMENT;
    if (c.confirmed)
        return SM_OK;
    c.confirmed = true;
    c.tries = 0;
    return choose(s, c);
}

// Makes what a slot holds no image; what is running is left as it is.
static SmResult blank(Store *s, uint8_t slot)
{
    uint8_t nothing[STORE_UNIT];
    const uint32_t unit = s->info.write > 4 ? s->info.write : 4;

    if (slot == s->running)
        return SM_OK;
    if (s->info.erase)
        return pal_nvm_erase(s->nvm, s->slot_at[slot], s->info.erase);
    memset(nothing, s->info.blank, sizeof nothing);
    return pal_nvm_write(s->nvm, s->slot_at[slot], nothing, unit);
}

static SmResult forget(Store *s, uint8_t slot)
{
    StoreChoice c = s->now;
    SmResult r = SM_OK;

    if (slot == c.active) {
        r = choose(s, step_back(s));
    } else if (slot == c.before) {
        c.before = STORE_BUILT_IN;
        c.checksum_before = 0;
        r = choose(s, c);
    }
    return r == SM_OK ? blank(s, slot) : r;
}

SmResult store_erase(Store *s, uint32_t checksum)
{
    uint32_t there, length;
    SmResult r = SM_E_MISSING;

    s->session = 0;
    for (uint8_t i = 0; i < s->plan.slots; i++)
        if (read_header(s, i, &there, &length) && there == checksum)
            r = forget(s, i);
    return r;
}
