// SPDX-License-Identifier: Apache-2.0
// Saves and restores the state of a run between two steps: a copy of each piece of memory that a step reads and writes.
#include "compiler/script/script_run.h"

#include <string.h>

struct RunPoint {
    uint64_t g;
    uint64_t steps, asserts_passed;
    uint64_t prints;
    size_t printed;           // length of ScriptRun.printed in bytes
    ScriptMachine machine;
    EngineNext next;
    PendingExpect *pending;
    uint32_t pendings;
    const Requirement *violated;
    char *memory;             // copies of all pieces of memory, one after another, in the order of the list
};

// An address range of a run's memory whose content a saved point has to contain.
typedef struct Piece { void *at; size_t size; } Piece;

typedef VEC(Piece) Pieces;

// Adds a piece of memory to those that a saved point of the run has to contain.
static void add_piece(Arena *arena, Pieces *list, void *at, size_t size)
{
    const Piece p = {at, size};

    if (size)
        vec_push(arena, list, p);
}

static void add_window(Arena *arena, Pieces *list, RefWindow *w)
{
    void *samples = w->slot ? (void *)w->slot : (void *)w->time;

    add_piece(arena, list, w, sizeof *w);
    add_piece(arena, list, samples, ref_window_samples(w->what) * sizeof(uint64_t));
}

// Lists the pieces of the run's memory that steps change and whose size is constant during the run.
static Pieces list_pieces(ScriptRun *r)
{
    Pieces list = {0};
    size_t items = 0, asserts = 0;

    for (size_t i = 0; i < r->s->section.n; i++)
        for (size_t k = 0; k < r->s->section.at[i].item.n; k++) {
            items++;
            asserts += r->s->section.at[i].item.at[k]->asserts.n;
        }
    add_piece(r->arena, &list, r->cell, (r->p->var.n + r->s->local.n) * sizeof *r->cell);
    add_piece(r->arena, &list, r->random.stream, r->s->random.n * sizeof *r->random.stream);
    add_piece(r->arena, &list, r->true_in, items * sizeof *r->true_in);
    add_piece(r->arena, &list, r->is_pending, asserts);
    add_piece(r->arena, &list, r->evaluated, asserts);
    add_piece(r->arena, &list, r->ran, r->p->state.n * sizeof *r->ran);
    add_piece(r->arena, &list, r->ran_at, r->p->state.n * sizeof *r->ran_at);
    for (size_t i = 0; i < r->windows.n; i++)
        add_window(r->arena, &list, &r->windows.at[i]);
    if (r->monitor) {
        add_piece(r->arena, &list, r->situation, r->monitor->size);
        add_piece(r->arena, &list, r->requirement, r->o->requirements->at.n * sizeof *r->requirement);
    }
    return list;
}

static const Pieces *pieces_of(ScriptRun *r)
{
    if (!r->pieces) {
        Pieces list = list_pieces(r);
        r->pieces = arena_copy(r->arena, &list, sizeof list);
    }
    return r->pieces;
}

bool run_has_points(const Script *s) { return !s->data && !s->program->joint; }

RunPoint *run_save_point(ScriptRun *r, Arena *arena)
{
    const Pieces *list = pieces_of(r);
    RunPoint *p = ARENA_NEW(arena, RunPoint);
    size_t size = 0;

    for (uint32_t i = 0; i < list->n; i++)
        size += list->at[i].size;
    p->memory = arena_alloc_unzeroed(arena, size);
    size = 0;
    for (uint32_t i = 0; i < list->n; size += list->at[i++].size)
        memcpy(p->memory + size, list->at[i].at, list->at[i].size);
    p->g = r->g;
    p->steps = r->result.steps;
    p->asserts_passed = r->result.asserts_passed;
    p->prints = r->prints;
    p->printed = r->printed.n;
    p->machine = r->machine[0];
    p->next = engine_next(&r->answer[0], 0);
    p->violated = r->violated;
    p->pendings = r->pending.n;
    p->pending = r->pending.n ? arena_copy(arena, r->pending.at, r->pending.n * sizeof *p->pending) : NULL;
    return p;
}

void run_restore_point(ScriptRun *r, const RunPoint *p)
{
    const Pieces *list = pieces_of(r);
    size_t at = 0;

    for (uint32_t i = 0; i < list->n; at += list->at[i++].size)
        memcpy(list->at[i].at, p->memory + at, list->at[i].size);
    r->g = p->g;
    r->result.steps = p->steps;
    r->result.asserts_passed = p->asserts_passed;
    r->result.failed = NULL;
    r->prints = p->prints;
    r->printed.n = p->printed;
    r->machine[0] = p->machine;
    r->answer[0].next_state = p->next.state;
    r->answer[0].next_is_first = p->next.is_first;
    r->pending.n = 0;
    for (uint32_t i = 0; i < p->pendings; i++)
        vec_push(r->arena, &r->pending, p->pending[i]);
    r->failed = NULL;
    r->failed_item = NULL;
    r->violated = p->violated;
    r->ended = false;
    schedule_rewind(r->schedule);
}
