// SPDX-License-Identifier: Apache-2.0
// Recorded data against a slow reference.  Random rows are written as CSV in random notations, and a script runs with them.  Every value of
// every step is computed again from the rows: by a search over all of them, and with the C library's strtod.  Clauses 8.56 to 8.69.
#include <math.h>
#include <string.h>

#include "compiler/compile.h"
#include "compiler/data/data_file.h"
#include "tests/test.h"
#include "tests/unit/host.h"
#include "tests/unit/random.h"

enum { ROWS = 40, COLUMNS = 5, STEPS = 60, CASES = 1500, TEXT = 100000 };

static uint32_t random_below(uint32_t n) { return (uint32_t)(random_u64() >> 33) % n; }

// ---- a random case ----

typedef struct Row {
    long us;                  // its time, in microseconds
    bool has_time, missing[COLUMNS];
    char cell[COLUMNS][40];   // as a decimal with a point
} Row;

typedef struct Case {
    Row row[ROWS];
    int rows;
    bool linear, nan, by_rows, scaled;
    int unit;                 // of the times: 0 s, 1 ms, 2 us
    uint64_t delta_t, delay;
    double tolerance;
    char csv[TEXT], script[TEXT];
    size_t csv_size;
} Case;

static const char *const names[COLUMNS] = {"P 1", "a,b;c", "B", "N", "F"};
static const char *const vars[COLUMNS] = {"x", "y", "b", "n", "f"};
static const double scale = -0.3, offset = 7.25;      // of column 1

static void make_rows(Case *k)
{
    long us = (long)random_below(5000000);

    k->rows = 1 + (int)random_below(ROWS - 1);
    for (int i = 0; i < k->rows; i++) {
        Row *r = &k->row[i];
        us += random_below(8) == 0 ? -(long)random_below(9000) : random_below(4) == 0 ? 1000 * (long)random_below(40) : (long)random_below(30000);
        us = us < 0 ? 0 : us;
        *r = (Row){.us = us, .has_time = i == 0 || random_below(12) != 0};
        for (int c = 0; c < COLUMNS; c++) {
            const int decimals = (int)random_below(6);
            r->missing[c] = random_below(6) == 0;
            if (c == 2)
                snprintf(r->cell[c], sizeof r->cell[c], "%u", random_below(2));
            else if (random_below(10) == 0)
                snprintf(r->cell[c], sizeof r->cell[c], "%d.%09ue%d", (int)random_below(9) - 4, random_below(1000000000), (int)random_below(6) - 3);
            else
                snprintf(r->cell[c], sizeof r->cell[c], "%.*f", decimals, ((double)random_below(1000000) - 500000) / 977);
        }
    }
}

// ---- as CSV ----

static void put_cell(Case *k, const char *text, char delimiter, bool may_have_comma)
{
    const bool quoted = random_below(5) == 0 || strchr(text, delimiter);
    char *at = k->csv + k->csv_size;

    k->csv_size += (size_t)snprintf(at, TEXT - k->csv_size, "%s%s%s", quoted ? "\"" : random_below(8) ? "" : " ", text, quoted ? "\"" : "");
    for (; may_have_comma && delimiter != ',' && *at; at++)
        if (*at == '.' && random_below(2))
            *at = ',';
}

static void put(Case *k, const char *text) { k->csv_size += (size_t)snprintf(k->csv + k->csv_size, TEXT - k->csv_size, "%s", text); }

static void write_csv(Case *k)
{
    static const char *const ends[] = {"\n", "\r\n", "\r"};
    static const char *const missing[] = {"", "nan", "NaN", " ", "-nan"};
    static const int decimals[] = {6, 3, 0};
    const char delimiter = ",;\t"[random_below(3)], *end = ends[random_below(3)], between[2] = {delimiter, '\0'};
    const bool is_last_ended = random_below(2);

    k->csv_size = 0;
    put(k, random_below(3) ? "" : "\xef\xbb\xbf");
    put_cell(k, "t", delimiter, false);
    for (int c = 0; c < COLUMNS; c++) {
        put(k, between);
        put(k, "\"");
        put(k, names[c]);
        put(k, "\"");
    }
    put(k, between);
    put(k, "note");
    for (int i = 0; i < k->rows; i++) {
        char time[40];
        const double power[] = {1e6, 1e3, 1};
        snprintf(time, sizeof time, "%.*f", decimals[k->unit], (double)k->row[i].us / power[k->unit]);
        put(k, random_below(10) ? end : "\n\n");
        put_cell(k, k->row[i].has_time ? time : missing[random_below(5)], delimiter, true);
        for (int c = 0; c < COLUMNS; c++) {
            put(k, between);
            put_cell(k, k->row[i].missing[c] ? missing[random_below(5)] : k->row[i].cell[c], delimiter, true);
        }
        put(k, between);
        put(k, random_below(4) ? "" : "\"two\nlines, \"\"quoted\"\"\"");
    }
    put(k, is_last_ended ? end : "");
}

