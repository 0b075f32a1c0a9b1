// SPDX-License-Identifier: Apache-2.0
#include "compiler/base/buf.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

void buf_init(Buf *b, Arena *arena)
{
    memset(b, 0, sizeof *b);
    b->arena = arena;
}

// Makes room for n more bytes and the final NUL.
static void reserve_bytes(Buf *b, size_t n)
{
    size_t cap = b->cap ? b->cap : 128;

    if (b->cap - b->n > n)
        return;
    while (cap - b->n <= n) {
        if (cap > SIZE_MAX / 2)
            longjmp(*b->arena->oom, 1);
        cap *= 2;
    }
    b->at = arena_grow(b->arena, b->at, b->cap, cap);
    b->cap = cap;
}

void buf_put(Buf *b, const void *bytes, size_t n)
{
    reserve_bytes(b, n);
    if (n)
        memcpy(b->at + b->n, bytes, n);
    b->n += n;
    b->at[b->n] = '\0';
}

void buf_str(Buf *b, const char *text) { buf_put(b, text, strlen(text)); }

void buf_spaces(Buf *b, size_t n)
{
    while (n--)
        buf_char(b, ' ');
}

static void put_formatted(Buf *b, const char *format, va_list args, va_list args_copy)
{
    int n = vsnprintf(NULL, 0, format, args);

    if (n < 0)
        return;
    reserve_bytes(b, (size_t)n);
    vsnprintf(b->at + b->n, (size_t)n + 1, format, args_copy);
    b->n += (size_t)n;
}

void buf_printf(Buf *b, const char *format, ...)
{
    va_list args, args_copy;

    va_start(args, format);
    va_copy(args_copy, args);
    put_formatted(b, format, args, args_copy);
    va_end(args_copy);
    va_end(args);
}

// Returns formatted text, allocated in the arena.
const char *format_in(Arena *arena, const char *format, ...)
{
    va_list args, args_copy;
    Buf b;

    buf_init(&b, arena);
    va_start(args, format);
    va_copy(args_copy, args);
    put_formatted(&b, format, args, args_copy);
    va_end(args_copy);
    va_end(args);
    return buf_text(&b);
}

void buf_percent(Buf *b, unsigned long n, unsigned long of, int digits)
{
    double unit = 1;
    uint64_t units;           // of the last digit

    for (int i = 0; i < digits; i++)
        unit /= 10;
    units = of ? (uint64_t)(100 * (double)n / (double)of / unit + 0.5) : (uint64_t)(100 / unit + 0.5);
    if (n < of && (double)units * unit > 100 - unit / 2)
        units--;
    buf_printf(b, "%.*f", digits, (double)units * unit);
}

const char *buf_text(const Buf *b) { return b->at ? b->at : ""; }

// Appends the low `bytes` bytes of v, the lowest first.
static void put_little_endian(Buf *b, uint64_t v, int bytes)
{
    for (int i = 0; i < bytes; i++)
        buf_char(b, (char)(unsigned char)(v >> (8 * i) & 0xff));
}

void buf_u32(Buf *b, uint32_t v) { put_little_endian(b, v, 4); }
void buf_u64(Buf *b, uint64_t v) { put_little_endian(b, v, 8); }
