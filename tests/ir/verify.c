// SPDX-License-Identifier: Apache-2.0
// Violates each invariant of ir.h once: ir_verify must find and report it.
#include "tests/ir/edit.h"
#include "tests/test.h"

static const Edit edits[] = {
    {"vector \"m\" size 40", "vector \"m\" size 41", "no multiple of 8"},
    {"x at 16", "x at 20", "not at a multiple of its size"},
    {"x at 16", "x at 40", "outside the state vector"},
    {"x at 16", "x at 4294967288", "outside the state vector"},
    {"size 40", "size 0", "outside the state vector"},
    {"u writable at 24", "u writable at 23", "overlaps another"},
    {"flag writable at 25", "flag writable at 24", "overlaps another"},
    {"f writable at 28", "f writable at 24", "overlaps another"},
    {"state A\n", "state 9\n", "no identifier"},
    {"time U64 T", "time U64 9T", "no identifier"},
    {"n writable = -5", "n writable = 0x10000", "does not fit"},
    {"k = 0x3fb999999999999a", "k = 0x7ff8000000000000", "not a number"},
    {"local F64 k =", "local F64 k outside hidden =", "hidden, but written from outside"},
    {"local F64 k = 0x3fb999999999999a", "local F64 k = 3\nlocal F32 k2 = 0x7fc00000", "not a number"},
    {"local F64 k = 0x3fb999999999999a", "local F64 k = 3\nlocal bool k2 = 0x2", "does not fit"},
    {"element U64 G at 0 is G\nelement U32 S at 8", "element U32 G at 0 is G\nelement U32 S at 8", "G is not what it must be"},
    {"element U32 S at", "element U64 S at", "S is not what it must be"},
    {"time U64", "time U32", "T is not what it must be"},
    {"S at", "S writable at", "S is writable"},
    {"G at", "G writable at", "G is writable"},
    {"T\n", "T writable\n", "T is writable"},
    {"w0 F64 size 10", "w0 F64 size 0", "size of window w0"},
    {"w0 F64 size 10", "w0 F64 size 100001", "size of window w0"},
    {"sample {\nb0:\n    %0 = load F64 x\n    sample w0, %0\n    %1 = stat avg w0\n    sample w1, %1\n    ret\n}\n", "", "windows require one"},
    {"    sample w1, %1\n", "", "window w1 gets no sample"},
    {"sample w1, %1", "sample w0, %1", "samples a window twice"},
    {"    sample w0, %0\n    %1 = stat avg w0\n", "    %1 = stat avg w0\n    sample w0, %0\n", "before its sample"},
    {"    sample w1, %1\n    ret\n", "    sample w1, %1\n    jmp b1\nb1:\n    ret\n", "not one block"},
    {"    sample w1, %1\n    ret\n", "    sample w1, %1\n    goto A\n", "transition is not allowed here"},
    {"    sample w1, %1\n", "    sample w1, %1\n    %2 = cvt U8 %1\n    store U8 u, %2\n", "writes a variable"},
    {"    %1 = const F64 5\n", "    %1 = const F64 5\n    sample w0, %1\n", "outside the sample function"},
    {"stat min w1", "stat median w1", "does not list"},
    {"store U8 u, %5\n    jmp", "store U8 u, %5\n    store bool flag, %3\n    jmp", "has not computed before"},
    {"store U8 u, %5\n    jmp", "%x = add F64 %0, %4\n    jmp", "has not computed before"},
    {"store U8 u, %5\n    jmp b3", "store U8 u, %5\n    br %3, b2, b3", "no bool of this block"},
    {"store U8 u, %5", "store U8 u, %4", "not of the right type"},
    {"store F32 f, %9", "store F64 x, %8", "not writable"},
    {"not %2", "not %1", "not of the right type"},
    {"%2 = lt F64 %0, %1\n    %3 = not %2", "%2 = lt F64 %0, %1\n    %3 = add F64 %2, %2", "not of the right type"},
    {"%7 = load F64 k\n    %8 = neg F64 %7", "%k = load F64 k\n    %7 = cvt U8 %k\n    %8 = neg U8 %7", "cannot work on its type"},
    {"%8 = neg F64 %7", "%10 = cvt I32 %7\n    %8 = neg F64 %10", "not of the right type"},
    {"%8 = neg F64 %7", "%10 = cvt F32 %7\n    %8 = min F32 %10, %10", "cannot work on its type"},
    {"%2 = lt F64 %0, %1", "%u = cvt U8 %0\n    %2 = lt U8 %u, %1", "not of the right type"},
    {"const F64 5", "const F64 0xfff8000000000000", "NaN other than IR_NAN"},
    {"const F64 5", "const F32 0x100000000\n    %x = const F64 5", "does not fit"},
    {"const bool 1", "const bool 0x2", "does not fit"},
    {"%3 = not %2\n    br %3", "%3 = not %2\n    br %1", "no bool of this block"},
    {"jmp b3", "jmp b1", "jump forward"},
    {"jmp b3", "jmp b0", "jump forward"},
    {"jmp b3", "jmp b4", "jump forward"},
    {"br %3, b1, b2", "br %3, b1, b0", "jump forward"},
    {"br %3, b1, b2", "br %3, b9, b2", "jump forward"},
    {"store I16 n, %0\n    ret", "store I16 n, %0\n    goto A", "transition is not allowed here"},
    {"exit {\nb0:\n    %0 = const I16 3\n    store I16 n, %0\n    ret\n}", "exit {\n}", "no block"},
    {"time U64 T", "time U64 T.x", "no identifier"},
};

