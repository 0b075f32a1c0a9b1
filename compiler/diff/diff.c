// SPDX-License-Identifier: Apache-2.0
#include "compiler/diff/diff.h"

#include <string.h>

#include "compiler/budget/cost.h"
#include "compiler/diff/diff_part.h"
#include "compiler/report/written.h"

const char *const diff_part_name[DIFF_PARTS] = {"state", "transition", "statement", "variable", "option", "mark", "layout"};
const char *const diff_how_name[DIFF_HOWS] = {"added", "removed", "changed", "renamed", "rewritten"};
const char *const diff_weight_name[] = {"behaviour", "interface", "note"};

void diff_add(ProgramDiff *d, DiffChange change)
{
    change.where = change.where ? change.where : "";
    vec_push(d->arena, &d->change, change);
}

bool diff_is_same(const ProgramDiff *d)
{
    for (size_t i = 0; i < d->change.n; i++)
        if (d->change.at[i].weight == DIFF_BEHAVIOUR)
            return false;
    for (size_t i = 0; i < d->run.n; i++)
        if (!d->run.at[i].problem && !d->run.at[i].same)
            return false;
    return true;
}

// ---- transitions and statements of one place ----

// A transition or an assignment, with the condition around it.
typedef struct Item {
    const Stmt *stmt;
    const Condition *when;
    BlockKind block;
    const char *target;           // in canonical form: "->Vent", or the assigned variable
    const char *condition, *value;            // in canonical form; value: of an assignment
    bool matched;
} Item;
typedef VEC(Item) Items;

// A state or a section [all_states] of one machine.
typedef struct Place { const State *state; const AllStates *all; } Place;

typedef struct ItemWalk { Arena *arena; const Canon *c; Place place; Items *out; } ItemWalk;

// Called for each statement of the machine: adds it to the list if it is a transition or assignment in the searched place (w->place).
static void add_item(const StmtLocation *at, void *context)
{
    ItemWalk *w = context;
    const Stmt *s = at->stmt;
    Item item = {.stmt = s, .when = at->when, .block = at->block, .value = ""};
    Buf value;

    if (at->state != w->place.state || s->kind == ST_IF || written_section(w->c->p, s->span) != w->place.all)
        return;
    item.target = s->kind == ST_TRANSITION ? format_in(w->arena, "->%s", w->c->state[s->target->number]) : w->c->var[s->var->index];
    item.condition = canon_condition(w->arena, w->c, at->when);
    if (s->kind == ST_ASSIGN) {
        buf_init(&value, w->arena);
        canon_expr(w->c, s->value, &value);
        item.value = buf_text(&value);
    }
    vec_push(w->arena, w->out, item);
}

// Lists the transitions and assignments in a place: the own statements of a state, or of one [all_states] section in it (Place).
static Items list_items(ProgramDiff *d, const Canon *c, Place place)
{
    Items out = {NULL, 0, 0};
    ItemWalk w = {d->arena, c, place, &out};

    if (place.state)
        each_stmt_location(d->arena, c->p, add_item, &w);
    return out;
}

// Returns the source text of an item (a transition or assignment): the condition of a transition; an assignment with its condition.
static const char *item_text(Arena *arena, const Item *i)
{
    const char *when = i->when ? condition_text(arena, i->when) : "";

    if (i->stmt->kind == ST_TRANSITION)
        return i->when ? when : "always";
    return format_in(arena, "%s%s%s", source_text(arena, i->stmt->span), i->when ? " if " : "", when);
}

// Returns how the report names a transition or assignment: "-> Vent in .entry" or "valve in .step".
static const char *item_name(Arena *arena, const Item *i)
{
    if (i->stmt->kind == ST_TRANSITION)
        return format_in(arena, "-> %s%s", i->stmt->target->name->text, i->block == BLOCK_ENTRY ? " in .entry" : "");
    return format_in(arena, "%s in %s", i->stmt->var->name->text,
                     i->block == BLOCK_ENTRY ? ".entry" : i->block == BLOCK_EXIT ? ".exit" : ".step");
}

