// SPDX-License-Identifier: Apache-2.0
// Tests the layout of state diagrams: no two things overlap, lines pass around boxes and labels, few lines cross, and the time is proportional
// to the size of the machine.
//
//     layout MACHINE.sm…       besides random machines.  "most crossings: N" in a machine's first line is a bound.
#include <stdlib.h>
#include <string.h>

#include "compiler/report/diagram_layout.h"
#include "compiler/compile.h"
#include "tests/heap.h"
#include "tests/test.h"
#include "tests/unit/random.h"

// ---- machines ----

static Session session;
static jmp_buf oom;

static Program *compile(const char *name, const char *text, size_t len)
{
    MachineInput in = {source_new(&session.arena, name, text, len), NULL, NULL, NULL};
    Program *p = session_program(&session, &in);

    if (!p)
        fprintf(stderr, "%s does not compile:\n%.*s\n", name, len < 2000 ? (int)len : 2000, text);
    CHECK(p != NULL);
    return p;
}

static Analysis analysed(const Program *p)
{
    Analysis a;

    analysis_begin(&a, &session.arena, &session.diags, p);
    return a;
}

// ---- boxes ----

typedef struct Thing { Box box; const char *what; const DiagramEdge *label_of; } Thing;
typedef VEC(Thing) Things;

static void add_thing(Things *t, Box box, const char *what, const DiagramEdge *label_of)
{
    Thing x = {box, what, label_of};

    vec_push(&session.arena, t, x);
}

// Collects the things of a diagram that must not overlap.  A line from a state to the stub beside it counts as part of the stub.
static Things things_of(const Diagram *d)
{
    Things t = {NULL, 0, 0};

    for (size_t n = 0; n < d->nodes; n++) {
        const DiagramNode *node = &d->node[n];
        const Box from = {node->box.x - 28 - node->from_w, node->box.y, node->from_w, node->box.h};
        if (node->all)
            add_thing(&t, (Box){node->box.x, node->box.y - 2 * STACK, node->box.w + 2 * STACK, node->box.h + 2 * STACK}, node->name, NULL);
        else
            add_thing(&t, node->box, node->name, NULL);
        if (node->from)
            add_thing(&t, from, node->from, NULL);
    }
    for (size_t e = 0; e < d->edge.n; e++) {
        const DiagramEdge *edge = &d->edge.at[e];
        Box label = edge->label;
        label.w += diagram_mark_width(edge);
        add_thing(&t, label, edge->guard.at[0].text, edge);
        if (edge->form == EDGE_STUB)
            add_thing(&t, edge->name, "stub", NULL);
    }
    return t;
}

static bool overlap(Box a, Box b)
{
    return a.x < b.x + b.w && b.x < a.x + a.w && a.y < b.y + b.h && b.y < a.y + a.h;
}

static void check_boxes(const Diagram *d, const Things *t)
{
    for (size_t i = 0; i < t->n; i++) {
        const Box a = t->at[i].box;
        CHECK(a.w > 0 && a.h > 0);
        CHECK(a.x >= 0 && a.y >= 0 && a.x + a.w <= d->w && a.y + a.h <= d->h);
        for (size_t j = 0; j < i; j++) {
            if (overlap(a, t->at[j].box))
                fprintf(stderr, "%s: '%s' lies on '%s'\n", d->a->p->name->text, t->at[i].what, t->at[j].what);
            CHECK(!overlap(a, t->at[j].box));
        }
    }
}

// Text is no wider than its box, even in the widest font.
static void check_text(const Diagram *d)
{
    for (size_t n = 0; n < d->nodes; n++)
        CHECK(d->node[n].name_w + 8 <= d->node[n].box.w && d->node[n].action_w + 8 <= d->node[n].box.w && d->node[n].action.n <= ACTIONS + 1);
    for (size_t e = 0; e < d->edge.n; e++)
        for (size_t g = 0; g < d->edge.at[e].guard.n; g++) {
            const DiagramLines *line = &d->edge.at[e].guard.at[g].line;
            CHECK(line->n >= 1 && line->n <= GUARD_LINES);
            for (size_t i = 0; i < line->n; i++)
                CHECK(line->at[i].w <= d->edge.at[e].label.w && line->at[i].w <= GUARD_W);
        }
}

// ---- lines ----

static Box around(Point a, Point b)
{
    Box box = {a.x < b.x ? a.x : b.x, a.y < b.y ? a.y : b.y, abs(a.x - b.x) + 1, abs(a.y - b.y)};
    return box;
}

