// SPDX-License-Identifier: Apache-2.0
// The console: text for people, on a terminal or a serial line.  It is for messages at start and on the bench: text is
// dropped rather than waited for, so that a slow line cannot hold up a step.  (Rules for all of these headers: pal.h.)
#ifndef PAL_CONSOLE_H
#define PAL_CONSOLE_H

#include "runtime-c/pal/pal.h"

#ifdef __cplusplus
extern "C" {
#endif

// Writes n bytes.  A line ends with '\n'; what else a terminal wants there, the platform adds.  Never waits.  Threads may write
// at the same time; the text of one call of up to 512 bytes stays together. SM_E_BUSY: the line takes no more now; what did not
// fit is lost.  SM_E_CLOSED: nobody reads it any more.
SmResult pal_console_write(const char *text, size_t n);

#ifdef __cplusplus
}
#endif
#endif
