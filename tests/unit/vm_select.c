// SPDX-License-Identifier: Apache-2.0
// From IR to images.  Instructions are as short as possible, a value is that at the time of its load, and what exceeds the format is reported.
// IR texts are compiled, compared with the disassembly, and run.
#include <stdlib.h>
#include <string.h>

#include "bytecode-vm/image.h"
#include "bytecode-vm/smvm.h"
#include "compiler/emit/bytecode/bytecode.h"
#include "stdlib/convert.h"
#include "tests/heap.h"
#include "tests/test.h"

typedef struct Work {
    Arena arena;
    StrPool strings;
    Diags diags;
    Buf image, listing;
    jmp_buf oom;
    SmvmMachine m;
    uint64_t sv[16];
    uint64_t *memory;
} Work;

static void open_work(Work *w)
{
    memset(w, 0, sizeof *w);
    arena_init(&w->arena, heap_alloc, NULL, &w->oom);
    str_pool_init(&w->strings, &w->arena);
    diags_init(&w->diags, &w->arena);
    buf_init(&w->image, &w->arena);
    buf_init(&w->listing, &w->arena);
}

static IrMachine *read(Work *w, const char *text)
{
    const char *error = NULL;
    IrMachine *m = ir_read(&w->arena, &w->strings, text, strlen(text), &error);

    if (m && !error)
        error = ir_verify(&w->arena, m);
    if (error)
        fprintf(stderr, "%s\n", error);
    CHECK(m && !error);
    return m;
}

static void print_instruction(void *context, const char *text, size_t length) { buf_put(context, text, length); }

static bool compile(Work *w, const char *text)
{
    IrMachine *m = read(w, text);

    if (!m || !emit_image(&w->arena, &w->diags, &m, 1, NULL, true, &w->image))
        return false;
    smvm_disasm((const uint8_t *)w->image.at, print_instruction, &w->listing);
    smvm_machine((const uint8_t *)w->image.at, 0, &w->m);
    w->memory = arena_alloc(&w->arena, smvm_ram_size(&w->m));
    return smvm_init(w->memory, smvm_ram_size(&w->m), &w->m, &(SmvmVector){w->sv, sizeof w->sv, 1}, 1) == SM_OK;
}

#define HEAD                                             \
    "machine \"t\"\nvector \"t\" size 128 hash 0x1\n"    \
    "element U64 G at 0 is G\nelement U32 S at 8 is S\n" \
    "element F64 a writable at 16\nelement F64 b writable at 24\nelement F32 f writable at 32\nelement U8 n writable at 36\n" \
    "element bool p writable at 37\nelement bool q writable at 38\nelement I64 i writable at 40\nlocal U16 l writable = 3\ntime U64 T\n"
#define STEP HEAD "state A\nstep {\nb0:\n"

// Returns the instructions of A.step without offsets, as "ldx a; out b; end".
static const char *instructions(Work *w)
{
    const char *at = strstr(buf_text(&w->listing), "A.step:\n");
    Buf out;

    buf_init(&out, &w->arena);
    for (at = at ? strchr(at, '\n') + 1 : ""; *at && *at != '\n'; at = strchr(at, '\n') + 1) {
        if (out.n > 0)
            buf_str(&out, "; ");
        for (const char *c = at + 8; *c != '\n'; c++)
            if (*c != ' ' || (c[-1] != ' ' && c[1] != ' ' && c[1] != '\n') || (c[-1] != ' ' && c[1] == ' '))
                buf_char(&out, *c);
    }
    return buf_text(&out);
}

static void expect_behind(const char *head, const char *body, const char *expected)
{
    Work w;

    open_work(&w);
    if (!compile(&w, format_in(&w.arena, "%s%s", head, body))) {
        CHECK(!"compiled");
        return;
    }
    if (strcmp(instructions(&w), expected) != 0)
        fprintf(stderr, "of: %s\nexpected: %s\ncame:     %s\n", body, expected, instructions(&w));
    CHECK(strcmp(instructions(&w), expected) == 0);
    arena_free(&w.arena);
}

static void expect(const char *body, const char *expected) { expect_behind(STEP, body, expected); }

// ---- selected instructions ----

static void test_loads_and_constants_become_operands(void)
{
    expect("%0 = load F64 a\n store F64 b, %0\n ret\n}", "ldx a; out b; end");
    expect("%0 = load U8 n\n %1 = cvt F64 %0\n %2 = const F64 1\n %3 = add F64 %1, %2\n %4 = cvt U8 %3\n store U8 n, %4\n ret\n}",
           "ldx n; addi 1; out n; end");
    expect("%0 = const bool 1\n store bool p, %0\n ret\n}", "ldx 1; out p; end");
    expect("%0 = load U8 n\n %1 = cvt F64 %0\n %2 = cvt bool %1\n store bool p, %2\n ret\n}", "ldx n; out p; end");
    expect("%0 = load bool p\n %1 = load bool q\n %2 = and %0, %1\n store bool p, %2\n ret\n}", "ldx p; ldy q; and; out p; end");
    expect("%0 = load F64 a\n %1 = cvt bool %0\n %2 = not %1\n store bool p, %2\n ret\n}", "ldx a; ldy 0; set not x <> y; out p; end");
    expect("%0 = load F64 a\n %1 = load F64 b\n %2 = gt F64 %0, %1\n store bool p, %2\n ret\n}", "ldx a; ldy b; set x > y; out p; end");
    expect("%0 = load F64 a\n %1 = sqrt F64 %0\n %2 = cvt F64 %1\n store F64 b, %2\n ret\n}", "ldx a; sqrt; out b; end");
    expect("%0 = load F64 a\n %1 = sin F64 %0\n %2 = cvt F64 %1\n store F64 b, %2\n ret\n}", "ldx a; fn sin; out b; end");
    // an elementary function changes Y, so b is loaded again
    expect("%0 = load F64 a\n %1 = load F64 b\n %2 = pow F64 %0, %1\n %3 = add F64 %2, %1\n %4 = cvt F64 %3\n store F64 b, %4\n ret\n}",
           "ldx a; ldy b; fn pow; ldy b; add; out b; end");
    expect("%0 = load U64 T\n %1 = cvt F64 %0\n %2 = const F64 -0\n %3 = div F64 %1, %2\n %4 = cvt F32 %3\n store F32 f, %4\n ret\n}",
           "ldx T; ldy -0; div; out f; end");
}

