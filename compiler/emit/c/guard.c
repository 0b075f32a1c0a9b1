// SPDX-License-Identifier: Apache-2.0
// Emitted C has the same meaning with any compiler and any flags, or does not compile, or its init fails.  Three mechanisms ensure that:
// 1. Pragmas switch off optimisations that change results.
// 2. #error rejects compilers and flags that predefined macros reveal.
// 3. A self-test at run time, with operands that the compiler cannot know, finds the rest.
#include "compiler/emit/c/unit.h"

static const char includes[] =
    "#include <float.h>\n"
    "#include <stdbool.h>\n"
    "#include <stddef.h>\n"
    "#include <stdint.h>\n"
    "#include <string.h>\n";

// FLT_EVAL_METHOD 1 is accepted: it evaluates float as double, and emitted C rounds every float result back.  Values from 16 to 64 are
// accepted: they concern types that are not used.
static const char guards[] =
    "// ---- what this file requires of the compiler ----\n"
    "\n"
    "#if FLT_RADIX != 2 || DBL_MANT_DIG != 53 || DBL_MAX_EXP != 1024 || FLT_MANT_DIG != 24 || FLT_MAX_EXP != 128\n"
    "#error \"this code needs a double that is IEEE binary64 and a float that is IEEE binary32: smc build --soft makes C without\"\n"
    "#endif\n"
    "#if defined(__x86_64__) && !defined(__SSE2__) && !defined(__TINYC__)\n"
    "#error \"this code needs SSE2, which every x86-64 has: build it without -mno-sse2\"\n"
    "#endif\n"
    "#if defined(FLT_EVAL_METHOD) && (FLT_EVAL_METHOD < 0 || FLT_EVAL_METHOD == 2 || FLT_EVAL_METHOD > 64)\n"
    "#error \"this code needs arithmetic without excess precision: on 32-bit x86 build with -msse2 -mfpmath=sse\"\n"
    "#endif\n"
    "#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0) || defined(_M_FP_FAST) || \\\n"
    "    defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || defined(__NO_SIGNED_ZEROS__)\n"
    "#error \"this code needs IEEE arithmetic: build it without -ffast-math and its parts\"\n"
    "#endif\n"
    "\n"
    "// a * b + c is two operations, each rounded.\n"
    "#if defined(__clang__)\n"
    "#pragma STDC FP_CONTRACT OFF\n"
    "#pragma clang diagnostic ignored \"-Wtautological-compare\"   // conditions are as their author wrote them\n"
    "#elif defined(__GNUC__)\n"
    "#pragma GCC optimize (\"fp-contract=off\")\n"
    "#pragma GCC optimize (\"rounding-math\")    // gcc 12 otherwise replaces 0.0 - (double)i by -(double)i, which is -0 for 0\n"
    "#pragma GCC optimize (\"no-tree-slp-vectorize\")    // gcc 12 drops the rounding of (double)(float)x when it vectorises two of them\n"
    "#elif defined(_MSC_VER)\n"
    "#pragma fp_contract (off)\n"
    "#endif\n"
    "\n"
    "// A flag can shorten the constants.\n"
    "typedef char %s_constants_are_double[sizeof 0.1 == sizeof(double) && sizeof(double) == 8 ? 1 : -1];\n";

// With soft numbers there is no floating-point arithmetic, so only the format of float is checked.
static const char soft_guards[] =
    "// ---- what this file requires of the compiler ----\n"
    "\n"
    "#if !SM_F64_SOFT\n"
    "#error \"this code was generated for soft numbers, but stdlib/f64.h uses a double here: build with -DSM_F64_SOFT=1, or smc without --soft\"\n"
    "#endif\n"
    "#if FLT_RADIX != 2 || FLT_MANT_DIG != 24 || FLT_MAX_EXP != 128\n"
    "#error \"this code needs a float that is IEEE binary32\"\n"
    "#endif\n"
    "#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0\n"
    "#error \"this code needs floats that can be NaN: build it without -ffast-math and its parts\"\n"
    "#endif\n"
    "#if defined(__clang__)\n"
    "#pragma clang diagnostic ignored \"-Wtautological-compare\"   // conditions are as their author wrote them\n"
    "#endif\n";

// Writes the includes, and the #error checks and pragmas against compilers and flags that change the meaning of arithmetic.  `name` begins
// the name of the type that checks the size of constants.
void c_write_compiler_checks(Buf *out, const char *name, bool soft)
{
    buf_str(out, includes);
    buf_char(out, '\n');
    if (soft)
        buf_str(out, soft_guards);
    else
        buf_printf(out, guards, name);
}

