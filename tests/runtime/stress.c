// SPDX-License-Identifier: Apache-2.0
// Random applications with random faults: modes change at any time, ticks take too long, sleeps end too late, the clock jumps by hours, and
// locks, pins and a watchdog refuse calls.  A model predicts which tick of which executor is next, the value of G, and the counters.
//     stress [STEPS [SEED]]; `make stress-runtime N=… SEED=…`
#include <stdlib.h>

#include "runtime-c/app.h"
#include "runtime-c/pal/clock.h"
#include "runtime-c/pal/dio.h"
#include "runtime-c/pal/watchdog.h"
#include "tests/runtime/parts.h"

#define EXECUTORS 3
#define GROUPS 3                          // groups after the first one, which contains only the probe
#define WORKERS 2                         // tasks in each group
#define HOUR (3600 * S)

// The model's copy of a task's state.
typedef struct Worker {
    int executor, place;                  // its position in its tick
    uint32_t every;
    uint64_t due, steps, safings, failures, fault_events;
    uint64_t to_step, to_safe;            // number of its ticks whose mode requires step; safe
    uint32_t in_a_row;
    bool has_safe;
    uint32_t rests;                       // calls of safe after the last tick
} Worker;

typedef struct Model {
    uint64_t ticks, skipped, number;      // number of ticks run, skipped; number of the last tick
    uint64_t began, ended;
    int place;                            // position of the last task that ran in the tick
    uint64_t overruns, told;
} Model;

static Model model[EXECUTORS];
static Worker worker[EXECUTORS][GROUPS][WORKERS];
static SmTask probe[EXECUTORS], work[EXECUTORS][GROUPS][WORKERS];
static SmTask *probes[EXECUTORS][1], *works[EXECUTORS][GROUPS][WORKERS];
static SmRate rate[EXECUTORS][1 + GROUPS];
static SmExecutor executor[EXECUTORS];
static SmExecutor *all[EXECUTORS];
static SmApp app;
static PalDio pin;
static uint64_t g, base, limit, hash, feeds_failed;
static uint64_t longest, latest;           // the longest tick; the longest delay of a sleep
static uint32_t trouble;                  // the maximum duration of a call, in thousandths of a period
static uint32_t locks_failed;
static uint64_t overslept;

// ---- chance ----

static uint64_t seed;

static uint64_t chance(uint64_t below)
{
    seed ^= seed >> 12;
    seed ^= seed << 25;
    seed ^= seed >> 27;
    return (seed * 2685821657736338717u >> 11) % below;
}

static bool one_in(uint64_t n) { return chance(n) == 0; }

static void mix(uint64_t x)
{
    hash = (hash ^ x) * 1099511628211u;
}

// ---- the model ----

// Returns the number of the next tick of executor i, as executor.h defines it.
static uint64_t next_number(int i)
{
    const Model *const m = &model[i];
    const SmExecutor *const e = &executor[i];
    const uint64_t most = e->overrun == SM_CATCH_UP ? e->most : 0;
    uint64_t come;

    if (m->ticks == 0)
        return 0;
    if (m->began - (app.start + m->number * e->period) < e->period)
        return m->number + 1;
    come = (m->ended - app.start + e->period - 1) / e->period;
    return come > m->number + 1 + most ? come - most : m->number + 1;
}

// Returns when executor i can run next: its tick is due, and its last tick has ended.
static uint64_t ready(int i)
{
    const uint64_t due = app.start + next_number(i) * executor[i].period;

    return model[i].ticks > 0 && model[i].ended > due ? model[i].ended : due;
}

static bool is_first(int i)
{
    for (int k = 0; k < app.executors; k++)
        if (ready(k) < ready(i) || (ready(k) == ready(i) && k < i))
            return false;
    return true;
}

static uint64_t least(uint64_t a, uint64_t b) { return a < b ? a : b; }

static void check_g(int i, const SmTick *tick)
{
    const uint64_t since = tick->time / executor[i].unit, now = crew_sv.time;
    const uint64_t wanted = since > UINT64_MAX - base ? UINT64_MAX : base + since;

    CHECK(now >= g);                                       // time never goes back
    if (crew_vector.faults == 0)
        CHECK(now == (wanted > g ? wanted : g));
    g = now;
}

