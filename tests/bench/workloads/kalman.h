// SPDX-License-Identifier: Apache-2.0
// The Kalman filter, handwritten.
#ifndef BENCH_KALMAN_H
#define BENCH_KALMAN_H

#include <stdbool.h>
#include <stdint.h>

#include "kalman_o2.h"
#include "tests/bench/workloads/frame.h"

typedef struct KalmanIn {
    uint64_t time;
    double accel;
    double baro;
    double baroVar;
    double gps;
    double gpsVar;
    uint8_t fix;
} KalmanIn;

typedef struct KalmanNative {
    uint32_t state;
    bool first;
    uint8_t misses;
    uint64_t start, last;
    double q, p00, p01, p02, p11, p12, p22;
} KalmanNative;

void kalman_native_init(KalmanNative *m, KalmanSv *sv);
void kalman_native_step(KalmanNative *m, KalmanSv *sv);

typedef struct KalmanF64 {
    Frame frame;
    uint64_t last;
    double q, p00, p01, p02, p11, p12, p22, a00, a01, a02, a11, a12, dt, e, a, y, s, k0, k1, k2, d;
    uint8_t misses;
} KalmanF64;

void kalman_f64_init(KalmanF64 *m, KalmanSv *sv);
void kalman_f64_step(KalmanF64 *m, KalmanSv *sv);

#endif
