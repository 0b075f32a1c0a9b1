// SPDX-License-Identifier: Apache-2.0
// Non-volatile memory: an array of bytes that survives a power cut, such as EEPROM, flash or a file.  It has no file system and no
// checksums.  The format of the content must detect damage.  (Rules for all of these headers: pal.h.)
//
// Power cuts.  Bytes whose write or erase returned SM_OK are stored permanently.  A write or erase that was in progress when the
// power failed does not change bytes outside its range.  Inside its range PalNvmInfo.atomic applies.  Each aligned unit of that
// many bytes has either its old content or its new content, never a mixture.  Units are independent of each other.  If `atomic` is
// 0, the bytes of the range are undefined.
//
// These calls wait for the medium: milliseconds for EEPROM, up to seconds for an SD card that is reorganising its blocks.  Call
// them from a thread that has no deadline.
#ifndef PAL_NVM_H
#define PAL_NVM_H

#include "runtime-c/pal/pal.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct PalNvm { uint8_t id; } PalNvm;

typedef struct PalNvmInfo {
    uint32_t size;            // size in bytes; a multiple of the sizes below
    uint32_t write;           // address and length of a write must be multiples of this; 1: no restriction
    uint32_t erase;           // address and length of an erase must be multiples of this; 0: bytes can be rewritten without an erase
    uint32_t atomic;          // unit that a power cut leaves either old or new (see "Power cuts" above); 0: none
    uint64_t slowest;         // longest time to write or erase one unit, in nanoseconds; 0: unknown
    uint8_t blank;            // value of an erased byte; if `erase` is 0, also of a byte that was never written
} PalNvmInfo;

// Opens a memory by its platform-specific name (a path, "eeprom").  The caller needs `size` bytes.  If the platform can create the
// memory (a file), a missing one is created and a short one is extended.  New bytes are blank.
//     SM_E_MISSING       no such memory
//     SM_E_SPACE         it has fewer than `size` bytes
//     SM_E_DENIED        no permission
//     SM_E_BUSY          it is already open, in this program or another one
//     SM_E_UNSUPPORTED   the name is not a memory (a folder, a device)
//     SM_E_ARGUMENT      size is 0; or the name is empty, or not shorter than PAL_NAME
//     SM_E_FULL          the table has no free entry
SmResult pal_nvm_open(PalNvm *memory, const char *name, uint32_t size);

// Reads the first n bytes of a memory by its name, also while it is open.  Creates, changes and locks nothing, and needs no permission to write:
// for settings that another program makes.
//     SM_E_MISSING       no such memory
//     SM_E_SPACE         it has fewer than n bytes
//     SM_E_DENIED        no permission to read
//     SM_E_UNSUPPORTED   the name is not a memory (a folder, a device)
//     SM_E_ARGUMENT      n is 0; or the name is empty, or not shorter than PAL_NAME
SmResult pal_nvm_load(const char *name, void *bytes, uint32_t n);

SmResult pal_nvm_info(PalNvm memory, PalNvmInfo *info);

// Reads n bytes at address `at`.  SM_E_ARGUMENT: the range exceeds the memory.
SmResult pal_nvm_read(PalNvm memory, uint32_t at, void *bytes, uint32_t n);

// Writes n bytes at address `at`.  When it returns SM_OK they are stored permanently.  If info.erase is not 0, the bytes must have
// been erased since they were last written.  Otherwise the result is SM_E_ARGUMENT if the platform can detect this, and undefined
// content if it cannot.
// SM_E_ARGUMENT: the range exceeds the memory, or `at` and n are not multiples of info.write.  SM_E_SPACE: the medium is full.
// After SM_E_SPACE or SM_E_DEVICE the range is in the same state as after a power cut.
SmResult pal_nvm_write(PalNvm memory, uint32_t at, const void *bytes, uint32_t n);

// Makes n bytes blank.  If info.erase is 0, this writes blank bytes.  Results as for pal_nvm_write, but `at` and n must be
// multiples of info.erase if that is not 0.
SmResult pal_nvm_erase(PalNvm memory, uint32_t at, uint32_t n);

SmResult pal_nvm_close(PalNvm memory);

#ifdef __cplusplus
}
#endif
#endif
