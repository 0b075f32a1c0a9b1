// SPDX-License-Identifier: Apache-2.0
// Runs the passes in their order.  Computes the facts that a pass needs if they are not valid, and verifies the IR after each pass.
#include <string.h>

#include "compiler/passes/pass.h"

const PassInfo pass_info[PASS_COUNT] = {
#define PASS(name, needs, invalidates, sentence) {#name, needs, invalidates, sentence, pass_##name, NULL},
#define PASS_MACHINE(name, needs, invalidates, sentence) {#name, needs, invalidates, sentence, NULL, pass_##name},
#include "compiler/passes/passes.def"
};

typedef struct PassRun { int level; PassId pass; } PassRun;

static const PassRun runs[] = {
#define RUN(level, name) {level, PASS_##name},
#include "compiler/passes/passes.def"
};

static const PassId runs_for_c[] = {
#define RUN_FOR_C(name) PASS_##name,
#include "compiler/passes/passes.def"
};

typedef struct PassRunner {
    Arena *arena;
    IrMachine *m;
    const PassOptions *o;
    Facts *facts;                     // by function: [0] for the sample function, then entry, step and exit of every state
    VarNotes notes;
    FactMachine *values;              // NULL: not computed yet, or invalidated
    Arena work;                       // for tables about the function on which passes run
    size_t instructions;              // number of instructions of the functions about which `work` has tables
} PassRunner;

static const PassInfo *find_pass(const char *name, size_t n)
{
    for (int p = 0; p < PASS_COUNT; p++)
        if (strlen(pass_info[p].name) == n && memcmp(pass_info[p].name, name, n) == 0)
            return &pass_info[p];
    return NULL;
}

// Returns the pass of this name; NULL if no pass has it.
const PassInfo *pass_find(const char *name)
{
    return find_pass(name, strlen(name));
}

// ---- notes on variables ----

void notes_begin_block(VarNotes *n) { n->block++; }

// Returns the current block's note about a variable; an empty one (IR_NONE, false) if the block has stored no note.
VarNote *find_variable_note(VarNotes *n, uint32_t var)
{
    VarNote *note = &n->at[var];

    if (note->block != n->block) {
        note->block = n->block;
        note->ref = note->load = IR_NONE;
        note->stored = false;
    }
    return note;
}

// ---- tables ----

enum { TABLES_MAX = 1000 };           // `work` is freed when its tables are about more instructions: so they stay in the processor's cache

// Frees the tables in `work` if they are about many instructions.  *instructions: number of instructions of the functions with tables; f is the last
// of these functions.
static void free_tables(Arena *work, size_t *instructions, const IrFn *f)
{
    *instructions += f->ins.n;
    if (*instructions < TABLES_MAX)
        return;
    arena_reset(work);
    *instructions = 0;
}

