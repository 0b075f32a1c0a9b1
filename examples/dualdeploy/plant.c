// SPDX-License-Identifier: Apache-2.0
// The plant: stands for the rocket, the air and the altimeter, so that the application flies on a desk. 10 ms at a time, and nothing but
// + - * /, so that a flight is the same on every computer. On a rocket this file is not there.
#include "dualdeploy_app.h"

static const double step    = 0.01;          // s
static const double gravity = 9.81;          // m/s2
static const double thrust  = 60;            // m/s2 for …
static const uint64_t burn  = 300;           // … this many steps from the launch on
static const uint64_t launch = 200;          // steps after power-on
static const uint64_t rest  = 20000;         // steps after which the simulation ends

// The speed of fall at which drag is as large as weight.
static double falling_speed(void)
{
    return dualdeploy_mainState() > 1 ? 6 : dualdeploy_drogueState() > 1 ? 25 : 120;
}

SmResult plant_step(const SmTick *tick)
{
    const bool burns = tick->number >= launch && tick->number < launch + burn;
    const double limit = falling_speed();
    double speed = dualdeploy_speed(), altitude = dualdeploy_altitude();

    dualdeploy_set_armed(true);
    if (tick->number >= launch)
        speed += step * ((burns ? thrust : 0) - gravity);
    if (speed < -limit)
        speed = -limit;
    altitude += step * speed;
    if (altitude < 0)
        altitude = speed = 0;
    dualdeploy_set_speed(speed);
    dualdeploy_set_altitude(altitude);
    if (tick->number == rest)
        sm_app_stop(&dualdeploy_app);
    return SM_OK;
}
