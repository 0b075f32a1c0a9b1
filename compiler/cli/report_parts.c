// SPDX-License-Identifier: Apache-2.0
#include "compiler/cli/report_parts.h"

#include <inttypes.h>

#include "compiler/base/os_signal.h"
#include "compiler/base/path.h"
#include "compiler/cli/fault_lines.h"
#include "compiler/cli/mutate_scripts.h"
#include "compiler/cli/runs.h"
#include "compiler/prove/prove_app.h"
#include "compiler/prove/prove_given.h"
#include "compiler/report/describe.h"
#include "compiler/search/mutant_reach.h"
#include "compiler/whatif/fault_script.h"
#include "compiler/whatif/sweep.h"

enum { SWEEP_POINTS = 21 };   // values of each parameter, before the search for boundaries

// When the parts stop: at a signal, and at the end of the time that the user has given.  Each part may take its share of the time that is left.
typedef struct PartsClock {
    double end, part_end;         // times at which all parts, and the current part, have to end, in seconds; 0: no limit
    uint32_t parts;               // parts that are still to run
} PartsClock;

// Gives the next part an equal share of the time that is left.
static void begin_part(PartsClock *k)
{
    const double now = os_seconds();

    k->part_end = k->end > 0 ? now + (k->end - now) / k->parts : 0;
    k->parts--;
}

// Whether the current part has time left and no signal has asked to stop.
static bool may_go_on(const PartsClock *k)
{
    return !os_signal_waiting() && (k->part_end == 0 || os_seconds() < k->part_end);
}

// Replaces --all by the options of all parts. --scripts and --pairs imply --faults.
void report_parts_choose(Cli *c)
{
    static const OptionId part[] = {OPT_PROVE, OPT_MUTATE, OPT_FAULTS, OPT_SWEEP};

    for (size_t i = 0; i < sizeof part / sizeof *part; i++)
        c->given[part[i]] = c->given[part[i]] || c->given[OPT_ALL];
    c->given[OPT_FAULTS] = c->given[OPT_FAULTS] || c->given[OPT_SCRIPTS] || c->given[OPT_PAIRS];
}

// Records the name of a part of the report that was not completed.
static void add_unfinished(Report *r, const char *part) { vec_push(r->arena, &r->unfinished, part); }

// The scripts that pass, with which the parts compare.
typedef struct PartScripts {
    const Script **script;    // `n` of them
    const uint8_t **ignored;  // by script: ScriptOptions.ignored
    uint32_t n;
    const char *none;         // why no script is left, as a phrase; NULL: n > 0
} PartScripts;

typedef struct PartsContext { Cli *c; Report *r; } PartsContext;

static void add_left_out(void *context, const char *sentence)
{
    const PartsContext *k = context;

    vec_push(k->r->arena, &k->r->left_out, sentence);
    cli_print_note(k->c, TEXT_sentence, sentence);
}

// Lists the scripts that the parts use, and in r->left_out those that fail anyway.
static PartScripts list_scripts(Cli *c, Report *r)
{
    Arena *arena = &c->session.arena;
    PartScripts out = {ARENA_ARRAY(arena, const Script *, r->runs + 1), ARENA_ARRAY(arena, const uint8_t *, r->runs + 1), 0, NULL};
    Baseline b;

    baseline_init(&b, arena, r->requirements);
    for (size_t i = 0; i < r->runs; i++)
        if (baseline_add(&b, r->run[i].name, r->run[i].script, &r->run[i].result)) {
            out.ignored[out.n] = b.run.at[i].ignored;
            out.script[out.n++] = r->run[i].script;
        }
    if (r->left_out.n == 0)
        baseline_list(&b, &(PartsContext){c, r}, add_left_out);
    if (out.n == 0)
        out.none = r->runs == 0 ? "there is no script" : format_in(arena, "every script fails anyway: the first, %s, %s", b.run.at[0].name, b.run.at[0].why);
    return out;
}

// ---- proofs ----

typedef struct ProofProgress { ProgressLine line; const Requirements *what; const PartsClock *clock; } ProofProgress;

