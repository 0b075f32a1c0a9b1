// SPDX-License-Identifier: Apache-2.0
// Writes the results of smc test after all tests: for people, as JUnit XML and in the Test Anything Protocol.
#include <string.h>

#include "compiler/base/path.h"
#include "compiler/base/utf8.h"
#include "compiler/cli/test.h"

// ---- messages ----

// Returns the length of the first line of the text.
static size_t first_line_length(const char *text)
{
    const char *lf = strchr(text, '\n');

    return lf ? (size_t)(lf - text) : strlen(text);
}

// Returns the line that contains the reason: the first error among diagnostics, even after warnings.
static const char *line_of_failure(const char *text)
{
    const char *error = strstr(text, ": error: ");

    if (!error)
        return text;
    while (error > text && error[-1] != '\n')
        error--;
    return error;
}

// ---- the end of a run, for people ----

static size_t count_status(const TestRun *t, TestStatus status)
{
    size_t n = 0;

    for (size_t i = 0; i < t->result.n; i++)
        n += t->result.at[i].status == status && !t->result.at[i].is_limit;
    return n;
}

// Adds whether what the scripts cover reaches the limits of --min-coverage, if it has any.
static void write_limits(const TestRun *t, Buf *out)
{
    size_t limits = 0, failed = 0;

    for (size_t i = 0; i < t->result.n; i++) {
        limits += t->result.at[i].is_limit;
        failed += t->result.at[i].is_limit && t->result.at[i].status != TEST_PASSED;
    }
    if (limits)
        buf_printf(out, "; coverage %s --min-coverage", failed ? "is below" : "reaches");
}

// Adds a line for each script that failed.  If many failed, their output is long, and these lines at the end are an overview.
static void write_failed_scripts(const TestRun *t, Buf *out)
{
    size_t scripts = 0;

    for (size_t i = 0; i < t->result.n; i++)
        scripts += t->result.at[i].status == TEST_FAILED && !has_suffix(t->result.at[i].path, ".smt");
    for (size_t i = 0; i < t->result.n && scripts > 1; i++) {
        const TestResult *r = &t->result.at[i];
        const char *why = line_of_failure(r->message);
        const bool names_script = r->is_limit || strncmp(why, r->path, strlen(r->path)) == 0;        // not if a requirement is violated
        if (r->status == TEST_FAILED && !has_suffix(r->path, ".smt"))
            buf_printf(out, "failed: %s%s%.*s\n", names_script ? "" : r->path, names_script ? "" : ": ", (int)first_line_length(why), why);
    }
}

void test_write_summary(const TestRun *t, Buf *out)
{
    size_t skipped = count_status(t, TEST_SKIPPED) + t->left_out, absent = 0;

    for (size_t i = 0; i < t->result.n; i++)
        absent += t->result.at[i].did_not_run;
    write_failed_scripts(t, out);
    buf_printf(out, "%lu passed, %lu failed", (unsigned long)count_status(t, TEST_PASSED),
               (unsigned long)(count_status(t, TEST_FAILED) + count_status(t, TEST_BROKEN) - absent));
    if (absent)
        buf_printf(out, ", %lu did not run", (unsigned long)absent);
    if (skipped)
        buf_printf(out, ", %lu skipped", (unsigned long)skipped);
    write_limits(t, out);
    buf_char(out, '\n');
}

// ---- JUnit ----

static bool is_xml_character(uint32_t code)
{
    return code == '\t' || code == '\n' || (code >= 0x20 && code != 0x7f && code != 0xfffe && code != 0xffff);
}

// Writes one character. Bytes that XML cannot contain, such as control bytes and invalid UTF-8, become U+FFFD.
static size_t write_xml_character(Buf *out, const char *s, size_t n, bool is_attribute)
{
    uint32_t code = 0;
    size_t len = utf8_decode(s, n, &code);

    if (len == 0 || !is_xml_character(code))
        buf_str(out, "&#xFFFD;");
    else if (*s == '&' || *s == '<' || *s == '>' || *s == '"' || (*s == '\n' && is_attribute))
        buf_printf(out, "&#%u;", (unsigned)code);
    else
        buf_put(out, s, len);
    return len ? len : 1;
}

static void write_xml(Buf *out, const char *s, size_t n, bool is_attribute)
{
    while (n) {
        size_t len = write_xml_character(out, s, n, is_attribute);
        s += len;
        n -= len;
    }
}

