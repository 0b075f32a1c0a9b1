// SPDX-License-Identifier: Apache-2.0
// What a small target can configure in the VM (SMVM_CONFIG): 16-bit offsets, little memory in the verifier, and functions that read the image,
// which here count the accesses.  It also counts instructions.  Used by tests/unit/vm_hostile.c.
#ifndef VM_SMALL_H
#define VM_SMALL_H

#define SMVM_AT uint16_t
#define SMVM_IMAGE_MAX 0xfffeu
#define SMVM_RAM_MAX 0x8000u
#define SMVM_LONGEST 1
#define SMVM_JOINS 2
#define SMVM_FUNCTIONS UINT32_C(1)                    // only exp
#define SMVM_PARAMETERS 0
#define SMVM_BYTES uint16_t
#define SMVM_FETCH(image, at) small_fetch((uint32_t)(image) + (at))

static uint8_t small_flash[0x10000];
static uint32_t small_image, small_end;               // the range of the image in memory
static uint32_t small_beyond;                         // bytes that were read outside it
static uint32_t small_opcodes;                        // instructions that were executed
#define SMVM_ON_INSTRUCTION (small_opcodes++)

static uint8_t small_fetch(uint32_t at)
{
    if (at < small_image || at >= small_end) {
        small_beyond++;
        return 0xff;
    }
    return small_flash[at];
}

#endif
