// SPDX-License-Identifier: Apache-2.0
// What can be true at once in one step of a state: the values that the conditions on a path compare, split into regions, in all combinations.
//
//     search_regions.c   numbers values, makes groups of them, and judges conditions in a combination
//     search_lemmas.c    relations between groups that exclude combinations
//     search_prove.c     which goals no combination reaches
#ifndef SMC_SEARCH_REGIONS_H
#define SMC_SEARCH_REGIONS_H

#include "compiler/cover/run_facts.h"
#include "compiler/search/search_run.h"

enum { MOST_REGIONS = 40, MOST_GROUPS = 14, MOST_LEMMAS = 32 };
#define MOST_COMBINATIONS UINT32_C(400000)

// An expression over the values at the start of a step: equal numbers mean equal values.
typedef struct Value {
    IrOp op;
    SmType type;
    SmStat stat;
    uint32_t a, b, var;       // operands as values; for a load, a is 0 if an earlier function of the step can have stored the variable
    uint64_t bits;
} Value;

// A value, or two, whose regions are enumerated.
typedef struct RegionGroup {
    uint32_t x, y;            // y: SEARCH_NONE, x is compared with constants
    double constant[MOST_REGIONS];
    uint32_t constants;
    uint32_t region, regions; // the current one
    double least, most;       // of x
    bool whole, nan;          // of x: only whole numbers; NaN as well
} RegionGroup;

// The values of a function that runs in the step.
typedef struct RegionView {
    const IrFn *fn;
    uint32_t *value_of;       // by IrRef
} RegionView;

typedef enum RegionLemmaKind {
    LEMMA_ORDER,              // group a is at most group b, unless one of them is NaN
    LEMMA_TRUE_ABOVE,         // if group a is above `bound`, the condition is true
    LEMMA_FALSE_BELOW,        // if group a is below `bound`, the condition is false
    LEMMA_COUNT               // group a is at most bound + slope * group b
} RegionLemmaKind;

typedef struct RegionLemma {
    RegionLemmaKind kind;
    uint32_t a, b;
    IrRef condition;          // in the function that samples the windows
    double bound, slope;
    double tolerance;         // ORDER: relative; an average is rounded
} RegionLemma;

typedef struct Prover {
    SearchRun *k;
    RunFacts *facts;          // NULL: runs do not begin in the first state
    uint32_t fn;
    VEC(Value) value;
    RegionView own, sample;   // of `fn`, of the function that samples the windows
    RegionGroup group[MOST_GROUPS];
    uint32_t groups;
    RegionLemma lemma[MOST_LEMMAS];
    uint32_t lemmas;
    bool fits;                // everything fits into the tables
    bool counted;             // a lemma of the kind COUNT has excluded a combination
} Prover;

void region_number_values(Prover *p, uint32_t fn);
void region_add_condition(Prover *p, const RegionView *v, IrRef ref);         // adds the groups of a condition
// Returns the group of a value that is compared with constants; NULL: no room.
RegionGroup *region_group_of(Prover *p, uint32_t value);
double region_combinations(Prover *p);        // how many there are; begins with the first one
bool region_next(Prover *p);
bool region_truth(Prover *p, const RegionView *v, IrRef ref);                 // in the current combination
// Sets the bounds of the current region of a group of one value, and whether they belong to it.  Returns false if the region is NaN.
bool region_bounds(const RegionGroup *g, double bound[2], bool inside[2]);

void region_find_lemmas(Prover *p);
bool region_is_consistent(Prover *p);         // whether no lemma excludes the current combination

#endif