static void test_conversions_round(void)
{
    // A conversion in the middle of an expression rounds.
    expect("%0 = load F64 a\n %1 = cvt F32 %0\n %2 = cvt F64 %1\n store F64 b, %2\n ret\n}", "ldx a; cvt F32; out b; end");
    expect("%0 = load F64 a\n %1 = cvt U8 %0\n %2 = cvt F64 %1\n %3 = cvt U16 %2\n store U16 l, %3\n ret\n}", "ldx a; cvt U8; st l; end");
    expect("%0 = load F64 a\n %1 = cvt F32 %0\n %2 = cvt F64 %1\n %3 = add F64 %2, %2\n %4 = cvt F64 %3\n store F64 b, %4\n ret\n}",
           "ldx a; cvt F32; st local F32@0; ldy local F32@0; add; out b; end");
    // The conversion of NaN to 0 is emitted where a NaN is possible, and costs nothing elsewhere.
    expect("%0 = load F64 a\n %1 = sqrt F64 %0\n %2 = cvt F64 %1\n %3 = neg F64 %2\n %4 = cvt F64 %3\n store F64 b, %4\n ret\n}",
           "ldx a; sqrt; cvt F64; neg; out b; end");
    expect("%0 = const F64 0x7ff8000000000000\n %1 = cvt F64 %0\n %2 = const F64 0\n %3 = eq F64 %1, %2\n store bool p, %3\n ret\n}",
           "ldx nan; cvt F64; ldy 0; set x == y; out p; end");
    expect("%0 = load F64 a\n %1 = cvt F64 %0\n %2 = neg F64 %1\n %3 = cvt F64 %2\n store F64 b, %3\n ret\n}", "ldx a; neg; out b; end");
}

static void test_loads_precede_later_stores(void)
{
    // A load has the value at its time, even if a store follows before the value is used.
    expect("%0 = load F64 a\n %1 = load F64 b\n store F64 a, %1\n store F64 b, %0\n ret\n}", "ldx a; st local RAW@0; ldx b; out a; ldx local RAW@0; out b; end");
    expect("%0 = load F64 a\n %1 = neg F64 %0\n %2 = const F64 1\n store F64 a, %2\n %3 = cvt F64 %1\n store F64 b, %3\n ret\n}",
           "ldx a; st local RAW@0; ldx 1; out a; ldx local RAW@0; neg; out b; end");
    expect("%0 = load U8 n\n %1 = cvt F64 %0\n %2 = const U8 1\n store U8 n, %2\n %3 = add F64 %1, %1\n %4 = cvt F64 %3\n store F64 b, %4\n ret\n}",
           "ldx n; st local U8@2; ldx 1; out n; ldx local U8@2; ldy local U8@2; add; out b; end");
    expect("%0 = load bool p\n %1 = const bool 1\n store bool p, %1\n br %0, b1, b2\nb1:\n goto A\nb2:\n ret\n}",
           "ldx p; st local bool@2; ldx 1; out p; ldx local bool@2; jt 13; end; goto A");
    expect("%0 = const U8 1\n store U8 n, %0\n %1 = load U8 n\n %2 = cvt F64 %1\n store F64 b, %2\n ret\n}", "ldx 1; out n; out b; end");
    // A value that is used twice is computed once.
    expect("%0 = load F64 a\n %1 = sqrt F64 %0\n %2 = mul F64 %1, %1\n %3 = cvt F64 %2\n store F64 b, %3\n ret\n}", "ldx a; sqrt; st local RAW@0; ldy local RAW@0; mul; out b; end");
    // Slots are used again.  An unused value is not computed.
    expect("%0 = load F64 a\n %1 = sqrt F64 %0\n %2 = floor F64 %0\n %3 = add F64 %1, %2\n %4 = ceil F64 %0\n %5 = mul F64 %3, %4\n"
           "%6 = cvt F64 %5\n store F64 b, %6\n %7 = div F64 %5, %5\n ret\n}",
           "ldx a; floor; st local RAW@0; ldx a; sqrt; ldy local RAW@0; add; st local RAW@0; ldx a; ceil; ldy local RAW@0; mul; out b; end");
}

