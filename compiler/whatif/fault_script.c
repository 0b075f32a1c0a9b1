// SPDX-License-Identifier: Apache-2.0
#include "compiler/whatif/fault_script.h"

#include <inttypes.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "compiler/base/path.h"
#include "compiler/cover/cover.h"
#include "compiler/script/ref.h"

// ---- words ----

void fault_write_name(const Faults *f, const FaultResult *r, Buf *out)
{
    for (uint32_t i = 0; i < r->faults; i++)
        buf_printf(out, "%s%s %s", i ? " and " : "", f->input.at[r->fault[i].input].var->report_name->text, fault_kind_name[r->fault[i].kind]);
}

void fault_write_trigger(const Faults *f, const FaultResult *r, Buf *out)
{
    const FaultTrigger *t = &f->trigger.at[r->trigger];

    if (t->from)
        buf_printf(out, "from %s -> %s on", t->from->name->text, t->state->name->text);
    else
        buf_printf(out, "%s %s", t->is_timed ? "from a time in" : t->step == 1 ? "from the start, in" : "in the middle of", t->state->name->text);
    buf_printf(out, " (G = %" PRIu64 ", %s)", t->g, source_short_name(f->script[t->script]->src));
}

static void write_cell(const Var *v, uint64_t cell, Buf *out)
{
    if (v->state_of && cell - 1 < v->state_of->state.n)
        buf_str(out, v->state_of->state.at[cell - 1]->name->text);
    else if (v->type == SM_BOOL)
        buf_str(out, cell ? "true" : "false");
    else
        format_cell_shortest(out, v->type, cell);
}

static void write_failed(const ScriptAssert *a, Buf *out)
{
    const Span s = a->condition ? a->condition->span : a->remark->span;

    buf_printf(out, "assert at %s:%lu", source_short_name(s.src), (unsigned long)source_position(s.src, s.at).line);
}

void fault_write_effect(const Faults *f, const FaultResult *r, Buf *out)
{
    const char *comma = "";

    if (r->violated) {
        buf_printf(out, "%s%s at G = %" PRIu64, f->options.requirements->at.at[r->violated - 1].id->text,
                   r->violated_in_truth ? ", by the true values," : "", r->violated_at.g);
        comma = "; ";
    }
    if (r->failed) {
        buf_str(out, comma);
        write_failed(r->failed, out);
        buf_printf(out, " at G = %" PRIu64, r->failed_at.g);
        comma = "; ";
    }
    if (r->differs) {
        buf_printf(out, "%s%s = ", comma, r->differs->report_name->text);
        write_cell(r->differs, r->cell, out);
        buf_str(out, " instead of ");
        write_cell(r->differs, r->healthy_cell, out);
        buf_printf(out, " at G = %" PRIu64, r->differs_at.g);
        comma = "; ";
    }
    if (r->end != r->healthy_end)
        buf_printf(out, "%sends in %s instead of %s", comma, r->end->name->text, r->healthy_end->name->text);
    else if (r->outcome == FAULT_HAS_ENDLESS)
        buf_printf(out, "%sno @stop within %" PRIu64 " steps", comma, r->steps);
}

// Appends what is most important about a result, in a word or two. Returns its rank among the effects with the same outcome: 0 is the clearest.
static int write_brief(const Faults *f, const FaultResult *r, Buf *out)
{
    if (r->outcome == FAULT_HAS_VIOLATED) {
        buf_str(out, f->options.requirements->at.at[r->violated - 1].id->text);
        return 0;
    }
    if (r->end != r->healthy_end) {
        buf_printf(out, "-> %s", r->end->name->text);
        return 0;
    }
    if (r->outcome == FAULT_HAS_ENDLESS) {
        buf_str(out, "no @stop");
        return 1;
    }
    buf_str(out, r->differs ? r->differs->report_name->text : "assert");
    return r->differs ? 2 : 3;
}

