// SPDX-License-Identifier: Apache-2.0
// The simulated devices when the test stand runs in real time: a stand at rest, with healthy sensors.  The application is stopped after as many
// calls as STANDIN_CALLS in the environment says; 0 or none: never.
#include <stdlib.h>

#include "NiFpga_Teststand.h"
#include "NiFpga_standin.h"
#include "teststand_app.h"

static void set(uint32_t address, double value) { standin_find(address)->value = value; }

NiFpga_Status standin_before(StandinCall call, StandinRegister *r)
{
    static unsigned long calls, last;

    (void)r;
    if (call == STANDIN_Open) {
        const char *text = getenv("STANDIN_CALLS");

        last = text ? strtoul(text, NULL, 10) : 0;
        set(NiFpga_Teststand_IndicatorI16_ChamberPressureA, 8.5 / 15 * 3276.8);
        set(NiFpga_Teststand_IndicatorI16_ChamberPressureB, 8.5 / 15 * 3276.8);
        set(NiFpga_Teststand_IndicatorI16_TankPressure, 47.5 / 15 * 3276.8);
        set(NiFpga_Teststand_IndicatorI32_LineTemperature, (293 - 23.15) / 200 * 1e6);
        set(NiFpga_Teststand_IndicatorSgl_Flow, 0.5);
    }
    if (++calls == last)
        sm_app_stop(&teststand_app);
    return 0;
}
