// SPDX-License-Identifier: Apache-2.0
// What stands below a diagram: what its marks mean, since nobody can point at paper, and how dotted lines are meant.
#ifndef SMC_SVG_NOTES_H
#define SMC_SVG_NOTES_H

#include "compiler/emit/report/diagram.h"

typedef struct SvgNote { uint32_t number; const char *text; int32_t y; } SvgNote;     // a line; number 0: it goes on, or has none

typedef struct SvgNotes {
    VEC(SvgNote) line;
    int32_t w, h;                 // the room that they need; 0 without any
} SvgNotes;

// Numbers the marks of a diagram that has its places, state by state.
void svg_number_notes(Diagram *d, SvgNotes *out);
void svg_put_notes(const SvgNotes *n, Buf *out);

#endif
