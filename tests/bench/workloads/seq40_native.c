// SPDX-License-Identifier: Apache-2.0
// The launch sequencer as a flight-software engineer writes it: one function for each kind of state.  The compiler inlines it with the constants
// of each state.
#include "tests/bench/workloads/seq40.h"

enum { BUS_LOW = 22000 };                                        // mV

void seq40_native_init(Seq40Native *m, Seq40Sv *sv)
{
    m->state = SEQ_Idle;
    m->first = true;
    m->start = 0;
    sv->state = SEQ_Idle;
}

static inline void go_to(Seq40Native *m, uint32_t to)
{
    m->state = to;
    m->first = true;
}

static inline void valve(Seq40Native *m, uint64_t in_state, uint64_t wait, uint32_t next)
{
    if (in_state >= wait)
        go_to(m, next);
}

static inline void cool(Seq40Native *m, Seq40Sv *sv, uint64_t in_state, int limit, uint64_t most, uint32_t next)
{
    if (sv->chill < limit || in_state > most) {
        sv->chillValve = false;
        go_to(m, sv->chill < limit ? next : SEQ_Hold);
    }
}

static inline void count(Seq40Native *m, Seq40Sv *sv, uint32_t next)
{
    if (sv->count > 0)
        sv->count--;
    if (!sv->go)
        go_to(m, SEQ_Hold);
    else if (sv->count == 0)
        go_to(m, next);
}

static inline void press(Seq40Native *m, uint64_t in_state, float pressure, uint8_t *out, float least, float most, uint64_t longest, uint32_t next)
{
    if (pressure >= least || in_state > longest) {
        *out = false;
        go_to(m, pressure > most ? SEQ_Abort : pressure >= least ? next : SEQ_Hold);
    }
}

static inline void settle(Seq40Native *m, Seq40Sv *sv, uint64_t in_state, float pressure, float least, uint64_t wait, uint32_t next)
{
    sv->lowest = pressure < sv->lowest ? pressure : sv->lowest;
    if (in_state >= wait)
        go_to(m, sv->lowest > least ? next : SEQ_Hold);
}

// Makes the transition to Abort if the machine must stop, and returns whether it does.  All states but Hold and Abort call it first.
static inline bool stops(Seq40Native *m, Seq40Sv *sv)
{
    if (sv->stop || sv->bus < BUS_LOW) {
        go_to(m, SEQ_Abort);
        return true;
    }
    return false;
}

static void hold(Seq40Native *m, Seq40Sv *sv, bool first, uint64_t in_state)
{
    if (first) {
        if (sv->holds < UINT8_MAX)
            sv->holds++;
        sv->pressLox = sv->pressFuel = sv->chillValve = false;
    }
    if (sv->stop)
        go_to(m, SEQ_Abort);
    else if (sv->go && in_state >= 500)
        go_to(m, SEQ_LightsOn);
    else if (in_state > 20000)
        go_to(m, SEQ_Abort);
}

static void aborted(Seq40Native *m, Seq40Sv *sv, bool first, uint64_t in_state)
{
    if (first) {
        sv->loxMain = sv->fuelMain = sv->igniter = sv->pressLox = sv->pressFuel = sv->chillValve = sv->armed = false;
        sv->loxVent = sv->fuelVent = true;
    }
    if (!sv->stop && in_state >= 1000)
        go_to(m, SEQ_Idle);
}

