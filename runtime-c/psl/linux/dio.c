// SPDX-License-Identifier: Apache-2.0
// Digital pins: lines of the GPIO character devices, interface version 2 (Linux 5.10).  Pin 1000 × chip + line is line `line` of
// /dev/gpiochip`chip`.  An open pin has exclusive use of its line.  When the program ends, for any reason, the kernel frees the
// lines.  Most drivers then leave an output unchanged.  A driver without pull resistors ignores a request for one, and an
// unconnected input then floats.
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <linux/gpio.h>
#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "runtime-c/pal/dio.h"
#include "runtime-c/psl/linux/linux.h"

#define LINES_OF_A_CHIP 1000u

typedef struct DioEntry {
    int fd;                   // file descriptor of the line
    bool output;
} DioEntry;

static bool used[PAL_DIOS];
static DioEntry entries[PAL_DIOS];

static uint64_t line_flags(PalDioMode mode)
{
    switch (mode) {
    case PAL_DIO_INPUT: return GPIO_V2_LINE_FLAG_INPUT;
    case PAL_DIO_PULL_UP: return GPIO_V2_LINE_FLAG_INPUT | GPIO_V2_LINE_FLAG_BIAS_PULL_UP;
    case PAL_DIO_PULL_DOWN: return GPIO_V2_LINE_FLAG_INPUT | GPIO_V2_LINE_FLAG_BIAS_PULL_DOWN;
    case PAL_DIO_OUTPUT: return GPIO_V2_LINE_FLAG_OUTPUT;
    }
    return 0;
}

// Requests a line from a chip.  The level is part of the request, so an output never has another level.
static SmResult request_line(int chip, uint32_t line, PalDioMode mode, bool level, int *fd)
{
    struct gpiochip_info info;
    struct gpio_v2_line_request r;

    memset(&info, 0, sizeof info);
    if (ioctl(chip, GPIO_GET_CHIPINFO_IOCTL, &info) != 0)
        return psl_result_of_errno(errno);
    if (line >= info.lines)
        return SM_E_MISSING;
    memset(&r, 0, sizeof r);
    r.offsets[0] = line;
    r.num_lines = 1;
    strcpy(r.consumer, "smc");
    r.config.flags = line_flags(mode);
    if (mode == PAL_DIO_OUTPUT) {
        r.config.num_attrs = 1;
        r.config.attrs[0].attr.id = GPIO_V2_LINE_ATTR_ID_OUTPUT_VALUES;
        r.config.attrs[0].attr.values = level;
        r.config.attrs[0].mask = 1;
    }
    if (ioctl(chip, GPIO_V2_GET_LINE_IOCTL, &r) != 0)
        return errno == EINVAL ? SM_E_UNSUPPORTED : psl_result_of_errno(errno);
    *fd = r.fd;
    return SM_OK;
}

static SmResult open_line(uint16_t number, PalDioMode mode, bool level, int *fd)
{
    char path[PAL_NAME];
    int chip;
    SmResult r;

    snprintf(path, sizeof path, "%s%u", PSL_LINUX_GPIO, number / LINES_OF_A_CHIP);
    chip = open(path, O_RDWR | O_CLOEXEC);
    if (chip < 0)
        return psl_result_of_errno(errno);
    r = request_line(chip, number % LINES_OF_A_CHIP, mode, level, fd);
    close(chip);
    return r;
}

SmResult pal_dio_open(PalDio *pin, uint16_t number, PalDioMode mode, bool level)
{
    SmResult r = SM_E_FULL;
    uint8_t id;

    if (!pin || line_flags(mode) == 0)
        return SM_E_ARGUMENT;
    psl_lock_tables();
    id = psl_table_allocate(used, PAL_DIOS);
    if (id != 0) {
        r = open_line(number, mode, level, &entries[id - 1].fd);
        entries[id - 1].output = mode == PAL_DIO_OUTPUT;
        used[id - 1] = r == SM_OK;
    }
    psl_unlock_tables();
    if (r == SM_OK)
        pin->id = id;
    return r;
}

SmResult pal_dio_read(PalDio pin, bool *level)
{
    struct gpio_v2_line_values v = {0, 1};

    if (!level)
        return SM_E_ARGUMENT;
    if (!psl_table_is_used(used, PAL_DIOS, pin.id))
        return SM_E_HANDLE;
    if (ioctl(entries[pin.id - 1].fd, GPIO_V2_LINE_GET_VALUES_IOCTL, &v) != 0)
        return psl_result_of_errno(errno);
    *level = v.bits & 1;
    return SM_OK;
}

SmResult pal_dio_write(PalDio pin, bool level)
{
    struct gpio_v2_line_values v = {level, 1};

    if (!psl_table_is_used(used, PAL_DIOS, pin.id))
        return SM_E_HANDLE;
    if (!entries[pin.id - 1].output)
        return SM_E_ARGUMENT;
    return ioctl(entries[pin.id - 1].fd, GPIO_V2_LINE_SET_VALUES_IOCTL, &v) == 0 ? SM_OK : psl_result_of_errno(errno);
}

SmResult pal_dio_close(PalDio pin)
{
    SmResult r = SM_E_HANDLE;

    psl_lock_tables();
    if (psl_table_is_used(used, PAL_DIOS, pin.id)) {
        close(entries[pin.id - 1].fd);
        used[pin.id - 1] = false;
        r = SM_OK;
    }
    psl_unlock_tables();
    return r;
}
