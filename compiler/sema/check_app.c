// SPDX-License-Identifier: Apache-2.0
// Checks an application (docs/config.md 10) and builds an App: its files, options and executors.  Tasks are checked in
// check_app_task.c, times in check_app_time.c.
#include "compiler/sema/app_check.h"

#include <string.h>

#include "stdlib/convert.h"

// ---- files ----

static const char *const suffix[] = {[FILE_SV] = ".sv", [FILE_SM] = ".sm", [FILE_IO] = ".io", [FILE_NET] = ".net"};

typedef struct FileListing { AppFiles *out; Map seen[FILE_KINDS]; } FileListing;

// Adds a file that the application names to the list, once for each kind and name.
static void add_file(FileListing *l, FileKind kind, const AstWord *name)
{
    AppFile *f = &l->out->at[l->out->n];
    const size_t n = name->text->len, end = strlen(suffix[kind]);

    if (map_find(&l->seen[kind], name->text))
        return;
    map_put(&l->seen[kind], name->text, f);
    f->kind = kind;
    f->name = *name;
    f->wrong_kind = n <= end || strcmp(name->text->text + n - end, suffix[kind]) != 0;
    l->out->n++;
}

// Adds the machine of a task. Its file has been added.
static void add_instance(FileListing *l, const AstAppTask *task)
{
    AppFile *f = map_find(&l->seen[FILE_SM], task->file.text);

    f->machines++;
    if (f->unbound == 0 && task->bindings.n == 0)
        f->unbound = l->out->instances + 1;
    l->out->instance[l->out->instances++] = (AppInstance){task, (size_t)(f - l->out->at), NULL};
}

static size_t count_tasks(const AstApp *ast)
{
    size_t n = 0;

    for (size_t e = 0; e < ast->executors.n; e++)
        for (size_t r = 0; r < ast->executors.at[e]->rates.n; r++)
            n += ast->executors.at[e]->rates.at[r].tasks.n;
    return n;
}

const AstAppOption *app_find_option(const AstApp *ast, AstAppOptionKind kind)
{
    for (size_t i = 0; i < ast->options.n; i++)
        if (ast->options.at[i].kind == kind)
            return &ast->options.at[i];
    return NULL;
}

// Lists the files that an application names.
void app_list_files(Arena *arena, const AstFile *f, AppFiles *out)
{
    const AstAppOption *sv = app_find_option(f->app, AST_APP_state_vector), *io = app_find_option(f->app, AST_APP_io);
    const AstAppOption *net = app_find_option(f->app, AST_APP_net);
    FileListing l;

    memset(&l, 0, sizeof l);
    l.out = out;
    for (size_t i = 0; i < sizeof l.seen / sizeof *l.seen; i++)
        l.seen[i].arena = arena;
    out->n = out->instances = 0;
    out->at = ARENA_ARRAY(arena, AppFile, count_tasks(f->app) + 3);
    out->instance = ARENA_ARRAY(arena, AppInstance, count_tasks(f->app));
    if (sv)
        add_file(&l, FILE_SV, &sv->file);
    if (io)
        add_file(&l, FILE_IO, &io->file);
    if (net)
        add_file(&l, FILE_NET, &net->file);
    for (size_t e = 0; e < f->app->executors.n; e++) {
        const AstAppExecutor *executor = f->app->executors.at[e];
        for (size_t r = 0; r < executor->rates.n; r++)
            for (size_t t = 0; t < executor->rates.at[r].tasks.n; t++)
                if (executor->rates.at[r].tasks.at[t].kind == AST_TASK_machine) {
                    add_file(&l, FILE_SM, &executor->rates.at[r].tasks.at[t].file);
                    add_instance(&l, &executor->rates.at[r].tasks.at[t]);
                }
    }
}

