// SPDX-License-Identifier: Apache-2.0
#include "compiler/whatif/sweep.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

#include "compiler/base/path.h"
#include "compiler/cover/cover.h"
#include "compiler/script/ref.h"

enum { SWEEP_MAP = SWEEP_AXES };      // in place of an axis: the map of two parameters

// A check fails at exactly one of the points `point` and point + 1 of the line of `axis`, so a boundary between them is searched.
typedef struct Gap { uint32_t axis, check, point; } Gap;

struct SweepRunner {
    Sweep *s;
    Arena *arena;             // memory of the results
    Arena run;                // memory of one run of a script
    FlatMachine **flat;       // the machines that all runs share
    uint32_t next_point;      // index in Sweep.point of the next point of the map
    uint32_t axis, next;      // the next point of the lines: its axis, and its index on that line
    bool has_gaps;            // `gap` has been filled, because all points have run
    VEC(Gap) gap;
    uint32_t next_gap;
    uint8_t *violated;        // by requirement: 1 if a run at the current point violated it
};

// ---- what can fail ----

static void add_check(SweepRunner *x, SweepCheck c) { vec_push(x->arena, &x->s->check, c); }

static void add_asserts(SweepRunner *x, uint32_t script, const ScriptItem *item)
{
    for (uint32_t k = 0; k < item->asserts.n; k++)
        if (item->asserts.at[k].kind != SCRIPT_PRINT)
            add_check(x, (SweepCheck){script, &item->asserts.at[k], item->first_assert + k, NULL});
}

// Lists what each point of the sweep is checked for: all requirements, then the asserts of all scripts.
static void list_checks(SweepRunner *x)
{
    const Requirements *rq = x->s->options.requirements;

    for (uint32_t i = 0; rq && i < rq->at.n; i++)
        add_check(x, (SweepCheck){0, NULL, 0, &rq->at.at[i]});
    for (uint32_t i = 0; i < x->s->scripts; i++) {
        const Script *s = x->s->script[i];
        for (uint32_t k = 0; k < s->section.n; k++)
            for (uint32_t j = 0; j < s->section.at[k].item.n; j++)
                add_asserts(x, i, s->section.at[k].item.at[j]);
        add_check(x, (SweepCheck){i, NULL, 0, NULL});
    }
}

void sweep_write_check(const Sweep *s, uint32_t check, Buf *out)
{
    const SweepCheck *c = &s->check.at[check];
    Span span;

    if (c->requirement) {
        buf_str(out, c->requirement->id->text);
    } else if (c->assert) {
        span = c->assert->condition ? c->assert->condition->span : c->assert->remark->span;
        buf_printf(out, "%s:%lu", source_short_name(span.src), (unsigned long)source_position(span.src, span.at).line);
    } else
        buf_printf(out, "%s does not end", source_short_name(s->script[c->script]->src));
}

// ---- one point ----

// Marks the requirements that this step violates.
static void note_violations(void *context, const ScriptStep *step)
{
    SweepRunner *x = context;

    for (uint32_t i = 0; step->results && i < x->s->options.requirements->at.n; i++)
        x->violated[i] |= step->results[i] == MONITOR_VIOLATED;
}

// Whether the script sets the parameter itself.  It keeps that value in all runs.
static bool script_sets(const Script *s, const Var *parameter)
{
    for (uint32_t k = 0; k < s->setting.n; k++)
        if (s->setting.at[k].parameter == parameter)
            return true;
    return false;
}

bool sweep_takes_part(const Sweep *s, uint32_t axis, uint32_t script) { return !script_sets(s->script[script], s->axis[axis].parameter); }

bool sweep_is_alone(const Sweep *s, uint32_t axis)
{
    for (uint32_t i = 0; i < s->scripts; i++)
        if (sweep_takes_part(s, axis, i))
            return false;
    return true;
}

// Runs a script with the parameters at these values, except those that it sets itself, and notes what fails.
static void run_script(SweepRunner *x, uint32_t script, const double *value, uint8_t *fails)
{
    const Sweep *s = x->s;
    ScriptSetting *setting;
    ScriptOptions o = {.max_steps = s->options.max_steps, .seed = s->options.seed, .after_step = note_violations, .context = x, .is_silent = true,
                       .is_compared = true, .continues = true, .requirements = s->options.requirements,
                       .ignored = s->options.ignored ? s->options.ignored[script] : NULL};
    ScriptResult r;
    Diags unused;
    Engine *e;

    arena_reset(&x->run);
    setting = ARENA_ARRAY(&x->run, ScriptSetting, s->options.settings + SWEEP_AXES);
    for (size_t i = 0; i < s->options.settings; i++)
        setting[o.settings++] = s->options.setting[i];
    for (uint32_t i = 0; i < s->options.axes; i++)
        if (sweep_takes_part(s, i, script))
            setting[o.settings++] = (ScriptSetting){s->axis[i].parameter, ref_convert(s->axis[i].parameter->type, value[i]), {0}};
    o.setting = setting;
    diags_init(&unused, &x->run);
    unused.muted = true;
    e = engine_flat_open_machines(&x->run, s->p, x->flat, NULL, 0);
    r = script_run(&x->run, &unused, s->script[script], &e, 1, &o);
    x->s->runs++;
    for (uint32_t c = 0; c < s->check.n; c++) {
        const SweepCheck *k = &s->check.at[c];
        if (k->assert && k->script == script)
            fails[c] |= r.failed_asserts[k->assert_number];
        else if (!k->assert && !k->requirement && k->script == script)
            fails[c] |= r.outcome != SCRIPT_PASSED;
    }
}