// Creates the record of a transition or assignment that was added (old is NULL), removed (new is NULL) or changed.
static DiffChange item_change(ProgramDiff *d, const char *where, const Item *old, const Item *new)
{
    DiffChange c = {.how = !old ? DIFF_ADDED : !new ? DIFF_REMOVED : DIFF_CHANGED, .weight = DIFF_BEHAVIOUR, .where = where};

    c.part = (new ? new : old)->stmt->kind == ST_TRANSITION ? DIFF_TRANSITION : DIFF_STATEMENT;
    c.what = item_name(d->arena, new ? new : old);
    c.old = old ? item_text(d->arena, old) : NULL;
    c.new = new ? item_text(d->arena, new) : NULL;
    c.old_stmt = old ? old->stmt : NULL;
    c.new_stmt = new ? new->stmt : NULL;
    return c;
}

enum { SAME_ALL, SAME_TARGET, SAME_CONDITION, RULES };

// Whether two items of the machines are versions of each other under this rule. Stricter rules are tried first: see SAME_ALL.
static bool items_match(const Item *a, const Item *b, int rule)
{
    if (a->stmt->kind != b->stmt->kind || a->block != b->block)
        return false;
    switch (rule) {
    case SAME_ALL: return strcmp(a->target, b->target) == 0 && strcmp(a->condition, b->condition) == 0 && strcmp(a->value, b->value) == 0;
    case SAME_TARGET: return strcmp(a->target, b->target) == 0;
    default: return a->stmt->kind == ST_TRANSITION && strcmp(a->condition, b->condition) == 0;
    }
}

// Records that item a became b, with the meaning of the change: another target, or how the guard differs.
static void add_changed_item(ProgramDiff *d, const Canon canon[2], const char *where, const Item *a, const Item *b)
{
    DiffChange c = item_change(d, where, a, b);

    if (strcmp(a->target, b->target) != 0) {
        c.meaning = format_in(d->arena, "leads to %s instead of %s", b->stmt->target->name->text, a->stmt->target->name->text);
    } else if (strcmp(a->value, b->value) == 0)
        c.meaning = diff_compare_guards(d, canon, a->when, b->when);
    if (!c.meaning && strcmp(c.old, c.new) == 0)
        c.meaning = diff_describe_defines(d, a->stmt, a->when);
    diff_add(d, c);
}

// Pairs the transitions and assignments of a place in the old and the new machine, and adds the differences to d->change.
static void compare_items(ProgramDiff *d, const Canon canon[2], const char *where, Place old, Place new)
{
    Items a = list_items(d, &canon[0], old), b = list_items(d, &canon[1], new);

    for (int rule = 0; rule < RULES; rule++)
        for (size_t i = 0; i < a.n; i++)
            for (size_t k = 0; k < b.n && !a.at[i].matched; k++) {
                if (b.at[k].matched || !items_match(&a.at[i], &b.at[k], rule))
                    continue;
                a.at[i].matched = b.at[k].matched = true;
                if (rule != SAME_ALL)
                    add_changed_item(d, canon, where, &a.at[i], &b.at[k]);
            }
    for (size_t i = 0; i < a.n; i++)
        if (!a.at[i].matched)
            diff_add(d, item_change(d, where, &a.at[i], NULL));
    for (size_t k = 0; k < b.n; k++)
        if (!b.at[k].matched)
            diff_add(d, item_change(d, where, NULL, &b.at[k]));
}

// ---- states ----

// Returns the statements of a place in canonical form, with names that do not depend on their spelling.
static const char *canon_place(ProgramDiff *d, const Canon *c, Place place)
{
    Buf out;

    buf_init(&out, d->arena);
    for (int b = 0; b < BLOCK_COUNT && place.state; b++) {
        const Stmts list = place.all ? b == BLOCK_STEP ? written_section_stmts(c->p, place.all) : (Stmts){NULL, 0, 0}
            : written_own_stmts(place.state, (BlockKind)b);
        buf_printf(&out, ".%d ", b);
        canon_stmts(c, &list, &out);
    }
    return buf_text(&out);
}