// Checks that a line begins and ends at its states, and between them touches only its own label.
static void check_path(const Diagram *d, const DiagramEdge *e, const Things *t)
{
    const Box from = d->node[e->from].box, to = d->node[e->to].box;
    const Point *p = e->path.at;
    const size_t n = e->path.n;

    CHECK(n >= 4 && n % 2 == 0);
    CHECK(p[0].x > from.x && p[0].x < from.x + from.w && p[0].y == from.y + (e->up ? 0 : from.h));
    CHECK(p[n - 1].x > to.x && p[n - 1].x < to.x + to.w && p[n - 1].y == to.y + (e->up ? to.h : 0));
    for (size_t i = 0; i + 1 < n; i++) {
        const Box piece = around(p[i], p[i + 1]);
        CHECK(i % 2 == 1 || p[i].x == p[i + 1].x);
        CHECK(e->up ? p[i].y >= p[i + 1].y : p[i].y <= p[i + 1].y);
        for (size_t k = 0; k < t->n; k++) {
            const bool touches = t->at[k].label_of != e && overlap(piece, t->at[k].box);
            if (touches)
                fprintf(stderr, "%s: a line touches '%s'\n", d->a->p->name->text, t->at[k].what);
            CHECK(!touches);
        }
    }
}

// Lines that end at the same state end at different points, so that their heads are distinct.
static void check_ends(const Diagram *d)
{
    for (size_t e = 0; e < d->edge.n; e++)
        for (size_t f = 0; f < e; f++) {
            const DiagramEdge *x = &d->edge.at[e], *y = &d->edge.at[f];
            if (x->form == EDGE_LINE && y->form == EDGE_LINE && x->to == y->to && x->up == y->up)
                CHECK(abs(x->path.at[x->path.n - 1].x - y->path.at[y->path.n - 1].x) >= 8);
        }
}

// Every transition is drawn once: as a guard of an edge, which has all copies of a transition of [all_states].
static void check_complete(const Diagram *d)
{
    size_t guards = 0;

    for (size_t e = 0; e < d->edge.n; e++) {
        for (size_t g = 0; g < d->edge.at[e].guard.n; g++)
            guards += d->edge.at[e].guard.at[g].transition->copy.n;
        CHECK((d->edge.at[e].form == EDGE_LINE) == (d->edge.at[e].path.n > 0));
    }
    CHECK(guards == d->a->transition.n);
}

// No position at which slices are cut touches a box, and below each layer there is such a position.
static void check_cuts(const Diagram *d, const Things *t)
{
    CHECK(d->cut.n > 0);
    for (size_t c = 0; c < d->cut.n; c++)
        for (size_t k = 0; k < t->n; k++)
            CHECK(d->cut.at[c] <= t->at[k].box.y || d->cut.at[c] >= t->at[k].box.y + t->at[k].box.h);
}

// Lays out a diagram with a finding, and so a mark, at every third transition.
static const Diagram *check_layout(const Program *p)
{
    Diags found;
    const DiagramOptions o = {.findings = &found};
    Analysis a = analysed(p);
    Diagram *d;
    Things t;

    diags_init(&found, &session.arena);
    for (size_t i = 0; i < a.transition.n; i += 3)
        diag_report(&found, DIAG_unreachable_state, a.transition.at[i].stmt->span, "marked");
    d = diagram_build(&a, &o);
    layout_diagram(d);
    t = things_of(d);
    check_boxes(d, &t);
    check_text(d);
    check_cuts(d, &t);
    check_complete(d);
    check_ends(d);
    for (size_t e = 0; e < d->edge.n; e++)
        if (d->edge.at[e].form == EDGE_LINE)
            check_path(d, &d->edge.at[e], &t);
    return d;
}

// ---- SVG: opened tags are closed, nothing is left unescaped ----

static bool well_formed(const char *s)
{
    int depth = 0;

    for (; *s; s++) {
        const char *end;
        if (*s == '&' && strncmp(s, "&amp;", 5) && strncmp(s, "&lt;", 4) && strncmp(s, "&gt;", 4) && strncmp(s, "&quot;", 6) &&
            strncmp(s, "&#39;", 5))
            return false;
        if (*s != '<')
            continue;
        if ((end = strchr(s, '>')) == NULL)
            return false;
        depth += s[1] == '/' ? -1 : end[-1] == '/' ? 0 : 1;
        if (depth < 0)
            return false;
        s = end;
    }
    return depth == 0;
}