static void write_attribute(Buf *out, const char *name, const char *value, size_t n)
{
    buf_printf(out, " %s=\"", name);
    write_xml(out, value, n, true);
    buf_char(out, '"');
}

// Writes the code of a diagnostic at the end of its line: "E0750" for "... [E0750]".
static void write_type(Buf *out, const char *line, size_t n)
{
    size_t at = n;

    while (at > 0 && line[at - 1] != '[')
        at--;
    if (at > 0 && line[at] == 'E' && line[n - 1] == ']')
        write_attribute(out, "type", line + at, strcspn(line + at, " ]"));
}

static void write_time(Buf *out, double seconds)
{
    const unsigned long us = (unsigned long)(seconds * 1e6 + 0.5);

    buf_printf(out, " time=\"%lu.%06lu\"", us / 1000000, us % 1000000);
}


// Writes a machine or a folder as a Java class name, because readers show Java packages as a tree: "flight.tank" for "flight/tank.sm".
static void write_classname(Buf *out, Arena *arena, const char *suite)
{
    const size_t end = strlen(suite) - (has_suffix(suite, ".sm") || has_suffix(suite, ".rq") ? 3 : 0);
    Buf name;

    buf_init(&name, arena);
    for (size_t i = 0; i < end; i++)
        if (suite[i] == '.' && (name.n == 0 || path_is_separator(suite[i - 1])) && (path_is_separator(suite[i + 1]) || i + 1 == end))
            i++;                                          // "./"
        else
            buf_char(&name, path_is_separator(suite[i]) ? '.' : suite[i]);
    if (name.n == 0)
        buf_str(&name, "cases");
    if (strcmp(suite, "-") == 0)
        name.n = 0, buf_str(&name, "stdin");
    write_attribute(out, "classname", buf_text(&name), name.n);
}

static bool is_not_empty(const char *text) { return text && *text; }

// Writes a property, unless its value is empty.
static void write_property(Buf *out, const char *name, const char *value, size_t n)
{
    if (n == 0)
        return;
    buf_printf(out, "        <property name=\"%s\"", name);
    write_attribute(out, "value", value, n);
    buf_str(out, "/>\n");
}

// Writes the seed of a script and the requirements that it has tested, as properties.
static void write_properties(Buf *out, const char *seed, const char *list)
{
    if (!is_not_empty(seed) && !is_not_empty(list))
        return;
    buf_str(out, "      <properties>\n");
    if (is_not_empty(seed))
        write_property(out, "seed", seed, strlen(seed));
    while (list && *list) {
        const size_t n = strcspn(list, " ");
        write_property(out, "requirement", list, n);
        list += n + (list[n] == ' ');
    }
    buf_str(out, "      </properties>\n");
}

static void write_problem(Buf *out, const TestResult *r, const char *element)
{
    const char *why = line_of_failure(r->message);

    buf_printf(out, "      <%s", element);
    write_attribute(out, "message", why, first_line_length(why));
    if (r->status != TEST_SKIPPED)
        write_type(out, why, first_line_length(why));
    buf_char(out, '>');
    write_xml(out, r->message, strlen(r->message), false);
    buf_printf(out, "</%s>\n", element);
}

static void write_testcase(Buf *out, const TestResult *r)
{
    static const char *const elements[] = {NULL, "failure", "error", "skipped"};          // by TestStatus
    const char *element = elements[r->status];
    const char *name = has_suffix(r->path, ".smt") ? path_file_name(r->path) : r->path;

    buf_str(out, "    <testcase");
    write_attribute(out, "name", name, strlen(name));
    write_classname(out, out->arena, r->suite);
    write_time(out, r->seconds);
    if (!element && !is_not_empty(r->printed) && !is_not_empty(r->seed) && !is_not_empty(r->requirements)) {
        buf_str(out, "/>\n");
        return;
    }
    buf_str(out, ">\n");
    write_properties(out, r->seed, r->requirements);
    if (element)
        write_problem(out, r, element);
    if (is_not_empty(r->printed)) {
        buf_str(out, "      <system-out>");
        write_xml(out, r->printed, strlen(r->printed), false);
        buf_str(out, "</system-out>\n");
    }
    buf_str(out, "    </testcase>\n");
}

