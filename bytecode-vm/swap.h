// SPDX-License-Identifier: Apache-2.0
// Replaces a machine that runs by another one, between two steps (docs/swapping.md 12).  The old machine continues in the new one: the new
// machine gets the state, T, the locals and the samples of the old one, as far as both have them by name.  For hosts: it needs images with
// names (smc build -g), and debug.c.  C99 without heap or recursion.
//
//     // Before, at any time, for example in another thread: `to` is an image that smvm_verify accepted.
//     smvm_prepare(new_memory, new_size, &to, &vector, 1);       // does not access the vector
//     smvm_swap_plan(plan, plan_size, &from, &to);               // plan_size: at least smvm_swap_size(&from, &to)
//
//     // Then between two steps of the old machine:
//     if (smvm_state_allows_swap(&from, smvm_state(old)) && smvm_swap_continue(plan, old, new_memory, sv) == SM_OK)
//         old = new_memory;                                      // from now on
//
// To restart instead, name the state in smvm_prepare, and call smvm_write_state between two steps; no plan is needed.
#ifndef SMVM_SWAP_H
#define SMVM_SWAP_H

#include "bytecode-vm/smvm.h"

#ifdef __cplusplus
extern "C" {
#endif
#ifdef SMVM_LIBRARY
#pragma GCC visibility push(default)
#endif

// Like smvm_init, but neither reads nor writes the state vector.  The caller later calls smvm_write_state or smvm_swap_continue, which store S.
SmResult smvm_prepare(void *memory, uint32_t size, const SmvmMachine *m, const SmvmVector *sv, uint32_t state);

// What one machine takes over from another, in memory of the caller.  Valid while both images are; it needs neither SmvmMachine.
typedef struct SmvmSwap SmvmSwap;

// Bytes of memory for a plan.
uint32_t smvm_swap_size(const SmvmMachine *from, const SmvmMachine *to);

// Compares two machines by the names of their states, locals and samples.  Takes time n log n in the number of names.  The memory must be
// aligned as an array of uint64_t.
// SM_E_LAYOUT: they are compiled for different state vectors.  SM_E_UNSUPPORTED: one of the images has no names.  SM_E_MEMORY: `size` is too
// small.  SM_E_ALIGNMENT: the memory is not aligned.
SmResult smvm_swap_plan(SmvmSwap *plan, uint32_t size, const SmvmMachine *from, const SmvmMachine *to);

// The number that state `state` of `from` has in `to`; 0: `to` has no state of this name, or `from` has no such state.
uint32_t smvm_swap_state(const SmvmSwap *plan, uint32_t state);

// Lets `to` continue where `from` is.  Both run the machines of the plan, and `to` has not stepped since smvm_prepare.  Takes time linear in the
// memory of `to`, except for a window of which `to` needs other statistics than `from`: its samples are added one by one.
// SM_E_ARGUMENT: `to` has no state of the name of the state that `from` is in, or they do not run the machines of the plan.  Then nothing
// has changed.
SmResult smvm_swap_continue(const SmvmSwap *plan, const SmVm *from, SmVm *to, void *sv);

// Stores the number of the machine's state in S, as smvm_init does: for a machine that smvm_prepare started.
void smvm_write_state(const SmVm *vm, const SmvmMachine *m, void *sv);

// ---- what is kept ----

typedef enum SmvmSwapKind { SMVM_SWAP_STATE, SMVM_SWAP_LOCAL, SMVM_SWAP_SAMPLE } SmvmSwapKind;
typedef enum SmvmSwapFate {
    SMVM_SWAP_KEPT,           // both machines have the state or variable: `to` continues with the state, value or samples of `from`
    SMVM_SWAP_ADDED,          // only `to` has the state or variable: a local begins at its initial value, a window empty
    SMVM_SWAP_REMOVED,        // only `from` has the state or variable
    SMVM_SWAP_CHANGED         // both have the variable, with different types: its value is not kept, as for SMVM_SWAP_ADDED
} SmvmSwapFate;

typedef struct SmvmSwapItem {
    SmvmSwapKind kind;
    SmvmSwapFate fate;
    const char *name;         // points into the image of `to`, or of `from` if fate is SMVM_SWAP_REMOVED; not NUL-terminated
    uint32_t length;          // of the name, in bytes
} SmvmSwapItem;

// Reads item i of the list of what a swap does with each name: states, locals and samples of `to`, then those that only `from` has.  Returns false at
// the end.
bool smvm_swap_item(const SmvmSwap *plan, uint32_t i, SmvmSwapItem *item);

#ifdef SMVM_LIBRARY
#pragma GCC visibility pop
#endif
#ifdef __cplusplus
}
#endif
#endif
