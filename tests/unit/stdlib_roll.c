// SPDX-License-Identifier: Apache-2.0
// Rolling windows compared with a model.  The model stores the whole history and computes each statistic again from language.md 7: it fills an
// array of slots with holes, adds pairs level by level, and sorts.  stdlib_roll_small.c runs this with SM_ROLL_SMALL.  There the functions that
// the VM calls and those that emitted C calls are separate, and must leave the same memory.
#include <stdlib.h>

#include "stdlib/roll.h"
#include "tests/test.h"
#include "tests/unit/random.h"

enum { HISTORY = 310000, STATS = (1 << SM_STAT_ELAPSED) - 1, EMITTED = 10000 };

static double history[HISTORY];          // the samples as the window must store them

static bool same(double a, double b) { return (a != a && b != b) || sm_bits(a) == sm_bits(b); }

// ---- the model ----

typedef struct Slot { bool full; double x; } Slot;

static Slot slot[SM_WINDOW_MAX];
static double sorted[SM_WINDOW_MAX];

// Fills the model with the samples of the last n of `steps` steps, each in its slot.
static uint32_t model_fill(uint32_t steps, uint32_t n)
{
    const uint32_t first = steps > n ? steps - n : 0;
    for (uint32_t i = 0; i < n; i++)
        slot[i].full = false;
    for (uint32_t k = first; k < steps; k++) {
        slot[k % n].full = true;
        slot[k % n].x = history[k];
    }
    return steps - first;
}

static double model_avg(uint32_t count, uint32_t n)
{
    for (uint32_t width = n; width > 1; width = (width + 1) / 2)
        for (uint32_t i = 0; i < width; i += 2) {
            const Slot none = { false, 0 }, a = slot[i], b = i + 1 < width ? slot[i + 1] : none;
            slot[i / 2].full = a.full || b.full;
            slot[i / 2].x = a.full && b.full ? a.x + b.x : a.full ? a.x : b.x;
        }
    return slot[0].x / count;
}

static int compare(const void *p, const void *q)
{
    const double a = *(const double *)p, b = *(const double *)q;
    return a != b ? (a < b ? -1 : 1) : (int)(sm_bits(b) >> 63) - (int)(sm_bits(a) >> 63);
}

static void model_sort(uint32_t n)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < n; i++)
        if (slot[i].full)
            sorted[count++] = slot[i].x;
    qsort(sorted, count, sizeof *sorted, compare);
}

static double model_median(uint32_t count)
{
    const double a = sorted[(count - 1) / 2], b = sorted[count / 2];
    if (a == b)
        return a;
    return b - a > 1.7976931348623157e308 ? a / 2 + b / 2 : a + (b - a) / 2;
}

static void model_stats(double *stat, uint32_t steps, uint32_t n)
{
    const uint32_t count = model_fill(steps, n);
    stat[SM_STAT_OLDEST] = history[steps - count];
    stat[SM_STAT_NEWEST] = history[steps - 1];
    stat[SM_STAT_CHANGE] = count < 2 ? 0 : history[steps - 1] - history[steps - count];
    model_sort(n);
    stat[SM_STAT_AVG] = model_avg(count, n);
    stat[SM_STAT_MEDIAN] = model_median(count);
    stat[SM_STAT_MIN] = sorted[0];
    stat[SM_STAT_MAX] = sorted[count - 1];
    stat[SM_STAT_RANGE] = sorted[0] == sorted[count - 1] ? 0.0 : sorted[count - 1] - sorted[0];
}

// ---- samples ----

enum { MOODS = 9 };

static double special(void)
{
    static const uint64_t bits[] = {
        0, 0x8000000000000000, 0x7FF0000000000000, 0xFFF0000000000000, 0x7FF8000000000000, 0xFFF8000000000001, 1, 0x8000000000000001,
        0x7FEFFFFFFFFFFFFF, 0xFFEFFFFFFFFFFFFF, 0x3FF0000000000000, 0x0010000000000000, 0x47EFFFFFE0000000, 0x36A0000000000000
    };
    return sm_from_bits(bits[random_u64() % (sizeof bits / sizeof *bits)]);
}