// Reports files that cannot be read.
static void check_files(AppCheck *k)
{
    static const char *const what[] = {[FILE_SV] = "state vector", [FILE_SM] = "machine", [FILE_IO] = "file of pins",
                                       [FILE_NET] = "file of messages"};

    for (size_t i = 0; i < k->files->n; i++) {
        const AppFile *f = &k->files->at[i];
        if (f->wrong_kind)
            diag_report(k->c->diags, DIAG_app_file_kind, f->name.span, f->name.text->text, what[f->kind], suffix[f->kind]);
        else if (!f->src)
            diag_report(k->c->diags, DIAG_app_file, f->name.span, f->name.text->text, f->problem);
    }
}

// ---- elements ----

// Returns the element with this name; NULL after reporting that it does not exist.  Also NULL, without a report, if the state vector has errors.
const Element *app_find_element(AppCheck *k, const AstWord *name)
{
    const Element *e = k->sv ? map_find(&k->sv->by_name, name->text) : NULL;
    Str similar;
    Diag *d;

    if (e || !k->sv)
        return e;
    d = diag_report(k->c->diags, DIAG_unknown_element, name->span, name->text->text);
    similar = suggest_element(k->c->diags, d, &k->guesses, k->sv, name->text);
    if (similar)
        diag_note(k->c->diags, d, ((const Element *)map_find(&k->sv->by_name, similar))->span, DIAG_note_declared_here, similar->text);
    return NULL;
}

// Reports `name` as a duplicate if `seen` contains it; otherwise adds it.  `what` is the kind of thing that it names.
void app_check_unique(AppCheck *k, Map *seen, const AstWord *name, const char *what)
{
    const Span *first = map_find(seen, name->text);

    if (first)
        diag_note(k->c->diags, diag_report(k->c->diags, DIAG_app_name_twice, name->span, what, name->text->text), *first,
                  DIAG_note_first_here);
    else
        map_put(seen, name->text, (void *)(size_t)&name->span);
}

// ---- options ----

// Returns where to report that something is missing in [options]: its header, or the start of the file if there is no header.
static Span options_span(const AppCheck *k)
{
    return k->ast->options_header.src ? k->ast->options_header : (Span){k->app->src, 0, 0};
}

// Reports element e, which `writer` writes, if an input pin also writes it.
static void report_inputs_writing(AppCheck *k, const Element *e, Span span, const char *writer)
{
    for (size_t i = 0; e && k->pins && i < k->pins->pin.n; i++)
        if (k->pins->pin.at[i].element == e && !pin_is_output(&k->pins->pin.at[i]))
            diag_note(k->c->diags, diag_report(k->c->diags, DIAG_app_two_writers, span, writer, e->name->text, "an input"),
                      k->pins->pin.at[i].span, DIAG_note_input_here);
}

static void check_time_option(AppCheck *k, const AstAppOption *o)
{
    const Element *e = app_find_element(k, &o->element);

    app_check_amount(k, &o->amount, APP_RANGE_unit, &k->app->unit);
    if (e && e->type != SM_U64) {
        Diag *d = diag_report(k->c->diags, DIAG_app_element_type, o->element.span, e->name->text, sm_type_info[e->type].spelling,
                              "the time", "a U64");
        diag_note(k->c->diags, d, e->span, DIAG_note_declared_here, e->name->text);
    }
    report_inputs_writing(k, e, o->element.span, "the runtime");
    k->app->time = e;
    k->app->time_span = o->element.span;
}

Str app_file_stem(AppCheck *k, Str path)
{
    Source named = {0};

    named.name = path->text;
    return sema_file_stem(k->c->strings, &named);
}

// Reports a log that is smaller than the smallest ring that the runtime accepts: runtime-c/log.h, SM_LOG_LEAST.
static void check_log_room(AppCheck *k, const AstAppOption *o)
{
    uint32_t least = 0;

    for (size_t i = 0; k->sv && i < k->sv->region.n; i++)
        least += k->sv->region.at[i]->packed_size;
    least = 2 * (least + 18) + 192;
    if (k->sv && k->app->log_room >= app_ranges[APP_RANGE_log_memory].least && k->app->log_room < least)
        diag_report(k->c->diags, DIAG_app_range, o->amount.span, app_ranges[APP_RANGE_log_memory].what,
                    diag_text(k->c->diags, DIAG_part_least_log, format_in(k->c->arena, "%lu", (unsigned long)least)));
}

