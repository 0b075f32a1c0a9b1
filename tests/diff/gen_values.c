// SPDX-License-Identifier: Apache-2.0
// Chooses the numbers in programs and the values of inputs.  Both are taken from the same few sets (limits of types, zeros, halves, small
// numbers).  Comparisons then often meet equal values, and conversions often meet the limits.
#include "tests/diff/gen.h"

#include <inttypes.h>
#include <stdio.h>

#include "stdlib/convert.h"

static const char *const edge_text[] = {
    "127", "128", "262143", "262144", "-262144", "-262145", "-128", "-32768", "-2147483648", "-9223372036854775808", "127.9", "255", "256", "255.5", "300", "32767", "32768", "65535", "65536", "65535.99",
    "2147483647", "2147483648", "4294967295", "4294967296", "16777216", "16777217", "9007199254740991",
    "9007199254740992", "9007199254740993", "9223372036854774784", "9223372036854775807", "9223372036854775808",
    "18446744073709549568", "18446744073709551615", "18446744073709551616", "3.4028234663852886e38",
    "3.4028235677973366e38", "1e39", "1e-45", "7e-46", "1e-310", "5e-324", "1e-400", "2.2250738585072014e-308",
    "1.7976931348623157e308", "1e308", "8.98846567431158e307", "1e300", "0x1F", "0xFFFF_FFFF", "0x8000000000000000",
    "0xffffffffffffffff", "1_000_000", "007.5", "010", "5.", ".5", "2.5E-3", "1E+2", "4503599627370495.5",
    "4503599627370496", "0.49999999999999994", "0.1", "0.2", "0.30000000000000004", "3.14159", "1e22", "1e23",
    "123456789.123456789", "-0",
};

static const char *const small_text[] = {
    "0", "1", "2", "3", "4", "5", "7", "10", "0.5", "1.5", "2.5", "0.25", "-1", "-2", "-0.5", "-0", "true", "false",
};

const char *gen_number(Arena *arena, Rng *r, uint32_t mood)
{
    char text[64];
    if (rng_percent(r, mood == 0 ? 85 : 35))
        return small_text[rng_below(r, sizeof small_text / sizeof *small_text)];
    if (rng_percent(r, 60))
        return edge_text[rng_below(r, sizeof edge_text / sizeof *edge_text)];
    if (rng_percent(r, 50))
        return format_in(arena, "%u", (unsigned)rng_below(r, 1000));
    // Any finite F64, with enough digits to identify it.
    snprintf(text, sizeof text, "%.17g", sm_from_bits(rng_u64(r) % 0x7FF0000000000000u));
    return format_in(arena, "%s", text);
}

// ---- cells ----

static const uint64_t edge_f64[] = {
    0x0000000000000000u, 0x8000000000000000u, 0x3FF0000000000000u, 0xBFF0000000000000u, 0x3FE0000000000000u, 0xBFE0000000000000u,
    0x7FF0000000000000u, 0xFFF0000000000000u, 0x7FF8000000000000u, 0xFFF8000000000000u, 0x7FF0000000000001u, 0x0000000000000001u,
    0x800FFFFFFFFFFFFFu, 0x0010000000000000u, 0x7FEFFFFFFFFFFFFFu, 0xFFEFFFFFFFFFFFFFu, 0x43F0000000000000u, 0x43E0000000000000u,
    0xC3E0000000000000u, 0x41F0000000000000u, 0x41E0000000000000u, 0x41DFFFFFFFC00000u, 0x40F0000000000000u, 0x405FC00000000000u,
    0x4060000000000000u, 0x47EFFFFFE0000000u, 0x47EFFFFFF0000000u, 0x36A0000000000000u, 0x3690000000000000u, 0x4330000000000000u,
};

static uint64_t random_f64_cell(Rng *r)
{
    const uint64_t u = rng_u64(r);
    switch (rng_below(r, 5)) {
    case 0: return u;
    case 1: return sm_bits((double)((int64_t)(u % 2001) - 1000) / 4);
    case 2: return (u & 0x8000000000000000u) | (uint64_t)(1023 - 4 + u % 80) << 52 | (rng_u64(r) >> 12);
    default: return edge_f64[u % (sizeof edge_f64 / sizeof *edge_f64)];
    }
}

