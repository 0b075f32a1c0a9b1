// SPDX-License-Identifier: Apache-2.0
// What smc cover prints: the goals with their outcomes, and the scripts.
#include <string.h>

#include "compiler/analysis/transitions.h"
#include "compiler/base/json.h"
#include "compiler/base/path.h"
#include "compiler/cli/cover_run.h"

// ---- outcomes ----

// Whether a coverage place (`place`: its index) is a goal: of a kind that is searched, and not covered by the given scripts.
bool cover_is_goal(const CoverRun *r, size_t machine, uint32_t place)
{
    return r->kinds >> r->given[machine]->place.at[place].kind & 1 && r->given[machine]->hits[place] == 0;
}

typedef enum Outcome { OUTCOME_REACHED, OUTCOME_IMPOSSIBLE, OUTCOME_NOT_FOUND } Outcome;

// Returns what has become of a goal; `place`: its index in Cover.place.
static Outcome outcome_of(const CoverRun *r, size_t machine, uint32_t place)
{
    if (r->all[machine]->hits[place] > 0)
        return OUTCOME_REACHED;
    return r->all[machine]->place.at[place].impossible ? OUTCOME_IMPOSSIBLE : OUTCOME_NOT_FOUND;
}

CoverTotals cover_count(const CoverRun *r, size_t machine)
{
    CoverTotals t = {0, 0, 0, 0};

    for (uint32_t i = 1; i < r->given[machine]->place.n; i++)
        if (cover_is_goal(r, machine, i)) {
            const Outcome outcome = outcome_of(r, machine, i);
            t.goals++;
            t.reached += outcome == OUTCOME_REACHED;
            t.impossible += outcome == OUTCOME_IMPOSSIBLE;
            t.not_found += outcome == OUTCOME_NOT_FOUND;
        }
    return t;
}

// Returns how the search for a goal ended without reaching it; NULL if it reached the goal or did not search. `place`: index of the goal.
static const SearchFind *find_failed_search(const CoverRun *r, size_t machine, uint32_t place)
{
    const SearchFind *f = r->result[machine] ? &r->result[machine]->find[place] : NULL;

    return f && f->outcome == SEARCH_NOT_FOUND ? f : NULL;
}

// Returns why the search has not reached a goal, as far as it knows; "": unknown. `place`: index of the goal in Cover.place.
static const char *describe_failed_search(const CoverRun *r, size_t machine, uint32_t place)
{
    const SearchFind *f = find_failed_search(r, machine, place);
    const CoverPlace *blocked = f && f->blocked_by ? &r->all[machine]->place.at[f->blocked_by] : NULL;
    Buf out;

    if (!f)
        return "";
    buf_init(&out, r->arena);
    if (!f->is_state_reached && r->all[machine]->place.at[place].from)
        buf_str(&out, "no run was in its state");
    if (blocked && (blocked->kind == COVER_CONDITION || blocked->kind == COVER_GUARD)) {
        if (f->blocked_by != place)
            buf_printf(&out, "%s'%s' was %s %s%s", out.n ? "; " : "", source_text(r->arena, blocked->span), f->is_never ? "never" : "not",
                       blocked->value ? "true" : "false", f->is_never ? "" : " together with the rest");
        if (f->missed_by < SEARCH_UNKNOWN)
            buf_printf(&out, f->missed_by < 1e4 || f->missed_by > 1e12 ? "%sthe nearest run missed by %.4g" : "%sthe nearest run missed by %.0f",
                       out.n ? "; " : "", f->missed_by);
    }
    return out.n ? buf_text(&out) : "no run came to what decides it";
}

// ---- text ----