// Each `fit = …` line tests one way in which a compiler, a flag or a mode of the processor can change results.
static const char self_test[] =
    "// Tests what no macro reports: the rounding mode, whether subnormal numbers survive, and what flags may have allowed the\n"
    "// compiler to do to arithmetic.  The operands are volatile, so that the compiler cannot evaluate it.\n"
    "SM_SELF_TEST bool sm_is_fit(void)\n"
    "{\n"
    "    const volatile double one = 1.0, three = 3.0, ten = 10.0, big = 9007199254740992.0, tiny = 4.9406564584124654e-324;\n"
    "    const volatile double tenth = 0.1, small = 1e-17, least = 2.2250738585072014e-308, zero = 0.0, minus_zero = -0.0;\n"
    "    const volatile float float_least = 1.17549435e-38f, float_half = 0.5f;\n"
    "    const volatile uint64_t wide = UINT64_C(9223372036854776833);\n"
    "    const volatile uint8_t nothing = 0;\n"
    "    const volatile double five = 5.0, nine = 9.0, forty_nine = 49.0;\n"
    "    const volatile double wall = 9223372036854775808.0, chip = 1073741824.0000007152557373046875;\n"
    "    const double x = one, y = three, z = big, d = forty_nine, product = tenth * ten, rest = product - x;\n"
    "    const volatile double q5 = five / d, q9 = nine / d, q10 = ten / d;\n"
    "    bool fit = true;\n"
    "\n"
    "    fit = fit && one + small == 1.0 && one - small == 1.0 && -one - small == -1.0;                      // rounds to nearest\n"
    "    fit = fit && big + one == 9007199254740992.0 && big + three == 9007199254740996.0;                  // ... even\n"
    "    fit = fit && wall - chip == 9223372035781033984.0 && chip - wall == -9223372035781033984.0;         // ... with all digits: libgcc of Cortex-M3, M4\n"
    "    fit = fit && tiny > 0.0 && tiny + tiny > tiny && least * 0.5 > 0.0;                                 // keeps subnormal numbers\n"
    "    fit = fit && float_least * float_half > 0.0f && (float)(least * 0.5) < float_least;                 // ... in float too\n"
    "    fit = fit && 1.0 / (minus_zero + zero) > 0.0 && 1.0 / (minus_zero * one) < 0.0;                     // keeps the sign of zero\n"
    "    fit = fit && 1.0 / (zero - zero) > 0.0 && 1.0 / -zero < 0.0 && 1.0 / (minus_zero + 0.0) > 0.0;\n"
    "    fit = fit && tenth * ten - one == 0.0 && one - tenth * ten == 0.0 && rest == 0.0;                   // rounds a * b before + and -\n"
    "    fit = fit && tenth * ten + -one == 0.0 && tenth * tenth - 0.010000000000000002 == 0.0;\n"
    "    fit = fit && (x + z) - z == 0.0 && (z + y) - z == 4.0 && (x + z) + x == z;                          // adds in the order written\n"
    "    fit = fit && (x + 9007199254740992.0) - 9007199254740992.0 == 0.0 && (tenth * 3.0) * 10.0 == 3.0000000000000004;\n"
    "    fit = fit && five / 49.0 == 0.10204081632653061 && x / y == 0.33333333333333331;                    // divides\n"
    "    fit = fit && q5 == 0.10204081632653061 && q9 == 0.1836734693877551 && q10 == 0.20408163265306123;\n"
    "    fit = fit && (zero / zero) != (zero / zero) && !(zero / zero == zero / zero);                       // has NaN\n"
    "    fit = fit && 1.0 / zero > 1.7976931348623157e308 && one / zero - one / zero != 0.0;                 // ... and infinity\n"
    "    fit = fit && (double)wide == 9223372036854777856.0;                                                 // rounds integers once\n"
    "    fit = fit && 1.0 / (0.0 - (double)nothing) > 0.0 && 1.0 / (0.0 + -(double)nothing) > 0.0;           // subtracts from zero\n"
    "    return fit;\n"
    "}\n";

void c_write_self_test_declaration(Buf *out)
{
    buf_str(out, "// Machines of one program that are compiled with the same options can share the self-test at the end of this file.  Compile one of\n"
                 "// them with -DSM_SHARED_SELF_TEST=1, and it has the function for all; the others with -DSM_SHARED_SELF_TEST=0.\n"
                 "#ifndef SM_SHARED_SELF_TEST\n"
                 "#define SM_SELF_TEST static\n"
                 "#elif defined(__cplusplus)\n"
                 "#define SM_SELF_TEST extern \"C\"\n"
                 "#else\n"
                 "#define SM_SELF_TEST extern\n"
                 "#endif\n"
                 "SM_SELF_TEST bool sm_is_fit(void);\n\n");
}

void c_write_self_test(Buf *out)
{
    buf_str(out, "#if !defined(SM_SHARED_SELF_TEST) || SM_SHARED_SELF_TEST\n\n");
    buf_str(out, self_test);
    buf_str(out, "\n#endif\n");
}
