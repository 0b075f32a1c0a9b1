// SPDX-License-Identifier: Apache-2.0
// Runs the scripts of a session's machine, and writes its diagram and its report.
#include <string.h>

#include "compiler/library/library.h"

enum { STEPS_DEFAULT = 1000000 };

// ---- reviews ----

// Returns the review that runs of a machine refer to.  Not to be called in a layer.
static const Report *review_of_runs(SmcSession *s, uint32_t machine)
{
    LibraryBench *b = &s->of.bench[machine];

    if (!b->review) {
        Report *r;
        library_begin_layer(s);
        r = ARENA_NEW(&s->compiler.arena, Report);
        review_begin(&s->compiler, library_compiled(s, machine)->program, r);
        library_keep_layer(s, &b->review_arena);
        b->review = r;
    }
    return b->review;
}

// Begins a review of a compiled machine with the runs done so far, in the current layer.  Its findings are those of smc_compile.
static void begin_review(SmcSession *s, uint32_t machine, Report *r)
{
    s->compiler.diags = s->below.diags;
    review_begin(&s->compiler, library_compiled(s, machine)->program, r);
    r->requirements = library_compiled(s, machine)->requirements;
    r->run = ARENA_ARRAY(&s->compiler.arena, ReportRun, s->of.sources);
    for (uint32_t i = 0; i < s->of.sources; i++)
        if (s->of.run[i].is_done && s->of.machine[i] == machine)
            r->run[r->runs++] = s->of.run[i].run;
}

// ---- runs ----

typedef struct RunRequest {
    uint32_t script, engines;
    uint64_t max_steps;
    bool is_displayed;            // the run is for a report, so it needs no assert
} RunRequest;

typedef struct Tracing {
    SmcSession *s;
    const Program *p;
    const Var **column;
    const char *script;
    Buf *out;                     // NULL: no trace
    const Requirements *requirements;     // NULL: none
} Tracing;

static void trace_step(void *context, const ScriptStep *step)
{
    Tracing *t = context;

    if (t->out)
        script_trace_row(t->out, t->script, step, t->column, t->p->var.n, t->requirements);
}

static bool is_cancelled(void *context) { return library_is_cancelled(((Tracing *)context)->s); }

// Opens the requested engines that are not open yet.  Returns how many `engine` has, or 0 after an error.
static size_t open_engines(SmcSession *s, LibraryBench *b, const Program *p, uint32_t engines, Engine *engine[ENGINE_COUNT])
{
    const char *error = "";
    size_t n = 0;

    for (int i = 0; i < ENGINE_COUNT; i++) {
        if (!(engines & 1u << i))
            continue;
        if (!b->engine[i]) {
            Engine *new;
            library_begin_layer(s);
            new = 1u << i == SMC_ENGINE_REF ? engine_ref_open(&s->compiler.arena, p)
                                            : session_open_vm(&s->compiler, p, s->of.o.opt_level, 1u << i == SMC_ENGINE_VM_SOFT, &error);
            if (!new) {
                library_fail(s, SMC_E_SOURCE, error);
                library_drop_layer(s);
                return 0;
            }
            library_keep_layer(s, &b->engine_arena[i]);
            b->engine[i] = new;
        }
        engine[n++] = b->engine[i];
    }
    return n;
}

static SmcResult result_of_outcome(const SmcSession *s, const LibraryRun *run)
{
    return run->run.result.outcome == SCRIPT_PASSED ? SMC_OK : library_fail(s, SMC_E_FAILED, NULL);
}

