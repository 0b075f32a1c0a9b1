// SPDX-License-Identifier: Apache-2.0
// The flight log in the simulation, from the step to the output of `smc log`.  It reads exactly what was logged, whatever errors the medium
// has.  Damaged files are in log_damage.c.
#include <math.h>

#include "log_flights.h"
#include "runtime-c/log_block.h"

// ---- the plain case ----

static void check_description(const LogDescription *d)
{
    const LogElement *e = d->element;

    CHECK(strcmp(d->vector, "wide") == 0 && d->layout == wide_layout.hash && d->packed == wide_layout.whole.packed && d->start == 0);
    CHECK(d->elements == wide_layout.elements && strcmp(e[WIDE_E_f64].name, "f64") == 0 && e[WIDE_E_f64].type == SM_F64);
    CHECK(d->machines == 1 && d->machine[0].number == 3 && strcmp(d->machine[0].name, "mission") == 0);
    CHECK(d->machine[0].s == WIDE_E_state && d->machine[0].state.n == 2 && strcmp(d->machine[0].state.name[1], "Landed") == 0);
    CHECK(d->task.n == 2 && strcmp(d->task.name[1], "engine") == 0 && d->executor.n == 0);
    CHECK(d->kinds >= 7 && d->kind[1].kind == SM_EVENT_STATE && strcmp(d->kind[1].name, "STATE") == 0);
}

static void test_plain(void)
{
    Log *log;
    LogEvent e;

    begin_log();
    add_event(SM_EVENT_STATE, 3, 0, 1, 0);
    for (uint64_t k = 0; k < 100; k++) {
        CHECK(step_and_log(k, 7) == SM_OK);
        CHECK(!sm_log_drain(&flight, PAL_SECOND));
    }
    CHECK(sm_log_close(&flight) == SM_OK);
    log = read_all();
    CHECK(log->session.n == 1 && log->damaged == 0 && log->damaged_ranges == 0 && !log->newer);
    check_description(log->session.at[0]->d);
    CHECK(log->session.at[0]->records == 100 && log->session.at[0]->events == 1 && records_are_true(log->session.at[0], 7));
    CHECK(log->session.at[0]->first == 0 && log->session.at[0]->last == 99 * TICK);
    CHECK(log->session.at[0]->item.at[0].kind == ITEM_EVENTS);
    e = log_read_event(&log->session.at[0]->item.at[0], 0);
    CHECK(e.kind == SM_EVENT_STATE && e.source == 3 && e.a == 0 && e.b == 1 && e.time == 0);
}

static void test_refused(void)
{
    begin_log();
    CHECK(sm_log_init(&flight) == SM_E_BUSY);
    CHECK(sm_log_close(&flight) == SM_OK);
    reset_log(NAME);
    flight.room = SM_LOG_LEAST(wide_layout.whole.packed) - 1;
    CHECK(sm_log_init(&flight) == SM_E_MEMORY);
    flight.room++;
    CHECK(sm_log_init(&flight) == SM_OK && sm_log_close(&flight) == SM_OK);
    reset_log("no/such");
    CHECK(sm_log_init(&flight) == SM_E_MISSING);
    flight.names = NULL;
    CHECK(sm_log_init(&flight) == SM_E_ARGUMENT && sm_log_init(NULL) == SM_E_ARGUMENT);
}

// ---- files that are no logs ----

static void put_file(const void *bytes, size_t n)
{
    PalLogFile file = {0};

    sim_reset();
    CHECK(pal_log_open(&file, NAME) == SM_OK && pal_log_append(file, bytes, n) == SM_OK && pal_log_close(file) == SM_OK);
}

static void test_foreign(void)
{
    static const char *const other[] = {"x", "[regions]\nSensors\n", "time,altitude\n0,1\n", "\x7f" "ELF\2\1\1\0\0\0\0\0\0\0\0\0\0\0"};
    static const size_t size[] = {1, 18, 18, 18};
    const uint8_t *bytes;
    size_t n;

    for (size_t i = 0; i < sizeof size / sizeof *size; i++) {
        put_file(other[i], size[i]);
        reset_log(NAME);
        CHECK(sm_log_init(&flight) == SM_E_FOREIGN && flight.out.id == 0);
        bytes = sim_log(NAME, &n);
        CHECK(n == size[i] && memcmp(bytes, other[i], n) == 0);
    }
}