static double any_sample(int mood, uint32_t k)
{
    switch (mood) {
    case 0: return sm_from_bits(random_f64_bits());
    case 1: return (double)(random_u64() % 7) - 3;
    case 2: return random_u64() % 2 != 0 ? 0.0 : -0.0;
    case 3: return random_u64() % 3 != 0 ? 1.7976931348623157e308 : -1.7976931348623157e308;
    case 4: return special();
    case 5: return (double)k * 0.5;                                       // sorted
    case 6: return 1000 - (double)k * 0.25;                               // in the other direction
    case 7: return k / 50 % 2 != 0 ? 1e6 + (double)(random_u64() % 100) : -1e6 - (double)(random_u64() % 100);
    default: return (double)(int64_t)random_u64() * 1e-10;
    }
}

// Returns the value of an element of the type after a store of x.
static double stored_value(uint32_t kind, double x)
{
    return sm_cell_to_f64((SmType)(kind & SM_ROLL_TYPE), sm_cell_from_f64((SmType)(kind & SM_ROLL_TYPE), x));
}

// ---- comparing ----

static uint64_t memory[5 * SM_WINDOW_MAX];
#if SM_ROLL_SMALL
static uint64_t emitted[5 * SM_WINDOW_MAX];

static double emitted_stat(uint32_t n, uint32_t kind, int s)
{
    switch (s) {
    case SM_STAT_AVG: return sm_roll_avg(emitted + 1, n, kind, sm_roll_count(emitted));
    case SM_STAT_MEDIAN: return sm_roll_median(emitted + 1, n, kind, sm_roll_count(emitted));
    case SM_STAT_MIN: return sm_roll_min(emitted + 1, n, kind, sm_roll_count(emitted));
    case SM_STAT_MAX: return sm_roll_max(emitted + 1, n, kind, sm_roll_count(emitted));
    case SM_STAT_OLDEST: return sm_roll_oldest(emitted + 1, n, kind, emitted);
    case SM_STAT_NEWEST: return sm_roll_newest(emitted + 1, n, kind, emitted);
    case SM_STAT_CHANGE: return sm_roll_change(emitted + 1, n, kind, emitted);
    default: return sm_roll_range(emitted + 1, n, kind, sm_roll_count(emitted));
    }
}

static void check_emitted(uint32_t n, uint32_t kind, const double *stat)
{
    CHECK(memcmp(emitted, memory, sm_roll_words(n, kind) * sizeof *memory) == 0);
    for (int s = 0; s < SM_STAT_ELAPSED; s++)
        if ((kind >> 4 >> s & 1u) != 0)
            CHECK(same(emitted_stat(n, kind, s), stat[s]));
}
#endif

static void sample(uint32_t n, uint32_t kind, double x)
{
#if SM_ROLL_SMALL
    if (n <= EMITTED)
        sm_roll_add_sample(emitted, n, kind, sm_roll_convert(kind, x));
#endif
    sm_roll_sample(memory, n, kind, x);
}

static void clear(uint32_t words)
{
    memset(memory, 0, words * sizeof *memory);
#if SM_ROLL_SMALL
    memset(emitted, 0, words * sizeof *emitted);
#endif
}

// Whether the samples are integers of at most 16 bits.
static bool has_short_integers(uint32_t kind)
{
    const uint32_t type = kind & SM_ROLL_TYPE;
    return type == SM_ROLL_I8 || type == SM_ROLL_I16 || type == SM_ROLL_U8 || type == SM_ROLL_U16;
}

static void check_stats(uint32_t n, uint32_t kind, uint32_t steps)
{
    double stat[SM_STAT_ELAPSED];
    model_stats(stat, steps, n);
    for (int s = 0; s < SM_STAT_ELAPSED; s++)
        if ((kind >> 4 >> s & 1u) != 0)
            CHECK(same(sm_roll_stat(memory, n, kind, (SmStat)s), stat[s]));
    if ((kind & SM_ROLL_MEDIAN) != 0 && has_short_integers(kind))
        CHECK(sm_roll_whole_median(memory + 1, n, kind, sm_roll_count(memory)) == (int32_t)stat[SM_STAT_MEDIAN]);
#if SM_ROLL_SMALL
    if (n <= EMITTED)
        check_emitted(n, kind, stat);
#endif
}

