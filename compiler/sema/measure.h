// SPDX-License-Identifier: Apache-2.0
// Units of measurement, the texts after @unit (language.md 2.24 to 2.28): reads, computes with and writes them.  Units never change what a
// program does.  Only reports and the analysis of units read them, so they are computed with the C compiler's own double.
#ifndef SMC_MEASURE_H
#define SMC_MEASURE_H

#include <stdbool.h>
#include <stdint.h>

#include "compiler/base/arena.h"

// The number of base units; the most names in a Measure; the length of the longest text of a unit, in characters.
enum { MEASURE_BASES = 8, MEASURE_NAMES = 6, MEASURE_LENGTH_MAX = 80 };

typedef struct MeasureName {
    const char *name;             // `len` characters, not terminated
    uint8_t len;
    float power;
} MeasureName;

typedef struct Measure {
    const char *text;             // the text that the user wrote; NULL: the unit was computed from others
    double scale;                 // how many base units (Pa for psi) one of this unit is: 6894.757… for psi; finite and above 0
    double zero;                  // a temperature scale that does not begin at 0 K (degC): its zero point in K; other units: 0
    double power[MEASURE_BASES];     // the exponents of m, kg, s, A, K, mol, cd and rev in the product of base units
    MeasureName name[MEASURE_NAMES];    // the units of whose powers this unit is the product, for messages
    uint8_t names;                // number of entries in `name`; above MEASURE_NAMES: the product has too many units, and `name` has no meaning
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

Measure measure_of_number(void);                                     // returns the unit of a plain number
Measure measure_named(const char *name);                             // returns the unit with this name, which exists, such as "rad"
Measure measure_product(const Measure *a, const Measure *b, double power); // returns a * b^power
Measure measure_power(const Measure *a, double power);

bool measure_is_usable(const Measure *u);                            // false: scale or powers have become too large to compare
bool measure_is_same_kind(const Measure *a, const Measure *b);         // whether both measure the same quantity, as m and ft do
bool measure_is_same_scale(const Measure *a, const Measure *b);          // for units of the same kind: whether scale and zero are equal
bool measure_is_number(const Measure *u);                            // whether u measures nothing, as rad, percent and m/m do
bool measure_is_temperature(const Measure *u);                       // whether u is a temperature alone, not a product or quotient with one
bool measure_is_g(const Measure *u);                                 // whether u is gn, the acceleration of gravity, alone

// Returns a text for a message: as written, else the product of the units from which it was computed.
const char *measure_text(Arena *arena, const Measure *u);

#endif
