// SPDX-License-Identifier: Apache-2.0
// Checks the messages of an application together with its tasks, its machines, its pins and its executors (docs/config.md 11.11, 11.19).
#include "compiler/sema/app_check.h"

// Reports element e, which the network writes, if another part of the application writes it as well.
static void check_other_writers(AppCheck *k, const Element *e, Span span, const char *what)
{
    const char *statistic = map_find(&k->statistic, e->name);

    for (size_t i = 0; k->pins && i < k->pins->pin.n; i++)
        if (k->pins->pin.at[i].element == e && !pin_is_output(&k->pins->pin.at[i]))
            diag_note(k->c->diags, diag_report(k->c->diags, DIAG_net_two_writers, span, e->name->text, what, "an input"),
                      k->pins->pin.at[i].span, DIAG_note_input_here);
    for (size_t i = 0; i < k->files->instances; i++) {
        const Program *p = k->files->instance[i].program;
        for (size_t v = 0; p && v < p->var.n; v++)
            if (p->var.at[v]->element == e && (p->var.at[v]->written || p->var.at[v] == p->s))
                diag_note(k->c->diags, diag_report(k->c->diags, DIAG_net_two_writers, span, e->name->text, what,
                                                   diag_text(k->c->diags, DIAG_part_machine, p->name->text)),
                          p->var.at[v]->span, DIAG_note_listed_there, p->name->text);
    }
    if (e == k->app->time)
        diag_note(k->c->diags, diag_report(k->c->diags, DIAG_net_two_writers, span, e->name->text, what, "the time"), k->app->time_span,
                  DIAG_note_named_here);
    else if (statistic)
        diag_report(k->c->diags, DIAG_net_two_writers, span, e->name->text, what, statistic);
}

// Reports elements that the channel writes and that something else writes too.
static void check_writers_of_channel(AppCheck *k, const NetChannel *c)
{
    const char *message = format_in(k->c->arena, "the message '%s'", c->name->text);

    for (size_t i = 0; !c->is_send && i < c->field.n; i++)
        check_other_writers(k, c->field.at[i].element, c->field.at[i].span, message);
    for (size_t i = 0; i < c->statistic.n; i++)
        check_other_writers(k, c->statistic.at[i].element, c->span, format_in(k->c->arena, "a count of '%s'", c->name->text));
    if (c->age)
        check_other_writers(k, c->age, c->span, format_in(k->c->arena, "the age of '%s'", c->name->text));
}

// Returns the period of the group that runs the task; 0 if no group does.
static uint64_t period_of_task(const AppCheck *k, AstAppTaskKind kind)
{
    for (size_t x = 0; x < k->app->executor.n; x++)
        for (size_t r = 0; r < k->app->executor.at[x]->rate.n; r++) {
            const AppRate *rate = k->app->executor.at[x]->rate.at[r];
            for (size_t t = 0; t < rate->task.n; t++)
                if (rate->task.at[t]->kind == kind)
                    return rate->period;
        }
    return 0;
}

// Reports messages of a direction whose task is missing, while the task of the other direction exists.
static void warn_of_missing_task(AppCheck *k, bool is_send)
{
    const AstAppTaskKind task = is_send ? AST_TASK_send : AST_TASK_receive, other = is_send ? AST_TASK_receive : AST_TASK_send;

    if (k->service[task].src || !k->service[other].src || k->ast->lost)
        return;
    for (size_t i = 0; i < k->net->channel.n; i++)
        if (k->net->channel.at[i]->is_send == is_send) {
            diag_report(k->c->diags, DIAG_net_without_task, k->net->channel.at[i]->span,
                        is_send ? "messages to send" : "messages to receive", app_task_word(task));
            return;
        }
}

void check_app_net(AppCheck *k)
{
    const uint64_t step = period_of_task(k, AST_TASK_send);

    for (size_t i = 0; i < k->net->channel.n; i++) {
        const NetChannel *c = k->net->channel.at[i];
        check_writers_of_channel(k, c);
        if (c->is_send && step && c->period % step)
            diag_report(k->c->diags, DIAG_net_period, c->span, c->name->text, app_time_text(k->c->arena, c->period),
                        app_time_text(k->c->arena, step));
    }
    warn_of_missing_task(k, true);
    warn_of_missing_task(k, false);
}
