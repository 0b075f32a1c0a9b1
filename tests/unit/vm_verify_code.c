// SPDX-License-Identifier: Apache-2.0
// The verifier and the code of an image: the ends of functions, opcodes and operands, samples, transitions, jumps, and registers without a
// value.  Each violation must be refused for exactly its rule.
#include "tests/unit/vm_good.h"

static void test_wrong_function_ends_are_refused(void)
{
    Build b = build_good_machine();

    b.end[2]--;                                       // the last instruction before `end`
    REFUSED(&b, FALLS_OUT);
    b = build_good_machine();
    b.end[2] -= 2;                                    // into the middle of an instruction
    REFUSED(&b, TRUNCATED);
    b = build_good_machine();
    b.end[2] = b.end[1] - 1;                          // an end before the start
    REFUSED(&b, FUNCTIONS);
    b = build_good_machine();
    b.end[6] = b.size + 1;                            // after the end of the code
    b.end[5] = b.size;
    REFUSED(&b, FUNCTIONS);
    b = build_good_machine();
    b.end[6] = 255;
    REFUSED(&b, FUNCTIONS);
    b = build_good_machine();
    b.size++;                                         // code outside all functions
    REFUSED(&b, FUNCTIONS);
}

#define STEP_REFUSED(statements, rule)  \
    do {                                \
        Build b;                        \
        open_step(&b);                  \
        statements;                     \
        close_step(&b);                 \
        REFUSED(&b, rule);              \
    } while (0)

static void test_unknown_opcodes_are_refused(void)
{
    for (unsigned op = 0; op < 256; op++) {           // a single byte
        const uint32_t shape = smvm_shape((uint8_t)op);
        if (op == SMVM_end)
            continue;
        if (shape == 0)
            STEP_REFUSED(code(&b, op, 0), OPCODE);
        else if (shape & (SMVM_SHAPE_X | SMVM_SHAPE_Y))
            STEP_REFUSED(code(&b, op, 0), REGISTER);
        else if (shape & SMVM_SHAPE_FOLLOWS)
            STEP_REFUSED(code(&b, op, 0), TRUNCATED);
        else
            STEP_REFUSED(code(&b, op, 0), FALLS_OUT);
    }
}

// Loads the registers, then appends op with these numbers, and `end`.
#define WITH_BOTH(op, n, a, c, rule)                              \
    STEP_REFUSED(put_load_input(&b); typed(&b, SMVM_ldy_elem, SM_F64, IN);    \
                 code(&b, op, n, a, c); code(&b, SMVM_end, 0), rule)

static void test_truncated_instructions_are_refused(void)
{
    STEP_REFUSED(code(&b, SMVM_stat, 1, 0), TRUNCATED);
    STEP_REFUSED(put_load_input(&b); code(&b, SMVM_jxn, 1, 0), TRUNCATED);
    STEP_REFUSED(code(&b, SMVM_ldx_plus, 1, 0x60); b.size--, TRUNCATED);         // a varint of two bytes without its second
    STEP_REFUSED(code(&b, SMVM_goto, 1, 0xc60); b.size--, TRUNCATED);
    STEP_REFUSED(code(&b, SMVM_ldx_plus, 1, 0x60); b.code[b.size - 1] = 0x80; code(&b, SMVM_end, 0), TRUNCATED);
    STEP_REFUSED(code(&b, SMVM_ldx_plus, 1, 0); b.code[b.size - 1] = 0x80; code(&b, SMVM_end, 0), TRUNCATED);
    STEP_REFUSED(code(&b, SMVM_stat, 2, 0, 0); b.code[b.size - 2] = 0xff; code(&b, SMVM_end, 0), TRUNCATED);
    STEP_REFUSED(code(&b, SMVM_jmp, 1, 0); b.code[b.size - 1] = SMVM_end; code(&b, SMVM_end, 0), TRUNCATED);
}

