// SPDX-License-Identifier: Apache-2.0
// A growing buffer of text or bytes, in an arena.  A NUL that `n` does not count follows the content.
#ifndef SMC_BUF_H
#define SMC_BUF_H

#include <stddef.h>
#include <stdint.h>

#include "compiler/base/arena.h"

typedef struct Buf {
    Arena *arena;
    char *at;             // n bytes and a NUL; NULL until the first write
    size_t n, cap;
} Buf;

void buf_init(Buf *b, Arena *arena);
void buf_put(Buf *b, const void *bytes, size_t n);
static inline void buf_char(Buf *b, char c)
{
    if (b->cap - b->n < 2) {
        buf_put(b, &c, 1);
        return;
    }
    b->at[b->n++] = c;
    b->at[b->n] = '\0';
}
void buf_str(Buf *b, const char *text);
void buf_spaces(Buf *b, size_t n);
// Appends formatted text.  The formats are those of printf.
#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
void buf_printf(Buf *b, const char *format, ...);
// Appends how many percent n is of `of`, with `digits` digits after the point.  100 only if n is `of`; of nothing, it is 100.
void buf_percent(Buf *b, unsigned long n, unsigned long of, int digits);
const char *buf_text(const Buf *b);          // returns the content so far; "" if nothing was written
void buf_u32(Buf *b, uint32_t v);            // appends 4 bytes, little-endian
void buf_u64(Buf *b, uint64_t v);            // appends 8 bytes, little-endian

// Formats text like printf, in new memory of the arena.
#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
const char *format_in(Arena *arena, const char *format, ...);

#endif
