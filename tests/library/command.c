// SPDX-License-Identifier: Apache-2.0
// Some of smc's commands through libsmc's public header alone; tests/library/parity.sh compares their output with that of smc.
//     command image|c|report|graph|check|run|structure FILE…        writes to standard output; outputs of `c` follow each other
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compiler/library/smc.h"

static int32_t kind_of(const char *path)
{
    static const char *const suffix[] = {".sv", ".sm", ".ss", ".io", ".app"};
    const char *dot = strrchr(path, '.');

    for (int32_t i = 0; i < 5; i++)
        if (dot && strcmp(dot, suffix[i]) == 0)
            return i;
    return -1;
}

static void add_file(SmcSession *s, const char *path, const char *name)
{
    FILE *f = fopen(path, "rb");
    char *text = malloc(1 << 20);
    size_t n;
    uint32_t source;

    if (!f || !text)
        exit(3);
    n = fread(text, 1, 1 << 20, f);
    fclose(f);
    if (smc_source_add(s, kind_of(path), name, text, n, &source) != SMC_OK)
        exit(3);
    free(text);
}

static void write_outputs(SmcSession *s)
{
    for (uint32_t i = 0; i < smc_output_count(s); i++) {
        const void *bytes;
        uint64_t size;
        if (smc_output(s, i, &bytes, &size) == SMC_OK)
            fwrite(bytes, 1, (size_t)size, stdout);
    }
}

static int run_all(SmcSession *s)
{
    int failed = 0;

    for (uint32_t i = 0; i < smc_source_count(s); i++)
        if (smc_source_kind(s, i) == SMC_KIND_SS) {
            failed |= smc_run(s, i, SMC_ENGINE_VM, 0) != SMC_OK;
            fputs(smc_run_report(s, i), stdout);
        }
    return failed;
}

// Whether the machine of source 0, when it is opened, has the states and variables of its structure, with the same numbers.
static int has_equal_machine(SmcSession *s)
{
    SmcMachine m;
    uint32_t states = smc_model_state_count(s, 0), variables;

    if (smc_machine_open(s, 0, &m) != SMC_OK || states == 0 || states != smc_machine_state_count(s, m))
        return 0;
    for (uint32_t i = 1; i <= states; i++)
        if (strcmp(smc_model_state_name(s, 0, i), smc_machine_state_name(s, m, i)) != 0 ||
            (smc_model_state_marks(s, 0, i) & ~(uint32_t)SMC_MARK_FINAL) != smc_machine_state_marks(s, m, i))
            return 0;
    variables = smc_machine_variable_count(s, m);
    for (uint32_t i = 0; i < variables; i++)
        if (strcmp(smc_model_variable_name(s, 0, i), smc_machine_variable_name(s, m, i)) != 0 ||
            smc_model_variable_type(s, 0, i) != smc_machine_variable_type(s, m, i) || smc_model_variable_kind(s, 0, i) != smc_machine_variable_kind(s, m, i))
            return 0;
    for (uint32_t i = variables; i < smc_model_variable_count(s, 0); i++)
        if (smc_model_variable_kind(s, 0, i) != SMC_VARIABLE_CONSTANT)
            return 0;
    return variables > 0;
}

// One line for each transition.
static int write_structure(SmcSession *s)
{
    static const char *const block[] = {".entry", ".step", ".exit"};

    for (uint32_t t = 0; t < smc_model_transition_count(s, 0); t++)
        printf("%u %s %s %s %u %s\n", (unsigned)t + 1, smc_model_state_name(s, 0, smc_model_transition_from(s, 0, t)),
               smc_model_state_name(s, 0, smc_model_transition_to(s, 0, t)), block[smc_model_transition_block(s, 0, t)],
               (unsigned)smc_model_transition_line(s, 0, t), smc_model_transition_guard(s, 0, t));
    return !has_equal_machine(s);
}

int main(int argc, char **argv)
{
    SmcSession *s;
    SmcResult r;
    const char *what = argc > 2 ? argv[1] : "", *text = "";
    uint64_t size = 0;
    int failed = 0;

    if (argc < 3 || smc_open(NULL, 0, &s) != SMC_OK)
        return 2;
    smc_option_set(s, SMC_OPTION_REVIEW, strcmp(what, "report") == 0);
    for (int i = 2; i < argc; i++) {
        char *name = strchr(argv[i], '=');           // PATH=NAME: the name that an application uses
        if (name)
            *name = '\0';
        add_file(s, argv[i], name ? name + 1 : argv[i]);
    }
    r = smc_compile(s);
    if (strcmp(what, "check") == 0)
        r = smc_render(s, SMC_RENDER_TEXT, &text, &size);
    else if (strcmp(what, "report") == 0)
        r = smc_report(s, 0, SMC_REPORT_HTML, &text, &size);
    else if (strcmp(what, "graph") == 0)
        r = smc_diagram(s, 0, SMC_DIAGRAM_SVG, &text, &size);
    else if (strcmp(what, "run") == 0)
        failed = run_all(s);
    else if (strcmp(what, "structure") == 0)
        failed = write_structure(s);
    else if ((r = smc_emit(s, strcmp(what, "image") == 0 ? SMC_EMIT_IMAGE : SMC_EMIT_C)) == SMC_OK)
        write_outputs(s);
    fwrite(text, 1, (size_t)size, stdout);
    if (r != SMC_OK)
        fprintf(stderr, "%s\n", smc_error_text(s));
    smc_close(s);
    return r != SMC_OK || failed;
}
