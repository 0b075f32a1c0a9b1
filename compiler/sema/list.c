// SPDX-License-Identifier: Apache-2.0
// Composes min, max, median and average of several values.  The median is a selection network of min and max: these order -0 below 0, and return
// NaN if an operand is NaN.  Both results of an exchange are then NaN.  A path leads from every value of the list to the median, so a NaN in the list
// makes the median NaN.
#include "compiler/sema/list.h"

#include <stdbool.h>

#include "stdlib/convert.h"
#include "stdlib/math.h"

// ---- steps ----

// The list of operations of which a call is composed, while operations are added.
typedef struct Steps {
    ListStep *step;
    uint32_t values, n;       // number of values in the list; number of steps so far
} Steps;

static uint8_t add_step(Steps *s, ListOp op, uint8_t a, uint8_t b)
{
    s->step[s->n] = (ListStep){.op = op, .a = a, .b = b};
    return (uint8_t)(s->values + s->n++);
}

static uint8_t add_number(Steps *s, SmF64 number)
{
    const uint8_t value = add_step(s, LIST_NUMBER, 0, 0);

    s->step[s->n - 1].number = number;
    return value;
}

static uint8_t add_whole_number(Steps *s, int32_t number) { return add_number(s, sm_from_i32(number)); }

// ---- smallest, largest ----

static void add_extreme(Steps *s, ListOp op)
{
    uint8_t value = 0;

    for (uint32_t i = 1; i < s->values; i++)
        value = add_step(s, op, value, (uint8_t)i);
}

// ---- average ----

// Adds the steps of the average: adds the values in pairs, then the sums in pairs, and so on; a last value without a partner is copied (language.md
// 7.12).
static void add_average(Steps *s)
{
    uint8_t sum[SM_LIST_MAX];
    uint32_t n = s->values;

    for (uint32_t i = 0; i < n; i++)
        sum[i] = (uint8_t)i;
    for (; n > 1; n = (n + 1) / 2)
        for (uint32_t i = 0; i < n; i += 2)
            sum[i / 2] = i + 1 < n ? add_step(s, LIST_ADD, sum[i], sum[i + 1]) : sum[i];
    add_step(s, LIST_DIV, sum[0], add_whole_number(s, (int32_t)s->values));
}

// ---- median ----

// A comparator between two wires of the network: after it, `low` carries the smaller value and `high` the larger.  needs_low, needs_high: whether a
// later comparator, or the result, uses that wire.
typedef struct Exchange { uint8_t low, high; bool needs_low, needs_high; } Exchange;

#define EXCHANGES_MAX 64      // the most exchanges of a network: 16 values need 62

// A network of exchanges that selects the median: each exchange orders two values.
typedef struct Selection {
    Exchange exchange[EXCHANGES_MAX];
    uint32_t n;
    uint8_t wire[SM_LIST_MAX];        // the wires whose values can still be the median
    uint32_t candidates;
} Selection;

static void add_exchange(Selection *net, uint32_t low, uint32_t high)
{
    net->exchange[net->n++] = (Exchange){.low = net->wire[low], .high = net->wire[high]};
}

// Moves the smallest candidate to the first wire and the largest to the last, then drops both.
static void drop_extremes(Selection *net)
{
    const uint32_t last = net->candidates - 1, half = net->candidates / 2;

    for (uint32_t i = 0; i < half; i++)
        add_exchange(net, i, last - i);
    for (uint32_t i = 1; i <= last - half; i++)
        add_exchange(net, 0, i);
    for (uint32_t i = half; i < last; i++)
        add_exchange(net, i, last);
    net->candidates -= 2;
    for (uint32_t i = 0; i < net->candidates; i++)
        net->wire[i] = net->wire[i + 1];
}

// Builds the network that finds the middle value, or the two in the middle, of n values.  Among n / 2 + 2 candidates the smallest has n / 2 + 1
// values above it, and the largest as many below, so neither is in the middle: both are dropped, and the next value of the list is added.
static void select_middle(Selection *net, uint32_t n)
{
    uint32_t next = n < 4 ? n : n / 2 + 2;

    net->n = 0;
    for (net->candidates = 0; net->candidates < next; net->candidates++)
        net->wire[net->candidates] = (uint8_t)net->candidates;
    while (net->candidates > 2) {
        drop_extremes(net);
        if (next < n)
            net->wire[net->candidates++] = (uint8_t)next++;
    }
    if (net->candidates == 2)
        add_exchange(net, 0, 1);
}