void pass_on_each_function(Arena *arena, IrMachine *m, FactMachine *values, PassValuesFn *pass)
{
    size_t instructions = 0;
    Arena work;

    arena_init_within(&work, arena);
    if (m->sample)
        pass(arena, &work, m->sample, facts_of_function(values, m->sample, facts_at_begin_of_sample(values)));
    for (size_t s = 0; s < m->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            if (m->state.at[s].block[b]) {
                pass(arena, &work, m->state.at[s].block[b], facts_of_block(values, s, b));
                free_tables(&work, &instructions, m->state.at[s].block[b]);
            }
}

// ---- running ----

// Runs one pass on a function, after counting uses if the pass needs them; marks as invalid what the pass changes.
static void run_on_function(PassRunner *r, const PassInfo *pass, IrFn *f, Facts *facts)
{
    if (pass->needs & ~facts->valid & FACT_USES) {
        facts->uses = ir_count_uses(r->o->verify ? r->arena : &r->work, f);       // `verify`: kept, because verify_machine reads them
        facts->valid |= FACT_USES;
    }
    pass->on_function(r->arena, f, facts);
    facts->valid &= ~pass->invalidates;
}

// Whether the stored use counts of a function are correct.  True if they are marked as not valid.
static bool are_use_counts_correct(PassRunner *r, const IrFn *f, const Facts *facts)
{
    const uint32_t *uses;

    if (!f || !(facts->valid & FACT_USES))
        return true;
    uses = ir_count_uses(r->arena, f);
    for (size_t b = 0; b < f->blk.n; b++)
        for (size_t p = 0; p < f->blk.at[b].ins.n; p++)
            if (uses[f->blk.at[b].ins.at[p]] != facts->uses[f->blk.at[b].ins.at[p]])
                return false;
    return true;
}

// Checks the IR and the stored use counts, if PassOptions.verify is set.  Returns NULL, or a sentence about what is wrong, with `when`.
static const char *verify_machine(PassRunner *r, const char *when)
{
    const Facts *facts = r->facts;
    const char *wrong;
    bool correct;

    if (!r->o->verify)
        return NULL;
    wrong = ir_verify(r->arena, r->m);
    if (!wrong) {
        correct = are_use_counts_correct(r, r->m->sample, facts++);
        for (size_t s = 0; s < r->m->state.n; s++)
            for (int k = 0; k < BLOCK_COUNT; k++)
                correct = are_use_counts_correct(r, r->m->state.at[s].block[k], facts++) && correct;
        wrong = correct ? NULL : "its use counts are wrong";
    }
    return wrong ? format_in(r->arena, "%s: %s", when, wrong) : NULL;
}

// Runs n passes on one function.  Their tables, and with them the use counts, are then free.
static void run_list_on_function(PassRunner *r, const PassInfo *const *pass, size_t n, IrFn *f, Facts *facts)
{
    if (!f)
        return;
    for (size_t k = 0; k < n; k++)
        run_on_function(r, pass[k], f, facts);
    free_tables(&r->work, &r->instructions, f);
    if (!r->o->verify)
        facts->valid &= ~(unsigned)FACT_USES;
}

// Runs n passes over functions, which are adjacent in their order.  All of them run on one function before they run on the next: the function is
// then still in the processor's cache.
static void run_on_functions(PassRunner *r, const PassInfo *const *pass, size_t n)
{
    Facts *facts = r->facts;

    run_list_on_function(r, pass, n, r->m->sample, facts++);
    for (size_t s = 0; s < r->m->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            run_list_on_function(r, pass, n, r->m->state.at[s].block[b], facts++);
}

static void run_on_machine(PassRunner *r, const PassInfo *pass)
{
    const size_t functions = 1 + r->m->state.n * BLOCK_COUNT;

    if (pass->needs & FACT_VALUES && !r->values)
        r->values = facts_of_machine(r->arena, r->m);
    pass->on_machine(r->arena, r->m, pass->needs & FACT_VALUES ? r->values : NULL);
    for (size_t f = 0; f < functions; f++)
        r->facts[f].valid &= ~pass->invalidates;
}

// Runs n adjacent passes, n > 1 only of passes over functions.  Returns NULL, or what `verify` found wrong with the result, as a sentence.
static const char *run_passes(PassRunner *r, const PassInfo *const *pass, size_t n)
{
    const PassInfo *last = pass[n - 1];

    if (last->on_function)
        run_on_functions(r, pass, n);
    else
        run_on_machine(r, last);
    for (size_t k = 0; k < n; k++)
        if (pass[k]->invalidates & FACT_VALUES)
            r->values = NULL;
    if (r->values)
        facts_forget_visits(r->values);
    if (r->o->after)
        r->o->after(r->o->context, last, r->m);
    return verify_machine(r, last->name);
}

static const char *run_pass(PassRunner *r, const PassInfo *pass) { return run_passes(r, &pass, 1); }

// Runs the passes of a list of names.  Returns NULL, or an error as a sentence.
static const char *run_listed_passes(PassRunner *r, const char *list)
{
    const char *wrong = NULL;

    while (!wrong && *list) {
        size_t n = strcspn(list, ",");
        const PassInfo *pass = find_pass(list, n);
        if (!pass)
            return format_in(r->arena, "there is no pass '%.*s'", (int)n, list);
        wrong = run_pass(r, pass);
        list += n + (list[n] == ',');
    }
    return wrong;
}

static void prepare_facts(PassRunner *r)
{
    size_t functions = 1 + r->m->state.n * BLOCK_COUNT;

    arena_init_within(&r->work, r->arena);
    r->facts = ARENA_ARRAY(r->arena, Facts, functions);
    r->notes.at = ARENA_ARRAY(r->arena, VarNote, r->m->var.n);
    for (size_t f = 0; f < functions; f++) {
        r->facts[f].m = r->m;
        r->facts[f].notes = &r->notes;
        r->facts[f].soft = r->o->soft;
        r->facts[f].work = &r->work;
    }
}

// Returns how many of the next n passes (at least 1) can run together: passes over functions, if no check or print follows each of them.
static size_t count_passes_over_functions(const PassRunner *r, const PassInfo *const *pass, size_t n)
{
    size_t together = 0;

    while (together < n && pass[together]->on_function && !r->o->verify && !r->o->after)
        together++;
    return together ? together : 1;
}

// Runs the optimiser.  Returns NULL, or an error as a sentence.
const char *passes_run(Arena *arena, IrMachine *m, const PassOptions *o)
{
    PassRunner r = {.arena = arena, .m = m, .o = o};
    const PassInfo *pass[sizeof runs / sizeof *runs];
    const char *wrong;
    size_t n = 0, together;

    prepare_facts(&r);
    wrong = verify_machine(&r, "before the first pass");
    if (!wrong && o->only)
        return run_listed_passes(&r, o->only);
    for (size_t p = 0; p < sizeof runs / sizeof *runs; p++)
        if (runs[p].level <= o->level)
            pass[n++] = &pass_info[runs[p].pass];
    for (size_t p = 0; !wrong && p < n; p += together) {
        together = count_passes_over_functions(&r, pass + p, n - p);
        wrong = run_passes(&r, pass + p, together);
    }
    return wrong;
}

// Runs the passes for C on a copy of m.  Returns NULL, or a sentence about what is wrong.
static const char *run_passes_for_c(Arena *arena, const IrMachine *m, const PassOptions *o, IrMachine **out)
{
    PassRunner r = {.arena = arena, .m = ir_copy(arena, m), .o = o};
    const char *wrong = NULL;

    prepare_facts(&r);
    r.m->values = r.values = facts_of_machine(arena, r.m);
    for (size_t p = 0; !wrong && p < sizeof runs_for_c / sizeof runs_for_c[0]; p++)
        wrong = run_pass(&r, &pass_info[runs_for_c[p]]);
    *out = r.m;
    return wrong ? wrong : ir_verify(arena, r.m);
}

// Computes the values (FACT_VALUES) before the passes run.  They stay true, because passes preserve the meaning of the machine.  Values
// computed afterwards would be less precise, because if_convert removes the branches whose guards limit counters.
// If the result is wrong, the passes run again, with a check after each of them, to name the pass.
IrMachine *passes_for_c(Arena *arena, const IrMachine *m, const PassOptions *o, const char **wrong)
{
    static const PassOptions none = {0}, checked = {.verify = true};
    IrMachine *out, *again;
    const char *named;

    *wrong = run_passes_for_c(arena, m, o ? o : &none, &out);
    if (!*wrong)
        return out;
    named = run_passes_for_c(arena, m, &checked, &again);
    *wrong = named ? named : *wrong;
    return NULL;
}
