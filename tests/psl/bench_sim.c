// SPDX-License-Identifier: Apache-2.0
// The bench of the simulated platform.
#include "runtime-c/psl/sim/sim.h"
#include "tests/psl/suite.h"

static void far_send(const void *bytes, size_t n)
{
    sim_serial_send("serial0", bytes, n);
}

static size_t far_receive(void *bytes, size_t room)
{
    return sim_serial_receive("serial0", bytes, room);
}

static void far_unplug(void)
{
    sim_serial_plug("serial0", false);
}

static size_t log_read(void *bytes, size_t room)
{
    size_t n;
    const uint8_t *from = sim_log("flight.log", &n);

    n = n < room ? n : room;
    if (from)
        memcpy(bytes, from, n);
    return n;
}

Bench bench = {
    .name = "sim", .clock = HAS, .console = HAS, .locks = HAS, .sockets = HAS,
    .nvm = HAS, .nvm_name = "eeprom", .nvm_size = 1000, .nvm_missing = "tape",
    .log = HAS, .log_name = "flight.log", .log_missing = "no-such-folder/flight.log", .log_read = log_read,
    .serial = HAS, .serial_name = "serial0", .far_send = far_send, .far_receive = far_receive, .far_unplug = far_unplug,
    .dio = HAS, .pins = {2, 3}, .wired = true, .pin_missing = SIM_PINS,
    .aio = HAS, .channel_in = 1, .channel_out = 0, .channel_missing = 16, .analog_wired = true,
    .watchdog = HAS,
    .own = {own_sim},
};

void bench_begin(void)
{
    sim_reset();
    sim_wire(2, 3);
    sim_wire_analog(0, 1);
}

Tally bench_end(void)
{
    return TALLY();
}
