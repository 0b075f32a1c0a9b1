// SPDX-License-Identifier: Apache-2.0
#include "compiler/analysis/questions.h"

#include <stdio.h>
#include <stdlib.h>

typedef struct Wanted { uint32_t number; const Stmt *found; } Wanted;

static void find_stmt(const Stmt *s, void *context)
{
    Wanted *w = context;

    if (s->number == w->number)
        w->found = s;
}

const Stmt *question_stmt(const Trials *t, uint32_t number)
{
    Wanted w = {number, NULL};

    each_stmt(t->a->p, find_stmt, &w);
    return w.found;
}

static bool is_among(const Stmts *stmts, const Stmt *stmt)
{
    for (size_t i = 0; i < stmts->n; i++)
        if (stmts->at[i] == stmt || is_among(&stmts->at[i]->then, stmt) || is_among(&stmts->at[i]->otherwise, stmt))
            return true;
    return false;
}

bool question_state(const Stmt *stmt, const State *s)
{
    for (int b = 0; b < BLOCK_COUNT; b++)
        if (is_among(&s->block[b], stmt))
            return true;
    return false;
}

const char *question_names(Arena *arena, const Var *const *v, uint32_t n)
{
    const char *text = v[0]->name->text;

    for (uint32_t i = 1; i < n; i++)
        text = format_in(arena, i + 1 < n ? "%s', '%s" : "%s' and '%s", text, v[i]->name->text);
    return text;
}

double question_rounded(double x)
{
    char text[32];

    snprintf(text, sizeof text, "%.4g", x);
    return strtod(text, NULL);
}

void analyse_trials(Analysis *a)
{
    Trials *t = trials_of(a);

#define QUESTION(name, sentence) question_##name(t);
#include "compiler/analysis/questions.def"
#undef QUESTION
}
