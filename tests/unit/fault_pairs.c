// SPDX-License-Identifier: Apache-2.0
// What faults of a campaign need no run: its results are those of a campaign that runs every fault and every pair (compiler/whatif/fault_replay.c).
// The machines differ in their limits, in what their plants and asserts read, and in whether the machine assigns an input.  Two machines of an
// application, of which one reads what the other stores, differ in the same way, and in how often the second one runs.
#include <setjmp.h>
#include <stdio.h>
#include <string.h>

#include "compiler/compile.h"
#include "compiler/whatif/faults.h"
#include "tests/test.h"
#include "tests/unit/host.h"

enum { MACHINES = 50, APPLICATIONS = 25, PAIRS_LEAST = 45000, WORSE_LEAST = 400, REPEATED_LEAST = 12000, UNREAD_LEAST = 25000 };

static uint64_t random_state = 1;
static uint64_t pairs, worse, repeated, unread;

static unsigned draw(unsigned n)
{
    random_state = random_state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (unsigned)(random_state >> 33) % n;
}

static const char machine[] =
    "[options]\nstep 10 ms\n[state_vector]\nU64 G\nU32 S\nF32 a @read_only @range 0 100\nF64 b %s@range 0 50\nbool c @read_only\nbool out\nF64 level\n"
    "[local]\nF64 last = 0\nU8 n = 0\n"
    "[Idle]\n.step\n    last = roll_median(a, 5)\n    level = %s\n    a > %u and b > %u: -> Run\n    c and T > %u ms: -> Run\n"
    "[Run]\n.entry\n    out = true\n.step\n    level = last - b\n    b < %u or (c and a < %u): n = n + 1\n    n > %u: -> Stop\n    T > %u ms: -> Idle\n    %s\n.exit\n    out = false\n"
    "[Stop] @abort @safe\n";

static const char script[] =
    "[options]\ndelta_t 10\n[local]\nF64 height = 0\n[all_states]\n"
    "%s: height = height + 2\nheight > %u: height = 0\n"
    "true: a = height + noise(1)\ntrue: b = %s\nfrom %u ms to %u ms: c = true\nafter %u ms: c = false\n"
    "at 900 ms: @assert %s\nat 1 s: @stop\n";

static const char vector[] =
    "[Time]\nU64 G\n[Inputs]\nF32 a @range 0 100\nF64 b @range 0 50\nbool c\n[Machines]\nU32 S\nU32 state\nbool out\nF64 level\nbool lamp\n";

static const char application[] =
    "[options]\nstate_vector \"x.sv\"\ntime G 1 ms\n[all]\nevery 10 ms:\n    machine one \"m.sm\"\n%s    machine two \"lamp.sm\"\n";

static const char second[] =
    "[state_vector]\nU64 G\nU32 state @alias S\n%s @read_only\nbool out @read_only\nF64 level @read_only\nbool lamp\n"
    "[Dark]\n.entry\n    lamp = false\n.step\n    out and level > %u: -> Lit\n"
    "[Lit]\n.entry\n    lamp = true\n.step\n    %s: -> Dark\n    T > %u: -> Broken\n"
    "[Broken] @abort\n.entry\n    lamp = false\n";

static const char of_two_machines[] =
    "[local]\nF64 height = 0\n[all_states]\n"
    "%s: height = height + 2\nheight > %u: height = 0\n"
    "true: a = height + noise(1)\ntrue: b = 40 - height * 0.3\nfrom %u ms to 450 ms: c = true\nafter 700 ms: c = false\n"
    "[two.Lit]\ntwo.T > 300: @assert one.S == Run\n[all_states]\nat 1 s: @stop\n";

static const char requirement[] = "R1 \"limit\" never %s and %s > %u\n";

static const Source *source_of(Session *s, const char *name, const char *text) { return source_new(&s->arena, name, text, strlen(text)); }

// Returns the results of a campaign; NULL if the files have errors.
static const Faults *run_campaign(Session *s, const Program *p, const Script *ss, const Requirements *rq, bool runs_all)
{
    const Script **list = arena_copy(&s->arena, &ss, sizeof ss);
    const FaultOptions o = {.kinds = (1u << FAULT_KIND_COUNT) - 1, .pairs = true, .runs_all = runs_all, .max_runs = UINT64_MAX,
                            .sizes = {0.05, 0.02, 3, 5, 0}, .max_steps = 1000, .requirements = rq};
    Faults *f = faults_new(&s->arena, p, list, 1, &o);

    while (f->baseline.left_out == 0 && faults_run_next(f))
        ;
    faults_end(f);
    return f;
}

static bool is_same_result(const FaultResult *x, const FaultResult *y)
{
    return x->trigger == y->trigger && x->faults == y->faults && memcmp(x->fault, y->fault, x->faults * sizeof *x->fault) == 0 && x->outcome == y->outcome &&
           x->violated == y->violated && x->violated_at.step == y->violated_at.step && x->failed == y->failed && x->differs == y->differs &&
           x->differs_at.step == y->differs_at.step && x->cell == y->cell && x->end == y->end && x->steps == y->steps && x->worse_than_alone == y->worse_than_alone;
}

static void compare_campaigns(const Faults *some, const Faults *all)
{
    CHECK(some->baseline.left_out == all->baseline.left_out && some->pairs == all->pairs && some->pairs_worse == all->pairs_worse);
    CHECK(some->result.n == all->result.n && all->repeated == 0);
    for (uint32_t i = 0; i < some->result.n && i < all->result.n; i++)
        CHECK(is_same_result(&some->result.at[i], &all->result.at[i]));
    pairs += some->pairs;
    worse += some->pairs_worse;
    repeated += some->repeated;
    unread += all->runs - some->runs;
}

