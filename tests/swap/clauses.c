// SPDX-License-Identifier: Apache-2.0
// The clauses of docs/swapping.md, one function for each group of them.  Clause 12.18 is in hostile.c.
#include <stdlib.h>
#include <string.h>

#include "tests/swap/machine.h"
#include "tests/test.h"

#define ELEMENTS "[state_vector]\nU64 G\nU32 S\nF64 p\nF64 out\nF64 more\nbool fired\n"
enum { AT_S = 8, AT_P = 16, AT_OUT = 24, AT_MORE = 32, AT_FIRED = 40 };

static union { uint64_t word[8]; uint8_t byte[64]; } sv;

static double number_at(uint32_t at)
{
    double x;

    memcpy(&x, sv.byte + at, sizeof x);
    return x;
}

static uint32_t state_number(void)
{
    uint32_t s;

    memcpy(&s, sv.byte + AT_S, sizeof s);
    return s;
}

static SmResult step(SwapMachine *s, uint64_t g, double p)
{
    memcpy(sv.byte, &g, sizeof g);
    memcpy(sv.byte + AT_P, &p, sizeof p);
    return smvm_step(s->vm, sv.byte);
}

// Starts `from` in its first state and steps it `steps` times, at G 10, 20, …, with p 1, 2, ….
static void run(SwapMachine *from, uint32_t steps)
{
    memset(&sv, 0, sizeof sv);
    CHECK(machine_start(from, sv.byte, 1) == SM_OK);
    for (uint32_t k = 1; k <= steps; k++)
        CHECK(step(from, 10 * k, k) == SM_OK);
}

// Prepares a swap and continues `from` in `to`.
static SmResult swap(SwapMachine *from, SwapMachine *to)
{
    SmResult result;
    SmvmSwap *plan = machine_plan(from, to, &result);

    if (plan == NULL)
        return result;
    CHECK(machine_start(to, NULL, 1) == SM_OK);
    result = smvm_swap_continue(plan, from->vm, to->vm, sv.byte);
    free(plan);
    return result;
}

// Compiles both machines.
static void compile_both(SwapMachine *from, SwapMachine *to, const char *old_text, const char *new_text)
{
    machine_compile(from, old_text, NULL, 2, true);
    machine_compile(to, new_text, NULL, 2, true);
}

static void free_both(SwapMachine *from, SwapMachine *to)
{
    machine_free(from);
    machine_free(to);
}

// Returns the fate of an item in the plan; 99 if the plan does not list it.
static unsigned fate_of(SwapMachine *from, SwapMachine *to, SmvmSwapKind kind, const char *name)
{
    SmResult result;
    SmvmSwap *plan = machine_plan(from, to, &result);
    unsigned found = 99;
    SmvmSwapItem item;

    for (uint32_t i = 0; plan != NULL && smvm_swap_item(plan, i, &item); i++)
        if (item.kind == kind && item.length == strlen(name) && memcmp(item.name, name, item.length) == 0)
            found = item.fate;
    free(plan);
    return found;
}

// ---- parameters ----

#define PARAMETER(line) ELEMENTS "[local]\n" line "\n[A] @swap\n.step\nout = limit\n"

// Returns the parameter `limit` after a swap.  The old machine runs with `limit` set to `value`.
static double limit_after(const char *old_text, const char *new_text, double value)
{
    SwapMachine old, new;
    double x = -1;
    uint32_t number;

    compile_both(&old, &new, old_text, new_text);
    if (smvm_find_parameter(&old.m, "limit", 5, &number))
        CHECK(smvm_set_parameter((uint8_t *)(uintptr_t)old.image, &old.m, number, value) == 0);
    run(&old, 2);
    if (swap(&old, &new) == SM_OK && step(&new, 30, 0) == SM_OK)
        x = number_at(AT_OUT);
    free_both(&old, &new);
    return x;
}

