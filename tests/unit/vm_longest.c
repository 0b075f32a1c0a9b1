// SPDX-License-Identifier: Apache-2.0
// The longest step, which the verifier computes from the code.  For random functions it is found once more by trying every path.
#include "tests/unit/vm_good.h"

static uint32_t longest_step_of(Build *b)
{
    SmvmVerdict v;

    close_step(b);
    memcpy(b->code + b->end[3], (const uint8_t[]){SMVM_end, SMVM_end, SMVM_end}, 3);            // the other state: 1, 1, 1
    b->size = b->end[3] + 3;
    b->end[4] = b->end[3] + 1;
    b->end[5] = b->end[3] + 2;
    b->end[6] = b->end[3] + 3;
    CHECK(verify(b, &v) == 0);
    return v.longest - 5;                             // without the sample function
}

static void test_longest_step_is_exact(void)
{
    Build b;

    open_step(&b);                                    // 4 and a jump on one side, 1 on the other, 2 before and 1 after
    code(&b, SMVM_ldx_time, 0);
    code(&b, SMVM_jt, 1, 2 + 4);
    for (unsigned i = 0; i < 4; i++)
        code(&b, SMVM_ldx_time, 0);
    code(&b, SMVM_jmp, 1, 1);
    code(&b, SMVM_ldx_time, 0);
    code(&b, SMVM_end, 0);
    CHECK(longest_step_of(&b) == 2 + 4 + 1 + 1);
    open_step(&b);                                    // unreachable code has no cost
    code(&b, SMVM_jmp, 1, 3);
    for (unsigned i = 0; i < 3; i++)
        code(&b, SMVM_ldx_time, 0);
    code(&b, SMVM_end, 0);
    CHECK(longest_step_of(&b) == 2);
}

// n conditions each jump to a separate `end` after 96 loads, the first condition to the last `end`.  While the verifier can follow all n jumps,
// the longest path passes all conditions.  Beyond that limit the verifier adds the costs of all code.
static void test_longest_step_of_many_jumps(void)
{
    enum { LOADS = 96, MOST = SMVM_JOINS + 20 };

    for (unsigned n = 1; n < MOST; n++) {
        uint32_t counted;
        Build b;
        open_step(&b);
        code(&b, SMVM_ldx_time, 0);
        for (unsigned i = 0; i < n; i++)
            code(&b, SMVM_jt, 1, 3 * (n - 1 - i) + LOADS + n - i);
        for (unsigned i = 0; i < LOADS; i++)
            code(&b, SMVM_ldx_time, 0);
        for (unsigned i = 0; i <= n; i++)
            code(&b, SMVM_end, 0);
        b.width = 2;
        counted = longest_step_of(&b);
        CHECK(n <= SMVM_JOINS ? counted == 1 + n + LOADS + 1 : counted == 1 + n + LOADS + n + 1);
    }
}

// ---- the longest step of random functions, found by trying every path ----

// `to`: the target of a jump; jt represents a load and a jump.
typedef struct Random { uint8_t op; unsigned to; } Random;

static uint64_t seed = 1;

static unsigned random_below(unsigned n)
{
    seed ^= seed << 13;
    seed ^= seed >> 7;
    seed ^= seed << 17;
    return (unsigned)(seed >> 20) % n;
}

// Returns the length of the longest path from instruction i that ends in `last`; 0 if no path does.
static unsigned measure_longest_path(const Random *r, unsigned i, uint8_t last)
{
    unsigned next, jump;

    if (r[i].op == SMVM_end || r[i].op == SMVM_goto)
        return r[i].op == last;
    if (r[i].op == SMVM_ldx_time) {
        next = measure_longest_path(r, i + 1, last);
        return next ? next + 1 : 0;
    }
    jump = measure_longest_path(r, r[i].to, last);
    next = r[i].op == SMVM_jmp ? 0 : measure_longest_path(r, i + 1, last);
    next = next > jump ? next : jump;
    return next ? next + (r[i].op == SMVM_jt ? 2 : 1) : 0;
}

static unsigned make_random_function(Random *r, bool may_go)
{
    unsigned n = 1 + random_below(14);

    for (unsigned i = 0; i < n; i++) {
        unsigned k = random_below(10);
        bool last = i + 1 == n;
        r[i].op = last || k == 0 ? (may_go && random_below(2) ? SMVM_goto : SMVM_end) : k < 3 ? SMVM_jmp : k < 7 ? SMVM_jt : SMVM_ldx_time;
        r[i].to = last ? 0 : i + 1 + random_below(n - i - 1);
    }
    return n;
}

static void put_random(Build *b, const Random *r, unsigned n)
{
    unsigned at[15] = {0};

    for (unsigned i = 0; i < n; i++)
        at[i + 1] = at[i] + (r[i].op == SMVM_jt ? 3 : r[i].op == SMVM_goto || r[i].op == SMVM_jmp ? 2 : 1);
    for (unsigned i = 0; i < n; i++) {
        if (r[i].op == SMVM_jt)
            code(b, SMVM_ldx_time, 0);
        if (r[i].op == SMVM_end || r[i].op == SMVM_ldx_time)
            code(b, r[i].op, 0);
        else
            code(b, r[i].op, 1, r[i].op == SMVM_goto ? 1 : at[r[i].to] - at[i + 1]);
    }
    end_function(b);
}

static void test_longest_step_of_random_functions(void)
{
    for (unsigned k = 0; k < 3000; k++) {
        unsigned ends[3], leaves[3], longest_max = 0;
        SmvmVerdict v;
        Build b;
        put_good_machine(&b);
        for (unsigned f = 0; f < 3; f++) {
            Random r[15];
            unsigned n = make_random_function(r, f < 2);
            put_random(&b, r, n);
            ends[f] = measure_longest_path(r, 0, SMVM_end);
            leaves[f] = measure_longest_path(r, 0, SMVM_goto);
        }
        if (leaves[0])                                                           // every path through a step
            longest_max = leaves[0] + ends[2];
        for (unsigned first = 0; first < 2; first++) {
            unsigned before = first ? ends[0] : 0;
            if (first && !ends[0])
                continue;
            if (ends[1] && before + ends[1] > longest_max)
                longest_max = before + ends[1];
            if (leaves[1] && before + leaves[1] + ends[2] > longest_max)
                longest_max = before + leaves[1] + ends[2];
        }
        b.states = 1;
        b.width = 2;
        CHECK(verify(&b, &v) == 0 && v.longest == 5 + longest_max);
    }
}

// Without SMVM_LONGEST (bytecode-vm/config.h) the verifier computes no longest step.
static void test_longest_step_is_not_computed(void)
{
    Build b = build_good_machine();
    SmvmVerdict v;

    CHECK(verify(&b, &v) == 0 && v.longest == 0);
}

int main(void)
{
    if (!SMVM_LONGEST) {
        test_longest_step_is_not_computed();
    } else {
        test_longest_step_is_exact();
        test_longest_step_of_many_jumps();
        test_longest_step_of_random_functions();
    }
    return test_end("vm_longest");
}
