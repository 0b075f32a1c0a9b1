// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/shapes.h"

#include <string.h>

#include "compiler/base/os.h"

// ---- memory ----

static const size_t pool_size = (size_t)1 << 31;
static char *pool;
static size_t used, most;

typedef struct Block { size_t before; size_t given_back; } Block;    // precedes each allocated block
static Block *last;

bool pool_open(void) { return (pool = os_alloc(NULL, NULL, pool_size)) != NULL; }       // allocates in pages, as the command does
void pool_empty(void) { used = most = 0; last = NULL; }
size_t pool_used(void) { return most; }

// Marks a block as given back.  Its memory is used again as soon as all later blocks have been given back.
static void *give_back(void *old)
{
    if (old)
        ((Block *)old - 1)->given_back = 1;
    while (last && last->given_back) {
        used = (size_t)((char *)last - pool);
        last = last->before ? (Block *)(void *)(pool + last->before - 1) : NULL;
    }
    return NULL;
}

void *pool_alloc(void *context, void *old, size_t size)
{
    Block *b = (Block *)(void *)(pool + used);

    (void)context;
    size = (size + 15) / 16 * 16;
    if (size == 0)
        return give_back(old);
    if (size + sizeof *b > pool_size - used)
        return NULL;
    *b = (Block){last ? (size_t)((char *)last - pool) + 1 : 0, 0};
    last = b;
    used += sizeof *b + size;
    most = used > most ? used : most;
    return b + 1;
}

// ---- shapes ----

static const char head[] = "[state_vector]\nU64 G\nU32 S\nF64 x\nF64 y\nbool p\n";

static void states(Buf *b, unsigned n)
{
    buf_str(b, head);
    for (unsigned i = 0; i < n; i++) {
        buf_printf(b, "[S%u]\n.step\n", i);
        for (unsigned k = 0; k < 8; k++)
            buf_printf(b, "    x = x * %u + y\n", k + 2);
        buf_printf(b, "    x > %u: -> S%u\n    y > x: -> S%u\n", i, (i + 1) % n, i * 7 % n);
    }
}

// A machine with input for every analysis: sensors with ranges, outputs, timers, windows, aborts; ten statements per state.
static void mission(Buf *b, unsigned n)
{
    buf_str(b, "[state_vector]\nU64 G\nU32 S\nF64 tank @read_only @range 0 40\nF32 flow @read_only @range -1 9\nbool arm @read_only\n"
               "bool valve\nU8 fin\n[local]\nU16 tries = 0\nF64 mean = 0\n");
    for (unsigned i = 0; i < n; i++) {
        buf_printf(b, "[S%u]\n.entry\n    valve = true\n    tries = tries + 1\n.step\n    mean = roll_avg(tank, 10)\n", i);
        buf_printf(b, "    tank > %u or tank < 1: -> Abort\n    fin = tank / flow\n    mean > 30 and arm { fin = %u }\n", 35 + i % 5, i % 256);
        buf_printf(b, "    flow > 8: -> Abort\n    T > %u: -> S%u\n    tries > 3 and arm: -> S%u\n.exit\n    valve = false\n", 100 + i,
                   (i + 1) % n, i * 7 % n);
    }
    buf_str(b, "[Abort] @abort @safe\n.entry\n    valve = false\n");
}

static void guards(Buf *b, unsigned n)
{
    buf_printf(b, "%s[A]\n.step\n", head);
    for (unsigned i = 0; i < n; i++)
        buf_printf(b, "    x > y + %u and p: -> A\n    y > x + %u and not p: y = %u\n", n - i, n - i, i);
}

static void statements(Buf *b, unsigned n)
{
    buf_printf(b, "%s[A]\n.step\n", head);
    for (unsigned i = 0; i < n; i++)
        buf_printf(b, "    x = x + %u.5\n", i);
}

static void conditionals(Buf *b, unsigned n)
{
    buf_printf(b, "%s[A]\n.step\n", head);
    for (unsigned i = 0; i < n; i++)
        buf_printf(b, "    x > %u: y = %u\n", i, i);
}

