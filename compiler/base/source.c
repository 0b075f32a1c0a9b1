// SPDX-License-Identifier: Apache-2.0
#include "compiler/base/source.h"

#include <string.h>

#include "compiler/base/buf.h"
#include "compiler/base/path.h"

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

const char *source_short_name(const Source *s) { return s->label ? s->label : path_portable_name(s->name); }

// Returns the end of a path with this number of names; all of it if it has no more.
static const char *path_end(const char *path, size_t names)
{
    const char *at = path + strlen(path);

    while (at > path && (names > 0 || (at[-1] != '/' && at[-1] != '\\'))) {
        at--;
        names -= (*at == '/' || *at == '\\') && names > 0;
    }
    return at;
}

void sources_label(Arena *arena, Source *const *at, size_t n)
{
    const char *name = path_portable_name(at[n - 1]->name);
    size_t names = 0, most = 0, same = 0;

    for (size_t i = 0; i < n; i++)
        if (strcmp(path_portable_name(at[i]->name), name) == 0) {
            size_t parts = 0;
            for (const char *c = at[i]->name; *c; c++)
                parts += *c == '/' || *c == '\\';
            most = parts > most ? parts : most;
            same++;
        }
    if (same < 2)
        return;
    for (bool clear = false; !clear && names < most; ) {
        names++;
        clear = true;
        for (size_t i = 0; i < n; i++)
            for (size_t k = 0; k < i; k++)
                clear = clear && (strcmp(path_portable_name(at[i]->name), name) != 0 || strcmp(at[i]->name, at[k]->name) == 0 ||
                                  strcmp(path_end(at[i]->name, names), path_end(at[k]->name, names)) != 0);
    }
    for (size_t i = 0; i < n; i++)
        if (strcmp(path_portable_name(at[i]->name), name) == 0)
            at[i]->label = format_in(arena, "%s", path_end(at[i]->name, names));
}