// Lists the goals that no script reaches: with `impossible`, those proved unreachable, else the others.  Goals whose cause is listed are only
// counted.  `n`: how many goals there are.
static void write_gaps(const CoverRun *r, size_t machine, bool impossible, unsigned long n, Buf *out)
{
    const CoverGaps gaps = cover_list_gaps(r->all[machine], r->kinds);
    bool is_first = true;
    unsigned long listed = 0;

    for (uint32_t i = 0; i < gaps.n; i++) {
        const CoverGap *g = &gaps.at[i];
        const char *reason = impossible ? "" : describe_failed_search(r, machine, g->place);
        if (g->is_impossible != impossible)
            continue;
        if (is_first)
            buf_printf(out, "%s%s%s:\n", impossible ? "impossible" : "not found", r->p->joint ? " in " : "",
                       r->p->joint ? engine_machine_name(r->p, machine) : "");
        is_first = false;
        listed++;
        buf_printf(out, "  line %lu: %s%s%s\n", (unsigned long)source_position(g->span.src, g->span.at).line, g->text, *reason ? ": " : "", reason);
    }
    if (listed && n > listed)
        buf_printf(out, "  %lu more goal%s, with the same cause as one of these\n", n - listed, n - listed == 1 ? "" : "s");
}

static void write_old_scripts(const CoverRun *r, Buf *out)
{
    for (uint32_t i = 0; i < r->old.n; i++) {
        const OldScript *old = &r->old.at[i];
        if (old->verdict == OLD_EDITED)
            buf_printf(out, "kept: %s has been edited\n", old->path);
        else if (old->verdict == OLD_STALE && !old->is_replaced)
            buf_printf(out, "kept: %s: %s, and no new script has its name; delete it if it is not needed\n", old->path, old->why);
        else if (old->verdict == OLD_STALE)
            buf_printf(out, "replaced: %s: %s\n", old->path, old->why);
    }
    for (uint32_t i = 0; i < r->in_the_way.n; i++)
        buf_printf(out, "kept: %s: smc has not written it, so the new script has a number after this name\n", r->in_the_way.at[i]);
}

// Lists the pairs of states without a transition for which no script exists.
static void write_pairs(const CoverRun *r, Buf *out)
{
    bool is_first = true;

    for (uint32_t i = 0; i < r->pair.n; i++)
        if (!r->pair.at[i].path) {
            if (is_first)
                buf_str(out, "not provoked: the condition that leads to\n");
            is_first = false;
            buf_printf(out, "  %s, in %s\n", r->pair.at[i].pair->to->name->text, r->pair.at[i].pair->in->name->text);
        }
}

void cover_write_report(const CoverRun *r, Buf *out)
{
    for (size_t m = 0; m < r->machines; m++) {
        const CoverTotals t = cover_count(r, m);
        buf_printf(out, "goals of %s: %lu of %lu reached", engine_machine_name(r->p, m), t.reached, t.goals - t.impossible);
        if (t.impossible)
            buf_printf(out, ", and %lu impossible", t.impossible);
        buf_char(out, '\n');
    }
    baseline_write_text(&r->given_run, out);
    for (uint32_t i = 0; i < r->new_one.n; i++)
        buf_printf(out, "wrote %s: %s\n", r->new_one.at[i].path, r->new_one.at[i].goal);
    write_old_scripts(r, out);
    for (size_t m = 0; m < r->machines; m++) {
        const CoverTotals t = cover_count(r, m);
        write_gaps(r, m, false, t.not_found, out);
        write_gaps(r, m, true, t.impossible, out);
    }
    write_pairs(r, out);
}

// ---- JSON ----

static void write_field(Buf *out, const char *name, const char *text)
{
    buf_printf(out, ",\"%s\":", name);
    json_put_string(out, text);
}

