// SPDX-License-Identifier: Apache-2.0
// The .smt file, the one form of a test: a header, then named parts.  This splits it and finds the diagnostics that its
// parts announce; whoever runs it decides what the parts are for.
//
//     spec 5.7   When two guards hold in one step, the first in source order is taken.
//     on   ref vm c
//     -- app.sm --
//     [A]
//     .step
//         x = nosuch      #! E0204 unknown element
//
// A header line is a key and, behind blanks, its value; `#` starts a comment line.  The keys and what they mean are the
// reader's business, but for `expect pass|fail|error`, `steps N` and `advance N`, which are read here.  A part's text is all that stands
// between its `-- NAME --` line and the next, byte for byte.
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
    uint32_t line;            // of the .smt, where its first line stands
} TestPart;

// `#! E0204 unknown element` behind a line of a source part.
typedef struct TestExpected {
    size_t part;              // index
    uint32_t line;            // within the part, from 1
    const char *id;           // "E0204"
    const char *text;         // what the diagnostic must contain; may be ""
} TestExpected;

typedef enum TestOutcome {
    TEST_PASS,
    TEST_FAIL,                // the script must fail
    TEST_ERROR                // it must not compile
} TestOutcome;

typedef struct TestFile {
    const char *name;
    const char *error;        // NULL, or what is wrong with the file: "line 3: …"; nothing else is to be used then
    VEC(TestHeader) header;
    VEC(TestPart) part;
    VEC(TestExpected) expected;       // in file order
    TestOutcome outcome;      // as `expect` says, or what the announced diagnostics suggest
    uint64_t steps;           // `steps N`; 0 when it is not given
    uint64_t advance;         // `advance N`, likewise: how much G advances in each step, for the analyses
} TestFile;

// Takes text (not copied).  Everything lives in the arena.
TestFile *testfile_parse(Arena *arena, const char *name, const char *text, size_t n);

const char *testfile_header(const TestFile *f, const char *key);          // the first one's value; NULL when absent
const TestPart *testfile_part(const TestFile *f, const char *name);       // NULL when absent
bool testfile_is_source(const TestPart *p);                               // NAME.sv, .sm, .ss, .io or .app
bool testfile_has_suffix(const TestPart *p, const char *suffix);
// Does a header's value, a list of words, hold this one?
bool testfile_has_word(const char *list, const char *word);

#endif