static void test_conditions_become_jumps(void)
{
    expect("%0 = load F64 a\n %1 = load F64 b\n %2 = lt F64 %0, %1\n %3 = load bool p\n %4 = or %2, %3\n %5 = not %4\n br %5, b1, b2\n"
           "b1:\n %6 = const bool 1\n store bool q, %6\n jmp b2\nb2:\n ret\n}",
           "ldx a; ldy b; jxy x < y, 14; ldx p; jt 14; ldx 1; out q; end");
    expect("%0 = load F64 a\n %1 = cvt bool %0\n br %1, b1, b2\nb1:\n goto A\nb2:\n ret\n}", "ldx a; jt 5; end; goto A");
    expect("%0 = const bool 1\n br %0, b1, b2\nb1:\n goto A\nb2:\n ret\n}", "goto A");
    // A condition that is also stored is a number.
    expect("%0 = load F64 a\n %1 = const F64 1\n %2 = ne F64 %0, %1\n store bool p, %2\n br %2, b1, b2\nb1:\n goto A\nb2:\n ret\n}",
           "ldx a; ldy 1; set x != y; out p; jt 11; end; goto A");
    // A jump to a transition becomes a transition.
    expect("%0 = load bool p\n br %0, b1, b2\nb1:\n %1 = const bool 0\n store bool q, %1\n jmp b3\nb2:\n %2 = const bool 1\n store bool q, %2\n"
           "jmp b3\nb3:\n goto A\n}",
           "ldx p; jf 10; ldx 0; out q; goto A; ldx 1; out q; goto A");
    expect("ret\n}", "");
    // A block that only jumps is skipped, an unreachable block is omitted, and a jump to the end becomes an end.
    expect("%0 = load bool p\n br %0, b1, b3\nb1:\n jmp b4\nb2:\n goto A\nb3:\n %1 = const bool 0\n store bool q, %1\n jmp b5\nb4:\n"
           "%2 = const bool 1\n store bool q, %2\n jmp b5\nb5:\n ret\n}",
           "ldx p; jt 9; ldx 0; out q; end; ldx 1; out q; end");
}

// Narrowed operations need no other opcodes, and their results no additional slots.
static void test_narrowed_operations_use_the_same_opcodes(void)
{
    expect("%0 = load U8 n\n %1 = cvt I32 %0\n %2 = const I32 1\n %3 = add I32 %1, %2\n %4 = cvt U8 %3\n store U8 n, %4\n ret\n}", "ldx n; addi 1; out n; end");
    expect("%0 = load U8 n\n %1 = cvt I64 %0\n %2 = cvt F64 %1\n %3 = cvt I16 %1\n %4 = cvt F64 %3\n %5 = sub F64 %2, %4\n store F64 b, %5\n ret\n}",
           "ldx n; neg; ldy n; add; out b; end");
    expect("%0 = load I64 i\n %1 = const I64 -5\n %2 = lt I64 %0, %1\n br %2, b1, b2\nb1:\n goto A\nb2:\n ret\n}", "ldx i; ldy -5; jxy x < y, 7; end; goto A");
    expect("%0 = load U8 n\n %1 = cvt I32 %0\n %2 = mul I32 %1, %1\n %3 = add I32 %2, %2\n %4 = cvt I64 %3\n store I64 i, %4\n ret\n}",
           "ldx n; ldy n; mul; st local I32@0; ldy local I32@0; add; out i; end");
    expect("%0 = load U8 n\n %1 = cvt I32 %0\n %2 = neg I32 %1\n %3 = cvt F64 %2\n store F64 b, %3\n ret\n}",
           "ldx n; neg; cvt I32; out b; end");        // 0, not -0
    expect("%0 = load U8 n\n %1 = cvt I32 %0\n %2 = neg I32 %1\n %3 = cvt F32 %2\n store F32 f, %3\n ret\n}",
           "ldx n; neg; cvt I32; out f; end");
    expect("%0 = load F32 f\n %1 = add F32 %0, %0\n %2 = cvt F32 %1\n %3 = div F32 %2, %0\n %4 = cvt F32 %3\n store F32 f, %4\n ret\n}",
           "ldx f; ldy f; add; cvt F32; div; out f; end");
    // From any type to any other: conversions that can change the number remain; those that the destination repeats are removed.
    expect("%0 = load I64 i\n %1 = cvt I32 %0\n %2 = cvt U16 %1\n store U16 l, %2\n ret\n}", "ldx i; st l; end");
    expect("%0 = load I64 i\n %1 = cvt I32 %0\n %2 = cvt I8 %1\n %3 = cvt U16 %2\n store U16 l, %3\n ret\n}", "ldx i; cvt I8; st l; end");
    expect("%0 = load F32 f\n %1 = cvt I8 %0\n %2 = cvt F32 %1\n store F32 f, %2\n ret\n}", "ldx f; cvt I8; out f; end");
    expect("%0 = load I64 i\n %1 = cvt F32 %0\n %2 = cvt F64 %1\n store F64 b, %2\n ret\n}", "ldx i; cvt F32; out b; end");
    expect("%0 = load I64 i\n %1 = cvt bool %0\n %2 = cvt I32 %1\n %3 = cvt I64 %2\n store I64 i, %3\n ret\n}", "ldx i; cvt bool; out i; end");
    expect("%0 = load I64 i\n %1 = cvt U8 %0\n %2 = cvt bool %1\n br %2, b1, b2\nb1:\n goto A\nb2:\n ret\n}", "ldx i; cvt U8; jt 7; end; goto A");
}

