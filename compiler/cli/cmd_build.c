// SPDX-License-Identifier: Apache-2.0
// smc build: compiles machines to bytecode (a file or a C array), to C, or to the text of a stage.
#include <string.h>

#include "compiler/base/path.h"
#include "compiler/cli/cli.h"
#include "compiler/cli/deps.h"
#include "compiler/passes/pass.h"

static const char *const emit_name[] = {"", "bytecode", "array", "c", "ir", "ast", "tokens"};      // by CompileEmit

static bool is_image(CompileEmit e) { return e == EMIT_BYTECODE || e == EMIT_ARRAY; }
static bool is_stage_text(CompileEmit e) { return e == EMIT_AST || e == EMIT_TOKENS; }

// Reads --emit into *emit, bytecode if it is absent. Returns false after a message about an unknown kind of output.
static bool find_emit(Cli *c, CompileEmit *emit)
{
    *emit = EMIT_BYTECODE;
    if (!c->given[OPT_EMIT])
        return true;
    for (size_t i = 1; i < sizeof emit_name / sizeof *emit_name; i++)
        if (strcmp(c->value[OPT_EMIT], emit_name[i]) == 0) {
            *emit = (CompileEmit)i;
            return true;
        }
    cli_usage_error(c, TEXT_emit_values, c->value[OPT_EMIT]);
    return false;
}

// ---- names of outputs ----

// Whether -o names a folder, which receives every output under its default name. A missing one is created if the name ends in a separator.
static bool is_to_folder(const Cli *c)
{
    return c->given[OPT_OUTPUT] && (path_ends_in_separator(c->value[OPT_OUTPUT]) || os_is_folder(c->value[OPT_OUTPUT]));
}

// Returns the path of a file in the folder that -o names.
static const char *path_in_folder(Cli *c, const char *name)
{
    const char *folder = c->value[OPT_OUTPUT];

    return format_in(&c->session.arena, "%s%s%s", folder, *folder && !path_ends_in_separator(folder) ? "/" : "", name);
}

// Returns the path of an output: the value of -o, or a file in the folder that -o names; without -o, the input's stem with this suffix.
static const char *output_path(Cli *c, const char *input, const char *suffix)
{
    const char *name = format_in(&c->session.arena, "%s%s", path_stem(c, input), suffix);

    if (is_to_folder(c))
        return path_in_folder(c, name);
    return c->given[OPT_OUTPUT] ? c->value[OPT_OUTPUT] : name;
}

// Returns the path of a C file generated from one input. `suffix`: ".c" or "_io.h", for example. -o names the .c, the stem of both
// files, or their folder.
static const char *c_path(Cli *c, const char *input, const char *suffix)
{
    const char *path = output_path(c, input, suffix);
    const size_t n = strlen(path) - (has_suffix(path, ".c") || has_suffix(path, ".h") ? 2 : 0);

    return format_in(&c->session.arena, "%.*s%s", (int)n, path, suffix + strlen(suffix) - 2);
}

static EmitCOptions make_c_options(Cli *c, const char *input, const char *header)
{
    EmitCOptions e;

    memset(&e, 0, sizeof e);
    e.prefix = c->given[OPT_PREFIX] ? c->value[OPT_PREFIX] : NULL;
    e.header = path_file_name(header);
    e.track_stores = c->given[OPT_TRACK];
    e.soft = c->given[OPT_SOFT];
    e.runtime = c->given[OPT_RUNTIME];
    e.source = strcmp(input, "-") == 0 ? "stdin" : path_file_name(input);
    return e;
}

// Returns the path at which an artefact is written.
static const char *artefact_path(Cli *c, const Artefact *a, CompileEmit emit)
{
    if (a->name)              // a file of an application: -o names the folder
        return c->given[OPT_OUTPUT] ? path_in_folder(c, a->name) : a->name;
    if (!a->suffix && !c->given[OPT_OUTPUT])
        return "-";
    if (!a->suffix)
        return output_path(c, c->file[a->source], format_in(&c->session.arena, ".%s", emit_name[emit]));
    return emit == EMIT_C ? c_path(c, c->file[a->source], a->suffix) : output_path(c, c->file[a->source], a->suffix);
}

// ---- outputs ----

typedef struct Outputs {
    OsOutput *at;
    size_t n;
} Outputs;

static void add_output(Outputs *o, const char *path, const Buf *bytes)
{
    o->at[o->n++] = (OsOutput){path, buf_text(bytes), bytes->n};
}

// Adds the soft-float library to the outputs, beside the C file `code`, once per folder.
static void add_soft_library(Cli *c, const char *code, Outputs *o)
{
    static const char *const name[] = {"sm_soft.h", "sm_soft.c", "sm_soft_avr.S"};
    Buf text[3];

    for (size_t i = 0; i < 3; i++)
        buf_init(&text[i], &c->session.arena);
    emit_c_soft_library(&text[0], &text[1], &text[2]);
    for (size_t i = 0; i < 3; i++) {
        const char *path = format_in(&c->session.arena, "%.*s%s", (int)(path_file_name(code) - code), code, name[i]);
        size_t k = 0;
        while (k < o->n && strcmp(o->at[k].path, path) != 0)
            k++;
        if (k == o->n)
            add_output(o, path, &text[i]);
    }
}

