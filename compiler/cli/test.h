// SPDX-License-Identifier: Apache-2.0
// smc test: declarations shared by its files. A test is one script run on one machine, or one .smt case.
#ifndef SMC_TEST_H
#define SMC_TEST_H

#include "compiler/cli/cli.h"
#include "compiler/device/engines.h"
#include "compiler/report/traceability.h"

// ---- the results ----

typedef enum TestStatus {
    TEST_PASSED,
    TEST_FAILED,              // the test ran, and differed from what it expects
    TEST_BROKEN,              // the test could not run: reading or compiling failed, or an engine broke down
    TEST_SKIPPED
} TestStatus;

typedef struct TestResult {
    const char *path;         // path of the script or the case
    const char *suite;        // path of the script's machine, or folder of the case
    TestStatus status;
    const char *message;      // why it did not pass, one or more lines; "" if it passed
    int code;                 // the exit code of `smc test`, unless another result has a greater one
    double seconds;           // duration of the test
    const char *printed;      // the lines that the script has printed; "" or NULL: none
    const char *seed;         // the seed of its random numbers; "" or NULL: it draws none
    bool is_limit;            // a limit of --min-coverage, not a test
    bool did_not_run;         // TEST_BROKEN: none of the machine's scripts ran, because of an error elsewhere
    const char *requirements; // the ids of the requirements that it has tested, separated by spaces; "" or NULL: none
} TestResult;

// The result of a requirement in all scripts of the call.
typedef struct TestRequirement {
    const Requirement *what;
    RequirementTotal total;
    const char *implemented;  // where the machine is marked with @req of this requirement: "tank.sm:7, tank.sm:12"; ""
    const char *judged;       // where it was judged and how often: "a.ss: 101, b.ss: 7"; ""
    const char *unvisited;    // the states that it names and no script came to: "Hold, Burn"; ""
    const char *asserts;      // the asserts of scripts that test it and were evaluated: "a.ss:12"; ""
} TestRequirement;

typedef struct TestRun {      // one call of smc test
    Cli *c;
    Arena *arena;
    unsigned engines;         // 1u << EngineKind of each engine that --engine names; 0: those that each case names, or the VM
    unsigned absent;          // engines that were requested, but cannot run here (bits as `engines`)
    const char *why_absent;   // why they cannot, as a sentence
    bool c_was_tried, c_runs; // c_was_tried: the C compiler has been tried; c_runs: it works
    int code;                 // the least exit code of the call, whatever its results: -Werror can make a warning about requirements an error
    size_t left_out;          // number of runs of cases that were omitted because their engine is absent
    uint64_t max_steps;
    uint64_t seed;            // the value of --seed
    VEC(const char *) path;   // .smt cases to run, in order
    VEC(const Script *) script;               // the scripts that ran
    VEC(TestResult) result;
    VEC(TestRequirement) requirement;         // in the order of their files
    const char *traceability; // the line that sums up --traceability; NULL: none
} TestRun;

// Whether results for another program go to standard output: then reports for people do not go there.
bool test_stdout_is_for_program(const Cli *c);                                    // cmd_test.c: whether standard output is for a program
// Where reports for people go: standard output, unless the trace or the diagnostics go there.
int test_result_fd(const Cli *c);                                   // cmd_test.c
// Whether an argument is a script. Standard input ("-") is one if the call names a machine; otherwise it is the machine.
bool test_is_script(const Cli *c, const char *path);               // cmd_test.c
bool test_is_requirements(const char *path);                         // cmd_test.c: whether an argument is a file of requirements
const char *test_suite_name(Arena *arena, const char *path);           // cmd_test.c: the suite of a case

// Runs every script of the call on the machine `path` and adds a result for each.  EXIT_OK, or the exit code after a message;
// EXIT_USAGE: nothing has been run.
int test_run_machine(TestRun *t, const char *path);                    // test_machine.c

// Returns the engines among `which` that cannot run here and are omitted, and records them for the end of the run. Engines that the call
// names are never omitted: they must run. Emitted C is not omitted either with --engine=all and the variable CC set.
unsigned test_absent_engines(TestRun *t, unsigned which);           // cmd_test.c

