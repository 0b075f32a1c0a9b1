// SPDX-License-Identifier: Apache-2.0
// The Kalman filter.  A flight of 40 s, steps of 8 to 12 ms; the barometer jumps now and then, and some measurements have the variance 0, both of
// them in some steps.
#include "tests/bench/workloads/kalman.h"

#include "kalman_o0.h"
#include "kalman_o1.h"
#include "kalman_o2.h"
#include "kalman_os.h"
#include "tests/bench/rows.h"

WORKLOAD_ROWS(kalman, Kalman)

// The true acceleration at time t, in seconds: motor, ballistic, chute, ground.
static double acceleration(double t, double height, double speed)
{
    if (t < 2)
        return 0;
    if (t < 5)
        return 50;
    if (speed > 0)
        return -9.8 - 0.002 * speed * speed;
    if (height > 0)
        return -9.8 * (1 - speed * speed / 6400);
    return -speed / 0.05;
}

static void inputs(Rng *r, void *at, unsigned n, unsigned episode)
{
    double height = 0, speed = 0;
    KalmanIn *in = at;
    uint64_t time = 0;
    unsigned jump = 0;

    (void)episode;
    for (unsigned i = 0; i < n; i++) {
        const unsigned ms = 8 + rng_below(r, 5);
        const double a = acceleration((double)time / 1000, height, speed);
        time += ms;
        height += speed * ms / 1000;
        speed += a * ms / 1000;
        if (rng_below(r, 300) == 0)
            jump = 1 + rng_below(r, 30);
        memset(&in[i], 0, sizeof in[i]);
        in[i].time = time;
        in[i].accel = a + 0.3 + rng_noise(r, 1);
        in[i].baroVar = rng_below(r, 20) == 0 ? 0 : 4;
        in[i].baro = height + (in[i].baroVar > 0 ? rng_noise(r, 3) : 0) + (jump > 0 ? 90 : 0);
        in[i].fix = rng_below(r, 4) == 0;
        in[i].gpsVar = rng_below(r, 4) == 0 ? 0 : 9;
        in[i].gps = height + (in[i].gpsVar > 0 ? rng_noise(r, 5) : 0);
        jump -= jump > 0;
    }
}

const Workload workload_kalman = {
    WORKLOAD(kalman, Kalman), .steps = 4000, .warm = 100, .count = 3900, .check = 4000,
};
