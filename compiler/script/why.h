// SPDX-License-Identifier: Apache-2.0
// Explains what a machine did in a step of a script, and what it did not do: the guards with the values of their parts, where a value comes
// from, the transitions that led there, and which other inputs would have changed the outcome.
//
//     WhyQuestion q = {.at_g = 4000, .has_g = true};
//     WhyAnswer a = why_ask(arena, script, &options, &q);
//     why_write_text(&a, &out);
//
// Every statement of an answer was observed in a run of the reference interpreter.  A claim of what would have been different was tried: the
// step ran again with that input.
#ifndef SMC_WHY_H
#define SMC_WHY_H

#include "compiler/base/buf.h"
#include "compiler/script/script.h"
#include "compiler/script/watch.h"

typedef struct WhyQuestion {
    uint64_t at_step;         // the number of the step; 0: the question names none
    uint64_t at_g;            // G of the step, if has_g
    bool has_g;               // without at_step and has_g: the step in which the run ended
    uint32_t machine;         // index of the machine of an application
    const State *to;          // of that machine: why it did, or did not, go there; NULL: not asked
    const Var *of;            // of that machine: why the variable has its value; NULL: not asked
    uint32_t depth;           // how many transitions before the step are listed
} WhyQuestion;

typedef enum WhyStatus {
    WHY_ANSWERED,
    WHY_BETWEEN_STEPS,        // no step has this G: WhyAnswer.before and .after are those of its neighbours
    WHY_ENDED_BEFORE,         // the run ended before, with step WhyAnswer.steps at G = .before
    WHY_NO_STEP,              // the machine has not run a step at or before that time
    WHY_NOT_RUN               // the script does not run: its data cannot be read
} WhyStatus;

// The kinds of lines: constant, its name in JSON.
#define WHY_KINDS(KIND) \
    KIND(HEADING, "heading")          /* the title of the lines that follow */ \
    KIND(STEP, "step")                /* the step that is explained */ \
    KIND(GUARD, "guard")              /* a guard, or a stored condition; its conditions follow */ \
    KIND(CONDITION, "condition")      /* a part of it */ \
    KIND(STORE, "store") \
    KIND(TRANSITION, "transition")    /* in the step that is explained */ \
    KIND(PASSAGE, "passage")          /* a transition before it */ \
    KIND(ORIGIN, "origin")            /* where the value of a variable comes from */ \
    KIND(NEAREST, "nearest")          /* the step that was nearest to a transition that the run never took; its guards and changes follow */ \
    KIND(CHANGE, "change")            /* what would have been different */ \
    KIND(REMARK, "remark")

typedef enum WhyKind {
#define KIND(constant, name) WHY_##constant,
    WHY_KINDS(KIND)
#undef KIND
    WHY_KIND_COUNT
} WhyKind;

// An input with which the step would have had another outcome.
typedef struct WhyChange {
    const Var *var;           // the input
    uint64_t cell, was;       // the value that was tried; the value in the run
    double limit;             // the value with which the variable is compared, if any
    int side;                 // the value tried is the limit (0), or the next one of its type above (1) or below (-1)
    const State *next;        // the target of the transition that the step then makes; NULL: none
    uint64_t stored;          // if the question is about a variable: its value after the changed step
} WhyChange;

typedef struct WhyLine {
    WhyKind kind;
    unsigned depth;           // levels of indentation
    Span at;                  // the position in the source; src NULL: no position
    const char *text;
    const Expr *e;            // GUARD, CONDITION: the expression
    bool truth;               // GUARD, CONDITION: its value
    bool has_gap;
    double gap;               // GUARD, CONDITION: by how much a comparison that was false missed
    uint64_t step, g;         // GUARD, CONDITION: since when it has had this value; other kinds: when it happened.  step 0: unknown
    WhyChange change;         // CHANGE
} WhyLine;

typedef struct WhyAnswer {
    WhyStatus status;
    uint64_t step, g;         // the step that is explained; its G
    uint64_t steps, before, after;
    VEC(WhyLine) line;
} WhyAnswer;

// Runs the script and explains a step.  Of `o` it uses max_steps, seed, setting, settings and requirements.  Reports nothing.
WhyAnswer why_ask(Arena *arena, const Script *s, const ScriptOptions *o, const WhyQuestion *q);

void why_write_text(const WhyAnswer *a, Buf *out);
// One object: the step, and its lines with their positions, values and times.
void why_write_json(const WhyAnswer *a, Buf *out);

#endif
