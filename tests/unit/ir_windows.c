// SPDX-License-Identifier: Apache-2.0
// Which roll calls share a window.  A machine has very many samples, each with one difference, and then all of them again: enough that different
// samples collide in the hash table.
#include <stdlib.h>
#include <string.h>

#include "compiler/compile.h"
#include "tests/heap.h"
#include "tests/test.h"

static const char *const relation[] = {"<", "<=", ">", ">="};
static const char *const function[] = {"abs", "floor", "ceil", "trunc", "round", "sqrt", "sign"};
static const char *const statistic[] = {"avg", "median", "min", "max", "range"};
static const char *const operator[] = {"+", "-", "*", "/", "==", "!=", "<", "and", "or"};
static const char *const variable[] = {"x", "y", "p", "G", "S", "T"};

enum { SIZES = 40 };
#define COUNT(list) (sizeof(list) / sizeof *(list))

// Adds a call with the sample e for each size.  Returns their number.
static size_t put_calls(Buf *b, const char *e)
{
    for (int size = 1; size <= SIZES; size++)
        buf_printf(b, "    z = roll_max(%s, %d)\n", e, size);
    return SIZES;
}

static size_t put_all(Buf *b)
{
    Arena *a = b->arena;
    size_t n = 0;

    for (size_t i = 0; i < COUNT(relation) * COUNT(relation) * COUNT(relation); i++)
        n += put_calls(b, format_in(a, "x %s y %s p %s x", relation[i % 4], relation[i / 4 % 4], relation[i / 16]));
    for (size_t i = 0; i < COUNT(function); i++)
        n += put_calls(b, format_in(a, "%s(x)", function[i]));
    for (size_t i = 0; i < COUNT(operator); i++)
        n += put_calls(b, format_in(a, "x %s y", operator[i]));
    for (size_t i = 0; i < COUNT(variable); i++)
        n += put_calls(b, variable[i]);
    for (int i = 0; i < 50; i++)
        n += put_calls(b, format_in(a, "x + %d.25", i));
    for (size_t i = 0; i < COUNT(statistic); i++)
        for (int inner = 1; inner <= 10; inner++)
            n += put_calls(b, format_in(a, "roll_%s(x, %d)", statistic[i], inner));
    for (size_t i = 0; i < 7 * 7 * 7 * 7; i++, n++)
        buf_printf(b, "    z = roll_min(%s(%s(%s(%s(x)))), 9)\n", function[i % 7], function[i / 7 % 7], function[i / 49 % 7], function[i / 343]);
    for (int size = SIZES + 1; size < 4000; size++, n++)
        buf_printf(b, "    z = roll_min(x, %d)\n", size);
    n += put_calls(b, "-x");
    n += put_calls(b, "not x");
    return n;
}

static void check_sharing(Session *s)
{
    MachineInput in = {0};
    size_t different;
    IrMachine *m;
    Program *p;
    Buf text;

    buf_init(&text, &s->arena);
    buf_str(&text, "[state_vector]\nU64 G\nU32 S\nF64 x\nF64 y\nF64 z\nbool p\n[A]\n.step\n");
    different = put_all(&text);
    put_all(&text);
    in.sm = source_new(&s->arena, "w.sm", buf_text(&text), text.n);
    CHECK((p = session_program(s, &in)) != NULL);
    if (!p)
        return;
    m = ir_build(&s->arena, p);
    // Of the samples, only `x` is sampled with sizes 1 … 10 inside other calls, and it is one of the variables.
    CHECK(m->window.n == different);
    CHECK(ir_verify(&s->arena, m) == NULL);
}

int main(void)
{
    jmp_buf oom;
    Session s;

    if (setjmp(oom) != 0)
        return 3;
    session_init(&s, heap_alloc, NULL, &oom);
    check_sharing(&s);
    session_free(&s);
    return test_end("ir_windows");
}
