// SPDX-License-Identifier: Apache-2.0
// A slot consists of: a sequence number, the layout's hash, the length of the packed vector, a CRC-32 over these three and the
// vector, and the packed vector.  Numbers are little-endian.  Even sequence numbers use the first slot and odd ones the second, so
// a write never overwrites the newest slot.
#include "runtime-c/keep.h"

#include <string.h>

#include "runtime-c/handover.h"
#include "runtime-c/log_block.h"

static uint32_t packed_of(const SmKeep *k) { return k->sv->layout->whole.packed; }
static uint32_t size_of(const SmKeep *k) { return SM_KEEP_SIZE(packed_of(k)); }
static uint8_t *half(const SmKeep *k, uint8_t n) { return k->buffer + (n - 1u) * size_of(k); }

static uint32_t check_of(const SmKeep *k, const uint8_t *slot)
{
    return sm_crc32_end(log_check(log_check(SM_CRC32_START, slot, 12), slot + SM_KEEP_HEAD, packed_of(k)));
}

// ---- restoring ----

static uint32_t round_up(uint32_t n, uint32_t unit) { return unit > 1 ? (n + unit - 1) / unit * unit : n; }

// Determines the distance between the slots in this memory.
static SmResult lay_out(SmKeep *k)
{
    PalNvmInfo info;
    SmResult r = pal_nvm_info(k->nvm, &info);

    if (r != SM_OK)
        return r;
    if (info.write == 0 || SM_KEEP_UNIT % info.write != 0)
        return SM_E_UNSUPPORTED;
    k->slot = round_up(size_of(k), info.erase);
    return k->slot <= info.size / 2 ? SM_OK : SM_E_SPACE;
}

// ---- is it ours? ----

// A power cut can leave anything in the slot that was being written, but does not affect the other one.  So in a memory that
// contains our data, at least one head is recognisable.  A single bit flip in each head cannot change both hash and length.  A
// memory without our data is never written.

// Reads the head at `at`; bytes beyond the end of the memory read as `blank`.  Returns false if the memory cannot be read.
static bool read_head(const SmKeep *k, const PalNvmInfo *info, uint32_t at, uint8_t head[SM_KEEP_HEAD])
{
    const uint32_t there = at < info->size ? info->size - at : 0;

    memset(head, info->blank, SM_KEEP_HEAD);
    return pal_nvm_read(k->nvm, there ? at : 0, head, there < SM_KEEP_HEAD ? there : SM_KEEP_HEAD) == SM_OK;
}

static bool is_blank(const uint8_t *bytes, uint32_t n, uint8_t blank)
{
    while (n > 0 && bytes[n - 1] == blank)
        n--;
    return n == 0;
}

static bool is_known(const SmKeep *k, const uint8_t *head)
{
    return log_get32(head + 4) == k->sv->layout->hash || log_get32(head + 8) == packed_of(k);
}

// Whether the memory begins with an intact slot of any layout.
static bool is_whole(const SmKeep *k, const PalNvmInfo *info, const uint8_t *head)
{
    const uint32_t n = log_get32(head + 8);
    uint32_t crc = log_check(SM_CRC32_START, head, 12);
    uint8_t piece[SM_KEEP_HEAD];

    if (info->size < SM_KEEP_HEAD || n > info->size - SM_KEEP_HEAD)
        return false;
    for (uint32_t at = 0; at < n; at += SM_KEEP_HEAD) {
        if (!read_head(k, info, SM_KEEP_HEAD + at, piece))
            return false;
        crc = log_check(crc, piece, n - at < SM_KEEP_HEAD ? n - at : SM_KEEP_HEAD);
    }
    return n > 0 && log_get32(head + 12) == sm_crc32_end(crc);
}

// Whether the memory is ours or blank.  For blank only the number and the hash are checked, because an erase may have been cut
// after them.
static bool is_ours(const SmKeep *k, const PalNvmInfo *info)
{
    uint8_t first[SM_KEEP_HEAD], second[SM_KEEP_HEAD];

    if (!read_head(k, info, 0, first) || !read_head(k, info, round_up(size_of(k), info->erase), second))
        return true;                                      // the medium cannot be read now, so the content is unknown
    return is_blank(first, 8, info->blank) || is_known(k, first) || is_known(k, second) || is_whole(k, info, first) ||
        (info->erase != 0 && is_blank(second, SM_KEEP_HEAD, info->blank));        // a cut erase of the first leaves undefined bytes there
}

// ---- opening ----

// Opens the memory at its current size, because opening it with a larger size would extend it.
static SmResult look_first(SmKeep *k, bool *fits)
{
    PalNvmInfo info;
    SmResult r = pal_nvm_open(&k->nvm, k->memory, 1);

    if (r != SM_OK)
        return r;
    r = pal_nvm_info(k->nvm, &info);
    if (r == SM_OK && !is_ours(k, &info))
        r = SM_E_FOREIGN;
    *fits = r == SM_OK && info.size >= 2 * size_of(k);
    if (!*fits)
        (void)pal_nvm_close(k->nvm);
    return r;
}

static SmResult open_memory(SmKeep *k)
{
    bool fits = false;
    SmResult r = look_first(k, &fits);

    if (r == SM_OK && !fits)
        r = pal_nvm_open(&k->nvm, k->memory, 2 * size_of(k));
    if (r != SM_OK) {
        k->nvm.id = 0;
        return r;
    }
    r = lay_out(k);
    if (r == SM_OK)
        r = sm_handover_open(&k->lock);
    if (r != SM_OK) {
        (void)pal_nvm_close(k->nvm);
        k->nvm.id = 0;
    }
    return r;
}

