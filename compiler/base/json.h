// SPDX-License-Identifier: Apache-2.0
// Writes JSON.
#ifndef SMC_JSON_H
#define SMC_JSON_H

#include "compiler/base/buf.h"

// Appends the text as a quoted JSON string, or null for NULL.  Bytes that are not UTF-8 become U+FFFD.
void json_put_string(Buf *out, const char *s);

#endif