// ---- what X and Y hold ----

static void test_registers_are_reused(void)
{
    // Guards on the same variable load it once, whatever their branches contain.  The branches follow the guards.
    expect("%0 = load F64 a\n %1 = const F64 5\n %2 = gt F64 %0, %1\n br %2, b1, b2\nb1:\n goto A\nb2:\n"
           "%3 = load F64 a\n %4 = const F64 1\n %5 = lt F64 %3, %4\n br %5, b3, b4\nb3:\n goto A\nb4:\n ret\n}",
           "ldx a; jxn x > 5, 9; jxn x < 1, 9; end; goto A");
    expect("%0 = load U8 n\n %1 = const U8 5\n %2 = gt U8 %0, %1\n br %2, b1, b2\nb1:\n %3 = const bool 1\n store bool p, %3\n goto A\nb2:\n"
           "%4 = load U8 n\n %5 = const U8 1\n %6 = lt U8 %4, %5\n br %6, b3, b4\nb3:\n goto A\nb4:\n ret\n}",
           "ldx n; jxn x > 5, 9; jxn x < 1, 13; end; ldx 1; out p; goto A");
    // Both registers, in either order.
    expect("%0 = load F64 a\n %1 = load F64 b\n %2 = gt F64 %0, %1\n br %2, b1, b2\nb1:\n goto A\nb2:\n"
           "%3 = load F64 a\n %4 = load F64 b\n %5 = gt F64 %4, %3\n br %5, b3, b4\nb3:\n goto A\nb4:\n ret\n}",
           "ldx a; ldy b; jxy x > y, 9; jxy x < y, 9; end; goto A");
    // It is loaded again after a label, and after a store to it, unless the load would read exactly the stored value.
    expect("%0 = load U8 n\n %1 = const U8 5\n %2 = gt U8 %0, %1\n br %2, b1, b2\nb1:\n %3 = const bool 1\n store bool p, %3\n jmp b2\nb2:\n"
           "%4 = load U8 n\n store U8 n, %4\n ret\n}",
           "ldx n; jxn not x > 5, 9; ldx 1; out p; ldx n; out n; end");
    expect("%0 = load U8 n\n %1 = cvt F64 %0\n %2 = const F64 1\n %3 = add F64 %1, %2\n %4 = cvt U8 %3\n store U8 n, %4\n"
           "%5 = load U8 n\n %6 = const U8 9\n %7 = gt U8 %5, %6\n br %7, b1, b2\nb1:\n goto A\nb2:\n ret\n}",
           "ldx n; addi 1; out n; ldx n; jxn x > 9, 12; end; goto A");
    expect("%0 = load U8 n\n %1 = cvt U16 %0\n store U16 l, %1\n %2 = load U16 l\n %3 = cvt U8 %2\n store U8 n, %3\n ret\n}", "ldx n; st l; out n; end");
    expect("%0 = load F64 a\n store F64 b, %0\n %1 = load F64 b\n store F64 a, %1\n %2 = load F64 a\n store F64 b, %2\n ret\n}",
           "ldx a; out b; out a; out b; end");
    // A number with several uses is loaded once.
    expect("%0 = const bool 0\n store bool p, %0\n store bool q, %0\n %1 = const U8 0\n store U8 n, %1\n ret\n}", "ldx 0; out p; out q; out n; end");
}

// A converted and stored value that is used again is read from its variable while the variable contains it.
static void test_stored_values_are_read_from_their_variable(void)
{
    const char *counts = "%0 = load U8 n\n %1 = cvt F64 %0\n %2 = const F64 1\n %3 = add F64 %1, %2\n %4 = cvt U8 %3\n store U8 n, %4\n";
    Work w;

    open_work(&w);
    expect(format_in(&w.arena, "%s%s", counts, "%5 = cvt F64 %4\n %6 = load F64 a\n %7 = mul F64 %6, %5\n %8 = cvt F64 %7\n store F64 b, %8\n ret\n}"),
           "ldx n; addi 1; out n; ldx a; ldy n; mul; out b; end");
    expect(format_in(&w.arena, "%s%s", counts, "%5 = const U8 0\n store U8 n, %5\n %6 = cvt F64 %4\n store F64 b, %6\n ret\n}"),
           "ldx n; addi 1; cvt U8; out n; st local U8@2; ldx 0; out n; ldx local U8@2; out b; end");
    arena_free(&w.arena);
}

// `not` is applied to the operands of `and` and `or` if that costs nothing.
static void test_negation_moves_inward(void)
{
    const char *chain = "%0 = load F64 a\n %1 = const F64 1\n %2 = ge F64 %0, %1\n %3 = const F64 9\n %4 = le F64 %0, %3\n %5 = and %2, %4\n";
    Work w;

    open_work(&w);
    expect(format_in(&w.arena, "%s%s", chain, "%6 = not %5\n store bool p, %6\n ret\n}"),
           "ldx a; ldy 9; set not x <= y; st local bool@2; ldx a; ldy 1; set not x >= y; ldy local bool@2; or; out p; end");
    expect(format_in(&w.arena, "%s%s", chain, "%6 = load bool q\n %7 = or %5, %6\n %8 = not %7\n store bool p, %8\n ret\n}"),
           "ldx a; ldy 9; set x <= y; st local bool@2; ldx a; ldy 1; set x >= y; ldy local bool@2; and; ldy q; or; ldy 0; set not x <> y; out p; end");
    arena_free(&w.arena);
}

