// SPDX-License-Identifier: Apache-2.0
// The verdicts on top of the page: one line for each section that judges the machine, with a link to it.
#include <inttypes.h>
#include <string.h>

#include "compiler/prove/prove_text.h"
#include "compiler/report/describe.h"
#include "compiler/report/page.h"
#include "compiler/report/page_text.h"

static const DocColumn columns[] = {{"section", "Section"}, {"verdict", "Verdict"}, {"details", "Details"}};

typedef enum Verdict { VERDICT_GOOD, VERDICT_OPEN, VERDICT_BAD, VERDICT_FACT } Verdict;      // FACT: a number without a judgement

// Returns the title of a verdict, which names the machine of an application.
static const char *title_of(const Report *r, const char *title)
{
    return r->of ? format_in(r->arena, "%s: %s", r->of->name->text, title) : title;
}

static void add_verdict(DocTable *t, const char *id, const char *title, Verdict v, const char *details)
{
    static const char *const tone[] = {"good", "note", "bad", NULL}, *const word[] = {"passed", "open", "failed", ""};

    doc_add_section_cell(t, title, id);
    doc_add_badge_cell(t, word[v], tone[v]);
    doc_add_plain_cell(t, details);
}

// Appends "3 met", unless n is 0.
static void add_count(Buf *out, size_t n, const char *what)
{
    if (n)
        buf_printf(out, "%s%lu %s", out->n ? ", " : "", (unsigned long)n, what);
}

// Verdict on requirements in scripts: failed when one is violated, open when one is undecided or was never judged.
static void add_requirements(const Report *r, DocTable *t)
{
    const size_t n = r->requirements ? r->requirements->at.n : 0;
    RequirementTotal *total = ARENA_ARRAY(r->arena, RequirementTotal, n);
    unsigned long violated = 0, undecided = 0, met = 0, unjudged = 0;
    Buf out;

    if (!r->requirements)
        return;
    for (size_t i = 0; i < r->runs; i++)
        if (r->run[i].script)
            requirement_add_run(total, r->requirements, &r->run[i].result);
    for (size_t i = 0; i < n; i++) {
        violated += total[i].violated > 0;
        undecided += !total[i].violated && total[i].undecided;
        met += !total[i].violated && !total[i].undecided && total[i].judged;
        unjudged += !total[i].violated && !total[i].undecided && !total[i].judged;
    }
    buf_init(&out, r->arena);
    add_count(&out, violated, "violated");
    add_count(&out, undecided, "undecided");
    add_count(&out, unjudged, "untested");
    add_count(&out, met, "met in all scripts");
    add_verdict(t, "requirements", r->proofs ? "Requirements in scripts" : "Requirements", violated ? VERDICT_BAD : undecided || unjudged ? VERDICT_OPEN : VERDICT_GOOD, buf_text(&out));
}

static void add_proofs(const Report *r, DocTable *t)
{
    unsigned long of[PROVE_VERDICTS] = {0};
    Buf out;

    if (!r->proofs)
        return;
    for (uint32_t i = 0; i < r->proofs->n; i++)
        of[r->proofs->of[i].verdict]++;
    buf_init(&out, r->arena);
    for (int v = PROVE_VERDICTS - 1; v >= PROVE_PROVED; v--)
        add_count(&out, of[v], prove_verdict_words((ProveVerdict)v));
    add_verdict(t, "proofs", "Proofs", of[PROVE_VIOLATED] ? VERDICT_BAD : of[PROVE_PROVED] == r->proofs->n ? VERDICT_GOOD : VERDICT_OPEN, buf_text(&out));
}

static void add_findings(const Report *r, DocTable *t)
{
    const FindingCount n = report_count_findings(r);
    Buf out;

    buf_init(&out, r->arena);
    add_count(&out, n.open, "open");
    add_count(&out, n.allowed, "allowed");
    if (r->members && !out.n)             // the machines have rows of their own
        return;
    add_verdict(t, report_section_of(r, "findings"), title_of(r, "Findings"), n.open ? VERDICT_OPEN : VERDICT_GOOD,
                out.n ? buf_text(&out) : "none");
}

