// SPDX-License-Identifier: Apache-2.0
// The console: text for people, on a terminal or a serial line.  It is meant for messages at start and on the bench.  Text that
// does not fit is dropped, so that a slow line cannot delay a step.  (Rules for all of these headers: pal.h.)
#ifndef PAL_CONSOLE_H
#define PAL_CONSOLE_H

#include "runtime-c/pal/pal.h"

#ifdef __cplusplus
extern "C" {
#endif

// Writes n bytes and never waits.  A line ends with '\n'; the platform adds any other characters that the terminal needs.  Several
// threads may write at the same time.  The text of one call is not interleaved with other text if it is at most 512 bytes.
// SM_E_BUSY: the line cannot accept more now, and the text that did not fit is lost.  SM_E_CLOSED: the reader has closed the line.
SmResult pal_console_write(const char *text, size_t n);

#ifdef __cplusplus
}
#endif
#endif