static bool finds(Arena *a, const IrMachine *m, const char *what)
{
    const char *said = ir_verify(a, m);

    if (!said || !strstr(said, what))
        fprintf(stderr, "expected '%s', said '%s'\n", what, said ? said : "nothing");
    return said && strstr(said, what);
}

static bool check_edit(Arena *a, const Edit *e)
{
    char *text = edit_apply(e);
    const char *error = "the text to replace is not there";
    StrPool strings;
    IrMachine *m;

    str_pool_init(&strings, a);
    m = text ? ir_read(a, &strings, text, strlen(text), &error) : NULL;
    free(text);
    if (!m)
        fprintf(stderr, "'%s': %s\n", e->to, error);
    return m && finds(a, m, e->says);
}

// ---- faults that no text can express ----

static IrMachine *fresh(Arena *a)
{
    StrPool strings;
    const char *error;

    str_pool_init(&strings, a);
    return ir_read(a, &strings, edit_text, sizeof edit_text - 1, &error);
}

static void check_broken_structures(Arena *a)
{
    IrMachine *m = fresh(a);

    CHECK(ir_verify(a, m) == NULL);
    m->state.n = 0;
    CHECK(finds(a, m, "no state"));
    m = fresh(a);
    m->state.at[1].name = m->state.at[0].name;
    CHECK(finds(a, m, "two have the same"));
    m = fresh(a);
    m->var.at[4].name = m->var.at[3].name;
    CHECK(finds(a, m, "two variables"));
    m = fresh(a);
    m->var.at[4].type = SM_TYPE_COUNT;
    CHECK(finds(a, m, "has no type"));
    m = fresh(a);
    m->var.at[4].space = (IrSpace)7;
    CHECK(finds(a, m, "no element, local or time"));
    m = fresh(a);
    m->var.at[m->t].space = IR_LOCAL;
    CHECK(finds(a, m, "T is not"));
    m = fresh(a);
    m->var.at[4].space = IR_TIME;
    CHECK(finds(a, m, "second time"));
    m = fresh(a);
    m->g = IR_NONE;
    CHECK(finds(a, m, "G is not"));
    m = fresh(a);
    m->window.at[0].stats = 1u << SM_STAT_COUNT;
    CHECK(finds(a, m, "unknown statistic"));
}

static void check_broken_functions(Arena *a)
{
    IrMachine *m = fresh(a);
    IrFn *f = m->state.at[0].block[BLOCK_STEP];

    vec_push(a, &f->blk.at[3].ins, f->blk.at[3].ins.at[0]);
    CHECK(finds(a, m, "occurs twice"));
    f = (m = fresh(a))->state.at[0].block[BLOCK_STEP];
    f->blk.at[3].ins.at[0] = 1000;
    CHECK(finds(a, m, "does not exist"));
    f = (m = fresh(a))->state.at[0].block[BLOCK_STEP];
    f->ins.at[0].op = IR_OP_COUNT;
    CHECK(finds(a, m, "no operation"));
    f = (m = fresh(a))->state.at[0].block[BLOCK_STEP];
    f->ins.at[0].type = (SmType)99;
    CHECK(finds(a, m, "no type"));
    f = (m = fresh(a))->state.at[0].block[BLOCK_STEP];
    f->ins.at[0].var = 1000;
    CHECK(finds(a, m, "its variable's type"));
    f = (m = fresh(a))->state.at[0].block[BLOCK_STEP];
    f->ins.at[2].type = SM_U8;
    CHECK(finds(a, m, "wrong type"));
    f = (m = fresh(a))->state.at[0].block[BLOCK_STEP];
    f->ins.at[2].a = 1000;
    CHECK(finds(a, m, "has not computed"));
    f = (m = fresh(a))->state.at[0].block[BLOCK_STEP];
    f->ins.at[2].a = 2;
    CHECK(finds(a, m, "has not computed"));
    f = (m = fresh(a))->state.at[0].block[BLOCK_STEP];
    f->ins.at[4].stat = SM_STAT_COUNT;
    CHECK(finds(a, m, "statistic of nothing"));
    f = (m = fresh(a))->state.at[0].block[BLOCK_STEP];
    f->ins.at[4].var = 2;
    CHECK(finds(a, m, "statistic of nothing"));
    f = (m = fresh(a))->state.at[0].block[BLOCK_STEP];
    f->ins.at[4].type = SM_U8;
    CHECK(finds(a, m, "no F64"));
    f = (m = fresh(a))->state.at[0].block[BLOCK_STEP];
    f->blk.at[2].jump.state = 3;
    CHECK(finds(a, m, "state that does not exist"));
    f->blk.at[2].jump.state = 0;
    CHECK(finds(a, m, "state that does not exist"));
    f->blk.at[2].jump.kind = (IrJumpKind)9;
    CHECK(finds(a, m, "ends in no jump"));
    f = (m = fresh(a))->state.at[0].block[BLOCK_STEP];
    f->blk.at[0].jump.cond = IR_NONE;
    CHECK(finds(a, m, "no bool of this block"));
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
    check_broken_structures(&a);
    check_broken_functions(&a);
    arena_free(&a);
    return test_end("ir/verify");
}
