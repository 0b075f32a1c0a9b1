// SPDX-License-Identifier: Apache-2.0
// The plant: stands for the rocket, its tank, the air and the converters behind the sensors, so that the application flies on a
// desk.  One dimension, 10 ms at a time, and nothing but + - * /, so that a flight is the same on every computer.  All it remembers
// is in the state vector, region World.  On a rocket this file is not there, and drivers write what it writes into region Raw.
#include "rocket_app.h"

static const double step    = 0.01;          // s
static const double gravity = 9.81;          // m/s2
static const double dryMass = 25.0;          // kg
static const double fuel    = 2.0;           // kg of propellant at lift-off, 1 kg to a litre
static const double gas     = 2.0;           // litres of gas above it, which press it out …
static const double full    = 40.0;          // … with so many bar at lift-off
static const double flow    = 0.025;         // kg/s through the open valve for each bar
static const double exhaust = 1500.0;        // m/s
static const double body    = 0.010;         // m2, drag coefficient times area
static const double chute   = 3.2;           // m2, the same of the open parachute
static const double opening = 1.5;           // s that it takes to open
static const double ground  = 100800.0;      // Pa, the pressure of the day
static const double density = 1.20;          // kg/m3 at the ground
static const double height  = 8434.0;        // m, scale height of the atmosphere
static const uint16_t rest  = 300;           // steps after landing when the simulation ends

// ---- noise ----

// A number from -1 to 1, even ones as likely as all others.  (A linear congruential generator, Knuth's MMIX.)
static double draw(void)
{
    uint64_t x = rocket_noise() * 6364136223846793005u + 1442695040888963407u;

    rocket_set_noise(x);
    return (double)(x >> 32) / 2147483648.0 - 1.0;
}

// Noise of that standard deviation; the sum of three is bell-shaped enough.
static double noise(double deviation)
{
    double a = draw(), b = draw();

    return deviation * (a + b + draw());
}

// As a converter of 16 bits: whole counts, and an end at both ends.
static uint16_t counts(double value)
{
    return value <= 0 ? 0 : value >= 65535 ? 65535 : (uint16_t)(value + 0.5);
}

// ---- the rocket ----

// What presses the propellant out: gas that fills what the propellant has left, at one temperature.
static double tank_pressure(void)
{
    return full * gas / (gas + fuel - rocket_propellant());
}

// Burns for one step; gives the thrust in newtons.
static double burn(void)
{
    double used = rocket_engineValve() ? flow * tank_pressure() * step : 0;

    if (used > rocket_propellant())
        used = rocket_propellant();
    rocket_set_propellant(rocket_propellant() - used);
    return used / step * exhaust;
}

static void open_canopy(void)
{
    if (rocket_parachuteCharge() || rocket_canopy() > 0)
        rocket_set_canopy(rocket_canopy() < 1 ? rocket_canopy() + step / opening : 1);
}

// How dense the air is, as a part of what it is on the ground: exp(-h), by the first terms of 1 / exp(h).
static double thinner(double altitude)
{
    double h = altitude / height;

    return 1 / (1 + h * (1 + h / 2 * (1 + h / 3 * (1 + h / 4))));
}

// Against the motion.
static double drag(double velocity)
{
    double area  = body + chute * rocket_canopy() * rocket_canopy();
    double force = 0.5 * density * thinner(rocket_trueAltitude()) * area * velocity * velocity;

    return velocity > 0 ? -force : force;
}

// One step of the rocket; gives the acceleration that it feels.
static double move(void)
{
    double felt     = (burn() + drag(rocket_trueVelocity())) / (dryMass + rocket_propellant());
    double velocity = rocket_trueVelocity() + (felt - gravity) * step;
    double altitude = rocket_trueAltitude() + velocity * step;
    bool stands     = altitude <= 0 && velocity <= 0;

    rocket_set_trueVelocity(stands ? 0 : velocity);
    rocket_set_trueAltitude(stands ? 0 : altitude);
    return stands ? gravity : felt;
}

// ---- the sensors ----

// One measurement in two hundred is wild: the radio is transmitting.
static void measure(double felt)
{
    bool wild = draw() > 0.99;

    rocket_set_rawAcceleration(counts(2000 + (felt + noise(0.3)) / 0.1));
    rocket_set_rawAirPressure(wild ? 65535 : counts((ground * thinner(rocket_trueAltitude()) + noise(15)) / 2));
    rocket_set_rawTankPressure(counts((tank_pressure() + noise(0.1)) / 0.01));
}

// Ends the application some seconds after the landing.
static void look_for_the_end(void)
{
    bool over = rocket_canopy() > 0 && rocket_trueAltitude() <= 0;

    rocket_set_stepsAtRest((uint16_t)(over ? rocket_stepsAtRest() + 1 : 0));
    if (rocket_stepsAtRest() >= rest)
        sm_app_stop(&rocket_app);
}

SmResult plant_step(const SmTick *tick)
{
    (void)tick;
    open_canopy();
    measure(move());
    look_for_the_end();
    return SM_OK;
}
