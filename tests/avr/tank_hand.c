// SPDX-License-Identifier: Apache-2.0
#include "tests/avr/tank_hand.h"

void tank_by_hand_init(Hand *h, TankSv *sv, uint8_t state)
{
    h->state = state;
    h->first = true;
    h->stepped = false;
    h->counter = 0;
    sv->state = state;
}

#ifdef TANK_I16               // the pressure is an I16
typedef int16_t Pressure;
static bool above(Pressure p, int16_t n, uint64_t bits) { return (void)bits, p > n; }
static bool below(Pressure p, int16_t n, uint64_t bits) { return (void)bits, p < n; }
#else
typedef SmF64 Pressure;
static bool above(Pressure p, int16_t n, uint64_t bits) { return (void)n, sm_lt(sm_from_bits(bits), p); }
static bool below(Pressure p, int16_t n, uint64_t bits) { return (void)n, sm_lt(p, sm_from_bits(bits)); }
#endif

static uint8_t vent(Hand *h, TankSv *sv)
{
    const Pressure p = sv->tankPressure;

    if (above(p, 775, 0x4088380000000000u)) {
        sv->valveOpen = true;
        if (h->counter < 0x20000000000000u)
            h->counter++;
    } else {
        sv->valveOpen = false;
    }
    if (!above(p, 500, 0x407F400000000000u) || !below(p, 825, 0x4089C80000000000u))
        return TANK_STATE_Abort;
    return h->counter > 1000 && sv->time - h->start > 4000 ? TANK_STATE_Idle : 0;
}

bool tank_by_hand_step(Hand *h, TankSv *sv)
{
    uint8_t next = 0;

    if ((h->stepped && sv->time <= h->last) || sv->time == UINT64_MAX)
        return false;
    h->stepped = true;
    h->last = sv->time;
    if (h->first) {
        h->first = false;
        h->start = sv->time;
        sv->state = h->state;
        if (h->state == TANK_STATE_TankVentControl)
            h->counter = 0;
    }
    if (h->state == TANK_STATE_TankVentControl)
        next = vent(h, sv);
    if (next != 0) {
        sv->valveOpen = true;
        h->state = next;
        h->first = true;
    }
    return true;
}