static SmcResult run_script(SmcSession *s, const RunRequest *q)
{
    const uint32_t machine = s->of.machine[q->script];
    const CompiledSource *m = library_compiled(s, machine), *ss = library_compiled(s, q->script);
    const Report *review = review_of_runs(s, machine);
    const Source *src = s->of.text[q->script];
    Tracing t = {s, m->scripted, NULL, src->name, NULL, m->requirements};
    const ScriptOptions o = {.max_steps = q->max_steps, .after_step = trace_step, .is_cancelled = is_cancelled, .context = &t,
                             .is_compared = q->is_displayed, .requirements = m->requirements};
    Engine *engine[ENGINE_COUNT];
    size_t n;
    LibraryRun run = {.engines = q->engines, .max_steps = q->max_steps, .is_traced = s->option[SMC_OPTION_TRACE] != 0};

    if ((n = open_engines(s, &s->of.bench[machine], m->scripted, q->engines, engine)) == 0)
        return SMC_E_SOURCE;
    library_begin_layer(s);
    buf_init(&run.report, &s->compiler.arena);
    buf_init(&run.trace, &s->compiler.arena);
    if (run.is_traced) {
        t.out = &run.trace;
        t.column = report_order(&s->compiler.arena, m->scripted);
        script_trace_header(t.out, m->scripted, t.column, m->scripted->var.n, m->requirements);
    }
    review_run_script(&s->compiler, review, m->scripted, src, ss->script, engine, n, &o, &run.run);
    if (run.run.result.outcome == SCRIPT_CANCELLED) {
        library_drop_layer(s);
        return library_fail(s, SMC_E_CANCELLED, NULL);
    }
    script_report(&run.run.result, m->scripted, &run.report);
    library_update_shown(s, &s->of.emitted, q->script, &run.run.diags);        // the last call that can run out of memory
    run.is_done = true;
    run.arena = s->of.run[q->script].arena;
    library_keep_layer(s, &run.arena);
    s->of.run[q->script] = run;
    return result_of_outcome(s, &run);
}

static SmcResult run_if_needed(SmcSession *s, void *argument)
{
    const RunRequest *q = argument;
    const LibraryRun *last = &s->of.run[q->script];

    if (last->is_done && last->engines == q->engines && last->max_steps == q->max_steps &&
        last->is_traced == (s->option[SMC_OPTION_TRACE] != 0))
        return result_of_outcome(s, last);
    return run_script(s, q);
}

SmcResult smc_run(SmcSession *s, uint32_t script, uint32_t engines, uint64_t max_steps)
{
    RunRequest q = {script, engines, max_steps ? max_steps : STEPS_DEFAULT, false};
    const CompiledSource *m, *ss;

    if (!library_is_open(s))
        return SMC_E_HANDLE;
    if (engines == 0 || engines >= 1u << ENGINE_COUNT)
        return library_fail(s, SMC_E_ARGUMENT, NULL);
    if (!s->of.is_compiled)
        return library_fail(s, SMC_E_STATE, NULL);
    if ((ss = library_compiled(s, script)) == NULL || s->of.in.at[s->of.input[script] - 1].kind != FILE_SS)
        return library_fail(s, SMC_E_INDEX, "there is no script of this number");
    if (ss->is_included)
        return library_fail(s, SMC_E_INDEX, "another script includes this one, so it is not a script by itself");
    if ((m = library_compiled(s, s->of.machine[script])) == NULL)
        return library_fail(s, SMC_E_STATE, "there is not exactly one machine, and smc_script_assign has not named one");
    if (!m->scripted || !ss->script)
        return library_fail(s, SMC_E_SOURCE, NULL);
    return library_guard(s, run_if_needed, &q);
}

// ---- the results of a run ----

static const LibraryRun *done_run(const SmcSession *s, uint32_t script)
{
    return library_is_open(s) && script < s->of.sources && s->of.run[script].is_done ? &s->of.run[script] : NULL;
}

int32_t smc_run_outcome(const SmcSession *s, uint32_t script)
{
    const LibraryRun *run = done_run(s, script);

    if (!run)
        return SMC_OUTCOME_NONE;
    switch (run->run.result.outcome) {
    case SCRIPT_PASSED: return SMC_OUTCOME_PASSED;
    case SCRIPT_FAILED: case SCRIPT_NO_DATA: return SMC_OUTCOME_FAILED;
    case SCRIPT_ENDLESS: return SMC_OUTCOME_ENDLESS;
    case SCRIPT_TIME_OVERFLOW: return SMC_OUTCOME_TIME_OVER;
    case SCRIPT_BROKEN: return SMC_OUTCOME_BROKEN;
    case SCRIPT_DIFFERENT: return SMC_OUTCOME_DIFFERENT;
    case SCRIPT_CANCELLED: break;
    }
    return SMC_OUTCOME_NONE;
}

uint64_t smc_run_steps(const SmcSession *s, uint32_t script)
{
    const LibraryRun *run = done_run(s, script);

    return run ? run->run.result.steps : 0;
}