// Compares the statements of a place in the old and the new machine.  With `same_code` (equal IR), all differences are notes.
static void compare_place(ProgramDiff *d, const Canon canon[2], const char *where, Place old, Place new, bool same_code)
{
    const size_t before = d->change.n;
    DiffChange whole = {.part = DIFF_STATEMENT, .how = DIFF_CHANGED, .weight = DIFF_BEHAVIOUR, .where = where,
                        .what = "order or nesting of its statements"};

    if (strcmp(canon_place(d, &canon[0], old), canon_place(d, &canon[1], new)) == 0)
        return;
    if (same_code) {
        whole.how = DIFF_REWRITTEN;
        whole.weight = DIFF_NOTE;
        whole.what = "statements";
        whole.meaning = "written differently; the optimiser makes the same code of them";
        diff_add(d, whole);
        return;
    }
    compare_items(d, canon, where, old, new);
    if (d->change.n == before && old.state && new.state)         // of a state without statements that is added, nothing is in another order
        diff_add(d, whole);
}

static const char *state_text(Arena *arena, const State *s)
{
    return format_in(arena, "%s%s%s%s", s->name->text, s->is_abort ? " @abort" : "", s->is_safe ? " @safe" : "", s->allows_swap ? " @swap" : "");
}

static void compare_state_marks(ProgramDiff *d, const State *a, const State *b)
{
    if (a->is_abort != b->is_abort || a->is_safe != b->is_safe || a->allows_swap != b->allows_swap)
        diff_add(d, (DiffChange){.part = DIFF_MARK, .how = DIFF_CHANGED, .weight = DIFF_NOTE, .where = b->name->text, .what = "marks of the state",
                                 .old = state_text(d->arena, a), .new = state_text(d->arena, b)});
}

// Whether two states have the same statements in canonical form.
static bool same_text(ProgramDiff *d, const Canon canon[2], const State *a, const State *b)
{
    Buf x, y;

    buf_init(&x, d->arena);
    buf_init(&y, d->arena);
    canon_state(&canon[0], a, &x);
    canon_state(&canon[1], b, &y);
    return strcmp(buf_text(&x), buf_text(&y)) == 0;
}

// Compares the [all_states] sections of both machines, in their order.
static void compare_sections(ProgramDiff *d, const Canon canon[2])
{
    const Program *p = d->old.p, *q = d->new.p;
    const size_t most = p->all_states.n > q->all_states.n ? p->all_states.n : q->all_states.n;

    for (size_t i = 0; i < most; i++) {
        Place old = {NULL, NULL}, new = {NULL, NULL};
        const char *old_name = NULL, *new_name = NULL;
        bool same = true;
        if (i < p->all_states.n) {
            old = (Place){written_first_state(p, p->all_states.at[i]), p->all_states.at[i]};
            old_name = written_section_name(d->arena, p, old.all, "");
        }
        if (i < q->all_states.n) {
            new = (Place){written_first_state(q, q->all_states.at[i]), q->all_states.at[i]};
            new_name = written_section_name(d->arena, q, new.all, "");
        }
        for (uint32_t s = 1; s <= q->state.n; s++)
            same = same && d->same_state[s];
        if (!same && old_name && new_name && strcmp(old_name, new_name) != 0)
            diff_add(d, (DiffChange){.part = DIFF_STATE, .how = DIFF_CHANGED, .weight = DIFF_BEHAVIOUR, .where = new_name,
                                     .what = "where [all_states] runs",
                                     .old = old_name, .new = new_name});
        compare_place(d, canon, new_name ? new_name : old_name, old, new, same);
    }
}

// Returns how many of the changes found so far change the behaviour.
static size_t count_behaviour(const ProgramDiff *d)
{
    size_t n = 0;

    for (size_t i = 0; i < d->change.n; i++)
        n += d->change.at[i].weight == DIFF_BEHAVIOUR;
    return n;
}

