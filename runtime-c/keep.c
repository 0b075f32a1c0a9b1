// SPDX-License-Identifier: Apache-2.0
// A slot is its number, the layout's hash, the length of the packed vector, a CRC-32 over these and it, and the vector; numbers have their
// least significant byte first.  The slot with an even number is the first one: so a slot is written while the newest stays.
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

// Finds out where slots lie in this memory.
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

// A power cut can leave anything in the slot that was being written, and nothing else in the other; so of a memory of ours one head at
// least can be known again, and a bit that flips in each does not hide both hash and length.  What is not ours is never written.

// The head at `at`, with `blank` where the memory is shorter; false: it cannot be read.
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

// A whole slot of any layout at the memory's beginning.
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

// Blank: number and hash alone, for an erase may have been cut behind them.
static bool is_ours(const SmKeep *k, const PalNvmInfo *info)
{
    uint8_t first[SM_KEEP_HEAD], second[SM_KEEP_HEAD];

    if (!read_head(k, info, 0, first) || !read_head(k, info, round_up(size_of(k), info->erase), second))
        return true;                                      // a medium that cannot be read now: nothing can be said of it
    return is_blank(first, 8, info->blank) || is_known(k, first) || is_known(k, second) || is_whole(k, info, first) ||
        (info->erase != 0 && is_blank(second, SM_KEEP_HEAD, info->blank));        // a cut erase of the first leaves anything there
}

// ---- opening ----

// As it is: whoever opens it for more than it has lengthens it.
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

// ---- what is kept ----

// Reads slot 0 or 1 into its half; whether it is whole and of this layout.
static bool read_slot(SmKeep *k, uint8_t which)
{
    uint8_t *slot = half(k, (uint8_t)(which + 1));

    return pal_nvm_read(k->nvm, which * k->slot, slot, SM_KEEP_HEAD + packed_of(k)) == SM_OK && log_get32(slot) % 2 == which &&
        log_get32(slot + 4) == k->sv->layout->hash && log_get32(slot + 8) == packed_of(k) && log_get32(slot + 12) == check_of(k, slot);
}

// Something was kept once: what is read of the slots is not blank.
static bool holds_something(const SmKeep *k)
{
    const uint32_t n = SM_KEEP_HEAD + packed_of(k);
    PalNvmInfo info;

    return pal_nvm_info(k->nvm, &info) == SM_OK && !(is_blank(half(k, 1), n, info.blank) && is_blank(half(k, 2), n, info.blank));
}

// The half of the buffer that holds the newest slot; 0: there is none.
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

// The half that a snapshot may go into: not the one that is being written; the one that waits only if it has to be.
static uint8_t claim(SmKeep *k)
{
    uint8_t into;

    if (sm_handover_take(k->lock) != SM_OK)
        return 0;
    into = k->busy != 1 && k->full != 1 ? 1 : k->busy != 2 && k->full != 2 ? 2 : k->full;
    if (into == k->full) {
        k->full = 0;                                      // withdrawn: the writer must not begin with it now
        k->missed++;
    }
    sm_handover_give(k->lock);
    return into;
}

// The result is that of the medium.
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

// The snapshot that waits becomes the one that is being written; 0: none waits.
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

// The older slot first: whatever happens in between, the next start is with the newest or with none.
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
