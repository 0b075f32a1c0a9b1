// SPDX-License-Identifier: Apache-2.0
// The tank as a flight-software engineer writes it: native types, compile-time constants, and no check that time advances.
#include "tests/bench/workloads/tank.h"

enum { VENT_CONTROL = 1, IDLE, ABORT };
enum { VENT_ABOVE = 775, LEAST = 500, MOST = 825, VENTS = 1000, VENT_TIME = 4000 };     // psi, psi, psi, steps, ms

void tank_native_init(TankNative *m, TankSv *sv)
{
    m->state = VENT_CONTROL;
    m->first = true;
    m->counter = 0;
    sv->state = VENT_CONTROL;
}

static void leave(TankNative *m, TankSv *sv, uint32_t to)
{
    sv->valveOpen = true;
    m->state = to;
    m->first = true;
}

static void vent_control(TankNative *m, TankSv *sv)
{
    const double pressure = sv->tankPressure;

    sv->valveOpen = pressure > VENT_ABOVE;
    if (sv->valveOpen)
        m->counter++;
    if (pressure <= LEAST || pressure >= MOST)
        leave(m, sv, ABORT);
    else if (m->counter > VENTS && sv->time - m->start > VENT_TIME)
        leave(m, sv, IDLE);
}

void tank_native_step(TankNative *m, TankSv *sv)
{
    if (m->first) {
        m->first = false;
        m->start = sv->time;
        m->counter = 0;
        sv->state = m->state;
    }
    switch (m->state) {
    case VENT_CONTROL:
        vent_control(m, sv);
        break;
    default:
        break;
    }
}
