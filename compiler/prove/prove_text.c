// SPDX-License-Identifier: Apache-2.0
#include "compiler/prove/prove_text.h"

#include <string.h>

#include "compiler/base/json.h"
#include "compiler/prove/prove_given.h"
#include "compiler/search/script_writer.h"

static const char *const assumption_text[PROVE_ASSUMPTIONS] = {
    "only this machine writes the elements that it assigns",
    "in the first step G and the elements that the machine assigns are 0",
    "the parameters have the values in the source (smc sweep tries others)",
    "elements with @range have values in it",
};

static const char *const assumption_name[PROVE_ASSUMPTIONS] = {"own-outputs", "zero-start", "parameters", "ranges"};

const char *prove_verdict_name(ProveVerdict v)
{
    static const char *const name[] = {"proved", "vacuous", "violated", "undecided", "interrupted", "violated-alone"};

    return name[v];
}

// ---- invariants ----

static bool is_below(Fact f, SmType type) { return f.hi < fact_of_type(type).hi; }
static bool is_above(Fact f, SmType type) { return f.lo > fact_of_type(type).lo; }

static void append_bound(Arena *arena, const ProveBound *b, Buf *out)
{
    const char *name = b->var->name->text;
    const SmType type = b->var->type;
    const Fact f = b->fact;

    if (f.lo > f.hi)
        return;
    if (out->n)
        buf_str(out, ", ");
    if (type == SM_BOOL)
        buf_printf(out, "%s is %s", name, f.lo > 0 ? "true" : "false");
    else if (f.lo == f.hi)
        buf_printf(out, "%s is %s", name, const_text(arena, f.lo));
    else if (is_above(f, type) && is_below(f, type))
        buf_printf(out, "%s is from %s to %s", name, const_text(arena, f.lo), const_text(arena, f.hi));
    else
        buf_printf(out, "%s is at %s %s", name, is_below(f, type) ? "most" : "least", const_text(arena, is_below(f, type) ? f.hi : f.lo));
}

const char *prove_invariant_text(Arena *arena, const ProveInvariant *i)
{
    Buf out;

    buf_init(&out, arena);
    for (uint32_t k = 0; k < i->bound.n; k++)
        append_bound(arena, &i->bound.at[k], &out);
    return out.n ? buf_text(&out) : NULL;
}

// ---- scripts ----

const char *prove_script(Arena *arena, const Program *p, const ProveOf *of)
{
    Engine *e = engine_ref_open(arena, p);
    const char *comment[1];
    ScriptPage page = {.p = p, .scenario = of->scenario, .engine = e, .comment = comment, .comments = 1};
    Buf out;
    bool written;

    comment[0] = format_in(arena, "Violates %s (%s).", of->what->id->text, of->what->text->text);
    buf_init(&out, arena);
    written = script_write(arena, &page, &out);
    e->close(e);
    return written ? buf_text(&out) : NULL;
}

// ---- text ----

// By ProveObstacle: `obstacle_text` in text, `obstacle_name` in JSON.
static const char *const obstacle_text[] = {"what is known about the values is too little for a proof",
                                            "a proof needs too many abstract states"};
static const char *const obstacle_name[] = {"facts-too-weak", "too-large"};

const char *prove_verdict_words(ProveVerdict v)
{
    static const char *const word[] = {"proved", "vacuous", "violated", "no violation found", "not decided", "violated alone"};

    return word[v];
}

static void write_assumptions(const ProveOf *of, size_t indent, Buf *out)
{
    for (int a = 0; a < PROVE_ASSUMPTIONS; a++)
        if (of->assumed >> a & 1)
            buf_printf(out, "%*sassuming that %s\n", (int)indent, "", assumption_text[a]);
}

static void write_invariants(Arena *arena, const Program *p, const ProveOf *of, size_t indent, Buf *out)
{
    for (uint32_t s = 0; s < p->state.n; s++) {
        const ProveInvariant *i = &of->invariant[s];
        const char *text = i->reached ? prove_invariant_text(arena, i) : "it is never reached";
        if (text)
            buf_printf(out, "%*sin %s: %s\n", (int)indent, "", i->state->name->text, text);
    }
}

static void write_lines_indented(const char *text, size_t indent, Buf *out)
{
    while (*text) {
        const char *end = strchr(text, '\n');
        const size_t n = end ? (size_t)(end - text) : strlen(text);
        if (n)
            buf_spaces(out, indent);
        buf_put(out, text, n);
        buf_char(out, '\n');
        text += n + (end != NULL);
    }
}

// ---- no proof, and no violation ----