// Whether the script runs on the line of this axis; for SWEEP_MAP, on the map of two.
static bool is_run(const Sweep *s, uint32_t axis, uint32_t script)
{
    return axis == SWEEP_MAP ? sweep_takes_part(s, 0, script) || sweep_takes_part(s, 1, script) : sweep_takes_part(s, axis, script);
}

// Runs the scripts of this axis, or of SWEEP_MAP, with the parameters at one point; returns which checks fail there.
static SweepPoint run_point(SweepRunner *x, uint32_t axis, const double *value, Arena *arena)
{
    const Sweep *s = x->s;
    SweepPoint p = {{value[0], value[1]}, arena_alloc(arena, s->check.n + 1), 0};

    memset(x->violated, 0, s->check.n + 1);
    for (uint32_t i = 0; i < s->scripts; i++)
        if (is_run(s, axis, i))
            run_script(x, i, value, p.fails);
    for (uint32_t c = 0; c < s->check.n && s->check.at[c].requirement; c++)
        p.fails[c] = x->violated[c];                  // the first entries of `check` are the requirements
    for (uint32_t c = 0; c < s->check.n; c++)
        p.failing += p.fails[c] != 0;
    return p;
}

// Whether one check fails on the line of this axis with the parameters at these values.
static bool check_fails(SweepRunner *x, uint32_t axis, uint32_t check, const double *value)
{
    const SweepCheck *c = &x->s->check.at[check];
    Arena own;
    uint8_t *fails;
    bool result;

    arena_init(&own, x->arena->alloc, x->arena->context, x->arena->oom);
    fails = arena_alloc(&own, x->s->check.n + 1);
    if (c->requirement)
        fails[check] = run_point(x, axis, value, &own).fails[check];
    else
        run_script(x, c->script, value, fails);
    result = fails[check] != 0;
    arena_free(&own);
    return result;
}

// ---- the boundaries ----

static bool is_whole(SmType t) { return sm_type_info[t].kind != SM_KIND_FLOAT; }

// Returns the whole number nearest to x, halves to even; x itself if it has no fraction that a double could hold.
static double rint_f64(double x)
{
    const double large = 4503599627370496.0;          // 2^52
    const double magnitude = x < 0 ? -x : x, whole = magnitude < large ? magnitude + large - large : magnitude;

    return x < 0 ? -whole : whole;
}

// A power of ten as a step: `factor`, or with is_part 1 / factor.  `factor` is exact, but 1 / factor is not.
typedef struct RoundStep { double factor; bool is_part; } RoundStep;

// Returns the largest power of ten that is at most x, but at least 1e-300.
static RoundStep round_step(double x)
{
    RoundStep s = {1, x < 1};

    while (s.is_part ? 1 / s.factor > x && s.factor < 1e300 : s.factor * 10 <= x)
        s.factor *= 10;
    return s;
}

static double size_of_step(RoundStep s) { return s.is_part ? 1 / s.factor : s.factor; }

// Returns the multiple of the step s that is nearest to x.
static double round_to_step(RoundStep s, double x) { return s.is_part ? rint_f64(x * s.factor) / s.factor : rint_f64(x / s.factor) * s.factor; }

// Searches the value at which a check begins to fail by bisection, among the multiples of a power of ten that is about a thousandth of the distance
// of the two points.
static void find_boundary(SweepRunner *x, const Gap *g)
{
    const SweepLine *line = &x->s->line[g->axis];
    const SweepPoint *a = &line->at.at[g->point], *b = a + 1;
    const SmType type = x->s->axis[g->axis].parameter->type;
    const double distance = b->value[g->axis] - a->value[g->axis];
    const RoundStep round = round_step(is_whole(type) ? 1 : distance / 1000);
    const double step = size_of_step(round);
    const bool low_fails = a->fails[g->check] != 0;
    double value[SWEEP_AXES] = {a->value[0], a->value[1]}, low = a->value[g->axis], high = b->value[g->axis];
    SweepBoundary found = {g->axis, g->check, 0, 0};

    for (int i = 0; i < 60 && high - low > step * 1.5; i++) {
        const double half = low + (high - low) / 2, rounded = round_to_step(round, half);
        const double middle = ref_read(type, ref_convert(type, rounded > low && rounded < high ? rounded : half));
        if (middle <= low || middle >= high)
            break;
        value[g->axis] = middle;
        if (check_fails(x, g->axis, g->check, value) == low_fails)
            low = middle;
        else
            high = middle;
    }
    found.passes = low_fails ? high : low;
    found.fails = low_fails ? low : high;
    vec_push(x->arena, &x->s->boundary, found);
}

