// SPDX-License-Identifier: Apache-2.0
// The tasks of an application: their names, modes, machines and required options (docs/config.md 10.13 to 10.18).
#include "compiler/sema/app_check.h"

#include <string.h>

// ---- names ----

// Whether runtime-c may use the name, because it begins with one of its prefixes.
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

// Finds why the name cannot be the prefix of C function names; returns false if it can.
static bool find_name_problem(const char *name, DiagCode *problem)
{
    size_t n = strlen(name);

    if (app_is_reserved_name(name))
        *problem = DIAG_part_reserved_name;
    else if (name[0] == '_' || name[n - 1] == '_')
        *problem = DIAG_part_outer_underscore;
    else if (strstr(name, "__"))
        *problem = DIAG_part_two_underscores;
    else
        return false;
    return true;
}

// Checks an inputs, outputs, log or keep task: an application has at most one of each, and only if it has the option that the task needs.
static void check_service_task(AppCheck *k, const AstAppTask *in)
{
    AstAppOptionKind needs = app_find_required_option(in->kind);
    const char *word = app_task_word(in->kind);
    bool found = k->ast->lost;

    for (size_t i = 0; i < k->ast->options.n; i++)
        found = found || k->ast->options.at[i].kind == needs;
    if (!found)
        diag_report(k->c->diags, DIAG_app_missing, in->name.span, diag_text(k->c->diags, DIAG_part_no_option, word, app_option_name(needs)));
    if (k->service[in->kind].src)
        diag_note(k->c->diags, diag_report(k->c->diags, DIAG_app_name_twice, in->name.span, "task", word), k->service[in->kind],
                  DIAG_note_first_here);
    else
        k->service[in->kind] = in->name.span;
}

// ---- machines ----

// Reports an application with a machine but without a time, and a machine whose G is another element than the application's time.
static void check_machine_time(AppCheck *k, const AstAppTask *in, const Program *p)
{
    const Element *time = k->app->time;
    Diag *d;

    for (size_t i = 0; i < k->ast->options.n; i++)
        if (k->ast->options.at[i].kind == AST_APP_time && !time)
            return;                               // the option names an element that does not exist, which is already reported
    if (!time) {
        if (!k->ast->lost)
            diag_report(k->c->diags, DIAG_app_missing, in->name.span,
                        diag_text(k->c->diags, DIAG_part_no_time, in->name.text->text,
                                  p && p->g && p->g->element ? p->g->element->name->text : "ELEMENT"));
        return;
    }
    if (!p || !p->g || p->g->element == time)
        return;
    d = diag_report(k->c->diags, DIAG_app_time_element, in->file.span, in->name.text->text, p->g->name->text, time->name->text);
    diag_note(k->c->diags, d, p->g->span, DIAG_note_listed_there, p->name->text);
    diag_note(k->c->diags, d, k->app->time_span, DIAG_note_named_here);
}

// Whether the machine has a state in which a swap can replace it (swapping.md 12.4).
static bool has_swap_state(const Program *p)
{
    for (size_t i = 0; i < p->state.n; i++)
        if (p->state.at[i]->allows_swap || p->state.at[i]->is_safe)
            return true;
    return false;
}

// Returns the most instructions of a step of a machine that steps once in `period` nanoseconds; at least 1.
static uint32_t step_limit(const App *app, uint64_t period)
{
    const uint64_t whole = period / 1000000 * app->swap_limit, rest = period % 1000000 * app->swap_limit / 1000000;

    return whole + rest > UINT32_MAX ? UINT32_MAX : whole + rest == 0 ? 1 : (uint32_t)(whole + rest);
}