// Returns what has too many values, in words.
static const char *wide_text(Arena *arena, const ProveWide *w)
{
    if (w->var)
        return w->var->name->text;
    if (!w->window)
        return "the time that the requirement waits";
    return format_in(arena, "the samples of %.*s", (int)w->window->span.len, w->window->span.src->text + w->window->span.at);
}

static bool is_untried(const ProveOf *of, uint32_t state) { return !of->tried[state] && !of->excluded[state]; }

// Writes the states that no run came to.
static void write_untried(const Program *p, const ProveOf *of, size_t indent, Buf *out)
{
    uint32_t n = 0;

    for (uint32_t s = 0; s < p->state.n; s++)
        if (is_untried(of, s)) {
            if (n++ == 0)
                buf_printf(out, "%*sno run that was tried came to ", (int)indent, "");
            else
                buf_str(out, ", ");
            buf_str(out, p->state.at[s]->name->text);
        }
    if (n)
        buf_str(out, "\n");
}

static bool is_time(const Program *p, const ProveWide *w) { return !w->window && (!w->var || w->var == p->t || w->var == p->g); }

// The longest time with which a state compares T.
typedef struct LongestTimer { const Program *p; const State *state, *found; double time; } LongestTimer;

static void note_timer(Expr *e, void *context)
{
    LongestTimer *l = context;

    for (uint32_t n = 0; (e->kind == EX_BINARY || e->kind == EX_CHAIN) && n + 1 < e->n; n++) {
        const Expr *a = e->arg[n], *b = e->arg[n + 1], *timer = a->kind == EX_VAR ? a : b, *time = timer == a ? b : a;
        if (timer->kind == EX_VAR && timer->var == l->p->t && time->kind == EX_NUMBER && time->number > l->time) {
            l->time = time->number;
            l->found = l->state;
        }
    }
}

static void note_timers(LongestTimer *l, const Stmts *list)
{
    for (uint32_t i = 0; i < list->n; i++) {
        if (list->at[i]->value)
            expr_walk(list->at[i]->value, note_timer, l);
        note_timers(l, &list->at[i]->then);
        note_timers(l, &list->at[i]->otherwise);
    }
}

// Writes what to make shorter if T has too many values.
static void write_timer(Arena *arena, const Program *p, Buf *out)
{
    LongestTimer l = {.p = p};

    for (uint32_t s = 0; s < p->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++) {
            l.state = p->state.at[s];
            note_timers(&l, &l.state->block[b]);
        }
    if (!l.found)
        buf_str(out, "a limit on T in the states that have none");
    else
        buf_printf(out, "a shorter timer than %s%s%s in %s", const_text(arena, l.time), p->uses_time_unit ? " " : "", p->uses_time_unit ? time_unit_name(p->time_unit) : "",
                   l.found->name->text);
}

// Writes, for each variable, window or time with too many values for an exploration, a change of the machine that gives it fewer.
static void write_remedies(Arena *arena, const Program *p, const ProveOf *of, size_t indent, Buf *out)
{
    bool has_timer = false;

    buf_printf(out, "%*sa proof can become possible by: ", (int)indent, "");
    for (uint32_t n = 0; n < of->wides; n++) {
        const ProveWide *w = &of->wide[n];
        const bool is_timer = is_time(p, w) && w->var;
        if (is_timer && has_timer)
            continue;
        has_timer |= is_timer;
        if (n)
            buf_str(out, "; ");
        if (w->window)
            buf_printf(out, "fewer samples in %.*s", (int)w->window->span.len, w->window->span.src->text + w->window->span.at);
        else if (is_timer)
            write_timer(arena, p, out);
        else if (!w->var)
            buf_str(out, "a shorter time after 'within'");
        else
            buf_printf(out, "fewer values of '%s', such as a counter that stops at a limit", w->var->name->text);
    }
    buf_char(out, '\n');
}

// Writes which variables the exploration could not follow exactly.  Leaves out T unless the machine is too large: T always has many values.
static void write_wides(Arena *arena, const Program *p, const ProveOf *of, size_t indent, Buf *out)
{
    const bool large = of->obstacle == PROVE_TOO_LARGE;
    uint32_t written = 0;

    for (uint32_t n = 0; n < of->wides; n++) {
        if (!large && is_time(p, &of->wide[n]))
            continue;
        if (written++)
            buf_str(out, ", ");
        else
            buf_printf(out, "%*s%s: ", (int)indent, "", large ? "too many values for a proof have" : "known only as ranges of values");
        buf_str(out, wide_text(arena, &of->wide[n]));
    }
    if (written)
        buf_char(out, '\n');
    if (written && !large)
        buf_printf(out, "%*sa proof can become possible by: limits on them that the machine keeps, such as clamp(x, 0, 100)\n", (int)indent, "");
}

