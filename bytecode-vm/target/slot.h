// SPDX-License-Identifier: Apache-2.0
// Memory for an image that can be swapped while the application runs (runtime-c/swap.h).  A machine has two slots: one runs, the other
// receives the next image.
//
//     static uint64_t first[4096 / 8], second[4096 / 8];
//     static SmvmSlot slots[2] = {
//         {.target = {.image = SMVM_IMAGE(image), .size = sizeof image, .memory = memory, .memory_size = sizeof memory}, .memory = first, .size = sizeof first},
//         {.memory = second, .size = sizeof second}};
//     static SmMachine m = {.name = "tank", .type = &smvm_machine_type, .self = &slots[0], …};
//     static SmSwappable tank = {.machine = &m, .type = &smvm_slot_type, .slot = {&slots[0], &slots[1]}};
//
// The memory of a slot contains, one after another: the image, the memory of the VM, the decoded form if there is a decoder, and the two
// plans of what is kept, to this slot and back.  The image with which the application starts is not in the slot.
// Link swap.c, debug.c and this folder's slot.c, in addition to the files that machine.h names.
#ifndef SMVM_TARGET_SLOT_H
#define SMVM_TARGET_SLOT_H

#include "bytecode-vm/swap.h"
#include "bytecode-vm/target/machine.h"
#include "runtime-c/swap.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct SmvmSlot {
    SmvmTarget target;        // the first field: SmMachine.self points to it.  Of the slot that does not run at first, only `decoder` is set
    void *memory;             // for the next image, not shared; aligned as an array of uint64_t
    uint32_t size;            // of `memory`, in bytes
    uint32_t longest;         // the most instructions of a step; 0: any number
    // The fields below belong to the runtime; initially all zero.
    SmvmMachine m;              // properties of the machine in the slot
    uint32_t identity;        // checksum of the image; 0: the slot has no image
    uint32_t used;            // bytes of `memory` that are allocated so far
    uint32_t first;           // number of the state in which the machine starts
    SmvmBytes built_in;       // the image with which the application was built
    uint32_t built_in_size;
    SmvmSwap *plan, *back;    // what is copied when this slot replaces the other one, and when the other replaces this one; NULL: nothing
} SmvmSlot;

// For SmSwappable.type; its slots are SmvmSlots.
extern const SmSwapType smvm_slot_type;

// Puts an image into slot `to`, which does not run, before the application starts with it.  `from` is the slot with the built-in image.  All
// conditions of a swap that do not depend on the running machine apply.  If the image has no state of the name image->state, it starts in its
// first state.  On success the machine in `to` can be initialised (SmMachineType.init) in state to->first.
SmSwapReason smvm_slot_load(SmvmSlot *to, const SmvmSlot *from, const SmSwapChange *image, const SmMachine *m);

// Item i of what the machine in the slot took over from the other slot.  Valid from phase WAITING until the next swap begins.  Returns false at
// the end of the list, which is empty after a restart.
bool smvm_slot_item(const SmvmSlot *slot, uint32_t i, SmvmSwapItem *item);

#ifdef __cplusplus
}
#endif
#endif
