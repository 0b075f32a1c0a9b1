// SPDX-License-Identifier: Apache-2.0
// Writes the report of a script (its steps, passed asserts and final values), and values as text.  The C library prints the digits.  Its
// locale has no effect, because its decimal separator is replaced by a point.
#include "compiler/script/script.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// ---- values ----

// Returns the number in the cell of a signed integer.
static int64_t cell_to_signed(SmType type, uint64_t cell)
{
    uint64_t half = (uint64_t)1 << (sm_type_info[type].bytes * 8 - 1);

    return cell < half ? (int64_t)cell : (int64_t)(cell - half) - (int64_t)(half - 1) - 1;
}

// Returns the number in the cell of a float, which may be NaN.
static double cell_to_float(SmType type, uint64_t cell)
{
    uint32_t low = (uint32_t)cell;
    float f;
    double d;

    memcpy(&f, &low, sizeof f);
    memcpy(&d, &cell, sizeof d);
    return type == SM_F32 ? f : d;
}

// If x is NaN or infinite, appends that and returns true.
static bool append_nonfinite(Buf *out, double x)
{
    if (x != x)
        buf_str(out, "nan");                          // its sign is not observable
    else if (x - x != 0)
        buf_str(out, x < 0 ? "-inf" : "inf");
    else
        return false;
    return true;
}

static bool is_number_char(char c) { return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == 'e'; }

// Appends a number that printf printed.  Replaces the decimal separator of the locale, which has one or more bytes, by a point.
static void append_decimal(Buf *out, const char *digits)
{
    for (const char *c = digits; *c; c++) {
        if (is_number_char(*c))
            buf_char(out, *c);
        else if (c == digits || is_number_char(c[-1]))
            buf_char(out, '.');
    }
}

static void append_fixed(Buf *out, double x)          // appends x with 6 digits after the point, like printf's %f
{
    char digits[400];                                 // at most 309 digits before the point, 6 after it

    if (append_nonfinite(out, x))
        return;
    snprintf(digits, sizeof digits, "%f", x);
    append_decimal(out, digits);
}

// Whether x can be printed as an integer: it is whole, less than 2^53 in magnitude, and not -0.
static bool is_whole(double x)
{
    return x > -9007199254740992.0 && x < 9007199254740992.0 && x == (double)(int64_t)x && !(x == 0 && 1 / x < 0);
}

// Tries increasing numbers of digits until the text reads back as x.  For a normal number it starts at 15 digits, because %.15g prints no
// superfluous zeros; fewer digits may identify a subnormal number, so for that it starts at 1.
void format_number_shortest(Buf *out, double x)
{
    const bool is_normal = x >= 2.2250738585072014e-308 || x <= -2.2250738585072014e-308;
    char digits[40];

    if (append_nonfinite(out, x))
        return;
    if (is_whole(x)) {
        buf_printf(out, "%" PRId64, (int64_t)x);
        return;
    }
    for (int precision = is_normal ? 15 : 1; precision <= 17; precision++) {
        snprintf(digits, sizeof digits, "%.*g", precision, x);
        if (strtod(digits, NULL) == x)
            break;
    }
    append_decimal(out, digits);
}

// Appends x as glibc's %a prints it: the shortest fraction, with 1 before the point for a normal number and 0 for a subnormal one.
static void append_hex(Buf *out, double x)
{
    static const char hex[] = "0123456789abcdef";
    uint64_t bits, fraction;
    int exponent;

    if (append_nonfinite(out, x))
        return;
    memcpy(&bits, &x, sizeof bits);
    fraction = bits << 12;                            // moves the first hexadecimal digit of the fraction to the highest four bits
    exponent = (int)(bits >> 52 & 0x7ff);
    buf_str(out, bits >> 63 ? "-0x" : "0x");
    buf_char(out, exponent ? '1' : '0');
    if (fraction)
        buf_char(out, '.');
    for (; fraction; fraction <<= 4)
        buf_char(out, hex[fraction >> 60]);
    if (exponent == 0)
        exponent = bits << 1 ? 1 : 1023;              // subnormals share the smallest normal exponent; zero is p+0
    buf_printf(out, "p%+d", exponent - 1023);
}

