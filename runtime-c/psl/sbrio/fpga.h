// SPDX-License-Identifier: Apache-2.0
// The table of pins that a program for an NI sbRIO contains: which control or indicator of the FPGA's VI is which pin or channel.
// The program has one source file with this table:
//
//     #include "NiFpga_Stand.h"                  // written by NI's FPGA Interface C API Generator
//     #define SBRIO_API NiFpga_Stand             // the prefix of its constants
//     #include "runtime-c/psl/sbrio/fpga.h"
//
//     static const SbrioPin pins[] = {
//         SBRIO_ANALOG_IN(0, I16, TankPressure, 10.0 / 32768, 0),
//         SBRIO_ANALOG_OUT(1, Dbl, Heater, 1, 0),
//         SBRIO_DIGITAL_IN(0, Key, DOWN),
//         SBRIO_DIGITAL_OUT(8, Igniter),
//     };
//     SBRIO_FPGA("/usr/local/stand/", "RIO0", pins);
//
// The first number of a row is that of the pin in the .io file and of the calls of pal/dio.h and pal/aio.h.  Digital pins and analog channels are
// numbered separately.  An input is an indicator of the VI, an output a control.  The macros build the name of the generated constant from kind,
// type and label, so a row with a wrong type or label does not compile.
#ifndef PSL_SBRIO_FPGA_H
#define PSL_SBRIO_FPGA_H

#include "runtime-c/pal/pal.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum SbrioType {
#define SBRIO_TYPE(name, c, lowest, highest, whole) SBRIO_##name,
#include "runtime-c/psl/sbrio/types.def"
#undef SBRIO_TYPE
    SBRIO_TYPES
} SbrioType;

// The resistor that the board has at a digital input.  The runtime cannot switch it.
typedef enum SbrioPull { SBRIO_NONE, SBRIO_UP, SBRIO_DOWN } SbrioPull;

typedef struct SbrioPin {
    uint16_t number;
    bool output;
    uint8_t type;             // SbrioType; SBRIO_Bool: a digital pin
    uint8_t pull;             // SbrioPull
    uint32_t address;         // the generated constant that identifies the control or indicator
    double scale, zero;       // analog: volts (or amperes) = value * scale + zero; scale is not 0, and both are finite
} SbrioPin;

typedef struct SbrioFpga {
    const char *bitfile;      // its absolute path
    const char *const *signature;
    const char *resource;     // NI's name of the FPGA, such as "RIO0"
    const SbrioPin *pin;
    uint16_t pins;
} SbrioFpga;

// The program's table.  SBRIO_FPGA defines it.
extern const SbrioFpga sbrio_fpga;

// Returns the last negative status that a function of NI's library returned, 0 if there was none: for messages, since several statuses become the
// same SmResult (status.def).  Any thread can call it.
int32_t sbrio_last_error(void);

// The rows.  `type` is I8, U8, I16, U16, I32, U32, I64, U64, Sgl or Dbl; `label` is the name of the control or indicator, as in the generated
// constant; `pull` is NONE, UP or DOWN.
#define SBRIO_ANALOG_IN(number, type, label, scale, zero)  {number, false, SBRIO_##type, SBRIO_NONE, SBRIO_CONSTANT(Indicator##type, label), scale, zero}
#define SBRIO_ANALOG_OUT(number, type, label, scale, zero) {number, true, SBRIO_##type, SBRIO_NONE, SBRIO_CONSTANT(Control##type, label), scale, zero}
#define SBRIO_DIGITAL_IN(number, label, pull)              {number, false, SBRIO_Bool, SBRIO_##pull, SBRIO_CONSTANT(IndicatorBool, label), 1, 0}
#define SBRIO_DIGITAL_OUT(number, label)                   {number, true, SBRIO_Bool, SBRIO_NONE, SBRIO_CONSTANT(ControlBool, label), 1, 0}

// The table.  `folder` is a string literal: the absolute path of the folder of the bitfile, with a slash at its end.
#define SBRIO_FPGA(folder, resource, table) \
    const SbrioFpga sbrio_fpga = {folder SBRIO_JOIN(SBRIO_API, _Bitfile), &SBRIO_JOIN(SBRIO_API, _Signature), resource, table, sizeof(table) / sizeof *(table)}

#define SBRIO_CONSTANT(kind, label) SBRIO_JOIN(SBRIO_API, _##kind##_##label)
#define SBRIO_JOIN(api, rest)       SBRIO_JOIN_EXPANDED(api, rest)
#define SBRIO_JOIN_EXPANDED(api, rest) api##rest

#ifdef __cplusplus
}
#endif
#endif