// A statistic is not computed again while X contains it.
static void test_statistic_in_x_is_reused(void)
{
    expect_behind(HEAD "window w0 F64 size 4 stats min max\nsample {\nb0:\n %0 = load F64 a\n sample w0, %0\n ret\n}\nstate A\nstep {\nb0:\n",
                  "%0 = stat min w0\n %1 = const F64 5\n %2 = gt F64 %0, %1\n br %2, b1, b2\nb1:\n goto A\nb2:\n"
                  "%3 = stat min w0\n %4 = const F64 1\n %5 = lt F64 %3, %4\n br %5, b3, b4\nb3:\n goto A\nb4:\n"
                  "%6 = stat max w0\n %7 = stat min w0\n %8 = sub F64 %6, %7\n %9 = cvt F64 %8\n store F64 b, %9\n ret\n}",
                  "stat smallest, w0; jxn x > 5, 25; jxn x < 1, 25; st local RAW@0; stat largest, w0; ldy local RAW@0; sub; out b; end; goto A");
}

// An integer result that is -0 in binary64 becomes 0 where it is converted to a float.  No other use can observe the sign of a zero.
static void test_negative_zero_becomes_zero(void)
{
    expect("%0 = load U8 n\n %1 = cvt I32 %0\n %2 = const I32 -3\n %3 = mul I32 %1, %2\n %4 = add I32 %3, %3\n %5 = cvt F64 %4\n store F64 b, %5\n ret\n}",
           "ldx n; ldy -3; mul; st local I32@0; ldy local I32@0; add; cvt I32; out b; end");
    expect("%0 = load U8 n\n %1 = cvt I32 %0\n %2 = const I32 3\n %3 = mul I32 %1, %2\n %4 = cvt F64 %3\n store F64 b, %4\n ret\n}",
           "ldx n; ldy 3; mul; out b; end");
    expect("%0 = load I64 i\n %1 = cvt I32 %0\n %2 = const I32 3\n %3 = mul I32 %2, %1\n %4 = cvt F64 %3\n store F64 b, %4\n ret\n}",
           "ldx i; cvt I32; ldy 3; mul; out b; end");
    expect("%0 = load I64 i\n %1 = cvt I32 %0\n %2 = mul I32 %1, %1\n %3 = cvt U8 %2\n store U8 n, %3\n %4 = cvt F32 %2\n store F32 f, %4\n ret\n}",
           "ldx i; cvt I32; st local I32@0; ldy local I32@0; mul; out n; cvt I32; out f; end");
    expect("%0 = load U8 n\n %1 = cvt I32 %0\n %2 = neg I32 %1\n %3 = const I32 5\n %4 = lt I32 %2, %3\n store bool p, %4\n ret\n}",
           "ldx n; neg; ldy 5; set x < y; out p; end");
}

// Constants become operands of additions and jumps.  The deeper operand is computed first; a difference is reversed if that saves a slot.
static void test_operands_are_ordered(void)
{
    expect("%0 = load F64 a\n %1 = const F64 -3\n %2 = sub F64 %0, %1\n %3 = add F64 %1, %2\n %4 = cvt F64 %3\n store F64 b, %4\n ret\n}",
           "ldx a; addi 3; subi 3; out b; end");
    expect("%0 = load F64 a\n %1 = const F64 0x3fe0000000000000\n %2 = sub F64 %0, %1\n %3 = const F64 0\n %4 = sub F64 %2, %3\n %5 = cvt F64 %4\n store F64 b, %5\n ret\n}",
           "ldx a; ldy 0.5; sub; ldy 0; sub; out b; end");
    expect("%0 = load F64 a\n %1 = sqrt F64 %0\n %2 = load F64 b\n %3 = sub F64 %2, %1\n %4 = cvt F64 %3\n store F64 b, %4\n ret\n}",
           "ldx a; sqrt; neg; ldy b; add; out b; end");
    expect("%0 = load F64 a\n %1 = sqrt F64 %0\n %2 = load F64 b\n %3 = div F64 %2, %1\n %4 = cvt F64 %3\n store F64 b, %4\n ret\n}",
           "ldx a; sqrt; st local RAW@0; ldx b; ldy local RAW@0; div; out b; end");
    expect("%0 = load F64 a\n %1 = sqrt F64 %0\n %2 = load F64 b\n %3 = lt F64 %2, %1\n br %3, b1, b2\nb1:\n goto A\nb2:\n ret\n}",
           "ldx a; sqrt; ldy b; jxy x > y, 8; end; goto A");
    expect("%0 = const F64 5\n %1 = load F64 b\n %2 = le F64 %0, %1\n br %2, b1, b2\nb1:\n goto A\nb2:\n ret\n}", "ldx b; jxn x >= 5, 6; end; goto A");
    expect("%0 = const F64 16780383\n %1 = load F64 b\n %2 = eq F64 %1, %0\n br %2, b1, b2\nb1:\n goto A\nb2:\n ret\n}",
           "ldx b; jxn x == 16780383, 9; end; goto A");
    expect("%0 = const F64 16780384\n %1 = load F64 b\n %2 = eq F64 %1, %0\n br %2, b1, b2\nb1:\n goto A\nb2:\n ret\n}",
           "ldx b; ldy 16780384; jxy x == y, 7; end; goto A");
}