void check_app_name_length(AppCheck *k, const AstWord *file, const AppRange *r)
{
    if (file->text->len < r->least || file->text->len > r->most)
        diag_report(k->c->diags, DIAG_app_range, file->span, r->what, r->limits);
}

// Stores the element that shows whether the application is armed.
static void check_armed(AppCheck *k, const AstAppOption *o)
{
    const Element *e = app_find_element(k, &o->element);

    k->app->armed = e;
    if (e && e->type != SM_BOOL)
        diag_note(k->c->diags, diag_report(k->c->diags, DIAG_app_element_type, o->element.span, e->name->text,
                                           sm_type_info[e->type].spelling, "'armed'", "a bool"),
                  e->span, DIAG_note_declared_here, e->name->text);
}

// Returns the amount of an option, whose range ends below 2^32; the range's least value after a report.
static uint32_t check_small_amount(AppCheck *k, const AstAppOption *o, AppRangeId range)
{
    uint64_t n;

    app_check_amount(k, &o->amount, range, &n);
    return (uint32_t)n;
}

static void check_options(AppCheck *k)
{
    k->app->events = 64;
    k->app->swap_trial = 1000;
    k->app->swap_limit = 10000;
    for (size_t i = 0; i < k->ast->options.n; i++) {
        const AstAppOption *o = &k->ast->options.at[i];

        switch (o->kind) {
        case AST_APP_state_vector: case AST_APP_OPTION_COUNT:
            break;
        case AST_APP_io:
            k->app->io = o->file.text;
            k->app->io_name = app_file_stem(k, o->file.text);
            break;
        case AST_APP_time:
            check_time_option(k, o);
            break;
        case AST_APP_net:
            k->app->net_name = app_file_stem(k, o->file.text);
            break;
        case AST_APP_watchdog:
            app_check_amount(k, &o->amount, APP_RANGE_watchdog, &k->app->watchdog);
            break;
        case AST_APP_events:
            k->app->events = check_small_amount(k, o, APP_RANGE_events);
            break;
        case AST_APP_log:
            k->app->log_room = check_small_amount(k, o, APP_RANGE_log_memory);
            k->app->log = o->file.text;
            check_app_name_length(k, &o->file, &app_ranges[APP_RANGE_name_length]);
            check_log_room(k, o);
            break;
        case AST_APP_keep:
            k->app->keep = o->file.text;
            check_app_name_length(k, &o->file, &app_ranges[APP_RANGE_name_length]);
            break;
        case AST_APP_swap:
            k->app->swap_room = (check_small_amount(k, o, APP_RANGE_swap_memory) + 7) / 8 * 8;
            break;
        case AST_APP_swap_trial:
            k->app->swap_trial = check_small_amount(k, o, APP_RANGE_swap_trial);
            break;
        case AST_APP_swap_limit:
            k->app->swap_limit = check_small_amount(k, o, APP_RANGE_swap_limit);
            break;
        case AST_APP_swap_at: case AST_APP_swap_speed: case AST_APP_swap_key:
            check_app_swap_at(k, o);
            break;
        case AST_APP_swap_store:
            k->app->swap_store = o->file.text;
            check_app_name_length(k, &o->file, &app_ranges[APP_RANGE_name_length]);
            break;
        case AST_APP_armed:
            check_armed(k, o);
            break;
        }
    }
    check_app_swap_place(k);
    if (!app_find_option(k->ast, AST_APP_state_vector) && !k->ast->lost)
        diag_report(k->c->diags, DIAG_app_missing, options_span(k), diag_text(k->c->diags, DIAG_part_no_state_vector));
}

// ---- [start]: the values of elements before any task runs (config.md 10.8) ----

