// SPDX-License-Identifier: Apache-2.0
// What inputs should be, so that a step comes nearer to a goal.  Only files of this folder include it.
//
//     search_wish.c      from a condition to bounds of the inputs that it reads
//     search_value.c     a value within the bounds
//     search_solve.c     changes of inputs, and for how many steps they last
#ifndef SMC_SEARCH_WISH_H
#define SMC_SEARCH_WISH_H

#include "compiler/search/search_run.h"

#define SEARCH_BIG 1e30       // bounds beyond it are none

// What an input should be.
typedef struct SearchWish {
    double lo, hi;            // bounds
    bool above, below;        // lo, hi are excluded
    bool needed;              // the current value contradicts a bound
    bool differs;             // not equal to `other`
    double other;
    double vary;              // amplitude of noise; 0: none
    double slope;             // change in each step; 0: none
    uint32_t copies;          // an output, as index into Program.var, that it should follow; SEARCH_NONE
} SearchWish;

// Wishes that node n of a decision has a value.
void search_wish_node(SearchRun *k, const SearchDecision *x, uint32_t n, bool value);
// Wishes that a condition decides: it has the value, and the other operands above it do not decide.
void search_wish_condition(SearchRun *k, const SearchDecision *x, uint32_t condition, bool value);
// A solution has to last for so many steps.
void search_wait_for(SearchRun *k, double steps);

bool search_is_within(const SearchWish *w, double x);
// Chooses a number within the bounds of an input.
double search_choose_value(SearchRun *k, uint32_t input);
// A step that matters for numbers of this size.
double search_unit_of(const SearchInput *in, double x);

#endif
