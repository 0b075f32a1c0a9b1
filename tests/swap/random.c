// SPDX-License-Identifier: Apache-2.0
// Swaps between random pairs of machines, in both directions, compared with the slow reference of reference.c.
//
//     random SEED COUNT
//
// A pair is a program of tests/diff and an edited copy of it.  The machines of a pair run in the reference interpreter, and in the VM both in
// place and decoded.  At some steps the other machine replaces the running one.  After every step and every swap, all elements, locals, T, the
// state and the stored elements must be equal.  Each pair runs without optimiser and with it.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "stdlib/convert.h"
#include "tests/diff/gen.h"
#include "tests/diff/subject.h"
#include "tests/swap/machine.h"
#include "tests/test.h"

enum { STEPS = 60 };

// One of the two machines of a pair.
typedef struct Half {
    Subject subject;
    SwapMachine compiled;
    SmVm *decoded_vm;         // a second copy of the same machine, which runs decoded
    SmvmDecoded *decoded;
    void *decoded_memory;
    const bool *has;          // by window: whether the image contains it
    Engine *reference;
    EngineStep answer;
    Gen *g;
} Half;

typedef struct Pair {
    Half half[2];
    Half *at;                 // the half that is running
    uint64_t *sv, *sv_decoded;
    uint32_t sv_size;
    uint64_t seed;
    int opt_level;
    const char *difference;
} Pair;

static struct { uint32_t pairs, continued, restarted, refused, locals, samples, added, removed, changed, first; } met;

// ---- edits ----

static void edit_state(Gen *g, GState *s)
{
    if (rng_percent(&g->rng, 40)) {
        for (int b = 0; b < 3; b++)
            s->block[b].n = 0;
        gen_random_state(g, s);
    }
    if (rng_percent(&g->rng, 15))
        s->name = gen_new_name(g);
}

static void edit_local(Gen *g, GVar *v)
{
    if (rng_percent(&g->rng, 15))
        v->name = gen_new_name(g);
    if (v->parameter && rng_percent(&g->rng, 50))
        gen_random_range(g, v);
    if (v->roll_size != 0 || v->parameter)            // they can be part of the size of a window
        return;
    if (rng_percent(&g->rng, 15))
        v->type = (SmType)rng_below(&g->rng, SM_TYPE_COUNT);
    if (rng_percent(&g->rng, 15)) {
        v->init = gen_expr_new(g, G_NUMBER, 0);
        v->init->text = gen_number(g->arena, &g->rng, g->mood);
    }
}

// Changes the order of states, and so their numbers.
static void edit_order(Gen *g)
{
    for (size_t i = g->state.n; i > 1; i--) {
        const uint32_t k = rng_below(&g->rng, (uint32_t)i);
        GState *s = g->state.at[i - 1];
        g->state.at[i - 1] = g->state.at[k];
        g->state.at[k] = s;
    }
}

static void edit(Gen *g)
{
    g->rng.state = rng_mix(g->seed, 20);
    for (size_t i = 0; i < g->state.n; i++)
        edit_state(g, g->state.at[i]);
    for (size_t i = 0; i < g->var.n; i++)
        if (g->var.at[i]->is_local)
            edit_local(g, g->var.at[i]);
    if (rng_percent(&g->rng, 30)) {
        GState *s = ARENA_NEW(g->arena, GState);
        s->name = gen_new_name(g);
        gen_random_state(g, s);
        vec_push(g->arena, &g->state, s);
    }
    if (rng_percent(&g->rng, 50))
        edit_order(g);
}

// ---- the pair ----

static void *allocate(size_t size)
{
    void *p = calloc(1, size > 0 ? size : 1);

    if (p == NULL)
        exit(3);
    return p;
}

static SmResult start(Half *h, SmVm *vm, uint32_t state)
{
    const SmvmVector none = {NULL, h->compiled.m.sv_size, h->compiled.m.layout};

    return smvm_prepare(vm, h->compiled.ram, &h->compiled.m, &none, state);
}

// Builds the image.  Does not start the machine.
static bool open_half(Pair *p, Half *h)
{
    SwapMachine *c = &h->compiled;

    memset(c, 0, sizeof *c);
    c->session = h->subject.session;
    c->program = h->subject.program;
    if (!machine_build(c, p->opt_level, true))
        return false;
    h->has = machine_windows(c);
    h->decoded_vm = allocate(c->ram);
    h->decoded_memory = allocate(smvm_decoded_size(&c->m));
    h->reference = engine_ref_open(&c->session.arena, c->program);
    engine_step_init(&h->answer, &c->session.arena, c->program);
    return true;
}

// Closes a half.  Its session belongs to the machine since the half was opened, so the subject has none to free.
static void close_half(Half *h)
{
    if (h->compiled.program != NULL)
        machine_free(&h->compiled);
    else
        subject_free(&h->subject);
    free(h->decoded_vm);
    free(h->decoded_memory);
}

static bool decode(Pair *p, Half *h)
{
    return smvm_decode(&h->decoded, h->decoded_memory, smvm_decoded_size(&h->compiled.m), &h->compiled.m, h->decoded_vm, p->sv_decoded) == SM_OK;
}