void fault_write_worst(const Faults *f, uint32_t input, FaultKind kind, Buf *out)
{
    const FaultOutcome worst = faults_find_worst(f, input, kind);
    VEC(const char *) seen = {0};             // the different effects
    uint32_t first = 0;                       // the clearest of them
    int rank = INT_MAX;

    for (uint32_t i = 0; i < f->result.n && worst != FAULT_HAS_NONE; i++) {
        const FaultResult *r = &f->result.at[i];
        uint32_t k = 0;
        Buf brief;
        int its_rank;
        if (r->faults != 1 || r->fault[0].input != input || r->fault[0].kind != kind || r->outcome != worst)
            continue;
        buf_init(&brief, out->arena);
        its_rank = write_brief(f, r, &brief);
        while (k < seen.n && strcmp(seen.at[k], buf_text(&brief)) != 0)
            k++;
        if (k == seen.n)
            vec_push(out->arena, &seen, buf_text(&brief));
        if (its_rank < rank) {
            rank = its_rank;
            first = k;
        }
    }
    if (seen.n)
        buf_str(out, seen.at[first]);
    if (seen.n > 1)
        buf_printf(out, " +%lu", (unsigned long)(seen.n - 1));
}

// ---- what the script must show ----

// Returns the step in which the script that reproduces the result must fail; step 0: at its end, or never.
static FaultMoment failing_moment(const FaultResult *r)
{
    static const FaultMoment end = {0, 0};

    switch (r->outcome) {
    case FAULT_HAS_VIOLATED: return r->violated_in_truth ? r->differs_at : r->violated_at;
    case FAULT_HAS_FAILED: return r->failed_at;
    case FAULT_HAS_ABORTED: case FAULT_HAS_DIFFERS: case FAULT_HAS_ELSEWHERE: return r->differs_at;
    case FAULT_HAS_ENDLESS: case FAULT_HAS_NONE: case FAULT_OUTCOME_COUNT: break;
    }
    return end;
}

// Whether the original script does not fail by itself, so that an assert is added that fails because of the fault.
static bool needs_assert(const FaultResult *r)
{
    return r->outcome == FAULT_HAS_VIOLATED ? r->violated_in_truth : r->outcome != FAULT_HAS_FAILED && r->outcome != FAULT_HAS_ENDLESS;
}

// Whether an assert of the original script fails, but the outcome to reproduce is another one, so that the new script must not have the assert.
static bool hides_asserts(const FaultResult *r) { return r->failed && r->outcome != FAULT_HAS_FAILED; }

// Appends an assert that an output has the value that it has without the fault.
static void write_assert(const Faults *f, const FaultResult *r, Buf *out)
{
    const Var *v = r->differs;

    buf_printf(out, "%s == %" PRIu64 ": @assert ", f->p->g->name->text, r->differs_at.g);
    if (v->type == SM_BOOL) {
        buf_printf(out, "%s%s", r->healthy_cell ? "" : "not ", v->name->text);
    } else {
        buf_printf(out, "%s == ", v->name->text);
        write_cell(v, r->healthy_cell, out);
    }
    buf_str(out, " \"as without the fault\"\n");
}

// Writes the comment on top of a generated script: which fault, from when, and what it shows.
static void write_header(const Faults *f, const FaultResult *r, const FaultScriptPlace *place, Buf *out)
{
    buf_str(out, "# ");
    fault_write_name(f, r, out);
    buf_char(out, ' ');
    fault_write_trigger(f, r, out);
    buf_printf(out, ": %s.\n# ", fault_outcome_words[r->outcome]);
    fault_write_effect(f, r, out);
    buf_printf(out, ".\n# This script fails as long as the fault has this effect:\n#     %s\n", place->command);
}

// ---- the edited form ----

typedef struct ScriptEdit { uint32_t at, len; const char *text; } ScriptEdit;

// The edits that make a script read faulty sensors.
typedef struct Edits {
    Arena *arena;
    const Source *src;
    const Var *var[FAULTS_MOST];      // the faulty inputs
    const char *name[FAULTS_MOST];    // by index in `var`: the variable of the script that has the true value
    uint32_t vars;            // number of faulty inputs
    bool hides_asserts;       // asserts of the original must not fail (hides_asserts below)
    VEC(ScriptEdit) at;
    const char *problem;      // why the script cannot be edited; NULL: it can
} Edits;

// Adds the replacement of a span of the script by `text`, unless the span is already replaced.
static void add_edit(Edits *e, Span span, const char *text)
{
    const ScriptEdit edit = {span.at, span.len, text};

    for (uint32_t i = 0; i < e->at.n; i++)
        if (e->at.at[i].at == span.at && e->at.at[i].len == span.len)
            return;
    if (span.src != e->src)
        e->problem = "another file contains what has to be edited";
    vec_push(e->arena, &e->at, edit);
}

