// SPDX-License-Identifier: Apache-2.0
// Units of measurement, the texts after @unit (language.md 2.24 to 2.28): reads, computes with and writes them.  Units never change what a
// program does.  Only reports and the analysis of units read them, so they are computed with the C compiler's own double.
#ifndef SMC_MEASURE_H
#define SMC_MEASURE_H

#include <stdbool.h>
#include <stdint.h>

#include "compiler/base/arena.h"

enum { MEASURE_BASES = 8, MEASURE_NAMES = 6, MEASURE_LENGTH_MAX = 80 };      // base units; names in a Measure; the longest text in characters

typedef struct MeasureName {
    const char *name;             // `len` characters, not terminated
    uint8_t len;
    float power;
} MeasureName;

typedef struct Measure {
    const char *text;             // as written; NULL: computed
    double scale;                 // one of this unit in base units: 6894.757… for psi; finite and above 0
    double zero;                  // a temperature scale that does not begin at 0 K (degC): its zero point in K; other units: 0
    double power[MEASURE_BASES];     // of m, kg, s, A, K, mol, cd, rev
    MeasureName name[MEASURE_NAMES];    // for messages: the units whose product it is
    uint8_t names;                // more than MEASURE_NAMES: too many, so `name` has no meaning
} Measure;

typedef enum MeasureFlaw { MEASURE_GOOD, MEASURE_MALFORMED, MEASURE_UNKNOWN } MeasureFlaw;

// Why a text is no unit.
typedef struct MeasureError {
    uint32_t at, len;             // the wrong part of the text
    const char *expected;         // MALFORMED: what is expected there
    char near[24];                // UNKNOWN: the unit to suggest, because its name is similar; "": none is similar
    bool is_certain;              // UNKNOWN: the text can only mean `near`
} MeasureError;

// Reads a text such as m/s^2.  `text` must outlive *into.
MeasureFlaw measure_parse(const char *text, Measure *into, MeasureError *error);

Measure measure_of_number(void);                                     // the unit of a plain number
Measure measure_named(const char *name);                             // a unit that exists, such as "rad"
Measure measure_product(const Measure *a, const Measure *b, double power); // a times b to the power `power`
Measure measure_power(const Measure *a, double power);

bool measure_is_usable(const Measure *u);                            // false: scale or powers have become too large to compare
bool measure_is_same_kind(const Measure *a, const Measure *b);         // m and ft
bool measure_is_same_scale(const Measure *a, const Measure *b);          // of units that measure the same: equal, so no factor or zero differs
bool measure_is_number(const Measure *u);                            // whether u measures nothing, as rad, percent and m/m do
bool measure_is_temperature(const Measure *u);                       // whether u is a temperature alone, not a product or quotient with one
bool measure_is_g(const Measure *u);                                 // whether u is gn, the acceleration of gravity, alone

// Returns a text for a message: as written, else the product of the units from which it was computed.
const char *measure_text(Arena *arena, const Measure *u);

#endif
