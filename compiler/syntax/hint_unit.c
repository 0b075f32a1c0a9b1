// SPDX-License-Identifier: Apache-2.0
#include "compiler/syntax/hint_unit.h"
#include "compiler/syntax/hints.h"

#include <string.h>

#include "compiler/syntax/time_unit.h"

// Names that users write for units of time.
static const struct { const char *name; TimeUnit unit; } times[] = {
    {"us", TIME_US}, {"usec", TIME_US}, {"micros", TIME_US}, {"microseconds", TIME_US},
    {"ms", TIME_MS}, {"msec", TIME_MS}, {"millis", TIME_MS}, {"milliseconds", TIME_MS},
    {"s", TIME_S}, {"sec", TIME_S}, {"secs", TIME_S}, {"second", TIME_S}, {"seconds", TIME_S}, {"S", TIME_S},
    {"min", TIME_MIN}, {"mins", TIME_MIN}, {"minute", TIME_MIN}, {"minutes", TIME_MIN},
    {"h", TIME_H}, {"hour", TIME_H}, {"hours", TIME_H}};

// Returns the unit of time that the word names, or TIME_NONE.
static TimeUnit find_unit(const char *word)
{
    for (size_t i = 0; i < sizeof times / sizeof *times; i++)
        if (strcmp(word, times[i].name) == 0)
            return times[i].unit;
    return TIME_NONE;
}

bool hint_is_time_unit(const char *word) { return find_unit(word) != TIME_NONE; }

// Labels d with what to write instead of the literal `number` followed by `unit`, which together are at `whole`.
void hint_label_unit(Diags *diags, Diag *d, const char *number, const char *unit, Span whole)
{
    const TimeUnit time = find_unit(unit);
    const bool is_hexadecimal = number[0] == '0' && (number[1] | 0x20) == 'x';

    if (time && !is_hexadecimal) {
        const char *literal = format_in(diags->arena, "%s %s", number, time_unit_name(time));
        diag_label(diags, d, DIAG_label_did_you_mean, literal);
        diag_edit(diags, d, whole, literal);
    } else {
        diag_label(diags, d, DIAG_label_no_unit, number, unit);
    }
}