// Replaces the name of a variable at the start of the span, if the variable is a faulty input.
static void rename_at(Edits *e, Span span, const Var *v)
{
    const char *at = span.src->text + span.at;

    for (uint32_t i = 0; i < e->vars; i++) {
        const Str name[2] = {v->name, v->alias};
        bool found = false;
        for (int k = 0; k < 2 && v == e->var[i]; k++)
            if (name[k] && name[k]->len <= span.len && memcmp(at, name[k]->text, name[k]->len) == 0 && !found) {
                const char after = name[k]->len < span.src->len - span.at ? at[name[k]->len] : ' ';
                if ((after >= 'a' && after <= 'z') || (after >= 'A' && after <= 'Z') || (after >= '0' && after <= '9') || after == '_')
                    continue;
                add_edit(e, (Span){span.src, span.at, name[k]->len}, e->name[i]);
                found = true;
            }
        if (v == e->var[i] && !found)
            e->problem = "the input is read through a definition";
    }
}

static void rename_in_expr(Edits *e, const Expr *x)
{
    if (x->kind == EX_VAR)
        rename_at(e, x->span, x->var);
    for (uint32_t i = 0; i < x->n; i++)
        rename_in_expr(e, x->arg[i]);
}

// Renames the faulty inputs in the roll calls of an assert: these sample true values, before the step.  Outside roll calls an assert reads the
// inputs after the step, when they have the faulty values that the machine read.
static void rename_samples(Edits *e, const Expr *x)
{
    if (x->kind == EX_ROLL)
        rename_in_expr(e, x);
    for (uint32_t i = 0; x->kind != EX_ROLL && i < x->n; i++)
        rename_samples(e, x->arg[i]);
}

// Edits an assert so that its windows sample true values; or replaces its condition by `true` if the assert must not end the run.
static void edit_assert(Edits *e, const ScriptAssert *a)
{
    if (e->hides_asserts && a->kind != SCRIPT_PRINT)
        add_edit(e, a->condition ? a->condition->span : a->remark->span, a->condition ? "true" : "@assert true");
    else if (a->condition)
        rename_samples(e, a->condition);
    for (uint32_t i = 0; a->remark && i < a->remark->printed.n; i++)
        rename_samples(e, a->remark->printed.at[i]);
}

static void edit_item(Edits *e, const ScriptItem *item)
{
    rename_in_expr(e, item->guard);
    for (uint32_t i = 0; i < item->inputs.n; i++) {
        rename_at(e, script_input_span(item, &item->inputs.at[i]), item->inputs.at[i].var);
        rename_in_expr(e, item->inputs.at[i].value);
    }
    for (uint32_t i = 0; i < item->asserts.n; i++)
        edit_assert(e, &item->asserts.at[i]);
}

// On each line that begins with `word`, puts to_original before the path in quotes that follows it.
static void edit_paths(Edits *e, const char *word, const char *to_original)
{
    const char *text = e->src->text, *line = text, *at;
    const size_t n = strlen(word);

    for (; line; line = (at = strchr(line, '\n')) != NULL ? at + 1 : NULL) {
        at = line + strspn(line, " \t");
        if (strncmp(at, word, n) != 0 || at[n + strspn(at + n, " \t")] != '"')
            continue;
        at = strchr(at, '"') + 1;
        if (path_is_absolute(at))
            continue;
        if (to_original)
            add_edit(e, (Span){e->src, (uint32_t)(at - text), 0}, to_original);
        else
            e->problem = "no path leads to the files that the script names";
    }
}

static void collect_edits(Edits *e, const Script *s, const char *to_original)
{
    for (uint32_t i = 0; i < s->section.n; i++)
        for (uint32_t j = 0; j < s->section.at[i].item.n; j++)
            edit_item(e, s->section.at[i].item.at[j]);
    for (uint32_t i = 0; s->data && i < s->data->column.n; i++)
        for (uint32_t k = 0; k < e->vars; k++)
            if (s->data->column.at[i].var == e->var[k])
                e->problem = "the input is a column of recorded data";
    edit_paths(e, "include", to_original);
    if (s->data)
        edit_paths(e, "file", to_original);
}

static int compare_edits(const void *a, const void *b)
{
    const ScriptEdit *x = a, *y = b;

    return x->at < y->at ? -1 : x->at > y->at;
}

