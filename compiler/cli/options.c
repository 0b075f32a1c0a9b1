// SPDX-License-Identifier: Apache-2.0
// Parses argv into the fields of Cli according to options.def, and prints the same table as help.
#include "compiler/cli/cli.h"

#include <stdio.h>
#include <string.h>

typedef struct OptionInfo { const char *spelling, *value, *commands, *sentence; } OptionInfo;

static const OptionInfo option_info[OPT_COUNT] = {
#define OPTION(id, spelling, value, commands, sentence) {spelling, value, commands, sentence},
#include "compiler/cli/options.def"
#undef OPTION
};

static bool has_joined_value(const OptionInfo *o) { return o->value && (o->value[0] == '=' || o->value[0] == '?'); }
static bool has_optional_value(const OptionInfo *o) { return o->value && o->value[0] == '?'; }

// What the help of some subcommands says of an option instead.
typedef struct OptionInCommand { OptionId id; const char *commands, *value, *sentence; } OptionInCommand;

static const OptionInCommand option_in_command[] = {
#define OPTION(id, spelling, value, commands, sentence)
#define OPTION_IN(id, commands, value, sentence) {OPT_##id, commands, value, sentence},
#include "compiler/cli/options.def"
#undef OPTION
};

// Two subcommands with one letter would accept each other's options. These constants make that an error of the C compiler.
enum {
#define COMMAND(name, letter, synopsis, sentence) LETTER_##letter,
#include "compiler/cli/commands.def"
#undef COMMAND
    LETTERS
};

static bool option_applies(const OptionInfo *o, const Command *command)
{
    return o->commands[0] == '*' || strchr(o->commands, command->letter[0]) != NULL;
}

// Finds the option that `arg` spells, and where its joined value starts (NULL: none). Returns OPT_COUNT for an unknown option.
static OptionId find_option(const char *arg, const char **value)
{
    *value = NULL;
    if (strcmp(arg, "-h") == 0)
        return OPT_HELP;
    for (size_t i = 0; i < OPT_COUNT; i++)
        if (strcmp(arg, option_info[i].spelling) == 0)
            return (OptionId)i;
    for (size_t i = 0; i < OPT_COUNT; i++) {
        const OptionInfo *o = &option_info[i];
        size_t n = strlen(o->spelling);
        bool is_long = o->spelling[1] == '-';
        if (strncmp(arg, o->spelling, n) != 0 || (is_long ? arg[n] != '=' : o->value == NULL))
            continue;
        *value = arg + n + (is_long ? 1 : 0);
        return (OptionId)i;
    }
    return OPT_COUNT;
}

// Reports an unknown option, with the most similar known one.  Always returns false, the result of options_parse.
static bool report_unknown_option(Cli *c, const char *arg)
{
    const char *names[OPT_COUNT], *near;
    char head[64];
    size_t n = 0;

    snprintf(head, sizeof head, "%.*s", (int)strcspn(arg, "="), arg);
    for (size_t i = 0; i < OPT_COUNT; i++)
        if (option_applies(&option_info[i], c->command))
            names[n++] = option_info[i].spelling;
    near = str_nearest(head, names, n);
    if (near)
        cli_usage_error(c, TEXT_unknown_option_near, arg, near);
    else
        cli_usage_error(c, TEXT_unknown_option, arg);
    return false;
}

// Stores option `id`; `next` is the following argument or NULL.  Sets *took_next when that was its value.  Returns false after a message.
static bool store_option(Cli *c, OptionId id, const char *arg, const char *value, const char *next, bool *took_next)
{
    const OptionInfo *o = &option_info[id];

    if (!option_applies(o, c->command))
        return cli_usage_error(c, TEXT_option_of_other, o->spelling, c->command->name), false;
    if (!o->value && value)
        return cli_usage_error(c, TEXT_option_no_value, o->spelling), false;
    if (o->value && !value && !has_optional_value(o)) {
        if (has_joined_value(o) || !next)
            return cli_usage_error(c, TEXT_option_needs_value, arg, o->value + has_joined_value(o)), false;
        value = next;
        *took_next = true;
    }
    if (o->value && value && *value == '\0')
        return cli_usage_error(c, TEXT_option_empty, o->spelling, o->value + has_joined_value(o)), false;
    c->given[id] = true;
    c->value[id] = value;
    if (id == OPT_BIND)
        buf_printf(&c->bindings, "%s\n", value);
    if (id == OPT_SET)
        vec_push(&c->session.arena, &c->set, value);
    if (id == OPT_WARN)
        c->warn.word[c->warn.n++] = value;
    if (id == OPT_NO_WARN)
        c->warn.none = true;
    return true;
}

// Checks that the value of an option, if given, is one of n words; `list` names them in the message.  Returns false after the message.
static bool check_one_of(Cli *c, OptionId id, const char *const *allowed, size_t n, const char *list)
{
    if (!c->given[id])
        return true;
    for (size_t i = 0; i < n; i++)
        if (strcmp(c->value[id], allowed[i]) == 0)
            return true;
    cli_usage_error(c, TEXT_option_values, option_info[id].spelling, list, c->value[id]);
    return false;
}

