// SPDX-License-Identifier: Apache-2.0
// The smc command: declarations shared by its subcommands. A subcommand parses arguments, calls the library and returns an exit code.
// Unless its comment says otherwise, a function of this folder that returns int returns an exit code: any other than EXIT_OK follows a message.
#ifndef SMC_CLI_H
#define SMC_CLI_H

#include <stdbool.h>
#include <stddef.h>

#include "bytecode-vm/smvm.h"
#include "compiler/base/os.h"
#include "compiler/compile.h"

// Exit codes: stable, because docs and scripts rely on them.
enum {
    EXIT_OK = 0,
    EXIT_PROBLEM = 1,         // the user's input has a problem: compile error, failed script
    EXIT_USAGE = 2,
    EXIT_ENVIRONMENT = 3,     // cannot read or write, out of memory, no device
    EXIT_INTERNAL = 4,        // a bug in smc
    EXIT_INCONCLUSIVE = 5     // a bound was reached: cover has not found every goal, prove has not decided every requirement
};

typedef enum OptionId {
#define OPTION(id, spelling, value, commands, sentence) OPT_##id,
#include "compiler/cli/options.def"
#undef OPTION
    OPT_COUNT
} OptionId;

typedef struct Cli Cli;

typedef struct Command {
    const char *name;
    const char *letter;                   // one character, which identifies the subcommand in options.def
    const char *synopsis, *sentence;
    int (*run)(Cli *c);
} Command;

struct Cli {
    Session session;                      // one compilation; out of memory anywhere ends the command with exit code 3
    const Command *command;
    const char **file;                    // the `files` arguments that are not options, in order; "-" included
    size_t files;
    bool given[OPT_COUNT];                // by OptionId: the command line has the option
    const char *value[OPT_COUNT];         // by OptionId: the value of an option that takes one; of several, the last
    VEC(Source *) scripts;                // the scripts that have been read, and the files that they include
    VEC(const char *) data;               // the paths of the files with recorded data that scripts name
    VEC(const Source *) included;         // the files that scripts include and no argument names
    VEC(const Source *) named;            // the files that an application names
    VEC(const char *) set;                // the values of --set, in order
    DiagSelection warn;
    Buf bindings;                         // the values of all --bind, one on each line
    Diags reported;                       // all diagnostics that cli_print_diagnostics has printed, for a SARIF document
    PlainMessages plain;                  // messages that are no diagnostics, printed so far; for the same document
    Buf message_file;                     // content of the file of --message-file, unless that is SARIF
    const char *last_error;               // the last text that cli_print_error has printed
};

// ---- options.c ----

// Parses argv after the subcommand into the fields of c. false: a message has been printed, exit with EXIT_USAGE.
bool options_parse(Cli *c, int argc, char **argv);
void options_write_help(const Command *command, Buf *out);      // writes the options of a subcommand, one per line
int options_opt_level(const Cli *c);                           // returns the value of -O: 0, 1 or 2

// ---- common.c ----

#if defined(__GNUC__)
#define CLI_PRINTF __attribute__((format(printf, 2, 3)))
#else
#define CLI_PRINTF
#endif

// Defines the messages of texts.def as constants TEXT_name.
#define CLI_TEXT(name, format) static const char TEXT_##name[] = format;
#include "compiler/cli/texts.def"
#undef CLI_TEXT

// Each prints "smc: " and a message to standard error, as text or as --message-format selects.
CLI_PRINTF void cli_print_error(Cli *c, const char *format, ...);
CLI_PRINTF void cli_print_warning(Cli *c, const char *format, ...);      // text begins with "warning: "
CLI_PRINTF void cli_print_note(Cli *c, const char *format, ...);         // for information that requires no action
// Adds a message to the file that --message-file names, and does not print it.
void cli_record_message(Cli *c, const char *severity, const char *text);
// Usage error: prints a message and refers to --help. Returns EXIT_USAGE.
CLI_PRINTF int cli_usage_error(Cli *c, const char *format, ...);

// Returns a name for use in a message, with control characters as \x0a; no file with such a name is ever opened. cli_usage_error calls this
// itself.
const char *cli_printable_name(Arena *a, const char *name);
// Reads an image and runs the device's own verifier on it.  EXIT_OK, or the exit code after a message.
int cli_load_image(Cli *c, const char *path, Source **image, SmvmVerdict *v);
void cli_write_pin(Buf *out, const SmvmPin *p);          // writes a pin in words: "digital input 2 with @pull_up"
// Writes outputs, after outputs_check. Returns EXIT_OK, or the exit code after a message: then no file has been replaced.
int cli_write_outputs(Cli *c, const OsOutput *out, size_t n);
// Writes an edited file over its input, without outputs_check. Reports hard links, because os_write_files changes only one of them.
int cli_write_edited(Cli *c, const OsOutput *out);
// Writes a file that a command generates into a folder of the user, without outputs_check: the caller knows that nothing of others is there.
int cli_write_generated(Cli *c, const OsOutput *out);
bool cli_print(Cli *c, int fd, const Buf *text);          // prints to standard output (1) or error (2); returns false if that
                                                          // failed, for standard output after a message

