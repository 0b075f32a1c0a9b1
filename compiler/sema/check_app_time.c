// SPDX-License-Identifier: Apache-2.0
// The times and counts of an application, computed exactly: whole nanoseconds, whole multiples of the tick
// (config.md 10.11, 10.12).
#include "compiler/sema/app_check.h"

// ---- amounts ----

// Multiplies *x; returns false if the product does not fit.
static bool try_multiply(uint64_t *x, uint64_t by)
{
    if (by && *x > UINT64_MAX / by)
        return false;
    *x *= by;
    return true;
}

// Multiplies *x by 10^power; returns false if the product does not fit.
static bool try_multiply_by_ten(uint64_t *x, int power)
{
    for (; power > 0; power--)
        if (*x && !try_multiply(x, 10))
            return false;
        else if (*x == 0)
            return true;
    return true;
}

typedef enum Exactness { EXACT, FRACTION, TOO_LARGE } Exactness;

// If the amount is a whole number that fits in *value, stores it and returns EXACT.  An amount is digits * 10^exponent * factor.
static Exactness amount_value(const AstAmount *a, uint64_t *value)
{
    uint64_t divisor = 1;

    *value = a->digits;
    if (!a->is_exact || a->exponent > 20)
        return a->is_exact && a->digits == 0 ? EXACT : TOO_LARGE;
    if (!try_multiply(value, a->factor) || !try_multiply_by_ten(value, a->exponent))
        return TOO_LARGE;
    if (a->exponent < 0 && (!try_multiply_by_ten(&divisor, -a->exponent) || *value % divisor))
        return *value ? FRACTION : EXACT;
    *value /= divisor;
    return EXACT;
}

// Adds a label with the powers of two below and above `value`, such as "32 KB or 64 KB would be".
static void label_powers(AppCheck *k, Diag *d, const AstAmount *a, uint64_t value)
{
    const char *text[2];
    uint64_t below = 1;

    while (below * 2 <= value)
        below *= 2;
    for (int i = 0; i < 2; i++) {
        unsigned long n = (unsigned long)(below << i);
        bool is_size = a->of == APP_SIZE, is_kb = is_size && n % 1024 == 0;
        text[i] = format_in(k->c->arena, "%lu%s", is_kb ? n / 1024 : n, is_kb ? " KB" : is_size ? " B" : "");
    }
    diag_label(k->c->diags, d, DIAG_label_multiples, text[0], text[1]);
}

const AppRange app_ranges[APP_RANGES] = {
#define APP_RANGE(name, what, least, most, power_of_two, limits) {what, least, most, power_of_two, limits},
#include "compiler/sema/app_ranges.def"
#undef APP_RANGE
};

// Converts the amount to a whole number.  If it is not in the range, reports that, sets *value to the range's least value, and returns
// false.
bool app_check_amount(AppCheck *k, const AstAmount *a, AppRangeId range, uint64_t *value)
{
    const AppRange *r = &app_ranges[range];
    Exactness e = amount_value(a, value);
    bool good = e == EXACT && *value >= r->least && *value <= r->most && (!r->power_of_two || (*value & (*value - 1)) == 0);

    if (!good) {
        Diag *d = diag_report(k->c->diags, DIAG_app_range, a->span, r->what, r->limits);
        if (r->power_of_two && e == EXACT && *value >= r->least && *value <= r->most)
            label_powers(k, d, a, *value);
        *value = r->least;
    }
    return good;
}

const char *app_time_text(Arena *arena, uint64_t ns)
{
    static const struct { const char *unit; uint64_t ns; } units[] = {{"s", 1000000000u}, {"ms", 1000000u}, {"us", 1000u},
                                                                      {"ns", 1u}};
    size_t i = 0;

    while (ns % units[i].ns)
        i++;
    return format_in(arena, "%llu %s", (unsigned long long)(ns / units[i].ns), units[i].unit);
}

// ---- periods ----

enum { SECOND = 1000000000 };

