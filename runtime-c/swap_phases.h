// SPDX-License-Identifier: Apache-2.0
// What both ends of the link know about a swap (docs/swapping.md 12): numbers that are sent, and limits.
#ifndef SM_SWAP_PHASES_H
#define SM_SWAP_PHASES_H

typedef enum SmSwapMode {
    SM_SWAP_RESTART = 1,      // the new machine starts, in a state that the swap names or in its first
    SM_SWAP_CONTINUE = 2      // the new machine continues in the state of the same name
} SmSwapMode;

typedef enum SmSwapPhase {
    SM_SWAP_IDLE,             // no swap has begun yet
    SM_SWAP_PREPARING, SM_SWAP_WAITING, SM_SWAP_TRIAL,            // a swap is in progress: another one cannot begin
    SM_SWAP_CONFIRMED, SM_SWAP_RETURNED, SM_SWAP_REFUSED          // the swap has ended
} SmSwapPhase;

// Whether a swap is in progress.
#define SM_SWAP_IS_IN_PROGRESS(phase) ((phase) == SM_SWAP_PREPARING || (phase) == SM_SWAP_WAITING || (phase) == SM_SWAP_TRIAL)

// How a trial ends: a of event TRIAL.
typedef enum SmSwapEnd { SM_SWAP_WAS_CONFIRMED = 1, SM_SWAP_TOOK_TOO_LONG = 2, SM_SWAP_ABORTED = 3 } SmSwapEnd;

// Why a swap is refused, or why a stored image does not run.
typedef enum SmSwapReason {
    SM_SWAP_NOT_REFUSED = 0,
#define SM_SWAP(name, number, text) SM_SWAP_NO_##name = number,
#include "runtime-c/swaps.def"
#undef SM_SWAP
} SmSwapReason;

#define SM_SWAP_VERSION 1u             // the first byte of a swap (bytecode-vm/target/swap_link.h)
#define SM_SWAP_NAME    64u            // most bytes of a name in a swap, with its zero byte

#endif
