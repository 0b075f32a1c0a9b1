// SPDX-License-Identifier: Apache-2.0
// Compares reports and traces with those that a case expects, line by line.
#include <string.h>

#include "compiler/case.h"

typedef struct LineCursor { const char *at, *end; } LineCursor;
typedef struct ReportLine { const char *at; size_t n; } ReportLine;

// Reads the next line, without its line end, into *line. Returns false at the end.
static bool read_line(LineCursor *l, ReportLine *line)
{
    const char *lf;

    if (l->at == l->end)
        return false;
    lf = memchr(l->at, '\n', (size_t)(l->end - l->at));
    line->at = l->at;
    line->n = (size_t)((lf ? lf : l->end) - l->at);
    l->at = lf ? lf + 1 : l->end;
    return true;
}

// Returns the lines of a part without the blank lines at its end, which separate it from the next part.
static LineCursor lines_of_part(const TestPart *p)
{
    size_t n = p->n;

    while (n && (p->text[n - 1] == '\n' || p->text[n - 1] == '\r'))
        n--;
    return (LineCursor){p->text, p->text + n};
}

static LineCursor lines_of_text(const Buf *text) { return (LineCursor){buf_text(text), buf_text(text) + text->n}; }

static bool same_text(ReportLine a, ReportLine b) { return a.n == b.n && memcmp(a.at, b.at, a.n) == 0; }

void case_compare_report(const TestPart *expected, const Buf *report, Buf *why)
{
    LineCursor wanted = lines_of_part(expected), written = lines_of_text(report);
    ReportLine e, r;
    bool more_e = true, more_r = true, differs = false;

    while (more_e || more_r) {
        more_e = read_line(&wanted, &e);
        more_r = read_line(&written, &r);
        if (more_e == more_r && (!more_e || same_text(e, r)))
            continue;
        if (!differs)
            buf_str(why, "the report differs (- expected, + came):\n");
        differs = true;
        if (more_e)
            buf_printf(why, "  - %.*s\n", (int)e.n, e.at);
        if (more_r)
            buf_printf(why, "  + %.*s\n", (int)r.n, r.at);
    }
}

// Returns the length of "STEP NAME " in a line "STEP NAME VALUE" of a trace.
static size_t length_before_value(ReportLine l)
{
    size_t n = l.n;

    while (n && l.at[n - 1] != ' ')
        n--;
    return n;
}

// Reports an expected line that the trace does not contain, with the values that the trace has for the same step and variable.
static void report_missing_line(ReportLine wanted, const Buf *trace, Buf *why)
{
    LineCursor all = lines_of_text(trace);
    size_t n = length_before_value(wanted);
    ReportLine l;

    buf_printf(why, "the trace has no line '%.*s' here", (int)wanted.n, wanted.at);
    while (read_line(&all, &l))
        if (n && length_before_value(l) == n && memcmp(l.at, wanted.at, n) == 0)
            buf_printf(why, "; it has '%.*s'", (int)l.n, l.at);
    buf_char(why, '\n');
}

// The trace must contain the expected lines in the same order. Other lines may be between them, and blank lines are ignored.
void case_compare_trace(const TestPart *expected, const Buf *trace, Buf *why)
{
    LineCursor wanted = lines_of_part(expected), written = lines_of_text(trace);
    ReportLine e, l;

    while (read_line(&wanted, &e)) {
        const LineCursor before = written;
        bool found = e.n == 0;
        while (!found && read_line(&written, &l))
            found = same_text(e, l);
        if (!found) {
            report_missing_line(e, trace, why);
            written = before;
        }
    }
}
