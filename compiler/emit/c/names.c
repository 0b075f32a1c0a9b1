// SPDX-License-Identifier: Apache-2.0
// Assigns C names to the names of the source.  A name is unchanged wherever C and C++ allow it.  Otherwise forbidden characters are removed or an
// underscore is appended, and a number if another thing already has the result as its name.  Unchanged names are assigned first, so that no other
// name of the machine affects them.
#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "compiler/emit/c/unit.h"

static const char *const reserved[] = {
#define R(word) #word,
#include "compiler/emit/c/reserved.def"
#undef R
};

static bool has_suffix(const char *name, const char *end)
{
    const size_t n = strlen(name), e = strlen(end);

    return n >= e && strcmp(name + n - e, end) == 0;
}

// Whether a member or variable of that name may fail to compile as C99 or C++11 with common headers.
bool c_is_reserved(const char *name)
{
    static const char *const own[] = { "_H_INCLUDED", "_SV_LAYOUT", "_slot_", "_sorted_" };   // endings of the emitted headers' own names

    for (size_t i = 0; i < sizeof own / sizeof *own; i++)
        if (has_suffix(name, own[i]))
            return true;
    for (size_t i = 0; i < sizeof reserved / sizeof *reserved; i++)
        if (name[0] == reserved[i][0] && strcmp(name, reserved[i]) == 0)
            return true;
    return name[0] == '_' || strstr(name, "__") != NULL;
}

static bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
static bool is_digit(char c) { return c >= '0' && c <= '9'; }
static char to_upper(char c) { return c >= 'a' && c <= 'z' ? (char)(c - 'a' + 'A') : c; }

// Whether a name is sm, smvm or pal, or begins with one of these and an underscore.
bool c_has_reserved_prefix(const char *name)
{
    static const char *const our[] = {"sm", "smvm", "pal"};

    for (size_t i = 0; i < sizeof our / sizeof *our; i++) {
        const size_t n = strlen(our[i]);
        if (strncmp(name, our[i], n) == 0 && (name[n] == '_' || name[n] == '\0'))
            return true;
    }
    return false;
}

// Turns any text into a C identifier: `my-tank.v2` becomes my_tank_v2, `sm` becomes m_sm.
const char *c_identifier(Arena *arena, const char *text, size_t len)
{
    Buf b;

    buf_init(&b, arena);
    for (size_t i = 0; i < len; i++) {
        if (is_letter(text[i]) || (is_digit(text[i]) && b.n > 0))
            buf_char(&b, text[i]);
        else if (is_digit(text[i]))
            buf_printf(&b, "m%c", text[i]);
        else if (b.n > 0 && b.at[b.n - 1] != '_')
            buf_char(&b, '_');
    }
    while (b.n > 0 && b.at[b.n - 1] == '_')
        b.at[--b.n] = '\0';
    if (b.n == 0)
        return "machine";
    return c_has_reserved_prefix(buf_text(&b)) ? format_in(arena, "m_%s", buf_text(&b)) : buf_text(&b);
}

// Returns the name of a type for a prefix: MyTankV2 for my_tank_v2.
const char *c_type_name(Arena *arena, const char *prefix)
{
    Buf b;

    buf_init(&b, arena);
    for (const char *p = prefix; *p; p++)
        if (*p != '_')
            buf_char(&b, p == prefix || p[-1] == '_' ? to_upper(*p) : *p);
    if (c_is_reserved(buf_text(&b)))
        buf_str(&b, "Machine");
    return buf_text(&b);
}

// Returns the prefix of macros for a prefix: MY_TANK_V2 for my_tank_v2.
const char *c_macro_name(Arena *arena, const char *prefix)
{
    Buf b;

    buf_init(&b, arena);
    for (const char *p = prefix; *p; p++)
        buf_char(&b, to_upper(*p));
    return buf_text(&b);
}

// ---- a set of names, each assigned once ----

