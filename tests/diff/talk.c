// SPDX-License-Identifier: Apache-2.0
#include "tests/diff/talk.h"

#include <stdlib.h>
#include <string.h>

#include "bytecode-vm/smvm.h"

enum { HEAD = 12, VERDICT = 8, NO_ROOM = 255 };

void talk_init(Talk *t, Arena *arena, bool images, uint32_t parts_max)
{
    memset(t, 0, sizeof *t);
    t->arena = arena;
    t->images = images;
    t->part = ARENA_ARRAY(arena, TalkPart, parts_max);
    buf_init(&t->commands, arena);
    buf_init(&t->answers, arena);
}

// ---- recording ----

static uint32_t number_of(const TalkPart *p) { return (uint32_t)(p - p->talk->part); }

static void put_command(TalkPart *p, uint32_t command)
{
    buf_u32(&p->talk->commands, number_of(p));
    buf_u32(&p->talk->commands, command);
}

static void put_answer(TalkPart *p, const EngineStep *s)
{
    Buf *out = &p->talk->answers;
    vec_push(p->talk->arena, &p->step, p->now);
    buf_u32(out, s->status == ENGINE_REFUSED);
    buf_u32(out, s->next_state);
    buf_u32(out, s->next_is_first);
    for (size_t i = 0; i < p->program->var.n; i++)
        buf_u64(out, s->cell[i]);
    for (size_t i = 0; i < p->program->var.n; i++)
        buf_char(out, !p->tracks ? 2 : s->stored[i] != 0 && p->program->var.at[i]->kind == VAR_ELEMENT);
}

static EngineStatus record_init(Engine *e, uint32_t state, EngineStep *out)
{
    TalkPart *p = e->self;
    put_command(p, 0);
    buf_u32(&p->talk->commands, state);
    const EngineStatus status = p->inner->init(p->inner, state, out);
    put_answer(p, out);
    return status;
}

static EngineStatus record_step(Engine *e, const EngineWrite *write, uint32_t n, EngineStep *out)
{
    TalkPart *p = e->self;
    put_command(p, 1);
    buf_u32(&p->talk->commands, n);
    for (uint32_t i = 0; i < n; i++) {
        buf_u32(&p->talk->commands, write[i].var);
        buf_u64(&p->talk->commands, write[i].cell);
    }
    const EngineStatus status = p->inner->step(p->inner, write, n, out);
    put_answer(p, out);
    return status;
}

static void record_close(Engine *e) { (void)e; }

// Every other part of emitted C is compiled without the flags of stored elements.
TalkPart *talk_add(Talk *t, Session *s, const Program *p, Form form, const IrMachine *ir, RunResult *result)
{
    TalkPart *part = &t->part[t->n++];
    part->talk = t;
    part->program = p;
    part->form = form;
    part->ir = ir;
    part->tracks = t->images || t->n % 2 == 0;
    part->result = result;
    part->inner = engine_ref_open(&s->arena, p);
    part->recorder = (Engine){ part->inner->name, p, NULL, part, record_init, record_step, record_close, part->inner };
    part->first = t->answers.n;
    part->answer = HEAD + 9 * p->var.n;
    return part;
}

void talk_load(TalkPart *p, Engine *vm, const Buf *image)
{
    Buf *out = &p->talk->commands;
    SmvmVerdict why;
    put_command(p, 2);
    buf_u32(out, (uint32_t)p->program->var.n);
    for (uint32_t i = 0; i < p->program->var.n; i++) {
        const EngineLocation place = engine_vm_location(vm, i);
        buf_u32(out, place.in);
        buf_u32(out, p->program->var.at[i]->type);
        buf_u32(out, place.offset);
        buf_u32(out, p->program->var.at[i] == p->program->s ? UINT32_MAX : place.output);
        buf_u64(out, p->program->var.at[i]->init);
    }
    buf_u32(out, (uint32_t)image->n);
    buf_put(out, image->at, image->n);
    buf_u32(&p->talk->answers, smvm_verify((const uint8_t *)image->at, (uint32_t)image->n, &why));
    buf_u32(&p->talk->answers, why.longest);
}

