// SPDX-License-Identifier: Apache-2.0
// Disassembling: every opcode as text, and images with invalid names: all with the same name of the greatest length, or not in order.
#include <string.h>

#include "bytecode-vm/smvm.h"
#include "tests/test.h"
#include "tests/unit/vm_build.h"

enum { NAME = 60000, MOVES = 500 };

static void count(void *context, const char *text, size_t length)
{
    (void)text;
    *(size_t *)context += length;
}

typedef struct Names {
    uint32_t variables;
    struct { unsigned is; uint32_t place; } variable[8];
    uint32_t size;            // size of the single name that all of them have
} Names;

static uint32_t put_debug(const Build *b, const Names *names, uint8_t *p)
{
    const uint8_t *start = p;
    const uint32_t name = 3 * (4 + b->states) + 7 * names->variables;

    put_bytes(&p, names->variables, 3);
    put_bytes(&p, 0, 3);
    for (uint32_t i = 2; i < 4 + b->states; i++)
        put_bytes(&p, name, 3);
    for (uint32_t i = 0; i < names->variables; i++) {
        put_bytes(&p, names->variable[i].is, 1);
        put_bytes(&p, names->variable[i].place, 3);
        put_bytes(&p, name, 3);
    }
    p += put_number(p, names->size);
    memset(p, 'x', names->size);
    return (uint32_t)(p - start) + names->size;
}

// Builds an image with names that the verifier accepts.
static void put_image(const Build *b, const Names *names, uint8_t *image)
{
    static const uint8_t id[] = {0x81, 0x82, 0x02};
    uint32_t size[3], at = 12 + 3 * 8;
    SmvmVerdict v;

    size[0] = put_machine(b, image + at);
    size[1] = b->size;
    memcpy(image + at + size[0], b->code, b->size);
    size[2] = put_debug(b, names, image + at + size[0] + size[1]);
    at = put_header(image, 3, id, size);
    CHECK(smvm_verify(image, at, &v) == 0);
    if (v.rule != 0)
        fprintf(stderr, "rule %u at %u\n", v.rule, (unsigned)v.at);
}

static void begin(Build *b)
{
    memset(b, 0, sizeof *b);
    b->sv_words = 4;
    b->states = b->outputs = 1;
    b->output[0] = PLACE(F64, 16);
    b->s = 2;
    b->width = 2;
    b->locals = 24;
}

static void end_functions(Build *b)
{
    code(b, SMVM_end, 0);
    while (b->ends < 4)
        end_function(b);
}

static void test_long_names_are_written(void)
{
    const Names names = {3, {{SMVM_IS_LOCAL, PLACE(F64, 0)}, {SMVM_IS_ELEMENT, PLACE(F64, 16)}, {SMVM_IS_TIME, 0}}, NAME};
    static uint8_t image[NAME + 8 * MOVES];
    static Build b;
    size_t length = 0;

    begin(&b);
    for (unsigned i = 0; i < MOVES; i++) {
        typed(&b, SMVM_ldx_elem, SM_F64, 16);
        code(&b, SMVM_out, 1, 0);
    }
    end_functions(&b);
    put_image(&b, &names, image);
    smvm_disasm(image, count, &length);
    CHECK(length > 2 * MOVES * 100 && length < 2 * MOVES * 300);
}

// ---- names ----

static void write_text(void *context, const char *text, size_t length) { strncat((char *)context, text, length); }

static const char *disassemble(const Build *b, const Names *names)
{
    static char text[8000];
    static uint8_t image[4000];

    put_image(b, names, image);
    text[0] = '\0';
    smvm_disasm(image, write_text, text);
    return text;
}