static bool proofs_may_go_on(void *context) { return may_go_on(((ProofProgress *)context)->clock); }

// Called before attempts at requirement number `now`; `done`: how many requirements have been decided.
static void show_proofs(void *context, uint32_t done, uint32_t now)
{
    ProofProgress *k = context;

    if (progress_is_due(&k->line) || (k->line.is_shown && done < k->what->at.n))
        progress_show(&k->line, format_in(&k->line.c->session.arena, "proofs: %lu of %lu requirements decided, now %.30s", (unsigned long)done,
                                          (unsigned long)k->what->at.n, done < k->what->at.n ? k->what->at.at[now].id->text : ""));
}

// Records the runs of the scripts, as starting points of searches.  Drops their diagnostics, because the report has already run the scripts.
static void record_scripts(Cli *c, const Report *r, ProveOptions *o)
{
    ProveGiven *given = ARENA_ARRAY(&c->session.arena, ProveGiven, r->runs + 1);
    const Program *p = r->requirements->program;
    Diags dropped;

    diags_init(&dropped, &c->session.arena);
    for (size_t i = 0; i < r->runs; i++)
        if (r->run[i].script)
            prove_record_script(&c->session.arena, &dropped, p, p, r->run[i].script, &given[o->givens++]);
    o->given = given;
}

// Decides the requirements that the machines of an application decide alone.  EXIT_PROBLEM if two of a machine contradict each other, which is
// printed.
static int run_proofs_of_app(Cli *c, Report *r, ProofProgress *k, ProveOptions *o)
{
    ProveApp *a = prove_app_new(r->arena, r->requirements);

    for (size_t m = 0; m < r->members; m++) {
        if (!a->own[m])
            continue;
        if (runs_report_contradiction(c, a->own[m])) {
            cli_print_diagnostics(c);
            return EXIT_PROBLEM;
        }
        k->what = a->own[m];
        prove_app_run(a, m, o);
    }
    r->proofs = prove_app_verdicts(a);
    r->proofs_of_app = a;
    return EXIT_OK;
}

// Decides the requirements.  EXIT_PROBLEM if two of them contradict each other, which is printed.
static int run_proofs(Cli *c, Report *r, const CompileOptions *o, const PartsClock *clock)
{
    ProofProgress k = {{c, 0, false}, r->requirements, clock};
    ProveOptions options = {.delta_t = o->step, .progress = show_proofs, .go_on = proofs_may_go_on, .context = &k};
    unsigned long interrupted = 0;

    if (!r->requirements)
        return EXIT_OK;
    if (r->members) {
        if (run_proofs_of_app(c, r, &k, &options) != EXIT_OK)
            return EXIT_PROBLEM;
    } else {
        if (runs_report_contradiction(c, r->requirements)) {
            cli_print_diagnostics(c);
            return EXIT_PROBLEM;
        }
        record_scripts(c, r, &options);
        r->proofs = prove_run(r->arena, r->requirements, &options);
    }
    progress_end(&k.line);
    for (uint32_t i = 0; i < r->proofs->n; i++)
        interrupted += r->proofs->of[i].verdict == PROVE_INTERRUPTED && !(r->proofs_of_app && r->proofs_of_app->why[i]);
    if (interrupted)
        add_unfinished(r, format_in(r->arena, "proofs of %lu of %lu requirements", interrupted, (unsigned long)r->proofs->n));
    return EXIT_OK;
}

// ---- changes of the machine ----

// Notes what is missing: changes that were not tried, or the search among those that no script notices.  of_machine: " of drogue", or "".
static void add_unfinished_mutation(Report *r, const Mutation *u, const char *of_machine)
{
    const MutationScore score = mutation_score(u);
    const unsigned long waiting = score.of[MUTANT_WAITING];

    if (waiting)
        add_unfinished(r, format_in(r->arena, "changes%s that no script notices (%lu of %lu tried)", of_machine, score.all - waiting, score.all));
    else
        add_unfinished(r, format_in(r->arena, "the search for changes%s that make no difference (all %lu were tried)", of_machine, score.all));
}