// Of each kind of operand, the last one that exists is accepted, and the next one is refused.
static void test_operands_out_of_range_are_refused(void)
{
    static const uint32_t far[] = {0x60, 0xc60, 0x10000, 0x1000c5f};

    for (unsigned t = 0; t <= SMVM_RAW; t++)
        for (unsigned y = 0; y < 0x40; y += 0x20) {
            const unsigned bytes = t == SMVM_RAW ? 8 : sm_type_info[t].bytes;
            WITH_BOTH(SMVM_ldx_local + y + t, 1, 16 / bytes, 0, OPERAND);
            WITH_BOTH(SMVM_ldx_local + y + t, 1, 16 / bytes - 1, 0, OK);
            if (t < SMVM_RAW) {
                WITH_BOTH(SMVM_ldx_elem + y + t, 1, 40 / bytes, 0, OPERAND);
                WITH_BOTH(SMVM_ldx_elem + y + t, 1, 40 / bytes - 1, 0, OK);
            }
            for (unsigned i = 0; i < 4; i++) {
                WITH_BOTH(SMVM_ldx_local + y + t, 1, far[i], 0, OPERAND);
                if (t < SMVM_RAW)
                    WITH_BOTH(SMVM_ldx_elem + y + t, 1, far[i], 0, OPERAND);
            }
        }
    for (unsigned t = 0; t <= SMVM_RAW; t++) {
        const unsigned bytes = t == SMVM_RAW ? 8 : sm_type_info[t].bytes;
        WITH_BOTH(SMVM_st_local + t, 1, 16 / bytes, 0, OPERAND);
        WITH_BOTH(SMVM_st_local + t, 1, 16 / bytes - 1, 0, OK);
        WITH_BOTH(SMVM_st_local + t, 1, 0x1000c5f, 0, OPERAND);
        WITH_BOTH(SMVM_cvt, 1, t, 0, OK + (t == SMVM_RAW ? SMVM_R_OPERAND : 0));
    }
    for (unsigned m = 0; m < 20; m++)
        WITH_BOTH(SMVM_set, 1, m, 0, OK + (m < 1 || m > 14 ? SMVM_R_OPERAND : 0));
    for (unsigned n = 0; n < 40; n++) {
        WITH_BOTH(SMVM_fn, 1, n, 0, OK + (n > 8 && (n < 16 || n > 18) ? SMVM_R_FUNCTION : 0));
    }
    for (unsigned i = 0; i < 4; i++) {
        WITH_BOTH(SMVM_fn, 1, far[i], 0, OK + SMVM_R_FUNCTION);
        WITH_BOTH(SMVM_out, 1, far[i], 0, OPERAND);
        WITH_BOTH(SMVM_cvt, 1, far[i], 0, OPERAND);
        WITH_BOTH(SMVM_set, 1, far[i], 0, OPERAND);
        WITH_BOTH(SMVM_ldx_f32, 1, far[i], 0, OPERAND);
        WITH_BOTH(SMVM_ldy_f64, 1, far[i], 0, OPERAND);
        WITH_BOTH(SMVM_ldx_plus, 1, far[i], 0, OK);
        WITH_BOTH(SMVM_ldy_minus, 1, far[i], 0, OK);
        WITH_BOTH(SMVM_addi, 1, far[i], 0, OK);
        WITH_BOTH(SMVM_jxn, 2, far[i], 0, OK);
    }
    WITH_BOTH(SMVM_out, 1, 2, 0, OPERAND);
    WITH_BOTH(SMVM_ldx_f32, 1, 1, 0, OPERAND);
    WITH_BOTH(SMVM_ldy_f32, 1, 1, 0, OPERAND);
    WITH_BOTH(SMVM_ldx_f64, 1, 1, 0, OPERAND);
    WITH_BOTH(SMVM_ldy_f64, 1, 1, 0, OPERAND);
}

// Elements before and after the part of the vector that the machine uses.
static void test_elements_outside_the_part_are_refused(void)
{
    for (unsigned t = 0; t < SM_TYPE_COUNT; t++)
        for (unsigned k = 0; k < 4; k++) {
            const unsigned bytes = sm_type_info[t].bytes;
            const uint32_t at[] = {16 / bytes - 1, 16 / bytes, 48 / bytes - 1, 48 / bytes};
            SmvmVerdict v;
            Build b;
            open_step(&b);
            code(&b, SMVM_ldx_elem + t, 1, at[k]);
            code(&b, SMVM_end, 0);
            close_step(&b);
            b.sv_words = 8;
            b.from = 2;
            b.to = 6;
            b.g = 5;
            b.s = 8;
            CHECK(verify(&b, &v) == (k == 0 || k == 3 ? SMVM_R_OPERAND : 0));
        }
}

