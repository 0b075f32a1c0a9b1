// SPDX-License-Identifier: Apache-2.0
// libsmc with passes that produce an invalid machine.  A call returns SMC_E_INTERNAL and names the pass, and the session can still be used and
// closed.  The linker replaces two passes by those below.
#include <string.h>

#include "compiler/library/smc.h"
#include "compiler/passes/pass.h"
#include "tests/test.h"

static const char machine[] = "[state_vector]\nU64 G\nU32 S\nF64 p\nF64 q\n[A] @safe\n.step\n    q = p * 2 + 1\n    p > 90: -> B\n[B]\n.step\n    q = 0\n";
static const char script[] = "[options]\ndelta_t 1\n[all_states]\nG == 5: p = 7\nG == 9 {\n    @assert q == 15\n    @stop\n}\n";

static enum { NONE, IN_DCE, IN_IF_CONVERT } fault;
static unsigned breaks;           // how often a pass has made a function invalid

void __real_pass_dce(Arena *arena, IrFn *f, Facts *facts);
void __wrap_pass_dce(Arena *arena, IrFn *f, Facts *facts);
void __real_pass_if_convert(Arena *arena, IrFn *f, Facts *facts);
void __wrap_pass_if_convert(Arena *arena, IrFn *f, Facts *facts);

// Changes the type of the first store of a function, so that it is not that of its variable.
void __wrap_pass_dce(Arena *arena, IrFn *f, Facts *facts)
{
    const IrBlk *b = &f->blk.at[0];

    __real_pass_dce(arena, f, facts);
    for (uint32_t i = 0; fault == IN_DCE && i < b->ins.n; i++)
        if (f->ins.at[b->ins.at[i]].op == IR_store) {
            f->ins.at[b->ins.at[i]].type = SM_BOOL;
            breaks++;
            return;
        }
}

void __wrap_pass_if_convert(Arena *arena, IrFn *f, Facts *facts)
{
    __real_pass_if_convert(arena, f, facts);
    if (fault == IN_IF_CONVERT) {
        f->blk.at[0].jump.kind = (IrJumpKind)99;
        breaks++;
    }
}

static uint32_t sm, ss;

static SmcSession *open_session(void)
{
    SmcSession *s = NULL;

    CHECK(smc_open(NULL, 0, &s) == SMC_OK);
    CHECK(smc_source_add(s, SMC_KIND_SM, "a.sm", machine, strlen(machine), &sm) == SMC_OK);
    CHECK(smc_source_add(s, SMC_KIND_SS, "a.ss", script, strlen(script), &ss) == SMC_OK);
    return s;
}

static bool names_pass(const SmcSession *s, const char *pass)
{
    return strstr(smc_error_text(s), "smc has a bug; please report it") != NULL && strstr(smc_error_text(s), pass) != NULL;
}

typedef SmcResult Call(SmcSession *s);

static SmcResult call_compile(SmcSession *s) { return smc_compile(s); }
static SmcResult call_emit(SmcSession *s) { return smc_emit(s, SMC_EMIT_IMAGE); }
static SmcResult call_run(SmcSession *s) { return smc_run(s, ss, SMC_ENGINE_VM, 0); }

static SmcResult call_open(SmcSession *s)
{
    SmcMachine m = 0;

    return smc_machine_open(s, sm, &m);
}

static SmcResult call_report(SmcSession *s)
{
    const char *text;
    uint64_t size;

    return smc_report(s, sm, SMC_REPORT_TEXT, &text, &size);
}

// Produces an invalid machine in one call.  Afterwards the same call succeeds, in the same session and without compiling again.
static void test_recovery(Call *call)
{
    SmcSession *s = open_session();
    uint64_t used;

    CHECK(smc_option_set(s, SMC_OPTION_REVIEW, 1) == SMC_OK && smc_option_set(s, SMC_OPTION_MAX_RAM, 100000) == SMC_OK);
    CHECK(call == call_compile || smc_compile(s) == SMC_OK);
    used = smc_memory_used(s);
    fault = IN_DCE;
    breaks = 0;
    CHECK(call(s) == SMC_E_INTERNAL && breaks > 0 && names_pass(s, "dce"));
    CHECK(smc_memory_used(s) == used || call == call_run || call == call_report);         // these calls have allocated memory for a review
    fault = NONE;
    CHECK(call(s) == SMC_OK);
    CHECK(smc_compile(s) == SMC_OK && smc_emit(s, SMC_EMIT_C) == SMC_OK && smc_output_count(s) == 2);
    CHECK(smc_close(s) == SMC_OK);
}

static void closes_after_a_bug(void)
{
    SmcSession *s = open_session();

    CHECK(smc_compile(s) == SMC_OK && smc_emit(s, SMC_EMIT_IMAGE) == SMC_OK);
    fault = IN_DCE;
    CHECK(call_open(s) == SMC_E_INTERNAL && smc_output_count(s) == 1);
    fault = NONE;
    CHECK(smc_close(s) == SMC_OK);
}

static void recovers_in_c(void)
{
    SmcSession *s = open_session();

    CHECK(smc_compile(s) == SMC_OK);
    fault = IN_IF_CONVERT;
    CHECK(smc_emit(s, SMC_EMIT_C) == SMC_E_INTERNAL && names_pass(s, "if_convert") && smc_output_count(s) == 0);
    fault = NONE;
    CHECK(smc_emit(s, SMC_EMIT_C) == SMC_OK && smc_output_count(s) == 2);
    CHECK(smc_close(s) == SMC_OK);
}

int main(void)
{
    static Call *const calls[] = {call_compile, call_emit, call_run, call_open, call_report};

    for (size_t i = 0; i < sizeof calls / sizeof *calls; i++)
        test_recovery(calls[i]);
    closes_after_a_bug();
    recovers_in_c();
    return test_end("broken");
}
