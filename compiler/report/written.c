// SPDX-License-Identifier: Apache-2.0
#include "compiler/report/written.h"

#include "compiler/report/describe.h"

// ---- sections [all_states] ----

// Returns the index of the section that contains the statement, found by binary search; the number of sections if it is a state's own.
static size_t section_index(const Program *p, Span span)
{
    size_t low = 0, high = p->all_states.n;

    if (!span.src || !span.src->copy_of)
        return p->all_states.n;
    while (high - low > 1) {
        const size_t middle = low + (high - low) / 2;
        if (p->all_states.at[middle]->span.at <= span.at)
            low = middle;
        else
            high = middle;
    }
    return low;
}

const AllStates *written_section(const Program *p, Span span)
{
    const size_t i = section_index(p, span);

    return i < p->all_states.n ? p->all_states.at[i] : NULL;
}

enum { EXCEPTED_NAMED = 3 };  // states that are named as exceptions although the others would be fewer

const char *written_section_name(Arena *arena, const Program *p, const AllStates *all, const char *mark)
{
    size_t excepted = 0, named, n = 0;
    bool names_excepted;
    Buf name;

    for (size_t s = 1; s <= p->state.n; s++)
        excepted += all->excepted[s];
    names_excepted = excepted <= EXCEPTED_NAMED || excepted <= p->state.n - excepted;
    named = names_excepted ? excepted : p->state.n - excepted;
    buf_init(&name, arena);
    buf_str(&name, excepted == 0 ? "all states" : names_excepted ? "all states except " : "the states ");
    for (size_t s = 1; s <= p->state.n; s++)
        if (excepted && all->excepted[s] == names_excepted) {
            buf_printf(&name, "%s%s%s%s", describe_separator(n, named), mark, p->state.at[s - 1]->name->text, mark);
            n++;
        }
    return buf_text(&name);
}

const State *written_first_state(const Program *p, const AllStates *all)
{
    for (size_t s = 0; s < p->state.n; s++)
        if (!all->excepted[s + 1])
            return p->state.at[s];
    return NULL;
}

Stmts written_section_stmts(const Program *p, const AllStates *all)
{
    const State *s = written_first_state(p, all);
    Stmts part = {NULL, 0, 0};

    if (!s)
        return part;
    part = s->block[BLOCK_STEP];
    while (part.n > 0 && written_section(p, part.at[0]->span) != all)
        part.at++, part.n--;
    while (part.n > 0 && written_section(p, part.at[part.n - 1]->span) != all)
        part.n--;
    return part;
}

// ---- states ----

// Without the copies of statements of [all_states], which come first in a block.
Stmts written_own_stmts(const State *s, BlockKind block)
{
    Stmts own = s->block[block];

    while (own.n > 0 && own.at[0]->span.src->copy_of)
        own.at++, own.n--;
    return own;
}

// Returns where the last of the statements ends in the source, or `end` if that is later.
static uint32_t end_of_statements(const Stmts *stmts, uint32_t end)
{
    for (size_t i = 0; i < stmts->n; i++) {
        const Stmt *s = stmts->at[i];
        if (s->span.at + s->span.len > end)
            end = s->span.at + s->span.len;
        end = end_of_statements(&s->otherwise, end_of_statements(&s->then, end));
    }
    return end;
}

Span written_state_range(const State *s)
{
    Span span = s->span;
    uint32_t end = span.at + span.len;

    for (int b = 0; b < BLOCK_COUNT; b++) {
        const Span label = s->block_span[b];
        const Stmts own = written_own_stmts(s, (BlockKind)b);
        if (label.src && !label.src->copy_of && label.at + label.len > end)
            end = label.at + label.len;
        end = end_of_statements(&own, end);
    }
    span.len = end - span.at;
    return span;
}

// ---- transitions ----

// Adds a transition of section i as one more copy of the transition that has the same position in the section.
static void add_copy(Arena *arena, const Program *p, WrittenTransitions *of, size_t i, size_t position, const Transition *t)
{
    const WrittenTransition first = {p->all_states.at[i], {NULL, 0, 0}};

    if (position == of[i].n)
        vec_push(arena, &of[i], first);
    vec_push(arena, &of[i].at[position].copy, t);
}

// In each state the transitions of a section are adjacent and have the same order.
WrittenTransitions written_transitions(Arena *arena, const Program *p, const Transitions *all)
{
    WrittenTransitions out = {NULL, 0, 0}, *of = ARENA_ARRAY(arena, WrittenTransitions, p->all_states.n + 1u);
    size_t position = 0, last = p->all_states.n;
    const State *from = NULL;

    for (size_t k = 0; k < all->n; k++) {
        const Transition *t = &all->at[k];
        const size_t i = section_index(p, t->stmt->span);
        WrittenTransition own = {NULL, {NULL, 0, 0}};
        position = i == last && t->from == from ? position + 1 : 0;
        last = i;
        from = t->from;
        if (i < p->all_states.n) {
            add_copy(arena, p, of, i, position, t);
            continue;
        }
        vec_push(arena, &own.copy, t);
        vec_push(arena, &out, own);
    }
    for (size_t i = 0; i < p->all_states.n; i++)
        for (size_t k = 0; k < of[i].n; k++)
            vec_push(arena, &out, of[i].at[k]);
    return out;
}
