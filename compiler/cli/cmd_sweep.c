// SPDX-License-Identifier: Apache-2.0
// smc sweep: runs scripts with one or two parameters at many values, and shows where asserts and requirements begin to fail.
#include <inttypes.h>
#include <string.h>

#include "compiler/base/json.h"
#include "compiler/base/os_signal.h"
#include "compiler/base/path.h"
#include "compiler/cli/deps.h"
#include "compiler/cli/progress.h"
#include "compiler/cli/setting.h"
#include "compiler/cli/whatif.h"
#include "compiler/whatif/sweep.h"

typedef struct SweepRun {
    Cli *c;
    Arena *arena;
    WhatIf w;
    SweepOptions o;
    ScriptSettings setting;
    uint64_t seed;
    Sweep *s;
    bool is_interrupted;
} SweepRun;

static const CliFormat formats[] = {
    {"text", {".txt", NULL, NULL}, NULL}, {"csv", {".csv", NULL, NULL}, NULL}, {"json", {".json", NULL, NULL}, NULL},
        {"svg", {".svg", NULL, NULL}, "a browser"}};

// ---- text ----

static const char *number_text(const SweepRun *r, const SweepAxis *a, double x)
{
    Buf b;

    buf_init(&b, r->arena);
    sweep_write_value(a, x, &b);
    return buf_text(&b);
}

// Writes the results along one parameter (`axis`: its index), the others at their current values.  Successive points with the same result are
// written as one range.
static void write_line(const SweepRun *r, uint32_t axis, Buf *out)
{
    const SweepLine *l = &r->s->line[axis];

    for (uint32_t first = 0, last; first < l->at.n; first = last + 1) {
        last = sweep_find_last_alike(r->s, axis, first);
        buf_printf(out, "  %s", number_text(r, &r->s->axis[axis], l->at.at[first].value[axis]));
        if (last > first)
            buf_printf(out, " to %s", number_text(r, &r->s->axis[axis], l->at.at[last].value[axis]));
        buf_str(out, l->at.at[last].failing ? ": fails: " : ": passes");
        sweep_write_failing(r->s, &l->at.at[last], ", ", out);
        buf_char(out, '\n');
    }
}

// Writes which scripts keep their own value of this parameter (`axis`: its index).
static void write_kept(const SweepRun *r, uint32_t axis, Buf *out)
{
    const char *before = "  left out, with a value of their own: ";

    for (uint32_t i = 0; i < r->s->scripts; i++)
        if (!sweep_takes_part(r->s, axis, i)) {
            buf_printf(out, "%s%s", before, source_short_name(r->s->script[i]->src));
            before = ", ";
        }
    if (*before == ',')
        buf_char(out, '\n');
}

// Writes the values of this parameter (`axis`: its index) at which the result of a check changes.
static void write_boundaries(const SweepRun *r, uint32_t axis, Buf *out)
{
    for (uint32_t i = 0; i < r->s->boundary.n; i++) {
        const SweepBoundary *b = &r->s->boundary.at[i];
        if (b->axis != axis)
            continue;
        buf_str(out, "  ");
        sweep_write_check(r->s, b->check, out);
        buf_printf(out, r->s->axis[axis].parameter->type == SM_BOOL ? ": passes at %s, fails at %s\n" : b->passes < b->fails
                   ? ": passes up to %s, fails from %s\n" : ": passes from %s, fails up to %s\n",
                   number_text(r, &r->s->axis[axis], b->passes), number_text(r, &r->s->axis[axis], b->fails));
    }
}

// Writes how far the current value of this parameter is from values at which a check fails.
static void write_margin(const SweepRun *r, uint32_t axis, Buf *out)
{
    const SweepAxis *a = &r->s->axis[axis];

    buf_printf(out, "  now %s: ", number_text(r, a, a->current));
    if (r->s->line[axis].current == UINT32_MAX) {
        buf_str(out, "outside what was swept\n");
        return;
    }
    if (sweep_fails_now(r->s, axis)) {
        buf_str(out, "fails\n");
        return;
    }
    buf_str(out, a->parameter->type == SM_BOOL ? "" : "below, ");
    sweep_write_side(r->s, axis, false, out);
    buf_str(out, a->parameter->type == SM_BOOL ? "" : "; above, ");
    sweep_write_side(r->s, axis, true, out);
    buf_char(out, '\n');
}

