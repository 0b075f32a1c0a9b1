// SPDX-License-Identifier: Apache-2.0
// Runs machines of an image as tasks of the flight runtime (runtime-c/machine.h).
//
//     static const uint8_t image[] SMVM_IMAGE_IN = { … };               // a .smb: in flash, in memory, read from a file
//     static uint64_t memory[SMVM_WORDS(0, 0, 16, 3)];
//     static SmvmTarget mission = {.image = SMVM_IMAGE(image), .size = sizeof image, .memory = memory, .memory_size = sizeof memory};
//     static SmMachine m = {.name = "mission", .type = &smvm_machine_type, .self = &mission, .sv = &rocket_vector, …};
//
// sm_machine_init verifies every image.  An image with several machines needs an SmvmTarget for each.
// Link load.c, pins.c, interp.c, verify.c, debug.c and this folder's machine.c.
#ifndef SMVM_TARGET_MACHINE_H
#define SMVM_TARGET_MACHINE_H

#include "bytecode-vm/smvm.h"
#include "runtime-c/machine_type.h"

#ifdef __cplusplus
extern "C" {
#endif

// Functions that create and run the decoded form of a machine (smvm_decode), which is several times as fast.  They are pointers, so that
// only programs that refer to smvm_decoder link decode*.c, fast.c and this folder's decoder.c.
typedef struct SmvmDecoder {
    uint32_t (*size)(const SmvmMachine *m);       // smvm_decoded_size
    SmResult (*decode)(SmvmDecoded **decoded, void *memory, uint32_t size, const SmvmMachine *m, SmVm *vm, void *sv);
    SmResult (*step)(SmvmDecoded *decoded, void *sv);
} SmvmDecoder;
extern const SmvmDecoder smvm_decoder;

typedef struct SmvmTarget {
    SmvmBytes image;          // for SMVM_FETCH (config.h); must not change while the machine runs
    uint32_t size;            // bytes available at `image`; the image may be shorter
    uint32_t machine;         // number of the machine in the image, counted from 0
    void *memory;             // for this machine only, aligned as an array of uint64_t
    uint32_t memory_size;     // bytes of `memory`; smvm_target_memory or SMVM_WORDS compute how many the machine needs
    const SmvmDecoder *decoder;       // &smvm_decoder; NULL: run from the image
    void *decoded;            // with a decoder: memory for the decoded form, aligned like `memory`
    uint32_t decoded_size;    // bytes of `decoded`; smvm_decoded_size computes how many are needed
    // The remaining fields belong to the runtime; all zero initially.
    SmvmVerdict why;          // the error in an image that the verifier rejected: why.rule, why.at
    SmVm *vm;                 // NULL: init has not succeeded, so the machine cannot step
    SmvmDecoded *fast;              // the decoded form; NULL: the machine runs from the image
    const uint8_t *more;      // a bit for each output from the 64th on (counted from 0): whether the last step stored it
    uint32_t states, outputs;       // numbers of states and outputs
    SmvmAt outputs_at;              // offset in the image of the table of outputs
    SmRange accessed, state_number; // bytes of the state vector: those that the machine accesses; those of S
} SmvmTarget;

// The machine type for images; `self` is an SmvmTarget.  Errors of its functions:
//   open   SM_E_IMAGE: the verifier rejects the image.  SM_E_MISSING: it has no machine of that number.  SM_E_LAYOUT: the machine was
//          compiled for another state vector.
//   init   SM_E_MEMORY: memory_size or decoded_size is too small.  SM_E_ALIGNMENT: memory is not aligned.  SM_E_ARGUMENT: no such state.
// States have names if the image was built with -g and is in memory that pointers can address.
extern const SmMachineType smvm_machine_type;

// Verifies an image.  Returns how many bytes of SmvmTarget.memory this machine of the image needs; 0 if the image is rejected or has no such machine.
uint32_t smvm_target_memory(SmvmBytes image, uint32_t size, uint32_t machine);

// The size that smvm_target_memory returns, but in words of 8 bytes and as a constant expression, for the size of an array.  `windows` and
// `outputs` are numbers of these, `locals` is in bytes, and window_words is the sum of sm_roll_words for all windows.
#define SMVM_WORDS(windows, window_words, locals, outputs) \
    ((sizeof(SmVm) + 7) / 8 + ((windows) * sizeof(uint64_t *) + 7) / 8 + (window_words) + \
     ((locals) + ((outputs) > 64 ? ((outputs) - 64u + 7u) / 8 : 0u) + 7) / 8)

#ifdef __cplusplus
}
#endif
#endif
