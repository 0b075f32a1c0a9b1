// SPDX-License-Identifier: Apache-2.0
// The notes below a diagram: the explanation of its marks, because paper has no tooltips, and of dotted lines.
#ifndef SMC_DIAGRAM_NOTES_H
#define SMC_DIAGRAM_NOTES_H

#include "compiler/report/diagram_model.h"

typedef struct SvgNote { uint32_t number; const char *text; int32_t y; } SvgNote;     // a line; number 0: it continues, or has none

typedef struct SvgNotes {
    VEC(SvgNote) line;
    int32_t w, h;                 // the size that they need; 0 if there are none
} SvgNotes;

// Numbers the marks of a diagram that has been laid out, state by state.
void svg_number_notes(Diagram *d, SvgNotes *out);
void svg_put_notes(const SvgNotes *n, Buf *out);

#endif
