// SPDX-License-Identifier: Apache-2.0
// Rolling windows against a model that keeps the whole history and works each statistic out anew from language.md 7: it
// fills an array of slots with holes, halves it level by level, and sorts by insertion.
#include "stdlib/roll.h"
#include "tests/test.h"
#include "tests/unit/random.h"

enum { HISTORY = 700 };

static double history[HISTORY];

static bool same(double a, double b) { return (a != a && b != b) || sm_bits(a) == sm_bits(b); }

typedef struct Slot { bool full; double x; } Slot;

// The samples of the last n of `steps` steps, each in its slot.
static uint32_t model_fill(Slot *slot, uint32_t steps, uint32_t n)
{
    const uint32_t first = steps > n ? steps - n : 0;
    for (uint32_t i = 0; i < n; i++)
        slot[i].full = false;
    for (uint32_t k = first; k < steps; k++) {
        slot[k % n].full = true;
        slot[k % n].x = history[k] != history[k] ? 0.0 : history[k];
    }
    return steps - first;
}

static double model_avg(uint32_t steps, uint32_t n)
{
    Slot slot[HISTORY];
    const uint32_t count = model_fill(slot, steps, n);
    for (uint32_t width = n; width > 1; width = (width + 1) / 2)
        for (uint32_t i = 0; i < width; i += 2) {
            const Slot a = slot[i], b = i + 1 < width ? slot[i + 1] : (Slot){ false, 0 };
            slot[i / 2].full = a.full || b.full;
            slot[i / 2].x = a.full && b.full ? a.x + b.x : a.full ? a.x : b.x;
        }
    return slot[0].x / count;
}

static bool before(double a, double b) { return a < b || (a == b && sm_bits(a) >> 63 > sm_bits(b) >> 63); }

static uint32_t model_sorted(double *out, uint32_t steps, uint32_t n)
{
    Slot slot[HISTORY];
    uint32_t count = 0, j;
    model_fill(slot, steps, n);
    for (uint32_t i = 0; i < n; i++) {
        if (!slot[i].full)
            continue;
        for (j = count++; j > 0 && before(slot[i].x, out[j - 1]); j--)
            out[j] = out[j - 1];
        out[j] = slot[i].x;
    }
    return count;
}

static double model_stat(SmStat stat, uint32_t steps, uint32_t n)
{
    double s[HISTORY], a, b;
    const uint32_t count = model_sorted(s, steps, n);
    switch (stat) {
    case SM_STAT_AVG: return model_avg(steps, n);
    case SM_STAT_MIN: return s[0];
    case SM_STAT_MAX: return s[count - 1];
    case SM_STAT_RANGE: return s[0] == s[count - 1] ? 0.0 : s[count - 1] - s[0];
    case SM_STAT_MEDIAN:
        a = s[(count - 1) / 2];
        b = s[count / 2];
        if (a == b)
            return a;
        return b - a > 1.7976931348623157e308 ? a / 2 + b / 2 : a + (b - a) / 2;
    case SM_STAT_COUNT: break;
    }
    return 0;
}

static double any_sample(int mood)
{
    switch (mood) {
    case 0: return sm_from_bits(random_f64_bits());
    case 1: return (double)(random_u64() % 7) - 3;
    case 2: return random_u64() % 2 != 0 ? 0.0 : -0.0;
    case 3: return random_u64() % 3 != 0 ? 1.7976931348623157e308 : -1.7976931348623157e308;
    case 4: return random_u64() % 9 == 0 ? sm_from_bits((random_u64() & 0x8000000000000000u) | 0x7FF0000000000000u) : 1.5;
    default: return (double)(int64_t)random_u64() * 1e-17;
    }
}

static void check_window(uint32_t n, uint32_t steps, uint32_t stats, int mood)
{
    static double memory[2 * HISTORY + 1];
    SmRoll r;
    memory[sm_roll_bytes(n, stats) / sizeof(double)] = 12345;
    sm_roll_init(&r, memory, n, stats);
    for (uint32_t k = 0; k < steps; k++) {
        history[k] = any_sample(mood);
        sm_roll_push(&r, history[k]);
        for (int stat = 0; stat < SM_STAT_COUNT; stat++)
            if ((stats >> stat & 1u) != 0)
                CHECK(same(sm_roll_stat(&r, (SmStat)stat), model_stat((SmStat)stat, k + 1, n)));
    }
    CHECK(memory[sm_roll_bytes(n, stats) / sizeof(double)] == 12345);
}

static void test_against_model(void)
{
    for (uint32_t n = 1; n <= 40; n++)
        for (int mood = 0; mood < 6; mood++) {
            check_window(n, 3 * n + 2, 31, mood);
            check_window(n, 3 * n + 2, 31 & ~(1u << SM_STAT_MEDIAN), mood);
        }
    for (int mood = 0; mood < 6; mood++)
        check_window(300, HISTORY, 31, mood);
}

static void test_empty(void)
{
    double memory[10];
    SmRoll r;
    sm_roll_init(&r, memory, 5, 31);
    for (int stat = 0; stat < SM_STAT_COUNT; stat++)
        CHECK(sm_bits(sm_roll_stat(&r, (SmStat)stat)) == 0);
}

// What has left leaves no trace: the same last n samples give the same bits as long as they sit in the same slots.
static void test_no_trace(void)
{
    double memory[2][16];
    SmRoll r[2];
    for (int i = 0; i < 2; i++)
        sm_roll_init(&r[i], memory[i], 8, 31);
    for (int k = 0; k < 8; k++)
        sm_roll_push(&r[0], k % 3 == 0 ? sm_from_bits(0x7FF0000000000000u) : 1e300);
    for (int k = 0; k < 8; k++) {
        sm_roll_push(&r[0], 0.1 * k);
        sm_roll_push(&r[1], 0.1 * k);
    }
    for (int stat = 0; stat < SM_STAT_COUNT; stat++)
        CHECK(same(sm_roll_stat(&r[0], (SmStat)stat), sm_roll_stat(&r[1], (SmStat)stat)));
}

static void test_largest(void)
{
    static double memory[2 * SM_WINDOW_MAX];
    SmRoll r;
    CHECK(sm_roll_bytes(SM_WINDOW_MAX, 31) == sizeof memory);
    sm_roll_init(&r, memory, SM_WINDOW_MAX, 31);
    for (uint32_t k = 0; k < SM_WINDOW_MAX + 5; k++)
        sm_roll_push(&r, (double)(k * 7 % 1000));
    CHECK(sm_roll_min(&r) == 0 && sm_roll_max(&r) == 999 && sm_roll_range(&r) == 999);
    CHECK(sm_roll_avg(&r) == 499.5 && sm_roll_median(&r) == 499.5);   // 100000 is a hundred times every residue; sums are exact
}

int main(void)
{
    test_against_model();
    test_empty();
    test_no_trace();
    test_largest();
    return test_end("stdlib_roll");
}