static void check_vitals(void)
{
    const SmExecutor *const e = &executor[0];

    if (crew_vector.faults > 0)
        return;
    CHECK(crew_sv.v_u64 == e->ticks && crew_sv.v_u8 == least(e->overruns, UINT8_MAX));
    CHECK((uint64_t)crew_sv.v_i16 == least(e->skipped, INT16_MAX) && crew_sv.v_u32 == least(e->late / 1000, UINT32_MAX));
}

// ---- events ----

static void count_event(const SmEvent *e)
{
    mix(e->time ^ e->a ^ (uint64_t)e->b << 32 ^ (uint64_t)e->kind << 56);
    if (e->kind == SM_EVENT_OVERRUN)
        model[e->source].told += e->a;
    else if (e->kind == SM_EVENT_FAULT)
        (&worker[0][0][0] + e->source)->fault_events--;
}

static void read_events(void)
{
    SmEvent e;
    uint32_t lost;

    while (sm_events_read(&events, &event_cursor, &e, 1, &lost) == 1) {
        CHECK(lost == 0);
        count_event(&e);
    }
}

// ---- trouble ----

static void spend(int i)
{
    sim_advance(chance(executor[i].period * trouble / 1000 + 1));
    if (trouble > 1000 && one_in(3000))
        sim_advance(chance(3 * HOUR));
    model[i].ended = pal_clock_now();
    if (longest < model[i].ended - model[i].began)
        longest = model[i].ended - model[i].began;
}

static void make_trouble(int i)
{
    static const uint8_t modes[] = {0, 1, 2, 2, 2, 3, 255};

    if (one_in(10))
        crew_sv.first = modes[chance(7)];
    if (one_in(20))
        crew_sv.second = modes[chance(7)];
    if (one_in(30))
        crew_sv.third = modes[chance(7)];
    if (one_in(200))
        sim_fail(SIM_dio_write, (uint32_t)chance(3), SM_E_DEVICE);
    if (one_in(500) && locks_failed > 0)
        sim_fail(SIM_lock_take, (uint32_t)chance(6), SM_E_TIMEOUT);
    if (one_in(500)) {
        sim_fail(SIM_watchdog_feed, (uint32_t)chance(3), SM_E_DEVICE);
        feeds_failed++;
    }
    if (one_in(300))
        sim_fail(SIM_clock_sleep_until, 0, SM_E_DEVICE);
    if (one_in(100)) {
        overslept = one_in(3) ? chance(executor[i].period * trouble / 1000 + 1) : 0;
        latest = overslept > latest ? overslept : latest;
        sim_oversleep(overslept);
    }
    if (called >= limit)
        sm_app_stop(&app);
}

// ---- tasks ----

static void expect_worker(Worker *w, const SmTask *t)
{
    const uint8_t mode = t->mode ? ((const uint8_t *)&crew_sv)[t->mode->offset] : 2;

    w->due++;
    w->to_step += mode == 2;
    w->to_safe += mode != 2 && mode != 0 && w->has_safe;
}

// Modes do not change until the next probe.
static void expect_workers(int i, uint64_t number)
{
    for (int k = 0; k < GROUPS; k++)
        for (int n = 0; n < WORKERS; n++)
            if (number % worker[i][k][n].every == 0)
                expect_worker(&worker[i][k][n], &work[i][k][n]);
}

// The probe: always enabled, and the first task of every tick.
static SmResult probe_step(void *context, const SmTick *tick)
{
    const int i = (int)((Model *)context - model);
    Model *const m = &model[i];
    const uint64_t number = next_number(i);

    called++;
    CHECK(tick->number == number && tick->time == number * executor[i].period);
    CHECK(pal_clock_now() - app.start >= tick->time && is_first(i) && !app.stop);
    CHECK(executor[i].next == executor[i].ticks + executor[i].skipped && executor[i].ticks == m->ticks);
    check_g(i, tick);
    if (i == 0 && m->ticks > 0)
        check_vitals();
    read_events();
    mix(tick->time + (uint64_t)i);
    if (m->ticks > 0)
        m->skipped += number - m->number - 1;
    m->number = number;
    m->ticks++;
    m->place = 0;
    m->began = m->ended = pal_clock_now();
    m->overruns += m->began - app.start - tick->time >= executor[i].period;
    make_trouble(i);
    expect_workers(i, number);
    spend(i);
    return SM_OK;
}