static void test_statistics_that_a_window_lacks_are_refused(void)
{
    static const struct { unsigned stat, window; uint8_t rule; } row[] = {
        {SM_STAT_AVG, 2, SMVM_R_WINDOW_USED}, {SM_STAT_AVG, 0x1000c5f, SMVM_R_WINDOW_USED}, {SM_STAT_AVG, 0x10000, SMVM_R_WINDOW_USED},
        {SM_STAT_AVG, 1, SMVM_R_WINDOW_USED}, {SM_STAT_MEDIAN, 0, SMVM_R_WINDOW_USED}, {SM_STAT_MIN, 1, SMVM_R_WINDOW_USED},       // not in the window
        {SM_STAT_MAX, 0, SMVM_R_WINDOW_USED}, {SM_STAT_RANGE, 0, SMVM_R_WINDOW_USED}, {SM_STAT_COUNT, 0, SMVM_R_OPERAND},
        {0x10000, 0, SMVM_R_OPERAND}, {0x1000c5f, 0, SMVM_R_OPERAND}, {SM_STAT_AVG, 0, 0}, {SM_STAT_MIN, 0, 0}, {SM_STAT_MEDIAN, 1, 0},
    };

    for (unsigned i = 0; i < sizeof row / sizeof *row; i++)
        STEP_REFUSED(code(&b, SMVM_stat, 2, row[i].stat, row[i].window); code(&b, SMVM_end, 0), OK + row[i].rule);
    STEP_REFUSED(put_load_input(&b); code(&b, SMVM_sample, 1, 2); code(&b, SMVM_end, 0), WINDOW_USED);
    STEP_REFUSED(put_load_input(&b); code(&b, SMVM_sample, 1, 0); code(&b, SMVM_end, 0), SAMPLE);           // outside the sample function
}

#define SAMPLE_REFUSED(statements, rule)          \
    do {                                          \
        Build b;                                  \
        put_good_machine(&b);                                 \
        b.size = b.ends = 0;                      \
        statements;                               \
        end_function(&b);                         \
        good_states(&b);                          \
        REFUSED(&b, rule);                        \
    } while (0)

static void put_sample(Build *b, unsigned w)
{
    put_load_input(b);
    code(b, SMVM_sample, 1, w);
}

static void put_average(Build *b) { code(b, SMVM_stat, 2, SM_STAT_AVG, 0); }

static void test_each_window_is_sampled_once(void)
{
    SAMPLE_REFUSED((void)b, SAMPLE);                                                            // the sample function has no sample
    SAMPLE_REFUSED(put_sample(&b, 0); code(&b, SMVM_end, 0), SAMPLE);                               // one sample is missing
    SAMPLE_REFUSED(put_sample(&b, 1); put_sample(&b, 0); code(&b, SMVM_end, 0), SAMPLE);
    SAMPLE_REFUSED(put_sample(&b, 0); put_sample(&b, 0); code(&b, SMVM_end, 0), SAMPLE);
    SAMPLE_REFUSED(put_sample(&b, 0); put_sample(&b, 1); put_sample(&b, 1); code(&b, SMVM_end, 0), SAMPLE);
    SAMPLE_REFUSED(put_average(&b); code(&b, SMVM_end, 0), SAMPLE);  // a statistic is read before its window is sampled
    SAMPLE_REFUSED(put_average(&b); put_sample(&b, 0); put_sample(&b, 1); code(&b, SMVM_end, 0), SAMPLE);
    SAMPLE_REFUSED(put_load_input(&b); code(&b, SMVM_jt, 1, 2); code(&b, SMVM_sample, 1, 0); put_sample(&b, 1); code(&b, SMVM_end, 0), SAMPLE);      // can be skipped
    SAMPLE_REFUSED(put_load_input(&b); code(&b, SMVM_jt, 1, 1); code(&b, SMVM_end, 0); put_sample(&b, 0); put_sample(&b, 1); code(&b, SMVM_end, 0), SAMPLE);     // can end before
    SAMPLE_REFUSED(put_sample(&b, 0); put_sample(&b, 1); code(&b, SMVM_goto, 1, 1), GOTO);
}

static void test_wrong_transitions_are_refused(void)
{
    STEP_REFUSED(code(&b, SMVM_goto, 1, 0), GOTO);
    STEP_REFUSED(code(&b, SMVM_goto, 1, 3), GOTO);
    STEP_REFUSED(code(&b, SMVM_goto, 1, 0x1000c5f), GOTO);
}