// Checks a log in which one byte was changed, or of which a power failure left only a part.
static void test_damaged_beginning(void)
{
    uint8_t bytes[200];
    size_t n;

    begin_log();
    CHECK(step_and_log(0, 0) == SM_OK && sm_log_close(&flight) == SM_OK);
    memcpy(bytes, sim_log(NAME, &n), sizeof bytes);
    for (size_t i = 0; i < 40; i++) {
        bytes[i] ^= 0xff;
        put_file(bytes, sizeof bytes);
        bytes[i] ^= 0xff;
        reset_log(NAME);
        CHECK(sm_log_init(&flight) == SM_OK && sm_log_close(&flight) == SM_OK);
        put_file(bytes, i);
        reset_log(NAME);
        CHECK(sm_log_init(&flight) == SM_OK && sm_log_close(&flight) == SM_OK);
    }
    memset(bytes, 0, sizeof bytes);
    put_file(bytes, sizeof bytes);
    reset_log(NAME);
    CHECK(sm_log_init(&flight) == SM_OK && sm_log_close(&flight) == SM_OK);
}

// ---- a medium that is too slow, full, broken ----

// The medium accepts nothing for some ticks: records are dropped and counted.  The later records are correct.
static void test_too_slow(void)
{
    uint32_t dropped = 0;
    Log *log;

    begin_log();
    for (uint64_t k = 0; k < 1000; k++) {
        const SmResult r = step_and_log(k, 1);
        CHECK(r == SM_OK || r == SM_E_FULL);
        dropped += r != SM_OK;
        if (k % 50 > 30)
            sm_log_drain(&flight, PAL_SECOND);
    }
    sm_log_drain(&flight, PAL_SECOND);
    CHECK(step_and_log(1000, 1) == SM_OK && sm_log_close(&flight) == SM_OK);
    CHECK(dropped > 100 && dropped < 900 && flight.dropped == dropped);
    for (uint32_t i = 0; i < GUARD; i++)
        CHECK(ring[ROOM + i] == 0x77);
    log = read_all();
    CHECK(log->session.n == 1 && log->damaged == 0 && records_are_true(log->session.at[0], 1));
    CHECK(log->session.at[0]->records == 1001 - dropped && log->session.at[0]->dropped == dropped);
}

// More events between two steps than the ring of events can contain.
static void test_lost_events(void)
{
    Log *log;

    begin_log();
    for (uint32_t i = 0; i < 21; i++)
        add_event(SM_EVENT_MODE, 1, i, 2, i);
    CHECK(step_and_log(0, 0) == SM_OK && sm_log_close(&flight) == SM_OK);
    log = read_all();
    CHECK(log->session.at[0]->events == 16 && log->session.at[0]->lost == 5 && log->session.at[0]->records == 1);
    CHECK(log_read_event(&log->session.at[0]->item.at[0], 0).a == 5);
}

// Events that were read but could not be handed over are lost, and the log contains their number.
static void test_events_not_handed_over(void)
{
    Log *log;

    begin_log();
    for (uint32_t i = 0; i < 3; i++)
        add_event(SM_EVENT_MODE, 1, i, 2, i);
    sim_fail(SIM_lock_take, 1, SM_E_TIMEOUT);             // the first lock is taken to reserve room
    (void)step_and_log(0, 0);
    CHECK(flight.lost == 3);
    CHECK(step_and_log(1, 0) == SM_OK && sm_log_close(&flight) == SM_OK);
    log = read_all();
    CHECK(log->session.n == 1 && log->damaged == 0 && log->session.at[0]->events == 0 && log->session.at[0]->lost == 3);
}