// Prints the session's diagnostics to standard error, with warnings as -W… selects them, and empties the list. Returns EXIT_PROBLEM if
// there was an error, EXIT_ENVIRONMENT if printing failed, else EXIT_OK.
int cli_print_diagnostics(Cli *c);
bool cli_prints_text(const Cli *c);       // whether diagnostics are printed as text alone, for a person

// Prints a SARIF document, and writes the file that --message-file names. Every command returns through it, with its exit code. After a usage
// error there is no document and no file: the file can be what the error is about.
int cli_finish(Cli *c, int code);

bool has_suffix(const char *path, const char *suffix);

#define EFFORT_MOST UINT64_C(1000000000)      // of --effort, in millions of steps
// Read a number such as the value of --seed.  Each returns false if it is not a whole number that 64 bits can hold; a count begins at 1.
bool cli_read_whole(const char *text, uint64_t *number);
bool cli_read_count(const char *text, uint64_t *count);
// Reads the value of an option, a whole number from 1 to `most`, if the option is given.  Returns false after a message.
bool cli_read_limit(Cli *c, OptionId id, const char *spelling, uint64_t most, uint64_t *count);
// Reads a time of --at, as in 400, '4 s' or 250ms, and converts it to units of G.  EXIT_OK, or EXIT_USAGE after a message.
int cli_read_time(Cli *c, const char *text, TimeUnit unit, uint64_t *g);
// Reads a percentage from 0 to 100, with up to six digits after the point.  Returns what follows it, or NULL.
const char *cli_read_percent(const char *at, double *percent);
bool cli_is_standard_output(const Cli *c, OptionId id);         // whether an option names "-"

// A format that a command can write; the first one is the default.
typedef struct CliFormat {
    const char *name;
    const char *suffix[3];                // endings of file names in this format, such as ".dot"; NULL: end of the list
    const char *viewer;                   // what to open the format with, if a terminal cannot display it: "a browser"
} CliFormat;
// Stores the index in `format` of the format that --format names. Without --format, the suffix of the -o name decides; without both, it is
// the first format, unless that would be printed on a terminal that cannot display it. Returns false after a message.
bool cli_choose_format(Cli *c, const CliFormat *format, size_t formats, size_t *found);

// Returns a file's name without folders and ending: "tank" for "dir/tank.sm", "stdin" for "-". Allocated in the session.
const char *path_stem(Cli *c, const char *path);

// ---- outputs.c: which files a command can write ----

// Whether all outputs can be written. None can be a source, an input, or a file that smc did not write (--force allows that last one),
// and no name can occur twice. Returns EXIT_OK, or the exit code after a message.
int outputs_check(Cli *c, const OsOutput *out, size_t n);
// Makes the same checks for the outputs that options name, before any input is read. Other names of standard output, such as /dev/stdout,
// become "-".
int outputs_check_options(Cli *c);
bool outputs_is_source_name(const char *name, size_t n);

// ---- inputs.c: the inputs of compile_sources(), from the arguments ----

// Reads a source; NULL after a message (exit with EXIT_ENVIRONMENT).  Diagnostics show the name as given.
Source *cli_read_source(Cli *c, const char *path);
// Reads every file that the command line names, and those of --sv and --io.  An application's own files are read too; a missing one is
// reported when it is checked.  "-" is a machine.  EXIT_OK, or EXIT_ENVIRONMENT after a message.
int cli_read_inputs(Cli *c, CompileInput *in);
// Reads the files that the application in->at[0] names, and sets in->app. One that cannot be read is reported when the application is checked.
void cli_load_app(Cli *c, CompileInput *in);
// Reads --bind, which is an error if the command line does not have exactly one machine (`machines`: how many); *out is NULL without --bind.
// EXIT_OK, or the exit code after a message.
int cli_read_bindings(Cli *c, size_t machines, const MachineInstance **out);
// Reads -O, --step, the limits, -W and --soft.  false after a message: one of them is not a number.
bool cli_compile_options(Cli *c, CompileOptions *o);
// Checks that the names of all files have the suffix of a source ("-" is accepted if `standard_input`); false after a message.
bool cli_check_sources(Cli *c, bool standard_input);

// ---- fix_list.c ----

// Lists the changed lines of a source: NAME:LINE: with its old number, then the text before and after.
void fix_write_changes(const Source *was, const Source *is, Buf *out);

// ---- one file each ----

#define COMMAND(name, letter, synopsis, sentence) int cmd_##name(Cli *c);
#include "compiler/cli/commands.def"
#undef COMMAND

#endif
