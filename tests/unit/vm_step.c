// SPDX-License-Identifier: Apache-2.0
// Steps of the interpreter: the rules of language.md 6, windows, and the memory and the start of a machine, on images built by hand.
#include <math.h>

#include "tests/unit/vm_machine.h"

// ---- the step: two states whose functions write down that they ran ----

// Each function does OUT = 10 * OUT + n.  The entry function of state 1 goes to state 2 if X, its step function goes to 2 if Y.  State 2 goes to
// itself if Y.
static void put_trace(Build *b, unsigned digit, unsigned condition, unsigned target)
{
    typed(b, SMVM_ldx_elem, SM_F64, 16);
    code(b, SMVM_ldy_plus, 1, 10);
    code(b, SMVM_mul, 0);
    code(b, SMVM_addi, 1, digit);
    put_out(b);
    if (target != 0) {
        typed(b, SMVM_ldx_elem, SM_F64, condition);
        code(b, SMVM_jf, 1, 2);
        code(b, SMVM_goto, 1, target);
    }
    code(b, SMVM_end, 0);
    end_function(b);
}

static void start_two_states(Machine *t)
{
    Build b;

    begin(&b);
    b.states = 2;
    end_function(&b);
    put_trace(&b, 1, IN_X, 2);
    put_trace(&b, 2, IN_Y, 2);
    put_trace(&b, 3, 0, 0);
    put_trace(&b, 4, 0, 0);
    put_trace(&b, 5, IN_Y, 2);
    put_trace(&b, 6, 0, 0);
    CHECK(open_machine(t, &b, 1));
}

static double step(Machine *t, uint64_t g, double x, double y)
{
    set_f64(t, 16, 0);
    set_f64(t, 32, x);
    set_f64(t, 40, y);
    t->sv[0] = g;
    CHECK(smvm_step((SmVm *)t->memory, t->sv) == SM_OK);
    return f64_at(t, 16);
}

static void test_steps_follow_transitions(void)
{
    Machine t;
    SmVm *vm = (SmVm *)t.memory;

    start_two_states(&t);
    CHECK(smvm_state(vm) == 1 && smvm_time(vm) == 0 && s_of(&t) == 1);
    set_s(&t, 99);
    CHECK(step(&t, 7, 0, 0) == 12);                   // entry, step
    CHECK(s_of(&t) == 1 && smvm_stored_state(vm) && smvm_time(vm) == 0);
    set_s(&t, 99);
    CHECK(step(&t, 10, 1, 0) == 2 && smvm_time(vm) == 3);            // not the first step: no entry
    CHECK(s_of(&t) == 99 && !smvm_stored_state(vm));        // other code has written S: it is not changed, and has no effect on the state
    CHECK(step(&t, 12, 0, 1) == 23);                  // the step function makes a transition, then exit
    CHECK(smvm_state(vm) == 2 && smvm_time(vm) == 5 && s_of(&t) == 99);
    CHECK(step(&t, 20, 0, 1) == 456 && smvm_time(vm) == 0 && s_of(&t) == 2);    // a transition to itself: exit…
    CHECK(smvm_state(vm) == 2);
    CHECK(step(&t, 21, 0, 0) == 45 && smvm_time(vm) == 0);           // …and then a first step again
    start_two_states(&t);
    CHECK(step(&t, 0, 1, 1) == 13 && smvm_state(vm) == 2);           // the entry function makes a transition: no step function; G may be 0
    CHECK(init(&t, t.memory, sizeof t.memory, t.sv, 2) == SM_OK && s_of(&t) == 2);
    CHECK(step(&t, 0, 0, 0) == 45);
}

