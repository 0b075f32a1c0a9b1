// SPDX-License-Identifier: Apache-2.0
// smc build NAME.app: emits all parts of an application as C in one folder.
#include <string.h>

#include "compiler/cli/app.h"
#include "compiler/cli/deps.h"
#include "compiler/emit/c/app.h"

typedef struct AppBuild {
    Cli *c;
    const App *app;
    OsOutput *out;
    size_t n;
} AppBuild;

static const char *in_folder(AppBuild *b, const char *name)
{
    const char *folder = b->c->given[OPT_OUTPUT] ? b->c->value[OPT_OUTPUT] : "";
    size_t n = strlen(folder);

    return format_in(&b->c->session.arena, "%s%s%s", folder, n && folder[n - 1] != '/' ? "/" : "", name);
}

static const char *plus(AppBuild *b, const char *stem, const char *end)
{
    return format_in(&b->c->session.arena, "%s%s", stem, end);
}

static Buf *new_buf(AppBuild *b)
{
    Buf *out = ARENA_NEW(&b->c->session.arena, Buf);
    buf_init(out, &b->c->session.arena);
    return out;
}

static void add(AppBuild *b, const char *name, const Buf *text)
{
    b->out[b->n++] = (OsOutput){in_folder(b, name), buf_text(text), text->n};
}

// Adds a code file and a header named after `stem`.
static void add_pair(AppBuild *b, const char *stem, const Buf *header, const Buf *code)
{
    add(b, plus(b, stem, ".c"), code);
    add(b, plus(b, stem, ".h"), header);
}

static EmitCOptions options(AppBuild *b, const char *stem, const char *ending)
{
    EmitCOptions e;

    memset(&e, 0, sizeof e);
    e.header = plus(b, stem, ".h");
    e.source = plus(b, stem, ending);
    e.runtime = true;
    e.soft = b->c->given[OPT_SOFT];
    return e;
}

static void add_vector(AppBuild *b)
{
    const char *stem = b->app->sv->name->text;
    EmitCOptions e = options(b, stem, ".sv");
    Buf *header = new_buf(b), *code = new_buf(b);

    session_emit_c_state_vector(&b->c->session, b->app->sv, &e, header, code);
    add_pair(b, stem, header, code);
}

static void add_machine(AppBuild *b, const Program *p)
{
    const char *stem = p->name->text;
    EmitCOptions e = options(b, stem, ".sm");
    Buf *header = new_buf(b), *code = new_buf(b);

    session_emit_c(&b->c->session, session_ir(&b->c->session, p, option_level(b->c)), &e, header, code);
    add_pair(b, stem, header, code);
}

static void add_pins(AppBuild *b)
{
    const char *stem = plus(b, b->app->io_name->text, "_io");
    EmitCOptions e = options(b, stem, ".io");
    Buf *header = new_buf(b), *code = new_buf(b);

    e.source = plus(b, b->app->io_name->text, ".io");
    session_emit_c_io(&b->c->session, b->app->pins, &e, header, code);
    add_pair(b, stem, header, code);
}

// Includes names, which a log requires, unless --strip is given.
static bool make_image(AppBuild *b, const Program *p, Buf *out)
{
    ImageOptions o = {!b->c->given[OPT_STRIP], NULL};
    IrMachine *m;

    b->c->session.hide_locals = !o.debug;
    m = session_ir(&b->c->session, p, option_level(b->c));
    b->c->session.hide_locals = false;
    return session_image(&b->c->session, &m, 1, &o, out);
}

static void add_app(AppBuild *b)
{
    Buf *header = new_buf(b), *code = new_buf(b);
    const Buf **image = ARENA_ARRAY(&b->c->session.arena, const Buf *, b->app->machine.n);

    for (size_t i = 0; i < b->app->machine.n; i++)
        if (b->app->machine.at[i]->bytecode) {
            Buf *bytes = new_buf(b);
            image[i] = bytes;
            if (!make_image(b, b->app->machine.at[i]->program, bytes))
                return;
        }
    emit_c_app(&b->c->session.arena, b->app, image, header, code);
    add_pair(b, plus(b, b->app->name->text, "_app"), header, code);
}

static void add_all(AppBuild *b)
{
    b->out = ARENA_ARRAY(&b->c->session.arena, OsOutput, 2 * b->app->machine.n + 7);
    add_app(b);
    add_vector(b);
    for (size_t i = 0; i < b->app->machine.n; i++)
        if (!b->app->machine.at[i]->bytecode)
            add_machine(b, b->app->machine.at[i]->program);
    if (b->app->pins)
        add_pins(b);
}

// The inputs for -MD: the application, and every existing file that it names.
static Inputs all_inputs(Cli *c, const AppFiles *files)
{
    Inputs in = {ARENA_ARRAY(&c->session.arena, const char *, files->n + 1), 1};

    in.at[0] = c->file[0];
    for (size_t i = 0; i < files->n; i++)
        in.at[in.n++] = files->at[i].src->name;
    return in;
}

static int check_use(Cli *c)
{
    if (c->files > 1)
        return cli_usage(c, "an application is built alone: it names its files itself");
    if (c->given[OPT_SV])
        return cli_usage(c, "'%s' names its state vector itself: --sv has no place here", c->file[0]);
    if (c->given[OPT_EMIT] && strcmp(c->value[OPT_EMIT], "c") != 0)
        return cli_usage(c, "an application becomes C, not %s", c->value[OPT_EMIT]);
    if (c->given[OPT_PREFIX])
        return cli_usage(c, "the names of an application's C come from its files: --prefix has no place here");
    if (c->given[OPT_OUTPUT] && strcmp(c->value[OPT_OUTPUT], "-") == 0)
        return cli_usage(c, "an application is several files: -o names the folder for them");
    return EXIT_OK;
}

// Creates the folder of -o if it does not exist.
static bool make_folder(Cli *c)
{
    const char *folder = c->value[OPT_OUTPUT], *why;

    if (!c->given[OPT_OUTPUT] || *folder == '\0' || os_make_folder(folder, &why))
        return true;
    cli_say(c, "cannot make the folder '%s': %s", cli_shown(&c->session.arena, folder), why);
    return false;
}

int build_app(Cli *c)
{
    AppBuild b = {c, NULL, NULL, 0};
    CliApp files;
    int code = check_use(c), reported;

    if (code != EXIT_OK)
        return code;
    if (!cli_load_app(c, c->file[0], &files))
        return EXIT_ENVIRONMENT;
    if ((b.app = session_app(&c->session, files.tree, &files.files)) != NULL)
        add_all(&b);
    reported = cli_report(c);
    if (!b.app || reported != EXIT_OK)
        return reported != EXIT_OK ? reported : EXIT_PROBLEM;
    if (deps_wanted(c))
        deps_add(c, b.out, &b.n, all_inputs(c, &files.files));
    return make_folder(c) ? cli_write(c, b.out, b.n) : EXIT_ENVIRONMENT;
}
