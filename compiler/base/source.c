// SPDX-License-Identifier: Apache-2.0
#include "compiler/base/source.h"

#include <string.h>

static uint32_t count_lines(const char *text, size_t len)
{
    const char *end = text + len;
    uint32_t lines = 1;

    while ((text = memchr(text, '\n', (size_t)(end - text))) != NULL)
        lines++, text++;
    return lines;
}

// Wraps `text` without copying it, and finds its lines.  `name` and `text` must outlive the result; len <= SOURCE_MAX.
Source *source_new(Arena *arena, const char *name, const char *text, size_t len)
{
    Source *s = ARENA_NEW(arena, Source);
    uint32_t n = 0;

    s->name = name;
    s->text = text;
    s->len = (uint32_t)len;
    s->lines = count_lines(text, len);
    s->line = ARENA_ARRAY(arena, uint32_t, s->lines);
    s->line[n++] = len >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0 ? 3 : 0;     // a byte-order mark is not part of the line
    for (const char *at = text; (at = memchr(at, '\n', (size_t)(text + len - at))) != NULL; )
        s->line[n++] = (uint32_t)(++at - text);
    return s;
}

// Returns a copy of the source for the statements of [all_states] as they apply to this state (Source.copy_of).
Source *source_copy_for_state(Arena *arena, const Source *s, const char *state)
{
    Source *copy = arena_copy(arena, s, sizeof *s);

    copy->copy_of = s;
    copy->state = state;
    return copy;
}

// Returns line and column, each from 1, of the byte at offset `at`.
LineCol source_position(const Source *s, uint32_t at)
{
    uint32_t low = 0, high = s->lines;      // invariant: line[low] <= at < line[high]

    while (high - low > 1) {
        uint32_t mid = low + (high - low) / 2;
        if (s->line[mid] <= at)
            low = mid;
        else
            high = mid;
    }
    if (at < s->line[low])
        at = s->line[low];
    return (LineCol){low + 1, at - s->line[low] + 1};
}

// Returns the text of a line, counted from 1, without its LF or CR LF; *len is its length.
const char *source_line(const Source *s, uint32_t line, uint32_t *len)
{
    uint32_t start = s->line[line - 1];
    uint32_t end = line < s->lines ? s->line[line] - 1 : s->len;

    if (end > start && s->text[end - 1] == '\r')
        end--;
    *len = end - start;
    return s->text + start;
}

// Returns the range from the start of a to the end of b.
Span span_join(Span a, Span b)
{
    a.len = b.at + b.len - a.at;
    return a;
}