// Writes the map of two parameters: a row for each value of the second one, from the largest down.
static void write_map(const SweepRun *r, Buf *out)
{
    const SweepAxis *a = &r->s->axis[0], *b = &r->s->axis[1];
    size_t widest = 0;

    for (uint32_t k = 0; k < b->n; k++)
        widest = strlen(number_text(r, b, b->value[k])) > widest ? strlen(number_text(r, b, b->value[k])) : widest;
    buf_printf(out, "map: %s up, %s to the right from %s to %s; '.' passes, a digit is the number of checks that fail, '+' more than 9\n",
               b->parameter->name->text,
               a->parameter->name->text, number_text(r, a, a->value[0]), number_text(r, a, a->value[a->n - 1]));
    for (uint32_t k = b->n; k-- > 0; ) {
        buf_printf(out, "  %*s  ", (int)widest, number_text(r, b, b->value[k]));
        for (uint32_t i = 0; i < a->n && i * b->n + k < r->s->point.n; i++) {
            const uint32_t n = r->s->point.at[i * b->n + k].failing;
            buf_char(out, n == 0 ? '.' : n > 9 ? '+' : (char)('0' + n));
        }
        buf_char(out, '\n');
    }
}

// Writes the results of one parameter (`axis`: its index).
static void write_parameter(const SweepRun *r, uint32_t axis, Buf *out)
{
    buf_printf(out, "%s:\n", r->s->axis[axis].parameter->name->text);
    write_kept(r, axis, out);
    if (sweep_is_alone(r->s, axis)) {
        buf_str(out, "  no script is left\n");
        return;
    }
    if (!sweep_is_noticed(r->s, axis))
        buf_str(out, "  no script or requirement notices any of these values, so none of them tests this parameter\n");
    write_line(r, axis, out);
    write_boundaries(r, axis, out);
    write_margin(r, axis, out);
}

// Returns the index of the parameter that is at this place in all forms: those first whose values nothing notices, because they are the least tested.
static uint32_t axis_at(const SweepRun *r, uint32_t place)
{
    return r->o.axes == 2 && sweep_is_noticed(r->s, 0) && !sweep_is_noticed(r->s, 1) ? 1 - place : place;
}

static void write_text(const SweepRun *r, Buf *out)
{
    buf_printf(out, "sweep of %s: %lu script%s, %" PRIu64 " runs\n", r->s->p->name->text, (unsigned long)r->s->scripts, r->s->scripts == 1 ? "" : "s",
               r->s->runs);
    for (uint32_t i = 0; i < r->o.axes; i++)
        write_parameter(r, axis_at(r, i), out);
    if (r->s->point.n)
        write_map(r, out);
}

// ---- CSV and JSON ----

// Calls f for each point of the map of two parameters, or of the line of the only parameter.
static void each_point(const SweepRun *r, void (*f)(const SweepRun *r, const SweepPoint *p, Buf *out), Buf *out)
{
    const uint32_t n = r->o.axes == 2 ? r->s->point.n : r->s->line[0].at.n;

    for (uint32_t i = 0; i < n; i++)
        f(r, r->o.axes == 2 ? &r->s->point.at[i] : &r->s->line[0].at.at[i], out);
}

// Whether the parameters have their current values at this point.
static bool is_current(const SweepRun *r, const SweepPoint *p)
{
    for (uint32_t i = 0; i < r->o.axes; i++)
        if (p->value[i] != r->s->axis[i].current)
            return false;
    return true;
}

