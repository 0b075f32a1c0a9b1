// SPDX-License-Identifier: Apache-2.0
// The functions of stdlib that emitted C carries with it, quoted from the headers that the VM and the constant folder use.
#include <string.h>

#include "compiler/emit/c/unit.h"
#include "stdlib_text.h"

size_t helper_count(void) { return STDLIB_TEXT_COUNT; }

static int find(const char *name)
{
    for (int i = 0; i < STDLIB_TEXT_COUNT; i++)
        if (strcmp(stdlib_text[i].name, name) == 0)
            return i;
    return -1;
}

// A text needs only texts before it, so one walk downwards finds all.
static void mark(bool *used, int i)
{
    used[i] = true;
    for (; i >= 0; i--)
        for (int d = 0; used[i] && d < stdlib_text[i].deps; d++)
            used[stdlib_text[i].dep[d]] = true;
}

const char *helper_use(CUnit *u, const char *name)
{
    const int i = find(name);

    if (i >= 0 && !u->helper[i])
        mark(u->helper, i);
    return name;
}

static bool is_word(char c)
{
    return c == '_' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

// The text with `double` for SmF64: emitted C needs no second name for it.
static void put_text(const char *text, Buf *out)
{
    for (const char *p = text; *p;) {
        const bool starts = p == text || !is_word(p[-1]);
        if (starts && strncmp(p, "SmF64", 5) == 0 && !is_word(p[5])) {
            buf_str(out, "double");
            p += 5;
        } else {
            buf_char(out, *p++);
        }
    }
}

void helper_type_put(const char *name, Buf *out)
{
    const int i = find(name);

    if (i >= 0)
        put_text(stdlib_text[i].text, out);
}

void helpers_put(const CUnit *u, Buf *out)
{
    for (int i = 0; i < STDLIB_TEXT_COUNT; i++) {
        const bool is_type = strncmp(stdlib_text[i].name, "Sm", 2) == 0;
        if (!u->helper[i] || is_type)
            continue;
        put_text(stdlib_text[i].text, out);
        buf_char(out, '\n');
    }
}