// ---- test_requirements.c ----

typedef struct RequirementTable RequirementTable;

// Begins the table of the requirements `what`, which can be NULL: then it stays empty.
RequirementTable *test_requirements_begin(TestRun *t, const Requirements *what);
// Adds the run of a script.
void test_requirements_add(RequirementTable *table, const Script *s, const ScriptResult *r);
// Ends the table: reports what no script has judged, and stores the results in t->requirement. `complete`: all scripts have reached a @stop.
void test_requirements_end(RequirementTable *table, bool complete);
void test_requirements_write(const TestRun *t, Buf *out);      // the table for people

// ---- test_case.c: one .smt file ----

typedef struct TestCase TestCase;

TestCase *test_case_open(TestRun *t, const char *path);    // reads and compiles the case
// Returns whether the case has to run on emitted C of this kind; if so, stores its program and its IR.
bool test_case_find_c(const TestCase *c, EngineKind kind, const Program **p, const IrMachine **ir);
// Runs the case and frees it. `emitted`, which the caller closes: the engines of emitted C, by kind; where one is NULL, the case opens its own engine.
TestResult test_case_close(TestCase *c, Engine *const *emitted);

// ---- test_batch.c ----

void test_run_cases(TestRun *t, const char *const *path, size_t n);    // many .smt files: adds a result for each

// ---- test_trace.c: --trace ----

typedef struct TestTrace TestTrace;

// Opens the file that --trace names; *trace is NULL without --trace. EXIT_OK, or the exit code after a message.
int test_trace_open(TestRun *run, const Program *p, const Requirements *rq, TestTrace **trace);
void test_trace_script(TestTrace *t, const char *path);            // names the script whose steps follow
void test_trace_left_out(TestTrace *t, const char *path);          // reports a script without a trace; t may be NULL
void test_trace_step(void *trace, const ScriptStep *step);         // writes a step; for ScriptOptions.after_step
int test_trace_close(TestTrace *t);                                // t may be NULL; the file appears if a script ran

// ---- test_coverage.c: --coverage ----

typedef struct TestCoverage TestCoverage;

bool test_coverage_is_wanted(const Cli *c);                         // whether an option requires coverage to be measured
bool test_is_coverage_data(const char *path);                      // whether an argument is a file of counts (.cov)
int test_coverage_check_options(Cli *c);                            // EXIT_OK, or EXIT_USAGE after a message
bool test_coverage_demands_requirements(const Cli *c, double *percent);       // whether --min-coverage has requirements
// Begins to measure p and adds an engine to the set.  Reads the files of counts that the command line names.  *coverage is NULL if nothing is
// measured.  EXIT_OK, or the exit code after a message.
int test_coverage_open(TestRun *t, const Program *p, EngineSet *engines, TestCoverage **coverage);
// After the scripts: writes the files that options name, prints the report, and adds a result for --min-coverage.  `coverage` may be NULL.
int test_coverage_finish(TestRun *t, TestCoverage *coverage, const char *machine);
// Prints the session's diagnostics and stores them for a result's message (test_machine.c).
int test_report_diagnostics(TestRun *t, const char **text);

// ---- test_traceability.c: --traceability, and requirements of --min-coverage ----

int test_traceability_check_options(Cli *c, const char *machine, size_t requirements);       // EXIT_OK, or EXIT_USAGE after a message
// Returns NULL if no option asks for traceability.
Traceability *test_traceability_begin(TestRun *t, const Program *p, const Requirements *what);
// After the scripts: writes the file, sets t->traceability, and adds a result for --min-coverage.  `matrix` may be NULL.
int test_traceability_finish(TestRun *t, Traceability *matrix, const char *machine);

// ---- test_output.c ----

void test_write_summary(const TestRun *t, Buf *out);
void test_write_junit(const TestRun *t, Buf *out);
void test_write_tap(const TestRun *t, Buf *out);

#endif
