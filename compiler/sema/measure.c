// SPDX-License-Identifier: Apache-2.0
#include "compiler/sema/measure.h"

#include <string.h>

#include "compiler/base/buf.h"
#include "stdlib/elementary.h"
#include "stdlib/math.h"

typedef struct MeasureRow {
    const char *name;
    bool prefixed;                // a prefix such as `k` can precede the unit
    double scale;
    double power[MEASURE_BASES];
} MeasureRow;

static const MeasureRow rows[] = {
#define PREFIXED(name, scale, ...) {#name, true, scale, {__VA_ARGS__}},
#define PLAIN(name, scale, ...) {#name, false, scale, {__VA_ARGS__}},
#include "compiler/sema/measure.def"
#undef PREFIXED
#undef PLAIN
};

enum { ROWS = sizeof rows / sizeof *rows };

static const struct { const char *name; double scale; } prefixes[] = {
    {"da", 1e1}, {"T", 1e12}, {"G", 1e9}, {"M", 1e6}, {"k", 1e3}, {"h", 1e2}, {"d", 1e-1}, {"c", 1e-2}, {"m", 1e-3}, {"u", 1e-6}, {"n", 1e-9},
        {"p", 1e-12}};

enum { PREFIXES = sizeof prefixes / sizeof *prefixes };

// The temperatures in K of the zero points of scales that do not begin at 0 K.
static const struct { const char *name; double zero; } zeros[] = {{"degC", 273.15}, {"degF", 273.15 - 32 * 5 / 9.0}};

// Other names that users write for a unit; is_certain: the name has no other meaning.
static const struct { const char *written, *unit; bool is_certain; } other_names[] = {
    {"sec", "s", true}, {"secs", "s", true}, {"second", "s", true}, {"seconds", "s", true}, {"msec", "ms", true}, {"usec", "us", true},
    {"minute", "min", true}, {"minutes", "min", true}, {"hour", "h", true}, {"hours", "h", true}, {"hr", "h", true},
    {"meter", "m", true}, {"meters", "m", true}, {"metre", "m", true}, {"metres", "m", true}, {"feet", "ft", true}, {"foot", "ft", true},
    {"inch", "in", true}, {"inches", "in", true}, {"mile", "mi", true}, {"miles", "mi", true}, {"knot", "kn", true}, {"knots", "kn", true},
    {"kts", "kn", true}, {"kt", "kn", true}, {"mps", "m/s", true}, {"fps", "ft/s", true}, {"mph", "mi/h", true}, {"kph", "km/h", true},
    {"Nm", "N*m", true}, {"Ns", "N*s", true}, {"Ah", "A*h", true}, {"mAh", "mA*h", true}, {"Wh", "W*h", true}, {"kWh", "kW*h", true},
    {"newton", "N", true}, {"newtons", "N", true}, {"pascal", "Pa", true}, {"pascals", "Pa", true}, {"volt", "V", true}, {"volts", "V", true},
    {"amp", "A", true}, {"amps", "A", true}, {"ampere", "A", true}, {"watt", "W", true}, {"watts", "W", true}, {"joule", "J", true},
    {"joules", "J", true},
    {"ohms", "ohm", true}, {"hertz", "Hz", true}, {"kelvin", "K", true}, {"celsius", "degC", true}, {"fahrenheit", "degF", true}, {"degK", "K", true},
    {"degree", "deg", true}, {"degrees", "deg", true}, {"radian", "rad", true}, {"radians", "rad", true}, {"pct", "percent", true},
    {"kilo", "kg", false}, {"kilogram", "kg", true}, {"kilograms", "kg", true}, {"gram", "g", true}, {"grams", "g", true}, {"lbm", "lb", true},
    {"lbs", "lbf", false}, {"pound", "lbf", false}, {"pounds", "lbf", false}, {"psia", "psi", false}, {"psig", "psi", false}, {"psid", "psi", false},
    {"bara", "bar", false}, {"barg", "bar", false}, {"g0", "gn", true}, {"gee", "gn", true}, {"gees", "gn", true}, {"gs", "gn", false},
    {"RPM", "rpm", true},
    {"%", "percent", true}, {"cc", "cm^3", true}, {"l", "L", true}, {"litre", "L", true}, {"liter", "L", true}, {"litres", "L", true},
    {"liters", "L", true}, {"ml", "mL", true}};

