// SPDX-License-Identifier: Apache-2.0
#include "compiler/cli/prove_application.h"

#include <string.h>

#include "compiler/base/json.h"
#include "compiler/base/os_signal.h"
#include "compiler/cli/runs.h"
#include "compiler/prove/prove_app.h"
#include "compiler/prove/prove_text.h"

// The verdicts, and where they are written.
typedef struct AppVerdicts {
    Cli *c;
    ProveApp *of;
    Buf *out;
} AppVerdicts;

static bool is_not_interrupted(void *context)
{
    (void)context;
    return !os_signal_waiting();
}

// ---- text ----

// Writes the verdicts on the requirements that one machine decides.  A violation is one of this machine alone.
static void write_text(const AppVerdicts *k, size_t machine)
{
    const ProveApp *a = k->of;
    const Program *p = a->what->program->joint->member.at[machine].program;
    uint32_t n = 0;

    prove_write_head(p, a->of[machine], k->out);
    for (size_t i = 0; i < a->what->at.n; i++) {
        if (a->decider[i] != machine)
            continue;
        if (a->of[machine]->of[n].verdict == PROVE_VIOLATED) {
            const Requirement *q = &a->what->at.at[i];
            buf_printf(k->out, "  %s  %-18s  %s\n", q->id->text, prove_verdict_words(PROVE_ALONE), q->text->text);
            prove_app_write_reason(a, i, 6, k->out);
        } else {
            prove_write_verdict(a->arena, p, a->of[machine], n, k->out);
        }
        n++;
    }
}

static void write_text_of_undecided(const AppVerdicts *k)
{
    const ProveApp *a = k->of;
    bool is_first = true;

    for (size_t i = 0; i < a->what->at.n; i++) {
        const Requirement *q = &a->what->at.at[i];
        if (!a->why[i])
            continue;
        if (is_first)
            buf_printf(k->out, "requirements of %s that no machine decides alone; 'smc test' judges them in scripts:\n",
                       a->what->program->name->text);
        buf_printf(k->out, "  %s  %-18s  %s\n", q->id->text, prove_verdict_words(PROVE_INTERRUPTED), q->text->text);
        prove_app_write_reason(a, i, 6, k->out);
        is_first = false;
    }
}

// ---- JSON ----

static void write_json_of_undecided(const AppVerdicts *k)
{
    const ProveApp *a = k->of;
    bool is_first = true;

    buf_str(k->out, "],\"undecided\":[");
    for (size_t i = 0; i < a->what->at.n; i++) {
        if (!a->why[i])
            continue;
        buf_str(k->out, is_first ? "\n{\"id\":" : ",\n{\"id\":");
        json_put_string(k->out, a->what->at.at[i].id->text);
        buf_str(k->out, ",\"because\":");
        json_put_string(k->out, a->why[i]);
        buf_char(k->out, '}');
        is_first = false;
    }
    buf_str(k->out, "]}\n");
}

// ---- deciding ----

// Decides the requirements of one machine, of which it has some, and writes the verdicts.
static void prove_machine(AppVerdicts *k, size_t machine, const ProveSettings *s, bool is_json, bool is_first)
{
    const ProveOptions options = {.assume_ranges = k->c->given[OPT_ASSUME_RANGES], .any_parameters = k->c->given[OPT_ANY_PARAMETERS],
                                  .effort = s->effort * 1000000, .memory = (size_t)s->memory << 20, .go_on = is_not_interrupted};

    prove_app_run(k->of, machine, &options);
    if (is_json) {
        buf_str(k->out, is_first ? "" : ",");
        prove_write_json(k->of->arena, k->of->what->program->joint->member.at[machine].program, k->of->of[machine], k->out);
    } else
        write_text(k, machine);
}

// Returns the exit code of the verdicts.
static int exit_code(Cli *c, const ProveResult *all)
{
    int code = EXIT_OK;

    for (uint32_t i = 0; i < all->n; i++)
        if (all->of[i].verdict != PROVE_PROVED && all->of[i].verdict != PROVE_VACUOUS)
            code = EXIT_INCONCLUSIVE;
    if (!all->bug)
        return code;
    cli_print_error(c, TEXT_sentence, all->bug);
    return EXIT_INTERNAL;
}

int prove_application(Cli *c, const Requirements *what, const ProveSettings *s, bool is_json, Buf *out)
{
    AppVerdicts k = {c, prove_app_new(&c->session.arena, what), out};
    bool any = false;

    if (is_json)
        buf_printf(out, "{\"smc-proofs\":1,\"application\":\"%s\",\"machines\":[\n", what->program->name->text);
    for (size_t i = 0; i < what->program->joint->member.n; i++) {
        if (!k.of->own[i])
            continue;
        if (runs_report_contradiction(c, k.of->own[i]))
            return cli_print_diagnostics(c);
        prove_machine(&k, i, s, is_json, !any);
        any = true;
    }
    if (is_json)
        write_json_of_undecided(&k);
    else
        write_text_of_undecided(&k);
    return exit_code(c, prove_app_verdicts(k.of));
}