// The disassembler finds names by binary search, so the table must be sorted by kind, type and offset.
static void test_variable_names(void)
{
    const Names all = {6, {{SMVM_IS_LOCAL, PLACE(I16, 2)}, {SMVM_IS_LOCAL, PLACE(F64, 8)}, {SMVM_IS_ELEMENT, PLACE(U32, 8)},
                            {SMVM_IS_ELEMENT, PLACE(U64, 0)}, {SMVM_IS_ELEMENT, PLACE(F64, 16)}, {SMVM_IS_TIME, 0}}, 3};
    const Names wrong = {2, {{SMVM_IS_TIME, 0}, {SMVM_IS_LOCAL, PLACE(I16, 2)}}, 3};
    const Names none = {0, {{0, 0}}, 3};
    static Build b;
    const char *text;

    begin(&b);
    end_function(&b);
    typed(&b, SMVM_ldx_local, SM_I16, 2);
    typed(&b, SMVM_st_local, SM_F64, 8);
    typed(&b, SMVM_st_local, SMVM_RAW, 8);
    typed(&b, SMVM_ldx_local, SM_I16, 4);
    typed(&b, SMVM_ldy_elem, SM_F64, 16);
    code(&b, SMVM_ldx_time, 0);
    end_functions(&b);
    text = disassemble(&b, &all);
    CHECK(strstr(text, "  ldx     xxx\n") && strstr(text, "  st      xxx\n") && strstr(text, "  st      local RAW@8\n"));
    CHECK(strstr(text, "  ldx     local I16@4\n") && strstr(text, "  ldy     xxx\n") && strstr(text, "ldx     xxx\n    11  end"));
    CHECK(strstr(text, "G               U64@0 xxx\n") && strstr(text, "S               U32@8 xxx\n"));
    CHECK(strstr(disassemble(&b, &wrong), "  ldx     T\n") && strstr(disassemble(&b, &wrong), "  ldx     local I16@2\n"));
    text = disassemble(&b, &none);
    CHECK(strstr(text, "ldx     local I16@2\n") && strstr(text, "ldy     F64@16\n") && strstr(text, "ldx     T\n"));
}

// A state's name is copied as far as it fits.  The copy is empty if the image has no names or the state does not exist.
static void test_state_name_is_copied(void)
{
    const Names names = {0, {{0, 0}}, 5};
    static uint8_t image[4000];
    static Build b;
    SmvmMachine m;
    char to[8];

    begin(&b);
    end_functions(&b);
    put_image(&b, &names, image);
    CHECK(smvm_machine(image, 0, &m));
    memset(to, '!', sizeof to);
    CHECK(smvm_copy_state_name(&m, 1, to, sizeof to) == 5 && strcmp(to, "xxxxx") == 0 && to[6] == '!');
    memset(to, '!', sizeof to);
    CHECK(smvm_copy_state_name(&m, 1, to, 5) == 5 && strcmp(to, "xxxx") == 0 && to[5] == '!');
    CHECK(smvm_copy_state_name(&m, 1, to, 0) == 5 && strcmp(to, "xxxx") == 0);
    CHECK(smvm_copy_state_name(&m, 0, to, sizeof to) == 0 && to[0] == '\0');
    CHECK(smvm_copy_state_name(&m, 2, to, sizeof to) == 0 && to[0] == '\0');
    m.debug_size = 0;
    CHECK(smvm_copy_state_name(&m, 1, to, sizeof to) == 0 && to[0] == '\0');
    CHECK(smvm_machine_size() == sizeof m && smvm_verdict_size() == sizeof(SmvmVerdict));
}

// ---- opcodes ----

typedef struct Line { const char *text; unsigned op; int numbers; unsigned n[2]; } Line;