typedef struct NameSet {
    Arena *arena;
    StrPool pool;
    Map taken;
} NameSet;

static void name_set_init(NameSet *s, Arena *arena)
{
    memset(s, 0, sizeof *s);
    s->arena = arena;
    str_pool_init(&s->pool, arena);
    s->taken.arena = arena;
}

// Adds a name to the set; returns false if it is already in the set.
static bool try_take_name(NameSet *s, const char *name)
{
    Str key = str_c(&s->pool, name);

    if (map_find(&s->taken, key))
        return false;
    map_put(&s->taken, key, s);
    return true;
}

// Adds `name` to the set, or `name` with the first number from 2 that makes it free; returns what it added.
static const char *take_free_name(NameSet *s, const char *name)
{
    const char *tried = name;

    for (unsigned i = 2; !try_take_name(s, tried); i++)
        tried = format_in(s->arena, has_suffix(name, "_") ? "%s%u" : "%s_%u", name, i);
    return tried;
}

// Returns a valid C name derived from `name`, which C does not allow.
static const char *make_valid_name(Arena *arena, const char *name)
{
    const char *plain = c_identifier(arena, name, strlen(name));

    return strcmp(plain, name) == 0 || c_is_reserved(plain) ? format_in(arena, "%s_", plain) : plain;
}

// Assigns members to `n` names: first those that can be unchanged, then the others.
static void assign_members(NameSet *s, const char **name, const char **member, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (name[i] && !c_is_reserved(name[i]) && try_take_name(s, name[i]))
            member[i] = name[i];
    for (size_t i = 0; i < n; i++)
        if (name[i] && !member[i])
            member[i] = take_free_name(s, make_valid_name(s->arena, name[i]));
}

// ---- the names in a unit ----

// Reserves the names of padding members, as in `pad_at_12_`.
static void reserve_padding_names(NameSet *s, const CVector *sv)
{
    uint32_t at = 0;

    for (size_t i = 0; i <= sv->n; i++) {
        if (i == sv->n || sv->at[i].offset != at)
            try_take_name(s, c_padding_name(s->arena, at));
        if (i < sv->n)
            at = sv->at[i].offset + sm_type_info[sv->at[i].type].bytes;
    }
}

// Returns the name of the member for the padding bytes at an offset.
const char *c_padding_name(Arena *arena, uint32_t at) { return format_in(arena, "pad_at_%u_", (unsigned)at); }

// Assigns the members of the elements of `sv`.  names->sv_type must be set.
void names_assign_elements(Arena *arena, CNames *names, CVector *sv)
{
    const char **name = ARENA_ARRAY(arena, const char *, sv->n), **member = ARENA_ARRAY(arena, const char *, sv->n);
    NameSet s;

    name_set_init(&s, arena);
    try_take_name(&s, names->sv_type);                // C++ does not allow a member with the name of its struct
    reserve_padding_names(&s, sv);
    for (size_t i = 0; i < sv->n; i++)
        name[i] = sv->at[i].name->text;
    assign_members(&s, name, member, sv->n);
    names->element.arena = arena;
    for (size_t i = 0; i < sv->n; i++) {
        sv->at[i].member = member[i];
        map_put(&names->element, sv->at[i].name, (void *)member[i]);
    }
}

// ---- the names of a state vector for the flight runtime ----

// Returns a name as it can be used in the middle or at the end of another name, where keywords are allowed.
static const char *make_name_part(Arena *a, const char *name)
{
    return name[0] != '_' && !strstr(name, "__") ? name : c_identifier(a, name, strlen(name));
}

// Reserves the names that the files of an application use if the application's name is `prefix`.  An element with such a name is renamed.
static void reserve_application_names(NameSet *s, const char *prefix)
{
    static const char *const own[] = { "sv", "vector", "layout", "element", "names", "regions", "element_names", "region_names",
                                       "app", "io", "inputs", "outputs" };

    for (size_t i = 0; i < sizeof own / sizeof *own; i++)
        try_take_name(s, format_in(s->arena, "%s_%s", prefix, own[i]));
}

