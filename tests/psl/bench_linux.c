// SPDX-License-Identifier: Apache-2.0
// The bench of the Linux platform: this computer, with a pseudo-terminal as a serial line and files for analog channels (built with
// PSL_LINUX_IIO="iio").  Files are created in a separate folder.  PSL_PINS=1 enables the test of digital pins, which needs a /dev/gpiochip0 with
// usable lines.
#define _GNU_SOURCE
#include <sys/stat.h>

#include "tests/psl/bench_host.h"

Bench bench = {
    .name = "linux", .clock = HAS, .console = HAS, .threads = HAS, .locks = HAS, .sockets = HAS,
    .nvm = HAS, .nvm_name = "nvm", .nvm_size = 1000, .nvm_missing = "no-such-folder/nvm",
    .log = HAS, .log_name = "flight.log", .log_missing = "no-such-folder/flight.log", .log_read = log_read,
    .serial = HAS, .serial_name = line, .far_send = far_send, .far_receive = far_receive, .far_unplug = far_unplug,
    .dio = HAS_NOTHING_THERE, .pins = {4, 5}, .pin_missing = 999,
    .aio = HAS, .channel_in = 1, .channel_out = 0, .channel_missing = 2000, .analog_wired = true,
    .watchdog = HAS,
    .own = {own_files_linux, own_threads_linux, own_devices_linux},
};

static void put_file(const char *name, const char *text)
{
    FILE *f = fopen(name, "w");

    CHECK(f != NULL && fputs(text, f) >= 0 && fclose(f) == 0);
}

static void put_channels(void)
{
    CHECK(mkdir("iio", 0700) == 0 && mkdir("iio/iio:device0", 0700) == 0);
    put_file("iio/iio:device0/out_voltage0_raw", "0\n");
    put_file("iio/iio:device0/out_voltage_scale", "0.125\n");
    put_file("iio/iio:device0/in_voltage1_scale", "0.125000000\n");
    CHECK(symlink("out_voltage0_raw", "iio/iio:device0/in_voltage1_raw") == 0);
}

static void remove_channels(void)
{
    const char *files[] = {"out_voltage0_raw", "out_voltage_scale", "in_voltage1_scale", "in_voltage1_raw"};
    char name[64];

    for (size_t i = 0; i < COUNT(files); i++) {
        snprintf(name, sizeof name, "iio/iio:device0/%s", files[i]);
        CHECK(unlink(name) == 0);
    }
    CHECK(rmdir("iio/iio:device0") == 0 && rmdir("iio") == 0);
}

void bench_begin(void)
{
    host_begin();
    put_channels();
    if (getenv("PSL_PINS"))
        bench.dio = HAS;
}

Tally bench_end(void)
{
    remove_channels();
    host_end();
    return TALLY();
}
