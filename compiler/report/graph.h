// SPDX-License-Identifier: Apache-2.0
// The state diagram of a machine: laid out and drawn as SVG, or as text for Graphviz and Mermaid.
//
// The SVG can be a file of its own or part of a page.  It starts with its <svg> tag, has no id, and loads no font, image or script.  Its
// style affects only elements below class "smc-graph".  It is light or dark as the reader's screen is.  The same machine produces the same
// bytes.
#ifndef SMC_GRAPH_H
#define SMC_GRAPH_H

#include "compiler/analysis/analysis.h"

// Counts of a run.  States and transitions with count 0 are drawn differently.
typedef struct GraphCounts {
    const uint64_t *state;        // by State.number - 1: times entered
    const uint64_t *transition;   // by Transition.number: times taken
} GraphCounts;

typedef struct GraphSize { int32_t w, h; } GraphSize;         // CSS pixels, 1/96 inch

// Additions to the diagram; all zero: none.
typedef struct GraphOptions {
    const Diags *findings;        // marked on their states and transitions; or NULL
    const GraphCounts *counts;    // or NULL
    GraphSize *size;              // receives the size of the picture from graph_svg; or NULL
} GraphOptions;

// Each appends the diagram of a->p to `out`.  `a` comes from analysis_begin; its arena provides temporary memory.
void graph_svg(const Analysis *a, const GraphOptions *o, Buf *out);
void graph_dot(const Analysis *a, const GraphOptions *o, Buf *out);
void graph_mermaid(const Analysis *a, const GraphOptions *o, Buf *out);

#endif