// Runs steps, and compares after each of the first `often` steps, then after every `seldom` steps.
static void check_window(uint32_t n, uint32_t kind, int mood, uint32_t steps, uint32_t often, uint32_t seldom)
{
    if (SM_ROLL_LATE_ORDER && n == 3 && (kind & SM_ROLL_MEDIAN) != 0)
        kind |= SM_ROLL_MEDIAN_OF_3;
    const uint32_t words = sm_roll_words(n, kind);
    clear(words);
    memory[words] = 12345;
    for (uint32_t k = 0; k < steps; k++) {
        const double x = any_sample(mood, k);
        history[k] = stored_value(kind, x);
        sample(n, kind, x);
        if (k < often || k % seldom == 0)
            check_stats(n, kind, k + 1);
    }
    CHECK(memory[words] == 12345);
}

static const SmType types[] = { SM_I8, SM_I16, SM_I32, SM_U8, SM_U16, SM_U32, SM_F32, SM_F64, SM_BOOL };
enum { TYPES = sizeof types / sizeof *types };

static void test_small_windows(void)
{
    for (uint32_t n = 1; n <= 40; n++)
        for (int t = 0; t < TYPES; t++)
            for (int mood = 0; mood < MOODS; mood++) {
                check_window(n, sm_roll_kind(types[t], STATS), mood, 3 * n + 2, 3 * n + 2, 1);
                check_window(n, sm_roll_kind(types[t], STATS & ~(1u << SM_STAT_MEDIAN)), mood, 3 * n + 2, 3 * n + 2, 1);
            }
}

// Every set of statistics has its own layout.
static void test_layouts(void)
{
    static const uint32_t size[] = { 1, 2, 7, 20 };
    for (unsigned i = 0; i < 4; i++)
        for (int t = 0; t < TYPES; t++)
            for (uint32_t stats = 0; stats <= STATS; stats++)
                check_window(size[i], sm_roll_kind(types[t], stats), 8 - (int)stats % 5, 3 * size[i] + 2, 3 * size[i] + 2, 1);
}

static void test_larger_windows(void)
{
    static const uint32_t size[] = { 63, 64, 65, 66, 127, 128, 129, 1001 };
    for (unsigned i = 0; i < sizeof size / sizeof *size; i++)
        for (int t = 0; t < TYPES; t++)
            for (int mood = 0; mood < MOODS; mood++) {
                check_window(size[i], sm_roll_kind(types[t], STATS), mood, 2 * size[i] + 70, 5, size[i] > 500 ? 53 : 17);
                check_window(size[i], sm_roll_kind(types[t], STATS & ~(1u << SM_STAT_MEDIAN)), mood, 2 * size[i] + 70, 5, size[i] > 500 ? 97 : 31);
            }
}

// In the small form a median moves the samples of the whole window for each one that comes, which takes half a minute under a sanitizer.
#if SM_ROLL_SMALL && (defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__))
enum { LONGEST_MEDIAN = 20000 };
#else
enum { LONGEST_MEDIAN = SM_WINDOW_MAX };
#endif

// Windows longer than one block, up to the longest.
static void test_long_windows(void)
{
    static const uint32_t size[] = { 2047, 2048, 2049, 4096, 4097, 5000, 6144, 6145 };
    for (unsigned i = 0; i < sizeof size / sizeof *size; i++)
        for (int mood = 0; mood < MOODS; mood++) {
            check_window(size[i], sm_roll_kind(SM_F64, STATS), mood, 3 * size[i], 3, 509);
            check_window(size[i], sm_roll_kind(types[mood % TYPES], STATS), (mood * 5 + 8) % MOODS, 3 * size[i], 3, 509);
        }
    check_window(LONGEST_MEDIAN, sm_roll_kind(SM_F64, STATS), 8, 3 * LONGEST_MEDIAN, 2, 29989);
    check_window(LONGEST_MEDIAN, sm_roll_kind(SM_F32, STATS), 8, 2 * LONGEST_MEDIAN + 10000, 2, 29989);
    check_window(LONGEST_MEDIAN, sm_roll_kind(SM_I16, STATS), 7, 2 * LONGEST_MEDIAN + 10000, 2, 29989);
    check_window(SM_WINDOW_MAX, sm_roll_kind(SM_F64, STATS & ~(1u << SM_STAT_MEDIAN)), 0, 210000, 2, 29989);
}

