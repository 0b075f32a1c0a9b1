// SPDX-License-Identifier: Apache-2.0
// The launch sequencer by the definitions of the language: every value a double, every store a conversion.
#include "tests/bench/workloads/seq40.h"

#define T ((double)m->frame.T)
#define STOPS if (sv->stop || (double)sv->bus < 22000.0) return SEQ_Abort

void seq40_f64_init(Seq40F64 *m, Seq40Sv *sv)
{
    frame_init(&m->frame);
    sv->state = SEQ_Idle;
}

static void entry(Seq40F64 *m, Seq40Sv *sv)
{
    switch (m->frame.state) {
    case SEQ_LightsOn: sv->lights = true; break;
    case SEQ_CameraOn: sv->camera = true; break;
    case SEQ_LoxVentOpen: sv->loxVent = true; break;
    case SEQ_FuelVentOpen: sv->fuelVent = true; break;
    case SEQ_PurgeOn: sv->purge = true; break;
    case SEQ_PurgeOff: sv->purge = false; break;
    case SEQ_ChillOne: sv->chillValve = true; break;
    case SEQ_ChillWait: sv->camera = true; break;
    case SEQ_ChillTwo: sv->chillValve = true; break;
    case SEQ_CountHold: sv->count = 40; break;
    case SEQ_LoxVentShut: sv->loxVent = false; break;
    case SEQ_LoxPressOne: sv->pressLox = true; break;
    case SEQ_LoxSettleOne: sv->lowest = sm_to_f32(F(sv->lox)); break;
    case SEQ_LoxPressTwo: sv->pressLox = true; break;
    case SEQ_LoxSettleTwo: sv->lowest = sm_to_f32(F(sv->lox)); break;
    case SEQ_FuelVentShut: sv->fuelVent = false; break;
    case SEQ_FuelPressOne: sv->pressFuel = true; break;
    case SEQ_FuelSettleOne: sv->lowest = sm_to_f32(F(sv->fuel)); break;
    case SEQ_FuelPressTwo: sv->pressFuel = true; break;
    case SEQ_FuelSettleTwo: sv->lowest = sm_to_f32(F(sv->fuel)); break;
    case SEQ_CountArm: sv->count = 55; break;
    case SEQ_Arm: sv->armed = true; break;
    case SEQ_LoxTop: sv->pressLox = true; break;
    case SEQ_FuelTop: sv->pressFuel = true; break;
    case SEQ_PurgeTwo: sv->purge = true; break;
    case SEQ_PurgeTwoOff: sv->purge = false; break;
    case SEQ_CountTerminal: sv->count = 100; break;
    case SEQ_IgniterOn: sv->igniter = true; break;
    case SEQ_FuelLead: sv->fuelMain = true; break;
    case SEQ_LoxOpen: sv->loxMain = true; break;
    case SEQ_IgniterOff: sv->igniter = false; break;
    case SEQ_FuelShut: sv->fuelMain = false; break;
    case SEQ_LoxShut: sv->loxMain = false; break;
    case SEQ_PurgeAfter: sv->purge = true; break;
    case SEQ_Safing: sv->purge = false; break;
    case SEQ_Disarm: sv->armed = false; break;
    case SEQ_Hold:
        sv->holds = sm_to_u8((double)sv->holds + 1.0);
        sv->pressLox = false;
        sv->pressFuel = false;
        sv->chillValve = false;
        break;
    case SEQ_Abort:
        sv->loxMain = false;
        sv->fuelMain = false;
        sv->igniter = false;
        sv->pressLox = false;
        sv->pressFuel = false;
        sv->chillValve = false;
        sv->armed = false;
        sv->loxVent = true;
        sv->fuelVent = true;
        break;
    default: break;
    }
}

