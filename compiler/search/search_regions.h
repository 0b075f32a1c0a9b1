// SPDX-License-Identifier: Apache-2.0
// What can be true at once in one step of a state: the values that the conditions on a path compare, split into regions, in all combinations.
//
//     search_regions.c   gives equal values one number, groups them by what they are compared with, judges conditions in a combination
//     search_lemmas.c    relations between groups that exclude combinations
//     search_prove.c     which goals no combination reaches
#ifndef SMC_SEARCH_REGIONS_H
#define SMC_SEARCH_REGIONS_H

#include "compiler/cover/run_facts.h"
#include "compiler/search/search_run.h"

enum { MOST_REGIONS = 40, MOST_GROUPS = 14, MOST_LEMMAS = 32 };
#define MOST_COMBINATIONS UINT32_C(400000)

// An expression over the values that variables have at the start of a step.  The number of a value is its index in Prover.value: two expressions with
// the same number have equal values.
typedef struct Value {
    IrOp op;
    SmType type;
    SmStat stat;
    uint32_t a, b, var;       // a, b: numbers of the operands; var: variable of a load, window of a statistic.  Of a load, a is 0 if an
                              // earlier function of the step can have stored the variable, else SEARCH_NONE
    uint64_t bits;            // the value of a constant
} Value;

// One value that is compared with constants, or two that are compared with each other.  Its regions are enumerated.
typedef struct RegionGroup {
    uint32_t x, y;            // numbers of the values; y SEARCH_NONE: x is compared with constants
    double constant[MOST_REGIONS];    // ascending
    uint32_t constants;
    uint32_t region, regions; // `region`: index of the region in the current combination; `regions`: how many there are
    double least, most;       // the smallest and the largest number that x can be
    bool whole, nan;          // whole: x can only be a whole number; nan: x can also be NaN
} RegionGroup;

// The values of a function that runs in the step.
typedef struct RegionView {
    const IrFn *fn;
    uint32_t *value_of;       // by IrRef: number of the temporary's value
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
    IrRef condition;          // a temporary of the function that samples the windows
    double bound, slope;      // TRUE_ABOVE, FALSE_BELOW, COUNT
    double tolerance;         // LEMMA_ORDER: a can be above b by this part of |a|, because an average is rounded
} RegionLemma;

typedef struct Prover {
    SearchRun *k;
    RunFacts *facts;          // NULL: runs do not begin in the first state
    uint32_t fn;              // index into SearchRun.fn: the function whose paths are judged
    VEC(Value) value;         // by number
    RegionView own, sample;   // `own`: of `fn`; `sample`: of the function that samples the windows
    RegionGroup group[MOST_GROUPS];
    uint32_t groups;
    RegionLemma lemma[MOST_LEMMAS];
    uint32_t lemmas;
    bool fits;                // `group` and `lemma` had room for everything; false: the combinations prove nothing
    bool counted;             // a lemma of the kind COUNT has excluded a combination
} Prover;

void region_number_values(Prover *p, uint32_t fn);
void region_add_condition(Prover *p, const RegionView *v, IrRef ref);         // adds the groups of a condition
// Returns the group of a value that is compared with constants; NULL: no room.
RegionGroup *region_group_of(Prover *p, uint32_t value);
double region_combinations(Prover *p);        // selects the first combination; returns an upper bound of how many there are
bool region_next(Prover *p);                  // selects the next combination; false: there was none
bool region_truth(Prover *p, const RegionView *v, IrRef ref);                 // the truth of condition `ref` in the current combination
// Sets the bounds of the current region of a group of one value, and whether they belong to it.  Returns false if the region is NaN.
bool region_bounds(const RegionGroup *g, double bound[2], bool inside[2]);

void region_find_lemmas(Prover *p);
bool region_is_consistent(Prover *p);         // whether no lemma excludes the current combination

#endif
