// SPDX-License-Identifier: Apache-2.0
// The constants of the VI of examples/sbrio, in the form in which NI's FPGA Interface C API Generator writes them.  This file was written by hand:
// there is no such VI.
#ifndef NIFPGA_TESTSTAND_H
#define NIFPGA_TESTSTAND_H

#include "NiFpga.h"

#define NiFpga_Teststand_Bitfile "NiFpga_Teststand.lvbitx"
static const char *const NiFpga_Teststand_Signature = "00112233445566778899AABBCCDDEEFF";

typedef enum {
    NiFpga_Teststand_IndicatorBool_Key = 0x18002,
    NiFpga_Teststand_IndicatorBool_Flame = 0x18006
} NiFpga_Teststand_IndicatorBool;

typedef enum {
    NiFpga_Teststand_IndicatorI16_ChamberPressureA = 0x1800A,
    NiFpga_Teststand_IndicatorI16_ChamberPressureB = 0x1800E,
    NiFpga_Teststand_IndicatorI16_TankPressure = 0x18012
} NiFpga_Teststand_IndicatorI16;

typedef enum { NiFpga_Teststand_IndicatorI32_LineTemperature = 0x18014 } NiFpga_Teststand_IndicatorI32;
typedef enum { NiFpga_Teststand_IndicatorSgl_Flow = 0x18018 } NiFpga_Teststand_IndicatorSgl;

typedef enum {
    NiFpga_Teststand_ControlBool_Igniter = 0x1801E,
    NiFpga_Teststand_ControlBool_OxidizerValve = 0x18022,
    NiFpga_Teststand_ControlBool_FuelValve = 0x18026,
    NiFpga_Teststand_ControlBool_ChillValve = 0x1802A,
    NiFpga_Teststand_ControlBool_PurgeValve = 0x1802E,
    NiFpga_Teststand_ControlBool_VentValve = 0x18032
} NiFpga_Teststand_ControlBool;

#endif
