// SPDX-License-Identifier: Apache-2.0
// The machine of run.sh's readings must treat NaN like 0 in every state, and continue to count from the value that a U64 reads as.  Exit code 0
// if it does.
#include <stdio.h>
#include <string.h>

#include "readings.h"

enum { STATES = 400 };

typedef struct Seen { unsigned char seen, also; } Seen;

// Stores the bits of a NaN, because compiler options can affect how a NaN is computed.
static void put_nan(ReadingsSv *sv)
{
    memset(&sv->x, 0xff, sizeof sv->x);
    memset(&sv->f, 0xff, sizeof sv->f);
}

static unsigned fly(int of_nan, double y, Seen *seen)
{
    static Readings m;
    static ReadingsSv sv;
    unsigned n = 0;

    memset(&sv, 0, sizeof sv);
    if (readings_init(&m, &sv, 1) != READINGS_OK)
        return 0;
    for (; n < STATES && (n == 0 || sv.seen != 0); n++) {
        if (of_nan)
            put_nan(&sv);
        memcpy(&sv.y, &y, sizeof sv.y);
        sv.seen = 0;
        sv.G = n + 1;
        sv.n = UINT64_C(0x20000000000001);
        if (readings_step(&m, &sv) != READINGS_OK)
            return 0;
        if (n == 0 && sv.n != UINT64_C(0x20000000000000))
            return 0;
        seen[n].seen = sv.seen;
        seen[n].also = sv.also;
    }
    return n;
}

int main(void)
{
    static const double ys[] = {-7.0, -0.0, 0.0, 7.0};
    static Seen zero[STATES], nan[STATES];
    int failed = 0;

    for (unsigned i = 0; i < sizeof ys / sizeof *ys; i++) {
        const unsigned n = fly(0, ys[i], zero), of_nan = fly(1, ys[i], nan);
        for (unsigned k = 0; k < n && k < of_nan; k++)
            if (zero[k].seen != nan[k].seen || zero[k].also != nan[k].also)
                failed = printf("N%u: NaN is not 0\n", k + 1);
        if (n != of_nan || n < 300)
            failed = printf("%u steps of 0, %u of NaN\n", n, of_nan);
    }
    return failed != 0;
}