// Changes one machine, and stores the result in its report.
static void mutate_machine(Cli *c, Report *r, size_t member, const Program *p, const PartScripts *s, const PartsClock *clock)
{
    Mutation *u = mutation_new(&c->session.arena, p, member, s->script, s->n, r->requirements, MUTATE_STEPS_MOST);
    ProgressLine k = {c, 0, false};
    bool goes_on;

    while ((goes_on = may_go_on(clock)) && mutation_run_next(u))
        mutate_show_progress(u, &k);
    while (goes_on && (goes_on = may_go_on(clock)) && mutation_search_next(u, MUTATE_SEARCH_STEPS))
        mutate_show_progress(u, &k);
    while (goes_on && (goes_on = may_go_on(clock)) && mutant_reach_next(u, MUTANT_REACH_EFFORT, MUTATE_SEARCH_STEPS))
        mutate_show_progress(u, &k);
    progress_end(&k);
    if (!goes_on)
        add_unfinished_mutation(r, u, r->members ? format_in(r->arena, " of %s", engine_machine_name(p, member)) : "");
    mutation_end(u);
    (r->members ? &r->member[member] : r)->mutation = u;
}

static void run_mutants(Cli *c, Report *r, const Program *p, const PartsClock *clock)
{
    const PartScripts s = list_scripts(c, r);

    r->not_mutated = s.none;
    if (r->not_mutated) {
        r->not_mutated = r->runs ? r->not_mutated : "there is no script that could notice it";
        cli_print_note(c, TEXT_report_not_mutated, r->not_mutated);
        return;
    }
    for (size_t i = 0; i < r->members; i++)
        r->member[i].left_out = r->left_out;
    for (size_t i = 0; i < engine_machines(p); i++)
        mutate_machine(c, r, i, p, &s, clock);
}

// ---- faults ----

// Returns the name, the words and the severity of each outcome of a fault, by FaultOutcome.
static const ReportOutcome *list_outcomes(Arena *arena)
{
    ReportOutcome *out = ARENA_ARRAY(arena, ReportOutcome, FAULT_OUTCOME_COUNT);

    for (int i = 0; i < FAULT_OUTCOME_COUNT; i++)
        out[i] = (ReportOutcome){fault_outcome_name[i], fault_outcome_words[i],
                                 i == FAULT_HAS_VIOLATED ? REPORT_VIOLATION : i <= FAULT_HAS_ABORTED ? REPORT_HARMLESS : REPORT_OPEN};
    return out;
}

// Returns the number, from 1, of the line about the single fault of this kind in this input with this outcome; 0: none.
static uint32_t find_line(const FaultLines *l, uint32_t input, FaultKind kind, FaultOutcome outcome)
{
    for (uint32_t i = 0; i < l->at.n; i++) {
        const FaultResult *x = l->at.at[i].r;
        if (x->faults == 1 && x->fault[0].input == input && x->fault[0].kind == kind && x->outcome == outcome)
            return i + 1;
    }
    return 0;
}

// Returns what the machine reads with a kind of fault, with its size.
static const char *describe_kind(Arena *arena, const FaultSizes *sizes, FaultKind kind)
{
    switch ((int)kind) {
    case FAULT_BELOW: return format_in(arena, "the true value less %g %% of the range", 100 * sizes->offset);
    case FAULT_ABOVE: return format_in(arena, "the true value and %g %% of the range", 100 * sizes->offset);
    case FAULT_NOISY: return format_in(arena, "the true value and a random number with a standard deviation of %g %% of the range",
                                       100 * sizes->noise);
    case FAULT_LATE: return format_in(arena, "the true value of %lu steps before", (unsigned long)sizes->late);
    case FAULT_DROPPED: return format_in(arena, "the last reading before the fault, for %lu steps", (unsigned long)sizes->dropped);
    default: return fault_kind_sentence[kind];
    }
}

