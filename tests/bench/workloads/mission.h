// SPDX-License-Identifier: Apache-2.0
// The mission, handwritten.
#ifndef BENCH_MISSION_H
#define BENCH_MISSION_H

#include <stdbool.h>
#include <stdint.h>

#include "mission_o2.h"
#include "tests/bench/workloads/hand_window.h"
#include "tests/bench/workloads/window.h"

typedef struct MissionIn {
    uint64_t time;
    double altitude;
    float acceleration;
    uint16_t battery;
    uint8_t armSwitch, launchButton;
} MissionIn;

enum { MEDIAN_OF = 11, AVERAGE_OF = 20, RANGE_OF = 15 };

// ---- native types ----

HAND_RING(Median, altitudes, double, 11)
HAND_RING(Average, accelerations, float, AVERAGE_OF)
HAND_RING(Range, recent, double, RANGE_OF)

typedef struct MissionNative {
    uint32_t state;
    bool first;
    uint64_t start;
    uint32_t in_state;        // time in the current state, ms
    double ground, top;
    float peak;
    uint16_t calm;
    uint8_t ignitions;
    Median altitude_median;
    Average acceleration_average;
    Range altitude_range;
} MissionNative;

void mission_native_init(MissionNative *m, MissionSv *sv);
void mission_native_step(MissionNative *m, MissionSv *sv);

// ---- every value a double ----

typedef struct MissionF64 {
    uint32_t state;
    bool first, ran;
    uint64_t start, last, T;
    double ground, top;
    float peak;
    uint16_t calm;
    uint8_t ignitions;
    Window median, average, range;
    double slots[MEDIAN_OF + AVERAGE_OF + RANGE_OF];
} MissionF64;

void mission_f64_init(MissionF64 *m, MissionSv *sv);
void mission_f64_step(MissionF64 *m, MissionSv *sv);

#endif
