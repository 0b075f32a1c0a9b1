// SPDX-License-Identifier: Apache-2.0
// Parameters in images (docs/bytecode.md, PARAMETERS): what the verifier refuses, the effect of setting a parameter, and the two identities.
#include <stdlib.h>
#include <string.h>

#include "bytecode-vm/image.h"
#include "compiler/compile.h"
#include "stdlib/parameter.h"
#include "tests/test.h"
#include "tests/unit/vm_build.h"

static const char plain[] = "[state_vector]\nU64 G\nU32 S\nF64 out\n[local]\nF64 n = 3\n[A]\n.step\n n = n + 1\n out = n\n";
static const char source[] = "[state_vector]\nU64 G\nU32 S\nF64 out\n[local]\nF64 limit = 450 @parameter @range 150 1000\n"
                             "F32 gain = 0.5 @parameter @range -1 1\nF32 trim = 0 @parameter @range -4 0\nI16 offset = -3 @parameter @range -5 5\nU8 n = 3 @parameter @range 1 9\n"
                             "bool on = true @parameter\nF64 count = 3\n[A]\n.step\n count = count + limit\n out = count * gain + offset + n + on + trim\n";

static uint8_t good[4096], image[4096];
static uint32_t size;
static SmvmMachine m;

static void *host(void *context, void *old, size_t n)
{
    (void)context;
    if (n)
        return realloc(old, n);
    free(old);
    return NULL;
}

static Buf compile(Session *s, const char *text, bool names)
{
    MachineInput in = {.sm = source_new(&s->arena, "t.sm", text, strlen(text))};
    const ImageOptions o = {names, NULL};
    IrMachine *ir = session_ir(s, session_program(s, &in), 2);
    Buf out;

    buf_init(&out, &s->arena);
    CHECK(session_image(s, &ir, 1, &o, &out));
    return out;
}

static void restore(void)
{
    memcpy(image, good, size);
    CHECK(smvm_machine(image, 0, &m));
}

// Returns the rule that the image violates if byte `at` has the value `byte`.
static uint8_t rule_with(uint32_t at, uint8_t byte)
{
    SmvmVerdict v;

    restore();
    image[at] = byte;
    fix_crc(image);
    return smvm_verify(image, size, &v);
}

static SmvmParameterEntry entry(uint32_t number)
{
    SmvmReader r;
    SmvmParameterEntry e;

    restore();
    r = smvm_parameters(&m);
    memset(&e, 0, sizeof e);
    do
        CHECK(smvm_read_parameter(&r, &e));
    while (number-- > 0);
    return e;
}

enum { LIMIT, GAIN, TRIM, OFFSET, N, ON, PARAMETERS };
static const uint32_t places[] = {0, 8, 12, 16, 18, 19};

static void test_entries_are_read(void)
{
    SmvmParameter p;
    uint32_t number;

    restore();
    CHECK(smvm_parameter(&m, LIMIT, &p) && p.type == SM_F64 && p.lowest == 150 && p.highest == 1000 && p.standard == 450 && p.value == 450);
    CHECK(p.name_size == 5 && memcmp(image + p.name_at, "limit", 6) == 0 && p.unit_size == 0);
    CHECK(smvm_parameter(&m, OFFSET, &p) && p.type == SM_I16 && p.lowest == -5 && p.highest == 5 && p.value == -3);
    CHECK(smvm_parameter(&m, ON, &p) && p.type == SM_BOOL && p.lowest == 0 && p.highest == 1 && p.value == 1);
    CHECK(!smvm_parameter(&m, PARAMETERS, &p));
    for (uint32_t i = 0; i < PARAMETERS; i++)
        CHECK(smvm_parameter(&m, i, &p) && p.offset == places[i] && smvm_find_parameter(&m, (const char *)image + p.name_at, p.name_size, &number) && number == i);
    CHECK(!smvm_find_parameter(&m, "limi", 4, &number) && !smvm_find_parameter(&m, "limits", 6, &number) && !smvm_find_parameter(&m, "count", 5, &number));
}

