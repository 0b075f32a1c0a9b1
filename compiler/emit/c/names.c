// SPDX-License-Identifier: Apache-2.0
// Names in the source to names in C.  A name is unchanged wherever C and C++ allow it.  Otherwise it loses the forbidden characters or gets
// an underscore appended, and a number if the result is taken.  Unchanged names are assigned first, so that the machine's other names never
// affect them.
#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "compiler/emit/c/unit.h"

static const char *const reserved[] = {
#define R(word) #word,
#include "compiler/emit/c/reserved.def"
#undef R
};

static bool ends_with(const char *name, const char *end)
{
    const size_t n = strlen(name), e = strlen(end);

    return n >= e && strcmp(name + n - e, end) == 0;
}

bool c_is_reserved(const char *name)
{
    static const char *const own[] = { "_H_INCLUDED", "_SV_LAYOUT", "_slot_", "_sorted_" };   // reserved for the emitted headers

    for (size_t i = 0; i < sizeof own / sizeof *own; i++)
        if (ends_with(name, own[i]))
            return true;
    for (size_t i = 0; i < sizeof reserved / sizeof *reserved; i++)
        if (name[0] == reserved[i][0] && strcmp(name, reserved[i]) == 0)
            return true;
    return name[0] == '_' || strstr(name, "__") != NULL;
}

static bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
static bool is_digit(char c) { return c >= '0' && c <= '9'; }
static char upper(char c) { return c >= 'a' && c <= 'z' ? (char)(c - 'a' + 'A') : c; }

bool c_is_ours(const char *name)
{
    static const char *const our[] = {"sm", "smvm", "pal"};

    for (size_t i = 0; i < sizeof our / sizeof *our; i++) {
        const size_t n = strlen(our[i]);
        if (strncmp(name, our[i], n) == 0 && (name[n] == '_' || name[n] == '\0'))
            return true;
    }
    return false;
}

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
    return c_is_ours(buf_text(&b)) ? format_in(arena, "m_%s", buf_text(&b)) : buf_text(&b);
}

const char *c_type_name(Arena *arena, const char *prefix)
{
    Buf b;

    buf_init(&b, arena);
    for (const char *p = prefix; *p; p++)
        if (*p != '_')
            buf_char(&b, p == prefix || p[-1] == '_' ? upper(*p) : *p);
    if (c_is_reserved(buf_text(&b)))
        buf_str(&b, "Machine");
    return buf_text(&b);
}

const char *c_macro_name(Arena *arena, const char *prefix)
{
    Buf b;

    buf_init(&b, arena);
    for (const char *p = prefix; *p; p++)
        buf_char(&b, upper(*p));
    return buf_text(&b);
}

// ---- a set of names, each assigned once ----

typedef struct NameSet {
    Arena *arena;
    StrPool pool;
    Map taken;
} NameSet;

static void set_init(NameSet *s, Arena *arena)
{
    memset(s, 0, sizeof *s);
    s->arena = arena;
    str_pool_init(&s->pool, arena);
    s->taken.arena = arena;
}

static bool set_take(NameSet *s, const char *name)
{
    Str key = str_c(&s->pool, name);

    if (map_find(&s->taken, key))
        return false;
    map_put(&s->taken, key, s);
    return true;
}

// Returns `name` if it is free, otherwise with the first number appended that makes it free.
static const char *set_take_free(NameSet *s, const char *name)
{
    const char *tried = name;

    for (unsigned i = 2; !set_take(s, tried); i++)
        tried = format_in(s->arena, ends_with(name, "_") ? "%s%u" : "%s_%u", name, i);
    return tried;
}

// The closest valid C name for a name that C does not allow.
static const char *tamed(Arena *arena, const char *name)
{
    const char *plain = c_identifier(arena, name, strlen(name));

    return strcmp(plain, name) == 0 || c_is_reserved(plain) ? format_in(arena, "%s_", plain) : plain;
}

