// SPDX-License-Identifier: Apache-2.0
// The machine with 200 states, handwritten.
#ifndef BENCH_BIG200_H
#define BENCH_BIG200_H

#include <stdbool.h>
#include <stdint.h>

#include "big200_o2.h"
#include "tests/bench/workloads/frame.h"

typedef struct Big200In {
    uint64_t time;
    double rate;
    uint16_t level;
    uint8_t ready;
} Big200In;

typedef struct Big200Native { uint32_t state; bool first; } Big200Native;

void big200_native_init(Big200Native *m, Big200Sv *sv);
void big200_native_step(Big200Native *m, Big200Sv *sv);

typedef struct Big200F64 { Frame frame; } Big200F64;

void big200_f64_init(Big200F64 *m, Big200Sv *sv);
void big200_f64_step(Big200F64 *m, Big200Sv *sv);

#endif
