// SPDX-License-Identifier: Apache-2.0
// Counts what occurred in the reference while it ran a program.  A differential test in which nothing ever saturates does not test saturation.
// watch.c replaces the reference's ref_number.c and ref_window.c in the test program, with their code unchanged.
#ifndef SM_DIFF_WATCH_H
#define SM_DIFF_WATCH_H

#include <stdint.h>

typedef struct Watch {
    uint64_t stores, saturated, nan, infinite, filled;
} Watch;

extern Watch watch;

#endif