// Returns an enumerator MACRO_kind_name for each of n names.
static const char **assign_enumerators(NameSet *s, const char *macro, char kind, const char **name, size_t n)
{
    const char **out = ARENA_ARRAY(s->arena, const char *, n);

    for (size_t i = 0; i < n; i++)
        out[i] = take_free_name(s, format_in(s->arena, "%s_%c_%s", macro, kind, make_name_part(s->arena, name[i])));
    return out;
}

// Returns a function name prefix_VERBname for each of n names.
static const char **assign_function_names(NameSet *s, const char *prefix, const char *verb, const char **name, size_t n)
{
    const char **out = ARENA_ARRAY(s->arena, const char *, n);

    for (size_t i = 0; i < n; i++)
        out[i] = take_free_name(s, format_in(s->arena, "%s_%s%s", prefix, verb, make_name_part(s->arena, name[i])));
    return out;
}

// Assigns the names of what the flight runtime needs for a state vector: access functions, enumerators of elements and regions.
void names_assign_runtime(Arena *arena, const CNames *names, const StateVec *sv, CVectorNames *out)
{
    const char **element = ARENA_ARRAY(arena, const char *, sv->element.n), **region = ARENA_ARRAY(arena, const char *, sv->region.n);
    NameSet s;

    for (size_t i = 0; i < sv->element.n; i++)
        element[i] = sv->element.at[i]->name->text;
    for (size_t i = 0; i < sv->region.n; i++)
        region[i] = sv->region.at[i]->name->text;
    name_set_init(&s, arena);
    reserve_application_names(&s, names->prefix);
    out->getter = assign_function_names(&s, names->prefix, "", element, sv->element.n);
    out->setter = assign_function_names(&s, names->prefix, "set_", element, sv->element.n);
    out->reader = assign_function_names(&s, names->prefix, "read_", region, sv->region.n);
    out->writer = assign_function_names(&s, names->prefix, "write_", region, sv->region.n);
    out->element = assign_enumerators(&s, names->macro, 'E', element, sv->element.n);
    out->region = assign_enumerators(&s, names->macro, 'R', region, sv->region.n);
}

// Reserves the members of the machine's struct that are not locals.
static void reserve_machine_members(NameSet *s, const CNames *n, bool has_parameters)
{
    static const char *const own[] = { "T", "stored", "state_", "first_", "gate_", "left_", "start_" };

    for (size_t i = 0; i < sizeof own / sizeof *own; i++)
        try_take_name(s, own[i]);
    try_take_name(s, n->type);
    try_take_name(s, n->sv_type);
    try_take_name(s, format_in(s->arena, "%sStored", n->type));
    try_take_name(s, format_in(s->arena, "%sStatus", n->type));
    if (has_parameters)
        try_take_name(s, format_in(s->arena, "%sParameters", n->type));
}

// Returns, by rolling window, the variable whose value it samples; IR_NONE if it samples another expression.
static uint32_t *find_sampled_variables(const CUnit *u)
{
    uint32_t *var = ARENA_ARRAY(u->arena, uint32_t, u->m->window.n);
    const IrFn *f = u->m->sample;

    for (size_t w = 0; w < u->m->window.n; w++)
        var[w] = IR_NONE;
    for (size_t i = 0; f && i < f->blk.at[0].ins.n; i++) {
        const IrIns *s = &f->ins.at[f->blk.at[0].ins.at[i]], *x = s;
        if (s->op != IR_sample)
            continue;
        do
            x = &f->ins.at[x->a];
        while (x->op == IR_cvt);
        if (x->op == IR_load)
            var[s->var] = x->var;
    }
    return var;
}

