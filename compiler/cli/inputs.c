// SPDX-License-Identifier: Apache-2.0
// Reads the inputs of compile_sources(): the sources that the arguments name, and the options.
#include <string.h>

#include "compiler/base/path.h"
#include "compiler/cli/cli.h"
#include "compiler/data/data_file.h"
#include "compiler/syntax/parse.h"

// ---- sources ----

// Reads a file as a source that diagnostics call `name`.  Returns NULL and sets *why if it cannot be read.
static Source *open_source(Cli *c, const char *path, const char *name, const char **why)
{
    char *text, *copy;
    size_t len;

    if (!os_read_file(path, SOURCE_MAX, &text, &len, why))
        return NULL;
    copy = arena_alloc(&c->session.arena, len + 1);
    memcpy(copy, text, len);
    os_alloc(NULL, text, 0);
    return source_new(&c->session.arena, name, copy, len);
}

// Finds a file that a script includes: reads it, unless the command has read it before under any name.
static const Source *find_included(void *context, const Source *from, const char *name, const char **why)
{
    Cli *c = context;
    const char *path = path_beside(&c->session.arena, from->name, name);
    Source *src;
    OsReader r;

    for (size_t i = 0; i < c->scripts.n; i++)
        if (os_same_file(c->scripts.at[i]->name, path))
            return c->scripts.at[i];
    if (!os_reader_open(&r, path, why))                        // refuses a pipe, which would wait for its writer, and a device
        return NULL;
    os_reader_close(&r);
    if ((src = open_source(c, path, path, why)) == NULL)
        return NULL;
    vec_push(&c->session.arena, &c->scripts, src);
    sources_label(&c->session.arena, c->scripts.at, c->scripts.n);
    vec_push(&c->session.arena, &c->included, src);
    return src;
}

static bool read_data(DataStream *s, char *into, size_t n, size_t *got, const char **why) { return os_reader_get(s->self, into, n, got, why); }

static void close_data(DataStream *s)
{
    os_reader_close(s->self);
    os_alloc(NULL, s->self, 0);
}

static bool open_data(const DataFile *file, DataStream *stream, const char **why)
{
    OsReader *r = os_alloc(NULL, NULL, sizeof *r);

    if (!r) {
        *why = "out of memory";
        return false;
    }
    *stream = (DataStream){r, 0, read_data, close_data};
    if (os_reader_open(r, file->name, why))
        return true;
    os_alloc(NULL, r, 0);
    return false;
}

// Adds the path of a file with recorded data to the inputs, once.
static void add_data_name(Cli *c, const char *name)
{
    for (size_t i = 0; i < c->data.n; i++)
        if (strcmp(c->data.at[i], name) == 0)
            return;
    vec_push(&c->session.arena, &c->data, name);
}

// Returns the file with recorded data that a script names. Called when a script is checked.
static const DataFile *find_data(void *context, const Source *from, const char *name, const char **why)
{
    static const OptionId outputs[] = {OPT_OUTPUT, OPT_TRACE, OPT_JUNIT, OPT_MESSAGE_FILE, OPT_DEPS_FILE};
    Cli *c = context;
    DataFile *file = ARENA_NEW(&c->session.arena, DataFile);

    *file = (DataFile){path_beside(&c->session.arena, from->name, name), NULL, open_data};
    add_data_name(c, file->name);
    for (size_t i = 0; i < sizeof outputs / sizeof *outputs; i++)
        if (c->given[outputs[i]] && os_same_file(c->value[outputs[i]], file->name)) {
            *why = "it is also an output of this command";
            return NULL;
        }
    return file;
}

// Reads a source; NULL after a message (exit with EXIT_ENVIRONMENT).
Source *cli_read_source(Cli *c, const char *path)
{
    const char *why;
    Source *src = open_source(c, path, strcmp(path, "-") == 0 ? "<stdin>" : path, &why);

    if (!src)
        cli_print_error(c, TEXT_cannot_read, cli_printable_name(&c->session.arena, path), why);
    else if (has_suffix(path, ".ss")) {
        vec_push(&c->session.arena, &c->scripts, src);
        sources_label(&c->session.arena, c->scripts.at, c->scripts.n);
    }
    c->session.finder = (SourceFinder){find_included, find_data, c};
    return src;
}

// Reads the files that an application names. Their paths are relative to its folder. A file that cannot be read is reported when the
// application is checked.
void cli_load_app(Cli *c, CompileInput *in)
{
    const char *app = in->at[0].text->name;

    in->app = ARENA_NEW(&c->session.arena, CompileApp);
    compile_open_app(&c->session, in->at[0].text, in->app);
    for (size_t i = 0; i < in->app->files.n; i++) {
        AppFile *f = &in->app->files.at[i];
        const char *name = f->name.text->text;
        const char *path = path_beside(&c->session.arena, app, name);
        if (f->wrong_kind)
            continue;
        if (strcmp(path, "-") == 0 || strlen(name) != f->name.text->len)
            f->problem = "that is no name of a file";
        else
            f->src = open_source(c, path, path, &f->problem);
        if (f->src)
            vec_push(&c->session.arena, &c->named, f->src);
    }
}