// A refused step writes neither the vector nor the memory of the VM.
static void test_refused_step_changes_nothing(void)
{
    Machine t;
    SmVm *vm = (SmVm *)t.memory;
    uint64_t before[8], memory[200];

    start_two_states(&t);
    step(&t, 7, 0, 0);
    for (unsigned i = 0; i < 3; i++) {
        t.sv[0] = ((const uint64_t[]){7, 6, UINT64_MAX})[i];
        set_f64(&t, 40, 1);
        memcpy(before, t.sv, sizeof before);
        memcpy(memory, t.memory, sizeof memory);
        CHECK(smvm_step(vm, t.sv) == SM_REFUSED);
        CHECK(memcmp(before, t.sv, sizeof before) == 0 && memcmp(memory, t.memory, sizeof memory) == 0);
    }
    CHECK(step(&t, UINT64_MAX - 1, 0, 0) == 2 && smvm_time(vm) == UINT64_MAX - 8);
    start_two_states(&t);
    t.sv[0] = UINT64_MAX;
    CHECK(smvm_step(vm, t.sv) == SM_REFUSED);
}

// smvm_stored does not report a store of an earlier step.  The step ends by a jump over two bytes.
static void test_stores_are_of_the_last_step(void)
{
    Machine t;
    SmVm *vm = (SmVm *)t.memory;
    Build b;

    begin(&b);
    end_function(&b);
    end_function(&b);
    code(&b, SMVM_ldx_time, 0);
    code(&b, SMVM_jt, 1, 4 * 50);
    for (int i = 0; i < 50; i++) {
        code(&b, SMVM_ldx_plus, 1, 7);
        put_out(&b);
    }
    code(&b, SMVM_end, 0);
    end_function(&b);
    end_function(&b);
    CHECK(open_machine(&t, &b, 1));
    CHECK(smvm_step(vm, t.sv) == SM_OK && smvm_stored(vm, 0));
    set_f64(&t, 16, 3);
    t.sv[0] = 1;
    CHECK(smvm_step(vm, t.sv) == SM_OK && !smvm_stored(vm, 0) && !smvm_stored(vm, 1) && f64_at(&t, 16) == 3);
}

// Samples 4, 1, 3, 2 enter a window of three; the statistic is read after each.
static void test_windows_compute_statistics(void)
{
    static const double in[] = {4, 1, 3, 2};
    static const double expected[][4] = {{4, 2.5, 8.0 / 3, 2}, {4, 2.5, 3, 2}, {4, 1, 1, 1}, {4, 4, 4, 3}, {0, 3, 3, 2}, {4, 4, 4, 1}, {4, 1, 3, 2}, {0, -3, -1, 1}};

    for (unsigned s = 0; s < sizeof expected / sizeof *expected; s++) {
        Machine t;
        Build b;
        begin(&b);
        b.windows = 1;
        b.window[0] = WINDOW(3, 1u << s);
        load_x(&b);
        code(&b, SMVM_sample, 1, 0);
        code(&b, SMVM_end, 0);
        end_function(&b);
        end_function(&b);
        code(&b, SMVM_stat, 2, s, 0);
        put_out(&b);
        code(&b, SMVM_end, 0);
        end_function(&b);
        end_function(&b);
        CHECK(open_machine(&t, &b, 1));
        for (unsigned i = 0; i < 4; i++) {
            t.sv[0] = i + 1;
            set_f64(&t, 32, in[i]);
            CHECK(smvm_step((SmVm *)t.memory, t.sv) == SM_OK && f64_at(&t, 16) == expected[s][i]);
        }
    }
}