// ---- comparison ----

static const SmvmLocation *find_local(const Half *h, const Var *v, SmvmLocation *at)
{
    for (uint32_t i = 0; i < smvm_variables(&h->compiled.m); i++) {
        SmvmVariable is;
        const SmvmName n = smvm_variable(&h->compiled.m, i, &is, at);
        if (is == SMVM_IS_LOCAL && n.size == v->name->len && memcmp(h->compiled.image + n.at, v->name->text, n.size) == 0)
            return at;
    }
    return NULL;
}

static bool is_local_equal(const Half *h, const Var *v, uint64_t cell)
{
    SmvmLocation at;

    if (v->is_constant)
        return true;
    return find_local(h, v, &at) != NULL && at.type == v->type && sm_cell_load(v->type, (uint8_t *)smvm_locals(h->compiled.vm) + at.offset) == cell
           && sm_cell_load(v->type, (uint8_t *)smvm_locals(h->decoded_vm) + at.offset) == cell;
}

// Compares the running machine with the reference.
static void compare(Pair *p, const char *when)
{
    const Half *h = p->at;
    const RefEngine *r = h->reference->self;
    const SmVm *vm = h->compiled.vm;

    if (smvm_state(vm) != r->state->number || vm->first != r->is_first || smvm_state(h->decoded_vm) != r->state->number || h->decoded_vm->first != r->is_first)
        p->difference = when;
    if (smvm_time(vm) != r->cell[r->p->t->index] || smvm_time(h->decoded_vm) != smvm_time(vm) || memcmp(p->sv, p->sv_decoded, p->sv_size) != 0)
        p->difference = when;
    for (size_t i = 0; i < r->p->var.n; i++) {
        const Var *v = r->p->var.at[i];
        if (v->kind == VAR_ELEMENT ? sm_cell_load(v->type, (uint8_t *)p->sv + v->element->offset) != r->cell[i]
                                   : v->kind == VAR_LOCAL && !is_local_equal(h, v, r->cell[i]))
            p->difference = when;
    }
}

static void write_inputs(Pair *p, const EngineWrite *write, uint32_t n)
{
    const Half *h = p->at;

    for (uint32_t i = 0; i < n; i++) {
        const Var *v = h->compiled.program->var.at[write[i].var];
        SmvmLocation at;
        if (v->kind == VAR_ELEMENT) {
            sm_cell_store(v->type, (uint8_t *)p->sv + v->element->offset, write[i].cell);
            sm_cell_store(v->type, (uint8_t *)p->sv_decoded + v->element->offset, write[i].cell);
        } else if (v->kind == VAR_LOCAL && find_local(h, v, &at) != NULL) {
            sm_cell_store(v->type, (uint8_t *)smvm_locals(h->compiled.vm) + at.offset, write[i].cell);
            sm_cell_store(v->type, (uint8_t *)smvm_locals(h->decoded_vm) + at.offset, write[i].cell);
        }
    }
}

static void step(Pair *p, uint32_t k)
{
    EngineWrite write[GEN_VARS_MAX];
    Half *h = p->at;
    const uint32_t n = subject_writes(&h->subject, h->g, k, write);

    write_inputs(p, write, n);
    h->reference->step(h->reference, write, n, &h->answer);
    const SmResult in_place = smvm_step(h->compiled.vm, p->sv), decoded = smvm_step_decoded(h->decoded, p->sv_decoded);
    if (in_place != decoded || (in_place == SM_OK) != (h->answer.status == ENGINE_OK))
        p->difference = "the results of a step differ";
    compare(p, "a step");
}

// ---- swaps ----

static void count_items(const SmvmSwap *plan)
{
    SmvmSwapItem item;

    for (uint32_t i = 0; smvm_swap_item(plan, i, &item); i++) {
        met.locals += item.kind == SMVM_SWAP_LOCAL && item.fate == SMVM_SWAP_KEPT;
        met.samples += item.kind == SMVM_SWAP_SAMPLE && item.fate == SMVM_SWAP_KEPT;
        met.added += item.fate == SMVM_SWAP_ADDED;
        met.removed += item.fate == SMVM_SWAP_REMOVED;
        met.changed += item.fate == SMVM_SWAP_CHANGED;
    }
}

static void swap_continue(Pair *p, Half *old, Half *new)
{
    SmResult planned;
    SmvmSwap *plan = machine_plan(&old->compiled, &new->compiled, &planned);

    if (plan == NULL) {
        p->difference = "there is no plan";
        return;
    }
    const bool possible = reference_continue(old->reference->self, new->reference->self, old->has, new->has);
    const SmResult a = smvm_swap_continue(plan, old->compiled.vm, new->compiled.vm, p->sv);
    const SmResult b = smvm_swap_continue(plan, old->decoded_vm, new->decoded_vm, p->sv_decoded);
    if (a != b || a != (possible ? SM_OK : SM_E_ARGUMENT))
        p->difference = "only one of the two refuses to continue";
    if (possible) {
        p->at = new;
        count_items(plan);
        met.continued++;
        met.first += new->compiled.vm->first;
    } else
        met.refused++;
    free(plan);
}