static void append_cell(Buf *out, SmType type, uint64_t cell, void (*append_float)(Buf *out, double x))
{
    switch (sm_type_info[type].kind) {
    case SM_KIND_SIGNED: buf_printf(out, "%" PRId64, cell_to_signed(type, cell)); break;
    case SM_KIND_UNSIGNED: buf_printf(out, "%" PRIu64, cell); break;
    case SM_KIND_FLOAT: append_float(out, cell_to_float(type, cell)); break;
    case SM_KIND_BOOL: buf_str(out, cell ? "true" : "false"); break;
    }
}

void format_cell_rounded(Buf *out, SmType type, uint64_t cell) { append_cell(out, type, cell, append_fixed); }

// Appends the value of a cell with the fewest digits that read back as the same double.
void format_cell_shortest(Buf *out, SmType type, uint64_t cell) { append_cell(out, type, cell, format_number_shortest); }

// Appends x, which is an F32, with the fewest digits that round to it.
static void append_f32(Buf *out, double x)
{
    char digits[40];

    if (append_nonfinite(out, x))
        return;
    for (int precision = 1; precision <= 9; precision++) {
        snprintf(digits, sizeof digits, "%.*g", precision, x);
        if ((float)strtod(digits, NULL) == (float)x)
            break;
    }
    format_number_shortest(out, strtod(digits, NULL));
}

void format_cell_stored(Buf *out, SmType type, uint64_t cell) { append_cell(out, type, cell, type == SM_F32 ? append_f32 : format_number_shortest); }

// Floats in hexadecimal, as C99 %a; all other values in decimal.
void format_cell_exact(Buf *out, SmType type, uint64_t cell) { append_cell(out, type, cell, append_hex); }

// ---- the report ----

static void sort_by_name(const Var **v, size_t n)             // shellsort: the C library's qsort may allocate heap memory
{
    size_t gap = 1;

    while (gap < n / 3)
        gap = gap * 3 + 1;
    for (; gap > 0; gap /= 3)
        for (size_t i = gap; i < n; i++) {
            const Var *moved = v[i];
            size_t j = i;
            for (; j >= gap && strcmp(moved->report_name->text, v[j - gap]->report_name->text) < 0; j -= gap)
                v[j] = v[j - gap];
            v[j] = moved;
        }
}

// Returns the variables in the order of reports and traces; allocated in `arena`.
const Var **report_order(Arena *arena, const Program *p)
{
    const Var **order = ARENA_ARRAY(arena, const Var *, p->var.n);

    for (size_t i = 0; i < p->var.n; i++)
        order[i] = p->var.at[i];
    sort_by_name(order, p->var.n);
    return order;
}

static void append_count(Buf *out, const char *before, uint64_t n, const char *what, const char *after)
{
    buf_printf(out, "%s%" PRIu64 " %s%s%s\n", before, n, what, n == 1 ? "" : "s", after);
}

// Appends a sentence about the rows of the recorded data, without a full stop.
void script_write_rows(const ScriptResult *r, Buf *out)
{
    buf_printf(out, "%s: %" PRIu64 " rows read, %" PRIu64 " of them skipped", r->data_file, r->data_rows, r->data_bad_rows);
    if (r->data_bad_rows)
        buf_printf(out, " (the first is line %" PRIu64 ")", r->data_first_bad_line);
    buf_printf(out, ", %" PRIu64 " between two steps", r->data_between);
}

// Appends the report of a run: the number of steps and of passed asserts, then the final value of each variable.
void script_report(const ScriptResult *r, const Program *p, Buf *out)
{
    const Var **order = report_order(out->arena, p);

    append_count(out, "state script ran for ", r->steps, "step", "");
    append_count(out, "", r->asserts_passed, "assert", " passed");
    if (r->is_random)
        buf_printf(out, "seed %" PRIu64 "\n", r->seed);
    if (r->data_file) {
        script_write_rows(r, out);
        buf_char(out, '\n');
    }
    buf_str(out, "final state vector:\n");
    for (size_t i = 0; i < p->var.n; i++) {
        buf_printf(out, "  %s = ", order[i]->report_name->text);
        format_cell_rounded(out, order[i]->type, r->cell[order[i]->index]);
        buf_char(out, '\n');
    }
}
