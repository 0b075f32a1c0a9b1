// SPDX-License-Identifier: Apache-2.0
// See plants.h.  Pins are those of the .io files of examples/tank and examples/recovery.
#include "tests/avr/plants.h"

#include <stdio.h>
#include <string.h>

// ---- a tank that is filled up to SUPPLY psi and has a vent valve; its transducer outputs 0 to 5 V for 0 to 1250 psi ----

#define SUPPLY 820.0                 // above the warning, below the abort threshold of examples/tank

static struct { double time, psi, lowest, highest; unsigned opened; bool open; } tank = {0, 700, 1e9, 0, 0, false};

static void tank_step(double s)
{
    const bool open = board_pin(8);

    tank.time += s;
    tank.psi += (open ? -60 : tank.psi < SUPPLY ? 25 : 0) * s;
    tank.psi = tank.psi < 0 ? 0 : tank.psi;
    tank.opened += open && !tank.open;
    tank.open = open;
    if (tank.time > 0.1) {
        tank.lowest = tank.psi < tank.lowest ? tank.psi : tank.lowest;
        tank.highest = tank.psi > tank.highest ? tank.psi : tank.highest;
    }
    board_set_volts(0, tank.psi / 250);
}

static void tank_report(void)
{
    printf("tank: %.0f s, %.0f to %.0f psi, vent opened %u times\n", tank.time, tank.lowest, tank.highest, tank.opened);
}

// ---- a rocket: up, down under a drogue, down under the main; its altimeter outputs 0.5 V on the ground and 1 V more each 100 m ----

static struct { double time, altitude, speed, apogee, drogue, main; bool landed; double fired[2]; } rocket;

static double noise(void)
{
    static unsigned state = 12345;

    state = state * 1103515245u + 12345u;
    return (double)(state >> 16 & 0xff) / 255.0 - 0.5;
}

static void rocket_step(double s)
{
    const double pull = rocket.time < 1.2 ? 60 : 0, limit = rocket.main > 0 ? 5 : rocket.drogue > 0 ? 18 : 1000;

    rocket.time += s;
    if (board_pin(8) && rocket.drogue == 0) {
        rocket.drogue = rocket.time;
        rocket.fired[0] = rocket.altitude;
    }
    if (board_pin(9) && rocket.main == 0) {
        rocket.main = rocket.time;
        rocket.fired[1] = rocket.altitude;
    }
    rocket.speed += (pull - 9.81) * s;
    if (rocket.speed < -limit)
        rocket.speed = -limit;
    rocket.altitude += rocket.speed * s;
    if (rocket.altitude < 0) {
        rocket.landed = rocket.landed || rocket.time > 3;
        rocket.altitude = rocket.speed = 0;
    }
    rocket.apogee = rocket.altitude > rocket.apogee ? rocket.altitude : rocket.apogee;
    board_set_volts(0, 0.5 + (rocket.altitude + noise()) / 100);
}

static void rocket_report(void)
{
    printf("rocket: apogee %.0f m, drogue at %.0f m after %.1f s, main at %.0f m, %s\n", rocket.apogee, rocket.fired[0], rocket.drogue,
           rocket.fired[1], rocket.landed ? "landed" : "in flight");
}

static const Plant plants[] = {{"tank", tank_step, tank_report}, {"rocket", rocket_step, rocket_report}};

const Plant *plant_named(const char *name)
{
    for (unsigned i = 0; name && i < sizeof plants / sizeof *plants; i++)
        if (strcmp(plants[i].name, name) == 0)
            return &plants[i];
    return NULL;
}
