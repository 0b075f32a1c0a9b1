// SPDX-License-Identifier: Apache-2.0
// Writes constants as C literals that preserve every bit.  Floats are decimal, because C++11 has no hexadecimal floats, with the fewest digits
// that convert back to the same number.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compiler/emit/c/unit.h"
#include "stdlib/convert.h"

// Replaces the decimal separator of the host's locale by a point.
static void replace_decimal_separator(char *text)
{
    for (; *text; text++)
        if (!strchr("0123456789+-e.", *text))
            *text = '.';
}

// Writes a number that printf produced, as a C literal without superfluous characters: 1e300 for 1e+300, 42.0 for 42.
static void write_normalized(Buf *out, char *text)
{
    char *e = strchr(text, 'e');

    if (e == NULL) {
        buf_str(out, text);
        buf_str(out, strchr(text, '.') ? "" : ".0");
        return;
    }
    buf_put(out, text, (size_t)(e - text) + 1);
    e += e[1] == '+' ? 2 : 1;
    if (*e == '-')
        buf_char(out, *e++);
    while (*e == '0')
        e++;
    buf_str(out, e);
}

// Writes a finite number with the fewest decimal digits that convert back to it.
void literal_write_finite(Buf *out, double x)
{
    char text[40];

    if (x < 1e15 && x > -1e15 && (double)(long long)x == x) {
        snprintf(text, sizeof text, "%.0f", x);
    } else {
        for (int digits = 1; digits <= 17; digits++) {
            snprintf(text, sizeof text, "%.*g", digits, x);
            if (strtod(text, NULL) == x)
                break;
        }
    }
    replace_decimal_separator(text);
    write_normalized(out, text);
}

// Writes an SmF64 constant: its bits, and the number as a comment.
static void write_soft_f64(CUnit *u, Buf *out, double x)
{
    const unsigned long high = (unsigned long)(sm_bits(x) >> 32), low = (unsigned long)(sm_bits(x) & 0xffffffffu);

    buf_printf(out, "%s(0x%08lX%08lXu /* ", helper_require(u, "sm_from_bits"), x != x ? 0x7FF80000ul : high, x != x ? 0ul : low);
    if (x - x == 0)
        literal_write_finite(out, x);
    else
        buf_str(out, x != x ? "NaN" : x > 0 ? "infinity" : "-infinity");
    buf_str(out, " */)");
}

static void write_f64(CUnit *u, Buf *out, double x)
{
    if (u->soft)
        write_soft_f64(u, out, x);
    else if (x - x == 0)
        literal_write_finite(out, x);
    else
        buf_printf(out, "%s(%s)", helper_require(u, "sm_from_bits"), x != x ? "0x7FF8000000000000u" :
                   x > 0 ? "0x7FF0000000000000u" : "0xFFF0000000000000u");
}

static void write_f32(CUnit *u, Buf *out, float x)
{
    char text[40];

    if (!(x - x == 0)) {
        buf_str(out, u->soft ? "sm_round_f32(" : "(float)");
        write_f64(u, out, (double)x);
        buf_str(out, u->soft ? ")" : "");
        return;
    }
    if (x < 1e6f && x > -1e6f && (float)(int)x == x) {
        snprintf(text, sizeof text, "%.0f", (double)x);
    } else {
        for (int digits = 1; digits <= 9; digits++) {
            snprintf(text, sizeof text, "%.*g", digits, (double)x);
            if (strtof(text, NULL) == x)
                break;
        }
    }
    replace_decimal_separator(text);
    write_normalized(out, text);
    buf_char(out, 'f');
}

static void write_signed(Buf *out, int64_t v)
{
    if (v == INT64_MIN)
        buf_str(out, "INT64_MIN");
    else if (v == INT32_MIN)
        buf_str(out, "INT32_MIN");
    else
        buf_printf(out, v > INT32_MAX || v < INT32_MIN ? "INT64_C(%lld)" : "%lld", (long long)v);
}

static void write_unsigned(Buf *out, uint64_t v)
{
    buf_printf(out, v > UINT32_MAX ? "UINT64_C(%llu)" : v > INT32_MAX ? "%lluu" : "%llu", (unsigned long long)v);
}

// Writes a constant as a C literal of its type.  `bits` is the constant's bit pattern, zero-extended.
void literal_write(CUnit *u, Buf *out, SmType type, uint64_t bits)
{
    switch (type) {
    case SM_I8:
    case SM_I16:
    case SM_I32: write_signed(out, sm_to_i64(sm_cell_to_f64(type, bits))); break;
    case SM_I64: { int64_t v; memcpy(&v, &bits, sizeof v); write_signed(out, v); break; }
    case SM_U8:
    case SM_U16:
    case SM_U32:
    case SM_U64: write_unsigned(out, bits); break;
    case SM_F32: write_f32(u, out, sm_f32_from_bits((uint32_t)bits)); break;
    case SM_F64: write_f64(u, out, sm_from_bits(bits)); break;
    case SM_BOOL: buf_str(out, bits ? "true" : "false"); break;
    case SM_TYPE_COUNT: break;
    }
}
