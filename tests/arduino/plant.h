// SPDX-License-Identifier: Apache-2.0
// The hardware connected to the boards of these tests: the tank of plant.ss, in counts of the analog input.  It advances by a step at the
// end of each line that the sketch prints.
#ifndef TEST_PLANT_H
#define TEST_PLANT_H

#include <stdbool.h>

enum { PLANT_STEPS = 301, PLANT_STUCK = 200, PLANT_FIRST = 600, VALVE_PIN = 8 };

static inline int plant_next(int pressure, bool open, int step)       // `step`: number of the printed line, from 0
{
    return step >= PLANT_STUCK ? pressure + 2 : open ? pressure - 7 : pressure + 7;
}

#endif