// Checks a machine with @swap (config.md 10.21).
static void check_swap(AppCheck *k, const AstAppTask *in, const AppMachine *m)
{
    const AstAppAnnotation *a = in->annotations.at;

    while (a->kind != AST_ON_swap)
        a++;
    if (!m->bytecode)
        diag_report(k->c->diags, DIAG_swap_without_bytecode, a->span);
    if (m->resume)
        diag_report(k->c->diags, DIAG_swap_with_resume, a->span);
    if (k->app->swap_room == 0 && !k->ast->lost)
        diag_report(k->c->diags, DIAG_app_missing, a->span, diag_text(k->c->diags, DIAG_part_no_swap_memory, m->name->text));
    if (m->program && !has_swap_state(m->program))
        diag_report(k->c->diags, DIAG_swap_without_state, a->span, m->name->text);
}

// Checks a machine whose file other machines have, too: at most one is without bindings, and each has an S of its own.
static void check_same_file(AppCheck *k, const AstAppTask *in, const AppMachine *m)
{
    const Span *first = map_find(&k->machine_file, in->file.text);
    const Program *p = m->program;
    const AppMachine *other;
    Str key;

    if (in->bindings.n == 0 && first) {
        Diag *d = diag_report(k->c->diags, DIAG_machine_twice, in->file.span, in->file.text->text);
        diag_label(k->c->diags, d, DIAG_label_bind);
        diag_note(k->c->diags, d, *first, DIAG_note_first_here);
        return;
    }
    if (in->bindings.n == 0)
        map_put(&k->machine_file, in->file.text, (void *)(size_t)&in->file.span);
    if (!p || !p->s || !p->s->element)
        return;
    key = str_c(k->c->strings, format_in(k->c->arena, "%lu %s", (unsigned long)m->file, p->s->element->name->text));
    if ((other = map_find(&k->machine_state, key)) == NULL)
        map_put(&k->machine_state, key, (void *)(size_t)m);
    else
        diag_note(k->c->diags, diag_report(k->c->diags, DIAG_machines_one_state, in->name.span, other->name->text, m->name->text, p->s->name->text,
                                           p->s->element->name->text),
                  p->s->span, DIAG_note_declared_here, p->s->name->text);
}

static const AppMachine *check_machine_task(AppCheck *k, const AstAppTask *in, uint64_t period)
{
    AppMachine *m = ARENA_NEW(k->c->arena, AppMachine);

    m->name = in->name.text;
    m->file = (uint32_t)k->files->instance[k->app->machine.n].file;
    m->program = k->files->instance[k->app->machine.n].program;
    m->number = (uint16_t)k->app->machine.n;
    vec_push(k->c->arena, &k->app->machine, m);
    check_machine_time(k, in, m->program);
    check_same_file(k, in, m);
    for (size_t i = 0; i < in->annotations.n; i++) {
        const AstAppAnnotation *a = &in->annotations.at[i];
        m->bytecode = m->bytecode || a->kind == AST_ON_bytecode;
        m->resume = m->resume || a->kind == AST_ON_resume;
        m->swap = m->swap || a->kind == AST_ON_swap;
        if (a->kind == AST_ON_resume && !k->app->keep && !k->ast->lost)
            diag_report(k->c->diags, DIAG_resume_without_keep, a->span);
        if (a->kind == AST_ON_state && m->program)
            m->initial = map_find(&m->program->state_by_name, a->word.text);
        if (a->kind == AST_ON_state && m->program && !m->initial)
            suggest_state(k->c->diags, diag_report(k->c->diags, DIAG_unknown_state, a->word.span, a->word.text->text), &k->guesses,
                          m->program, a->word.text);
    }
    m->longest = step_limit(k->app, period);
    if (m->swap)
        check_swap(k, in, m);
    return m;
}

// ---- one task ----