static void swap(Pair *p, Rng *r)
{
    Half *old = p->at, *new = &p->half[old == p->half];

    if (start(new, new->compiled.vm, 1) != SM_OK || start(new, new->decoded_vm, 1) != SM_OK || !decode(p, new)) {
        p->difference = "the other machine does not start";
        return;
    }
    if (rng_percent(r, 15)) {
        const uint32_t state = 1 + rng_below(r, (uint32_t)new->compiled.program->state.n);
        start(new, new->compiled.vm, state);
        start(new, new->decoded_vm, state);
        smvm_write_state(new->compiled.vm, &new->compiled.m, p->sv);
        smvm_write_state(new->decoded_vm, &new->compiled.m, p->sv_decoded);
        reference_restart(old->reference->self, new->reference->self, state);
        p->at = new;
        met.restarted++;
    } else
        swap_continue(p, old, new);
    compare(p, "a swap");
}

static void run(Pair *p)
{
    Half *h = p->at = &p->half[0];
    Rng r = {rng_mix(p->seed, 21)};
    const uint32_t state = gen_state_number(h->g, h->g->first_state);

    p->sv_size = h->compiled.m.sv_size;
    p->sv = allocate(p->sv_size);
    p->sv_decoded = allocate(p->sv_size);
    h->reference->init(h->reference, state, &h->answer);
    if (start(h, h->compiled.vm, state) != SM_OK || start(h, h->decoded_vm, state) != SM_OK || !decode(p, h))
        p->difference = "the machine does not start";
    smvm_write_state(h->compiled.vm, &h->compiled.m, p->sv);
    smvm_write_state(h->decoded_vm, &h->compiled.m, p->sv_decoded);
    for (uint32_t k = 0; k < STEPS && p->difference == NULL; k++) {
        if (rng_percent(&r, 12))
            swap(p, &r);
        if (p->difference == NULL)
            step(p, k);
        if (p->difference != NULL)
            printf("seed %llu, -O%d: before or at step %lu: %s\n", (unsigned long long)p->seed, p->opt_level, (unsigned long)k, p->difference);
    }
    free(p->sv);
    free(p->sv_decoded);
}

static void write_programs(Pair *p, const char *folder)
{
    for (int i = 0; i < 2; i++) {
        Buf text;
        char path[400];
        buf_init(&text, p->half[i].g->arena);
        gen_print_sm(p->half[i].g, &text);
        snprintf(path, sizeof path, "%s/%d.sm", folder, i);
        FILE *f = fopen(path, "wb");
        if (f != NULL) {
            fwrite(buf_text(&text), 1, text.n, f);
            fclose(f);
        }
    }
}

static void run_pair(uint64_t seed, int opt_level, const char *folder)
{
    static Pair p;
    Arena arena;

    memset(&p, 0, sizeof p);
    p.seed = seed;
    p.opt_level = opt_level;
    diff_arena_init(&arena);
    for (int i = 0; i < 2; i++)
        p.half[i].g = gen_program(&arena, seed, STEPS);
    edit(p.half[1].g);
    const bool compiled[2] = {subject_compile(&p.half[0].subject, p.half[0].g, &arena) == NULL,
                              subject_compile(&p.half[1].subject, p.half[1].g, &arena) == NULL};
    if (compiled[0] && compiled[1] && open_half(&p, &p.half[0]) && open_half(&p, &p.half[1])) {
        met.pairs++;
        run(&p);
        if (p.difference != NULL && folder != NULL)
            write_programs(&p, folder);
        test_count(p.difference == NULL, "a pair of machines");
    }
    for (int i = 0; i < 2; i++)
        close_half(&p.half[i]);
    arena_free(&arena);
}

int main(int argc, char **argv)
{
    const uint64_t seed = argc > 1 ? strtoull(argv[1], NULL, 10) : 1;
    const uint32_t count = argc > 2 ? (uint32_t)strtoul(argv[2], NULL, 10) : 1000;

    for (uint32_t i = 0; i < count; i++)
        run_pair(seed + i, i % 4 == 0 ? 0 : 2, argc > 3 ? argv[3] : NULL);
    printf("%lu pairs, %lu continued (%lu into a first step), %lu restarted, %lu refused; %lu locals and %lu windows kept; %lu added, %lu removed, %lu changed\n",
           (unsigned long)met.pairs, (unsigned long)met.continued, (unsigned long)met.first, (unsigned long)met.restarted, (unsigned long)met.refused,
           (unsigned long)met.locals, (unsigned long)met.samples, (unsigned long)met.added, (unsigned long)met.removed, (unsigned long)met.changed);
    if (count >= 1000) {
        CHECK(met.pairs > count * 9 / 10 && met.continued > 2 * count && met.restarted > count / 4 && met.refused > count / 10);
        CHECK(met.locals > count && met.samples > count / 4 && met.added > count && met.removed > count && met.changed > count / 4 && met.first > count / 4);
    }
    return test_end("swap/random");
}
