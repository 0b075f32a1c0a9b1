// SPDX-License-Identifier: Apache-2.0
#include "tests/prove/related_text.h"

static const char *any_of(Rng *rng, const char *const *text, uint32_t n) { return text[rng_below(rng, n)]; }
#define ANY(...) any_of(rng, (const char *const[]){__VA_ARGS__}, sizeof((const char *const[]){__VA_ARGS__}) / sizeof(const char *))

// Few variables, so that relations between them are frequent.
static const char *target(Rng *rng) { return ANY("a", "a", "b", "b", "c", "n", "out", "narrow"); }
static const char *value(Rng *rng) { return rng_percent(rng, 70) ? target(rng) : ANY("p", "q", "r", "roll_median(p, 3)", "roll_avg(q, 2)", "prev(p)"); }
static const char *number(Rng *rng) { return ANY("0", "1", "0.1", "0.2", "3", "5", "0.25", "1e16", "9007199254740993", "1e-320", "1e308", "16777217"); }

static void print_expression(Rng *rng, const char *self, unsigned depth, Buf *out)
{
    const char *x = rng_percent(rng, 60) ? self : value(rng), *y = value(rng);

    switch (rng_below(rng, depth ? 11 : 4)) {
    case 0: buf_str(out, y); break;
    case 1: buf_printf(out, "max(%s, %s)", x, y); break;
    case 2: buf_printf(out, "min(%s, %s)", x, y); break;
    case 3: buf_printf(out, "(%s %s %s)", x, ANY("+", "-"), number(rng)); break;
    case 4: case 5: {
        const char *k = number(rng);
        buf_printf(out, "%s + clamp(%s - %s, -%s, %s)", x, y, x, k, k);
        break;
    }
    case 6: buf_printf(out, "clamp(%s + clamp(%s - %s, -0.2, 0.2), -5, 5)", x, y, x); break;
    case 7: buf_printf(out, "%s(%s)", ANY("abs", "-", "floor", "sqrt"), y); break;
    case 8: buf_printf(out, "%s * %s", x, number(rng)); break;
    default:
        buf_printf(out, "%s(", ANY("max", "min"));
        print_expression(rng, self, depth - 1, out);
        buf_str(out, ", ");
        print_expression(rng, self, depth - 1, out);
        buf_char(out, ')');
    }
}

static void print_assignment(Rng *rng, const char *indent, Buf *out)
{
    const char *to = target(rng);

    buf_printf(out, "%s%s = ", indent, to);
    print_expression(rng, to, 1, out);
    buf_char(out, '\n');
}

static void print_statements(Rng *rng, uint32_t n, Buf *out)
{
    for (uint32_t i = 0; i < n; i++) {
        if (rng_percent(rng, 70)) {
            print_assignment(rng, "    ", out);
            continue;
        }
        buf_printf(out, "    %s %s %s {\n", target(rng), ANY("<", "<=", ">", ">="), value(rng));
        print_assignment(rng, "        ", out);
        buf_str(out, "    }\n");
    }
}

static void print_relation(Rng *rng, const Related *of, Buf *out)
{
    if (rng_percent(rng, 15))
        return;
    switch (of->kind) {
    case 0: buf_printf(out, "    %s = max(%s, %s)\n", of->x, of->x, of->y); break;
    case 1: buf_printf(out, "    %s = min(%s, %s)\n", of->x, of->x, of->y); break;
    case 2: buf_printf(out, "    %s = %s + clamp(%s - %s, -%s, %s)\n", of->x, of->x, of->y, of->x, of->by, of->by); break;
    case 3: buf_printf(out, "    %s = clamp(%s + clamp(%s - %s, -%s, %s), -5, 5)\n", of->x, of->x, of->y, of->x, of->by, of->by); break;
    default: buf_printf(out, "    %s = %s + %s\n", of->x, of->y, of->by);
    }
}

Related related_print_machine(Rng *rng, Buf *out)
{
    const Related of = {target(rng), value(rng), number(rng), rng_below(rng, 5)};

    buf_str(out, "[options]\nstep 10 ms\n\n[state_vector]\nU64 time @alias G\nU32 state @alias S\nF64 p @read_only\nF32 q @read_only\nI16 r @read_only\nbool go @read_only\n"
                 "F64 out\nF32 narrow\n\n[local]\n");
    buf_printf(out, "F64 a = 0\nF64 b = %s\nF32 c = 0\nI32 n = 0\n\n[One]\n.step\n", ANY("0", "0", "1", "5"));
    print_statements(rng, rng_below(rng, 3), out);
    print_relation(rng, &of, out);
    buf_printf(out, "    %s: -> Two\n", ANY("go", "T > 30 ms", "a < b", "p > 1"));
    buf_str(out, "\n[Two]\n");
    if (rng_percent(rng, 30)) {
        buf_str(out, ".entry\n");
        print_statements(rng, 1, out);
    }
    buf_str(out, ".step\n");
    print_statements(rng, rng_below(rng, 2), out);
    print_relation(rng, &of, out);
    buf_printf(out, "    %s: -> One\n", ANY("not go", "T > 20 ms", "out > 3"));
    return of;
}

// A requirement that the relation meets, or almost.
static void print_near(Rng *rng, const Related *of, Buf *out)
{
    buf_printf(out, "always %s", ANY("", "S == One implies ", "T > 0 implies "));
    switch (of->kind) {
    case 0: buf_printf(out, "%s %s %s\n", of->x, ANY(">=", ">=", ">"), of->y); break;
    case 1: buf_printf(out, "not (%s %s %s)\n", of->x, ANY(">", ">", ">="), of->y); break;
    case 2: case 3: buf_printf(out, "abs(%s - prev(%s)) <= %s%s\n", of->x, of->x, of->by, ANY("", " + 0.001", " * 1.01", " + 1")); break;
    default: buf_printf(out, "%s - %s <= %s%s\n", of->x, of->y, of->by, ANY("", " + 0.001", " + 1"));
    }
}

void related_print_requirement(Rng *rng, const Related *of, Buf *out)
{
    const char *x = target(rng), *y = rng_percent(rng, 25) ? x : value(rng), *when = ANY("", "", "S == One", "S == Two", "T > 0", "go");
    const char *relation = ANY("<=", "<=", ">=", ">=", "<", ">", "==", "!=");
    const bool previous = y == x || rng_percent(rng, 20), always = rng_percent(rng, 50);

    if (rng_percent(rng, 60)) {
        print_near(rng, of, out);
        return;
    }
    buf_str(out, always ? "always " : "never ");
    if (*when)
        buf_printf(out, "%s %s ", when, always ? "implies" : "and");
    if (!always && !*when)
        buf_str(out, "not ");
    if (rng_percent(rng, 50))
        buf_printf(out, "(%s %s %s%s%s)\n", x, relation, previous ? "prev(" : "", y, previous ? ")" : "");
    else
        buf_printf(out, "(%s(%s - %s%s%s) %s %s)\n", rng_percent(rng, 60) ? "abs" : "", x, previous ? "prev(" : "", y, previous ? ")" : "", ANY("<=", "<=", ">=", "<"), ANY("0", "0.2", "0.201", "1", "3", "5", "0.1"));
}
