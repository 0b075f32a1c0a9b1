// SPDX-License-Identifier: Apache-2.0
// A source text and positions in it.  Lines and columns count from 1; columns count bytes.
#ifndef SMC_SOURCE_H
#define SMC_SOURCE_H

#include <stddef.h>
#include <stdint.h>

#include "compiler/base/arena.h"

typedef struct Source {
    const char *name;     // as the user named it, for messages
    const char *text;     // len bytes and a NUL; may contain NUL bytes itself
    uint32_t len;
    uint32_t *line;       // line[i]: offset of the first byte of line i + 1
    uint32_t lines;       // number of lines; at least 1
    const char *label;    // its name where the name of the file alone is ambiguous, set by sources_label; else NULL
    uint32_t number;      // free for use by the code that created the source; initially 0

    // A copy of a source whose statements belong to several states ([all_states] of a machine), one for each of these states. Positions in it
    // tell which state they belong to. Diagnostics replace it by the source itself.
    const struct Source *copy_of; // the source of which this is a copy; NULL: this is no copy
    const char *state;            // the name of the state
} Source;

// A range of a source.  Zeroed: no position (src is NULL).
typedef struct Span {
    const Source *src;
    uint32_t at, len;     // byte offset and length; a length of 0 points between bytes
} Span;

typedef struct LineCol { uint32_t line, col; } LineCol;

enum { SOURCE_MAX = 0x40000000 };   // the longest source in bytes: the sum of two offsets fits in 32 bits

// Wraps `text` without copying it, and finds its lines.  `name` and `text` must outlive the result; len <= SOURCE_MAX.
Source *source_new(Arena *arena, const char *name, const char *text, size_t len);
Source *source_copy_for_state(Arena *arena, const Source *s, const char *state);      // see Source.copy_of
LineCol source_position(const Source *s, uint32_t at);
// Returns the text of a line, counted from 1, without its LF or CR LF; *len is its length.
const char *source_line(const Source *s, uint32_t line, uint32_t *len);
// Returns the name of a source in results, which are the same on every computer: without folders, unless two sources of the command share it.
const char *source_short_name(const Source *s);
// Gives the last of n sources, and those with the same file name, labels that tell them apart: as much of the end of their paths as is needed.
void sources_label(Arena *arena, Source *const *at, size_t n);
Span span_join(Span a, Span b);     // the range from the start of a to the end of b

#endif
