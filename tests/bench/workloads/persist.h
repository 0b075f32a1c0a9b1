// SPDX-License-Identifier: Apache-2.0
// The pressure stand, handwritten.
#ifndef BENCH_PERSIST_H
#define BENCH_PERSIST_H

#include <stdbool.h>
#include <stdint.h>

#include "persist_o2.h"
#include "tests/bench/workloads/frame.h"
#include "tests/bench/workloads/window.h"

enum { PRESSURES = 4, RATE_SIZE = 6, HEAT_SIZE = 11, DRIFT_SIZE = 31 };

typedef struct PersistIn {
    uint64_t time;
    float p[PRESSURES];
    float heat;
    int16_t current;
    uint8_t armed;
    uint8_t key;
    uint8_t link;
} PersistIn;

// Conditions that must hold.  In PersistNative each has the time of its first true sample.
enum {
    STUCK, HIGH = STUCK + PRESSURES, LEAK = HIGH + PRESSURES, ARMED = LEAK + PRESSURES, LINKED, UNLINKED, ALARM, FILLED, NEAR, CALM, CURRENT,
    FALLS, VENTED, CONDITIONS
};

typedef struct PersistNative {
    uint32_t state;
    bool first, ran, lastPressed, lastKey, lastLink, lastArmed;
    uint64_t start, last;
    uint64_t since[CONDITIONS];              // UINT64_MAX: false
    uint32_t currents;                       // samples
    float before[PRESSURES];
    unsigned n, heats, drifts;               // samples taken
    float p[RATE_SIZE][PRESSURES], heat[HEAT_SIZE];
    uint64_t pTime[RATE_SIZE], driftTime[DRIFT_SIZE];
    double mean[DRIFT_SIZE];
} PersistNative;

void persist_native_init(PersistNative *m, PersistSv *sv);
void persist_native_step(PersistNative *m, PersistSv *sv);

typedef struct PersistHeld { bool on; uint64_t since, samples; } PersistHeld;
typedef struct PersistRate { double slot[DRIFT_SIZE]; uint64_t time[DRIFT_SIZE]; uint32_t size, n, next; } PersistRate;

typedef struct PersistF64 {
    Frame frame;
    bool ran, pressed, lastPressed, linkWas, armedWas;
    double before[PRESSURES];
    PersistHeld held[CONDITIONS];
    PersistRate pressure[PRESSURES], drift;
    Window heat;
    double heatSlot[HEAT_SIZE];
    bool stuck[PRESSURES], high[PRESSURES], leak[PRESSURES];
    bool fellLink, fellArmed, roseKey, rosePress, jump, keyWas;
    uint64_t now;
} PersistF64;

void persist_f64_init(PersistF64 *m, PersistSv *sv);
void persist_f64_step(PersistF64 *m, PersistSv *sv);

#endif