static void test_parameters(void)
{
    const char *const wide = PARAMETER("F64 limit = 450 @parameter @range 150 1000"), *const narrow = PARAMETER("F64 limit = 300 @parameter @range 200 500");
    const char *const other = PARAMETER("F32 limit = 300 @parameter @range 150 1000"), *const local = PARAMETER("F64 limit = 7");
    const char *const moved = PARAMETER("F64 first = 1 @parameter @range 0 2\nF64 limit = 300 @parameter @range 200 500");
    SwapMachine old, new, third;

    CHECK(limit_after(wide, narrow, 400) == 400 && limit_after(wide, narrow, 200) == 200 && limit_after(wide, narrow, 500) == 500);    // clause 12.55
    CHECK(limit_after(wide, narrow, 501) == 300 && limit_after(wide, narrow, 199) == 300 && limit_after(wide, other, 400) == 300);
    CHECK(limit_after(wide, moved, 400) == 400 && limit_after(wide, moved, 501) == 300 && limit_after(moved, wide, 250) == 250);
    CHECK(limit_after(local, narrow, 0) == 300 && limit_after(wide, local, 400) == 7);             // clause 12.56
    compile_both(&old, &new, wide, narrow);
    machine_compile(&third, wide, NULL, 2, true);
    CHECK(fate_of(&old, &new, SMVM_SWAP_LOCAL, "limit") == SMVM_SWAP_KEPT);
    CHECK(smvm_set_parameter((uint8_t *)(uintptr_t)old.image, &old.m, 0, 480) == 0);
    run(&old, 2);
    CHECK(swap(&old, &new) == SM_OK && step(&new, 30, 0) == SM_OK && number_at(AT_OUT) == 480);
    CHECK(swap(&new, &third) == SM_OK && step(&third, 40, 0) == SM_OK && number_at(AT_OUT) == 480);
    CHECK(machine_start(&new, sv.byte, 1) == SM_OK && step(&new, 50, 0) == SM_OK && number_at(AT_OUT) == 300);        // clause 12.57
    free_both(&old, &new);
    machine_free(&third);
    compile_both(&old, &new, wide, other);
    CHECK(fate_of(&old, &new, SMVM_SWAP_LOCAL, "limit") == SMVM_SWAP_CHANGED);
    free_both(&old, &new);
    compile_both(&old, &new, wide, local);
    CHECK(fate_of(&old, &new, SMVM_SWAP_LOCAL, "limit") == SMVM_SWAP_REMOVED || fate_of(&old, &new, SMVM_SWAP_LOCAL, "limit") == SMVM_SWAP_ADDED);
    free_both(&old, &new);
}

// ---- what can be swapped ----

#define COUNTER ELEMENTS "[local]\nU16 n = 0\nU16 other = 5\n[A] @swap\n.entry\nfired = true\n.step\nn = n + 1\nout = n\nmore = T\n"

static void test_boundary(void)
{
    SwapMachine old, new;

    // clause 12.1: the step before is one of the old machine, the step after one of the new; clause 12.3: no element but S changes.
    compile_both(&old, &new, COUNTER, ELEMENTS "[First]\n[A]\n.step\nout = out + 100\n");
    run(&old, 3);
    const uint32_t s = 2;
    uint8_t before[64];
    memcpy(before, sv.byte, sizeof before);
    CHECK(number_at(AT_OUT) == 3);
    CHECK(swap(&old, &new) == SM_OK && state_number() == 2);
    memcpy(before + AT_S, &s, sizeof s);
    CHECK(memcmp(before, sv.byte, sizeof before) == 0);
    CHECK(step(&new, 40, 0) == SM_OK && number_at(AT_OUT) == 103);
    free_both(&old, &new);
}

static void test_layout(void)
{
    SwapMachine old, new;

    // clause 12.2
    compile_both(&old, &new, COUNTER, ELEMENTS "F64 another\n[A]\n");
    run(&old, 1);
    CHECK(swap(&old, &new) == SM_E_LAYOUT);
    free_both(&old, &new);
    compile_both(&old, &new, COUNTER, ELEMENTS "[A]\n");
    CHECK(swap(&old, &new) == SM_E_ARGUMENT);                  // the old machine is not running
    free_both(&old, &new);
}

