// SPDX-License-Identifier: Apache-2.0
// Mutants in words, in order and in numbers, for texts and reports.
#include <inttypes.h>
#include <stdlib.h>

#include "compiler/analysis/transitions.h"
#include "compiler/cover/mutate.h"
#include "stdlib/convert.h"

static int compare_danger(const void *a, const void *b)
{
    const Mutant *x = *(const Mutant *const *)a, *y = *(const Mutant *const *)b;

    if (x->danger != y->danger)
        return x->danger > y->danger ? -1 : 1;
    return x < y ? -1 : x > y;
}

const Mutant **mutation_order(const Mutation *u, Arena *arena, MutantVerdict verdict, uint32_t *n)
{
    uint32_t all;
    const Mutant *m = mutation_list(u, &all), **order = arena_array(arena, all + (size_t)1, sizeof *order);

    *n = 0;
    for (uint32_t i = 0; i < all; i++)
        if (m[i].verdict == verdict)
            order[(*n)++] = &m[i];
    qsort(order, *n, sizeof *order, compare_danger);
    return order;
}

MutationScore mutation_score(const Mutation *u)
{
    MutationScore s = {0, {0}, 0, 100};
    uint32_t n;
    const Mutant *m = mutation_list(u, &n);

    s.all = n;
    for (uint32_t i = 0; i < n; i++)
        s.of[m[i].verdict]++;
    s.noticeable = s.of[MUTANT_NOTICED] + s.of[MUTANT_GENERATED] + s.of[MUTANT_UNNOTICED];
    if (s.noticeable)
        s.percent = 100 * (double)s.of[MUTANT_NOTICED] / (double)s.noticeable;
    return s;
}

void mutant_write_change(Arena *arena, const Mutant *m, Buf *out)
{
    static const char *const about[] = {"", "", ", an output", ", a hazardous output", ", on the way to an @abort state"};

    buf_printf(out, "`%s` ", source_text(arena, m->span));
    if (m->text[0] == 'i')
        buf_str(out, "removed");
    else if (m->text[0] == '\0')
        buf_str(out, "left out");
    else
        buf_printf(out, "changed to `%s`", m->text);
    if (m->state)
        buf_printf(out, " in %s", m->state->name->text);
    buf_str(out, about[m->danger]);
}

// Appends the change of an input: "pressure = 776", "pressure from 776 by 0.5 a step".
static void write_input(const Program *p, const ScenarioChange *c, Buf *out)
{
    const Var *v = p->var.at[c->var];

    buf_printf(out, "%s %s ", v->report_name->text, c->kind == SCENARIO_RAMP ? "from" : "=");
    if (c->kind == SCENARIO_COPY) {
        buf_str(out, p->var.at[c->source]->report_name->text);
        return;
    }
    format_cell_stored(out, v->type, sm_cell_from_f64(v->type, c->a));
    if (c->kind == SCENARIO_ALTERNATE) {
        buf_str(out, " and ");
        format_cell_stored(out, v->type, sm_cell_from_f64(v->type, c->b));
        buf_str(out, " in turn");
    } else if (c->kind == SCENARIO_RAMP) {
        buf_str(out, " by ");
        format_number_shortest(out, c->b);
        buf_str(out, " a step");
    }
}

void mutant_write_scenario(const Program *p, const Mutant *m, size_t most, Buf *out)
{
    const Scenario *s = m->scenario;

    buf_printf(out, "from %s", s->init_state->name->text);
    for (size_t i = 0; i < s->changes && i < most; i++) {
        if (i > 0 && s->change[i].step == s->change[i - 1].step)
            buf_str(out, ", ");
        else
            buf_printf(out, "%s at G = %" PRIu64 ": ", i ? ";" : ",", (s->change[i].step - 1) * s->delta_t);
        write_input(p, &s->change[i], out);
    }
    if (s->changes > most)
        buf_printf(out, "; and %lu more inputs", (unsigned long)(s->changes - most));
    buf_printf(out, "%s at G = %" PRIu64 ", %s differs", s->changes ? ";" : ",", (s->steps - 1) * s->delta_t, (m->differs ? m->differs : p->s)->report_name->text);
}
