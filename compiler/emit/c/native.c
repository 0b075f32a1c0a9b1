// SPDX-License-Identifier: Apache-2.0
// Replaces calls in the source of stdlib snippets by C operators.  stdlib computes on F64 with functions, so that it also compiles where double
// is not a binary64.  Emitted C without soft numbers requires a binary64, and operators are easier to read:
// sm_lt(sm_from_i32(0), x) becomes 0.0 < x.
#include <stdlib.h>
#include <string.h>

#include "compiler/emit/c/unit.h"
#include "stdlib/f64.h"

// The C syntax that replaces a call of an F64 function with arguments a and b.
typedef enum CSyntax {
    SYNTAX_BINARY,            // a op b
    SYNTAX_CAST,              // (type)a
    SYNTAX_TO_DOUBLE,         // a, an integer of at most 32 bits, as a double
    SYNTAX_WIDE_TO_DOUBLE,    // a, a 64-bit integer, as a double: only a constant is replaced (f64.h explains why)
    SYNTAX_FROM_BITS,         // a literal, if a is the constant bits of a finite double
    SYNTAX_COMPARE_SELF       // a != a
} CSyntax;

// A function of stdlib/f64.h that C syntax can replace.
typedef struct F64Primitive {
    const char *name, *text;  // the function's name; the operator or cast that replaces a call
    CSyntax syntax;
    int prec;                 // precedence of the replacement, numbered as PREC_ in fn.h
} F64Primitive;

// Precedences of C operators, equal to PREC_EQ to PREC_PRIMARY in fn.h.
enum { EQUALITY = 9, RELATION = 10, SUM = 12, PRODUCT = 13, UNARY = 14, PRIMARY = 15 };

static const F64Primitive primitive[] = {
    { "sm_add", " + ", SYNTAX_BINARY, SUM },
    { "sm_sub", " - ", SYNTAX_BINARY, SUM },
    { "sm_mul", " * ", SYNTAX_BINARY, PRODUCT },
    { "sm_div", " / ", SYNTAX_BINARY, PRODUCT },
    { "sm_lt", " < ", SYNTAX_BINARY, RELATION },
    { "sm_le", " <= ", SYNTAX_BINARY, RELATION },
    { "sm_eq", " == ", SYNTAX_BINARY, EQUALITY },
    { "sm_is_nan", " != ", SYNTAX_COMPARE_SELF, EQUALITY },
    { "sm_from_i32", "(double)", SYNTAX_TO_DOUBLE, UNARY },
    { "sm_from_u32", "(double)", SYNTAX_TO_DOUBLE, UNARY },
    { "sm_from_i64", "", SYNTAX_WIDE_TO_DOUBLE, PRIMARY },
    { "sm_from_u64", "", SYNTAX_WIDE_TO_DOUBLE, PRIMARY },
    { "sm_from_f32", "(double)", SYNTAX_CAST, UNARY },
    { "sm_truncate_i32", "(int32_t)", SYNTAX_CAST, UNARY },
    { "sm_truncate_u32", "(uint32_t)", SYNTAX_CAST, UNARY },
    { "sm_truncate_i64", "(int64_t)", SYNTAX_CAST, UNARY },
    { "sm_truncate_u64", "(uint64_t)", SYNTAX_CAST, UNARY },
    { "sm_round_f32", "(float)", SYNTAX_CAST, UNARY },
    { "sm_from_bits", "", SYNTAX_FROM_BITS, PRIMARY },
};