// ---- names ----

static const MeasureRow *find_row(const char *name, size_t n)
{
    for (size_t i = 0; i < ROWS; i++)
        if (strlen(rows[i].name) == n && memcmp(rows[i].name, name, n) == 0)
            return &rows[i];
    return NULL;
}

// Sets *into to the unit with this name, which can have a prefix. Returns false if no unit has this name.
static bool find_unit(const char *name, size_t n, Measure *into)
{
    const MeasureRow *row = find_row(name, n);
    double scale = 1;

    for (size_t i = 0; !row && i < PREFIXES; i++) {
        const size_t len = strlen(prefixes[i].name);
        if (len >= n || memcmp(prefixes[i].name, name, len) != 0)
            continue;
        row = find_row(name + len, n - len);
        if (row && !row->prefixed)
            row = NULL;
        scale = prefixes[i].scale;
    }
    if (!row)
        return false;
    *into = (Measure){.scale = scale * row->scale};
    memcpy(into->power, row->power, sizeof into->power);
    into->name[0] = (MeasureName){name, (uint8_t)n, 1};
    into->names = 1;
    for (size_t i = 0; i < sizeof zeros / sizeof *zeros; i++)
        if (strcmp(row->name, zeros[i].name) == 0)
            into->zero = zeros[i].zero;
    return true;
}

// ---- names that are not units ----

static char to_lower_case(char c) { return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c; }

static bool is_same_but_case(const char *a, size_t n, const char *b)
{
    size_t i = 0;

    while (i < n && b[i] && to_lower_case(a[i]) == to_lower_case(b[i]))
        i++;
    return i == n && !b[i];
}

// Finds the units that differ from the name only in capital letters, as kPa for kpa. Sets *count to their number, and `found`, which has room for 16
// characters, to the first of them.
static void find_other_case(const char *name, size_t n, char *found, unsigned *count)
{
    char tried[16];

    *count = 0;
    for (size_t i = 0; i < ROWS; i++)
        for (size_t p = 0; p <= (rows[i].prefixed ? PREFIXES : 0); p++) {
            strcpy(tried, p > 0 ? prefixes[p - 1].name : "");
            strcat(tried, rows[i].name);
            if (is_same_but_case(name, n, tried) && ++*count == 1)
                strcpy(found, tried);
        }
}

// Returns the length of a name without the digits at its end, if that is a unit: m of m2. Else 0.
static size_t length_without_power(const char *name, size_t n)
{
    size_t len = n;
    Measure u;

    while (len > 0 && name[len - 1] >= '0' && name[len - 1] <= '9')
        len--;
    return len > 0 && len < n && find_unit(name, len, &u) ? len : 0;
}

static void explain_unknown(const char *name, size_t n, MeasureError *error)
{
    const size_t len = n < sizeof error->near - 1 ? length_without_power(name, n) : 0;
    unsigned count = 0;

    for (size_t i = 0; i < sizeof other_names / sizeof *other_names; i++)
        if (strlen(other_names[i].written) == n && memcmp(other_names[i].written, name, n) == 0) {
            strcpy(error->near, other_names[i].unit);
            error->is_certain = other_names[i].is_certain;
            return;
        }
    if (len > 0) {
        memcpy(error->near, name, len);
        error->near[len] = '^';
        memcpy(error->near + len + 1, name + len, n - len);
    } else
        find_other_case(name, n, error->near, &count);
    error->is_certain = (len > 0 && name[n] != '^') || count == 1;
}

// ---- grammar: term { (* | /) term }; term: (1 | name | '(' unit ')') [ ^ [-] number ] ----

enum { DEPTH_MAX = 8 };           // the most nested parentheses
static const double power_max = 99;

typedef struct MeasureReader {
    const char *text;
    uint32_t at;
    unsigned depth;               // number of open parentheses
    MeasureFlaw flaw;                // kind of the first error; GOOD: none so far
    MeasureError *error;
} MeasureReader;

static bool report_flaw(MeasureReader *r, MeasureFlaw flaw, uint32_t at, uint32_t len, const char *expected)
{
    if (r->flaw != MEASURE_GOOD && (r->flaw != MEASURE_UNKNOWN || flaw != MEASURE_MALFORMED))
        return false;
    r->flaw = flaw;
    *r->error = (MeasureError){.at = at, .len = len, .expected = expected};
    if (flaw == MEASURE_UNKNOWN)
        explain_unknown(r->text + at, len, r->error);
    return false;
}

