// SPDX-License-Identifier: Apache-2.0
// What a firmware of this folder and the computer that emulates it say to each other.  The firmware writes the address of its
// mailbox to GPIOR1 (low) and GPIOR2 (high) once, and these to GPIOR0.
#ifndef AVR_MAILBOX_H
#define AVR_MAILBOX_H

#include <stdint.h>

enum { AVR_READY = 3, AVR_BEGIN = 1, AVR_END = 2 };    // READY: the computer may look into the mailbox and change it

typedef struct Mailbox {
    uint64_t a, b, result;
    uint8_t op;
} Mailbox;

#endif
