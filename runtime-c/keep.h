// SPDX-License-Identifier: Apache-2.0
// Saves the state vector in non-volatile memory, so that an application that was killed can continue where it was.
// Two slots are written alternately.  Each has a sequence number, the layout's hash and a checksum.  Whenever the power fails, one
// of them is intact: the last one or the one before it.  A slot written with another .sv is not used.  A task's step takes the
// snapshot.  A thread without a deadline writes it to the memory; without threads the executor does, while it is idle.
#ifndef SM_KEEP_H
#define SM_KEEP_H

#include "runtime-c/pal/nvm.h"
#include "runtime-c/task.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct SmKeep {
    const char *memory;       // name of the memory, for pal_nvm_open
    SmStateVec *sv;
    uint8_t *buffer;          // 2 * SM_KEEP_SIZE(packed size of the vector) bytes
    // The fields below belong to the runtime; initially all zero.
    PalNvm nvm;
    PalLock lock;             // protects `waiting`, `writing` and `result`
    uint32_t slot;            // distance between the two slots in bytes
    uint32_t number;          // sequence number of the newest slot
    uint8_t waiting, writing; // the half of `buffer`, 1 or 2, that waits to be written, and that is being written; 0: none
    uint32_t taken, written, replaced;    // number of snapshots taken, written, and replaced by a later one before being written
    SmResult result;          // result of the last access to the medium
    bool restored;
    bool unusable;            // there was a slot, but it is damaged or of another layout
} SmKeep;

#define SM_KEEP_HEAD 16u      // bytes of a slot before the packed vector: number, hash, length, checksum
// Size of a slot in bytes, rounded up to SM_KEEP_UNIT, the write alignment of the memory (config.h).
#define SM_KEEP_SIZE(packed) (((packed) + SM_KEEP_HEAD + SM_KEEP_UNIT - 1u) / SM_KEEP_UNIT * SM_KEEP_UNIT)

// Opens the memory.  If it contains an intact slot of this layout, restores the vector and sets keep->restored.  A missing slot is
// not an error.  A damaged slot or one of another layout is not an error either, but sets keep->unusable.  Call this before the
// tasks' init.
//     SM_E_FOREIGN       the memory is neither blank nor contains a slot; it is left unchanged
//     SM_E_SPACE         two slots do not fit
//     SM_E_UNSUPPORTED   SM_KEEP_UNIT is not a multiple of the memory's write size
// Other results as for pal_nvm_open.
SmResult sm_keep_restore(SmKeep *keep);
// Compatible with SmTaskStep.  Takes a snapshot and replaces one that still waits to be written.  If the previous write to the
// medium failed, returns the error of that write after taking the snapshot, so that it is the task's fault until a write succeeds.
//     SM_E_TIMEOUT   a lock was not free in time, that of the vector or of the snapshots; no snapshot was taken, the next step tries again
SmResult sm_keep_step(void *keep, const SmTick *tick);
// Writes the waiting snapshot, if there is one, and waits for the medium.  Call it from one thread only; any thread will do.
// After an error the snapshot waits again, unless a later one does, and the previous slot stays valid.
SmResult sm_keep_write(SmKeep *keep);
// Erases both slots and discards a waiting snapshot, so that the next start is a fresh one.  Call it from the thread that writes.
SmResult sm_keep_forget(SmKeep *keep);

#ifdef __cplusplus
}
#endif
#endif
