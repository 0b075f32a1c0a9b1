// SPDX-License-Identifier: Apache-2.0
// smc build: compiles machines to bytecode (a file or a C array), to C, or to the text of a stage.
#include <string.h>

#include "compiler/analysis/analysis.h"
#include "compiler/cli/app.h"
#include "compiler/cli/cli.h"
#include "compiler/cli/deps.h"
#include "compiler/passes/pass.h"
#include "compiler/syntax/parse.h"

typedef enum Emit { EMIT_BYTECODE, EMIT_ARRAY, EMIT_C, EMIT_IR, EMIT_AST, EMIT_TOKENS, EMIT_COUNT } Emit;

static const char *const emit_name[EMIT_COUNT] = {"bytecode", "array", "c", "ir", "ast", "tokens"};

static bool is_image(Emit e) { return e == EMIT_BYTECODE || e == EMIT_ARRAY; }

// The outputs of a build: at most the C and header of each machine, the soft-float files, and the make rule.
typedef struct Outputs {
    OsOutput *at;
    size_t n;
} Outputs;

static bool find_emit(Cli *c, Emit *emit)
{
    *emit = EMIT_BYTECODE;
    if (!c->given[OPT_EMIT])
        return true;
    for (size_t i = 0; i < EMIT_COUNT; i++)
        if (strcmp(c->value[OPT_EMIT], emit_name[i]) == 0) {
            *emit = (Emit)i;
            return true;
        }
    cli_usage(c, "--emit is bytecode, array, c, ir, ast or tokens, not '%s'", c->value[OPT_EMIT]);
    return false;
}

static bool source_kind(Cli *c, const char *path, FileKind *kind)
{
    *kind = FILE_SM;
    if (strcmp(path, "-") == 0 || file_kind(path, kind))
        return true;
    cli_usage(c, "'%s' is no source: names end in .sm, .sv, .ss, .io or .app", path);
    return false;
}

static void add_output(Outputs *o, const char *path, const Buf *bytes)
{
    o->at[o->n].path = path;
    o->at[o->n].bytes = buf_text(bytes);
    o->at[o->n++].n = bytes->n;
}

// Returns a new buffer that outlives the call.
static Buf *new_buf(Cli *c)
{
    Buf *b = ARENA_NEW(&c->session.arena, Buf);
    buf_init(b, &c->session.arena);
    return b;
}

