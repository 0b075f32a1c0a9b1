// SPDX-License-Identifier: Apache-2.0
// Measures how the time and the memory of compiling, and of running a script, grow with the size of the input.  Each shape is measured at some
// size and at four times that size.  The larger one may cost at most MOST_GROWTH times as much.
//
//     scale            every shape: times per stage, and whether they grow as they should
//     scale SHAPE N    one shape at size N; prints the machine if N is followed by -p
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "compiler/report/diagram.h"
#include "compiler/compile.h"
#include "tests/bench/shapes.h"
#include "tests/test.h"

enum { FACTOR = 4 };
#define MOST_GROWTH 8.0           // the most that four times the input may cost, as a multiple; quadratic growth is 16
#define NOISE 0.02                // seconds: shorter times are noise
#define SMALL_MEMORY 4e6          // bytes: below this, fixed costs and block sizes are a large part

// ---- measuring ----

enum { STAGES = 9 };
static const char *const stage_name[STAGES] = {"parse+check", "analysis", "ir -O0", "ir -O2", "image", "C", "graph", "run", "report"};

static double now(void)
{
    return (double)clock() / CLOCKS_PER_SEC;
}

// Draws the diagram.  The facts that it needs are computed before, as part of the analysis.
static void draw(Session *s, const Program *p, Buf *out)
{
    const DiagramOptions o = {.findings = NULL};
    Analysis a;

    memset(&a, 0, sizeof a);
    a.arena = &s->arena;
    a.p = p;
    a.stmt = ARENA_ARRAY(&s->arena, StmtFact, p->stmts + 1u);
    for (size_t i = 0; i <= p->stmts; i++)
        a.stmt[i].reached = true;
    a.transition = transitions_of(&s->arena, p);
    diagram_write_svg(&a, &o, out);
}

static void run(Session *s, const Program *p, const Script *script)
{
    const ScriptOptions o = {.max_steps = 1000000, .is_compared = true};
    Engine *ref = engine_ref_open(&s->arena, p);

    script_run(&s->arena, &s->diags, script, &ref, 1, &o);
}

