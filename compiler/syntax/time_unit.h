// SPDX-License-Identifier: Apache-2.0
// Units of time in machines and scripts (language.md 1.36 to 1.39): the words that can follow a number, and the conversion of a literal
// such as `1.5 s` to the unit that G counts.
#ifndef SMC_TIME_UNIT_H
#define SMC_TIME_UNIT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "compiler/base/arena.h"
#include "stdlib/f64.h"

// A row of the table in time_unit.c. TIME_NONE: a number without a unit.
typedef enum TimeUnit { TIME_NONE, TIME_US, TIME_MS, TIME_S, TIME_MIN, TIME_H, TIME_UNITS } TimeUnit;

TimeUnit time_unit_find(const char *word);        // returns TIME_NONE if the word is no unit
const char *time_unit_name(TimeUnit unit);        // returns the word, such as "ms"; the unit is not TIME_NONE
bool time_unit_counts(TimeUnit unit);             // whether G can count in this unit: us, ms or s
TimeUnit time_unit_of_period(uint64_t ns);        // returns the unit of so many nanoseconds in which G can count; TIME_NONE: it cannot count in any

// Converts the literal of `len` characters at `text`, which is decimal, from `from` to a unit in which G can count: multiplies exactly, and
// rounds once to the nearest F64. Returns false if the result is too large.
bool time_to_f64(const char *text, size_t len, TimeUnit from, TimeUnit to, SmF64 *value);

// Returns the time of a call that waits for seconds in other languages, as in sleep(2): "2 s". `arguments` begins at its (. Returns "5 s" if they
// are no number.
const char *time_unit_format_call(Arena *arena, const char *arguments);

#endif