static void write_undecided(Arena *arena, const Program *p, const ProveOf *of, size_t indent, Buf *out)
{
    buf_printf(out, "%*s%llu steps were tried; %s\n", (int)indent, "", (unsigned long long)of->steps, obstacle_text[of->obstacle]);
    write_untried(p, of, indent, out);
    buf_printf(out, "%*s%lu abstract states and %llu paths were examined\n", (int)indent, "", (unsigned long)of->nodes,
               (unsigned long long)of->visits);
    write_wides(arena, p, of, indent, out);
    if (of->obstacle == PROVE_TOO_LARGE && of->wides)
        write_remedies(arena, p, of, indent, out);
}

static void write_names(const Var *const *var, uint32_t n, Buf *out)
{
    for (uint32_t i = 0; i < n; i++)
        buf_printf(out, "%s'%s'", i == 0 ? "" : i + 1 < n ? ", " : " and ", var[i]->name->text);
}

// Writes which ranges of inputs can help.
static void write_range_advice(const ProveOf *of, Buf *out)
{
    if (of->rangeds) {
        buf_str(out, "--assume-ranges, if there are no values beyond the @range of ");
        write_names(of->ranged, of->rangeds, out);
        buf_str(out, "; ");
    }
    if (of->unrangeds) {
        buf_str(out, "@range on ");
        write_names(of->unranged, of->unrangeds, out);
        buf_str(out, ", with --assume-ranges; ");
    }
}

// Writes what the user of the command can do.
static void write_advice(const Program *p, const ProveResult *r, const ProveOf *of, size_t indent, Buf *out)
{
    enum { MILLION = 1000000, LONGER = 10 };
    const uint64_t effort = (r->effort + MILLION - 1) / MILLION * LONGER;
    bool untried = false;

    for (uint32_t s = 0; s < p->state.n; s++)
        untried = untried || is_untried(of, s);
    buf_printf(out, "%*swhat can help: ", (int)indent, "");
    if (untried)
        buf_str(out, "a script that comes to these states, named in the command; ");
    else if (!of->premise_seen)
        buf_str(out, "a script that comes to the premise, named in the command; ");
    write_range_advice(of, out);
    buf_printf(out, "--effort=%llu, which searches %slonger\n", (unsigned long long)effort, r->can_prove_longer ? "and proves " : "");
}

// Writes how much was tried before the interruption, which shows how long the requirement takes, but nothing about it.
static void write_interrupted(const ProveOf *of, size_t indent, Buf *out)
{
    if (of->steps == 0 && of->visits == 0)
        buf_printf(out, "%*sinterrupted before anything was tried\n", (int)indent, "");
    else
        buf_printf(out, "%*sinterrupted after %llu steps of runs and %llu paths of proofs; this says nothing about it\n", (int)indent, "",
                   (unsigned long long)of->steps,
                   (unsigned long long)of->visits);
}

// Writes which given script violates the requirement, in which step, if some inputs are different there.
static void write_near_given(const ProveNear *n, size_t indent, Buf *out)
{
    buf_printf(out, "%*sthe script %s violates it in its step %llu if ", (int)indent, "", n->given->name, (unsigned long long)n->step);
    for (uint32_t i = 0; i < n->vars; i++) {
        buf_printf(out, "%s%s is ", i ? " and " : "", n->var[i]->name->text);
        script_write_value(out, n->var[i]->type, n->value[i]);
    }
    if (n->from == n->to)
        buf_printf(out, " in its step %llu\n", (unsigned long long)n->from);
    else
        buf_printf(out, " from its step %llu to %llu\n", (unsigned long long)n->from, (unsigned long long)n->to);
}

