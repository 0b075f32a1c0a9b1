// SPDX-License-Identifier: Apache-2.0
// Runs one case: compiles the sources, steps the engines, and compares their results.
#include "tests/diff/run.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/diff/batch.h"
#include "tests/diff/cover_model.h"
#include "tests/diff/engine_ir.h"
#include "tests/diff/engine_task.h"
#include "tests/diff/sound.h"
#include "tests/diff/subject.h"
#include "tests/diff/watch.h"

// At most these engines run: the reference, each form twice, in the VM with soft numbers and as a task; the reference and one form of the
// changed program, likewise; coverage and its model.
enum { ENGINES_MAX = 2 + 4 * FORM_COUNT + 5 + 2 };

const char *const form_name[FORM_COUNT] = { "-O0", "-O1", "-O2", "-O2, locals hidden" };

// ---- engines ----

typedef struct Lane {
    const Subject *subject;
    Form form;                // of every engine but the reference
    Engine *engine;
    EngineStep answer;
} Lane;

typedef struct Lanes {
    Lane at[ENGINES_MAX];
    uint32_t n;
} Lanes;

static void add_lane(Lanes *l, Subject *s, Engine *e, Form form)
{
    Lane *lane = &l->at[l->n++];
    lane->subject = s;
    lane->form = form;
    lane->engine = e;
    engine_step_init(&lane->answer, &s->session.arena, s->program);
}

bool run_is_unknown(const Var *v, Form form)
{
    return form == FORM_HIDDEN && v->kind == VAR_LOCAL && !v->outside && !v->is_constant && !v->parameter;
}

IrMachine *run_machine(Subject *s, const Program *p, Form form)
{
    s->session.locals = form == FORM_HIDDEN ? LOCALS_HIDDEN : LOCALS_READ;
    s->session.check_passes = true;
    return session_ir(&s->session, p, form < FORM_O2 ? (int)form : 2);
}

const Program *run_known_program(Subject *s, Form form)
{
    Arena *a = &s->session.arena;
    if (form != FORM_HIDDEN)
        return s->program;
    Program *p = ARENA_NEW(a, Program);
    *p = *s->program;
    memset(&p->var, 0, sizeof p->var);
    for (size_t i = 0; i < s->program->var.n; i++) {
        Var *v = s->program->var.at[i];
        if (run_is_unknown(v, form)) {
            v = ARENA_NEW(a, Var);
            *v = *s->program->var.at[i];
            v->is_constant = true;
        }
        vec_push(a, &p->var, v);
    }
    return p;
}

// The VM on the last machine of an image; the others precede it.
static const char *add_vm(Lanes *l, Subject *s, Form form, const Subject *before)
{
    const ImageOptions options = { .debug = true };      // the engine finds locals by name
    const char *error = "no image";
    IrMachine *m[2];
    Buf image;
    uint32_t n = 0;
    buf_init(&image, &s->session.arena);
    if (before != NULL)
        m[n++] = run_machine(s, before->program, form);
    m[n++] = run_machine(s, s->program, form);
    if (m[0] == NULL || m[n - 1] == NULL || !session_image(&s->session, m, n, &options, &image))
        return "the compiler makes no image";
    Engine *e = engine_vm_open(&s->session.arena, run_known_program(s, form), (const uint8_t *)image.at, image.n, n - 1, &error);
    if (e == NULL)
        return error;
    add_lane(l, s, e, form);
    if (before != NULL)
        return NULL;
    add_lane(l, s, engine_ir_open(&s->session.arena, s->program, m[n - 1]), form);
    if (form == FORM_O2 || form == FORM_HIDDEN) {
        e = engine_task_open(&s->session.arena, run_known_program(s, form), (const uint8_t *)image.at, image.n, form == FORM_O2, &error);
        if (e == NULL)
            return error;
        add_lane(l, s, e, form);
    }
    if (form == FORM_O0 || form == FORM_O2) {
        e = engine_vm_soft_open(&s->session.arena, s->program, (const uint8_t *)image.at, image.n, 0, &error);
        if (e == NULL)
            return error;
        add_lane(l, s, e, form);
    }
    return NULL;
}

static void step_lane(Lane *l, const Gen *g, uint32_t k)
{
    EngineWrite write[GEN_VARS_MAX];
    const uint32_t n = subject_writes(l->subject, g, k, write);
    l->engine->step(l->engine, write, n, &l->answer);
}