uint64_t smc_run_asserts(const SmcSession *s, uint32_t script)
{
    const LibraryRun *run = done_run(s, script);

    return run ? run->run.result.asserts_passed : 0;
}

// ---- requirements ----

// Returns a requirement of a compiled machine; NULL if no requirement has this number.
static const Requirement *find_requirement(const SmcSession *s, uint32_t machine, uint32_t requirement)
{
    const CompiledSource *m = library_is_open(s) && s->of.is_compiled ? library_compiled(s, machine) : NULL;

    return m && m->requirements && requirement < m->requirements->at.n ? &m->requirements->at.at[requirement] : NULL;
}

uint32_t smc_requirement_count(const SmcSession *s, uint32_t machine)
{
    uint32_t n = 0;

    while (find_requirement(s, machine, n))
        n++;
    return n;
}

const char *smc_requirement_id(const SmcSession *s, uint32_t machine, uint32_t requirement)
{
    const Requirement *r = find_requirement(s, machine, requirement);

    return r ? r->id->text : "";
}

const char *smc_requirement_text(const SmcSession *s, uint32_t machine, uint32_t requirement)
{
    const Requirement *r = find_requirement(s, machine, requirement);

    return r ? r->text->text : "";
}

// Returns what a run has found about a requirement; NULL if no requirement has this number.
static const RequirementRun *find_requirement_run(const SmcSession *s, uint32_t script, uint32_t requirement)
{
    const LibraryRun *run = done_run(s, script);

    return run && run->run.result.requirement && find_requirement(s, s->of.machine[script], requirement) ? &run->run.result.requirement[requirement]
                                                                                                         : NULL;
}

int32_t smc_run_requirement(const SmcSession *s, uint32_t script, uint32_t requirement)
{
    const RequirementRun *r = find_requirement_run(s, script, requirement);

    return !r                  ? SMC_REQUIREMENT_UNJUDGED
           : r->violations > 0 ? SMC_REQUIREMENT_VIOLATED
           : r->undecided      ? SMC_REQUIREMENT_UNDECIDED
           : r->judged > 0     ? SMC_REQUIREMENT_MET
                               : SMC_REQUIREMENT_UNJUDGED;
}

uint64_t smc_run_judged(const SmcSession *s, uint32_t script, uint32_t requirement)
{
    const RequirementRun *r = find_requirement_run(s, script, requirement);

    return r ? r->judged : 0;
}

const char *smc_run_report(const SmcSession *s, uint32_t script)
{
    const LibraryRun *run = done_run(s, script);

    return run ? buf_text(&run->report) : "";
}

const char *smc_run_trace(const SmcSession *s, uint32_t script)
{
    const LibraryRun *run = done_run(s, script);

    return run ? buf_text(&run->trace) : "";
}

// ---- diagrams and reports ----

typedef struct PageRequest {
    uint32_t machine;
    int32_t form;
    Buf out;
} PageRequest;

static SmcResult draw_diagram(SmcSession *s, void *argument)
{
    typedef void Write(const Analysis *a, const DiagramOptions *o, Buf *out);
    static Write *const writer[] = {diagram_write_svg, diagram_write_dot, diagram_write_mermaid};      // by SMC_DIAGRAM_…
    PageRequest *q = argument;
    DiagramCounts counts;
    DiagramOptions o = {.findings = &s->of.shown, .counts = &counts};
    Report r;

    library_begin_layer(s);
    begin_review(s, q->machine, &r);
    review_measure_coverage(&s->compiler, library_compiled(s, q->machine)->scripted, &r);
    counts = report_sum_counts(&r);
    o.counts = r.runs > 0 ? &counts : NULL;
    buf_init(&q->out, &s->compiler.arena);
    writer[q->form](&r.analysis, &o, &q->out);
    library_keep_layer(s, &s->of.page[PAGE_DIAGRAM]);
    return SMC_OK;
}

// Runs the scripts that have not run.
static SmcResult run_missing_scripts(SmcSession *s)
{
    for (uint32_t i = 0; i < s->of.sources; i++) {
        const CompiledSource *ss = library_compiled(s, i);
        const RunRequest q = {i, SMC_ENGINE_VM, STEPS_DEFAULT, true};
        SmcResult r;
        if (!ss || !ss->script || s->of.run[i].is_done)
            continue;
        r = run_script(s, &q);
        if (r != SMC_OK && r != SMC_E_FAILED)
            return r;
    }
    return SMC_OK;
}