// Returns whether the expression contains only numbers; reports each part that is not one.
static bool check_only_numbers(AppCheck *k, const Sema *s, const AstExpr *e)
{
    const SmBuiltinInfo *fn = e->kind == AST_CALL ? scope_find_function(s, e->name) : NULL;
    bool good = true;

    if (e->kind == AST_NAME || (fn && fn->is_roll)) {
        diag_report(k->c->diags, DIAG_start_no_number, e->span);
        return false;
    }
    if (e->a)
        good = check_only_numbers(k, s, e->a);
    if (e->b)
        good = check_only_numbers(k, s, e->b) && good;
    for (size_t i = 0; e->args && i < e->args->n; i++)
        good = check_only_numbers(k, s, e->args->at[i]) && good;
    return good && e->kind != AST_ERROR;
}

static void check_start_value(AppCheck *k, Sema *s, AstStmt *in)
{
    const AstWord name = {in->name, in->name_span};
    const Element *e = app_find_element(k, &name);
    const Span *first = map_find(&k->start, in->name);
    Expr *value = NULL;
    AppStart out;
    SmF64 written, stored;

    if (first) {
        diag_note(k->c->diags, diag_report(k->c->diags, DIAG_start_twice, in->name_span, in->name->text), *first, DIAG_note_first_here);
    } else {
        map_put(&k->start, in->name, &in->name_span);
        if (check_only_numbers(k, s, in->value))
            value = check_expr(s, in->value);
    }
    if (!e || !value)
        return;
    written = expr_constant_value(value);
    out.element = e;
    out.cell = sm_cell_from_f64(e->type, written);
    stored = sm_cell_to_f64(e->type, out.cell);
    if (e->type != SM_F32 && e->type != SM_F64 && !sm_eq(stored, written))
        diag_report(k->c->diags, DIAG_start_range, in->value->span, const_text(k->c->arena, written), e->name->text,
                    sm_type_info[e->type].spelling, const_text(k->c->arena, stored));
    vec_push(k->c->arena, &k->app->start, out);
}

// Checks the values of [start] with the checker of machines, in an empty Program: no variable exists there.
static void check_start_section(AppCheck *k)
{
    Program *nothing = ARENA_NEW(k->c->arena, Program);
    HiddenNames *lost = ARENA_NEW(k->c->arena, HiddenNames);
    Sema s;

    nothing->by_name.arena = nothing->state_by_name.arena = lost->word.arena = k->c->arena;
    sema_init(&s, k->c, lost, nothing, &nothing->window);
    for (size_t i = 0; i < k->ast->start.n; i++)
        check_start_value(k, &s, k->ast->start.at[i]);
}

// ---- executors ----

// Reports element e, which an executor writes, if a machine or an input pin also writes it.
static void check_other_writers(AppCheck *k, const AstAppAnnotation *a, const Element *e)
{
    for (size_t i = 0; i < k->files->instances; i++) {
        const Program *p = k->files->instance[i].program;
        for (size_t v = 0; p && v < p->var.n; v++)
            if (p->var.at[v]->element == e && p->var.at[v]->written)
                diag_note(k->c->diags, diag_report(k->c->diags, DIAG_app_two_writers, a->word.span, "the executor", e->name->text,
                                                   diag_text(k->c->diags, DIAG_part_machine, p->name->text)),
                          p->var.at[v]->span, DIAG_note_listed_there, p->name->text);
    }
    report_inputs_writing(k, e, a->word.span, "the executor");
}

