// SPDX-License-Identifier: Apache-2.0
// Sessions of libsmc for tests that use its public header alone, and a machine for them.
#ifndef TESTS_LIBRARY_SESSION_H
#define TESTS_LIBRARY_SESSION_H

#include <string.h>

#include "compiler/library/smc.h"
#include "tests/test.h"

static const char tank[] = "[state_vector]\n"
                           "U64 G\nU32 S\nF32 p @range 0 1000\nbool valve\nI16 small\n"
                           "[local]\nU8 n = 3\nF64 level = 1.5\nF64 limit = 700 @read_only\n"
                           "[Fill] @safe\n.step\n    n = n + 1\n    level = level + 0.25\n    small = n * 1000 + (level > 1e9)\n    valve = p > limit\n    p > 900: -> Abort\n"
                           "[Abort] @abort\n.entry\n    valve = true\n";

static inline bool is_text(const char *text, const char *expected) { return strcmp(text, expected) == 0; }

static inline SmcSession *open_session(void)
{
    SmcSession *s = NULL;

    CHECK(smc_open(NULL, 0, &s) == SMC_OK && s != NULL);
    return s;
}

static inline uint32_t add(SmcSession *s, int32_t kind, const char *name, const char *text)
{
    uint32_t source = 999;

    CHECK(smc_source_add(s, kind, name, text, strlen(text), &source) == SMC_OK);
    return source;
}

#endif