typedef struct TestTotals { size_t by_status[TEST_SKIPPED + 1], tests; double seconds; } TestTotals;

// Adds up one suite, or all suites if `suite` is NULL.
static TestTotals add_totals(const TestRun *t, const char *suite)
{
    TestTotals all = {{0}, 0, 0};

    for (size_t i = 0; i < t->result.n; i++) {
        const TestResult *r = &t->result.at[i];
        if (suite && strcmp(r->suite, suite) != 0)
            continue;
        all.by_status[r->status]++;
        all.tests++;
        all.seconds += r->seconds;
    }
    return all;
}

static void write_totals(Buf *out, const TestTotals *all)
{
    buf_printf(out, " tests=\"%lu\" failures=\"%lu\" errors=\"%lu\"", (unsigned long)all->tests,
               (unsigned long)all->by_status[TEST_FAILED], (unsigned long)all->by_status[TEST_BROKEN]);
}

static void write_suite(const TestRun *t, const char *suite, Buf *out)
{
    const TestTotals all = add_totals(t, suite);

    buf_str(out, "  <testsuite");
    write_attribute(out, "name", suite, strlen(suite));
    write_totals(out, &all);
    buf_printf(out, " skipped=\"%lu\"", (unsigned long)all.by_status[TEST_SKIPPED]);
    write_time(out, all.seconds);
    if (has_suffix(suite, ".sm"))
        write_attribute(out, "file", suite, strlen(suite));
    buf_str(out, ">\n");
    for (size_t i = 0; i < t->result.n; i++)
        if (strcmp(t->result.at[i].suite, suite) == 0)
            write_testcase(out, &t->result.at[i]);
    buf_str(out, "  </testsuite>\n");
}

// ---- requirements in JUnit: a suite for each file, a test for each requirement ----

static TestStatus status_of_requirement(const TestRequirement *r)
{
    return r->total.violated ? TEST_FAILED : r->total.undecided || r->total.judged == 0 ? TEST_SKIPPED : TEST_PASSED;
}

// Adds up the requirements of one file, or all if `file` is NULL.
static void add_requirements(const TestRun *t, const char *file, TestTotals *all)
{
    for (size_t i = 0; i < t->requirement.n; i++) {
        const TestRequirement *r = &t->requirement.at[i];
        if (file && strcmp(r->what->span.src->name, file) != 0)
            continue;
        all->by_status[status_of_requirement(r)]++;
        all->tests++;
    }
}

static void write_requirement(Buf *out, const TestRequirement *r)
{
    static const char *const elements[] = {NULL, "failure", "error", "skipped"};          // by TestStatus
    const char *name = format_in(out->arena, "%s %s", r->what->id->text, r->what->text->text), *element = elements[status_of_requirement(r)];
    const char *verdict = requirement_verdict(&r->total);

    buf_str(out, "    <testcase");
    write_attribute(out, "name", name, strlen(name));
    write_classname(out, out->arena, r->what->span.src->name);
    write_time(out, 0);
    buf_str(out, ">\n      <properties>\n");
    write_property(out, "requirement", r->what->id->text, strlen(r->what->id->text));
    write_property(out, "judged", r->judged, strlen(r->judged));
    write_property(out, "not visited", r->unvisited, strlen(r->unvisited));
    write_property(out, "tested by", r->asserts, strlen(r->asserts));
    write_property(out, "implemented", r->implemented, strlen(r->implemented));
    buf_str(out, "      </properties>\n");
    if (element) {
        buf_printf(out, "      <%s", element);
        write_attribute(out, "message", verdict, strlen(verdict));
        buf_str(out, "/>\n");
    }
    buf_str(out, "    </testcase>\n");
}

static void write_requirements_of(const TestRun *t, const char *file, Buf *out)
{
    TestTotals all = {{0}, 0, 0};

    add_requirements(t, file, &all);
    buf_str(out, "  <testsuite");
    write_attribute(out, "name", file, strlen(file));
    write_totals(out, &all);
    buf_printf(out, " skipped=\"%lu\"", (unsigned long)all.by_status[TEST_SKIPPED]);
    write_time(out, 0);
    write_attribute(out, "file", file, strlen(file));
    buf_str(out, ">\n");
    for (size_t i = 0; i < t->requirement.n; i++)
        if (strcmp(t->requirement.at[i].what->span.src->name, file) == 0)
            write_requirement(out, &t->requirement.at[i]);
    buf_str(out, "  </testsuite>\n");
}

