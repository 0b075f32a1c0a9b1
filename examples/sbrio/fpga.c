// SPDX-License-Identifier: Apache-2.0
// The pins of the test stand (../teststand) on an NI sbRIO.  The VI converts what it measures:
//   pressures          I16, 10 V at 32768
//   line temperature   I32, microvolts
//   flow               Sgl, volts
#include "NiFpga_Teststand.h"
#define SBRIO_API NiFpga_Teststand
#include "runtime-c/psl/sbrio/fpga.h"

static const SbrioPin pins[] = {
    SBRIO_ANALOG_IN(0, I16, ChamberPressureA, 10.0 / 32768, 0),
    SBRIO_ANALOG_IN(1, I16, ChamberPressureB, 10.0 / 32768, 0),
    SBRIO_ANALOG_IN(2, I16, TankPressure, 10.0 / 32768, 0),
    SBRIO_ANALOG_IN(3, I32, LineTemperature, 0.000001, 0),
    SBRIO_ANALOG_IN(4, Sgl, Flow, 1, 0),
    SBRIO_DIGITAL_IN(0, Key, DOWN),
    SBRIO_DIGITAL_IN(1, Flame, DOWN),
    SBRIO_DIGITAL_OUT(8, Igniter),
    SBRIO_DIGITAL_OUT(9, OxidizerValve),
    SBRIO_DIGITAL_OUT(10, FuelValve),
    SBRIO_DIGITAL_OUT(11, ChillValve),
    SBRIO_DIGITAL_OUT(12, PurgeValve),
    SBRIO_DIGITAL_OUT(13, VentValve),
};
SBRIO_FPGA("/usr/local/teststand/", "RIO0", pins);
