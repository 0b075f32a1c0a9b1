// SPDX-License-Identifier: Apache-2.0
// The processor can be set to another rounding mode, or to flush subnormal numbers to zero, which the compiler does not know.  A machine must
// then refuse to start.  Exit code 0 if it does.
#include <fenv.h>
#include <stdio.h>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include "arithmetic.h"

static int failed;

static void expect(ArithmeticStatus want, const char *what)
{
    static Arithmetic m;
    static ArithmeticSv sv;
    const ArithmeticStatus got = arithmetic_init(&m, &sv, 1);

    if (got != want || (got != ARITHMETIC_OK && arithmetic_step(&m, &sv) == ARITHMETIC_OK)) {
        printf("%s: init gives %d\n", what, (int)got);
        failed = 1;
    }
}

int main(void)
{
    expect(ARITHMETIC_OK, "as the program starts");
    fesetround(FE_UPWARD);
    expect(ARITHMETIC_UNFIT, "rounding upward");
    fesetround(FE_DOWNWARD);
    expect(ARITHMETIC_UNFIT, "rounding downward");
    fesetround(FE_TOWARDZERO);
    expect(ARITHMETIC_UNFIT, "rounding toward zero");
    fesetround(FE_TONEAREST);
    expect(ARITHMETIC_OK, "rounding to nearest");
#if defined(__SSE2__)
    _mm_setcsr(_mm_getcsr() | 0x8000u);
    expect(ARITHMETIC_UNFIT, "results near zero dropped");
    _mm_setcsr((_mm_getcsr() & ~0x8000u) | 0x0040u);
    expect(ARITHMETIC_UNFIT, "operands near zero dropped");
    _mm_setcsr(_mm_getcsr() & ~0x0040u);
    expect(ARITHMETIC_OK, "as before");
#endif
    return failed;
}