static void check_statistic(AppCheck *k, const AstAppAnnotation *a, AppExecutor *out)
{
    static const char *const name[APP_STATISTICS] = {"its ticks", "its overruns", "its skipped ticks", "its lateness", "its busy time"};
    AppStatistic which = (AppStatistic)(a->kind - AST_ON_ticks);
    const Element *e = app_find_element(k, &a->word);
    const char *content = e ? map_find(&k->statistic, e->name) : NULL;
    Diag *d;

    if (!e)
        return;
    out->statistic[which] = e;
    check_other_writers(k, a, e);
    if (e->type == SM_F32 || e->type == SM_F64 || e->type == SM_BOOL) {
        d = diag_report(k->c->diags, DIAG_app_element_type, a->word.span, e->name->text, sm_type_info[e->type].spelling,
                        "a statistic of an executor", "of an integer type");
        diag_note(k->c->diags, d, e->span, DIAG_note_declared_here, e->name->text);
    } else if (content || e == k->app->time) {
        diag_report(k->c->diags, DIAG_vitals_twice, a->word.span, e->name->text, name[which], content ? content : "the time");
    } else {
        content = diag_text(k->c->diags, DIAG_part_statistic, name[which], out->name->text);
        map_put(&k->statistic, e->name, (void *)(size_t)content);
    }
}

static void check_executor(AppCheck *k, const AstAppExecutor *in)
{
    AppExecutor *out = ARENA_NEW(k->c->arena, AppExecutor);

    out->name = in->name.text;
    out->span = in->header;
    app_check_unique(k, &k->executor, &in->name, "executor");
    vec_push(k->c->arena, &k->app->executor, out);
    for (size_t i = 0; i < in->annotations.n; i++) {
        const AstAppAnnotation *a = &in->annotations.at[i];
        uint64_t n = 0;
        if (a->kind >= AST_ON_ticks && a->kind <= AST_ON_busy) {
            check_statistic(k, a, out);
        } else if (a->kind == AST_ON_priority) {
            app_check_amount(k, &a->amount, APP_RANGE_priority, &n);
            out->priority = (uint32_t)n;
        } else if (a->kind == AST_ON_overrun && a->amount.of != APP_NOTHING) {
            app_check_amount(k, &a->amount, APP_RANGE_catch_up, &n);
            out->catch_up = true;
            out->most = (uint32_t)n;
        }
    }
    if (in->rates.n == 0 && !in->lost)
        diag_report(k->c->diags, DIAG_app_missing, in->header, diag_text(k->c->diags, DIAG_part_no_rate, in->name.text->text));
    check_app_rates(k, in, out);
    check_app_tasks(k, in, out);
}

static void check_executors(AppCheck *k)
{
    enum { MOST = 254 };                          // the most threads that any platform supports (runtime-c/pal/config.h)
    size_t n = k->ast->executors.n;

    for (size_t i = 0; i < n; i++)
        check_executor(k, k->ast->executors.at[i]);
    if (n == 0 && !k->ast->lost)
        diag_report(k->c->diags, DIAG_app_missing, options_span(k), diag_text(k->c->diags, DIAG_part_no_executor));
    if (n > MOST)
        diag_report(k->c->diags, DIAG_app_too_many, k->ast->executors.at[MOST]->header, "executors", "254");
    if (n > 1 && k->sv && !k->sv->lock) {
        const AstWord *file = &app_find_option(k->ast, AST_APP_state_vector)->file;
        Diag *d = diag_report(k->c->diags, DIAG_app_no_lock, k->ast->executors.at[1]->header,
                              format_in(k->c->arena, "%lu", (unsigned long)n), k->sv->name->text);
        diag_label(k->c->diags, d, DIAG_label_write_lock, file->text->text);
        diag_note(k->c->diags, d, file->span, DIAG_note_named_here);
    }
}

// ---- entry points ----

// Reports the options of swaps if no machine can be swapped.
static void report_unused_swap_options(AppCheck *k)
{
    bool any = k->ast->lost;

    for (size_t i = 0; i < k->app->machine.n; i++)
        any = any || k->app->machine.at[i]->swap;
    for (size_t i = 0; i < k->ast->options.n && !any; i++) {
        const AstAppOption *o = &k->ast->options.at[i];
        if (o->kind >= AST_APP_swap && o->kind <= AST_APP_armed)
            diag_report(k->c->diags, DIAG_app_option_unused, o->name_span, app_option_name(o->kind),
                        diag_text(k->c->diags, DIAG_part_no_swap_mark));
    }
}

