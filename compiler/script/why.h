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
    bool has_g;               // the question names G.  Without at_step and has_g it is about the step in which the run ended
    uint32_t machine;         // index of the machine that the question is about; 0 without an application
    const State *to;          // a state of that machine: why did it, or did it not, make a transition there?  NULL: not asked
    const Var *of;            // a variable of that machine: why does it have its value?  NULL: not asked
    uint32_t depth;           // how many of the transitions before the step are listed
} WhyQuestion;

typedef enum WhyStatus {
    WHY_ANSWERED,
    WHY_BETWEEN_STEPS,        // no step has this G: WhyAnswer.before and .after are G of the steps before and after it
    WHY_ENDED_BEFORE,         // the run ended before that step: its last one was step WhyAnswer.steps at G = WhyAnswer.before
    WHY_NO_STEP,              // the machine has not run any step up to that one
    WHY_NOT_RUN               // the script does not run: its data cannot be read
} WhyStatus;

// The kinds of lines: constant, its name in JSON.
#define WHY_KINDS(KIND) \
    KIND(HEADING, "heading")          /* the title of the lines that follow */ \
    KIND(STEP, "step")                /* the step that is explained */ \
    KIND(GUARD, "guard")              /* a guard, or a stored condition; its conditions follow */ \
    KIND(CONDITION, "condition")      /* a condition in the guard above */ \
    KIND(STORE, "store")              /* an assignment that the step executed */ \
    KIND(TRANSITION, "transition")    /* in the step that is explained */ \
    KIND(PASSAGE, "passage")          /* a transition in an earlier step */ \
    KIND(ORIGIN, "origin")            /* where the value of a variable comes from */ \
    KIND(NEAREST, "nearest")          /* the step that was nearest to a transition that the run never took; its guards and changes follow */ \
    KIND(CHANGE, "change")            /* another value of an input, and what would have been different */ \
    KIND(REMARK, "remark")            /* a sentence */

typedef enum WhyKind {
#define KIND(constant, name) WHY_##constant,
    WHY_KINDS(KIND)
#undef KIND
    WHY_KIND_COUNT
} WhyKind;

// An input with which the step would have had another outcome.
typedef struct WhyChange {
    const Var *var;           // the input that is changed
    uint64_t cell, was;       // the value that was tried; the value in the run
    double limit;             // the value with which the machine compares the variable, if any
    int side;                 // `cell` is the limit (0), or the next value of the type above it (1) or below it (-1)
    const State *next;        // the target of the transition that the step then makes; NULL: none
    uint64_t stored;          // if the question is about a variable: its value after the changed step
} WhyChange;

typedef struct WhyLine {
    WhyKind kind;
    unsigned depth;           // indentation in levels
    Span at;                  // the position in the source; src NULL: no position
    const char *text;
    const Expr *e;            // GUARD, CONDITION: the expression
    bool truth;               // GUARD, CONDITION: whether the expression was true
    bool has_gap;             // `gap` is set
    double gap;               // GUARD, CONDITION: the difference of the two sides of a comparison that was false
    uint64_t step, g;         // number and G of a step.  GUARD, CONDITION: since then it has had this value; others: it happened then.  0: unknown
    WhyChange change;         // CHANGE: the input and its value
} WhyLine;

typedef struct WhyAnswer {
    WhyStatus status;
    uint64_t step, g;         // number and G of the step that is explained
    uint64_t steps, before, after;    // see WHY_BETWEEN_STEPS and WHY_ENDED_BEFORE
    VEC(WhyLine) line;
} WhyAnswer;

// Runs the script and explains a step.  Of `o` it uses max_steps, seed, setting, settings and requirements.  Reports nothing.
WhyAnswer why_ask(Arena *arena, const Script *s, const ScriptOptions *o, const WhyQuestion *q);

void why_write_text(const WhyAnswer *a, Buf *out);
// One object: the step, and its lines with their positions, values and times.
void why_write_json(const WhyAnswer *a, Buf *out);

#endif
