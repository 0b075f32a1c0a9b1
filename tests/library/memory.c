// SPDX-License-Identifier: Apache-2.0
// Calls all of libsmc with too little memory: with each limit of a session, from nothing to enough, in malloc and in an area.  A call either
// succeeds or returns SMC_E_MEMORY.  The session can still be used, and closing it frees all memory.
#include <stdlib.h>
#include <string.h>

#include "compiler/library/smc.h"
#include "tests/test.h"

static const char vector[] = "[Bus]\nU64 G\nU32 S\nF64 p\nbool v\n";
static const char machine[] = "[state_vector]\nU64 G\nU32 S\nF64 p\nbool v\n[local]\nU32 n = 0\n[A] @safe\n.step\n    n = n + 1\n    v = roll_avg(p, 20) > 5 and n > 3\n    p > 90: -> B\n"
                              "[B]\n.step\n    v = false\n";
static const char script[] = "[options]\ndelta_t 1\n[all_states]\nG == 5: p = 7\nG == 9 {\n    @assert not v\n    @stop\n}\n";

static size_t refused;

// Whether a call succeeded.  It can fail only for lack of memory, or because an earlier call did.
static bool is_ok(SmcResult r)
{
    CHECK(r == SMC_OK || r == SMC_E_MEMORY || r == SMC_E_STATE || r == SMC_E_HANDLE || r == SMC_E_INDEX);
    refused += r == SMC_E_MEMORY;
    return r == SMC_OK;
}

// Returns whether every call succeeded.
static bool use_library(SmcSession *s)
{
    uint32_t sv, sm, ss;
    const char *text;
    const void *bytes;
    uint64_t size;
    SmcMachine m = 0, second = 0;
    bool all = is_ok(smc_source_add(s, SMC_KIND_SV, "bus.sv", vector, strlen(vector), &sv));

    all = is_ok(smc_source_add(s, SMC_KIND_SM, "a.sm", machine, strlen(machine), &sm)) && all;
    all = is_ok(smc_source_add(s, SMC_KIND_SS, "a.ss", script, strlen(script), &ss)) && all;
    if (!all)
        return false;
    all = is_ok(smc_warning_select(s, "everything"));
    all = is_ok(smc_option_set(s, SMC_OPTION_REVIEW, 1)) && all;
    all = is_ok(smc_option_set(s, SMC_OPTION_TRACE, 1)) && all;
    all = is_ok(smc_compile(s)) && all;
    all = is_ok(smc_machine_open(s, sm, &m)) && all;
    all = is_ok(smc_machine_open(s, sm, &second)) && all;
    if (m)
        CHECK(smc_machine_step(s, m, 1) == SMC_OK && smc_machine_step(s, m, 2) == SMC_OK);
    if (m && second)
        is_ok(smc_machine_continue(s, m, second));
    all = is_ok(smc_emit(s, SMC_EMIT_IMAGE)) && all;
    if (smc_output_count(s) == 1)
        CHECK(smc_output(s, 0, &bytes, &size) == SMC_OK && size > 100);
    all = is_ok(smc_emit(s, SMC_EMIT_C)) && all;
    all = is_ok(smc_run(s, ss, SMC_ENGINE_VM | SMC_ENGINE_REF, 0)) && all;
    all = is_ok(smc_diagram(s, sm, SMC_DIAGRAM_SVG, &text, &size)) && all;
    all = is_ok(smc_report(s, sm, SMC_REPORT_HTML, &text, &size)) && all;
    all = is_ok(smc_render(s, SMC_RENDER_SARIF, &text, &size)) && all;
    if (m)
        CHECK(smc_machine_step(s, m, 3) == SMC_OK && smc_machine_close(s, m) == SMC_OK);
    return all;
}

// Returns whether everything succeeded with `size` bytes.
static bool try_size(void *area, uint64_t size)
{
    SmcSession *s = NULL;
    const SmcResult r = smc_open(area, size, &s);
    bool all;

    CHECK(r == SMC_OK || r == SMC_E_MEMORY);
    if (r != SMC_OK)
        return false;
    all = use_library(s);
    CHECK(smc_memory_peak(s) <= size);
    CHECK(smc_sources_clear(s) == SMC_OK);
    if (all) {                    // repeated in the memory that the first time has freed
        CHECK(use_library(s));
        CHECK(smc_memory_peak(s) <= size);
    }
    CHECK(smc_close(s) == SMC_OK);
    return all;
}

int main(int argc, char **argv)
{
    const uint64_t most = 4000000, step = argc > 1 ? (uint64_t)atoi(argv[1]) : 20011;
    unsigned char *area = malloc(most + 64);
    size_t worked_at = 0;

    CHECK(area != NULL);
    for (uint64_t size = 1; size < most && worked_at < 3; size += step) {
        memset(area + size, 0xa5, 64);
        worked_at += try_size(area, size);
        for (int i = 0; i < 64; i++)
            CHECK(area[size + (uint64_t)i] == 0xa5);
        try_size(NULL, size);
    }
    CHECK(worked_at == 3 && refused > 50);
    free(area);
    return test_end("memory");
}