static const char *drawn(const Analysis *a, const DiagramOptions *o)
{
    Buf out;

    buf_init(&out, &session.arena);
    diagram_write_svg(a, o, &out);
    CHECK(well_formed(buf_text(&out)));
    return buf_text(&out);
}

// Whether the slices together show every corner of a box.
static bool is_shown(const Things *slices, Box box)
{
    const Point corner[] = {{box.x, box.y}, {box.x + box.w - 1, box.y}, {box.x, box.y + box.h - 1}, {box.x + box.w - 1, box.y + box.h - 1}};
    int shown = 0;

    for (int c = 0; c < 4; c++) {
        bool found = false;
        for (size_t i = 0; i < slices->n; i++) {
            const Box s = slices->at[i].box;
            found |= corner[c].x >= s.x && corner[c].x < s.x + s.w && corner[c].y >= s.y && corner[c].y < s.y + s.h;
        }
        shown += found;
    }
    return shown == 4;
}

// The slices of a picture follow each other row by row, from left to right.  None is larger than allowed, or outside the picture; those of a row
// have one height, and rows do not overlap.  Blank slices are left out, so what the picture shows is checked: every state and every text.
static void check_slices(const Analysis *a, DiagramSize most)
{
    DiagramSize size;
    const DiagramOptions o = {.size = &size};
    Diagram *d = diagram_build(a, &o);
    Things slices = {NULL, 0, 0}, t;
    Buf out;

    drawn(a, &o);
    buf_init(&out, &session.arena);
    diagram_write_slices(a, &o, most, &out);
    CHECK(well_formed(buf_text(&out)));
    for (const char *s = buf_text(&out); (s = strstr(s, "viewBox=\"")) != NULL; s++) {
        char *end;
        const long left = strtol(s + 9, &end, 10), top = strtol(end, &end, 10), w = strtol(end, &end, 10), h = strtol(end, &end, 10);
        const Thing now = {.box = {(int32_t)left, (int32_t)top, (int32_t)w, (int32_t)h}};
        const Box *last = slices.n ? &slices.at[slices.n - 1].box : NULL;
        CHECK(w > 0 && w <= most.w && h > 0 && h <= most.h && left >= 0 && top >= 0 && left + w <= size.w && top + h <= size.h);
        CHECK(!last || (top == last->y ? left > last->x && h == last->h : top >= last->y + last->h));
        vec_push(&session.arena, &slices, now);
    }
    CHECK(slices.n > 0);
    layout_diagram(d);
    t = things_of(d);
    for (size_t i = 0; i < t.n; i++)
        CHECK(is_shown(&slices, t.at[i].box));
}

static void check_svg(const Program *p)
{
    const DiagramOptions none = {.findings = NULL};
    Analysis a = analysed(p), b = analysed(p);

    CHECK(strcmp(drawn(&a, &none), drawn(&b, &none)) == 0);
    check_slices(&a, (DiagramSize){100000, 300});
    check_slices(&a, (DiagramSize){100000, 100000});
    check_slices(&a, (DiagramSize){350, 300});
}

// ---- machines from files ----

static char *read_file(const char *path, size_t *len)
{
    FILE *f = fopen(path, "rb");
    char *text = arena_alloc(&session.arena, 100001);

    CHECK(f != NULL);
    *len = f ? fread(text, 1, 100000, f) : 0;
    if (f)
        fclose(f);
    return text;
}

static void check_file(const char *path)
{
    const char *most, *name = strrchr(path, '/');
    size_t len;
    char *text = read_file(path, &len);
    Program *p = compile(name ? name + 1 : path, text, len);
    const Diagram *d;

    if (!p)
        return;
    d = check_layout(p);
    check_svg(p);
    most = strstr(text, "most crossings: ");
    if (most && d->crossings > strtoul(most + 16, NULL, 10))
        fprintf(stderr, "%s: %lu crossings\n", path, (unsigned long)d->crossings);
    CHECK(!most || d->crossings <= strtoul(most + 16, NULL, 10));
}

// ---- random machines ----

static unsigned below(unsigned n) { return (unsigned)(random_u64() >> 33) % n; }