static void try_machine(void)
{
    static const char *const level[] = {"a + b", "b", "last"}, *const plant[] = {"true", "not out", "level < 60", "b < 30"}, *const of_b[] = {"40 - height * 0.3", "30", "height * 0.5"},
                      *const judged[] = {"not state Stop", "level < 90", "a < 95 or out"}, *const in_rule[] = {"out", "S == Run", "not c"},
                      *const value[] = {"a", "level", "b"};
    const bool stores_b = draw(3) == 0;
    MachineInput in = {0};
    Session s;
    const Program *p;
    const Script *ss;
    const Requirements *rq;
    const Source *text;

    session_init(&s, heap_alloc, NULL, &host_oom);
    in.sm = source_of(&s, "m.sm", format_in(&s.arena, machine, stores_b ? "" : "@read_only ", level[draw(3)], 20 + draw(40), draw(30), 100 + draw(300), 5 + draw(20),
                                            20 + draw(40), draw(6), 150 + draw(300), stores_b ? "b = last / 2" : "n = n"));
    p = session_program(&s, &in);
    text = source_of(&s, "m.ss", format_in(&s.arena, script, plant[draw(4)], 60 + draw(40), of_b[draw(3)], 100 + draw(200), 400 + draw(200), 700 + draw(100), judged[draw(3)]));
    ss = p ? session_script(&s, text, p) : NULL;
    text = source_of(&s, "m.rq", format_in(&s.arena, requirement, in_rule[draw(3)], value[draw(3)], 60 + draw(60)));
    rq = ss ? session_requirements(&s, &text, 1, p) : NULL;
    CHECK(p && ss && rq);
    if (p && ss && rq)
        compare_campaigns(run_campaign(&s, p, ss, rq, false), run_campaign(&s, p, ss, rq, true));
    session_free(&s);
}

static const Source *find_file(Session *s, const AppFile *file, const char *const *text)
{
    static const char *const name[] = {"x.sv", "m.sm", "lamp.sm"};

    for (int i = 0; i < 3; i++)
        if (strcmp(file->name.text->text, name[i]) == 0)
            return source_of(s, name[i], text[i]);
    return NULL;
}

// Compiles the application with the text of its files (in the order of find_file), a script and a requirement, and compares two campaigns.
static void try_application(Session *s, const char *app_text, const char *const *text, const char *ss_text, const char *rq_text)
{
    CompileSource at[2] = {{.text = source_of(s, "x.app", app_text), .kind = FILE_APP}, {.text = source_of(s, "x.rq", rq_text), .kind = FILE_RQ}};
    CompileApp app;
    CompileInput in = {.at = at, .n = 2, .app = &app};
    CompileOptions o = {.skip_analyses = true, .scripts_later = true};
    Compiled made;
    const Program *p;
    const Script *ss;
    bool is_good;

    compile_open_app(s, at[0].text, &app);
    for (size_t i = 0; i < app.files.n; i++)
        app.files.at[i].src = find_file(s, &app.files.at[i], text);
    is_good = compile_sources(s, &in, &o, &made);
    CHECK(is_good);
    if (!is_good)
        return;
    p = made.of[0].scripted;
    ss = session_script(s, source_of(s, "x.ss", ss_text), p);
    CHECK(ss != NULL);
    if (ss)
        compare_campaigns(run_campaign(s, p, ss, made.of[0].requirements, false), run_campaign(s, p, ss, made.of[0].requirements, true));
}

static void try_machines(void)
{
    static const char *const plant[] = {"true", "not out", "not lamp", "b < 30"}, *const input[] = {"F32 a", "bool c", "F64 b"},
                      *const dark[] = {"a > 30", "c", "b > 25"}, *const in_rule[] = {"lamp", "two.S == Lit", "one.S == Run", "not c"},
                      *const value[] = {"a", "level", "b"};
    const unsigned read = draw(3);
    const char *text[3] = {vector};
    Session s;

    session_init(&s, heap_alloc, NULL, &host_oom);
    text[1] = format_in(&s.arena, machine, "@read_only ", draw(2) ? "b" : "last", 20 + draw(40), draw(30), 100 + draw(300), 5 + draw(20), 20 + draw(40),
                        draw(6), 150 + draw(300), "n = n");
    text[2] = format_in(&s.arena, second, input[read], draw(30), dark[read], 100 + draw(400));
    try_application(&s, format_in(&s.arena, application, draw(2) ? "" : "every 30 ms:\n"), text,
                    format_in(&s.arena, of_two_machines, plant[draw(4)], 60 + draw(40), 100 + draw(200)),
                    format_in(&s.arena, requirement, in_rule[draw(4)], value[draw(3)], 60 + draw(60)));
    session_free(&s);
}

int main(void)
{
    host_check(setjmp(host_oom));
    for (int i = 0; i < MACHINES; i++)
        try_machine();
    for (int i = 0; i < APPLICATIONS; i++)
        try_machines();
    CHECK(pairs >= PAIRS_LEAST && worse >= WORSE_LEAST && repeated >= REPEATED_LEAST && unread >= UNREAD_LEAST);
    if (test_failed)
        fprintf(stderr, "%llu pairs, %llu worse, %llu repeated, %llu runs less\n", (unsigned long long)pairs, (unsigned long long)worse,
                (unsigned long long)repeated, (unsigned long long)unread);
    return test_end("fault_pairs");
}
