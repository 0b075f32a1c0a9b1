// SPDX-License-Identifier: Apache-2.0
// Text inside XML and HTML.
#ifndef SMC_XML_H
#define SMC_XML_H

#include "compiler/base/buf.h"

// Writes the text with special characters escaped, also for attribute values.  Invisible characters and those that change the direction
// of text are spelled out as <U+202E>.  Bytes that are not UTF-8, and characters that XML does not allow, become U+FFFD.
void xml_write(Buf *out, const char *text, size_t n);
void xml_write_str(Buf *out, const char *text);

#endif
