// SPDX-License-Identifier: Apache-2.0
// Tests that break one thing in a valid text.  A row contains the words to replace, their replacement, and the expected message.
#ifndef TESTS_IR_EDIT_H
#define TESTS_IR_EDIT_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compiler/ir/ir.h"
#include "tests/heap.h"

typedef struct Edit { const char *from, *to, *says; } Edit;

// A machine that contains every construct once.
static const char edit_text[] =
    "machine \"m\"\n"
    "vector \"m\" size 40 hash 0x00000001\n"
    "element U64 G at 0 is G\n"
    "element U32 S at 8 is S\n"
    "element F64 x at 16\n"
    "element U8 u writable at 24\n"
    "element bool flag writable at 25\n"
    "element F32 f writable at 28\n"
    "local I16 n writable = -5\n"
    "local F64 k = 0x3fb999999999999a\n"
    "time U64 T\n"
    "window w0 F64 size 10 stats avg\n"
    "window w1 F64 size 3 stats min max\n"
    "sample {\n"
    "b0:\n"
    "    %0 = load F64 x\n"
    "    sample w0, %0\n"
    "    %1 = stat avg w0\n"
    "    sample w1, %1\n"
    "    ret\n"
    "}\n"
    "state A\n"
    "step {\n"
    "b0:\n"
    "    %0 = load F64 x\n"
    "    %1 = const F64 5\n"
    "    %2 = lt F64 %0, %1\n"
    "    %3 = not %2\n"
    "    br %3, b1, b2\n"
    "b1:\n"
    "    %4 = stat min w1\n"
    "    %5 = cvt U8 %4\n"
    "    store U8 u, %5\n"
    "    jmp b3\n"
    "b2:\n"
    "    %6 = const bool 1\n"
    "    store bool flag, %6\n"
    "    goto B\n"
    "b3:\n"
    "    %7 = load F64 k\n"
    "    %8 = neg F64 %7\n"
    "    %9 = cvt F32 %8\n"
    "    store F32 f, %9\n"
    "    ret\n"
    "}\n"
    "exit {\n"
    "b0:\n"
    "    %0 = const I16 3\n"
    "    store I16 n, %0\n"
    "    ret\n"
    "}\n"
    "state B\n";

// Returns edit_text with the first `from` replaced; NULL if it has none.  The caller frees it.
static char *edit_apply(const Edit *e)
{
    const char *at = strstr(edit_text, e->from);
    char *text = at ? malloc(sizeof edit_text + strlen(e->to)) : NULL;

    if (text)
        sprintf(text, "%.*s%s%s", (int)(at - edit_text), edit_text, e->to, at + strlen(e->from));
    return text;
}

#endif
