// SPDX-License-Identifier: Apache-2.0
// Text inside XML and HTML.
#ifndef SMC_XML_H
#define SMC_XML_H

#include "compiler/base/buf.h"

// Writes the text with special characters escaped, also for use in quotes.  Bytes that are not UTF-8, and characters that XML does not
// allow, become U+FFFD.
void xml_put(Buf *out, const char *text);

#endif