static void test_places_are_checked(void)
{
    const uint32_t n = entry(N).numbers - SMVM_LOCATION_BYTES, gain = entry(GAIN).numbers - SMVM_LOCATION_BYTES;

    CHECK(rule_with(n, image[n]) == 0);
    CHECK(rule_with(n, 17) == SMVM_R_PARAMETERS);                     // overlaps the parameter `offset`
    CHECK(rule_with(n, 19) == SMVM_R_PARAMETERS);                     // overlaps `on`, the next parameter
    CHECK(rule_with(n, 200) == SMVM_R_PARAMETERS);                    // beyond the locals
    CHECK(rule_with(gain, 0) == SMVM_R_PARAMETERS);                   // `limit`
    CHECK(rule_with(n + 2, SMVM_RAW) == SMVM_R_PARAMETERS && rule_with(n + 2, 15) == SMVM_R_PARAMETERS);
    CHECK(rule_with(entry(ON).numbers - SMVM_LOCATION_BYTES, 24) == SMVM_R_READ_ONLY);       // `count`, which the code writes
    CHECK(rule_with(entry(N).name[0] - 1, 0) == SMVM_R_PARAMETERS);   // no name
    CHECK(rule_with(entry(ON).name[1] - 1, 1) == SMVM_R_PARAMETERS && rule_with(entry(ON).name[1] - 1, 0x5f) == SMVM_R_PARAMETERS);    // its unit is cut off
}

// An entry without a name is refused, although its size is right: the unit has the byte that the name lacks.
static void test_nameless_entry_is_refused(void)
{
    const uint32_t at = entry(N).name[0] - 1;
    SmvmVerdict v;

    restore();
    CHECK(image[at] == 1 && image[at + 3] == 0);                      // `n`, without a unit
    memcpy(image + at, "\0\0\1x", 4);
    fix_crc(image);
    CHECK(smvm_verify(image, size, &v) == SMVM_R_PARAMETERS);
}

// Returns the rule that the image violates if a number of a parameter has the value `bits`.
static uint8_t rule_of_value(uint32_t number, uint8_t which, uint64_t bits)
{
    const SmvmParameterEntry e = entry(number);
    SmvmVerdict v;

    for (unsigned i = 0; i < e.bytes; i++)
        image[smvm_parameter_number(&e, which) + i] = (uint8_t)(bits >> 8 * i);
    fix_crc(image);
    return smvm_verify(image, size, &v);
}

static uint64_t bits_of(double x) { return sm_bits(x); }

