// SPDX-License-Identifier: Apache-2.0
// The state vector between threads.  What is written in one critical section is read as a whole: as a region, as a snapshot, in wire form, and
// between sm_enter and sm_leave.  No write is lost.
//     vector_linux [unguarded]     With this word no lock is used, and the test must fail.
#include <string.h>

#include "runtime-c/pal/clock.h"
#include "runtime-c/pal/thread.h"
#include "fight.h"
#include "tests/test.h"

#define MOMENT ((uint64_t)250 * PAL_MILLISECOND)          // the duration of each test
#define MOST 0xFFFFFFu                                    // the most rounds
#define LONG ((uint64_t)60 * PAL_SECOND)
#define PAIR (&fight_layout.region[FIGHT_R_Pair])
#define MANY (&fight_layout.region[FIGHT_R_Many])

// The results of one thread, which only this thread accesses until it is joined.
typedef struct Part {
    PalThread thread;
    PalThreadMain *run;
    uint64_t end;
    uint64_t seed, torn, refused, done;
} Part;

// The content of PAIR: `a` and the value computed from it.  Any other content is wrong.
typedef struct Pair { uint64_t a; uint8_t odd, gap[7]; uint64_t not_a; SmF64 number; } Pair;

static Pair pair_of(uint64_t a)
{
    Pair p = {a, a & 1u, {0}, ~a, (SmF64)(a & 0xFFFFFFu)};

    return p;
}

static bool is_whole(const Pair *p)
{
    const Pair q = pair_of(p->a);

    return p->odd == q.odd && p->not_a == q.not_a && p->number == q.number;
}

// Reads the clock only from time to time, so that most of the time is spent in the test itself.
static bool goes_on(Part *part)
{
    part->done++;
    return part->done < MOST && (part->done % 64 != 0 || pal_clock_now() < part->end);
}

static uint64_t next(uint64_t *x) { return *x = *x * 6364136223846793005u + 1442695040888963407u; }

// ---- writers ----

static void write_pairs(void *argument)
{
    Part *part = (Part *)argument;

    while (goes_on(part)) {
        const Pair p = pair_of(next(&part->seed));
        part->refused += sm_write_region(&fight_vector, PAIR, &p) != SM_OK;
    }
}

// The same in wire form.
static void unpack_pairs(void *argument)
{
    Part *part = (Part *)argument;
    uint8_t wire[25];

    while (goes_on(part)) {
        const Pair p = pair_of(next(&part->seed));
        memcpy(wire, &p.a, 8);
        wire[8] = p.odd;
        memcpy(wire + 9, &p.not_a, 8);
        memcpy(wire + 17, &p.number, 8);
        part->refused += sm_unpack_region(&fight_vector, PAIR, wire, sizeof wire) != SM_OK;
    }
}

// All members of the struct are equal, as C code that knows the struct reads them.
static void write_many(void *argument)
{
    Part *part = (Part *)argument;

    while (goes_on(part)) {
        const uint64_t v = next(&part->seed);
        if (sm_enter(&fight_vector) != SM_OK) {
            part->refused++;
            continue;
        }
        fight_sv.m0 = fight_sv.m1 = fight_sv.m2 = fight_sv.m3 = v;
        fight_sv.m4 = fight_sv.m5 = fight_sv.m6 = fight_sv.m7 = v;
        sm_leave(&fight_vector);
    }
}

static void count(void *argument)
{
    Part *part = (Part *)argument;

    while (goes_on(part)) {
        if (sm_enter(&fight_vector) == SM_OK) {
            fight_sv.hits++;
            sm_leave(&fight_vector);
        } else
            part->refused++;
        fight_set_writes((uint32_t)part->done);
        part->refused += sm_write_U32(&fight_vector, &fight_element[FIGHT_E_writes], (uint32_t)part->done) != SM_OK;
        part->refused += sm_write_number(&fight_vector, &fight_element[FIGHT_E_writes], (SmF64)part->done) != SM_OK;
    }
}

// ---- readers ----

static void read_regions(void *argument)
{
    Part *part = (Part *)argument;

    while (goes_on(part)) {
        uint64_t m[8];
        Pair p;
        part->refused += sm_read_region(&fight_vector, PAIR, &p) != SM_OK || sm_read_region(&fight_vector, MANY, m) != SM_OK;
        part->torn += !is_whole(&p) || memcmp(m, m + 1, sizeof m - sizeof *m) != 0;
    }
}