static uint32_t step(Seq40F64 *m, Seq40Sv *sv)
{
    switch (m->frame.state) {
    case SEQ_Idle: STOPS; return sv->go && T >= 200.0 ? SEQ_LightsOn : 0;
    case SEQ_LightsOn: STOPS; return T >= 300.0 ? SEQ_CameraOn : 0;
    case SEQ_CameraOn: STOPS; return T >= 450.0 ? SEQ_LoxVentOpen : 0;
    case SEQ_LoxVentOpen: STOPS; return T >= 800.0 ? SEQ_FuelVentOpen : 0;
    case SEQ_FuelVentOpen: STOPS; return T >= 700.0 ? SEQ_PurgeOn : 0;
    case SEQ_PurgeOn: STOPS; return T >= 1500.0 ? SEQ_PurgeOff : 0;
    case SEQ_PurgeOff: STOPS; return T >= 400.0 ? SEQ_ChillOne : 0;
    case SEQ_ChillOne: STOPS; return (double)sv->chill < -60.0 ? SEQ_ChillWait : T > 9000.0 ? SEQ_Hold : 0;
    case SEQ_ChillWait: STOPS; return T >= 900.0 ? SEQ_ChillTwo : 0;
    case SEQ_ChillTwo: STOPS; return (double)sv->chill < -120.0 ? SEQ_CountHold : T > 9000.0 ? SEQ_Hold : 0;
    case SEQ_CountHold: STOPS; sv->count = sm_to_u16((double)sv->count - 1.0); return !sv->go ? SEQ_Hold : (double)sv->count == 0.0 ? SEQ_LoxVentShut : 0;
    case SEQ_LoxVentShut: STOPS; return T >= 350.0 ? SEQ_LoxPressOne : 0;
    case SEQ_LoxPressOne: STOPS; return F(sv->lox) > 30.0 ? SEQ_Abort : F(sv->lox) >= 20.0 ? SEQ_LoxSettleOne : T > 6000.0 ? SEQ_Hold : 0;
    case SEQ_LoxSettleOne: STOPS; sv->lowest = sm_to_f32(sm_min(F(sv->lowest), F(sv->lox))); return T < 800.0 ? 0 : F(sv->lowest) > 12.0 ? SEQ_LoxPressTwo : SEQ_Hold;
    case SEQ_LoxPressTwo: STOPS; return F(sv->lox) > 42.0 ? SEQ_Abort : F(sv->lox) >= 30.0 ? SEQ_LoxSettleTwo : T > 6000.0 ? SEQ_Hold : 0;
    case SEQ_LoxSettleTwo: STOPS; sv->lowest = sm_to_f32(sm_min(F(sv->lowest), F(sv->lox))); return T < 900.0 ? 0 : F(sv->lowest) > 22.0 ? SEQ_FuelVentShut : SEQ_Hold;
    case SEQ_FuelVentShut: STOPS; return T >= 350.0 ? SEQ_FuelPressOne : 0;
    case SEQ_FuelPressOne: STOPS; return F(sv->fuel) > 30.0 ? SEQ_Abort : F(sv->fuel) >= 18.0 ? SEQ_FuelSettleOne : T > 6000.0 ? SEQ_Hold : 0;
    case SEQ_FuelSettleOne: STOPS; sv->lowest = sm_to_f32(sm_min(F(sv->lowest), F(sv->fuel))); return T < 700.0 ? 0 : F(sv->lowest) > 10.0 ? SEQ_FuelPressTwo : SEQ_Hold;
    case SEQ_FuelPressTwo: STOPS; return F(sv->fuel) > 42.0 ? SEQ_Abort : F(sv->fuel) >= 28.0 ? SEQ_FuelSettleTwo : T > 6000.0 ? SEQ_Hold : 0;
    case SEQ_FuelSettleTwo: STOPS; sv->lowest = sm_to_f32(sm_min(F(sv->lowest), F(sv->fuel))); return T < 900.0 ? 0 : F(sv->lowest) > 20.0 ? SEQ_CountArm : SEQ_Hold;
    case SEQ_CountArm: STOPS; sv->count = sm_to_u16((double)sv->count - 1.0); return !sv->go ? SEQ_Hold : (double)sv->count == 0.0 ? SEQ_Arm : 0;
    case SEQ_Arm: STOPS; return T >= 500.0 ? SEQ_LoxTop : 0;
    case SEQ_LoxTop: STOPS; return F(sv->lox) > 42.0 ? SEQ_Abort : F(sv->lox) >= 32.0 ? SEQ_FuelTop : T > 6000.0 ? SEQ_Hold : 0;
    case SEQ_FuelTop: STOPS; return F(sv->fuel) > 42.0 ? SEQ_Abort : F(sv->fuel) >= 30.0 ? SEQ_PurgeTwo : T > 6000.0 ? SEQ_Hold : 0;
    case SEQ_PurgeTwo: STOPS; return T >= 600.0 ? SEQ_PurgeTwoOff : 0;
    case SEQ_PurgeTwoOff: STOPS; return T >= 250.0 ? SEQ_CountTerminal : 0;
    case SEQ_CountTerminal: STOPS; sv->count = sm_to_u16((double)sv->count - 1.0); return !sv->go ? SEQ_Hold : (double)sv->count == 0.0 ? SEQ_IgniterOn : 0;
    case SEQ_IgniterOn: STOPS; return T >= 450.0 ? SEQ_FuelLead : 0;
    case SEQ_FuelLead: STOPS; return T >= 120.0 ? SEQ_LoxOpen : 0;
    case SEQ_LoxOpen: STOPS; return T >= 150.0 ? SEQ_IgniterOff : 0;
    case SEQ_IgniterOff: STOPS; return T >= 300.0 ? SEQ_Burn : 0;
    case SEQ_Burn: STOPS; return T > 200.0 && F(sv->chamber) < 8.0 ? SEQ_Abort : F(sv->chamber) > 60.0 ? SEQ_Abort : T >= 1800.0 ? SEQ_FuelShut : 0;
    case SEQ_FuelShut: STOPS; return T >= 100.0 ? SEQ_LoxShut : 0;
    case SEQ_LoxShut: STOPS; return T >= 400.0 ? SEQ_PurgeAfter : 0;
    case SEQ_PurgeAfter: STOPS; return T >= 900.0 ? SEQ_Safing : 0;
    case SEQ_Safing: STOPS; return T >= 500.0 ? SEQ_Disarm : 0;
    case SEQ_Disarm: STOPS; return T >= 600.0 ? SEQ_Idle : 0;
    case SEQ_Hold: return sv->stop ? SEQ_Abort : sv->go && T >= 500.0 ? SEQ_LightsOn : T > 20000.0 ? SEQ_Abort : 0;
    case SEQ_Abort: return !sv->stop && T >= 1000.0 ? SEQ_Idle : 0;
    default: return 0;
    }
}

static void leave(Seq40F64 *m, Seq40Sv *sv)
{
    switch (m->frame.state) {
    case SEQ_ChillOne: sv->chillValve = false; break;
    case SEQ_ChillTwo: sv->chillValve = false; break;
    case SEQ_LoxPressOne: sv->pressLox = false; break;
    case SEQ_LoxPressTwo: sv->pressLox = false; break;
    case SEQ_FuelPressOne: sv->pressFuel = false; break;
    case SEQ_FuelPressTwo: sv->pressFuel = false; break;
    case SEQ_LoxTop: sv->pressLox = false; break;
    case SEQ_FuelTop: sv->pressFuel = false; break;
    default: break;
    }
}

void seq40_f64_step(Seq40F64 *m, Seq40Sv *sv)
{
    uint32_t to;

    if (!frame_begin(&m->frame, sv->time, &sv->state))
        return;
    if (m->frame.first)
        entry(m, sv);
    to = step(m, sv);
    if (to != 0)
        leave(m, sv);
    frame_end(&m->frame, to);
}
