// SPDX-License-Identifier: Apache-2.0
// Soft binary64 on an emulated ATmega328P compared with the host's: the same bits, and the cycles of each operation.
//   run_soft ELF N SEED [free]     N random operands for every operation, and as many of the special ones; free: without a limit of cycles
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/avr/mailbox.h"
#include "tests/avr/sim.h"
#include "tests/soft/soft.h"

enum { SHORT_FIRST = 0x8000, SHORT_END = 0x10000, SHORT_MOST = 640, READINGS = 1024, MICROVOLTS = 5000000 };

// The most cycles that the assembly may need on average.  SM_SOFT_PORTABLE has no limits.
static const struct { SoftOp op; double most; } limit[] = {
    {SOFT_add, 260}, {SOFT_sub, 265}, {SOFT_mul, 530}, {SOFT_div, 1550}, {SOFT_lt, 110}, {SOFT_le, 115}, {SOFT_eq, 115},
    {SOFT_to_i32, 150}, {SOFT_from_i32, 110}, {SOFT_to_f32, 170}, {SOFT_from_f32, 90}, {SOFT_sqrt, 1600},
};

// Cycles of an operation.  The average is over typical numbers: F64 of either sign between a millionth and a million.
typedef struct Count { uint64_t sum, n, most; } Count;

static unsigned long wrong, done;
static Count count[SOFT_OPS];

static bool one(Sim *s, SoftOp op, uint64_t a, uint64_t b, Count *c)
{
    uint8_t *m = sim_mailbox(s);
    uint64_t result;
    const uint64_t hard = hard_result(op, a, b);

    memcpy(m, &a, 8);
    memcpy(m + 8, &b, 8);
    m[24] = (uint8_t)op;
    if (!sim_until_ready(s))
        return false;
    memcpy(&result, m + 16, 8);
    done++;
    if (!soft_same(result, hard, op) && wrong++ < 20)
        printf("%s(%016llx, %016llx): %016llx, should be %016llx\n", soft_name(op), (unsigned long long)a, (unsigned long long)b,
               (unsigned long long)result, (unsigned long long)hard);
    if (c != NULL) {
        c->sum += s->cycles;
        c->n++;
    }
    if (count[op].most < s->cycles)
        count[op].most = s->cycles;
    return true;
}

static uint64_t next(uint64_t *state)
{
    *state ^= *state >> 12;
    *state ^= *state << 25;
    *state ^= *state >> 27;
    return *state * 0x2545F4914F6CDD1Du;
}

static uint64_t usual(SoftOp op, uint64_t *state)
{
    const uint64_t r = next(state);

    if (op == SOFT_from_i32 || op == SOFT_from_u32)
        return r >> 32;
    if (op == SOFT_from_f32)
        return (r & 0x807FFFFF) | ((127 - 20 + (r >> 32) % 40) << 23);
    if (op == SOFT_from_i64 || op == SOFT_from_u64)
        return r;
    return (r & 0x800FFFFFFFFFFFFFu) | ((1023 - 20 + next(state) % 40) << 52);
}

static bool run_op(Sim *s, SoftOp op, unsigned long n, uint64_t seed)
{
    const uint64_t *list;
    const size_t specials = soft_specials(&list);
    uint64_t state = (seed * 64 + (uint64_t)op + 1) * 0x9E3779B97F4A7C15u, a, b;

    for (unsigned long i = 0; i < n; i++) {
        soft_random(op, &state, &a, &b);
        if (!one(s, op, a, b, NULL) || !one(s, op, list[next(&state) % specials], list[next(&state) % specials], NULL))
            return false;
    }
    count[op].most = 0;
    for (unsigned long i = 0; i < n; i++) {
        a = usual(op, &state);
        b = usual(op, &state);
        if (!one(s, op, a, b, &count[op]))
            return false;
    }
    return true;
}

static uint64_t bits(double x)
{
    uint64_t b;

    memcpy(&b, &x, sizeof b);
    return b;
}

// Divides by every divisor of 16 digits, for which there is a separate code path, and by some of 17.  Dividends are random, multiples of the
// divisor, and their neighbours.  Also the operations of analog pins on all their readings.
static bool run_short(Sim *s, uint64_t seed, Count *c)
{
    uint64_t state = seed * 0x9E3779B97F4A7C15u, a;

    for (unsigned d = SHORT_FIRST; d < SHORT_END; d++) {
        const double by = d % 16 == 5 ? 2.0 * d + 1 : d, multiple = by * (double)(next(&state) >> (28 + next(&state) % 36));
        a = d % 2 ? usual(SOFT_div, &state) : bits(multiple) + next(&state) % 3 - 1;
        if (!one(s, SOFT_div, a, bits(by / (double)(1u << next(&state) % 31)), by > d ? NULL : c))
            return false;
    }
    for (uint32_t i = 0; i < READINGS; i++)
        if (!one(s, SOFT_div, bits((double)(i * (uint32_t)(MICROVOLTS / 64) >> 4)), bits(1e6), c)
            || !one(s, SOFT_div, bits((double)(next(&state) % MICROVOLTS)), bits(1e6), c))
            return false;
    return true;
}

static void check_short(Sim *s, uint64_t seed)
{
    Count c = {0, 0, 0};
    const bool runs = run_short(s, seed, &c);
    const double average = (double)c.sum / (double)c.n;

    printf("%-10s %8.0f            by 16 digits\n", "div", average);
    done++;
    wrong += !runs || average > SHORT_MOST;
}

static void check_time(SoftOp op, double average)
{
    for (size_t i = 0; i < sizeof limit / sizeof *limit; i++)
        if (limit[i].op == op) {
            done++;
            if (average > limit[i].most) {
                wrong++;
                printf("%s takes %.0f cycles, more than %.0f\n", soft_name(op), average, limit[i].most);
            }
        }
}

int main(int argc, char **argv)
{
    Sim s;

    if (argc < 4 || !sim_open(&s, argv[1]) || !sim_until_ready(&s))
        return 1;
    printf("%-10s %8s %8s   cycles on an ATmega328P\n", "", "average", "most");
    for (int op = 0; op < SOFT_OPS; op++) {
        if (!run_op(&s, (SoftOp)op, strtoul(argv[2], NULL, 10), strtoull(argv[3], NULL, 10)))
            return 1;
        const double average = (double)count[op].sum / (double)count[op].n;
        printf("%-10s %8.0f %8lu\n", soft_name((SoftOp)op), average, (unsigned long)count[op].most);
        if (argc == 4)
            check_time((SoftOp)op, average);
    }
    if (argc == 4)
        check_short(&s, strtoull(argv[3], NULL, 10));
    printf("%lu operands tried, %lu wrong\n", done, wrong);
    return wrong != 0 || done == 0;
}