// Writes a row: the values, whether they are the current ones, how many checks and how many requirements fail, and which.
static void write_csv_point(const SweepRun *r, const SweepPoint *p, Buf *out)
{
    uint32_t requirements = 0;
    Buf failing;

    for (uint32_t i = 0; i < r->o.axes; i++)
        buf_printf(out, "%s,", number_text(r, &r->s->axis[axis_at(r, i)], p->value[axis_at(r, i)]));
    for (uint32_t c = 0; c < r->s->check.n; c++)
        requirements += p->fails[c] && r->s->check.at[c].requirement;
    buf_printf(out, "%s,%lu,%lu,\"", is_current(r, p) ? "now" : "", (unsigned long)p->failing, (unsigned long)requirements);
    buf_init(&failing, r->arena);
    sweep_write_failing(r->s, p, ", ", &failing);
    for (size_t i = 0; i < failing.n; i++)
        buf_printf(out, failing.at[i] == '"' ? "\"\"" : "%c", failing.at[i]);
    buf_str(out, "\"\n");
}

static void write_csv(const SweepRun *r, Buf *out)
{
    for (uint32_t i = 0; i < r->o.axes; i++)
        buf_printf(out, "%s,", r->s->axis[axis_at(r, i)].parameter->name->text);
    buf_str(out, "now,failing,requirements,checks\n");
    each_point(r, write_csv_point, out);
}

// Writes the names of the checks that fail at a point.
static void write_json_failing(const SweepRun *r, const SweepPoint *p, Buf *out)
{
    const char *before = "";

    buf_str(out, "\"fails\":[");
    for (uint32_t c = 0; c < r->s->check.n; c++)
        if (p->fails[c]) {
            Buf name;
            buf_init(&name, r->arena);
            sweep_write_check(r->s, c, &name);
            buf_str(out, before);
            json_put_string(out, buf_text(&name));
            before = ",";
        }
    buf_char(out, ']');
}

static void write_json_point(const SweepRun *r, const SweepPoint *p, Buf *out)
{
    buf_str(out, out->at[out->n - 1] == '[' ? "\n{\"at\":[" : ",\n{\"at\":[");
    for (uint32_t i = 0; i < r->o.axes; i++)
        buf_printf(out, "%s%s", i ? "," : "", number_text(r, &r->s->axis[axis_at(r, i)], p->value[axis_at(r, i)]));
    buf_str(out, "],");
    write_json_failing(r, p, out);
    buf_char(out, '}');
}

// Writes the results along one parameter, as write_line does.
static void write_json_line(const SweepRun *r, uint32_t axis, Buf *out)
{
    const SweepLine *l = &r->s->line[axis];

    buf_str(out, ",\"values\":[");
    for (uint32_t first = 0, last; first < l->at.n; first = last + 1) {
        last = sweep_find_last_alike(r->s, axis, first);
        buf_printf(out, "%s{\"from\":%s,\"to\":%s,", first ? "," : "", number_text(r, &r->s->axis[axis], l->at.at[first].value[axis]),
                   number_text(r, &r->s->axis[axis], l->at.at[last].value[axis]));
        write_json_failing(r, &l->at.at[last], out);
        buf_char(out, '}');
    }
    buf_char(out, ']');
}

// Writes where something fails below or above the current value, and what it is.
static void write_json_margin(const SweepRun *r, uint32_t axis, bool above, Buf *out)
{
    const char *side = above ? "above" : "below";
    uint32_t limit;
    double fails;
    Buf name;

    if (!sweep_find_margin(r->s, axis, above, &fails))
        return;
    limit = sweep_find_limit(r->s, axis, fails);
    buf_init(&name, r->arena);
    sweep_write_check(r->s, limit, &name);
    buf_printf(out, ",\"fails_%s\":%s,\"check_%s\":", side, number_text(r, &r->s->axis[axis], fails), side);
    json_put_string(out, buf_text(&name));
    buf_printf(out, ",\"kind_%s\":\"%s\"", side,
               r->s->check.at[limit].requirement ? "requirement" : r->s->check.at[limit].assert ? "assert" : "script");
}

// Writes the scripts that keep their own value of the parameter, if there are any.
static void write_json_kept(const SweepRun *r, uint32_t axis, Buf *out)
{
    const char *before = ",\"left_out\":[";

    for (uint32_t i = 0; i < r->s->scripts; i++)
        if (!sweep_takes_part(r->s, axis, i)) {
            buf_str(out, before);
            json_put_string(out, source_short_name(r->s->script[i]->src));
            before = ",";
        }
    if (!before[1])
        buf_char(out, ']');
}

