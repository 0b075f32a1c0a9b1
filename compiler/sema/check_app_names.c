// SPDX-License-Identifier: Apache-2.0
// The files generated from an application: no two may have the same name (docs/config.md 10.17).
#include "compiler/sema/app_check.h"

#include <string.h>

typedef struct GeneratedFile { const char *what; Span span; } GeneratedFile;

// Returns the name in lower case.  Two files whose names differ only in case would be one file on some file systems.
static Str fold_case(AppCheck *k, const char *name)
{
    char *copy = arena_alloc(k->c->arena, strlen(name) + 1);

    strcpy(copy, name);
    for (char *c = copy; *c; c++)
        if (*c >= 'A' && *c <= 'Z')
            *c = (char)(*c - 'A' + 'a');
    return str_c(k->c->strings, copy);
}

static void add_generated_file(AppCheck *k, Map *seen, const char *stem, const char *what, Span span)
{
    Str key = fold_case(k, stem);
    const GeneratedFile *first = map_find(seen, key);
    GeneratedFile *p = ARENA_NEW(k->c->arena, GeneratedFile);
    Diag *d;

    p->what = what;
    p->span = span;
    if (!first) {
        map_put(seen, key, p);
        return;
    }
    d = diag_report(k->c->diags, DIAG_app_product_twice, span, format_in(k->c->arena, "%s.c", stem), first->what, what);
    diag_note(k->c->diags, d, first->span, DIAG_note_first_here);
}

static bool is_lower(char c) { return c >= 'a' && c <= 'z'; }
static bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }
static bool is_letter(char c) { return is_lower(c) || is_upper(c); }

// Whether the stem begins with this word: sm, SM_x, sm-x, SmX; but not smoke, SMOKE.
static bool begins_with_word(const char *stem, const char *word)
{
    size_t n = 0;

    while (word[n] && is_letter(stem[n]) && (stem[n] | 0x20) == word[n])
        n++;
    if (word[n])
        return false;
    return !is_letter(stem[n]) || (is_upper(stem[n]) && is_lower(stem[n - 1]));
}

// Whether names generated from this stem would conflict with runtime-c: sm.sv generates sm_vector, SM.sm SM_OK, SmApp.sm struct SmApp.
static bool is_reserved_stem(const char *stem)
{
    while (*stem && !is_letter(*stem) && !(*stem >= '0' && *stem <= '9'))
        stem++;
    return begins_with_word(stem, "sm") || begins_with_word(stem, "pal") || begins_with_word(stem, "smvm");
}

// Reports a stem that generated C cannot use.
static void check_stem(AppCheck *k, const char *stem, Span span)
{
    bool includable = true;                       // the name can appear in #include "…" and in a // comment

    for (const char *c = stem; *c; c++)
        includable = includable && (unsigned char)*c >= 0x20 && *c != 0x7f && *c != '"';
    if (!includable || is_reserved_stem(stem))
        diag_report(k->c->diags, DIAG_task_name_reserved, span, stem, "file",
                    diag_text(k->c->diags, includable ? DIAG_part_reserved_name : DIAG_part_not_includable));
}

static bool has_annotation_kind(const AstAppTask *task, AstAppAnnotationKind kind)
{
    for (size_t a = 0; a < task->annotations.n; a++)
        if (task->annotations.at[a].kind == kind)
            return true;
    return false;
}

// Adds the C file of each machine. Machines with @bytecode become arrays in the application's file instead. The file of a machine with
// bindings has the machine's name. A second machine of a file without bindings has been reported.
static void add_machine_files(AppCheck *k, Map *seen)
{
    Map unbound = {k->c->arena, NULL, NULL, 0, 0};

    for (size_t i = 0; i < k->files->instances; i++) {
        const AstAppTask *task = k->files->instance[i].task;
        const bool bound = task->bindings.n > 0;
        if (has_annotation_kind(task, AST_ON_bytecode) || (!bound && map_find(&unbound, task->file.text)))
            continue;
        if (!bound)
            map_put(&unbound, task->file.text, (void *)(size_t)task);
        add_generated_file(k, seen, bound ? task->name.text->text : app_file_stem(k, task->file.text)->text,
                           format_in(k->c->arena, "a machine '%s'", bound ? task->name.text->text : task->file.text->text),
                           bound ? task->name.span : task->file.span);
    }
}

// Reports generated files with equal names, and names that runtime-c reserves.
void check_app_products(AppCheck *k)
{
    static const char *const end[] = {[FILE_SV] = "", [FILE_IO] = "_io", [FILE_NET] = "_net"};
    static const char *const what[] = {[FILE_SV] = "the state vector", [FILE_IO] = "the pins", [FILE_NET] = "the messages"};
    Map seen = {k->c->arena, NULL, NULL, 0, 0};

    check_stem(k, k->app->name->text, (Span){k->app->src, 0, 0});
    add_generated_file(k, &seen, format_in(k->c->arena, "%s_app", k->app->name->text), "the application", (Span){k->app->src, 0, 0});
    for (size_t i = 0; i < k->files->n; i++) {
        const AppFile *f = &k->files->at[i];
        const char *stem = app_file_stem(k, f->name.text)->text;
        check_stem(k, stem, f->name.span);
        if (f->kind != FILE_SM)
            add_generated_file(k, &seen, format_in(k->c->arena, "%s%s", stem, end[f->kind]),
                               format_in(k->c->arena, "%s '%s'", what[f->kind], f->name.text->text), f->name.span);
    }
    add_machine_files(k, &seen);
}

// ---- files of the running application ----

// Returns the name without "./" at its start, so that ./a equals a.
static const char *without_dot_slash(const char *name)
{
    while (name[0] == '.' && name[1] == '/')
        name += 2;
    return name;
}

// Reports option o if the file that it names is also `other`, a file of the application.
static void check_file_differs(AppCheck *k, const AstAppOption *o, const AstWord *other, const char *what)
{
    if (strcmp(without_dot_slash(o->file.text->text), without_dot_slash(other->text->text)) == 0)
        diag_note(k->c->diags, diag_report(k->c->diags, DIAG_app_file_taken, o->file.span, o->file.text->text,
                                           app_option_name(o->kind), what),
                  other->span, DIAG_note_named_here);
}

// Whether the running application writes the file of an option.
static bool is_written(AstAppOptionKind kind) { return kind == AST_APP_log || kind == AST_APP_keep || kind == AST_APP_swap_store; }

// Whether an option names another file of the running application.
static bool is_file(AstAppOptionKind kind) { return is_written(kind) || kind == AST_APP_swap_key || kind == AST_APP_swap_at; }

// Reports a file that the running application writes and that another option or a source names, too.
void check_app_platform_files(AppCheck *k)
{
    static const char *const what[] = {[FILE_SV] = "the state vector's", [FILE_SM] = "a machine's", [FILE_IO] = "that of the pins",
                                       [FILE_NET] = "that of the messages"};

    for (size_t i = 0; i < k->ast->options.n; i++) {
        const AstAppOption *o = &k->ast->options.at[i];
        if (!is_written(o->kind))
            continue;
        for (size_t f = 0; f < k->files->n; f++)
            check_file_differs(k, o, &k->files->at[f].name, what[k->files->at[f].kind]);
        for (size_t j = 0; j < k->ast->options.n; j++) {
            const AstAppOption *other = &k->ast->options.at[j];
            if (is_file(other->kind) && (j < i || (j > i && !is_written(other->kind))))
                check_file_differs(k, o, &other->file, other->kind == AST_APP_log
                                   ? "the log's" : format_in(k->c->arena, "that of '%s'", app_option_name(other->kind)));
        }
    }
}
