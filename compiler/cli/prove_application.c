// SPDX-License-Identifier: Apache-2.0
#include "compiler/cli/prove_application.h"

#include <string.h>

#include "compiler/base/json.h"
#include "compiler/base/os_signal.h"
#include "compiler/cli/runs.h"
#include "compiler/prove/prove_app.h"
#include "compiler/prove/prove_text.h"

typedef struct ProveApp {
    Cli *c;
    Arena *arena;
    const Requirements *what;
    const size_t *decider;    // by requirement: the machine that decides it; SIZE_MAX: none
    const char **why;         // by requirement: the reason if no machine decides it
    Buf *out;
    unsigned long open;       // number of requirements that are neither proved nor vacuous
    const char *bug;
} ProveApp;

static bool is_not_interrupted(void *context)
{
    (void)context;
    return !os_signal_waiting();
}

// ---- text ----

// Writes the verdicts on the requirements that one machine decides.  A violation is one of this machine alone.
static void write_text(ProveApp *k, const Member *m, const ProveResult *r)
{
    prove_write_head(m->program, r, k->out);
    for (uint32_t i = 0; i < r->n; i++) {
        const ProveOf *of = &r->of[i];
        if (of->verdict != PROVE_VIOLATED) {
            prove_write_verdict(k->arena, m->program, r, i, k->out);
            continue;
        }
        buf_printf(k->out, "  %s  %-18s  %s\n", of->what->id->text, "violated alone", of->what->text->text);
        prove_write_reason(k->arena, m->program, of, 6, k->out);
        buf_printf(k->out, "      this run is of %s alone: in the application, its inputs may never have these values\n", m->name->text);
    }
}

static void write_text_of_undecided(ProveApp *k)
{
    bool is_first = true;

    for (size_t i = 0; i < k->what->at.n; i++) {
        const Requirement *q = &k->what->at.at[i];
        if (k->decider[i] != SIZE_MAX)
            continue;
        if (is_first)
            buf_printf(k->out, "requirements of %s that no machine decides alone; 'smc test' judges them in scripts:\n",
                       k->what->program->name->text);
        buf_printf(k->out, "  %s  %-18s  %s\n      because %s\n", q->id->text, prove_verdict_words(PROVE_INTERRUPTED), q->text->text, k->why[i]);
        is_first = false;
    }
}

// ---- JSON ----

static void write_json_of_undecided(ProveApp *k)
{
    bool is_first = true;

    buf_str(k->out, "],\"undecided\":[");
    for (size_t i = 0; i < k->what->at.n; i++) {
        if (k->decider[i] != SIZE_MAX)
            continue;
        buf_str(k->out, is_first ? "\n{\"id\":" : ",\n{\"id\":");
        json_put_string(k->out, k->what->at.at[i].id->text);
        buf_str(k->out, ",\"because\":");
        json_put_string(k->out, k->why[i]);
        buf_char(k->out, '}');
        is_first = false;
    }
    buf_str(k->out, "]}\n");
}

// ---- deciding ----

// Decides the requirements of one machine, of which it has some, and writes the verdicts.
static void prove_machine(ProveApp *k, size_t machine, const Requirements *own, const ProveSettings *s, bool is_json, bool is_first)
{
    const Program *p = k->what->program;
    const Member *m = &p->joint->member.at[machine];
    const ProveOptions options = {.delta_t = p->step, .init_state = m->initial, .assume_ranges = k->c->given[OPT_ASSUME_RANGES],
                                  .any_parameters = k->c->given[OPT_ANY_PARAMETERS],
                                  .effort = s->effort * 1000000, .memory = (size_t)s->memory << 20, .go_on = is_not_interrupted};
    const ProveResult *r;

    r = prove_run(k->arena, own, &options);
    k->bug = r->bug ? r->bug : k->bug;
    for (uint32_t i = 0; i < r->n; i++)
        k->open += r->of[i].verdict != PROVE_PROVED && r->of[i].verdict != PROVE_VACUOUS;
    if (is_json) {
        buf_str(k->out, is_first ? "" : ",");
        prove_write_json(k->arena, m->program, r, k->out);
    } else
        write_text(k, m, r);
}

int prove_application(Cli *c, const Requirements *what, const ProveSettings *s, bool is_json, Buf *out)
{
    Arena *arena = &c->session.arena;
    size_t *decider = ARENA_ARRAY(arena, size_t, what->at.n + 1);
    ProveApp k = {c, arena, what, decider, ARENA_ARRAY(arena, const char *, what->at.n + 1), out, 0, NULL};
    bool any = false;

    for (size_t i = 0; i < what->at.n; i++) {
        decider[i] = prove_find_machine(arena, what, i, &k.why[i]);
        k.open += decider[i] == SIZE_MAX;
    }
    if (is_json)
        buf_printf(out, "{\"smc-proofs\":1,\"application\":\"%s\",\"machines\":[\n", what->program->name->text);
    for (size_t i = 0; i < what->program->joint->member.n; i++) {
        const Requirements *own = prove_of_machine(arena, what, decider, i);
        if (own->at.n == 0)
            continue;
        if (runs_report_contradiction(c, own))
            return cli_print_diagnostics(c);
        prove_machine(&k, i, own, s, is_json, !any);
        any = true;
    }
    if (is_json)
        write_json_of_undecided(&k);
    else
        write_text_of_undecided(&k);
    if (k.bug) {
        cli_print_error(c, TEXT_sentence, k.bug);
        return EXIT_INTERNAL;
    }
    return k.open ? EXIT_INCONCLUSIVE : EXIT_OK;
}