// Compares the states.  One whose code differs is always listed, even if no single difference can be named.
static void compare_states(ProgramDiff *d, const Canon canon[2])
{
    const Program *p = d->old.p, *q = d->new.p;
    bool differs = false;

    for (size_t i = 0; i < p->state.n; i++) {
        const State *a = p->state.at[i], *b = d->state_of[a->number] ? q->state.at[d->state_of[a->number] - 1] : NULL;
        if (!b)
            diff_add(d, (DiffChange){.part = DIFF_STATE, .how = DIFF_REMOVED, .weight = DIFF_BEHAVIOUR, .where = a->name->text, .what = "state",
                                     .old = state_text(d->arena, a)});
        else {
            d->same_state[b->number] = same_text(d, canon, a, b) || diff_same_code(d, a, b);
            differs = differs || !d->same_state[b->number];
        }
    }
    for (size_t i = 0; i < q->state.n; i++) {
        const State *b = q->state.at[i], *a = d->old_state_of[b->number] ? p->state.at[d->old_state_of[b->number] - 1] : NULL;
        if (!a)
            diff_add(d, (DiffChange){.part = DIFF_STATE, .how = DIFF_ADDED, .weight = DIFF_BEHAVIOUR, .where = b->name->text, .what = "state",
                                     .new = state_text(d->arena, b)});
        compare_place(d, canon, b->name->text, (Place){a, NULL}, (Place){b, NULL}, a && d->same_state[b->number]);
        if (a)
            compare_state_marks(d, a, b);
    }
    compare_sections(d, canon);
    if (differs && count_behaviour(d) == 0)
        diff_add(d, (DiffChange){.part = DIFF_STATEMENT, .how = DIFF_CHANGED, .weight = DIFF_BEHAVIOUR, .what = "order or nesting of statements"});
    if (d->state_of[1] != 1)
        diff_add(d, (DiffChange){.part = DIFF_STATE, .how = DIFF_CHANGED, .weight = DIFF_BEHAVIOUR, .where = q->state.at[0]->name->text,
                                 .what = "initial state",
                                 .old = p->state.at[0]->name->text, .new = q->state.at[0]->name->text});
    else if (!canon[0].keeps_numbers && d->state_of[1] == 1)
        for (uint32_t s = 2; s <= p->state.n; s++)
            if (d->state_of[s] && d->state_of[s] != s)
                diff_add(d, (DiffChange){.part = DIFF_STATE, .how = DIFF_CHANGED, .weight = DIFF_INTERFACE,
                                         .where = q->state.at[d->state_of[s] - 1]->name->text,
                                         .what = "number in S", .old = format_in(d->arena, "%lu", (unsigned long)s),
                                         .new = format_in(d->arena, "%lu", (unsigned long)d->state_of[s])});
}

// ---- variables ----

// Returns the declaration of a variable, in normal form, for the report.
static const char *var_text(Arena *arena, const Var *v)
{
    Buf out;

    buf_init(&out, arena);
    buf_printf(&out, "%s %s", sm_type_info[v->type].spelling, v->name->text);
    if (v->alias)
        buf_printf(&out, " @alias %s", v->alias->text);
    if (v->kind == VAR_LOCAL) {
        buf_str(&out, " = ");
        format_cell_shortest(&out, v->type, v->parameter ? v->parameter->standard : v->init);
    }
    if (v->parameter) {
        buf_str(&out, " @parameter @range ");
        format_number_shortest(&out, v->parameter->lo);
        buf_char(&out, ' ');
        format_number_shortest(&out, v->parameter->hi);
    } else if (v->read_only && v->kind == VAR_LOCAL)
        buf_str(&out, " @read_only");
    if (v->range) {
        buf_str(&out, " @range ");
        format_number_shortest(&out, v->range->lo);
        buf_char(&out, ' ');
        format_number_shortest(&out, v->range->hi);
    }
    buf_printf(&out, "%s", v->command ? " @command" : "");
    return buf_text(&out);
}

static bool same_parameter(const Parameter *a, const Parameter *b)
{
    return (!a && !b) || (a && b && a->lo == b->lo && a->hi == b->hi && a->standard == b->standard);
}