// Sets needs_low and needs_high: whether the remaining candidates depend on that result of the exchange.
static void mark_needed(Selection *net)
{
    bool needed[SM_LIST_MAX] = {false};

    for (uint32_t i = 0; i < net->candidates; i++)
        needed[net->wire[i]] = true;
    for (uint32_t i = net->n; i-- > 0;) {
        Exchange *x = &net->exchange[i];
        x->needs_low = needed[x->low];
        x->needs_high = needed[x->high];
        needed[x->low] = needed[x->high] = x->needs_low || x->needs_high;
    }
}

// Adds the value between lo and hi, lo not above hi (language.md 7.16, 7.17): lo if they are equal, else lo + (hi - lo) / 2, or lo / 2 + hi / 2 if
// the difference is not finite.  Without a branch: `finite` is 1 or 0, and `near` is lo or a zero.  Subtracting (near - hi + 0) / 2 instead of
// adding its opposite leaves a lo of -0 as it is if hi is a zero.  The result is never outside lo and hi; min and max let the facts know that.
static void add_middle_of_two(Steps *s, uint8_t lo, uint8_t hi)
{
    const uint8_t infinity = add_number(s, sm_from_bits(0x7FF0000000000000u));
    const uint8_t finite = add_step(s, LIST_LT, add_step(s, LIST_SUB, hi, lo), infinity);
    const uint8_t bound = add_step(s, LIST_DIV, finite, add_step(s, LIST_SUB, add_whole_number(s, 1), finite));       // infinity if `finite`, else 0
    const uint8_t near = add_step(s, LIST_MIN, add_step(s, LIST_MAX, lo, add_step(s, LIST_NEG, bound, 0)), bound);
    const uint8_t zero = add_whole_number(s, 0), two = add_whole_number(s, 2);
    const uint8_t share = add_step(s, LIST_DIV, lo, add_step(s, LIST_SUB, two, finite));                       // lo if `finite`, else lo / 2
    const uint8_t gap = add_step(s, LIST_ADD, add_step(s, LIST_SUB, near, hi), zero);
    const uint8_t middle = add_step(s, LIST_SUB, share, add_step(s, LIST_DIV, gap, two));

    add_step(s, LIST_MIN, add_step(s, LIST_MAX, middle, lo), hi);
}

static void add_median(Steps *s)
{
    uint8_t value[SM_LIST_MAX];       // by wire: the number of the value that it carries
    Selection net;

    for (uint32_t i = 0; i < s->values; i++)
        value[i] = (uint8_t)i;
    select_middle(&net, s->values);
    mark_needed(&net);
    for (uint32_t i = 0; i < net.n; i++) {
        const Exchange *x = &net.exchange[i];
        const uint8_t a = value[x->low], b = value[x->high];
        if (x->needs_low)
            value[x->low] = add_step(s, LIST_MIN, a, b);
        if (x->needs_high)
            value[x->high] = add_step(s, LIST_MAX, a, b);
    }
    if (net.candidates == 2)
        add_middle_of_two(s, value[net.wire[0]], value[net.wire[1]]);
}

// ---- the functions ----

uint32_t list_steps(SmBuiltin fn, uint32_t n, ListStep *step)
{
    Steps s = {.step = step, .values = n};

    switch (fn) {
    case SM_FN_median: add_median(&s); break;
    case SM_FN_average: add_average(&s); break;
    default: add_extreme(&s, fn == SM_FN_min ? LIST_MIN : LIST_MAX); break;
    }
    return s.n;
}

static SmF64 step_value(const ListStep *s, const SmF64 *v)
{
    switch (s->op) {
    case LIST_NUMBER: break;
    case LIST_MIN: return sm_min(v[s->a], v[s->b]);
    case LIST_MAX: return sm_max(v[s->a], v[s->b]);
    case LIST_ADD: return sm_add(v[s->a], v[s->b]);
    case LIST_SUB: return sm_sub(v[s->a], v[s->b]);
    case LIST_DIV: return sm_div(v[s->a], v[s->b]);
    case LIST_NEG: return sm_neg(v[s->a]);
    case LIST_LT: return sm_from_bool(sm_lt(v[s->a], v[s->b]));
    }
    return s->number;
}

SmF64 list_value(SmBuiltin fn, uint32_t n, const SmF64 *value)
{
    ListStep step[LIST_STEPS_MAX];
    SmF64 v[SM_LIST_MAX + LIST_STEPS_MAX];
    const uint32_t steps = list_steps(fn, n, step);

    for (uint32_t i = 0; i < n; i++)
        v[i] = value[i];
    for (uint32_t i = 0; i < steps; i++)
        v[n + i] = step_value(&step[i], v);
    return v[n + steps - 1];
}
