// SPDX-License-Identifier: Apache-2.0
// Damaged flight logs: cut off anywhere, with changed, missing or repeated bytes, with many descriptions, or written while the power fails.
// The reader returns exactly the undamaged records, counts the bytes that it skips, and needs time in proportion to the size of the file.
#include <time.h>

#include "log_flights.h"
#include "runtime-c/log_block.h"

enum { BLOCKS_MOST = 20000 };
static uint8_t copy[SIM_LOG_SIZE];
static struct { uint32_t at, size; bool is_record; } block[BLOCKS_MOST];
static size_t blocks;

static void take_copy(size_t *n)
{
    const uint8_t *bytes = sim_log(NAME, n);
    uint32_t at = 0;

    memcpy(copy, bytes, *n);
    for (blocks = 0; at < *n && blocks < BLOCKS_MOST; blocks++) {
        const uint32_t length = bytes[at + 2] + 256u * bytes[at + 3] + 65536u * bytes[at + 4];
        block[blocks].at = at;
        block[blocks].size = length + SM_LOG_BLOCK;
        block[blocks].is_record = bytes[at + 1] == 'R';
        at += block[blocks].size;
    }
    CHECK(at == *n);
}

// Returns the number of whole records outside [from, to).
static uint64_t count_records_outside(uint32_t from, uint32_t to)
{
    uint64_t n = 0;

    for (size_t i = 0; i < blocks; i++)
        n += block[i].is_record && (block[i].at + block[i].size <= from || block[i].at >= to);
    return n;
}

static uint64_t count_all_records(const Log *log)
{
    uint64_t n = 0;

    for (size_t i = 0; i < log->session.n; i++) {
        CHECK(records_are_true(log->session.at[i], (uint32_t)(log->session.at[i]->d->start ? 1 : 0)));
        n += log->session.at[i]->records;
    }
    return n;
}

static void make_two_sessions(size_t *n)
{
    sim_reset();
    write_flight(0, 30, 0);
    write_flight(0, 30, 1);
    take_copy(n);
}

// The file is cut at every position: all whole blocks before the cut are read.
static void test_cut(void)
{
    size_t n;

    make_two_sessions(&n);
    for (uint32_t at = 0; at <= n; at++) {
        Log *log = read_bytes(copy, at);
        CHECK(count_all_records(log) == count_records_outside(at, (uint32_t)n));
        CHECK(log->damaged == log->torn && log->torn < 2000);
    }
}

// One wrong byte, at each position and with several values: only its block is lost.
static void test_one_byte(void)
{
    size_t n;

    make_two_sessions(&n);
    for (uint32_t at = block[0].size; at < n; at++)
        for (uint8_t flip = 1; flip; flip = (uint8_t)(flip << 3)) {
            Log *log;
            copy[at] ^= flip;
            log = read_bytes(copy, n);
            if (at < block[32].at || at >= block[32].at + block[32].size || !log->damaged)
                CHECK(count_all_records(log) == count_records_outside(at, at + 1) || log->session.n < 2);
            CHECK(log->damaged_ranges == 1 && log->session.n >= 1);
            copy[at] ^= flip;
        }
}

static uint32_t seed = 1;

static uint32_t next_block(uint32_t below)
{
    seed = seed * 1664525u + 1013904223u;
    return (uint32_t)((uint64_t)seed * below >> 32);
}

// A part of the file is overwritten, removed or inserted twice.
static void test_stretch(void)
{
    static uint8_t changed[2 * sizeof copy];
    size_t n;

    make_two_sessions(&n);
    for (int i = 0; i < 2000; i++) {
        const uint32_t at = block[0].size + next_block((uint32_t)n - block[0].size), size = next_block((uint32_t)n - at), kind = next_block(3);
        size_t m = n;
        memcpy(changed, copy, n);
        if (kind == 0) {
            for (uint32_t k = 0; k < size; k++)
                changed[at + k] = (uint8_t)next_block(256);
        } else if (kind == 1) {
            memmove(changed + at, copy + at + size, n - at - size);
            m -= size;
        } else {
            memcpy(changed + at + size, copy + at, n - at);
            m += size;
        }
        {
            Log *log = read_bytes(changed, m);
            for (size_t s = 0; kind < 2 && s < log->session.n; s++)
                CHECK(records_are_true(log->session.at[s], log->session.at[s]->d->start ? 1 : 0));
            if (kind < 2 && log->session.n == 2)
                CHECK(log->session.at[0]->records + log->session.at[1]->records >= count_records_outside(at, at + size + (size == 0)) - (size == 0));
        }
    }
}