static bool is_word(char c)
{
    return c == '_' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

// Returns the length of the identifier or number at p.
static size_t word_length(const char *p)
{
    size_t n = 0;

    while (is_word(p[n]))
        n++;
    return n;
}

static const F64Primitive *find_primitive(const char *name, size_t n)
{
    for (size_t i = 0; i < sizeof primitive / sizeof *primitive; i++)
        if (strlen(primitive[i].name) == n && memcmp(primitive[i].name, name, n) == 0)
            return &primitive[i];
    return NULL;
}

// ---- arguments ----

// A part of the source of a snippet.
typedef struct SourceSlice {
    const char *at;
    size_t n;
} SourceSlice;

// Returns the argument of a call that starts at p and ends before the next comma or the closing parenthesis of the call.
static SourceSlice parse_argument(const char *p)
{
    SourceSlice t = { p, 0 };
    int depth = 0;

    while (*t.at == ' ')
        t.at++;
    for (; t.at[t.n] && (depth > 0 || (t.at[t.n] != ',' && t.at[t.n] != ')')); t.n++)
        depth += (t.at[t.n] == '(') - (t.at[t.n] == ')');
    return t;
}

static bool is_integer_literal(SourceSlice t)
{
    for (size_t i = t.at[0] == '-'; i < t.n; i++)
        if (t.at[i] < '0' || t.at[i] > '9')
            return false;
    return t.n > 0;
}

// Returns the precedence of expression t as it is written, before calls in it are replaced by native syntax: 0 if it has an operator with
// spaces around it outside brackets, UNARY if it starts with a minus, otherwise PRIMARY.
static int text_precedence(SourceSlice t)
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

static void write_with_native_syntax(CUnit *u, const char *from, const char *to, Buf *out);

// If t is a hexadecimal constant, the bits of a finite double, writes that number as a literal and returns true.
static bool try_write_from_bits(CUnit *u, SourceSlice t, Buf *out)
{
    uint64_t bits;
    char *end;

    if (t.n < 3 || t.at[0] != '0' || t.at[1] != 'x')
        return false;
    bits = strtoull(t.at, &end, 16);
    if (*end == 'u')
        end++;
    if (end != t.at + t.n)                            // only a part of the argument is a constant
        return false;
    if (!sm_lt(sm_from_bits(bits & 0x7FFFFFFFFFFFFFFFu), sm_from_bits(0x7FF0000000000000u)))
        return false;
    literal_write(u, out, SM_F64, bits);
    return true;
}

// Returns the function that is called at p, if it can be replaced, otherwise NULL.
static const F64Primitive *find_primitive_call(const char *p)
{
    const size_t n = word_length(p);

    return n > 0 && p[n] == '(' ? find_primitive(p, n) : NULL;
}

// Writes operand t, in parentheses if its precedence is below `prec`.
static void write_operand(CUnit *u, SourceSlice t, int prec, Buf *out)
{
    const F64Primitive *call = find_primitive_call(t.at);
    const bool parens = (call && text_precedence(t) == PRIMARY ? call->prec : text_precedence(t)) < prec;

    buf_str(out, parens ? "(" : "");
    write_with_native_syntax(u, t.at, t.at + t.n, out);
    buf_str(out, parens ? ")" : "");
}

// Writes the call of an f64 function as a call, with native syntax in its arguments only.
static void write_unchanged_call(CUnit *u, const F64Primitive *p, SourceSlice t, Buf *out)
{
    buf_printf(out, "%s(", p->name);
    write_with_native_syntax(u, t.at, t.at + t.n, out);
    buf_char(out, ')');
}

static void write_as_double(CUnit *u, const F64Primitive *p, SourceSlice t, Buf *out)
{
    if (is_integer_literal(t)) {
        buf_put(out, t.at, t.n);
        buf_str(out, ".0");
    } else if (p->syntax == SYNTAX_WIDE_TO_DOUBLE) {
        write_unchanged_call(u, p, t, out);
    } else {
        buf_str(out, p->text);
        write_operand(u, t, UNARY, out);
    }
}

// Writes the syntax that replaces a call of p with arguments a and b.
static void write_native_syntax(CUnit *u, const F64Primitive *p, SourceSlice a, SourceSlice b, Buf *out)
{
    switch (p->syntax) {
    case SYNTAX_BINARY:
        write_operand(u, a, p->prec == RELATION || p->prec == EQUALITY ? SUM : p->prec + (p->prec == SUM), out);
        buf_str(out, p->text);
        write_operand(u, b, p->prec + 1, out);
        break;
    case SYNTAX_COMPARE_SELF:
        write_operand(u, a, PRIMARY, out);
        buf_str(out, p->text);
        write_operand(u, a, PRIMARY, out);
        break;
    case SYNTAX_CAST:
        buf_str(out, p->text);
        write_operand(u, a, PRIMARY, out);
        break;
    case SYNTAX_TO_DOUBLE: case SYNTAX_WIDE_TO_DOUBLE: write_as_double(u, p, a, out); break;
    case SYNTAX_FROM_BITS:
        if (!try_write_from_bits(u, a, out))
            write_unchanged_call(u, p, a, out);
        break;
    }
}

// Writes the C syntax that replaces the call of p at `at`; returns the end of the call.  `tight`: a unary operator precedes it.
static const char *write_native_call(CUnit *u, const F64Primitive *p, const char *at, bool tight, Buf *out)
{
    const SourceSlice a = parse_argument(at + word_length(at) + 1);
    const bool two = p->syntax == SYNTAX_BINARY;
    const SourceSlice b = two ? parse_argument(a.at + a.n + 1) : a;

    buf_str(out, tight && p->prec < UNARY ? "(" : "");
    write_native_syntax(u, p, a, b, out);
    buf_str(out, tight && p->prec < UNARY ? ")" : "");
    return b.at + b.n + 1;
}

// Copies the word at p, or writes the replacement of the call at p.  `before` is the preceding character.  Returns the end of the word or call.
static const char *write_word_or_call(CUnit *u, const char *p, char before, Buf *out)
{
    const size_t n = word_length(p);
    const F64Primitive *call = find_primitive_call(p);

    if (call)
        return write_native_call(u, call, p, before == '!' || before == '-', out);
    if (n == 5 && memcmp(p, "SmF64", 5) == 0)
        buf_str(out, "double");
    else
        buf_put(out, p, n);
    return p + n;
}

// Copies the comment at p, and returns where it ends.
static const char *write_comment(const char *p, Buf *out)
{
    const size_t n = strcspn(p, "\n");

    buf_put(out, p, n);
    return p + n;
}

// Copies C code, and replaces calls of f64 functions by C's operators on double.
static void write_with_native_syntax(CUnit *u, const char *from, const char *to, Buf *out)
{
    for (const char *p = from; p < to;) {
        if (p[0] == '/' && p[1] == '/')
            p = write_comment(p, out);
        else if (is_word(*p))
            p = write_word_or_call(u, p, p > from ? p[-1] : ' ', out);
        else
            buf_char(out, *p++);
    }
}

// Writes the source of a stdlib snippet.
void native_write(CUnit *u, const char *text, Buf *out)
{
    if (u->soft)
        buf_str(out, text);
    else
        write_with_native_syntax(u, text, text + strlen(text), out);
}
