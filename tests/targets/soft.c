// SPDX-License-Identifier: Apache-2.0
// Compares the target compiler's double with stdlib's soft binary64, which tests/soft compares with an x86-64.  The operands are every
// SOFT_STRIDE-th pair of special numbers, and SOFT_RANDOM random pairs for each operation.
#include <stdint.h>
#include <stdio.h>

#include "tests/soft/soft.h"

static unsigned long wrong, done;

static void put_text(const char *text)
{
    while (*text != '\0')
        putchar(*text++);
}

static void put_number(uint64_t n, unsigned base)
{
    char digit[24];
    int i = 0;

    do
        digit[i++] = "0123456789abcdef"[n % base];
    while ((n /= base) != 0);
    while (i > 0)
        putchar(digit[--i]);
}

static void check(SoftOp op, uint64_t a, uint64_t b)
{
    const uint64_t soft = soft_result(op, a, b), hard = hard_result(op, a, b);
    const uint64_t told[] = { a, b, hard, soft };

    done++;
    if (soft_same(soft, hard, op) || wrong++ > 20)
        return;
    put_text(soft_name(op));
    for (int i = 0; i < 4; i++) {
        put_text(i == 2 ? " is here " : i == 3 ? ", should be " : " ");
        put_number(told[i], 16);
    }
    put_text("\n");
}

static void check_specials(SoftOp op)
{
    const uint64_t *list;
    const size_t n = soft_specials(&list), all = soft_operands(op) == 2 ? n * n : n;

    for (size_t i = 0; i < all; i += all > n ? SOFT_STRIDE : 1)
        check(op, list[i / (all / n)], list[i % n]);
}

int main(void)
{
    for (int op = 0; op < SOFT_OPS; op++) {
        uint64_t state = ((uint64_t)op + 1) * 0x9E3779B97F4A7C15u, a, b;
        check_specials((SoftOp)op);
        for (uint32_t i = 0; i < SOFT_RANDOM; i++) {
            soft_random((SoftOp)op, &state, &a, &b);
            check((SoftOp)op, a, b);
        }
    }
    put_number(done, 10);
    put_text(" operands tried, ");
    put_number(wrong, 10);
    put_text(" wrong\n");
    return wrong != 0 || done == 0;
}