static void add_scripts(const Report *r, DocTable *t)
{
    unsigned long passed = 0;

    for (size_t i = 0; i < r->runs; i++)
        passed += r->run[i].script && r->run[i].result.outcome == SCRIPT_PASSED;
    add_verdict(t, "scripts", "Scripts", r->runs == 0 ? VERDICT_OPEN : passed < r->runs ? VERDICT_BAD : VERDICT_GOOD,
                r->runs ? format_in(r->arena, "%lu of %lu passed", passed, (unsigned long)r->runs) : "none were run");
}

static void add_coverage(const Report *r, DocTable *t)
{
    unsigned long covered = 0, possible = 0;
    Buf details;

    if (!r->cover)
        return;
    for (int k = 0; k <= COVER_PARAMETER; k++) {
        const CoverTotal of = cover_total(r->cover, (CoverKind)k);
        covered += of.covered;
        possible += of.possible;
    }
    buf_init(&details, r->arena);
    buf_printf(&details, "%lu of %lu places (", covered, possible);
    buf_percent(&details, covered, possible, 0);
    buf_str(&details, " %)");
    add_verdict(t, report_section_of(r, "scripts"), title_of(r, "Coverage"), covered < possible ? VERDICT_OPEN : VERDICT_GOOD, buf_text(&details));
}

// Adds the verdict on a part that compares with scripts.  What fails anyway is not in it, so it cannot be good then.
static void add_part_verdict(const Report *r, DocTable *t, const char *id, const char *title, Verdict v, const char *details)
{
    if (r->left_out.n)
        details = format_in(r->arena, "%s; without what fails anyway", details);
    add_verdict(t, id, title, r->left_out.n && v == VERDICT_GOOD ? VERDICT_OPEN : v, details);
}

static void add_mutation(const Report *r, DocTable *t)
{
    MutationScore s;
    Buf details;

    if (r->not_mutated)
        add_verdict(t, "mutation", "Changes that scripts notice", VERDICT_BAD, format_in(r->arena, "not tried, because %s", r->not_mutated));
    if (!r->mutation)
        return;
    s = mutation_score(r->mutation);
    buf_init(&details, r->arena);
    if (s.noticeable || s.of[MUTANT_WAITING] == 0) {
        buf_percent(&details, s.of[MUTANT_NOTICED], s.noticeable, 1);
        buf_printf(&details, " %% of %lu", s.noticeable);
    }
    if (s.of[MUTANT_WAITING])
        buf_printf(&details, "%sonly %lu of %lu were tried", details.n ? "; " : "", s.all - s.of[MUTANT_WAITING], s.all);
    add_part_verdict(r, t, report_section_of(r, "mutation"), title_of(r, "Changes that scripts notice"),
                     s.of[MUTANT_NOTICED] < s.noticeable || s.of[MUTANT_WAITING] ? VERDICT_OPEN : VERDICT_GOOD,
                     buf_text(&details));
}

static void add_faults(const Report *r, DocTable *t)
{
    const ReportFaults *f = r->faults;
    ReportDanger worst = REPORT_HARMLESS;
    Buf out;

    if (!f)
        return;
    if (f->not_run) {
        add_verdict(t, "faults", "Faults of sensors", VERDICT_OPEN, format_in(r->arena, "not tried, because %s", f->not_run));
        return;
    }
    buf_init(&out, r->arena);
    for (uint32_t o = f->outcomes; o-- > 0; ) {
        size_t n = 0;
        for (uint32_t i = 0; i < f->cell.n; i++)
            n += f->cell.at[i].applies && f->cell.at[i].outcome == o;
        add_count(&out, n, o ? f->outcome[o].name : f->is_cut ? "without an effect so far" : "without effect");
        if (n && f->outcome[o].danger > worst)
            worst = f->outcome[o].danger;
    }
    for (uint32_t i = 0; i < f->line.n; i++)
        if (f->line.at[i].is_pair && f->outcome[f->line.at[i].outcome].danger > worst)
            worst = f->outcome[f->line.at[i].outcome].danger;
    add_part_verdict(r, t, "faults", "Faults of sensors",
                     worst == REPORT_VIOLATION ? VERDICT_BAD : worst == REPORT_OPEN || f->is_cut || !r->requirements ? VERDICT_OPEN : VERDICT_GOOD,
                     f->input.n ? format_in(r->arena, "of input and kind: %s", buf_text(&out)) : "the machine has no input");
}

