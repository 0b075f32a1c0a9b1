// SPDX-License-Identifier: Apache-2.0
// The launch sequencer, handwritten.
#ifndef BENCH_SEQ40_H
#define BENCH_SEQ40_H

#include <stdbool.h>
#include <stdint.h>

#include "seq40_o2.h"
#include "tests/bench/workloads/frame.h"

typedef struct Seq40In {
    uint64_t time;
    float lox;
    float fuel;
    float chamber;
    int16_t chill;
    uint16_t bus;
    uint8_t go;
    uint8_t stop;
} Seq40In;

enum {
    SEQ_Idle = 1,
    SEQ_LightsOn,
    SEQ_CameraOn,
    SEQ_LoxVentOpen,
    SEQ_FuelVentOpen,
    SEQ_PurgeOn,
    SEQ_PurgeOff,
    SEQ_ChillOne,
    SEQ_ChillWait,
    SEQ_ChillTwo,
    SEQ_CountHold,
    SEQ_LoxVentShut,
    SEQ_LoxPressOne,
    SEQ_LoxSettleOne,
    SEQ_LoxPressTwo,
    SEQ_LoxSettleTwo,
    SEQ_FuelVentShut,
    SEQ_FuelPressOne,
    SEQ_FuelSettleOne,
    SEQ_FuelPressTwo,
    SEQ_FuelSettleTwo,
    SEQ_CountArm,
    SEQ_Arm,
    SEQ_LoxTop,
    SEQ_FuelTop,
    SEQ_PurgeTwo,
    SEQ_PurgeTwoOff,
    SEQ_CountTerminal,
    SEQ_IgniterOn,
    SEQ_FuelLead,
    SEQ_LoxOpen,
    SEQ_IgniterOff,
    SEQ_Burn,
    SEQ_FuelShut,
    SEQ_LoxShut,
    SEQ_PurgeAfter,
    SEQ_Safing,
    SEQ_Disarm,
    SEQ_Hold,
    SEQ_Abort,
};

typedef struct Seq40Native {
    uint32_t state;
    bool first;
    uint64_t start;
} Seq40Native;

void seq40_native_init(Seq40Native *m, Seq40Sv *sv);
void seq40_native_step(Seq40Native *m, Seq40Sv *sv);

typedef struct Seq40F64 { Frame frame; } Seq40F64;

void seq40_f64_init(Seq40F64 *m, Seq40Sv *sv);
void seq40_f64_step(Seq40F64 *m, Seq40Sv *sv);

#endif
