// SPDX-License-Identifier: Apache-2.0
// Prints the parts of a line of the disassembler: numbers, names, variables.
#include "bytecode-vm/disasm.h"
#include "stdlib/convert.h"
#include "stdlib/math.h"

enum { NAME_MOST = 250 };     // the most characters of a name that are printed

// ---- text ----

void smvm_print(DisasmOutput *o, const char *s)
{
    size_t n = 0;

    while (s[n])
        n++;
    o->write(o->context, s, n);
    o->column = n > 0 && s[n - 1] == '\n' ? 0 : o->column + (uint32_t)n;
}

// Prints at least one space, and more up to this column.
void smvm_print_padding(DisasmOutput *o, uint32_t column)
{
    do
        smvm_print(o, " ");
    while (o->column < column);
}

void smvm_print_unsigned(DisasmOutput *o, uint64_t v)
{
    char digits[21], *p = digits + 20;

    *p = '\0';
    do
        *--p = (char)('0' + v % 10);
    while ((v /= 10) != 0);
    smvm_print(o, p);
}

void smvm_print_hex(DisasmOutput *o, uint64_t v, uint8_t digits)
{
    char t[2] = "";

    while (digits-- > 0) {
        t[0] = "0123456789abcdef"[v >> 4 * digits & 15];
        smvm_print(o, t);
    }
}

// Truncates very long names.  Several names may share the same bytes of an image, so that otherwise a small image could have a huge
// listing.
void smvm_print_name(DisasmOutput *o, SmvmName n)
{
    char t[2] = "";

    for (uint32_t i = 0; i < n.size && i < NAME_MOST; i++) {
        t[0] = (char)smvm_u8(o->m->image, n.at + i);
        smvm_print(o, t[0] >= ' ' && t[0] <= '~' ? t : "?");
    }
}

// ---- numbers and variables ----

void smvm_print_signed(DisasmOutput *o, int32_t v)
{
    if (v < 0)
        smvm_print(o, "-");
    smvm_print_unsigned(o, v < 0 ? 0u - (uint32_t)v : (uint32_t)v);
}

// Prints m / 10^places with a decimal point and all its places.
static void print_decimal(DisasmOutput *o, uint64_t m, uint8_t places)
{
    uint64_t unit = 1;

    for (uint8_t i = 0; i < places; i++)
        unit *= 10;
    smvm_print_unsigned(o, m / unit);
    if (places == 0)
        return;
    smvm_print(o, ".");
    for (m %= unit; unit > 10 && m < unit / 10; unit /= 10)
        smvm_print(o, "0");
    smvm_print_unsigned(o, m);
}

// Prints x >= 0 as a decimal of at most 15 places whose nearest F64 is x.  Returns false, and prints nothing, if no such decimal exists.  The
// decimal is m / unit, both exact, and their quotient is rounded like a decimal that is read.
static bool print_short_decimal(DisasmOutput *o, SmF64 x)
{
    const SmF64 ten = sm_from_i32(10), limit = sm_from_u64((uint64_t)1 << 53);
    SmF64 unit = sm_from_i32(1);

    for (uint8_t places = 0; places <= 15 && sm_lt(sm_mul(x, unit), limit); places++) {
        SmF64 m = sm_round(sm_mul(x, unit));
        if (sm_eq(sm_div(m, unit), x)) {
            print_decimal(o, sm_to_u64(m), places);
            return true;
        }
        unit = sm_mul(unit, ten);
    }
    return false;
}

// Prints a number as a decimal if a short one is exact, else like %a of C99.
void smvm_print_f64(DisasmOutput *o, SmF64 x)
{
    uint64_t bits = sm_bits(x), fraction = bits & 0xfffffffffffffu;
    int32_t exponent = (int32_t)(bits >> 52 & 0x7ff);
    uint8_t digits = 13;

    if (bits >> 63 && !sm_is_nan(x))
        smvm_print(o, "-");
    if (exponent == 0x7ff) {
        smvm_print(o, fraction != 0 ? "nan" : "inf");
        return;
    }
    if (print_short_decimal(o, sm_abs(x)))
        return;
    for (; digits > 0 && (fraction & 15u) == 0; digits--)
        fraction >>= 4;
    smvm_print(o, exponent == 0 ? "0x0" : "0x1");
    if (digits > 0)
        smvm_print(o, ".");
    smvm_print_hex(o, fraction, digits);
    smvm_print(o, "p");
    if (exponent > 1022)
        smvm_print(o, "+");
    smvm_print_signed(o, exponent == 0 ? -1022 : exponent - 1023);
}

const char *smvm_type_name(uint32_t type) { return type < SM_TYPE_COUNT ? sm_type_info[type].spelling : "RAW"; }

void smvm_print_location(DisasmOutput *o, const char *space, const SmvmLocation *p)
{
    smvm_print(o, space);
    smvm_print(o, smvm_type_name(p->type));
    smvm_print(o, "@");
    smvm_print_unsigned(o, p->offset);
}

void smvm_print_variable(DisasmOutput *o, SmvmVariable is, const SmvmLocation *p)
{
    SmvmName n = smvm_name_of(o->m, is, p);

    if (n.size > 0)
        smvm_print_name(o, n);
    else if (is == SMVM_IS_TIME)
        smvm_print(o, "T");
    else
        smvm_print_location(o, is == SMVM_IS_LOCAL ? "local " : "", p);
}

void smvm_print_state(DisasmOutput *o, uint32_t s)
{
    SmvmName n = smvm_state_name(o->m, s);

    if (n.size > 0) {
        smvm_print_name(o, n);
    } else {
        smvm_print(o, "state ");
        smvm_print_unsigned(o, s);
    }
}
