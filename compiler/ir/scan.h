// SPDX-License-Identifier: Apache-2.0
// The words and numbers of IR text, for read.c.  Every function that wants something and does not find it notes an error and
// gives false; the first error stands.
#ifndef SMC_IR_SCAN_H
#define SMC_IR_SCAN_H

#include "compiler/ir/ir.h"

typedef struct Scan {
    Arena *arena;
    StrPool *strings;
    const char *at, *end;             // what is not read yet
    uint32_t line;
    const char *error;                // "line 7: …"; NULL while there is none
} Scan;

#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
bool scan_fail(Scan *s, const char *format, ...);             // notes an error; always false
bool scan_next_line(Scan *s);                                 // to the first word of the next line that has one; false at the end
bool scan_at_line_end(Scan *s);                               // nothing more stands on the line, comments apart

Str scan_word(Scan *s, const char *expected);                 // the next word of the line, or NULL
bool scan_is(Str word, const char *text);                     // false for NULL
bool scan_char(Scan *s, char c);
bool scan_optional_char(Scan *s, char c);                     // takes it if it comes next
bool scan_this(Scan *s, const char *text);
bool scan_optional(Scan *s, const char *text);                // takes the word if it comes next
bool scan_quoted(Scan *s, Str *out);
bool scan_number(Scan *s, const char *what, uint32_t *out);
bool scan_lettered(Scan *s, char letter, const char *what, uint32_t *out);    // b7, w7: the number
bool scan_type(Scan *s, SmType *out);
bool scan_value(Scan *s, SmType type, uint64_t *cell);        // a whole number that fits the type, or a cell in hexadecimal
bool scan_parse_number(const char *text, uint64_t *out);      // decimal, or hexadecimal behind 0x

#endif