// X and Y are 1 and 2 before each instruction.
static void test_every_opcode_is_written(void)
{
    static const Line lines[] = {
        {"  ldx     local U8@3\n", SMVM_ldx_local + 4, 1, {3, 0}},
        {"  ldx     local RAW@16\n", SMVM_ldx_local + SMVM_RAW, 1, {2, 0}},
        {"  ldx     100000\n", SMVM_ldx_plus, 1, {100000, 0}},
        {"  ldx     -1\n", SMVM_ldx_minus, 1, {0, 0}},
        {"  ldx     -16780384\n", SMVM_ldx_minus, 1, {SMVM_VARINT_END - 1, 0}},
        {"  ldx     0.1\n", SMVM_ldx_f64, 1, {0, 0}},
        {"  ldx     0.25\n", SMVM_ldx_f32, 1, {0, 0}},
        {"  ldx     bool@17\n", SMVM_ldx_elem + 10, 1, {17, 0}},
        {"  ldx     T\n", SMVM_ldx_time, 0, {0, 0}},
        {"  stat    median, w0\n", SMVM_stat, 2, {SM_STAT_MEDIAN, 0}},
        {"  addi    7\n", SMVM_addi, 1, {7, 0}},
        {"  subi    7\n", SMVM_subi, 1, {7, 0}},
        {"  ldy     local I16@2\n", SMVM_ldy_local + 1, 1, {1, 0}},
        {"  ldy     -3\n", SMVM_ldy_minus, 1, {2, 0}},
        {"  ldy     0.1\n", SMVM_ldy_f64, 1, {0, 0}},
        {"  ldy     F64@24\n", SMVM_ldy_elem + 9, 1, {3, 0}},
        {"  ldy     T\n", SMVM_ldy_time, 0, {0, 0}},
        {"  cvt     F32\n", SMVM_cvt, 1, {8, 0}},
        {"  fn      exp\n", SMVM_fn, 1, {SMVM_FN_exp, 0}},
        {"  fn      atan\n", SMVM_fn, 1, {SMVM_FN_atan, 0}},
        {"  fn      hypot\n", SMVM_fn, 1, {SMVM_FN_hypot, 0}},
        {"  set     not x <= y\n", SMVM_set, 1, {12, 0}},
        {"  set     x <> y\n", SMVM_set, 1, {5, 0}},
        {"  st      local F32@4\n", SMVM_st_local + 8, 1, {1, 0}},
        {"  out     F64@16\n", SMVM_out, 1, {0, 0}},
        {"  jxy     x != y, ", SMVM_jxy + 12, 1, {0, 0}},
        {"  jxn     x >= 300, ", SMVM_jxn + 5, 2, {300, 0}},
        {"  jxn     x < 5, ", SMVM_jxn, 2, {5, 0}},
        {"  jt      ", SMVM_jt, 1, {0, 0}},
        {"  jf      ", SMVM_jf, 1, {0, 0}},
        {"  add\n", SMVM_add, 0, {0, 0}},
        {"  and\n", SMVM_and, 0, {0, 0}},
        {"  sign\n", SMVM_sign, 0, {0, 0}},
    };
    const Names none = {0, {{0, 0}}, 3};
    static Build b;

    for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++) {
        begin(&b);
        b.windows = b.f32s = b.f64s = 1;
        b.window[0] = WINDOW(5, 1u << SM_STAT_MEDIAN);
        b.f32[0] = 0x3e800000u;
        b.f64[0] = 0x3fb999999999999au;
        code(&b, SMVM_ldx_plus, 1, 1);
        code(&b, SMVM_sample, 1, 0);
        code(&b, SMVM_end, 0);
        end_function(&b);
        end_function(&b);
        code(&b, SMVM_ldx_plus, 1, 1);
        code(&b, SMVM_ldy_plus, 1, 2);
        code(&b, lines[i].op, lines[i].numbers, lines[i].n[0], lines[i].n[1]);
        end_functions(&b);
        CHECK(strstr(disassemble(&b, &none), lines[i].text));
        if (!strstr(disassemble(&b, &none), lines[i].text))
            fprintf(stderr, "not there: %s%s", lines[i].text, disassemble(&b, &none));
    }
}

int main(void)
{
    test_long_names_are_written();
    test_variable_names();
    test_state_name_is_copied();
    test_every_opcode_is_written();
    return test_end("vm_disasm");
}
