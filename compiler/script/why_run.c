// SPDX-License-Identifier: Apache-2.0
#include "compiler/script/why_run.h"

#include <string.h>

// Called after each step: notes how near each transition came to being taken.
static void note_step(void *context, const ScriptStep *step)
{
    WhyRun *r = context;

    r->g_before = r->last_g;
    r->last_g = step->g;
    if (r->near && r->watch[r->q.machine]->step == step->number)
        why_note_near(r->watch[r->q.machine], r->near);
}

static bool is_question_reached(void *context)
{
    const WhyRun *r = context;

    return r->q.at_step ? r->run.result.steps >= r->q.at_step : r->q.has_g && r->last_g >= r->q.at_g;
}

const Program *why_program(const Program *p, size_t i) { return p->joint ? p->joint->member.at[i].program : p; }

static void open_engines(WhyRun *r, Engine *(*wrap)(void *context, WhyRun *r, Engine *ref), void *context)
{
    const Program *p = r->s->program;
    const size_t n = engine_machines(p);

    r->machine = ARENA_ARRAY(r->arena, Engine *, n);
    r->watch = ARENA_ARRAY(r->arena, Watch *, n);
    for (size_t i = 0; i < n; i++) {
        r->machine[i] = engine_ref_open(r->arena, why_program(p, i));
        if (wrap && i == r->q.machine)
            r->machine[i] = wrap(context, r, r->machine[i]);
        if (wrap)
            continue;
        r->watch[i] = watch_new(r->arena, why_program(p, i), &r->run.result.steps, r->q.depth + 2);
        watch_attach(r->watch[i], r->machine[i]);
    }
    if (r->q.to && !r->q.at_step && !r->q.has_g)
        r->near = ARENA_ARRAY(r->arena, WhyNear, why_program(p, r->q.machine)->stmts + 1);
    r->engine = p->joint ? engine_app_open(r->arena, p, r->machine) : r->machine[0];
}

void why_run(WhyRun *r, Arena *arena, const Script *s, const ScriptOptions *o, const WhyQuestion *q,
             Engine *(*wrap)(void *context, WhyRun *r, Engine *ref),
             void *context)
{
    memset(r, 0, sizeof *r);
    r->arena = arena;
    r->s = s;
    r->given = o;
    r->q = *q;
    r->o = (ScriptOptions){.max_steps = o->max_steps, .seed = o->seed, .after_step = note_step, .context = r, .is_cancelled = is_question_reached,
                           .setting = o->setting,
                           .settings = o->settings, .requirements = o->requirements, .is_silent = true, .is_compared = true,
                           .ends_at_violation = !q->at_step && !q->has_g && !q->to};
    diags_init(&r->silent, arena);
    r->silent.muted = true;
    r->run = (ScriptRun){.arena = arena, .diags = &r->silent, .s = s, .p = s->program, .engine = &r->engine, .engines = 1, .o = &r->o};
    open_engines(r, wrap, context);
    run_to_the_end(&r->run);
}
