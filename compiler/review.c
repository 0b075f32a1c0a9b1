// SPDX-License-Identifier: Apache-2.0
#include "compiler/review.h"

#include "compiler/base/path.h"
#include <string.h>

#include "compiler/version.h"

// Begins a review without runs.
void review_begin(Session *s, const Program *flown, Report *r)
{
    memset(r, 0, sizeof *r);
    r->arena = &s->arena;
    r->maker = "smc " SMC_VERSION;
    analysis_begin(&r->analysis, r->arena, &s->diags, flown);
}

// Adds the costs of a machine as it flies: compiled with the option `measure`, with its image as `smc build` writes it, without names but
// with pins.  `step_given`: the user chose s->step; otherwise the machine declares it, or its scripts do.
void review_add_costs(Session *s, const CompiledSource *m, const Buf *image, bool step_given, Report *r)
{
    r->step_given = step_given;
    r->analysis.step = s->step;
    cost_of_machine(r->arena, m->measured, 0, COST_INSTRUCTIONS, &r->cost);
    cost_of_machine(r->arena, m->measured, 0, COST_CYCLES_FLASH, &r->flash);
    cost_of_machine(r->arena, m->measured, 0, COST_CYCLES_EEPROM, &r->eeprom);
    r->image = (const uint8_t *)image->at;
    r->image_size = image->n;
}

// The context of the callback after each step in review_run_script, which records data in `trace`, then calls the caller's after_step.
typedef struct AfterStep { Trace *trace; const ScriptOptions *of_caller; } AfterStep;

static void record_after_step(void *context, const ScriptStep *step)
{
    const AfterStep *a = context;

    if (step->recorded)
        trace_add_recorded(a->trace, step->recorded);
    if (a->of_caller->after_step)
        a->of_caller->after_step(a->of_caller->context, step);
}

static bool is_cancelled(void *context)
{
    const ScriptOptions *o = ((const AfterStep *)context)->of_caller;

    return o->is_cancelled && o->is_cancelled(o->context);
}

// Runs the script `src` on the engines in lock step and records what the first one does in *run.  `p` is the machine as its scripts run it.
// `script`: the compiled script; NULL: it is compiled now, and if it has errors, run->script is NULL and nothing has run.
void review_run_script(Session *s, const Report *r, const Program *p, const Source *src, const Script *script, Engine **engine, size_t engines,
                       const ScriptOptions *o, ReportRun *run)
{
    const Diags of_machine = s->diags;
    Engine **all = ARENA_ARRAY(&s->arena, Engine *, engines);
    AfterStep after = {&run->trace, o};
    ScriptOptions with_data = *o;

    run->name = source_short_name(src);
    trace_init(&run->trace, &s->arena, p, &r->analysis.transition);
    diags_clear(&s->diags);
    if ((run->script = script ? script : session_script(s, src, p)) != NULL) {
        if (o->requirements && !script)
            session_check_requirements_of_script(s, o->requirements, run->script);
        memcpy(all, engine, engines * sizeof *all);
        all[0] = trace_wrap_engine(&run->trace, engine[0]);
        if (run->script->data)
            trace_begin_recorded(&run->trace, run->script->data);
        with_data.after_step = record_after_step;
        with_data.is_cancelled = is_cancelled;
        with_data.context = &after;
        run->result = script_run(&s->arena, &s->diags, run->script, all, engines, &with_data);
    }
    diags_apply_allows(&s->diags);
    run->diags = s->diags;
    s->diags = of_machine;
}

// ---- applications ----

// Returns the machine of the application as it flies.
static const Program *flown_program(const App *app, const Member *m)
{
    for (size_t i = 0; i < app->machine.n; i++)
        if (app->machine.at[i]->name == m->name)
            return app->machine.at[i]->program;
    return m->program;
}

// Whether a position is in the source `src`; if `src` is NULL, in that of no machine of the application.
static bool is_in_source(const Report *r, Span span, const Source *src)
{
    for (size_t i = 0; !src && i < r->members; i++)
        if (span.src == r->member[i].analysis.p->src)
            return false;
    return !src || span.src == src;
}

// Returns the findings at positions in the source of a machine; for NULL, those that are in the source of no machine.
static Diags *findings_of(Session *s, const Report *r, const Source *src)
{
    Diags *out = arena_copy(&s->arena, &s->diags, sizeof s->diags);

    out->list.at = out->allowed.at = NULL;
    out->list.n = out->list.cap = out->allowed.n = out->allowed.cap = 0;
    for (size_t i = 0; i < s->diags.list.n; i++)
        if (is_in_source(r, s->diags.list.at[i]->span, src))
            vec_push(&s->arena, &out->list, s->diags.list.at[i]);
    for (size_t i = 0; i < s->diags.allowed.n; i++)
        if (is_in_source(r, s->diags.allowed.at[i]->span, src))
            vec_push(&s->arena, &out->allowed, s->diags.allowed.at[i]);
    return out;
}