// A record that could not be handed over counts as dropped.
static void test_record_not_handed_over(void)
{
    Log *log;

    begin_log();
    CHECK(step_and_log(0, 0) == SM_OK);
    sim_fail(SIM_lock_take, 3, SM_E_TIMEOUT);             // locks: room for events, room for the record, the state vector
    CHECK(step_and_log(1, 0) == SM_E_TIMEOUT && flight.dropped == 1);
    CHECK(step_and_log(2, 0) == SM_OK && sm_log_close(&flight) == SM_OK);
    log = read_all();
    CHECK(log->session.at[0]->records == 2 && log->session.at[0]->dropped == 1 && records_are_true(log->session.at[0], 0));
}

// A file has become shorter than before, and an append is refused: no record of the ring counts as written.  All of them are written later.
static void test_shrunk(void)
{
    size_t n;
    Log *log;

    begin_log();
    for (uint64_t k = 0; k < 10; k++) {
        CHECK(step_and_log(k, 0) == SM_OK);
        sm_log_drain(&flight, PAL_SECOND);
    }
    sim_log(NAME, &n);
    sim_log_shrink(NAME, n - 100);
    for (uint64_t k = 10; k < 12; k++)
        CHECK(step_and_log(k, 0) == SM_OK);
    sim_fail(SIM_log_append, 0, SM_E_DEVICE);
    CHECK(!sm_log_drain(&flight, PAL_SECOND) && flight.result == SM_E_DEVICE && flight.written == n);
    CHECK(sm_log_close(&flight) == SM_OK);
    log = read_all();
    CHECK(log->session.n == 1 && log->damaged_ranges == 1 && records_are_true(log->session.at[0], 0));
    CHECK(log->session.at[0]->records >= 9 && log->session.at[0]->last == 11 * TICK);
}

// The medium fails from time to time, in the middle of a write: the file is complete nevertheless.
static void test_refusals(void)
{
    Log *log;

    for (uint32_t room = 0; room < 3000; room += 7) {
        begin_log();
        for (uint64_t k = 0; k < 40; k++) {
            (void)step_and_log(k, room);
            if (k == 20 && room % 2 == 0)
                flight.described_at -= SM_LOG_AGAIN;      // the description is due while a part of a block waits
            if (k == 30)
                sim_log_space(SIM_LOG_SIZE);
            if (k == 3)
                sim_log_space(room);
            CHECK(!sm_log_drain(&flight, PAL_SECOND));
            CHECK(flight.result == (k >= 3 && k < 30 && sim_log(NAME, &(size_t){0}) && flight.written >= room ? flight.result : SM_OK));
        }
        CHECK(sm_log_close(&flight) == SM_OK);
        log = read_all();
        CHECK(log->session.n == 1 && log->damaged == 0 && records_are_true(log->session.at[0], room));
        CHECK(log->session.at[0]->records + flight.dropped == 40);
    }
}

static void test_full_for_good(void)
{
    Log *log;

    begin_log();
    sim_log_space(1500);
    for (uint64_t k = 0; k < 200; k++) {
        (void)step_and_log(k, 2);
        CHECK(!sm_log_drain(&flight, UINT64_MAX));        // it terminates
    }
    CHECK(sm_log_close(&flight) == SM_E_SPACE);
    log = read_all();
    CHECK(log->session.n == 1 && records_are_true(log->session.at[0], 2) && log->damaged == log->torn);
}

// ---- time ----

// A step writes at least one piece, and not more than the budget allows.
static void test_budget(void)
{
    begin_log();
    sim_delay(SIM_log_append, PAL_MILLISECOND);
    CHECK(step_and_log(0, 0) == SM_OK);
    CHECK(sm_log_drain(&flight, 0) && sim_count(SIM_log_append) == 1);
    CHECK(sm_log_drain(&flight, 3 * PAL_MILLISECOND) && sim_count(SIM_log_append) == 4);
    CHECK(!sm_log_drain(&flight, PAL_SECOND));
}

