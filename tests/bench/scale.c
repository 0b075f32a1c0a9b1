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

static void *from_heap(void *context, void *old, size_t size)
{
    (void)context;
    if (size)
        return realloc(old, size);
    free(old);
    return NULL;
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

typedef struct Shape {
    const char *name;
    void (*write)(Buf *b, unsigned n);
    unsigned n;               // the smaller size
} Shape;

static const Shape shapes[] = {
    {"states", states, 2500},
    {"statements", statements, 25000},
    {"conditionals", conditionals, 15000},
    {"nested", nested, 400},
    {"else_ifs", else_ifs, 400},
    {"locals", locals, 8000},
    {"constants", constants, 15000},
    {"elements", elements, 8000},
    {"windows", windows, 4000},
    {"same_windows", same_windows, 10000},
    {"nested_windows", nested_windows, 200},
    {"deep_expression", deep_expression, 450},
    {"long_line", long_line, 15000},
    {"comments", comments, 250000},
    {"unknown_names", unknown_names, 5000},
    {"unknown_states", unknown_states, 5000},
    {"syntax_errors", syntax_errors, 25000},
    {"warnings", warnings, 10000},
    {"unreachable_states", unreachable_states, 10000},
};

// ---- measuring ----

enum { STAGES = 6 };
static const char *const stage_name[STAGES] = {"check", "ir -O0", "ir -O2", "image", "C", "report"};

static double now(void)
{
    return (double)clock() / CLOCKS_PER_SEC;
}

static void compile(Session *s, const Source *src, double *at)
{
    MachineInput in = {src, NULL, NULL, 0};
    ImageOptions image = {true};
    EmitCOptions c;
    IrMachine *m = NULL;
    Buf out, header;
    Program *p = session_program(s, &in);

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
    at[5] = now();
}

// Seconds a stage took, into took; false when memory ran out.
static bool measure(const Shape *shape, unsigned n, double *took)
{
    double at[STAGES], start;
    jmp_buf oom;
    Session s;
    Buf text;

    session_init(&s, from_heap, NULL, &oom);
    if (setjmp(oom) != 0)
        return false;
    buf_init(&text, &s.arena);
    shape->write(&text, n);
    start = now();
    compile(&s, source_new(&s.arena, "m.sm", buf_text(&text), text.n), at);
    report(&s, at);
    for (int k = 0; k < STAGES; k++)
        took[k] = at[k] - (k ? at[k - 1] : start);
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
        printf(" %8.3f", took[k]);
    printf(" %8.3f s\n", total(took));
}

static bool grows_linearly(const Shape *shape, const double *small, const double *large)
{
    bool ok = true;

    for (int k = 0; k < STAGES; k++)
        if (large[k] > NOISE && large[k] > MOST_GROWTH * (small[k] > NOISE / FACTOR ? small[k] : NOISE / FACTOR)) {
            printf("%s: %s takes %.1f times as long for %d times as much\n", shape->name, stage_name[k], large[k] / small[k], FACTOR);
            ok = false;
        }
    return ok;
}

static void check_shape(const Shape *shape)
{
    double small[STAGES], large[STAGES];

    CHECK(measure(shape, shape->n, small));
    CHECK(measure(shape, shape->n * FACTOR, large));
    print_times(shape, shape->n, small);
    print_times(shape, shape->n * FACTOR, large);
    CHECK(grows_linearly(shape, small, large));
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
    arena_init(&a, from_heap, NULL, &oom);
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

    if (shape)
        return one(shape, (unsigned)strtoul(argv[2], NULL, 10), argc > 3);
    printf("%-18s %7s", "", "size");
    for (int k = 0; k < STAGES; k++)
        printf(" %8s", stage_name[k]);
    printf("    total\n");
    for (size_t i = 0; i < sizeof shapes / sizeof shapes[0]; i++)
        check_shape(&shapes[i]);
    return test_end("scale");
}