// Writes the results of one parameter: those of write_parameter in the text.
static void write_json_parameter(const SweepRun *r, uint32_t axis, Buf *out)
{
    const SweepLine *l = &r->s->line[axis];

    buf_printf(out, "{\"name\":\"%s\",\"now\":%s,\"is_swept\":%s,\"is_noticed\":%s,\"fails_now\":%s", r->s->axis[axis].parameter->name->text,
               number_text(r, &r->s->axis[axis], r->s->axis[axis].current), l->current == UINT32_MAX ? "false" : "true",
               sweep_is_noticed(r->s, axis) ? "true" : "false", sweep_fails_now(r->s, axis) ? "true" : "false");
    write_json_margin(r, axis, false, out);
    write_json_margin(r, axis, true, out);
    write_json_kept(r, axis, out);
    write_json_line(r, axis, out);
    buf_char(out, '}');
}

static void write_json_boundaries(const SweepRun *r, Buf *out)
{
    buf_str(out, "\n],\"boundaries\":[");
    for (uint32_t i = 0; i < r->s->boundary.n; i++) {
        const SweepBoundary *b = &r->s->boundary.at[i];
        Buf name;
        buf_init(&name, r->arena);
        sweep_write_check(r->s, b->check, &name);
        buf_printf(out, "%s\n{\"parameter\":\"%s\",\"check\":", i ? "," : "", r->s->axis[b->axis].parameter->name->text);
        json_put_string(out, buf_text(&name));
        buf_printf(out, ",\"passes\":%s,\"fails\":%s}", number_text(r, &r->s->axis[b->axis], b->passes),
                   number_text(r, &r->s->axis[b->axis], b->fails));
    }
}

static void write_json(const SweepRun *r, Buf *out)
{
    buf_printf(out, "{\"smc-sweep\":1,\"%s\":\"%s\",\"runs\":%" PRIu64 ",\"complete\":%s,\"parameters\":[",
               r->s->p->joint ? "application" : "machine", r->s->p->name->text, r->s->runs,
               r->is_interrupted ? "false" : "true");
    for (uint32_t i = 0; i < r->o.axes; i++) {
        buf_str(out, i ? ",\n" : "\n");
        write_json_parameter(r, axis_at(r, i), out);
    }
    buf_str(out, "],\n\"points\":[");
    each_point(r, write_json_point, out);
    write_json_boundaries(r, out);
    buf_str(out, "\n]}\n");
}

static void write_svg(const SweepRun *r, Buf *out) { sweep_write_svg(r->arena, r->s, out); }

// ---- running ----

static int run_and_report(SweepRun *r, size_t format)
{
    static void (*const writer[])(const SweepRun *r, Buf *out) = {write_text, write_csv, write_json, write_svg};
    ProgressLine k = {r->c, 0, false};
    Buf out;
    int code;

    r->s = sweep_new(r->arena, r->w.p, r->w.script.at, r->w.script.n, &r->o);
    os_signals_begin();
    os_signals_delay();
    while (!(r->is_interrupted = os_signal_waiting() != 0) && sweep_run_next(r->s))
        if (progress_is_due(&k))
            progress_show(&k, format_in(r->arena, "sweep: %lu runs", (unsigned long)r->s->runs));
    progress_end(&k);
    buf_init(&out, r->arena);
    writer[format](r, &out);
    code = deps_write_result(r->c, &out);
    if (r->is_interrupted)
        cli_print_error(r->c, TEXT_sweep_interrupted, (unsigned long)r->s->runs);
    sweep_end(r->s);
    os_signals_resume();                  // ends the process if a signal has asked to stop
    os_signals_end();
    return code;
}

// ---- options ----

