// SPDX-License-Identifier: Apache-2.0
#include "compiler/syntax/hint_unit.h"

#include <string.h>

#include "compiler/syntax/number.h"

// Units of time. A unit is factor * 10^exponent milliseconds.
static const struct { const char *name; unsigned factor; int exponent; } times[] = {
    {"us", 1, -3}, {"usec", 1, -3}, {"ms", 1, 0}, {"msec", 1, 0}, {"millis", 1, 0}, {"milliseconds", 1, 0},
    {"s", 1, 3}, {"sec", 1, 3}, {"secs", 1, 3}, {"second", 1, 3}, {"seconds", 1, 3}, {"S", 1, 3},
    {"min", 6, 4}, {"mins", 6, 4}, {"minute", 6, 4}, {"minutes", 6, 4}, {"h", 36, 5}, {"hour", 36, 5}, {"hours", 36, 5}};

// Returns digits * 10^exponent as a literal without an exponent; NULL if it would be too long to read.
static const char *format_decimal(Arena *arena, uint64_t digits, int exponent)
{
    enum { LONGEST = 15 };
    const char *text = format_in(arena, "%llu", (unsigned long long)digits);
    const int n = (int)strlen(text);

    if (n + exponent > LONGEST || exponent < -LONGEST)
        return NULL;
    if (exponent >= 0)
        return format_in(arena, "%s%.*s", text, exponent, "000000000000000");
    if (n + exponent > 0)
        return format_in(arena, "%.*s.%s", n + exponent, text, text + n + exponent);
    return format_in(arena, "0.%.*s%s", -exponent - n, "000000000000000", text);
}

// Converts the time `number` `unit` to a literal in milliseconds; returns NULL if `unit` is not a unit of time or the literal is too long.
const char *hint_to_milliseconds(Arena *arena, const char *number, const char *unit)
{
    uint64_t digits;
    int exponent;

    for (size_t i = 0; i < sizeof times / sizeof *times; i++)
        if (strcmp(unit, times[i].name) == 0 && number_to_decimal(number, strlen(number), &digits, &exponent) && digits < UINT64_MAX / 100)
            return format_decimal(arena, digits * times[i].factor, exponent + times[i].exponent);
    return NULL;
}

bool hint_is_time_unit(const char *unit)
{
    for (size_t i = 0; i < sizeof times / sizeof *times; i++)
        if (strcmp(unit, times[i].name) == 0)
            return true;
    return false;
}

// Labels d with what to write instead of the literal `number` followed by `unit`.
void hint_label_unit(Diags *diags, Diag *d, const char *number, const char *unit)
{
    const char *time = hint_to_milliseconds(diags->arena, number, unit);

    if (time)
        diag_label(diags, d, DIAG_label_time_unit, time);
    else
        diag_label(diags, d, DIAG_label_no_unit, number, unit);
}