// ---- comparing ----

static uint64_t number_at(const char *bytes, size_t size)
{
    uint64_t v = 0;
    while (size > 0)
        v = v << 8 | (uint8_t)bytes[--size];
    return v;
}

// Returns the name of the field of an answer that contains byte `at`.
static const char *field_at(const TalkPart *p, size_t at, size_t *from, size_t *size, Arena *arena)
{
    static const char *const head[] = { "status", "next state", "whether the next step is a first one" };
    const Program *program = p->program;
    *from = at;
    *size = 1;
    if (at < HEAD) {
        *from = at / 4 * 4;
        *size = 4;
        return head[at / 4];
    }
    if (at >= HEAD + 8 * program->var.n)
        return format_in(arena, "whether %s was stored", program->var.at[at - HEAD - 8 * program->var.n]->name->text);
    *from = HEAD + (at - HEAD) / 8 * 8;
    *size = 8;
    return program->var.at[(at - HEAD) / 8]->name->text;
}

// Reports a difference.  `want` and `got` are the answers of the part, which differ first at byte `at`.
static void blame(TalkPart *p, size_t at, const char *want, const char *got, size_t got_n, const char *who)
{
    Arena *arena = p->talk->arena;
    const size_t verdict = p->talk->images ? VERDICT : 0;
    size_t from = at / 4 * 4, size = 4;
    if (p->result->verdict != VERDICT_SAME)
        return;
    p->result->verdict = VERDICT_DIFFERENT;
    const char *what = at < 4 ? "verdict" : "longest step";
    if (at >= verdict) {
        const size_t answer = (at - verdict) / p->answer;
        p->result->step = p->step.at[answer];
        what = field_at(p, (at - verdict) % p->answer, &from, &size, arena);
        from += verdict + answer * p->answer;
    }
    if (from + size > got_n)
        p->result->message = format_in(arena, "%s: (%s): stopped answering", form_name[p->form], who);
    else
        p->result->message = format_in(arena, "%s: %s: ref has 0x%llx, (%s) has 0x%llx", form_name[p->form], what,
                                       (unsigned long long)number_at(want + from, size), who, (unsigned long long)number_at(got + from, size));
}

// Values that cannot be observed in this form are copied from the reference.
static void take_unknown(const TalkPart *p, const char *want, char *got, size_t n)
{
    for (size_t at = p->talk->images ? VERDICT : 0; at + p->answer <= n; at += p->answer)
        for (size_t v = 0; v < p->program->var.n; v++)
            if (run_is_unknown(p->program->var.at[v], p->form))
                memcpy(got + at + HEAD + 8 * v, want + at + HEAD + 8 * v, 8);
}

// Compares the answers of a part.  Returns how many of the n bytes belong to it.
static size_t compare_part(TalkPart *p, size_t end, char *got, size_t n, const char *who)
{
    const size_t expected = end - p->first;
    const char *want = p->talk->answers.at + p->first;
    if (p->talk->images && n >= VERDICT && number_at(got, 4) == NO_ROOM) {
        p->result->met.no_room = true;
        return VERDICT;
    }
    n = n < expected ? n : expected;
    take_unknown(p, want, got, n);
    for (size_t at = 0; at < expected; at++)
        if (at >= n || got[at] != want[at]) {
            blame(p, at, want, got, n, who);
            break;
        }
    return n;
}

void talk_compare(Talk *t, char *got, size_t n, const char *who)
{
    for (uint32_t i = 0; i < t->n; i++) {
        const size_t end = i + 1 < t->n ? t->part[i + 1].first : t->answers.n;
        const size_t used = compare_part(&t->part[i], end, got, n, who);
        got += used;
        n -= used;
    }
}
