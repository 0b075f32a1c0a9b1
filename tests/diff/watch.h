// SPDX-License-Identifier: Apache-2.0
// What the reference met while it ran a program: a differential test that never saturates proves nothing about saturating.
// watch.c replaces the reference's ref_number.c and ref_window.c in the test program; their code is unchanged.
#ifndef SM_DIFF_WATCH_H
#define SM_DIFF_WATCH_H

#include <stdint.h>

typedef struct Watch {
    uint64_t stores, saturated, nan, infinite, filled;
} Watch;

extern Watch watch;

#endif
