// SPDX-License-Identifier: Apache-2.0
// fragments FILE   Puts each fragment of the table FILE into a file that is right otherwise, and checks that one error is shown, and that it
// names what to write instead. The table's header describes its form.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compiler/library/smc.h"

enum { TEXT_MAX = 4000, TABLE_MAX = 200000 };

// The files into which fragments are put. A \1 is replaced by the fragments of the first place, and so on.
static const char machine[] =
    "\1[state_vector]\nU64 G\nU32 S\nF64 x\nF64 y\nI32 n\nbool valve\n\2[local]\nF64 t0 = 0\n\3[Work]\n.entry\n    t0 = x\n.step\n\4    x > 90: -> Idle\n"
    "\5[Idle]\n.entry\n    y = t0\n    n = n + 1\n    valve = x > 3\n";
static const char script[] = "[options]\ndelta_t 10\n\n[all_states]\n\6G == 200: @stop\n";
static const char requirements[] = "R1 \"the valve is closed\"\n   never S == Work and y > 100\n\n\7R3 \"three\"\n   always S == Idle implies n > 0\n";

static const char *const places[] = {"top", "vector", "local", "step", "state", "script", "requirements"};
enum { PLACES = sizeof places / sizeof *places, SCRIPT = 6, REQUIREMENTS = 7 };

static unsigned long passed, failed;

// Copies `from` to `to`, with the fragment at its place, and nothing at the other places.
static void fill(char *to, const char *from, int place, const char *fragment)
{
    for (; *from; from++)
        if (*from <= PLACES) {
            if (*from == place)
                to += sprintf(to, "%s", fragment);
        } else {
            *to++ = *from;
        }
    *to = '\0';
}

static void add_source(SmcSession *s, int32_t kind, const char *name, const char *text)
{
    uint32_t source;

    if (smc_source_add(s, kind, name, text, strlen(text), &source) != SMC_OK)
        exit(2);
}

// Whether the texts of the diagnostic contain `words`.
static int contains(SmcSession *s, uint32_t diag, const char *words)
{
    return strstr(smc_diag_message(s, diag), words) || strstr(smc_diag_label(s, diag), words);
}

static void fail(unsigned long line, const char *what, const char *fragment)
{
    printf("fragments.txt:%lu: %s\n%s", line, what, fragment);
    failed++;
}

// Judges the errors of the fragment on a line of the table.
static void judge(SmcSession *s, unsigned long line, const char *words, const char *fragment)
{
    uint32_t errors = 0, last = 0;

    for (uint32_t i = 0; i < smc_diag_count(s); i++)
        if (smc_diag_severity(s, i) == SMC_SEVERITY_ERROR) {
            errors++;
            last = i;
        }
    if (errors == 1 && contains(s, last, words)) {
        passed++;
        return;
    }
    fail(line, errors == 1 ? "the error does not name what to write" : errors ? "several errors" : "no error", fragment);
    for (uint32_t i = 0; i < smc_diag_count(s); i++)
        if (smc_diag_severity(s, i) == SMC_SEVERITY_ERROR)
            printf("    %s: %s (%s)\n", smc_diag_code(s, i), smc_diag_message(s, i), smc_diag_label(s, i));
}

static void check(unsigned long line, const char *where, const char *words, const char *fragment)
{
    static char text[3][TEXT_MAX];
    SmcSession *s;
    int place = 0;

    while (place < PLACES && strcmp(places[place], where) != 0)
        place++;
    if (place++ == PLACES || smc_open(NULL, 0, &s) != SMC_OK)
        exit(2);
    fill(text[0], machine, place, fragment);
    fill(text[1], script, place, fragment);
    fill(text[2], requirements, place, fragment);
    add_source(s, SMC_KIND_SM, "a.sm", text[0]);
    if (place == SCRIPT)
        add_source(s, SMC_KIND_SS, "a.ss", text[1]);
    if (place == REQUIREMENTS)
        add_source(s, SMC_KIND_RQ, "a.rq", text[2]);
    smc_compile(s);
    judge(s, line, words, fragment);
    smc_close(s);
}

int main(int argc, char **argv)
{
    static char table[TABLE_MAX], fragment[TEXT_MAX], where[32], words[256];
    FILE *f = argc == 2 ? fopen(argv[1], "rb") : NULL;
    unsigned long line = 0, head = 0;
    const char *at = table;

    if (!f || fread(table, 1, TABLE_MAX - 1, f) == 0 || !feof(f) || fclose(f) != 0)
        return 2;
    while (*at) {
        const size_t n = strcspn(at, "\n") + (at[strcspn(at, "\n")] == '\n');
        line++;
        if (at[0] == '=' && at[1] == '=') {
            if (head)
                check(head, where, words, fragment);
            if (sscanf(at, "== %31[^:]: %255[^\n]", where, words) != 2)
                return 2;
            head = line;
            fragment[0] = '\0';
        } else if (head && strlen(fragment) + n < TEXT_MAX / 4) {
            strncat(fragment, at, n);
        }
        at += n;
    }
    if (head)
        check(head, where, words, fragment);
    printf("%lu passed, %lu failed\n", passed, failed);
    return failed > 0 || passed == 0;
}
