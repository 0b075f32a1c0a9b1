// SPDX-License-Identifier: Apache-2.0
// The stand-in's VI of examples/sbrio.
#include "NiFpga_Teststand.h"
#include "NiFpga_standin.h"

#define IN(type, label)  {NiFpga_Teststand_Indicator##type##_##label, STANDIN_##type, false, 0, 0, false}
#define OUT(type, label) {NiFpga_Teststand_Control##type##_##label, STANDIN_##type, true, 0, 0, false}

static StandinRegister registers[] = {
    IN(Bool, Key), IN(Bool, Flame), IN(I16, ChamberPressureA), IN(I16, ChamberPressureB), IN(I16, TankPressure), IN(I32, LineTemperature), IN(Sgl, Flow),
    OUT(Bool, Igniter), OUT(Bool, OxidizerValve), OUT(Bool, FuelValve), OUT(Bool, ChillValve), OUT(Bool, PurgeValve), OUT(Bool, VentValve),
};
const StandinVi standin_vi = {"00112233445566778899AABBCCDDEEFF", registers, sizeof registers / sizeof *registers, true};