static void test_marks(void)
{
    SwapMachine marked, none, swap_only;

    // clause 12.4
    machine_compile(&marked, ELEMENTS "[A] @swap\n[B] @safe\n[C]\n[D] @abort @swap @safe\n[E] @abort\n", NULL, 2, true);
    machine_compile(&none, ELEMENTS "[A]\n[B] @abort\n", NULL, 2, true);
    machine_compile(&swap_only, ELEMENTS "[A]\n[B] @swap\n", NULL, 2, false);
    for (uint32_t s = 1; s <= 5; s++) {
        CHECK(smvm_state_allows_swap(&marked.m, s) == (s == 1 || s == 2 || s == 4));
        CHECK(smvm_state_is_safe(&marked.m, s) == (s == 2 || s == 4));
        CHECK(smvm_state_is_abort(&marked.m, s) == (s >= 4));
    }
    CHECK(!smvm_state_allows_swap(&none.m, 1) && !smvm_state_allows_swap(&none.m, 2) && smvm_state_is_safe(&none.m, 1));
    CHECK(!smvm_state_allows_swap(&swap_only.m, 1) && smvm_state_allows_swap(&swap_only.m, 2) && smvm_state_is_safe(&swap_only.m, 1));
    machine_free(&marked);
    machine_free(&none);
    machine_free(&swap_only);
}

// ---- restart, continue ----

static void test_restart(void)
{
    SwapMachine old, new;
    SmResult result;

    // clause 12.6, clause 12.5: the caller continues a machine or starts it; clause 12.19: preparing does not touch the vector.
    compile_both(&old, &new, COUNTER, COUNTER "[B]\n.entry\nout = 7\n.step\nmore = T + roll_max(p, 3)\n");
    run(&old, 4);
    memset(sv.byte + AT_FIRED, 0, 1);
    uint8_t before[64];
    memcpy(before, sv.byte, sizeof before);
    CHECK(machine_start(&new, NULL, 2) == SM_OK && machine_decode(&new, sv.byte) == SM_OK);
    free(machine_plan(&old, &new, &result));
    CHECK(memcmp(before, sv.byte, sizeof before) == 0);
    smvm_write_state(new.vm, &new.m, sv.byte);
    CHECK(state_number() == 2 && step(&new, 41, 3) == SM_OK && number_at(AT_OUT) == 7 && number_at(AT_MORE) == 3);
    CHECK(machine_start(&new, NULL, 1) == SM_OK);
    smvm_write_state(new.vm, &new.m, sv.byte);
    CHECK(step(&new, 41, 3) == SM_OK && state_number() == 1 && number_at(AT_OUT) == 1 && number_at(AT_MORE) == 0 && sv.byte[AT_FIRED] == 1);
    free_both(&old, &new);
}

static void test_states(void)
{
    SwapMachine old, new;

    // clause 12.7: a state is found by its name; its number may change
    compile_both(&old, &new, ELEMENTS "[A]\n.step\n-> B\n[B]\n.step\n-> Gone\n[Gone]\n", ELEMENTS "[New]\n[B]\n[A]\n.step\nout = 5\n");
    SmResult result;
    SmvmSwap *plan = machine_plan(&old, &new, &result);
    CHECK(smvm_swap_state(plan, 1) == 3 && smvm_swap_state(plan, 2) == 2 && smvm_swap_state(plan, 3) == 0);
    CHECK(smvm_swap_state(plan, 0) == 0 && smvm_swap_state(plan, 4) == 0);
    free(plan);
    run(&old, 0);
    CHECK(swap(&old, &new) == SM_OK && smvm_state(new.vm) == 3 && state_number() == 3);
    run(&old, 2);
    CHECK(smvm_state(old.vm) == 3 && state_number() == 2);
    plan = machine_plan(&old, &new, &result);
    CHECK(machine_start(&new, NULL, 1) == SM_OK);
    uint8_t *before = malloc(new.ram), sv_before[64];
    memcpy(before, new.vm, new.ram);
    memcpy(sv_before, sv.byte, 64);
    CHECK(smvm_swap_continue(plan, old.vm, new.vm, sv.byte) == SM_E_ARGUMENT);  // the new machine has no state [Gone]: nothing has changed
    CHECK(memcmp(before, new.vm, new.ram) == 0 && memcmp(sv_before, sv.byte, 64) == 0);
    free(before);
    free(plan);
    CHECK(fate_of(&old, &new, SMVM_SWAP_STATE, "Gone") == SMVM_SWAP_REMOVED && fate_of(&old, &new, SMVM_SWAP_STATE, "New") == SMVM_SWAP_ADDED);
    CHECK(fate_of(&old, &new, SMVM_SWAP_STATE, "A") == SMVM_SWAP_KEPT);
    free_both(&old, &new);
}

