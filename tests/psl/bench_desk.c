// SPDX-License-Identifier: Apache-2.0
// The bench of the desk platform: simulated devices are connected as on the simulated platform, and files are in a folder of the test.
#define _GNU_SOURCE
#include <stdlib.h>
#include <unistd.h>

#include "runtime-c/psl/sim/sim.h"
#include "tests/psl/suite.h"

static char folder[256];

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
    FILE *f = fopen("flight.log", "rb");
    size_t n = f ? fread(bytes, 1, room, f) : 0;

    if (f)
        fclose(f);
    return n;
}

Bench bench = {
    .name = "desk", .clock = HAS, .console = HAS, .locks = HAS, .sockets = HAS,
    .nvm = HAS, .nvm_name = "nvm", .nvm_size = 1000, .nvm_missing = "no-such-folder/nvm",
    .log = HAS, .log_name = "flight.log", .log_missing = "no-such-folder/flight.log", .log_read = log_read,
    .serial = HAS, .serial_name = "serial0", .far_send = far_send, .far_receive = far_receive, .far_unplug = far_unplug,
    .dio = HAS, .pins = {2, 3}, .wired = true, .pin_missing = SIM_PINS,
    .aio = HAS, .channel_in = 1, .channel_out = 0, .channel_missing = 16, .analog_wired = true,
    .watchdog = HAS,
};

void bench_begin(void)
{
    const char *base = getenv("TMPDIR");

    snprintf(folder, sizeof folder, "%s/smc-psl.XXXXXX", base ? base : P_tmpdir);
    CHECK(mkdtemp(folder) != NULL && chdir(folder) == 0);
    sim_reset();
    sim_wire(2, 3);
    sim_wire_analog(0, 1);
}

Tally bench_end(void)
{
    unlink("nvm");
    unlink("flight.log");
    CHECK(chdir("/") == 0 && rmdir(folder) == 0);         // fails if a test left a file
    return TALLY();
}
