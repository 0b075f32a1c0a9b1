// SPDX-License-Identifier: Apache-2.0
// How names in the source become names in C.
#include <stdlib.h>
#include <string.h>

#include "compiler/emit/c/emit_c.h"
#include "compiler/emit/c/unit.h"
#include "tests/heap.h"
#include "tests/test.h"

static Arena arena;

static bool prefix_becomes(const char *text, const char *prefix, const char *type, const char *macro)
{
    const char *p = c_identifier(&arena, text, strlen(text));

    return strcmp(p, prefix) == 0 && strcmp(c_type_name(&arena, p), type) == 0 && strcmp(c_macro_name(&arena, p), macro) == 0;
}

static void test_prefixes_are_identifiers(void)
{
    CHECK(prefix_becomes("tank", "tank", "Tank", "TANK"));
    CHECK(prefix_becomes("my-tank.v2", "my_tank_v2", "MyTankV2", "MY_TANK_V2"));
    CHECK(prefix_becomes("2stage", "m2stage", "M2stage", "M2STAGE"));
    CHECK(prefix_becomes("__a__b__", "a_b", "AB", "A_B"));
    CHECK(prefix_becomes("\xc3\xa4 \xc3\xb6", "machine", "Machine", "MACHINE"));
    CHECK(prefix_becomes("", "machine", "Machine", "MACHINE"));
    CHECK(prefix_becomes("FILE", "FILE", "FILEMachine", "FILE"));
    CHECK(emit_c_prefix_error("tank") == NULL && emit_c_prefix_error("a1_b") == NULL);
    CHECK(emit_c_prefix_error("") && emit_c_prefix_error("_a") && emit_c_prefix_error("1a") && emit_c_prefix_error("a__b"));
    CHECK(emit_c_prefix_error("a-b") && emit_c_prefix_error("a_") && emit_c_prefix_error("\xc3\xa4"));
}

static void test_reserved_names(void)
{
    CHECK(c_is_reserved("int") && c_is_reserved("class") && c_is_reserved("errno") && c_is_reserved("NULL") && c_is_reserved("linux"));
    CHECK(c_is_reserved("_x") && c_is_reserved("a__b") && c_is_reserved("TANK_SV_LAYOUT") && c_is_reserved("TANK_H_INCLUDED"));
    CHECK(!c_is_reserved("pressure") && !c_is_reserved("Int") && !c_is_reserved("x_") && !c_is_reserved("T"));
}

// Returns the members that elements with these names get, separated by blanks.
static const char *member_names(const char *const *name, size_t n)
{
    StrPool strings;
    CNames names;
    CVector sv;
    Buf out;

    memset(&names, 0, sizeof names);
    memset(&sv, 0, sizeof sv);
    str_pool_init(&strings, &arena);
    names.sv_type = "BusSv";
    sv.at = ARENA_ARRAY(&arena, CElement, n);
    sv.n = n;
    for (size_t i = 0; i < n; i++) {
        sv.at[i].name = str_c(&strings, name[i]);
        sv.at[i].offset = (uint32_t)i * 16;
    }
    names_assign_elements(&arena, &names, &sv);
    buf_init(&out, &arena);
    for (size_t i = 0; i < n; i++)
        buf_printf(&out, "%s ", sv.at[i].member);
    return buf_text(&out);
}

static void test_members_are_unique(void)
{
    static const char *const plain[] = { "int", "int_", "int_2", "_x", "x", "x_2", "BusSv", "pad_at_1_", "a__b" };
    static const char *const turned[] = { "a__b", "pad_at_1_", "BusSv", "x_2", "x", "_x", "int_2", "int_", "int" };

    CHECK(strcmp(member_names(plain, 9), "int_3 int_ int_2 x_3 x x_2 BusSv_ pad_at_1 a_b ") == 0);
    CHECK(strcmp(member_names(turned, 9), "a_b pad_at_1 BusSv_ x_2 x x_3 int_2 int_ int_3 ") == 0);
}

int main(void)
{
    jmp_buf oom;

    if (setjmp(oom))
        return 3;
    arena_init(&arena, heap_alloc, NULL, &oom);
    test_prefixes_are_identifiers();
    test_reserved_names();
    test_members_are_unique();
    arena_free(&arena);
    return test_end("emitc_names");
}
