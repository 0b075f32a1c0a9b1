// SPDX-License-Identifier: Apache-2.0
// Tables, results and checksum.
#include "stdlib/std.h"
#include "tests/test.h"

static void test_types(void)
{
    static const unsigned bytes[SM_TYPE_COUNT] = { 1, 2, 4, 8, 1, 2, 4, 8, 4, 8, 1 };
    for (int i = 0; i < SM_TYPE_COUNT; i++) {
        CHECK(sm_type_info[i].spelling != NULL && sm_type_info[i].ctype != NULL);
        CHECK(sm_type_info[i].bytes == bytes[i]);
        CHECK((sm_type_info[i].kind == SM_KIND_UNSIGNED) == (sm_type_info[i].spelling[0] == 'U'));
    }
    CHECK(strcmp(sm_type_info[SM_BOOL].spelling, "bool") == 0 && strcmp(sm_type_info[SM_I8].ctype, "int8_t") == 0);
}

static void test_operators(void)
{
    CHECK(strcmp(sm_op_info[SM_OP_NE].spelling, "!=") == 0 && sm_op_info[SM_OP_NE].op_class == SM_CLASS_EQUALITY);
    CHECK(sm_op_info[SM_OP_OR].precedence < sm_op_info[SM_OP_AND].precedence);
    CHECK(sm_op_info[SM_OP_AND].precedence < sm_op_info[SM_OP_EQ].precedence);
    CHECK(sm_op_info[SM_OP_EQ].precedence < sm_op_info[SM_OP_LT].precedence);
    CHECK(sm_op_info[SM_OP_GE].precedence < sm_op_info[SM_OP_SUB].precedence);
    CHECK(sm_op_info[SM_OP_ADD].precedence < sm_op_info[SM_OP_DIV].precedence);
    CHECK(sm_op_info[SM_OP_MUL].precedence < sm_op_info[SM_OP_NOT].precedence);
    for (int i = 0; i < SM_OP_COUNT; i++)
        CHECK(sm_op_info[i].arity == (i >= SM_OP_NOT ? 1 : 2));
}

static void test_builtins(void)
{
    int rolls = 0;
    for (int i = 0; i < SM_FN_COUNT; i++) {
        CHECK(sm_builtin_info[i].is_roll == (strncmp(sm_builtin_info[i].name, "roll_", 5) == 0));
        rolls += sm_builtin_info[i].is_roll;
    }
    CHECK(rolls == SM_STAT_OLDEST);
    CHECK(sm_builtin_info[SM_FN_clamp].arguments == 3 && sm_builtin_info[SM_FN_roll_range].stat == SM_STAT_RANGE);
}

static void test_results(void)
{
    CHECK(SM_OK == 0 && SM_REFUSED == -1);
    CHECK(strcmp(sm_result_text(SM_OK), "ok") == 0);
    CHECK(strstr(sm_result_text(SM_REFUSED), "refused") != NULL);
    CHECK(strcmp(sm_result_text((SmResult)-31999), "unknown result") == 0);
}

static void test_crc(void)
{
    CHECK(sm_crc32("", 0) == 0);
    CHECK(sm_crc32("123456789", 9) == 0xCBF43926u);
    CHECK(sm_crc32("The quick brown fox jumps over the lazy dog", 43) == 0x414FA339u);
}

int main(void)
{
    test_types();
    test_operators();
    test_builtins();
    test_results();
    test_crc();
    return test_end("stdlib_tables");
}
