// SPDX-License-Identifier: Apache-2.0
// The notes below a diagram: the explanation of its marks, because paper has no tooltips, and of dotted lines.
#ifndef SMC_DIAGRAM_NOTES_H
#define SMC_DIAGRAM_NOTES_H

#include "compiler/report/diagram_model.h"

// A line of a note.  number: in its first line the number of the note, as on the mark; 0 in its other lines, and in the explanation of dotted lines.
typedef struct DiagramNote { uint32_t number; const char *text; int32_t y; } DiagramNote;

typedef struct DiagramNotes {
    VEC(DiagramNote) line;
    int32_t w, h;                 // the size of the notes; 0 if the diagram has none
} DiagramNotes;

// Numbers the marks of a diagram that has been laid out, state by state.
void diagram_number_notes(Diagram *d, DiagramNotes *out);
Box diagram_note_box(const DiagramNote *note);          // around the text of a line and its number
void diagram_write_notes(const DiagramNotes *n, Buf *out);

#endif
