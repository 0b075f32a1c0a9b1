// SPDX-License-Identifier: Apache-2.0
// smc test: what its files share.  A test is one script run on one machine, or one .smt case.
#ifndef SMC_TEST_H
#define SMC_TEST_H

#include "compiler/cli/cli.h"
#include "compiler/script/testfile.h"

// ---- engines.c ----

typedef enum EngineKind { ENGINE_REF, ENGINE_VM, ENGINE_VM_SOFT, ENGINE_C, ENGINE_C_SOFT, ENGINE_KINDS } EngineKind;

extern const char *const engine_name[ENGINE_KINDS];

// The engines of one program, the reference first.  Closing may be done at any time, twice too.
typedef struct EngineSet {
    Engine *at[ENGINE_KINDS];
    size_t n;
    const char *error;        // why engines_open failed
} EngineSet;

unsigned engines_named(const char *name);             // a bit of 1u << kind each, of names between commas; "all": but c-soft; 0: unknown
unsigned engines_in_list(const char *list);           // those of a header's `on ref vm c`; others are left out
bool engines_open(EngineSet *set, Session *s, const Program *p, unsigned which, int opt_level);
void engines_close(EngineSet *set);

// ---- the results ----

typedef enum TestStatus {
    TEST_PASSED,
    TEST_FAILED,              // it ran, and something was not as expected
    TEST_BROKEN,              // it could not run: it cannot be read or compiled, or an engine broke down
    TEST_SKIPPED
} TestStatus;

typedef struct TestResult {
    const char *path;         // of the script or the case
    const char *suite;        // the machine, or the folder of the case
    TestStatus status;
    const char *message;      // lines: why it is not passed; else ""
    int code;                 // the exit code it asks for
    double seconds;           // that it took
} TestResult;

typedef struct TestRun {      // one call of smc test
    Cli *c;
    Arena *arena;
    unsigned engines;         // bits asked for; 0: as each case says, or vm
    unsigned absent;          // engines that were wanted and left out
    const char *why_absent;   // a sentence
    bool c_was_tried, c_runs; // whether the C compiler runs, once it was tried
    size_t left_out;          // runs on absent engines that cases did without
    uint64_t max_steps;
    VEC(const char *) path;   // .smt cases to run, in order
    VEC(TestResult) result;
} TestRun;

// Whether standard output is another program's to read and has the results: people's reports stay away from it.
bool test_is_read(const Cli *c);                                    // cmd_test.c
// Where reports for people go: standard output, unless the trace goes there.
int test_result_fd(const Cli *c);                                   // cmd_test.c
const char *test_folder(Arena *arena, const char *path);           // cmd_test.c: the suite of a case

// Runs every script of the call on the machine `path` and adds a result for each.  EXIT_OK, or the exit code after a message;
// EXIT_USAGE: nothing has been run.
int test_machine(TestRun *t, const char *path);                    // test_machine.c

// Those of the engines `which` that cannot run here and that are left out, which is noted for the end of the run.  Engines that the call
// names are not among them: they must run.  Nor is emitted C with --engine=all and the variable CC set.
unsigned test_absent_engines(TestRun *t, unsigned which);           // cmd_test.c

// ---- test_case.c: one .smt file ----

typedef struct TestCase TestCase;

TestCase *case_open(TestRun *t, const char *path);    // reads and compiles it
// Whether it is to run on emitted C, of either kind, and what of.
bool case_wants_c(const TestCase *c, EngineKind kind, const Program **p, const IrMachine **ir);
// Runs it and gives everything back.  `emitted` are the engines of emitted C, by kind; NULL: it opens one of its own.
TestResult case_close(TestCase *c, Engine *const *emitted);

// ---- test_batch.c ----

void test_cases(TestRun *t, const char *const *path, size_t n);    // many .smt files: adds a result for each

// ---- test_trace.c: --trace ----

typedef struct TestTrace TestTrace;

// Opens the file that --trace names; *trace is NULL where none is wanted.  EXIT_OK, or the exit code after a message.
int test_trace_open(TestRun *run, const Program *p, TestTrace **trace);
void test_trace_script(TestTrace *t, const char *path);            // the script whose steps follow
void test_trace_left_out(TestTrace *t, const char *path);          // reports one that has none; t may be NULL
void test_trace_step(void *trace, const ScriptStep *step);         // for ScriptOptions
int test_trace_close(TestTrace *t);                                // t may be NULL; the file appears if a script ran

// ---- test_text.c ----

// What differs is added to `why`, a line or more each.
void test_check_report(const TestPart *part, const Buf *report, Buf *why);
void test_check_trace(const TestPart *part, const Buf *trace, Buf *why);

// ---- test_output.c ----

void test_write_summary(const TestRun *t, Buf *out);
void test_write_junit(const TestRun *t, Buf *out);
void test_write_tap(const TestRun *t, Buf *out);

#endif