// Assigns members to `n` names: first those that can be unchanged, then the others.
static void take_all(NameSet *s, const char **name, const char **member, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (name[i] && !c_is_reserved(name[i]) && set_take(s, name[i]))
            member[i] = name[i];
    for (size_t i = 0; i < n; i++)
        if (name[i] && !member[i])
            member[i] = set_take_free(s, tamed(s->arena, name[i]));
}

// ---- the names in a unit ----

// The bytes between elements are named too: `pad_at_12_`.
static void take_padding(NameSet *s, const CVector *sv)
{
    uint32_t at = 0;

    for (size_t i = 0; i <= sv->n; i++) {
        if (i == sv->n || sv->at[i].offset != at)
            set_take(s, c_padding_name(s->arena, at));
        if (i < sv->n)
            at = sv->at[i].offset + sm_type_info[sv->at[i].type].bytes;
    }
}

const char *c_padding_name(Arena *arena, uint32_t at) { return format_in(arena, "pad_at_%u_", (unsigned)at); }

void names_elements(Arena *arena, CNames *names, CVector *sv)
{
    const char **name = ARENA_ARRAY(arena, const char *, sv->n), **member = ARENA_ARRAY(arena, const char *, sv->n);
    NameSet s;

    set_init(&s, arena);
    set_take(&s, names->sv_type);                     // C++ does not allow a member with the name of its struct
    take_padding(&s, sv);
    for (size_t i = 0; i < sv->n; i++)
        name[i] = sv->at[i].name->text;
    take_all(&s, name, member, sv->n);
    names->element.arena = arena;
    for (size_t i = 0; i < sv->n; i++) {
        sv->at[i].member = member[i];
        map_put(&names->element, sv->at[i].name, (void *)member[i]);
    }
}

// ---- the names in a vector's runtime view ----

// A name for use in the middle or at the end of another, where keywords are allowed.
static const char *within(Arena *a, const char *name)
{
    return name[0] != '_' && !strstr(name, "__") ? name : c_identifier(a, name, strlen(name));
}

// Reserves the names that an application with the same file name uses itself.  An element with such a name is renamed.
static void take_vector_own(NameSet *s, const char *prefix)
{
    static const char *const own[] = { "sv", "vector", "layout", "element", "names", "regions", "element_names", "region_names",
                                       "app", "io", "inputs", "outputs" };

    for (size_t i = 0; i < sizeof own / sizeof *own; i++)
        set_take(s, format_in(s->arena, "%s_%s", prefix, own[i]));
}

// MACRO_kind_name for each of n names.
static const char **enumerators(NameSet *s, const char *macro, char kind, const char **name, size_t n)
{
    const char **out = ARENA_ARRAY(s->arena, const char *, n);

    for (size_t i = 0; i < n; i++)
        out[i] = set_take_free(s, format_in(s->arena, "%s_%c_%s", macro, kind, within(s->arena, name[i])));
    return out;
}

static const char **functions(NameSet *s, const char *prefix, const char *verb, const char **name, size_t n)
{
    const char **out = ARENA_ARRAY(s->arena, const char *, n);

    for (size_t i = 0; i < n; i++)
        out[i] = set_take_free(s, format_in(s->arena, "%s_%s%s", prefix, verb, within(s->arena, name[i])));
    return out;
}

void names_runtime(Arena *arena, const CNames *names, const StateVec *sv, CVectorNames *out)
{
    const char **element = ARENA_ARRAY(arena, const char *, sv->element.n), **region = ARENA_ARRAY(arena, const char *, sv->region.n);
    NameSet s;

    for (size_t i = 0; i < sv->element.n; i++)
        element[i] = sv->element.at[i]->name->text;
    for (size_t i = 0; i < sv->region.n; i++)
        region[i] = sv->region.at[i]->name->text;
    set_init(&s, arena);
    take_vector_own(&s, names->prefix);
    out->getter = functions(&s, names->prefix, "", element, sv->element.n);
    out->setter = functions(&s, names->prefix, "set_", element, sv->element.n);
    out->reader = functions(&s, names->prefix, "read_", region, sv->region.n);
    out->writer = functions(&s, names->prefix, "write_", region, sv->region.n);
    out->element = enumerators(&s, names->macro, 'E', element, sv->element.n);
    out->region = enumerators(&s, names->macro, 'R', region, sv->region.n);
}

