// SPDX-License-Identifier: Apache-2.0
// The tasks of an application: their names, modes, machines and required options (docs/config.md 10.13 to 10.18).
#include "compiler/sema/app_check.h"

#include <string.h>

// ---- names ----

bool app_is_reserved_name(const char *name)
{
    static const char *const taken[] = {"sm", "pal", "smvm"};

    for (size_t i = 0; i < sizeof taken / sizeof *taken; i++) {
        size_t n = strlen(taken[i]);
        if (strncmp(name, taken[i], n) == 0 && (name[n] == '\0' || name[n] == '_'))
            return true;
    }
    return false;
}

// Returns why the name cannot be the prefix of C function names; NULL if it can.
static const char *find_name_problem(const char *name)
{
    size_t n = strlen(name);

    if (app_is_reserved_name(name))
        return "it belongs to the runtime";
    if (name[0] == '_' || name[n - 1] == '_')
        return "it begins or ends with an underscore";
    return strstr(name, "__") ? "it has two underscores in a row" : NULL;
}

static void check_task_name(AppCheck *k, const AstAppTask *in)
{
    const char *what = in->kind == AST_TASK_machine ? "machine" : "task", *problem = find_name_problem(in->name.text->text);
    const Span *first = map_find(&k->task, in->name.text);

    if (problem)
        diag_report(k->c->diags, DIAG_task_name_reserved, in->name.span, in->name.text->text, what, problem);
    if (first)
        diag_note(k->c->diags, diag_report(k->c->diags, DIAG_app_name_twice, in->name.span, "task or machine", in->name.text->text),
                  *first,
                  DIAG_note_first_here);
    else
        map_put(&k->task, in->name.text, (void *)(size_t)&in->name.span);
}

// Checks one of the tasks inputs, outputs, log and keep: each at most once, and only with its option.
static void check_service_task(AppCheck *k, const AstAppTask *in)
{
    AstAppOptionKind needs = app_find_required_option(in->kind);
    const char *word = app_task_word(in->kind);
    bool found = k->ast->lost;

    for (size_t i = 0; i < k->ast->options.n; i++)
        found = found || k->ast->options.at[i].kind == needs;
    if (!found)
        diag_report(k->c->diags, DIAG_app_missing, in->name.span, format_in(k->c->arena, "'%s' needs '%s' in [options]", word,
                                                                          app_option_name(needs)));
    if (k->service[in->kind].src)
        diag_note(k->c->diags, diag_report(k->c->diags, DIAG_app_name_twice, in->name.span, "task", word), k->service[in->kind],
                  DIAG_note_first_here);
    else
        k->service[in->kind] = in->name.span;
}

// ---- machines ----

static const State *find_state(AppCheck *k, const Program *p, const AstWord *name)
{
    const State *s = map_find(&p->state_by_name, name->text);
    Guess g = guess_init(name->text);
    Diag *d;

    if (s)
        return s;
    d = diag_report(k->c->diags, DIAG_unknown_state, name->span, name->text->text);
    if (k->guesses == 0)
        return NULL;
    k->guesses--;
    for (size_t i = 0; i < p->state.n; i++)
        guess_consider(&g, p->state.at[i]->name);
    guess_add_label(k->c->diags, d, &g);
    return NULL;
}

static void check_machine_time(AppCheck *k, const AstAppTask *in, const Program *p)
{
    const Element *time = k->app->time;
    Diag *d;

    for (size_t i = 0; i < k->ast->options.n; i++)
        if (k->ast->options.at[i].kind == AST_APP_time && !time)
            return;                               // reported: the element does not exist
    if (!time) {
        if (!k->ast->lost)
            diag_report(k->c->diags, DIAG_app_missing, in->name.span,
                        format_in(k->c->arena, "machine '%s' needs the time: in [options], time %s 1 ms", in->name.text->text,
                                  p && p->g && p->g->element ? p->g->element->name->text : "ELEMENT"));
        return;
    }
    if (!p || !p->g || p->g->element == time)
        return;
    d = diag_report(k->c->diags, DIAG_app_time_element, in->file.span, in->name.text->text, p->g->name->text, time->name->text);
    diag_note(k->c->diags, d, p->g->span, DIAG_note_listed_there, p->name->text);
    diag_note(k->c->diags, d, k->app->time_span, DIAG_note_named_here);
}

// Two tasks with one machine file would write the same elements, including S.
static void check_machine_file(AppCheck *k, const AstAppTask *in)
{
    const Span *first = map_find(&k->machine_file, in->file.text);

    if (first)
        diag_note(k->c->diags, diag_report(k->c->diags, DIAG_machine_twice, in->file.span, in->file.text->text), *first,
                  DIAG_note_first_here);
    else
        map_put(&k->machine_file, in->file.text, (void *)(size_t)&in->file.span);
}

