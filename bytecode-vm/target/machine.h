// SPDX-License-Identifier: Apache-2.0
// Machines of an image as tasks of the flight runtime (runtime-c/machine.h).
//
//     static const uint8_t image[] SMVM_IMAGE_IN = { … };               // a .smb: in flash, in memory, read from a file
//     static uint64_t memory[SMVM_WORDS(0, 0, 16, 3)];
//     static SmvmTarget mission = {.image = SMVM_IMAGE(image), .size = sizeof image, .memory = memory, .memory_size = sizeof memory};
//     static SmMachine m = {.name = "mission", .type = &smvm_machine_type, .self = &mission, .sv = &rocket_vector, …};
//
// The image is verified in sm_machine_init, whoever made it.  An image of several machines has an SmvmTarget for each.
// Link load.c, pins.c, interp.c, verify.c, debug.c and this folder's machine.c.
#ifndef SMVM_TARGET_MACHINE_H
#define SMVM_TARGET_MACHINE_H

#include "bytecode-vm/smvm.h"
#include "runtime-c/machine_type.h"

#ifdef __cplusplus
extern "C" {
#endif

// The decoded form of a machine (smvm_decode), several times as fast.  Behind pointers, so that only who names smvm_decoder links
// decode*.c, fast.c and this folder's decoder.c.
typedef struct SmvmDecoder {
    SmResult (*decode)(SmvmDecoded **decoded, void *memory, uint32_t size, const SmvmMachine *m, SmVm *vm, void *sv);
    SmResult (*step)(SmvmDecoded *decoded, void *sv);
} SmvmDecoder;
extern const SmvmDecoder smvm_decoder;

typedef struct SmvmTarget {
    SmvmBytes image;          // as SMVM_FETCH reads it (config.h); stays as it is while the machine runs
    uint32_t size;            // bytes; an image may be shorter
    uint32_t machine;         // which one of the image, counted from 0
    void *memory;             // its own, aligned as an array of uint64_t
    uint32_t memory_size;     // bytes; smvm_target_memory or SMVM_WORDS tell how many it takes
    const SmvmDecoder *decoder;       // &smvm_decoder; NULL: it runs from the image
    void *decoded;            // then: memory for the decoded form, aligned likewise
    uint32_t decoded_size;    // bytes; smvm_decoded_size tells how many it takes
    // What follows is the runtime's; all zero at first.
    SmvmVerdict why;          // what is wrong with an image that was refused: why.rule, why.at
    SmVm *vm;                 // NULL where it cannot step
    SmvmDecoded *fast;
    const uint8_t *more;      // what it stored of the outputs from 64 on, a bit each
    uint32_t states, outputs;
    SmvmAt outputs_at;
    SmPlace uses, number;
} SmvmTarget;

// The type of all images; `self` is an SmvmTarget.
//   open   SM_E_IMAGE: the verifier refuses it.  SM_E_MISSING: it has no machine of that number.  SM_E_LAYOUT.
//   init   SM_E_MEMORY: memory_size or decoded_size is too small.  SM_E_ALIGNMENT.  SM_E_ARGUMENT: no such state.
// States have names where the image was built with -g and lies in plain memory.
extern const SmMachineType smvm_machine_type;

// Verifies an image and tells how much `memory` a machine of it needs here; 0: it is refused, or has no such machine.
uint32_t smvm_target_memory(SmvmBytes image, uint32_t size, uint32_t machine);

// The same as a constant, in words of 8 bytes, from the numbers that `smc image` shows; window_words are those of all windows
// (sm_roll_words).
#define SMVM_WORDS(windows, window_words, locals, outputs) \
    ((sizeof(SmVm) + 7) / 8 + ((windows) * sizeof(uint64_t *) + 7) / 8 + (window_words) + \
     ((locals) + ((outputs) > 64 ? ((outputs) - 64u + 7u) / 8 : 0u) + 7) / 8)

#ifdef __cplusplus
}
#endif
#endif