static void test_time(void)
{
    SwapMachine old, new;

    // clause 12.8
    compile_both(&old, &new, COUNTER, ELEMENTS "[A]\n.step\nmore = T + 0.5\n");
    run(&old, 3);
    CHECK(smvm_time(old.vm) == 20 && swap(&old, &new) == SM_OK && smvm_time(new.vm) == 20);
    CHECK(step(&new, 30, 0) == SM_REFUSED && step(&new, 29, 0) == SM_REFUSED);
    CHECK(step(&new, 31, 0) == SM_OK && number_at(AT_MORE) == 21.5);
    free_both(&old, &new);
}

#define CHARGE(n) ELEMENTS "[Wait]\n.step\np > 2: -> Fire\n[Fire]\n.entry\nfired = true\nout = out + " #n "\n.step\nmore = T\n"

static void test_first_step(void)
{
    SwapMachine old, new;

    // clause 12.9: .entry has run and does not run again
    compile_both(&old, &new, CHARGE(1), CHARGE(100));
    run(&old, 5);
    CHECK(number_at(AT_OUT) == 1 && swap(&old, &new) == SM_OK && step(&new, 60, 0) == SM_OK && number_at(AT_OUT) == 1);
    // The transition has been made, but .entry has not run.  The .entry of the new machine then runs, once.
    run(&old, 3);
    CHECK(smvm_state(old.vm) == 2 && number_at(AT_OUT) == 0 && swap(&old, &new) == SM_OK && state_number() == 2);
    CHECK(step(&new, 40, 0) == SM_OK && number_at(AT_OUT) == 100 && number_at(AT_MORE) == 0);
    CHECK(step(&new, 50, 0) == SM_OK && number_at(AT_OUT) == 100 && number_at(AT_MORE) == 10);
    free_both(&old, &new);
}

// ---- locals, samples ----

static void test_locals(void)
{
    SwapMachine old, new;

    // clause 12.10.  `kept` is never assigned by the new machine, and `guess` is never above 1 there: neither is assumed (clause 12.16).
    compile_both(&old, &new,
                 ELEMENTS "[local]\nU16 kept = 1\nU16 typed = 1\nU16 named = 1\nU16 limit = 800 @read_only\nU8 guess = 0\nU16 was = 3 @read_only\n[A]\n"
                          ".step\nkept = kept + 1\ntyped = typed + 1\nnamed = named + 1\nguess = guess + 1\nout = limit + was\n",
                 ELEMENTS "[local]\nU16 renamed = 7\nU16 limit = 900 @read_only\nU32 typed = 9\nU8 guess = 0\nU16 was = 4\nU16 kept = 1\n[A]\n"
                          ".step\nout = kept * 10000 + limit\nmore = typed * 100 + renamed * 10 + was\nguess > 1: fired = true\nguess = 1\n");
    run(&old, 4);
    CHECK(number_at(AT_OUT) == 803 && swap(&old, &new) == SM_OK);
    CHECK(step(&new, 50, 0) == SM_OK && number_at(AT_OUT) == 50900 && number_at(AT_MORE) == 974 && sv.byte[AT_FIRED] == 1);
    // clause 12.17
    CHECK(fate_of(&old, &new, SMVM_SWAP_LOCAL, "kept") == SMVM_SWAP_KEPT && fate_of(&old, &new, SMVM_SWAP_LOCAL, "typed") == SMVM_SWAP_CHANGED);
    CHECK(fate_of(&old, &new, SMVM_SWAP_LOCAL, "named") == SMVM_SWAP_REMOVED && fate_of(&old, &new, SMVM_SWAP_LOCAL, "renamed") == SMVM_SWAP_ADDED);
    CHECK(fate_of(&old, &new, SMVM_SWAP_LOCAL, "limit") == 99 && fate_of(&old, &new, SMVM_SWAP_LOCAL, "was") == SMVM_SWAP_ADDED);
    free_both(&old, &new);
    // A local that the old machine always stores before it reads it is also transferred: it has its value between steps.
    compile_both(&old, &new, ELEMENTS "[local]\nF64 last = 0\n[A]\n.step\nlast = p * 2\nout = last\n", ELEMENTS "[local]\nF64 last = 0\n[A]\n.step\nout = last\nlast = p\n");
    run(&old, 3);
    CHECK(swap(&old, &new) == SM_OK && step(&new, 40, 1) == SM_OK && number_at(AT_OUT) == 6);
    free_both(&old, &new);
}

