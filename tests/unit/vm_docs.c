// SPDX-License-Identifier: Apache-2.0
// Checks that docs/bytecode.md agrees with the tables, row by row, and that its example of embedding compiles and runs.
#include <string.h>

#include "bytecode-vm/image.h"
#include "bytecode-vm/smvm.h"
#include "tests/test.h"
#include "tests/unit/vm_build.h"

SmVm *start(const uint8_t *image, uint32_t size, uint32_t layout);
bool cycle(SmVm *vm);

#include "embed.c"            // the page's example

static char page[100000];

static bool page_contains(const char *text)
{
    if (!strstr(page, text))
        fprintf(stderr, "docs/bytecode.md lacks: %s\n", text);
    return strstr(page, text) != NULL;
}

static void load_page(void)
{
    FILE *f = fopen("docs/bytecode.md", "rb");

    CHECK(f && fread(page, 1, sizeof page - 1, f) > 0);
    if (f)
        fclose(f);
}

// Writes the letters of an operand shape as the page has them.
static void put_shape(char *out, uint32_t shape)
{
    static const char letter[] = "LENFDOSKWTMJ";

    *out = '\0';
    for (unsigned i = 0; i < sizeof letter - 1; i++)
        if (shape >> i & 1) {
            if (*out)
                strcat(out, " ");
            strncat(out, letter + i, 1);
        }
}

static void check_opcode(const char *name, unsigned first, unsigned last)
{
    char row[100], shape[40], number[20];

    put_shape(shape, smvm_shape((uint8_t)first));
    snprintf(number, sizeof number, first == last ? "0x%02x" : "0x%02x … 0x%02x", first, last);
    snprintf(row, sizeof row, "| %s | `%s` |%s%s |", number, name, *shape ? " " : "", shape);
    CHECK(page_contains(row));
}

static void test_opcodes_are_documented(void)
{
#define SMVM_OP(name, first, last, shape, meaning) check_opcode(#name, first, last);
#include "bytecode-vm/opcodes.def"
#undef SMVM_OP
}

// Whether the page has the sentence of a rule.  Compares without quotes and capitals, since the page begins with a capital and marks code.
static bool same_words(const char *a, const char *b)
{
    while (*a && *b) {
        if (*b == '`' || *b == '\'') {
            b++;
            continue;
        }
        if (*a == '\'') {
            a++;
            continue;
        }
        if (*a != *b && !(*a >= 'a' && *a <= 'z' && *b == *a - 'a' + 'A'))
            return false;
        a++;
        b++;
    }
    return !*a;
}

static void test_rules_are_documented(void)
{
    const char *at, *list = strstr(page, "## The verifier");
    char row[20];

#define SMVM_RULE(number, name, sentence)                                                              \
    snprintf(row, sizeof row, "\n| %d | ", number);                                                    \
    at = list ? strstr(list, row) : 0;                                                                         \
    if (!at || !same_words(sentence, at + strlen(row)))                                                \
        fprintf(stderr, "docs/bytecode.md: rule %d is not: %s\n", number, sentence);                   \
    CHECK(at && same_words(sentence, at + strlen(row)));                                               \
    CHECK(strcmp(smvm_rule_text(number), sentence) == 0);
#include "bytecode-vm/rules.def"
#undef SMVM_RULE
}

static void test_sections_are_documented(void)
{
    char row[100];

#define SMVM_SECTION(name, id, version, meaning)                                      \
    snprintf(row, sizeof row, "| 0x%02x | %d |", id, version);                        \
    CHECK(page_contains(row) && strstr(strstr(page, row), "| " #name " |"));
#include "bytecode-vm/image.def"
#undef SMVM_SECTION
}

// ---- the example ----

static void test_example_works(void)
{
    static uint8_t image[1000];
    uint32_t n;
    SmVm *vm;
    Build b;

    memset(&b, 0, sizeof b);
    b.layout = 77;
    b.sv_words = 8;
    b.outputs = b.states = b.width = 1;
    b.output[0] = PLACE(F64, 16);
    b.s = 2;
    end_function(&b);
    end_function(&b);
    code(&b, SMVM_ldx_plus, 1, 42);
    code(&b, SMVM_out, 1, 0);
    code(&b, SMVM_end, 0);
    end_function(&b);
    end_function(&b);
    n = build_image(&b, image);
    CHECK(start(image, n, 78) == NULL && start(image, n - 1, 77) == NULL);
    vm = start(image, n, 77);
    CHECK(vm != NULL);
    if (!vm)
        return;
    sv[0] = 1;
    CHECK(cycle(vm) && sm_from_bits(sv[2]) == 42 && smvm_stored(vm, 0));
    CHECK(!cycle(vm));
}

int main(void)
{
    load_page();
    test_opcodes_are_documented();
    test_rules_are_documented();
    test_sections_are_documented();
    test_example_works();
    return test_end("vm_docs");
}
