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
    uint32_t number;          // of the newest slot
    uint32_t pending, stored, missed;         // snapshots taken, written, not taken because the one before was still being written
    bool restored;
} SmKeep;

#define SM_KEEP_HEAD 16u      // bytes beside the packed vector: number, hash, length, checksum
#define SM_KEEP_SIZE(packed) ((packed) + SM_KEEP_HEAD)

// Opens the memory and, where a slot is whole and of this layout, brings the vector back: keep->restored.  No slot is no error.
// To be called before the tasks' init.
SmResult sm_keep_restore(SmKeep *keep);
SmResult sm_keep_step(void *keep, const SmTick *tick);
// Writes the pending snapshot; waits for the medium; from one thread only, any.
SmResult sm_keep_write(SmKeep *keep);
// Forgets what is kept: the next start is a fresh one.
SmResult sm_keep_forget(SmKeep *keep);

#ifdef __cplusplus
}
#endif
#endif