// Fills the matrix with the kinds that some input can have.
static void fill_matrix(Arena *arena, const FaultLines *l, ReportFaults *out)
{
    const Faults *f = l->f;
    bool is_used[FAULT_KIND_COUNT] = {false};

    for (int k = 0; k < FAULT_KIND_COUNT; k++) {
        for (uint32_t i = 0; i < f->input.n; i++)
            is_used[k] |= fault_applies(&f->input.at[i], (FaultKind)k);
        if (is_used[k])
            vec_push(arena, &out->kind, ((ReportFaultKind){fault_kind_name[k], describe_kind(arena, &f->options.sizes, (FaultKind)k)}));
    }
    for (uint32_t i = 0; i < f->input.n; i++) {
        vec_push(arena, &out->input, f->input.at[i].var->report_name->text);
        for (int k = 0; k < FAULT_KIND_COUNT; k++) {
            const FaultOutcome worst = faults_find_worst(f, i, (FaultKind)k);
            Buf effect;
            buf_init(&effect, arena);
            fault_write_worst(f, i, (FaultKind)k, &effect);
            if (is_used[k])
                vec_push(arena, &out->cell, ((ReportFaultCell){fault_applies(&f->input.at[i], (FaultKind)k), worst,
                                                               find_line(l, i, (FaultKind)k, worst), buf_text(&effect)}));
        }
    }
}

// Returns what one of the fault_write_… functions writes about a result.
static const char *fault_text(Arena *arena, const Faults *f, const FaultResult *x, void (*write)(const Faults *f, const FaultResult *r, Buf *out))
{
    Buf b;

    buf_init(&b, arena);
    write(f, x, &b);
    return buf_text(&b);
}

static void fill_lines(Arena *arena, const FaultLines *l, ReportFaults *out)
{
    for (uint32_t i = 0; i < l->at.n; i++) {
        const FaultLine *line = &l->at.at[i];
        const ReportFaultLine to = {line->r->faults > 1, line->r->outcome, fault_text(arena, l->f, line->r, fault_write_name),
                                    fault_text(arena, l->f, line->r, fault_write_trigger), fault_text(arena, l->f, line->r, fault_write_effect), line->others,
                                    line->script ? path_file_name(line->script) : NULL};
        vec_push(arena, &out->line, to);
    }
}

// Stores, for each requirement, how many faults violate it and the number of the first line about one.
static void fill_requirements(Arena *arena, const FaultLines *l, const Requirements *rq, ReportFaults *out)
{
    for (uint32_t q = 0; rq && q < rq->at.n; q++) {
        ReportFaultsOf of = {0, 0};
        for (uint32_t i = 0; i < l->f->result.n; i++)
            of.faults += l->f->result.at[i].violated == q + 1;
        for (uint32_t i = l->at.n; i-- > 0; )
            of.line = l->at.at[i].r->violated == q + 1 ? i + 1 : of.line;
        vec_push(arena, &out->of, of);
    }
}

static void fill_faults(Arena *arena, const FaultLines *l, ReportFaults *out)
{
    const Faults *f = l->f;
    unsigned long effects = 0;
    Buf ranges;

    for (uint32_t i = 0; i < f->result.n; i++)
        effects += f->result.at[i].faults == 1 && f->result.at[i].outcome != FAULT_HAS_NONE;
    out->summary = format_in(arena, "%lu of %lu faults have an effect: %s, %s in %s.", effects, (unsigned long)(f->faults - f->pairs),
                             describe_count(arena, f->input.n, "input", "inputs"), describe_count(arena, f->trigger.n, "trigger", "triggers"),
                             describe_count(arena, f->scripts, "script", "scripts"));
    if (f->options.pairs)
        out->summary = format_in(arena, "%s Of %lu pairs of faults, %lu are worse than each fault alone.", out->summary, (unsigned long)f->pairs,
                                 (unsigned long)f->pairs_worse);
    fill_matrix(arena, l, out);
    fill_lines(arena, l, out);
    fill_requirements(arena, l, f->options.requirements, out);
    for (uint32_t i = 0; i < f->input.n; i++) {
        buf_init(&ranges, arena);
        if (fault_write_range(&f->input.at[i], &ranges))
            vec_push(arena, &out->note, format_in(arena, "%s.", buf_text(&ranges)));
    }
    out->is_cut = f->is_cut;
}