// The description is repeated, so that a damaged beginning loses only its own bytes.
static void test_repeated(void)
{
    size_t n;
    Log *log;

    sim_reset();
    write_flight(0, 8000, 0);
    take_copy(&n);
    CHECK(n > 500000 && n < SM_LOG_AGAIN);                // not repeated yet
    sim_reset();
    reset_log(NAME);
    CHECK(sm_log_init(&flight) == SM_OK);
    for (uint64_t k = 0; k < 9000; k++) {
        if (k == 10)
            flight.described_at -= SM_LOG_AGAIN;          // simulates that this many bytes were written in between
        CHECK(step_and_log(k, 0) == SM_OK);
        sm_log_drain(&flight, PAL_SECOND);
    }
    CHECK(sm_log_close(&flight) == SM_OK);
    take_copy(&n);
    log = read_bytes(copy, n);
    CHECK(log->session.n == 1 && log->damaged == 0 && log->session.at[0]->records == 9000);
    copy[100] ^= 1;
    log = read_bytes(copy, n);
    CHECK(log->session.n == 1 && log->damaged_ranges == 1 && log->session.at[0]->records == 9000 && records_are_true(log->session.at[0], 0));
}

enum { BLOCKS = 300000, DESCRIPTIONS = 4000 };

// Writes a description, blocks that may be damaged, and the other descriptions: of two sessions alternately, or all of one.
static void write_layout(uint8_t *at, const uint8_t *description, uint32_t size, bool in_turn)
{
    for (uint32_t i = 0; i < DESCRIPTIONS; i++, at += size) {
        memcpy(at, description, size);
        at[LOG_HEAD + 1] = in_turn && i % 2;              // its first timestamp: distinguishes sessions
        log_put32(at + size - LOG_CHECK, sm_crc32_end(log_crc_update(SM_CRC32_START, at, size - LOG_CHECK)));
        for (uint32_t b = 0; i == 0 && b < BLOCKS; b++, at += LOG_HEAD)
            log_put_head(at + size, LOG_RECORD, 0);
    }
}

static clock_t time_to_read(const uint8_t *description, uint32_t size, bool in_turn)
{
    const uint32_t n = BLOCKS * LOG_HEAD + DESCRIPTIONS * size;
    uint8_t *bytes = malloc(n);
    clock_t began;

    CHECK(bytes != NULL);
    if (!bytes)
        return 0;
    write_layout(bytes, description, size, in_turn);
    began = clock();
    CHECK(read_bytes(bytes, n)->session.n == (in_turn ? DESCRIPTIONS : 1));
    began = clock() - began;
    free(bytes);
    return began;
}

// A file with very many descriptions is not slow to read.
static void test_many_descriptions(void)
{
    size_t n;
    const uint8_t *bytes;
    clock_t in_turn;

    begin_log();
    while (sm_log_drain(&flight, PAL_SECOND)) {}
    bytes = sim_log(NAME, &n);
    in_turn = time_to_read(bytes, (uint32_t)n, true);
    CHECK(time_to_read(bytes, (uint32_t)n, false) < 4 * in_turn + CLOCKS_PER_SEC / 20);
}

// The power fails in each append in turn, at several bytes: the next start continues, and all records before and after are correct.
static void test_power(void)
{
    for (uint32_t appends = 0; appends < 60; appends++)
        for (uint32_t bytes = 0; bytes < 130; bytes += 1 + bytes / 4) {
            uint64_t written = 0;
            Log *log;
            begin_log();
            sim_cut_power(appends, bytes);
            for (uint64_t k = 0; k < 45; k++) {
                (void)step_and_log(k, 0);
                sm_log_drain(&flight, PAL_SECOND);
            }
            sim_power_on();
            write_flight(0, 10, 1);
            log = read_all();
            CHECK(log->session.n >= 1);
            for (size_t s = 0; s < log->session.n; s++) {
                CHECK(records_are_true(log->session.at[s], log->session.at[s]->d->start ? 1 : 0));
                written = log->session.at[s]->records;
            }
            CHECK(written == 10);
        }
}

int main(void)
{
    arena_init(&arena, heap_alloc, NULL, &oom);
    if (setjmp(oom))
        return 1;
    test_cut();
    test_one_byte();
    test_stretch();
    test_repeated();
    test_many_descriptions();
    test_power();
    arena_free(&arena);
    return test_end("log_damage");
}
