// SPDX-License-Identifier: Apache-2.0
// Simulated non-volatile memory: "eeprom", in which any byte can be written at any time, and "flash", which is written in units
// that must have been erased.  A power cut interrupts a write and leaves one byte with an undefined value.
#include <string.h>

#include "runtime-c/pal/nvm.h"
#include "runtime-c/psl/sim/world.h"

#define BLANK 0xff
#define TORN  0xa5            // value of the byte at which the power was cut; tests use other values, so it is neither old nor new

static struct {
    const char *name;
    PalNvmInfo info;
    bool open;
    uint8_t bytes[SIM_NVM_SIZE];
    uint32_t stuck_at;
    uint8_t stuck_bits, stuck_value;
} media[] = {
    {"eeprom", {SIM_NVM_SIZE, 1, 0, 0, 3400000, BLANK}, false, {0}, 0, 0, 0},
    {"flash", {SIM_NVM_SIZE, 8, 32, 0, 20000000, BLANK}, false, {0}, 0, 0, 0},
};
enum { MEDIA = sizeof media / sizeof *media };

static bool used[PAL_NVMS];
static uint8_t medium_of[PAL_NVMS];

// The planned power cut.  `after` more writes succeed; the next one stores `bytes` bytes, then the power is cut.  off: the power is off.
static struct {
    bool planned, off;
    uint32_t after, bytes;
} cut;

// Closes all memories and forgets a planned power cut, as at power on.
static void close_all(void)
{
    memset(used, 0, sizeof used);
    for (size_t i = 0; i < MEDIA; i++)
        media[i].open = false;
    memset(&cut, 0, sizeof cut);
}

void sim_nvm_reset(void)
{
    close_all();
    for (size_t i = 0; i < MEDIA; i++) {
        memset(media[i].bytes, BLANK, SIM_NVM_SIZE);
        media[i].stuck_bits = 0;
    }
}

// Sets the stuck bits of a memory to their stuck values, after each write.
static void apply_stuck_bits(size_t medium)
{
    uint8_t *b = &media[medium].bytes[media[medium].stuck_at];
    const uint8_t bits = media[medium].stuck_bits;

    *b = (uint8_t)((*b & ~bits) | (media[medium].stuck_value & bits));
}

// Returns the index of the medium with that name; the last one for an unknown name.
static size_t find_medium(const char *name)
{
    size_t i = 0;

    while (i < MEDIA - 1 && strcmp(media[i].name, name) != 0)
        i++;
    return i;
}

// Returns the SIM_NVM_SIZE bytes of a memory.
uint8_t *sim_nvm(const char *name) { return media[find_medium(name)].bytes; }

// From now on the bits in `bits` of byte `at` have the values in `value`, whatever is written.  `bits` = 0 repairs it.
void sim_stick(const char *name, uint32_t at, uint8_t bits, uint8_t value)
{
    const size_t i = find_medium(name);

    media[i].stuck_at = at % SIM_NVM_SIZE;
    media[i].stuck_bits = bits;
    media[i].stuck_value = value;
    apply_stuck_bits(i);
}

// Cuts the power after `after` more writes, erases or appends: the next one stores `bytes` bytes, and the byte after them becomes undefined.
void sim_cut_power(uint32_t after, uint32_t bytes)
{
    cut.planned = true;
    cut.after = after;
    cut.bytes = bytes;
}

void sim_power_on(void)
{
    close_all();
    sim_log_power_on();
}

bool sim_is_power_off(void)
{
    return cut.off;
}

// Counts a write, erase or append of n bytes that is about to begin.  Returns how many of the bytes are stored before a power cut.
uint32_t sim_bytes_before_power_cut(uint32_t n)
{
    if (!cut.planned || cut.after-- > 0)
        return n;
    cut.planned = false;
    cut.off = true;
    return cut.bytes < n ? cut.bytes : n;
}

// ---- the PAL ----

static SmResult open_medium(const char *name, uint32_t size, uint8_t *medium)
{
    for (uint8_t i = 0; i < MEDIA; i++)
        if (strcmp(media[i].name, name) == 0) {
            *medium = i;
            return size > SIM_NVM_SIZE ? SM_E_SPACE : media[i].open ? SM_E_BUSY : sim_begin_call(SIM_nvm_open);
        }
    return SM_E_MISSING;
}

SmResult pal_nvm_open(PalNvm *memory, const char *name, uint32_t size)
{
    uint8_t id, medium = 0;
    SmResult r;

    if (!memory || !name || size == 0 || name[0] == '\0' || strlen(name) >= PAL_NAME)
        return SM_E_ARGUMENT;
    r = cut.off ? SM_E_DEVICE : open_medium(name, size, &medium);
    if (r != SM_OK)
        return r;
    id = psl_table_allocate(used, PAL_NVMS);
    if (id == 0)
        return SM_E_FULL;
    media[medium].open = true;
    medium_of[id - 1] = medium;
    memory->id = id;
    return SM_OK;
}