// Values that cannot be observed in this form are copied from the reference.
static void take_unknown(const Lane *from, Lane *to)
{
    for (size_t i = 0; i < from->subject->program->var.n; i++)
        if (run_is_unknown(from->subject->program->var.at[i], to->form))
            to->answer.cell[i] = from->answer.cell[i];
}

static const char *compare(Lanes *l, Arena *arena)
{
    for (uint32_t i = 1; i < l->n; i++) {
        const Lane *a = &l->at[0];
        Lane *b = &l->at[i];
        if (b->answer.status == ENGINE_BROKEN)
            return format_in(arena, "%s: %s", b->engine->name, b->engine->error);
        if (b->form == FORM_HIDDEN)
            take_unknown(a, b);
        const char *difference = engine_compare(arena, a->engine, &a->answer, b->engine, &b->answer);
        if (difference != NULL)
            return format_in(arena, "%s%s: %s", b->subject != a->subject ? "(the second is the changed program) " : "", form_name[b->form], difference);
    }
    return NULL;
}

static void note(Met *met, const EngineStep *s, uint32_t vars)
{
    met->refusal |= s->status == ENGINE_REFUSED;
    met->refused += s->status == ENGINE_REFUSED;
    met->transition |= s->status == ENGINE_OK && s->next_is_first;
    for (uint32_t i = 0; i < vars; i++)
        met->store |= s->stored[i] != 0;
}

static void note_watch(Met *met)
{
    met->saturation = watch.saturated > 0;
    met->nan = watch.nan > 0;
    met->infinity = watch.infinite > 0;
    met->full_window = watch.filled > 0;
}

static void restart(Lanes *l, const Gen *g, uint32_t state)
{
    for (uint32_t i = 0; i < l->n; i++)
        l->at[i].engine->init(l->at[i].engine, gen_state_number(g, state), &l->at[i].answer);
}

static RunResult run_lanes(Lanes *l, const Gen *g, Arena *arena)
{
    RunResult r = { VERDICT_SAME, NULL, 0, { 0 } };
    uint32_t state;
    for (uint32_t k = 0; k < g->steps && r.message == NULL; k++) {
        r.step = k;
        if (gen_restarts(g, k, &state)) {
            restart(l, g, state);
            r.message = compare(l, arena);
        }
        if (g->skip[k] || r.message != NULL)
            continue;
        for (uint32_t i = 0; i < l->n; i++)
            step_lane(&l->at[i], g, k);
        r.message = compare(l, arena);
        note(&r.met, &l->at[0].answer, (uint32_t)l->at[0].subject->program->var.n);
    }
    r.verdict = r.message == NULL ? VERDICT_SAME : VERDICT_DIFFERENT;
    return r;
}

// ---- initial values ----

// Compares the constants that the compiler computed with the reference's results for the same expressions.
static const char *compare_inits(const Subject *plain, const Subject *s, const Gen *g, const EngineStep *after, Arena *arena)
{
    for (size_t i = 0; i < g->var.n; i++) {
        const GVar *v = g->var.at[i];
        if (!v->is_local || v->removed)
            continue;
        const uint64_t compiled = plain->program->var.at[plain->index[v->id]]->init, run = after->cell[s->index[v->id]];
        if (compiled != run)
            return format_in(arena, "initial value of %s: the compiler has 0x%llx, ref has 0x%llx", v->name,
                             (unsigned long long)compiled, (unsigned long long)run);
    }
    return NULL;
}

static const char *check_inits(const Subject *plain, Gen *g, Arena *arena)
{
    static Subject s;
    EngineStep after;
    const char *error = subject_compile_inits(&s, g, arena);
    if (error == NULL) {
        Engine *e = engine_ref_open(&s.session.arena, s.program);
        engine_step_init(&after, &s.session.arena, s.program);
        e->init(e, 1, &after);
        e->step(e, NULL, 0, &after);
        error = compare_inits(plain, &s, g, &after, arena);
    }
    subject_free(&s);
    return error;
}

// ---- the case ----