static void write_blocking_condition(const CoverRun *r, size_t machine, const SearchFind *f, Buf *out)
{
    const CoverPlace *p = &r->all[machine]->place.at[f->blocked_by];
    const LineCol at = source_position(p->span.src, p->span.at);

    buf_printf(out, ",\"blocked_by\":{\"kind\":\"%s\",\"line\":%lu,\"column\":%lu", cover_kind_name[p->kind], (unsigned long)at.line,
               (unsigned long)at.col);
    write_field(out, "text", source_text(r->arena, p->span));
    buf_printf(out, ",\"wanted\":%s,\"never\":%s", p->value ? "true" : "false", f->is_never ? "true" : "false");
    if (f->missed_by < SEARCH_UNKNOWN)
        buf_printf(out, ",\"missed_by\":%.6g", f->missed_by);
    buf_char(out, '}');
}

// Writes the JSON object of a goal. i: its index in Cover.place.
static void write_goal(const CoverRun *r, size_t machine, uint32_t i, Buf *out)
{
    static const char *const word[] = {"reached", "impossible", "not found"};
    const CoverPlace *p = &r->all[machine]->place.at[i];
    const LineCol at = source_position(p->span.src, p->span.at);
    const Outcome outcome = outcome_of(r, machine, i);
    const SearchFind *failed = find_failed_search(r, machine, i);

    buf_printf(out, "{\"kind\":\"%s\",\"line\":%lu,\"column\":%lu", cover_kind_name[p->kind], (unsigned long)at.line, (unsigned long)at.col);
    write_field(out, "text", source_text(r->arena, p->span));
    write_field(out, "goal", goal_sentence(r->text[machine], i));
    write_field(out, "outcome", word[outcome]);
    if (outcome == OUTCOME_IMPOSSIBLE)
        write_field(out, "reason", p->impossible);
    if (outcome == OUTCOME_NOT_FOUND && *describe_failed_search(r, machine, i))
        write_field(out, "reason", describe_failed_search(r, machine, i));
    if (outcome == OUTCOME_NOT_FOUND && failed)
        write_blocking_condition(r, machine, failed, out);
    buf_char(out, '}');
}

// Writes the members "machine" and "goals" of a JSON object.
static void write_machine(const CoverRun *r, size_t machine, Buf *out)
{
    const char *separator = "\n";

    buf_str(out, "\"machine\":");
    json_put_string(out, engine_machine_name(r->p, machine));
    buf_str(out, ",\"goals\":[");
    for (uint32_t i = 1; i < r->all[machine]->place.n; i++)
        if (cover_is_goal(r, machine, i)) {
            buf_str(out, separator);
            write_goal(r, machine, i, out);
            separator = ",\n";
        }
    buf_char(out, ']');
}

static void write_machines(const CoverRun *r, Buf *out)
{
    write_field(out, "application", r->p->name->text);
    buf_str(out, ",\"machines\":[");
    for (size_t m = 0; m < r->machines; m++) {
        buf_str(out, m ? ",\n{" : "\n{");
        write_machine(r, m, out);
        buf_char(out, '}');
    }
    buf_char(out, ']');
}

void cover_write_goals_json(const CoverRun *r, Buf *out)
{
    static const char *const verdict[] = {"edited", "valid", "stale"};

    buf_str(out, "{\"smc-goals\":1");
    if (r->p->joint) {
        write_machines(r, out);
    } else {
        buf_char(out, ',');
        write_machine(r, 0, out);
    }
    baseline_write_json(&r->given_run, out);
    buf_str(out, ",\"written\":[");
    for (uint32_t i = 0; i < r->new_one.n; i++) {
        buf_str(out, i ? ",\n{\"script\":" : "\n{\"script\":");
        json_put_string(out, path_portable_name(r->new_one.at[i].path));
        write_field(out, "goal", r->new_one.at[i].goal);
        buf_char(out, '}');
    }
    buf_str(out, "],\"found\":[");
    for (uint32_t i = 0; i < r->old.n; i++) {
        buf_str(out, i ? ",\n{\"script\":" : "\n{\"script\":");
        json_put_string(out, path_portable_name(r->old.at[i].path));
        write_field(out, "verdict", verdict[r->old.at[i].verdict]);
        buf_char(out, '}');
    }
    buf_str(out, "]}\n");
}
