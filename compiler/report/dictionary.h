// SPDX-License-Identifier: Apache-2.0
// The dictionary of a .net: every message with its bytes, for programs on other computers (docs/config.md 11.20).
#ifndef SMC_DICTIONARY_H
#define SMC_DICTIONARY_H

#include "compiler/base/buf.h"
#include "compiler/sema/network.h"

typedef void DictionaryWriter(const Network *net, Buf *out);

DictionaryWriter dictionary_write_json, dictionary_write_c, dictionary_write_python, dictionary_write_xtce;

#endif