static void put_machine(Buf *out, unsigned states, unsigned transitions, uint64_t seed)
{
    random_state = 0x9E3779B97F4A7C15u ^ seed << 32;
    buf_str(out, "[state_vector]\nU64 G\nU32 S\nF64 pressure\n");
    for (unsigned s = 0; s < states; s++) {
        buf_printf(out, "[State%u]%s\n.step\n", s, below(12) == 0 ? " @abort" : below(12) == 0 ? " @safe" : "");
        for (unsigned t = below(transitions + 1); t > 0; t--)
            buf_printf(out, "    pressure > %u%s: -> State%u\n", below(1000),
                       below(3) ? "" : " and roll_min(pressure, 10) > 7 or pressure == 3", below(states));
    }
}

static Program *random_machine(unsigned states, unsigned transitions, uint64_t seed)
{
    Buf text;

    buf_init(&text, &session.arena);
    put_machine(&text, states, transitions, seed);
    return compile("random.sm", buf_text(&text), text.n);
}

static void check_random(void)
{
    for (unsigned seed = 1; seed <= 150; seed++) {
        check_layout(random_machine(1 + seed % 30, seed % 5, seed));
        session_free(&session);
        session_init(&session, heap_alloc, NULL, &oom);
    }
}

// ---- overlays ----

static const char plain[] = "[state_vector]\nU64 G\nU32 S\nF64 pressure\n"
                            "[Idle]\n.step\n    pressure > 5: -> Run\n[Run]\n.step\n    pressure < 2: -> Idle\n    pressure > 9: -> Idle\n";

static void check_counts(void)
{
    const uint64_t states[] = {3, 0}, transitions[] = {2, 0, 0};
    const DiagramCounts counts = {states, transitions, true};
    const DiagramOptions o = {.counts = &counts}, none = {.findings = NULL};
    Program *p = compile("plain.sm", plain, strlen(plain));
    Analysis a = analysed(p);
    const char *with = drawn(&a, &o), *without = drawn(&a, &none);

    CHECK(strstr(with, "entered 3 times") && strstr(with, "taken 2 times") && strstr(with, "never taken"));
    CHECK(strstr(with, "g-edge\" stroke-width=\"2.4\"") && strstr(with, "class=\"g-edge g-unrun\"") && strstr(with, "class=\"g-node g-unrun\""));
    CHECK(!strstr(without, "times") && !strstr(without, "class=\"g-edge g-unrun\""));
}

static unsigned times(const char *text, const char *word)
{
    unsigned n = 0;

    for (; (text = strstr(text, word)) != NULL; text++)
        n++;
    return n;
}

// Of three findings one is at a guard, one at a transition, one at a state; one in the state vector is not shown.
static void check_findings(void)
{
    Diags found;
    const DiagramOptions o = {.findings = &found};
    Program *p = compile("plain.sm", plain, strlen(plain));
    Analysis a = analysed(p);
    const char *svg;
    Diag *raised;

    diags_init(&found, &session.arena);
    diag_report(&found, DIAG_unreachable_state, p->state.at[1]->span, "<&\"'\x01\xff>");
    diag_report(&found, DIAG_unreachable_state, a.transition.at[0].when->stmt->span, "guard");
    raised = diag_report(&found, DIAG_unreachable_state, a.transition.at[2].stmt->span, "transition");
    raised->severity = DIAG_ERROR;
    diag_report(&found, DIAG_unreachable_state, p->var.at[2]->span, "nowhere");
    svg = drawn(&a, &o);
    CHECK(times(svg, "\"g-mark\"") == 2 && times(svg, "\"g-mark g-error\"") == 1);
    CHECK(strstr(svg, "state &#39;&lt;&amp;&quot;&#39;&lt;U+0001&gt;\xef\xbf\xbd&gt;&#39; is unreachable"));
    CHECK(strstr(svg, "guard&#39; is") && strstr(svg, "transition&#39; is") && !strstr(svg, "nowhere"));
}

// ---- [all_states] ----

static const char sections[] = "[state_vector]\nU64 G\nU32 S\nF64 pressure\nbool stop\nbool beacon\n"
                               "[Idle]\n.step\n    pressure > 5: -> Run\n"
                               "[Run]\n.step\n    pressure > 9: -> Abort\n    pressure < 2: -> Idle\n"
                               "[Abort]\n[Lost]\n.step\n    pressure > 7: -> Abort\n[define]\nnone = 1\n"
                               "[all_states] @except Abort\n.step\n    beacon = true\n    stop: -> Abort\n"
                               "[all_states]\n.step\n    pressure = pressure\n";

