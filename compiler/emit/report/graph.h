// SPDX-License-Identifier: Apache-2.0
// The state diagram of a machine: laid out and drawn as SVG, or as text for Graphviz and Mermaid.
//
// The SVG stands alone and inside a page: it starts with its <svg> tag, has no id, asks for no font, picture or script, and its
// style holds for what is below class "smc-graph" only.  It is light or dark as the reader's screen is.  Same machine, same bytes.
#ifndef SMC_GRAPH_H
#define SMC_GRAPH_H

#include "compiler/analysis/analysis.h"

// How often a run was there; what no run has reached is drawn as such.
typedef struct GraphCounts {
    const uint64_t *state;        // by State.number - 1: times entered
    const uint64_t *transition;   // by Transition.number: times taken
} GraphCounts;

typedef struct GraphSize { int32_t w, h; } GraphSize;         // CSS pixels, 1/96 inch

// What is drawn over the diagram; all zero: nothing.
typedef struct GraphOptions {
    const Diags *findings;        // marked on the states and transitions that they point at; or NULL
    const GraphCounts *counts;    // or NULL
    GraphSize *size;              // where graph_svg puts the size of the picture; or NULL
} GraphOptions;

// Appends the diagram of a->p to `out`.  `a` comes from analysis_begin; its arena takes what is needed on the way.
void graph_svg(const Analysis *a, const GraphOptions *o, Buf *out);
void graph_dot(const Analysis *a, const GraphOptions *o, Buf *out);
void graph_mermaid(const Analysis *a, const GraphOptions *o, Buf *out);

#endif