static const char *file_part(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

// ---- stages as text ----

static int emit_tokens_or_ast(Cli *c, Emit emit, Outputs *o)
{
    Buf *out = new_buf(c);

    for (size_t i = 0; i < c->files; i++) {
        FileKind kind;
        Source *src;
        if (!source_kind(c, c->file[i], &kind))
            return EXIT_USAGE;
        if ((src = cli_load(c, c->file[i])) == NULL)
            return EXIT_ENVIRONMENT;
        buf_str(out, emit == EMIT_TOKENS ? "# Tokens of " : "# Syntax tree of ");
        diag_put_printable(out, file_part(src->name), strlen(file_part(src->name)));
        buf_str(out, ", printed by smc\n");
        if (emit == EMIT_TOKENS)
            lex_print(&c->session.strings, &c->session.diags, src, kind, out);
        else {
            AstFile *f = session_parse(&c->session, src, kind);
            if (f)
                ast_print(f, out);
        }
    }
    add_output(o, c->given[OPT_OUTPUT] ? c->value[OPT_OUTPUT] : "-", out);
    return EXIT_OK;
}

// ---- compiled machines ----

static const char *output_path(Cli *c, const char *input, const char *suffix)
{
    return c->given[OPT_OUTPUT] ? c->value[OPT_OUTPUT] : format_in(&c->session.arena, "%s%s", path_stem(c, input), suffix);
}

// Finds the two C files of one input: -o names the .c, or their common stem.
static void c_paths(Cli *c, const char *input, const char *suffix, const char **code, const char **header)
{
    const char *path = output_path(c, input, suffix);
    size_t stem = strlen(path) - (has_suffix(path, ".c") || has_suffix(path, ".h") ? 2 : 0);

    *code = format_in(&c->session.arena, "%.*s.c", (int)stem, path);
    *header = format_in(&c->session.arena, "%.*s.h", (int)stem, path);
}

static EmitCOptions c_options(Cli *c, const char *input, const char *header)
{
    EmitCOptions e;

    memset(&e, 0, sizeof e);
    e.prefix = c->given[OPT_PREFIX] ? c->value[OPT_PREFIX] : NULL;
    e.header = file_part(header);
    e.track_stores = c->given[OPT_TRACK];
    e.soft = c->given[OPT_SOFT];
    e.runtime = c->given[OPT_RUNTIME];
    e.source = strcmp(input, "-") == 0 ? "stdin" : file_part(input);
    return e;
}

static bool has_output(const Outputs *o, const char *path)
{
    for (size_t i = 0; i < o->n; i++)
        if (strcmp(o->at[i].path, path) == 0)
            return true;
    return false;
}

// Adds the soft-float files, once per folder.
static void add_soft_library(Cli *c, const char *code, Outputs *o)
{
    static const char *const name[] = {"sm_soft.h", "sm_soft.c", "sm_soft_avr.S"};
    const int folder = (int)(file_part(code) - code);
    Buf *text[] = {new_buf(c), new_buf(c), new_buf(c)};

    emit_c_soft_library(text[0], text[1], text[2]);
    for (size_t i = 0; i < sizeof name / sizeof *name; i++) {
        const char *path = format_in(&c->session.arena, "%.*s%s", folder, code, name[i]);
        if (!has_output(o, path))
            add_output(o, path, text[i]);
    }
}

static void emit_c(Cli *c, const char *input, const IrMachine *m, const StateVec *sv, Outputs *o)
{
    Buf *header_text = new_buf(c), *code_text = new_buf(c);
    const char *code, *header;
    EmitCOptions e;

    c_paths(c, input, ".c", &code, &header);
    e = c_options(c, input, header);
    if (m)
        session_emit_c(&c->session, m, &e, header_text, code_text);
    else
        session_emit_c_state_vector(&c->session, sv, &e, header_text, code_text);
    add_output(o, code, code_text);
    add_output(o, header, header_text);
    if (e.soft && !e.runtime)
        add_soft_library(c, code, o);
}

static int build_pins(Cli *c, const Source *sv, Outputs *o)
{
    for (size_t i = 0; i < c->files; i++) {
        Buf *header_text = new_buf(c), *code_text = new_buf(c);
        const Source *src = cli_load(c, c->file[i]);
        const char *code, *header;
        EmitCOptions e;
        IoMap *io;

        if (!src)
            return EXIT_ENVIRONMENT;
        if ((io = session_io(&c->session, src, sv)) == NULL)
            continue;
        c_paths(c, c->file[i], "_io.c", &code, &header);
        e = c_options(c, c->file[i], header);
        session_emit_c_io(&c->session, io, &e, header_text, code_text);
        add_output(o, code, code_text);
        add_output(o, header, header_text);
    }
    return EXIT_OK;
}

static void emit_array(Cli *c, const Buf *image, Outputs *o)
{
    Buf *text = new_buf(c);
    const char *path = output_path(c, c->file[0], "_image.h");
    const EmitCOptions e = c_options(c, c->file[0], path);

    session_emit_c_image(&c->session, path_stem(c, c->file[0]), image, &e, text);
    add_output(o, path, text);
}

// Loads the pins of --io; *io is NULL if there were errors.
static int load_pins(Cli *c, const Source *sv, const Program *const *programs, size_t n, const IoMap **io)
{
    const Source *src = cli_load(c, c->value[OPT_IO]);

    if (!src)
        return EXIT_ENVIRONMENT;
    if ((*io = session_io(&c->session, src, sv)) == NULL)
        return EXIT_PROBLEM;
    for (size_t i = 0; i < n; i++)
        analyse_pins(&c->session.arena, &c->session.diags, *io, programs[i]);
    return EXIT_OK;
}

static int build_machines(Cli *c, Emit emit, const Source *sv, Outputs *o)
{
    IrMachine **m = ARENA_ARRAY(&c->session.arena, IrMachine *, c->files);
    ImageOptions image = {c->given[OPT_DEBUG] && !c->given[OPT_STRIP], NULL};
    Buf *out = new_buf(c);
    const Program **programs = ARENA_ARRAY(&c->session.arena, const Program *, c->files);
    size_t built = 0;
    int code;

    c->session.hide_locals = emit != EMIT_C && !image.debug;     // in C other code can read them
    for (size_t i = 0; i < c->files; i++) {
        MachineInput in = {cli_load(c, c->file[i]), sv, NULL, option_level(c)};
        Program *p;
        if (!in.sm)
            return EXIT_ENVIRONMENT;
        if ((p = session_program(&c->session, &in)) == NULL)
            continue;
        session_analyse(&c->session, p);
        programs[built] = p;
        m[built] = session_ir(&c->session, p, in.opt_level);
        if (limits_given(c))
            limits_check(c, p, m[built]);
        built++;
    }
    if (sv)
        analyse_together(&c->session.arena, &c->session.diags, programs, built);
    if (c->given[OPT_IO] && (code = load_pins(c, sv, programs, built, &image.io)) != EXIT_OK)
        return code;
    if (built < c->files)
        return EXIT_PROBLEM;
    if (is_image(emit) && !session_image(&c->session, m, built, &image, out))
        return EXIT_PROBLEM;
    if (emit == EMIT_BYTECODE)
        add_output(o, output_path(c, c->file[0], ".smb"), out);
    else if (emit == EMIT_ARRAY)
        emit_array(c, out, o);
    for (size_t i = 0; i < built; i++)
        if (emit == EMIT_C)
            emit_c(c, c->file[i], m[i], NULL, o);
        else if (emit == EMIT_IR)
            ir_print(m[i], out);
    if (emit == EMIT_IR)
        add_output(o, c->given[OPT_OUTPUT] ? c->value[OPT_OUTPUT] : "-", out);
    return EXIT_OK;
}

static int build_state_vectors(Cli *c, Outputs *o)
{
    for (size_t i = 0; i < c->files; i++) {
        const Source *src = cli_load(c, c->file[i]);
        const StateVec *sv;
        if (!src)
            return EXIT_ENVIRONMENT;
        if ((sv = session_state_vector(&c->session, src)) != NULL)
            emit_c(c, c->file[i], NULL, sv, o);
    }
    return EXIT_OK;
}

// ---- the command ----

// Whether -o names a possible pair of C files.
static bool takes_c(Cli *c, const char *path)
{
    const size_t n = strlen(path);

    if (strcmp(path, "-") == 0)
        cli_usage(c, "C is two files, a .c and a .h: standard output cannot take both");
    else if (os_is_special(path))
        cli_usage(c, "C is two files, a .c and a .h: '%s' cannot take both", path);
    else if (os_is_folder(path))
        cli_usage(c, "'%s' is a folder: name the .c in it, as in -o %s%s%s.c", path, path, path[n - 1] == '/' ? "" : "/", path_stem(c, c->file[0]));
    else
        return true;
    return false;
}

// Whether #include "…" can name the header of each input.
static bool is_includable(Cli *c)
{
    for (size_t i = 0; i < c->files; i++) {
        const char *path = output_path(c, c->file[i], ".c"), *name = file_part(path);
        if (strpbrk(name, "\"\\")) {
            cli_usage(c, "emitted C cannot be named '%s': an #include cannot contain quotation marks or backslashes; choose another name with -o", path);
            return false;
        }
    }
    return true;
}

static bool is_named_c(const char *path) { return has_suffix(path, ".c") || has_suffix(path, ".h"); }

// Checks that the inputs, the kind of output and -o are compatible.
static int check_use(Cli *c, Emit emit, FileKind *first)
{
    FileKind kind;

    if (c->files == 0)
        return cli_usage(c, "build wants a machine, as in 'smc build tank.sm'");
    if (!source_kind(c, c->file[0], first))
        return EXIT_USAGE;
    for (size_t i = 0; i < c->files; i++) {
        if (!source_kind(c, c->file[i], &kind))
            return EXIT_USAGE;
        if (kind == FILE_APP && emit < EMIT_AST)
            return cli_usage(c, "an application is built alone: it names its files itself");
        if (kind != *first && emit < EMIT_AST)
            return cli_usage(c, "'%s' and '%s' cannot be built in one call; name a state vector with --sv", c->file[0], c->file[i]);
    }
    if (*first == FILE_IO && emit < EMIT_AST && !c->given[OPT_SV])
        return cli_usage(c, "pins are built with their state vector, as in 'smc build %s --sv app.sv --emit=c'", c->file[0]);
    if (*first == FILE_IO && emit < EMIT_AST && emit != EMIT_C)
        return cli_usage(c, "pins alone give C only; say --emit=c");
    if (c->given[OPT_IO] && (*first != FILE_SM || !is_image(emit) || !c->given[OPT_SV]))
        return cli_usage(c, "--io puts pins into an image, by the state vector that --sv names, as in 'smc build tank.sm --sv app.sv --io %s'", c->value[OPT_IO]);
    if (*first == FILE_SS && emit < EMIT_AST)
        return cli_usage(c, "a state script is not built; 'smc test MACHINE.sm %s' runs it", c->file[0]);
    if (*first == FILE_SV && (is_image(emit) || emit == EMIT_IR))
        return cli_usage(c, "a state vector alone gives no %s; build its machines, or say --emit=c", emit == EMIT_IR ? "IR" : "bytecode");
    if (emit == EMIT_BYTECODE && !c->given[OPT_EMIT] && c->given[OPT_OUTPUT] && is_named_c(c->value[OPT_OUTPUT]))
        return cli_usage(c, "'%s' is a name for C: say --emit=c for C, or --emit=array for bytecode as a C array", c->value[OPT_OUTPUT]);
    if (emit == EMIT_C && c->given[OPT_OUTPUT] && !takes_c(c, c->value[OPT_OUTPUT]))
        return EXIT_USAGE;
    if (emit == EMIT_C && !is_includable(c))
        return EXIT_USAGE;
    if (emit == EMIT_C && c->files > 1 && (c->given[OPT_OUTPUT] || c->given[OPT_PREFIX]))
        return cli_usage(c, "with several inputs %s would name several outputs", c->given[OPT_OUTPUT] ? "-o" : "--prefix");
    if (c->given[OPT_RUNTIME] && emit != EMIT_C)
        return cli_usage(c, "--runtime speaks of emitted C: say --emit=c too");
    if (c->given[OPT_SOFT] && emit != EMIT_C)
        return cli_usage(c, "--soft speaks of emitted C: say --emit=c too");
    if (limits_given(c) && !is_image(emit))
        return cli_usage(c, "--max-ram, --max-step and --max-cycles speak of bytecode, not of --emit=%s", emit_name[emit]);
    if (!limits_known(c))
        return EXIT_USAGE;
    if (c->given[OPT_PREFIX] && emit_c_prefix_error(c->value[OPT_PREFIX]))
        return cli_usage(c, "'%s' cannot be a prefix: %s", c->value[OPT_PREFIX], emit_c_prefix_error(c->value[OPT_PREFIX]));
    return EXIT_OK;
}

// --print-after
static bool set_print(Cli *c)
{
    const char *pass = c->value[OPT_PRINT], *known = "build";

    if (!c->given[OPT_PRINT])
        return true;
    c->session.print_after = pass;
    c->session.print_to = new_buf(c);
    if (pass_find(pass) || strcmp(pass, "build") == 0)
        return true;
    for (int i = 0; i < PASS_COUNT; i++)
        known = format_in(&c->session.arena, "%s, %s", known, pass_info[i].name);
    cli_usage(c, "there is no pass '%s'; there are %s", pass, known);
    return false;
}

static int build(Cli *c, Emit emit, FileKind first, Outputs *o)
{
    const Source *sv = NULL;

    if (emit >= EMIT_AST)
        return emit_tokens_or_ast(c, emit, o);
    if (first == FILE_SV)
        return build_state_vectors(c, o);
    if (c->given[OPT_SV] && (sv = cli_load(c, c->value[OPT_SV])) == NULL)
        return EXIT_ENVIRONMENT;
    return first == FILE_IO ? build_pins(c, sv, o) : build_machines(c, emit, sv, o);
}

// The inputs for -MD: all files of the call, the state vector and the pins.
static Inputs build_inputs(Cli *c)
{
    Inputs in = {ARENA_ARRAY(&c->session.arena, const char *, c->files + 2), 0};

    for (size_t i = 0; i < c->files; i++)
        in.at[in.n++] = c->file[i];
    if (c->value[OPT_SV])
        in.at[in.n++] = c->value[OPT_SV];
    if (c->value[OPT_IO])
        in.at[in.n++] = c->value[OPT_IO];
    return in;
}

int cmd_build(Cli *c)
{
    bool wants_deps = deps_wanted(c);
    Outputs o = {NULL, 0};
    FileKind first = FILE_SM;
    Emit emit;
    int code, reported;

    if (!find_emit(c, &emit))
        return EXIT_USAGE;
    if (c->files && has_suffix(c->file[0], ".app") && emit < EMIT_AST)
        return build_app(c);
    if ((code = check_use(c, emit, &first)) != EXIT_OK)
        return code;
    if (!set_print(c))
        return EXIT_USAGE;
    o.at = ARENA_ARRAY(&c->session.arena, OsOutput, 5 * c->files + 2);
    code = build(c, emit, first, &o);
    if (c->session.print_to && !cli_print(c, 2, c->session.print_to))
        return EXIT_ENVIRONMENT;
    if ((reported = cli_report(c)) != EXIT_OK && code == EXIT_OK)
        code = reported;
    if (code != EXIT_OK)
        return code;
    if (wants_deps && !deps_named(c, &o.at[0]))
        return EXIT_USAGE;
    if (wants_deps)
        deps_add(c, o.at, &o.n, build_inputs(c));
    return cli_write(c, o.at, o.n);
}
