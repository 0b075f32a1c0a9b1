// SPDX-License-Identifier: Apache-2.0
// A slot consists of: a sequence number, the layout's hash, the length of the packed vector, a CRC-32 over these three and the
// vector, and the packed vector.  Numbers are little-endian.  Even sequence numbers use the first slot and odd ones the second, so
// a write never overwrites the newest slot.
#include "runtime-c/keep.h"

#include <string.h>

#include "runtime-c/handover.h"
#include "runtime-c/log_block.h"

enum { SLOT_HASH = 4, SLOT_LENGTH = 8, SLOT_CHECKSUM = 12 };   // offsets in a slot; the sequence number is at offset 0

static uint32_t packed_size(const SmKeep *k) { return k->sv->layout->whole.packed; }
static uint32_t slot_size(const SmKeep *k) { return SM_KEEP_SIZE(packed_size(k)); }
// Half 1 or 2 of the buffer.  Each has room for one slot.
static uint8_t *buffer_half(const SmKeep *k, uint8_t n) { return k->buffer + (n - 1u) * slot_size(k); }

// Returns the CRC of a slot without the CRC's own field.
static uint32_t slot_crc(const SmKeep *k, const uint8_t *slot)
{
    return sm_crc32_end(log_crc_update(log_crc_update(SM_CRC32_START, slot, SLOT_CHECKSUM), slot + SM_KEEP_HEAD, packed_size(k)));
}

// ---- restoring ----

static uint32_t round_up(uint32_t n, uint32_t unit) { return unit > 1 ? (n + unit - 1) / unit * unit : n; }

// Determines the distance between the slots in this memory.
static SmResult compute_slot_distance(SmKeep *k)
{
    PalNvmInfo info;
    SmResult r = pal_nvm_info(k->nvm, &info);

    if (r != SM_OK)
        return r;
    if (info.write == 0 || SM_KEEP_UNIT % info.write != 0)
        return SM_E_UNSUPPORTED;
    k->slot = round_up(slot_size(k), info.erase);
    return k->slot <= info.size / 2 ? SM_OK : SM_E_SPACE;
}

// ---- recognising the content ----

// A memory with content of another program must never be written.  A memory with a saved vector has at least one recognisable
// head: a power cut can damage the slot that was being written, but not the other one.  A single bit flip in a head cannot change
// both its hash and its length.

// Reads the head at `at`; bytes beyond the end of the memory read as `blank`.  Returns false if the memory cannot be read.
static bool read_head(const SmKeep *k, const PalNvmInfo *info, uint32_t at, uint8_t head[SM_KEEP_HEAD])
{
    const uint32_t there = at < info->size ? info->size - at : 0;

    memset(head, info->blank, SM_KEEP_HEAD);
    return pal_nvm_read(k->nvm, there ? at : 0, head, there < SM_KEEP_HEAD ? there : SM_KEEP_HEAD) == SM_OK;
}

// Whether all n bytes have the value of erased memory.
static bool is_blank(const uint8_t *bytes, uint32_t n, uint8_t blank)
{
    while (n > 0 && bytes[n - 1] == blank)
        n--;
    return n == 0;
}

// Whether the hash or the length in a slot's head is that of the vector's layout.  One damaged field is tolerated.
static bool matches_layout(const SmKeep *k, const uint8_t *head)
{
    return log_get32(head + SLOT_HASH) == k->sv->layout->hash || log_get32(head + SLOT_LENGTH) == packed_size(k);
}

// Whether the memory begins with an intact slot of any layout.
static bool begins_with_intact_slot(const SmKeep *k, const PalNvmInfo *info, const uint8_t *head)
{
    const uint32_t n = log_get32(head + SLOT_LENGTH);
    uint32_t crc = log_crc_update(SM_CRC32_START, head, SLOT_CHECKSUM);
    uint8_t piece[SM_KEEP_HEAD];

    if (info->size < SM_KEEP_HEAD || n > info->size - SM_KEEP_HEAD)
        return false;
    for (uint32_t at = 0; at < n; at += SM_KEEP_HEAD) {
        if (!read_head(k, info, SM_KEEP_HEAD + at, piece))
            return false;
        crc = log_crc_update(crc, piece, n - at < SM_KEEP_HEAD ? n - at : SM_KEEP_HEAD);
    }
    return n > 0 && log_get32(head + SLOT_CHECKSUM) == sm_crc32_end(crc);
}