void seq40_native_step(Seq40Native *m, Seq40Sv *sv)
{
    const bool first = m->first;
    uint64_t t;

    if (first) {
        m->first = false;
        m->start = sv->time;
        sv->state = m->state;
    }
    t = sv->time - m->start;
    switch (m->state) {
    case SEQ_Idle:
        if (!stops(m, sv) && sv->go && t >= 200)
            go_to(m, SEQ_LightsOn);
        break;
    case SEQ_LightsOn:
        if (first)
            sv->lights = true;
        if (!stops(m, sv))
            valve(m, t, 300, SEQ_CameraOn);
        break;
    case SEQ_CameraOn:
        if (first)
            sv->camera = true;
        if (!stops(m, sv))
            valve(m, t, 450, SEQ_LoxVentOpen);
        break;
    case SEQ_LoxVentOpen:
        if (first)
            sv->loxVent = true;
        if (!stops(m, sv))
            valve(m, t, 800, SEQ_FuelVentOpen);
        break;
    case SEQ_FuelVentOpen:
        if (first)
            sv->fuelVent = true;
        if (!stops(m, sv))
            valve(m, t, 700, SEQ_PurgeOn);
        break;
    case SEQ_PurgeOn:
        if (first)
            sv->purge = true;
        if (!stops(m, sv))
            valve(m, t, 1500, SEQ_PurgeOff);
        break;
    case SEQ_PurgeOff:
        if (first)
            sv->purge = false;
        if (!stops(m, sv))
            valve(m, t, 400, SEQ_ChillOne);
        break;
    case SEQ_ChillOne:
        if (first)
            sv->chillValve = true;
        if (!stops(m, sv))
            cool(m, sv, t, -60, 9000, SEQ_ChillWait);
        else
            sv->chillValve = false;
        break;
    case SEQ_ChillWait:
        if (first)
            sv->camera = true;
        if (!stops(m, sv))
            valve(m, t, 900, SEQ_ChillTwo);
        break;
    case SEQ_ChillTwo:
        if (first)
            sv->chillValve = true;
        if (!stops(m, sv))
            cool(m, sv, t, -120, 9000, SEQ_CountHold);
        else
            sv->chillValve = false;
        break;
    case SEQ_CountHold:
        if (first)
            sv->count = 40;
        if (!stops(m, sv))
            count(m, sv, SEQ_LoxVentShut);
        break;
    case SEQ_LoxVentShut:
        if (first)
            sv->loxVent = false;
        if (!stops(m, sv))
            valve(m, t, 350, SEQ_LoxPressOne);
        break;
    case SEQ_LoxPressOne:
        if (first)
            sv->pressLox = true;
        if (!stops(m, sv))
            press(m, t, sv->lox, &sv->pressLox, 20, 30, 6000, SEQ_LoxSettleOne);
        else
            sv->pressLox = false;
        break;
    case SEQ_LoxSettleOne:
        if (first)
            sv->lowest = sv->lox;
        if (!stops(m, sv))
            settle(m, sv, t, sv->lox, 12, 800, SEQ_LoxPressTwo);
        break;
    case SEQ_LoxPressTwo:
        if (first)
            sv->pressLox = true;
        if (!stops(m, sv))
            press(m, t, sv->lox, &sv->pressLox, 30, 42, 6000, SEQ_LoxSettleTwo);
        else
            sv->pressLox = false;
        break;
    case SEQ_LoxSettleTwo:
        if (first)
            sv->lowest = sv->lox;
        if (!stops(m, sv))
            settle(m, sv, t, sv->lox, 22, 900, SEQ_FuelVentShut);
        break;
    case SEQ_FuelVentShut:
        if (first)
            sv->fuelVent = false;
        if (!stops(m, sv))
            valve(m, t, 350, SEQ_FuelPressOne);
        break;
    case SEQ_FuelPressOne:
        if (first)
            sv->pressFuel = true;
        if (!stops(m, sv))
            press(m, t, sv->fuel, &sv->pressFuel, 18, 30, 6000, SEQ_FuelSettleOne);
        else
            sv->pressFuel = false;
        break;
    case SEQ_FuelSettleOne:
        if (first)
            sv->lowest = sv->fuel;
        if (!stops(m, sv))
            settle(m, sv, t, sv->fuel, 10, 700, SEQ_FuelPressTwo);
        break;
    case SEQ_FuelPressTwo:
        if (first)
            sv->pressFuel = true;
        if (!stops(m, sv))
            press(m, t, sv->fuel, &sv->pressFuel, 28, 42, 6000, SEQ_FuelSettleTwo);
        else
            sv->pressFuel = false;
        break;
    case SEQ_FuelSettleTwo:
        if (first)
            sv->lowest = sv->fuel;
        if (!stops(m, sv))
            settle(m, sv, t, sv->fuel, 20, 900, SEQ_CountArm);
        break;
    case SEQ_CountArm:
        if (first)
            sv->count = 55;
        if (!stops(m, sv))
            count(m, sv, SEQ_Arm);
        break;
    case SEQ_Arm:
        if (first)
            sv->armed = true;
        if (!stops(m, sv))
            valve(m, t, 500, SEQ_LoxTop);
        break;
    case SEQ_LoxTop:
        if (first)
            sv->pressLox = true;
        if (!stops(m, sv))
            press(m, t, sv->lox, &sv->pressLox, 32, 42, 6000, SEQ_FuelTop);
        else
            sv->pressLox = false;
        break;
    case SEQ_FuelTop:
        if (first)
            sv->pressFuel = true;
        if (!stops(m, sv))
            press(m, t, sv->fuel, &sv->pressFuel, 30, 42, 6000, SEQ_PurgeTwo);
        else
            sv->pressFuel = false;
        break;
    case SEQ_PurgeTwo:
        if (first)
            sv->purge = true;
        if (!stops(m, sv))
            valve(m, t, 600, SEQ_PurgeTwoOff);
        break;
    case SEQ_PurgeTwoOff:
        if (first)
            sv->purge = false;
        if (!stops(m, sv))
            valve(m, t, 250, SEQ_CountTerminal);
        break;
    case SEQ_CountTerminal:
        if (first)
            sv->count = 100;
        if (!stops(m, sv))
            count(m, sv, SEQ_IgniterOn);
        break;
    case SEQ_IgniterOn:
        if (first)
            sv->igniter = true;
        if (!stops(m, sv))
            valve(m, t, 450, SEQ_FuelLead);
        break;
    case SEQ_FuelLead:
        if (first)
            sv->fuelMain = true;
        if (!stops(m, sv))
            valve(m, t, 120, SEQ_LoxOpen);
        break;
    case SEQ_LoxOpen:
        if (first)
            sv->loxMain = true;
        if (!stops(m, sv))
            valve(m, t, 150, SEQ_IgniterOff);
        break;
    case SEQ_IgniterOff:
        if (first)
            sv->igniter = false;
        if (!stops(m, sv))
            valve(m, t, 300, SEQ_Burn);
        break;
    case SEQ_Burn:
        if (stops(m, sv))
            break;
        if ((t > 200 && sv->chamber < 8) || sv->chamber > 60)
            go_to(m, SEQ_Abort);
        else if (t >= 1800)
            go_to(m, SEQ_FuelShut);
        break;
    case SEQ_FuelShut:
        if (first)
            sv->fuelMain = false;
        if (!stops(m, sv))
            valve(m, t, 100, SEQ_LoxShut);
        break;
    case SEQ_LoxShut:
        if (first)
            sv->loxMain = false;
        if (!stops(m, sv))
            valve(m, t, 400, SEQ_PurgeAfter);
        break;
    case SEQ_PurgeAfter:
        if (first)
            sv->purge = true;
        if (!stops(m, sv))
            valve(m, t, 900, SEQ_Safing);
        break;
    case SEQ_Safing:
        if (first)
            sv->purge = false;
        if (!stops(m, sv))
            valve(m, t, 500, SEQ_Disarm);
        break;
    case SEQ_Disarm:
        if (first)
            sv->armed = false;
        if (!stops(m, sv))
            valve(m, t, 600, SEQ_Idle);
        break;
    case SEQ_Hold: hold(m, sv, first, t); break;
    default: aborted(m, sv, first, t); break;
    }
}
