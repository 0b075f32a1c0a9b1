// SPDX-License-Identifier: Apache-2.0
// Rolling windows on an emulated ATmega328P, in their small form, compared with those of this computer, which store trees and another order of
// samples.  They must have the same bits for every type, size and set of statistics.  Prints the cycles of a sample and of each statistic.
//   run_roll ELF SEED
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "stdlib/roll.h"
#include "tests/avr/mailbox.h"
#include "tests/avr/sim.h"

enum { MOODS = 3, ALL = 31, MOST = 40 };

typedef struct Pair {
    Sim sim;
    RollBox *box;
    uint64_t window[8 * MOST];                    // the window on this computer
    uint32_t n, kind;
    uint64_t state, sum, count;                   // sum, count: cycles measured
} Pair;

static unsigned long passed, failed;

static uint64_t next(Pair *p)
{
    p->state ^= p->state >> 12;
    p->state ^= p->state << 25;
    p->state ^= p->state >> 27;
    return p->state * 0x2545F4914F6CDD1Du;
}

// Values like those of a sensor; the whole range of small integers, both zeros and values beyond it; any values.
static SmF64 value(Pair *p, int mood)
{
    const uint64_t r = next(p);

    if (mood == 0)
        return sm_div(sm_from_i32((int32_t)(r % 20000)), sm_from_i32(80));
    if (mood == 1)
        return r % 8 == 0 ? sm_neg(sm_from_i32(0)) : sm_from_i32((int32_t)(r % 600) - 300);
    return sm_from_bits(r % 4 == 0 ? (r >> 8 & 0x800FFFFFFFFFFFFFu) | 0x7FF0000000000000u : r % 4 == 1 ? r : r & 0xC0FFFFFFFFFFFFFFu);
}

static bool ask(Pair *p, unsigned what, SmF64 x)
{
    p->box->what = (uint8_t)what;
    p->box->x = sm_bits(x);
    p->box->n = p->n;
    p->box->kind = p->kind;
    if (!sim_until_ready(&p->sim))
        return false;
    p->sum += p->sim.cycles;
    p->count++;
    return true;
}

static bool same(uint64_t a, SmF64 b) { return a == sm_bits(b) || (sm_is_nan(sm_from_bits(a)) && sm_is_nan(b)); }

static bool check_stat(Pair *p, int s)
{
    const SmF64 here = sm_roll_stat(p->window, p->n, p->kind, (SmStat)s);

    if (ask(p, (unsigned)s, here) && same(p->box->x, here))
        return passed++, true;
    if (failed++ < 20)
        printf("n %u, kind %x, statistic %d: %016llx, should be %016llx\n", p->n, p->kind, s, (unsigned long long)p->box->x,
               (unsigned long long)sm_bits(here));
    return false;
}

static void begin(Pair *p, SmType type, uint32_t n, uint32_t stats)
{
    p->n = n;
    p->kind = sm_roll_kind(type, stats);
    memset(p->window, 0, sizeof p->window);
    memset(sim_ram(&p->sim) + p->box->window, 0, p->box->window_size);
}

static bool sample(Pair *p, int mood)
{
    const SmF64 x = value(p, mood);

    sm_roll_sample(p->window, p->n, p->kind, x);
    return ask(p, ROLL_SAMPLE, x);
}

static bool check_window(Pair *p, SmType type, uint32_t n, uint32_t stats, int mood)
{
    begin(p, type, n, stats);
    for (uint32_t k = 0; k < 2 * n + 3; k++) {
        if (!sample(p, mood))
            return false;
        for (int s = 0; s < SM_STAT_ELAPSED; s++)
            if ((stats >> s & 1u) != 0 && (k < 3 || k + 4 > n) && !check_stat(p, s))
                return false;
    }
    return true;
}

// ---- cycles ----

static double cycles(Pair *p) { return (double)p->sum / (double)p->count; }

static double sample_cycles(Pair *p, SmType type, uint32_t n, uint32_t stats)
{
    begin(p, type, n, stats);
    for (uint32_t k = 0; k < n; k++)
        sample(p, 0);
    p->sum = p->count = 0;
    for (uint32_t k = 0; k < 3 * n; k++)
        sample(p, 0);
    return cycles(p);
}

static double stat_cycles(Pair *p, int s)
{
    p->sum = p->count = 0;
    check_stat(p, s);
    return cycles(p);
}

static void print_cycles(Pair *p, SmType type, const char *name, uint32_t n)
{
    printf("%-4s n = %2u: %6.0f", name, n, sample_cycles(p, type, n, ALL & ~(1u << SM_STAT_MEDIAN)));
    for (int s = 0; s < SM_STAT_ELAPSED; s++)
        if (s != SM_STAT_MEDIAN)
            printf(" %7.0f", stat_cycles(p, s));
    printf(" %9.0f", sample_cycles(p, type, n, 1u << SM_STAT_MEDIAN));
    printf(" %7.0f\n", stat_cycles(p, SM_STAT_MEDIAN));
}

int main(int argc, char **argv)
{
    static const struct { SmType type; const char *name; } type[] = {
        {SM_U16, "U16"}, {SM_F32, "F32"}, {SM_F64, "F64"}, {SM_I8, "I8"}, {SM_I16, "I16"}, {SM_I32, "I32"}, {SM_U8, "U8"}, {SM_U32, "U32"},
        {SM_BOOL, "bool"}, {SM_I64, "I64"}};
    static const uint8_t size[] = {1, 2, 3, 8, 11, 20, 40};
    static Pair p;

    if (argc < 3 || !sim_open(&p.sim, argv[1]) || !sim_until_ready(&p.sim))
        return 1;
    p.box = sim_mailbox(&p.sim);
    p.state = strtoull(argv[2], NULL, 10) * 0x9E3779B97F4A7C15u | 1;
    for (unsigned t = 0; t < sizeof type / sizeof *type; t++)
        for (unsigned i = 0; i < sizeof size; i++)
            for (int mood = 0; mood < MOODS; mood++) {
                check_window(&p, type[t].type, size[i], ALL, mood);
                check_window(&p, type[t].type, size[i], ALL & ~(1u << SM_STAT_MEDIAN), mood);
            }
    printf("cycles       sample     avg     min     max   range  of median: sample  median\n");
    for (unsigned t = 0; t < 3; t++)
        for (uint32_t n = 11; n <= 20; n += 9)
            print_cycles(&p, type[t].type, type[t].name, n);
    printf("%lu passed, %lu failed\n", passed, failed);
    return failed != 0 || passed == 0;
}
