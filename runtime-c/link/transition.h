// SPDX-License-Identifier: Apache-2.0
// The record of a transition in the log that a board stores in the slot of its image (docs/link.md, chapter 9), for both ends: a board
// writes it, a host reads it with READ.  A record belongs to the image whose checksum went into its check.
#ifndef SM_TRANSITION_H
#define SM_TRANSITION_H

#include "runtime-c/link/link.h"

#ifdef __cplusplus
extern "C" {
#endif

enum {
    LINK_TRANSITION = 12,     // bytes: number, machine and `lost` << 4, u16 from, u16 to, u32 time, u16 check
    LINK_TRANSITIONS = 120,   // the most records of a log: fewer than 128, so that their numbers have an order
    LINK_LOST_MAX = 15
};

typedef struct LinkTransition {
    uint8_t number;           // modulo 256: one more than that of the record before
    uint8_t machine;          // number of the machine in the image, 0 to 15
    uint8_t lost;             // how many transitions before it were not stored; LINK_LOST_MAX: that many or more
    uint16_t from, to;        // states; from 0: the machine started
    uint32_t time;            // since the start of the board, in units of 2^20 ns
} LinkTransition;

void sm_link_store_transition(uint8_t *record, const LinkTransition *t, uint32_t checksum);

// Returns false if these bytes are no record of the image with this checksum.
bool sm_link_load_transition(const uint8_t *record, uint32_t checksum, LinkTransition *t);

// Whether a record with this number is later than one with the number `other`.  Numbers are modulo 256 and differ by less than 128.
static inline bool sm_link_is_later(uint8_t number, uint8_t other) { return number != other && (uint8_t)(number - other) < 128; }

#ifdef __cplusplus
}
#endif
#endif
