// SPDX-License-Identifier: Apache-2.0
// The parameters of an image, for hosts: reads them, sets them, and computes what identifies the logic and the settings of an image.
#include <string.h>

#include "bytecode-vm/image.h"
#include "bytecode-vm/smvm.h"
#include "stdlib/convert.h"
#include "stdlib/crc32.h"
#include "stdlib/parameter.h"

#if SMVM_PARAMETERS

// ---- reading ----

// Reads one of a parameter's numbers (`which`: its lowest value, its highest value, ...) from the image.
static SmF64 read_value(SmvmBytes image, const SmvmParameterEntry *e, uint8_t which)
{
    return sm_cell_to_f64(e->location.type, smvm_cell(image, smvm_parameter_number(e, which), e->bytes));
}

// Reads the machine's parameter number `number`, counted from 0; returns false if the machine has fewer.
static bool read_entry(const SmvmMachine *m, uint32_t number, SmvmParameterEntry *e)
{
    SmvmReader r = smvm_parameters(m);

    do
        if (!smvm_read_parameter(&r, e))
            return false;
    while (number-- > 0);
    return true;
}

bool smvm_parameter(const SmvmMachine *m, uint32_t number, SmvmParameter *p)
{
    SmvmParameterEntry e;

    if (!read_entry(m, number, &e))
        return false;
    p->type = (uint8_t)e.location.type;
    p->offset = e.location.offset;
    p->name_at = e.name[0];
    p->name_size = e.size[0];
    p->unit_at = e.name[1];
    p->unit_size = e.size[1];
    p->lowest = read_value(m->image, &e, SMVM_PARAMETER_LOWEST);
    p->highest = read_value(m->image, &e, SMVM_PARAMETER_HIGHEST);
    p->standard = read_value(m->image, &e, SMVM_PARAMETER_DEFAULT);
    p->value = read_value(m->image, &e, SMVM_PARAMETER_VALUE);
    return true;
}

bool smvm_find_parameter(const SmvmMachine *m, const char *name, uint32_t size, uint32_t *number)
{
    SmvmReader r = smvm_parameters(m);
    SmvmParameterEntry e;

    for (*number = 0; smvm_read_parameter(&r, &e); (*number)++) {
        SmvmAt i = 0;
        while (e.size[0] == size && i < size && smvm_u8(m->image, (SmvmAt)(e.name[0] + i)) == (uint8_t)name[i])
            i++;
        if (e.size[0] == size && i == size)
            return true;
    }
    return false;
}

// ---- setting ----

// Returns why x is not allowed as a value of the parameter; SM_REFUSAL_NONE if it is allowed.
static SmRefusal judge_value(const SmvmMachine *m, const SmvmParameterEntry *e, SmF64 x)
{
    const SmParameterRange range = {e->location.type, read_value(m->image, e, SMVM_PARAMETER_LOWEST),
                                    read_value(m->image, e, SMVM_PARAMETER_HIGHEST)};

    return sm_parameter_judge(&range, x);
}

uint8_t smvm_judge_parameter(const SmvmMachine *m, uint32_t number, SmF64 x)
{
    SmvmParameterEntry e;

    return (uint8_t)(read_entry(m, number, &e) ? judge_value(m, &e, x) : SM_REFUSAL_UNKNOWN);
}

// Writes the CRC of an image that has changed.
static void write_crc(uint8_t *image)
{
    const uint32_t n = (uint32_t)image[SMVM_LENGTH_AT] | (uint32_t)image[SMVM_LENGTH_AT + 1] << 8 | (uint32_t)image[SMVM_LENGTH_AT + 2] << 16;
    uint32_t crc = SM_CRC32_START;

    for (uint32_t i = 0; i < n; i++)
        if (i < SMVM_CRC_AT || i >= SMVM_CRC_AT + 4)
            crc = sm_crc32_byte(crc, image[i]);
    crc = sm_crc32_end(crc);
    for (unsigned i = 0; i < 4; i++)
        image[SMVM_CRC_AT + i] = (uint8_t)(crc >> 8 * i);
}

