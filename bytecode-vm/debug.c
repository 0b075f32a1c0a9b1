// SPDX-License-Identifier: Apache-2.0
// Reads names and lines from the DEBUG section.  The verifier does not check it, because nothing needs it to run.  So the functions
// here trust nothing in it: they treat data that is not inside the section as absent.
#include <string.h>

#include "bytecode-vm/image.h"

// Offsets in the image: `at` bytes into the section, and the end of the section.
static SmvmAt place_of(const SmvmMachine *m, uint32_t at) { return (SmvmAt)(m->debug_at + at); }
static SmvmAt end_of(const SmvmMachine *m) { return place_of(m, m->debug_size); }

static bool number_at(const SmvmMachine *m, uint32_t at, uint32_t *value)        // a number of three bytes, `at` bytes into the section
{
    if (m->debug_size < 3 || at > m->debug_size - 3u)
        return false;
    *value = smvm_u24(m->image, place_of(m, at));
    return true;
}

static SmvmName name_at(const SmvmMachine *m, uint32_t at)                      // the name whose offset is the number at `at`
{
    SmvmName none = {0, 0}, n;
    uint32_t offset;

    if (!number_at(m, at, &offset) || offset == 0 || offset >= m->debug_size)
        return none;
    n.at = place_of(m, offset);
    return smvm_varint(m->image, &n.at, end_of(m), &n.size) && n.size <= (SmvmAt)(end_of(m) - n.at) ? n : none;
}

SmvmName smvm_name(const SmvmMachine *m, uint32_t which) { return name_at(m, 3 * which); }

SmvmName smvm_state_name(const SmvmMachine *m, uint32_t state) { return name_at(m, 3 * (SMVM_DEBUG_NUMBERS + state - 1)); }

static uint32_t variables_at(const SmvmMachine *m) { return 3 * (SMVM_DEBUG_NUMBERS + m->states); }

uint32_t smvm_variables(const SmvmMachine *m)
{
    uint32_t n, most;

    if (!number_at(m, 0, &n) || m->debug_size < variables_at(m))
        return 0;
    most = (m->debug_size - variables_at(m)) / SMVM_DEBUG_VARIABLE;
    return n < most ? n : most;
}

SmvmName smvm_variable(const SmvmMachine *m, uint32_t index, SmvmVariable *is, SmvmPlace *place)
{
    uint32_t at = variables_at(m) + SMVM_DEBUG_VARIABLE * index;

    *is = (SmvmVariable)smvm_u8(m->image, place_of(m, at));
    *place = smvm_place(m->image, place_of(m, at + 1));
    return name_at(m, at + 1 + SMVM_PLACE);
}

// Whether variable `index` sorts before one of this kind at this place.
static bool is_before(const SmvmMachine *m, uint32_t index, SmvmVariable is, const SmvmPlace *place)
{
    SmvmVariable there;
    SmvmPlace p;

    smvm_variable(m, index, &there, &p);
    if (there != is || is == SMVM_IS_TIME)
        return there < is;
    return p.type != place->type ? p.type < place->type : p.offset < place->offset;
}

SmvmName smvm_name_of(const SmvmMachine *m, SmvmVariable is, const SmvmPlace *place)
{
    uint32_t from = 0, end = smvm_variables(m), count = end;
    SmvmName none = {0, 0}, n;
    SmvmVariable there;
    SmvmPlace p;

    while (from < end) {
        uint32_t middle = from + (end - from) / 2;
        if (is_before(m, middle, is, place))
            from = middle + 1;
        else
            end = middle;
    }
    if (from == count)
        return none;
    n = smvm_variable(m, from, &there, &p);
    return there == is && (is == SMVM_IS_TIME || (p.type == place->type && p.offset == place->offset)) ? n : none;
}

static bool open_lines(const SmvmMachine *m, SmvmLines *l)
{
    uint32_t offset;

    l->open = true;
    if (!number_at(m, 3, &offset) || offset == 0 || offset >= m->debug_size)
        return false;
    l->at = place_of(m, offset);
    return smvm_varint(m->image, &l->at, end_of(m), &l->left);
}

bool smvm_next_line(const SmvmMachine *m, SmvmLines *l)
{
    uint32_t code = 0, line = 0;

    if (!l->open && !open_lines(m, l))
        l->left = 0;
    if (l->left == 0 || !smvm_varint(m->image, &l->at, end_of(m), &code) || !smvm_varint(m->image, &l->at, end_of(m), &line)) {
        l->left = 0;
        return false;
    }
    l->left--;
    l->code += code;
    l->line += (line & 1u) != 0 ? 0u - (line + 1) / 2 : line / 2;
    return true;
}
