// SPDX-License-Identifier: Apache-2.0
// The arithmetic.  Readings drift, rates sometimes exceed their types, and at times a sensor is at its limit.
#include "tests/bench/workloads/arith.h"

#include "arith_o0.h"
#include "arith_o1.h"
#include "arith_o2.h"
#include "arith_os.h"
#include "tests/bench/rows.h"

WORKLOAD_ROWS(arith, Arith)

static double limit(double x, double least, double most)
{
    return x < least ? least : x > most ? most : x;
}

static uint16_t reading(Rng *r, double *mean)                  // returns a reading of an analogue input: 0 … 4095
{
    *mean = limit(*mean + rng_noise(r, 60), 200, 3900);
    if (rng_below(r, 64) == 0)
        return rng_below(r, 2) != 0 ? 4095 : 0;
    return (uint16_t)(*mean + rng_noise(r, 30));
}

static int16_t rate(Rng *r, double *mean)
{
    *mean = limit(*mean * 0.999 + rng_noise(r, 900), -30000, 30000);
    return (int16_t)(*mean + rng_noise(r, 300));
}

static void inputs(Rng *r, void *at, unsigned n, unsigned episode)
{
    double adc[3] = {2000, 1000, 1700}, gyro[3] = {0, 0, 0}, encoder = 0, pressure = 101;
    ArithIn *in = at;
    int setpoint = 0, mode = 0, enable = 1;

    (void)episode;
    for (unsigned i = 0; i < n; i++) {
        if (rng_below(r, 200) == 0)
            setpoint = (int)rng_below(r, 4000) - 2000;
        if (rng_below(r, 100) == 0)
            mode = (int)rng_below(r, 4);
        if (rng_below(r, 100) == 0)
            enable = !enable;
        encoder += (setpoint - encoder) * 0.02 + rng_noise(r, 10);
        pressure = limit(pressure + rng_noise(r, 0.1), 20, 102);
        memset(&in[i], 0, sizeof in[i]);
        in[i].time = i + 1;
        in[i].pressure = pressure;
        in[i].setpoint = setpoint;
        in[i].encoder = (int32_t)encoder;
        in[i].airspeed = (float)(50 + rng_noise(r, 40));
        in[i].gyroX = rate(r, &gyro[0]);
        in[i].gyroY = rate(r, &gyro[1]);
        in[i].gyroZ = rate(r, &gyro[2]);
        in[i].adc0 = reading(r, &adc[0]);
        in[i].adc1 = reading(r, &adc[1]);
        in[i].adc2 = reading(r, &adc[2]);
        in[i].trim = (int8_t)((int)rng_below(r, 41) - 20);
        in[i].mode = (uint8_t)mode;
        in[i].enable = (uint8_t)enable;
    }
}

const Workload workload_arith = {
    WORKLOAD(arith, Arith), .steps = 4000, .warm = 100, .count = 3900, .check = 4000,
};