// Whether the memory contains a saved vector or is blank, so that it may be written.  It counts as blank if the number and the hash of
// the first slot are blank: a power cut may have interrupted an erase after these.
static bool is_ours_or_blank(const SmKeep *k, const PalNvmInfo *info)
{
    uint8_t first[SM_KEEP_HEAD], second[SM_KEEP_HEAD];

    if (!read_head(k, info, 0, first) || !read_head(k, info, round_up(slot_size(k), info->erase), second))
        return true;                                      // the medium cannot be read now, so the content is unknown
    return is_blank(first, SLOT_LENGTH, info->blank) || matches_layout(k, first) || matches_layout(k, second) ||
        begins_with_intact_slot(k, info, first) ||
        (info->erase != 0 && is_blank(second, SM_KEEP_HEAD, info->blank));        // an interrupted erase leaves the first slot undefined
}

// ---- opening ----

// Opens the memory without extending it, and checks its content.  If it is too small for two slots, sets *fits to false and closes
// it.
static SmResult open_at_current_size(SmKeep *k, bool *fits)
{
    PalNvmInfo info;
    SmResult r = pal_nvm_open(&k->nvm, k->memory, 1);

    if (r != SM_OK)
        return r;
    r = pal_nvm_info(k->nvm, &info);
    if (r == SM_OK && !is_ours_or_blank(k, &info))
        r = SM_E_FOREIGN;
    *fits = r == SM_OK && info.size >= 2 * slot_size(k);
    if (!*fits)
        (void)pal_nvm_close(k->nvm);
    return r;
}

static SmResult open_memory(SmKeep *k)
{
    bool fits = false;
    SmResult r = open_at_current_size(k, &fits);

    if (r == SM_OK && !fits)
        r = pal_nvm_open(&k->nvm, k->memory, 2 * slot_size(k));
    if (r != SM_OK) {
        k->nvm.id = 0;
        return r;
    }
    r = compute_slot_distance(k);
    if (r == SM_OK)
        r = sm_handover_open(&k->lock);
    if (r != SM_OK) {
        (void)pal_nvm_close(k->nvm);
        k->nvm.id = 0;
    }
    return r;
}

// ---- reading slots ----

// Reads slot 0 or 1 into half 1 or 2 of the buffer.  Returns true if it is intact and of this layout.
static bool read_slot(SmKeep *k, uint8_t which)
{
    uint8_t *slot = buffer_half(k, (uint8_t)(which + 1));

    return pal_nvm_read(k->nvm, which * k->slot, slot, SM_KEEP_HEAD + packed_size(k)) == SM_OK && log_get32(slot) % 2 == which &&
        log_get32(slot + SLOT_HASH) == k->sv->layout->hash && log_get32(slot + SLOT_LENGTH) == packed_size(k) &&
        log_get32(slot + SLOT_CHECKSUM) == slot_crc(k, slot);
}

// Whether the memory contains anything but blank bytes, although no slot is intact.  Called after read_slot has read both.
static bool has_saved_data(const SmKeep *k)
{
    const uint32_t n = SM_KEEP_HEAD + packed_size(k);
    PalNvmInfo info;

    return pal_nvm_info(k->nvm, &info) == SM_OK && !(is_blank(buffer_half(k, 1), n, info.blank) && is_blank(buffer_half(k, 2), n, info.blank));
}

// Reads both slots.  Returns the half of the buffer with the newer of the intact ones; 0 if none is intact.
static uint8_t find_newest_half(SmKeep *k)
{
    const bool first = read_slot(k, 0), second = read_slot(k, 1);

    if (first && second)
        return log_get32(buffer_half(k, 1)) - log_get32(buffer_half(k, 2)) < UINT32_MAX / 2 ? 1 : 2;
    return first ? 1 : second ? 2 : 0;
}

// Opens the memory.  If it contains an intact slot of this layout, restores the state vector and sets k->restored.
SmResult sm_keep_restore(SmKeep *k)
{
    SmResult r;
    uint8_t found;

    if (!k || !k->memory || !k->sv || !k->buffer)
        return SM_E_ARGUMENT;
    r = open_memory(k);
    if (r != SM_OK)
        return r;
    found = find_newest_half(k);
    if (found == 0) {
        k->unusable = has_saved_data(k);
        return SM_OK;
    }
    k->number = log_get32(buffer_half(k, found));
    r = sm_unpack_region(k->sv, &k->sv->layout->whole, buffer_half(k, found) + SM_KEEP_HEAD, (size_t)packed_size(k));
    k->restored = r == SM_OK;
    return r;
}

// ---- taking snapshots ----

