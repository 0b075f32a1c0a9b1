// SPDX-License-Identifier: Apache-2.0
// The .smt file, the only format of a test: a header, then named parts.  This module splits it, and finds the diagnostics that its
// parts announce.  The test runner decides how the parts are used.
//
//     spec 5.7   When two guards hold in one step, the first in source order is taken.
//     on   ref vm c
//     -- app.sm --
//     [A]
//     .step
//         x = nosuch      #! E0204 unknown element
//
// A header line is a key followed by spaces and its value; `#` starts a comment line.  This module reads `expect pass|fail|error`,
// `steps N` and `advance N`.  The other keys are defined by the test runner.  A part's text is everything between its `-- NAME --`
// line and the next one, byte for byte.
#ifndef SMC_TESTFILE_H
#define SMC_TESTFILE_H

#include <stdbool.h>
#include <stdint.h>

#include "compiler/base/arena.h"
#include "compiler/base/vec.h"

typedef struct TestHeader { const char *key, *value; uint32_t line; } TestHeader;

typedef struct TestPart {
    const char *name;
    const char *text;         // n bytes and a NUL
    size_t n;
    uint32_t line;            // line number of its first line in the .smt file
} TestPart;

// `#! E0204 unknown element` after a line of a source part.
typedef struct TestExpected {
    size_t part;              // index of the part in TestFile.part
    uint32_t line;            // line within the part, counted from 1
    const char *id;           // "E0204"
    const char *text;         // a part of the message that the diagnostic must have; may be ""
} TestExpected;

typedef enum TestOutcome {
    TEST_PASS,                // every script must pass
    TEST_FAIL,                // a script must fail
    TEST_ERROR                // the sources must not compile
} TestOutcome;

typedef struct TestFile {
    const char *name;
    const char *error;        // NULL, or the error in the file: "line 3: …"; the other fields are then invalid
    VEC(TestHeader) header;
    VEC(TestPart) part;
    VEC(TestExpected) expected;       // in file order
    TestOutcome outcome;      // from `expect`, else derived from the announced diagnostics
    uint64_t steps;           // `steps N`, the most steps of a script; 0 if absent
    uint64_t advance;         // `advance N`, the increment of G per step for the analyses; 0 if absent
} TestFile;

// Parses text (not copied).  Everything is allocated in the arena.
TestFile *testfile_parse(Arena *arena, const char *name, const char *text, size_t n);

const char *testfile_header(const TestFile *f, const char *key);          // value of the first line with this key; NULL if absent
const TestPart *testfile_part(const TestFile *f, const char *name);       // returns the part with this name; NULL if absent
bool testfile_is_source(const TestPart *p);                               // whether the name ends with .sv, .sm, .ss, .io, .net, .app or .rq
bool testfile_has_suffix(const TestPart *p, const char *suffix);
// Whether a header's value, a list of words, contains this word.
bool testfile_has_word(const char *list, const char *word);

#endif
