// SPDX-License-Identifier: Apache-2.0
// What inputs should be, so that a step comes nearer to a goal.  Only files of this folder include it.
//
//     search_wish.c      from a condition to bounds of the inputs that it reads
//     search_value.c     a value within the bounds
//     search_solve.c     changes of inputs, and for how many steps they last
#ifndef SMC_SEARCH_WISH_H
#define SMC_SEARCH_WISH_H

#include "compiler/search/search_run.h"

#define SEARCH_BIG 1e30       // lo and hi of this magnitude or more mean: no bound

// The value that a solution wants an input to have: a *wish*.
typedef struct SearchWish {
    double lo, hi;            // bounds of the input
    bool above, below;        // above: lo itself is excluded; below: hi itself is
    bool needed;              // the current value contradicts a bound
    bool differs;             // the input should not equal `other`
    double other;             // the value that the input should not have, if `differs`
    double vary;              // the input should alternate between two values that differ by this much; 0: it need not
    double slope;             // the input should grow by this much in each step; 0: it need not
    uint32_t copies;          // the output that the input should follow, as a feedback does: index into Program.var; SEARCH_NONE: none
} SearchWish;

// Adds wishes so that node n of a decision gets the value.
void search_wish_node(SearchRun *k, const SearchDecision *x, uint32_t n, bool value);
// Adds wishes so that a condition decides: it gets the value, and no other operand of the enclosing `and` and `or` decides.
void search_wish_condition(SearchRun *k, const SearchDecision *x, uint32_t condition, bool value);
// Makes the solution last at least this many steps.
void search_wait_for(SearchRun *k, double steps);

// Changes the input as its wish demands, instead of as the solution has changed it.
void search_replace_turn(SearchRun *k, uint32_t input);

bool search_is_within(const SearchWish *w, double x);
// Chooses a number within the bounds of an input.
double search_choose_value(SearchRun *k, uint32_t input);
// Returns the size of a change that matters for an input with values of this magnitude.
double search_unit_of(const SearchInput *in, double x);

#endif