// Reads the lowest or highest value to which a parameter is swept.  EXIT_OK, or the exit code after a message.
static int read_end(SweepRun *r, const char *name, const char *text, size_t n, double *x, const Var **parameter)
{
    const char *word = format_in(r->arena, "%s=%.*s", name, (int)n, text);
    ScriptSetting setting;
    Setting s;
    int code;

    if (!setting_parse(r->c, word, &s))
        return EXIT_USAGE;
    if ((code = setting_find(r->c, r->w.p, &s, &setting)) != EXIT_OK)
        return code;
    *x = s.value;
    *parameter = setting.parameter;
    return EXIT_OK;
}

// Reads NAME=LO:HI:N.  EXIT_OK, or the exit code after a message.
static int read_axis(SweepRun *r, const char *word)
{
    const char *equals = strchr(word, '='), *first = strchr(word, ':'), *second = first ? strchr(first + 1, ':') : NULL;
    const char *name = format_in(r->arena, "%.*s", (int)(equals - word), word);
    SweepAxis *a = &r->o.axis[r->o.axes];
    uint64_t n;
    int code;

    if (!second || !cli_read_count(second + 1, &n) || n < 2 || n > SWEEP_POINTS_MOST)
        return cli_usage_error(r->c, TEXT_sweep_form, (int)SWEEP_POINTS_MOST, word);
    if ((code = read_end(r, name, equals + 1, (size_t)(first - equals - 1), &a->lo, &a->parameter)) != EXIT_OK ||
        (code = read_end(r, name, first + 1, (size_t)(second - first - 1), &a->hi, &a->parameter)) != EXIT_OK)
        return code;
    if (!(a->lo < a->hi))
        return cli_usage_error(r->c, TEXT_sweep_ends, word);
    if (r->o.axes == 1 && a->parameter == r->o.axis[0].parameter)
        return cli_usage_error(r->c, TEXT_sweep_twice, name);
    a->n = (uint32_t)n;
    r->o.axes++;
    return EXIT_OK;
}

// Reads the values of --set: NAME=LO:HI:N is a parameter to sweep, NAME=VALUE sets one for all runs. EXIT_OK, or the exit code after a message.
static int read_settings(SweepRun *r)
{
    Cli *c = r->c;
    int code;

    for (size_t i = 0; i < c->set.n; i++) {
        const char *equals = strchr(c->set.at[i], '=');
        Setting s;
        if (equals && strchr(equals, ':')) {
            if (r->o.axes == SWEEP_AXES)
                return cli_usage_error(c, TEXT_sweep_axes);
            if ((code = read_axis(r, c->set.at[i])) != EXIT_OK)
                return code;
            continue;
        }
        if (!setting_parse(c, c->set.at[i], &s))
            return EXIT_USAGE;
        if ((code = settings_add(c, r->w.p, &s, &r->setting)) != EXIT_OK)
            return code;
    }
    if (r->o.axes == 0)
        return cli_usage_error(c, TEXT_sweep_axes);
    if (r->o.axes == 2 && (uint64_t)r->o.axis[0].n * r->o.axis[1].n > SWEEP_POINTS_MOST)
        return cli_usage_error(c, TEXT_sweep_points, (int)SWEEP_POINTS_MOST);
    return EXIT_OK;
}

int cmd_sweep(Cli *c)
{
    SweepRun r = {.c = c, .arena = &c->session.arena};
    size_t format;
    int code;

    if (!cli_choose_format(c, formats, sizeof formats / sizeof *formats, &format))
        return EXIT_USAGE;
    if (c->given[OPT_SEED] && (!cli_read_whole(c->value[OPT_SEED], &r.seed) || r.seed > SCRIPT_SEED_MAX))
        return cli_usage_error(c, TEXT_seed_value, c->value[OPT_SEED]);
    if ((code = whatif_load(c, &r.w)) != EXIT_OK || (code = read_settings(&r)) != EXIT_OK)
        return code;
    r.o.max_steps = r.w.max_steps;
    r.o.seed = c->given[OPT_SEED] ? &r.seed : NULL;
    r.o.requirements = r.w.requirements;
    r.o.setting = r.setting.at;
    r.o.settings = r.setting.n;
    return run_and_report(&r, format);
}
