// SPDX-License-Identifier: Apache-2.0
// The tank of examples/, handwritten for AVR, with every check that the language requires.  Emitted C is compared with it.
#ifndef AVR_TANK_HAND_H
#define AVR_TANK_HAND_H

#include "tank.h"             // for the state vector

typedef struct Hand {
    uint64_t counter, start, last;
    uint8_t state;            // the state that the next step executes
    bool first;               // the next step is the first one in its state
    bool stepped;             // a step has been executed, at the time `last`
} Hand;

void tank_by_hand_init(Hand *h, TankSv *sv, uint8_t state);
bool tank_by_hand_step(Hand *h, TankSv *sv);      // returns false and changes nothing if time has not advanced, or is the largest

#endif