static void write_edited_text(Edits *e, Buf *out)
{
    uint32_t at = 0;

    if (e->at.n > 1)
        qsort(e->at.at, e->at.n, sizeof *e->at.at, compare_edits);
    for (uint32_t i = 0; i < e->at.n; i++) {
        const ScriptEdit *edit = &e->at.at[i];
        if (edit->at < at) {
            e->problem = "two edits overlap";
            return;
        }
        buf_put(out, e->src->text + at, edit->at - at);
        buf_str(out, edit->text);
        at = edit->at + edit->len;
    }
    buf_put(out, e->src->text + at, e->src->len - at);
    if (out->n > 0 && out->at[out->n - 1] != '\n')
        buf_char(out, '\n');
}

static bool is_name_free(const Faults *f, const Script *s, const char *name)
{
    for (size_t i = 0; i < f->p->var.n; i++)
        if (strcmp(f->p->var.at[i]->name->text, name) == 0 || (f->p->var.at[i]->alias && strcmp(f->p->var.at[i]->alias->text, name) == 0))
            return false;
    for (uint32_t i = 0; i < s->local.n; i++)
        if (strcmp(s->local.at[i]->name->text, name) == 0)
            return false;
    for (uint32_t i = 0; i < f->p->state.n; i++)
        if (strcmp(f->p->state.at[i]->name->text, name) == 0)
            return false;
    return true;
}

static const char *free_name(Arena *arena, const Faults *f, const Script *s, const char *prefix, const Var *v)
{
    const char *name = format_in(arena, "%s_%s", prefix, v->name->text);

    while (!is_name_free(f, s, name))
        name = format_in(arena, "%s_", name);
    return name;
}

// A fault, and the names that the generated script uses for it.
typedef struct FaultText {
    const Faults *f;
    const Var *var;
    FaultKind kind;
    const char *g, *input, *truth, *other;    // of G, of the faulty input, of its true value; other: of the last reading, or the
                                             // prefix of the names of earlier values (LATE)
    uint64_t from, to;        // the fault is active while from <= G < to
} FaultText;

static bool holds_reading(FaultKind kind) { return kind == FAULT_STUCK || kind == FAULT_DROPPED; }

// Declares the script variables that the simulated sensor needs.
static void write_locals(const FaultText *t, Buf *out)
{
    const char *type = sm_type_info[t->var->type].spelling, *zero = t->var->type == SM_BOOL ? "false" : "0";

    buf_printf(out, "%s %s = %s     # the true value\n", type, t->truth, zero);
    if (holds_reading(t->kind))
        buf_printf(out, "%s %s = %s     # the last reading before the fault\n", type, t->other, zero);
    for (uint32_t i = 0; t->kind == FAULT_LATE && i <= t->f->options.sizes.late; i++)
        buf_printf(out, "%s %s%lu = %s\n", type, t->other, (unsigned long)i, zero);
}

// Appends the conditionals that store earlier true values for the faulty reading.
static void write_memory(const FaultText *t, Buf *out)
{
    const uint32_t late = t->f->options.sizes.late;

    if (holds_reading(t->kind))
        buf_printf(out, "%s < %" PRIu64 " or %s == 0: %s = %s\n", t->g, t->from, t->g, t->other, t->truth);
    if (t->kind != FAULT_LATE)
        return;
    buf_printf(out, "%s == 0 {\n", t->g);
    for (uint32_t i = 1; i <= late; i++)
        buf_printf(out, "    %s%lu = %s\n", t->other, (unsigned long)i, t->truth);
    buf_str(out, "}\nelse {\n");
    for (uint32_t i = late; i > 0; i--)
        buf_printf(out, "    %s%lu = %s%lu\n", t->other, (unsigned long)i, t->other, (unsigned long)(i - 1));
    buf_printf(out, "}\ntrue: %s0 = %s\n", t->other, t->truth);
}

// Writes the expression of what the faulty sensor reads.
static void write_reading(const FaultText *t, Buf *out)
{
    const FaultSizes *sizes = &t->f->options.sizes;
    FaultInput in = {0};

    for (uint32_t i = 0; i < t->f->input.n; i++)
        in = t->f->input.at[i].var == t->var ? t->f->input.at[i] : in;
    switch (t->kind) {
    case FAULT_STUCK: case FAULT_DROPPED: buf_str(out, t->other); break;
    case FAULT_DEAD: case FAULT_NAN: buf_str(out, t->var->type == SM_BOOL ? "false" : "0"); break;
    case FAULT_LOW: format_number_shortest(out, in.lo); break;
    case FAULT_HIGH:
        if (t->var->type == SM_BOOL)
            buf_str(out, "true");
        else
            format_number_shortest(out, in.hi);
        break;
    case FAULT_BELOW: case FAULT_ABOVE:
        buf_printf(out, "%s %c ", t->truth, t->kind == FAULT_ABOVE ? '+' : '-');
        format_number_shortest(out, (in.hi - in.lo) * sizes->offset);
        break;
    case FAULT_NOISY:
        buf_printf(out, "%s + noise(", t->truth);
        format_number_shortest(out, (in.hi - in.lo) * sizes->noise);
        buf_char(out, ')');
        break;
    case FAULT_LATE: buf_printf(out, "%s%lu", t->other, (unsigned long)sizes->late); break;
    case FAULT_FLIPPED: buf_printf(out, "not %s", t->truth); break;
    case FAULT_KIND_COUNT: break;
    }
}

