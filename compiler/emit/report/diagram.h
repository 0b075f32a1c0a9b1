// SPDX-License-Identifier: Apache-2.0
// What a state diagram shows: states, and between two states one edge for all transitions that lead from one to the other.
// diagram.c makes it of a machine, layout.h gives everything its place, svg.c draws it.  Lengths are pixels, y grows downwards.
#ifndef SMC_DIAGRAM_H
#define SMC_DIAGRAM_H

#include "compiler/emit/report/graph.h"

typedef struct Point { int32_t x, y; } Point;
typedef struct Box { int32_t x, y, w, h; } Box;           // x, y: left and top

typedef struct TextLine { const char *text; int32_t w; } TextLine;
typedef VEC(TextLine) TextLines;

typedef VEC(const Diag *) Findings;

// Why one transition is made.
typedef struct Guard {
    const Transition *transition;
    const char *text;             // all of it; never empty
    TextLines line;               // as shown: wrapped, at most GUARD_LINES, cut off with "…"
    bool possible;                // some run may take it
    Findings finding;             // on it or its guard
    uint32_t mark;                // the number of the note below the picture that tells them
} Guard;

// How an edge is drawn.
typedef enum EdgeForm {
    EDGE_LINE,                    // a line to the state
    EDGE_STUB,                    // an arrow to the state's name, beside the state that it leaves
    EDGE_LOOP                     // back to the state itself; where stubs stand there too it is one of them
} EdgeForm;

typedef struct DiagramEdge {
    uint32_t from, to;            // Diagram.node
    VEC(Guard) guard;             // in file order, at least one
    EdgeForm form;
    bool possible;                // some run may take it
    bool up;                      // LINE: `to` lies above `from`
    Box label;                    // all guards, one below the other
    Box name;                     // STUB: the name of the state it leads to
    VEC(Point) way;               // LINE: from state to state; see layout.h
} DiagramEdge;

typedef struct DiagramNode {
    const State *state;
    const char *name;             // as shown: cut off with "…" when it is very long
    int32_t name_w;
    bool reached;                 // some run may come here
    uint32_t first_edge, edges;   // those that leave it: Diagram.edge[first_edge …]
    VEC(uint32_t) stub_in;        // edges that end here as stubs elsewhere
    const char *from;             // "from 5 states", of stub_in; NULL: there are none
    int32_t from_w;
    Findings finding;             // on the state, not on one of its transitions
    uint32_t mark;
    Box box;
} DiagramNode;

typedef struct Diagram {
    const Analysis *a;
    const GraphOptions *o;
    DiagramNode *node;            // by State.number - 1
    VEC(DiagramEdge) edge;        // by state they leave, there in file order
    size_t nodes;
    int32_t w, h;                 // of the whole picture
    uint64_t crossings;           // of two edges
} Diagram;

enum {
    NAME_SIZE = 13, GUARD_SIZE = 11,              // of letters
    GUARD_LINE = 14,                              // from line to line
    GUARD_W = 190, GUARD_LINES = 3,               // the widest guard, and the most lines of one
    GUARD_GAP = 7,                                // between two guards of a label
    STUB_H = 20                                   // the box around a stub's name
};

// The machine of `a` as a diagram; nothing has a place yet.
Diagram *diagram_of(const Analysis *a, const GraphOptions *o);

// ---- diagram_text.c: how wide a text is, whatever sans-serif font the reader has ----

int32_t text_width(const char *text, int32_t size, bool bold);
// At most `lines` lines, none wider than w, broken before "and" and "or" where that fits.
TextLines text_wrap(Arena *arena, const char *text, int32_t size, int32_t w, size_t lines);
bool text_is_cut(const TextLines *lines);          // the last one ends with …
// The text, or as much of its start as fits, and "…".
const char *text_cut(Arena *arena, const char *text, int32_t size, bool bold, int32_t w);

// ---- counts: of what a run has done; 0 and false without them ----

uint64_t edge_count(const Diagram *d, const DiagramEdge *e);
uint64_t node_count(const Diagram *d, const DiagramNode *n);
const char *count_text(const Diagram *d, const char *done, uint64_t count);       // "taken 3 times"
const char *edge_count_text(const Diagram *d, const DiagramEdge *e);

// ---- marks.c: which findings belong where ----

void diagram_mark(Diagram *d, const Diags *findings);

#endif
