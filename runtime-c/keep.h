// SPDX-License-Identifier: Apache-2.0
// Keeps the state vector in non-volatile memory, so that an application that was killed goes on where it was (thesis 2.4).
// Two slots are written in turn, each with a number, the layout's hash and a checksum: whatever moment the power goes, one of them is
// whole, the last or the one before.  A slot of another .sv is not taken.  A task's step takes the snapshot; it is written by a thread without a
// deadline (or by the step itself, where there is none).
#ifndef SM_KEEP_H
#define SM_KEEP_H

#include "runtime-c/pal/nvm.h"
#include "runtime-c/task.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct SmKeep {
    const char *memory;       // a name as pal/nvm.h takes it
    SmStateVec *sv;
    uint8_t *buffer;          // SM_KEEP_SIZE(packed size of the vector) bytes, twice
    // What follows is the runtime's; all zero at first.
    PalNvm nvm;
    PalLock lock;             // around `full`, `busy` and `result`
    uint32_t slot;            // bytes from the first slot to the second
    uint32_t number;          // of the newest slot
    uint8_t full, busy;       // the half of the buffer, 1 or 2, that waits to be written, that is being written; 0: none
    uint32_t pending, stored, missed;     // snapshots taken, written, replaced by a later one before they were written
    SmResult result;          // of the medium, the last time
    bool restored;
    bool unusable;            // there was one, damaged or of another layout
} SmKeep;

#define SM_KEEP_HEAD 16u      // bytes beside the packed vector: number, hash, length, checksum
// (Rounded up to what memories are written in multiples of: config.h.)
#define SM_KEEP_SIZE(packed) (((packed) + SM_KEEP_HEAD + SM_KEEP_UNIT - 1u) / SM_KEEP_UNIT * SM_KEEP_UNIT)

// Opens the memory and, where a slot is whole and of this layout, brings the vector back: keep->restored.  No slot is no error, a damaged one
// or one of another layout is none either: keep->unusable.
// SM_E_FOREIGN: the memory is neither blank nor does it hold a slot; it stays as it is, to the byte.
// To be called before the tasks' init.  SM_E_SPACE: two slots do not fit.  SM_E_UNSUPPORTED: it is written in multiples of something that
// SM_KEEP_UNIT is no multiple of.  Otherwise as pal_nvm_open.
SmResult sm_keep_restore(SmKeep *keep);
// As SmTaskStep.  Takes a snapshot; one that still waits is replaced.  When that is done and the medium refused the last one that it was
// given, the result is what it said: so it is told as the task's fault, until it takes one again.
SmResult sm_keep_step(void *keep, const SmTick *tick);
// Writes the snapshot that waits, if one does; waits for the medium; from one thread only, any.  After an error it waits again, if no later
// one does, and the slot that was there before still counts.
SmResult sm_keep_write(SmKeep *keep);
// Forgets what is kept and what waits: the next start is a fresh one.  From the thread that writes.
SmResult sm_keep_forget(SmKeep *keep);

#ifdef __cplusplus
}
#endif
#endif