// A program with additions gets two comparisons: with a changed program, as often as other programs, and just as often with itself written out
// by hand.
RunOptions run_options_of(uint64_t seed)
{
    const uint64_t r = rng_mix(seed, 9), turn = r / 3 % 4;
    const bool by_hand = turn == 2 && gen_seed_has_additions(seed);
    return (RunOptions){
        .forms = (1u << FORM_COUNT) - 1, .change_form = (Form)(r % 3), .change = turn == 0 || by_hand, .inits = turn == 1, .cover = r / 5 % 4 == 0,
        .what = by_hand ? CHANGE_BY_HAND : (GChange)(r / 12 % CHANGE_BY_HAND),
    };
}

// ---- the same machine by hand ----

// Collects the sections MACHINE, CODE and INIT of a machine (docs/bytecode.md): its whole behaviour, without names, lines and the hash of its
// source.
static bool machine_bytes(Subject *s, Form form, Buf *out)
{
    const ImageOptions options = { .debug = false };
    IrMachine *m = run_machine(s, s->program, form);
    Buf image;
    buf_init(&image, &s->session.arena);
    buf_init(out, &s->session.arena);
    if (m == NULL || !session_image(&s->session, &m, 1, &options, &image))
        return false;
    const uint8_t *b = (const uint8_t *)buf_text(&image);
    for (unsigned i = 0; i < b[11]; i++) {
        const uint8_t *row = b + 12 + 8 * i;
        const uint32_t offset = row[2] | row[3] << 8 | (uint32_t)row[4] << 16, size = row[5] | row[6] << 8 | (uint32_t)row[7] << 16;
        if (row[0] >= 0x81)
            buf_put(out, (const char *)b + offset, size);
    }
    return true;
}