static int run_faults(Cli *c, Report *r, const Program *p, const PartsClock *clock)
{
    FaultOptions o = {.pairs = c->given[OPT_PAIRS], .max_steps = MUTATE_STEPS_MOST, .requirements = r->requirements};
    ReportFaults *out = ARENA_NEW(&c->session.arena, ReportFaults);
    const PartScripts s = list_scripts(c, r);
    FaultLines l = {.c = c, .p = p};
    ProgressLine k = {c, 0, false};
    bool goes_on;
    int code;

    r->faults = out;
    out->outcome = list_outcomes(&c->session.arena);
    out->outcomes = FAULT_OUTCOME_COUNT;
    out->not_run = s.none;
    if (out->not_run) {
        cli_print_note(c, TEXT_report_no_faults, out->not_run);
        return EXIT_OK;
    }
    fault_lines_set_defaults(&o);
    l.f = faults_new(&c->session.arena, p, s.script, s.n, &o);
    while ((goes_on = may_go_on(clock)) && faults_run_next(l.f))
        fault_lines_show_progress(l.f, &k);
    progress_end(&k);
    if (!goes_on)
        add_unfinished(r, "faults of sensors");
    fault_lines_collect(&l, false);
    code = fault_lines_write_scripts(&l);
    fill_faults(&c->session.arena, &l, out);
    out->is_cut |= !goes_on;
    out->has_scripts = l.scripts > 0;
    faults_end(l.f);
    return code;
}

// ---- other values of parameters ----

static const char *value_text(Arena *arena, const Sweep *s, double x)
{
    Buf b;

    buf_init(&b, arena);
    sweep_write_value(&s->axis[0], x, &b);
    return buf_text(&b);
}

// Returns the text that the author of a check (a requirement or an assert) gave it; "": none.
static const char *check_meaning(const SweepCheck *c)
{
    if (c->requirement)
        return c->requirement->text->text;
    return c->assert && c->assert->remark && c->assert->remark->text ? c->assert->remark->text->text : "";
}

// Returns the scripts that keep their own value of the parameter, as a list; "": none.
static const char *list_kept(Arena *arena, const Sweep *s)
{
    Buf out;

    buf_init(&out, arena);
    for (uint32_t i = 0; i < s->scripts; i++)
        if (!sweep_takes_part(s, 0, i))
            buf_printf(&out, "%s%s", out.n ? ", " : "", source_short_name(s->script[i]->src));
    return buf_text(&out);
}

// Stores the results along the parameter. Successive values at which the same checks fail become one span.
static void fill_spans(Arena *arena, const Sweep *s, ReportSweepOf *out)
{
    const SweepLine *l = &s->line[0];

    for (uint32_t first = 0, last; first < l->at.n; first = last + 1) {
        Buf fails;
        last = sweep_find_last_alike(s, 0, first);
        buf_init(&fails, arena);
        sweep_write_failing(s, &l->at.at[first], ", ", &fails);
        vec_push(arena, &out->span, ((ReportSweepSpan){value_text(arena, s, l->at.at[first].value[0]), value_text(arena, s, l->at.at[last].value[0]), buf_text(&fails)}));
    }
    for (uint32_t i = 0; i < s->boundary.n; i++) {
        const SweepBoundary *b = &s->boundary.at[i];
        Buf name;
        buf_init(&name, arena);
        sweep_write_check(s, b->check, &name);
        vec_push(arena, &out->boundary, ((ReportSweepBoundary){buf_text(&name), check_meaning(&s->check.at[b->check]), value_text(arena, s, b->passes), value_text(arena, s, b->fails)}));
    }
}