static void nested(Buf *b, unsigned n)
{
    buf_printf(b, "%s[A]\n.step\n", head);
    for (unsigned i = 0; i < n; i++)
        buf_printf(b, "x > %u {\n", i);
    for (unsigned i = 0; i < n; i++)
        buf_printf(b, "y = %u\n}\n", i);
}

static void else_ifs(Buf *b, unsigned n)
{
    buf_printf(b, "%s[A]\n.step\n    if p: x = 0\n", head);
    for (unsigned i = 0; i < n; i++)
        buf_printf(b, "    else if x > %u: x = %u\n", i, i);
}

static void locals(Buf *b, unsigned n)
{
    buf_printf(b, "%s[local]\n", head);
    for (unsigned i = 0; i < n; i++)
        buf_printf(b, "U16 local%u = %u\n", i, i);
    buf_str(b, "[A]\n.step\n");
    for (unsigned i = 0; i < n; i++)
        buf_printf(b, "    local%u = local%u + 1\n", i, n - 1 - i);
}

// As many locals as states.  Each local is used in only a few states.
static void states_locals(Buf *b, unsigned n)
{
    buf_printf(b, "%s[local]\n", head);
    for (unsigned i = 0; i < n; i++)
        buf_printf(b, "F64 local%u = %u\n", i, i);
    for (unsigned i = 0; i < n; i++) {
        buf_printf(b, "[S%u]\n.entry\n    local%u = 0\n.step\n", i, i);
        for (unsigned k = 0; k < 6; k++)
            buf_printf(b, "    local%u = local%u + x\n", (i * 7 + k) % n, (i * 3 + k * 5) % n);
        buf_printf(b, "    local%u > y: -> S%u\n    x > %u: -> S%u\n\n", i, (i + 1) % n, i, i * 7 % n);
    }
}

// Twenty states, each with many conditional transitions.
static void transitions(Buf *b, unsigned n)
{
    buf_str(b, head);
    for (unsigned i = 0; i < 20; i++) {
        buf_printf(b, "[S%u]\n.step\n", i);
        for (unsigned k = 0; k < n; k++)
            buf_printf(b, "    x > %u and y < %u: -> S%u\n", k * 3 + i, k * 5, (i * 7 + k) % 20);
    }
}

static void constants(Buf *b, unsigned n)
{
    buf_printf(b, "%s[local]\nF64 c0 = 1 @read_only\n", head);
    for (unsigned i = 1; i < n; i++)
        buf_printf(b, "F64 c%u = c%u * 1.01 + 1 @read_only\n", i, i - 1);
    buf_printf(b, "[A]\n.step\n    x = c%u\n", n - 1);
}

static void elements(Buf *b, unsigned n)
{
    buf_str(b, head);
    for (unsigned i = 0; i < n; i++)
        buf_printf(b, "%s e%u\n", i % 3 ? "U8" : "F32", i);
    buf_str(b, "[A]\n.step\n");
    for (unsigned i = 0; i < n; i++)
        buf_printf(b, "    e%u = e%u + 1\n", i, n - 1 - i);
}

static void windows(Buf *b, unsigned n)
{
    buf_printf(b, "%s[A]\n.step\n", head);
    for (unsigned i = 0; i < n; i++)
        buf_printf(b, "    y = roll_avg(x + %u, %u)\n", i, i % 7 + 1);
}

static void same_windows(Buf *b, unsigned n)
{
    buf_printf(b, "%s[A]\n.step\n", head);
    for (unsigned i = 0; i < n; i++)
        buf_printf(b, "    y = roll_max(x * y, 10) + roll_min(x * y, 10)\n");
}

static void nested_windows(Buf *b, unsigned n)
{
    buf_printf(b, "%s[A]\n.step\n    y = ", head);
    for (unsigned i = 0; i < n; i++)
        buf_str(b, "roll_max(");
    buf_str(b, "x");
    for (unsigned i = 0; i < n; i++)
        buf_printf(b, ", 3)");
    buf_str(b, "\n");
}