// Writes the conditionals that give the input its true value before the fault and after it, and the faulty reading in between.
static void write_sensor(const FaultText *t, Buf *out)
{
    write_memory(t, out);
    if (t->from > 0)
        buf_printf(out, "%s < %" PRIu64 ": %s = %s\nelse", t->g, t->from, t->input, t->truth);
    if (t->to != UINT64_MAX)
        buf_printf(out, "%s%s < %" PRIu64 ": %s = ", t->from ? " if " : "", t->g, t->to, t->input);
    else
        buf_printf(out, "%s: %s = ", t->from ? "" : "true", t->input);
    write_reading(t, out);
    if (t->to != UINT64_MAX)
        buf_printf(out, "\nelse: %s = %s", t->input, t->truth);
    buf_char(out, '\n');
}

static FaultText text_of_fault(const Edits *e, const Faults *f, const FaultResult *r, const Script *s, uint32_t i)
{
    const FaultTrigger *t = &f->trigger.at[r->trigger];
    FaultText text = {.f = f, .var = e->var[i], .kind = r->fault[i].kind, .g = f->p->g->name->text, .input = e->var[i]->name->text,
                      .truth = e->name[i],
                      .from = t->g, .to = UINT64_MAX};

    text.other = free_name(e->arena, f, s, text.kind == FAULT_LATE ? "late" : "last", e->var[i]);
    if (text.kind == FAULT_LATE)
        text.other = format_in(e->arena, "%s_", text.other);
    if (text.kind == FAULT_DROPPED)
        text.to = t->g + f->options.sizes.dropped * (s->program->joint ? s->program->step : s->delta_t);
    return text;
}

static void write_sensors(const Edits *e, const Faults *f, const FaultResult *r, const Script *s, Buf *out)
{
    FaultText text[FAULTS_MOST];

    buf_str(out, "\n# ---- the fault ----\n\n[local]\n");
    for (uint32_t i = 0; i < r->faults; i++) {
        text[i] = text_of_fault(e, f, r, s, i);
        write_locals(&text[i], out);
    }
    buf_str(out, "\n[all_states]\n");
    for (uint32_t i = 0; i < r->faults; i++)
        write_sensor(&text[i], out);
    if (needs_assert(r))
        write_assert(f, r, out);
}

const char *fault_script_write_edited(Arena *arena, const Faults *f, const FaultResult *r, const FaultScriptPlace *place, Buf *out)
{
    const Script *s = f->script[f->trigger.at[r->trigger].script];
    Edits e = {.arena = arena, .src = s->src, .vars = r->faults, .hides_asserts = hides_asserts(r)};

    if (needs_assert(r) && !r->differs)
        return "no output shows it";
    if (s->by_rows)
        return "its steps are the rows of a file";
    if (s->program->joint && s->program->step == 0)
        return "its ticks are no whole units of G";
    for (uint32_t i = 0; i < r->faults; i++) {
        e.var[i] = f->input.at[r->fault[i].input].var;
        e.name[i] = free_name(arena, f, s, "true", e.var[i]);
    }
    collect_edits(&e, s, place->to_original);
    write_header(f, r, place, out);
    if (!e.problem)
        write_edited_text(&e, out);
    write_sensors(&e, f, r, s, out);
    return e.problem;
}

// ---- the recorded form ----

static void write_input(const FaultWrite *w, Buf *out)
{
    buf_printf(out, "    %s = ", w->var->name->text);
    if (w->var->type == SM_BOOL)
        buf_str(out, w->cell ? "true" : "false");
    else if (ref_read(w->var->type, w->cell) == 0)
        buf_char(out, '0');                           // also for NaN, which the machine reads as 0
    else
        format_cell_shortest(out, w->var->type, w->cell);
    buf_char(out, '\n');
}