static SmResult do_work(Worker *w, const SmTick *tick)
{
    Model *const m = &model[w->executor];
    SmResult r = SM_OK;

    called++;
    CHECK(tick->number == m->number && w->place > m->place && tick->number % w->every == 0);
    m->place = w->place;
    mix((uint64_t)w->place << 8 | (uint64_t)w->executor);
    spend(w->executor);
    if (one_in(50))
        r = one_in(2) ? SM_E_DEVICE : SM_REFUSED;
    else if (w->place % 2 == 0)
        r = pal_dio_write(pin, tick->number % 2 == 0);
    w->fault_events += r == SM_OK ? w->in_a_row > 0 : w->in_a_row == 0;
    w->failures += r != SM_OK;
    w->in_a_row = r == SM_OK ? 0 : w->in_a_row + 1;
    return r;
}

static SmResult work_step(void *context, const SmTick *tick)
{
    ((Worker *)context)->steps++;
    return do_work(context, tick);
}

// Makes the task safe at a tick, or once more at the end, with the number of the tick that would have been next.
static SmResult work_safe(void *context, const SmTick *tick)
{
    Worker *const w = context;
    const Model *const m = &model[w->executor];

    if (sm_app_stopping(&app) && (m->ticks == 0 || tick->number != m->number)) {
        w->rests++;
        return w->in_a_row > 0 ? SM_E_DEVICE : SM_OK;      // the same result as before, so that no event is emitted
    }
    w->safings++;
    return do_work(context, tick);
}

// ---- a random application ----

static void make_worker(int i, int k, int n, uint32_t every)
{
    const SmElement *const modes[] = {CREW(first), CREW(second), CREW(third), NULL};
    Worker *const w = &worker[i][k][n];
    const Worker fresh = {.executor = i, .place = 1 + k * WORKERS + n, .every = every, .has_safe = chance(2) == 0};
    const SmTask t = {.name = "work", .step = work_step, .safe = fresh.has_safe ? work_safe : NULL, .context = w, .mode = modes[chance(4)],
                      .number = (uint16_t)(w - &worker[0][0][0])};

    *w = fresh;
    work[i][k][n] = t;
    works[i][k][n] = &work[i][k][n];
}

static void make_executor(int i)
{
    static const uint64_t periods[] = {1000, 12345, MS, 10 * MS, 10 * MS, 20 * MS, 100 * MS, S};
    static const uint64_t units[] = {1, 7, 1000, MS, MS, S};
    const SmTask t = {.name = "probe", .step = probe_step, .context = &model[i], .number = 1000};
    const SmRate first = {1, 1, probes[i]};
    const SmExecutor e = {.name = "e", .period = periods[chance(8)], .rate = rate[i], .rates = 1 + GROUPS,
                          .overrun = one_in(2) ? SM_SKIP : SM_CATCH_UP, .most = (uint32_t)chance(6), .sv = &crew_vector, .events = &events,
                          .time = CREW(time), .unit = i > 0 ? executor[0].unit : units[chance(6)], .number = (uint16_t)i};
    const SmVitals v = {CREW(v_u64), CREW(v_u8), CREW(v_i16), CREW(v_u32), CREW(v_i8)};

    memset(&model[i], 0, sizeof model[i]);
    probe[i] = t;
    probes[i][0] = &probe[i];
    rate[i][0] = first;
    for (int k = 0; k < GROUPS; k++) {
        const uint32_t every = (uint32_t)(1 + chance(12));
        const SmRate r = {every, WORKERS, works[i][k]};

        for (int n = 0; n < WORKERS; n++)
            make_worker(i, k, n, every);
        rate[i][1 + k] = r;
    }
    executor[i] = e;
    if (i == 0)
        executor[i].vitals = v;
    all[i] = &executor[i];
}