static void test_values_are_checked(void)
{
    static const struct { uint32_t number; uint8_t which; uint64_t bits; bool good; } row[] = {
        {GAIN, 3, 0x3f800000, true}, {GAIN, 3, 0xbf800000, true}, {GAIN, 3, 0x80000000, true}, {GAIN, 3, 0x3f800001, false},
        {TRIM, 3, 0x80000000, true}, {TRIM, 3, 0, true}, {TRIM, 3, 1, false}, {TRIM, 3, 0xc0800000, true}, {TRIM, 3, 0xc0800001, false},
        {TRIM, 3, 0xbf800000, true}, {TRIM, 3, 0xffc00000, false}, {TRIM, 0, 0xffc00000, false}, {GAIN, 3, 0x7fc00000, false}, {GAIN, 3, 0x7f800000, false}, {GAIN, 2, 0xff800000, false}, {GAIN, 2, 0xffc00000, false},
        {GAIN, 1, 0x7f800000, false}, {GAIN, 0, 0xff800000, false}, {GAIN, 1, 0x7fc00000, false}, {GAIN, 0, 0x7fc00000, false},
        {GAIN, 1, 0x3efffffe, false}, {GAIN, 1, 0x3f000000, true}, {OFFSET, 3, 0xfffb, true}, {OFFSET, 3, 0xfffa, false},
        {OFFSET, 3, 5, true}, {OFFSET, 3, 6, false}, {OFFSET, 2, 6, false}, {OFFSET, 0, 0xfffe, false}, {N, 3, 0, false}, {N, 3, 9, true},
        {N, 3, 10, false}, {N, 3, 255, false}, {ON, 3, 0, true}, {ON, 3, 2, false}, {ON, 2, 255, false}, {ON, 1, 2, false}, {ON, 1, 0, false},
    };

    CHECK(rule_of_value(LIMIT, 3, bits_of(150)) == 0 && rule_of_value(LIMIT, 3, bits_of(1000)) == 0);
    CHECK(rule_of_value(LIMIT, 3, bits_of(149.99999999999997)) == SMVM_R_VALUE && rule_of_value(LIMIT, 3, bits_of(1000.0000000000001)) == SMVM_R_VALUE);
    CHECK(rule_of_value(LIMIT, 3, IR_NAN) == SMVM_R_VALUE && rule_of_value(LIMIT, 3, 0x7ff0000000000001) == SMVM_R_VALUE);
    CHECK(rule_of_value(LIMIT, 1, 0x7ff0000000000000) == SMVM_R_VALUE && rule_of_value(LIMIT, 2, bits_of(1001)) == SMVM_R_VALUE);
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        const uint8_t rule = rule_of_value(row[i].number, row[i].which, row[i].bits);
        if (rule != (row[i].good ? 0 : SMVM_R_VALUE))
            fprintf(stderr, "row %u: rule %u\n", (unsigned)i, rule);
        CHECK(rule == (row[i].good ? 0 : SMVM_R_VALUE));
    }
}

// Starts the machine of `image`, and checks that its parameters have the values in the image.
static void check_started(void)
{
    static uint64_t memory[100], sv[8];
    const SmvmVector vector = {sv, m.sv_size, m.layout};
    SmvmParameter p;

    CHECK(smvm_init(memory, sizeof memory, &m, &vector, 1) == SM_OK);
    for (uint32_t i = 0; smvm_parameter(&m, i, &p); i++) {
        const uint8_t *at = (const uint8_t *)smvm_locals((SmVm *)(void *)memory) + p.offset;
        CHECK(sm_load((SmType)p.type, at) == p.value && p.value >= p.lowest && p.value <= p.highest);
    }
}

// For each value of each byte of the section, the verifier refuses the image, or the machine starts with values within its ranges.
static void test_any_damage_is_harmless(void)
{
    uint32_t accepted = 0;

    restore();
    for (uint32_t at = m.parameters_at; at < m.parameters_at + m.parameters_size; at++)
        for (unsigned byte = 0; byte < 256; byte++)
            if (rule_with(at, (uint8_t)byte) == 0 && smvm_machine(image, 0, &m)) {
                check_started();
                accepted++;
            }
    CHECK(accepted > 1000);
    for (uint32_t n = 0; n < m.parameters_size; n++) {                // the section is cut off
        SmvmVerdict v;
        uint8_t *table = image + SMVM_HEADER;
        restore();
        while (table[0] != SMVM_S_PARAMETERS)
            table += SMVM_SECTION_ENTRY;
        table[5] = (uint8_t)n;
        fix_crc(image);
        if (smvm_verify(image, size, &v) == 0)
            CHECK(smvm_machine(image, 0, &m) && m.parameters_size == n);
        else
            CHECK(v.rule == SMVM_R_PARAMETERS);
    }
}

