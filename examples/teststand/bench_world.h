// SPDX-License-Identifier: Apache-2.0
// The test stand on the bench: tank, line, igniter and chamber behind the pins of teststand.io, and what can break of them.
#ifndef BENCH_WORLD_H
#define BENCH_WORLD_H

#include <stdbool.h>
#include <stdint.h>

typedef enum Kind {
    NOTHING,
    KEY,                      // the operator lets go
    STUCK, ZERO, FAILS, HIGH, OFFSET,             // channel `argument`
    NO_CHANNELS, NO_SWITCHES,
    WARM_LINE, NO_FLAME, NO_FUEL, HOT, TANK_LEAKS, TANK_RISES, OXIDIZER_OPEN,
    SLOW,                     // each reading of a channel takes `argument` ms
    NO_OUTPUTS,               // for `argument` ms, in which the operator lets go
    HANGS                     // for `argument` ms
} Kind;

typedef struct World {
    double tank, chamber;     // bar
    double line;              // K
    double oxidizer, fuel;    // kg/s
    double lit;               // s for which the igniter has been on
    bool key;
    bool off;                 // the watchdog has bitten: no current at any output
    Kind kind;                // what is broken
    int argument;
    int since;                // ms for which it has been
} World;

void world_begin(World *w);
// One millisecond: from what the pins say to what the channels show.
void world_step(World *w);

// Whether nothing feeds or lights the chamber, and the tank is open: seen at the pins.
bool world_is_safe(const World *w);

#endif