static ReportSweepOf fill_sweep(Arena *arena, const Sweep *s)
{
    const SweepAxis *a = &s->axis[0];
    ReportSweepOf out = {.parameter = a->parameter->name->text, .now = value_text(arena, s, a->current), .from = value_text(arena, s, a->lo),
                         .to = value_text(arena, s, a->hi), .below = "", .above = "", .left_out = list_kept(arena, s), .has_scripts = !sweep_is_alone(s, 0),
                         .fails_now = sweep_fails_now(s, 0)};
    Buf below, above, svg;
    double fails;

    if (!out.has_scripts)
        return out;
    buf_init(&below, arena);
    buf_init(&above, arena);
    buf_init(&svg, arena);
    if (!out.fails_now) {
        sweep_write_side(s, 0, false, &below);
        sweep_write_side(s, 0, true, &above);
    }
    out.below = buf_text(&below);
    out.above = buf_text(&above);
    for (int up = 0; up <= 1; up++)
        if (sweep_find_margin(s, 0, up != 0, &fails)) {
            out.has_margin = true;
            out.is_requirement |= s->check.at[sweep_find_limit(s, 0, fails)].requirement != NULL;
        }
    fill_spans(arena, s, &out);
    sweep_write_svg(arena, s, &svg);
    out.svg = buf_text(&svg);
    return out;
}

// Sweeps each parameter over its range.
static void run_sweeps(Cli *c, Report *r, const Program *p, const PartsClock *clock)
{
    Arena *arena = &c->session.arena;
    ReportSweep *out = ARENA_NEW(arena, ReportSweep);
    const PartScripts good = list_scripts(c, r);
    ProgressLine k = {c, 0, false};
    bool goes_on = true;

    r->sweep = out;
    out->not_run = good.none;
    if (out->not_run) {
        cli_print_note(c, TEXT_report_no_sweep, out->not_run);
        return;
    }
    for (size_t i = 0; i < p->var.n; i++) {
        const Var *v = p->var.at[i];
        Sweep *s;
        if (v->kind != VAR_LOCAL || !v->parameter || !(v->parameter->lo < v->parameter->hi))
            continue;
        if (!goes_on) {
            vec_push(arena, &out->not_swept, v->name->text);
            continue;
        }
        s = sweep_new(arena, p, good.script, good.n, &(SweepOptions){.axis = {{.parameter = v, .lo = v->parameter->lo, .hi = v->parameter->hi, .n = SWEEP_POINTS}},
                                                                           .axes = 1, .max_steps = MUTATE_STEPS_MOST, .requirements = r->requirements,
                                                                           .ignored = good.ignored});
        while ((goes_on = may_go_on(clock)) && sweep_run_next(s))
            if (progress_is_due(&k))
                progress_show(&k, format_in(arena, "sweep of '%.40s': %lu runs", v->name->text, (unsigned long)s->runs));
        if (goes_on)
            vec_push(arena, &out->of, fill_sweep(arena, s));
        else
            vec_push(arena, &out->not_swept, v->name->text);
        sweep_end(s);
    }
    progress_end(&k);
    if (!goes_on)
        add_unfinished(r, format_in(arena, "margins of %lu of %lu parameters", (unsigned long)out->not_swept.n,
                                    (unsigned long)(out->not_swept.n + out->of.n)));
}

// Runs the requested parts of the report. seconds: the time for all of them together; 0: no limit.
int report_parts_run(Cli *c, Report *r, const Program *p, const CompileOptions *o, double seconds)
{
    static const OptionId part[] = {OPT_PROVE, OPT_MUTATE, OPT_FAULTS, OPT_SWEEP};
    PartsClock clock = {seconds > 0 ? os_seconds() + seconds : 0, 0, 0};
    int code = EXIT_OK;

    for (size_t i = 0; i < sizeof part / sizeof *part; i++)
        clock.parts += c->given[part[i]];
    // Parts that usually end early come first, and leave the rest of their share of the time to the others.
    if (c->given[OPT_SWEEP]) {
        begin_part(&clock);
        run_sweeps(c, r, p, &clock);
    }
    if (c->given[OPT_MUTATE]) {
        begin_part(&clock);
        run_mutants(c, r, p, &clock);
    }
    if (c->given[OPT_FAULTS]) {
        begin_part(&clock);
        code = run_faults(c, r, p, &clock);
    }
    if (c->given[OPT_PROVE] && code == EXIT_OK) {
        begin_part(&clock);
        code = run_proofs(c, r, o, &clock);
    }
    return code;
}
