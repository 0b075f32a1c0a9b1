// SPDX-License-Identifier: Apache-2.0
// The results of smc test for other programs: JUnit XML and the Test Anything Protocol.
#include <string.h>

#include "compiler/base/utf8.h"
#include "compiler/cli/test.h"

static size_t count(const TestRun *t, TestStatus status)
{
    size_t n = 0;

    for (size_t i = 0; i < t->result.n; i++)
        n += t->result.at[i].status == status;
    return n;
}

// ---- JUnit ----

static bool is_xml_character(uint32_t code)
{
    return code == '\t' || code == '\n' || (code >= 0x20 && code != 0x7f && code != 0xfffe && code != 0xffff);
}

// One character; what XML cannot hold, as control bytes and bytes that are not UTF-8, becomes U+FFFD.
static size_t put_xml_character(Buf *out, const char *s, size_t n)
{
    uint32_t code = 0;
    size_t len = utf8_decode(s, n, &code);

    if (len == 0 || !is_xml_character(code))
        buf_str(out, "&#xFFFD;");
    else if (*s == '&' || *s == '<' || *s == '>' || *s == '"' || *s == '\n')
        buf_printf(out, "&#%u;", (unsigned)code);
    else
        buf_put(out, s, len);
    return len ? len : 1;
}

static void put_xml(Buf *out, const char *s, size_t n)
{
    while (n) {
        size_t len = put_xml_character(out, s, n);
        s += len;
        n -= len;
    }
}

static void put_attribute(Buf *out, const char *name, const char *value, size_t n)
{
    buf_printf(out, " %s=\"", name);
    put_xml(out, value, n);
    buf_char(out, '"');
}

static size_t first_line(const char *text)
{
    const char *lf = strchr(text, '\n');

    return lf ? (size_t)(lf - text) : strlen(text);
}

// The line that says why: of diagnostics the first error, whatever warnings stand above it.
static const char *line_of_failure(const char *text)
{
    const char *error = strstr(text, ": error: ");

    if (!error)
        return text;
    while (error > text && error[-1] != '\n')
        error--;
    return error;
}

static void put_testcase(Buf *out, const TestResult *r)
{
    const char *element = r->status == TEST_SKIPPED ? "skipped" : "failure", *why = line_of_failure(r->message);

    buf_str(out, "  <testcase");
    put_attribute(out, "name", r->name, strlen(r->name));
    put_attribute(out, "classname", "smc", 3);
    if (r->status == TEST_PASSED) {
        buf_str(out, "/>\n");
        return;
    }
    buf_printf(out, ">\n    <%s", element);
    put_attribute(out, "message", why, first_line(why));
    buf_char(out, '>');
    put_xml(out, r->message, strlen(r->message));
    buf_printf(out, "</%s>\n  </testcase>\n", element);
}

void test_write_junit(const TestRun *t, Buf *out)
{
    buf_str(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    buf_printf(out, "<testsuite name=\"smc test\" tests=\"%lu\" failures=\"%lu\" errors=\"0\" skipped=\"%lu\">\n",
               (unsigned long)t->result.n, (unsigned long)count(t, TEST_FAILED), (unsigned long)count(t, TEST_SKIPPED));
    for (size_t i = 0; i < t->result.n; i++)
        put_testcase(out, &t->result.at[i]);
    buf_str(out, "</testsuite>\n");
}

// ---- TAP ----

// A name on its line: no line end, and no # that would begin a directive.
static void put_tap_name(Buf *out, const char *s)
{
    for (; *s; s++) {
        if (*s == '#' || *s == '\\')
            buf_char(out, '\\');
        buf_char(out, *s == '\n' || *s == '\r' ? ' ' : *s);
    }
}

static void put_tap_lines(Buf *out, const char *text)
{
    while (*text) {
        size_t n = first_line(text);
        buf_str(out, "# ");
        buf_put(out, text, n);
        buf_char(out, '\n');
        text += n + (text[n] == '\n');
    }
}

void test_write_tap(const TestRun *t, Buf *out)
{
    buf_printf(out, "TAP version 13\n1..%lu\n", (unsigned long)t->result.n);
    for (size_t i = 0; i < t->result.n; i++) {
        const TestResult *r = &t->result.at[i];

        buf_printf(out, "%s %lu - ", r->status == TEST_FAILED ? "not ok" : "ok", (unsigned long)i + 1);
        put_tap_name(out, r->name);
        if (r->status == TEST_SKIPPED)
            buf_printf(out, " # SKIP %.*s", (int)first_line(r->message), r->message);
        buf_char(out, '\n');
        if (r->status == TEST_FAILED)
            put_tap_lines(out, r->message);
    }
}