// Returns how serious a difference between two declarations is.  The behaviour depends on the type, on the initial value of a local that is not
// constant, and on the values that a parameter can have.
static DiffWeight weigh_declarations(const Var *a, const Var *b)
{
    if (a->type != b->type || !same_parameter(a->parameter, b->parameter))
        return DIFF_BEHAVIOUR;
    if (a->kind == VAR_LOCAL && a->init != b->init && !(a->is_constant && b->is_constant) && (a->read || b->read))
        return DIFF_BEHAVIOUR;
    return DIFF_NOTE;
}

static void compare_variables(ProgramDiff *d)
{
    const Program *p = d->old.p, *q = d->new.p;

    for (size_t i = 0; i < p->var.n; i++) {
        const Var *a = p->var.at[i], *b = d->var_of[i];
        DiffChange c = {.part = DIFF_VARIABLE, .how = !b ? DIFF_REMOVED : DIFF_CHANGED, .weight = DIFF_NOTE};
        if (a->kind == VAR_TIME)
            continue;
        c.what = format_in(d->arena, "%s %s", a->kind == VAR_ELEMENT ? "element" : a->parameter ? "parameter" : "local", a->name->text);
        c.old = var_text(d->arena, a);
        c.new = b ? var_text(d->arena, b) : NULL;
        if (b && strcmp(c.old, c.new) == 0)
            continue;
        if (b)
            c.weight = weigh_declarations(a, b);
        else
            c.weight = a->kind == VAR_ELEMENT || a->parameter ? DIFF_INTERFACE : DIFF_NOTE;
        if (b && c.weight == DIFF_NOTE && a->name != b->name && a->kind == VAR_LOCAL && strcmp(a->name->text, b->name->text) != 0)
            c.how = DIFF_RENAMED;
        diff_add(d, c);
    }
    for (size_t i = 0; i < q->var.n; i++) {
        const Var *b = q->var.at[i];
        if (!d->old_var_of[i] && b->kind != VAR_TIME)
            diff_add(d, (DiffChange){.part = DIFF_VARIABLE, .how = DIFF_ADDED,
                                     .weight = b->kind == VAR_ELEMENT || b->parameter ? DIFF_INTERFACE : DIFF_NOTE,
                                     .what = format_in(d->arena, "%s %s", b->kind == VAR_ELEMENT ? "element" : b->parameter ? "parameter" : "local",
                                                       b->name->text),
                                     .new = var_text(d->arena, b)});
    }
}

// ---- options, marks, layout ----

static void compare_options(ProgramDiff *d)
{
    static const char *const unit[] = {"", "us", "ms", "s", "min", "h"};
    const Program *p = d->old.p, *q = d->new.p;

    if (p->step != q->step)
        diff_add(d, (DiffChange){.part = DIFF_OPTION, .how = DIFF_CHANGED, .weight = DIFF_INTERFACE, .what = "step",
                                 .old = format_in(d->arena, "%llu", (unsigned long long)p->step),
                                 .new = format_in(d->arena, "%llu", (unsigned long long)q->step),
                                 .meaning = "how much G advances from step to step; 0: not declared"});
    if (p->time_unit != q->time_unit)
        diff_add(d, (DiffChange){.part = DIFF_OPTION, .how = DIFF_CHANGED, .weight = DIFF_INTERFACE, .what = "time_unit",
                                 .old = (size_t)p->time_unit < sizeof unit / sizeof *unit ? unit[p->time_unit] : "",
                                 .new = (size_t)q->time_unit < sizeof unit / sizeof *unit ? unit[q->time_unit] : ""});
}

// Counts the marks @req of requirement `id` in a state, among the first `end` marks of the old or the new machine.  `state`: its name in the new one.
static size_t count_marks(const ProgramDiff *d, bool of_new, Str id, const char *state, size_t end)
{
    const Program *p = of_new ? d->new.p : d->old.p;
    size_t n = 0;

    for (size_t i = 0; i < p->mark.n && i < end; i++) {
        const State *s = p->mark.at[i].state;
        if (s && !of_new && d->state_of[s->number])
            s = d->new.p->state.at[d->state_of[s->number] - 1];
        n += strcmp(p->mark.at[i].requirement->text, id->text) == 0 && strcmp(s ? s->name->text : "", state) == 0;
    }
    return n;
}