// Checks the values of the options that every command reads in the same way; false after a message.
static bool check_values(Cli *c)
{
    static const char *const levels[] = {"0", "1", "2"};
    static const char *const formats[] = {"text", "json", "sarif"};
    static const char *const whens[] = {"auto", "always", "never"};
    const char *wrong;

    if (!check_one_of(c, OPT_OPT, levels, 3, "0, 1 or 2") || !check_one_of(c, OPT_FORMAT, formats, 3, "text, json or sarif"))
        return false;
    // SARIF describes findings in sources.  The failed cases of smc test go to standard error as text, which no document can contain.
    if (c->given[OPT_FORMAT] && strcmp(c->value[OPT_FORMAT], "sarif") == 0 && !c->given[OPT_MESSAGE_FILE] &&
        (!option_applies(&option_info[OPT_MESSAGE_FILE], c->command) || c->command->run == cmd_test)) {
        cli_usage_error(c, c->command->run == cmd_test ? TEXT_sarif_of_test : TEXT_sarif_commands);
        return false;
    }
    // The name is copied verbatim into a make rule; no file of that name is opened.
    if (c->given[OPT_DEPS_NAME] && !os_is_name(c->value[OPT_DEPS_NAME])) {
        cli_usage_error(c, TEXT_target_control, c->value[OPT_DEPS_NAME]);
        return false;
    }
    if (!check_one_of(c, OPT_COLOR, whens, 3, "auto, always or never"))
        return false;
    if ((wrong = diag_selection_error(&c->session.arena, &c->warn)) != NULL) {
        cli_usage_error(c, TEXT_sentence, wrong);
        return false;
    }
    c->session.warnings = diag_selection_groups(&c->warn);
    return true;
}

// Parses argv after the subcommand into the fields of c. false: a message has been printed, exit with EXIT_USAGE.
bool options_parse(Cli *c, int argc, char **argv)
{
    bool ended = false;

    c->file = ARENA_ARRAY(&c->session.arena, const char *, (size_t)argc + 1);
    buf_init(&c->bindings, &c->session.arena);
    c->warn.word = ARENA_ARRAY(&c->session.arena, const char *, (size_t)argc + 1);
    for (int i = 0; i < argc; i++) {
        const char *arg = argv[i], *value;
        bool took_next = false;
        OptionId id;
        if (ended || arg[0] != '-' || arg[1] == '\0' || arg[1] == '>') {        // `-> State` of smc why
            c->file[c->files++] = arg;
            continue;
        }
        if (strcmp(arg, "--") == 0) {
            ended = true;
            continue;
        }
        if ((id = find_option(arg, &value)) == OPT_COUNT)
            return report_unknown_option(c, arg);
        if (!store_option(c, id, arg, value, i + 1 < argc ? argv[i + 1] : NULL, &took_next))
            return false;
        i += took_next;
    }
    return c->given[OPT_HELP] || c->given[OPT_VERSION] || check_values(c);
}

// Returns an option with the description that it has in the help of this subcommand.
static OptionInfo find_option_help(OptionId id, const Command *command)
{
    OptionInfo o = option_info[id];

    for (size_t i = 0; i < sizeof option_in_command / sizeof *option_in_command; i++) {
        const OptionInCommand *in = &option_in_command[i];
        if (in->id == id && strchr(in->commands, command->letter[0])) {
            o.value = in->value;
            o.sentence = in->sentence;
        }
    }
    return o;
}

enum { HELP_COLUMN = 27, HELP_WIDTH = 100 };

// Writes a sentence that begins in HELP_COLUMN, with a new line at the last blank before HELP_WIDTH.
static void write_wrapped(Buf *out, const char *text)
{
    const size_t width = HELP_WIDTH - HELP_COLUMN;

    while (strlen(text) > width) {
        size_t n = width;
        while (n > 0 && text[n] != ' ')
            n--;
        if (n == 0)
            break;
        buf_printf(out, "%.*s\n%*s", (int)n, text, HELP_COLUMN, "");
        text += n + 1;
    }
    buf_printf(out, "%s\n", text);
}

void options_write_help(const Command *command, Buf *out)
{
    for (size_t i = 0; i < OPT_COUNT; i++) {
        const OptionInfo o = find_option_help((OptionId)i, command);
        char left[64];
        if (!option_applies(&o, command))
            continue;
        snprintf(left, sizeof left, "%s%s%s%s", o.spelling,
                 has_optional_value(&o) ? "[=" : !o.value || has_joined_value(&o) ? "" : o.spelling[1] == '-' ? "=" : " ",
                 o.value ? o.value + has_joined_value(&o) : "", has_optional_value(&o) ? "]" : "");
        buf_printf(out, "  %-*s ", HELP_COLUMN - 3, left);
        write_wrapped(out, o.sentence);
    }
}

int options_opt_level(const Cli *c)
{
    return c->given[OPT_OPT] ? c->value[OPT_OPT][0] - '0' : 2;
}
