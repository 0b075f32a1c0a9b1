// SPDX-License-Identifier: Apache-2.0
// The content of a state diagram: nodes, and one edge between two nodes for all transitions from one to the other.  A node is a state, or a
// section [all_states]: its transitions are drawn once, as they are written.  diagram_model.c builds the content from a machine,
// diagram_layout.h places everything, diagram_svg.c draws it.  Lengths are in pixels, y grows downwards.
#ifndef SMC_DIAGRAM_MODEL_H
#define SMC_DIAGRAM_MODEL_H

#include "compiler/report/diagram.h"
#include "compiler/report/written.h"

typedef struct Point { int32_t x, y; } Point;
typedef struct Box { int32_t x, y, w, h; } Box;           // x, y: its upper left corner

typedef struct DiagramLine { const char *text; int32_t w; } DiagramLine;      // w: width of the text
typedef VEC(DiagramLine) DiagramLines;

typedef VEC(const Diag *) DiagramFindings;

// The condition of one transition.
typedef struct DiagramGuard {
    const WrittenTransition *transition;
    const char *text;             // the condition as text, complete; never empty
    DiagramLines line;            // the text as shown: wrapped, at most GUARD_LINES, truncated with "…"
    bool possible;                // some run can take the transition
    DiagramChange change;         // DIAGRAM_SAME unless the diagram shows differences
    uint64_t taken;               // how often runs took the transition; not set if DiagramCounts.by_pair
    DiagramFindings finding;      // findings on the transition or its innermost guard; those on a guard of several transitions are in the first
    uint32_t mark;                // number of the note below the diagram that lists these findings; 0: none
} DiagramGuard;

// How an edge is drawn.
typedef enum EdgeForm {
    EDGE_LINE,                    // a line to the target state
    EDGE_STUB,                    // an arrow to the other state's name, beside the source state
    EDGE_LOOP                     // from the state to itself; if the state also has stubs, the loop is drawn as one of them
} EdgeForm;

typedef struct DiagramEdge {
    uint32_t from, to;            // indices in Diagram.node
    VEC(DiagramGuard) guard;      // the conditions of its transitions in file order, at least one
    EdgeForm form;
    bool possible;                // some run can take one of its transitions
    DiagramChange change;         // the change of all its transitions, if they agree; else CHANGED
    uint64_t taken, shared;       // runs took the edge at least `taken` times, and at most taken + shared times
    bool up;                      // EDGE_LINE: `to` is above `from`
    Box label;                    // box of all guards, stacked
    Box name;                     // EDGE_STUB: box with the name of the target state
    VEC(Point) path;              // EDGE_LINE: the line from state to state; see diagram_layout.h
} DiagramEdge;

// An assignment to an element of the state vector, as a line in the box of its state.
typedef struct DiagramAction {
    const char *block_name;       // "entry", "step", "exit"
    bool first;                   // the first line of its block, before which the name of the block is written
    const char *text;             // "valve = true if T >= 60", truncated with "…"
    int32_t w;                    // width, including the column of the block names
} DiagramAction;

typedef struct DiagramNode {
    const State *state;           // NULL: the node is a section [all_states]
    const AllStates *all;         // the section; NULL: the node is a state
    const char *title;            // the name of the state; "all states except Abort"
    const char *name;             // the name as drawn: truncated with "…" if it is very long
    int32_t name_w;
    VEC(DiagramAction) action;    // in file order, at most ACTIONS, then a line with the number of the others
    int32_t action_w;             // width of the widest action
    bool reached;                 // some run can reach the state
    DiagramChange change;
    uint32_t first_edge, edges;   // outgoing edges: Diagram.edge[first_edge] … [first_edge + edges - 1]
    VEC(uint32_t) stub_in;        // indices in Diagram.edge: incoming edges that are drawn as stubs beside their source states
    const char *from;             // text about the edges in stub_in, such as "from 5 states"; NULL: none
    int32_t from_w;
    DiagramFindings finding;      // findings on the state itself, not on one of its transitions
    uint32_t mark;                // number of the note that lists these findings; 0: none
    Box box;
} DiagramNode;

typedef struct Diagram {
    const Analysis *a;
    const DiagramOptions *o;
    DiagramNode *node;            // states by State.number - 1, then sections [all_states]
    VEC(DiagramEdge) edge;        // by source node, then in file order
    const size_t *first_of;       // transitions_by_state: the transitions of state s are first_of[s] … first_of[s + 1] - 1
    size_t nodes, states;         // number of all nodes, and of those that are states
    int32_t w, h;                 // size of the whole diagram
    VEC(int32_t) cut;             // each y, ascending, where a horizontal line across the picture crosses only edges, so that a slice can end there
    uint64_t crossings;           // number of pairs of edges that cross
} Diagram;

enum {
    NAME_SIZE = 13, GUARD_SIZE = 11,              // font sizes of names and guards
    GUARD_LINE = 14,                              // height of a line of a guard
    GUARD_W = 260, GUARD_LINES = 6,               // maximum width and number of lines of a guard
    GUARD_GAP = 8,                                // distance between two guards of a label
    ACTION_W = 240, ACTIONS = 8,                  // maximum width of an action, and number of actions in a box
    ACTION_LABEL_W = 34,                          // width of the column of "entry", "step" and "exit"
    MARK_W = 16,                                  // width of the mark that follows the first line of a guard with findings
    STUB_H = 20                                   // height of the box around a stub's name
};

// Builds the diagram of the machine of `a`, without positions.
Diagram *diagram_build(const Analysis *a, const DiagramOptions *o);

// ---- diagram_text.c: the largest width of a text in the usual sans-serif fonts ----

int32_t diagram_text_width(const char *text, int32_t size, bool bold);
// Wraps a text to at most `lines` lines, none wider than w.  It prefers breaks before "and" and "or", and avoids breaks inside brackets.
DiagramLines diagram_text_wrap(Arena *arena, const char *text, int32_t size, int32_t w, size_t lines);
bool diagram_text_is_truncated(const DiagramLines *lines);  // whether the last line ends with …
// Returns the text, or the longest start of it that fits with "…".
const char *diagram_text_truncate(Arena *arena, const char *text, int32_t size, bool bold, int32_t w);

// ---- how often runs took the transitions of an edge and entered a state; 0 if DiagramOptions.counts is NULL ----

uint64_t diagram_times_taken(const DiagramEdge *e);       // upper bound of how often runs took the edge
uint64_t diagram_times_taken_in(const Diagram *d, const DiagramEdge *e, const State *from);    // the same, of the transitions from one state
// how often runs entered the state; of a section [all_states]: the sum over the states where it runs
uint64_t diagram_times_entered(const Diagram *d, const DiagramNode *n);
const char *diagram_count_text(const Diagram *d, const char *done, uint64_t count);  // "taken 3 times"
const char *diagram_times_taken_text(const Diagram *d, const DiagramEdge *e);     // "taken 2 to 5 times" if other edges share the count
const char *diagram_unused_lines(const Diagram *d, const DiagramEdge *e);         // ", never by line 24", or ""

// ---- diagram_actions.c: the lines in the boxes of states ----

void diagram_add_actions(Diagram *d);

// ---- diagram_findings.c: assigns findings to states and transitions ----

int32_t diagram_mark_width(const DiagramEdge *e);       // width beside the edge's label that the marks of its guards need; 0: no marks

void diagram_attach_findings(Diagram *d, const Diags *findings);

#endif