// Verdict on parameters: failed when a check fails at the present value, open when no check depends on some parameter.
static void add_sweep(const Report *r, DocTable *t)
{
    unsigned long failing = 0, limited = 0, unchanged = 0, all;
    Buf out;

    if (!r->sweep)
        return;
    if (r->sweep->not_run) {
        add_verdict(t, "sweep", "Parameters", VERDICT_OPEN, format_in(r->arena, "not changed, because %s", r->sweep->not_run));
        return;
    }
    all = r->sweep->of.n + r->sweep->not_swept.n;
    for (uint32_t i = 0; i < r->sweep->of.n; i++) {
        failing += r->sweep->of.at[i].fails_now;
        limited += !r->sweep->of.at[i].fails_now && r->sweep->of.at[i].has_margin;
        unchanged += !r->sweep->of.at[i].has_scripts;
    }
    buf_init(&out, r->arena);
    add_count(&out, failing, "fail now");
    add_count(&out, limited, "with a known margin");
    add_count(&out, r->sweep->of.n - failing - limited - unchanged, "whose value nothing notices");
    add_count(&out, unchanged, "that all scripts set themselves");
    add_count(&out, r->sweep->not_swept.n, "not known: stopped before");
    add_part_verdict(r, t, "sweep", "Parameters", failing ? VERDICT_BAD : all == 0 ? VERDICT_FACT : limited < all ? VERDICT_OPEN : VERDICT_GOOD,
                out.n ? buf_text(&out) : "none can be set");
}

// Names what the page does not contain because it was not requested.
static void add_parts_left_out(const Report *r, Doc *d)
{
    Buf out;

    buf_init(&out, r->arena);
    buf_str(&out, r->requirements && !r->proofs ? ", proofs of the requirements (`--prove`)" : "");
    buf_str(&out, !(r->members ? r->member : r)->mutation && !r->not_mutated ? ", changes that no script notices (`--mutate`)" : "");
    buf_str(&out, !r->faults ? ", faults of sensors (`--faults`)" : "");
    buf_str(&out, !r->sweep ? ", margins of parameters (`--sweep`)" : "");
    if (out.n)
        doc_add_paragraph(d, format_in(r->arena, "Not examined: %s. `smc report --all` adds them.", buf_text(&out) + 2));
    if (r->unfinished.n == 0)
        return;
    buf_init(&out, r->arena);
    for (size_t i = 0; i < r->unfinished.n; i++)
        buf_printf(&out, "%s%s", describe_separator(i, r->unfinished.n), r->unfinished.at[i]);
    doc_add_plain(d, format_in(r->arena, "Stopped before it was complete: %s.", buf_text(&out)));
}

// ---- what blocks ----

static const DocColumn blocker_columns[] = {{"what", "What speaks against it"}, {"how", "How it is known"}};
enum { BLOCKERS_MOST = 30 };  // rows; the sections have the rest

typedef struct Blockers {
    Doc *d;
    DocTable *t;                  // NULL: there is none yet
    size_t n;
} Blockers;

// Adds a row to the table of failures: what fails, and how. Rows beyond BLOCKERS_MOST are only counted.
static void add_blocker(Blockers *b, const char *what, const char *how)
{
    if (++b->n > BLOCKERS_MOST)
        return;
    if (!b->t)
        b->t = DOC_ADD_TABLE(b->d, "blockers", blocker_columns);
    doc_add_plain_cell(b->t, what);
    doc_add_plain_cell(b->t, how);
}

// Returns where a requirement is violated first: by a script, or else by a run that a search has found; NULL: nowhere.
static const char *find_violation(const Report *r, uint32_t requirement)
{
    const ReportRun *first = NULL;
    unsigned long scripts = 0;
    uint64_t step;

    for (size_t i = r->runs; i-- > 0; )
        if (r->run[i].script && r->run[i].result.requirement && r->run[i].result.requirement[requirement].violations) {
            first = &r->run[i];
            scripts++;
        }
    if (first) {
        step = first->result.requirement[requirement].first_step;
        if (scripts == 1)
            return format_in(r->arena, "%s violates it in step %" PRIu64, first->name, step);
        return format_in(r->arena, "%lu scripts violate it, first %s in step %" PRIu64, scripts, first->name, step);
    }
    if (r->proofs && r->proofs->of[requirement].verdict == PROVE_VIOLATED)
        return "a run that violates it was found (Proofs)";
    return NULL;
}