// Stores the period of a frequency in nanoseconds: 10^9 / (digits * 10^exponent * factor).  A FRACTION is rounded down.
static Exactness frequency_period(const AstAmount *a, uint64_t *period)
{
    uint64_t numerator = SECOND, hertz = a->digits;

    if (!a->is_exact || a->digits == 0 || a->exponent > 6)
        return TOO_LARGE;
    if (!try_multiply_by_ten(&numerator, -a->exponent) || !try_multiply_by_ten(&hertz, a->exponent) || !try_multiply(&hertz, a->factor))
        return TOO_LARGE;
    *period = numerator / hertz;
    return numerator % hertz ? FRACTION : EXACT;
}

// Returns the period of a rate in nanoseconds; 0 after a report.
static uint64_t period_of(AppCheck *k, const AstAppRate *r)
{
    const AppRange *range = &app_ranges[APP_RANGE_period];
    uint64_t period = 0;
    Exactness e = r->amount.of == APP_FREQUENCY ? frequency_period(&r->amount, &period) : amount_value(&r->amount, &period);

    if (e == FRACTION && (r->amount.of == APP_TIME || (period >= range->least && period < range->most))) {
        const Span written = r->amount.span;
        Diag *d = diag_report(k->c->diags, DIAG_period_fraction, written,
                              format_in(k->c->arena, "%.*s", (int)written.len, written.src->text + written.at));
        if (r->amount.of == APP_FREQUENCY)
            diag_label(k->c->diags, d, DIAG_label_every_instead, app_time_text(k->c->arena, period));
        return 0;
    }
    if (e == EXACT && period >= range->least && period <= range->most)
        return period;
    diag_report(k->c->diags, DIAG_app_range, r->amount.span, range->what, range->limits);
    return 0;
}

// ---- the rates of an executor ----

// Reports a period that is not a multiple of the executor's shortest period.
static void check_multiple(AppCheck *k, const AppExecutor *e, const AppRate *r)
{
    uint64_t below = r->period / e->period * e->period;
    Diag *d;

    if (r->period % e->period == 0)
        return;
    d = diag_report(k->c->diags, DIAG_period_multiple, r->span, app_time_text(k->c->arena, r->period),
                    app_time_text(k->c->arena, e->period), e->name->text);
    diag_label(k->c->diags, d, DIAG_label_multiples, app_time_text(k->c->arena, below),
               app_time_text(k->c->arena, below + e->period));
}

// Reports two rates of an executor with the same period.
static void check_duplicate_period(AppCheck *k, const AppExecutor *e, const AppRate *r, Map *seen)
{
    Str key = str_c(k->c->strings, app_time_text(k->c->arena, r->period));
    const AppRate *first = map_find(seen, key);

    if (first)
        diag_note(k->c->diags, diag_report(k->c->diags, DIAG_period_twice, r->span, key->text, e->name->text), first->span,
                  DIAG_note_first_here);
    else
        map_put(seen, key, (void *)(size_t)r);
}

// Fills in the rate groups of `out` and its period, which is the shortest period of a group.  Reports periods that occur twice, and periods that are
// no multiple of the shortest.
void check_app_rates(AppCheck *k, const AstAppExecutor *in, AppExecutor *out)
{
    Map seen = {k->c->arena, NULL, NULL, 0, 0};

    for (size_t i = 0; i < in->rates.n; i++) {
        AppRate *r = ARENA_NEW(k->c->arena, AppRate);
        r->span = in->rates.at[i].span;
        r->period = period_of(k, &in->rates.at[i]);
        if (r->period && (out->period == 0 || r->period < out->period))
            out->period = r->period;
        vec_push(k->c->arena, &out->rate, r);
    }
    for (size_t i = 0; i < out->rate.n; i++)
        if (out->rate.at[i]->period) {
            check_multiple(k, out, out->rate.at[i]);
            check_duplicate_period(k, out, out->rate.at[i], &seen);
            out->rate.at[i]->every = (uint32_t)(out->rate.at[i]->period / out->period);
        }
}
