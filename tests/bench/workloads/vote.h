// SPDX-License-Identifier: Apache-2.0
// The vote, handwritten.
#ifndef BENCH_VOTE_H
#define BENCH_VOTE_H

#include <stdbool.h>
#include <stdint.h>

#include "tests/bench/workloads/frame.h"
#include "tests/bench/workloads/hand_window.h"
#include "tests/bench/workloads/window.h"
#include "vote_o2.h"

typedef struct VoteIn {
    uint64_t time;
    float p1;
    float p2;
    float p3;
    float a1;
    float a2;
    int16_t t1;
    int16_t t2;
    uint8_t reset;
} VoteIn;

// ---- native types ----

HAND_RING(Five, five, float, 5)
HAND_RING(Nine, nine, float, 9)
HAND_RING(Fifteen, fifteen, float, 15)
HAND_RING(Twenty, twenty, float, 20)
HAND_RING(Fifty, fifty, float, 50)
HAND_RING(Three, three, int16_t, 3)
HAND_RING(Warm, warm, int16_t, 32)

typedef struct VoteNative {
    uint32_t state;
    bool first;
    uint64_t start;
    float m1, m2, m3;
    Five p1_five, p2_five, p3_five;
    Nine a1_nine;
    Fifteen a2_fifteen;
    Twenty p1_twenty, p2_twenty, p3_twenty;
    Fifty p1_fifty, a2_fifty;
    Three t2_three;
    Warm t1_warm;
    int32_t t1_sum;               // sum of t1_warm; exact, since all samples are integers
} VoteNative;

void vote_native_init(VoteNative *m, VoteSv *sv);
void vote_native_step(VoteNative *m, VoteSv *sv);

// ---- every value a double ----

enum { VOTE_WINDOWS = 12 };

typedef struct VoteF64 {
    Frame frame;
    float m1, m2, m3;
    Window window[VOTE_WINDOWS];
    double slot[VOTE_WINDOWS][50];
} VoteF64;

void vote_f64_init(VoteF64 *m, VoteSv *sv);
void vote_f64_step(VoteF64 *m, VoteSv *sv);

#endif