// Warns of a task that has a mode but no @safe: while it is safed the task does nothing, so its outputs keep their values.  Does not warn of a
// machine that writes no element, because it has no outputs.
static void warn_of_mode_without_safe(AppCheck *k, const AppTask *t)
{
    const Program *p = t->machine ? t->machine->program : NULL;
    const Var *written = NULL;    // the first element that the machine assigns, other than S, for which `written` is never set

    for (size_t i = 0; p && !written && i < p->var.n; i++)
        if (p->var.at[i]->element && p->var.at[i]->written)
            written = p->var.at[i];
    if (!t->mode || t->has_safe || (t->kind != AST_TASK_task && !written))
        return;
    diag_report(k->c->diags, DIAG_mode_without_safe, t->span, t->name->text,
                written ? diag_text(k->c->diags, DIAG_part_machine_stays, written->name->text) : diag_text(k->c->diags, DIAG_part_no_safe));
}

static AppTask *check_task(AppCheck *k, const AstAppTask *in, uint64_t period)
{
    AppTask *t = ARENA_NEW(k->c->arena, AppTask);
    DiagCode problem;

    t->kind = in->kind;
    t->name = in->name.text;
    t->span = in->name.span;
    t->number = (uint16_t)k->app->task.n;
    if (in->kind == AST_TASK_task || in->kind == AST_TASK_machine) {
        if (find_name_problem(in->name.text->text, &problem))
            diag_report(k->c->diags, DIAG_task_name_reserved, in->name.span, in->name.text->text,
                        in->kind == AST_TASK_machine ? "machine" : "task", diag_text(k->c->diags, problem));
        app_check_unique(k, &k->task, &in->name, "task or machine");
    } else
        check_service_task(k, in);
    for (size_t i = 0; i < in->annotations.n; i++) {
        const AstAppAnnotation *a = &in->annotations.at[i];
        t->has_init = t->has_init || a->kind == AST_ON_init;
        t->has_safe = t->has_safe || a->kind == AST_ON_safe;
        if (a->kind != AST_ON_mode)
            continue;
        t->mode = app_find_element(k, &a->word);
        if (t->mode && t->mode->type != SM_U8)
            diag_note(k->c->diags, diag_report(k->c->diags, DIAG_app_element_type, a->word.span, t->mode->name->text,
                                               sm_type_info[t->mode->type].spelling, "a mode", "a U8"),
                      t->mode->span, DIAG_note_declared_here, t->mode->name->text);
    }
    if (in->kind == AST_TASK_machine)
        t->machine = check_machine_task(k, in, period);
    warn_of_mode_without_safe(k, t);
    return t;
}

void check_app_tasks(AppCheck *k, const AstAppExecutor *in, AppExecutor *out)
{
    enum { MOST = 65535 };

    for (size_t r = 0; r < in->rates.n; r++) {
        if (in->rates.at[r].tasks.n == 0 && !in->lost)
            diag_report(k->c->diags, DIAG_app_missing, in->rates.at[r].span, diag_text(k->c->diags, DIAG_part_empty_rate));
        for (size_t t = 0; t < in->rates.at[r].tasks.n; t++) {
            const AstAppTask *written = &in->rates.at[r].tasks.at[t];
            const AppRate *rate = out->rate.at[r];
            AppTask *task = check_task(k, written, rate->period);
            if (k->app->task.n == MOST)
                diag_report(k->c->diags, DIAG_app_too_many, task->span, "tasks", "65535");
            // A machine refuses a step if the time has not advanced, so a period must not be shorter than one unit of the time.
            if (written->kind == AST_TASK_machine && k->app->time && rate->period && rate->period < k->app->unit)
                diag_note(k->c->diags, diag_report(k->c->diags, DIAG_app_time_coarse, written->name.span, written->name.text->text,
                                                   app_time_text(k->c->arena, rate->period), k->app->time->name->text,
                                                   app_time_text(k->c->arena, k->app->unit)),
                          k->app->time_span, DIAG_note_named_here);
            if (task->machine && task->machine->program)
                check_app_machine_time(k->c, (Program *)task->machine->program, written->name.span, k->app->time ? k->app->unit : 0, rate->period);
            vec_push(k->c->arena, &k->app->task, task);
            vec_push(k->c->arena, &out->rate.at[r]->task, (const AppTask *)task);
        }
    }
}
