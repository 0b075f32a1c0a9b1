// SPDX-License-Identifier: Apache-2.0
// The bench of the sbRIO platform: this computer, as for Linux, and the stand-in for NI's library (tests/sbrio).  Its VI has a control of each
// type, and an indicator that has the same value.
#define _GNU_SOURCE
#include "NiFpga_Suite.h"
#define SBRIO_API NiFpga_Suite
#include "runtime-c/psl/sbrio/fpga.h"
#include "tests/psl/bench_host.h"
#include "tests/sbrio/NiFpga_standin.h"

// Channel 20 + type is the control of a type, channel 40 + type its indicator.
#define PAIR(type, scale, zero) SBRIO_ANALOG_OUT(20 + SBRIO_##type, type, Out, scale, zero), SBRIO_ANALOG_IN(40 + SBRIO_##type, type, In, scale, zero)
static const SbrioPin pins[] = {
    SBRIO_DIGITAL_OUT(4, Out),
    SBRIO_DIGITAL_IN(5, In, NONE),
    SBRIO_DIGITAL_IN(6, Up, UP),
    SBRIO_DIGITAL_IN(7, Down, DOWN),
    SBRIO_ANALOG_OUT(0, I16, Out, 10.0 / 32000, 0),
    SBRIO_ANALOG_IN(1, I16, In, 10.0 / 32000, 0),
    PAIR(I8, 0.1, 0),
    PAIR(U8, 0.01, -1),
    PAIR(I16, -0.001, 0),
    PAIR(U16, 0.001, 0),
    PAIR(I32, 0.000001, 0),
    PAIR(U32, 0.000001, 0),
    PAIR(I64, 1e-9, 0),
    PAIR(U64, 1e-9, 0),
    PAIR(Sgl, 1, 0),
    PAIR(Dbl, 2, 0.5),
    SBRIO_ANALOG_IN(60, I32, In, 0, 0),                   // invalid rows: scales of 0 and infinity, an infinite zero, the same number twice
    SBRIO_ANALOG_IN(61, I32, In, 1e308 * 10, 0),
    SBRIO_ANALOG_IN(62, I32, In, 1, -1e308 * 10),
    SBRIO_ANALOG_IN(63, I32, In, 1, 0),
    SBRIO_ANALOG_IN(63, U32, In, 1, 0),
};
SBRIO_FPGA("/tmp/", "RIO0", pins);

#define REGISTERS(type) {NiFpga_Suite_Control##type##_Out, STANDIN_##type, true, 0, 0, false}, \
    {NiFpga_Suite_Indicator##type##_In, STANDIN_##type, false, NiFpga_Suite_Control##type##_Out, 0, false}
static StandinRegister registers[] = {
    REGISTERS(Bool), REGISTERS(I8), REGISTERS(U8), REGISTERS(I16), REGISTERS(U16), REGISTERS(I32), REGISTERS(U32), REGISTERS(I64), REGISTERS(U64),
    REGISTERS(Sgl), REGISTERS(Dbl), {NiFpga_Suite_IndicatorBool_Up, STANDIN_Bool, false, 0, 0, false}, {NiFpga_Suite_IndicatorBool_Down, STANDIN_Bool, false, 0, 0, false},
};
const StandinVi standin_vi = {"FFEEDDCCBBAA99887766554433221100", registers, COUNT(registers), false};

NiFpga_Status standin_before(StandinCall call, StandinRegister *r)
{
    (void)call;
    (void)r;
    return 0;
}

Bench bench = {
    .name = "sbrio", .clock = HAS, .console = HAS, .threads = HAS, .locks = HAS, .sockets = HAS,
    .nvm = HAS, .nvm_name = "nvm", .nvm_size = 1000, .nvm_missing = "no-such-folder/nvm",
    .log = HAS, .log_name = "flight.log", .log_missing = "no-such-folder/flight.log", .log_read = log_read,
    .serial = HAS, .serial_name = line, .far_send = far_send, .far_receive = far_receive, .far_unplug = far_unplug,
    .dio = HAS, .pins = {4, 5}, .wired = true, .pin_missing = 999,
    .aio = HAS, .channel_in = 1, .channel_out = 0, .channel_missing = 2000, .analog_wired = true,
    .watchdog = HAS,
    .own = {own_sbrio},
};

void bench_begin(void)
{
    host_begin();
}

Tally bench_end(void)
{
    host_end();
    return TALLY();
}