static void deep_expression(Buf *b, unsigned n)
{
    buf_printf(b, "%s[A]\n.step\n    y = ", head);
    for (unsigned i = 0; i < n; i++)
        buf_str(b, "(x + ");
    buf_str(b, "1");
    for (unsigned i = 0; i < n; i++)
        buf_str(b, ")");
    buf_str(b, "\n");
}

static void long_line(Buf *b, unsigned n)
{
    buf_printf(b, "%s[A]\n.step\n    ", head);
    for (unsigned i = 0; i < n; i++)
        buf_str(b, "p { x = 1 } ");
    buf_str(b, "\n");
}

static void comments(Buf *b, unsigned n)
{
    buf_str(b, head);
    for (unsigned i = 0; i < n; i++)
        buf_str(b, "# a line that says nothing\n\n");
    buf_str(b, "[A]\n");
}

// ---- shapes with mistakes: reporting must not cost more than compiling ----

static void unknown_names(Buf *b, unsigned n)
{
    buf_printf(b, "%s[local]\n", head);
    for (unsigned i = 0; i < n; i++)
        buf_printf(b, "U16 local%u = %u\n", i, i);
    buf_str(b, "[A]\n.step\n");
    for (unsigned i = 0; i < n; i++)
        buf_printf(b, "    lokal%u = 1\n", i);
}

static void unknown_states(Buf *b, unsigned n)
{
    buf_str(b, head);
    for (unsigned i = 0; i < n; i++)
        buf_printf(b, "[State%u]\n.step\n    p: -> Stat%u\n", i, i);
}

static void syntax_errors(Buf *b, unsigned n)
{
    buf_printf(b, "%s[A]\n.step\n", head);
    for (unsigned i = 0; i < n; i++)
        buf_printf(b, "    x = = %u\n", i);
}

static void warnings(Buf *b, unsigned n)
{
    buf_printf(b, "%s[local]\n", head);
    for (unsigned i = 0; i < n; i++)
        buf_printf(b, "U16 local%u = %u\n", i, i);
    buf_str(b, "[A]\n");
}

static void unreachable_states(Buf *b, unsigned n)
{
    buf_printf(b, "%s[A]\n", head);
    for (unsigned i = 0; i < n; i++)
        buf_printf(b, "[S%u]\n.step\n    -> S%u\n", i, i);
}

// ---- state vectors and scripts ----

static void one_state(Buf *b, unsigned n)
{
    (void)n;
    buf_printf(b, "%s[A]\n.step\n    y = x\n", head);
}

static void write_sv(Buf *b, unsigned n)
{
    buf_str(b, "[Base]\nU64 G\nU32 S\nF64 x\nF64 y\nbool p\n");
    for (unsigned i = 0; i < n; i++)
        buf_printf(b, "%sU8 e%u\n", i % 10 ? "" : i ? format_in(b->arena, "[R%u]\n", i) : "[R]\n", i);
}

static void script_items(Buf *b, unsigned n)
{
    buf_str(b, "[options]\ndelta_t 1\n[A]\n");
    for (unsigned i = 0; i < n; i++)
        buf_printf(b, "G == %u { x = %u\n @assert y == %u }\n", i, i, i);
    buf_str(b, "G == 100: @stop\n");
}

static void script_blocks(Buf *b, unsigned n)               // one block for each step
{
    buf_str(b, "[options]\ndelta_t 10\n[A]\n");
    for (unsigned i = 0; i < n; i++)
        buf_printf(b, "G == %u { x = %u }\n", i * 10, i % 1000);
    buf_printf(b, "G == %u: @stop\n", (n - 1) * 10);
}