static Outputs list_outputs(Cli *c, const Compiled *made, CompileEmit emit)
{
    Outputs o = {ARENA_ARRAY(&c->session.arena, OsOutput, made->artefact.n + 3 * c->files + 1), 0};

    for (size_t i = 0; i < made->artefact.n; i++) {
        const Artefact *a = &made->artefact.at[i];
        const char *path = artefact_path(c, a, emit);
        add_output(&o, path, a->bytes);
        if (emit == EMIT_C && !made->app && has_suffix(path, ".h") && c->given[OPT_SOFT] && !c->given[OPT_RUNTIME])
            add_soft_library(c, path, &o);
    }
    return o;
}

// Writes all outputs. Creates the folder that -o names (`to_folder`) only after all outputs have been checked.
static int write_outputs(Cli *c, const Outputs *o, bool to_folder)
{
    const char *folder = c->value[OPT_OUTPUT], *why;
    const int code = outputs_check(c, o->at, o->n);

    if (code != EXIT_OK)
        return code;
    if (to_folder && *folder && !os_make_folder(folder, &why)) {
        cli_print_error(c, TEXT_cannot_make_folder, cli_printable_name(&c->session.arena, folder), why);
        return EXIT_ENVIRONMENT;
    }
    return cli_write_outputs(c, o->at, o->n);
}

// ---- which options and arguments go together ----

// Checks that a .c and a .h can be written beside each other at `path`; false after a message.
static bool check_c_pair_name(Cli *c, const char *path)
{
    if (strcmp(path, "-") == 0)
        cli_usage_error(c, TEXT_c_to_stdout);
    else if (os_is_special(path))
        cli_usage_error(c, TEXT_c_to_special, path);
    else
        return true;
    return false;
}

static int check_app_arguments(Cli *c)
{
    if (c->files > 1)
        return cli_usage_error(c, TEXT_app_built_alone);
    if (c->given[OPT_SV])
        return cli_usage_error(c, TEXT_app_names_vector, c->file[0]);
    if (c->given[OPT_EMIT] && strcmp(c->value[OPT_EMIT], "c") != 0)
        return cli_usage_error(c, TEXT_app_becomes_c, c->value[OPT_EMIT]);
    if (c->given[OPT_PREFIX])
        return cli_usage_error(c, TEXT_app_no_prefix);
    if (c->given[OPT_OUTPUT] && strcmp(c->value[OPT_OUTPUT], "-") == 0)
        return cli_usage_error(c, TEXT_app_needs_folder);
    return EXIT_OK;
}

// Checks the options that apply to C or to images only, and the value of --prefix.
static int check_c_options(Cli *c, CompileEmit emit)
{
    if (c->given[OPT_RUNTIME] && emit != EMIT_C)
        return cli_usage_error(c, TEXT_runtime_needs_c);
    if (c->given[OPT_SOFT] && emit != EMIT_C)
        return cli_usage_error(c, TEXT_soft_needs_c);
    if ((c->given[OPT_MAX_RAM] || c->given[OPT_MAX_STEP] || c->given[OPT_MAX_CYCLES] || c->given[OPT_MCU]) && !is_image(emit))
        return cli_usage_error(c, TEXT_limits_need_image, emit_name[emit]);
    if (c->given[OPT_PREFIX] && emit_c_prefix_error(c->value[OPT_PREFIX]))
        return cli_usage_error(c, TEXT_bad_prefix, c->value[OPT_PREFIX], emit_c_prefix_error(c->value[OPT_PREFIX]));
    return EXIT_OK;
}

// Checks that all inputs are of one kind, and that smc build accepts this kind.  Returns EXIT_OK, or EXIT_USAGE after a message.
static int check_kinds(Cli *c, CompileEmit emit, FileKind first)
{
    for (size_t i = 0; i < c->files; i++) {
        FileKind kind = FILE_SM;
        file_kind(c->file[i], &kind);
        if (kind == FILE_APP)
            return cli_usage_error(c, TEXT_app_built_alone);
        if (kind != first)
            return cli_usage_error(c, TEXT_build_mixed, c->file[0], c->file[i]);
    }
    if ((first == FILE_IO || first == FILE_NET) && !c->given[OPT_SV])
        return cli_usage_error(c, TEXT_pins_need_vector, c->file[0]);
    if ((first == FILE_IO || first == FILE_NET) && emit != EMIT_C)
        return cli_usage_error(c, TEXT_pins_need_c);
    if (c->given[OPT_IO] && (first != FILE_SM || !is_image(emit) || !c->given[OPT_SV]))
        return cli_usage_error(c, TEXT_io_needs_image, c->value[OPT_IO]);
    if (first == FILE_SS)
        return cli_usage_error(c, TEXT_script_not_built, c->file[0]);
    if (first == FILE_RQ)
        return cli_usage_error(c, TEXT_requirements_not_built, c->file[0]);
    if (first == FILE_SV && (is_image(emit) || emit == EMIT_IR))
        return cli_usage_error(c, TEXT_vector_alone, emit == EMIT_IR ? "IR" : "bytecode");
    return EXIT_OK;
}