// Counts the instructions of all states.
static uint32_t count_instructions(const IrMachine *m)
{
    uint32_t n = 0;

    for (size_t i = 0; i < m->state.n; i++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            for (size_t k = 0; m->state.at[i].block[b] && k < m->state.at[i].block[b]->blk.n; k++)
                n += (uint32_t)m->state.at[i].block[b]->blk.at[k].ins.n + 1;
    return n;
}

// Additions are notation only: they compile to the same code as the program written out by hand.  There is one exception.  A window of a
// definition or a rule exists once, but its copies by hand are several windows with other numbers, which are sampled in another order.  Then
// only the windows and the instructions of the states are counted, and only at -O2, where the optimiser merges the copies.
static const char *compare_bytes(const Gen *g, Subject *plain, Subject *by_hand, Form form, Arena *arena)
{
    Buf a, b;
    if (gen_additions_sample(g)) {
        const IrMachine *m = run_machine(plain, plain->program, FORM_O2), *hand = run_machine(by_hand, by_hand->program, FORM_O2);
        const uint32_t n = m ? count_instructions(m) : 0, of_hand = hand ? count_instructions(hand) : 0;
        if (m && hand && n == of_hand && m->window.n == hand->window.n)
            return NULL;
        return format_in(arena, "%u instructions and %u windows, by hand %u and %u", (unsigned)n, m ? (unsigned)m->window.n : 0, (unsigned)of_hand,
                         hand ? (unsigned)hand->window.n : 0);
    }
    if (!machine_bytes(plain, form, &a) || !machine_bytes(by_hand, form, &b))
        return "no image";
    if (a.n == b.n && memcmp(buf_text(&a), buf_text(&b), a.n) == 0)
        return NULL;
    return format_in(arena, "%s: %u bytes of image, by hand %u bytes or others", form_name[form], (unsigned)a.n, (unsigned)b.n);
}

static const char *open_lanes(Lanes *l, Subject *s, unsigned forms, const Subject *before)
{
    const char *error = NULL;
    add_lane(l, s, engine_ref_open(&s->session.arena, s->program), FORM_O0);
    for (Form f = FORM_O0; f < FORM_COUNT && error == NULL; f++)
        if (forms >> f & 1)
            error = add_vm(l, s, f, before);
    return error;
}

// Opens an engine that counts coverage, and the model with which the counts are compared.
static Cover *add_cover(Lanes *l, Subject *s, Engine **model)
{
    Cover *c = cover_new(&s->session.arena, s->program);
    add_lane(l, s, cover_open_engine(c), FORM_O0);
    *model = cover_model_open(&s->session.arena, s->program, c);
    add_lane(l, s, *model, FORM_O0);
    return c;
}

// Opens the changed program.  If it has the same state vector and another name, it is the second machine in an image with the first.
static const char *open_changed(Lanes *l, Subject *s, Subject *plain, Gen *g, const RunOptions *o, Arena *arena)
{
    gen_change(g, o->what);
    const char *error = subject_compile(s, g, arena);
    gen_change_back(g);
    if (error == NULL && o->what == CHANGE_BY_HAND)
        error = compare_bytes(g, plain, s, o->change_form, arena);
    if (error != NULL)
        return error;
    return open_lanes(l, s, 1u << o->change_form, g->with_sv && o->what != CHANGE_NAMES && o->what != CHANGE_BY_HAND ? plain : NULL);
}

static void close_all(Lanes *l, Subject *a, Subject *b)
{
    for (uint32_t i = 0; i < l->n; i++)
        l->at[i].engine->close(l->at[i].engine);
    subject_free(a);
    if (b != NULL)
        subject_free(b);
}

RunResult run_case(Gen *g, const RunOptions *o, Arena *arena)
{
    static Subject plain, changed;
    Lanes lanes = { .n = 0 };
    RunResult r = { VERDICT_REJECTED, NULL, 0, { 0 } };
    Cover *cover = NULL;
    Engine *model = NULL;
    if (o->sound)
        return run_sound(g, arena);
    if (o->via != NULL)
        return run_batch(&g, &o->forms, 1, o->via, 1, o->folder, arena, &r), r;
    memset(&watch, 0, sizeof watch);
    r.message = subject_compile(&plain, g, arena);
    if (r.message == NULL)
        r.message = open_lanes(&lanes, &plain, o->forms, NULL);
    if (r.message == NULL && o->cover)
        cover = add_cover(&lanes, &plain, &model);
    const bool more = r.message == NULL && o->change;
    if (more)
        r.message = open_changed(&lanes, &changed, &plain, g, o, arena);
    if (r.message == NULL)
        r = run_lanes(&lanes, g, arena);
    else
        r.message = format_in(arena, "%s", r.message);        // copies the message out of the session, which ends here
    note_watch(&r.met);
    if (r.verdict == VERDICT_SAME && cover) {
        cover_settle(cover);
        if ((r.message = cover_model_compare(model, cover, arena)) != NULL)
            r.verdict = VERDICT_DIFFERENT;
    }
    if (r.verdict == VERDICT_SAME && o->inits && (r.message = check_inits(&plain, g, arena)) != NULL)
        r.verdict = VERDICT_DIFFERENT;
    close_all(&lanes, &plain, more ? &changed : NULL);
    return r;
}

// ---- files ----

static void write_file(const char *folder, const char *name, Buf *text)
{
    char path[600];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *f = fopen(path, "wb");
    if (f == NULL)
        return;
    fwrite(buf_text(text), 1, text->n, f);
    fclose(f);
}

static void describe_steps(Gen *g, Buf *out)
{
    GInput in[GEN_VARS_MAX];
    uint32_t state;
    for (uint32_t k = 0; k < g->steps; k++) {
        if (gen_restarts(g, k, &state))
            buf_printf(out, "start in state %u\n", (unsigned)gen_state_number(g, state));
        if (g->skip[k])
            continue;
        const uint32_t n = gen_inputs(g, k, in);
        buf_printf(out, "step %u:", (unsigned)k);
        for (uint32_t i = 0; i < n; i++)
            buf_printf(out, " %s=0x%llx", in[i].var->name, (unsigned long long)in[i].cell);
        buf_str(out, "\n");
    }
}

void run_write_files(Gen *g, const RunOptions *o, const RunResult *r, const char *folder)
{
    Arena a;
    Buf sm, sv, what;
    diff_arena_init(&a);
    buf_init(&sm, &a);
    buf_init(&sv, &a);
    buf_init(&what, &a);
    gen_print_sm(g, &sm);
    write_file(folder, format_in(&a, "%s.sm", g->machine_name), &sm);
    if (g->with_sv) {
        gen_print_sv(g, &sv);
        write_file(folder, "bus.sv", &sv);
    }
    buf_printf(&what, "seed %llu, step %u", (unsigned long long)g->seed, (unsigned)r->step);
    if (o->via != NULL)
        buf_printf(&what, ", %s", o->via->command);
    else if (o->change)
        buf_printf(&what, ", compared with %s at %s", gen_change_name[o->what], form_name[o->change_form]);
    buf_printf(&what, "\n%s\n\n", r->message != NULL ? r->message : "");
    describe_steps(g, &what);
    write_file(folder, "what.txt", &what);
    arena_free(&a);
}