// A section with its transitions and assignments is drawn once, apart from the states.
static void check_sections(void)
{
    const DiagramOptions none = {.findings = NULL};
    Program *p = compile("sections.sm", sections, strlen(sections));
    Analysis a = analysed(p);
    const Diagram *d = diagram_build(&a, &none);
    const DiagramNode *first = &d->node[4];

    CHECK(d->states == 4 && d->nodes == 6 && first->all == p->all_states.at[0] && !first->state);
    CHECK(strcmp(first->title, "all states except Abort") == 0 && strcmp(d->node[5].title, "all states") == 0);
    CHECK(first->edges == 1 && first->action.n == 1 && first->reached);
    CHECK(d->edge.at[first->first_edge].guard.at[0].transition->copy.n == 3 && d->edge.at[first->first_edge].possible);
    CHECK(d->node[0].edges == 1 && d->node[0].action.n == 0 && d->node[5].edges == 0 && !d->node[3].reached && d->node[2].reached);
    CHECK(strstr(drawn(&a, &none), "4 states, 5 transitions."));
}

// The count of a pair of states that two edges have belongs to either of them.  From Run and from Lost two transitions lead to Abort.
static void check_section_counts(void)
{
    const uint64_t states[] = {3, 3, 3, 0};
    uint64_t taken[8] = {0};
    const DiagramCounts counts = {states, taken, true};
    const DiagramOptions o = {.counts = &counts};
    Program *p = compile("sections.sm", sections, strlen(sections));
    Analysis a = analysed(p);
    const char *svg;

    CHECK(a.transition.n == 7);
    taken[0] = 1;                     // Idle to Abort
    taken[1] = 4;                     // Idle to Run
    taken[2] = 2;                     // Run to Abort
    svg = drawn(&a, &o);
    CHECK(strstr(svg, "all states except Abort to Abort: stop\ntaken 1 to 3 times<"));
    CHECK(strstr(svg, "Run to Abort: pressure &gt; 9\ntaken at most 2 times<"));
    CHECK(strstr(svg, "Idle to Run: pressure &gt; 5\ntaken 4 times<"));
    CHECK(strstr(svg, "Lost to Abort: pressure &gt; 7\nnever taken<") || strstr(svg, "Lost to Abort: pressure &gt; 7 (never)\nnever taken<"));
    CHECK(!strstr(svg, "all states except Abort\nentered"));
}

// A finding in a section belongs to the section, wherever in the file it is, and not to the states that have a copy.
static void check_section_findings(void)
{
    Diags found;
    const DiagramOptions o = {.findings = &found};
    Program *p = compile("sections.sm", sections, strlen(sections));
    Analysis a = analysed(p);
    const Stmt *set = p->state.at[0]->block[BLOCK_STEP].at[0], *stop = a.transition.at[0].stmt;
    const Diagram *d;

    diags_init(&found, &session.arena);
    diag_report(&found, DIAG_unreachable_state, set->span, "section");
    diag_report(&found, DIAG_unreachable_state, stop->span, "transition");
    diag_report(&found, DIAG_unreachable_state, p->state.at[2]->span, "Abort");
    diag_report(&found, DIAG_unused_definition, p->define.at[0]->span, "none");       // between a state and a section: not shown
    d = diagram_build(&a, &o);
    CHECK(d->node[4].finding.n == 1 && d->edge.at[d->node[4].first_edge].guard.at[0].finding.n == 1 && d->node[2].finding.n == 1);
    CHECK(d->node[0].finding.n == 0 && d->node[1].finding.n == 0 && d->node[3].finding.n == 0);
}

// The name of a file can contain any characters.
static void check_name(void)
{
    const DiagramOptions none = {.findings = NULL};
    Program *p = compile("a<b>&\"c.sm", plain, strlen(plain));
    Analysis a = analysed(p);
    Buf dot;

    CHECK(strstr(drawn(&a, &none), "State diagram of a&lt;b&gt;&amp;&quot;c"));
    buf_init(&dot, &session.arena);
    diagram_write_dot(&a, &none, &dot);
    CHECK(strstr(buf_text(&dot), "digraph \"a<b>&amp;\\\"c\""));
}

// ---- text ----

