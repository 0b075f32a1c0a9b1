// SPDX-License-Identifier: Apache-2.0
// Reads names and lines from the DEBUG section.  The verifier does not look at it, for nothing needs it to run; so nothing
// here believes it: what does not lie inside the section is as if it were not there.
#include <string.h>

#include "bytecode-vm/image.h"

static bool entry(const SmvmMachine *m, uint32_t index, uint32_t *value)       // number `index` of three bytes
{
    if (m->debug_size / 3 <= index)
        return false;
    *value = smvm_u24(m->image, m->debug_at + 3 * index);
    return true;
}

static SmvmName name_at(const SmvmMachine *m, uint32_t index)                  // whose offset is number `index`
{
    SmvmName none = {0, 0}, n;
    uint32_t offset, end = m->debug_at + m->debug_size;

    if (!entry(m, index, &offset) || offset == 0 || offset >= m->debug_size)
        return none;
    n.at = m->debug_at + offset;
    return smvm_varint(m->image, &n.at, end, &n.size) && n.size <= end - n.at ? n : none;
}

SmvmName smvm_name(const SmvmMachine *m, uint32_t which) { return name_at(m, which); }

SmvmName smvm_state_name(const SmvmMachine *m, uint32_t state) { return name_at(m, SMVM_DEBUG_NUMBERS + state - 1); }

SmvmName smvm_operand_name(const SmvmMachine *m, uint32_t operand)
{
    return name_at(m, SMVM_DEBUG_NUMBERS + m->states + operand);
}

uint32_t smvm_variables(const SmvmMachine *m)
{
    uint32_t n, tables = SMVM_DEBUG_NUMBERS + m->states + m->operands, most = m->debug_size / 3;

    if (!entry(m, 0, &n) || most < tables)
        return 0;
    return n < (most - tables) / 2 ? n : (most - tables) / 2;
}

SmvmName smvm_variable(const SmvmMachine *m, uint32_t index, SmvmOperand *o)
{
    uint32_t at = SMVM_DEBUG_NUMBERS + m->states + m->operands + 2 * index;

    *o = smvm_operand_at(m->image, m->debug_at + 3 * at);
    return name_at(m, at + 1);
}

static bool open_lines(const SmvmMachine *m, SmvmLines *l)
{
    uint32_t offset;

    l->open = true;
    if (!entry(m, 1, &offset) || offset >= m->debug_size)
        return false;
    l->at = m->debug_at + offset;
    return smvm_varint(m->image, &l->at, m->debug_at + m->debug_size, &l->left);
}

bool smvm_next_line(const SmvmMachine *m, SmvmLines *l)
{
    uint32_t end = m->debug_at + m->debug_size, code, line;

    if (!l->open && !open_lines(m, l))
        l->left = 0;
    if (l->left == 0 || !smvm_varint(m->image, &l->at, end, &code) || !smvm_varint(m->image, &l->at, end, &line)) {
        l->left = 0;
        return false;
    }
    l->left--;
    l->code += code;
    l->line += (line & 1u) != 0 ? 0u - (line + 1) / 2 : line / 2;
    return true;
}