// Reserves the members of the machine's struct that are not locals.
static void take_own_members(NameSet *s, const CNames *n)
{
    static const char *const own[] = { "T", "stored", "state_", "first_", "gate_", "left_", "start_" };

    for (size_t i = 0; i < sizeof own / sizeof *own; i++)
        set_take(s, own[i]);
    set_take(s, n->type);
    set_take(s, n->sv_type);
    set_take(s, format_in(s->arena, "%sStored", n->type));
    set_take(s, format_in(s->arena, "%sStatus", n->type));
}

// The variable whose value each window samples; IR_NONE if it samples something else.
static uint32_t *sampled_variables(const CUnit *u)
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

// `altitude_last_9` for a window that samples a variable, `window2` for one that samples something else.
static const char *window_name(const CUnit *u, size_t w, uint32_t var)
{
    return var == IR_NONE ? format_in(u->arena, "window%lu", (unsigned long)w)
                          : format_in(u->arena, "%s_last_%lu", u->names.var[var], (unsigned long)u->m->window.at[w].size);
}

static void name_windows(CUnit *u, NameSet *s)
{
    const uint32_t *var = sampled_variables(u);

    u->window = ARENA_ARRAY(u->arena, const char *, u->m->window.n);
    for (size_t w = 0; w < u->m->window.n; w++) {
        const char *name = window_name(u, w, var[w]);
        u->window[w] = set_take_free(s, c_is_reserved(name) ? tamed(u->arena, name) : name);
    }
}

static void name_variables(CUnit *u)
{
    const IrMachine *m = u->m;
    const char **name = ARENA_ARRAY(u->arena, const char *, m->var.n);
    NameSet s;

    set_init(&s, u->arena);
    take_own_members(&s, &u->names);
    u->names.var = ARENA_ARRAY(u->arena, const char *, m->var.n);
    for (size_t v = 0; v < m->var.n; v++) {
        switch (m->var.at[v].space) {
        case IR_ELEMENT: u->names.var[v] = map_find(&u->names.element, m->var.at[v].name); break;
        case IR_LOCAL: name[v] = m->var.at[v].name->text; break;
        case IR_TIME: u->names.var[v] = "T"; break;
        }
    }
    take_all(&s, name, u->names.var, m->var.n);
    name_windows(u, &s);
}

static void name_states(CUnit *u)
{
    const size_t n = u->m->state.n;
    const char **name = ARENA_ARRAY(u->arena, const char *, n);
    NameSet s;

    set_init(&s, u->arena);
    u->names.state = ARENA_ARRAY(u->arena, const char *, n);
    for (size_t i = 0; i < n; i++)
        name[i] = u->m->state.at[i].name->text;
    for (size_t i = 0; i < n; i++)                    // keywords are allowed in the middle of a name
        if (name[i][0] != '_' && !strstr(name[i], "__") && name[i][strlen(name[i]) - 1] != '_' && set_take(&s, name[i]))
            u->names.state[i] = name[i];
    for (size_t i = 0; i < n; i++)
        if (!u->names.state[i])
            u->names.state[i] = set_take_free(&s, c_identifier(u->arena, name[i], strlen(name[i])));
}

const char *c_machine_type(Arena *arena, const char *prefix, const char *sv_type)
{
    const char *type = c_type_name(arena, prefix);

    return strcmp(type, sv_type) == 0 ? format_in(arena, "%sMachine", type) : type;
}

void names_init(CUnit *u, const char *prefix)
{
    CNames *n = &u->names;

    n->prefix = prefix;
    n->type = c_machine_type(u->arena, prefix, n->sv_type);
    n->macro = c_macro_name(u->arena, prefix);
    names_elements(u->arena, n, &u->sv);
    name_variables(u);
    name_states(u);
}
