// SPDX-License-Identifier: Apache-2.0
#include "tests/prove/held_text.h"

enum { FORMS = 5, EQUAL = 3 };

// Conditions: the first EQUAL of a family are equal, the others almost.
static const char *const family[][FORMS] = {
    {"max(p, q) > limit", "p > limit or q > limit", "not (p <= limit and not (limit < q))", "p >= limit or q > limit", "p > limit"},
    {"min(p, q) < 0", "p < 0 or q < 0", "not (p >= 0 and q >= 0)", "p < 0 and q < 0", "min(p, q) <= 0"},
    {"0 < p < 2 and on", "not (p <= 0 or p >= 2) and on", "on and p > 0 and p < 2", "0 <= p < 2 and on", "0 < p < 2"},
    {"abs(p) > 1", "p > 1 or p < -1", "not (-1 <= p <= 1)", "p > 1 or p <= -1", "abs(p) > limit"},
    {"r == prev(r)", "r == prev(r)", "not (r != prev(r))", "r >= prev(r)", "r == prev(p)"},
    {"on != out", "prev(out) != on", "not (prev(out) == on)", "out != on", "on and not out"},
    {"rising(on)", "rising(on)", "on and not prev(on)", "on", "falling(on)"}};

enum { FAMILIES = sizeof family / sizeof *family };

static const char *any_of(Rng *rng, const char *const *text, uint32_t n) { return text[rng_below(rng, n)]; }
#define ANY(...) any_of(rng, (const char *const[]){__VA_ARGS__}, sizeof((const char *const[]){__VA_ARGS__}) / sizeof(const char *))

static const char *any_time(Rng *rng) { return ANY("10 ms", "20 ms", "30 ms", "2 steps", "3 steps", "1 steps"); }

static void print_guard(Rng *rng, const char *to, const char *condition, const char *time, Buf *out)
{
    if (rng_percent(rng, 50))
        buf_printf(out, "    held(%s, %s): -> %s\n", condition, time, to);
    else
        buf_printf(out, "    held(%s, %s) {\n        code = %u\n        -> %s\n    }\n", condition, time, (unsigned)rng_below(rng, 4), to);
}

static void print_any_guard(Rng *rng, const char *to, Buf *out)
{
    print_guard(rng, to, family[rng_below(rng, FAMILIES)][0], any_time(rng), out);
}

Held held_print_machine(Rng *rng, Buf *out)
{
    const Held of = {rng_below(rng, FAMILIES), any_time(rng)};
    const char *leaves = family[of.family][rng_below(rng, EQUAL)];

    buf_str(out, "[options]\nstep 10 ms\n\n[state_vector]\nU64 time @alias G\nU32 state @alias S\n"
                 "F32 p @read_only @range -100 100\nF64 q @read_only @range 0 4\nI16 r @read_only\nbool on @read_only\nbool out\nU8 code\n\n[local]\nF32 limit = 3 @parameter @range 1 5\n\n");
    buf_printf(out, "[One]\n.entry\n    out = %s\n.step\n", ANY("true", "false", "on"));
    if (rng_percent(rng, 30))
        print_any_guard(rng, "Two", out);
    print_guard(rng, "Two", leaves, of.time, out);
    buf_printf(out, "\n[Two]\n.step\n    out = %s\n", ANY("true", "false", "p > 0"));
    if (rng_percent(rng, 50))
        print_any_guard(rng, "Three", out);
    buf_printf(out, "    %s: -> One\n\n[Three]\n.step\n    code = %s\n", ANY("T > 20 ms", "on", "p > limit"), ANY("0", "7", "code"));
    print_any_guard(rng, "One", out);
    return of;
}

void held_print_requirement(Rng *rng, const Held *of, Buf *out)
{
    const uint32_t same = rng_percent(rng, 85) ? of->family : rng_below(rng, FAMILIES);
    const char *condition = family[same][rng_below(rng, rng_percent(rng, 75) ? EQUAL : FORMS)];
    const char *time = rng_percent(rng, 80) ? of->time : any_time(rng);

    switch (rng_below(rng, 7)) {
    case 0: buf_printf(out, "always held(%s, %s) and S == One leads to S == Two within %s\n", condition, time, ANY("10 ms", "0 ms", "20 ms")); break;
    case 1: buf_printf(out, "never S == Two and prev(S == One) and not prev(held(%s, %s))\n", condition, time); break;
    case 2: buf_printf(out, "always rising(S == Two) implies prev(held(%s, %s))\n", condition, time); break;
    case 3: buf_printf(out, "never Two before (held(%s, %s))\n", condition, time); break;
    case 4:
        buf_printf(out, "never %s%s\n", ANY("S == Two and ", "", "not on and "),
                   ANY("q > 4", "p + q > 104", "p < -100", "max(p, q) > 99", "held(q < 0, 2 steps)", "q < 0 or q >= 4"));
        break;
    case 5:
        buf_printf(out, "always %s%s\n", ANY("S == One implies ", "code == 7 implies ", ""),
                   ANY("1 <= limit <= 5", "limit > 1", "limit - q >= -3", "code <= 7"));
        break;
    default: buf_printf(out, "never Two after (S == One) without (held(%s, %s))\n", condition, time); break;
    }
}