// Returns the fate of the window `name` in a swap between two machines of one statement each.
static unsigned sample_fate(const char *old_text, const char *new_text, const char *name)
{
    SwapMachine old, new;
    unsigned fate;

    compile_both(&old, &new, old_text, new_text);
    fate = fate_of(&old, &new, SMVM_SWAP_SAMPLE, name);
    free_both(&old, &new);
    return fate;
}

// The old machine of a swap in which states get other numbers: B has number 2.
#define TWO_STATES(text) ELEMENTS "[A]\n.step\nout = " text "\np > 2: -> B\n[B]\n"
// The new machine: C has number 2, and B number 3.
#define THREE_STATES(text) ELEMENTS "[A]\n.step\nout = " text "\np > 2: -> C\n[C]\n.step\np > 3: -> B\n[B]\n"

// clause 12.11: a state is named, because its number may differ.
static void test_sample_names_of_states(void)
{
    CHECK(sample_fate(TWO_STATES("roll_avg(S == B, 4)"), THREE_STATES("roll_avg(S == B, 4)"), "roll(S == [B], 4)") == SMVM_SWAP_KEPT);
    CHECK(sample_fate(TWO_STATES("roll_avg(S == B, 4)"), THREE_STATES("roll_avg(S == C, 4)"), "roll(S == [C], 4)") == SMVM_SWAP_ADDED);
    CHECK(sample_fate(TWO_STATES("roll_avg(B != S, 4)"), THREE_STATES("roll_avg(B != S, 4)"), "roll([B] != S, 4)") == SMVM_SWAP_KEPT);
    CHECK(sample_fate(TWO_STATES("roll_avg(S == 2, 4)"), THREE_STATES("roll_avg(S == 2, 4)"), "roll(S == 2, 4)") == SMVM_SWAP_KEPT);
    CHECK(sample_fate(TWO_STATES("held(p > 2 and S == B, 40 ms)"), THREE_STATES("held(p > 2 and S == B, 40 ms)"),
                      "run(not (not ((p > 2) and (S == [B]))), 1)") == SMVM_SWAP_KEPT);
}