// Two conditionals for each step: one for this step alone, one for the ten steps that begin with it.
static void script_steps(Buf *b, unsigned n)
{
    buf_str(b, "[options]\ndelta_t 10\n[A]\n");
    for (unsigned i = 0; i < n; i++)
        buf_printf(b, "G == %u { x = %u\n @assert y == %u }\nT >= %u and T < %u and x > 5: p = 1\n", i * 10, i, i, i * 10, i * 10 + 100);
    buf_printf(b, "[all_states]\nG == %u: @stop\n", (n - 1) * 10);
}

// Guards that depend on time.  In each step a few are true.  Their periods grow with the script.
static void script_guards(Buf *b, unsigned n)
{
    buf_str(b, "[options]\ndelta_t 10\n[A]\n");
    for (unsigned i = 0; i < n; i++) {
        const unsigned g = i * 10;
        buf_printf(b, "at %u { x = %u }\nelse if from %u to %u: p = noise(1)\nevery %u: p = 1\n", g, i, g + 20, g + 50, g + 10);
    }
    buf_printf(b, "[all_states]\nat %u: @stop\n", (n - 1) * 10);
}

static void script_windows(Buf *b, unsigned n)
{
    buf_str(b, "[options]\ndelta_t 1\n[all_states]\n");
    for (unsigned i = 0; i < n; i++)
        buf_printf(b, "roll_avg(x, %u) > 1: p = 1\n", i % 100 + 1);
    buf_str(b, "G == 100: @stop\n");
}

const Shape shapes[] = {
    {"states", states, 2500, NULL, NULL, 0},
    {"mission", mission, 1000, NULL, NULL, 0},
    {"guards", guards, 5000, NULL, NULL, 0},
    {"statements", statements, 25000, NULL, NULL, 0},
    {"conditionals", conditionals, 20000, NULL, NULL, 0},
    {"nested", nested, 400, NULL, NULL, 0},
    {"else_ifs", else_ifs, 400, NULL, NULL, 0},
    {"locals", locals, 8000, NULL, NULL, 0},
    {"states_locals", states_locals, 125, NULL, NULL, 1u << DIAG_GROUP_FLIGHT},       // each trial run copies every local
    {"transitions", transitions, 40, NULL, NULL, 0},
    {"constants", constants, 30000, NULL, NULL, 0},
    {"elements", elements, 8000, NULL, NULL, 0},
    {"windows", windows, 4000, NULL, NULL, 0},
    {"same_windows", same_windows, 15000, NULL, NULL, 0},
    {"nested_windows", nested_windows, 200, NULL, NULL, 0},
    {"deep_expression", deep_expression, 450, NULL, NULL, 0},
    {"long_line", long_line, 25000, NULL, NULL, 0},
    {"comments", comments, 250000, NULL, NULL, 0},
    {"unknown_names", unknown_names, 5000, NULL, NULL, 0},
    {"unknown_states", unknown_states, 5000, NULL, NULL, 0},
    {"syntax_errors", syntax_errors, 50000, NULL, NULL, 0},
    {"warnings", warnings, 10000, NULL, NULL, 0},
    {"unreachable_states", unreachable_states, 10000, NULL, NULL, 0},
    {"state_vector", one_state, 10000, write_sv, NULL, 0},
    {"script_items", one_state, 20000, NULL, script_items, 0},
    {"script_blocks", one_state, 20000, NULL, script_blocks, 0},
    {"script_steps", one_state, 3000, NULL, script_steps, 0},
    {"script_guards", one_state, 3000, NULL, script_guards, 0},
    {"script_windows", one_state, 20000, NULL, script_windows, 0},
};
const size_t shapes_n = sizeof shapes / sizeof shapes[0];

const Shape *shape_find(const char *name)
{
    for (size_t i = 0; i < shapes_n; i++)
        if (strcmp(shapes[i].name, name) == 0)
            return &shapes[i];
    return NULL;
}

const Source *shape_source(Session *s, const char *name, WriteFn *write, unsigned n)
{
    Buf text;

    if (!write)
        return NULL;
    buf_init(&text, &s->arena);
    write(&text, n);
    return source_new(&s->arena, name, buf_text(&text), text.n);
}