// ---- what runs ----

static void run_step(Work *w, uint64_t g)
{
    w->sv[0] = g;
    CHECK(smvm_step((SmVm *)w->memory, w->sv) == SM_OK);
}

// Runs two step functions, one of them narrowed, on the same inputs: the results are equal.
static void expect_equal_runs(const char *wide, const char *narrow)
{
    uint64_t seed = 1;
    Work w[2];

    for (int k = 0; k < 2; k++) {
        open_work(&w[k]);
        CHECK(compile(&w[k], format_in(&w[k].arena, "%s%s", STEP, k ? narrow : wide)));
    }
    for (uint64_t g = 1; g < 2000 && w[0].memory && w[1].memory; g++) {
        for (unsigned i = 2; i < 6; i++) {
            seed = seed * 6364136223846793005u + 1442695040888963407u;
            w[0].sv[i] = w[1].sv[i] = seed >> (i == 5 ? 12 + seed % 40 : 0);
        }
        run_step(&w[0], g);
        run_step(&w[1], g);
        CHECK(memcmp(w[0].sv, w[1].sv, sizeof w[0].sv) == 0);
    }
    arena_free(&w[0].arena);
    arena_free(&w[1].arena);
}

static void test_narrowed_code_computes_the_same(void)
{
    expect_equal_runs("%0 = load U8 n\n %1 = cvt F64 %0\n %2 = const F64 -3\n %3 = mul F64 %1, %2\n %4 = add F64 %3, %1\n %5 = mul F64 %4, %4\n %6 = cvt I64 %5\n store I64 i, %6\n"
          "%7 = sign F64 %3\n %8 = add F64 %7, %2\n %9 = cvt F64 %8\n store F64 b, %9\n ret\n}",
          "%0 = load U8 n\n %1 = cvt I32 %0\n %2 = const I32 -3\n %3 = mul I32 %1, %2\n %4 = add I32 %3, %1\n %5 = mul I32 %4, %4\n %6 = cvt I64 %5\n store I64 i, %6\n"
          "%7 = sign I32 %3\n %8 = add I32 %7, %2\n %9 = cvt F64 %8\n store F64 b, %9\n ret\n}");
    expect_equal_runs("%0 = load F32 f\n %1 = cvt F64 %0\n %2 = load U8 n\n %3 = cvt F64 %2\n %4 = div F64 %1, %3\n %5 = cvt F32 %4\n store F32 f, %5\n ret\n}",
          "%0 = load F32 f\n %2 = load U8 n\n %3 = cvt F32 %2\n %4 = div F32 %0, %3\n %5 = cvt F32 %4\n store F32 f, %5\n ret\n}");
    expect_equal_runs("%0 = load F32 f\n %1 = cvt F64 %0\n %2 = mul F64 %1, %1\n %3 = cvt F32 %2\n %4 = cvt F64 %3\n %5 = sub F64 %4, %1\n %6 = cvt F32 %5\n store F32 f, %6\n ret\n}",
          "%0 = load F32 f\n %2 = mul F32 %0, %0\n %3 = cvt F32 %2\n %5 = sub F32 %3, %0\n %6 = cvt F32 %5\n store F32 f, %6\n ret\n}");
    expect_equal_runs("%0 = load I64 i\n %1 = cvt F64 %0\n %2 = const F64 1000\n %3 = ge F64 %1, %2\n store bool p, %3\n %4 = abs F64 %1\n %5 = min F64 %4, %2\n %6 = cvt U16 %5\n store U16 l, %6\n ret\n}",
          "%0 = load I64 i\n %2 = const I64 1000\n %3 = ge I64 %0, %2\n store bool p, %3\n %4 = abs I64 %0\n %5 = min I64 %4, %2\n %6 = cvt U16 %5\n store U16 l, %6\n ret\n}");
}

// 1 + 1/2 + 1/3 + …, one expression with a thousand nested operations in the left operand, or in the right one.
static void test_deep_expression_is_computed(bool left)
{
    double expected = 0;
    Buf text;
    Work w;

    open_work(&w);
    buf_init(&text, &w.arena);
    buf_str(&text, STEP "%z0 = load F64 a\n");
    for (int i = 1; i <= 1000; i++) {
        buf_printf(&text, "%%c%d = const F64 %d\n %%d%d = div F64 %%z0, %%c%d\n", i, i, i, i);
        buf_printf(&text, left ? "%%z%d = add F64 %%z%d, %%d%d\n" : "%%z%d = sub F64 %%d%d, %%z%d\n", i, left ? i - 1 : i, left ? i : i - 1);
    }
    buf_str(&text, "%r = cvt F64 %z1000\n store F64 b, %r\n ret\n}");
    if (!compile(&w, buf_text(&text))) {
        CHECK(!"compiled");
        return;
    }
    w.sv[2] = sm_bits(3);
    run_step(&w, 1);
    expected = 3;
    for (int i = 1; i <= 1000; i++)
        expected = left ? expected + 3.0 / i : 3.0 / i - expected;
    CHECK(sm_from_bits(w.sv[3]) == expected);
    CHECK(w.m.locals < 8 * 8);
    arena_free(&w.arena);
}

