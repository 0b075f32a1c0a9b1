// SPDX-License-Identifier: Apache-2.0
// Writes flights into a log in the simulation, and reads it with the code of `smc log`: what each record must contain follows from its time.
#ifndef LOG_FLIGHTS_H
#define LOG_FLIGHTS_H

#include <setjmp.h>
#include <stdlib.h>

#include "compiler/report/flight_log.h"
#include "log_parts.h"
#include "runtime-c/psl/sim/sim.h"
#include "tests/heap.h"

#define NAME "flight.log"

// ---- reading ----

static Arena arena;
static jmp_buf oom;

static inline Log *read_bytes(const uint8_t *bytes, size_t n)
{
    arena_free(&arena);
    return log_read(&arena, bytes, (uint32_t)n);
}

static inline Log *read_all(void)
{
    size_t n;
    const uint8_t *bytes = sim_log(NAME, &n);

    return read_bytes(bytes, n);
}

// Reads the content of a record, without its time.  Returns false if it differs from the step of that tick.
static inline bool is_true(const LogSession *s, const LogItem *r, uint32_t salt)
{
    const uint64_t k = log_read_time(r) / TICK;
    const LogElement *e = s->d->element;
    double f64;
    uint64_t bits;

    bits = log_read_cell(r, &e[WIDE_E_f64]);
    memcpy(&f64, &bits, sizeof f64);
    return log_read_time(r) % TICK == 0 && log_read_cell(r, &e[WIDE_E_time]) == k * TICK && log_read_cell(r, &e[WIDE_E_state]) == k % 2 + 1 &&
        f64 == (double)k * 0.25 + salt && log_read_cell(r, &e[WIDE_E_i64]) == (uint64_t)-(int64_t)k && log_read_cell(r, &e[WIDE_E_u32]) == salt &&
        log_read_cell(r, &e[WIDE_E_flag]) == (k % 3 == 0) && log_read_cell(r, &e[WIDE_E_u8]) == (uint8_t)(0xA5 + k);
}

// Whether all records of a session are correct and in order.
static inline bool records_are_true(const LogSession *s, uint32_t salt)
{
    uint64_t last = 0, n = 0;

    for (size_t i = 0; i < s->item.n; i++)
        if (s->item.at[i].kind == ITEM_RECORD) {
            if (!is_true(s, &s->item.at[i], salt) || (n > 0 && log_read_time(&s->item.at[i]) <= last))
                return false;
            last = log_read_time(&s->item.at[i]);
            n++;
        }
    return n == s->records;
}

static inline SmResult step_and_log(uint64_t k, uint32_t salt)
{
    const SmTick tick = {k * TICK, k};

    fill_vector(k, salt);
    return sm_log_step(&flight, &tick);
}

static inline void add_event(uint8_t kind, uint16_t source, uint32_t a, uint32_t b, uint64_t time)
{
    SmEvent e = {time, a, b, 0, 0};

    e.kind = kind;
    e.source = source;
    sm_event(&events, &e);
}

// ---- writing ----

static inline void begin_log(void)
{
    sim_reset();
    reset_log(NAME);
    CHECK(sm_log_init(&flight) == SM_OK);
}

static inline void write_flight(uint64_t from, uint64_t to, uint32_t salt)
{
    reset_log(NAME);
    CHECK(sm_log_init(&flight) == SM_OK);
    for (uint64_t k = from; k < to; k++) {
        CHECK(step_and_log(k, salt) == SM_OK);
        sm_log_drain(&flight, PAL_SECOND);
    }
    CHECK(sm_log_close(&flight) == SM_OK);
}

#endif
