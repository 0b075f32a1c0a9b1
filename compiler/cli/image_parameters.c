// SPDX-License-Identifier: Apache-2.0
#include "compiler/cli/image_parameters.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bytecode-vm/image.h"
#include "compiler/cli/setting.h"

// ---- the list ----

static const char *machine_name(Cli *c, const SmvmMachine *m, uint32_t index)
{
    const SmvmName n = smvm_name(m, SMVM_NAME_MACHINE);

    return n.size > 0 ? format_in(&c->session.arena, "%.*s", (int)n.size, (const char *)m->image + n.at)
                      : format_in(&c->session.arena, "%lu", (unsigned long)index + 1);
}

// Writes a value with the fewest digits from which its type reads it back.
static void write_value(Cli *c, Buf *out, const SmvmParameter *p, SmF64 x)
{
    char digits[32];

    if (p->type == SM_BOOL) {
        buf_str(out, sm_eq(x, sm_from_i32(0)) ? "false" : "true");
        return;
    }
    for (int n = 6; n <= 9 && p->type == SM_F32; n++) {
        snprintf(digits, sizeof digits, "%.*g", n, x);
        if ((float)strtod(digits, NULL) == (float)x) {
            buf_str(out, digits);
            return;
        }
    }
    buf_str(out, const_text(&c->session.arena, x));
}

// Writes a text of the image, which can contain any bytes.
static void write_text(Buf *out, const SmvmMachine *m, SmvmAt at, SmvmAt n)
{
    for (; n > 0; n--, at++)
        buf_char(out, smvm_u8(m->image, at) > ' ' && smvm_u8(m->image, at) < 0x7f ? (char)smvm_u8(m->image, at) : '?');
}

// Writes a line such as `MAIN_ALT = 450 m (F64, 150 to 1000, default 300)`.
static void list_parameter(Cli *c, const SmvmMachine *m, const SmvmParameter *p, Buf *out)
{
    write_text(out, m, p->name_at, p->name_size);
    buf_str(out, " = ");
    write_value(c, out, p, p->value);
    buf_str(out, p->unit_size > 0 ? " " : "");
    write_text(out, m, p->unit_at, p->unit_size);
    buf_printf(out, " (%s, ", sm_type_info[p->type].spelling);
    if (p->type != SM_BOOL) {
        // The image stores -0 as the lower bound 0, so that the value -0 is in the range.  Adding 0 shows it as 0.
        write_value(c, out, p, sm_add(p->lowest, sm_from_i32(0)));
        buf_str(out, " to ");
        write_value(c, out, p, p->highest);
        buf_str(out, ", ");
    }
    buf_str(out, "default ");
    write_value(c, out, p, p->standard);
    buf_str(out, ")\n");
}

// Writes the identities of logic and settings, then a line for each parameter.
void parameters_list(Cli *c, SmvmBytes bytes, Buf *out)
{
    SmvmMachine m, second;
    SmvmParameter p;

    buf_printf(out, "logic %016llx, settings %016llx\n", (unsigned long long)smvm_logic_identity(bytes),
               (unsigned long long)smvm_settings_identity(bytes));
    for (uint32_t i = 0; smvm_machine(bytes, i, &m); i++)
        for (uint32_t n = 0; smvm_parameter(&m, n, &p); n++) {
            if (smvm_machine(bytes, 1, &second))
                buf_printf(out, "%s.", machine_name(c, &m, i));
            list_parameter(c, &m, &p, out);
        }
}

// ---- setting ----

// A parameter that a setting names, "NAME" or "MACHINE.NAME". found: how many machines have it; m, number: the last of them, and its index there.
typedef struct Named { SmvmMachine m; uint32_t number; unsigned found; } Named;

static Named find_named_parameter(Cli *c, SmvmBytes image, const Setting *s)
{
    const char *const point = memchr(s->name, '.', s->name_size);
    const char *const name = point ? point + 1 : s->name;
    const size_t before = point ? (size_t)(point - s->name) : 0, size = s->name_size - (size_t)(name - s->name);
    Named found = {.found = 0};
    SmvmMachine m;
    uint32_t number;

    for (uint32_t i = 0; smvm_machine(image, i, &m); i++) {
        const char *const of = machine_name(c, &m, i);
        if (point && (strlen(of) != before || memcmp(of, s->name, before) != 0))
            continue;
        if (!smvm_find_parameter(&m, name, (uint32_t)size, &number))
            continue;
        found = (Named){m, number, found.found + 1};
    }
    return found;
}

// Sets the parameter that `word`, as NAME=VALUE, names. Returns false after a message; the image has then not changed.
bool parameters_set(Cli *c, uint8_t *image, const char *word)
{
    uint8_t refusal;
    Setting s;
    Named n;

    if (!setting_parse(c, word, &s))
        return false;
    n = find_named_parameter(c, (SmvmBytes)image, &s);
    if (n.found > 1) {
        cli_print_error(c, TEXT_setting_of_several, (int)s.name_size, s.name, (int)s.name_size, s.name);
        return false;
    }
    refusal = n.found ? smvm_set_parameter(image, &n.m, n.number, s.value) : (uint8_t)SM_REFUSAL_UNKNOWN;
    if (refusal)
        setting_report_refused(c, &s, smvm_refusal_text(refusal));
    return refusal == 0;
}