// A sample is converted to the type of its window, as by a store.  The windows have one sample.
static void test_samples_are_converted(void)
{
    static const struct { SmType type; double in, out; } row[] = {
        {SM_I8, 300, 127}, {SM_I8, -2.9, -2}, {SM_U8, -1, 0}, {SM_I16, -1e9, -32768}, {SM_U16, 65535.5, 65535}, {SM_I32, 1e300, 2147483647},
        {SM_U32, 4294967295, 4294967295}, {SM_F32, 1e300, INFINITY}, {SM_F32, 0.1, 0x1.99999ap-4}, {SM_F32, -0.0, -0.0}, {SM_BOOL, -7, 1},
        {SM_F64, 0.1, 0.1}
    };

    for (unsigned i = 0; i < sizeof row / sizeof *row; i++) {
        Machine t;
        Build b;
        begin(&b);
        b.windows = 1;
        b.window[0] = WINDOW_OF(row[i].type, 1, 1u << SM_STAT_MAX);
        load_x(&b);
        code(&b, SMVM_sample, 1, 0);
        code(&b, SMVM_end, 0);
        end_function(&b);
        end_function(&b);
        code(&b, SMVM_stat, 2, SM_STAT_MAX, 0);
        put_out(&b);
        code(&b, SMVM_end, 0);
        end_function(&b);
        end_function(&b);
        CHECK(open_machine(&t, &b, 1));
        t.sv[0] = 1;
        set_f64(&t, 32, row[i].in);
        CHECK(smvm_step((SmVm *)t.memory, t.sv) == SM_OK && same(f64_at(&t, 16), row[i].out));
    }
}

// ---- memory ----

static uint32_t round_up_to_8(size_t n) { return (uint32_t)((n + 7) / 8 * 8); }

static void test_ram_size_is_exact(void)
{
    Machine t;
    Build b;

    begin(&b);
    b.windows = 2;
    b.window[0] = WINDOW(3, 1u << SM_STAT_AVG);
    b.window[1] = WINDOW(5, 1u << SM_STAT_MEDIAN);
    load_x(&b);
    code(&b, SMVM_sample, 1, 0);
    code(&b, SMVM_sample, 1, 1);
    code(&b, SMVM_end, 0);
    for (int i = 0; i < 4; i++)
        end_function(&b);
    CHECK(open_machine(&t, &b, 1));
    CHECK(smvm_ram_size(&t.m) == round_up_to_8(sizeof(SmVm)) + round_up_to_8(2 * sizeof(uint64_t *)) + 8 * (1 + 3) + 8 * (1 + 2 * 5) + 16);
}

static void test_init_checks_memory(void)
{
    Machine t;
    Build b;
    uint8_t *odd = (uint8_t *)t.memory + 1;
    uint32_t need;

    begin(&b);
    b.init_size = 3 + 1 + 3 + 4;
    memcpy(b.init, (const uint8_t[]){0, 0, SM_U8, 200, 1, 0, SM_F32, 0, 0, 0x80, 0x3e}, 11);
    typed(&b, SMVM_ldx_local, SM_U8, LOCAL_U8);
    typed(&b, SMVM_ldy_local, SM_F32, LOCAL_F32);
    code(&b, SMVM_add, 0);
    put_out(&b);
    CHECK(run(&t, &b, 0, 0) && f64_at(&t, 16) == 200.25);
    need = smvm_ram_size(&t.m);
    CHECK(init(&t, t.memory, need, t.sv, 1) == SM_OK);
    CHECK(init(&t, t.memory, need - 1, t.sv, 1) == SM_E_MEMORY);
    CHECK(init(&t, odd, sizeof t.memory - 8, t.sv, 1) == SM_E_ALIGNMENT);
    CHECK(init(&t, t.memory, need, (uint8_t *)t.sv + 2, 1) == SM_E_ALIGNMENT);
    CHECK(init(&t, t.memory, need, t.sv, 0) == SM_E_ARGUMENT);
    CHECK(init(&t, t.memory, need, t.sv, 2) == SM_E_ARGUMENT);
    CHECK(smvm_init(t.memory, need, &t.m, &(SmvmVector){t.sv, 64, 1}, 1) == SM_E_LAYOUT);
    CHECK(smvm_init(t.memory, need, &t.m, &(SmvmVector){t.sv, 56, 0}, 1) == SM_E_LAYOUT);
    CHECK(!smvm_machine(t.image, 1, &t.m));
}

int main(void)
{
    test_steps_follow_transitions();
    test_refused_step_changes_nothing();
    test_stores_are_of_the_last_step();
    test_windows_compute_statistics();
    test_samples_are_converted();
    test_ram_size_is_exact();
    test_init_checks_memory();
    return test_end("vm_step");
}
