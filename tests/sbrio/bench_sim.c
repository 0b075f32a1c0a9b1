// SPDX-License-Identifier: Apache-2.0
// Connects the bench of the test stand (examples/teststand/bench.c) to the application through the stand-in.  The bench sets and reads simulated
// pins, which are controls and indicators here.  A failure of a pin becomes a failed call of NI's library.
#include "NiFpga_Teststand.h"
#include "NiFpga_standin.h"
#include "runtime-c/psl/sim/world.h"

// The numbers of the pins are those of teststand.io.
static const struct { uint16_t number; uint32_t address; } digital[] = {
    {0, NiFpga_Teststand_IndicatorBool_Key}, {1, NiFpga_Teststand_IndicatorBool_Flame}, {8, NiFpga_Teststand_ControlBool_Igniter},
    {9, NiFpga_Teststand_ControlBool_OxidizerValve}, {10, NiFpga_Teststand_ControlBool_FuelValve}, {11, NiFpga_Teststand_ControlBool_ChillValve},
    {12, NiFpga_Teststand_ControlBool_PurgeValve}, {13, NiFpga_Teststand_ControlBool_VentValve}};

static StandinRegister *pin_register(uint16_t number)
{
    for (size_t i = 0; i < sizeof digital / sizeof *digital; i++)
        if (digital[i].number == number)
            return standin_find(digital[i].address);
    return NULL;
}

// An output of a VI that is not running has no effect.
bool sim_pin(uint16_t pin) { return standin_runs() && pin_register(pin)->value != 0; }
void sim_drive(uint16_t pin, bool level) { pin_register(pin)->value = level; }

// Returns what the VI measures at a voltage: its converter returns 32768 at 10 V.
static double whole(double x) { return (double)(int32_t)x; }
void sim_set_analog(uint16_t channel, int32_t millionths)
{
    static const uint32_t pressures[] = {NiFpga_Teststand_IndicatorI16_ChamberPressureA, NiFpga_Teststand_IndicatorI16_ChamberPressureB, NiFpga_Teststand_IndicatorI16_TankPressure};
    const double volts = millionths / 1e6;

    if (channel < 3)
        standin_find(pressures[channel])->value = whole(volts * 3276.8);
    else if (channel == 3)
        standin_find(NiFpga_Teststand_IndicatorI32_LineTemperature)->value = millionths;
    else
        standin_find(NiFpga_Teststand_IndicatorSgl_Flow)->value = volts;
}

void sim_dio_reset(void) { standin_reset(); }
void sim_aio_reset(void) {}

NiFpga_Status standin_before(StandinCall call, StandinRegister *r)
{
    const bool is_digital = r && r->type == STANDIN_Bool;

    if (call == STANDIN_Read)
        return sim_begin_call(is_digital ? SIM_dio_read : SIM_aio_read) == SM_OK ? 0 : -63150;
    if (call == STANDIN_Write)
        return sim_begin_call(is_digital ? SIM_dio_write : SIM_aio_write) == SM_OK ? 0 : -63150;
    return 0;
}