// Reports options that no task uses.
static void report_unused_options(AppCheck *k)
{
    static const struct { AstAppOptionKind option; AstAppTaskKind a, b; DiagCode missing; } uses[] = {
        {AST_APP_io, AST_TASK_inputs, AST_TASK_outputs, DIAG_part_no_pin_task},
        {AST_APP_net, AST_TASK_receive, AST_TASK_send, DIAG_part_no_net_task},
        {AST_APP_log, AST_TASK_log, AST_TASK_log, DIAG_part_no_task},
        {AST_APP_keep, AST_TASK_keep, AST_TASK_keep, DIAG_part_no_task}};

    for (size_t i = 0; i < sizeof uses / sizeof *uses; i++) {
        const AstAppOption *o = app_find_option(k->ast, uses[i].option);
        if (o && !k->service[uses[i].a].src && !k->service[uses[i].b].src && !k->ast->lost)
            diag_report(k->c->diags, DIAG_app_option_unused, o->name_span, app_option_name(o->kind),
                        diag_text(k->c->diags, uses[i].missing, app_option_name(o->kind)));
    }
}

// Reports outputs (or inputs, if `output` is false) among the pins if their task does not exist but the task of the other direction does.
static void report_unused_pins(AppCheck *k, bool output, AstAppTaskKind task, AstAppTaskKind other)
{
    const AstAppOption *o = app_find_option(k->ast, AST_APP_io);
    size_t i = 0;

    if (!o || !k->pins || k->ast->lost || k->service[task].src || !k->service[other].src)
        return;
    while (i < k->pins->pin.n && pin_is_output(&k->pins->pin.at[i]) != output)
        i++;
    if (i < k->pins->pin.n)
        diag_note(k->c->diags, diag_report(k->c->diags, DIAG_pins_without_task, o->name_span, app_task_word(task), app_task_word(task)),
                  k->pins->pin.at[i].span, output ? DIAG_note_output_here : DIAG_note_input_here);
}

// Builds an application from its tree.  `sv`, `pins` and a machine's program are NULL if that file has errors, which are already reported.
App *check_app(CheckContext *c, const AstFile *f, const StateVec *sv, const IoMap *pins, const Network *net, const AppFiles *files)
{
    enum { GUESSES = 30 };        // the most unknown names for which a similar name is suggested: more than the reports that are shown
    size_t errors = c->diags->errors_seen;
    AppCheck k;

    memset(&k, 0, sizeof k);
    k.c = c;
    k.ast = f->app;
    k.files = files;
    k.sv = sv;
    k.pins = pins;
    k.net = net;
    k.guesses = GUESSES;
    k.machine_file.arena = k.machine_state.arena = k.task.arena = k.executor.arena = k.statistic.arena = k.start.arena = c->arena;
    k.app = ARENA_NEW(c->arena, App);
    k.app->name = sema_file_stem(c->strings, f->src);
    k.app->src = f->src;
    k.app->sv = sv;
    k.app->pins = pins;
    k.app->net = net;
    for (size_t i = 0; i < f->app->allows.n; i++) {
        const AstAppAllow *a = &f->app->allows.at[i];
        diag_allow(c->diags, a->is->name->text, a->is->reason->text, a->is->span, a->covers);
    }
    check_files(&k);
    check_app_products(&k);
    check_options(&k);
    check_start_section(&k);
    check_executors(&k);
    report_unused_options(&k);
    report_unused_swap_options(&k);
    report_unused_pins(&k, false, AST_TASK_inputs, AST_TASK_outputs);
    report_unused_pins(&k, true, AST_TASK_outputs, AST_TASK_inputs);
    if (net)
        check_app_net(&k);
    check_app_platform_files(&k);
    return c->diags->errors_seen > errors || !sv || f->app->lost ? NULL : k.app;
}