SmResult pal_nvm_load(const char *name, void *bytes, uint32_t n)
{
    SmResult r = SM_E_MISSING;
    size_t i = 0;

    if (!name || !bytes || n == 0 || name[0] == '\0' || strlen(name) >= PAL_NAME)
        return SM_E_ARGUMENT;
    while (i < MEDIA && strcmp(media[i].name, name) != 0)
        i++;
    if (i < MEDIA)
        r = cut.off ? SM_E_DEVICE : n > SIM_NVM_SIZE ? SM_E_SPACE : sim_begin_call(SIM_nvm_load);
    if (r == SM_OK)
        memcpy(bytes, media[i].bytes, n);
    return r;
}

SmResult pal_nvm_info(PalNvm memory, PalNvmInfo *info)
{
    if (!info)
        return SM_E_ARGUMENT;
    if (!psl_table_is_used(used, PAL_NVMS, memory.id))
        return SM_E_HANDLE;
    *info = media[medium_of[memory.id - 1]].info;
    return SM_OK;
}

// Stores the address of byte `at` in *bytes.  Checks that the handle is open, and that the range is valid and aligned to `unit`.
static SmResult check_access(PalNvm memory, uint32_t at, uint32_t n, uint32_t unit, uint8_t **bytes)
{
    if (!psl_table_is_used(used, PAL_NVMS, memory.id))
        return SM_E_HANDLE;
    if (at > SIM_NVM_SIZE || n > SIM_NVM_SIZE - at || at % unit != 0 || n % unit != 0)
        return SM_E_ARGUMENT;
    *bytes = media[medium_of[memory.id - 1]].bytes + at;
    return SM_OK;
}

static const PalNvmInfo *info_of(PalNvm memory)
{
    return &media[psl_table_is_used(used, PAL_NVMS, memory.id) ? medium_of[memory.id - 1] : 0].info;
}

SmResult pal_nvm_read(PalNvm memory, uint32_t at, void *bytes, uint32_t n)
{
    uint8_t *here;
    SmResult r = check_access(memory, at, n, 1, &here);

    if (r == SM_OK && !bytes)
        r = SM_E_ARGUMENT;
    if (r == SM_OK)
        r = cut.off ? SM_E_DEVICE : sim_begin_call(SIM_nvm_read);
    if (r == SM_OK)
        memcpy(bytes, here, n);
    return r;
}

static bool is_blank(const uint8_t *bytes, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++)
        if (bytes[i] != BLANK)
            return false;
    return true;
}

// Stores n bytes, blank ones if `bytes` is NULL, until the power is cut.
static SmResult store_bytes(uint8_t *here, const uint8_t *bytes, uint32_t n, SimCall call)
{
    SmResult r = cut.off ? SM_E_DEVICE : sim_begin_call(call);
    uint32_t done;

    if (r != SM_OK)
        return r;
    done = sim_bytes_before_power_cut(n);
    if (bytes)
        memcpy(here, bytes, done);
    else
        memset(here, BLANK, done);
    if (done < n)
        here[done] = TORN;
    for (size_t i = 0; i < MEDIA; i++)
        apply_stuck_bits(i);
    return cut.off ? SM_E_DEVICE : SM_OK;
}

SmResult pal_nvm_write(PalNvm memory, uint32_t at, const void *bytes, uint32_t n)
{
    uint8_t *here;
    SmResult r = check_access(memory, at, n, info_of(memory)->write, &here);

    if (r == SM_OK && (!bytes || (info_of(memory)->erase != 0 && !is_blank(here, n))))
        r = SM_E_ARGUMENT;
    return r == SM_OK && n > 0 ? store_bytes(here, bytes, n, SIM_nvm_write) : r;
}

SmResult pal_nvm_erase(PalNvm memory, uint32_t at, uint32_t n)
{
    uint32_t unit = info_of(memory)->erase;
    uint8_t *here;
    SmResult r = check_access(memory, at, n, unit ? unit : 1, &here);

    return r == SM_OK && n > 0 ? store_bytes(here, NULL, n, SIM_nvm_erase) : r;
}

SmResult pal_nvm_close(PalNvm memory)
{
    if (!psl_table_is_used(used, PAL_NVMS, memory.id))
        return SM_E_HANDLE;
    media[medium_of[memory.id - 1]].open = false;
    used[memory.id - 1] = false;
    return SM_OK;
}
