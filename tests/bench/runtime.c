// SPDX-License-Identifier: Apache-2.0
// The cost of an access to the state vector.  runtime.sh counts its instructions with callgrind:
//     runtime ROW N             executes that row N times
//     runtime                   prints the names of the rows
//     runtime time              prints nanoseconds per access of each row, the lowest of several runs
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "plain.h"
#include "runtime-c/event.h"
#include "runtime-c/pal/clock.h"
#include "fight.h"

// Rows are separate functions that the compiler cannot inline or merge.
#ifdef __GNUC__
#define ROW __attribute__((noinline)) static void
#else
#define ROW static void
#endif

static volatile SmF64 number;
static volatile uint64_t hits;
static uint8_t bytes[256];
static SmEvent storage[64];
static SmEvents events = {storage, 64, true, {0}, 0, 0}, own_events = {storage, 64, false, {0}, 0, 0};

#define MANY (&fight_layout.region[FIGHT_R_Many])
#define PAIR (&fight_layout.region[FIGHT_R_Pair])
#define PLAIN_ALL (&plain_layout.region[PLAIN_R_All])

ROW nothing(void) { number = 1; }
ROW member_read(void) { number = plain_sv.f64; }
ROW member_write(void) { plain_sv.f64 = number; }
ROW plain_read(void) { number = plain_f64(); }
ROW plain_write(void) { plain_set_f64(number); }
ROW plain_read_F64(void)
{
    SmF64 value;
    sm_read_F64(&plain_vector, &plain_element[PLAIN_E_f64], &value);
    number = value;
}
ROW plain_read_number(void)
{
    SmF64 value;
    sm_read_number(&plain_vector, &plain_element[PLAIN_E_u16], &value);
    number = value;
}
ROW plain_write_number(void) { sm_write_number(&plain_vector, &plain_element[PLAIN_E_u16], number); }
ROW plain_region(void) { sm_read_region(&plain_vector, PLAIN_ALL, bytes); }
ROW plain_memcpy(void) { memcpy(bytes, (const uint8_t *)plain_vector.at + PLAIN_ALL->offset, PLAIN_ALL->size); }
ROW plain_pack(void) { sm_pack_region(&plain_vector, PLAIN_ALL, bytes, sizeof bytes); }
ROW plain_unpack(void) { sm_unpack_region(&plain_vector, PLAIN_ALL, bytes, PLAIN_ALL->packed); }

ROW lock_alone(void)
{
    pal_lock_take(fight_vector.lock, SM_LOCK_WAIT);
    pal_lock_give(fight_vector.lock);
}
ROW guarded_read(void) { number = fight_number(); }
ROW guarded_write(void) { fight_set_number(number); }
ROW guarded_read_F64(void)
{
    SmF64 value;
    sm_read_F64(&fight_vector, &fight_element[FIGHT_E_number], &value);
    number = value;
}
ROW guarded_read_number(void)
{
    SmF64 value;
    sm_read_number(&fight_vector, &fight_element[FIGHT_E_writes], &value);
    number = value;
}
ROW guarded_eight(void)
{
    if (sm_enter(&fight_vector) == SM_OK) {
        hits = fight_sv.m0 + fight_sv.m1 + fight_sv.m2 + fight_sv.m3 + fight_sv.m4 + fight_sv.m5 + fight_sv.m6 + fight_sv.m7;
        sm_leave(&fight_vector);
    }
}
ROW guarded_region(void) { sm_read_region(&fight_vector, MANY, bytes); }
ROW guarded_pack(void) { sm_pack_region(&fight_vector, PAIR, bytes, sizeof bytes); }

ROW event(void)
{
    const SmEvent e = {1, 2, 3, 4, SM_EVENT_STATE};
    sm_event(&own_events, &e);
}
ROW event_guarded(void)
{
    const SmEvent e = {1, 2, 3, 4, SM_EVENT_STATE};
    sm_event(&events, &e);
}

static const struct { const char *name; void (*run)(void); } row[] = {
#define R(name) {#name, name}
    R(nothing), R(member_read), R(plain_read), R(member_write), R(plain_write), R(plain_read_F64), R(plain_read_number), R(plain_write_number),
    R(plain_memcpy), R(plain_region), R(plain_pack), R(plain_unpack), R(lock_alone), R(guarded_read), R(guarded_write), R(guarded_read_F64),
    R(guarded_read_number), R(guarded_eight), R(guarded_region), R(guarded_pack), R(event), R(event_guarded),
#undef R
};
enum { ROWS = sizeof row / sizeof *row };

static void repeat(size_t r, long n)
{
    for (long i = 0; i < n; i++)
        row[r].run();
}

// Returns nanoseconds per access, the lowest of many runs.
static double time_of(size_t r)
{
    enum { RUNS = 40, N = 20000 };
    uint64_t best = UINT64_MAX;

    for (int i = 0; i < RUNS; i++) {
        uint64_t begin = pal_clock_now(), took;
        repeat(r, N);
        took = pal_clock_now() - begin;
        best = took < best ? took : best;
    }
    return (double)best / N;
}

int main(int argc, char **argv)
{
    const char *what = argc > 1 ? argv[1] : "";

    if (sm_statevec_init(&plain_vector) != SM_OK || sm_statevec_init(&fight_vector) != SM_OK || sm_events_init(&events) != SM_OK ||
        sm_events_init(&own_events) != SM_OK)
        return 1;
    for (size_t r = 0; r < ROWS; r++)
        if (argc == 1)
            printf("%s\n", row[r].name);
        else if (strcmp(what, "time") == 0)
            printf("time %s %.1f\n", row[r].name, time_of(r));
        else if (argc > 2 && strcmp(what, row[r].name) == 0)
            repeat(r, atol(argv[2]));
    return 0;
}