static void write_options(const Script *s, const FaultWrites *writes, Buf *out)
{
    buf_str(out, "\n[options]\n");
    if (!s->program->joint)
        buf_printf(out, "delta_t %" PRIu64 "\ninit_state %s\n", s->delta_t, s->init_state->name->text);
    for (uint32_t i = 0; i < writes->n; i++)
        if (writes->at[i].var->parameter) {
            buf_printf(out, "set %s ", writes->at[i].var->name->text);
            if (writes->at[i].var->type == SM_BOOL)
                buf_str(out, writes->at[i].cell ? "true" : "false");
            else
                format_cell_shortest(out, writes->at[i].var->type, writes->at[i].cell);
            buf_char(out, '\n');
        }
}

static void write_steps(const Faults *f, const FaultWrites *writes, Buf *out)
{
    for (uint32_t i = 0; i < writes->n; i++) {
        const FaultWrite *w = &writes->at[i];
        if (w->var->parameter)
            continue;
        if (i == 0 || w[-1].step != w->step || w[-1].var->parameter)
            buf_printf(out, "%s == %" PRIu64 " {\n", f->p->g->name->text, w->g);
        write_input(w, out);
        if (i + 1 == writes->n || w[1].step != w->step)
            buf_str(out, "}\n");
    }
}

const char *fault_script_write_recorded(Arena *arena, Faults *f, const FaultResult *r, const FaultScriptPlace *place, Buf *out)
{
    enum { WRITES_MOST = 100000 };
    const Script *s = f->script[f->trigger.at[r->trigger].script];
    FaultWrites writes = {0};

    if (needs_assert(r) && !r->differs)
        return "no output shows it";
    if (s->by_rows)
        return "its steps are the rows of a file";
    (void)arena;
    faults_record(f, r, &writes);
    if (writes.n > WRITES_MOST)
        return "it would be too long";
    write_header(f, r, place, out);
    write_options(s, &writes, out);
    buf_str(out, "\n[all_states]\n");
    write_steps(f, &writes, out);
    if (needs_assert(r))
        write_assert(f, r, out);
    if (r->outcome == FAULT_HAS_FAILED) {
        buf_printf(out, "%s == %" PRIu64 ": @fail \"", f->p->g->name->text, r->failed ? r->failed_at.g : r->end_g);
        if (r->failed)
            write_failed(r->failed, out);
        else
            buf_str(out, "@compare");
        buf_str(out, " fails\"\n");
    }
    buf_printf(out, "%s == %" PRIu64 "%s: @stop\n", f->p->g->name->text, r->end_g, r->outcome == FAULT_HAS_ENDLESS ? " and false" : "");
    return NULL;
}

// ---- running it ----

bool fault_script_reproduces(Arena *arena, const Faults *f, const FaultResult *r, const Script *s)
{
    Arena run;
    Diags unused;
    Engine *e;
    ScriptResult result;
    FaultMoment at = failing_moment(r);
    const ScriptOptions o = {.max_steps = r->steps, .seed = f->options.has_seed ? &f->options.sizes.seed : NULL, .is_silent = true,
                             .is_compared = true, .ends_at_violation = true,
                             .ignored = f->baseline.run.at[f->trigger.at[r->trigger].script].ignored,
                             .requirements = f->options.requirements, .setting = f->options.setting, .settings = f->options.settings};
    bool is_same;

    arena_init(&run, arena->alloc, arena->context, arena->oom);
    diags_init(&unused, &run);
    unused.muted = true;
    e = engine_flat_open_machines(&run, f->p, flat_new_machines(&run, f->p), NULL, 0);
    result = script_run(&run, &unused, s, &e, 1, &o);
    is_same = result.steps == (at.step ? at.step : r->steps) && result.outcome == (r->outcome == FAULT_HAS_ENDLESS ? SCRIPT_ENDLESS : SCRIPT_FAILED);
    if (r->outcome == FAULT_HAS_VIOLATED && !r->violated_in_truth)
        is_same = is_same && result.is_violated && result.requirement[r->violated - 1].violations > 0;
    arena_free(&run);
    return is_same;
}

bool fault_write_range(const FaultInput *in, Buf *out)
{
    if (!in->range_is_seen)
        return false;
    buf_printf(out, "'%s' has no @range; ", in->var->report_name->text);
    if (in->has_range)
        buf_printf(out, "its range in the runs without a fault is %.7g to %.7g", in->lo, in->hi);
    else
        buf_str(out, "it never changes, so it has no faults that depend on a range");
    return true;
}