static void test_sample_names(void)
{
#define ONE(locals, text) ELEMENTS "[local]\nU8 unused = 0\n" locals "[A]\n.step\nout = " text "\n"
    // clause 12.11
    CHECK(sample_fate(ONE("", "roll_avg(p + 1, 10)"), ONE("", "roll_max(p + 1, 10) + roll_avg(p, 10)"), "roll(p + 1, 10)") == SMVM_SWAP_KEPT);
    CHECK(sample_fate(ONE("", "roll_avg(p, 10)"), ONE("", "roll_avg(p, 11)"), "roll(p, 11)") == SMVM_SWAP_ADDED);
    CHECK(sample_fate(ONE("", "roll_avg(p, 10)"), ONE("", "roll_avg(p, 11)"), "roll(p, 10)") == SMVM_SWAP_REMOVED);
    CHECK(sample_fate(ONE("U8 k = 4 @read_only\n", "roll_avg(p * k, 2 + k)"), ONE("F64 q = 4 @read_only\n", "roll_avg(p * q, 6)"), "roll(p * 4, 6)") == SMVM_SWAP_KEPT);
    CHECK(sample_fate(ONE("U8 k = 4 @read_only\n", "roll_avg(p * k, 6)"), ONE("U8 k = 5 @read_only\n", "roll_avg(p * k, 6)"), "roll(p * 5, 6)") == SMVM_SWAP_ADDED);
    CHECK(sample_fate(ONE("U8 k = 4\n", "roll_avg(p * k, 6)"), ONE("U8 k = 5\n", "roll_avg(p * k, 6)"), "roll(p * U8 k, 6)") == SMVM_SWAP_KEPT);
    CHECK(sample_fate(ONE("U8 k = 4\n", "roll_avg(p * k, 6)"), ONE("U16 k = 4\n", "roll_avg(p * k, 6)"), "roll(p * U16 k, 6)") == SMVM_SWAP_ADDED);
    CHECK(sample_fate(ONE("", "roll_avg((p - out) - more, 6)"), ONE("", "roll_avg(p - (out - more), 6)"), "roll(p - (out - more), 6)") == SMVM_SWAP_ADDED);
    CHECK(sample_fate(ONE("", "roll_avg(p - out - more, 6)"), ONE("", "roll_avg((p - out) - more, 6)"), "roll((p - out) - more, 6)") == SMVM_SWAP_KEPT);
    CHECK(sample_fate(ONE("", "roll_avg(roll_min(p, 3) < p <= 2, 4)"), ONE("", "roll_avg(roll_max(p, 3) < p <= 2, 4)"), "roll(roll_max(p, 3) < p <= 2, 4)") == SMVM_SWAP_ADDED);
    CHECK(sample_fate(ONE("", "roll_avg(not p, 4)"), ONE("", "roll_avg(!p, 4)"), "roll(not p, 4)") == SMVM_SWAP_KEPT);
    CHECK(sample_fate(ONE("", "roll_avg(-p + 3 / 0 - 1 / 4, 4)"), ONE("", "roll_avg(-p + 1 / 0 - 0.25, 4)"), "roll(((-p) + 1/0) - 0.25, 4)") == SMVM_SWAP_KEPT);
    CHECK(sample_fate(ONE("", "roll_avg(p + -0.0, 4)"), ONE("", "roll_avg(p + 0, 4)"), "roll(p + 0, 4)") == SMVM_SWAP_ADDED);
    CHECK(sample_fate(ONE("", "roll_avg(clamp(p, 1, T), 4)"), ONE("", "roll_avg(clamp(p, 1, T), 4)"), "roll(clamp(p, 1, T), 4)") == SMVM_SWAP_KEPT);
    CHECK(sample_fate(ONE("", "roll_avg(p == 0.1, 4)"), ONE("", "roll_avg(p == 1e-1, 4)"), "roll(p == 0.1, 4)") == SMVM_SWAP_KEPT);
    CHECK(sample_fate("[state_vector]\nU64 G\nU32 S\nF64 p @alias q\nF64 out\nF64 more\nbool fired\n[A]\n.step\nout = roll_avg(q, 3)\n", ONE("", "roll_avg(p, 3)"),
                      "roll(p, 3)") == SMVM_SWAP_KEPT);
}

// Checks that samples survive a swap at step `at`: the statistics equal those of the new machine running alone from the start.
static void check_samples(const char *old_text, const char *new_text, uint32_t at)
{
    SwapMachine old, new, alone;
    double swapped[40];

    machine_compile(&alone, new_text, NULL, 2, true);
    compile_both(&old, &new, old_text, new_text);
    run(&old, at);
    CHECK(swap(&old, &new) == SM_OK);
    for (uint32_t k = at + 1; k <= 39; k++) {
        CHECK(step(&new, 10 * k, k) == SM_OK);
        swapped[k] = number_at(AT_OUT);
    }
    run(&alone, at);
    for (uint32_t k = at + 1; k <= 39; k++) {
        CHECK(step(&alone, 10 * k, k) == SM_OK && number_at(AT_OUT) == swapped[k]);
    }
    free_both(&old, &new);
    machine_free(&alone);
}

static void test_samples(void)
{
    static const char *const statistic[] = {"roll_avg(p / 3, 7)", "roll_median(p / 3, 7)", "roll_min(p / 3, 7)", "roll_max(p / 3, 7)", "roll_range(p / 3, 7)",
                                            "roll_avg(p / 3, 70)", "roll_median(p / 3, 70)", "roll_min(p / 3, 70)", "roll_avg(p > 7, 7)"};
    char old_text[400], new_text[400];

    // clause 12.13: before the window is full, and when it has wrapped
    for (size_t i = 0; i < sizeof statistic / sizeof *statistic; i++)
        for (size_t k = 0; k < sizeof statistic / sizeof *statistic; k++)
            for (uint32_t at = 0; at < 38; at += i == k ? 1 : 5) {
                // clause 12.14: a window of the same name keeps its samples even if its expression is spelled in another way
                snprintf(old_text, sizeof old_text, ELEMENTS "[local]\nU8 n = 0\n[A]\n.step\nout = %s\n", statistic[k]);
                snprintf(new_text, sizeof new_text, ELEMENTS "[local]\nF64 c = 3 @read_only\nF64 n = 0\n[A]\n.step\nout = %s + roll_avg(p / c, 7) * 0\n", statistic[i]);
                if ((k < 5) == (i < 5) && (k < 5 || i == k))
                    check_samples(old_text, new_text, at);
            }
}

