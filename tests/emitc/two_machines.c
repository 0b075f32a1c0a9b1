// SPDX-License-Identifier: Apache-2.0
// A program with two machines that share a state vector, as C and as C++.  Exit code 0 if both behave as their sources define.
#include <stdio.h>

#include "bus.h"
#include "pump.h"
#include "valve.h"

static int failed;

static void check(int holds, const char *what)
{
    if (!holds) {
        printf("does not hold: %s\n", what);
        failed = 1;
    }
}

static void step(Valve *valve, Pump *pump, BusSv *sv, uint64_t time, double pressure)
{
    sv->G = time;
    sv->pressure = pressure;
    check(valve_step(valve, sv) == VALVE_OK, "the valve steps");
    check(pump_step(pump, sv) == PUMP_OK, "the pump steps");
}

int main(void)
{
    static Valve valve, copy;
    static Pump pump;
    static BusSv sv, before;

    check(valve_step(&valve, &sv) == VALVE_NO_STATE, "no step before init");
    check(valve_init(&valve, &sv, 0) == VALVE_NO_STATE && valve_init(&valve, &sv, 3) == VALVE_NO_STATE, "states are 1 and 2");
    check(valve_step(&valve, &sv) == VALVE_NO_STATE, "no step after an init that failed");
    check(valve_init(&valve, &sv, VALVE_INITIAL_STATE) == VALVE_OK, "the valve starts");
    check(pump_init(&pump, &sv, PUMP_STATE_Off) == PUMP_OK, "the pump starts");
    check(sv.S == 1 && sv.S2 == 1, "init writes S");

    step(&valve, &pump, &sv, 10, 700);
    check(valve.stored.valveOpen && valve.stored.S && pump.stored.pumpOn, "what was stored is told");
    check(pump_state(&pump) == PUMP_STATE_On && sv.S2 == PUMP_STATE_Off, "the transition comes with the next step");
    step(&valve, &pump, &sv, 20, 700);
    check(sv.pumpOn == 1 && pump.starts == 1 && !valve.stored.valveOpen && !valve.stored.S, "the pump runs");
    before = sv;
    check(valve_step(&valve, &sv) == VALVE_REFUSED && sv.S == before.S, "time has to advance");
    sv.G = UINT64_MAX;
    check(valve_step(&valve, &sv) == VALVE_REFUSED, "the last value of time is never a time");
    step(&valve, &pump, &sv, 30, 900);
    check(valve_state(&valve) == VALVE_STATE_Open, "high pressure opens");
    copy = valve;                                     // a copy runs independently, windows included
    step(&valve, &pump, &sv, 40, 501);
    check(valve_state(&valve) == VALVE_STATE_Open, "the average of 700, 900, 501 is above 700");
    step(&valve, &pump, &sv, 50, 98);
    check(valve_state(&valve) == VALVE_STATE_Shut, "that of 900, 501, 98 is not");
    sv.G = 60;
    sv.pressure = 1000;
    check(valve_step(&copy, &sv) == VALVE_OK && valve_state(&copy) == VALVE_STATE_Open, "the copy has seen 700, 900, 1000");
    check(valve_state_name(VALVE_STATE_Open)[0] == 'O' && valve_state_name(0)[0] == 0 && valve_state_name(99)[0] == 0, "names of states");
    return failed;
}