// Adds the costs of a machine of an application, as if it flew alone in an image.
static void add_costs_of_member(Session *s, int opt_level, Report *r)
{
    const ImageOptions with_lines = {true, NULL}, as_sent = {false, NULL};
    IrMachine *ir = session_ir(s, r->analysis.p, opt_level);
    CompiledSource of = {0};
    Buf lines, image;

    buf_init(&lines, &s->arena);
    buf_init(&image, &s->arena);
    if (!session_image(s, &ir, 1, &with_lines, &lines) || !session_image(s, &ir, 1, &as_sent, &image))
        return;
    of.measured = (const uint8_t *)lines.at;
    s->step = r->analysis.step;
    review_add_costs(s, &of, &image, false, r);
}

void review_begin_app(Session *s, const App *app, const Program *joint, int opt_level, Report *r)
{
    const Joint *j = joint->joint;

    *r = (Report){.arena = &s->arena, .maker = "smc " SMC_VERSION, .analysis = {.p = joint, .diags = &s->diags}, .net = app->net};
    r->members = j->member.n;
    r->member = ARENA_ARRAY(&s->arena, Report, r->members);
    for (size_t i = 0; i < r->members; i++) {
        const uint64_t period = j->member.at[i].every * j->tick;
        review_begin(s, flown_program(app, &j->member.at[i]), &r->member[i]);
        r->member[i].analysis.step = period % j->unit == 0 ? period / j->unit : 0;
        r->member[i].of = &j->member.at[i];
        add_costs_of_member(s, opt_level, &r->member[i]);
    }
    for (size_t i = 0; i < r->members; i++)
        r->member[i].analysis.diags = findings_of(s, r, r->member[i].analysis.p->src);
    r->analysis.diags = findings_of(s, r, NULL);
}

// Sets the run of one machine: what is the same for all machines, and the values of its own variables at the end.
static void set_run_of_machine(Session *s, const Member *m, const ReportRun *all, ReportRun *run)
{
    uint64_t *cell = ARENA_ARRAY(&s->arena, uint64_t, m->program->var.n);

    run->name = all->name;
    run->script = all->script;
    if (!all->script)
        return;
    run->result = all->result;
    for (size_t v = 0; v < m->program->var.n; v++)
        cell[v] = all->result.cell[m->var[v]->index];
    run->result.cell = cell;
}

void review_run_app_script(Session *s, Report *r, const Source *src, Engine *vm, Engine *const *engine, const ScriptOptions *o, size_t number)
{
    const Diags of_application = s->diags;
    Engine **traced = ARENA_ARRAY(&s->arena, Engine *, r->members), *all[2] = {vm, NULL};
    ReportRun *run = &r->run[number];

    for (size_t i = 0; i < r->members; i++) {
        Report *m = &r->member[i];
        trace_init(&m->run[number].trace, &s->arena, m->of->program, &m->analysis.transition);
        traced[i] = trace_wrap_engine(&m->run[number].trace, engine[i]);
    }
    all[1] = engine_app_open(&s->arena, r->analysis.p, traced);
    run->name = source_short_name(src);
    diags_clear(&s->diags);
    if ((run->script = session_script(s, src, r->analysis.p)) != NULL) {
        if (o->requirements)
            session_check_requirements_of_script(s, o->requirements, run->script);
        run->result = script_run(&s->arena, &s->diags, run->script, all, 2, o);
    }
    diags_apply_allows(&s->diags);
    run->diags = s->diags;
    s->diags = of_application;
    for (size_t i = 0; i < r->members; i++)
        set_run_of_machine(s, r->member[i].of, run, &r->member[i].run[number]);
}

// Measures what the runs of r cover: runs their scripts again, as far as they ran.
void review_measure_coverage(Session *s, const Program *p, Report *r)
{
    Cover *cover;
    Engine *engine;
    Diags unused;

    if (r->runs == 0)
        return;
    cover = cover_new(&s->arena, p);
    engine = cover_open_engine(cover);
    diags_init(&unused, &s->arena);
    unused.muted = true;
    for (size_t i = 0; i < r->runs; i++) {
        const ScriptOptions o = {.max_steps = r->run[i].result.steps, .is_compared = true};
        if (r->run[i].script)
            script_run(&s->arena, &unused, r->run[i].script, &engine, 1, &o);
    }
    cover_settle(cover);
    r->cover = cover;
}
