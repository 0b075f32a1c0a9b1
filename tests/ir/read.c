// SPDX-License-Identifier: Apache-2.0
// Invalid IR texts: the reader must report the position and the reason.
#include "tests/ir/edit.h"
#include "tests/test.h"

static const Edit edits[] = {
    {"machine \"m\"", "machine m", "line 1: expected '\"'"},
    {"machine \"m\"", "machine \"m", "line 1: expected '\"'"},
    {"machine \"m\"", "machine \"m\\x\"", "two hexadecimal digits"},
    {"machine \"m\"", "", "without a machine"},
    {"machine \"m\"", "machine \"m\" \"n\"", "end of the line"},
    {"machine \"m\"", "machine \"m\"\nmachine \"m\"", "line 2: the machine has a name already"},
    {"vector \"m\" size 40 hash 0x00000001\n", "", "without a vector"},
    {"size 40", "length 40", "line 2: expected 'size'"},
    {"size 40", "size 4294967296", "expected a size"},
    {"hash 0x00000001", "hash", "expected a hash"},
    {"hash 0x00000001", "hash 0x", "expected a hash"},
    {"element U64 G", "thing U64 G", "line 3: 'thing' is not allowed here"},
    {"element U64 G", "element u64 G", "expected a type, found 'u64'"},
    {"G at 0 is G", "G at 0 is T", "expected G or S"},
    {"x at 16", "x at 16 is G", "two elements of this role"},
    {"G at 0 is G", "G at 0", "without an element that is G"},
    {"x at 16", "G at 16", "two variables 'G'"},
    {"x at 16", "x", "expected 'at'"},
    {"element F64 x", "element F64", "expected 'at'"},
    {"time U64 T", "time U64 T\ntime U64 T2", "two times"},
    {"time U64 T", "", "and a time"},
    {"= -5", "", "expected '='"},
    {"= -5", "= -32769", "-32769 is no value of type I16"},
    {"= -5", "= 32768", "no value of type I16"},
    {"= -5", "= five", "expected a value, found 'five'"},
    {"= -5", "= 18446744073709551616", "expected a value"},
    {"k = 0x3fb999999999999a", "k = 9007199254740993", "no value of type F64"},
    {"window w0", "window w1", "expected w0"},
    {"window w0", "window x0", "expected a window"},
    {"stats avg", "stats avg mode", "expected a statistic, found 'mode'"},
    {"sample w1, %1\n    ret\n}", "sample w1, %1\n    ret\n}\nsample {\nb0:\nret\n}", "duplicate function"},
    {"sample {\nb0:", "sample {\nb1:", "expected b0"},
    {"sample {", "sample", "expected '{'"},
    {"step {\nb0:\n", "step {\n", "expected a block's label"},
    {"exit {", "step {", "duplicate function"},
    {"exit {", "leave {", "'leave' is not allowed here"},
    {"state A\n", "", "expected a state before"},
    {"state B", "state A", "two states 'A'"},
    {"goto B", "goto C", "line 38: there is no state 'C'"},
    {"goto B", "goto", "expected a state"},
    {"    goto B\n", "", "does not end in a jump"},
    {"    ret\n}\nexit", "}\nexit", "does not end in a jump"},
    {"    goto B\n", "    goto B\n    ret\n", "expected a block's label"},
    {"%2 = lt", "%2 = less", "no operation 'less'"},
    {"%2 = lt", "%2 lt", "expected '='"},
    {"%2 = lt", "%1 = lt", "assigned twice"},
    {"%2 = lt F64 %0, %1", "%2 = lt F64 %0 %1", "expected ','"},
    {"%2 = lt F64 %0, %1", "%2 = lt F64 %0", "expected ','"},
    {"%2 = lt F64 %0, %1", "%2 = lt F64 %0, %9", "no temporary '%9'"},
    {"%2 = lt F64 %0, %1", "%2 = lt U8 %0, %1", "not of type U8"},
    {"%2 = lt F64 %0, %1", "lt F64 %0, %1", "must precede it"},
    {"store U8 u, %5", "%9 = store U8 u, %5", "has no result"},
    {"store U8 u, %5", "store U16 u, %5", "'u' is of type U8"},
    {"store U8 u, %5", "store U8 v, %5", "no variable 'v'"},
    {"stat min w1", "stat min w2", "no window w2"},
    {"br %3, b1, b2", "br %3, b1", "expected ','"},
    {"br %3, b1, b2", "br %3, b1, c2", "expected a block, found 'c2'"},
    {"jmp b3", "jmp b99999999999", "expected a block"},
    {"jmp b3", "jmp b3 b4", "end of the line"},
    {"state B\n", "state B\nentry {\nb0:\n", "expected '}'"},
    {"state B\n", "state B\n}", "expected a declaration"},
};

static bool check_edit(Arena *a, const Edit *e)
{
    char *text = edit_apply(e);
    const char *error = "the text to replace is not there";
    StrPool strings;
    IrMachine *m;

    str_pool_init(&strings, a);
    m = text ? ir_read(a, &strings, text, strlen(text), &error) : NULL;
    free(text);
    if (!m && strstr(error, e->says))
        return true;
    fprintf(stderr, "'%s': expected '%s', said '%s'\n", e->to, e->says, m ? "nothing" : error);
    return false;
}

// Every prefix of a valid text is accepted or refused, without a crash.
static void check_beginnings(Arena *a)
{
    StrPool strings;
    const char *error;

    str_pool_init(&strings, a);
    for (size_t n = 0; n < sizeof edit_text; n++) {
        char *text = malloc(n + 1);                            // a separate block, so that a sanitizer notices a read beyond it
        memcpy(text, edit_text, n);
        CHECK((ir_read(a, &strings, text, n, &error) == NULL) == (error != NULL));
        free(text);
    }
}

int main(void)
{
    jmp_buf oom;
    Arena a;

    if (setjmp(oom) != 0)
        return 3;
    arena_init(&a, heap_alloc, NULL, &oom);
    for (size_t i = 0; i < sizeof edits / sizeof edits[0]; i++)
        CHECK(check_edit(&a, &edits[i]));
    check_beginnings(&a);
    arena_free(&a);
    return test_end("ir/read");
}
