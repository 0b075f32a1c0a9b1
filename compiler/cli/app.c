// SPDX-License-Identifier: Apache-2.0
// Loads an application and the files that it names from the disk: relative to the .app, each once.
#include <string.h>

#include "compiler/cli/app.h"
#include "compiler/syntax/parse.h"

// Returns the path of a file in the folder of `app`.
static const char *beside(Cli *c, const char *app, Str name)
{
    const char *slash = strrchr(app, '/');

    if (name->text[0] == '/' || !slash)
        return name->text;
    return format_in(&c->session.arena, "%.*s%s", (int)(slash + 1 - app), app, name->text);
}

static void load_file(Cli *c, const char *app, AppFile *f)
{
    const char *path = beside(c, app, f->name.text);
    char *text, *copy;
    size_t len;

    if (strcmp(path, "-") == 0 || strlen(f->name.text->text) != f->name.text->len) {
        f->problem = "that is no name of a file";
        return;
    }
    if (!os_read(path, SOURCE_MAX, &text, &len, &f->problem))
        return;
    copy = arena_alloc(&c->session.arena, len + 1);
    memcpy(copy, text, len);
    os_alloc(NULL, text, 0);
    f->src = source_new(&c->session.arena, path, copy, len);
}

int check_app_file(Cli *c)
{
    CliApp files;
    App *a;

    if (c->files > 1)
        return cli_usage(c, "an application is checked alone: it names its files itself");
    if (c->given[OPT_SV])
        return cli_usage(c, "'%s' names its state vector itself: --sv has no place here", c->file[0]);
    if (!limits_known(c))
        return EXIT_USAGE;
    if (!cli_load_app(c, c->file[0], &files))
        return EXIT_ENVIRONMENT;
    a = session_app(&c->session, files.tree, &files.files);
    c->session.hide_locals = true;
    for (size_t i = 0; a && limits_given(c) && i < a->machine.n; i++)
        if (a->machine.at[i]->bytecode)
            limits_check(c, a->machine.at[i]->program, session_ir(&c->session, a->machine.at[i]->program, option_level(c)));
    c->session.hide_locals = false;
    return cli_report(c);
}

bool cli_load_app(Cli *c, const char *path, CliApp *out)
{
    Source *src = cli_load(c, path);

    memset(out, 0, sizeof *out);
    if (!src)
        return false;
    out->tree = parse_file(&c->session.arena, &c->session.strings, &c->session.diags, src, FILE_APP);
    app_files(&c->session.arena, out->tree, &out->files);
    for (size_t i = 0; i < out->files.n; i++)
        if (!out->files.at[i].wrong_kind)
            load_file(c, src->name, &out->files.at[i]);
    return true;
}
