// SPDX-License-Identifier: Apache-2.0
// Non-volatile memory: an array of bytes that is still there after the power was gone.  EEPROM, flash, a file.
// It has no files and no checksums: what is stored there says itself whether it is whole.  (Rules for all of these headers: pal.h.)
//
// A power cut: what a write or erase that returned SM_OK stored is there for good.  One that was under way when the
// power went leaves everything outside its range as it was.  Within the range, info.atomic says what to expect:
// each aligned unit of so many bytes holds what it held before or what was written, not a mixture; units are independent of
// each other.  0: the bytes of the range may be anything.
//
// These calls wait for the medium: milliseconds for EEPROM, up to seconds for an SD card that tidies up.  Make them from a
// thread without a deadline.
#ifndef PAL_NVM_H
#define PAL_NVM_H

#include "runtime-c/pal/pal.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct PalNvm { uint8_t id; } PalNvm;

typedef struct PalNvmInfo {
    uint32_t size;            // bytes there are; a multiple of the sizes below
    uint32_t write;           // place and length of a write are multiples of this; 1: any
    uint32_t erase;           // the same for an erase; 0: bytes may be written again without one
    uint32_t atomic;          // what survives a power cut whole, see above; 0: nothing
    uint64_t slowest;         // nanoseconds that a write or erase of one unit takes at most; 0: not known
    uint8_t blank;            // what every erased byte reads as, and bytes that were never written where erase is 0
} PalNvmInfo;

// Opens a memory by the name that the platform has for it (a path, "eeprom"), of which the caller needs `size` bytes.
// Where the platform can make it (a file), it is made, blank, if it is not there, and lengthened with blank bytes if it is too
// short.  SM_E_MISSING: there is none.  SM_E_SPACE: it is smaller than that.  SM_E_DENIED: not permitted.  SM_E_BUSY: it is
// open already, here or in another program.  SM_E_UNSUPPORTED: what has that name is no memory (a folder, a device).
// SM_E_ARGUMENT: size 0, an empty name, one as long as PAL_NAME.  SM_E_FULL.
SmResult pal_nvm_open(PalNvm *memory, const char *name, uint32_t size);

SmResult pal_nvm_info(PalNvm memory, PalNvmInfo *info);

// Reads n bytes from place `at` on.  SM_E_ARGUMENT: beyond the end.
SmResult pal_nvm_read(PalNvm memory, uint32_t at, void *bytes, uint32_t n);

// Stores n bytes from place `at` on; when it returns SM_OK they are stored for good.  Where info.erase is not 0, those bytes
// must have been erased since they were last written: SM_E_ARGUMENT if the platform can tell, otherwise they become anything.
// SM_E_ARGUMENT: beyond the end, or not multiples of info.write.  SM_E_SPACE: the medium is full.  After SM_E_SPACE and
// SM_E_DEVICE the range is as after a power cut.
SmResult pal_nvm_write(PalNvm memory, uint32_t at, const void *bytes, uint32_t n);

// Makes n bytes blank.  Where info.erase is 0 this is a write of blank bytes.  Results as of write.
SmResult pal_nvm_erase(PalNvm memory, uint32_t at, uint32_t n);

SmResult pal_nvm_close(PalNvm memory);

#ifdef __cplusplus
}
#endif
#endif