uint8_t smvm_set_parameter(uint8_t *image, const SmvmMachine *m, uint32_t number, SmF64 x)
{
    SmvmParameterEntry e;
    SmRefusal refusal;
    uint64_t cell;

    if (!read_entry(m, number, &e))
        return SM_REFUSAL_UNKNOWN;
    if ((refusal = judge_value(m, &e, x)) != SM_REFUSAL_NONE)
        return (uint8_t)refusal;
    cell = sm_cell_from_f64(e.location.type, x);
    for (unsigned i = 0; i < e.bytes; i++)
        image[smvm_parameter_number(&e, SMVM_PARAMETER_VALUE) + i] = (uint8_t)(cell >> 8 * i);
    write_crc(image);
    return SM_REFUSAL_NONE;
}

const char *smvm_refusal_text(uint8_t refusal)
{
    static const char *const text[] = {
        "",
#define REFUSAL(name, text) text,
#include "stdlib/parameters.def"
#undef REFUSAL
    };

    return refusal < SM_REFUSAL_COUNT ? text[refusal] : "";
}

// ---- identities: FNV-1a, 64 bits ----

static uint64_t hash_byte(uint64_t hash, uint8_t byte) { return (hash ^ byte) * UINT64_C(0x100000001b3); }

static uint64_t hash_bytes(uint64_t hash, SmvmBytes image, SmvmAt at, SmvmAt n)
{
    for (; n > 0; n--)
        hash = hash_byte(hash, smvm_u8(image, at++));
    return hash;
}

// Adds the section PARAMETERS to the hash, with the default of each parameter in place of its value.
static uint64_t hash_parameters(uint64_t hash, SmvmBytes image, const SmvmSection *s)
{
    SmvmReader r = {image, s->at, (SmvmAt)(s->at + s->size), 0};
    SmvmParameterEntry e;
    SmvmAt from = r.at;

    while (smvm_read_parameter(&r, &e)) {
        hash = hash_bytes(hash, image, from, (SmvmAt)(smvm_parameter_number(&e, SMVM_PARAMETER_VALUE) - from));
        hash = hash_bytes(hash, image, smvm_parameter_number(&e, SMVM_PARAMETER_DEFAULT), e.bytes);
        from = smvm_parameter_number(&e, SMVM_PARAMETER_NUMBERS);
    }
    return hash_bytes(hash, image, from, (SmvmAt)(r.end - from));
}

uint64_t smvm_logic_identity(SmvmBytes image)
{
    uint64_t hash = UINT64_C(0xcbf29ce484222325);

    for (uint8_t i = 0; i < smvm_section_count(image); i++) {
        SmvmSection s;
        smvm_read_section(image, i, &s);
        if (s.id < SMVM_MUST_KNOW)
            continue;
        hash = hash_byte(hash, s.id);
        hash = s.id == SMVM_S_PARAMETERS ? hash_parameters(hash, image, &s) : hash_bytes(hash, image, s.at, s.size);
    }
    return hash;
}

uint64_t smvm_settings_identity(SmvmBytes image)
{
    uint64_t hash = UINT64_C(0xcbf29ce484222325);
    SmvmMachine m;

    for (uint32_t i = 0; smvm_machine(image, i, &m); i++) {
        SmvmReader r = smvm_parameters(&m);
        SmvmParameterEntry e;
        hash = hash_byte(hash, SMVM_S_MACHINE);
        while (smvm_read_parameter(&r, &e)) {
            hash = hash_bytes(hash, image, e.name[0], (SmvmAt)(e.size[0] + 1));
            hash = hash_bytes(hash, image, smvm_parameter_number(&e, SMVM_PARAMETER_VALUE), e.bytes);
        }
    }
    return hash;
}

#else
typedef char parameter_needs_smvm_parameters;         // ISO C forbids an empty file
#endif