// Reads --bind into *out, NULL if it is absent; an error if the call compiles several machines.
int cli_read_bindings(Cli *c, size_t machines, const MachineInstance **out)
{
    MachineInstance *instance = ARENA_NEW(&c->session.arena, MachineInstance);
    AstBindings all = {0};

    *out = NULL;
    if (!c->given[OPT_BIND])
        return EXIT_OK;
    if (machines != 1)
        return cli_usage_error(c, TEXT_bind_one_machine);
    if (!c->given[OPT_SV])
        return cli_usage_error(c, TEXT_bind_needs_vector);
    parse_bindings(&c->session.arena, &c->session.strings, &c->session.diags,
                   source_new(&c->session.arena, "--bind", buf_text(&c->bindings), c->bindings.n), &all);
    instance->binding = all.at;
    instance->bindings = all.n;
    instance->lost = c->session.diags.errors > 0;
    *out = instance;
    return EXIT_OK;
}

// Reads every file that the command line names, and those of --sv, --io and --net.
int cli_read_inputs(Cli *c, CompileInput *in)
{
    size_t machines = 0;

    memset(in, 0, sizeof *in);
    in->at = ARENA_ARRAY(&c->session.arena, CompileSource, c->files);
    for (size_t i = 0; i < c->files; i++) {
        CompileSource *s = &in->at[in->n++];
        s->kind = FILE_SM;
        file_kind(c->file[i], &s->kind);
        if ((s->text = cli_read_source(c, c->file[i])) == NULL)
            return EXIT_ENVIRONMENT;
    }
    if ((c->given[OPT_SV] && (in->vector = cli_read_source(c, c->value[OPT_SV])) == NULL) ||
        (c->given[OPT_NET] && (in->messages = cli_read_source(c, c->value[OPT_NET])) == NULL) ||
        (c->given[OPT_IO] && (in->pins = cli_read_source(c, c->value[OPT_IO])) == NULL))
        return EXIT_ENVIRONMENT;
    for (size_t i = 1; i < in->n; i++)
        if (in->at[i].kind == FILE_APP && in->at[0].kind != FILE_APP) {
            const CompileSource first = in->at[0];
            in->at[0] = in->at[i];
            in->at[i] = first;
        }
    if (in->n > 0 && in->at[0].kind == FILE_APP)
        cli_load_app(c, in);
    for (size_t i = 0; i < in->n; i++)
        machines += in->at[i].kind == FILE_SM;
    return cli_read_bindings(c, machines, &in->instance);
}

// Checks that the names of all files have the suffix of a source ("-" is accepted if `standard_input`); false after a message.
bool cli_check_sources(Cli *c, bool standard_input)
{
    FileKind kind;

    for (size_t i = 0; i < c->files; i++)
        if (!file_kind(c->file[i], &kind) && !(standard_input && strcmp(c->file[i], "-") == 0)) {
            cli_usage_error(c, TEXT_not_a_source, c->file[i]);
            return false;
        }
    return true;
}

// ---- options ----

// Stores the value of an option, a whole number of at least 1, in *number; 0 if the option is absent.  Returns false after a message.
static bool read_number_option(Cli *c, OptionId id, const char *spelling, uint32_t *number)
{
    uint64_t n = 0;

    if (!cli_read_limit(c, id, spelling, UINT32_MAX, &n))
        return false;
    *number = (uint32_t)n;
    return true;
}

// Reads -O, --step, the limits, -W and --soft.  false after a message: one of them is invalid.
bool cli_compile_options(Cli *c, CompileOptions *o)
{
    uint32_t step;

    memset(o, 0, sizeof *o);
    o->opt_level = options_opt_level(c);
    o->warnings = &c->warn;
    o->soft = c->given[OPT_SOFT];
    if (!read_number_option(c, OPT_STEP, "--step", &step) || !read_number_option(c, OPT_MAX_RAM, "--max-ram", &o->limits.ram) ||
        !read_number_option(c, OPT_MAX_STEP, "--max-step", &o->limits.step) ||
        !read_number_option(c, OPT_MAX_CYCLES, "--max-cycles", &o->limits.cycles))
        return false;
    if (c->given[OPT_MCU] && !(o->limits.board = board_find(c->value[OPT_MCU]))) {
        cli_usage_error(c, TEXT_mcu_values, c->value[OPT_MCU]);
        return false;
    }
    o->step = step;
    return true;
}
