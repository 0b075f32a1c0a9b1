// SPDX-License-Identifier: Apache-2.0
// stdlib computes with F64 through functions, so that it can be built where double is too short.  Emitted C has a full double, and C
// operators are easier to read: sm_lt(sm_from_i32(0), x) becomes 0.0 < x.
#include <stdlib.h>
#include <string.h>

#include "compiler/emit/c/unit.h"
#include "stdlib/f64.h"

typedef enum Form {
    FORM_BINARY,              // a op b
    FORM_CAST,                // (type)a
    FORM_NUMBER,              // a as a double
    FORM_WIDE,                // a, a 64-bit integer, as a double: a call (f64.h explains why), except for a constant
    FORM_BITS,                // the double with these bits, if they are a finite constant
    FORM_SELF                 // a != a
} Form;

typedef struct Primitive {
    const char *name, *text;
    Form form;
    int prec;                 // as in fn.h
} Primitive;

enum { EQUALITY = 9, RELATION = 10, SUM = 12, PRODUCT = 13, UNARY = 14, PRIMARY = 15 };

static const Primitive primitive[] = {
    { "sm_add", " + ", FORM_BINARY, SUM },
    { "sm_sub", " - ", FORM_BINARY, SUM },
    { "sm_mul", " * ", FORM_BINARY, PRODUCT },
    { "sm_div", " / ", FORM_BINARY, PRODUCT },
    { "sm_lt", " < ", FORM_BINARY, RELATION },
    { "sm_le", " <= ", FORM_BINARY, RELATION },
    { "sm_eq", " == ", FORM_BINARY, EQUALITY },
    { "sm_is_nan", " != ", FORM_SELF, EQUALITY },
    { "sm_from_i32", "(double)", FORM_NUMBER, UNARY },
    { "sm_from_u32", "(double)", FORM_NUMBER, UNARY },
    { "sm_from_i64", "", FORM_WIDE, PRIMARY },
    { "sm_from_u64", "", FORM_WIDE, PRIMARY },
    { "sm_from_f32", "(double)", FORM_CAST, UNARY },
    { "sm_truncate_i32", "(int32_t)", FORM_CAST, UNARY },
    { "sm_truncate_u32", "(uint32_t)", FORM_CAST, UNARY },
    { "sm_truncate_i64", "(int64_t)", FORM_CAST, UNARY },
    { "sm_truncate_u64", "(uint64_t)", FORM_CAST, UNARY },
    { "sm_round_f32", "(float)", FORM_CAST, UNARY },
    { "sm_from_bits", "", FORM_BITS, PRIMARY },
};