static SmcResult write_report(SmcSession *s, void *argument)
{
    typedef void Write(const Doc *d, Buf *out);
    static Write *const writer[] = {doc_write_html, doc_write_text, doc_write_json};      // by SMC_REPORT_…
    PageRequest *q = argument;
    LibraryResults *of = &s->of;
    CompileOptions o = of->o;
    Compiled made = of->made;
    Report r;
    SmcResult result = run_missing_scripts(s);

    if (result != SMC_OK)
        return result;
    library_begin_layer(s);
    o.emit = EMIT_BYTECODE;
    o.names = false;
    o.measure = true;
    memset(&o.limits, 0, sizeof o.limits);
    made.of = arena_copy(&s->compiler.arena, of->made.of, of->in.n * sizeof *made.of);
    for (size_t i = 0; i < of->in.n && !made.image_pins; i++)
        made.image_pins = made.of[i].pins;
    if (!compile_emit(&s->compiler, &of->in, &o, &made)) {
        library_fail(s, SMC_E_SOURCE, s->compiler.diags.list.n ? s->compiler.diags.list.at[0]->text : NULL);
        library_drop_layer(s);
        return SMC_E_SOURCE;
    }
    begin_review(s, q->machine, &r);
    review_measure_coverage(&s->compiler, library_compiled(s, q->machine)->scripted, &r);
    review_add_costs(&s->compiler, &made.of[of->input[q->machine] - 1], made.artefact.at[0].bytes, o.step != 0, &r);
    buf_init(&q->out, &s->compiler.arena);
    writer[q->form](report_build(&r), &q->out);
    library_keep_layer(s, &s->of.page[PAGE_REPORT]);
    return SMC_OK;
}

static SmcResult make_page(SmcSession *s, LibraryWork *work, PageRequest *q, const char **text, uint64_t *size)
{
    const SmcResult r = library_guard(s, work, q);

    if (r != SMC_OK)
        return r;
    *text = buf_text(&q->out);
    *size = q->out.n;
    return SMC_OK;
}

// Checks what smc_diagram and smc_report have in common.
static SmcResult check_page(const SmcSession *s, const PageRequest *q, int32_t last_form, const char **text, const uint64_t *size)
{
    const CompiledSource *m;

    if (!library_is_open(s))
        return SMC_E_HANDLE;
    if (!text || !size || q->form < 0 || q->form > last_form)
        return library_fail(s, SMC_E_ARGUMENT, NULL);
    if (!s->of.is_compiled)
        return library_fail(s, SMC_E_STATE, NULL);
    if ((m = library_compiled(s, q->machine)) == NULL || s->of.in.at[s->of.input[q->machine] - 1].kind != FILE_SM)
        return library_fail(s, SMC_E_INDEX, "there is no machine of this number");
    return m->program ? SMC_OK : library_fail(s, SMC_E_STATE, "the machine has errors");
}

SmcResult smc_diagram(SmcSession *s, uint32_t machine, int32_t form, const char **text, uint64_t *size)
{
    PageRequest q = {machine, form, {0}};
    const SmcResult r = check_page(s, &q, SMC_DIAGRAM_MERMAID, text, size);

    return r == SMC_OK ? make_page(s, draw_diagram, &q, text, size) : r;
}

SmcResult smc_report(SmcSession *s, uint32_t machine, int32_t form, const char **text, uint64_t *size)
{
    PageRequest q = {machine, form, {0}};
    const SmcResult r = check_page(s, &q, SMC_REPORT_JSON, text, size);

    if (r != SMC_OK)
        return r;
    if (s->compiler.diags.errors)
        return library_fail(s, SMC_E_STATE, "the sources have errors");
    if (s->of.o.warnings)
        return library_fail(s, SMC_E_STATE, "set SMC_OPTION_REVIEW before compiling");
    if (library_only_machine(s) != machine)
        return library_fail(s, SMC_E_STATE, "a report is about the only machine of a session");
    return make_page(s, write_report, &q, text, size);
}
