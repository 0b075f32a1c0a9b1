// SPDX-License-Identifier: Apache-2.0
// A slot is its number, the layout's hash, the length of the packed vector, a CRC-32 over these and it, and the vector; numbers have their
// least significant byte first.  The slot with an even number is the first one: so a slot is written while the newest stays.
#include "runtime-c/keep.h"

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

static SmResult open_memory(SmKeep *k)
{
    SmResult r = pal_nvm_open(&k->nvm, k->memory, 2 * size_of(k));

    if (r != SM_OK)
        return r;
    r = lay_out(k);
    if (r == SM_OK)
        r = sm_handover_open(&k->lock);
    if (r != SM_OK) {
        (void)pal_nvm_close(k->nvm);
        k->nvm.id = 0;
    }
    return r;
}

// Reads slot 0 or 1 into its half; whether it is whole and of this layout.
static bool read_slot(SmKeep *k, uint8_t which)
{
    uint8_t *slot = half(k, (uint8_t)(which + 1));

    return pal_nvm_read(k->nvm, which * k->slot, slot, SM_KEEP_HEAD + packed_of(k)) == SM_OK && log_get32(slot) % 2 == which &&
        log_get32(slot + 4) == k->sv->layout->hash && log_get32(slot + 8) == packed_of(k) && log_get32(slot + 12) == check_of(k, slot);
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
    if (found == 0)
        return SM_OK;
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