void prove_write_reason(Arena *arena, const Program *p, const ProveOf *of, size_t indent, Buf *out)
{
    const char *script;

    if (!of->premise_seen && of->verdict == PROVE_PROVED)
        buf_printf(out, "%*sthe proof is about all runs; of those that were tried, none came to its premise\n", (int)indent, "");
    if (!of->premise_seen && of->verdict == PROVE_UNDECIDED)
        buf_printf(out, "%*sno run that was tried came to its premise, so this says little: scripts that come there show more\n", (int)indent, "");
    switch (of->verdict) {
    case PROVE_PROVED:
        write_assumptions(of, indent, out);
        write_invariants(arena, p, of, indent, out);
        break;
    case PROVE_VACUOUS:
        buf_printf(out, "%*sno run comes to its premise, so it requires nothing\n", (int)indent, "");
        write_assumptions(of, indent, out);
        write_invariants(arena, p, of, indent, out);
        break;
    case PROVE_VIOLATED: case PROVE_ALONE:
        if (of->given)
            buf_printf(out, "%*sthe script %s violates it in its step %llu\n", (int)indent, "", of->given->name, (unsigned long long)of->given_step);
        if (of->near)
            write_near_given(of->near, indent, out);
        buf_printf(out, "%*safter %lu steps\n", (int)indent, "", (unsigned long)of->scenario->steps);
        script = prove_script(arena, p, of);
        if (script)
            write_lines_indented(script, indent, out);
        break;
    case PROVE_UNDECIDED:
        write_undecided(arena, p, of, indent, out);
        break;
    case PROVE_INTERRUPTED:
        write_interrupted(of, indent, out);
        break;
    case PROVE_VERDICTS:
        break;
    }
}

// Writes which part of each given script was a starting point of the searches.
static void write_givens(const Program *p, const ProveResult *r, Buf *out)
{
    for (uint32_t i = 0; i < r->givens; i++) {
        const ProveGiven *g = &r->given[i];
        const bool used = prove_uses_given(g, r->init_state, r->delta_t);
        buf_printf(out, "  script %s: ", g->name);
        if (!used && g->run.init_state != r->init_state)
            buf_printf(out, "not used, because it begins in state %s\n", g->run.init_state->name->text);
        else if (!used && g->run.delta_t != r->delta_t)
            buf_printf(out, "not used, because it has a step every %llu\n", (unsigned long long)g->run.delta_t);
        else if (!g->ended_by)
            buf_printf(out, "%llu steps\n", (unsigned long long)g->run.steps);
        else
            buf_printf(out, "the first %llu of %llu steps, because then it %s '%s'%s\n", (unsigned long long)g->run.steps, (unsigned long long)g->ran,
                       g->ended_by == p->g ? "changes the step of" : "sets", g->ended_by->name->text,
                       g->ended_by == p->g || g->ended_by->kind != VAR_ELEMENT ? "" : ", which the machine assigns");
    }
}

void prove_write_head(const Program *p, const ProveResult *r, Buf *out)
{
    buf_printf(out, "requirements of %s, from state %s, with a step every %llu", p->name->text, r->init_state->name->text,
               (unsigned long long)r->delta_t);
    if (p->uses_time_unit)
        buf_printf(out, " %s", time_unit_name(p->time_unit));
    buf_str(out, ":\n");
    write_givens(p, r, out);
}

void prove_write_verdict(Arena *arena, const Program *p, const ProveResult *r, uint32_t n, Buf *out)
{
    const ProveOf *of = &r->of[n];
    size_t width = 0;

    for (uint32_t i = 0; i < r->n; i++)
        width = r->of[i].what->id->len > width ? r->of[i].what->id->len : width;
    buf_printf(out, "  %-*s  %-18s  %s\n", (int)width, of->what->id->text, prove_verdict_words(of->verdict), of->what->text->text);
    prove_write_reason(arena, p, of, 6, out);
    if (of->verdict == PROVE_UNDECIDED)
        write_advice(p, r, of, 6, out);
}

void prove_write_text(Arena *arena, const Program *p, const ProveResult *r, Buf *out)
{
    prove_write_head(p, r, out);
    for (uint32_t i = 0; i < r->n; i++)
        prove_write_verdict(arena, p, r, i, out);
}

// ---- JSON ----

static void write_json_number(Arena *arena, double x, Buf *out)
{
    if (x - x != 0)
        buf_str(out, "null");
    else
        buf_str(out, const_text(arena, x));
}

static void write_json_invariants(Arena *arena, const Program *p, const ProveOf *of, Buf *out)
{
    const char *separator = "";

    buf_str(out, ",\"invariants\":[");
    for (uint32_t s = 0; of->invariant && s < p->state.n; s++) {
        const ProveInvariant *i = &of->invariant[s];
        buf_printf(out, "%s{\"state\":", separator);
        json_put_string(out, i->state->name->text);
        buf_printf(out, ",\"reached\":%s,\"values\":[", i->reached ? "true" : "false");
        for (uint32_t k = 0; k < i->bound.n; k++) {
            buf_printf(out, "%s{\"name\":", k ? "," : "");
            json_put_string(out, i->bound.at[k].var->name->text);
            buf_str(out, ",\"least\":");
            write_json_number(arena, i->bound.at[k].fact.lo, out);
            buf_str(out, ",\"most\":");
            write_json_number(arena, i->bound.at[k].fact.hi, out);
            buf_char(out, '}');
        }
        buf_str(out, "]}");
        separator = ",";
    }
    buf_char(out, ']');
}

