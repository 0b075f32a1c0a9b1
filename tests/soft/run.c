// SPDX-License-Identifier: Apache-2.0
// Compares soft binary64 with hardware.
//   run                      every pair of the special numbers, and some random ones, for every operation
//   run N SEED [FILE]        N random ones for every operation, the seeds SEED, SEED + 1, … for a million each; where it was stopped
//                            resumes from FILE, which stores the next seed and the number done
//   run f32                  every binary32 to binary64 and back, and the numbers between it and the next one
#include <stdio.h>
#include <stdlib.h>

#include "tests/soft/soft.h"

enum { BATCH = 1000000 };

// A test is one operation with all operands of one kind: special ones, random ones of a seed, or every binary32.  The first test that fails ends
// the run: other operations use the failed one, and might not terminate.
static unsigned long long wrong, done;
static unsigned passed, failed;

static void check(SoftOp op, uint64_t a, uint64_t b)
{
    const uint64_t soft = soft_result(op, a, b), hard = hard_result(op, a, b);

    done++;
    if (!soft_same(soft, hard, op) && wrong++ < 20)
        printf("%s(%016llx, %016llx): %016llx, should be %016llx\n", soft_name(op), (unsigned long long)a, (unsigned long long)b,
               (unsigned long long)soft, (unsigned long long)hard);
}

// Ends a test that began at these counts.  It fails if an operand was wrong or none was tried.
static bool end_test(unsigned long long done_before, unsigned long long wrong_before)
{
    const bool held = wrong == wrong_before && done > done_before;

    passed += held;
    failed += !held;
    return held;
}

static void check_specials(void)
{
    const uint64_t *list;
    const size_t n = soft_specials(&list);

    for (int op = 0; op < SOFT_OPS; op++) {
        const unsigned long long done_before = done, wrong_before = wrong;
        for (size_t i = 0; i < n; i++)
            for (size_t k = 0; k < (soft_operands((SoftOp)op) == 2 ? n : 1); k++)
                check((SoftOp)op, list[i], list[k]);
        if (!end_test(done_before, wrong_before))
            return;
    }
}

static void check_random(uint64_t seed, unsigned long long n)
{
    for (int op = 0; op < SOFT_OPS; op++) {
        const unsigned long long done_before = done, wrong_before = wrong;
        uint64_t state = (seed * 64 + (uint64_t)op + 1) * 0x9E3779B97F4A7C15u, a, b;
        for (unsigned long long i = 0; i < n; i++) {
            soft_random((SoftOp)op, &state, &a, &b);
            check((SoftOp)op, a, b);
        }
        if (!end_test(done_before, wrong_before))
            return;
    }
}

static void check_f32(void)
{
    uint32_t u = 0;

    do {
        const uint64_t x = hard_result(SOFT_from_f32, u, 0);
        check(SOFT_from_f32, u, 0);
        check(SOFT_to_f32, x, 0);
        check(SOFT_to_f32, x + 0x0FFFFFFF, 0);         // below the tie to the next number, at the tie, above it
        check(SOFT_to_f32, x + 0x10000000, 0);
        check(SOFT_to_f32, x + 0x10000001, 0);
    } while (++u != 0 && wrong == 0);
}

static void keep(const char *path, uint64_t seed, unsigned long long left)
{
    FILE *f = fopen(path, "w");

    if (f != NULL) {
        fprintf(f, "%llu %llu\n", (unsigned long long)seed, left);
        fclose(f);
    }
}

// Runs N operations, and continues where the last run ended if FILE contains its state.
static void campaign(unsigned long long n, uint64_t seed, const char *path)
{
    unsigned long long kept_seed, over = 0;
    FILE *f = path != NULL ? fopen(path, "r") : NULL;

    if (f != NULL) {
        if (fscanf(f, "%llu %llu", &kept_seed, &over) == 2)
            seed = kept_seed;
        fclose(f);
    }
    for (; over < n && wrong == 0; over += BATCH) {
        check_random(seed, BATCH);
        if (path != NULL)
            keep(path, ++seed, over + BATCH);
        else
            seed++;
    }
    printf("%llu of each operation, the next seed is %llu\n", over, (unsigned long long)seed);
}

int main(int argc, char **argv)
{
    if (argc == 1) {
        check_specials();
        if (failed == 0)
            check_random(1, 200000);
    } else if (argv[1][0] == 'f') {
        check_f32();
        end_test(0, 0);
    } else
        campaign(strtoull(argv[1], NULL, 10), argc > 2 ? strtoull(argv[2], NULL, 10) : 1, argc > 3 ? argv[3] : NULL);
    printf("%llu pairs of operands, %llu wrong\n", done, wrong);
    printf("%u passed, %u failed\n", passed, failed);
    return failed != 0 || passed == 0;
}