// Runs all stages.  The cost of a stage is the time between two entries of `at`.
static void compile(Session *s, const Shape *shape, unsigned n, double *at)
{
    MachineInput in = {.sm = shape_source(s, "m.sm", shape->write, n), .sv = shape_source(s, "m.sv", shape->sv, n)};
    const Source *ss = shape_source(s, "m.ss", shape->ss, n);
    ImageOptions image = {true, NULL};
    EmitCOptions c;
    IrMachine *m = NULL;
    Script *script = NULL;
    Buf out, header;
    Program *p;

    *at++ = now();
    p = session_program(s, &in);
    if (p && ss)
        script = session_script(s, ss, p);
    memset(&c, 0, sizeof c);
    c.header = "m.h";
    c.source = "m.sm";
    buf_init(&out, &s->arena);
    buf_init(&header, &s->arena);
    *at++ = now();
    if (p)
        session_analyse(s, p);
    *at++ = now();
    if (p)
        session_ir(s, p, 0);
    *at++ = now();
    if (p)
        m = session_ir(s, p, 2);
    *at++ = now();
    if (m)
        session_image(s, &m, 1, &image, &out);
    *at++ = now();
    if (m)
        session_emit_c(s, m, &c, &header, &out);
    *at++ = now();
    if (p)
        draw(s, p, &out);
    *at++ = now();
    if (script)
        run(s, p, script);
    *at = now();
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

// The cost of one size: seconds by stage, and the most bytes in use.
typedef struct Cost { double took[STAGES], bytes; } Cost;

// Measures one size.  Returns false when memory ran out.
static bool measure(const Shape *shape, unsigned n, Cost *c)
{
    double at[STAGES + 1];
    jmp_buf oom;
    Session s;

    pool_empty();
    session_init(&s, pool_alloc, NULL, &oom);
    s.warnings &= ~shape->left_out;
    if (setjmp(oom) != 0)
        return false;
    compile(&s, shape, n, at);
    report(&s, &at[STAGES]);
    for (int k = 0; k < STAGES; k++)
        c->took[k] = at[k + 1] - at[k];
    session_free(&s);
    c->bytes = (double)pool_used();
    return true;
}

static double total(const double *took)
{
    double sum = 0;

    for (int k = 0; k < STAGES; k++)
        sum += took[k];
    return sum;
}

static void print_cost(const Shape *shape, unsigned n, const Cost *c)
{
    printf("%-18s %7u", shape->name, n);
    for (int k = 0; k < STAGES; k++)
        printf(k ? " %8.3f" : " %12.3f", c->took[k]);
    printf(" %8.3f s %7.1f MB\n", total(c->took), c->bytes / 1e6);
}

// Returns a stage that grows too fast; -1 if no stage does.
static int grows_too_fast(const double *small, const double *large)
{
    for (int k = 0; k < STAGES; k++)
        if (large[k] > NOISE && large[k] > MOST_GROWTH * (small[k] > NOISE / 4 ? small[k] : NOISE / 4))
            return k;
    return -1;
}

static bool measure_best(const Shape *shape, unsigned n, Cost *best)
{
    Cost c;

    if (!measure(shape, n, &c))
        return false;
    for (int k = 0; k < STAGES; k++)
        if (c.took[k] < best->took[k])
            best->took[k] = c.took[k];
    best->bytes = c.bytes;
    return true;
}

// Reports a shape whose cost grows too fast.
static void check_growth(const Shape *shape, const Cost *small, const Cost *large, int fast)
{
    const bool bytes_fit = large->bytes < SMALL_MEMORY || large->bytes < MOST_GROWTH * small->bytes;

    if (fast >= 0)
        printf("%s: %s takes %.1f times as long for %d times as much\n", shape->name, stage_name[fast],
               large->took[fast] / small->took[fast], FACTOR);
    if (!bytes_fit)
        printf("%s: %.1f times as much memory for %d times as much\n", shape->name, large->bytes / small->bytes, FACTOR);
    CHECK(fast < 0 && bytes_fit);
}

// Measures a shape up to three times, since another program can make it slower.  The best time of each stage counts.
static void check_shape(const Shape *shape)
{
    Cost small = {{0}, 0}, large = {{0}, 0};
    int fast = 0;

    for (int k = 0; k < STAGES; k++)
        small.took[k] = large.took[k] = 1e9;
    for (int chance = 0; chance < 3 && fast >= 0; chance++) {
        const bool fits = measure_best(shape, shape->n, &small) && measure_best(shape, shape->n * FACTOR, &large);
        CHECK(fits);
        if (!fits) {
            printf("%s: out of memory\n", shape->name);
            return;
        }
        fast = grows_too_fast(small.took, large.took);
    }
    print_cost(shape, shape->n, &small);
    print_cost(shape, shape->n * FACTOR, &large);
    check_growth(shape, &small, &large, fast);
}

static int one(const Shape *shape, unsigned n, bool print)
{
    Cost c;
    jmp_buf oom;
    Arena a;
    Buf text;

    if (!print && measure(shape, n, &c)) {
        print_cost(shape, n, &c);
        return 0;
    }
    arena_init(&a, pool_alloc, NULL, &oom);
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
    const Shape *shape = argc > 2 ? shape_find(argv[1]) : NULL;

    if (!pool_open())
        return 3;
    if (shape)
        return one(shape, (unsigned)strtoul(argv[2], NULL, 10), argc > 3);
    printf("%-18s %7s", "", "size");
    for (int k = 0; k < STAGES; k++)
        printf(k ? " %8s" : " %12s", stage_name[k]);
    printf("    total\n");
    for (size_t i = 0; i < shapes_n; i++)
        check_shape(&shapes[i]);
    return test_end("scale");
}
