// SPDX-License-Identifier: Apache-2.0
// The tank by the definitions of the language: every value a double, every store a conversion.
#include "stdlib/convert.h"
#include "tests/bench/workloads/tank.h"

enum { TANK_VENT_CONTROL = 1, IDLE, ABORT };

void tank_f64_init(TankF64 *m, TankSv *sv)
{
    memset(m, 0, sizeof *m);
    m->state = TANK_VENT_CONTROL;
    m->first = true;
    m->P_AbortThreshold = 825;
    sv->state = TANK_VENT_CONTROL;
}

static uint32_t vent_control(TankF64 *m, TankSv *sv)
{
    const double pressure = sm_read_f64(sv->tankPressure);

    if (pressure > 775.0) {
        sv->valveOpen = true;
        m->counter = sm_to_u64((double)m->counter + 1.0);
    } else {
        sv->valveOpen = false;
    }
    if (!(500.0 < pressure && pressure < (double)m->P_AbortThreshold))
        return ABORT;
    if ((double)m->counter > 1000.0 && (double)m->T > 4000.0)
        return IDLE;
    return 0;
}

void tank_f64_step(TankF64 *m, TankSv *sv)
{
    uint32_t to = 0;

    if (sv->time == UINT64_MAX || (m->ran && sv->time <= m->last))
        return;
    m->ran = true;
    m->last = sv->time;
    if (m->first) {
        m->start = sv->time;
        sv->state = m->state;
    }
    m->T = sv->time - m->start;
    if (m->state == TANK_VENT_CONTROL) {
        if (m->first)
            m->counter = 0;
        to = vent_control(m, sv);
        if (to != 0)
            sv->valveOpen = true;
    }
    m->first = to != 0;
    if (to != 0)
        m->state = to;
}
