// SPDX-License-Identifier: Apache-2.0
// Reads names and source lines from the DEBUG section, and the marks of states from SWAP and ABORT.  The verifier does not check these
// sections, because a machine runs without them.  So the functions here check every offset: data that is not inside counts as absent.
#include <string.h>

#include "bytecode-vm/image.h"

// These return offsets in the image: of byte `at` of the DEBUG section, and of the section's end.
static SmvmAt debug_offset(const SmvmMachine *m, uint32_t at) { return (SmvmAt)(m->debug_at + at); }
static SmvmAt debug_end(const SmvmMachine *m) { return debug_offset(m, m->debug_size); }

// Reads a number of three bytes, `at` bytes into the section.  Returns false if it is not inside the section.
static bool read_debug_u24(const SmvmMachine *m, uint32_t at, uint32_t *value)
{
    if (m->debug_size < 3 || at > m->debug_size - 3u)
        return false;
    *value = smvm_u24(m->image, debug_offset(m, at));
    return true;
}

// Reads the name whose offset in the section is the number at `at`.  Returns an empty name if the section has no name at that offset.
static SmvmName read_debug_name(const SmvmMachine *m, uint32_t at)
{
    SmvmName none = {0, 0}, n;
    uint32_t offset;

    if (!read_debug_u24(m, at, &offset) || offset == 0 || offset >= m->debug_size)
        return none;
    n.at = debug_offset(m, offset);
    return smvm_read_varint(m->image, &n.at, debug_end(m), &n.size) && n.size <= (SmvmAt)(debug_end(m) - n.at) ? n : none;
}

// Returns the name of the machine or of its source: `which` is SMVM_NAME_MACHINE or SMVM_NAME_SOURCE.
SmvmName smvm_name(const SmvmMachine *m, uint32_t which) { return read_debug_name(m, 3 * which); }

// Returns the name of a state (1 to m->states); size 0: the image does not name the state.
SmvmName smvm_state_name(const SmvmMachine *m, uint32_t state) { return read_debug_name(m, 3 * (SMVM_DEBUG_NUMBERS + state - 1)); }

// Copies the name of a state to `to`, at most size - 1 characters and a 0.  Returns the length of the name; 0 if the image has no names.
uint32_t smvm_copy_state_name(const SmvmMachine *m, uint32_t state, char *to, uint32_t size)
{
    SmvmName n = {0, 0};
    uint32_t i;

    if (state >= 1 && state <= m->states)
        n = smvm_state_name(m, state);
    for (i = 0; i < n.size && i + 1 < size; i++)
        to[i] = (char)smvm_u8(m->image, (SmvmAt)(n.at + i));
    if (size > 0)
        to[i] = 0;
    return n.size;
}

// ---- marks ----

// Whether a state is marked in section `id` of the machine: SMVM_S_SWAP or SMVM_S_ABORT.
bool smvm_is_marked(const SmvmMachine *m, uint8_t id, uint32_t state)
{
    const uint32_t bit = state - 1;
    bool inside = false;
    SmvmSection s;

    for (uint8_t i = 0; i < smvm_section_count(m->image); i++) {
        smvm_read_section(m->image, i, &s);
        if (s.kind.id == SMVM_S_MACHINE)
            inside = s.at == m->machine_at;
        if (inside && s.id == id && smvm_u8(m->image, (SmvmAt)(SMVM_HEADER + i * SMVM_SECTION_ENTRY + 1)) == 1 && bit >> 3 < s.size)
            return (smvm_u8(m->image, (SmvmAt)(s.at + (bit >> 3))) >> (bit & 7) & 1) != 0;
    }
    return false;
}

// Whether a machine may be replaced while it is in a state (1 to m->states): the state is marked @swap or @safe (swapping.md 12.4).
bool smvm_state_allows_swap(const SmvmMachine *m, uint32_t state)
{
    return (m->safe_at != 0 && smvm_state_is_safe(m, state)) || smvm_is_marked(m, SMVM_S_SWAP, state);
}