#define STEP "[options]\nstep 10 ms\n" ELEMENTS

// clause 12.59: what held, prev, rising, falling, rate and windows in time keep.
static void test_functions_that_remember(void)
{
    static const char *const same[][2] = {
        {"held(p > 20, 50 ms)", "held(p > 20, 50 ms)"}, {"held(p > 20, 50 ms)", "held(p > 20, 80 ms)"}, {"held(p > 20, 5 steps)", "held(p > 20, 5 steps)"}, {"prev(p / 3)", "prev(p / 3)"}, {"prev(p / 3)", "rising(p / 3) + prev(p / 3)"}, {"rising(p > 20)", "rising(p > 20)"},
        {"rising(p > 20)", "falling(p > 20)"}, {"rate(p * p, 70 ms)", "rate(p * p, 8 steps)"}, {"roll_avg(p / 3, 60 ms)", "roll_max(p / 3, 7)"}};
    char old_text[400], new_text[400];

    for (size_t i = 0; i < sizeof same / sizeof *same; i++)
        for (uint32_t at = 1; at < 38; at += 3) {
            snprintf(old_text, sizeof old_text, STEP "[A]\n.step\nout = %s\n", same[i][0]);
            snprintf(new_text, sizeof new_text, STEP "[A]\n.step\nout = %s\n", same[i][1]);
            check_samples(old_text, new_text, at);
        }
#define STEPPED(text) STEP "[A]\n.step\nout = " text "\n"
    CHECK(sample_fate(STEPPED("held(p > 20, 50 ms)"), STEPPED("held(p > 20, 80 ms)"), "run(not (not (p > 20)), 1)") == SMVM_SWAP_KEPT);
    CHECK(sample_fate(STEPPED("held(p > 20, 50 ms)"), STEPPED("held(p > 21, 50 ms)"), "run(not (not (p > 21)), 1)") == SMVM_SWAP_ADDED);
    CHECK(sample_fate(STEPPED("held(p > 20, 5 steps)"), STEPPED("held(p > 20, 6 steps)"), "run(not (not (p > 20)), 6)") == SMVM_SWAP_ADDED);
    CHECK(sample_fate(STEPPED("held(p > 20, 5 steps)"), STEPPED("roll_min(not not (p > 20), 5)"), "roll(not (not (p > 20)), 5)") == SMVM_SWAP_ADDED);
    CHECK(sample_fate(STEPPED("rate(p, 70 ms)"), STEPPED("rate(p, 8 steps) + roll_avg(p, 70 ms)"), "roll(p, 8)") == SMVM_SWAP_KEPT);
    CHECK(sample_fate(STEPPED("rate(p, 70 ms)"), STEPPED("rate(p, 8 steps)"), "times(1, 8)") == SMVM_SWAP_KEPT);
    CHECK(sample_fate(STEPPED("roll_avg(p, 70 ms)"), STEPPED("rate(p, 70 ms)"), "times(1, 8)") == SMVM_SWAP_ADDED);
    CHECK(sample_fate(STEPPED("prev(p)"), STEPPED("roll_avg(p, 2)"), "roll(p, 2)") == SMVM_SWAP_KEPT);
}

static void test_removed_window(void)
{
    SwapMachine old, new;
    char text[5000] = ELEMENTS "[A]\n.step\nout = roll_max(p";

    // clause 12.12
    for (int i = 0; i < 300; i++)
        strcat(text, " + more");
    CHECK(sample_fate(COUNTER, ONE("", "roll_avg(p, 3)"), "roll(p, 3)") == SMVM_SWAP_ADDED);
    strcat(text, ", 5)\n");
    compile_both(&old, &new, text, text);
    run(&old, 3);
    CHECK(number_at(AT_OUT) == 3 && swap(&old, &new) == SM_OK && step(&new, 40, 1) == SM_OK && number_at(AT_OUT) == 1);
    free_both(&old, &new);
    CHECK(sample_fate(ELEMENTS "[A]\n.step\n1 > 2: out = roll_max(p, 3)\n", ONE("", "roll_max(p, 3)"), "roll(p, 3)") == SMVM_SWAP_ADDED);
}