// Pieces have at most SM_LOG_PIECE bytes, however much waits: a task that shares the medium's thread waits for at most one piece.
static void test_pieces(void)
{
    static uint8_t large[5 * SM_LOG_PIECE];
    size_t before, after;
    Log *log;

    begin_log();
    CHECK(sm_log_close(&flight) == SM_OK);
    sim_reset();
    reset_log(NAME);
    flight.buffer = large;
    flight.room = sizeof large;
    CHECK(sm_log_init(&flight) == SM_OK);
    for (uint64_t k = 0; k < 100; k++)
        CHECK(step_and_log(k, 0) == SM_OK);
    CHECK(flight.head > 2 * SM_LOG_PIECE);
    sim_log(NAME, &before);
    while (sm_log_drain(&flight, 0)) {
        sim_log(NAME, &after);
        CHECK(after > before && after - before <= SM_LOG_PIECE);
        before = after;
    }
    CHECK(sm_log_close(&flight) == SM_OK);
    log = read_all();
    CHECK(log->session.at[0]->records == 100 && log->damaged == 0 && records_are_true(log->session.at[0], 0));
}

// A sync that failed is repeated, even if nothing was written since.
static void test_sync_again(void)
{
    size_t n;

    begin_log();
    CHECK(step_and_log(0, 0) == SM_OK);
    sim_fail(SIM_log_sync, 0, SM_E_DEVICE);
    sim_advance(SM_LOG_SYNC);
    (void)sm_log_drain(&flight, PAL_SECOND);
    CHECK(flight.result == SM_E_DEVICE && sim_log_synced(NAME) == 0);
    sim_advance(SM_LOG_SYNC);
    CHECK(!sm_log_drain(&flight, PAL_SECOND));
    CHECK(sim_log(NAME, &n) && n > 0 && sim_log_synced(NAME) == n);
}

// A ring that is full to the last byte is not mistaken for an empty one.
static void test_full_ring(void)
{
    const uint32_t record = SM_LOG_RECORD(wide_layout.whole.packed);
    uint64_t taken = 0;
    Log *log;

    for (uint32_t room = SM_LOG_LEAST(wide_layout.whole.packed); room < SM_LOG_LEAST(wide_layout.whole.packed) + record; room++) {
        begin_log();
        CHECK(sm_log_close(&flight) == SM_OK);
        sim_reset();
        reset_log(NAME);
        flight.room = room;
        CHECK(sm_log_init(&flight) == SM_OK);
        taken = 0;
        for (uint64_t k = 0; k < 60; k++) {
            taken += step_and_log(k, 0) == SM_OK;
            if (k % 7 == 5)
                (void)sm_log_drain(&flight, 0);           // a piece: everything in the ring
        }
        CHECK(sm_log_close(&flight) == SM_OK);
        log = read_all();
        CHECK(log->session.n == 1 && log->damaged == 0 && log->session.at[0]->records == taken && records_are_true(log->session.at[0], 0));
    }
}

// The log is synced once a second and at the end.
static void test_sync(void)
{
    begin_log();
    for (uint64_t k = 0; k < 1000; k++) {
        CHECK(step_and_log(k, 0) == SM_OK);
        sm_log_drain(&flight, PAL_SECOND);
        sim_advance(TICK);
    }
    CHECK(sim_count(SIM_log_sync) >= 9 && sim_count(SIM_log_sync) <= 11);
    sim_fail(SIM_log_sync, 0, SM_E_DEVICE);
    CHECK(sm_log_close(&flight) == SM_E_DEVICE);
}

// ---- sessions ----
// Where records are out of order, a session lasts from the earliest to the latest.
static void test_out_of_order(void)
{
    Log *log;

    begin_log();
    CHECK(step_and_log(5, 0) == SM_OK && step_and_log(9, 0) == SM_OK && step_and_log(3, 0) == SM_OK && step_and_log(7, 0) == SM_OK);
    CHECK(sm_log_close(&flight) == SM_OK);
    log = read_all();
    CHECK(log->session.n == 1 && log->session.at[0]->records == 4);
    CHECK(log->session.at[0]->first == 3 * TICK && log->session.at[0]->last == 9 * TICK);
}

static void test_sessions(void)
{
    Log *log;

    sim_reset();
    for (uint32_t i = 0; i < 5; i++)
        write_flight(0, 10 + i, i);
    log = read_all();
    CHECK(log->session.n == 5 && log->damaged == 0);
    for (uint32_t i = 0; i < 5 && i < log->session.n; i++)
        CHECK(log->session.at[i]->records == 10 + i && records_are_true(log->session.at[i], i));
}

// ---- a flight for manual inspection: `log FILE` writes it ----