// Writes a suite for each file of requirements. The requirements of a file follow each other.
static void write_requirement_suites(const TestRun *t, Buf *out)
{
    for (size_t i = 0; i < t->requirement.n; i++) {
        const char *file = t->requirement.at[i].what->span.src->name;
        if (i == 0 || strcmp(t->requirement.at[i - 1].what->span.src->name, file) != 0)
            write_requirements_of(t, file, out);
    }
}

static bool is_first_of_suite(const TestRun *t, size_t i)
{
    for (size_t k = 0; k < i; k++)
        if (strcmp(t->result.at[k].suite, t->result.at[i].suite) == 0)
            return false;
    return true;
}

void test_write_junit(const TestRun *t, Buf *out)
{
    TestTotals all = add_totals(t, NULL);

    add_requirements(t, NULL, &all);
    buf_str(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"smc test\"");
    write_totals(out, &all);
    write_time(out, all.seconds);
    buf_str(out, ">\n");
    for (size_t i = 0; i < t->result.n; i++)
        if (is_first_of_suite(t, i))
            write_suite(t, t->result.at[i].suite, out);
    write_requirement_suites(t, out);
    buf_str(out, "</testsuites>\n");
}

// ---- TAP ----

// Writes a name on its line, without line ends and without a # that would begin a directive.
static void write_tap_name(Buf *out, const char *s)
{
    for (; *s; s++) {
        if (*s == '#' || *s == '\\')
            buf_char(out, '\\');
        buf_char(out, *s == '\n' || *s == '\r' ? ' ' : *s);
    }
}

static void write_tap_lines(Buf *out, const char *text)
{
    while (*text) {
        size_t n = first_line_length(text);
        buf_str(out, "# ");
        buf_put(out, text, n);
        buf_char(out, '\n');
        text += n + (text[n] == '\n');
    }
}

static void write_tap_detail(Buf *out, const char *what, const char *places)
{
    if (*places)
        write_tap_lines(out, format_in(out->arena, "%s %s", what, places));
}

// Writes a requirement as a test. One that is undecided or was never judged has not been tested, so it is skipped.
static void write_tap_requirement(const TestRequirement *r, size_t number, Buf *out)
{
    const TestStatus status = status_of_requirement(r);

    buf_printf(out, "%s %lu - %s ", status == TEST_FAILED ? "not ok" : "ok", (unsigned long)number, r->what->id->text);
    write_tap_name(out, r->what->text->text);
    if (status == TEST_SKIPPED)
        buf_printf(out, " # SKIP %s", requirement_verdict(&r->total));
    buf_char(out, '\n');
    write_tap_detail(out, "judged in", r->judged);
    write_tap_detail(out, "no script came to", r->unvisited);
    write_tap_detail(out, "tested by", r->asserts);
    write_tap_detail(out, "implemented in", r->implemented);
}

void test_write_tap(const TestRun *t, Buf *out)
{
    buf_printf(out, "TAP version 13\n1..%lu\n", (unsigned long)(t->result.n + t->requirement.n));
    for (size_t i = 0; i < t->result.n; i++) {
        const TestResult *r = &t->result.at[i];

        buf_printf(out, "%s %lu - ", r->status == TEST_FAILED || r->status == TEST_BROKEN ? "not ok" : "ok", (unsigned long)i + 1);
        write_tap_name(out, r->path);
        if (r->status == TEST_SKIPPED)
            buf_printf(out, " # SKIP %.*s", (int)first_line_length(r->message), r->message);
        buf_char(out, '\n');
        if (r->status == TEST_FAILED || r->status == TEST_BROKEN)
            write_tap_lines(out, r->message);
        if (is_not_empty(r->seed))
            buf_printf(out, "# seed: %s\n", r->seed);
        if (is_not_empty(r->requirements))
            buf_printf(out, "# requirements: %s\n", r->requirements);
        if (is_not_empty(r->printed))
            write_tap_lines(out, r->printed);
    }
    for (size_t i = 0; i < t->requirement.n; i++)
        write_tap_requirement(&t->requirement.at[i], t->result.n + i + 1, out);
}