static void test_transition_in_exit_is_refused(void)
{
    Build b;

    open_step(&b);
    end_function(&b);
    code(&b, SMVM_goto, 1, 1);
    end_function(&b);
    put_state(&b, 1);
    REFUSED(&b, GOTO);
}

static void test_wrong_jumps_are_refused(void)
{
    STEP_REFUSED(put_load_input(&b); code(&b, SMVM_jt, 1, 1); code(&b, SMVM_end, 0), JUMP);                 // to the function's end
    STEP_REFUSED(code(&b, SMVM_jmp, 1, 0), JUMP);
    STEP_REFUSED(put_load_input(&b); code(&b, SMVM_jt, 1, 2); code(&b, SMVM_end, 0), JUMP);                 // into the next function
    STEP_REFUSED(put_load_input(&b); code(&b, SMVM_jt, 1, 0x1000c5f); code(&b, SMVM_end, 0), JUMP);         // the largest that can be encoded
    STEP_REFUSED(put_load_input(&b); code(&b, SMVM_jt, 1, 0x10000); code(&b, SMVM_end, 0), JUMP);
    STEP_REFUSED(code(&b, SMVM_jmp, 1, 1); put_load_input(&b); code(&b, SMVM_end, 0), JUMP);                // into an instruction
    STEP_REFUSED(code(&b, SMVM_jmp, 1, 2); code(&b, SMVM_stat, 2, 0, 0); code(&b, SMVM_end, 0), JUMP);
    STEP_REFUSED(put_load_input(&b), FALLS_OUT);
    STEP_REFUSED(code(&b, SMVM_end, 0); put_load_input(&b), FALLS_OUT);
    STEP_REFUSED(put_load_input(&b); code(&b, SMVM_jt, 1, 0); code(&b, SMVM_ldx_time, 0), FALLS_OUT);
}

static void load_both_registers(Build *b)
{
    put_load_input(b);
    typed(b, SMVM_ldy_elem, SM_F64, IN);
}

#define THEN(statements, rule) STEP_REFUSED(statements; code(&b, SMVM_end, 0), rule)

// Each instruction leaves a value in X, in Y, in both or in neither.  Reading a register without a value is refused.
static void test_registers_without_value_are_refused(void)
{
    THEN(code(&b, SMVM_addi, 1, 1), REGISTER);                                                  // X has no value yet
    THEN(code(&b, SMVM_ldy_plus, 1, 1); code(&b, SMVM_neg, 0), REGISTER);
    THEN(put_load_input(&b); code(&b, SMVM_add, 0), REGISTER);
    THEN(load_both_registers(&b); code(&b, SMVM_add, 0); code(&b, SMVM_mul, 0), OK);
    THEN(code(&b, SMVM_fn, 1, SMVM_FN_exp), REGISTER);
    THEN(code(&b, SMVM_ldx_plus, 1, 1); code(&b, SMVM_fn, 1, SMVM_FN_exp), OK);
    THEN(code(&b, SMVM_ldx_plus, 1, 1); code(&b, SMVM_fn, 1, SMVM_FN_pow), REGISTER);
    THEN(load_both_registers(&b); code(&b, SMVM_fn, 1, SMVM_FN_pow), OK);
    THEN(load_both_registers(&b); code(&b, SMVM_fn, 1, SMVM_FN_exp); code(&b, SMVM_add, 0), REGISTER);
    THEN(load_both_registers(&b); code(&b, SMVM_set, 1, 1); code(&b, SMVM_add, 0), OK);
    THEN(load_both_registers(&b); code(&b, SMVM_addi, 1, 1); code(&b, SMVM_cvt, 1, 0); code(&b, SMVM_neg, 0); code(&b, SMVM_or, 0), OK);
    THEN(load_both_registers(&b); put_load_input(&b); code(&b, SMVM_add, 0), REGISTER);  // Y no longer has a value
    THEN(load_both_registers(&b); code(&b, SMVM_ldx_time, 0); code(&b, SMVM_add, 0), REGISTER);
    THEN(load_both_registers(&b); code(&b, SMVM_ldx_plus, 1, 0); code(&b, SMVM_add, 0), REGISTER);
    THEN(load_both_registers(&b); code(&b, SMVM_stat, 2, 0, 0); code(&b, SMVM_add, 0), REGISTER);
    THEN(load_both_registers(&b); typed(&b, SMVM_st_local, SM_I8, 0); code(&b, SMVM_add, 0), REGISTER);
    THEN(load_both_registers(&b); typed(&b, SMVM_st_local, SM_I8, 0); code(&b, SMVM_neg, 0), OK);              // X is not changed
    THEN(load_both_registers(&b); code(&b, SMVM_out, 1, 0); code(&b, SMVM_add, 0), REGISTER);
    THEN(load_both_registers(&b); code(&b, SMVM_out, 1, 0); code(&b, SMVM_jt, 1, 0), OK);
    THEN(load_both_registers(&b); code(&b, SMVM_jmp, 1, 0); code(&b, SMVM_ldy_plus, 1, 0), REGISTER);          // (a jump to ldy)
    THEN(load_both_registers(&b); code(&b, SMVM_end, 0); code(&b, SMVM_neg, 0), REGISTER);                     // after the end
    THEN(load_both_registers(&b); code(&b, SMVM_goto, 1, 1); code(&b, SMVM_neg, 0), REGISTER);
    THEN(load_both_registers(&b); code(&b, SMVM_jt, 1, 2); code(&b, SMVM_jmp, 1, 0); put_load_input(&b); code(&b, SMVM_add, 0), REGISTER);
    SAMPLE_REFUSED(load_both_registers(&b); code(&b, SMVM_sample, 1, 0); code(&b, SMVM_add, 0); code(&b, SMVM_sample, 1, 1); code(&b, SMVM_end, 0), REGISTER);
    SAMPLE_REFUSED(load_both_registers(&b); code(&b, SMVM_sample, 1, 0); code(&b, SMVM_neg, 0); code(&b, SMVM_sample, 1, 1); code(&b, SMVM_end, 0), OK);
}

