// SPDX-License-Identifier: Apache-2.0
// The navigation task: altitude and velocity from accelerometer and barometer, the one quick and drifting, the other slow and true.
// A filter of second order: the accelerometer moves the estimate, what the barometer says otherwise pulls it back, by a critically
// damped spring of 1.5 rad/s.  On the pad it learns the pressure of the day.
#include "rocket_app.h"

static const double step        = 0.01;      // s, the period of this task
static const double gravity     = 9.81;      // m/s2
static const double scaleHeight = 8434.0;    // m in which the pressure falls to 1/e
static const double rigid       = 1.5;       // rad/s
static const double farOff      = 40.0;      // m; a measurement so far from what is expected is not believed …
static const uint8_t patience   = 20;        // … unless so many in a row are

// Metres above the pad: ln(p0 / p) by the first terms of its series in (p0 - p) / (p0 + p), exact to centimetres up to 2 km.
static double barometric(double pressure, double atPad)
{
    double y = (atPad - pressure) / (atPad + pressure);

    return scaleHeight * 2 * (y + y * y * y / 3);
}

// Whether a measurement that is so many metres off is to be believed.
static bool believes(double error)
{
    bool far = error > farOff || error < -farOff;

    if (far)
        rocket_set_rejected(rocket_rejected() + 1);
    rocket_set_unbelieved((uint8_t)(!far ? 0 : rocket_unbelieved() < patience ? rocket_unbelieved() + 1 : patience));
    return !far || rocket_unbelieved() >= patience;
}

// The pressure on the pad: a slow average, which begins with the first measurement, or again after a wild one.
static void learn_pad(double pressure)
{
    double before = rocket_padPressure();

    if (before <= 0)
        rocket_set_padPressure(pressure);
    else if (believes(barometric(pressure, before)))
        rocket_set_padPressure(before + (rocket_unbelieved() > 0 ? 1 : 0.01) * (pressure - before));
    rocket_set_altitude(0);
    rocket_set_velocity(0);
}

static void estimate(double acceleration, double pressure)
{
    double velocity = rocket_velocity() + (acceleration - gravity) * step;
    double altitude = rocket_altitude() + velocity * step;
    double error    = barometric(pressure, rocket_padPressure()) - altitude;

    if (believes(error)) {
        altitude += 2 * rigid * step * error;
        velocity += rigid * rigid * step * error;
    }
    rocket_set_altitude(altitude);
    rocket_set_velocity(velocity);
}

SmResult navigation_step(const SmTick *tick)
{
    (void)tick;
    if (rocket_flying())
        estimate((double)rocket_acceleration(), (double)rocket_airPressure());
    else
        learn_pad((double)rocket_airPressure());
    return SM_OK;
}