// Returns the half of the buffer for the next snapshot, never the one that is being written.  If it must reuse the one that waits,
// the snapshot there is dropped.  Returns 0 if the lock timed out.
static uint8_t claim_half(SmKeep *k)
{
    uint8_t into;

    if (sm_handover_lock(k->lock) != SM_OK)
        return 0;
    into = k->writing != 1 && k->waiting != 1 ? 1 : k->writing != 2 && k->waiting != 2 ? 2 : k->waiting;
    if (into == k->waiting) {
        k->waiting = 0;                                   // withdrawn before the writer could start on it
        k->replaced++;
    }
    sm_handover_unlock(k->lock);
    return into;
}

// Makes the snapshot in that half the waiting one.  Returns the result of the last write to the medium.
static SmResult hand_over_snapshot(SmKeep *k, uint8_t snapshot)
{
    SmResult r = sm_handover_lock(k->lock);

    if (r != SM_OK)
        return r;
    k->replaced += k->waiting != 0;
    k->waiting = snapshot;
    k->taken++;
    r = k->result;
    sm_handover_unlock(k->lock);
    return r;
}

// Takes a snapshot of the state vector, in place of one that still waits to be written.
SmResult sm_keep_step(void *context, const SmTick *tick)
{
    SmKeep *k = (SmKeep *)context;
    const uint8_t into = claim_half(k);
    SmResult r = into != 0 ? SM_OK : SM_E_TIMEOUT;

    (void)tick;
    if (r == SM_OK)
        r = sm_pack_region(k->sv, &k->sv->layout->whole, buffer_half(k, into) + SM_KEEP_HEAD, (size_t)packed_size(k));
    return r == SM_OK ? hand_over_snapshot(k, into) : r;
}

// ---- writing ----

// Moves the waiting snapshot to `writing` and returns its half of the buffer; 0 if none waits.
static uint8_t begin_write(SmKeep *k)
{
    if (sm_handover_lock(k->lock) != SM_OK)
        return 0;
    k->writing = k->waiting;
    k->waiting = 0;
    sm_handover_unlock(k->lock);
    return k->writing;
}

// Records the result of a write.  After an error the snapshot waits again, unless a later one does.
static void end_write(SmKeep *k, SmResult r)
{
    if (sm_handover_lock(k->lock) != SM_OK)
        return;
    k->result = r;
    if (r == SM_OK)
        k->written++;
    else if (k->waiting == 0)
        k->waiting = k->writing;
    else
        k->replaced++;
    k->writing = 0;
    sm_handover_unlock(k->lock);
}

// Writes the head of a slot: its number, the layout of the vector, the length of the contents and the CRC.
static void fill_head(const SmKeep *k, uint8_t *slot, uint32_t number)
{
    log_put32(slot, number);
    log_put32(slot + SLOT_HASH, k->sv->layout->hash);
    log_put32(slot + SLOT_LENGTH, packed_size(k));
    log_put32(slot + SLOT_CHECKSUM, slot_crc(k, slot));
}

static SmResult erase_slot(const SmKeep *k, uint32_t at)
{
    PalNvmInfo info;
    SmResult r = pal_nvm_info(k->nvm, &info);

    return r == SM_OK && info.erase != 0 ? pal_nvm_erase(k->nvm, at, k->slot) : r;
}

// Writes a slot to the medium, in the place of number % 2, which it erases first.
static SmResult write_slot(const SmKeep *k, uint8_t *slot, uint32_t number)
{
    const uint32_t at = number % 2 * k->slot;
    SmResult r = erase_slot(k, at);

    fill_head(k, slot, number);
    return r == SM_OK ? pal_nvm_write(k->nvm, at, slot, slot_size(k)) : r;
}

// Writes the waiting snapshot, if there is one, and waits for the medium.
SmResult sm_keep_write(SmKeep *k)
{
    const uint8_t snapshot = begin_write(k);
    SmResult r;

    if (snapshot == 0)
        return SM_OK;
    r = write_slot(k, buffer_half(k, snapshot), k->number + 1);
    k->number += r == SM_OK;
    end_write(k, r);
    return r;
}

// Erases the older slot first.  If this is interrupted, the next start uses the newest slot or none.
SmResult sm_keep_forget(SmKeep *k)
{
    const uint32_t newer = k->number % 2 * k->slot;
    SmResult r = pal_nvm_erase(k->nvm, k->slot - newer, k->slot);

    if (r == SM_OK)
        r = pal_nvm_erase(k->nvm, newer, k->slot);
    if (r == SM_OK)
        r = sm_handover_lock(k->lock);
    if (r != SM_OK)
        return r;
    k->replaced += k->waiting != 0;
    k->waiting = 0;
    sm_handover_unlock(k->lock);
    return SM_OK;
}