static void test_outputs(void)
{
    SwapMachine old, new;

    // clause 12.15
    compile_both(&old, &new, COUNTER, COUNTER);
    run(&old, 1);
    CHECK(smvm_stored(old.vm, 0) && smvm_stored_state(old.vm) && swap(&old, &new) == SM_OK);
    for (uint32_t i = 0; i < new.m.outputs; i++)
        CHECK(!smvm_stored(new.vm, i));
    CHECK(!smvm_stored_state(new.vm) && step(&new, 20, 0) == SM_OK && !smvm_stored_state(new.vm));
    free_both(&old, &new);
}

// ---- names ----

static void test_no_names(void)
{
    SwapMachine old, new;

    // clause 12.16
    machine_compile(&old, COUNTER, NULL, 2, false);
    machine_compile(&new, COUNTER, NULL, 2, true);
    run(&old, 2);
    CHECK(swap(&old, &new) == SM_E_UNSUPPORTED && swap(&new, &old) == SM_E_UNSUPPORTED);
    CHECK(machine_start(&new, NULL, 1) == SM_OK && step(&new, 30, 0) == SM_OK && number_at(AT_OUT) == 1);
    free_both(&old, &new);
}

static void test_arguments(void)
{
    SwapMachine old, new, third;
    SmResult result;
    uint64_t small[2];

    compile_both(&old, &new, COUNTER, COUNTER);
    machine_compile(&third, COUNTER, NULL, 2, true);
    run(&old, 1);
    CHECK(machine_start(&new, NULL, 1) == SM_OK && machine_start(&third, NULL, 1) == SM_OK);
    const uint32_t size = smvm_swap_size(&old.m, &new.m);
    uint8_t *memory = malloc(size + 8);
    CHECK(smvm_swap_plan((SmvmSwap *)(void *)small, sizeof small, &old.m, &new.m) == SM_E_MEMORY);
    CHECK(smvm_swap_plan((SmvmSwap *)(void *)memory, size - 1, &old.m, &new.m) == SM_E_MEMORY);
    CHECK(smvm_swap_plan((SmvmSwap *)(void *)(memory + 1), size, &old.m, &new.m) == SM_E_ALIGNMENT);
    free(memory);
    SmvmSwap *plan = machine_plan(&old, &new, &result);
    CHECK(smvm_swap_continue(plan, old.vm, third.vm, sv.byte) == SM_E_ARGUMENT && smvm_swap_continue(plan, third.vm, new.vm, sv.byte) == SM_E_ARGUMENT);
    CHECK(smvm_swap_continue(plan, old.vm, new.vm, sv.byte) == SM_OK);
    free(plan);
    machine_free(&third);
    free_both(&old, &new);
}

static void test_back(void)
{
    SwapMachine old, new;

    // clause 12.20
    compile_both(&old, &new, COUNTER, ELEMENTS "[local]\nU16 n = 0\n[A] @swap\n.step\nn = n + 10\n");
    run(&old, 3);
    CHECK(swap(&old, &new) == SM_OK && step(&new, 40, 0) == SM_OK && step(&new, 50, 0) == SM_OK);
    CHECK(swap(&new, &old) == SM_OK && step(&old, 60, 0) == SM_OK && number_at(AT_OUT) == 24 && number_at(AT_MORE) == 50);
    free_both(&old, &new);
}

int main(void)
{
    test_boundary();
    test_layout();
    test_parameters();
    test_marks();
    test_restart();
    test_states();
    test_time();
    test_first_step();
    test_locals();
    test_sample_names();
    test_sample_names_of_states();
    test_samples();
    test_functions_that_remember();
    test_removed_window();
    test_outputs();
    test_no_names();
    test_arguments();
    test_back();
    return test_end("swap/clauses");
}
