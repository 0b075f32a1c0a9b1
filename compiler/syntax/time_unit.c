// SPDX-License-Identifier: Apache-2.0
#include "compiler/syntax/time_unit.h"

#include <string.h>

#include "compiler/base/buf.h"
#include "compiler/syntax/number.h"

// A unit is factor * 10^exponent microseconds.
static const struct { const char *name; unsigned factor; int exponent; } units[TIME_UNITS] = {
    [TIME_NONE] = {"", 1, 0}, [TIME_US] = {"us", 1, 0}, [TIME_MS] = {"ms", 1, 3}, [TIME_S] = {"s", 1, 6},
    [TIME_MIN] = {"min", 6, 7}, [TIME_H] = {"h", 36, 8}};

TimeUnit time_unit_find(const char *word)
{
    for (TimeUnit u = TIME_US; u < TIME_UNITS; u++)
        if (strcmp(word, units[u].name) == 0)
            return u;
    return TIME_NONE;
}

const char *time_unit_name(TimeUnit unit) { return units[unit].name; }

bool time_unit_counts(TimeUnit unit) { return unit == TIME_US || unit == TIME_MS || unit == TIME_S; }

TimeUnit time_unit_of_period(uint64_t ns)
{
    return ns == 1000 ? TIME_US : ns == 1000000 ? TIME_MS : ns == 1000000000 ? TIME_S : TIME_NONE;
}

bool time_to_f64(const char *text, size_t len, TimeUnit from, TimeUnit to, SmF64 *value)
{
    return number_to_scaled_f64(text, len, units[from].factor, units[from].exponent - units[to].exponent, value);
}

const char *time_unit_format_call(Arena *arena, const char *arguments)
{
    const char *at = *arguments == '(' ? arguments + 1 : arguments;
    const size_t digits = strspn(at, "0123456789.");

    return digits > 0 && at[digits] == ')' ? format_in(arena, "%.*s s", (int)digits, at) : "5 s";
}