static void read_snapshots(void *argument)
{
    Part *part = (Part *)argument;

    while (goes_on(part)) {
        FightSv sv;
        Pair p;
        part->refused += sm_read_region(&fight_vector, &fight_layout.whole, &sv) != SM_OK;
        memcpy(&p, &sv.a, sizeof p);
        part->torn += !is_whole(&p) || memcmp(&sv.m0, &sv.m1, 7 * sizeof sv.m0) != 0;
    }
}

static void read_wire(void *argument)
{
    Part *part = (Part *)argument;
    uint8_t wire[25];

    while (goes_on(part)) {
        Pair p = {0, 0, {0}, 0, 0};
        part->refused += sm_pack_region(&fight_vector, PAIR, wire, sizeof wire) != SM_OK;
        memcpy(&p.a, wire, 8);
        p.odd = wire[8];
        memcpy(&p.not_a, wire + 9, 8);
        memcpy(&p.number, wire + 17, 8);
        part->torn += !is_whole(&p);
    }
}

// Reads elements one by one: other threads can write between two reads, but each value was written by one of them.
static void read_elements(void *argument)
{
    Part *part = (Part *)argument;

    while (goes_on(part)) {
        SmF64 number = -1;
        uint64_t hits = fight_hits();
        part->torn += fight_number() > MOST || fight_hits() < hits || fight_writes() > MOST;
        part->refused += sm_read_number(&fight_vector, &fight_element[FIGHT_E_number], &number) != SM_OK;
        part->torn += number < 0 || number > 0xFFFFFF || number != (SmF64)(uint32_t)number;
    }
}

// ---- all at once ----

static PalLock gate;          // held until all threads have begun

static void begin(void *argument)
{
    Part *part = (Part *)argument;

    if (pal_lock_take(gate, LONG) == SM_OK)
        pal_lock_give(gate);
    part->end = pal_clock_now() + MOMENT;
    part->run(part);
}

static void run_together(Part *part, size_t n)
{
    static const PalThreadPlan plan = {"part", 0, 0};

    CHECK(pal_lock_take(gate, LONG) == SM_OK);
    for (size_t i = 0; i < n; i++) {
        part[i].seed = i;
        CHECK(pal_thread_create(&part[i].thread, &plan, begin, &part[i]) == SM_OK);
    }
    CHECK(pal_lock_give(gate) == SM_OK);
    for (size_t i = 0; i < n; i++) {
        CHECK(pal_thread_join(part[i].thread, LONG) == SM_OK);
        CHECK(part[i].refused == 0);
        CHECK(part[i].torn == 0);
    }
    CHECK(fight_vector.faults == 0);
}

static void test_threads(void)
{
    static PalThreadMain *const run[] = {write_pairs, unpack_pairs, write_many, count, read_regions, read_snapshots, read_wire, read_elements};
    static Part part[sizeof run / sizeof *run];
    const Pair first = pair_of(0);

    CHECK(sizeof run / sizeof *run <= PAL_THREADS && sizeof first == PAIR->size);
    CHECK(sm_write_region(&fight_vector, PAIR, &first) == SM_OK);
    for (size_t i = 0; i < sizeof run / sizeof *run; i++)
        part[i].run = run[i];
    run_together(part, sizeof run / sizeof *run);
}

// Several threads that count in the same element lose no count.
static void test_counting(void)
{
    static Part part[3];
    uint64_t counted = 0;

    fight_set_hits(0);
    for (size_t i = 0; i < 3; i++)
        part[i].run = count;
    run_together(part, 3);
    for (size_t i = 0; i < 3; i++)
        counted += part[i].done - 1;
    CHECK(fight_hits() == counted);
}

// ---- a thread that dies inside ----

static void die_inside(void *argument) { *(SmResult *)argument = sm_enter(&fight_vector); }

static void test_death(void)
{
    static const PalThreadPlan plan = {"dies", 0, 0};
    static PalThread thread;
    static SmResult entered = SM_E_DEVICE;
    uint64_t begin, waited, hits = fight_sv.hits;

    CHECK(pal_thread_create(&thread, &plan, die_inside, &entered) == SM_OK);
    CHECK(pal_thread_join(thread, LONG) == SM_OK && entered == SM_OK);
    begin = pal_clock_now();
    fight_set_hits(123);
    waited = pal_clock_now() - begin;
    CHECK(fight_sv.hits == hits && fight_vector.faults == 1);
    CHECK(waited < LONG);
}

int main(int argc, char **argv)
{
    if (argc > 1 && strcmp(argv[1], "unguarded") == 0)
        fight_vector.guarded = false;
    CHECK(sm_statevec_init(&fight_vector) == SM_OK && pal_lock_open(&gate) == SM_OK);
    test_threads();
    test_counting();
    if (fight_vector.guarded)
        test_death();
    return test_end("vector_linux");
}
