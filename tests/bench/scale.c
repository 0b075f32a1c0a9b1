// SPDX-License-Identifier: Apache-2.0
// How the time to compile grows with the size of the input: each shape of machine is compiled at some size and at four
// times that size, and four times the input may take at most a little more than four times as long.
//
//     scale            every shape: times per stage, and whether they grow as they should
//     scale SHAPE N    one shape at size N; prints the machine if N is followed by -p
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "compiler/analysis/analysis.h"
#include "compiler/pipeline.h"
#include "tests/test.h"

enum { FACTOR = 4 };
#define MOST_GROWTH 8.0           // what four times the input may cost; 16 would be quadratic
#define NOISE 0.02                // seconds: below this a time says nothing

// One piece of memory that every session uses anew: what the system takes for handing out pages is none of our time.
static const size_t pool_size = (size_t)1 << 30;
static char *pool;
static size_t pool_used;

static void *from_pool(void *context, void *old, size_t size)
{
    char *p = pool + pool_used;

    (void)context;
    (void)old;
    size = (size + 15) / 16 * 16;
    if (size == 0 || size > pool_size - pool_used)
        return NULL;
    pool_used += size;
    return p;
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

static void script_windows(Buf *b, unsigned n)
{
    buf_str(b, "[options]\ndelta_t 1\n[all_states]\n");
    for (unsigned i = 0; i < n; i++)
        buf_printf(b, "roll_avg(x, %u) > 1: p = 1\n", i % 100 + 1);
    buf_str(b, "G == 100: @stop\n");
}

typedef void WriteFn(Buf *b, unsigned n);

typedef struct Shape {
    const char *name;
    WriteFn *write;           // the machine
    unsigned n;               // the smaller size
    WriteFn *sv, *ss;         // a state vector and a script beside it; or NULL
} Shape;

static const Shape shapes[] = {
    {"states", states, 2500, NULL, NULL},
    {"statements", statements, 25000, NULL, NULL},
    {"conditionals", conditionals, 20000, NULL, NULL},
    {"nested", nested, 400, NULL, NULL},
    {"else_ifs", else_ifs, 400, NULL, NULL},
    {"locals", locals, 8000, NULL, NULL},
    {"constants", constants, 30000, NULL, NULL},
    {"elements", elements, 8000, NULL, NULL},
    {"windows", windows, 4000, NULL, NULL},
    {"same_windows", same_windows, 15000, NULL, NULL},
    {"nested_windows", nested_windows, 200, NULL, NULL},
    {"deep_expression", deep_expression, 450, NULL, NULL},
    {"long_line", long_line, 25000, NULL, NULL},
    {"comments", comments, 250000, NULL, NULL},
    {"unknown_names", unknown_names, 5000, NULL, NULL},
    {"unknown_states", unknown_states, 5000, NULL, NULL},
    {"syntax_errors", syntax_errors, 50000, NULL, NULL},
    {"warnings", warnings, 10000, NULL, NULL},
    {"unreachable_states", unreachable_states, 10000, NULL, NULL},
    {"state_vector", one_state, 10000, write_sv, NULL},
    {"script_items", one_state, 20000, NULL, script_items},
    {"script_windows", one_state, 20000, NULL, script_windows},
};

// ---- measuring ----

enum { STAGES = 6 };
static const char *const stage_name[STAGES] = {"parse+check", "ir -O0", "ir -O2", "image", "C", "report"};

static double now(void)
{
    return (double)clock() / CLOCKS_PER_SEC;
}

static const Source *written(Session *s, const char *name, WriteFn *write, unsigned n)
{
    Buf text;

    if (!write)
        return NULL;
    buf_init(&text, &s->arena);
    write(&text, n);
    return source_new(&s->arena, name, buf_text(&text), text.n);
}

// All stages.  What they cost is the time between two entries of `at`.
static void compile(Session *s, const Shape *shape, unsigned n, double *at)
{
    MachineInput in = {written(s, "m.sm", shape->write, n), written(s, "m.sv", shape->sv, n), NULL, 0};
    const Source *ss = written(s, "m.ss", shape->ss, n);
    ImageOptions image = {true};
    EmitCOptions c;
    IrMachine *m = NULL;
    Buf out, header;
    Program *p;

    *at++ = now();
    p = session_program(s, &in);
    if (p && ss)
        session_script(s, ss, p);
    memset(&c, 0, sizeof c);
    c.header = "m.h";
    c.source = "m.sm";
    buf_init(&out, &s->arena);
    buf_init(&header, &s->arena);
    if (p)
        analyse_program(&s->arena, &s->diags, p);
    at[0] = now();
    if (p)
        session_ir(s, p, 0);
    at[1] = now();
    if (p)
        m = session_ir(s, p, 2);
    at[2] = now();
    if (m)
        session_image(s, &m, 1, &image, &out);
    at[3] = now();
    if (m)
        session_emit_c(s, m, &c, &header, &out);
    at[4] = now();
}

static void report(Session *s, double *at)
{
    DiagStyle style = {false, 20};
    Buf out;

    buf_init(&out, &s->arena);
    diags_sort(&s->diags);
    diags_render_text(&s->diags, &style, &out);
    diags_render_json(&s->diags, &out);
    *at = now();
}

// Seconds a stage took, into took; false when memory ran out.
static bool measure(const Shape *shape, unsigned n, double *took)
{
    double at[STAGES + 1];
    jmp_buf oom;
    Session s;

    pool_used = 0;
    session_init(&s, from_pool, NULL, &oom);
    if (setjmp(oom) != 0)
        return false;
    compile(&s, shape, n, at);
    report(&s, &at[STAGES]);
    for (int k = 0; k < STAGES; k++)
        took[k] = at[k + 1] - at[k];
    session_free(&s);
    return true;
}

static double total(const double *took)
{
    double sum = 0;

    for (int k = 0; k < STAGES; k++)
        sum += took[k];
    return sum;
}

static void print_times(const Shape *shape, unsigned n, const double *took)
{
    printf("%-18s %7u", shape->name, n);
    for (int k = 0; k < STAGES; k++)
        printf(k ? " %8.3f" : " %12.3f", took[k]);
    printf(" %8.3f s\n", total(took));
}

// The stage that grows too fast, or -1.
static int grows_too_fast(const double *small, const double *large)
{
    for (int k = 0; k < STAGES; k++)
        if (large[k] > NOISE && large[k] > MOST_GROWTH * (small[k] > NOISE / 4 ? small[k] : NOISE / 4))
            return k;
    return -1;
}

static bool measure_best(const Shape *shape, unsigned n, double *best)
{
    double took[STAGES];

    if (!measure(shape, n, took))
        return false;
    for (int k = 0; k < STAGES; k++)
        if (took[k] < best[k])
            best[k] = took[k];
    return true;
}

// A machine that does something else at the same time gets three chances: what counts is the best time of each stage.
static void check_shape(const Shape *shape)
{
    double small[STAGES], large[STAGES];
    int fast = 0;

    for (int k = 0; k < STAGES; k++)
        small[k] = large[k] = 1e9;
    for (int chance = 0; chance < 3 && fast >= 0; chance++) {
        CHECK(measure_best(shape, shape->n, small));
        CHECK(measure_best(shape, shape->n * FACTOR, large));
        fast = grows_too_fast(small, large);
    }
    print_times(shape, shape->n, small);
    print_times(shape, shape->n * FACTOR, large);
    if (fast >= 0)
        printf("%s: %s takes %.1f times as long for %d times as much\n", shape->name, stage_name[fast], large[fast] / small[fast], FACTOR);
    CHECK(fast < 0);
}

static const Shape *find_shape(const char *name)
{
    for (size_t i = 0; i < sizeof shapes / sizeof shapes[0]; i++)
        if (strcmp(shapes[i].name, name) == 0)
            return &shapes[i];
    return NULL;
}

static int one(const Shape *shape, unsigned n, bool print)
{
    double took[STAGES];
    jmp_buf oom;
    Arena a;
    Buf text;

    if (!print && measure(shape, n, took)) {
        print_times(shape, n, took);
        return 0;
    }
    arena_init(&a, from_pool, NULL, &oom);
    if (!print || setjmp(oom) != 0)
        return 3;
    buf_init(&text, &a);
    shape->write(&text, n);
    fputs(buf_text(&text), stdout);
    arena_free(&a);
    return 0;
}

int main(int argc, char **argv)
{
    const Shape *shape = argc > 2 ? find_shape(argv[1]) : NULL;

    if (!(pool = malloc(pool_size)))
        return 3;
    if (shape)
        return one(shape, (unsigned)strtoul(argv[2], NULL, 10), argc > 3);
    printf("%-18s %7s", "", "size");
    for (int k = 0; k < STAGES; k++)
        printf(k ? " %8s" : " %12s", stage_name[k]);
    printf("    total\n");
    for (size_t i = 0; i < sizeof shapes / sizeof shapes[0]; i++)
        check_shape(&shapes[i]);
    return test_end("scale");
}