static void make_app(uint64_t calls_wanted)
{
    static const uint64_t bases[] = {0, 0, 12345, UINT64_MAX - 3000};
    static const uint32_t troubles[] = {5, 5, 100, 200, 1500};
    const SmApp fresh = {.name = "stress", .sv = &crew_vector, .events = &events, .executor = all, .executors = (uint16_t)(1 + chance(EXECUTORS)),
                         .one_thread = true, .watchdog = one_in(2) ? 0 : S};

    parts_reset();
    app = fresh;
    for (int i = 0; i < EXECUTORS; i++)
        make_executor(i);
    crew_vector.faults = 0;
    crew_vector.guarded = events.guarded = chance(3) > 0;
    g = base = crew_sv.time = bases[chance(4)];
    trouble = troubles[chance(5)];
    locks_failed = (uint32_t)chance(2);
    limit = calls_wanted;
    feeds_failed = overslept = longest = latest = 0;
    CHECK(pal_dio_open(&pin, 4, PAL_DIO_OUTPUT, false) == SM_OK);
}

// ---- totals ----

static void check_task(const Worker *w, const SmTask *t)
{
    const uint32_t again = w->in_a_row > 0 ? w->rests : 0;

    CHECK(t->steps == w->steps && t->safings == w->safings + w->rests && t->failures == w->failures + again && t->failures_in_row == w->in_a_row + again);
    CHECK(w->rests <= 1 && (t->mode || !w->has_safe || w->rests == 1));
    CHECK(w->steps + w->safings <= w->due && (t->mode || w->steps == w->due));
    CHECK(crew_vector.faults > 0 || (w->steps == w->to_step && w->safings == w->to_safe));
    CHECK(w->fault_events == 0 || events.faults > 0);
}

static void check_executor(int i)
{
    const SmExecutor *const e = &executor[i];

    CHECK(e->ticks == model[i].ticks && e->next == e->ticks + e->skipped && e->next == next_number(i));
    CHECK(e->overruns == model[i].overruns && (events.faults > 0 || e->reported_skipped == model[i].told));
    for (int k = 0; k < GROUPS; k++)
        for (int n = 0; n < WORKERS; n++)
            check_task(&worker[i][k][n], &work[i][k][n]);
}

// The watchdog has fired if a tick took longer than its timeout.  It has not if all ticks were short.
static void check_watchdog(void)
{
    if (app.watchdog == 0)
        return;
    CHECK(sim_watchdog_fired() || longest <= app.watchdog);
    CHECK(!sim_watchdog_fired() || longest + latest > app.watchdog / 8 || feeds_failed > 0);
    CHECK(pal_watchdog_feed() == SM_E_HANDLE);
}

static void check_end(void)
{
    read_events();
    for (int i = 0; i < app.executors; i++)
        check_executor(i);
    if (crew_vector.guarded)                               // all locks are free
        CHECK(pal_lock_close(crew_vector.lock) == SM_OK && pal_lock_close(events.lock) == SM_OK);
    check_watchdog();
}

// Runs one application.  Returns the hash of all that happened.
static uint64_t run(uint64_t calls_wanted)
{
    hash = 14695981039346656037u;
    make_app(calls_wanted);
    CHECK(sm_app_run(&app) == SM_OK);
    check_end();
    return hash;
}

int main(int argc, char *argv[])
{
    const uint64_t steps = argc > 1 ? strtoull(argv[1], NULL, 10) : 30000;
    const uint64_t first = argc > 2 ? strtoull(argv[2], NULL, 10) : 1;
    uint64_t done = 0, apps = 0, overruns = 0, skipped = 0;

    for (; done < steps && test_failed == 0; apps++) {
        uint64_t before;

        seed = (first + apps) * 0x9E3779B97F4A7C15u | 1;
        before = run(500 + apps % 7 * 500);
        for (int i = 0; i < app.executors; i++) {
            overruns += executor[i].overruns;
            skipped += executor[i].skipped;
        }
        done += called;
        if (apps % 8 == 0) {                               // the same seed must give the same hash
            seed = (first + apps) * 0x9E3779B97F4A7C15u | 1;
            CHECK(run(500 + apps % 7 * 500) == before);
        }
        if (test_failed)
            fprintf(stderr, "seed %llu\n", (unsigned long long)(first + apps));
    }
    printf("%llu steps of %llu applications, %llu overruns, %llu ticks left out\n", (unsigned long long)done, (unsigned long long)apps,
           (unsigned long long)overruns, (unsigned long long)skipped);
    return test_end("stress");
}