static void write_script(Case *k)
{
    static const char *const units[] = {"s", "ms", "us"};
    char step[30], body[400];

    snprintf(step, sizeof step, k->by_rows ? "file" : "%lu", (unsigned long)k->delta_t);
    snprintf(body, sizeof body, k->by_rows ? "[all_states]\nG > 1e9: @stop\n" : "[all_states]\nG >= %lu: @stop\n", (unsigned long)((STEPS - 1) * k->delta_t));
    snprintf(k->script, TEXT, "[options]\ndelta_t %s\n[data]\nfile \"d.csv\"\ntime \"t\" %s\n%s\n%s\nmissing %s\n"
             "x = \"P 1\"\ny = \"a,b;c\" @scale -0.3 @offset 7.25\nb = \"B\"\nn = \"N\"\nf = \"F\"\n@compare x \"P 1\" tolerance %.3f delay %lu\n%s",
             step, units[k->unit], k->linear ? "linear" : "hold", random_below(2) ? "on_bad_time skip" : "", k->nan ? "nan" : "hold", k->tolerance,
             (unsigned long)k->delay, body);
}

static void make_case(Case *k)
{
    memset(k, 0, sizeof *k);
    k->linear = random_below(2);
    k->nan = random_below(3) == 0;
    k->by_rows = random_below(4) == 0;
    k->unit = (int)random_below(3);
    k->delta_t = 1 + random_below(25);
    k->delay = random_below(3) ? random_below(60) : 0;
    k->tolerance = random_below(2) ? random_below(400) : 0;
    make_rows(k);
    write_csv(k);
    write_script(k);
}

// ---- the reference ----

typedef struct Good { int n; double time[ROWS]; int row[ROWS]; int bad; } Good;        // rows without a bad time

static double time_of(const Row *r)
{
    char text[40];

    snprintf(text, sizeof text, "%ld.%03ld", r->us / 1000, r->us % 1000);
    return strtod(text, NULL);
}

static Good find_good(const Case *k)
{
    Good g = {0};

    for (int i = 0; i < k->rows; i++) {
        double t = time_of(&k->row[i]) - time_of(&k->row[0]);
        if (k->by_rows)
            t = (double)(2 * t < 0 ? -1 : ((long)(2 * t) + 1) / 2);   // halves up; a negative time is bad
        if (!k->row[i].has_time || (g.n && !(t > g.time[g.n - 1]))) {
            g.bad++;
            continue;
        }
        g.time[g.n] = t;
        g.row[g.n++] = i;
    }
    return g;
}

// Returns the value of column c in good row i; NaN: none.
static double value_of(const Case *k, const Good *g, int i, int c)
{
    for (; i >= 0; i--) {
        const Row *r = &k->row[g->row[i]];
        if (!r->missing[c]) {
            volatile double x = strtod(r->cell[c], NULL);
            if (c == 1) {
                x = x * scale;
                x = x + offset;
            }
            return x;
        }
        if (k->nan)
            break;
    }
    return NAN;
}

static int last_at(const Good *g, double t)
{
    int found = -1;

    for (int i = 0; i < g->n; i++)
        if (g->time[i] <= t)
            found = i;
    return found;
}

static double input_of(const Case *k, const Good *g, double t, int c)
{
    const int i = last_at(g, t);
    const double a = value_of(k, g, i, c);

    if (k->linear && c != 2 && i + 1 < g->n) {
        const double b = value_of(k, g, i + 1, c);
        volatile double share = (t - g->time[i]) / (g->time[i + 1] - g->time[i]), rise = (b - a) * share;
        return a + rise;
    }
    return a;
}

// Returns what a variable has after the assignment of x.
static double store(int c, double x)
{
    if (x != x)
        return 0;
    if (c == 2)
        return x != 0;
    if (c == 3)                                       // U8
        return x <= 0 ? 0 : x >= 255 ? 255 : (double)(long)x;
    return c == 4 ? (double)(float)x : x;
}

// ---- comparing ----

typedef struct Run { const Case *k; Good good; const Program *p; double now[COLUMNS]; uint64_t steps, failed, compared; } Run;