static void test_empty(void)
{
    for (int t = 0; t < TYPES; t++)
        for (uint32_t stats = 0; stats <= STATS; stats++) {
            const uint32_t kind = sm_roll_kind(types[t], stats);
            memset(memory, 0, sm_roll_words(5, kind) * sizeof *memory);
            for (int stat = 0; stat < SM_STAT_ELAPSED; stat++)
                if ((stats >> stat & 1u) != 0)
                    CHECK(sm_bits(sm_roll_stat(memory, 5, kind, (SmStat)stat)) == 0);
        }
}

// I64 and U64 lose their last bits in the conversion to F64, so the model stores them converted.
static void test_kinds(void)
{
    CHECK(sm_roll_kind(SM_I64, 3) == (SM_ROLL_F64 | SM_ROLL_AVG | SM_ROLL_MEDIAN) && sm_roll_kind(SM_U64, 0) == SM_ROLL_F64);
    CHECK(sm_roll_kind(SM_I8, 4) == (SM_ROLL_I8 | SM_ROLL_MIN) && sm_roll_kind(SM_BOOL, 24) == (SM_ROLL_BOOL | SM_ROLL_MAX | SM_ROLL_RANGE));
}

// A window of a narrow type needs less memory in proportion.
static void test_window_sizes_in_memory(void)
{
    const bool small = SM_ROLL_SMALL;
    CHECK(sm_roll_words(11, SM_ROLL_F64 | SM_ROLL_MEDIAN) == 1 + 2 * 11);
    CHECK(sm_roll_words(11, SM_ROLL_F32 | SM_ROLL_MEDIAN) == 1 + 2 * 6);
    CHECK(sm_roll_words(11, SM_ROLL_I8 | SM_ROLL_MEDIAN) == 1 + 2 * 2);
    CHECK(sm_roll_words(20, SM_ROLL_I16 | SM_ROLL_AVG) == (small ? 1 : 2) + 5);
    CHECK(sm_roll_words(20, SM_ROLL_F64 | SM_ROLL_AVG) == 1 + 20);
    CHECK(sm_roll_words(32, SM_ROLL_F32 | SM_ROLL_AVG) == 1 + 16);
    CHECK(sm_roll_words(33, SM_ROLL_F64 | SM_ROLL_AVG) == (small ? 1 + 33 : 2 + 33 + 17 + 9 + 5 + 3 + 2));
    CHECK(sm_roll_words(64, SM_ROLL_F32 | SM_ROLL_RANGE) == 1 + 32);
    CHECK(sm_roll_words(100, SM_ROLL_F32 | SM_ROLL_RANGE) == (small ? 1 + 50 : 3 + 50 + 100 + 15 + 50 + 25 + 13 + 7 + 4 + 2));
    CHECK(sm_roll_words(100000, SM_ROLL_I32 | SM_ROLL_MEDIAN) == 1 + 100000 + (small ? 0 : 13));
}

// Samples that have left the window have no effect: the same last n samples in the same slots give the same bits.
static void test_old_samples_leave_no_trace(void)
{
    const uint32_t kind = sm_roll_kind(SM_F64, STATS);
    uint64_t w[2][64] = { { 0 }, { 0 } };
    CHECK(sm_roll_words(8, kind) <= 64);
    for (int k = 0; k < 8; k++)
        sm_roll_push(w[0] + 1, 8, kind, sm_roll_advance(w[0], 8), sm_roll_of_f64(k % 3 == 0 ? sm_from_bits(0x7FF0000000000000u) : 1e300));
    for (int k = 0; k < 8; k++)
        for (int i = 0; i < 2; i++)
            sm_roll_push(w[i] + 1, 8, kind, sm_roll_advance(w[i], 8), sm_roll_of_f64(0.1 * k));
    for (int stat = 0; stat < SM_STAT_ELAPSED; stat++)
        CHECK(same(sm_roll_stat(w[0], 8, kind, (SmStat)stat), sm_roll_stat(w[1], 8, kind, (SmStat)stat)));
}

