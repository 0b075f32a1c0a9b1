// SPDX-License-Identifier: Apache-2.0
// The machine wide.sm rounds 64-bit integers as the language defines: to 53 binary digits, halves to even.  The caller stores them,
// since a state script can only store doubles.  The expected values are computed with integers.  Exit 0 when all agree.
#include <stdio.h>

#include "wide.h"

// Rounds v to 53 bits, as a conversion to double does.  A result of 2^64 saturates to 2^64 - 1.
static uint64_t rounded(uint64_t v)
{
    unsigned drop = 0;
    uint64_t rest, half, kept;

    while (v >> drop >= UINT64_C(0x20000000000000))
        drop++;
    if (drop == 0)
        return v;
    rest = v & ((UINT64_C(1) << drop) - 1);
    half = UINT64_C(1) << (drop - 1);
    kept = (v >> drop) + (rest > half || (rest == half && (v >> drop & 1) != 0));
    return drop == 11 && kept == UINT64_C(0x20000000000000) ? UINT64_MAX : kept << drop;
}

static int64_t rounded_signed(int64_t v)
{
    const uint64_t r = v < 0 ? rounded(0 - (uint64_t)v) : rounded((uint64_t)v);

    if (v < 0)
        return r > (uint64_t)INT64_MAX ? INT64_MIN : -(int64_t)r;
    return r > (uint64_t)INT64_MAX ? INT64_MAX : (int64_t)r;
}

// Whether f is d rounded to 24 binary digits.
static int is_float_of(float f, double d)
{
    const volatile float wanted = (float)d;

    return f == wanted;
}

static int is_rounded(Wide *m, WideSv *sv, uint64_t bits)
{
    const int64_t i = (int64_t)(bits >> 1) * (bits & 1 ? -1 : 1);

    sv->i = i;
    sv->u = bits;
    sv->G++;
    if (wide_init(m, sv, 1) != WIDE_OK || wide_step(m, sv) != WIDE_OK)
        return 0;
    return sv->i_of_i == rounded_signed(i) && sv->u_of_u == rounded(bits) && sv->u_of_i == (i < 0 ? 0 : rounded((uint64_t)i)) &&
           sv->i_of_u == (rounded(bits) > (uint64_t)INT64_MAX ? INT64_MAX : (int64_t)rounded(bits)) &&
           sv->i_mean == rounded_signed(i) && sv->u_most == rounded(bits) && sv->u_counted == rounded(bits) &&
           (bits == UINT64_MAX || rounded(bits) == UINT64_MAX || (uint64_t)sv->d_of_u == rounded(bits)) &&
           (i > INT64_MAX - 1024 || (int64_t)sv->d_of_i == rounded_signed(i)) && is_float_of(sv->f_of_i, sv->d_of_i) &&
           is_float_of(sv->f_of_u, sv->d_of_u) && sv->same;
}

int main(void)
{
    static const uint64_t special[] = {
        0, 1, UINT64_C(0x1FFFFFFFFFFFFF), UINT64_C(0x20000000000001), UINT64_C(0x20000000000003), UINT64_C(0x40000000000002),
        UINT64_C(0x40000000000003), UINT64_C(0x40000000000006), UINT64_C(0x7FFFFFFFFFFFFDFF), UINT64_C(0x7FFFFFFFFFFFFE00),
        UINT64_C(0x8000000000000400), UINT64_C(0x8000000000000401), UINT64_C(0xFFFFFFFFFFFFFBFF), UINT64_C(0xFFFFFFFFFFFFFC00),
        UINT64_C(0xFFFFFFFFFFFFFFFF), UINT64_C(0xFFFFFFFF80000000), UINT64_C(0x00000001FFFFFFFF), UINT64_C(0x0100000080000001)};
    static Wide m;
    static WideSv sv;
    uint64_t random = 1;
    int failed = 0;

    for (unsigned n = 0; n < 20000; n++) {
        uint64_t bits = n < sizeof special / sizeof *special ? special[n] : random >> (n % 12);
        random = random * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
        if (!is_rounded(&m, &sv, bits) && failed++ < 5)
            printf("0x%08lx%08lx is not rounded as a double\n", (unsigned long)(bits >> 32), (unsigned long)(bits & 0xFFFFFFFFu));
    }
    return failed != 0;
}
