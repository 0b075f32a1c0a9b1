// SPDX-License-Identifier: Apache-2.0
// The tank of examples/ written by hand for AVR, with every check that the language makes: what emitted C is measured against.
#ifndef AVR_TANK_HAND_H
#define AVR_TANK_HAND_H

#include "tank.h"             // for the state vector

typedef struct Hand {
    uint64_t counter, start, last;
    uint8_t state;            // that the next step runs
    bool first;               // it is the state's first
    bool stepped;             // `last` is the time of a step
} Hand;

void tank_by_hand_init(Hand *h, TankSv *sv, uint8_t state);
bool tank_by_hand_step(Hand *h, TankSv *sv);      // false: time has not advanced, or has ended; nothing has changed

#endif
