// SPDX-License-Identifier: Apache-2.0
#include "compiler/script/baseline.h"

#include "compiler/base/json.h"
#include "compiler/base/path.h"

enum { NAMED_MOST = 3 };      // the most scripts that a line names; it counts the others

void baseline_init(Baseline *b, Arena *arena, const Requirements *rq) { *b = (Baseline){.arena = arena, .requirements = rq}; }

// ---- one run ----

// Returns where the assert that failed is: "fails at tank.ss:9".
static const char *assert_text(Arena *arena, const ScriptAssert *a)
{
    const Span at = a->condition ? a->condition->span : a->remark->span;

    return format_in(arena, "fails at %s:%lu", source_short_name(at.src), (unsigned long)source_position(at.src, at.at).line);
}

static bool has_other_data(const Script *s, const ScriptResult *r)
{
    for (size_t i = 0; s->data && r->compare && i < s->data->compare.n; i++)
        if (r->compare[i].failed)
            return true;
    return false;
}

// Returns why a script shows nothing about a change; NULL: it does.
static const char *reason_to_leave_out(Arena *arena, const Script *s, const ScriptResult *r)
{
    switch (r->outcome) {
    case SCRIPT_PASSED: case SCRIPT_FAILED:
        return r->failed ? assert_text(arena, r->failed) : has_other_data(s, r) ? "differs from its recorded data" : NULL;
    case SCRIPT_ENDLESS: return "does not stop";
    case SCRIPT_TIME_OVERFLOW: return "reaches the largest time";
    case SCRIPT_NO_DATA: return "has no data that can be used";
    case SCRIPT_CANCELLED: case SCRIPT_BROKEN: case SCRIPT_DIFFERENT: break;
    }
    return "does not run";
}

// Returns the requirements that a run violates, as ScriptOptions.ignored.
static const uint8_t *list_violated(const Baseline *b, const ScriptResult *r)
{
    uint8_t *out = arena_alloc(b->arena, b->requirements->at.n);

    for (size_t i = 0; i < b->requirements->at.n; i++)
        out[i] = r->requirement[i].violations > 0;
    return out;
}

bool baseline_add(Baseline *b, const char *name, const Script *s, const ScriptResult *r)
{
    BaselineRun run = {s ? source_short_name(s->src) : path_portable_name(name), s ? reason_to_leave_out(b->arena, s, r) : "does not compile", NULL};

    if (!run.why && b->requirements && r->is_violated)
        run.ignored = list_violated(b, r);
    b->left_out += run.why != NULL;
    b->ignoring += run.ignored != NULL;
    vec_push(b->arena, &b->run, run);
    return !run.why;
}

bool baseline_is_complete(const Baseline *b) { return b->left_out + b->ignoring == 0; }

// ---- what is left out, in words ----

static bool is_ignored(const Baseline *b, uint32_t run, size_t requirement)
{
    return b->run.at[run].ignored && b->run.at[run].ignored[requirement];
}

// Returns how many runs violate a requirement.
static uint32_t count_ignoring(const Baseline *b, size_t requirement)
{
    uint32_t n = 0;

    for (uint32_t i = 0; i < b->run.n; i++)
        n += is_ignored(b, i, requirement);
    return n;
}

static size_t requirements_of(const Baseline *b) { return b->requirements ? b->requirements->at.n : 0; }

// Returns the scripts whose runs violate a requirement: "a.ss, b.ss and 4 more".
static const char *list_ignoring(const Baseline *b, size_t requirement)
{
    const uint32_t all = count_ignoring(b, requirement), named = all > NAMED_MOST ? NAMED_MOST - 1 : all;
    uint32_t n = 0;
    Buf out;

    buf_init(&out, b->arena);
    for (uint32_t i = 0; i < b->run.n && n < named; i++)
        if (is_ignored(b, i, requirement))
            buf_printf(&out, "%s%s", n++ == 0 ? "" : n == all ? " and " : ", ", b->run.at[i].name);
    if (all > named)
        buf_printf(&out, " and %lu more", (unsigned long)(all - named));
    return buf_text(&out);
}

void baseline_list(const Baseline *b, void *context, void (*add)(void *context, const char *sentence))
{
    for (uint32_t i = 0; i < b->run.n; i++)
        if (b->run.at[i].why)
            add(context, format_in(b->arena, "Left out: %s, because it %s.", b->run.at[i].name, b->run.at[i].why));
    for (size_t q = 0; q < requirements_of(b); q++)
        if (count_ignoring(b, q))
            add(context, format_in(b->arena, "Not judged: %s in %s, where it is violated anyway.", b->requirements->at.at[q].id->text,
                                   list_ignoring(b, q)));
}

static void add_line(void *context, const char *sentence) { buf_printf(context, "  %s\n", sentence); }

void baseline_write_text(const Baseline *b, Buf *out) { baseline_list(b, out, add_line); }

void baseline_write_json(const Baseline *b, Buf *out)
{
    const char *before = "";

    if (baseline_is_complete(b))
        return;
    buf_str(out, ",\"left_out\":[");
    for (uint32_t i = 0; i < b->run.n; i++)
        if (b->run.at[i].why) {
            buf_printf(out, "%s{\"script\":", before);
            json_put_string(out, b->run.at[i].name);
            buf_str(out, ",\"why\":");
            json_put_string(out, b->run.at[i].why);
            buf_char(out, '}');
            before = ",";
        }
    buf_str(out, "],\"not_judged\":[");
    before = "";
    for (size_t q = 0; q < requirements_of(b); q++)
        for (uint32_t i = 0; i < b->run.n; i++)
            if (is_ignored(b, i, q)) {
                buf_printf(out, "%s{\"requirement\":\"%s\",\"script\":", before, b->requirements->at.at[q].id->text);
                json_put_string(out, b->run.at[i].name);
                buf_char(out, '}');
                before = ",";
            }
    buf_char(out, ']');
}
