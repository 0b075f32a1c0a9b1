// SPDX-License-Identifier: Apache-2.0
// What the stand does in a millisecond.  Coarse physics: each pressure goes a part of the way to where it would come to rest.
#include "bench_world.h"
#include "runtime-c/psl/sim/sim.h"

enum { CHAMBER_A, CHAMBER_B, TANK, LINE, FLOW, CHANNELS };                                        // as in teststand.io
enum { KEY_PIN, FLAME_PIN, IGNITER = 8, OXIDIZER, FUEL, CHILL, PURGE, VENT };

static const double ms = 0.001;   // s

void world_begin(World *w)
{
    static const World rest = {.tank = 40, .chamber = 1, .line = 293};

    *w = rest;
}

static bool on(const World *w, uint16_t pin)
{
    return sim_pin(pin) && !w->off;
}

// Without current the vent is open.
bool world_is_safe(const World *w)
{
    return !on(w, IGNITER) && !on(w, OXIDIZER) && !on(w, FUEL) && !on(w, CHILL) && !on(w, VENT);
}

// A part of the way to a goal, so that two thirds of it are gone in `seconds`.
static double toward(double now, double goal, double seconds)
{
    return now + (goal - now) * ms / seconds;
}

static void tank(World *w)
{
    if (!on(w, VENT))
        w->tank = toward(w->tank, 1, 0.8);
    else if (w->kind == TANK_LEAKS)
        w->tank = toward(w->tank, 1, 2);
    else if (w->kind == TANK_RISES)
        w->tank = toward(w->tank, 60, 1);
    else
        w->tank = toward(w->tank, 40, 0.5);
}

static void line(World *w)
{
    bool flows = on(w, CHILL) || w->oxidizer > 0.1;

    w->line = w->kind == WARM_LINE ? toward(w->line, 293, 1) : flows ? toward(w->line, 95, 1.5) : toward(w->line, 293, 60);
}

// Valves take 30 ms; what flows goes with the difference in pressure.
static void valves(World *w)
{
    bool oxidizer = on(w, OXIDIZER) || w->kind == OXIDIZER_OPEN;
    bool fuel     = on(w, FUEL) && w->kind != NO_FUEL;
    double push   = w->tank > w->chamber ? w->tank - w->chamber : 0;

    w->oxidizer = toward(w->oxidizer, oxidizer ? 0.045 * push : 0, 0.03);
    w->fuel     = toward(w->fuel, fuel ? 0.0135 * push : 0, 0.03);
}

// A flame needs both, and something that lights it or that burns already.
static void chamber(World *w)
{
    bool burns = w->fuel > 0.02 && w->oxidizer > 0.1 && (w->lit > 0.2 || w->chamber > 5);
    double hot = w->kind == HOT ? 60 : 16.2;

    w->lit     = on(w, IGNITER) && w->kind != NO_FLAME ? w->lit + ms : 0;
    w->chamber = toward(w->chamber, burns ? 1 + hot * (w->fuel + w->oxidizer) : 1 + 2 * w->oxidizer, 0.03);
}

// ---- what the pins show of it ----

// From -1 to 1, a linear congruential generator.
static double tremble(void)
{
    static uint32_t x = 1;

    x = x * 1664525u + 1013904223u;
    return (double)(x >> 8) / 8388608.0 - 1;
}

static void show(const World *w, int channel, double volts)
{
    bool mine = w->argument == channel;

    if (mine && w->kind == STUCK)
        return;
    if (mine && w->kind == OFFSET)
        volts += 5 / 15.0;
    if (mine && (w->kind == ZERO || w->kind == HIGH))
        volts = w->kind == ZERO ? 0 : 9.9;
    sim_set_analog((uint16_t)channel, (int32_t)((volts + 0.002 * tremble()) * 1e6));
}

static void show_all(const World *w)
{
    show(w, CHAMBER_A, (w->chamber + 7.5) / 15);
    show(w, CHAMBER_B, (w->chamber + 7.5) / 15);
    show(w, TANK, (w->tank + 7.5) / 15);
    show(w, LINE, (w->line - 23.15) / 200);
    show(w, FLOW, (w->oxidizer + 0.25) / 0.5);
    sim_drive(KEY_PIN, w->key);
    sim_drive(FLAME_PIN, w->lit > 0.2 || w->chamber > 5);
}

void world_step(World *w)
{
    tank(w);
    line(w);
    valves(w);
    chamber(w);
    show_all(w);
}