static void list_gaps(SweepRunner *x)
{
    for (uint32_t a = 0; a < x->s->options.axes; a++)
        for (uint32_t c = 0; c < x->s->check.n; c++)
            for (uint32_t i = 0; i + 1 < x->s->line[a].at.n; i++) {
                const Gap g = {a, c, i};
                if (x->s->line[a].at.at[i].fails[c] != x->s->line[a].at.at[i + 1].fails[c])
                    vec_push(x->arena, &x->gap, g);
            }
    x->has_gaps = true;
}

// ---- all of it ----

// Adds the next point of the lines that have scripts.  Returns false after the last one.
static bool run_line_point(SweepRunner *x)
{
    while (x->axis < x->s->options.axes) {
        SweepAxis *a = &x->s->axis[x->axis];
        SweepLine *line = &x->s->line[x->axis];
        double value[SWEEP_AXES] = {x->s->axis[0].current, x->s->axis[1].current};
        const bool current_is_next = line->current == UINT32_MAX && a->current >= a->lo && a->current <= a->hi &&
                                     (x->next == a->n || a->current <= a->value[x->next]);
        SweepPoint p;
        if (sweep_is_alone(x->s, x->axis) || (x->next == a->n && !current_is_next)) {
            x->axis++;
            x->next = 0;
            continue;
        }
        value[x->axis] = current_is_next ? a->current : a->value[x->next];
        p = run_point(x, x->axis, value, x->arena);
        if (current_is_next)
            line->current = line->at.n;
        x->next += x->next < a->n && value[x->axis] == a->value[x->next];
        vec_push(x->arena, &line->at, p);
        return true;
    }
    return false;
}

bool sweep_run_next(Sweep *s)
{
    SweepRunner *x = s->runner;

    if (run_line_point(x))
        return true;
    if (s->options.axes == 2 && !(sweep_is_alone(s, 0) && sweep_is_alone(s, 1)) && x->next_point < s->axis[0].n * s->axis[1].n) {
        const double value[SWEEP_AXES] = {s->axis[0].value[x->next_point / s->axis[1].n], s->axis[1].value[x->next_point % s->axis[1].n]};
        const SweepPoint p = run_point(x, SWEEP_MAP, value, x->arena);
        vec_push(x->arena, &s->point, p);
        x->next_point++;
        return true;
    }
    if (!x->has_gaps)
        list_gaps(x);
    if (x->next_gap == x->gap.n)
        return false;
    find_boundary(x, &x->gap.at[x->next_gap++]);
    return true;
}

// Sets the values of an axis, as its parameter stores them, without those that are equal.
static void set_values(SweepRunner *x, SweepAxis *a)
{
    const SmType type = a->parameter->type;
    uint32_t n = 0;

    a->value = ARENA_ARRAY(x->arena, double, a->n);
    for (uint32_t i = 0; i < a->n; i++) {
        double v = i + 1 == a->n ? a->hi : a->lo + (a->hi - a->lo) * i / (a->n - 1);
        v = ref_read(type, ref_convert(type, v));
        if (n == 0 || v != a->value[n - 1])
            a->value[n++] = v;
    }
    a->n = n;
}

// Returns the value of a parameter outside the sweep: set with --set, or the machine's.
static double current_value(const Sweep *s, const Var *parameter)
{
    uint64_t cell = parameter->init;

    for (size_t i = 0; i < s->options.settings; i++)
        if (s->options.setting[i].parameter == parameter)
            cell = s->options.setting[i].cell;
    return ref_read(parameter->type, cell);
}

Sweep *sweep_new(Arena *arena, const Program *p, const Script *const *script, uint32_t scripts, const SweepOptions *o)
{
    Sweep *s = ARENA_NEW(arena, Sweep);
    SweepRunner *x = ARENA_NEW(arena, SweepRunner);

    *s = (Sweep){.p = p, .script = script, .scripts = scripts, .options = *o, .runner = x};
    x->s = s;
    x->arena = arena;
    arena_init(&x->run, arena->alloc, arena->context, arena->oom);
    x->flat = flat_new_machines(arena, p);
    list_checks(x);
    x->violated = arena_alloc(arena, s->check.n + 1);
    for (uint32_t i = 0; i < o->axes; i++) {
        s->axis[i] = o->axis[i];
        s->axis[i].current = current_value(s, o->axis[i].parameter);
        s->line[i].current = UINT32_MAX;
        set_values(x, &s->axis[i]);
    }
    return s;
}

