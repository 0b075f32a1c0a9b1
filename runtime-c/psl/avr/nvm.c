// SPDX-License-Identifier: Apache-2.0
// "eeprom": written byte by byte, each when real-time readers permit it (avr.h).  A byte that already has the value is not
// written.
#include "runtime-c/pal/nvm.h"

#include <string.h>

#include "runtime-c/psl/avr/avr.h"

#ifdef PSL_AVR

enum { SIZE = E2END + 1, BLANK = 0xff };
#define SLOWEST (3400u * (uint64_t)PAL_MICROSECOND)

static bool is_opened;
static bool (*may_write)(void);

// From now on `may` decides before each write of a byte whether it may begin; NULL: always.
void avr_eeprom_guard_writes(bool (*may)(void)) { may_write = may; }

SmResult pal_nvm_open(PalNvm *memory, const char *name, uint32_t size)
{
    if (!memory || !name || size == 0)
        return SM_E_ARGUMENT;
    if (strcmp(name, "eeprom") != 0)
        return SM_E_MISSING;
    if (size > SIZE)
        return SM_E_SPACE;
    if (is_opened)
        return SM_E_BUSY;
    is_opened = true;
    memory->id = 1;
    return SM_OK;
}

SmResult pal_nvm_load(const char *name, void *bytes, uint32_t n)
{
    uint8_t *to = bytes;

    if (!name || !bytes || n == 0)
        return SM_E_ARGUMENT;
    if (strcmp(name, "eeprom") != 0)
        return SM_E_MISSING;
    if (n > SIZE)
        return SM_E_SPACE;
    for (uint16_t at = 0; at < (uint16_t)n; at++)
        to[at] = avr_eeprom_read(at);
    return SM_OK;
}

static bool is_open(PalNvm memory) { return is_opened && memory.id == 1; }

SmResult pal_nvm_info(PalNvm memory, PalNvmInfo *info)
{
    if (!info)
        return SM_E_ARGUMENT;
    if (!is_open(memory))
        return SM_E_HANDLE;
    memset(info, 0, sizeof *info);
    info->size = SIZE;
    info->write = 1;
    info->slowest = SLOWEST;
    info->blank = BLANK;
    return SM_OK;
}

// Checks that the memory is open and the range is valid.
__attribute__((noinline)) static SmResult check_range(PalNvm memory, uint32_t at, uint32_t n)
{
    return !is_open(memory) ? SM_E_HANDLE : at > SIZE || n > SIZE - at ? SM_E_ARGUMENT : SM_OK;
}

SmResult pal_nvm_read(PalNvm memory, uint32_t at, void *bytes, uint32_t n)
{
    const SmResult r = bytes || n == 0 ? check_range(memory, at, n) : SM_E_ARGUMENT;
    uint8_t *to = bytes;
    uint16_t from = (uint16_t)at;

    for (uint16_t left = r == SM_OK ? (uint16_t)n : 0; left > 0; left--)
        *to++ = avr_eeprom_read(from++);
    return r;
}

// Begins to write a byte to the EEPROM and returns true, unless another write is in progress.  Interrupts are off between this check and the write.
bool avr_eeprom_begin_write(uint16_t at, uint8_t byte)
{
    const uint8_t flags = SREG;
    bool may;

    cli();
    may = (EECR & 1 << EEPE) == 0 && (!may_write || may_write());
    if (may) {
        EEAR = at;
        EEDR = byte;
        EECR = 1 << EEMPE;
        EECR |= 1 << EEPE;             // must follow within four cycles
    }
    SREG = flags;
    return may;
}

static void write_byte(uint16_t at, uint8_t byte)
{
    if (avr_eeprom_read(at) == byte)
        return;
    while (!avr_eeprom_begin_write(at, byte))
        ;
    while (EECR & 1 << EEPE)
        ;
}

// Writes n bytes; blank ones if `bytes` is NULL.
static SmResult write_bytes(PalNvm memory, uint32_t at, const uint8_t *bytes, uint32_t n)
{
    const SmResult r = check_range(memory, at, n);
    uint16_t to = (uint16_t)at;

    for (uint16_t left = r == SM_OK ? (uint16_t)n : 0; left > 0; left--)
        write_byte(to++, bytes ? *bytes++ : BLANK);
    return r;
}

SmResult pal_nvm_write(PalNvm memory, uint32_t at, const void *bytes, uint32_t n)
{
    return bytes || n == 0 ? write_bytes(memory, at, bytes, n) : SM_E_ARGUMENT;
}

SmResult pal_nvm_erase(PalNvm memory, uint32_t at, uint32_t n) { return write_bytes(memory, at, NULL, n); }

SmResult pal_nvm_close(PalNvm memory)
{
    if (!is_open(memory))
        return SM_E_HANDLE;
    is_opened = false;
    return SM_OK;
}

#endif
