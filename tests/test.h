// SPDX-License-Identifier: Apache-2.0
// CHECK(a == b), and test_end for the end of main: `int main(void) { CHECK(…); return test_end("name"); }`.  Tests need no registration.
#ifndef SM_TEST_H
#define SM_TEST_H

#include <stdbool.h>
#include <stdio.h>

// A program has one pair of counters. In each of its sources but the one with main, TEST_PART is defined before this header is included; without it
// the linker refuses a second pair, whose failures nothing would report. TEST_TALLY instead: each source has its own pair, and main adds them up.
#if defined TEST_PART
extern int test_passed, test_failed;
#elif defined TEST_TALLY
static int test_passed, test_failed;
#else
int test_passed, test_failed;
#endif

// A check in a loop counts once if it is true, and each time that it is false.
#define CHECK(condition)                                                                      \
    do {                                                                                      \
        static bool test_held;                                                                  \
        if (condition) {                                                                      \
            test_passed += !test_held;                                                          \
            test_held = true;                                                                   \
        } else if (test_failed++ < 20)                                                        \
            fprintf(stderr, "%s:%d: failed: %s\n", __FILE__, __LINE__, #condition);           \
    } while (0)

// Counts a test that is not a line of this program, such as a file.  Counts each call.
static inline void test_count(bool held, const char *name)
{
    test_passed += held;
    if (!held && test_failed++ < 20)
        fprintf(stderr, "failed: %s\n", name);
}

static inline int test_end(const char *name)
{
    printf("%s: %d passed, %d failed\n", name, test_passed, test_failed);
    return test_failed != 0 || test_passed == 0;          // a program that has checked nothing has not passed
}

#endif
