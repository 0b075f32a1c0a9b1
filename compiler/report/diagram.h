// SPDX-License-Identifier: Apache-2.0
// The state diagram of a machine: laid out and drawn as SVG, or as text for Graphviz and Mermaid.
//
// The SVG can be a file of its own or part of a page.  It starts with its <svg> tag, has no id, and loads no font, image or script.  Its
// style affects only elements below class "smc-graph".  Its colours follow the light or dark mode of the reader's screen.  The same machine
// produces the same bytes.
#ifndef SMC_DIAGRAM_H
#define SMC_DIAGRAM_H

#include "compiler/analysis/analysis.h"

// How often runs entered states and took transitions.  States and transitions with count 0 are drawn differently.
typedef struct DiagramCounts {
    const uint64_t *state;        // by State.number - 1: how often the state was entered
    const uint64_t *transition;   // by Transition.number: how often it was taken
    bool by_pair;                 // it is only known from which state to which the machine went: of all transitions from one state to
                                  // another, the first has the count of all of them
} DiagramCounts;

typedef struct DiagramSize { int32_t w, h; } DiagramSize;         // CSS pixels, 1/96 inch

// How a state or transition of the new version of a machine differs from the old version.  Text, lines and colours show it.
typedef enum DiagramChange { DIAGRAM_SAME, DIAGRAM_ADDED, DIAGRAM_REMOVED, DIAGRAM_CHANGED } DiagramChange;

typedef struct DiagramChanges {
    const DiagramChange *state;       // by State.number - 1
    const DiagramChange *transition;  // by Transition.number
    const char *const *was;           // by Transition.number: the condition before the change; NULL: it was the same, or the transition is new
} DiagramChanges;

// Additions to the diagram; all zero: none.
typedef struct DiagramOptions {
    const Diags *findings;          // findings that are marked on their states and transitions; or NULL
    const DiagramCounts *counts;    // counts that are written beside states and transitions; or NULL
    const DiagramChanges *changes;  // a->p joins two machines, whose differences are drawn; only arena, p and transition of *a are then set; or NULL
    DiagramSize *size;              // diagram_write_svg stores the size of the picture here; or NULL
} DiagramOptions;

// Each appends the diagram of a->p to `out`.  `a` comes from analysis_begin; its arena provides temporary memory.
void diagram_write_svg(const Analysis *a, const DiagramOptions *o, Buf *out);
// Returns the width of the slices of a picture of width w: the same for all, and at most `most`, which must be more than 200.
int32_t diagram_slice_width(int32_t w, int32_t most);
// Appends the picture in slices, row by row from top to bottom, each a picture of its own and at most `most` large.  Horizontal cuts are between
// states and between texts: only a state or text that is itself higher than `most` is cut through.  Slices side by side overlap by 200 pixels;
// blank ones are left out.
void diagram_write_slices(const Analysis *a, const DiagramOptions *o, DiagramSize most, Buf *out);
void diagram_write_dot(const Analysis *a, const DiagramOptions *o, Buf *out);
void diagram_write_mermaid(const Analysis *a, const DiagramOptions *o, Buf *out);

#endif