static void test_setting_changes_value_and_crc_only(void)
{
    SmvmVerdict v;
    const uint64_t logic = (restore(), smvm_logic_identity(image)), settings = smvm_settings_identity(image);

    CHECK(smvm_set_parameter(image, &m, LIMIT, 300) == 0 && smvm_set_parameter(image, &m, GAIN, 0.1) == 0);
    CHECK(smvm_verify(image, size, &v) == 0);
    check_started();
    CHECK(smvm_logic_identity(image) == logic && smvm_settings_identity(image) != settings);
    CHECK(smvm_set_parameter(image, &m, LIMIT, 450) == 0 && smvm_set_parameter(image, &m, GAIN, 0.5) == 0);
    CHECK(memcmp(image, good, size) == 0);
    CHECK(smvm_set_parameter(image, &m, LIMIT, 149) == SM_REFUSAL_LOW && smvm_set_parameter(image, &m, LIMIT, 1001) == SM_REFUSAL_HIGH);
    CHECK(smvm_set_parameter(image, &m, LIMIT, sm_from_bits(IR_NAN)) == SM_REFUSAL_NAN && smvm_set_parameter(image, &m, N, 1.5) == SM_REFUSAL_FRACTION);
    CHECK(smvm_set_parameter(image, &m, N, 257) == SM_REFUSAL_HIGH && smvm_set_parameter(image, &m, ON, 0.5) == SM_REFUSAL_TRUTH);
    CHECK(smvm_set_parameter(image, &m, PARAMETERS, 0) == SM_REFUSAL_UNKNOWN && smvm_judge_parameter(&m, PARAMETERS, 0) == SM_REFUSAL_UNKNOWN);
    CHECK(smvm_judge_parameter(&m, OFFSET, -5) == 0 && smvm_judge_parameter(&m, OFFSET, -6) == SM_REFUSAL_LOW);
    CHECK(memcmp(image, good, size) == 0);
    CHECK(strcmp(smvm_refusal_text(SM_REFUSAL_HIGH), "the value is above the range") == 0 && *smvm_refusal_text(0) == '\0' && *smvm_refusal_text(200) == '\0');
}

static uint64_t logic_with_default(double x)
{
    CHECK(rule_of_value(LIMIT, SMVM_PARAMETER_DEFAULT, bits_of(x)) == 0);
    return smvm_logic_identity(image);
}

static void test_identities(Session *s)
{
    const Buf named = compile(s, source, true);

    restore();
    CHECK(smvm_logic_identity((const uint8_t *)named.at) == smvm_logic_identity(image));
    CHECK(smvm_settings_identity((const uint8_t *)named.at) == smvm_settings_identity(image));
    CHECK(rule_of_value(LIMIT, SMVM_PARAMETER_DEFAULT, bits_of(200)) == 0);
    CHECK(smvm_logic_identity((const uint8_t *)named.at) != smvm_logic_identity(image));
    CHECK(smvm_settings_identity((const uint8_t *)named.at) == smvm_settings_identity(image));
    CHECK(rule_of_value(LIMIT, SMVM_PARAMETER_HIGHEST, bits_of(2000)) == 0);
    CHECK(smvm_logic_identity((const uint8_t *)named.at) != smvm_logic_identity(image));
    CHECK(logic_with_default(200) != logic_with_default(300) && logic_with_default(200) == logic_with_default(200));
    restore();
    image[entry(N).name[0]] = 'm';                                    // another name is another parameter: both identities differ
    CHECK(smvm_logic_identity((const uint8_t *)named.at) != smvm_logic_identity(image));
    CHECK(smvm_settings_identity((const uint8_t *)named.at) != smvm_settings_identity(image));
}

static void test_machine_without_parameters(Session *s)
{
    const Buf b = compile(s, plain, false);
    SmvmMachine of;
    SmvmParameter p;

    CHECK(smvm_machine((const uint8_t *)b.at, 0, &of) && of.parameters_size == 0 && !smvm_parameter(&of, 0, &p));
}

int main(void)
{
    jmp_buf oom;
    Session s;
    Buf b;

    if (setjmp(oom) != 0)
        return 1;
    session_init(&s, host, NULL, &oom);
    b = compile(&s, source, false);
    size = (uint32_t)b.n;
    memcpy(good, b.at, size);
    test_entries_are_read();
    test_places_are_checked();
    test_nameless_entry_is_refused();
    test_values_are_checked();
    test_any_damage_is_harmless();
    test_setting_changes_value_and_crc_only();
    test_identities(&s);
    test_machine_without_parameters(&s);
    session_free(&s);
    return test_end("vm_parameters");
}
