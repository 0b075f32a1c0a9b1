// SPDX-License-Identifier: Apache-2.0
#include "compiler/cli/setting.h"

#include <string.h>

#include "compiler/syntax/number.h"

// Whether text is a well-formed number without a sign: its characters are those of a number, and number_to_f64 needs no others.
static bool is_number(const char *text)
{
    const bool is_hex = text[0] == '0' && (text[1] == 'x' || text[1] == 'X');
    const char *at = is_hex ? text + 2 : text;
    size_t digits = strspn(at, is_hex ? "0123456789abcdefABCDEF" : "0123456789");

    at += digits;
    if (!is_hex && *at == '.' && digits > 0) {
        digits = strspn(at + 1, "0123456789");
        at += 1 + digits;
    }
    if (!is_hex && (*at == 'e' || *at == 'E') && digits > 0) {
        at += 1 + (at[1] == '+' || at[1] == '-');
        digits = strspn(at, "0123456789");
        at += digits;
    }
    return digits > 0 && *at == '\0';
}

// Reads true, false or a number with an optional sign; NaN for any other text.
static SmF64 read_value(const char *text)
{
    const bool minus = text[0] == '-';
    const char *digits = text + (minus || text[0] == '+');
    SmF64 x;

    if (strcmp(text, "true") == 0 || strcmp(text, "false") == 0)
        return sm_from_i32(text[0] == 't');
    if (!is_number(digits))
        return sm_from_bits(UINT64_C(0x7ff8000000000000));
    if (!number_to_f64(digits, strlen(digits), &x))
        x = sm_from_bits(UINT64_C(0x7ff0000000000000));
    return minus ? sm_neg(x) : x;
}

// Splits NAME=VALUE and reads the value. Returns false after a message.
bool setting_parse(Cli *c, const char *word, Setting *s)
{
    const char *equals = strchr(word, '=');

    if (!equals || equals == word || equals[1] == '\0') {
        cli_usage_error(c, TEXT_setting_form, word);
        return false;
    }
    s->name = word;
    s->name_size = (uint32_t)(equals - word);
    s->text = equals + 1;
    s->value = read_value(s->text);
    return true;
}

// Reports a parameter without the name of its machine, in an application.  Returns false if no machine has the parameter.
static bool report_parameter_of_machines(Cli *c, const Program *p, const Setting *s)
{
    Buf names;

    buf_init(&names, &c->session.arena);
    for (size_t i = 0; p->joint && i < p->joint->member.n; i++) {
        const Member *m = &p->joint->member.at[i];
        if (program_parameter(m->program, str_intern(&c->session.strings, s->name, s->name_size)))
            buf_printf(&names, "%s'%s.%.*s'", names.n ? " or " : "", m->name->text, (int)s->name_size, s->name);
    }
    if (names.n)
        cli_print_error(c, TEXT_setting_of_machine, (int)s->name_size, s->name, buf_text(&names));
    return names.n > 0;
}

// Reports an unknown parameter whose name is near to that of another one.  Returns false if none is near.
static bool report_similar_parameter(Cli *c, const Program *p, const Setting *s)
{
    const char **name = ARENA_ARRAY(&c->session.arena, const char *, p->var.n), *near;
    size_t n = 0;

    for (size_t i = 0; i < p->var.n; i++)
        if (p->var.at[i]->parameter)
            name[n++] = p->var.at[i]->name->text;
    near = str_nearest(format_in(&c->session.arena, "%.*s", (int)s->name_size, s->name), name, n);
    if (near)
        cli_print_error(c, TEXT_setting_near, p->joint ? "application" : "machine", (int)s->name_size, s->name, near);
    return near != NULL;
}

// Finds the parameter and converts the value to its type. Returns EXIT_OK, or the exit code after a message.
int setting_find(Cli *c, const Program *p, const Setting *s, ScriptSetting *out)
{
    SmRefusal refusal = SM_REFUSAL_UNKNOWN;

    *out = (ScriptSetting){NULL, 0, {0}};
    out->parameter = program_parameter(p, str_intern(&c->session.strings, s->name, s->name_size));
    if (out->parameter)
        refusal = parameter_judge(out->parameter, s->value, &out->cell);
    if (!refusal)
        return EXIT_OK;
    if (refusal != SM_REFUSAL_UNKNOWN || !(report_parameter_of_machines(c, p, s) || report_similar_parameter(c, p, s)))
        setting_report_refused(c, s, p->joint && refusal == SM_REFUSAL_UNKNOWN ? "the application has no such parameter"
                                                                               : parameter_refusal_text(refusal));
    return EXIT_PROBLEM;
}

// Adds a setting to the list.  A parameter that is in the list already has an error: which value is meant is unknown.
int settings_add(Cli *c, const Program *p, const Setting *s, ScriptSettings *list)
{
    ScriptSetting setting;
    const int code = setting_find(c, p, s, &setting);

    if (code != EXIT_OK)
        return code;
    for (size_t i = 0; i < list->n; i++)
        if (list->at[i].parameter == setting.parameter)
            return cli_usage_error(c, TEXT_setting_twice, setting.parameter->name->text);
    vec_push(&c->session.arena, list, setting);
    return EXIT_OK;
}

// Adds the values of all --set to the list, for the parameters of p.
int settings_read(Cli *c, const Program *p, ScriptSettings *list)
{
    int code = EXIT_OK;

    for (size_t i = 0; i < c->set.n; i++) {
        Setting s;
        int added;
        if (!setting_parse(c, c->set.at[i], &s))
            return EXIT_USAGE;
        if ((added = settings_add(c, p, &s, list)) == EXIT_USAGE)
            return added;
        code = added == EXIT_OK ? code : added;
    }
    return code;
}

void setting_report_refused(Cli *c, const Setting *s, const char *reason)
{
    cli_print_error(c, TEXT_setting_refused, (int)s->name_size, s->name, s->text, reason);
}