// Returns the number of faults that violate the requirement.
static unsigned long count_faults(const Report *r, uint32_t requirement)
{
    return r->faults && requirement < r->faults->of.n ? r->faults->of.at[requirement].faults : 0;
}

// Whether a script fails for a reason other than a violated requirement, which has a row of its own.
static bool fails_by_itself(const ReportRun *run)
{
    return !run->script || (run->result.outcome != SCRIPT_PASSED && !(run->result.is_violated && script_has_stopped(&run->result)));
}

// Adds a row for the open findings, which names their codes, each once.
static void add_open_findings(const Report *r, Blockers *b)
{
    const size_t n = report_count_findings(r).open;
    Buf codes;

    buf_init(&codes, r->arena);
    for (size_t i = 0; i < n; i++) {
        const char *code = diag_info[r->analysis.diags->list.at[i]->code].id;
        if (!codes.n || !strstr(buf_text(&codes), code))
            buf_printf(&codes, "%s%s", codes.n ? ", " : "", code);
    }
    if (n)
        add_blocker(b, title_of(r, n == 1 ? "1 open finding" : format_in(r->arena, "%lu open findings", (unsigned long)n)),
                    format_in(r->arena, "%s (%s)", buf_text(&codes), title_of(r, "Findings")));
    for (size_t i = 0; i < r->members; i++)
        add_open_findings(&r->member[i], b);
}

// Adds a row for each parameter that can have any value without a script noticing it.
static void add_unnoticed_parameters(const Report *r, Blockers *b)
{
    for (uint32_t i = 0; r->sweep && i < r->sweep->of.n; i++) {
        const ReportSweepOf *of = &r->sweep->of.at[i];
        if (of->has_scripts && !of->fails_now && !of->has_margin)
            add_blocker(b, format_in(r->arena, "parameter %s", of->parameter), "no script notices its value (Parameters at other values)");
    }
}

// Lists what the page shows to be wrong: scripts that fail, requirements that a run violates, findings, and values that nothing notices.
static void add_blockers(const Report *r, Doc *d)
{
    Blockers b = {d, NULL, 0};

    for (size_t i = 0; i < r->runs; i++)
        if (fails_by_itself(&r->run[i]))
            add_blocker(&b, format_in(r->arena, "script %s", r->run[i].name), r->run[i].script ? "it fails (Scripts)" : "it does not compile (Scripts)");
    for (uint32_t i = 0; r->requirements && i < r->requirements->at.n; i++) {
        const Requirement *what = &r->requirements->at.at[i];
        const char *how = find_violation(r, i);
        if (!how && count_faults(r, i))
            how = format_in(r->arena, "%lu faults of sensors violate it (What breaks it)", count_faults(r, i));
        if (how)
            add_blocker(&b, format_in(r->arena, "%s: %s", what->id->text, what->text->text), how);
    }
    add_open_findings(r, &b);
    add_unnoticed_parameters(r, &b);
    if (b.n > BLOCKERS_MOST)
        doc_add_plain(d, format_in(r->arena, "And %lu more: see the sections.", (unsigned long)(b.n - BLOCKERS_MOST)));
}

static void add_longest_step(const Report *r, DocTable *t)
{
    add_verdict(t, report_section_of(r, "cost"), title_of(r, "Longest step"), VERDICT_FACT,
                format_in(r->arena, "%lu instructions, in %s", (unsigned long)r->cost.worst,
                          r->analysis.p->state.at[r->cost.worst_state - 1]->name->text));
}

void report_add_verdicts(Report *r, Doc *d)
{
    DocTable *t = DOC_ADD_TABLE(d, "verdicts", columns);

    t->narrow = true;
    add_requirements(r, t);
    add_proofs(r, t);
    add_findings(r, t);
    for (size_t i = 0; i < r->members; i++)
        add_findings(&r->member[i], t);
    add_scripts(r, t);
    for (size_t i = 0; i < r->members; i++)
        add_coverage(&r->member[i], t);
    add_coverage(r, t);
    for (size_t i = 0; i < r->members; i++)
        add_mutation(&r->member[i], t);
    add_mutation(r, t);
    add_faults(r, t);
    add_sweep(r, t);
    for (size_t i = 0; i < r->members; i++)
        add_longest_step(&r->member[i], t);
    if (!r->members)
        add_longest_step(r, t);
    doc_add_paragraph(d, TEXT_VERDICTS);
    add_parts_left_out(r, d);
    add_blockers(r, d);
}