static void write_json_obstacle(Arena *arena, const Program *p, const ProveOf *of, Buf *out)
{
    const char *separator = "";

    buf_printf(out, ",\"obstacle\":\"%s\",\"too_many_values\":[", obstacle_name[of->obstacle]);
    for (uint32_t n = 0; n < of->wides; n++) {
        buf_str(out, n ? "," : "");
        json_put_string(out, wide_text(arena, &of->wide[n]));
    }
    buf_str(out, "],\"untried_states\":[");
    for (uint32_t s = 0; s < p->state.n; s++)
        if (is_untried(of, s)) {
            buf_str(out, separator);
            json_put_string(out, p->state.at[s]->name->text);
            separator = ",";
        }
    buf_char(out, ']');
}

static void write_json_near(Arena *arena, const ProveNear *n, Buf *out)
{
    buf_str(out, ",\"violated_near\":");
    json_put_string(out, n->given->name);
    buf_printf(out, ",\"violated_near_step\":%llu,\"other_inputs\":[", (unsigned long long)n->step);
    for (uint32_t i = 0; i < n->vars; i++) {
        buf_str(out, i ? ",{\"name\":" : "{\"name\":");
        json_put_string(out, n->var[i]->name->text);
        buf_printf(out, ",\"value\":%s,\"from_step\":%llu,\"to_step\":%llu}", const_text(arena, n->value[i]), (unsigned long long)n->from, (unsigned long long)n->to);
    }
    buf_char(out, ']');
}

static void write_json_verdict(Arena *arena, const Program *p, const ProveOf *of, Buf *out)
{
    const char *separator = "";

    buf_str(out, "{\"id\":");
    json_put_string(out, of->what->id->text);
    buf_str(out, ",\"text\":");
    json_put_string(out, of->what->text->text);
    buf_printf(out, ",\"verdict\":\"%s\",\"premise_seen\":%s,\"steps\":%llu,\"abstract_states\":%lu,\"paths\":%llu,\"assumptions\":[",
               prove_verdict_name(of->verdict),
               of->premise_seen ? "true" : "false", (unsigned long long)of->steps, (unsigned long)of->nodes, (unsigned long long)of->visits);
    for (int a = 0; a < PROVE_ASSUMPTIONS; a++)
        if (of->assumed >> a & 1) {
            buf_printf(out, "%s\"%s\"", separator, assumption_name[a]);
            separator = ",";
        }
    buf_char(out, ']');
    if (of->verdict == PROVE_PROVED || of->verdict == PROVE_VACUOUS)
        write_json_invariants(arena, p, of, out);
    if (of->verdict == PROVE_UNDECIDED)
        write_json_obstacle(arena, p, of, out);
    if (of->verdict == PROVE_VIOLATED) {
        buf_printf(out, ",\"violated_after\":%llu,\"changes\":%lu,\"script\":", (unsigned long long)of->scenario->steps,
                   (unsigned long)of->scenario->changes);
        json_put_string(out, prove_script(arena, p, of));
        if (of->given) {
            buf_str(out, ",\"violated_by\":");
            json_put_string(out, of->given->name);
            buf_printf(out, ",\"violated_by_step\":%llu", (unsigned long long)of->given_step);
        }
        if (of->near)
            write_json_near(arena, of->near, out);
    }
    buf_char(out, '}');
}

void prove_write_json(Arena *arena, const Program *p, const ProveResult *r, Buf *out)
{
    buf_str(out, "{\"smc-proofs\":1,\"machine\":");
    json_put_string(out, p->name->text);
    buf_str(out, ",\"state\":");
    json_put_string(out, r->init_state->name->text);
    buf_printf(out, ",\"delta_t\":%llu,\"scripts\":[", (unsigned long long)r->delta_t);
    for (uint32_t i = 0; i < r->givens; i++) {
        const ProveGiven *g = &r->given[i];
        buf_str(out, i ? ",{\"name\":" : "{\"name\":");
        json_put_string(out, g->name);
        buf_printf(out, ",\"steps\":%llu,\"used\":%llu}", (unsigned long long)g->ran,
                   (unsigned long long)(prove_uses_given(g, r->init_state, r->delta_t) ? g->run.steps : 0));
    }
    buf_str(out, "],\"requirements\":[\n");
    for (uint32_t i = 0; i < r->n; i++) {
        write_json_verdict(arena, p, &r->of[i], out);
        buf_str(out, i + 1 < r->n ? ",\n" : "\n");
    }
    buf_str(out, "]}\n");
}
