# Pins become tables of constants; a make rule names what they depend on.
args build rocket.io --sv rocket.sv --emit=c -MD && cat rocket_io.h rocket_io.c rocket_io.d

-- rocket.sv --
[Sensors]
F64 tankPressure
bool limitSwitch
[Valves]
bool valveOpen
F32 heaterVoltage
-- rocket.io --
[analog]
i  0  tankPressure   @scale 250  @offset -125
o  3  heaterVoltage  @safe 0.5

[digital]
o  0  valveOpen
i  2  limitSwitch    @pull_up  @inverted @hold 3
-- stdout --
// The pins of rocket.  Made by smc from rocket.io: change that, not this file.
#ifndef ROCKET_IO_H_INCLUDED
#define ROCKET_IO_H_INCLUDED

#include "runtime-c/io.h"

#ifdef __cplusplus
extern "C" {
#endif

extern SmIo rocket_inputs, rocket_outputs;

#ifdef __cplusplus
}
#endif

#endif
// The pins of rocket.  Made by smc from rocket.io: change that, not this file.
#include "rocket_io.h"

#include "rocket.h"

#if ROCKET_SV_LAYOUT != 0x93824399u
#error "rocket_io was generated from another state vector: build it again"
#endif

// kind, type, flags, hold, pin, offset in the state vector; scale, offset and safe value as bits of a binary64.

static const SmIoPin input[2] = {
    {SM_ANALOG_IN, SM_F64, 0, 0, 0, 0, 0x406f400000000000u, 0xc05f400000000000u, 0},   // tankPressure, scale 250, offset -125
    {SM_DIGITAL_IN, SM_BOOL, SM_IO_INVERTED | SM_IO_PULL_UP, 3, 2, 8, 0, 0, 0},   // limitSwitch
};
static uint8_t input_handle[2];
static uint16_t input_missed[2];
static uint64_t input_value[2];

SmIo rocket_inputs = {input, 2, &rocket_vector, input_handle, input_missed, input_value, 0};

static const SmIoPin output[2] = {
    {SM_ANALOG_OUT, SM_F32, 0, 0, 3, 20, 0x3ff0000000000000u, 0, 0x3fe0000000000000u},   // heaterVoltage, safe 0.5
    {SM_DIGITAL_OUT, SM_BOOL, 0, 0, 0, 16, 0, 0, 0},   // valveOpen
};
static uint8_t output_handle[2];
static uint16_t output_missed[2];
static uint64_t output_value[2];

SmIo rocket_outputs = {output, 2, &rocket_vector, output_handle, output_missed, output_value, 0};
rocket_io.c rocket_io.h: rocket.io rocket.sv