// A flight of four seconds up and down with a gap in it.  The second session is the restart after the gap.
static void fly_and_restart(uint64_t from, uint64_t to)
{
    for (uint64_t k = from; k < to; k++) {
        const SmTick tick = {k * TICK, k};
        const double t = (double)k / 100;

        wide_sv.f64 = 200 * t - 50 * t * t;
        wide_sv.state = k < 200 ? 1 : 2;
        wide_sv.flag = k < 120;
        wide_sv.i16 = (int16_t)(k % 50) - 20;
        wide_sv.time = k;
        if (k == 200)
            add_event(SM_EVENT_STATE, 3, 1, 2, k * TICK);
        (void)sm_log_step(&flight, &tick);
        if (k < 290 || k > 320)
            sm_log_drain(&flight, PAL_SECOND);
    }
}

static int write_sample(const char *path)
{
    FILE *f = fopen(path, "wb");
    size_t n;
    const uint8_t *bytes = sim_log(NAME, &n);

    return !f || fwrite(bytes, 1, n, f) != n || fclose(f) != 0 || test_failed != 0;
}

// One record per second, with states that begin between records.  One of the states lasts less than a second.
static int make_rare_records(const char *path)
{
    begin_log();
    add_event(SM_EVENT_START, 0, 2, 0, 0);
    add_event(SM_EVENT_STATE, 3, 0, 1, 0);
    add_event(SM_EVENT_FAULT, 1, 0, 1, TICK);
    add_event(SM_EVENT_OVERRUN, 0, 1, 1500, TICK);
    for (uint64_t k = 0; k < 10; k++) {
        if (k == 4) {
            add_event(SM_EVENT_STATE, 3, 1, 2, 302 * TICK);
            add_event(SM_EVENT_STATE, 3, 2, 1, 352 * TICK);
        }
        wide_sv.f32 = k == 3 || k == 4 ? NAN : (float)k;               // a sensor that fails and recovers
        CHECK(step_and_log(100 * k, 0) == SM_OK && !sm_log_drain(&flight, PAL_SECOND));
    }
    CHECK(sm_log_close(&flight) == SM_OK);
    return write_sample(path);
}

static int make_sample(const char *path)
{
    begin_log();
    add_event(SM_EVENT_START, 0, 0, 0, 0);
    add_event(SM_EVENT_STATE, 3, 0, 1, 0);
    add_event(SM_EVENT_FAULT, 1, 17, 1, 50 * TICK);
    add_event(SM_EVENT_FAULT, 1, 0, 4, 54 * TICK);
    add_event(SM_EVENT_MODE, 1, 2, 1, 60 * TICK);
    add_event(SM_EVENT_OVERRUN, 0, 2, 1500, 70 * TICK);
    add_event(SM_EVENT_REFUSED, 3, 1, 0, 80 * TICK);
    add_event(99, 7, 8, 9, 90 * TICK);
    fly_and_restart(0, 400);
    CHECK(sm_log_close(&flight) == SM_OK);
    reset_log(NAME);
    CHECK(sm_log_init(&flight) == SM_OK);
    add_event(SM_EVENT_START, 0, 1, 1, 0);
    fly_and_restart(0, 3);
    add_event(SM_EVENT_STOP, 0, 0, 0, 3 * TICK);
    fly_and_restart(3, 4);
    CHECK(sm_log_close(&flight) == SM_OK);
    return write_sample(path);
}

int main(int argc, char **argv)
{
    if (argc > 1)
        return argc > 2 ? make_rare_records(argv[2]) : make_sample(argv[1]);
    arena_init(&arena, heap_alloc, NULL, &oom);
    if (setjmp(oom))
        return 1;
    test_plain();
    test_refused();
    test_foreign();
    test_damaged_beginning();
    test_too_slow();
    test_lost_events();
    test_events_not_handed_over();
    test_record_not_handed_over();
    test_shrunk();
    test_refusals();
    test_full_for_good();
    test_budget();
    test_pieces();
    test_sync();
    test_sync_again();
    test_full_ring();
    test_out_of_order();
    test_sessions();
    arena_free(&arena);
    return test_end("log");
}
