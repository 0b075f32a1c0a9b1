// SPDX-License-Identifier: Apache-2.0
// A machine one of whose sensors has read one thing for ever: windows that sample it hold nothing else, and locals that are made
// of it hold what is then stored in them.
//
//     DeadSensor d = dead_sensor_new(&sensors);
//     dead_sensor_reads(&d, pressure, fact_of_number(sm_from_i32(0)));
//     const Env *env = dead_sensor_begin(&d, state, BLOCK_STEP);   // with which the block then begins, in the analysis d.what
//
// Only what a state reads is looked into, and once a question: the next one begins with dead_sensor_reads.
// What can be then is never too little: what is impossible under these facts is impossible.  One thing is taken for granted: that
// a filter, x = 0.9 * x + 0.1 * pressure, has come to rest.  What an earlier state has noted under a guard is history: it may
// be from before the sensor died, and is left open.
#ifndef SMC_DEAD_SENSOR_H
#define SMC_DEAD_SENSOR_H

#include "compiler/analysis/sensors.h"
#include "compiler/analysis/whatif.h"

typedef struct DeadSensor {
    const Sensors *s;
    Analysis what;                // the analysis, with windows of its own
    const Var *sensor;
    Fact reads;
    const Env *env;               // what the sensor holds, and the locals that have been looked into
    uint32_t question;            // counts from 1
    uint32_t *local, *window;     // by Var.index, by IrMachine.window: the question in which it was looked into
    Fact *rest;                   // by Var.index, of one that was looked into: what it holds where a state keeps storing it
    bool *always;                 // by Var.index, likewise: none of its stores stands under a guard
    uint32_t *kept, *stored;      // by Var.index: the last look at a state that keeps storing it; at one that stores it at all
    uint32_t looks;               // counts looks at states
    Numbers changed;              // windows of this question
    unsigned depth;
    size_t work;                  // stores and samples looked at, in all questions
} DeadSensor;

DeadSensor dead_sensor_new(const Sensors *s);
void dead_sensor_reads(DeadSensor *d, const Var *sensor, Fact f);

// How a block of a state that can be reached begins.
const Env *dead_sensor_begin(DeadSensor *d, const State *state, BlockKind block);
// What the sensor and the locals that the state reads hold there, and nothing else.
const Env *dead_sensor_settled(DeadSensor *d, const State *state);

#endif