static uint64_t random_integer_cell(Rng *r, unsigned bits)
{
    const uint64_t mask = UINT64_MAX >> (64 - bits), u = rng_u64(r);
    switch (rng_below(r, 6)) {
    case 0: return u & mask;
    case 1: return mask;                              // the largest value, or -1 if the type is signed
    case 2: return mask >> 1;
    case 3: return (mask >> 1) + 1;
    case 4: return (0 - u % 8) & mask;
    default: return u % 20 & mask;
    }
}

uint64_t gen_cell(Rng *r, SmType type, uint32_t mood)
{
    if (type == SM_BOOL)
        return rng_below(r, 2);
    if (mood == 0 && rng_percent(r, 85))              // mostly small numbers, so that values are often equal
        return sm_cell_from_f64(type, (double)rng_below(r, 12) - (type == SM_F64 || type == SM_I8 ? 3 : 0));
    if (type == SM_F64)
        return random_f64_cell(r);
    if (type == SM_F32)
        return rng_percent(r, 30) ? rng_u64(r) >> 32 : sm_f32_bits((float)sm_from_bits(random_f64_cell(r)));
    return random_integer_cell(r, 8u * sm_type_info[type].bytes);
}

// ---- inputs ----

static uint64_t first_g(const Gen *g, Rng *r)
{
    switch (rng_below(r, 10)) {
    case 0: return 9007199254740992u - rng_below(r, 50);
    case 1: return 0x8000000000000000u - rng_below(r, 50);
    case 2: return rng_percent(r, 30) ? UINT64_MAX - 20 - 2 * g->steps : 1000;
    case 3: return rng_u64(r) >> rng_below(r, 64);
    default: return rng_below(r, 3);
    }
}

// Plans G before each step.  Most steps advance by a small amount; some do not advance, or go back.
void gen_plan_time(Gen *g)
{
    Rng r = { rng_mix(g->seed, 3) };
    uint64_t now = first_g(g, &r);
    const uint32_t stride = rng_percent(&r, 70) ? 1 : 1 + rng_below(&r, 100);
    g->now[0] = now;
    for (uint32_t i = 1; i < g->steps; i++) {
        const uint32_t what = rng_below(&r, 100);
        if (what < 3)
            g->now[i] = now;                          // does not advance
        else if (what < 5)
            g->now[i] = now - rng_below(&r, now < 50 ? (uint32_t)now + 1 : 50);      // goes back
        else if (what < 6)
            g->now[i] = UINT64_MAX;
        else
            g->now[i] = now += what < 8 ? 1 + rng_below(&r, 10000) : stride;
    }
}

// An element can have the value NaN, written by the test.  A local cannot: only the machine stores it, and the language stores no NaN.
static uint64_t input_cell(const Gen *g, Rng *r, const GVar *v)
{
    const bool none = !v->is_local && sm_type_info[v->type].kind == SM_KIND_FLOAT && rng_percent(r, 3);
    const uint64_t cell = none ? v->type == SM_F32 ? 0xffc00001u : 0x7FF8000000000000u : gen_cell(r, v->type, g->mood);
    const bool f32_nan = v->type == SM_F32 && (cell & 0x7fffffffu) > 0x7f800000u;
    const bool f64_nan = v->type == SM_F64 && (cell & 0x7FFFFFFFFFFFFFFFu) > 0x7FF0000000000000u;
    return v->is_local && (f32_nan || f64_nan) ? 0 : cell;
}

uint32_t gen_inputs(const Gen *g, uint32_t k, GInput *out)
{
    uint32_t n = 0;
    out[n++] = (GInput){ g->var.at[0], g->now[k] };
    for (size_t i = 1; i < g->var.n; i++) {
        GVar *v = g->var.at[i];
        Rng r = { rng_mix(rng_mix(g->seed, 5 + v->id), k) };
        if (v->outside && !v->removed && (v->listed || v->is_local) && rng_percent(&r, k == 0 ? 80 : 25))
            out[n++] = (GInput){ v, input_cell(g, &r, v) };
        if (v->parameter && v->is_set && !v->removed && k == 0)
            out[n++] = (GInput){ v, gen_parameter_cell(v) };
    }
    return n;
}

bool gen_restarts(const Gen *g, uint32_t k, uint32_t *state)
{
    Rng r = { rng_mix(rng_mix(g->seed, 4), (uint64_t)k << 32) };
    *state = k == 0 ? g->first_state : rng_below(&r, g->states);
    return k == 0 || rng_below(&r, 700) == 0;
}