// ((p and q) and p) and …, nested deeper than the code generator can postpone operations.
static void test_deep_condition_is_computed(void)
{
    Buf text;
    Work w;

    open_work(&w);
    buf_init(&text, &w.arena);
    buf_str(&text, STEP "%p = load bool p\n%q = load bool q\n %s0 = or %p, %q\n");
    for (int i = 1; i <= 1000; i++)
        buf_printf(&text, "%%s%d = %s %%s%d, %%%s\n", i, i % 3 ? "and" : "or", i - 1, i % 2 ? "p" : "q");
    buf_str(&text, "br %s1000, b1, b2\nb1:\n %x = const U8 1\n store U8 n, %x\n ret\nb2:\n %y = const U8 2\n store U8 n, %y\n ret\n}");
    if (!compile(&w, buf_text(&text))) {
        CHECK(!"compiled");
        return;
    }
    for (unsigned in = 0; in < 4; in++) {
        bool p = in & 1, q = in >> 1, expected = p || q;
        for (int i = 1; i <= 1000; i++)
            expected = i % 3 ? expected && (i % 2 ? p : q) : expected || (i % 2 ? p : q);
        memcpy((uint8_t *)w.sv + 37, &(const uint8_t[]){p, q}, 2);
        run_step(&w, in + 1);
        CHECK(((uint8_t *)w.sv)[36] == (expected ? 1 : 2));
    }
    arena_free(&w.arena);
}

// An expression converts a number to all types, and there are locals of all types: no two of them share memory.
static void test_slots_do_not_overlap(void)
{
    static const double expected[SM_TYPE_COUNT] = {-3, -3, -3, -3, 0, 0, 0, 0, -3.5, -3.5, 1};
    double sum = 0;
    Buf text;
    Work w;

    open_work(&w);
    buf_init(&text, &w.arena);
    buf_str(&text, HEAD);
    for (int t = 0; t < SM_TYPE_COUNT; t++)
        buf_printf(&text, "local %s l%d writable = %d\n", sm_type_info[t].spelling, t, t > 0);
    buf_str(&text, "state A\nstep {\nb0:\n%x = load F64 a\n%s = const F64 0\n");
    for (int t = 0; t < SM_TYPE_COUNT; t++)
        buf_printf(&text, "%%c%d = cvt %s %%x\n%%d%d = cvt F64 %%c%d\n", t, sm_type_info[t].spelling, t, t);
    for (int t = 0; t < SM_TYPE_COUNT; t++)
        buf_printf(&text, "%%e%d = mul F64 %%d%d, %%d%d\n%%f%d = add F64 %%e%d, %%d%d\n", t, t, t, t, t, t);
    for (int t = 0; t < SM_TYPE_COUNT; t++) {
        buf_printf(&text, "%%s%d = add F64 %%%s%d, %%f%d\n", t, t ? "s" : "f", t ? t - 1 : 0, t);
        sum += expected[t] * expected[t] + expected[t] + (t ? 0 : expected[t] * expected[t] + expected[t]);
    }
    buf_printf(&text, "%%r = cvt F64 %%s%d\nstore F64 b, %%r\nret\n}", SM_TYPE_COUNT - 1);
    CHECK(compile(&w, buf_text(&text)));
    if (w.memory == NULL)
        return;
    w.sv[2] = sm_bits(-3.5);
    run_step(&w, 1);
    CHECK(sm_from_bits(w.sv[3]) == sum);
    for (uint32_t i = 0, at = 0; i < smvm_variables(&w.m); i++) {    // the locals still have their initial values
        SmvmVariable is;
        SmvmLocation place;
        SmvmName name = smvm_variable(&w.m, i, &is, &place);
        const uint8_t *p = (const uint8_t *)smvm_locals((SmVm *)w.memory) + place.offset;
        if (name.size >= 2 && is == SMVM_IS_LOCAL && at < SM_TYPE_COUNT)
            CHECK(sm_from_bits(sm_bits(sm_load(place.type, p))) == (double)(at++ > 0));
    }
    arena_free(&w.arena);
}

// Code of more than 64 KB, with a function that begins beyond 64 KB.
static void test_long_code_runs(void)
{
    Buf text;
    Work w;

    open_work(&w);
    buf_init(&text, &w.arena);
    buf_str(&text, STEP);
    for (int i = 0; i < 25000; i++)
        buf_printf(&text, "%%%d = const F64 %d\n store F64 a, %%%d\n", i, i, i);
    buf_str(&text, "goto B\n}\nexit {\nb0:\n%0 = const F64 7\nstore F64 b, %0\nret\n}\n"
                   "state B\nstep {\nb0:\n%0 = const F64 8\nstore F64 b, %0\nret\n}");
    CHECK(compile(&w, buf_text(&text)) == (SMVM_IMAGE_MAX > 0x20000));       // a smaller target refuses it
    if (SMVM_IMAGE_MAX < 0x20000) {
        arena_free(&w.arena);
        return;
    }
    CHECK(w.m.width == 3 && w.m.code_size > 0x10000);
    run_step(&w, 1);
    CHECK(sm_from_bits(w.sv[2]) == 24999 && sm_from_bits(w.sv[3]) == 7);
    run_step(&w, 2);
    CHECK(sm_from_bits(w.sv[2]) == 24999 && sm_from_bits(w.sv[3]) == 8);
    arena_free(&w.arena);
}

