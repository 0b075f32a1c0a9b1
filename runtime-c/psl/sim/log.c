// SPDX-License-Identifier: Apache-2.0
// Simulated logs: bytes in memory, under any name.  A full medium accepts the bytes that still fit.  A power cut stores the bytes
// before the cut and one more byte with an undefined value.
#include <string.h>

#include "runtime-c/pal/log.h"
#include "runtime-c/psl/sim/world.h"

#define TORN 0xa5             // value of the byte at which the power was cut

static struct {
    char name[PAL_NAME];      // "": unused
    bool open;
    uint32_t size, synced;
    uint8_t bytes[SIM_LOG_SIZE];
} logs[SIM_LOGS];

static bool used[PAL_LOGS];
static uint8_t log_of[PAL_LOGS];
static uint32_t space = SIM_LOG_SIZE;

void sim_log_reset(void)
{
    sim_log_power_on();
    for (size_t i = 0; i < SIM_LOGS; i++) {
        logs[i].name[0] = '\0';
        logs[i].size = logs[i].synced = 0;
    }
    space = SIM_LOG_SIZE;
}

void sim_log_power_on(void)
{
    memset(used, 0, sizeof used);
    for (size_t i = 0; i < SIM_LOGS; i++)
        logs[i].open = false;
}

// Returns the index of the log with that name; SIM_LOGS if no log has it.
static uint8_t find_log(const char *name)
{
    uint8_t i = 0;

    while (i < SIM_LOGS && strcmp(logs[i].name, name) != 0)
        i++;
    return i;
}

// Returns the content of the log of that name, *n bytes, valid until sim_reset; NULL if no log has it.
const uint8_t *sim_log(const char *name, size_t *n)
{
    uint8_t i = find_log(name);

    *n = i < SIM_LOGS ? logs[i].size : 0;
    return i < SIM_LOGS ? logs[i].bytes : NULL;
}

// Returns how many bytes of the log are safe from a power cut.
size_t sim_log_synced(const char *name)
{
    uint8_t i = find_log(name);

    return i < SIM_LOGS ? logs[i].synced : 0;
}

// From now on a log accepts at most `bytes` bytes in total.
void sim_log_space(uint32_t bytes)
{
    space = bytes < SIM_LOG_SIZE ? bytes : SIM_LOG_SIZE;
}

// Truncates the log with that name to at most `bytes` bytes, like the repair of a file system.
void sim_log_shrink(const char *name, size_t bytes)
{
    uint8_t i = find_log(name);

    if (i < SIM_LOGS && logs[i].size > bytes)
        logs[i].size = (uint32_t)bytes;
}

// ---- the PAL ----

// Finds the log with that name, or an unused one.
static SmResult find_or_create_log(const char *name, uint8_t *log)
{
    *log = find_log(name);
    if (*log == SIM_LOGS)
        *log = find_log("");
    if (*log == SIM_LOGS)
        return SM_E_SPACE;
    return logs[*log].open ? SM_E_BUSY : sim_begin_call(SIM_log_open);
}

SmResult pal_log_open(PalLogFile *file, const char *name)
{
    uint8_t id, log;
    SmResult r;

    if (!file || !name || name[0] == '\0' || strlen(name) >= PAL_NAME)
        return SM_E_ARGUMENT;
    if (strchr(name, '/'))
        return SM_E_MISSING;                              // the name contains a folder, and there are no folders
    r = sim_is_power_off() ? SM_E_DEVICE : find_or_create_log(name, &log);
    if (r != SM_OK)
        return r;
    id = psl_table_allocate(used, PAL_LOGS);
    if (id == 0)
        return SM_E_FULL;
    strcpy(logs[log].name, name);
    logs[log].open = true;
    log_of[id - 1] = log;
    file->id = id;
    return SM_OK;
}

// Appends the bytes that fit and that precede a power cut.  Returns how many of the n bytes it stored undamaged.
static uint32_t store_bytes(uint8_t log, const uint8_t *bytes, uint32_t n)
{
    const uint32_t left = space > logs[log].size ? space - logs[log].size : 0, fits = n < left ? n : left;
    const uint32_t done = sim_bytes_before_power_cut(fits);

    memcpy(logs[log].bytes + logs[log].size, bytes, done);
    logs[log].size += done;
    if (done < fits)
        logs[log].bytes[logs[log].size++] = TORN;
    return done;
}

SmResult pal_log_append(PalLogFile file, const void *bytes, size_t n)
{
    SmResult r = psl_table_is_used(used, PAL_LOGS, file.id) ? SM_OK : SM_E_HANDLE;
    uint32_t done;

    if (r == SM_OK && (!bytes || n > UINT32_MAX))
        r = SM_E_ARGUMENT;
    if (r == SM_OK)
        r = sim_is_power_off() ? SM_E_DEVICE : sim_begin_call(SIM_log_append);
    if (r != SM_OK || n == 0)
        return r;
    done = store_bytes(log_of[file.id - 1], (const uint8_t *)bytes, (uint32_t)n);
    return sim_is_power_off() ? SM_E_DEVICE : done < n ? SM_E_SPACE : SM_OK;
}

SmResult pal_log_sync(PalLogFile file)
{
    SmResult r = psl_table_is_used(used, PAL_LOGS, file.id) ? SM_OK : SM_E_HANDLE;

    if (r == SM_OK)
        r = sim_is_power_off() ? SM_E_DEVICE : sim_begin_call(SIM_log_sync);
    if (r == SM_OK)
        logs[log_of[file.id - 1]].synced = logs[log_of[file.id - 1]].size;
    return r;
}

SmResult pal_log_read(PalLogFile file, void *bytes, size_t n)
{
    if (!psl_table_is_used(used, PAL_LOGS, file.id))
        return SM_E_HANDLE;
    if (!bytes || n > logs[log_of[file.id - 1]].size)
        return SM_E_ARGUMENT;
    if (sim_is_power_off())
        return SM_E_DEVICE;
    memcpy(bytes, logs[log_of[file.id - 1]].bytes, n);
    return SM_OK;
}

SmResult pal_log_size(PalLogFile file, uint64_t *size)
{
    if (!size)
        return SM_E_ARGUMENT;
    if (!psl_table_is_used(used, PAL_LOGS, file.id))
        return SM_E_HANDLE;
    if (sim_is_power_off())
        return SM_E_DEVICE;
    *size = logs[log_of[file.id - 1]].size;
    return SM_OK;
}

SmResult pal_log_close(PalLogFile file)
{
    if (!psl_table_is_used(used, PAL_LOGS, file.id))
        return SM_E_HANDLE;
    logs[log_of[file.id - 1]].open = false;
    used[file.id - 1] = false;
    return SM_OK;
}
