// SPDX-License-Identifier: Apache-2.0
#include "bytecode-vm/target/swap_numbers.h"

#include "stdlib/crc32.h"

// A record: the number (u32) and its check, at the beginning of STRIDE bytes.  The check is the CRC-32 of the four bytes, exclusive-or MARK: the
// CRC-32 of four blank bytes (0xff) is blank, too, and a blank record must not be valid.
#define MARK UINT32_C(0x534d4e52)
enum { RECORD = 8, STRIDE = 512, DIGITS = 2 * SMVM_KEY };

static int digit_value(uint8_t c)
{
    return c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

static SmResult decode_key(const uint8_t *digits, uint8_t *key)
{
    for (int i = 0; i < SMVM_KEY; i++) {
        const int high = digit_value(digits[2 * i]), low = digit_value(digits[2 * i + 1]);
        if (high < 0 || low < 0)
            return SM_E_ARGUMENT;
        key[i] = (uint8_t)(high << 4 | low);
    }
    return SM_OK;
}

static uint32_t check_of(const uint8_t *record) { return sm_crc32(record, 4) ^ MARK; }

static SmResult read_key(SmSwapLink *l)
{
    uint8_t digits[DIGITS];
    const SmResult r = pal_nvm_load(l->key_file, digits, DIGITS);

    return r == SM_OK ? decode_key(digits, l->key) : r == SM_E_SPACE ? SM_E_ARGUMENT : r;
}

static SmResult read_numbers(SmSwapLink *l)
{
    SmResult r = pal_nvm_open(&l->memory, l->number_memory, 2 * STRIDE);

    for (uint8_t i = 0; i < 2 && r == SM_OK; i++) {
        uint8_t record[RECORD];
        r = pal_nvm_read(l->memory, i * STRIDE, record, RECORD);
        if (r == SM_OK && check_of(record) == sm_link_load(record + 4, 4) && sm_link_load(record, 4) >= l->newest) {
            l->newest = sm_link_load(record, 4);
            l->record = i ^ 1;
        }
    }
    return r;
}

SmResult sm_swap_open_numbers(SmSwapLink *l, const char **failed)
{
    SmResult r = read_key(l);

    *failed = l->key_file;
    if (r != SM_OK)
        return r;
    *failed = l->number_memory;
    return read_numbers(l);
}

SmResult sm_swap_store_number(SmSwapLink *l, uint32_t number)
{
    uint8_t record[RECORD];
    SmResult r;

    sm_link_store(record, number, 4);
    sm_link_store(record + 4, check_of(record), 4);
    r = pal_nvm_write(l->memory, (uint32_t)l->record * STRIDE, record, RECORD);
    if (r == SM_OK) {
        l->newest = number;
        l->record ^= 1;
    }
    return r;
}