// Returns `altitude_last_9` for a window that samples a variable, `window2` for a window that samples another expression.
static const char *choose_window_name(const CUnit *u, size_t w, uint32_t var)
{
    return var == IR_NONE ? format_in(u->arena, "window%lu", (unsigned long)w)
                          : format_in(u->arena, "%s_last_%lu", u->names.var[var], (unsigned long)u->m->window.at[w].size);
}

// Names the struct members that store the number of samples and the next slot of windows.  Windows of the same size share such a member.
static void assign_ring_names(CUnit *u, NameSet *s)
{
    u->ring = ARENA_ARRAY(u->arena, const char *, u->m->window.n);
    for (size_t w = 0; w < u->m->window.n; w++) {
        const unsigned long size = (unsigned long)u->m->window.at[w].size;
        const size_t first = c_ring_owner(u, w);
        u->ring[w] = first < w ? u->ring[first] : take_free_name(s, format_in(u->arena, "ring%lu_", size));
    }
}

// Chooses a free C name for each rolling window.
static void assign_window_names(CUnit *u, NameSet *s)
{
    const uint32_t *var = find_sampled_variables(u);

    u->window = ARENA_ARRAY(u->arena, const char *, u->m->window.n);
    for (size_t w = 0; w < u->m->window.n; w++) {
        const char *name = choose_window_name(u, w, var[w]);
        u->window[w] = take_free_name(s, c_is_reserved(name) ? make_valid_name(u->arena, name) : name);
    }
    assign_ring_names(u, s);
}

static void assign_variable_names(CUnit *u)
{
    const IrMachine *m = u->m;
    const char **name = ARENA_ARRAY(u->arena, const char *, m->var.n);
    NameSet s;

    name_set_init(&s, u->arena);
    reserve_machine_members(&s, &u->names, c_has_parameters(u));
    u->names.var = ARENA_ARRAY(u->arena, const char *, m->var.n);
    for (size_t v = 0; v < m->var.n; v++) {
        switch (m->var.at[v].space) {
        case IR_ELEMENT: u->names.var[v] = map_find(&u->names.element, m->var.at[v].element ? m->var.at[v].element : m->var.at[v].name); break;
        case IR_LOCAL: name[v] = m->var.at[v].name->text; break;
        case IR_TIME: u->names.var[v] = "T"; break;
        }
    }
    assign_members(&s, name, u->names.var, m->var.n);
    assign_window_names(u, &s);
}

static void assign_state_names(CUnit *u)
{
    const size_t n = u->m->state.n;
    const char **name = ARENA_ARRAY(u->arena, const char *, n);
    NameSet s;

    name_set_init(&s, u->arena);
    u->names.state = ARENA_ARRAY(u->arena, const char *, n);
    for (size_t i = 0; i < n; i++)
        name[i] = u->m->state.at[i].name->text;
    for (size_t i = 0; i < n; i++)                    // keywords are allowed in the middle of a name
        if (name[i][0] != '_' && !strstr(name[i], "__") && name[i][strlen(name[i]) - 1] != '_' && try_take_name(&s, name[i]))
            u->names.state[i] = name[i];
    for (size_t i = 0; i < n; i++)
        if (!u->names.state[i])
            u->names.state[i] = take_free_name(&s, c_identifier(u->arena, name[i], strlen(name[i])));
}

// Returns the name of the struct of a machine whose functions begin with `prefix`.
const char *c_machine_type(Arena *arena, const char *prefix, const char *sv_type)
{
    const char *type = c_type_name(arena, prefix);

    return strcmp(type, sv_type) == 0 ? format_in(arena, "%sMachine", type) : type;
}

// Assigns all names of the unit's machine and state vector.  names.sv_type must be set.
void names_init(CUnit *u, const char *prefix)
{
    CNames *n = &u->names;

    n->prefix = prefix;
    n->type = c_machine_type(u->arena, prefix, n->sv_type);
    n->macro = c_macro_name(u->arena, prefix);
    names_assign_elements(u->arena, n, &u->sv);
    assign_variable_names(u);
    assign_state_names(u);
}