// A varint that was written is read back, and has the shortest form.
static void test_varints_are_read_back(void)
{
    static const uint32_t at[] = {0, 95, 96, 97, 3167, 3168, 3169, 0x200c5f, 0x200c60, 0x123456, 0xfffff0, 0x1000c5f};
    Work w;

    open_work(&w);
    for (unsigned i = 0; i < sizeof at / sizeof *at; i++) {
        SmvmAt from = 0;
        uint32_t value = 0;
        Buf b;
        buf_init(&b, &w.arena);
        bc_write_varint(&b, at[i]);
        CHECK(smvm_read_varint((const uint8_t *)b.at, &from, (SmvmAt)b.n, &value) && from == b.n && value == at[i]);
        CHECK(b.n == (at[i] < 96 ? 1 : at[i] < 3168 ? 2 : 4));
    }
    arena_free(&w.arena);
}

// Whole constants are encoded in the code; every other value is stored once, in the table of its type.
static void test_constants_are_stored_once(void)
{
    Buf text;
    Work w;

    open_work(&w);
    buf_init(&text, &w.arena);
    buf_str(&text, STEP);
    for (int i = 0; i < 600; i++)
        buf_printf(&text, "%%c%d = const F64 %d\n store F64 a, %%c%d\n", i, i % 300, i);
    for (int i = 0; i < 9; i++)
        buf_printf(&text, "%%d%d = const F64 0x3fb999999999999a\n store F64 b, %%d%d\n", i, i);
    buf_str(&text, "ret\n}");
    CHECK(compile(&w, buf_text(&text)));
    if (w.memory == NULL)
        return;
    CHECK(w.m.outputs == 2 && w.m.f64s == 1 && w.m.f32s == 0);
    CHECK(w.m.init_size == 3 + 2);                    // only one local is not zero
    arena_free(&w.arena);
}

// ---- what does not fit ----

static bool refused_as(const char *text, DiagCode code, const char *words)
{
    bool refused;
    Work w;

    open_work(&w);
    refused = !compile(&w, text) && w.diags.list.n == 1 && w.diags.list.at[0]->code == code && strstr(w.diags.list.at[0]->text, words);
    if (w.diags.list.n > 0 && !refused)
        fprintf(stderr, "%s\n", w.diags.list.at[0]->text);
    arena_free(&w.arena);
    return refused;
}

static void test_too_many_machines_are_refused(void)
{
    IrMachine *m[90];
    Work w;

    open_work(&w);
    m[0] = read(&w, STEP "ret\n}");
    for (int i = 1; i < 90; i++)
        m[i] = m[0];
    CHECK(emit_image(&w.arena, &w.diags, m, 63, NULL, true, &w.image));
    w.image.n = 0;
    CHECK(!emit_image(&w.arena, &w.diags, m, 90, NULL, true, &w.image));
    CHECK(w.diags.list.n == 1 && w.diags.list.at[0]->code == DIAG_image_size && strstr(w.diags.list.at[0]->text, "machines"));
    arena_free(&w.arena);
}

static void test_too_much_memory_is_refused(void)
{
    Buf text;
    Work w;

    open_work(&w);
    buf_init(&text, &w.arena);
    buf_str(&text, HEAD);
    for (int i = 0; i < 1400; i++)
        buf_printf(&text, "window w%d F64 size 100000 stats median\n", i);
    buf_str(&text, "sample {\nb0:\n %0 = load F64 a\n");
    for (int i = 0; i < 1400; i++)
        buf_printf(&text, "sample w%d, %%0\n", i);
    buf_str(&text, "ret\n}\nstate A\n");
    CHECK(refused_as(buf_text(&text), DIAG_image_memory, "2 GB"));
    arena_free(&w.arena);
}

static void test_image_limits_are_reported(void)
{
    CHECK(refused_as("machine \"t\"\nvector \"t\" size 1048584 hash 0x1\nelement U64 G at 0 is G\nelement U32 S at 8 is S\n"
                     "element bool far writable at 1048576\ntime U64 T\nstate A\nstep {\nb0:\n%0 = const bool 1\n store bool far, %0\n ret\n}",
                     DIAG_image_limit, "elements"));
    test_too_many_machines_are_refused();
    test_too_much_memory_is_refused();
}

int main(void)
{
    test_loads_and_constants_become_operands();
    test_conversions_round();
    test_loads_precede_later_stores();
    test_conditions_become_jumps();
    test_narrowed_operations_use_the_same_opcodes();
    test_registers_are_reused();
    test_stored_values_are_read_from_their_variable();
    test_negation_moves_inward();
    test_statistic_in_x_is_reused();
    test_negative_zero_becomes_zero();
    test_operands_are_ordered();
    test_narrowed_code_computes_the_same();
    test_deep_expression_is_computed(true);
    test_deep_expression_is_computed(false);
    test_deep_condition_is_computed();
    test_slots_do_not_overlap();
    test_long_code_runs();
    test_varints_are_read_back();
    test_constants_are_stored_once();
    test_image_limits_are_reported();
    return test_end("vm_select");
}