static void check_wrapping(void)
{
    DiagramLines t = diagram_text_wrap(&session.arena, "T > 500 and roll_avg(pressure, 10) > 3", GUARD_SIZE, 190, 3);

    CHECK(t.n == 2 && strcmp(t.at[0].text, "T > 500") == 0 && strcmp(t.at[1].text, "and roll_avg(pressure, 10) > 3") == 0);
    t = diagram_text_wrap(&session.arena, "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa", GUARD_SIZE, 100, 2);
    CHECK(t.n == 2 && t.at[0].w <= 100 && t.at[1].w <= 100 && strstr(t.at[1].text, "\xe2\x80\xa6"));
    t = diagram_text_wrap(&session.arena, "go", GUARD_SIZE, 100, 2);
    CHECK(t.n == 1 && strcmp(t.at[0].text, "go") == 0);
}

// A condition is broken between operands and operators.  A call is broken only if it is wider than a line.
static void check_condition_lines(void)
{
    static const char *const want[] = {"T > 300", "and roll_min(max(pressureA, pressureB), 5)", "> mostPressure and not (a or b)"};
    const DiagramLines t = diagram_text_wrap(&session.arena,
                                             "T > 300 and roll_min(max(pressureA, pressureB), 5) > mostPressure and not (a or b)",
                                             GUARD_SIZE, 260, 6);

    CHECK(t.n == sizeof want / sizeof *want);
    for (size_t i = 0; i < t.n; i++)
        CHECK(strcmp(t.at[i].text, want[i]) == 0);
}

// ---- actions ----

static const char acting[] = "[state_vector]\nU64 t @alias G\nU32 s @alias S\nF64 p\nbool valve\nU8 code\nU8 c\n[local]\nF64 l = 0\n"
                             "[A]\n.entry\nvalve = true\nl = p\n.step\np > 5: valve = p > 7\n"
                             "p > 9 {\ncode = 3\n-> B\n}\n.exit\nvalve = false\n"
                             "[B]\n.step\nc = 1\nc = 2\nc = 3\nc = 4\nc = 5\nc = 6\nc = 7\nc = 8\nc = 9\nc = 10\n";

// Boxes list assignments to elements.  Those to locals and those in the same braces as a transition are omitted, and the rest is only counted.
static void check_actions(void)
{
    static const char *const want[] = {"valve = true", "valve = p > 7 if p > 5", "valve = false"};
    const DiagramOptions none = {.findings = NULL};
    Analysis a = analysed(compile("acting.sm", acting, strlen(acting)));
    const Diagram *d = diagram_build(&a, &none);

    CHECK(d->node[0].action.n == sizeof want / sizeof *want);
    for (size_t i = 0; i < d->node[0].action.n; i++)
        CHECK(strcmp(d->node[0].action.at[i].text, want[i]) == 0 && d->node[0].action.at[i].first);
    CHECK(d->node[1].action.n == ACTIONS + 1);
    CHECK(d->node[1].action.at[0].first && !d->node[1].action.at[1].first);
    CHECK(strcmp(d->node[1].action.at[ACTIONS].text, "\xe2\x80\xa6 and 2 more") == 0);
    CHECK(strstr(drawn(&a, &none), ">exit<") != NULL);
}

// ---- the path down the page ----

static const char aborting[] = "[state_vector]\nU64 t @alias G\nU32 s @alias S\nF64 p\n"
                               "[A]\n.step\np > 1: -> X\np < 0: -> B\n[B]\n.step\np > 5: -> C\n[C]\n[X] @abort\n.step\n-> Y\n[Y]\n.step\n-> Z\n[Z]\n";

static int32_t center_of(const Diagram *d, size_t node) { return d->node[node].box.x + d->node[node].box.w / 2; }

// The longest path from A leads through the @abort state, but the column below A is A, B, C.
static void check_spine(void)
{
    const DiagramOptions none = {.findings = NULL};
    Analysis a = analysed(compile("aborting.sm", aborting, strlen(aborting)));
    Diagram *d = diagram_build(&a, &none);

    layout_diagram(d);
    CHECK(abs(center_of(d, 0) - center_of(d, 1)) <= 1 && abs(center_of(d, 1) - center_of(d, 2)) <= 1);
    CHECK(abs(center_of(d, 0) - center_of(d, 3)) > 20);
}

int main(int argc, char **argv)
{
    if (setjmp(oom)) {
        puts("out of memory: 0 passed, 1 failed");
        return 1;
    }
    session_init(&session, heap_alloc, NULL, &oom);
    for (int i = 1; i < argc; i++)
        check_file(argv[i]);
    check_wrapping();
    check_condition_lines();
    check_actions();
    check_spine();
    check_counts();
    check_sections();
    check_section_counts();
    check_section_findings();
    check_findings();
    check_name();
    check_random();
    session_free(&session);
    return test_end("layout");
}
