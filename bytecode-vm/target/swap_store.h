// SPDX-License-Identifier: Apache-2.0
// Stores the images of confirmed swaps in non-volatile memory, so that an application starts with them after a restart (docs/swapping.md 12.48
// to 12.52).  Whenever the application is killed or the power fails, the next start finds the images of the last confirmation or those of the
// one before, of all machines together.
//
//     static SmSwapStore store = {.storage = SM_SWAP_STORE_STORAGE, .memory = "stand.images", .room = SM_SWAP_STORE_ROOM(2, 16384)};
//     SmSwaps stand_swaps = {…, .storage = &store.storage};
//
// The memory begins with two heads of HEAD_STRIDE bytes.  Each describes a set: the images of all machines that do not run the image with which
// the application was built.  Heads are written alternately.  The newest head whose set is intact is in effect.  A new set is first written to
// bytes that do not belong to the current one, then its head, and then both are read back.
//
//     head: 8 bytes "smcswap1", u32 number, u32 address and u32 length of the set, u32 CRC-32 of the set, 16 bytes of code (bytecode-vm/auth.h)
//         over the fields from the number to the length and the set, zeros without a key, u32 CRC-32 of the head before it
//     set, of each machine: u8 n, n bytes name, u32 checksum of the image with which the application was built, u32 length, the image
//
// The image of a machine is not used if the application was built again with another image of this machine.  The memory must be one whose
// bytes can be rewritten without an erase (PalNvmInfo), such as a file.  Boards have a store of their own (store.h).
#ifndef SMVM_TARGET_SWAP_STORE_H
#define SMVM_TARGET_SWAP_STORE_H

#include "bytecode-vm/auth.h"
#include "bytecode-vm/target/slot.h"
#include "runtime-c/pal/nvm.h"

#ifdef __cplusplus
extern "C" {
#endif

// Bytes of a set of n machines, with images of up to `image` bytes each.
#define SM_SWAP_STORE_ROOM(n, image) ((n) * ((image) + 9u + SM_SWAP_NAME))

// A set of images in the non-volatile memory.
typedef struct SmSwapSet {
    uint32_t number;          // sequence number, modulo 2^32
    uint32_t at, length;      // address in the memory, and length in bytes
    bool is_intact;             // the checksums of head and set are right, and with a key the code
} SmSwapSet;

typedef struct SmSwapStore {
    SmSwapStorage storage;    // the first field: SM_SWAP_STORE_STORAGE
    const char *memory;       // name of the memory, for pal_nvm_open
    uint32_t room;            // most bytes of a set
    const uint8_t *key;       // SMVM_KEY bytes, valid when the storage opens; NULL: sets have no code
    // The fields below belong to the module; initially all zero.
    PalNvm nvm;                 // the opened memory
    SmSwapSet current;        // the newest intact set
} SmSwapStore;

// The functions of SM_SWAP_STORE_STORAGE.
// open: SM_E_FOREIGN: the memory has content of another program; it is left unchanged.  SM_E_UNSUPPORTED: the memory must be erased before it
// is written.  Other results as for pal_nvm_open.  A damaged set is not an error: an event says why a machine runs its built-in image.
SmResult sm_swap_store_open(SmSwapStorage *storage, SmSwaps *s, SmApp *app);
// save: SM_E_DEVICE: the memory does not contain what was written.  Other results as for pal_nvm_write.
SmResult sm_swap_store_save(SmSwapStorage *storage, SmSwaps *s);
void sm_swap_store_close(SmSwapStorage *storage);
#define SM_SWAP_STORE_STORAGE {sm_swap_store_open, sm_swap_store_save, sm_swap_store_close}

#ifdef __cplusplus
}
#endif
#endif