static bool report_expected_text(MeasureReader *r, const char *what) { return report_flaw(r, MEASURE_MALFORMED, r->at, r->text[r->at] != 0, what); }

static bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
static bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Reads the number after ^.
static bool read_power(MeasureReader *r, double *power)
{
    const bool minus = r->text[r->at] == '-';
    double x = 0, digit = 1;

    r->at += minus;
    if (!is_digit(r->text[r->at]))
        return report_expected_text(r, "a number");
    for (; is_digit(r->text[r->at]) && x <= power_max; r->at++)
        x = x * 10 + (r->text[r->at] - '0');
    if (r->text[r->at] == '.' && is_digit(r->text[r->at + 1]))
        for (r->at++; is_digit(r->text[r->at]); r->at++)
            x += (r->text[r->at] - '0') * (digit /= 10);
    if (x > power_max)
        return report_expected_text(r, "a number of at most 99");
    *power = minus ? -x : x;
    return true;
}

static bool read_unit(MeasureReader *r, Measure *into);

static bool read_term(MeasureReader *r, Measure *into)
{
    const uint32_t from = r->at;
    double power = 1;

    if (r->text[r->at] == '(') {
        r->at++;
        if (++r->depth > DEPTH_MAX)
            return report_expected_text(r, "fewer parentheses");
        if (!read_unit(r, into))
            return false;
        if (r->text[r->at] != ')')
            return report_expected_text(r, "')'");
        r->at++;
        r->depth--;
    } else if (r->text[r->at] == '1' && !is_digit(r->text[r->at + 1])) {
        r->at++;
        *into = measure_of_number();
    } else if (is_letter(r->text[r->at]) || r->text[r->at] == '%') {
        r->at += r->text[r->at] == '%';
        while ((is_letter(r->text[r->at]) || is_digit(r->text[r->at])) && r->text[from] != '%')
            r->at++;
        if (!find_unit(r->text + from, r->at - from, into)) {
            report_flaw(r, MEASURE_UNKNOWN, from, r->at - from, NULL);
            *into = measure_of_number();
        }
    } else
        return report_expected_text(r, (unsigned char)r->text[r->at] < 0x80 ? "the name of a unit" : "letters a to z and A to Z, as in degC");
    if (r->text[r->at] != '^')
        return true;
    r->at++;
    if (!read_power(r, &power))
        return false;
    *into = measure_power(into, power);
    return true;
}

static bool read_unit(MeasureReader *r, Measure *into)
{
    Measure next;

    if (!read_term(r, into))
        return false;
    while (r->text[r->at] == '*' || r->text[r->at] == '/') {
        const double power = r->text[r->at++] == '*' ? 1 : -1;
        if (!read_term(r, &next))
            return false;
        *into = measure_product(into, &next, power);
    }
    return true;
}

MeasureFlaw measure_parse(const char *text, Measure *into, MeasureError *error)
{
    MeasureReader r = {text, 0, 0, MEASURE_GOOD, error};

    if (strlen(text) > MEASURE_LENGTH_MAX)
        report_flaw(&r, MEASURE_MALFORMED, 0, (uint32_t)strlen(text), "at most 80 characters");
    else if (read_unit(&r, into) && text[r.at])
        report_expected_text(&r, "'*', '/' or '^'");
    if (r.flaw == MEASURE_GOOD && !measure_is_usable(into))
        report_flaw(&r, MEASURE_MALFORMED, 0, (uint32_t)strlen(text), "a smaller unit");
    into->text = text;
    return r.flaw;
}

// ---- computing ----

Measure measure_of_number(void) { return (Measure){.scale = 1}; }

Measure measure_named(const char *name)
{
    Measure out = measure_of_number();

    find_unit(name, strlen(name), &out);
    out.text = name;
    return out;
}

static double size_of(double x) { return x < 0 ? -x : x; }

static bool is_equal(double a, double b) { return size_of(a - b) <= 1e-9 * (size_of(a) + size_of(b)); }