// Lists the requirements that a state of one machine is marked with more often than the same state of the other.
static void compare_requirements(ProgramDiff *d)
{
    for (int side = 0; side < 2; side++) {
        const Program *p = side ? d->new.p : d->old.p;
        for (size_t i = 0; i < p->mark.n; i++) {
            const RequirementMark *m = &p->mark.at[i];
            const State *s = m->state;
            const char *where;
            if (s && !side && d->state_of[s->number])
                s = d->new.p->state.at[d->state_of[s->number] - 1];
            where = s ? s->name->text : "";
            if (count_marks(d, side, m->requirement, where, i + 1) > count_marks(d, !side, m->requirement, where, SIZE_MAX))
                diff_add(d, (DiffChange){.part = DIFF_MARK, .how = side ? DIFF_ADDED : DIFF_REMOVED, .weight = DIFF_NOTE, .where = where,
                                         .what = format_in(d->arena, "@req %s", m->requirement->text)});
        }
    }
}

// Whether two state vectors have the same elements at the same offsets.  A machine's own section is a region with the name of its file, which can
// differ between two versions.
static bool same_vector(const StateVec *a, const StateVec *b)
{
    if (a->size != b->size || a->element.n != b->element.n || a->region.n != b->region.n || a->from_machine != b->from_machine)
        return false;
    for (size_t i = 0; i < a->region.n && !a->from_machine; i++)
        if (strcmp(a->region.at[i]->name->text, b->region.at[i]->name->text) != 0)
            return false;
    for (size_t i = 0; i < a->element.n; i++) {
        const Element *x = a->element.at[i], *y = b->element.at[i];
        if (strcmp(x->name->text, y->name->text) != 0 || x->type != y->type || x->offset != y->offset)
            return false;
    }
    return true;
}

static void compare_layout(ProgramDiff *d)
{
    const StateVec *a = d->old.p->sv, *b = d->new.p->sv;

    d->same_layout = same_vector(a, b);
    d->same_image = d->old.identity == d->new.identity;
    if (!d->same_layout)
        diff_add(d, (DiffChange){.part = DIFF_LAYOUT, .how = DIFF_CHANGED, .weight = DIFF_INTERFACE, .what = "layout of the state vector",
                                 .old = format_in(d->arena, "%lu bytes, %lu elements", (unsigned long)a->size, (unsigned long)a->element.n),
                                 .new = format_in(d->arena, "%lu bytes, %lu elements", (unsigned long)b->size, (unsigned long)b->element.n),
                                 .meaning = "images of the one do not run with the other"});
}

// Reports whether the new machine can continue where the old one is, if it is swapped in flight, and what it loses (swapping.md 12.2, 12.4, 12.7).
static void describe_swap(ProgramDiff *d)
{
    Buf can, lost;

    buf_init(&can, d->arena);
    buf_init(&lost, d->arena);
    for (size_t i = 0; i < d->old.p->state.n; i++) {
        const State *s = d->old.p->state.at[i];
        bool has_name = false;
        if (!s->is_safe && !s->allows_swap)
            continue;
        for (size_t k = 0; k < d->new.p->state.n; k++)
            has_name |= strcmp(d->new.p->state.at[k]->name->text, s->name->text) == 0;
        buf_printf(has_name ? &can : &lost, "%s%s", (has_name ? can : lost).n ? ", " : "", s->name->text);
    }
    if (!d->same_layout)
        d->swap = "not possible: the layout of the state vector differs";
    else if (can.n + lost.n == 0)
        d->swap = "not possible: no state of the old machine is marked @swap or @safe";
    else if (can.n == 0)
        d->swap = format_in(d->arena, "not possible: the new machine has no state of the name %s", buf_text(&lost));
    else
        d->swap = format_in(d->arena, "possible in %s%s%s", buf_text(&can), lost.n ? "; not in " : "", buf_text(&lost));
}

// ---- costs and findings ----