// Whether a state is marked @abort.
bool smvm_state_is_abort(const SmvmMachine *m, uint32_t state) { return smvm_is_marked(m, SMVM_S_ABORT, state); }

uint32_t smvm_verdict_size(void) { return sizeof(SmvmVerdict); }
uint32_t smvm_machine_size(void) { return sizeof(SmvmMachine); }

// Returns the offset of the table of variables in the section.
static uint32_t variables_offset(const SmvmMachine *m) { return 3 * (SMVM_DEBUG_NUMBERS + m->states); }

// Returns the number of variables with names; they are sorted by SmvmVariable, type, offset.
uint32_t smvm_variables(const SmvmMachine *m)
{
    uint32_t n, most;

    if (!read_debug_u24(m, 0, &n) || m->debug_size < variables_offset(m))
        return 0;
    most = (m->debug_size - variables_offset(m)) / SMVM_DEBUG_VARIABLE;
    return n < most ? n : most;
}

// Returns the name of variable `index`, and stores its kind in *is and its location in *location.
SmvmName smvm_variable(const SmvmMachine *m, uint32_t index, SmvmVariable *is, SmvmLocation *location)
{
    uint32_t at = variables_offset(m) + SMVM_DEBUG_VARIABLE * index;

    *is = (SmvmVariable)smvm_u8(m->image, debug_offset(m, at));
    *location = smvm_location(m->image, debug_offset(m, at + 1));
    return read_debug_name(m, at + 1 + SMVM_LOCATION_BYTES);
}

// Whether variable `index` sorts before a variable of kind `is` at `location`.
static bool is_variable_before(const SmvmMachine *m, uint32_t index, SmvmVariable is, const SmvmLocation *location)
{
    SmvmVariable there;
    SmvmLocation p;

    smvm_variable(m, index, &there, &p);
    if (there != is || is == SMVM_IS_TIME)
        return there < is;
    return p.type != location->type ? p.type < location->type : p.offset < location->offset;
}

// Returns the name of the variable at a location, which is ignored for T; size 0: the image does not name the variable.
SmvmName smvm_name_of(const SmvmMachine *m, SmvmVariable is, const SmvmLocation *location)
{
    uint32_t from = 0, end = smvm_variables(m), count = end;
    SmvmName none = {0, 0}, n;
    SmvmVariable there;
    SmvmLocation p;

    while (from < end) {
        uint32_t middle = from + (end - from) / 2;
        if (is_variable_before(m, middle, is, location))
            from = middle + 1;
        else
            end = middle;
    }
    if (from == count)
        return none;
    n = smvm_variable(m, from, &there, &p);
    return there == is && (is == SMVM_IS_TIME || (p.type == location->type && p.offset == location->offset)) ? n : none;
}

// Initialises l so that smvm_next_line reads the first line next.  Returns false if the section has no lines.
static bool try_open_lines(const SmvmMachine *m, SmvmLines *l)
{
    uint32_t offset;

    l->open = true;
    if (!read_debug_u24(m, 3, &offset) || offset == 0 || offset >= m->debug_size)
        return false;
    l->at = debug_offset(m, offset);
    return smvm_read_varint(m->image, &l->at, debug_end(m), &l->left);
}

// Advances to the next source line: l->line applies from l->code on, an offset in CODE.  Returns false at the end.
bool smvm_next_line(const SmvmMachine *m, SmvmLines *l)
{
    uint32_t code = 0, line = 0;

    if (!l->open && !try_open_lines(m, l))
        l->left = 0;
    if (l->left == 0 || !smvm_read_varint(m->image, &l->at, debug_end(m), &code) || !smvm_read_varint(m->image, &l->at, debug_end(m), &line)) {
        l->left = 0;
        return false;
    }
    l->left--;
    l->code += code;
    // `line` is the encoded difference d to the previous line: 2 d if d >= 0, else -2 d - 1.
    l->line += (line & 1u) != 0 ? 0u - (line + 1) / 2 : line / 2;
    return true;
}