// Returns x to the power n, exact for small whole n.
static double power_of(double x, double n)
{
    double out = 1;

    if (n != sm_floor(n) || size_of(n) > power_max)
        return sm_pow(x, n);
    for (double i = size_of(n); i > 0; i--)
        out *= x;
    return n < 0 ? 1 / out : out;
}

// Multiplies `out` with a name to a power. A name whose power becomes 0 is removed.
static void multiply_name(Measure *out, const MeasureName *with, double power)
{
    size_t i = 0;

    while (i < out->names && (out->name[i].len != with->len || memcmp(out->name[i].name, with->name, with->len) != 0))
        i++;
    if (i == out->names && out->names < MEASURE_NAMES)
        out->name[out->names++] = (MeasureName){with->name, with->len, (float)power};
    else if (i == out->names)
        out->names = MEASURE_NAMES + 1;
    else if (size_of(out->name[i].power += (float)power) < 1e-5)
        out->name[i] = out->name[--out->names];
}

Measure measure_product(const Measure *a, const Measure *b, double power)
{
    Measure out = {.scale = a->scale * power_of(b->scale, power)};

    for (size_t i = 0; i < MEASURE_BASES; i++)
        out.power[i] = a->power[i] + power * b->power[i];
    memcpy(out.name, a->name, sizeof out.name);
    out.names = a->names;
    if (b->names > MEASURE_NAMES)
        out.names = b->names;
    for (size_t i = 0; i < b->names && out.names <= MEASURE_NAMES; i++)
        multiply_name(&out, &b->name[i], power * (double)b->name[i].power);
    return out;
}

Measure measure_power(const Measure *a, double power)
{
    const Measure one = measure_of_number();

    return power == 1 ? *a : measure_product(&one, a, power);
}

bool measure_is_usable(const Measure *u)
{
    bool usable = u->scale > 1e-200 && u->scale < 1e200;

    for (size_t i = 0; i < MEASURE_BASES; i++)
        usable = usable && size_of(u->power[i]) < 1000;
    return usable;
}

bool measure_is_same_kind(const Measure *a, const Measure *b)
{
    for (size_t i = 0; i < MEASURE_BASES; i++)
        if (size_of(a->power[i] - b->power[i]) > 1e-6)
            return false;
    return true;
}

bool measure_is_same_scale(const Measure *a, const Measure *b) { return is_equal(a->scale, b->scale) && a->zero == b->zero; }

bool measure_is_number(const Measure *u)
{
    const Measure one = measure_of_number();

    return measure_is_same_kind(u, &one);
}

bool measure_is_temperature(const Measure *u)
{
    const Measure kelvin = measure_named("K");

    return measure_is_same_kind(u, &kelvin);
}

bool measure_is_g(const Measure *u)
{
    const Measure gn = measure_named("gn");

    return measure_is_same_kind(u, &gn) && is_equal(u->scale, gn.scale);
}

// ---- writing ----

static void write_power(const char *name, size_t len, double power, bool first, Buf *out)
{
    const double size = size_of(power);

    if (first && power < 0)
        buf_char(out, '1');
    buf_str(out, power < 0 ? "/" : first ? "" : "*");
    buf_printf(out, "%.*s", (int)len, name);
    if (size != 1)
        buf_printf(out, "^%g", size);
}

const char *measure_text(Arena *arena, const Measure *u)
{
    static const char *const base[MEASURE_BASES] = {"m", "kg", "s", "A", "K", "mol", "cd", "rev"};
    const bool named = u->names <= MEASURE_NAMES;
    const size_t n = named ? u->names : MEASURE_BASES;
    bool first = true;
    Buf b;

    if (u->text)
        return u->text;
    buf_init(&b, arena);
    if (!named && !is_equal(u->scale, 1))
        buf_printf(&b, "%g ", u->scale);
    for (int sign = 1; sign >= -1; sign -= 2)                       // first the factors (positive exponents), then the divisors
        for (size_t i = 0; i < n; i++) {
            const double power = named ? (double)u->name[i].power : u->power[i];
            if (power * sign <= 1e-6)
                continue;
            write_power(named ? u->name[i].name : base[i], named ? u->name[i].len : strlen(base[i]), power, first, &b);
            first = false;
        }
    if (first)
        buf_str(&b, "1");
    return buf_text(&b);
}
