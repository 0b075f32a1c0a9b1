// SPDX-License-Identifier: Apache-2.0
// Append-only files, for the flight log.  (Rules for all of these headers: pal.h.)
//
// If the program is killed, no appended bytes are lost.  After a power cut, the file begins with the bytes that it had at the last
// pal_log_sync.  Later bytes may be missing or wrong.  The format of the content must therefore detect damage.
#ifndef PAL_LOG_H
#define PAL_LOG_H

#include "runtime-c/pal/pal.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct PalLogFile { uint8_t id; } PalLogFile;

// Opens a file for appending, by its platform-specific name (a path).  Creates it if it does not exist.
//     SM_E_MISSING       no such folder
//     SM_E_DENIED        no permission
//     SM_E_BUSY          it is already open, in this program or another one
//     SM_E_UNSUPPORTED   the platform has no files, or the name is not a file (a folder, a device)
//     SM_E_SPACE         no room for another file
//     SM_E_ARGUMENT      the name is empty, or not shorter than PAL_NAME
//     SM_E_FULL          the table has no free entry
SmResult pal_log_open(PalLogFile *file, const char *name);

// Appends n bytes.  Waits for the operating system, not for the medium.  SM_E_SPACE: the medium is full.  After an error, some of
// the first bytes may have been written; pal_log_size returns the resulting size.
SmResult pal_log_append(PalLogFile file, const void *bytes, size_t n);

// Waits until all appended bytes are on the medium.  This takes tens of milliseconds, or seconds for an SD card that is
// reorganising its blocks.
SmResult pal_log_sync(PalLogFile file);

// Reads the first n bytes of the file.  SM_E_ARGUMENT: the file is shorter than n bytes.
SmResult pal_log_read(PalLogFile file, void *bytes, size_t n);

// Stores the size of the file in *size, in bytes.
SmResult pal_log_size(PalLogFile file, uint64_t *size);

SmResult pal_log_close(PalLogFile file);

#ifdef __cplusplus
}
#endif
#endif