static bool is_word(char c)
{
    return c == '_' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

static size_t word_length(const char *p)
{
    size_t n = 0;

    while (is_word(p[n]))
        n++;
    return n;
}

static const Primitive *find_primitive(const char *name, size_t n)
{
    for (size_t i = 0; i < sizeof primitive / sizeof *primitive; i++)
        if (strlen(primitive[i].name) == n && memcmp(primitive[i].name, name, n) == 0)
            return &primitive[i];
    return NULL;
}

// ---- arguments ----

typedef struct Text {
    const char *at;
    size_t n;
} Text;

// The argument at p, up to a comma or the closing parenthesis of the call.
static Text argument(const char *p)
{
    Text t = { p, 0 };
    int depth = 0;

    while (*t.at == ' ')
        t.at++;
    for (; t.at[t.n] && (depth > 0 || (t.at[t.n] != ',' && t.at[t.n] != ')')); t.n++)
        depth += (t.at[t.n] == '(') - (t.at[t.n] == ')');
    return t;
}

static bool is_number(Text t)
{
    for (size_t i = t.at[0] == '-'; i < t.n; i++)
        if (t.at[i] < '0' || t.at[i] > '9')
            return false;
    return t.n > 0;
}

// The precedence of an expression that is not a primitive's call: PRIMARY for names, members, calls and subscripts.
static int prec_of_text(Text t)
{
    int depth = 0;

    for (size_t i = 0; i < t.n; i++) {
        depth += (t.at[i] == '(' || t.at[i] == '[') - (t.at[i] == ')' || t.at[i] == ']');
        if (depth == 0 && t.at[i] == ' ')
            return 0;
    }
    return t.at[0] == '-' ? UNARY : PRIMARY;
}

// ---- writing ----

static void write_range(CUnit *u, const char *from, const char *to, Buf *out);

// Writes the finite number with these constant bits; returns false if t is something else.
static bool write_bits(CUnit *u, Text t, Buf *out)
{
    uint64_t bits;

    if (t.n < 3 || t.at[0] != '0' || t.at[1] != 'x')
        return false;
    bits = strtoull(t.at, NULL, 16);
    if (!sm_lt(sm_from_bits(bits & 0x7FFFFFFFFFFFFFFFu), sm_from_bits(0x7FF0000000000000u)))
        return false;
    literal_write(u, out, SM_F64, bits);
    return true;
}

static const Primitive *call_at(const char *p)
{
    const size_t n = word_length(p);

    return n > 0 && p[n] == '(' ? find_primitive(p, n) : NULL;
}

static void write_operand(CUnit *u, Text t, int prec, Buf *out)
{
    const Primitive *call = call_at(t.at);
    const bool parens = (call && prec_of_text(t) == PRIMARY ? call->prec : prec_of_text(t)) < prec;

    buf_str(out, parens ? "(" : "");
    write_range(u, t.at, t.at + t.n, out);
    buf_str(out, parens ? ")" : "");
}

static void write_plain_call(CUnit *u, const Primitive *p, Text t, Buf *out)
{
    buf_printf(out, "%s(", p->name);
    write_range(u, t.at, t.at + t.n, out);
    buf_char(out, ')');
}

static void write_number(CUnit *u, const Primitive *p, Text t, Buf *out)
{
    if (is_number(t)) {
        buf_put(out, t.at, t.n);
        buf_str(out, ".0");
    } else if (p->form == FORM_WIDE) {
        write_plain_call(u, p, t, out);
    } else {
        buf_str(out, p->text);
        write_operand(u, t, UNARY, out);
    }
}

static void write_primitive(CUnit *u, const Primitive *p, Text a, Text b, Buf *out)
{
    switch (p->form) {
    case FORM_BINARY:
        write_operand(u, a, p->prec == RELATION || p->prec == EQUALITY ? SUM : p->prec + (p->prec == SUM), out);
        buf_str(out, p->text);
        write_operand(u, b, p->prec + 1, out);
        break;
    case FORM_SELF:
        write_operand(u, a, PRIMARY, out);
        buf_str(out, p->text);
        write_operand(u, a, PRIMARY, out);
        break;
    case FORM_CAST:
        buf_str(out, p->text);
        write_operand(u, a, PRIMARY, out);
        break;
    case FORM_NUMBER: case FORM_WIDE: write_number(u, p, a, out); break;
    case FORM_BITS:
        if (!write_bits(u, a, out))
            write_plain_call(u, p, a, out);
        break;
    }
}

// Writes the primitive's call at `at`; returns its end.  `tight`: a unary operator precedes it.
static const char *write_call(CUnit *u, const Primitive *p, const char *at, bool tight, Buf *out)
{
    const Text a = argument(at + word_length(at) + 1);
    const bool two = p->form == FORM_BINARY;
    const Text b = two ? argument(a.at + a.n + 1) : a;

    buf_str(out, tight && p->prec < UNARY ? "(" : "");
    write_primitive(u, p, a, b, out);
    buf_str(out, tight && p->prec < UNARY ? ")" : "");
    return b.at + b.n + 1;
}

static const char *write_word(CUnit *u, const char *p, char before, Buf *out)
{
    const size_t n = word_length(p);
    const Primitive *call = call_at(p);

    if (call)
        return write_call(u, call, p, before == '!' || before == '-', out);
    if (n == 5 && memcmp(p, "SmF64", 5) == 0)
        buf_str(out, "double");
    else
        buf_put(out, p, n);
    return p + n;
}

static const char *write_comment(const char *p, Buf *out)
{
    const size_t n = strcspn(p, "\n");

    buf_put(out, p, n);
    return p + n;
}

static void write_range(CUnit *u, const char *from, const char *to, Buf *out)
{
    for (const char *p = from; p < to;) {
        if (p[0] == '/' && p[1] == '/')
            p = write_comment(p, out);
        else if (is_word(*p))
            p = write_word(u, p, p > from ? p[-1] : ' ', out);
        else
            buf_char(out, *p++);
    }
}

void native_write(CUnit *u, const char *text, Buf *out)
{
    if (u->soft)
        buf_str(out, text);
    else
        write_range(u, text, text + strlen(text), out);
}
