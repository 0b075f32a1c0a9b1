// SPDX-License-Identifier: Apache-2.0
// Text inside XML and HTML.
#ifndef SMC_XML_H
#define SMC_XML_H

#include "compiler/base/buf.h"

// The text with what means something there escaped, also within quotes.  Bytes that are not UTF-8, and characters that XML does
// not know, become U+FFFD.
void xml_put(Buf *out, const char *text);

#endif