static void compare_costs(ProgramDiff *d)
{
    static const struct { const char *name; CostUnit unit; } row[] = {
        {"instructions of the longest step", COST_INSTRUCTIONS}, {"cycles of the longest step, ATmega, image in flash", COST_CYCLES_FLASH},
        {"cycles of the longest step, ATmega, image in EEPROM", COST_CYCLES_EEPROM}};
    Cost a, b;

    if (!d->old.measured || !d->new.measured)
        return;
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        cost_of_machine(d->arena, d->old.measured, 0, row[i].unit, &a);
        cost_of_machine(d->arena, d->new.measured, 0, row[i].unit, &b);
        vec_push(d->arena, &d->cost, ((DiffCost){row[i].name, a.worst, b.worst}));
    }
    vec_push(d->arena, &d->cost, ((DiffCost){"bytes of the image", d->old.image_size, d->new.image_size}));
    vec_push(d->arena, &d->cost, ((DiffCost){"bytes of memory on the VM", a.ram, b.ram}));
}

// Returns the name of the state that contains this position of the source; "": none.
static const char *state_at(const Program *p, Span span)
{
    for (size_t i = 0; i < p->state.n; i++) {
        const Span s = written_state_range(p->state.at[i]);
        if (span.src == s.src && span.at >= s.at && span.at < s.at + s.len)
            return p->state.at[i]->name->text;
    }
    return "";
}

// Returns the name that a state of the old machine has in the new one; without a match, or with `of_new`, the same name.
static const char *name_in_new(const ProgramDiff *d, bool of_new, const char *state)
{
    for (size_t i = 0; i < d->old.p->state.n && !of_new; i++)
        if (strcmp(d->old.p->state.at[i]->name->text, state) == 0 && d->state_of[i + 1])
            return d->new.p->state.at[d->state_of[i + 1] - 1]->name->text;
    return state;
}

// Counts the findings of a machine with this code in the state `where`, among its first `end` findings.
static size_t count_findings(const ProgramDiff *d, bool of_new, DiagCode code, const char *where, size_t end)
{
    const Diags *f = of_new ? d->new.findings : d->old.findings;
    const Program *p = of_new ? d->new.p : d->old.p;
    size_t n = 0;

    for (size_t i = 0; i < f->list.n && i < end; i++)
        n += f->list.at[i]->code == code && strcmp(name_in_new(d, of_new, state_at(p, f->list.at[i]->span)), where) == 0;
    return n;
}

// Lists the findings that only one machine has.  They are compared by code and state, not by line.
static void compare_findings(ProgramDiff *d)
{
    for (int side = 1; side >= 0 && d->old.findings && d->new.findings; side--) {
        const Diags *f = side ? d->new.findings : d->old.findings;
        for (size_t i = 0; i < f->list.n; i++) {
            const Diag *g = f->list.at[i];
            const char *where = name_in_new(d, side, state_at(side ? d->new.p : d->old.p, g->span));
            if (count_findings(d, side, g->code, where, i + 1) > count_findings(d, !side, g->code, where, SIZE_MAX))
                vec_push(d->arena, &d->finding, ((DiffFinding){side, g, where}));
        }
    }
}

// ---- all ----

ProgramDiff *diff_programs(Arena *arena, const DiffSide *old, const DiffSide *new)
{
    ProgramDiff *d = ARENA_NEW(arena, ProgramDiff);
    Canon canon[2];

    d->arena = arena;
    d->old = *old;
    d->new = *new;
    d->state_of = ARENA_ARRAY(arena, uint32_t, old->p->state.n + 1u);
    d->old_state_of = ARENA_ARRAY(arena, uint32_t, new->p->state.n + 1u);
    d->var_of = ARENA_ARRAY(arena, const Var *, old->p->var.n + 1u);
    d->old_var_of = ARENA_ARRAY(arena, const Var *, new->p->var.n + 1u);
    d->same_state = ARENA_ARRAY(arena, bool, new->p->state.n + 1u);
    diff_match(d, canon);
    compare_states(d, canon);
    compare_variables(d);
    diff_compare_defines(d);
    compare_options(d);
    compare_requirements(d);
    compare_layout(d);
    describe_swap(d);
    compare_costs(d);
    compare_findings(d);
    return d;
}
