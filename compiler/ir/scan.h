// SPDX-License-Identifier: Apache-2.0
// Scans the words and numbers of IR text for ir_read.c.  A function that does not find what it requires sets the error and returns false
// (or NULL).  Only the first error is stored.
#ifndef SMC_IR_SCAN_H
#define SMC_IR_SCAN_H

#include "compiler/ir/ir.h"

typedef struct IrScan {
    Arena *arena;
    StrPool *strings;
    const char *at, *end;             // the remaining input
    uint32_t line;
    const char *error;                // the first error, "line 7: …", or NULL
} IrScan;

#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
bool scan_fail(IrScan *s, const char *format, ...);             // sets the error unless an earlier error is set; always returns false
bool scan_next_line(IrScan *s);                                 // skips to the next nonempty line; false at the end of the input
bool scan_at_line_end(IrScan *s);                               // whether only whitespace and a comment are left on the line

Str scan_word(IrScan *s, const char *expected);                 // reads the next word; NULL if none: the error says `expected`
bool scan_word_is(Str word, const char *text);                // whether the word equals `text`; false if `word` is NULL
bool scan_expect_char(IrScan *s, char c);                       // consumes c; an error if c is not next
bool scan_match_char(IrScan *s, char c);                        // consumes c if it is next, and returns whether it was; no error
bool scan_expect_word(IrScan *s, const char *text);             // consumes the word; an error if it is not next
bool scan_match_word(IrScan *s, const char *text);              // consumes the word if it is next, and returns whether it was; no error
bool scan_quoted(IrScan *s, Str *out);                          // reads a text in quotes
bool scan_number(IrScan *s, const char *what, uint32_t *out);   // reads a number; `what` names it in the error
bool scan_lettered_number(IrScan *s, char letter, const char *what, uint32_t *out);  // reads a letter and a number: b7, w7
bool scan_type(IrScan *s, SmType *out);                         // reads the name of a type
bool scan_value(IrScan *s, SmType type, uint64_t *cell);        // reads a whole number that fits the type, or a cell in hexadecimal
bool scan_try_parse_number(const char *text, uint64_t *out);  // decimal, or after 0x hexadecimal; false: not a number

#endif
