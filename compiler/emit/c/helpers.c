// SPDX-License-Identifier: Apache-2.0
// The stdlib functions that emitted C contains, copied from the headers that the VM and the constant folder use.  stdlib_text.h, which
// embed_tool.c generates, has the source of each function or type as a snippet.
#include <string.h>

#include "compiler/emit/c/unit.h"
#include "stdlib_text.h"

size_t helper_count(void) { return STDLIB_TEXT_COUNT; }

// Returns the index of a snippet in stdlib_text, or -1.
static int find_helper(const char *name)
{
    for (int i = 0; i < STDLIB_TEXT_COUNT; i++)
        if (strcmp(stdlib_text[i].name, name) == 0)
            return i;
    return -1;
}

// Counts a use of the snippet `name` of stdlib, so that it is emitted; returns `name`.
const char *helper_require(CUnit *u, const char *name)
{
    const int i = find_helper(name);

    if (i >= 0)
        u->helper[i]++;
    return name;
}

// Writes the snippet that defines type `name`.
void helper_write_type(CUnit *u, const char *name, Buf *out)
{
    const int i = find_helper(name);

    if (i >= 0)
        native_write(u, stdlib_text[i].text, out);
}

static bool is_word(char c)
{
    return c == '_' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

// Whether `name` occurs in `text` as a whole word.
static bool contains_word(const char *text, const char *name)
{
    const size_t n = strlen(name);

    for (const char *p = text; (p = strstr(p, name)) != NULL; p += n)
        if ((p == text || !is_word(p[-1])) && !is_word(p[n]))
            return true;
    return false;
}

// Counts a use of each snippet that occurs in `text`: the source of snippet i after calls have been replaced by C operators, so that some of
// its recorded dependencies may no longer occur.
static void require_dependencies(CUnit *u, int i, const char *text)
{
    for (int d = 0; d < stdlib_text[i].deps; d++) {
        const int dep = stdlib_text[i].dep[d];
        if (contains_word(text, stdlib_text[dep].name))
            u->helper[dep]++;
    }
}

// A conversion or NaN check with more calls than this is declared noinline.  For a machine of a thousand states gcc then takes half the time and
// produces half the code.
enum { INLINE_USES_MAX = 500 };
static const char noinline_macro[] =
    "#if defined(__GNUC__)\n"
    "#define SM_NOINLINE __attribute__((noinline))    // inlined, they make compilation slow\n"
    "#else\n"
    "#define SM_NOINLINE\n"
    "#endif\n";

// Whether snippet i is a function that is declared noinline.
static bool is_noinline(const CUnit *u, int i)
{
    const char *const name = stdlib_text[i].name;

    return !u->soft && u->helper[i] > INLINE_USES_MAX && (strncmp(name, "sm_to_", 6) == 0 || strncmp(name, "sm_read_", 8) == 0);
}

static void write_snippet(const CUnit *u, int i, const char *text, Buf *out)
{
    static const char inlined[] = "static inline ";
    const char *at = is_noinline(u, i) ? strstr(text, inlined) : NULL;

    if (at)
        buf_printf(out, "%.*sstatic SM_NOINLINE %s\n", (int)(at - text), text, at + sizeof inlined - 1);
    else
        buf_printf(out, "%s\n", text);
}

// Whether the snippet is left out here: helper_write_type writes SmRoll, and SmF64 is never written, because emitted C uses double or the soft
// library.
static bool is_type_snippet(int i) { return strcmp(stdlib_text[i].name, "SmF64") == 0 || strcmp(stdlib_text[i].name, "SmRoll") == 0; }

// Writes the snippets that were counted as used, and the snippets that they use. A snippet uses only earlier ones, so one pass from the last to
// the first finds all.
void helpers_write_required(CUnit *u, Buf *out)
{
    Buf text[STDLIB_TEXT_COUNT];

    for (int i = STDLIB_TEXT_COUNT - 1; i >= 0; i--) {
        buf_init(&text[i], u->arena);
        if (!u->helper[i] || is_type_snippet(i) || (u->soft && stdlib_text[i].native))
            continue;
        native_write(u, stdlib_text[i].text, &text[i]);
        require_dependencies(u, i, buf_text(&text[i]));
    }
    for (int i = 0; i < STDLIB_TEXT_COUNT; i++)
        u->uses_noinline |= is_noinline(u, i);
    if (u->uses_noinline)
        buf_printf(out, "%s\n", noinline_macro);
    if (u->key_bits)
        buf_printf(out, "// The key by which windows store and order a sample (sm_roll_key).\ntypedef int%u_t SmRollKey;\n\n", u->key_bits);
    for (int i = 0; i < STDLIB_TEXT_COUNT; i++)
        if (text[i].n > 0)
            write_snippet(u, i, buf_text(&text[i]), out);
}
