// SPDX-License-Identifier: Apache-2.0
// The version of everything in this tree, defined only here.
#ifndef SMC_VERSION_H
#define SMC_VERSION_H

#define SMC_VERSION "0.1.0"

#endif