// ---- reading slots ----

// Reads slot 0 or 1 into its half of the buffer.  Returns whether it is intact and of this layout.
static bool read_slot(SmKeep *k, uint8_t which)
{
    uint8_t *slot = half(k, (uint8_t)(which + 1));

    return pal_nvm_read(k->nvm, which * k->slot, slot, SM_KEEP_HEAD + packed_of(k)) == SM_OK && log_get32(slot) % 2 == which &&
        log_get32(slot + 4) == k->sv->layout->hash && log_get32(slot + 8) == packed_of(k) && log_get32(slot + 12) == check_of(k, slot);
}

// Whether a vector was ever saved: the bytes read from the slots are not all blank.
static bool holds_something(const SmKeep *k)
{
    const uint32_t n = SM_KEEP_HEAD + packed_of(k);
    PalNvmInfo info;

    return pal_nvm_info(k->nvm, &info) == SM_OK && !(is_blank(half(k, 1), n, info.blank) && is_blank(half(k, 2), n, info.blank));
}

// The half of the buffer that contains the newest slot; 0: none.
static uint8_t newest(SmKeep *k)
{
    const bool first = read_slot(k, 0), second = read_slot(k, 1);

    if (first && second)
        return log_get32(half(k, 1)) - log_get32(half(k, 2)) < UINT32_MAX / 2 ? 1 : 2;
    return first ? 1 : second ? 2 : 0;
}

SmResult sm_keep_restore(SmKeep *k)
{
    SmResult r;
    uint8_t found;

    if (!k || !k->memory || !k->sv || !k->buffer)
        return SM_E_ARGUMENT;
    r = open_memory(k);
    if (r != SM_OK)
        return r;
    found = newest(k);
    if (found == 0) {
        k->unusable = holds_something(k);
        return SM_OK;
    }
    k->number = log_get32(half(k, found));
    r = sm_unpack_region(k->sv, &k->sv->layout->whole, half(k, found) + SM_KEEP_HEAD, (size_t)packed_of(k));
    k->restored = r == SM_OK;
    return r;
}

// ---- taking snapshots ----

// Chooses the half for the next snapshot.  It never chooses the half that is being written, and chooses the waiting one only if
// necessary.
static uint8_t claim(SmKeep *k)
{
    uint8_t into;

    if (sm_handover_take(k->lock) != SM_OK)
        return 0;
    into = k->busy != 1 && k->full != 1 ? 1 : k->busy != 2 && k->full != 2 ? 2 : k->full;
    if (into == k->full) {
        k->full = 0;                                      // withdrawn, so that the writer does not start on it now
        k->missed++;
    }
    sm_handover_give(k->lock);
    return into;
}

// Returns the result of the last write to the medium.
static SmResult hand_over(SmKeep *k, uint8_t snapshot)
{
    SmResult r = sm_handover_take(k->lock);

    if (r != SM_OK)
        return r;
    k->missed += k->full != 0;
    k->full = snapshot;
    k->pending++;
    r = k->result;
    sm_handover_give(k->lock);
    return r;
}

SmResult sm_keep_step(void *context, const SmTick *tick)
{
    SmKeep *k = (SmKeep *)context;
    const uint8_t into = claim(k);
    SmResult r = into != 0 ? SM_OK : SM_E_TIMEOUT;

    (void)tick;
    if (r == SM_OK)
        r = sm_pack_region(k->sv, &k->sv->layout->whole, half(k, into) + SM_KEEP_HEAD, (size_t)packed_of(k));
    return r == SM_OK ? hand_over(k, into) : r;
}

// ---- writing ----

// Moves the waiting snapshot to `busy`.  Returns 0 if none waits.
static uint8_t begin(SmKeep *k)
{
    if (sm_handover_take(k->lock) != SM_OK)
        return 0;
    k->busy = k->full;
    k->full = 0;
    sm_handover_give(k->lock);
    return k->busy;
}

static void end(SmKeep *k, SmResult r)
{
    if (sm_handover_take(k->lock) != SM_OK)
        return;
    k->result = r;
    if (r == SM_OK)
        k->stored++;
    else if (k->full == 0)
        k->full = k->busy;
    else
        k->missed++;
    k->busy = 0;
    sm_handover_give(k->lock);
}

static void put_head(const SmKeep *k, uint8_t *slot, uint32_t number)
{
    log_put32(slot, number);
    log_put32(slot + 4, k->sv->layout->hash);
    log_put32(slot + 8, packed_of(k));
    log_put32(slot + 12, check_of(k, slot));
}

static SmResult erase(const SmKeep *k, uint32_t at)
{
    PalNvmInfo info;
    SmResult r = pal_nvm_info(k->nvm, &info);

    return r == SM_OK && info.erase != 0 ? pal_nvm_erase(k->nvm, at, k->slot) : r;
}

static SmResult store(const SmKeep *k, uint8_t *slot, uint32_t number)
{
    const uint32_t at = number % 2 * k->slot;
    SmResult r = erase(k, at);

    put_head(k, slot, number);
    return r == SM_OK ? pal_nvm_write(k->nvm, at, slot, size_of(k)) : r;
}

SmResult sm_keep_write(SmKeep *k)
{
    const uint8_t snapshot = begin(k);
    SmResult r;

    if (snapshot == 0)
        return SM_OK;
    r = store(k, half(k, snapshot), k->number + 1);
    k->number += r == SM_OK;
    end(k, r);
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
        r = sm_handover_take(k->lock);
    if (r != SM_OK)
        return r;
    k->missed += k->full != 0;
    k->full = 0;
    sm_handover_give(k->lock);
    return SM_OK;
}
