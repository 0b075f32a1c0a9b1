// SPDX-License-Identifier: Apache-2.0
// Disassembling images whose names are lies: all operands share one as long as the image allows.
#include <string.h>

#include "bytecode-vm/smvm.h"
#include "tests/test.h"
#include "tests/unit/vm_build.h"

enum { NAME = 60000, MOVES = 500 };

static void count(void *context, const char *text, size_t length)
{
    (void)text;
    *(size_t *)context += length;
}

static uint32_t put_debug(const Build *b, uint8_t *p)
{
    const uint8_t *start = p;
    const uint32_t numbers = 4 + b->states + b->operands;

    for (uint32_t i = 0; i < numbers; i++)
        put_bytes(&p, i < 2 ? 0 : 3 * numbers, 3);
    p += put_number(p, NAME);
    memset(p, 'x', NAME);
    return (uint32_t)(p - start) + NAME;
}

static void long_name(void)
{
    static const uint8_t id[] = {0x81, 0x82, 0x02};
    const uint32_t operand[] = {ELEMENT(F64, 16), ELEMENT(U64, 0), ELEMENT(U32, 8)};
    static uint8_t image[NAME + 4 * MOVES];
    static Build b;
    uint32_t size[3], at = 12 + 3 * 8;
    SmvmVerdict v;
    size_t length = 0;

    b.sv_words = 3;
    b.outputs = b.states = 1;
    b.width = 2;
    b.operands = 3;
    memcpy(b.operand, operand, sizeof operand);
    for (unsigned i = 0; i < MOVES; i++)
        code(&b, SMVM_mov, 2, 0, 0);
    code(&b, SMVM_end, 0);
    for (unsigned i = 0; i < 4; i++)
        end_function(&b);
    size[0] = put_machine(&b, image + at);
    size[1] = b.size;
    memcpy(image + at + size[0], b.code, b.size);
    size[2] = put_debug(&b, image + at + size[0] + size[1]);
    at = put_header(image, 3, id, size);
    CHECK(smvm_verify(image, at, &v) == 0);
    smvm_disasm(image, count, &length);
    CHECK(length > 2 * MOVES * 100 && length < 2 * MOVES * 300);
}

int main(void)
{
    long_name();
    return test_end("vm_disasm");
}
