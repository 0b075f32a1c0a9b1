// SPDX-License-Identifier: Apache-2.0
// Prints the syntax tree of an application: one line per entry, indented below its owner.
#include "compiler/syntax/ast_app.h"

static void print_source(Buf *out, Span span) { buf_put(out, span.src->text + span.at, span.len); }

static void print_source_if_present(Buf *out, Span span)
{
    if (span.src) {
        buf_char(out, ' ');
        print_source(out, span);
    }
}

static void print_annotations(Buf *out, const AstAppAnnotations *all)
{
    for (size_t i = 0; i < all->n; i++) {
        buf_printf(out, " @%s", app_annotation_name(all->at[i].kind));
        print_source_if_present(out, all->at[i].word.span);
        print_source_if_present(out, all->at[i].amount.span);
    }
    buf_char(out, '\n');
}

static void print_option(Buf *out, const AstAppOption *o)
{
    buf_printf(out, "  %s", app_option_name(o->kind));
    print_source_if_present(out, o->element.span);
    print_source_if_present(out, o->file.span);
    print_source_if_present(out, o->amount.span);
    buf_char(out, '\n');
}

static void print_task(Buf *out, const AstAppTask *t)
{
    buf_printf(out, "    %s", app_task_word(t->kind));
    if (t->kind == AST_TASK_task || t->kind == AST_TASK_machine)
        print_source_if_present(out, t->name.span);
    print_source_if_present(out, t->file.span);
    for (size_t i = 0; i < t->bindings.n; i++) {
        buf_str(out, i == 0 ? " {" : "");
        print_source_if_present(out, t->bindings.at[i].name.span);
        buf_str(out, " =");
        print_source_if_present(out, t->bindings.at[i].value->span);
        buf_str(out, i + 1 == t->bindings.n ? " }" : "");
    }
    print_annotations(out, &t->annotations);
}

static void print_executor(Buf *out, const AstAppExecutor *e)
{
    buf_printf(out, "executor %s", e->name.text->text);
    print_annotations(out, &e->annotations);
    for (size_t r = 0; r < e->rates.n; r++) {
        const AstAppRate *rate = &e->rates.at[r];
        buf_str(out, rate->amount.of == APP_TIME ? "  every" : "  at");
        print_source_if_present(out, rate->amount.span);
        buf_char(out, '\n');
        for (size_t t = 0; t < rate->tasks.n; t++)
            print_task(out, &rate->tasks.at[t]);
    }
}

void ast_print_app(const AstApp *app, Buf *out)
{
    if (app->options_header.src)
        buf_str(out, "options\n");
    for (size_t i = 0; i < app->options.n; i++)
        print_option(out, &app->options.at[i]);
    if (app->start_header.src)
        buf_str(out, "start\n");
    for (size_t i = 0; i < app->start.n; i++) {
        buf_str(out, "  ");
        print_source(out, app->start.at[i]->span);
        buf_char(out, '\n');
    }
    for (size_t i = 0; i < app->executors.n; i++)
        print_executor(out, app->executors.at[i]);
    for (size_t i = 0; i < app->allows.n; i++) {
        print_source(out, app->allows.at[i].is->span);
        buf_char(out, '\n');
    }
}