// After a jump that is not taken, both registers have their numbers.  After a jump that is taken, they are unknown.
static void test_jumps_preserve_registers(void)
{
    for (unsigned op = 0x80; op < 0x100; op++) {      // a jump to each instruction
        const uint32_t shape = smvm_shape((uint8_t)op);
        const bool alone = (shape & SMVM_SHAPE_GX && !(shape & SMVM_SHAPE_X)) || op == SMVM_goto || op == SMVM_end || op == SMVM_jmp;
        if (shape == 0 || op == SMVM_sample)
            continue;
        THEN(load_both_registers(&b); code(&b, SMVM_jt, 1, 0); code(&b, op, shape & SMVM_SHAPE_K || (shape & SMVM_SHAPE_N && shape & SMVM_SHAPE_J) ? 2
             : shape & SMVM_SHAPE_FOLLOWS ? 1 : 0, op == SMVM_set || op == SMVM_goto ? 1 : op >= SMVM_ldx_elem && op < SMVM_stat ? 4 : 0, 0), OK + (alone ? 0 : SMVM_R_REGISTER));
    }
    THEN(load_both_registers(&b); code(&b, SMVM_jxy, 1, 1); code(&b, SMVM_add, 0), OK);
    THEN(load_both_registers(&b); code(&b, SMVM_jxn, 2, 5, 1); code(&b, SMVM_add, 0), OK);
    THEN(load_both_registers(&b); code(&b, SMVM_jf, 1, 1); code(&b, SMVM_add, 0), OK);
    THEN(load_both_registers(&b); code(&b, SMVM_jt, 1, 1); code(&b, SMVM_add, 0), OK);
}

// A register has no value at the start of the next function.
static void test_registers_end_with_the_function(void)
{
    Build b;

    open_step(&b);
    put_load_input(&b);
    code(&b, SMVM_end, 0);
    end_function(&b);
    code(&b, SMVM_neg, 0);
    code(&b, SMVM_end, 0);
    end_function(&b);
    put_state(&b, 1);
    REFUSED(&b, REGISTER);
}

int main(void)
{
    test_wrong_function_ends_are_refused();
    test_unknown_opcodes_are_refused();
    test_truncated_instructions_are_refused();
    test_operands_out_of_range_are_refused();
    test_elements_outside_the_part_are_refused();
    test_statistics_that_a_window_lacks_are_refused();
    test_each_window_is_sampled_once();
    test_wrong_transitions_are_refused();
    test_transition_in_exit_is_refused();
    test_wrong_jumps_are_refused();
    test_registers_without_value_are_refused();
    test_jumps_preserve_registers();
    test_registers_end_with_the_function();
    return test_end("vm_verify_code");
}