static const AppMachine *check_machine_task(AppCheck *k, const AstAppTask *in)
{
    AppMachine *m = ARENA_NEW(k->c->arena, AppMachine);

    m->name = in->name.text;
    m->file = (uint32_t)((size_t)map_find(&k->file_index, in->file.text) - 1);
    m->program = k->files->at[m->file].program;
    m->number = (uint16_t)k->app->machine.n;
    vec_push(k->c->arena, &k->app->machine, m);
    check_machine_file(k, in);
    check_machine_time(k, in, m->program);
    for (size_t i = 0; i < in->annotations.n; i++) {
        const AstAppAnnotation *a = &in->annotations.at[i];
        m->bytecode = m->bytecode || a->kind == AST_ON_bytecode;
        m->resume = m->resume || a->kind == AST_ON_resume;
        if (a->kind == AST_ON_resume && !k->app->keep && !k->ast->lost)
            diag_report(k->c->diags, DIAG_resume_without_keep, a->span);
        if (a->kind == AST_ON_state && m->program)
            m->initial = find_state(k, m->program, &a->word);
    }
    return m;
}

// ---- one task ----

static const Element *check_mode(AppCheck *k, const AstWord *name)
{
    const Element *e = app_find_element(k, name);

    if (e && e->type != SM_U8) {
        Diag *d = diag_report(k->c->diags, DIAG_app_element_type, name->span, e->name->text, sm_type_info[e->type].spelling,
                              "a mode",
                              "a U8");
        diag_note(k->c->diags, d, e->span, DIAG_note_declared_here, e->name->text);
    }
    return e;
}

static void check_annotation(AppCheck *k, const AstAppAnnotation *a, AppTask *t)
{
    if (a->kind == AST_ON_mode)
        t->mode = check_mode(k, &a->word);
    t->has_init = t->has_init || a->kind == AST_ON_init;
    t->has_safe = t->has_safe || a->kind == AST_ON_safe;
}

// The first element except S that a machine writes; NULL if there is none.
static const Var *first_written(const Program *p)
{
    for (size_t i = 0; p && i < p->var.n; i++)
        if (p->var.at[i]->element && p->var.at[i]->written)
            return p->var.at[i];
    return NULL;
}

// In safe mode a task without @safe does nothing: what it has started continues.
static void warn_of_mode_without_safe(AppCheck *k, const AppTask *t)
{
    const Var *left = t->machine ? first_written(t->machine->program) : NULL;
    const char *why = "no @safe: while safed, it does nothing";

    if (!t->mode || t->has_safe || (t->kind != AST_TASK_task && !left))
        return;
    if (left)
        why = format_in(k->c->arena, "is a machine: while safed, it does not step, and '%s' stays as it is", left->name->text);
    diag_report(k->c->diags, DIAG_mode_without_safe, t->span, t->name->text, why);
}

static AppTask *check_task(AppCheck *k, const AstAppTask *in)
{
    AppTask *t = ARENA_NEW(k->c->arena, AppTask);

    t->kind = in->kind;
    t->name = in->name.text;
    t->span = in->name.span;
    t->number = (uint16_t)k->app->task.n;
    if (in->kind == AST_TASK_task || in->kind == AST_TASK_machine)
        check_task_name(k, in);
    else
        check_service_task(k, in);
    for (size_t i = 0; i < in->annotations.n; i++)
        check_annotation(k, &in->annotations.at[i], t);
    if (in->kind == AST_TASK_machine)
        t->machine = check_machine_task(k, in);
    warn_of_mode_without_safe(k, t);
    return t;
}

// The time must advance between two steps of a machine, or the second step is refused.
static void check_time_advances(AppCheck *k, const AstAppTask *in, const AppRate *rate)
{
    if (in->kind == AST_TASK_machine && k->app->time && rate->period && rate->period < k->app->unit)
        diag_note(k->c->diags, diag_report(k->c->diags, DIAG_app_time_coarse, in->name.span, in->name.text->text,
                                           app_time_text(k->c->arena, rate->period), k->app->time->name->text,
                                           app_time_text(k->c->arena, k->app->unit)),
                  k->app->time_span, DIAG_note_named_here);
}

void check_app_tasks(AppCheck *k, const AstAppExecutor *in, AppExecutor *out)
{
    enum { MOST = 65535 };

    for (size_t r = 0; r < in->rates.n; r++) {
        if (in->rates.at[r].tasks.n == 0 && !in->lost)
            diag_report(k->c->diags, DIAG_app_missing, in->rates.at[r].span, "this rate has no task");
        for (size_t t = 0; t < in->rates.at[r].tasks.n; t++) {
            AppTask *task = check_task(k, &in->rates.at[r].tasks.at[t]);
            if (k->app->task.n == MOST)
                diag_report(k->c->diags, DIAG_app_too_many, task->span, "tasks", "65535");
            check_time_advances(k, &in->rates.at[r].tasks.at[t], out->rate.at[r]);
            vec_push(k->c->arena, &k->app->task, task);
            vec_push(k->c->arena, &out->rate.at[r]->task, (const AppTask *)task);
        }
    }
}
