// SPDX-License-Identifier: Apache-2.0
// Files that only grow: the flight log.  (Rules for all of these headers: pal.h.)
//
// A program that is killed loses nothing that was appended.  A power cut leaves a file that begins with what was there at the last
// pal_log_sync; of what came later anything may be missing or wrong.  What is stored there says itself where it is whole.
#ifndef PAL_LOG_H
#define PAL_LOG_H

#include "runtime-c/pal/pal.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct PalLogFile { uint8_t id; } PalLogFile;

// Opens a file by the name that the platform has for it (a path), to write behind what it holds; made if it is not there.
// SM_E_MISSING: no such folder.  SM_E_DENIED.  SM_E_BUSY: it is open already, here or in another program.
// SM_E_UNSUPPORTED: no files, or what has that name is none (a folder, a device).  SM_E_SPACE: no room for another file.
// SM_E_ARGUMENT: an empty name, one as long as PAL_NAME.  SM_E_FULL.
SmResult pal_log_open(PalLogFile *file, const char *name);

// Writes n bytes behind the others.  Waits for the system, not for the medium.  SM_E_SPACE: the medium is full.
// After an error the first of the bytes may be there: pal_log_size tells how many.
SmResult pal_log_append(PalLogFile file, const void *bytes, size_t n);

// Waits until all that was appended is on the medium: tens of milliseconds, seconds for an SD card that tidies up.
SmResult pal_log_sync(PalLogFile file);

// Reads the first n bytes of those that the file holds.  SM_E_ARGUMENT: it holds fewer.
SmResult pal_log_read(PalLogFile file, void *bytes, size_t n);

// How many bytes the file holds.
SmResult pal_log_size(PalLogFile file, uint64_t *size);

SmResult pal_log_close(PalLogFile file);

#ifdef __cplusplus
}
#endif
#endif