static double read_var(const Run *run, const ScriptStep *step, const char *name)
{
    for (size_t i = 0; i < run->p->var.n; i++) {
        const Var *v = run->p->var.at[i];
        const uint64_t cell = step->cell[v->index];
        double x;
        float y;
        if (strcmp(v->name->text, name) != 0)
            continue;
        if (v->type == SM_F64)
            return memcpy(&x, &cell, sizeof x), x;
        if (v->type == SM_F32) {
            const uint32_t half = (uint32_t)cell;
            return memcpy(&y, &half, sizeof y), (double)y;
        }
        return (double)cell;
    }
    return NAN;
}

static void after_step(void *context, const ScriptStep *step)
{
    Run *run = context;
    const double t = (double)step->g;
    double recorded;

    if (run->k->by_rows)
        CHECK((int)step->number <= run->good.n && t == run->good.time[step->number - 1]);
    else
        CHECK(step->g == (step->number - 1) * run->k->delta_t);
    for (int c = 0; c < COLUMNS; c++) {
        const double x = input_of(run->k, &run->good, t, c);
        if (x == x || run->k->nan)
            run->now[c] = store(c, x);
        CHECK(read_var(run, step, vars[c]) == run->now[c]);
    }
    run->steps++;
    if (step->g < run->k->delay)
        return;
    recorded = value_of(run->k, &run->good, last_at(&run->good, (double)(step->g - run->k->delay)), 0);
    run->compared += recorded == recorded;
    run->failed += recorded == recorded && !(run->now[0] - recorded <= run->k->tolerance && recorded - run->now[0] <= run->k->tolerance);
}

static const DataFile *find_data(void *context, const Source *from, const char *name, const char **problem)
{
    (void)from, (void)name, (void)problem;
    return &((DataMemory *)context)->file;
}

static uint64_t all_failed, all_compared, all_steps;

static void run_case(Session *s, Case *k)
{
    static const char sm[] = "[state_vector]\nU64 G\nU32 S\nF64 x @read_only\nF64 y @read_only\nbool b @read_only\nU8 n @read_only\nF32 f @read_only\nF64 out\n"
                             "[A]\n.step\n out = x + y + b + n + f\n";
    DataMemory m;
    MachineInput in = {0};
    Run run = {.k = k, .good = find_good(k)};
    ScriptOptions o = {.max_steps = 100000, .after_step = after_step, .context = &run};
    const Script *script;
    Engine *e;
    ScriptResult r;

    data_memory_init(&m, "d.csv", k->csv, k->csv_size);
    s->finder = (SourceFinder){NULL, find_data, &m};
    in.sm = source_new(&s->arena, "app.sm", sm, strlen(sm));
    run.p = session_program(s, &in);
    script = session_script(s, source_new(&s->arena, "app.ss", k->script, strlen(k->script)), run.p);
    CHECK(script != NULL);
    if (!script)
        return;
    e = engine_ref_open(&s->arena, run.p);
    r = script_run(&s->arena, &s->diags, script, &e, 1, &o);
    CHECK(r.outcome == (k->by_rows ? SCRIPT_NO_DATA : run.failed ? SCRIPT_FAILED : SCRIPT_PASSED));
    CHECK(run.steps == (k->by_rows ? (uint64_t)run.good.n : STEPS));
    CHECK(r.compare && r.compare[0].steps == run.compared && r.compare[0].failed == run.failed);
    CHECK(!k->by_rows || (r.data_rows == (uint64_t)k->rows && r.data_bad_rows == (uint64_t)run.good.bad));
    all_failed += run.failed;
    all_compared += run.compared;
    all_steps += run.steps;
}

int main(void)
{
    static Case k;
    static Session s;
    static int i;

    host_check(setjmp(host_oom));
    for (; i < CASES; i++) {
        const int failed_before = test_failed;
        make_case(&k);
        session_init(&s, heap_alloc, NULL, &host_oom);
        run_case(&s, &k);
        if (test_failed > failed_before && test_failed < 5) {
            DiagStyle plain = {false, 20};
            Buf b;
            buf_init(&b, &s.arena);
            diags_render_text(&s.diags, &plain, &b);
            fprintf(stderr, "case %d:\n%s\n%.*s\n%s\n", i, k.script, (int)k.csv_size, k.csv, buf_text(&b));
        }
        session_free(&s);
    }
    CHECK(all_steps > 20000 && all_compared > 10000 && all_failed > 1000 && all_failed < all_compared);
    return test_end("replay");
}
