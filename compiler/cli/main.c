// SPDX-License-Identifier: Apache-2.0
// The smc command: finds the subcommand, reads its options, runs it. Out of memory anywhere returns here by longjmp.
#include <stdio.h>
#include <string.h>

#include "compiler/cli/cli.h"
#include "compiler/version.h"

static const Command commands[] = {
#define COMMAND(name, letter, synopsis, sentence) {#name, #letter, synopsis, sentence, cmd_##name},
#define COMMAND_AS(name, spelling, letter, synopsis, sentence) {spelling, #letter, synopsis, sentence, cmd_##name},
#include "compiler/cli/commands.def"
#undef COMMAND
};

enum { COMMANDS = sizeof commands / sizeof *commands };

static void write_general_help(Buf *out)
{
    buf_str(out, "smc - state machines for rockets: checks them, tests them, compiles them to C and bytecode\n\nUsage:\n");
    for (size_t i = 0; i < COMMANDS; i++)
        buf_printf(out, "  smc %s\n      %s\n", commands[i].synopsis, commands[i].sentence);
    buf_str(out, "\n'smc COMMAND --help' lists a command's options.\n");
}

// Returns the subcommand; NULL after reporting an unknown name.
static const Command *find_command(Cli *c, const char *name)
{
    const char *names[COMMANDS], *near;

    for (size_t i = 0; i < COMMANDS; i++) {
        names[i] = commands[i].name;
        if (strcmp(name, names[i]) == 0)
            return &commands[i];
    }
    near = str_nearest(name, names, COMMANDS);
    if (has_suffix(name, ".sm") || has_suffix(name, ".sv") || has_suffix(name, ".io") || has_suffix(name, ".net") || has_suffix(name, ".app"))
        cli_usage_error(c, TEXT_command_first, name);
    else if (near)
        cli_usage_error(c, TEXT_unknown_command_near, name, near);
    else
        cli_usage_error(c, TEXT_unknown_command, name);
    return NULL;
}

static int print_text(Cli *c, int fd, const Buf *text, int code)
{
    return cli_print(c, fd, text) ? code : EXIT_ENVIRONMENT;
}

static int run_command(Cli *c, int argc, char **argv)
{
    Buf out;
    int code;

    buf_init(&out, &c->session.arena);
    if ((c->command = find_command(c, argv[1])) == NULL || !options_parse(c, argc - 2, argv + 2))
        return EXIT_USAGE;
    if (c->given[OPT_VERSION]) {
        buf_str(&out, "smc " SMC_VERSION "\n");
        return print_text(c, 1, &out, EXIT_OK);
    }
    if (c->given[OPT_HELP]) {
        buf_printf(&out, "Usage: smc %s\n  %s\n\nOptions:\n", c->command->synopsis, c->command->sentence);
        options_write_help(c->command, &out);
        return print_text(c, 1, &out, EXIT_OK);
    }
    buf_init(&c->message_file, &c->session.arena);
    if ((code = outputs_check_options(c)) != EXIT_OK)
        return code;
    return cli_finish(c, c->command->run(c));
}

static int dispatch_command(Cli *c, int argc, char **argv)
{
    Buf out;

    buf_init(&out, &c->session.arena);
    if (argc < 2) {
        write_general_help(&out);
        return print_text(c, 2, &out, EXIT_USAGE);
    }
    if (strcmp(argv[1], "help") == 0 && argc > 2) {
        char *swapped[] = {argv[0], argv[2], "--help"};
        return run_command(c, 3, swapped);
    }
    if (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0 || strcmp(argv[1], "help") == 0) {
        write_general_help(&out);
        return print_text(c, 1, &out, EXIT_OK);
    }
    if (strcmp(argv[1], "--version") == 0) {
        buf_str(&out, "smc " SMC_VERSION "\n");
        return print_text(c, 1, &out, EXIT_OK);
    }
    if (argv[1][0] == '-')
        return cli_usage_error(c, TEXT_option_before_command, argv[1]);
    return run_command(c, argc, argv);
}

int main(int argc, char **argv)
{
    static Cli cli;           // static, so that its value is defined after the longjmp
    jmp_buf oom;
    int code;

    os_start(&argc, &argv);
    if (setjmp(oom) != 0) {
        fprintf(stderr, "smc: %s\n", cli.session.bug ? cli.session.bug : "out of memory");
        code = cli.session.bug ? EXIT_INTERNAL : EXIT_ENVIRONMENT;
        session_free(&cli.session);
        return code;
    }
    session_init(&cli.session, os_alloc, NULL, &oom);
    code = dispatch_command(&cli, argc, argv);
    session_free(&cli.session);
    return code;
}
