// SPDX-License-Identifier: Apache-2.0
// smc test --traceability: which requirements the machine and its scripts belong to, as a file; and how many requirements are tested.
#include "compiler/cli/test.h"
#include "compiler/prove/prove_given.h"
#include "compiler/prove/prove_text.h"

static bool is_requested(const Cli *c)
{
    double unused;

    return c->given[OPT_TRACEABILITY] || test_coverage_demands_requirements(c, &unused);
}

int test_traceability_check_options(Cli *c, const char *machine, size_t requirements)
{
    double unused;

    if (c->given[OPT_PROVE] && !c->given[OPT_TRACEABILITY])
        return cli_usage_error(c, TEXT_proof_without_matrix);
    if (c->given[OPT_TRACEABILITY] && !machine)
        return cli_usage_error(c, TEXT_traceability_of_machine);
    if (c->given[OPT_TRACEABILITY] && has_suffix(machine, ".app"))
        return cli_usage_error(c, TEXT_traceability_of_app, machine);
    if (test_coverage_demands_requirements(c, &unused) && requirements == 0)
        return cli_usage_error(c, TEXT_demand_of_requirements);
    return EXIT_OK;
}

// Returns an empty matrix; NULL if no option asks for traceability.
Traceability *test_traceability_begin(TestRun *t, const Program *p, const Requirements *what)
{
    return is_requested(t->c) ? traceability_new(t->arena, p, what) : NULL;
}

static int write_file(TestRun *t, const Traceability *matrix)
{
    OsOutput file = {t->c->value[OPT_TRACEABILITY], NULL, 0};
    Buf out;

    if (!t->c->given[OPT_TRACEABILITY])
        return EXIT_OK;
    buf_init(&out, t->arena);
    if (has_suffix(file.path, ".json"))
        traceability_write_json(matrix, &out);
    else
        traceability_write_csv(matrix, &out);
    file.bytes = buf_text(&out);
    file.n = out.n;
    return cli_write_outputs(t->c, &file, 1);
}

// Returns where a source names the requirement: its definition, else a mark @req, else an assert.
static Span requirement_span(const Traceability *matrix, const TracedRequirement *q)
{
    return q->what ? q->what->span : q->mark.n ? q->mark.at[0].span : matrix->assert.at[q->assert.at[0]].span;
}

// Reports that too few requirements are tested, with a note for each that is not.  One that is violated has been tested.
static void judge_tested_requirements(TestRun *t, const Traceability *matrix, const char *machine, double percent)
{
    Diags *d = &t->c->session.diags;
    const uint32_t tested = matrix->counts.tested + matrix->counts.violated, all = matrix->requirement.n;
    TestResult r = {.path = format_in(t->arena, "requirements of %s", machine), .suite = machine, .status = TEST_PASSED, .message = "", .is_limit = true};
    Diag *low = NULL;

    for (size_t i = 0; i < all && 100.0 * tested < percent * all; i++) {
        const TracedRequirement *q = &matrix->requirement.at[i];
        if (q->result[0] != 'u')                  // "untested" and "undecided" begin with u
            continue;
        if (low == NULL)
            low = diag_report(d, DIAG_coverage_too_low, requirement_span(matrix, q), "requirements",
                              format_in(t->arena, "%lu of %lu", (unsigned long)tested, (unsigned long)all), format_in(t->arena, "%.6g", percent));
        diag_note(d, low, requirement_span(matrix, q), DIAG_note_not_covered,
                  format_in(t->arena, "%s is %s%s%s", q->id->text, q->result, q->what ? ": " : "", q->what ? q->what->text->text : ""));
    }
    r.code = test_report_diagnostics(t, &r.message);
    if (r.code != EXIT_OK)
        r.status = TEST_FAILED;
    vec_push(t->arena, &t->result, r);
}

// Tries to prove the requirements, and stores the verdicts in the matrix.  The runs of the scripts are starting points of searches.
static void add_proofs(TestRun *t, Traceability *matrix)
{
    const Program *p = matrix->what->program;
    ProveGiven *given = ARENA_ARRAY(t->arena, ProveGiven, t->script.n + 1);
    Diags reported;                               // dropped: the scripts have run before, and their diagnostics have been printed
    const ProveResult *r;

    diags_init(&reported, t->arena);
    for (uint32_t i = 0; i < t->script.n; i++)
        prove_record_script(t->arena, &reported, p, p, t->script.at[i], &given[i]);
    r = prove_run(t->arena, matrix->what, &(ProveOptions){.given = given, .givens = t->script.n});

    for (uint32_t i = 0; i < r->n; i++)
        traceability_set_proof(matrix, r->of[i].what->id, prove_verdict_words(r->of[i].verdict));
}

// After the scripts: writes the matrix, and compares the tested requirements with --min-coverage.
int test_traceability_finish(TestRun *t, Traceability *matrix, const char *machine)
{
    double percent;
    Buf out;
    int code;

    if (!matrix)
        return EXIT_OK;
    traceability_finish(matrix);
    if (t->c->given[OPT_PROVE] && matrix->what)
        add_proofs(t, matrix);
    if ((code = write_file(t, matrix)) != EXIT_OK)
        return code;
    buf_init(&out, t->arena);
    traceability_write_summary(matrix, &out);
    t->traceability = buf_text(&out);
    if (test_coverage_demands_requirements(t->c, &percent))
        judge_tested_requirements(t, matrix, machine, percent);
    return EXIT_OK;
}