// ---- windows of times ----

enum { EVENTS = 400 };

// Compares a window of times and a run of n with a list of all events.
static void check_times(uint32_t n, uint64_t most_step, uint64_t start)
{
    const uint32_t times_kind = sm_roll_kind(SM_U64, 1u << SM_STAT_ELAPSED), run_kind = sm_roll_kind(SM_U64, SM_STATS_OF_RUNS);
    uint64_t times[1 + 20] = { 0 }, run[4] = { 0 }, pushed[EVENTS], g = start, first = 0;
    uint32_t count = 0, length = 0;

    run[3] = 12345;
    CHECK(sm_roll_words(n, times_kind) == 1 + n && sm_roll_words(n, run_kind) == 3);
    for (int k = 0; k < EVENTS && g < UINT64_MAX - most_step - 1; k++) {
        const uint64_t event = random_u64() % 12 == 0 ? random_u64() : random_u64() % 8 == 0 ? 0 : random_u64() % 9 == 0 ? 2 : 1;
        g += 1 + random_u64() % most_step;
        sm_roll_sample_event(times, n, times_kind, event, g);
        sm_roll_sample_event(run, n, run_kind, event, g);
        if (event != 0)
            pushed[count++] = g;
        if (event == 0 || event > 1)
            length = 0;
        if (event != 0 && length++ == 0)
            first = g;
        const uint64_t oldest = count == 0 ? 0 : pushed[count > n ? count - n : 0];
        CHECK(sm_roll_stat(times, n, times_kind, SM_STAT_ELAPSED) == (count == 0 ? 0.0 : (double)(pushed[count - 1] - oldest)));
        CHECK(sm_roll_stat(run, n, run_kind, SM_STAT_RUN_STEPS) == (double)(length < n ? length : n));
        CHECK(sm_roll_stat(run, n, run_kind, SM_STAT_RUN_TIME) == (length == 0 ? 0.0 : (double)(g - first)));
    }
    CHECK(run[3] == 12345);
}

static void test_times(void)
{
    for (uint32_t n = 1; n <= 20; n++) {
        check_times(n, 3, 0);
        check_times(n, 1000000, UINT64_MAX - 100000000);
        check_times(n, UINT64_C(1) << 55, 5);
    }
}

static void test_kinds_of_times(void)
{
    CHECK(sm_roll_is_kind(SM_ROLL_TIMES | SM_ROLL_ELAPSED) && sm_roll_is_kind(SM_ROLL_TIMES | SM_ROLL_RUN_STEPS) &&
          sm_roll_is_kind(SM_ROLL_TIMES | SM_ROLL_RUN_TIME | SM_ROLL_RUN_STEPS));
    CHECK(!sm_roll_is_kind(SM_ROLL_TIMES) && !sm_roll_is_kind(SM_ROLL_TIMES | SM_ROLL_AVG) &&
          !sm_roll_is_kind(SM_ROLL_TIMES | SM_ROLL_ELAPSED | SM_ROLL_RUN_TIME) && !sm_roll_is_kind(SM_ROLL_TIMES | SM_ROLL_ELAPSED | SM_ROLL_OLDEST));
    CHECK(!sm_roll_is_kind(SM_ROLL_F64 | SM_ROLL_ELAPSED) && !sm_roll_is_kind(SM_ROLL_U8 | SM_ROLL_RUN_STEPS) &&
          !sm_roll_is_kind(SM_ROLL_F32 | SM_ROLL_AVG | SM_ROLL_RUN_TIME));
}

int main(void)
{
    test_times();
    test_kinds_of_times();
    test_small_windows();
    test_layouts();
    test_larger_windows();
    test_long_windows();
    test_empty();
    test_kinds();
    test_window_sizes_in_memory();
    test_old_samples_leave_no_trace();
    return test_end("stdlib_roll");
}