// Checks the names of the outputs.  Returns EXIT_OK, or EXIT_USAGE after a message.
static int check_output_names(Cli *c, CompileEmit emit)
{
    if (emit == EMIT_BYTECODE && !c->given[OPT_EMIT] && c->given[OPT_OUTPUT] &&
        (has_suffix(c->value[OPT_OUTPUT], ".c") || has_suffix(c->value[OPT_OUTPUT], ".h")))
        return cli_usage_error(c, TEXT_name_for_c, c->value[OPT_OUTPUT]);
    if (emit != EMIT_C)
        return EXIT_OK;
    if (c->given[OPT_OUTPUT] && !check_c_pair_name(c, c->value[OPT_OUTPUT]))
        return EXIT_USAGE;
    for (size_t i = 0; i < c->files; i++) {
        const char *path = output_path(c, c->file[i], ".c");
        if (strpbrk(path_file_name(path), "\"\\"))           // #include "…" could not name its header
            return cli_usage_error(c, TEXT_c_not_includable, path);
    }
    if (c->files > 1 && c->given[OPT_OUTPUT] && !is_to_folder(c))
        return cli_usage_error(c, TEXT_several_outputs, c->value[OPT_OUTPUT], c->value[OPT_OUTPUT]);
    if (c->files > 1 && c->given[OPT_PREFIX])
        return cli_usage_error(c, TEXT_several_prefixes);
    return EXIT_OK;
}

// Checks that the inputs, the kind of output and the options are compatible.  Returns EXIT_OK, or EXIT_USAGE after a message.
static int check_arguments(Cli *c, CompileEmit emit)
{
    FileKind first = FILE_SM;
    int code;

    if (c->files == 0)
        return cli_usage_error(c, TEXT_build_what);
    if (!cli_check_sources(c, true))
        return EXIT_USAGE;
    file_kind(c->file[0], &first);
    if (is_stage_text(emit))
        return check_c_options(c, emit);
    if (first == FILE_APP)
        return check_app_arguments(c);
    if ((code = check_kinds(c, emit, first)) != EXIT_OK || (code = check_output_names(c, emit)) != EXIT_OK)
        return code;
    return check_c_options(c, emit);
}

// Sets up the printing of the IR that --print-after requests; false after a message.
static bool set_print_after(Cli *c)
{
    const char *pass = c->value[OPT_PRINT], *known = "build";

    if (!c->given[OPT_PRINT])
        return true;
    c->session.print_after = pass;
    c->session.print_to = ARENA_NEW(&c->session.arena, Buf);
    buf_init(c->session.print_to, &c->session.arena);
    if (pass_find(pass) || strcmp(pass, "build") == 0)
        return true;
    for (int i = 0; i < PASS_COUNT; i++)
        known = format_in(&c->session.arena, "%s, %s", known, pass_info[i].name);
    cli_usage_error(c, TEXT_no_such_pass, pass, known);
    return false;
}

int cmd_build(Cli *c)
{
    CompileEmit emit;
    CompileInput in;
    CompileOptions o;
    Compiled made;
    Outputs out;
    bool ok;
    int code;

    if (!find_emit(c, &emit))
        return EXIT_USAGE;
    if ((code = check_arguments(c, emit)) != EXIT_OK)
        return code;
    if (!cli_compile_options(c, &o) || !set_print_after(c))
        return EXIT_USAGE;
    if ((code = cli_read_inputs(c, &in)) != EXIT_OK)
        return code;
    if (is_stage_text(emit))
        in.app = NULL;
    o.emit = in.app ? EMIT_C : emit;
    o.names = (in.app || c->given[OPT_DEBUG]) && !c->given[OPT_STRIP];      // the log of an application contains the names of states
    for (size_t i = 0; i < in.n; i++)
        in.at[i].c = make_c_options(c, c->file[i], emit == EMIT_C
                                    ? c_path(c, c->file[i], in.at[i].kind == FILE_IO ? "_io.h" : in.at[i].kind == FILE_NET ? "_net.h" : ".h")
                                                             : output_path(c, c->file[i], "_image.h"));
    in.at[0].array = path_stem(c, c->file[0]);
    ok = compile_sources(&c->session, &in, &o, &made);
    if (c->session.print_to && !cli_print(c, 2, c->session.print_to))
        return EXIT_ENVIRONMENT;
    if ((code = cli_print_diagnostics(c)) != EXIT_OK || !ok)
        return code != EXIT_OK ? code : EXIT_PROBLEM;
    out = list_outputs(c, &made, o.emit);
    if (deps_wanted(c) && !deps_check_name(c, &out.at[0]))
        return EXIT_USAGE;
    if (deps_wanted(c))
        deps_add_rule(c, out.at, &out.n, deps_list_inputs(c));
    return write_outputs(c, &out, (in.app && c->given[OPT_OUTPUT]) || is_to_folder(c));
}