bool sweep_fails_now(const Sweep *s, uint32_t axis)
{
    const SweepLine *l = &s->line[axis];

    return l->current < l->at.n && l->at.at[l->current].failing > 0;
}

bool sweep_find_margin(const Sweep *s, uint32_t axis, bool above, double *fails)
{
    const SweepLine *l = &s->line[axis];
    const double current = s->axis[axis].current, sign = above ? 1 : -1;
    bool found = false;

    if (l->current >= l->at.n || sweep_fails_now(s, axis))
        return false;
    for (uint32_t i = 0; i < l->at.n + s->boundary.n; i++) {
        const SweepBoundary *b = i < l->at.n ? NULL : &s->boundary.at[i - l->at.n];
        const double x = b ? b->fails : l->at.at[i].value[axis];
        if ((b ? b->axis != axis : l->at.at[i].failing == 0) || (x - current) * sign <= 0 || (found && (x - *fails) * sign >= 0))
            continue;
        *fails = x;
        found = true;
    }
    return found;
}

bool sweep_is_noticed(const Sweep *s, uint32_t axis)
{
    for (uint32_t i = 0; i < s->line[axis].at.n; i++)
        if (s->line[axis].at.at[i].failing > 0)
            return true;
    return false;
}

uint32_t sweep_find_limit(const Sweep *s, uint32_t axis, double fails)
{
    const SweepLine *l = &s->line[axis];
    uint32_t limit = s->check.n;              // requirements are the first checks

    for (uint32_t i = 0; i < l->at.n; i++)
        for (uint32_t c = 0; l->at.at[i].value[axis] == fails && c < limit; c++)
            limit = l->at.at[i].fails[c] ? c : limit;
    for (uint32_t i = 0; i < s->boundary.n; i++)
        if (s->boundary.at[i].axis == axis && s->boundary.at[i].fails == fails && s->boundary.at[i].check < limit)
            limit = s->boundary.at[i].check;
    return limit;
}

void sweep_write_value(const SweepAxis *a, double x, Buf *out)
{
    if (a->parameter->type == SM_BOOL)
        buf_str(out, x != 0 ? "true" : "false");
    else if (a->parameter->type == SM_F32)
        format_cell_stored(out, SM_F32, ref_convert(SM_F32, x));
    else
        format_number_shortest(out, x);
}

uint32_t sweep_find_last_alike(const Sweep *s, uint32_t axis, uint32_t first)
{
    const SweepLine *l = &s->line[axis];

    while (first + 1 < l->at.n && memcmp(l->at.at[first].fails, l->at.at[first + 1].fails, s->check.n) == 0)
        first++;
    return first;
}

void sweep_write_failing(const Sweep *s, const SweepPoint *p, const char *separator, Buf *out)
{
    const char *before = "";

    for (uint32_t c = 0; c < s->check.n; c++)
        if (p->fails[c]) {
            buf_str(out, before);
            sweep_write_check(s, c, out);
            before = separator;
        }
}

// Returns the number that a person reads where sweep_write_value writes x.
static double written_value(const SweepAxis *a, double x, Arena *arena)
{
    Buf b;

    buf_init(&b, arena);
    sweep_write_value(a, x, &b);
    return strtod(buf_text(&b), NULL);
}

void sweep_write_side(const Sweep *s, uint32_t axis, bool above, Buf *out)
{
    const SweepAxis *a = &s->axis[axis];
    const bool is_bool = a->parameter->type == SM_BOOL;
    double fails, distance;
    uint32_t limit;

    if (sweep_find_margin(s, axis, above, &fails)) {
        buf_str(out, "fails at ");
        sweep_write_value(a, fails, out);
        buf_str(out, " (");
        distance = written_value(a, fails, out->arena) - written_value(a, a->current, out->arena);
        if (!is_bool)
            buf_printf(out, "%.6g away, ", above ? distance : -distance);
        limit = sweep_find_limit(s, axis, fails);
        buf_str(out, s->check.at[limit].requirement ? "requirement " : s->check.at[limit].assert ? "only the assert " : "");
        sweep_write_check(s, limit, out);
        buf_char(out, ')');
    } else if (!is_bool || a->current != (above ? a->hi : a->lo)) {
        buf_str(out, sweep_is_noticed(s, axis) ? "nothing fails " : "nothing notices it ");
        buf_str(out, is_bool ? "at " : above ? "up to " : "down to ");
        sweep_write_value(a, above ? a->hi : a->lo, out);
    }
}

void sweep_end(Sweep *s) { arena_free(&s->runner->run); }
