// SPDX-License-Identifier: Apache-2.0
// The smc command: what its subcommands share.  A subcommand is arguments, a call into the library, an exit code.
#ifndef SMC_CLI_H
#define SMC_CLI_H

#include <stdbool.h>
#include <stddef.h>

#include "bytecode-vm/smvm.h"
#include "compiler/base/os.h"
#include "compiler/pipeline.h"

// Exit codes: a promise (docs and scripts rely on them).
enum {
    EXIT_OK = 0,
    EXIT_PROBLEM = 1,         // the user's input has a problem: compile error, failed script
    EXIT_USAGE = 2,
    EXIT_ENVIRONMENT = 3,     // cannot read, write, no memory, no device
    EXIT_INTERNAL = 4,        // a bug of ours
    EXIT_INCONCLUSIVE = 5     // a bound was hit
};

typedef enum OptionId {
#define OPTION(id, spelling, value, commands, sentence) OPT_##id,
#include "compiler/cli/options.def"
#undef OPTION
    OPT_COUNT
} OptionId;

typedef struct Cli Cli;

typedef struct Command {
    const char *name, *synopsis, *sentence;
    int (*run)(Cli *c);
} Command;

// -W… as given: each word without its -W, in order.
typedef struct Warnings {
    const char **word;
    size_t n;
    bool none;                            // -w
} Warnings;

struct Cli {
    Session session;                      // one compilation; out of memory anywhere ends the command with exit 3
    const Command *command;
    const char **file;                    // the arguments that are no options, in order; "-" included
    size_t files;
    bool given[OPT_COUNT];
    const char *value[OPT_COUNT];         // of an option that takes one; the last one given
    Warnings warn;
    Sentences said;                       // for the end of a document in SARIF
    bool reported;                        // that has been begun
    const char *last_error;               // the last message of cli_say; lives in the session
};

// ---- options.c ----

// Sorts argv behind the subcommand into the fields of c.  false: a message has been printed, exit with EXIT_USAGE.
bool options_parse(Cli *c, int argc, char **argv);
void options_help(const Command *command, Buf *out);      // the options a subcommand knows, a line each
int option_level(const Cli *c);                           // -O: 0, 1 or 2
// The nearest of the names to `name`, or NULL if none is near.
const char *nearest_name(const char *name, const char *const *names, size_t n);

// ---- common.c ----

#if defined(__GNUC__)
#define CLI_PRINTF __attribute__((format(printf, 2, 3)))
#else
#define CLI_PRINTF
#endif

// "smc: " and a message to standard error; in the form that --message-format asks for.
CLI_PRINTF void cli_say(Cli *c, const char *format, ...);
CLI_PRINTF void cli_remark(Cli *c, const char *format, ...);      // of what hinders nothing
// Usage error: a message, and a hint at --help.  Gives EXIT_USAGE.
CLI_PRINTF int cli_usage(Cli *c, const char *format, ...);

// Reads a source; NULL after a message (exit with EXIT_ENVIRONMENT).  The name stands in diagnostics as given.
Source *cli_load(Cli *c, const char *path);
// A name for a message: control characters, with which no file is opened, as \x0a.  cli_usage does it by itself.
const char *cli_shown(Arena *a, const char *name);
// Reads an image and runs the device's own verifier on it.  EXIT_OK, or the exit code after a message.
int cli_load_image(Cli *c, const char *path, Source **image, SmvmVerdict *v);
void cli_put_pin(Buf *out, const SmvmPin *p);          // "digital input 2 with @pull_up"
// Reads the scripts of the call, once each: by argument, NULL for what is no script or cannot be read (after a message, which is then in
// problem[argument] unless `problem` is NULL).  Then cli_note_scripts.
Source **cli_load_scripts(Cli *c, Map *written, const char **problem);
// The names that scripts (by argument) assign go into `written`: a machine is compiled with those locals as variables, to run
// them.  Without --step, the session's step becomes the delta_t of the scripts if all have the same.
void cli_note_scripts(Cli *c, Source *const *ss, Map *written);
// Writes outputs, after outputs_check.  EXIT_OK, or the exit code after a message: nothing has been replaced then.
int cli_write(Cli *c, const OsOutput *out, size_t n);
// Writes what a command has edited over its input, without outputs_check.  Reports hard links, of which os_write changes one.
int cli_rewrite(Cli *c, const OsOutput *out);
bool cli_print(Cli *c, int fd, const Buf *text);          // to standard output or error; false after a message

// Prints what the session's diagnostics say, warnings as -W… wants them, to standard error and empties the list.
// EXIT_PROBLEM if an error was among them, EXIT_ENVIRONMENT if it could not print, else EXIT_OK.
int cli_report(Cli *c);

// What the command is left through, with its exit code: ends what cli_report has begun.
int cli_end(Cli *c, int code);

bool has_suffix(const char *path, const char *suffix);

// What a command can write, the default first.
typedef struct CliFormat {
    const char *name;
    const char *ending[3];                // ".dot"; NULL: no more
    const char *viewer;                   // what it is looked at with, where a terminal shows nothing of it: "a browser"
} CliFormat;
// Which of `formats` --format names; without it, which one the name behind -o ends like; else the first, unless that would flood a
// terminal.  false after a message.
bool cli_format(Cli *c, const CliFormat *format, size_t formats, size_t *found);

// "tank" of "dir/tank.sm"; of "-" it is "stdin".  Lives in the session.
const char *path_stem(Cli *c, const char *path);

// ---- outputs.c: what a command may write to ----

// Whether all of these may be written: no source, no input, no file that smc did not write (--force allows that one), and no name
// twice.  EXIT_OK, or the exit code after a message.
int outputs_check(Cli *c, const OsOutput *out, size_t n);
// The same for the outputs that options name, before anything is read.  Other names of standard output, as /dev/stdout, become "-".
int outputs_check_options(Cli *c);
bool outputs_is_source_name(const char *name, size_t n);

// ---- warnings.c ----

// 1u << DiagGroup of each group of which some warning is wanted.
unsigned warnings_groups(const Warnings *w);
// Drops the warnings that are switched off and makes errors of those that -Werror names.
void warnings_apply(const Warnings *w, Diags *d);
// What is wrong with the words: "no warning is called 'x'; did you mean 'y'?"; NULL if nothing is.
const char *warnings_complaint(Arena *arena, const Warnings *w);

// ---- limits.c: --step, --max-ram, --max-step and --max-cycles ----

bool step_known(Cli *c);                  // reads --step; false after a message: it is no number
bool limits_known(Cli *c);                // reads --step and the others; false after a message: one of them is no number
bool limits_given(const Cli *c);
// Reports what machine m, compiled from p as it will fly, takes beyond them.
void limits_check(Cli *c, const Program *p, IrMachine *m);

// ---- fix_list.c ----

// Which lines of a source are other ones now: NAME:LINE: as it was, then before and after.
void fix_list(const Source *was, const Source *is, Buf *out);

// ---- one file each ----

#define COMMAND(name, synopsis, sentence) int cmd_##name(Cli *c);
#include "compiler/cli/commands.def"
#undef COMMAND

#endif
